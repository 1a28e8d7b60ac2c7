#!/bin/sh
# Draws the pictures of the README: the scene that sf makes itself, before, and made printable in three
# ways. And that of docs/balance.md: one shape that is made to stand, with terms left out.
# Pictures hold words, and words the fonts of a machine, so no test compares them byte for byte.
set -eu
cd "$(dirname "$0")"
here=$(mktemp -d)
trap 'rm -rf "$here"' EXIT
../../dev sf run scene:garden --pixels 800,640 -o "$here/garden" >/dev/null
mv "$here/garden/before.png" "$here/garden/after.png" .
program=tests/truth/truth-terms_picture
build=${BUILD:-$(cd ../.. && pwd)/build}
ninja -C "$build" $program >/dev/null
"$build/$program" "$here/terms.png" >/dev/null
mv "$here/terms.png" .
# And the other of docs/balance.md: a leaning tower, made to stand.
eval "$(sed -n '/^tower() {/,/^}/p' ../../tests/cli/stand.sh)"
tower "$here/tower.obj" 16 8
../../dev sf stand "$here/tower.obj" --wall 1 --resolution 32 --pixels 800,600 -o "$here/standing" >/dev/null
mv "$here/standing.png" .
# And that of docs/grade.md: a block of sixteen cells, painted.
eval "$(sed -n '/^cage() {/,/^}/p' ../../tests/cli/tap.sh)"
cage "$here/cage.vtk" 4 2 2
cat >"$here/materials.json" <<'END'
{"format": "libsf-materials", "version": 1,
 "materials": [{"name": "soft", "colour": "#2060c0"}, {"name": "stiff", "colour": "#f0a020"},
               {"name": "hard", "colour": "#202020"}],
 "properties": ["stiffness"],
 "mixtures": [{"fractions": [1, 0, 0], "values": [0]}, {"fractions": [0, 1, 0], "values": [0.5]},
              {"fractions": [0, 0, 1], "values": [1]}]}
END
cat >"$here/recipe.json" <<'END'
{"format": "libsf-paint", "version": 1,
 "steps": [{"property": "stiffness", "ball": {"at_mm": [1, 1, 1], "radius_mm": 1.6}, "set": 1.5},
           {"property": "stiffness", "capsule": {"from_mm": [0, 0, 2], "to_mm": [4, 0, 2], "radius_mm": 1.2}, "set": 0},
           {"ball": {"at_mm": [4, 1, 1], "radius_mm": 1.2}, "move": [1, 0, 0]}]}
END
../../dev sf grade "$here/cage.vtk" --paint "$here/recipe.json" --materials "$here/materials.json" \
    --resolution 170 -o "$here/graded" --picture "$here/graded.png" >/dev/null
mv "$here/graded.png" .
# And those of docs/sculpt.md: scenes, and the window on a screen that nobody sees.
for scene in shaun pumpkin intertwined; do
    size=720x540 view=-75,12
    [ $scene != shaun ] || view=-48,14
    [ $scene != intertwined ] || size=540x720
    ../../dev demo --headless --scene $scene --resolution 512 --size $size --view $view --shot $scene.png
done
xvfb-run -a -s "-screen 0 1280x800x24" ../../dev demo --scene shaun --resolution 256 --input window.input \
    --size 840x620 --shot sculpt.png
xvfb-run -a -s "-screen 0 1280x800x24" ../../dev demo --workspace balance --view=-58,16 --input balance.input \
    --size 940x660 --shot balance.png
xvfb-run -a -s "-screen 0 1280x800x24" ../../dev demo --workspace grade --view=-66,28 --input grade.input \
    --size 1000x700 --shot grade.png
