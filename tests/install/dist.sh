# Why: what is released is not the tree that was tested but an archive of it. It is made here as for a
# release, must hold the files of the last commit and no others, and is built and tried where there is
# nothing else: a law of the operators passes.
# usage: dist.sh MESON SOURCE VERSION
set -u
meson=$1 source=$2 version=$3
if ! git -C "$source" rev-parse --verify -q HEAD >/dev/null 2>&1; then
    echo "1..0 # SKIP this is no git checkout, of which releases are made"
    exit 0
fi
here=$(mktemp -d) || exit 99
trap 'rm -rf "$here"' EXIT
count=0 failures=0

ok() {
    count=$((count + 1))
    if [ "$1" -eq 0 ]; then
        echo "ok $count - $2"
    else
        failures=$((failures + 1))
        echo "not ok $count - $2"
        tail -20 "$here/log" | sed 's/^/#   /'
    fi
}

# A build folder of its own, so that what is going on in the tested one is not disturbed.
"$meson" setup "$here/build" "$source" -Dtests=false -Ddemo=false >"$here/log" 2>&1 &&
    "$meson" dist -C "$here/build" --no-tests --allow-dirty --formats xztar >>"$here/log" 2>&1
ok $? "meson dist"
archive=$here/build/meson-dist/libsf-$version.tar.xz
(cd "$here/build/meson-dist" && sha256sum -c "libsf-$version.tar.xz.sha256sum") >"$here/log" 2>&1
ok $? "the archive has the digest that is written beside it"
tar -xJf "$archive" -C "$here" 2>"$here/log"
ok $? "the archive unpacks"
tree=$here/libsf-$version
git -C "$source" ls-tree -r --name-only HEAD | sort >"$here/committed"
(cd "$tree" && find . ! -type d | sed 's:^\./::' | sort) >"$here/released"
diff "$here/committed" "$here/released" >"$here/log" 2>&1
ok $? "it holds what was committed, and nothing else"
"$meson" setup "$here/again" "$tree" -Doptimization=0 -Dauto_features=disabled >"$here/log" 2>&1 &&
    ninja -C "$here/again" tests/law/law-trim >>"$here/log" 2>&1 &&
    "$here/again/tests/law/law-trim" >>"$here/log" 2>&1
ok $? "it builds without any other library, and the law of trim holds"
echo "1..$count"
exit $((failures > 0))
