# Why: people have broken files. Whatever holds a shape must give a stack; the three files that hold
# none must be refused in one sentence that names a line or a byte; nothing may crash, hang for five
# seconds, or leave half a file. The meshes come from SF_DATA; exit_status.sh tries the same refusals
# on files of its own, unit/mesh voxelize_auto and voxelize_open the same defects.
. "$1"

if [ -z "${SF_DATA:-}" ]; then
    echo "1..0 # SKIP SF_DATA is not set"
    exit 0
fi
for file in "$SF_DATA"/broken/*; do
    name=${file##*/}
    begun=$(date +%s)
    run slice "$file" --size 50 --resolution 128 -o "stack/"
    took=$(($(date +%s) - begun))
    case $name in
    empty2.stl | inf_nan.obj | invalidvertex.stl)
        [ $exit -eq 3 ] && [ "$(wc -l <stderr)" -eq 1 ] && grep -Eq 'line [0-9]+|byte [0-9]+' stderr &&
            [ -z "$(ls -A | grep -v '^std')" ]
        ok $? "$name is refused: $(cat stderr)"
        ;;
    *)
        [ $exit -eq 0 ] && [ -s stack/stack.json ] && [ -s stack/layer_00000.* ]
        ok $? "$name gives a stack"
        ;;
    esac
    [ $took -lt 60 ]
    ok $? "$name ends"
    rm -rf stack
done
finish
