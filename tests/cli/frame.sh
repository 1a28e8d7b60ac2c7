# Why: a mesh must come back where it was, whatever was meant by up, and at the size that was asked.
. "$1"
needs_json

exits 0 trim scene:garden --resolution 24 -o part.obj
run info part.obj --json
low=$(value bounds_mm.low.0),$(value bounds_mm.low.1),$(value bounds_mm.low.2)
high=$(value bounds_mm.high.0),$(value bounds_mm.high.1),$(value bounds_mm.high.2)

for up in +x -x +y -y +z -z; do
    exits 0 trim part.obj --up $up --pitch 4 -o turned.obj
    run info turned.obj --json
    within=$(awk -v low="$low" -v high="$high" -v a="$(value bounds_mm.low.0),$(value bounds_mm.low.1),$(value bounds_mm.low.2)" \
        -v b="$(value bounds_mm.high.0),$(value bounds_mm.high.1),$(value bounds_mm.high.2)" 'BEGIN {
        split(low, l, ","); split(high, h, ","); split(a, p, ","); split(b, q, ",")
        for (i = 1; i <= 3; i++) if (p[i] < l[i] - 4.01 || q[i] > h[i] + 4.01) { print "no"; exit }
        print "yes" }')
    same "$within" yes "with $up up the result lies within the input, in its axes"
done
run slice part.obj --up +x --pitch 4 --json
nx=$(value lattice.nx) ny=$(value lattice.ny) nz=$(value lattice.nz)
run slice part.obj --up +z --pitch 4 --json
same "$nz" "$(($(value lattice.nx) - 2))" "x becomes the build direction"
same "$nx $ny" "$(($(value lattice.nz) + 2)) $(value lattice.ny)" "z lies down, y stays"

run info part.obj --units in --json
same "$(value bounds_mm.high.2 | cut -d. -f1)" "$(awk -v z="${high##*,}" 'BEGIN { print int(z * 25.4) }')" "inches"
run check part.obj --size 50 --resolution 50 --json
same "$(value lattice.pitch_mm.0)" 1 "--size makes the longest side that long"
run check part.obj --scale 0.5 --pitch 1 --json
same "$(value lattice.nx)" 48 "--scale halves it (92 mm, and an empty voxel on each side)"
same "$(value warnings)" 0 "and no warning"
run check part.obj --units m --resolution 16 --json
same "$(value warnings)" 0 "a unit that was given is believed"
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n' >tiny.obj
run check tiny.obj --resolution 16 --json
same "$(value warnings)" 1 "a part of 1 mm is worth a warning"

run check part.obj --pitch 4 --json
free=$(value unsupported_voxels) nz=$(value lattice.nz)
run check part.obj --pitch 4 --bed -8 --json
same "$(value lattice.nz) $(value bed_layer)" "$((nz + 2)) 0" "a bed two layers below the part"
[ "$(value unsupported_voxels)" -gt "$free" ]
ok $? "leaves all of it in the air"
run trim part.obj --pitch 4 --bed 8 --json
same "$(value bed_layer)" 2 "a bed within the part"
finish
