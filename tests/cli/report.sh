# Why: programs read the report. Every field that is promised is there, and the figures agree with
# each other and from verb to verb.
. "$1"
needs_json

run check scene:garden --resolution 96 --json
for path in lattice.nx lattice.ny lattice.nz lattice.pitch_mm.1 lattice.layer_mm lattice.origin_mm.2 \
    solid_voxels unsupported_voxels trimmed_voxels island_count support_free volume_mm3 \
    findings.0.kind findings.0.layer findings.0.high_mm.2 rule.kind rule.angle_deg warnings summary; do
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

run trim scene:garden --resolution 96 --json -o layers
same "$(value trim.removed_voxels)" "$trimmed" "trim takes away what check said"
same "$(value trim.kept_voxels)" $((solid - trimmed)) "and keeps the rest"
same "$(value trim.added_voxels)" 0 "and adds nothing"
same "$(value trim.support_free)" true "and then it prints"
kept=$(value trim.kept_voxels)
value seconds >/dev/null
ok $? "trim says how long it took"

run check layers --json
same $exit 0 "what trim wrote needs no supports"
same "$(value solid_voxels)" "$kept" "a stack holds the same voxels"
same "$(value rule.kind)" octagon "and carries its rule"
run trim layers -o twice --json
same "$(value trim.removed_voxels)" 0 "trimming twice changes nothing"

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
run check nothing.stl --json
same "$(value error.exit)" 3 "a failure is a JSON object too"
finish
