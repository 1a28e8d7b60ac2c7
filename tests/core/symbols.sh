# Why: the checker for a printer's processor promises to stand alone (the profile "core"). This lists
# what libsf-core.a asks of others: nothing but the four functions that a compiler may always call,
# and its own routines for 64-bit integers on processors of 32 bits.
# usage: symbols.sh NM ARCHIVE
set -u
nm=$1 archive=$2
symbols=$(mktemp) || exit 99
trap 'rm -f "$symbols"' EXIT
"$nm" "$archive" >"$symbols" || exit 99

defined=$(awk 'NF == 3 { print $3 }' "$symbols")
undefined=$(awk '$1 == "U" { print $2 }' "$symbols" | sort -u)
foreign=$(printf '%s\n' $undefined | grep -vxF "$defined" |
    grep -vxE '_?mem(cpy|set|move|cmp)' |
    grep -vxE '_GLOBAL_OFFSET_TABLE_|__u?(div|mod|divmod)di[34]|__(ashl|lshr|ashr|mul)di3|__clzdi2|__ctzdi2|__aeabi_u?(l|i)[a-z0-9]*|__aeabi_mem[a-z0-9]*')
# __int128 is inlined where it multiplies, so its absence is looked for in the names of what divides
# and in tests/house; floating point without registers for it would show as __aeabi_d* or *df*.
if [ -z "$foreign" ]; then
    echo "ok 1 - asks for nothing but:" $(printf '%s\n' $undefined | grep -vxF "$defined")
else
    printf '# wants %s\n' $foreign
    echo "not ok 1 - asks for what a printer's processor may not have"
fi

wanted="sf_checker_size sf_checker_place sf_checker_push sf_checker_push_runs sf_checker_push_grey
sf_checker_report sf_chip_push sf_chip_save sf_chip_resume sf_rule_element sf_slice_and_dilate sf_runs_label sf_status_message"
missing=$(printf '%s\n' $wanted | grep -vxF "$(printf '%s\n' "$defined" | sed 's/^_sf/sf/')")
if [ -z "$missing" ]; then
    echo "ok 2 - holds what a checker needs"
else
    printf '# lacks %s\n' $missing
    echo "not ok 2 - holds what a checker needs"
fi
echo 1..2
[ -z "$foreign$missing" ]
