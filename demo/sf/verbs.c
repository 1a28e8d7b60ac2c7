// SPDX-License-Identifier: MIT
// The table of verbs: what each is for, which options it takes, examples that work.
//
// The README shows the first two columns, and a test runs every example.

#include "verbs.h"

#define INPUT_OPTIONS                                                                              \
    (OPTION_RESOLUTION | OPTION_PITCH | OPTION_UP | OPTION_UNITS | OPTION_SCALE | OPTION_SIZE |    \
     OPTION_FILL | OPTION_MEMORY | OPTION_THRESHOLD)
#define RULE_OPTIONS (OPTION_ANGLE | OPTION_RULE | OPTION_BED | OPTION_BRIDGE)
#define HOST_OPTIONS (OPTION_THREADS | OPTION_JSON | OPTION_QUIET)
#define CHANGE_OPTIONS                                                                             \
    (INPUT_OPTIONS | RULE_OPTIONS | HOST_OPTIONS | OPTION_OUTPUT | OPTION_SMOOTH |                 \
     OPTION_CERTIFICATE)
#define STAND_OPTIONS                                                                              \
    (OPTION_OUTPUT | OPTION_RESOLUTION | OPTION_PITCH | OPTION_UP | OPTION_UNITS | OPTION_SCALE |  \
     OPTION_SIZE | OPTION_ANGLE | OPTION_RULE | OPTION_MEMORY | OPTION_WALL | OPTION_DRAIN |       \
     OPTION_MIN_FEATURE | OPTION_DENSITY | OPTION_PIXELS | OPTION_BUILD | OPTION_GAMMA |           \
     OPTION_CONTACTS | OPTION_HANDLES | OPTION_MAX_SHIFT | OPTION_SUSPEND | OPTION_STANCE |        \
     OPTION_CARVE | OPTION_SOLVER | OPTION_MU | OPTION_NO_CARVE | OPTION_NO_DEFORM |               \
     OPTION_NO_LAPLACIAN | OPTION_TURN | OPTION_REST | OPTION_LAYERS | OPTION_CERTIFICATE |        \
     OPTION_CUT)
#define MISSED "1 the asked property was not reached"
#define CHANGE_OUTPUT "a mesh (.stl .obj .ply .3mf .glb), a job (.sl1), or a folder for layers"

const verb_entry verbs_table[] = {
    {{"run", "check a part, make it printable in three ways, write a folder", "FILE", 1,
      INPUT_OPTIONS | RULE_OPTIONS | HOST_OPTIONS | OPTION_OUTPUT | OPTION_SMOOTH | OPTION_VIEW |
          OPTION_PIXELS | OPTION_MIN_FEATURE | OPTION_CRUMBS,
      "  sf run\n  sf run part.stl --angle 50 -o printable\n",
      "folder for the results (default out)", MISSED},
     verb_run},
    {{"info", "what a part is: size, volume, mass, holes, orientation", "FILE", 0,
      HOST_OPTIONS | OPTION_UP | OPTION_UNITS | OPTION_SCALE | OPTION_SIZE,
      "  sf info part.stl\n  sf info part.obj --units in --up +y --json\n  sf info layers\n", NULL,
      NULL},
     verb_info},
    {{"check", "does it print without supports, and where not?", "FILE", 0,
      INPUT_OPTIONS | RULE_OPTIONS | HOST_OPTIONS | OPTION_STEEPEST | OPTION_CRUMBS |
          OPTION_PRINTING | OPTION_INNER,
      "  sf check part.stl\n  sf check part.stl --pitch 0.1,0.1,0.05 --angle 50\n"
      "  sf check scene:garden --rule box3 --json\n  sf check part.stl --steepest\n"
      "  sf check part.stl --printing\n  sf check job.sl1 --threshold 100\n",
      NULL, "1 it does not print without supports, or topples"},
     verb_check},
    {{"trim", "take away what cannot print without supports", "FILE", 0,
      CHANGE_OPTIONS | OPTION_KEEP,
      "  sf trim part.stl -o printable.stl\n  sf trim part.stl --resolution 512 -o layers\n"
      "  sf trim layers -o printable.ply\n  sf trim job.sl1 -o fixed.sl1\n"
      "  sf trim part.stl -o layers --certificate layers.json\n",
      CHANGE_OUTPUT, MISSED},
     verb_trim},
    {{"grow", "add what is missing below, and take nothing away", "FILE", 0,
      CHANGE_OPTIONS | OPTION_FORBID,
      "  sf grow part.stl -o printable.stl\n  sf grow part.stl --bridge 5 -o printable.stl\n"
      "  sf grow part.stl --forbid box.stl -o layers --certificate layers.json\n",
      CHANGE_OUTPUT, MISSED},
     verb_grow},
    {{"repair", "the least change: take away here, add there", "FILE", 0,
      CHANGE_OPTIONS | OPTION_KEEP | OPTION_FORBID | OPTION_MIN_FEATURE,
      "  sf repair part.stl -o printable.stl\n"
      "  sf repair part.stl --min-feature 0.8 --keep box.stl -o printable.stl\n"
      "  sf repair part.stl --angle 50 -o layers --certificate layers.json\n",
      CHANGE_OUTPUT, MISSED},
     verb_repair},
    {{"preserve", "remove a brush, but not what carries the rest", "FILE", 0,
      CHANGE_OPTIONS | OPTION_REMOVE | OPTION_KEEP | OPTION_MODE,
      "  sf preserve part.stl --remove box.stl -o hollowed.stl\n"
      "  sf preserve layers --remove box.stl --mode irredundant -o carved\n",
      CHANGE_OUTPUT, MISSED},
     verb_preserve},
    {{"hollow", "take the inside out, so that what printed still does", "FILE", 0,
      CHANGE_OPTIONS | OPTION_WALL | OPTION_DRAIN | OPTION_MIN_FEATURE | OPTION_KEEP |
          OPTION_DENSITY | OPTION_CAVITY | OPTION_PICTURE | OPTION_VIEW | OPTION_PIXELS |
          OPTION_CUT,
      "  sf hollow part.stl --wall 2 -o hollow.stl\n"
      "  sf hollow part.stl --wall 2 --cut z -o hollow.stl\n"
      "  sf hollow part.stl --wall 2 --drain 3 -o layers --certificate layers.json\n"
      "  sf hollow part.stl --wall 2 --drain 3,2 --cavity cavity.stl --picture cut.png\n",
      CHANGE_OUTPUT, MISSED},
     verb_hollow},
    {{"stand", "make a model stand, hang or rock as it is meant to", "MESH", 0,
      STAND_OPTIONS | HOST_OPTIONS,
      "  sf stand part.stl --up +z -o standing\n"
      "  sf stand part.stl --up +x --build +z --gamma 6 --wall 2 -o standing\n"
      "  sf stand part.stl --carve paper --no-deform --drain 3\n"
      "  sf stand part.stl -o standing --layers layers --certificate layers.json\n"
      "  sf stand part.stl --cut x,8 -o standing\n"
      "  sf stand part.stl --suspend 28,25,36\n"
      "  sf stand part.stl --stance stances.json --handles handles.json -o standing\n"
      "  sf stand part.stl --up -y --rest\n",
      "PREFIX of what is written: _outer.stl, _inner.stl, .json and .png; or a .3mf file for both",
      MISSED},
     verb_stand},
    {{"grade", "a solid of mixed materials from a cage, as layers", "SOLID", 0,
      OPTION_OUTPUT | OPTION_PITCH | OPTION_RESOLUTION | OPTION_UNITS | OPTION_SCALE | OPTION_SIZE |
          OPTION_MEMORY | OPTION_PAINT | OPTION_PROPERTY | OPTION_MATERIALS | OPTION_MASK |
          OPTION_SEPARABLE | OPTION_SHELL | OPTION_KEEP_OUT | OPTION_PICTURE | OPTION_PIXELS |
          OPTION_VIEW | OPTION_SLICE | HOST_OPTIONS,
      "  sf grade cage.vtk -o graded\n"
      "  sf grade cage.vtk --materials materials.json --pitch 0.0423,0.0846,0.027 -o graded\n"
      "  sf grade cage.vtk --shell 0.2,low -o graded\n"
      "  sf grade cage.vtk --paint recipe.json -o graded --picture graded.png\n"
      "  sf grade cage.vtk -o graded --picture graded.png --view top --slice 8\n"
      "  sf grade cage.vtk --property stiffness --mask diffuse --resolution 128 -o graded\n"
      "  sf grade cage.vtk --resolution 128 -o graded.3mf\n",
      "folder for the layers, or a .3mf file for what is mixed where", NULL},
     verb_grade},
    {{"refine", "a cage after some steps of subdivision", "CAGE", 0,
      OPTION_OUTPUT | OPTION_UNITS | OPTION_SCALE | OPTION_SIZE | OPTION_STEPS | OPTION_PAINT |
          OPTION_SEPARABLE | HOST_OPTIONS,
      "  sf refine cage.vtk --steps 3 -o fine.vtk\n", "the refined cage (.vtk)", NULL},
     verb_refine},
    {{"tetra", "a cage as tetrahedra, for simulations and exchange", "CAGE", 0,
      OPTION_OUTPUT | OPTION_UNITS | OPTION_SCALE | OPTION_SIZE | OPTION_STEPS | OPTION_PAINT |
          OPTION_SEPARABLE | HOST_OPTIONS,
      "  sf tetra cage.vtk --steps 2 -o tetra.vtk\n  sf tetra cage.vtk -o tetra.h5\n",
      "the tetrahedra (.h5, with .xdmf beside it, or .vtk)", "1 a tetrahedron is inverted"},
     verb_tetra},
    {{"exchange", "tetrahedra from one format to another", "TETRA", 0,
      OPTION_OUTPUT | OPTION_UNITS | OPTION_SCALE | OPTION_SIZE | HOST_OPTIONS,
      "  sf exchange tetra.vtk -o exchanged.h5\n  sf exchange tetra.h5 -o exchanged.vtk\n",
      "the tetrahedra (.h5, with .xdmf beside it, or .vtk)", NULL},
     verb_exchange},
    {{"slice", "the part as a stack of pictures, as it is", "FILE", 0,
      INPUT_OPTIONS | RULE_OPTIONS | HOST_OPTIONS | OPTION_OUTPUT,
      "  sf slice part.stl --pitch 0.05 -o layers\n"
      "  sf slice part.stl --pitch 0.05 -o job.sl1\n",
      "folder for the layers, or a job (.sl1)", NULL},
     verb_slice},
    {{"orient", "which way up does it print best, and why?", "MESH", 0,
      OPTION_RESOLUTION | OPTION_UP | OPTION_UNITS | OPTION_SCALE | OPTION_SIZE | OPTION_FILL |
          OPTION_ANGLE | OPTION_RULE | HOST_OPTIONS | OPTION_OUTPUT | OPTION_COUNT,
      "  sf orient part.stl\n  sf orient part.stl --angle 50 --count 3 -o turned.stl\n",
      "the mesh, turned the best way (.stl .obj .ply .3mf .glb)", NULL},
     verb_orient},
    {{"render", "a picture of the part, what cannot print in red", "FILE", 0,
      INPUT_OPTIONS | RULE_OPTIONS | HOST_OPTIONS | OPTION_OUTPUT | OPTION_VIEW | OPTION_PIXELS,
      "  sf render part.stl -o part.png\n  sf render part.stl --view below --pixels 800,600\n"
      "  sf render part.stl -o part.glb\n",
      "the picture (default render.png), or a coloured mesh (.glb)", NULL},
     verb_render},
};
const int verbs_count = sizeof verbs_table / sizeof verbs_table[0];
