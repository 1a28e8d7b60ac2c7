# Why: programs read the report. Every field that is promised is there, and the figures agree with
# each other and from verb to verb.
. "$1"
needs_json

run check scene:garden --resolution 96 --json
for path in lattice.nx lattice.ny lattice.nz lattice.pitch_mm.1 lattice.layer_mm lattice.origin_mm.2 \
    solid_voxels unsupported_voxels trimmed_voxels island_count support_free volume_mm3 \
    findings.0.kind findings.0.layer findings.0.high_mm.2 findings.0.grow_voxels \
    findings.0.trim_voxels findings.0.rank places.crumbs.most_voxels voids.traps voids.cups voids.cup_voxels rule.kind rule.angle_deg warnings summary; do
    value $path >/dev/null
    ok $? "check reports $path"
done
solid=$(value solid_voxels) trimmed=$(value trimmed_voxels)
same "$(value support_free)" false "the garden needs supports"
same "$(value lattice.nx)" 98 "one empty voxel stands around the part in x"
same "$(value lattice.nz)" 60 "none below it"
same "$(value island_count)" 2 "the lantern and the bird are islands"
sum=0 i=0
while kind=$(value findings.$i.kind 2>/dev/null); do
    sum=$((sum + $(value findings.$i.volume_voxels)))
    i=$((i + 1))
done
same $sum "$trimmed" "the findings add up to what a trim takes away"
ranks=$(j=0; while [ $j -lt $i ]; do value findings.$j.rank; j=$((j + 1)); done | sort -n | uniq | wc -l)
same $((ranks)) $i "every finding has a rank of its own"

# What follows from a finding is one place with it, and places that lose little are only summed up.
i=0
while kind=$(value findings.$i.kind 2>/dev/null); do
    echo "$i $kind $(value findings.$i.volume_voxels) $(value findings.$i.cause)"
    i=$((i + 1))
done >findings
for most in 0 8 40 1000000; do
    exits 1 check scene:garden --resolution 96 --crumbs $most --json
    expected=$(awk -v most=$most '{ root[$1] = $4 == "null" ? $1 : root[$4]; kind[$1] = $2; sum[root[$1]] += $3 }
        END { for (r in sum) if (sum[r] > most) large[kind[r]]++; else { small++; voxels += sum[r] }
              print large["overhang"] + 0, large["island"] + 0, small + 0, voxels + 0 }' findings)
    same "$(value places.overhangs) $(value places.islands) $(value places.crumbs.count) $(value places.crumbs.voxels)" \
        "$expected" "places, and those of at most $most voxels"
    same "$(value trimmed_voxels) $(value findings)" "$trimmed $i" "findings are all listed"
    run check scene:garden --resolution 96 --crumbs $most
    # shellcheck disable=SC2086
    set -- $expected
    named=$(($1 + $2 < 4 ? $1 + $2 : 4))
    same "$(grep -Ec '^  (overhang|island)' stdout)" $named "the dearest are named"
    [ $3 -eq 0 ] || grep -q "supports: .*\b$3 places of at most $most voxels; " stdout
    ok $? "and $3 are not: $(sed -n 2p stdout)"
done

run check scene:garden --pitch 1,1.6,0.8 --json
same "$(value rule.kind)" slack "on oblong pixels the rule is slack"
run check scene:garden --pitch 1,1,0.8 --json
same "$(value rule.kind)" octagon "and octagon on square ones"

# A box of 20 mm with a box of 10 mm in it that faces inwards, shut or open at the top.
hollow() {
    awk -v top="$1" 'BEGIN {
        split("1 3 2 2 3 4 5 6 7 6 8 7 1 2 5 2 6 5 3 7 4 4 7 8 1 5 3 3 5 7 2 4 6 4 8 6", corner)
        for (b = 0; b < 2; b++)
            for (i = 0; i < 8; i++)
                print "v", b ? 5 + 10 * (i % 2) : 20 * (i % 2),
                    b ? 5 + 10 * (int(i / 2) % 2) : 20 * (int(i / 2) % 2),
                    b ? (i < 4 ? 5 : top) : 20 * (i > 3)
        for (i = 1; i <= 36; i += 3) print "f", corner[i], corner[i + 1], corner[i + 2]
        for (i = 1; i <= 36; i += 3) print "f", 8 + corner[i], 8 + corner[i + 2], 8 + corner[i + 1]
    }'
}
hollow 15 >shut.obj
run check shut.obj --pitch 1 --json
same "$(value voids.traps) $(value voids.cups) $(value voids.trap_voxels)" "1 0 1000" "a trap is named"
same "$(value voids.list.0.kind) $(value voids.list.0.area_mm2)" "trap 100" "and how wide it is"
same "$(value voids.list.0.low_mm.2) $(value voids.list.0.high_mm.2)" "5 15" "and where"
hollow 15 | awk '$1 == "v" { $4 -= 5.0000001 } { print }' >sunk.obj
run check sunk.obj --pitch 1
grep -q 'trap .* z = *0\.00 mm' stdout
ok $? "and in a sentence, without a minus where there is nothing to subtract"
hollow 20 >open.obj
run check open.obj --pitch 1 --json
same "$(value voids.traps) $(value voids.cups) $(value voids.list.0.vent_layer)" "0 1 20" "and a cup"

run trim scene:garden --resolution 96 --json -o layers
same "$(value removed_voxels)" "$trimmed" "trim takes away what check said"
same "$(value kept_voxels)" $((solid - trimmed)) "and keeps the rest"
same "$(value added_voxels)" 0 "and adds nothing"
same "$(value support_free)" true "and then it prints"
kept=$(value kept_voxels)
cp stdout trimmed.json
box box.obj 0 0 0 9 9 9
box top.obj 0 0 5 9 9 9
for verb in run info check trim grow repair "preserve --remove top.obj" slice render; do
    # shellcheck disable=SC2086
    run ${verb%% *} box.obj ${verb#"${verb%% *}"} $([ "$verb" = info ] || echo --resolution 16) --json
    [ $exit -eq 2 ] || value seconds >/dev/null
    ok $? "$verb says how long it took"
done

run run scene:garden --resolution 96 --pixels 320,240 -o out
for path in kept_voxels removed_voxels added_voxels support_free; do
    same "$(value trim.$path out/report.json)" "$(value $path trimmed.json)" "run says of its trim what trim says: $path"
done

run check layers --json
same $exit 0 "what trim wrote needs no supports"
same "$(value solid_voxels)" "$kept" "a stack holds the same voxels"
same "$(value rule.kind)" octagon "and carries its rule"
run trim layers -o twice --json
same "$(value removed_voxels)" 0 "trimming twice changes nothing"

run trim layers -o part.stl --json
run info part.stl --json
for path in triangles vertices closed boundary_edges nonmanifold_edges shells oriented flipped \
    volume_mm3 area_mm2 com_mm.2 inertia_mm5.5 bounds_mm.high.2; do
    value $path >/dev/null
    ok $? "info reports $path"
done
same "$(value closed) $(value oriented) $(value flipped)" "true true false" "the mesh is closed"
same "$(value nonmanifold_edges)" 0 "and a manifold"

run slice part.stl --pitch 1 -o again --json
same "$(value solid_voxels)" "$kept" "the mesh becomes the same voxels on the same lattice"
same "$(value layers.0.components)" 1 "slice counts the pieces of a layer"

run orient part.stl --resolution 32 --count 2 --json -o turned.stl
for path in lattice.nx lattice.pitch_mm.1 lattice.layer_mm lattice.origin_mm.2 orientations.1.up.2 orientations.0.matrix.8 orientations.0.shift_mm.2 given.margin_deg \
    orientations.0.trimmed_mm3 orientations.0.height_mm orientations.0.unsupported_mm2 output; do
    value $path >/dev/null
    ok $? "orient reports $path"
done
high=$(value orientations.0.height_mm)
run info turned.stl --json
awk -v low="$(value bounds_mm.low.2)" -v top="$(value bounds_mm.high.2)" -v high="$high" \
    'BEGIN { exit !(low * low < 1e-6 && (top - high) ^ 2 < 1e-6) }'
ok $? "and writes the mesh that way up, on the bed"

# Every verb that makes voxels of a mesh says that it is not closed, and on which lattice.
box whole.obj 0 0 0 20 12 10
sed '$d' whole.obj >lid.obj
for verb in run check trim grow repair "preserve --remove top.obj" slice orient render; do
    # shellcheck disable=SC2086
    run ${verb%% *} lid.obj ${verb#"${verb%% *}"} --resolution 40 --json
    [ $exit -eq 2 ] || same "$(value lattice.nx) $(value lattice.nz) $(value lattice.pitch_mm.0)" "42 20 0.5" "$verb says what its lattice is"
    [ $exit -eq 2 ] || grep -q 'The mesh is not closed (4 open edges)' stdout
    ok $? "$verb warns of an open mesh"
done

# A box of 12 x 20 x 30 mm, as a mesh and as voxels of 2 x 1 x 1.5 mm; inertia is V/12 (b^2 + c^2).
cat >box.obj <<'OBJ'
v 0 0 0
v 12 0 0
v 12 20 0
v 0 20 0
v 0 0 30
v 12 0 30
v 12 20 30
v 0 20 30
f 4 3 2 1
f 5 6 7 8
f 1 2 6 5
f 2 3 7 6
f 3 4 8 7
f 4 1 5 8
OBJ
run slice box.obj --pitch 2,1,1.5 -o box
for part in box.obj box; do
    run info $part --json
    same "$(value volume_mm3) $(value com_mm.0) $(value com_mm.1) $(value com_mm.2)" "7200 6 10 15" "volume and centre of $part"
    same "$(value inertia_mm5.0) $(value inertia_mm5.1) $(value inertia_mm5.2)" "780000 626400 326400" "inertia of $part"
    same "$(value bounds_mm.low.0) $(value bounds_mm.high.1) $(value bounds_mm.high.2)" "0 20 30" "bounds of $part"
done
same "$(value solid_voxels) $(value lattice.layer_mm) $(value closed) $(value shells) $(value area_mm2)" \
    "2400 1.5 null null null" "what voxels have, and what they have not"
run info scene:garden --json
same "$exit $(value lattice.nx)" "0 258" "info takes a scene"
run info box.obj --up +x --json
same "$(value bounds_mm.high.2) $(value inertia_mm5.2)" "12 780000" "info turns a mesh upright"
exits 2 info box --up +x

# A table two micrometres high, over the origin: findings say where they lie, and no zero is negative.
awk 'BEGIN {
    split("-1 -1 0 1 1 1  -3 -3 1 3 3 2", c, " ")
    for (b = 0; b < 2; b++)
        for (i = 0; i < 8; i++)
            print "v", c[6*b + 1 + i%2*3]/1000, c[6*b + 2 + int(i/2)%2*3]/1000, c[6*b + 3 + int(i/4)*3]/1000
    for (b = 0; b < 16; b += 8)
        printf "f %d %d %d %d\nf %d %d %d %d\nf %d %d %d %d\nf %d %d %d %d\nf %d %d %d %d\nf %d %d %d %d\n",
            b+1,b+3,b+4,b+2, b+5,b+6,b+8,b+7, b+1,b+2,b+6,b+5, b+3,b+7,b+8,b+4, b+1,b+5,b+7,b+3, b+2,b+4,b+8,b+6
}' >table.obj
run check table.obj --resolution 12
grep -q 'overhang from z =  *0.0010* mm, x -0.0030* to 0.0030*, y -0.0030* to 0.0030*:' stdout &&
    ! grep -Eq -- '-0\.0*( |:|,)' stdout
ok $? "findings are told in as many digits as the voxels need: $(grep '^  overhang' stdout)"

run check nothing.stl --json
same "$(value error.exit)" 3 "a failure is a JSON object too"
finish
