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

# Places are named in the axes of the file, whichever of them points up. A column with an arm that
# hangs, a pillar beside it that leans over, and a cavity; turned, so that something else is up.
# turn UP: lines of three numbers, as they would stand in a file of which UP points up.
turn() {
    awk -v up="$1" -v OFMT=%.15g '{ x = $1; y = $2; z = $3 }
        up == "+z" { print x, y, z } up == "-z" { print x, -y + 0, -z + 0 }
        up == "+x" { print z, y, -x + 0 } up == "-x" { print -z + 0, y, x }
        up == "+y" { print x, z, -y + 0 } up == "-y" { print x, -z + 0, y }'
}
# sorted LOW HIGH: two corners, the lower numbers first.
sorted() {
    echo "$1 $2" | awk -v OFMT=%.15g '{ for (i = 1; i <= 3; i++) { l[i] = $i < $(i + 3) ? $i : $(i + 3); h[i] = $i + $(i + 3) - l[i] }
        print l[1], l[2], l[3], h[1], h[2], h[3] }'
}
triple() { echo "$(value "$1.0") $(value "$1.1") $(value "$1.2")"; }
# places: the report's places, a line each, in the axes of the file.
places() {
    $wrapper "$SF" check turned.obj --up "$1" --pitch 1 --printing --steepest --json >stdout 2>stderr
    for box in findings.0.:low_mm:high_mm voids.list.0.:low_mm:high_mm steepest_box_mm.:low:high printing.:low_mm:high_mm; do
        echo "$box $(sorted "$(triple "${box%%:*}$(echo "$box" | cut -d: -f2)")" "$(triple "${box%%:*}${box##*:}")")"
    done
    echo "com $(triple printing.com_mm)"
    echo "height $(value findings.0.height_mm)"
    $wrapper "$SF" hollow turned.obj --up "$1" --pitch 1 --wall 2 --drain 3 --json >stdout 2>stderr
    echo "hollow $(triple com_mm) $(triple com_before_mm)"
    echo "hole $(triple drains.0.from_mm) $(triple drains.0.to_mm)"
}
{ box base.obj 3 0 2 15 14 26; box arm.obj 15 4 18 35 10 24; cat base.obj; sed '/^f/d' arm.obj
  awk '/^f/ { print "f", $2 + 8, $3 + 8, $4 + 8, $5 + 8 }' arm.obj
  box room.obj 6 3 8 12 11 20; sed '/^f/d' room.obj; awk '/^f/ { print "f", $5 + 16, $4 + 16, $3 + 16, $2 + 16 }' room.obj; } >upright.obj
cp upright.obj turned.obj
places +z >upright
grep -q '[1-9]' upright && ! grep -q null upright
ok $? "there are places to name"
for up in +x -x +y -y -z; do
    { sed -n 's/^v //p' upright.obj | turn $up | sed 's/^/v /'; grep '^f' upright.obj; } >turned.obj
    places $up >found
    while read -r name numbers; do
        # shellcheck disable=SC2086
        set -- $numbers
        case $name in
        *:*) expected=$(sorted "$(echo "$1 $2 $3" | turn $up)" "$(echo "$4 $5 $6" | turn $up)") ;;
        com) expected=$(echo "$1 $2 $3" | turn $up) ;;
        height) expected=$1 ;;
        *) expected="$(echo "$1 $2 $3" | turn $up) $(echo "$4 $5 $6" | turn $up)" ;;
        esac
        got=$(grep "^$name " found | cut -d' ' -f2-)
        echo "$got $expected" | awk '{ n = NF / 2; for (i = 1; i <= n; i++) if (($i - $(n + i)) ^ 2 > 1e-12) exit 1 }'
        ok $? "with $up up $name is $got"
    done <upright
done
run check turned.obj --up -z --pitch 1
grep -q 'overhang from z = *-18.00 mm, x [0-9.]* to [0-9.]*, y -' stdout
ok $? "sentences begin with the height, and name the file's axes: $(sed -n 3p stdout)"
run orient turned.obj --up -z --resolution 24 --json
same "$(triple given.up) $(value given.matrix.8)" "0 0 -1 -1" "directions are in the file's axes too"
finish
