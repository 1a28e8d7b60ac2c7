# Why: the crates are another way to build libsf and other readers of its interface, and nobody who works
# on the library runs them. Their own tests are run here, on the library that they compile and on the one that
# this build has made; that what is committed of api.json is that of the interface, that the archives that
# are published hold every source, and that the documentation has no dead links, is tried as well.
# usage: rust.sh SOURCE BUILD CARGO PYTHON SYSTEM; SYSTEM is yes where this build's library can be linked to
set -u
source=$1 build=$2 cargo=$3 python=$4 system=$5
here=$build/rust
count=0 failures=0

ok() {
    count=$((count + 1))
    if [ "$1" -eq 0 ]; then
        echo "ok $count - $2"
    else
        failures=$((failures + 1))
        echo "not ok $count - $2"
        sed 's/^/#   /' "$here/log" | tail -40
    fi
}

skip() {
    count=$((count + 1))
    echo "ok $count - $1 # SKIP $2"
}

mkdir -p "$here"
if [ -n "$python" ]; then
    "$python" -B "$source/bindings/rust/generate.py" "$source" --check >"$here/log" 2>&1
    ok $? "externs, records and words are those of api.json"
else
    skip "externs, records and words are those of api.json" "python3 is not installed"
fi

# Cargo writes beside what it builds, so it gets a copy; the sources stay where they are.
rm -rf "$here/crates-before"
[ ! -d "$here/crates" ] || mv "$here/crates" "$here/crates-before"
cp -Rp "$source/bindings/rust" "$here/crates"
# What somebody wrote while the run before went on would look older than what that has built.
(cd "$here/crates" && find . -type f) | while read -r file; do
    cmp -s "$here/crates/$file" "$here/crates-before/$file" || touch "$here/crates/$file"
done
rm -rf "$here/crates-before"
for link in libsf-sys/vendor:libsf libsf-sys/LICENSE:LICENSE libsf/LICENSE:LICENSE \
    libsf/tests/box3.json:tests/golden/box3.json libsf/tests/tetrahedra.json:tests/golden/tetrahedra.json; do
    rm -f "$here/crates/${link%:*}"
    ln -s "$source/${link#*:}" "$here/crates/${link%:*}"
    # A link that looks new would have all of libsf compiled again.
    touch -h -r "$source/meson.build" "$here/crates/${link%:*}"
done
[ ! -f "$here/Cargo.lock" ] || cp -p "$here/Cargo.lock" "$here/crates/Cargo.lock"
cd "$here/crates" || exit 99
export CARGO_TARGET_DIR="$here/target" CARGO_TERM_COLOR=never
# A machine without a net is told so soon, and not after many tries.
if ! CARGO_NET_RETRY=0 CARGO_HTTP_TIMEOUT=20 "$cargo" fetch >"$here/log" 2>&1; then
    for what in "every source is in the archives" "the crates compile libsf, and their tests pass" \
        "clippy has nothing to say" "the documentation has no warnings" \
        "what is in the archives compiles" "their tests pass on this build's library"; do
        skip "$what" "the crates that it is built with cannot be had"
    done
    echo "1..$count"
    exit $((failures > 0))
fi
cp -p Cargo.lock "$here/Cargo.lock"

# That a link to a folder is packed as its files is a habit of cargo's, not a promise.
"$cargo" package --list --allow-dirty -p libsf-sys >"$here/list" 2>"$here/log"
(cd "$source/libsf" && find . -name '*.[ch]' -o -name '*.inc') | sed 's:^\./:vendor/:' | sort >"$here/wanted"
grep '^vendor/' "$here/list" | sort | diff "$here/wanted" - >"$here/log" && [ -s "$here/wanted" ]
same=$?
"$cargo" package --list --allow-dirty -p libsf >"$here/list" 2>>"$here/log"
(cd "$source/bindings/rust/libsf" && find . -name '*.rs' -o -name '*.json') | sed 's:^\./::' | sort >"$here/wanted"
grep '\.rs$\|\.json$' "$here/list" | sort | diff "$here/wanted" - >>"$here/log" && [ "$same" -eq 0 ]
ok $? "every source is in the archives"

"$cargo" test --offline --features libsf/ndarray >"$here/log" 2>&1 &&
    grep -q '^test c_and_rust_agree_on_every_number ... ok' "$here/log" &&
    grep -q '^test a_trim_is_the_largest_part_that_stands ... ok' "$here/log" &&
    grep -q '^test shapes_come_to_what_three_languages_say ... ok' "$here/log"
ok $? "the crates compile libsf, and their tests pass"

if "$cargo" clippy --version >/dev/null 2>&1; then
    "$cargo" clippy --offline --all-targets --features libsf/ndarray -- -D warnings >"$here/log" 2>&1
    ok $? "clippy has nothing to say"
else
    skip "clippy has nothing to say" "clippy is not installed"
fi

RUSTDOCFLAGS='-D warnings' "$cargo" doc --offline --no-deps --features libsf/ndarray >"$here/log" 2>&1
ok $? "the documentation has no warnings"

# Each crate is compiled from its archive, beside the other: cargo would look for that in a registry. It
# packs crates that need each other since 1.90.
unpack() {
    rm -rf "$here/unpacked"
    mkdir -p "$here/unpacked" &&
        "$cargo" package --offline --workspace --allow-dirty --no-verify &&
        for archive in "$here"/target/package/*.crate; do
            tar -xzf "$archive" -C "$here/unpacked" || return 1
        done
    (cd "$here/unpacked" && printf '[workspace]\nresolver = "2"\nmembers = ["libsf-*"]\n' &&
        echo "[patch.crates-io]" && for each in libsf-sys-*; do echo "libsf-sys = { path = \"$each\" }"; done
    ) >"$here/unpacked/Cargo.toml" && cp "$here/Cargo.lock" "$here/unpacked/Cargo.lock"
}

minor=$("$cargo" --version | sed 's/^cargo [0-9]*\.\([0-9]*\).*/\1/')
if [ "${minor:-0}" -ge 90 ]; then
    rm -rf "$here/target/package"
    # That the C sources compile is said above; where there is a library to link to, once is enough.
    [ "$system" = yes ] && linked='--no-default-features --features system' || linked=
    # shellcheck disable=SC2086
    unpack >"$here/log" 2>&1 && cd "$here/unpacked" &&
        PKG_CONFIG_PATH=$build/meson-uninstalled "$cargo" check --offline --all-targets --workspace $linked \
            >>"$here/log" 2>&1
    ok $? "what is in the archives compiles"
    cd "$here/crates" || exit 99
else
    skip "what is in the archives compiles" "cargo is older than 1.90"
fi

if [ "$system" = yes ]; then
    PKG_CONFIG_PATH=$build/meson-uninstalled LD_LIBRARY_PATH=$build/libsf:$build/libsf/io \
        "$cargo" test --offline --no-default-features --features system >"$here/log" 2>&1
    ok $? "their tests pass on this build's library"
else
    skip "their tests pass on this build's library" "this build's library is not one to link to"
fi
echo "1..$count"
exit $((failures > 0))
