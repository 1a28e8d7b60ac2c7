# Why: hollowing is a promise in figures: walls no thinner than asked, nothing hanging that was
# carried, nothing shut in where holes were asked for. Each is looked at from outside: the layers
# voxel by voxel, the mesh by slicing it again, the certificate by sf-verify, the voids by a check.
. "$1"
needs_json

# changes A B X0 Y0 Z0 X1 Y1 Z1: "removed added removed added", inside the box and outside.
changes() {
    $wrapper "$STACK_COMPARE" "$@" 2>stderr || echo -1 -1 -1 -1
}

# A block that lies along the voxels: just what lies deeper than the wall may come out.
box block.obj 0 0 0 40 30 30
exits 0 slice block.obj --pitch 1 -o drawn
for rule in "--angle 45" "--rule box3" "--rule slack --angle 40"; do
    # shellcheck disable=SC2086
    exits 0 hollow block.obj --pitch 1 --wall 3 $rule -o hollow --certificate proof.json --json
    same "$(value wall_min_mm) $(value support_free) $(value added_voxels)" "3 true 0" "walls are just as asked, and it prints"
    # shellcheck disable=SC2046
    set -- $(changes drawn hollow 3 3 3 37 27 27)
    same "$1 $2 $3 $4" "$(value carved_voxels) 0 0 0" "and only what lies deeper came out"
    [ "$1" -gt 9000 ]
    ok $? "which is most of it ($1 voxels of 19584)"
    exits 0 check hollow
    if [ -n "${SF_VERIFY:-}" ]; then
        $wrapper "$SF_VERIFY" hollow proof.json >stdout 2>stderr
        ok $? "and sf-verify takes the certificate"
    fi
    # The same as a mesh: the block's own surface and the cavity's.
    # shellcheck disable=SC2086
    exits 0 hollow block.obj --pitch 1 --wall 3 $rule -o hollow.stl
    exits 0 slice hollow.stl --pitch 1 -o again
    same "$(changes hollow again 0 0 0 0 0 0)" "0 0 0 0" "the mesh is just the layers"
done
exits 0 hollow block.obj --pitch 1 --wall 2.5 --json
awk -v w="$(value wall_min_mm)" 'BEGIN { exit !(w == 3) }'
ok $? "between two voxels the wall is the thicker one ($(value wall_min_mm))"
run hollow block.obj --pitch 1 --wall 3
grep -Eq 'walls are 3 mm or more' stdout && grep -q 'Nothing was written' stdout
ok $? "and sentences say so"

# A block that is turned: distances are exact, whatever the voxels are.
awk 'BEGIN { c = cos(0.5); s = sin(0.5) }
    /^v/ { print "v", c * $2 - s * $3, s * $2 + c * $3, $4; next } { print }' block.obj >turned.obj
exits 0 hollow turned.obj --pitch 0.8,1,0.7 --wall 3.3 --json
awk -v w="$(value wall_min_mm)" 'BEGIN { exit !(w >= 3.3 && w < 4.2) }'
ok $? "turned, walls are $(value wall_min_mm), no less than 3.3"

# Holes.
exits 0 hollow block.obj --pitch 1 --wall 3 --json
same "$(value voids.closed)" "$(value voids.count)" "without holes the void is shut"
[ "$(value voids.count)" -ge 1 ]
ok $? "there is one ($(value voids.count))"
exits 0 hollow block.obj --pitch 1 --wall 3 --drain 4 -o drained --certificate drained.json --json
cp stdout drained.report
same "$(value voids.closed) $(value support_free)" "0 true" "with holes nothing is shut in, and it prints"
same "$(value drains.0.from_mm.2) $(value drains.0.to_mm.2)" "3 0" "the hole goes through the floor"
exits 0 check drained --json
same "$(value voids.traps) $(value voids.list.0.on_bed)" "1 true" "as a check finds: it opens once the part is off the bed"
if [ -n "${SF_VERIFY:-}" ]; then
    $wrapper "$SF_VERIFY" drained drained.json >stdout 2>stderr
    ok $? "and sf-verify takes it"
fi
exits 0 hollow block.obj --pitch 1 --wall 3 --drain 4,2 -o drained.stl --cavity cavity.stl --json
same "$(value drains 2>/dev/null)" 2 "two holes where two are asked for"
exits 0 slice drained.stl --pitch 1 -o again
same "$(changes drawn again 3 3 0 37 27 27 | cut -d' ' -f2-)" "0 0 0" "a drained mesh is the voxels' surface"
exits 0 info cavity.stl --json
[ -n "$(value volume_mm3)" ] && awk -v v="$(value volume_mm3)" -v c="$(value carved_mm3 drained.report)" 'BEGIN { exit !(v > c && v < 1.1 * c) }'
ok $? "the cavity alone is that large, and its holes go on ($(value volume_mm3), $(value carved_mm3 drained.report))"
run hollow block.obj --pitch 1 --wall 3 --drain 4
grep -q 'hole from x ' stdout
ok $? "holes are named"

# Halves: each is closed, together they are the whole, and what was shut in is open.
exits 0 hollow block.obj --pitch 1 --wall 3 -o whole.stl --cut z --json
cp stdout cut.report
same "$(value halves.axis) $(value halves.at_mm) $(value halves.low.output) $(value halves.high.output)" "z 15 whole_low.stl whole_high.stl" "--cut says where, and what it wrote"
exits 0 info whole.stl --json
whole=$(value volume_mm3) shut=$(value flipped_shells)
[ "$(value halves.shut_cavities cut.report)" -lt "$shut" ]
ok $? "cavities that the plane meets are open ($(value halves.shut_cavities cut.report) of $shut are not)"
exits 0 info whole_low.stl --json
same "$(value closed) $(value oriented) $(value boundary_edges) $(value nonmanifold_edges) $(value bounds_mm.high.2)" "true true 0 0 15" "the low half is closed and lies below the plane"
low=$(value volume_mm3)
near() { awk -v a="$1" -v b="$2" 'BEGIN { d = a - b; exit !(d < 1e-3 && d > -1e-3) }'; }
near "$low" "$(value halves.low.volume_mm3 cut.report)"
ok $? "of the volume that the report names ($low)"
exits 0 info whole_high.stl --json
same "$(value closed) $(value nonmanifold_edges) $(value bounds_mm.low.2)" "true 0 15" "the high half as well"
near "$(value volume_mm3)" "$(value halves.high.volume_mm3 cut.report)" && awk -v l="$low" -v h="$(value volume_mm3)" -v w="$whole" 'BEGIN { exit !((l + h - w) ^ 2 < 1e-4) }'
ok $? "and both are the whole ($low, $(value volume_mm3), $whole)"
exits 0 hollow block.obj --pitch 1 --wall 3 --drain 4 --up +x -o drilled.stl --cut x,17.3 --json
for half in low high; do
    exits 0 info drilled_$half.stl --json
    same "$(value closed) $(value nonmanifold_edges)" "true 0" "drained and turned, the $half half is closed"
done
same "$(awk -v x="$(value bounds_mm.low.0)" 'BEGIN { printf "%.1f", x }')" "17.3" "in the axes of the input"
exits 0 hollow scene:garden --resolution 48 --wall 3 -o garden.stl --cut y --json
exits 0 info garden_low.stl --json
same "$(value closed)" true "a scene's surface is cut, too"
exits 2 hollow block.obj --pitch 1 --wall 3 --cut z
exits 2 hollow block.obj --pitch 1 --wall 3 --cut z -o layers
exits 2 hollow block.obj --pitch 1 --wall 3 --cut z,30 -o beside.stl
[ ! -e beside.stl ] && grep -q 'goes from 0 to 30 mm along z' stderr
ok $? "a plane beside the part is refused: $(cat stderr)"
exits 2 hollow block.obj --pitch 1 --wall 3 --cut up -o beside.stl
exits 2 hollow block.obj --pitch 1 --wall 3 --cut z, -o beside.stl
exits 2 hollow block.obj --pitch 1 --wall 3 --cut z,1,2 -o beside.stl
mkdir -p taken_low.stl
exits 4 hollow block.obj --pitch 1 --wall 3 --cut z -o taken.stl
[ ! -e taken.stl ]
ok $? "a half that cannot be written is said before the work"

# What hung may hang on; nothing else does.
awk 'BEGIN { b = 0 }
    function box(x0, y0, z0, x1, y1, z1, i) {
        for (i = 0; i < 8; i++) print "v", (i % 2) ? x1 : x0, (int(i / 2) % 2) ? y1 : y0, (i > 3) ? z1 : z0
        n = split("1 3 4 2 5 6 8 7 1 2 6 5 3 7 8 4 1 5 7 3 2 4 8 6", f, " ")
        for (i = 1; i <= n; i += 4) print "f", b + f[i], b + f[i + 1], b + f[i + 2], b + f[i + 3]
        b += 8 }
    BEGIN { box(0, 0, 0, 16, 16, 20); box(0, 0, 20, 40, 16, 36) }' >arm.obj
exits 1 check arm.obj --pitch 1 --json
hangs=$(value unsupported_voxels)
exits 0 hollow arm.obj --pitch 1 --wall 2 --drain 2 -o arm --certificate arm.json --json
same "$(value support_free)" false "what hung hangs"
[ "$(value accepted_voxels)" -le "$hangs" ] && [ "$(value carved_voxels)" -gt 1000 ]
ok $? "it was hollowed all the same ($(value carved_voxels) voxels)"
exits 1 check arm --json
[ "$(value unsupported_voxels)" -le "$hangs" ]
ok $? "and nothing hangs that did not ($(value unsupported_voxels), $hangs)"

# A stack, a scene, an open mesh.
exits 0 hollow drawn --wall 3 -o from_stack --json
same "$(value wall_min_mm)" 3 "of a stack, walls are as asked"
same "$(changes drawn from_stack 3 3 3 37 27 27 | cut -d' ' -f2-)" "0 0 0" "and only what lies deeper came out"
exits 0 hollow scene:garden --resolution 64 --wall 3 --json
awk -v w="$(value wall_min_mm)" 'BEGIN { exit !(w >= 3) }'
ok $? "of a scene they are $(value wall_min_mm)"
sed '$d' block.obj >open.obj
exits 0 hollow open.obj --pitch 1 --wall 3 -o open --json
same "$(changes drawn open 3 3 3 37 27 27 | cut -d' ' -f2-)" "0 0 0" "behind a hole of the mesh there is a wall as well"

# Masks and widths.
box corner.obj 0 0 0 20 30 30
exits 0 hollow block.obj --pitch 1 --wall 3 --keep corner.obj -o kept
same "$(changes drawn kept 0 0 0 20 30 30 | cut -d' ' -f1-2)" "0 0" "what is to be kept is kept"
exits 0 hollow block.obj --pitch 1 --wall 3 --min-feature 3 --json
same "$(value support_free)" true "struts of a width"
exits 2 hollow block.obj --pitch 0.1 --wall 3 --min-feature 30

# Weights.
exits 0 hollow block.obj --pitch 1 --wall 3 --density 2 --json
same "$(value mass_before)" 72000 "a density is one number"
same "$(value solid_mm3) $(value mass)" "36000 $(value volume_mm3 | awk '{ print 2 * $1 }')" "of all the solid, and of what is left"
left=$(value mass)
run hollow block.obj --pitch 1 --wall 3 --density 2
grep -q "^Solid, its 36000 mm3 weigh 72000; hollow, its .* mm3 weigh $left, by --density 2" stdout
ok $? "and a sentence says so: $(grep '^Solid' stdout)"
box half.obj 0 0 0 20 30 30
cat >density.json <<'END'
{"format": "libsf-density", "version": 1, "density": 2, "infill": 0.25, "wall_mm": 3,
 "regions": [{"box": {"low": [20, 0, 0], "high": [40, 30, 30]}, "density": 4},
             {"mesh": "half.obj", "density": 1}]}
END
exits 0 hollow block.obj --pitch 1 --wall 3 --density density.json --json
same "$(value mass_before) $(value warnings)" "90000 0" "or a file with regions"
awk -v x="$(value com_before_mm.0)" 'BEGIN { exit !(x > 25.999 && x < 26.001) }'
ok $? "which move the centre of mass ($(value com_before_mm.0))"
cat >beside.json <<'END'
{"format": "libsf-density", "version": 1, "density": 2,
 "regions": [{"box": {"low": [20, 0, 0], "high": [40, 30, 30]}, "density": 4},
             {"box": {"low": [20, 0, 300], "high": [40, 30, 310]}, "density": 4},
             {"mesh": "half.obj", "density": 2}]}
END
exits 0 hollow block.obj --pitch 1 --wall 3 --density beside.json
grep -q "region 2 lies beside the part" stderr
ok $? "a region beside the part is worth a warning"
cat >infill.json <<'END'
{"format": "libsf-density", "version": 1, "density": 2, "infill": 0.25, "wall_mm": 3}
END
exits 0 hollow block.obj --pitch 1 --wall 3 --density infill.json --json
same "$(value mass_before)" "42624" "and infill" # (36000 - 19584) * 2 + 19584 / 2
for bad in '{' '[]' '{"format": "libsf-density", "version": 2}' \
    '{"format": "libsf-density", "version": 1, "infill": 0}' \
    '{"format": "libsf-density", "version": 1, "regions": [{"density": 1}]}' \
    '{"format": "libsf-density", "version": 1, "regions": [{"density": -1, "mesh": "half.obj"}]}' \
    '{"format": "libsf-density", "version": 1, "regions": [{"density": 1, "mesh": "none.obj"}]}' \
    '{"format": "libsf-density", "version": 1, "regions": [{"density": 1, "box": {"low": [1, 2], "high": [1, 2, 3]}}]}'; do
    echo "$bad" >bad.json
    exits 3 hollow block.obj --pitch 1 --wall 3 --density bad.json
done
exits 3 hollow block.obj --pitch 1 --wall 3 --density nowhere.json
exits 2 hollow block.obj --pitch 1 --wall 3 --density 0

# A picture, where there are pictures.
run hollow block.obj --pitch 1 --wall 3 --picture cut.png --pixels 200,150 --json
if [ $exit -ne 2 ]; then
    same "$exit $(head -c 4 cut.png | tail -c 3)" "0 PNG" "a picture of a cut"
fi

# What cannot be.
exits 1 hollow block.obj --pitch 1 --wall 20 -o nothing
grep -q 'Nothing can be carved' stderr && [ ! -e nothing ]
ok $? "a wall thicker than the part: $(cat stderr)"
exits 2 hollow block.obj --pitch 1
exits 2 hollow block.obj --pitch 1 --wall 0
exits 2 hollow block.obj --pitch 1 --wall 3 --drain 0
exits 2 hollow block.obj --pitch 1 --wall 3 --drain 2,0
exits 2 hollow block.obj --pitch 1 --wall 3 --cavity cavity
# An arm hangs, hollow or not; sf check finds just as much in what was written, by the command that
# is said, and in the same words.
box arm.obj 40 0 20 60 30 30
{ cat block.obj; sed '/^f/d' arm.obj; awk '/^f/ { print "f", $2 + 8, $3 + 8, $4 + 8, $5 + 8 }' arm.obj; } >armed.obj
for how in "-o armed.stl" "-o armed.stl --angle 40 --pitch 1,1,0.5" "-o armed.stl --rule box3 --bridge 3" "-o armed" "-o armed.stl --up +x" "-o armed.stl --drain 4"; do
    pitch="--pitch 1"
    case $how in *--pitch*) pitch= ;; esac
    # shellcheck disable=SC2086
    run hollow armed.obj $pitch --wall 3 $how
    grep 'hang in the air, as before hollowing' stdout >sentence
    # shellcheck disable=SC2086
    run hollow armed.obj $pitch --wall 3 $how --json
    hangs=$(value accepted_voxels)
    command=$(value check)
    eval "run ${command#sf } --json"
    same "$(value unsupported_voxels)" "$hangs" "$command finds as much that hangs"
    eval "run ${command#sf }"
    same "$(sed -n 's/.*; \(.*\) hang in the air.*/\1/p' stdout)" "$(sed 's/ hang in the air.*//' sentence)" "and says so: $(cat sentence)"
done
exits 2 hollow block.obj --pitch 1 --wall 3 --picture cut.jpg
exits 4 hollow block.obj --pitch 1 --wall 3 --cavity nowhere/cavity.stl -o unwritten
exits 4 hollow block.obj --pitch 1 --wall 3 --picture nowhere/cut.png -o unwritten
exits 4 hollow block.obj --pitch 1 --wall 3 --certificate nowhere/proof.json -o unwritten
[ ! -e unwritten ]
ok $? "and then nothing is written"
finish
