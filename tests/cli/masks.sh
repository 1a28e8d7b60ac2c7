# Why: --keep, --forbid and --remove are promises about places. What is kept is there afterwards,
# what is forbidden is untouched, what cannot be is refused with its place and nothing is written;
# and a mask lies where the part lies, however that is turned and sized.
. "$1"
needs_json

# changes A B X0 Y0 Z0 X1 Y1 Z1: "removed added removed added", inside the box and outside.
changes() {
    $wrapper "$STACK_COMPARE" "$@" 2>stderr || echo -1 -1 -1 -1
}

bird="14 28 44 44 56 60" # the bird flies in there, and nothing else
cap="44 2 18.5 74 30 40" # the mushroom's cap
post="44 2 4 74 30 18.5" # and all that is below it
# shellcheck disable=SC2086
box bird.obj $bird
# shellcheck disable=SC2086
box cap.obj $cap
# shellcheck disable=SC2086
box post.obj $post
exits 0 slice scene:garden --resolution 64 --angle 45 -o drawn

# Keep.
box below.obj 0 0 0 100 60 42
exits 0 repair scene:garden --resolution 64 --forbid below.obj -o repaired
# shellcheck disable=SC2086
set -- $(changes drawn repaired $bird)
[ "$1" -gt 0 ]
ok $? "where nothing may stand below it a repair gives up the bird ($1 voxels)"
box below.obj 0 0 0 26 60 42
exits 0 repair scene:garden --resolution 64 --forbid below.obj --keep bird.obj -o repaired --json
[ "$(value keep_mask_voxels)" -gt 0 ]
ok $? "the report says how large the mask is"
# shellcheck disable=SC2086
set -- $(changes drawn repaired $bird)
same "$1" 0 "but not where it is to be kept"
exits 0 check repaired
exits 1 trim scene:garden --resolution 64 --keep bird.obj -o trimmed --json
[ "$(value culprits.count)" -gt 0 ] && [ ! -e trimmed ]
ok $? "a trim that must keep it is refused, and writes nothing"
awk -v box="$bird" -v low="$(value culprits.box_mm.low.0) $(value culprits.box_mm.low.1) $(value culprits.box_mm.low.2)" \
    -v high="$(value culprits.box_mm.high.0) $(value culprits.box_mm.high.1) $(value culprits.box_mm.high.2)" 'BEGIN {
    split(box, b, " "); split(low, l, " "); split(high, h, " ")
    for (i = 1; i <= 3; i++) if (l[i] < b[i] - 2 || h[i] > b[i + 3] + 2) exit 1 }'
ok $? "with the place"
exits 1 trim scene:garden --resolution 64 --keep bird.obj
grep -Eq '^sf: [0-9]+ voxels of what --keep names cannot be carried.* mm\. Nothing was written\.$' stderr
ok $? "in a sentence: $(cat stderr)"

# Forbid.
exits 0 grow scene:garden --resolution 64 -o grown
# shellcheck disable=SC2086
set -- $(changes drawn grown $post)
[ "$2" -gt 0 ]
ok $? "growing puts something below the cap ($2 voxels)"
exits 0 repair scene:garden --resolution 64 --forbid post.obj -o repaired
# shellcheck disable=SC2086
set -- $(changes drawn repaired $post)
same "$2" 0 "but not where it is forbidden"
exits 0 check repaired
exits 1 grow scene:garden --resolution 64 --forbid post.obj -o never --certificate never.json --json
[ "$(value culprits.count)" -gt 0 ] && [ "$(value error.exit)" = 1 ] && [ ! -e never ] && [ ! -e never.json ]
ok $? "what cannot be grown is refused, and writes nothing"
exits 1 repair scene:garden --resolution 64 --forbid post.obj --keep cap.obj -o never
[ ! -e never ]
ok $? "as is a repair with nowhere to go"

# Remove.
exits 0 trim scene:garden --resolution 64 -o printable
exits 0 preserve printable --remove post.obj -o carved --json
# shellcheck disable=SC2086
set -- $(changes printable carved $post)
same "$1 $2 $3 $4" "$(value removed_voxels) 0 0 0" "nothing outside of what is to go changes"
exits 0 preserve printable --remove post.obj --keep post.obj -o carved --json
same "$(value removed_voxels)" 0 "and what is kept as well stays"

# A mask that is somewhere else says so and does nothing.
box far.obj 500 500 500 510 510 510
exits 0 preserve printable --remove far.obj --json
same "$(value warnings) $(value removed_voxels) $(value remove_mask_voxels)" "1 0 0" "a mask beside the part is worth a warning"
exits 0 preserve printable --remove far.obj
grep -q '^--remove far.obj: No voxel' stderr
ok $? "which names it: $(cat stderr)"

# A mask is turned and sized like its part: a part of 12 x 20 x 30, its upper half the mask.
box part.obj 0 0 0 12 20 30
box half.obj 0 0 15 12 20 30
for how in "--pitch 1 :3600" "--up -y --pitch 1 :3600" "--units cm --scale 0.5 --pitch 5 :3600" \
    "--size 60 --pitch 2 :3600" "--size 15 --up +x --pitch 0.5 :3600"; do
    # shellcheck disable=SC2086
    run preserve part.obj --remove half.obj ${how%:*} --json
    same "$(value remove_mask_voxels)" "${how##*:}" "half of the part is the mask: ${how%:*}"
done
finish
