# What the tests of the command line share: TAP, and a folder of their own to work in. The program
# is $SF; $JSON_GET prints one value of a JSON file, or is empty where there is no jansson.
set -u
count=0 failures=0
# What runs a program for another machine: words, or empty.
wrapper=${SF_WRAPPER:-}
here=$(mktemp -d) || exit 99
trap 'rm -rf "$here"' EXIT
cd "$here" || exit 99

# ok STATUS WORDS: one line of TAP.
ok() {
    count=$((count + 1))
    if [ "$1" -eq 0 ]; then
        echo "ok $count - $2"
    else
        failures=$((failures + 1))
        echo "not ok $count - $2"
        echo "# exit $exit, standard output and error:"
        sed 's/^/#   /' stdout stderr | head -20
    fi
}

# run ARGS: run the program; leaves exit, and the files stdout and stderr.
run() {
    exit=0
    $wrapper "$SF" "$@" >stdout 2>stderr </dev/null || exit=$?
}

# exits N ARGS: run the program and expect an exit status.
exits() {
    want=$1
    shift
    run "$@"
    [ "$exit" -eq "$want" ]
    ok $? "sf $* exits with $want"
}

same() {
    [ "$1" = "$2" ]
    ok $? "$3 ('$1', expected '$2')"
}

# value PATH [FILE]: one value of the report on standard output, or of a file.
value() {
    "$JSON_GET" "${2:-stdout}" "$1"
}

# box FILE X0 Y0 Z0 X1 Y1 Z1: a box, as an OBJ.
box() {
    awk -v box="$*" 'BEGIN {
        split(box, b, " ")
        for (i = 0; i < 8; i++)
            print "v", b[i % 2 ? 5 : 2], b[int(i / 2) % 2 ? 6 : 3], b[(i > 3) ? 7 : 4]
        print "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6"
    }' >"$1"
}

# cage FILE NX NY NZ: a block of unit cubes, as a VTK grid; the property stiffness goes from 0 to 1
# along x.
cage() {
    awk -v block="$*" 'BEGIN {
        split(block, b, " ")
        nx = b[2]; ny = b[3]; nz = b[4]
        points = (nx + 1) * (ny + 1) * (nz + 1); cells = nx * ny * nz
        print "# vtk DataFile Version 3.0\na block\nASCII\nDATASET UNSTRUCTURED_GRID"
        print "POINTS", points, "double"
        for (z = 0; z <= nz; z++) for (y = 0; y <= ny; y++) for (x = 0; x <= nx; x++) print x, y, z
        print "CELLS", cells, 9 * cells
        for (z = 0; z < nz; z++) for (y = 0; y < ny; y++) for (x = 0; x < nx; x++) {
            p = x + (nx + 1) * (y + (ny + 1) * z); q = p + (nx + 1) * (ny + 1)
            print 8, p, p + 1, p + nx + 2, p + nx + 1, q, q + 1, q + nx + 2, q + nx + 1
        }
        print "CELL_TYPES", cells
        for (i = 0; i < cells; i++) print 12
        print "POINT_DATA", points, "\nSCALARS stiffness double 1\nLOOKUP_TABLE default"
        for (i = 0; i < points; i++) print (i % (nx + 1)) / nx
    }' >"$1"
}

needs_json() {
    if [ -z "$JSON_GET" ]; then
        echo "1..0 # SKIP jansson is not installed"
        exit 0
    fi
}

finish() {
    echo "1..$count"
    exit $((failures > 0))
}
