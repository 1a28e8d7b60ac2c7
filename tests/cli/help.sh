# Why: an example that does not work is worse than none. Every line that --help shows under
# "examples" is run as it stands.
. "$1"

run trim scene:garden --resolution 24 -o part.stl
run trim scene:garden --resolution 24 -o part.obj
run slice scene:garden --resolution 24 -o layers
run slice scene:garden --resolution 24 -o job.sl1
box box.obj 10 10 0 30 30 20
run slice box.obj --pitch 2 -o box
run trim box -o box.stl
cat >stances.json <<'END'
{"format": "libsf-stance", "version": 1, "stances": [{"kind": "stand", "up": [0, 0, 1]}]}
END
cat >handles.json <<'END'
{"format": "libsf-handles", "version": 1, "handles": [{"at_mm": [28, 25, 36]}]}
END
cage cage.vtk 4 2 2
cat >materials.json <<'END'
{"format": "libsf-materials", "version": 1,
 "materials": [{"name": "soft", "colour": "#2060c0", "density_g_cm3": 1.12},
               {"name": "stiff", "colour": "#f0a020", "density_g_cm3": 1.18}],
 "properties": ["stiffness"],
 "mixtures": [{"fractions": [1, 0], "values": [0]}, {"fractions": [0.5, 0.5], "values": [0.2]},
              {"fractions": [0, 1], "values": [1]}]}
END
cat >recipe.json <<'END'
{"format": "libsf-paint", "version": 1,
 "steps": [{"property": "stiffness", "ball": {"at_mm": [4, 1, 1], "radius_mm": 2}, "set": 0.5}]}
END
for verb in run info check trim grow repair preserve hollow stand grade refine tetra exchange slice orient render; do
    run $verb --help
    tr -d '\r' <stdout | sed -n '/^examples:/,/^$/s/^  sf //p' >examples
    [ -s examples ]
    ok $? "$verb --help has examples"
    says=no
    grep -q 'stack of pictures that sf' stdout && says=yes
    same $says "$(case $verb in orient | stand | grade | refine | tetra | exchange) echo no ;; *) echo yes ;; esac)" "$verb --help says whether it takes more than meshes"
    cp stdout asked
    run help $verb
    cmp -s stdout asked
    ok $? "sf help $verb says the same"
    run $verb --help
    says=no
    grep -q 'status: 0 good, 1' stdout && says=yes
    same $says "$(case $verb in info | grade | refine | exchange | slice | orient | render) echo no ;; *) echo yes ;; esac)" "$verb --help says what 1 means where there is such an end"
    while read -r line; do
        case $line in # small, so that the test is quick; what is tried is that the line is taken
        refine* | tetra* | exchange* | info* | *--pitch* | "trim layers"* | *job.sl1* | "preserve layers"*) extra= ;;
        *--resolution*) extra= ;;
        *) extra="--resolution 24" ;;
        esac
        case $line in *--pitch\ 0.05*) line="$line --size 4" ;; esac
        case $line in *--pitch\ 0.1*) line="$line --size 8" ;; esac
        case $line in *render* | run* | stand* | *--picture*) extra="$extra --pixels 96,96" ;; esac
        # shellcheck disable=SC2086
        run $line $extra
        [ $exit -le 1 ] || { [ $exit -eq 2 ] && grep -q "without PNG" stderr; } ||
            grep -q "build it with libhdf5\|build it with libspng\|tetra.h5" stderr ||
            { [ $exit -eq 3 ] && grep -q "build it with jansson" stderr; }
        ok $? "sf $line $extra"
    done <examples
done
finish
