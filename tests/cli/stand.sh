# Why: `sf stand` says that a model stands, and by how much. Here the meshes that it wrote are weighed
# and tipped again, by a few lines that share nothing with it; and what it says of itself, hanging,
# several stances, files of handles, what cannot be, is held against shapes of which one knows.
. "$1"
needs_json

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
finish
