#!/bin/sh
# Why: a program that was linked with a release must run with the next patch of it. The libraries as they
# are now are compared with those of the last release by abidiff (libabigail), which reads what the
# compiler says of every function and struct: what is new is welcome, what changed or is gone is not,
# unless the version says so (before 1.0 a minor version, then a major one).
#
# usage: abi.sh compare OLD NEW HEADERS     one library with another
#        abi.sh since SOURCE FOLDER [REF]   the sources with those of REF (the last tag, v...)
#        abi.sh bites FOLDER                whether a change is seen at all; speaks TAP, as `since` does
set -u

# What the change amounts to: same, larger or broken.
verdict() {
    abidiff --no-show-locs --headers-dir1 "$3" --headers-dir2 "$3" "$1" "$2" >"$4" 2>&1
    status=$?
    if [ $((status & 3)) -ne 0 ]; then # a bit for an error, one for a wrong call
        echo failed
    elif [ $((status & 8)) -ne 0 ]; then
        echo broken
    elif [ $((status & 4)) -eq 0 ]; then
        echo same
    elif abidiff --no-show-locs --no-added-syms --headers-dir1 "$3" --headers-dir2 "$3" "$1" "$2" >>"$4" 2>&1; then
        echo larger
    else
        echo broken
    fi
}

# The part of a version that a change may not go beyond.
interface() {
    sed -n "s/.*version: '\([0-9]*\)\.\([0-9]*\)\..*/\1 \2/p" "$1/meson.build" | head -n 1 |
        while read -r major minor; do
            [ "$major" != 0 ] && echo "$major" || echo "0.$minor"
        done
}

build() {
    ${MESON:-meson} setup "$1/build" "$1" -Dbuildtype=debug -Ddemo=false -Dtests=false >"$1.log" 2>&1 &&
        ninja -C "$1/build" >>"$1.log" 2>&1
}

since() {
    source=$(cd "$1" && pwd) out=$2
    ref=${3:-$(git -C "$source" describe --tags --abbrev=0 --match 'v*' 2>/dev/null)}
    if [ -z "$ref" ]; then
        echo "1..0 # SKIP there is no release yet to compare with; name a commit"
        return 0
    fi
    rm -rf "$out"
    mkdir -p "$out/old" "$out/new" || return 99
    git -C "$source" archive "$ref" | tar -x -C "$out/old"
    git -C "$source" archive HEAD | tar -x -C "$out/new"
    for side in old new; do
        build "$out/$side" || { tail -n 20 "$out/$side.log"; echo "Bail out! $side does not build"; return 99; }
    done
    old=$(interface "$out/old") new=$(interface "$out/new") count=0 bad=0
    for path in libsf/libsf.so libsf/io/libsf-io.so; do
        count=$((count + 1))
        said=$(verdict "$out/old/build/$path" "$out/new/build/$path" "$out/new/libsf/include" "$out/report")
        sed 's/^/# /' "$out/report"
        if [ "$said" = same ] || [ "$said" = larger ] || { [ "$said" = broken ] && [ "$old" != "$new" ]; }; then
            echo "ok $count - $path since $ref ($old, now $new): $said"
        else
            bad=1
            echo "not ok $count - $path since $ref ($old, now $new): $said"
        fi
    done
    echo "1..$count"
    return $bad
}

bites() {
    out=$1
    rm -rf "$out"
    mkdir -p "$out" || return 99
    cd "$out" || return 99
    count=0 bad=0
    say() {
        printf '%s\n' "$2" >lib.h
        printf '#include "lib.h"\n%s\n' "$3" >lib.c
        ${CC:-cc} -g -O0 -shared -fPIC lib.c -o "$1.so" || exit 99
    }
    say first 'struct s { int a, b; }; int f(struct s *s);' 'int f(struct s *s) { return s->a; }'
    say same 'struct s { int a, b; }; int f(struct s *s);' 'int f(struct s *s) { return s->b - 1; }'
    say more 'struct s { int a, b; }; int f(struct s *s); int g(void);' \
        'int f(struct s *s) { return s->a; } int g(void) { return 1; }'
    say moved 'struct s { int b, a; long c; }; int f(struct s *s);' 'int f(struct s *s) { return s->a; }'
    say gone 'struct s { int a, b; }; int g(struct s *s);' 'int g(struct s *s) { return s->a; }'
    say other 'struct s { int a, b; }; long f(struct s *s);' 'long f(struct s *s) { return s->a; }'
    for expected in same:same more:larger moved:broken gone:broken other:broken; do
        count=$((count + 1))
        said=$(verdict first.so "${expected%:*}.so" "$out" report)
        if [ "$said" = "${expected#*:}" ]; then
            echo "ok $count - ${expected%:*} is $said"
        else
            bad=1
            echo "not ok $count - ${expected%:*} is $said, not ${expected#*:}"
        fi
    done
    echo "1..$count"
    return $bad
}

if ! command -v abidiff >/dev/null 2>&1; then
    echo "1..0 # SKIP abidiff is not installed (abigail-tools)"
    exit 0
fi
verb=$1
shift
case $verb in
compare) verdict "$1" "$2" "$3" /dev/stderr ;;
since) since "$@" ;;
bites) bites "$1" ;;
*) exit 99 ;;
esac
