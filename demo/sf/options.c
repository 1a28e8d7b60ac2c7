// SPDX-License-Identifier: MIT
// What the command line asks for: one table names every option, and parsing, the checks and --help
// all read it. The splitting itself is getopt_long's.

#include "options.h"

#include "values.h"

#include <getopt.h>
#include <string.h>

typedef struct option_entry {
    uint64_t bit;
    const char *name;
    char letter;          // or 0
    const char *argument; // or NULL
    const char *help;
} option_entry;

static const option_entry table[] = {
    {OPTION_OUTPUT, "output", 'o', "OUT", "where the result goes"},
    {OPTION_RESOLUTION, "resolution", 0, "N",
     "voxels on the longest side, 1 to 65533 (default 256)"},
    {OPTION_PITCH, "pitch", 0, "PX[,PY[,LAYER]]", "voxel size in mm instead of a resolution"},
    {OPTION_ANGLE, "angle", 0, "DEG",
     "overhang that still prints, 5 to 85 from the vertical (default 45)"},
    {OPTION_RULE, "rule", 0, "RULE",
     "octagon (default; slack on oblong pixels), slack, disk, or box3, which takes no angle"},
    {OPTION_BRIDGE, "bridge", 0, "MM[,ANCHOR]", "gaps that may be spanned between two held ends"},
    {OPTION_WALL, "wall", 0, "MM", "thickness of the wall that stays around the inside"},
    {OPTION_DRAIN, "drain", 0, "MM[,N]",
     "drill a hole of that width (or N) into every void; fill what none fits into"},
    {OPTION_DENSITY, "density", 0, "D|FILE", "what 1 mm3 weighs, or a file that says more"},
    {OPTION_PAINT, "paint", 0, "FILE", "a recipe of what to change in the cage first"},
    {OPTION_PROPERTY, "property", 0, "NAME", "the property that materials are mixed for"},
    {OPTION_MATERIALS, "materials", 0, "FILE",
     "materials, and what mixtures of them were measured to be (default: two, from the least to "
     "the "
     "greatest value)"},
    {OPTION_MASK, "mask", 0, "KIND",
     "slice (default: even in each layer), isotropic (even in the solid) or diffuse (errors go "
     "on)"},
    {OPTION_SHELL, "shell", 0, "MM[,MATERIAL]",
     "all that is within MM of the surface is of that material (default: the first)"},
    {OPTION_KEEP_OUT, "keep-out", 0, "MM,MATERIAL[,INSTEAD]",
     "a material comes no nearer to the surface; another takes its place (default: the first other "
     "one)"},
    {OPTION_STEPS, "steps", 0, "N", "steps of refinement, 1 to 6 (default 2)"},
    {OPTION_SEPARABLE, "separable", 0, NULL,
     "where the cage is extruded, cross sections are those of surfaces"},
    {OPTION_INNER, "inner", 0, "MESH", "the surface of a cavity, which is taken from the part"},
    {OPTION_CAVITY, "cavity", 0, "MESH", "also write the cavity, holes included, by itself"},
    {OPTION_CUT, "cut", 0, "AXIS[,MM]",
     "also cut the written mesh across x, y or z into halves _low and _high (default: its middle)"},
    {OPTION_PICTURE, "picture", 0, "PNG", "also draw the part, cut open"},
    {OPTION_LAYERS, "layers", 0, "FOLDER", "also write the layers of what was carved"},
    {OPTION_CERTIFICATE, "certificate", 0, "FILE", "a proof of the result, for sf-verify"},
    {OPTION_KEEP, "keep", 0, "MESH", "matter in there is never removed"},
    {OPTION_FORBID, "forbid", 0, "MESH", "nothing is added in there"},
    {OPTION_REMOVE, "remove", 0, "MESH", "what is to go, but for what carries the rest"},
    {OPTION_MODE, "mode", 0, "MODE",
     "fast (default), irredundant (keep the least) or core (keep it thick)"},
    {OPTION_MIN_FEATURE, "min-feature", 0, "MM",
     "what is added, or left inside, is that wide where there is room"},
    {OPTION_STEEPEST, "steepest", 0, NULL, "also look for the steepest overhang"},
    {OPTION_THRESHOLD, "threshold", 0, "GREY",
     "of a job: the least grey, 1 to 255, that hardens (default 128)"},
    {OPTION_CRUMBS, "crumbs", 0, "N",
     "places of at most N voxels are summed up, not named (default 8)"},
    {OPTION_PRINTING, "printing", 0, NULL,
     "also ask whether it topples while it is printed, which is then status 1"},
    {OPTION_GAMMA, "gamma", 0, "DEG", "tilt that it must stand, 0 to 80 (default 4)"},
    {OPTION_CONTACTS, "contacts", 0, "WHERE",
     "only vertices there, in mm, can touch the ground: 'x>0', 'x>0,y<2.5'"},
    {OPTION_SUSPEND, "suspend", 0, "X,Y,Z",
     "it hangs from that point, in mm, and stands on nothing"},
    {OPTION_STANCE, "stance", 0, "FILE", "poses that it is to rest in, instead of --up"},
    {OPTION_HANDLES, "handles", 0, "FILE|auto:N",
     "what bends it; or N places, 0 to 63, found by themselves (default auto:8)"},
    {OPTION_MAX_SHIFT, "max-shift", 0, "MM",
     "no handle moves farther along x, y or z (default half the longest side)"},
    {OPTION_TURN, "turn", 0, NULL, "handles may turn as well as shift and scale"},
    {OPTION_CARVE, "carve", 0, "WAY",
     "support-free (default), or paper, after which ceilings may hang"},
    {OPTION_SOLVER, "solver", 0, "WAY", "sqp (default), or paper: its gradient descent"},
    {OPTION_MU, "mu", 0, "M", "what the shape weighs in the paper's sum, 0 to 1 (default 0.5)"},
    {OPTION_NO_CARVE, "no-carve", 0, NULL, "leave the inside as it is"},
    {OPTION_NO_DEFORM, "no-deform", 0, NULL, "leave the outside as it is"},
    {OPTION_NO_LAPLACIAN, "no-laplacian", 0, NULL, "let details go where that bends it less"},
    {OPTION_REST, "rest", 0, NULL, "change nothing: say where it comes to rest, put down as --up"},
    {OPTION_BUILD, "build", 0, "AXIS",
     "the axis that points up while it is printed (default: --up)"},
    {OPTION_UP, "up", 0, "AXIS", "the input's axis that points up: +x -x +y -y +z -z (y is +y)"},
    {OPTION_UNITS, "units", 0, "UNIT", "unit of the input: mm (default), cm, m, in"},
    {OPTION_SCALE, "scale", 0, "F", "make the part F times as large"},
    {OPTION_SIZE, "size", 0, "MM", "make the longest side MM long"},
    {OPTION_BED, "bed", 0, "Z", "height of the bed in mm (default: where the part begins)"},
    {OPTION_FILL, "fill", 0, "WAY", "what is inside: auto (default), parity, winding, surface"},
    {OPTION_SMOOTH, "smooth", 0, "N",
     "passes of smoothing over a written mesh, 0 to 100 (default 0)"},
    {OPTION_VIEW, "view", 0, "AZ,EL", "degrees around and above, or iso, below, front, side, top"},
    {OPTION_SLICE, "slice", 0, "N",
     "the picture's cut goes through voxels N across its view (default: the middle)"},
    {OPTION_PIXELS, "pixels", 0, "W,H", "size of the picture, 64 to 16384 each (default 1200,900)"},
    {OPTION_COUNT, "count", 0, "N", "how many answers to give, 1 to 1000 (default 5)"},
    {OPTION_THREADS, "threads", 0, "N", "threads to use, 1 to 1024 (default: all processors)"},
    {OPTION_MEMORY, "memory", 0, "MIB", "most memory for one grid, in MiB (default 4096)"},
    {OPTION_JSON, "json", 0, NULL, "one JSON object on standard output"},
    {OPTION_QUIET, "quiet", 'q', NULL, "no progress bar"},
};
enum { TABLE_SIZE = sizeof table / sizeof table[0], HELP = 1000 };

// Options that exclude each other.
static int check_together(const cli_options *made, char *message, size_t size)
{
    const char *why = NULL;
    if ((made->given & OPTION_PITCH) && (made->given & OPTION_RESOLUTION)) {
        why = "--pitch and --resolution both say how large a voxel is; give one of them";
    } else if ((made->given & OPTION_SCALE) && (made->given & OPTION_SIZE)) {
        why = "--scale and --size both say how large the part is; give one of them";
    } else if ((made->given & OPTION_SHELL) && (made->given & OPTION_KEEP_OUT)) {
        why = "--shell and --keep-out both say what the surface is of; give one of them";
    } else if (made->rule == SF_RULE_BOX3 && (made->given & OPTION_ANGLE)) {
        why = "the rule box3 takes no angle: leave out --angle, or use --rule octagon";
    }
    if (why != NULL) {
        snprintf(message, size, "%s", why);
    }
    return why == NULL ? 0 : -1;
}

// What an option says in a verb that it means something else in.
static const struct {
    const char *verb;
    uint64_t bit;
    const char *help;
} own_words[] = {
    {"stand", OPTION_RESOLUTION, "voxels on the longest side, 1 to 65533 (default 64)"},
    {"grade", OPTION_MEMORY,
     "most memory for one layer and what it asks for, in MiB (default 4096)"},
    {"grade", OPTION_VIEW, "where the picture looks from: front (default), side or top"},
    {"grade", OPTION_PICTURE, "also draw the surface, a cut through it, and three layers"},
};

static const char *help_of(const cli_verb *verb, const option_entry *entry)
{
    for (size_t i = 0; i < sizeof own_words / sizeof own_words[0]; i++) {
        if (own_words[i].bit == entry->bit && strcmp(own_words[i].verb, verb->name) == 0) {
            return own_words[i].help;
        }
    }
    return entry->bit == OPTION_OUTPUT ? verb->output : entry->help;
}

static int take_option(const cli_verb *verb, int index, cli_options *made, char *message,
                       size_t size)
{
    const option_entry *entry = &table[index];
    if ((verb->takes & entry->bit) == 0) {
        snprintf(message, size, "'sf %s' takes no --%s", verb->name, entry->name);
        return -1;
    }
    made->given |= entry->bit;
    if (entry->bit == OPTION_JSON) {
        made->json = 1;
    } else if (entry->bit == OPTION_QUIET) {
        made->quiet = 1;
    } else if (entry->bit == OPTION_STEEPEST) {
        made->steepest = 1;
    } else if (entry->bit == OPTION_PRINTING) {
        made->printing = 1;
    } else if (entry->argument != NULL && !values_parse(entry->bit, optarg, made)) {
        snprintf(message, size, "--%s wants %s, and '%s' will not do: %s", entry->name,
                 entry->argument, optarg, help_of(verb, entry));
        return -1;
    }
    return 0;
}

// getopt_long's own form of the table. Long options return their place in it.
static void describe(struct option *longs, char *shorts)
{
    size_t used = 0;
    shorts[used++] = ':';
    shorts[used++] = 'h';
    for (int i = 0; i < TABLE_SIZE; i++) {
        struct option made = {table[i].name,
                              table[i].argument != NULL ? required_argument : no_argument, NULL,
                              HELP + 1 + i};
        longs[i] = made;
        if (table[i].letter != 0) {
            shorts[used++] = table[i].letter;
            if (table[i].argument != NULL) {
                shorts[used++] = ':';
            }
        }
    }
    struct option help = {"help", no_argument, NULL, HELP}, end = {NULL, 0, NULL, 0};
    longs[TABLE_SIZE] = help;
    longs[TABLE_SIZE + 1] = end;
    shorts[used] = '\0';
}

// Place in the table of what getopt_long returned, or -1.
static int place_of(int code)
{
    if (code > HELP) {
        return code - HELP - 1;
    }
    for (int i = 0; i < TABLE_SIZE; i++) {
        if (table[i].letter != 0 && table[i].letter == code) {
            return i;
        }
    }
    return -1;
}

static int take_operands(const cli_verb *verb, int count, char **operands, cli_options *made,
                         char *message, size_t size)
{
    if (count > 1) {
        snprintf(message, size, "one %s at a time, please: '%s' is too much", verb->input,
                 operands[1]);
        return -1;
    }
    if (count == 0 && !verb->input_optional) {
        snprintf(message, size, "'sf %s' needs a %s", verb->name, verb->input);
        return -1;
    }
    made->input = count == 1 ? operands[0] : NULL;
    return 0;
}

int options_parse(const cli_verb *verb, int argc, char **argv, cli_options *made, char *message,
                  size_t message_size)
{
    struct option longs[TABLE_SIZE + 2];
    char shorts[2 * TABLE_SIZE + 3];
    int code;
    describe(longs, shorts);
    *made = values_default();
    opterr = 0;
    optind = 1;
    while ((code = getopt_long(argc, argv, shorts, longs, NULL)) != -1) {
        const char *seen = optind > 0 && optind <= argc ? argv[optind - 1] : "";
        if (code == HELP || code == 'h') {
            return 1;
        }
        if (code == '?' && optopt > HELP) {
            snprintf(message, message_size, "--%s takes no value", table[place_of(optopt)].name);
            return -1;
        }
        if (code == '?') {
            snprintf(message, message_size, "there is no option '%s'; 'sf %s --help' lists them",
                     seen, verb->name);
            return -1;
        }
        if (code == ':') {
            snprintf(message, message_size, "'%s' wants a value after it", seen);
            return -1;
        }
        if (take_option(verb, place_of(code), made, message, message_size) != 0) {
            return -1;
        }
    }
    if (take_operands(verb, argc - optind, argv + optind, made, message, message_size) != 0) {
        return -1;
    }
    return check_together(made, message, message_size);
}

// What a verb takes, by the name of its argument.
static const char *describe_input(const char *name)
{
    if (strcmp(name, "MESH") == 0) {
        return "\nA MESH is an STL, OBJ, PLY, OFF, 3MF or glTF (.glb) file.\n";
    }
    if (strcmp(name, "CAGE") == 0) {
        return "\nA CAGE is a mesh of cells with properties: legacy VTK, Medit .mesh or MFEM "
               ".mesh.\n";
    }
    if (strcmp(name, "TETRA") == 0) {
        return "\nTETRA is an exchange file (.h5), or a legacy VTK file of tetrahedra.\n";
    }
    if (strcmp(name, "SOLID") == 0) {
        return "\nA SOLID is a cage, which is made smooth (legacy VTK, Medit .mesh or MFEM .mesh), "
               "or "
               "tetrahedra,\nwhich are taken as they are (an exchange file .h5, or VTK of nothing "
               "else)."
               "\n";
    }
    return "\nA FILE is an STL, OBJ, PLY, OFF, 3MF or glTF mesh, a job of a printer (.sl1, "
           ".photon),\ncontours (.cli), a folder with a stack of pictures that sf wrote, or "
           "scene:garden, a scene\nthat the program makes itself.\n";
}

void options_help(const cli_verb *verb, FILE *to)
{
    fprintf(to, "sf %s: %s\n\nusage: sf %s [options] %s%s%s\n\n", verb->name, verb->purpose,
            verb->name, verb->input_optional ? "[" : "", verb->input,
            verb->input_optional ? "]" : "");
    for (int i = 0; i < TABLE_SIZE; i++) {
        char left[40], letter[8] = "    ";
        if ((verb->takes & table[i].bit) == 0) {
            continue;
        }
        if (table[i].letter != 0) {
            snprintf(letter, sizeof letter, "-%c, ", table[i].letter);
        }
        snprintf(left, sizeof left, "%s--%s%s%s", letter, table[i].name,
                 table[i].argument != NULL ? " " : "",
                 table[i].argument != NULL ? table[i].argument : "");
        fprintf(to, "  %-29s %s\n", left, help_of(verb, &table[i]));
    }
    fprintf(to, "  %-29s %s\n\nexamples:\n%s", "-h, --help", "this text", verb->examples);
    fputs(describe_input(verb->input), to);
    if (verb->takes & OPTION_BRIDGE) {
        fputs("A stack brings its own rule, angle, bridges and bed; an option takes the place of "
              "one.\n",
              to);
    }
    fprintf(
        to,
        "\nexit status: 0 good, %s%s2 usage, 3 bad input, 4 out of memory or disk, 130 cancelled\n",
        verb->missed != NULL ? verb->missed : "", verb->missed != NULL ? ",\n" : "");
}
