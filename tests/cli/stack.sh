# Why: a stack that is read and written again is the same bytes, its angle too: radians are what is
# kept, and degrees, for people, are made from them and never turned back.
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
finish
