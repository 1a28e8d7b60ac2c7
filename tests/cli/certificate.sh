# Why: the proof that travels with a result is made by the program and checked by another one. Every
# operator writes it whole or not at all, sf-verify takes it for that stack and no other.
. "$1"
if [ -z "${SF_VERIFY:-}" ]; then
    echo "1..0 # SKIP sf-verify is not built"
    exit 0
fi

# verified N STACK CERTIFICATE: sf-verify exits with N.
verified() {
    exit=0
    # shellcheck disable=SC2086
    $wrapper "$SF_VERIFY" $2 $3 >stdout 2>stderr || exit=$?
    [ "$exit" -eq "$1" ]
    ok $? "sf-verify $2 $3 exits with $1: $(cat stdout stderr | head -1)"
}

for rule in "--rule box3" "--angle 50" "--rule disk --angle 75" "--rule slack --angle 40 --bridge 6,1.5"; do
    for verb in trim grow repair; do
        # shellcheck disable=SC2086
        exits 0 $verb scene:garden --resolution 48 $rule -o layers --certificate proof.json
        verified 0 layers proof.json
    done
done

# Preserve: of what prints, and of what hangs before and after, which the certificate then exempts.
box gate.obj 8 4 0 44 20 14
for how in "layers" "scene:garden --resolution 48 --mode irredundant" "scene:garden --resolution 48 --mode core"; do
    # shellcheck disable=SC2086
    exits 0 preserve $how --remove gate.obj -o carved --certificate carved.json
    verified 0 carved carved.json
done
grep -q '"exempt": \[\]' carved.json
[ $? -eq 1 ]
ok $? "what was accepted is in the certificate"
cp proof.json other.json
exits 0 trim scene:garden --resolution 48 --angle 50 -o layers --certificate proof.json
verified 1 layers other.json
same "$(cat stdout)" "not verified: it is of other layers than these" "a certificate of another model says so"
sed 's/"trim"/"grow"/' proof.json >changed.json
verified 1 layers changed.json
: >empty.json
verified 3 layers empty.json
verified 3 layers missing.json
same "$(cat stderr)" "sf-verify: missing.json: it cannot be read" "and names the file"
verified 3 missing proof.json
same "$(cat stderr)" "sf-verify: missing/stack.json: it cannot be read" "of a folder too"
verified 0 --help ""
grep -q '^usage: sf-verify LAYERS CERTIFICATE' stdout && [ ! -s stderr ]
ok $? "help is on standard output"
verified 0 -h ""
verified 2 layers ""
verified 2 "" ""
grep -q '^usage: ' stderr && [ ! -s stdout ]
ok $? "and usage on standard error where it was none"
verified 2 layers "proof.json again"
# One byte more than it reads: a hole at its end takes no room.
cp proof.json large.json
dd if=/dev/zero of=large.json bs=1 count=1 seek=268435456 conv=notrunc 2>/dev/null
verified 3 layers large.json
grep -q 'larger than 256 MiB' stderr && [ "$(wc -l <stderr)" -eq 1 ] && [ ! -s stdout ]
ok $? "and says why: $(cat stderr)"
rm large.json
exits 0 trim layers --angle 50 -o again --certificate again.json
verified 0 again again.json
exits 0 trim scene:garden --resolution 24 -o part.stl --certificate part.json
exits 2 check scene:garden --certificate part.json
exits 4 trim scene:garden --resolution 24 --certificate nowhere/part.json
exits 4 trim scene:garden --resolution 24 -o uncertified --certificate nowhere/part.json
[ ! -e uncertified ]
ok $? "and no layers without the certificate that was asked for"
[ ! -e nowhere ] && [ -z "$(ls | grep tmp)" ]
ok $? "nothing half-written"
finish
