# Why: a stack that is read and written again is the same bytes, its angle too: radians are what is
# kept, and degrees, for people, are made from them and never turned back.
# Its rule, angle, bridges and bed come with it, until an option takes the place of one; and where they
# cannot be, the stack is at fault, and named.
. "$1"
needs_json

for angle in 5 6 9.2 12 18.1 24 33.3 42.4 45 48 52.5 57 66.6 72.4 81.4 85; do
    exits 0 trim scene:garden --resolution 16 --angle $angle -o one
    exits 0 trim one -o two
    diff -r one two >stdout 2>stderr
    ok $? "made for $angle degrees, read and written again, it is the same"
    same "$(value rule.angle_deg two/stack.json)" $angle "and people still read $angle"
    run check two --json
    same "$(value rule.angle_deg)" $angle "in the report too"
    rm -rf one two
done

exits 0 slice scene:garden --resolution 64 --rule slack --angle 50 --bridge 8,1.5 -o drawn
grep -q 'bridges up to 8 mm' stdout
ok $? "what may be bridged is said"
exits 0 slice drawn -o again
diff -r drawn again >stdout 2>stderr
ok $? "slicing a stack keeps its rule"
run check drawn --json
same "$(value rule.kind) $(value rule.bridge_mm.0)" "slack 8" "a stack is judged by what it brings"
for option in "--rule slack" "--angle 50"; do
    # shellcheck disable=SC2086
    exits 1 check drawn $option
    grep -q 'bridges of up to 8 mm stay' stderr && grep -q 'bridges up to 8 mm' stdout
    ok $? "$option leaves the bridges, and says so"
    # shellcheck disable=SC2086
    exits 1 check drawn $option --bridge 0
    ! grep -q 'bridges' stderr && ! grep -q 'bridges' stdout
    ok $? "but for --bridge 0"
done
# An option takes the place of what it names, and of nothing else.
for kind in octagon slack disk; do
    run slice scene:garden --resolution 32 --rule $kind --angle 50 -o own
    for options in "" "--angle 60" "--rule slack" "--rule disk --angle 60"; do
        rule=$kind angle=50
        case $options in *slack*) rule=slack ;; *disk*) rule=disk ;; esac
        case $options in *60*) angle=60 ;; esac
        # shellcheck disable=SC2086
        run check own $options --json
        same "$exit $(value rule.kind) $(value rule.angle_deg)" "1 $rule $angle" "a stack made by $kind at 50, checked with '$options'"
        same "$(value warnings)" 0 "without a warning"
    done
done
run slice scene:garden --resolution 32 --rule box3 -o own
run check own --angle 60 --json
same "$(value rule.kind) $(value rule.angle_deg) $(value warnings)" "octagon 60 1" "box3 takes no angle, which is said"
exits 0 trim own --json
same "$(value rule.kind) $(value rule.angle_deg)" "box3 null" "and without one it stays"

exits 0 slice scene:garden --resolution 32 --bridge 9 --bed -9 -o told
same "$(value rule.bridge_mm.0 told/stack.json) $(value rule.bed_layer told/stack.json)" "9 0" \
    "bridges and bed alone are kept too"

for change in 's/"bridge_mm": \[8,/"bridge_mm": [1e9,/' 's/"kind": "slack"/"kind": "disk"/'; do
    rm -rf bent
    cp -R drawn bent
    # A disk on these layers reaches too little at 20 degrees.
    sed -e "$change" -e '/disk/,$s/"angle_rad": .*/"angle_rad": 0.34906585039886590,/' \
        drawn/stack.json >bent/stack.json
    exits 3 check bent
    grep -q '^sf: bent: stack.json: ' stderr && ! grep -q -- '--bridge' stderr
    ok $? "the stack is named: $(cat stderr)"
    exits 1 check bent --angle 45 --bridge 8
done
exits 2 check drawn --bridge 1e9
grep -q '^sf: --bridge: ' stderr
ok $? "an option is named where it is at fault"
finish
