#!/bin/sh
# Draws the pictures of the README: the scene that sf makes itself, before, and made printable in three
# ways. And that of docs/balance.md: one shape that is made to stand, with terms left out.
# Pictures hold words, and words the fonts of a machine, so no test compares them byte for byte.
set -eu
cd "$(dirname "$0")"
here=$(mktemp -d)
trap 'rm -rf "$here"' EXIT
../../dev sf run scene:garden --pixels 800,640 -o "$here/garden" >/dev/null
mv "$here/garden/before.png" "$here/garden/after.png" .
program=tests/truth/truth-terms_picture
build=${BUILD:-$(cd ../.. && pwd)/build}
ninja -C "$build" $program >/dev/null
"$build/$program" "$here/terms.png" >/dev/null
mv "$here/terms.png" .
