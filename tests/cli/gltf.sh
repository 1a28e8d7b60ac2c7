# Why: glTF comes from other people's programs, in metres, with y up, and is parsed by a library that
# may die of it. A part must come through every verb the right way up and of the right size; what a
# file has beside triangles is named, not lost without a word; and no file makes the program crash,
# hang or read what lies elsewhere.
. "$1"
needs_json

box part.obj 0 0 0 10 20 30
run orient part.obj -o turned.glb --json
[ "$exit" -eq 0 ] && [ "$(head -c 4 turned.glb)" = glTF ]
ok $? "a mesh is written as GLB"
exits 2 trim part.obj -o part.gltf # binary glTF is .glb
grep -q '\.glb' stderr
ok $? "and .gltf is refused by a sentence that names .glb"

exits 0 render scene:garden --resolution 40 -o garden.glb
grep -q COLOR_0 garden.glb
ok $? "what a picture shows is written with colours"

run info turned.glb --json
if [ "$exit" -eq 3 ] && grep -q 'without tinygltf' stderr; then
    ok 0 "a build without tinygltf says so # SKIP the rest needs tinygltf"
    finish
fi
same "$exit" 0 "it is read back"
same "$(value volume_mm3 | cut -c1-4)" 6000 "with its volume in mm3"

# A tetrahedron of 10 x 20 x 30 mm, standing on y = 0, with buffer and JSON apart.
# 0 0 0, .01 0 0, 0 .03 0, 0 0 .02 as floats; corners 0 1 3, 0 3 2, 0 2 1, 1 2 3.
printf '\000\000\000\000\000\000\000\000\000\000\000\000' >part.bin
printf '\012\327\043\074\000\000\000\000\000\000\000\000' >>part.bin
printf '\000\000\000\000\217\302\365\074\000\000\000\000' >>part.bin
printf '\000\000\000\000\000\000\000\000\012\327\243\074' >>part.bin
printf '\000\001\003\000\003\002\000\002\001\001\002\003' >>part.bin

# gltf NODE REST: part.gltf with that node and those fields.
gltf() {
    cat >part.gltf <<TEXT
{"asset": {"version": "2.0"}, "nodes": [{"mesh": 0$1}], $2
 "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
 "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
               {"bufferView": 1, "componentType": 5121, "count": 12, "type": "SCALAR"}],
 "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 12}],
 "buffers": [{"byteLength": 60, "uri": "${buffer:-part.bin}"}]}
TEXT
}

gltf '' ''
run info part.gltf --json
same "$exit" 0 "a file of text with its buffer beside it"
same "$(value bounds_mm.high.2 | cut -c1-5)" 29.99 "y is up, and metres are mm"
exits 0 check part.gltf --pitch 0.5
exits 0 trim part.gltf --pitch 0.5 -o trimmed.glb
exits 0 slice turned.glb --pitch 1 -o layers
exits 0 grow part.obj --pitch 1 --forbid trimmed.glb -o cut.stl
exits 2 check part.gltf --units mm
grep -q -- '--scale 0.001' stderr
ok $? "units are refused by a sentence that says what to do"
gltf ', "scale": [100, 100, 100]' ''
run info part.gltf
grep -q 'metres' stderr
ok $? "a part of 3 m is warned of"

gltf ', "skin": 0' '"skins": [{"joints": [0]}], "animations": [{"channels": [], "samplers": []}],'
run info part.gltf
grep -q '1 animations, 1 nodes with a skin' stderr
ok $? "what is not applied is said"

mkdir below && mv part.bin below/
for buffer in ../part.bin below/part.bin "$here/below/part.bin" file:part.bin part.bin; do
    gltf '' ''
    run info part.gltf
    [ "$exit" -eq 3 ] && grep -q 'no plain name' stderr
    ok $? "a buffer '$buffer' that does not lie beside the file"
done

# Deep nesting would end the parser's stack.
{
    printf '{"asset":{"version":"2.0"},"extras":'
    awk 'BEGIN { for (i = 0; i < 100000; i++) printf "[" }'
} >deep.gltf
exits 4 info deep.gltf
head -c 300 turned.glb >short.glb
exits 3 info short.glb
grep -q 'cut short' stderr
ok $? "a file that is cut short is told"
cp turned.glb turned.stl
exits 0 info turned.stl
finish
