# Why: `sf run` is the first thing that anybody does. It writes seven things, says so in ten lines, and
# can be run again; and where it is cancelled or the disk is full, what was there is there still.
. "$1"

for attempt in first second; do
    run run --resolution 64 --pixels 320,240 -o out
    same $exit 0 "$attempt run"
    [ "$(wc -l <stdout)" -le 10 ]
    ok $? "at most ten lines"
    [ -s out/printable.stl ] && [ -s out/trimmed.stl ] && [ -s out/grown.stl ] && [ -s out/report.json ] && [ -s out/layers/stack.json ]
    ok $? "meshes, report and stack are there"
    [ "$(ls out | wc -l)" -le 7 ] && [ -z "$(ls -A out | grep '^\.')" ]
    ok $? "and nothing else"
done
if [ -n "$JSON_GET" ]; then
    for way in trim grow repair; do
        same "$(value $way.support_free out/report.json)" true "the report is JSON and says that $way prints"
        for path in kept_voxels removed_voxels added_voxels cost volume_mm3 seconds; do
            value $way.$path out/report.json >/dev/null
            ok $? "and has its $path"
        done
    done
    for way in trim grow; do
        [ "$(value repair.cost out/report.json)" -le "$(value $way.cost out/report.json)" ]
        ok $? "repair changes no more than $way"
    done
    same "$(value printable out/report.json)" repair "printable.stl is the repair"
    exits 0 check out/layers
    exits 0 check out/printable.stl --pitch 1.5
fi
if [ -e out/before.png ]; then
    same "$(head -c 8 out/before.png | od -An -tx1 | tr -d ' \n')" 89504e470d0a1a0a "the picture is a PNG"
    cmp -s out/before.png out/after.png
    [ $? -eq 1 ]
    ok $? "before and after differ"
fi

# Ten lines for a part with overhangs, crumbs, voids that are shut and suction cups as well.
for hollow in "2 2 5 8 8 15" "12 2 5 18 8 15" "2 12 5 8 18 15" "12 12 5 18 18 15" "22 2 12 28 8 30" "22 12 12 28 18 30" "29 0 0 30 20 1"; do
    # shellcheck disable=SC2086
    box hollow.obj $hollow
    cat hollow.obj
done >hollows.obj
box outer.obj 0 0 0 30 20 30
cat outer.obj hollows.obj | awk '$1 == "v" { print; seen++ } $1 == "f" { printf "f"; for (i = 2; i <= NF; i++) printf " %d", $i + seen - 8; print "" }' >voids.obj
run run voids.obj --fill parity --pitch 0.5 --crumbs 3 --pixels 160,120 -o voids
same "$exit $(wc -l <stdout)" "0 10" "ten lines for a part with everything"
grep -q '^4 voids are shut, .*; printed from resin it makes 2 suction cups' stdout
ok $? "voids in one of them: $(grep void stdout)"

# Where growing cannot do it, the other two stand, and the grown shape of an earlier run goes.
cp -R out bed
run run --resolution 64 --pixels 160,120 --bed 8 -o bed
same "$exit $(ls bed | grep -c grown.stl)" "0 0" "matter below the bed cannot be grown under"
grep -q 'grow .*not possible' stdout && [ -s bed/printable.stl ]
ok $? "which is said"
[ -z "$JSON_GET" ] || [ "$(value grow.culprits.count bed/report.json)" -gt 0 ]
ok $? "with what is in the way"
run run --resolution 64 --pixels 160,120 --memory 0.15 -o little
same "$exit $(ls little | grep -c grown.stl)" "0 0" "little memory is enough for a trim"
grep -q 'Only trimmed' stderr && grep -q 'printable.stl is the trim' stdout
ok $? "which is said too"

run run --resolution 32 --pixels 160,120 --bed -9 -o bed
same "$exit $(ls bed | grep -c trimmed.stl)" "0 0" "a version of which nothing is left is not written"
grep -q 'trim .*nothing would be left' stdout && grep -q 'printable.stl is the repair' stdout
ok $? "but said"

run run --resolution 48 --pixels 160,120 --smooth 2 --min-feature 4 -o smooth
same $exit 0 "run takes --smooth and --min-feature"
[ -z "$JSON_GET" ] || value smoothed_repair.passes smooth/report.json >/dev/null
ok $? "and says what smoothing did to each"

# Other files in the folder are nobody's business; a folder of layers that is no stack is refused.
echo mine >out/mine.txt
run run --resolution 48 --pixels 160,120 -o out/
same $exit 0 "run into a folder with a file"
same "$(cat out/mine.txt)" mine "the file stays"
mkdir -p other/layers && echo mine >other/layers/mine.txt
run run --resolution 48 --pixels 160,120 -o other
same "$exit $(ls -A other) $(ls -A other/layers)" "4 layers mine.txt" "layers that are no stack stay"

# prints FOLDER: names and bytes of all files in it.
prints() {
    (cd "$1" && find . -type f | sort | xargs cksum)
}

# Cancelled while it draws: the mesh and the layers are made, aside, and nothing of it is to be seen.
prints out >before
for to in out fresh; do
    $wrapper "$SF" run scene:garden --resolution 64 --pixels 8000,6000 -o $to >stdout 2>stderr &
    pid=$!
    for tick in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20; do
        sleep 0.1
        find . -path '*sf-*' -name stack.json | grep -q . && break
        prints out | cmp -s - before || break
    done
    kill -INT $pid
    exit=0
    wait $pid || exit=$?
    same $exit 130 "a run to $to is cancelled"
    prints out >after
    cmp -s before after
    ok $? "and $to is as it was"
    [ -z "$(ls -A | grep fresh)" ] && [ -z "$(ls -A out | grep 'sf-')" ]
    ok $? "with nothing beside it"
done

# A disk that is full: here, files that may not grow beyond a few blocks.
if [ -z "$wrapper" ]; then
    for to in out fresh; do
        exit=0
        (trap '' XFSZ; ulimit -f 8; exec "$SF" run scene:garden --resolution 64 -o $to) >stdout 2>stderr || exit=$?
        same $exit 4 "a run to $to on a full disk"
        grep -q "^sf: $to/" stderr && ! grep -q 'sf-\|tmp' stderr
        ok $? "names what was to be written: $(cat stderr)"
        prints out >after
        cmp -s before after && [ -z "$(ls -A | grep fresh)" ] && [ -z "$(ls -A out | grep 'sf-')" ]
        ok $? "leaves all as it was"
    done
fi

# Any number of threads gives the same bytes.
for threads in 1 3; do
    run trim scene:garden --resolution 80 --threads $threads -o t$threads.ply
    run render scene:garden --resolution 48 --pixels 160,120 --threads $threads -o t$threads.png
done
cmp -s t1.ply t3.ply
ok $? "one and three threads write the same mesh"
[ ! -e t1.png ] || cmp -s t1.png t3.png
ok $? "and the same picture"

# Ctrl-C: status 130, and nothing half-written.
$wrapper "$SF" trim scene:garden --resolution 900 -o big.stl >stdout 2>stderr &
pid=$!
sleep 0.3
kill -INT $pid
exit=0
wait $pid || exit=$?
same $exit 130 "cancelled"
[ ! -e big.stl ] && [ -z "$(ls -A | grep 'big')" ]
ok $? "a cancelled run leaves no file"
finish
