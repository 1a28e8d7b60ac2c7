# Why: 3MF is what slicers take and give, so every verb that takes a mesh takes it and every one that
# writes a mesh writes it, with the same shape as in another format; a file with slices is judged by
# them; a file that is damaged is refused, and nothing half-written is left.
. "$1"
needs_json
box box.obj 0 0 0 12 8 20
run trim box.obj --pitch 0.5 -o box.3mf
if grep -q 'writes no 3MF' stderr; then
    echo "1..0 # SKIP this build writes no 3MF"
    exit 0
fi
ok "$exit" "trim writes 3MF"
exits 0 info box.3mf --json
same "$(value volume_mm3)" 1920 "and what it wrote is as large as the part"
exits 0 check box.3mf --pitch 0.5
cp box.3mf first.3mf
exits 0 trim box.obj --pitch 0.5 -o box.3mf
cmp -s box.3mf first.3mf
ok $? "the same part is the same bytes"
for verb in grow repair; do
    exits 0 $verb box.3mf --pitch 0.5 -o $verb.3mf --json
    exits 0 info $verb.3mf --json
    same "$(value volume_mm3)" 1920 "$verb reads 3MF and writes it"
done
exits 0 orient box.3mf -o turned.3mf --count 1
exits 0 hollow box.3mf --wall 2 --pitch 0.5 -o hollow.3mf --json
hollow=$(value volume_mm3)
exits 0 info hollow.3mf --json
awk "BEGIN { exit !(($(value volume_mm3) - $hollow) ^ 2 < 1e-6 * $hollow ^ 2) }"
ok $? "a cavity is in the file ($hollow mm3)"
exits 0 slice box.3mf --pitch 0.5 -o layers
exits 0 preserve box.3mf --remove box.3mf --pitch 0.5 -o kept.3mf --keep box.3mf

# A column that leans, made to stand: one file with its cavity, a picture and a report.
awk 'BEGIN {
    for (i = 0; i < 8; i++)
        print "v", (i % 2) * 12 + (i > 3) * 16, int(i / 2) % 2 * 12, (i > 3) * 40
    print "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6" }' >column.obj
run stand column.obj --gamma 1 --resolution 32 -o stands.3mf --json
[ "$exit" -le 1 ] && [ "$(value package)" = stands.3mf ] && [ "$(value outer)" = null ]
ok $? "stand writes a package and says so"
[ -s stands.3mf ] && [ -s stands.json ] && [ ! -e stands_outer.stl ] && [ ! -e stands.3mf.json ]
ok $? "with the report beside it"
exits 0 info stands.3mf
run stand column.obj --gamma 1 --resolution 32 --cut x -o halves.3mf
[ "$exit" -le 1 ] && [ -s halves.3mf ] && [ ! -e halves_low.stl ]
ok $? "halves are in the package"

# A graded solid: its surface, and pictures of what is mixed where.
cage cage.vtk 4 2 2
run grade cage.vtk --resolution 40 -o graded.3mf --json
if ! grep -q 'build it with libspng' stderr; then
    same "$exit $(value materials.0.name) $(value materials.1.name)" "0 low high" "grade writes what is mixed"
    half=$(value materials.0.tone_asked)
    awk "BEGIN { exit !($half > 0.499 && $half < 0.501) }"
    ok $? "half of it the first material ($half)"
    exits 0 info graded.3mf --json
    awk "BEGIN { exit !($(value volume_mm3) > 13.5 && $(value volume_mm3) < 13.7) }"
    ok $? "and the surface of the smooth solid ($(value volume_mm3) mm3)"
    exits 2 grade cage.vtk --mask diffuse -o graded.3mf
    exits 3 grade box.obj -o none.3mf
    [ ! -e none.3mf ]
    ok $? "what cannot be graded leaves nothing"
fi

# What is damaged is refused with a sentence, and what stood there stays.
head -c 3000 box.3mf >cut.3mf
exits 3 check cut.3mf
grep -q '3MF' stderr
ok $? "and says why"
printf 'PK\003\004 and nothing more' >nothing.3mf
exits 3 info nothing.3mf --json
exits 3 trim nothing.3mf -o box.3mf
cmp -s box.3mf first.3mf
ok $? "a failed run leaves the old file"

# Slices of its own, which are all equally high: a box of four layers. Its triangles say nothing.
if command -v python3 >/dev/null; then
    python3 - <<'END'
import zipfile
CORE = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02"
SLICE = "http://schemas.microsoft.com/3dmanufacturing/slice/2015/07"
RELATED = "http://schemas.openxmlformats.org/package/2006/relationships"
square = "".join(f'<s:vertex x="{x}" y="{y}"/>' for x, y in ((0, 0), (6, 0), (6, 4), (0, 4)))
round_it = "".join(f'<s:segment v2="{v}"/>' for v in (1, 2, 3, 0))
slices = "".join(f'<s:slice ztop="{k / 2}"><s:vertices>{square}</s:vertices>'
                 f'<s:polygon startv="0">{round_it}</s:polygon></s:slice>' for k in range(1, 5))
points = "".join(f'<vertex x="{x}" y="{y}" z="{z}"/>' for x, y, z in ((0, 0, 0), (6, 0, 0), (0, 4, 0), (0, 0, 2)))
faces = "".join(f'<triangle v1="{a}" v2="{b}" v3="{c}"/>' for a, b, c in ((0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)))
with zipfile.ZipFile("sliced.3mf", "w") as file:
    file.writestr("_rels/.rels", f'<Relationships xmlns="{RELATED}"><Relationship Id="a" Target="/3D/a.model" '
                  'Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>')
    file.writestr("3D/a.model", f'<model unit="millimeter" xmlns="{CORE}" xmlns:s="{SLICE}"><resources>'
                  f'<s:slicestack id="1" zbottom="0">{slices}</s:slicestack>'
                  f'<object id="2" type="model" s:slicestackid="1"><mesh><vertices>{points}</vertices>'
                  f'<triangles>{faces}</triangles></mesh></object></resources><build><item objectid="2"/></build></model>')
END
    exits 0 check sliced.3mf --pitch 0.5 --json
    same "$(value slices) $(value lattice.nz) $(value lattice.layer_mm) $(value solid_voxels)" "4 4 0.5 384" "slices are the layers"
fi

# A file of slices, from the data.
torus=${SF_DATA:-}/3mf/torus_sliced.3mf
if [ -f "$torus" ]; then
    exits 1 check "$torus" --pitch 0.05 --json
    same "$(value slices) $(value lattice.nz) $(value lattice.layer_mm)" "50 50 0.08" "slices are the layers"
    awk "BEGIN { exit !(($(value solid_voxels) * 0.0002 - 797.9223) ^ 2 < 0.01) }"
    ok $? "of 797.92 mm3 ($(value solid_voxels) voxels of 0.0002)"
    exits 0 info "$torus"
    exits 2 check "$torus" --scale 2
    exits 0 repair "$torus" --pitch 0.2 -o torus.3mf
    exits 1 check "$(dirname "$torus")/pyramid_vertexcolor.3mf" --resolution 32
    exits 3 check "$(dirname "$torus")/variable_voronoi.3mf"
    grep -q 'beam lattices' stderr
    ok $? "beam lattices are named"
fi
finish
