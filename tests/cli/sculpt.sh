#!/bin/sh
# The sculpting program without a window, and, where there is an X server without a screen, with one:
# what was recorded gives the same bits either way and once more from its session; a model is never
# lost to a file that cannot be read, a window of one pixel or a close in the middle of a stroke.
# shellcheck disable=SC1091
. "${1%/*}/tap.sh"

SF=$SCULPT

# shellcheck disable=SC2154
exits 0 --help
grep -q 'sculpt --headless --scene shaun' stdout
ok $? "help has examples"
exits 0 --version
for bad in '--nonsense' '--headless' '--resolution 12' '--size 12' '--scene shaun part.stl' '--hash' 'a.stl b.stl' '--headless --hash --view 3' '--headless --record x --hash' '--headless --workspace grade --scene shaun --hash'; do
    # shellcheck disable=SC2086
    exits 2 $bad
    [ -s stderr ]
    ok $? "and says why: $(head -1 stderr)"
done

# Hashes: the same for the same scene, another for another.
exits 0 --headless --scene shaun --resolution 96 --hash
shaun=$(cat stdout)
exits 0 --headless --scene shaun --resolution 96 --hash
same "$(cat stdout)" "$shaun" "a scene is the same every time"
exits 0 --headless --scene pumpkin --resolution 96 --hash
[ "$(cat stdout)" != "$shaun" ]
ok $? "and another scene is another"
exits 0 --headless --hash
exits 3 --headless --scene timmy --hash
grep -q 'shaun, pumpkin and intertwined' stderr
ok $? "a scene that there is not is refused with those that there are: $(cat stderr)"
exits 3 --headless nowhere.stl --hash
echo 'solid broken' >broken.stl
exits 3 --headless broken.stl --hash
echo 'libsf-session 1 space' >broken.session
exits 3 --headless --session broken.session --hash
grep -q 'line 2' stderr
ok $? "a session that is broken is refused by its line: $(cat stderr)"

# What was recorded, without a window; its session gives the same model.
cat >input <<'END'
size 0 0 800 600 0 0 0
set 2 0 5 0 0 0 0
set 3 0 3 0 0 0 0
key 51 0 0 0 0 0 0
press 0 0 480 220 0 0 0
move 0 0 500 240 0 0 0
move 0 0 560 300 0 0 0
release 0 0 560 300 0 0 0
press 1 0 400 300 0 0 0
move 0 0 460 310 0 0 0
release 1 0 460 310 0 0 0
scroll 0 0 0 2 0 0 0
press 0 2 400 300 0 0 0
move 0 0 410 320 0 0 0
release 0 0 410 320 0 0 0
press 0 1 420 260 0 0 0
release 0 0 420 260 0 0 0
do 0 0 0 0 0 0 0
do 1 0 0 0 0 0 0
key 90 2 0 0 0 0 0
set 5 0 1 0 0 0 0
press 0 0 380 250 0 0 0
move 0 0 390 260 0 0 0
do 4 0 0 0 0 0 0
press 0 0 380 250 0 0 0
release 0 0 380 250 0 0 0
END
exits 0 --headless --scene shaun --resolution 96 --input input --hash --save first.session --size 800x600
hash=$(cat stdout)
[ "$hash" != "$shaun" ]
ok $? "input changes the model"
exits 0 --headless --session first.session --hash
same "$(cat stdout)" "$hash" "and its session gives the same"
{ echo 'set 0 0 1 0 0 0 0'; echo 'open first.session'; echo 'open nowhere.stl'; } >opens
exits 0 --headless --scene pumpkin --resolution 96 --input opens --hash
same "$(cat stdout)" "$hash" "a file that is opened is an event as well, and one that cannot be changes nothing"
grep -q 'opens, line 3: .*nowhere.stl' stderr
ok $? "which is said: $(cat stderr)"
echo 'open ' >opens
exits 3 --headless --input opens --hash
grep -q 'line 1' stderr
ok $? "an event that opens no file is none: $(cat stderr)"
# A mesh as the brush's shape: its session holds the voxels, so the mesh is not needed again.
box tip.obj 0 0 0 40 10 20
{ echo 'tip nowhere.stl'; echo 'tip tip.obj'; cat input; } >meshed
exits 0 --headless --scene shaun --resolution 96 --size 800x600 --input meshed --hash --save meshed.session
meshed=$(cat stdout)
[ "$meshed" != "$hash" ]
ok $? "a mesh as a brush makes another model"
rm tip.obj
exits 0 --headless --session meshed.session --hash
same "$(cat stdout)" "$meshed" "and its session gives the same"
# Steps that were there when a session was opened can be undone; the next session knows them too,
# and so does one after it.
printf 'do 0 0 0 0 0 0 0\ndo 0 0 0 0 0 0 0\n' >undo
exits 0 --headless --scene shaun --resolution 96 --input undo --hash --save undone.session
undone=$(cat stdout)
[ "$undone" != "$shaun" ]
ok $? "strokes of a scene are undone"
exits 0 --headless --session undone.session --hash
same "$(cat stdout)" "$undone" "and its session gives the same"
exits 0 --headless --session first.session --input undo --hash --save third.session
undone=$(cat stdout)
exits 0 --headless --session third.session --hash
same "$(cat stdout)" "$undone" "as do steps of a session that was opened"
grep -q '^stroke' undone.session
ok $? "which keeps the strokes that it began with"
# The release of another button than the one that draws does not end a stroke.
cat >buttons <<'END'
press 0 0 480 220 0 0 0
press 1 0 480 220 0 0 0
release 1 0 480 220 0 0 0
move 0 0 560 300 0 0 0
release 0 0 560 300 0 0 0
END
exits 0 --headless --scene shaun --resolution 96 --input buttons --hash --size 800x600
both=$(cat stdout)
grep -v ' 1 0 480' buttons >button
exits 0 --headless --scene shaun --resolution 96 --input button --hash --size 800x600
same "$(cat stdout)" "$both" "another button that comes and goes changes nothing"
[ "$both" != "$shaun" ]
ok $? "of a stroke that there is"
exits 3 --headless --input nowhere --hash
echo 'dance 1 2' >nonsense
exits 3 --headless --input nonsense --hash
for number in nan inf -inf 1e300; do
    echo "move 0 0 $number 0 0 0 0" >nonsense
    exits 3 --headless --input nonsense --hash
    grep -q 'line 1' stderr
    ok $? "and so is $number: $(cat stderr)"
done
exits 4 --headless --save nowhere/there.session --hash

# The session that docs/sculpt.md shows.
sed -n '/^```session/,/^```/p' "$DOCS/sculpt.md" | grep -v '^```' >shown.session
exits 0 --headless --session shown.session --hash
[ "$(cat stdout)" != "$shaun" ] && [ -s shown.session ]
ok $? "the session of the documents is played"

# The other workspaces: what was recorded gives the same bits each time, and another hash each.
cat >balance <<'END'
do 102 0 0 0 0 0 0
do 100 0 0 0 0 0 0
do 7 0 0 0 0 0 0
do 7 0 0 0 0 0 0
do 7 0 0 0 0 0 0
press 0 0 400 200 0 0 0
move 0 0 410 180 0 0 0
release 0 0 410 180 0 0 0
do 7 0 0 0 0 0 0
END
cat >grade <<'END'
do 200 0 0 0 0 0 0
set 203 0 0.5 0 0 0 0
key 32 0 0 0 0 0 0
do 7 0 0 0 0 0 0
key 90 2 0 0 0 0 0
set 200 0 1 0 0 0 0
press 0 0 400 320 0 0 0
move 0 0 420 300 0 0 0
release 0 0 420 300 0 0 0
do 7 0 0 0 0 0 0
END
exits 0 --headless --workspace balance --size 800x600 --input balance --hash --save balance.obj
balanced=$(cat stdout)
exits 0 --headless --workspace balance --size 800x600 --input balance --hash
same "$(cat stdout)" "$balanced" "what was done at the balance gives the same bits"
[ -s balance.obj ] && [ -s balance_inner.obj ]
ok $? "and leaves a hull and a cavity"
exits 0 --headless --workspace balance --size 800x600 --hash balance.obj
exits 0 --headless --workspace grade --size 800x600 --input grade --hash --save grade.vtk
graded=$(cat stdout)
exits 0 --headless --workspace grade --size 800x600 --input grade --hash
same "$(cat stdout)" "$graded" "and so does what was painted"
exits 0 --headless --workspace grade --hash grade.vtk
# Without input all is done that is under way at the beginning: the slice is part of it.
alone=$(cat stdout)
echo 'do 7 0 0 0 0 0 0' >slice
exits 0 --headless --workspace grade --input slice --hash grade.vtk
same "$(cat stdout)" "$alone" "a cage is sliced without being asked"
[ "$graded" != "$balanced" ]
ok $? "a hash each"
# From one to the other and back, with a shape that was sculpted.
printf 'set 15 0 1 0 0 0 0\nset 15 0 2 0 0 0 0\nset 15 0 0 0 0 0 0\n' >rounds
exits 0 --headless --scene shaun --resolution 96 --input rounds --hash
same "$(cat stdout)" "$shaun" "the shape is the same after a walk through all workspaces"
exits 0 --headless --scene shaun --resolution 96 --workspace balance --hash
[ "$(cat stdout)" != "$balanced" ]
ok $? "and stands on the balance"
exits 3 --headless --workspace balance broken.stl --hash
exits 3 --headless --workspace grade broken.stl --hash
[ -s stderr ]
ok $? "what is no cage is refused: $(cat stderr)"
exits 2 --headless --workspace kitchen --hash
exits 4 --headless --workspace balance --save nowhere/out.obj

# Pictures.
if [ "${SF_NO_GL:-}" = 1 ]; then
    echo "ok $((count += 1)) - pictures # SKIP SF_NO_GL=1"
else
    exits 0 --headless --scene shaun --resolution 96 --shot shot.png --size 320x200
    [ "$(head -c 4 shot.png | tail -c 3)" = PNG ] && [ "$(wc -c <shot.png)" -gt 5000 ]
    ok $? "a picture is drawn"
    exits 0 --headless --scene shaun --resolution 96 --bench --size 160x100
    grep -q 'a frame of 160x100: [0-9.]* ms' stdout
    ok $? "and frames are timed: $(cat stdout)"
    exits 4 --headless --scene shaun --resolution 96 --shot nowhere/shot.png --size 32x20
    for work in balance grade; do
        exits 0 --headless --workspace $work --input $work --shot $work.png --size 320x200 --bench
        [ "$(wc -c <$work.png)" -gt 5000 ]
        ok $? "a picture of the workspace $work: $(cat stdout)"
    done

    # The twin on the graphics card, told apart from the model by what it is fetched from.
    exits 0 --headless --scene shaun --resolution 96 --size 800x600 --input input --hash --gpu --shot twin.png
    same "$(cat stdout)" "$hash" "the graphics card holds the same after all that was recorded"
    exits 0 --headless --scene shaun --resolution 96 --size 800x600 --input input --shot model.png
    cmp -s twin.png model.png
    ok $? "and draws the same"
    # More undone than the card has seen done, some of it done again, and a stroke upon that.
    { cat input; printf 'do %d 0 0 0 0 0 0\n' 0 0 0 0 0 0 0 0 1 1 1 1 1 0 0; tail -n 5 input; echo 'do 0 0 0 0 0 0 0'; } >deep
    exits 0 --headless --scene shaun --resolution 96 --size 800x600 --input deep --hash
    deep=$(cat stdout)
    exits 0 --headless --scene shaun --resolution 96 --size 800x600 --input deep --hash --gpu
    same "$(cat stdout)" "$deep" "also where steps are undone that it has not seen"
    [ "$deep" != "$hash" ]
    ok $? "which is another model"
fi

# The window.
if [ "${SF_NO_GL:-}" = 1 ] || [ -z "${SCULPT_WINDOW:-}" ] || ! command -v xvfb-run >/dev/null 2>&1; then
    echo "ok $((count += 1)) - the window # SKIP there is no window in this build, no xvfb-run, or SF_NO_GL=1"
else
    # xvfb-run takes the server's words as one; with a file of its own for authorities it would fail at
    # times to remove the folder of that.
    : >authority
    window() {
        exit=0
        timeout 120 xvfb-run -a -f authority -s "-screen 0 1280x1024x24" "$SF" "$@" >stdout 2>stderr </dev/null || exit=$?
    }
    window --scene shaun --resolution 96 --size 800x600 --input input --save second.session --shot window.png --record again
    same "$exit" 0 "the window plays what was recorded: $(cat stderr)"
    cmp -s first.session second.session
    ok $? "to the same session"
    [ "$(wc -c <window.png)" -gt 20000 ]
    ok $? "and shows it, with its panel"
    window --scene shaun --resolution 96 --size 800x600 --input input --save second.session --gpu --shot twin.png
    cmp -s first.session second.session && [ "$(wc -c <twin.png)" -gt 20000 ]
    ok $? "and so it does where the brushes work on the graphics card: $(cat stderr)"
    window --workspace balance --size 800x600 --input balance --save again.obj --shot window.png
    same "$exit" 0 "the window plays what was done at the balance: $(cat stderr)"
    cmp -s balance.obj again.obj && cmp -s balance_inner.obj again_inner.obj
    ok $? "to the same hull and cavity"
    window --workspace grade --size 800x600 --input grade --save again.vtk --shot window.png
    same "$exit" 0 "and what was painted: $(cat stderr)"
    cmp -s grade.vtk again.vtk
    ok $? "to the same cage"
    cp input tiny
    cat >>tiny <<'END'
size 0 0 1 1 0 0 0
move 0 0 0 0 0 0 0
size 0 0 640 480 0 0 0
move 0 0 300 200 0 0 0
press 0 0 300 200 0 0 0
move 0 0 320 220 0 0 0
do 5 0 0 0 0 0 0
END
    window --scene shaun --resolution 96 --size 800x600 --input tiny --save third.session
    same "$exit" 0 "a window of one pixel, and a close in the middle of a stroke: $(cat stderr)"
    cmp -s first.session third.session
    ok $? "lose nothing, and leave no half of a stroke"
    if [ -n "${SCULPT_LOST:-}" ]; then
        exit=0
        timeout 120 xvfb-run -a -f authority -s "-screen 0 1280x1024x24" "$SCULPT_LOST" --scene shaun --resolution 96 \
            --size 800x600 --input input >stdout 2>stderr </dev/null || exit=$?
        same "$exit" 4 "where the graphics card is lost it ends: $(head -1 stderr)"
        exits 0 --headless --session sculpt-rescued.session --hash
        same "$(cat stdout)" "$hash" "and what was done is in a session"
    fi
    if [ -n "${SCULPT_FLOWN:-}" ]; then
        exit=0
        timeout 120 xvfb-run -a -f authority -s "-screen 0 1280x1024x24" "$SCULPT_FLOWN" --scene shaun --resolution 96 \
            --size 640x480 --record flown --shot flown.png >stdout 2>stderr </dev/null || exit=$?
        same "$exit" 0 "a SpaceMouse that is turned and falls silent lets the window go on: $(cat stderr)"
        awk '$1 == "fly" { n++; if ($4 != 0 || $5 != 0 || $6 != 0 || !($7 > 0) || $8 != 0) bad = 1 }
            END { exit bad || n == 0 }' flown
        ok $? "and turns the camera, in the record too: $(grep -c '^fly' flown) times"
        exits 0 --headless --scene shaun --resolution 96 --input flown --hash
        same "$(cat stdout)" "$shaun" "which is played without a window, and no stroke"
    fi
    exit=0
    timeout 60 env -u DISPLAY -u WAYLAND_DISPLAY "$SF" --scene shaun --resolution 96 >stdout 2>stderr </dev/null || exit=$?
    same "$exit" 4 "without a display it ends"
    grep -q -- '--headless' stderr
    ok $? "and says what works: $(cat stderr)"
fi
finish
