# Why: `sf run` is the first thing that anybody does. It writes five things, says so in ten lines, and
# can be run again.
. "$1"

for attempt in first second; do
    run run --resolution 64 --pixels 320,240 -o out
    same $exit 0 "$attempt run"
    [ "$(wc -l <stdout)" -le 10 ]
    ok $? "at most ten lines"
    [ -s out/printable.stl ] && [ -s out/report.json ] && [ -s out/layers/stack.json ]
    ok $? "mesh, report and stack are there"
    [ "$(ls out | wc -l)" -le 5 ] && [ -z "$(ls -A out | grep '^\.')" ]
    ok $? "and nothing else"
done
if [ -n "$JSON_GET" ]; then
    same "$(value trim.support_free out/report.json)" true "the report is JSON and says it prints"
    exits 0 check out/layers
    exits 0 check out/printable.stl --pitch 1.5
fi
if [ -e out/before.png ]; then
    same "$(head -c 8 out/before.png | od -An -tx1 | tr -d ' \n')" 89504e470d0a1a0a "the picture is a PNG"
    cmp -s out/before.png out/after.png
    [ $? -eq 1 ]
    ok $? "before and after differ"
fi

# Any number of threads gives the same bytes.
for threads in 1 3; do
    run trim scene:garden --resolution 80 --threads $threads -o t$threads.ply
    run render scene:garden --resolution 48 --pixels 160,120 --threads $threads -o t$threads.png
done
cmp -s t1.ply t3.ply
ok $? "one and three threads write the same mesh"
[ ! -e t1.png ] || cmp -s t1.png t3.png
ok $? "and the same picture"

# Ctrl-C: status 130, and nothing half-written.
$wrapper "$SF" trim scene:garden --resolution 900 -o big.stl >stdout 2>stderr &
pid=$!
sleep 0.3
kill -INT $pid
exit=0
wait $pid || exit=$?
same $exit 130 "cancelled"
[ ! -e big.stl ] && [ -z "$(ls -A | grep 'big')" ]
ok $? "a cancelled run leaves no file"
finish
