# Why: a painted surface is to become a graded print without a line of code: filled with tetrahedra, by
# voxels or by TetGen, and printed by sf grade. Whichever way, half of a box that is painted from 0 to 1
# is of either material; and what is no surface, or no values, ends in a sentence and no file.
# usage: fill.sh TAP; $SF is sf-fill or sf-tetgen, $GRADE is sf
. "$1"

box part.obj 0 0 0 10 20 30
# Its corners have z 0 four times, then 30.
printf '0\n0\n0\n0\n1\n1\n1\n1\n' >values.txt

# shellcheck disable=SC2086
exits 0 part.obj --values values.txt --property shade ${PITCH:-} -o part.vtk --json
grep -q '"volume_mm3": 6000' stdout || grep -q '"volume_mm3": 5999.99999' stdout
ok $? "the box is filled"
"$GRADE" grade part.vtk --property shade --pitch 1 -o graded >stdout 2>stderr
grep -Eq 'low .*asked for (50|49\.9)' stdout
ok $? "and half of it is of either material"

printf '0\n-\n0\n-\n1\n-\n-\n1\n' >values.txt
run part.obj --values values.txt -o free.vtk
[ "$exit" -eq "${FREE:-0}" ]
ok $? "vertices may be free"

printf '0\n0\n0\n' >short.txt
printf '0\n0\n0\n0\n1\n1\n1\n1e999\n' >infinite.txt
printf '0\n0\n0\n0\n1\n1\n1\n1\n1\n' >long.txt
printf '0\n0\n0\n0\n1\none\n1\n1\n' >word.txt
for file in short infinite long word none; do
    exits 3 part.obj --values $file.txt -o no.vtk
done
exits 3 part.obj --values values.txt --property poisson -o no.vtk # 1 is beyond its bounds
exits 3 none.obj --values values.txt -o no.vtk
exits 2 part.obj --values values.txt -o no.stl
exits 2 part.obj -o no.vtk
[ ! -e no.vtk ] && [ ! -e no.stl ]
ok $? "and no file is left"
exits 0 --help
grep -q 'examples:' stdout
ok $? "--help has examples"
finish
