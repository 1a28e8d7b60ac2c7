# Why: scripts and slicers go by the exit status, and people by the sentence. Each kind of failure has
# its own status in every verb, says one line on standard error, nothing on standard output, and
# leaves no file behind.
. "$1"

says_one_line() {
    [ "$(wc -l <stderr)" -eq 1 ] && [ ! -s stdout ]
    ok $? "one sentence, and nothing on standard output: $(cat stderr)"
}

box box.obj 0 0 0 10 10 10
for arguments in "check" "check a b" "check --nonsense x" "check x --angle 90" "check x --angle 4.9" \
    "check x --pitch 0" "check x --pitch 1,2,3,4" "check x --pitch 1 --resolution 9" \
    "check x --resolution 0" "check x --resolution 2.5" "check x --up w" "check x --units ft" \
    "render x --pixels 64.7,64" "render x --pixels 640,480.5" \
    "check x --rule cone" "check x --rule box3 --angle 30" "check x --scale -1" \
    "check x --size 10 --scale 2" "check x --threads 0" "check x --pitch" "check x -o y" \
    "check x --bed nan" "trim x -o y.step" "trim x -o y.off" "slice x -o y.stl" "render x -o y.stl" \
    "run x -o y.png" "orient x -o y.png" "orient x --count 0" "orient x --pitch 1" "info x --pitch 1" "check scene:garden --bed 1000" \
    "check scene:garden --up +x" "check scene:garden --pitch 1,2 --rule octagon" \
    "preserve x" "preserve x --remove y --mode paper" "grow x --keep y" "trim x --forbid y" \
    "check x --remove y" "grow x -o y.step" "repair x --min-feature 0" "repair x --min-feature -1" \
    "repair x --min-feature nan" "repair x --min-feature inf" "trim x --min-feature 1" \
    "repair scene:garden --resolution 24 --min-feature 1e6" "grow x --angle nan" \
    "repair x --angle -45" "preserve x --remove y --angle 1e300" "grow x --bridge nan" \
    "grow x --bridge -1" "repair x --bridge 1,-1" "grow x --bridge 1,2,3" "trim x --steepest" "trim x --printing" \
    "grow scene:garden --resolution 24 --bridge 1e9" "repair x --keep" "check x --bridge inf" \
    "check x --resolution 65534" "check x --json=3" "check x --crumbs -1" "check x --crumbs 1.5" "trim x --crumbs 3" "check scene:garden --pitch 1e300" \
    "check box.obj --size 1e30" "check box.obj --pitch 1e300"; do
    # shellcheck disable=SC2086
    exits 2 $arguments
    says_one_line
done
exits 2 check box.obj --bed -1e9
grep -q '^sf: --bed -1e+09 lies 1e+09 mm below the part, ' stderr
ok $? "a bed that is too far away is said to be: $(cat stderr)"
exits 2
exits 2 frobnicate
if [ -n "$JSON_GET" ]; then
    for arguments in "check --json" "check x --nonsense --json" "check --json x --angle 90" "frobnicate --json" \
        "check --json scene:garden --bed 1000" "preserve x --json" "run x -o y.png --json"; do
        # shellcheck disable=SC2086
        exits 2 $arguments
        same "$(value error.exit) sf: $(value error.message)" "2 $(head -1 stderr)" "and so does a JSON object"
    done
fi
exits 0 --help
exits 0 --version
for verb in run info check trim grow repair preserve slice orient render; do
    exits 0 $verb --help
done

printf 'solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 x\n' >text.stl
printf 'v 0 0 0\nv 1 0 nan\n' >nan.obj
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n' >index.obj
printf 'solid nothing\nendsolid nothing\n' >none.stl
printf 'v 3 3 3\nv 3 3 3\nv 3 3 3\nf 1 2 3\n' >point.obj
: >empty.stl
mkdir folder
# A build without PNG refuses to draw before it looks at the part.
run render scene:garden --resolution 8 --pixels 16,16 -o probe.png
[ $exit -eq 2 ] && draw= || draw="render -o p.png"
for file in text.stl nan.obj index.obj none.stl point.obj empty.stl missing.stl folder scene:desert; do
    for verb in "check" "trim -o t.stl" "grow -o t.stl" "repair -o t.stl" "slice -o layers" ${draw:+"$draw"} "run -o out"; do
        # shellcheck disable=SC2086
        exits 3 ${verb%% *} "$file" $(expr "$verb" : '[a-z]* \(.*\)')
        says_one_line
    done
done
for file in text.stl nan.obj index.obj empty.stl missing.stl folder; do
    for option in "repair --keep" "grow --forbid" "preserve --remove"; do
        # shellcheck disable=SC2086
        exits 3 ${option%% *} scene:garden --resolution 16 -o t.stl ${option##* } $file
        grep -q "^sf: ${option##* }: .*$file" stderr && [ "$(wc -l <stderr)" -eq 1 ]
        ok $? "one sentence, which names option and file: $(cat stderr)"
    done
done
exits 3 orient scene:garden
exits 3 check text.stl
grep -q 'line 5' stderr
ok $? "the sentence names the line"
[ ! -e t.stl ] && [ ! -e layers ] && [ ! -e p.png ] && [ ! -e out ]
ok $? "no file was left"

exits 4 check scene:garden --pitch 0.01
exits 4 trim scene:garden --resolution 20 -o nowhere/t.stl
exits 4 slice scene:garden --resolution 20 -o folder/missing/layers
printf 'mine\n' >folder/precious
exits 4 slice scene:garden --resolution 20 -o folder
same "$(cat folder/precious)" mine "a folder that is no stack is left alone"
exits 1 check scene:garden --resolution 40 --bed -9
grep -Eq '\b100 % of its matter cannot print' stdout
ok $? "over a bed that is further down all of it hangs in the air"
exits 4 run scene:garden -o folder/precious
says_one_line
# Nothing is not a result: it is said, and not written.
box all.obj -1 -1 -1 200 200 200
for arguments in "trim scene:garden --resolution 40 --bed -9" "preserve box.obj --resolution 16 --remove all.obj" \
    "run scene:garden --resolution 64 --bed -9 --memory 0.15"; do
    # shellcheck disable=SC2086
    exits 1 $arguments -o nothing
    grep -q '^sf: Nothing is left: ' stderr && [ ! -e nothing ]
    ok $? "with a sentence, and no file: $(grep '^sf:' stderr)"
done
# What cannot be written is said before the part is looked at.
for arguments in "trim -o nowhere/t.stl" "grow -o nowhere/layers" "slice -o nowhere/layers" "run -o nowhere/out" \
    "orient -o nowhere/t.stl" ${draw:+"render -o nowhere/p.png"} "trim --certificate nowhere/proof.json"; do
    # shellcheck disable=SC2086
    exits 4 $arguments missing.stl
    says_one_line
done
exits 3 check missing.stl
same "$(grep -o missing.stl stderr | wc -l | tr -d ' ')" 1 "a path is said once"
exits 1 check scene:garden --resolution 40
exits 0 trim scene:garden --resolution 40 --angle 80 -o t.stl
exits 0 trim t.stl --size 900 --resolution 40
grep -Eq 'took [0-9]{5,} mm3 away' stdout
ok $? "large volumes are written out"
finish
