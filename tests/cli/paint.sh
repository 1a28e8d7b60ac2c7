# Why: a recipe changes what is printed, step by step and unseen. Steps must do what their formulas
# say, and what is no step, or no number, must be refused with its number and leave nothing behind.
. "$1"
needs_json

cage cage.vtk 2 1 1
head='{"format": "libsf-paint", "version": 1, "steps": ['

# recipe STEPS: refine with them.
recipe() {
    printf '%s%s]}' "$head" "$1" >recipe.json
    run refine cage.vtk --paint recipe.json --steps 1 -o painted.vtk --json
}

# refused STEPS WORDS: they are, and the message says so.
refused() {
    recipe "$1"
    grep -q "$2" stderr
    same "$exit $?" "3 0" "$2"
    [ "$exit" -eq 3 ] || sed 's/^/# /' stderr
}

# How many numbers of the file are 79/128, which is no coordinate.
count_numbers() {
    od -An -v -tx1 painted.vtk | tr -d ' \n' | awk '{ print gsub("3fe3c00000000000", "") }'
}

recipe '{"create": "density", "value": 2}, {"all": true, "property": "density", "set": 5},
        {"all": true, "property": "stiffness", "set": 0.6171875}, {"all": true, "move": [1, 2, 3]}'
same "$exit $(value cage.properties.0) $(value cage.properties.1)" "0 stiffness density" "a property more"
same "$(count_numbers)" 45 "a number that is set is that number everywhere"

recipe '{"all": true, "property": "stiffness", "expression": "0*x+79/128"}'
if [ "$exit" -eq 0 ]; then
    same "$(count_numbers)" 45 "a formula is evaluated"
    refused '{"all": true, "property": "stiffness", "expression": "0,5"}' "several values"
    refused '{"all": true, "property": "stiffness", "expression": "x=3"}' "sets a variable"
    refused '{"all": true, "property": "stiffness", "expression": ""}' "is no formula"
    refused '{"all": true, "property": "stiffness", "expression": "((x"}' "is no formula"
    refused '{"all": true, "property": "stiffness", "expression": "1/0"}' "no value at a point"
    refused '{"all": true, "property": "stiffness", "expression": "0/0"}' "no value at a point"
else
    grep -q muparser stderr
    ok $? "a build without muparser says so"
fi
rm -f painted.vtk

refused '{"all": true, "property": "stiffness", "set": 1e999}' "overflow"
refused '{"all": true, "property": "stiffness", "smooth": 2}' "step 1: smooth"
refused '{"all": true, "property": "none", "set": 2}' "no property 'none'; there is 'stiffness', or"
refused '{"all": true, "move": [1e300, 0, 0]}' "step 1: it moves a point farther than 10^12 mm"
refused '{"all": true, "smooth_shape": 2}' "step 1: smooth_shape is a number from 0 to 1"
refused '{"all": true, "move": [1, 2]}' "step 1: move"
refused '{"all": true, "move": [1, 2, 3], "property": "stiffness", "set": 1}' "it does one thing"
refused '{"all": true, "ball": {}, "move": [1, 2, 3]}' "one selection"
refused '{"ball": {"at_mm": [0, 0, 0], "radius_mm": -1}, "move": [1, 2, 3]}' "a ball has"
refused '{"ball": 7, "move": [1, 2, 3]}' "a ball has"
refused '{"points": [0, 12], "move": [1, 2, 3]}' "points are whole numbers"
refused '{"points": [-1], "move": [1, 2, 3]}' "points are whole numbers"
refused '{"create": "a", "low": 5, "high": 1}' "bounds that no value"
refused '{"create": "a", "low": 5}' "outside the property"
refused '{"create": "a"}, {"create": "a"}' "step 2: .*name or the UUID of another"
refused '{"create": ""}' "1 to 47 bytes"
refused '{"al": true, "move": [1, 2, 3]}' "not known"
refused 'null' "not known"
exits 3 refine cage.vtk --paint missing.json -o painted.vtk
grep -q "^sf: --paint missing.json: unable to open" stderr
ok $? "a recipe that is not there has no line"
[ ! -e painted.vtk ]
ok $? "nothing was written by any of these"

recipe '{"ball": {"at_mm": [9, 9, 9], "radius_mm": 1}, "move": [1, 2, 3]}'
grep -q "step 1 touches no point" stdout
same "$exit $?" "0 0" "a brush that meets nothing is said to"
recipe '{"ball": {"at_mm": [0, 0, 0], "radius_mm": 1}, "move": [0, 0, -1]}'
grep -q "touches no point" stdout
same "$exit $?" "0 1" "and one that meets a point is not"
finish
