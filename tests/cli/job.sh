# Why: a job that is checked must be told what the same layers are told as a stack, without ever
# being held; what is trimmed or repaired must come back as a job that prints; a name that is no job,
# or a job cut short, ends with a sentence and leaves nothing.
. "$1"
needs_json

exits 0 slice scene:garden --resolution 48 -o layers
run slice scene:garden --resolution 48 -o job.sl1
if [ $exit -ne 0 ] && grep -q 'build it with libspng' stderr; then
    ok 0 "a build without libspng writes no SL1, and says so"
    finish
fi
same $exit 0 "a part becomes a job"
exits 1 check layers --json
cp stdout stack.json
exits 1 check job.sl1 --json
cp stdout job.json
for key in solid_voxels unsupported_voxels trimmed_voxels island_count overhang_count findings findings.0.layer \
    findings.0.volume_voxels findings.1.area_voxels voids.traps voids.trap_voxels voids.cups voids.cup_voxels \
    lattice.nx lattice.nz rule.kind; do
    same "$(value $key job.json)" "$(value $key stack.json)" "as a job and as a stack it has the same $key"
done
same "$(value job job.json) $(value threshold job.json)" "sl1 128" "the report says what it read"

# Its findings need no mesh; what takes all layers at once loads them.
exits 1 check job.sl1 --steepest
grep -q 'steepest\|at no angle' stdout
ok $? "--steepest reads all of it"
for verb in trim grow repair; do
    exits 0 $verb job.sl1 -o fixed.sl1
    grep -q 'layers changed; everything else is as it was' stdout
    ok $? "sf $verb says how many layers changed"
    exits 0 check fixed.sl1
    rm -f fixed.sl1
done
exits 0 trim job.sl1 -o layers_of_it
exits 0 check layers_of_it

# A box without a lid, and one that is shut.
cage_box() { # FILE, LID: walls of a box as five or six slabs
    box slab_0.obj 0 0 0 10 10 1
    box slab_1.obj 0 0 1 10 1 6
    box slab_2.obj 0 9 1 10 10 6
    box slab_3.obj 0 1 1 1 9 6
    box slab_4.obj 9 1 1 10 9 6
    box slab_5.obj 0 0 6 10 10 7
    awk -v lid="$2" 'FNR == 1 { file++; first = count } $1 == "v" && file <= 5 + lid { print; count++ }
        $1 == "f" && file <= 5 + lid { print "f", $2 + first, $3 + first, $4 + first, $5 + first }' slab_?.obj >"$1"
}
cage_box open.obj 0
cage_box shut.obj 1
exits 0 slice open.obj --pitch 0.5 -o open.sl1
exits 0 check open.sl1
grep -q 'cup .*opens when the print ends' stdout
ok $? "a cup is named, and when it opens"
exits 0 slice shut.obj --pitch 0.5 -o shut.sl1
run check shut.sl1 --json
same "$(value voids.traps)" 1 "and so is a trap"

cat >part.cli <<'END'
$$HEADERSTART
$$ASCII
$$UNITS/1
$$LAYERS/2
$$HEADEREND
$$GEOMETRYSTART
$$LAYER/0.5
$$POLYLINE/1,1,4,0,0,4,0,4,4,0,4
$$LAYER/1
$$POLYLINE/1,1,4,0,0,8,0,8,4,0,4
$$GEOMETRYEND
END
exits 1 check part.cli --pitch 0.5 --json
same "$(value solid_voxels) $(value lattice.layer_mm)" "192 0.5" "contours are drawn at the pitch that was asked for"

head -c 2000 job.sl1 >short.sl1
cp layers/stack.json wrong.sl1
for file in short.sl1 wrong.sl1 missing.sl1 missing.cli; do
    exits 3 check $file
    exits 3 trim $file -o out.sl1
    [ ! -e out.sl1 ]
    ok $? "$file leaves nothing: $(cat stderr)"
done
exits 2 check job.sl1 --up +x
exits 2 check job.sl1 --threshold 0
exits 2 trim job.sl1 -o out.photon
exits 4 trim job.sl1 --memory 0.01 -o out.sl1
cp job.sl1 same.sl1
exits 0 trim same.sl1 -o same.sl1
exits 0 check same.sl1
finish
