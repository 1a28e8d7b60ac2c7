#!/bin/sh
# Why: what is handed out must be what the sources say, and hard to misuse. A release is built twice, from
# two folders of different names, by another number of processes, with another time zone, locale and
# umask: every library and program must be the same bytes. Then the files are looked into for what
# the flags promise.
#
# usage: release.sh SOURCE FOLDER core|whole; core: only the checker for printers, for a quick answer.
# Speaks TAP.
set -u
source=$(cd "$1" && pwd) out=$2 what=$3
rm -rf "$out"
mkdir -p "$out" || exit 99
out=$(cd "$out" && pwd)
count=0 bad=0

ok() {
    count=$((count + 1))
    if [ "$1" -eq 0 ]; then
        echo "ok $count - $2"
    else
        bad=1
        [ ! -f "$out/log" ] || tail -n 30 "$out/log" | sed 's/^/# /'
        echo "not ok $count - $2"
    fi
    rm -f "$out/log"
}

case $what in
core) options='-Dprofile=core -Dtests=false' ;;
*) options='-Dtests=false -Dpython=disabled' ;;
esac

# build NAME JOBS: a copy of the sources in a folder of that name, built there.
build() {
    mkdir -p "$out/$1" && cp -R "$source/libsf" "$source/demo" "$source/meson.build" \
        "$source/meson_options.txt" "$source/bindings" "$out/$1/" &&
        mkdir -p "$out/$1/tests" && cp -R "$source/tests/." "$out/$1/tests/" &&
        (cd "$out/$1" && ${MESON:-meson} setup build -Dbuildtype=release $options &&
            ninja -C build -j "$2" &&
            ${MESON:-meson} install -C build --no-rebuild --destdir "$out/$1/root")
}

(umask 022 && TZ=UTC LC_ALL=C CCACHE_DISABLE=1 build here 2) >"$out/log" 2>&1
ok $? "a release builds"
(umask 077 && TZ=Asia/Tokyo LC_ALL=C.UTF-8 CCACHE_DISABLE=1 build another/place/with-a-longer-name 1) \
    >"$out/log" 2>&1
ok $? "and again, elsewhere"

# What is installed: links by where they lead, files by their bytes and who may do what with them.
results() {
    (cd "$out/$1/root" && find . \( -type l -printf '%p -> %l\n' \) -o -type f -printf '%p %m\n' | LC_ALL=C sort &&
        find . -type f | LC_ALL=C sort | xargs sha256sum)
}
results here >"$out/first"
results another/place/with-a-longer-name >"$out/second"
diff "$out/first" "$out/second" >"$out/log" 2>&1 && [ -s "$out/first" ]
ok $? "what is installed is the same bytes: $(grep -c " \./" "$out/first") files"

if [ "$what" = whole ]; then
    build=$out/here/build
    files="$build/libsf/libsf.so.*.*.* $build/libsf/io/libsf-io.so.*.*.* $build/demo/sf/sf"
    : >"$out/log"
    # shellcheck disable=SC2086
    for file in $files; do
        case $file in *.p | *.symbols) continue ;; esac
        readelf -lW "$file" | grep -q GNU_RELRO || echo "$file: no read-only relocations" >>"$out/log"
        readelf -dW "$file" | grep -q -e BIND_NOW -e 'NOW' || echo "$file: bound lazily" >>"$out/log"
        readelf -lW "$file" | grep GNU_STACK | grep -q 'RW ' || echo "$file: a stack that runs" >>"$out/log"
        readelf -sW "$file" | grep -q __stack_chk_fail || echo "$file: no stack protector" >>"$out/log"
    done
    readelf -sW "$build/demo/sf/sf" | grep -q '__[a-z]*printf_chk' || echo "sf: no fortified calls" >>"$out/log"
    readelf -nW "$build/demo/sf/sf" | grep -q 'IBT' || case $(uname -m) in
    x86_64) echo "sf: jumps are not marked" >>"$out/log" ;;
    esac
    [ ! -s "$out/log" ]
    ok $? "libraries and program are hard to misuse"
    strings -a $build/libsf/libsf.so.*.*.* | grep -q "$out"
    [ $? -ne 0 ]
    ok $? "no path of this machine is in them"
fi
echo "1..$count"
exit $bad
