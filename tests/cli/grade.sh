# Why: layers of materials go to a printer as they are. Their table must say what the pictures hold,
# tones must come to what was asked, the solid must be the same whatever is mixed, and what cannot be
# graded must be refused with a sentence and leave nothing behind.
. "$1"
needs_json

cage cage.vtk 4 2 2
cat >three.json <<'END'
{"format": "libsf-materials", "version": 1,
 "materials": [{"name": "soft", "colour": "#2060c0", "density_g_cm3": 1.12},
               {"name": "stiff", "colour": "#f0a020", "density_g_cm3": 1.18}, {"name": "hard"}],
 "properties": ["stiffness"],
 "mixtures": [{"fractions": [0, 0, 1], "values": [1]}, {"fractions": [1, 0, 0], "values": [0]},
              {"fractions": [0, 1, 0], "values": [0.5]}]}
END

run grade cage.vtk --resolution 48 -o graded --json
if [ "$exit" -ne 0 ] && grep -q "without PNG\|build it with libspng" stderr; then
    echo "1..0 # SKIP this build writes no PNG"
    exit 0
fi
same "$exit $(value properties.0) $(value warnings)" "0 stiffness 0" "one property needs no name"
solid=$(value solid_voxels)
same "$(($(value materials.0.voxels) + $(value materials.1.voxels)))" "$solid" "every solid voxel has a material"
awk -v a="$(value materials.0.tone_asked)" -v b="$(value materials.0.tone_obtained)" \
    'BEGIN { exit !(a > 0.499 && a < 0.501 && b - a < 0.003 && a - b < 0.003) }'
ok $? "half of it is the first ($(value materials.0.tone_asked) asked, $(value materials.0.tone_obtained) got)"
same "$(value materials.0.voxels graded/stack.json)" "$(value materials.0.voxels)" "stack.json has the same table"
same "$(value version graded/stack.json) $(value materials.1.name graded/stack.json)" "3 high" "and names"

# Other materials, another mask: the same solid.
for mask in slice isotropic diffuse; do
    exits 0 grade cage.vtk --resolution 48 --materials three.json --mask $mask -o three --json
    same "$(value solid_voxels)" "$solid" "the solid is the same by $mask"
    worst=0
    for i in 0 1 2; do
        worst=$(awk -v w="$worst" -v a="$(value materials.$i.tone_asked)" \
            -v b="$(value materials.$i.tone_obtained)" \
            'BEGIN { d = a > b ? a - b : b - a; print (d > w ? d : w) }')
    done
    awk -v w="$worst" 'BEGIN { exit !(w < 0.003) }'
    ok $? "tones are as asked within 0.003 ($worst) by $mask"
    awk -v v="$(value materials.0.volume_mm3)" -v g="$(value materials.0.grams)" \
        'BEGIN { d = v * 1.12 / 1000 - g; exit !(d < 1e-12 && d > -1e-12) }'
    ok $? "grams are volume times density"
done
same "$(value materials.2.grams)" null "a material without a density has no grams"
exits 0 info three --json
same "$(value solid_voxels)" "$solid" "other verbs read layers of materials as what is solid"

# The same bytes with any number of threads.
exits 0 grade cage.vtk --resolution 40 -o one --threads 1
exits 0 grade cage.vtk --resolution 40 -o many --threads 7
cmp -s one/layer_00010.png many/layer_00010.png && cmp -s one/stack.json many/stack.json
ok $? "one thread and seven write the same bytes"

# A property that is the same everywhere needs no printer of two materials.
awk '/^LOOKUP_TABLE/ { print; values = 1; next } values { print 3; next } { print }' cage.vtk >even.vtk
exits 0 grade even.vtk --resolution 16 -o even --json
same "$(value warnings) $(value materials.1.voxels)" "1 0" "one that is the same everywhere is worth a warning"

# A layer is held and not the stack.
exits 0 grade cage.vtk --pitch 0.02,0.08,0.002 --memory 1 --mask diffuse -o thin --json
same "$(awk -v n="$(value lattice.nx) $(value lattice.ny) $(value lattice.nz)" 'BEGIN { split(n, a, " ")
    print (8 * int((a[1] + 511) / 512) * 8 * a[2] * a[3] > 1048576) }')" 1 "of a grid that is larger"
exits 4 grade cage.vtk --resolution 512 --memory 3 -o none
grep -q "^sf: A layer of .* MiB with its properties and tones, and --memory allows 3" stderr
ok $? "and says what a layer takes"

# Who asks another verb is shown the way.
for verb in info check trim slice render orient stand; do
    exits 3 $verb cage.vtk
    grep -q "cage.vtk is a cage or a mesh of cells, not a surface: 'sf grade'" stderr
    ok $? "and names sf grade"
done
exits 3 preserve scene:garden --remove cage.vtk --resolution 24
grep -q "cage.vtk is a cage" stderr
ok $? "and so does a mask"
sed 's/UNSTRUCTURED_GRID/POLYDATA/' cage.vtk >polydata.vtk
exits 3 check polydata.vtk
grep -q "sf grade" stderr
same $? 1 "which cannot take VTK of another kind"
awk '/^CELLS/ { print "CELLS 2 10\n4 0 1 6 5\n4 1 2 7 6\nCELL_TYPES 2\n9 9"; skip = 1 }
    /^POINT_DATA/ { skip = 0 } !skip { print }' cage.vtk >surface.vtk
exits 3 grade surface.vtk -o none
grep -q "surface.vtk is a surface; only a solid can be graded" stderr
ok $? "and says so"

# Shells: a box of 20 voxels each way, all of it soft, whose surface lies on sides of voxels. Those on
# both sides of it are touched; a voxel belongs to the shell if its side is less than 1.2 mm from
# theirs, so that the shell is four voxels thick.
cat >tets.vtk <<'END'
# vtk DataFile Version 3.0
box
ASCII
DATASET UNSTRUCTURED_GRID
POINTS 8 double
0 0 0 10 0 0 0 10 0 10 10 0 0 0 10 10 0 10 0 10 10 10 10 10
CELLS 6 30
4 0 1 3 7
4 0 3 2 7
4 0 2 6 7
4 0 6 4 7
4 0 4 5 7
4 0 5 1 7
CELL_TYPES 6
10 10 10 10 10 10
POINT_DATA 8
SCALARS stiffness double 1
LOOKUP_TABLE default
0 0 0 0 0 0 0 0
END
exits 0 grade tets.vtk --pitch 0.5 --materials three.json --shell 1.2,hard -o shell --json
same "$(value solid_voxels) $(value shell_voxels) $(value materials.0.voxels) $(value materials.2.voxels)" \
    "8000 6272 1728 6272" "a shell of one material, and what is within"
exits 0 grade tets.vtk --pitch 0.5 --materials three.json --keep-out 1.2,soft,hard -o out --json
same "$(value materials.0.voxels) $(value materials.2.voxels)" "1728 6272" "one that is kept out, and which is there instead"
cmp -s shell/layer_00007.png out/layer_00007.png
ok $? "the same picture"
exits 0 grade tets.vtk --pitch 0.5 --materials three.json --keep-out 1.2,soft -o out --json
same "$(value materials.1.voxels)" 6272 "the first other one, where none is named"
exits 0 grade tets.vtk --pitch 0.5 --materials three.json --shell 9 --mask diffuse -o out --json
same "$(value materials.0.voxels)" 8000 "a shell as thick as the solid"
exits 2 grade tets.vtk --pitch 0.5 --shell 1.2,clay -o none
grep -q "'clay' names no material; there are 'low', 'high'" stderr
ok $? "and says which there are"
exits 2 grade tets.vtk --pitch 0.5 --keep-out 1.2 -o none
exits 2 grade tets.vtk --pitch 0.5 --keep-out 1.2,low,low -o none
exits 2 grade tets.vtk --pitch 0.5 --shell -1 -o none
exits 2 grade tets.vtk --pitch 0.5 --shell 200 -o none
grep -q "more than 255 voxels" stderr
ok $? "and says how far it may reach"
exits 2 grade tets.vtk --pitch 0.5 --shell 1 --keep-out 1,low -o none

# Pictures look from where they are asked to, and are cut where they can be.
for view in front side top; do
    exits 0 grade cage.vtk --resolution 16 -o seen --view $view --slice 3 --pixels 300,200 --picture $view.png
done
cmp -s front.png side.png || cmp -s front.png top.png
same $? 1 "they are not the same picture"
exits 2 grade cage.vtk --resolution 16 -o none --picture none.png --view iso
exits 2 grade cage.vtk --resolution 16 -o none --picture none.png --slice 60
grep -q "across that view" stderr
ok $? "and says which slices there are"

# What cannot be.
exits 2 grade cage.vtk
exits 3 grade cage.vtk --property nothing -o none
grep -q "it has 'stiffness'" stderr
ok $? "and says which properties there are"
exits 3 grade missing.vtk -o none
exits 2 grade cage.vtk --pitch 0.00001 -o none
exits 3 grade cage.vtk --pitch 1000 -o none --picture none.png
grep -q "No voxel has its centre inside" stderr
ok $? "and says that nothing would be solid"
exits 2 grade cage.vtk --pitch 0.1,10,0.1 -o none
grep -q "no side may be more than 64 times another" stderr
ok $? "and says what voxels may be"
exits 2 grade cage.vtk -o none --picture none.jpg
: >empty.vtk
exits 3 grade empty.vtk -o none
grep -q "the file is empty" stderr
ok $? "and says so"
exits 3 grade cage.vtk --materials missing.json -o none
grep -q "^sf: --materials missing.json: unable to open" stderr
ok $? "and says so"
exits 3 grade cage.vtk --materials cage.vtk -o none
sed 's/"values": \[0.5\]/"values": [1]/' three.json >twice.json
exits 3 grade cage.vtk --materials twice.json -o none
grep -q "no two mixtures can have the same value" stderr
ok $? "and says so"
sed 's/#2060c0/#-1-1-1/' three.json >colour.json
exits 3 grade cage.vtk --materials colour.json -o none
cat >below.json <<'END'
{"format": "libsf-materials", "version": 1, "materials": [{"name": "soft"}, {"name": "stiff"}],
 "properties": ["stiffness"],
 "mixtures": [{"fractions": [1, 0], "values": [0]}, {"fractions": [-5, 6], "values": [1]}]}
END
exits 3 grade cage.vtk --materials below.json -o none
grep -q "fractions are not below 0" stderr
ok $? "and says so"
sed 's/^0 0 0$/9 9 9/' cage.vtk >inverted.vtk
exits 3 grade inverted.vtk -o none
grep -q "cell 0 is inverted or flat" stderr
ok $? "and names the cell"
sed '/^POINT_DATA/,$d' cage.vtk >bare.vtk
exits 3 grade bare.vtk -o none
grep -q "has no properties" stderr
ok $? "and says so"
[ ! -e none ] && [ ! -e none.png ] && [ ! -e none.jpg ]
ok $? "nothing was written by any of these"
finish
