# Why: tetrahedra go to other programs, and come back. What is written must be read as the same by every
# path, files that are damaged must end in a sentence, and what comes of a cage must say what it is.
. "$1"
needs_json

cage cage.vtk 2 2 1
exits 0 refine cage.vtk --steps 2 -o fine.vtk --json
same "$(value refined_cells)" 256 "four cells are 256 after two steps"
exits 0 refine fine.vtk --steps 1 -o finer.vtk --json
same "$(value cage.cells) $(value refined_cells) $(value cage.properties.0)" "256 2048 stiffness" "and what is written is a cage again"
exits 0 tetra cage.vtk --steps 3 -o tetra.vtk --json
same "$(value tetrahedra)" 12288 "six tetrahedra a cell"
volume=$(value volume_mm3)

# By the two ways nearly the same layers.
exits 0 grade tetra.vtk --resolution 40 -o one --json
if [ "$exit" -eq 0 ]; then
    tets=$(value solid_voxels)
    exits 0 grade cage.vtk --resolution 40 -o two --json
    awk -v a="$tets" -v b="$(value solid_voxels)" 'BEGIN { d = (a - b) / b; exit !(d < 0.02 && d > -0.02) }'
    ok $? "tetrahedra and cage give nearly the same layers ($tets and $(value solid_voxels) voxels)"
fi

run tetra cage.vtk --steps 3 -o tetra.h5 --json
if [ "$exit" -eq 0 ]; then
    same "$(value volume_mm3)" "$volume" "the exchange file has the same volume"
    grep -q 'Name="stiffness"' tetra.xdmf && grep -q 'tetra.h5:/tets' tetra.xdmf
    ok $? "ParaView is told by tetra.xdmf"
    exits 0 exchange tetra.h5 -o again.vtk
    exits 0 exchange again.vtk -o again.h5
    cmp -s tetra.h5 again.h5
    ok $? "there and back are the same bytes"
    exits 0 grade tetra.h5 --resolution 40 -o three --json
    same "$(value solid_voxels)" "${tets:-$(value solid_voxels)}" "and the same layers"
    head -c 3000 tetra.h5 >cut.h5
    exits 3 exchange cut.h5 -o none.vtk
    exits 3 grade cut.h5 -o none
    exits 3 refine tetra.h5 -o none.vtk
    grep -q "taken by 'sf exchange' and 'sf grade'" stderr
    ok $? "what is no cage is said to go elsewhere"
else
    grep -q libhdf5 stderr
    ok $? "a build without libhdf5 says so"
fi

exits 2 tetra cage.vtk -o none.stl
exits 2 refine cage.vtk -o none.h5
exits 3 exchange cage.vtk -o none.vtk
grep -q "'sf tetra' makes tetrahedra of it" stderr
ok $? "and says what does"
exits 2 tetra cage.vtk --steps 0 -o none.vtk
[ ! -e none ] && [ ! -e none.vtk ] && [ ! -e none.h5 ] && [ ! -e none.stl ]
ok $? "nothing was written by any of these"
finish
