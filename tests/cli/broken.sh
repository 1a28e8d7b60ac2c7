# Why: people have broken files. Whatever holds a shape must give a stack; the three files that hold
# none must be refused in one sentence that names a line or a byte; nothing may crash, hang for five
# seconds at the resolution that the program chooses, or leave half a file; and Ctrl-C is heard while
# the worst of them is voxelised finely. The meshes come from SF_DATA; exit_status.sh tries the same
# refusals on files of its own, unit/mesh voxelize_auto, voxelize_open and voxelize_promises the same
# defects and cancels.
. "$1"

if [ -z "${SF_DATA:-}" ]; then
    echo "1..0 # SKIP SF_DATA is not set"
    exit 0
fi
# Five seconds of the processor's time; a program for another machine, or one that is watched, may
# take twelve times as long.
limit=5
[ -z "$wrapper${SF_WATCHED:-}" ] || limit=60

# run, but not for longer.
run_within() {
    exit=0
    (ulimit -t $limit && exec $wrapper "$SF" "$@") >stdout 2>stderr </dev/null || exit=$?
}

for file in "$SF_DATA"/broken/*; do
    name=${file##*/}
    run_within slice "$file" --size 50 -o "stack/"
    case $name in
    empty2.stl | inf_nan.obj | invalidvertex.stl)
        [ $exit -eq 3 ] && [ "$(wc -l <stderr)" -eq 1 ] && grep -Eq 'line [0-9]+|byte [0-9]+|holds no triangles' stderr &&
            [ -z "$(ls -A | grep -v '^std')" ]
        ok $? "$name is refused: $(cat stderr)"
        ;;
    *)
        [ $exit -eq 0 ] && [ -s stack/stack.json ] && [ -s stack/layer_00000.* ]
        ok $? "$name gives a stack within $limit seconds"
        run_within check "$file" --size 50
        [ $exit -eq 0 ] || [ $exit -eq 1 ]
        ok $? "$name is checked within $limit seconds"
        ;;
    esac
    rm -rf stack
done

$wrapper "$SF" check "$SF_DATA/broken/soup.stl" --resolution 700 --threads 1 >stdout 2>stderr &
pid=$!
sleep 1
begun=$(date +%s)
kill -INT $pid
exit=0
wait $pid || exit=$?
same $exit 130 "cancelled while it voxelises"
[ $(($(date +%s) - begun)) -lt $limit ]
ok $? "and at once"
finish
