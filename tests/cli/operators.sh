# Why: trim, grow, repair and preserve are one family: the same options, the same fields, the same
# exit statuses. Their figures agree with each other and with the layers that they write, voxel for
# voxel; repair changes no more than the cheaper of the other two; what prints is left alone; and on
# a full disk nothing half-written is left.
. "$1"
needs_json

# differs A B: "removed added" of two stacks; -1 -1 when they cannot be compared.
differs() {
    # shellcheck disable=SC2086
    set -- $($wrapper "$STACK_COMPARE" "$1" "$2" 0 0 0 0 0 0 2>stderr || echo 0 0 -1 -1)
    echo "$3 $4"
}

for rule in "--angle 45" "--rule box3" "--rule slack --angle 50 --bridge 8,1.5"; do
    # shellcheck disable=SC2086
    exits 0 slice scene:garden --resolution 64 ${rule%% --bridge*} -o drawn
    for verb in trim grow repair; do
        # shellcheck disable=SC2086
        exits 0 $verb scene:garden --resolution 64 $rule -o $verb --json
        cp stdout $verb.json
        for path in verb rule.kind kept_voxels removed_voxels added_voxels cost volume_mm3 \
            removed_mm3 added_mm3 support_free seconds output summary.1; do
            value $path $verb.json >/dev/null
            ok $? "$verb reports $path"
        done
        same "$(differs drawn $verb)" "$(value removed_voxels $verb.json) $(value added_voxels $verb.json)" \
            "$verb changed what it says it changed"
        same "$(value support_free $verb.json) $(value cost $verb.json)" \
            "true $(($(value removed_voxels $verb.json) + $(value added_voxels $verb.json)))" "and it prints"
        exits 0 check $verb
    done
    same "$(value added_voxels trim.json) $(value removed_voxels grow.json)" "0 0" "trim adds nothing, grow removes nothing"
    least=$(value cost trim.json)
    [ "$least" -lt "$(value cost grow.json)" ] || least=$(value cost grow.json)
    [ "$(value cost repair.json)" -le "$least" ]
    ok $? "repair costs no more than the cheaper of the two ($(value cost repair.json), $least)"
done

# What prints is left alone.
for verb in trim grow repair; do
    exits 0 $verb repair -o again --json
    same "$(value cost) $(value support_free)" "0 true" "$verb leaves alone what prints"
    exits 0 $verb repair
    grep -q 'nothing was changed' stdout && grep -q 'Nothing was written' stdout
    ok $? "and says so"
done

# The least width, where all must stay, so that only the width of what is added can differ.
box all.obj -1 -1 -1 200 200 200
run repair scene:garden --resolution 64 --keep all.obj --json
thin=$(value added_voxels)
exits 0 repair scene:garden --resolution 64 --keep all.obj --min-feature 3.1 --json
[ "$(value added_voxels)" -gt "$thin" ]
ok $? "a least width adds more ($(value added_voxels), $thin)"
exits 0 repair scene:garden --resolution 64 --keep all.obj --min-feature 1.4 --json
same "$(value added_voxels)" "$thin" "less than a voxel asks nothing"

# Preserve: of a shape that prints, and of one of which parts hang.
box cap.obj 44 2 0 74 30 24
for mode in fast irredundant core; do
    exits 0 preserve trim --remove cap.obj --mode $mode -o carved --json
    same "$(value support_free) $(value added_voxels) $(value accepted_voxels)" "true 0 0" "what printed prints, mode $mode"
    same "$(differs trim carved | cut -d' ' -f1)" "$(value removed_voxels)" "and lost what it says"
    [ "$(value removed_voxels)" -gt 0 ]
    ok $? "which is something ($(value removed_voxels))"
    exits 0 check carved
done
exits 0 preserve scene:garden --resolution 64 --remove cap.obj -o carved --json
same "$(value support_free)" false "what hung hangs still"
[ "$(value accepted_voxels)" -gt 0 ] && [ "$(value hanging_voxels)" -ge "$(value accepted_voxels)" ]
ok $? "and the report says how much"
exits 0 preserve scene:garden --resolution 64 --remove cap.obj
grep -q 'hung before and were accepted' stdout
ok $? "and a sentence says so"

run check scene:garden --resolution 64 --steepest --json
same "$(value steepest_deg) $(value steepest_box_mm)" "null 2" "an island prints at no angle"
run trim scene:garden --resolution 64 --angle 30 -o steep
run check steep --steepest --json
awk -v a="$(value steepest_deg)" 'BEGIN { exit !(a > 15 && a < 60) }'
ok $? "and what was trimmed for 30 degrees has a steepest overhang of about that ($(value steepest_deg))"
run check steep --steepest
grep -Eq 'steepest overhang is [0-9.]+ degrees .* at z = ' stdout
ok $? "with its place"

# A post with an arm to one side, and a later one to the other that balances it.
box post.obj 0 0 0 10 10 40
box arm.obj -30 0 40 10 10 50
box late.obj -30 0 50 60 10 60
awk 'FNR == 1 { at = n } $1 == "v" { n++ } $1 == "f" { for (i = 2; i <= NF; i++) $i += at } { print }' \
    post.obj arm.obj late.obj >lamp.obj
exits 1 check lamp.obj --pitch 2 --printing --json
same "$(value printing.topples) $(value printing.standing_pieces) $(value printing.floating_pieces)" "true 1 0" "it leans on the way"
same "$(value printing.height_mm) $(value lattice.nz)" "50 30" "and worst once the first arm is there"
awk -v m="$(value printing.margin_deg)" 'BEGIN { a = atan2(-2.5, 32.5) * 57.29577951308232; exit !(m - a < 1e-6 && a - m < 1e-6) }'
ok $? "by the angle of its weight beyond its edge ($(value printing.margin_deg))"
value printing.margins_deg.29 >/dev/null
ok $? "each layer has a margin"
run check lamp.obj --pitch 2 --printing
grep -Eq 'topple while .* after [0-9]+ layers .* with its top at z = ' stdout
ok $? "and a sentence says so"
exits 0 check post.obj --pitch 2 --printing --json
same "$(value printing.topples)" false "a post stands"
awk -v m="$(value printing.margin_deg)" 'BEGIN { a = atan2(5, 20) * 57.29577951308232; exit !(m - a < 1e-6 && a - m < 1e-6) }'
ok $? "worst when it is done ($(value printing.margin_deg))"
run check post.obj --pitch 2 --printing
grep -q 'It stands while it is printed' stdout
ok $? "as a sentence says"
awk '$1 == "v" && $4 > 0 { $2 += 30 } { print }' post.obj >lean.obj
exits 0 check lean.obj --pitch 1 --angle 60
exits 1 check lean.obj --pitch 1 --angle 60 --printing

# A mesh that was smoothed is looked at again, whoever made it.
exits 0 repair scene:garden --resolution 48 --smooth 3 -o smooth.stl --json
value smoothed.unsupported_voxels >/dev/null
ok $? "repair takes --smooth"

# A full disk: files that may not grow beyond a few blocks.
if [ -z "$wrapper" ]; then
    for verb in grow repair "preserve --remove cap.obj"; do
        for to in full.stl full; do
            exit=0
            # shellcheck disable=SC2086
            (trap '' XFSZ; ulimit -f 8; exec "$SF" $verb scene:garden --resolution 200 -o $to) \
                >stdout 2>stderr || exit=$?
            [ $exit -eq 4 ] || { [ $to = full ] && [ $exit -eq 0 ]; } # small layers fit
            ok $? "$verb to $to on a full disk exits with 4"
            [ $exit -eq 0 ] || [ -z "$(ls -A | grep full)" ]
            ok $? "and leaves nothing"
            rm -rf full
        done
    done
    exit=0
    (trap '' XFSZ; ulimit -f 8; exec "$SF" repair scene:garden --resolution 200 -o full --certificate full.json) \
        >stdout 2>stderr || exit=$?
    same "$exit $(ls -A | grep -c full)" "4 0" "a certificate on a full disk is none, nor are its layers"
    grep -q '^sf: full.json: ' stderr && ! grep -q tmp stderr
    ok $? "which is said: $(cat stderr)"
fi
finish
