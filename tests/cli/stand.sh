# Why: `sf stand` says that a model stands, and by how much. Here the meshes that it wrote are weighed
# and tipped again, by a few lines that share nothing with it; and what it says of itself, hanging,
# several stances, files of handles, what cannot be, is held against shapes of which one knows.
. "$1"
needs_json
docs=$(dirname "$1")/../../docs/balance.md

# tower FILE LEAN RINGS: a square column of 12 mm and 40 mm height whose top lies LEAN aside in x.
tower() {
    awk -v lean="$2" -v n="$3" 'BEGIN {
        for (k = 0; k <= n; k++)
            for (i = 0; i < 4; i++)
                print "v", ((i == 1 || i == 2) ? 12 : 0) + lean * k / n, (i > 1) ? 12 : 0, 40 * k / n
        print "f 1 4 3 2"
        for (k = 0; k < n; k++)
            for (i = 0; i < 4; i++)
                print "f", 4 * k + i + 1, 4 * k + (i + 1) % 4 + 1, 4 * k + 4 + (i + 1) % 4 + 1, 4 * k + 4 + i + 1
        print "f", 4 * n + 1, 4 * n + 2, 4 * n + 3, 4 * n + 4 }' >"$1"
}

# corners MESH...: x y z of each corner of each triangle of binary STL files, a line each.
corners() {
    for mesh in "$@"; do
        tail -c +85 "$mesh" | od -An -v -w50 -tu1 | awk '
            function number(at, e, m) {
                e = ($(at + 3) % 128) * 2 + int($(at + 2) / 128)
                m = ($(at + 2) % 128) * 65536 + $(at + 1) * 256 + $at
                m = (e == 0 ? m * 2 : m + 8388608) * 2 ^ (e - 150)
                return $(at + 3) > 127 ? -m : m }
            { for (c = 0; c < 3; c++)
                printf "%.9g %.9g %.9g\n", number(13 + 12 * c), number(17 + 12 * c), number(21 + 12 * c) }'
    done
}

# tipped UP OUTER [INNER]: the least tilt, in degrees, that tips what the meshes bound, put on its
# lowest vertices: from the triangles alone. UP is 1, 2 or 3 for x, y or z.
tipped() {
    up=$1
    shift
    corners "$@" >corners
    awk -v u="$up" -v outer="$(corners "$1" | wc -l)" '
        { for (d = 1; d <= 3; d++) p[NR % 3, d] = $d }
        NR <= outer { n++; h[n] = $u; x[n] = $(u % 3 + 1); y[n] = $((u + 1) % 3 + 1); if (n == 1 || h[n] < low) low = h[n] }
        NR % 3 == 0 {
            det = p[1, 1] * (p[2, 2] * p[0, 3] - p[2, 3] * p[0, 2]) - p[1, 2] * (p[2, 1] * p[0, 3] - p[2, 3] * p[0, 1]) \
                + p[1, 3] * (p[2, 1] * p[0, 2] - p[2, 2] * p[0, 1])
            mass += det
            for (d = 1; d <= 3; d++) c[d] += det * (p[0, d] + p[1, d] + p[2, d]) / 4 }
        END {
            for (d = 1; d <= 3; d++) c[d] /= mass
            cx = c[u % 3 + 1]; cy = c[(u + 1) % 3 + 1]; up = c[u] - low
            for (i = 1; i <= n; i++) if (h[i] < low + 1e-4) { m++; fx[m] = x[i]; fy[m] = y[i] }
            # An edge of the hull has all contacts on its left: tried for every pair.
            least = 90
            for (i = 1; i <= m; i++) for (j = 1; j <= m; j++) {
                ex = fx[j] - fx[i]; ey = fy[j] - fy[i]; l = sqrt(ex * ex + ey * ey)
                if (l < 1e-6) continue
                for (k = 1; k <= m; k++) if (ex * (fy[k] - fy[i]) - ey * (fx[k] - fx[i]) < -1e-6 * l) break
                if (k <= m) continue
                tilt = atan2((ex * (cy - fy[i]) - ey * (cx - fx[i])) / l, up) * 45 / atan2(1, 1)
                if (tilt < least) least = tilt
            }
            printf "%.4f\n", least }' corners
}

# near A B TOLERANCE WORDS
near() {
    awk -v a="$1" -v b="$2" -v t="$3" 'BEGIN { exit !(a - b <= t && b - a <= t) }'
    ok $? "$4 ($1, $2)"
}

# A tower that leans too far, in three directions; carved, and bent where that is not enough.
tower tower.obj 16 8
awk '/^v/ { print "v", $4, $2, $3; next } { print }' tower.obj >tower_x.obj
awk '/^v/ { print "v", $3, $4, $2; next } { print }' tower.obj >tower_y.obj
for case in "tower.obj +z 3" "tower_x.obj +x 1" "tower_y.obj +y 2"; do
    # shellcheck disable=SC2086
    set -- $case
    exits 0 stand $1 --up $2 --wall 1 --resolution 32 --pixels 200,150 -o tower --json
    cmp -s stdout tower.json
    ok $? "the report is on standard output and in the file"
    same "$(value stands) $(value safe) $(value up) $(value build)" "true true $2 $2" "it stands"
    near "$(value margin_before_deg)" "-5.7106" 1e-3 "it would have fallen" # atan(2 / 20): 2 mm beyond the edge, 20 mm high
    near "$(value margin_deg)" "$(tipped $3 tower_outer.stl $([ -e tower_inner.stl ] && echo tower_inner.stl))" 0.01 "the margin is that of the meshes"
    awk -v m="$(value margin_deg)" 'BEGIN { exit !(m >= 4) }'
    ok $? "and as large as asked"
    awk -v w="$(value wall_min_mm)" 'BEGIN { exit !(w == "null" || w >= 0.999999) }'
    ok $? "the wall is as thick as asked ($(value wall_min_mm))"
    same "$(value cavity_support_free) $(value folds) $(value overlap_voxels)" "true 0 0" "nothing hangs, folds or overlaps"
    if [ "$(value picture)" != null ]; then
        same "$(head -c 4 tower.png | tail -c 3)" PNG "and a picture shows it"
    fi
done

# Printed another way up than it stands: gravity's up decides, and all is in the axes of the input.
exits 0 stand tower.obj --up +z --build +x --wall 1 --resolution 32 --pixels 200,150 -o other --json
same "$(value succeeded) $(value safe) $(value up) $(value build) $(value cavity_support_free)" "true true +z +x true" "printed along x it stands along z"
near "$(value margin_deg)" "$(tipped 3 other_outer.stl other_inner.stl)" 0.01 "by the margin of its meshes"
near "$(value com_before_mm.0)" 14 1e-9 "with places in the axes of the input"

# A tower that carving alone can save, and one that it cannot: then the bound is the proof.
tower light.obj 13 1
exits 0 stand light.obj --wall 1 --resolution 40 --no-deform --gamma 1 -o light --json
same "$(value safe)" true "carved alone it stands"
corners light_outer.stl | sort -u >new
awk '/^v/ { printf "%.9g %.9g %.9g\n", $2, $3, $4 }' light.obj | sort -u >old
cmp -s old new
ok $? "and its outside is as it was"
near "$(value margin_deg)" "$(tipped 3 light_outer.stl light_inner.stl)" 0.01 "by the margin of its meshes"
awk -v b="$(value bound_deg)" -v m="$(value margin_deg)" 'BEGIN { exit !(b >= m) }'
ok $? "which is no better than the bound ($(value bound_deg), $(value margin_deg))"
exits 1 stand tower.obj --wall 1 --resolution 32 --no-deform
grep -q 'It cannot stand: the best margin that was found is -' stdout && grep -q 'No carving of the shape as it was given passes a margin of -' stdout
ok $? "where it cannot stand, a sentence says how far it came, and that no carving could"
exits 1 stand tower.obj --no-deform --no-carve --json
same "$(value stands) $(value bound_deg) $(value carved_mm3) $(value iterations)" "false null 0 1" "left as it is it falls"
near "$(value margin_deg)" "-5.7106" 1e-3 "by what it was"
for way in "--carve paper" "--no-carve" "--no-laplacian" "--min-feature 4" "--handles auto:3"; do
    # shellcheck disable=SC2086
    exits 0 stand tower.obj --resolution 32 $way --json
    same "$(value safe)" true "it stands with $way"
done
run stand tower.obj --wall 1 --resolution 32 --solver paper --mu 0.2
[ "$exit" -le 1 ] && grep -q 'rounds' stdout
ok $? "the paper's solver runs ($exit)"

# A foot that is not flat is put flat, and how far that goes counts; but not with --no-deform.
awk '/^v/ && $4 == 0 && $2 == 12 { $4 = 0.3 } { print }' light.obj >uneven.obj
run stand uneven.obj --wall 1 --resolution 32 -o uneven --json
awk -v m="$(value max_displacement_mm)" 'BEGIN { exit !(m >= 0.299) }'
ok $? "feet that are put flat are said to move ($(value max_displacement_mm))"
run stand uneven.obj --wall 1 --resolution 32 --no-deform -o uneven --json
corners uneven_outer.stl | sort -u >new
awk '/^v/ { printf "%.9g %.9g %.9g\n", $2, $3, $4 }' uneven.obj | sort -u >old
awk '{ getline other <"old"; split(other, o, " "); for (i = 1; i <= 3; i++) if (($i - o[i]) ^ 2 > 1e-8) exit 1 }' new
ok $? "with --no-deform they stay as they are"
near "$(value max_displacement_mm)" 0 1e-4 "and it says so"

# Layers, and a certificate of them.
exits 0 stand light.obj --wall 1 --resolution 40 --no-deform --gamma 1 -o light --layers light --certificate proof.json --json
same "$(value layers) $(value certificate)" "light proof.json" "layers and a certificate"
run check light --json
[ "$exit" -le 1 ] && [ "$(value lattice.nz)" -ge 39 ]
ok $? "which are a stack like any other"
if [ -n "$SF_VERIFY" ]; then
    $wrapper "$SF_VERIFY" light proof.json >verified
    same "$? $(awk '{ print $1 }' verified)" "0 verified:" "which sf-verify takes"
fi
exits 2 stand light.obj --layers light
exits 2 stand light.obj -o light --certificate proof.json
exits 2 stand light.obj -o light --layers light --certificate proof.json --carve paper
exits 4 stand light.obj -o light --layers nowhere/layers
exits 0 stand light.obj --wall 1 --resolution 40 --gamma 1 --drain 2 -o drained --layers drained --certificate drained.proof --json
if [ -n "$SF_VERIFY" ]; then
    $wrapper "$SF_VERIFY" drained drained.proof >verified
    same "$? $(awk '{ print $1 }' verified)" "0 verified:" "with holes too"
fi

# Holes: what is taken from the outside is the cavity and its holes, and it stands with them.
exits 0 stand tower.obj --wall 1 --resolution 40 --drain 2 --pixels 200,150 -o drained --json
same "$(value drained.closed) $(value drained.safe)" "0 true" "with holes nothing is shut in, and it stands"
[ "$(value drained.open)" -ge 1 ]
ok $? "there is one ($(value drained.open))"
awk -v c="$(value carved_mm3)" -v h="$(value drained.volume_mm3)" 'BEGIN { exit !(c > 0 && h > 0 && h < c) }'
ok $? "of $(value drained.volume_mm3) mm3"
carved=$(value carved_mm3) hole=$(value drained.volume_mm3) filled=$(value drained.filled)
exits 0 info drained_cut.stl --json
awk -v v="$(value volume_mm3)" -v c="$carved" -v h="$hole" -v f="$filled" 'BEGIN { exit !((v >= c + h - 1e-3 || f > 0) && v < 1.1 * (c + h)) }'
ok $? "the body to be taken away is as large, and goes on ($(value volume_mm3), $carved, $hole)"

# Halves: of the model as it came out, so that a weight can be put in. Closed, and facing outwards.
halves() { # NAME: the sum of both volumes
    sum=0
    for half in low high; do
        exits 0 info $1_$half.stl --json
        same "$(value closed) $(value oriented) $(value flipped) $(value misoriented_edges)" "true true false 0" "$1_$half.stl is closed and faces outwards"
        sum=$(awk -v s="$sum" -v v="$(value volume_mm3)" 'BEGIN { printf "%.6f", s + v }')
    done
}
exits 0 stand tower.obj --wall 1 --resolution 40 --cut z,20 --pixels 200,150 -o opened --json
same "$(value halves.axis) $(value halves.at_mm) $(value halves.low.output) $(value halves.high.output)" "z 20 opened_low.stl opened_high.stl" "--cut opens it"
halves opened
for side in outer inner; do
    exits 0 info opened_$side.stl --json
    same "$(value closed)" true "opened_$side.stl is closed"
    sum=$(awk -v s="$sum" -v v="$(value volume_mm3)" -v h=$side 'BEGIN { printf "%.6f", s - (v < 0 || h == "outer" ? v : -v) }')
done
near "$sum" 0 0.05 "the halves are the outside without the cavity"
# With holes too: the layers are voxels, so what they weigh is known to the last one. The plane lies
# in faces of voxels, and across holes, where x = 6 is.
for cut in z,20 z,20.3 x,6; do
    exits 0 stand tower.obj --wall 1 --resolution 40 --drain 2 --cut $cut --pixels 200,150 -o drilled --layers drilled --json
    holes=$(value drained.volume_mm3)
    same "$(awk -v h="$holes" 'BEGIN { print (h > 1) }') $(value drained.closed) $(value halves.shut_cavities)" "1 0 0" "drained and cut at $cut"
    grep -q 'The halves have the holes' drilled.json
    ok $? "and says that the holes are in the halves"
    halves drilled
    exits 0 info drilled --json
    near "$sum" "$(value volume_mm3)" 0.01 "the halves are what the layers are, holes and all ($holes mm3 of holes)"
done
exits 0 stand tower.obj --wall 1 --resolution 40 --pixels 200,150 -o opened
[ ! -e opened_low.stl ] && [ ! -e opened_high.stl ]
ok $? "halves of an earlier run go"
exits 1 stand tower.obj --wall 1 --resolution 32 --cut x,27 --pixels 200,150 -o opened
grep -q 'not cut as it came out. The plane x = 27 mm leaves nothing on one side: the mesh goes from [-0-9.e]* to 2[0-6][0-9.]* mm along x' stderr
ok $? "bent away from the plane it is not cut: $(cat stderr)"
exits 2 stand tower.obj --cut z,20
exits 2 stand tower.obj --cut z,40 -o beside

# What hangs is said in the words of sf check, with the command that finds the same: on the same
# voxels, of the outside without the cavity, or without cavity and holes, or of layers. A mesh is
# written in 32-bit floats, by which a voxel in thousands turns over.
sentence=$(run stand tower.obj --wall 1 --resolution 40 --build +x --pixels 200,150 -o looked && grep 'hang in the air' stdout)
[ -n "$sentence" ]
ok $? "what hangs is said: $sentence"
for how in "--build +x" "--build -y --angle 50" "--up +x --wall 1.3" "--rule box3 --build +x" "--drain 2" "--drain 2 --build +x" "--layers looked"; do
    # shellcheck disable=SC2086
    run stand tower.obj --wall 1 --resolution 40 --pixels 200,150 $how -o looked --json
    hangs=$(value unsupported_voxels) falls=$(value trimmed_voxels) free=$(value support_free)
    command=$(value check)
    eval "run ${command#sf } --json"
    near "$(value unsupported_voxels)" "$hangs" 1 "$command finds as much that hangs"
    near "$(value trimmed_voxels)" "$falls" 4 "and as much that rests on it"
    same "$(value support_free)" "$free" "and the same verdict"
done
exits 0 stand light.obj --wall 1 --resolution 40 --no-deform --gamma 1 -o 'with space' --pixels 200,150 --json
command=$(value check) solid=$(value unsupported_voxels)
eval "run ${command#sf } --json"
same "$(value unsupported_voxels) $(value inner)" "$solid with space_inner.stl" "$command"
exits 3 check light.obj --inner missing.stl
box beside.obj 100 0 0 110 10 10
exits 3 check light.obj --inner beside.obj
grep -q 'lies beside the part' stderr
ok $? "a cavity lies in its part: $(cat stderr)"
exits 2 check scene:garden --resolution 16 --inner beside.obj
# A cavity is taken away whichever way it faces: 40 x 30 x 20 less 20 x 10 x 10 in the middle, whose
# ceiling hangs but for its rim.
box whole.obj 0 0 0 40 30 20
box hole.obj 10 10 5 30 20 15
awk '/^f/ { print "f", $5, $4, $3, $2; next } { print }' hole.obj >turned_hole.obj
for hole in hole turned_hole; do
    run check whole.obj --inner $hole.obj --pitch 1 --json
    same "$exit $(value solid_voxels) $(value unsupported_voxels)" "1 22000 144" "without $hole.obj"
done

# Contacts: on one of two feet. A bench whose feet stand at x = 0..4 and 16..20.
awk 'BEGIN { b = 0; print "# bench" }
    function box(x0, x1, z0, z1, i) {
        for (i = 0; i < 8; i++) print "v", (i % 2) ? x1 : x0, (int(i / 2) % 2) ? 10 : 0, (i > 3) ? z1 : z0
        n = split("1 3 4 2 5 6 8 7 1 2 6 5 3 7 8 4 1 5 7 3 2 4 8 6", f, " ")
        for (i = 1; i <= n; i += 4) print "f", b + f[i], b + f[i + 1], b + f[i + 2], b + f[i + 3]
        b += 8 }
    BEGIN { box(0, 4, 0, 10); box(16, 20, 0, 10); box(0, 20, 10, 14) }' >bench.obj
exits 0 stand bench.obj --no-carve --no-deform --json
same "$(value support_polygon_mm.1.0)" 20 "on two feet it stands on both"
run stand bench.obj --no-carve --no-deform --contacts 'x>12.5' --json
same "$exit $(value support_polygon_mm.0.0) $(value support_polygon_mm.2.0)" "1 16 20" "with --contacts on one of them, and falls"
run stand bench.obj --no-carve --no-deform --contacts 'x>0.5,x<0.6' --json
same "$exit" 3 "where nothing can touch the ground it has no stance"
run stand bench.obj --units cm --no-carve --no-deform --contacts 'x<125' --json
same "$(value support_polygon_mm.1.0)" 40 "numbers of --contacts are in mm of the part as it is printed"
exits 3 stand bench.obj --units cm --no-carve --no-deform --contacts 'x>400' --json
grep -q 'the model spans x 0 to 200, y 0 to 100, z 0 to 140 mm' stderr
ok $? "and who asks beside it is told where it lies: $(cat stderr)"

# What rests already is left alone, also where its feet could be put flat.
exits 0 stand bench.obj --gamma 20 --resolution 40
grep -q 'nothing was changed' stdout && ! grep -q 'put flat' stdout
ok $? "what stands already is left as it is"

# A sheared block, whose weights are so steep around its handles that long steps fold it: it stood
# when it was solid, and with a cavity fell by up to 12.8 degrees, because no step was taken.
{
    printf 'v %s\n' '0 0 0' '20 0 0' '20 20 0' '0 20 0' '27 0 30' '47 0 30' '47 20 30' '27 20 30'
    printf 'f %s\n' '1 3 2' '1 4 3' '5 6 7' '5 7 8' '1 2 6' '1 6 5' '2 3 7' '2 7 6' '3 4 8' '3 8 7' \
        '4 1 5' '4 5 8'
} >lean.obj
for wall in 2 3 4 5; do
    exits 0 stand lean.obj --resolution 40 --wall $wall --json
    [ "$(value succeeded)" = true ] && [ "$(value iterations)" -lt 12 ]
    ok $? "with a wall of $wall mm a leaning block stands after $(value iterations) rounds"
done
exits 0 stand lean.obj --resolution 40 --wall 12
grep -q 'nothing left to carve within walls of 12 mm' stdout
ok $? "and is told where walls leave nothing to carve"

# Hanging: straight below the point is the centre of mass, which the point is over, or not.
box block.obj 0 0 0 40 30 20
exits 0 stand block.obj --suspend 20,15,20 --resolution 32 --no-deform --json
near "$(value margin_deg)" 0 1e-9 "hung from the middle of its top it hangs as it is"
same "$(value stances.0.kind) $(value safe) $(value bound_deg)" "hang true null" "and says so"
exits 1 stand block.obj --suspend 30,15,20 --no-carve --no-deform --json
near "$(value margin_deg)" -45 1e-9 "hung 10 mm beside it, it turns by 45 degrees"
exits 3 stand block.obj --suspend 20,15,40
grep -q 'lies 20 mm outside of the model' stderr
ok $? "tied to the air it does not hang: $(cat stderr)"
exits 3 stand block.obj --suspend 50000,15,20 --units m --no-deform # a slip of the unit
grep -q 'which spans x 0 to 4e+04, y 0 to 3e+04, z 0 to 2e+04 mm' stderr
ok $? "and is told where the model lies: $(cat stderr)"
exits 0 stand block.obj --suspend 20,15,12 --resolution 32 --no-deform

# Rest: a block on its edge falls onto a side, and a slab put on its narrow side stays there.
exits 0 stand block.obj --up +x --rest --json
near "$(value rest.tilt_deg)" 0 1e-9 "a block stays on any side"
near "$(value rest.margin_deg)" 26.5651 1e-3 "until the ground tilts by atan(10 / 20)"
exits 0 stand tower.obj --rest --json
same "$(value rest.turns | awk '{ print ($1 > 0) }')" 1 "the tower falls over"
run stand tower.obj --rest
grep -q 'tips over' stdout && grep -q 'until the ground tilts' stdout
ok $? "which is said: $(head -1 stdout)"

# Several stances at once, from a file; handles from a file.
cat >stances.json <<'END'
{"format": "libsf-stance", "version": 1, "stances": [
    {"kind": "stand", "up": [0, 0, 2], "gamma_deg": 5},
    {"kind": "hang", "up": [0, 0, 1], "point_mm": [20, 15, 20], "tolerance_deg": 2},
    {"up": [1, 0, 0], "low_mm": [-1, -1, -1], "high_mm": [1, 100, 100], "contact_mm": 0.1}]}
END
exits 0 stand block.obj --stance stances.json --resolution 24 --no-deform --pixels 200,150 -o many --json
same "$(value stances.0.kind) $(value stances.1.kind) $(value stances.2.kind) $(value stances.2.safe)" "stand hang stand true" "three stances at once"
near "$(value stances.1.tolerance_deg)" 2 1e-9 "each with its own figures"
cat >handles.json <<'END'
{"format": "libsf-handles", "version": 1, "handles": [
    {"at_mm": [13, 6, 32]},
    {"kind": "ball", "at_mm": [9, 6, 18], "radius_mm": 2, "locked": true,
     "pose": {"scale": 1.1, "shift_mm": [-1, 0, 0.5], "turn_deg": [3, -20, 5]}}]}
END
for build in +z +x; do
    run stand tower.obj --build $build --handles handles.json --wall 1 --resolution 32 --json
    same "$(value handles.1.locked) $(value handles.1.pose.shift_mm.0) $(value handles.1.pose.shift_mm.2)" "true -1 0.5" "a locked handle keeps its pose, printed along $build"
    near "$(value handles.1.pose.scale)" 1.1 1e-12 "and its scale"
    near "$(value handles.1.pose.turn_deg.1)" -20 1e-9 "and its turn"
    same "$(value handles.0.pose.shift_mm.0 | awk '{ print ($1 < 0) }')" 1 "the other is moved back over the foot"
done

echo '{"format": "libsf-handles", "version": 1, "handles": [
    {"ray": {"from_mm": [-50, 6, 18], "direction": [2, 0, 0]}}]}' >ray.json
for build in +z +x; do
    run stand tower.obj --build $build --handles ray.json --wall 1 --resolution 64 --json
    near "$(value handles.0.at_mm.0)" 13.2 0.7 "a ray leads to the middle of the tower, printed along $build"
    same "$(value handles.0.at_mm.1) $(value handles.0.at_mm.2)" "6 18" "and nowhere else"
done

# The examples of docs/balance.md, as they stand there.
awk '/^## / { inside = /sf stand/ } inside && /^```json/ { file = "doc" ++n ".json"; next }
    /^```/ { file = "" } file != "" { print >file }' "$docs"
[ -s doc1.json ] && [ -s doc2.json ]
ok $? "docs/balance.md shows files of stances and handles"
exits 0 stand tower.obj --stance doc1.json --handles doc2.json --wall 1 --resolution 32 --json
same "$(value stances.1.kind) $(value safe) $(value handles.1.kind)" "hang true ball" "and they work"

# A density: a heavy foot, and the margin is that of what it weighs.
cat >density.json <<'END'
{"format": "libsf-density", "version": 1, "regions": [{"box": {"low": [0, 0, 0], "high": [40, 30, 10]}, "density": 3}]}
END
exits 0 stand block.obj --resolution 40 --no-carve --no-deform --density density.json --json
near "$(value com_mm.2)" 7.5 1e-6 "with a heavy half the centre of mass is lower"
near "$(value mass)" 48000 1e-3 "and it weighs what its halves do"
near "$(value com_before_mm.2)" 7.5 1e-6 "as it was at first"
near "$(value margin_before_deg)" 63.4349 1e-3 "and so is the margin at first" # atan(15 / 7.5)
exits 0 stand block.obj --rest --density density.json --json
near "$(value rest.height_mm)" 7.5 1e-6 "also where it rests"

# A dense region is a thing that is put there: it stays, unless it says that it may go. A mass in a
# point counts, and is no matter.
magnet='"box": {"low": [12, 10, 4], "high": [28, 20, 12]}, "density": 5'
echo "{\"format\": \"libsf-density\", \"version\": 1, \"regions\": [{$magnet}]}" >magnet.json
echo "{\"format\": \"libsf-density\", \"version\": 1, \"regions\": [{$magnet, \"keep\": false}]}" >goes.json
exits 0 hollow block.obj --pitch 1 --wall 2 --density magnet.json -o stays --json
carved=$(value carved_mm3)
exits 0 hollow block.obj --pitch 1 --wall 2 --density goes.json -o went --json
near "$(awk -v a="$(value carved_mm3)" -v b="$carved" 'BEGIN { print (a - b >= 600 && a - b <= 1800) }')" 1 0 "a magnet is not carved away ($carved mm3), unless it may be ($(value carved_mm3) mm3)"
echo '{"format": "libsf-density", "version": 1, "masses": [{"mass": 24000, "at_mm": [20, 15, 2]}]}' >mass.json
exits 0 stand block.obj --resolution 40 --no-carve --no-deform --density mass.json --json
near "$(value com_mm.2)" 6 1e-6 "a mass in a point draws the centre of mass towards it"
near "$(value mass)" 48000 1e-3 "and weighs what it weighs"
exits 0 stand block.obj --rest --density mass.json --json
near "$(value rest.height_mm)" 6 1e-6 "also where it rests"

# Holes are weighed with what is drilled out: a file that says 2 everywhere is the number 2, and
# where the floor weighs three times as much its holes do.
exits 0 stand tower.obj --wall 1 --resolution 40 --density 2 --drain 2 --json
number="$(value drained.open) $(value drained.volume_mm3)" com=$(value drained.com_mm.0) mass=$(value drained.mass)
near "$mass" "$(awk -v v="$(value drained.volume_mm3)" 'BEGIN { print 2 * v }')" 1e-6 "holes of a density of 2 weigh twice their volume"
echo '{"format": "libsf-density", "version": 1, "density": 2}' >even.json
exits 0 stand tower.obj --wall 1 --resolution 40 --density even.json --drain 2 --json
same "$(value drained.open) $(value drained.volume_mm3)" "$number" "a file that says the same drills the same holes"
near "$(value drained.com_mm.0)" "$com" 1e-9 "and the centre of mass is there with them"
echo '{"format": "libsf-density", "version": 1, "regions": [{"box": {"low": [-99, -99, -99], "high": [99, 99, 4]}, "density": 3}]}' >floor.json
exits 0 stand light.obj --wall 2 --gamma 0 --no-deform --resolution 40 --density floor.json --drain 2 --json
near "$(value drained.mass)" "$(awk -v v="$(value drained.volume_mm3)" 'BEGIN { print 3 * v }')" 1e-6 "holes through a heavy floor weigh that ($(value drained.volume_mm3) mm3)"
near "$(value drained.holes.0.mass)" "$(awk -v v="$(value drained.holes.0.volume_mm3)" 'BEGIN { print 3 * v }')" 1e-6 "each of them"
for keep in true false; do
    echo '{"format": "libsf-density", "version": 1, "regions": [{"density": 1, "keep": '$keep', "box": {"low": [-99, -99, -99], "high": [99, 99, 99]}}]}' >all.json
    run stand light.obj --wall 2 --gamma 0 --no-deform --resolution 40 --density all.json --json
    same "$exit $(awk -v v="$(value carved_mm3)" 'BEGIN { print (v > 0) }')" "$([ $keep = true ] && echo 1 0 || echo 0 1)" "where keep is $keep what stands is carved as it may be"
done

# A number says how heavy all of it is, and takes no longer; one that voxels cannot hold is refused.
exits 0 stand tower.obj --wall 1 --resolution 40 --density 2 --json
same "$(value safe)" true "twice as heavy, the tower is bent upright"
for bad in 0 -1 nan inf 1e-300 1e300; do
    exits 2 stand block.obj --density $bad
done

# As steep as can be asked for; off a table's edge; with a vertex far below that nothing uses.
run stand block.obj --gamma 80 --no-deform --resolution 24
same "$exit" 1 "80 degrees can be asked for, and are not reached"
{ box table.obj 0 0 0 10 10 10; cat table.obj; box arm.obj 10 0 -60 40 10 5
  awk '/^v/ { print } /^f/ { print "f", $2 + 8, $3 + 8, $4 + 8, $5 + 8 }' arm.obj; } >hook.obj
for deform in '' --no-deform; do
    run stand hook.obj --contacts 'z>-1' --gamma 2 --resolution 40 $deform --json
    same "$exit $(value stands) $(value bound_deg)" "1 false null" "off a table's edge it falls, and there is no bound"
done
{ cat block.obj; echo 'v 5 5 -5000'; } >stray.obj
exits 0 stand stray.obj --resolution 24 --json
near "$(value max_displacement_mm)" 0 1e-9 "a vertex of no triangle makes no foot"

# Inside out, open.
awk '/^f/ { print $1, $5, $4, $3, $2; next } { print }' block.obj >inside_out.obj
exits 0 stand inside_out.obj --resolution 24
grep -q 'inside out; it was turned' stderr
ok $? "a mesh that is inside out is turned, with a word"
sed '$d' block.obj >open.obj
exits 3 stand open.obj
grep -q 'open.obj: The mesh is open' stderr
ok $? "an open mesh is refused: $(cat stderr)"

# What makes no sense.
for bad in '{' '[]' '{"format": "libsf-stance", "version": 2, "stances": [{}]}' \
    '{"format": "libsf-stance", "version": 1, "stances": []}' \
    '{"format": "libsf-stance", "version": 1, "stances": [{"kind": "lie"}]}' \
    '{"format": "libsf-stance", "version": 1, "stances": [{"up": [0, 0, 0]}]}' \
    '{"format": "libsf-stance", "version": 1, "stances": [{"up": [0, 1]}]}' \
    '{"format": "libsf-stance", "version": 1, "stances": [{"gama_deg": 3}]}' \
    '{"format": "libsf-stance", "version": 1, "stances": [{"gamma_deg": 85}]}' \
    '{"format": "libsf-stance", "version": 1, "stances": [{"gamma_deg": "3"}]}'; do
    echo "$bad" >bad.json
    exits 3 stand block.obj --stance bad.json
done
for bad in '{"format": "libsf-handles", "version": 1, "handles": [{"kind": "point"}]}' \
    '{"format": "libsf-handles", "version": 1, "handles": [{"at_mm": [1, 2, 3], "kind": "ball"}]}' \
    '{"format": "libsf-handles", "version": 1, "handles": [{"at_mm": [1, 2, 3], "pose": {"scale": 0}}]}' \
    '{"format": "libsf-handles", "version": 1, "handles": [{"at_mm": [100, 2, 3]}]}' \
    '{"format": "libsf-handles", "version": 1, "handles": [{"at_mm": [1, 2, 3], "ray": {"from_mm": [1, 2, 3], "direction": [1, 0, 0]}}]}' \
    '{"format": "libsf-handles", "version": 1, "handles": [{"ray": {"from_mm": [1, 2, 3]}}]}' \
    '{"format": "libsf-handles", "version": 1, "handles": [{"ray": {"from_mm": [1, 2, 3], "direction": [0, 0, 0]}}]}' \
    '{"format": "libsf-handles", "version": 1, "handles": [{"ray": {"from_mm": [-9, 2, 3], "direction": [-1, 0, 0]}}]}'; do
    echo "$bad" >bad.json
    exits 3 stand block.obj --handles bad.json
done
exits 2 stand block.obj --contacts 'w>0'
exits 2 stand block.obj --contacts 'x>3,x<2'
exits 2 stand block.obj --suspend 1,2
exits 2 stand block.obj --gamma 81
exits 2 stand block.obj --handles auto:64
exits 2 stand block.obj --carve whole
exits 2 stand block.obj --mu 0.5
exits 2 stand block.obj --max-shift 0
exits 2 stand block.obj --max-shift 2 --solver paper
exits 2 stand block.obj --pitch 1,1,2
exits 2 stand block.obj --rest -o rest
exits 2 stand block.obj --stance stances.json --gamma 3
exits 2 stand block.obj --suspend 1,2,3 --gamma 3
exits 4 stand block.obj -o nowhere/block
exits 3 stand missing.obj -o missing
[ ! -e missing_outer.stl ]
ok $? "and then nothing is written"

# Any number of threads gives the same bytes.
for threads in 1 3; do
    run stand tower.obj --wall 1 --resolution 32 --pixels 200,150 --threads $threads -o t$threads
done
cmp -s t1_outer.stl t3_outer.stl && cmp -s t1_inner.stl t3_inner.stl
ok $? "one and three threads write the same meshes"
[ ! -e t1.png ] || cmp -s t1.png t3.png
ok $? "and the same picture"

# Ctrl-C: status 130, and what an earlier run wrote is there still.
ls -A >names
$wrapper "$SF" stand tower.obj --wall 1 --resolution 250 -o t1 >stdout 2>stderr &
pid=$!
sleep 0.3
kill -INT $pid
exit=0
wait $pid || exit=$?
same $exit 130 "cancelled"
cmp -s t1_outer.stl t3_outer.stl && cmp -s t1_inner.stl t3_inner.stl && [ -z "$(ls -A | grep -v -x -F -f names)" ]
ok $? "a cancelled run leaves all as it was"
finish
