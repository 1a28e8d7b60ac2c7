#!/bin/sh
# Draws the pictures of the README: the scene that sf makes itself, before, and made printable in three
# ways.
# Pictures hold words, and words the fonts of a machine, so no test compares them byte for byte.
set -eu
cd "$(dirname "$0")"
here=$(mktemp -d)
trap 'rm -rf "$here"' EXIT
../../dev sf run scene:garden --pixels 800,640 -o "$here/garden" >/dev/null
mv "$here/garden/before.png" "$here/garden/after.png" .
