# Why: `sf run` is the first thing that anybody does. It writes five things, says so in ten lines, and
# can be run again; and where it is cancelled or the disk is full, what was there is there still.
. "$1"

for attempt in first second; do
    run run --resolution 64 --pixels 320,240 -o out
    same $exit 0 "$attempt run"
    [ "$(wc -l <stdout)" -le 10 ]
    ok $? "at most ten lines"
    [ -s out/printable.stl ] && [ -s out/report.json ] && [ -s out/layers/stack.json ]
    ok $? "mesh, report and stack are there"
    [ "$(ls out | wc -l)" -le 5 ] && [ -z "$(ls -A out | grep '^\.')" ]
    ok $? "and nothing else"
done
if [ -n "$JSON_GET" ]; then
    same "$(value trim.support_free out/report.json)" true "the report is JSON and says it prints"
    exits 0 check out/layers
    exits 0 check out/printable.stl --pitch 1.5
fi
if [ -e out/before.png ]; then
    same "$(head -c 8 out/before.png | od -An -tx1 | tr -d ' \n')" 89504e470d0a1a0a "the picture is a PNG"
    cmp -s out/before.png out/after.png
    [ $? -eq 1 ]
    ok $? "before and after differ"
fi

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
