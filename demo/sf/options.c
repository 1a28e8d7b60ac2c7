// SPDX-License-Identifier: MIT
// What the command line asks for: one table names every option, and parsing, the checks and --help
// all read it. The splitting itself is getopt_long's.

#include "options.h"

#include <errno.h>
#include <getopt.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct option_entry {
    uint32_t bit;
    const char *name;
    char letter;          // or 0
    const char *argument; // or NULL
    const char *help;
} option_entry;

static const option_entry table[] = {
    {OPTION_OUTPUT, "output", 'o', "OUT", "where the result goes"},
    {OPTION_RESOLUTION, "resolution", 0, "N", "voxels on the longest side (default 256)"},
    {OPTION_PITCH, "pitch", 0, "PX[,PY[,LAYER]]", "voxel size in mm instead of a resolution"},
    {OPTION_ANGLE, "angle", 0, "DEG", "overhang from the vertical that still prints (default 45)"},
    {OPTION_RULE, "rule", 0, "RULE",
     "octagon (default), slack, disk, or box3, which takes no angle"},
    {OPTION_BRIDGE, "bridge", 0, "MM[,ANCHOR]", "gaps that may be spanned between two held ends"},
    {OPTION_CERTIFICATE, "certificate", 0, "FILE", "a proof of the result, for sf-verify"},
    {OPTION_UP, "up", 0, "AXIS", "the input's axis that points up: +x -x +y -y +z -z"},
    {OPTION_UNITS, "units", 0, "UNIT", "unit of the input: mm (default), cm, m, in"},
    {OPTION_SCALE, "scale", 0, "F", "make the part F times as large"},
    {OPTION_SIZE, "size", 0, "MM", "make the longest side MM long"},
    {OPTION_BED, "bed", 0, "Z", "height of the bed in mm (default: where the part begins)"},
    {OPTION_FILL, "fill", 0, "WAY", "what is inside: auto (default), parity, winding, surface"},
    {OPTION_SMOOTH, "smooth", 0, "N", "passes of smoothing over a written mesh (default 0)"},
    {OPTION_VIEW, "view", 0, "AZ,EL", "degrees around and above, or iso, below, front, side, top"},
    {OPTION_PIXELS, "pixels", 0, "W,H", "size of the picture (default 1200,900)"},
    {OPTION_COUNT, "count", 0, "N", "how many answers to give (default 5)"},
    {OPTION_THREADS, "threads", 0, "N", "threads to use (default: all processors)"},
    {OPTION_MEMORY, "memory", 0, "MIB", "most memory for one grid, in MiB (default 4096)"},
    {OPTION_JSON, "json", 0, NULL, "one JSON object on standard output"},
    {OPTION_QUIET, "quiet", 'q', NULL, "no progress bar"},
};
enum { TABLE_SIZE = sizeof table / sizeof table[0], HELP = 1000 };

static const struct {
    const char *name;
    axis axis;
} axes[] = {{"+x", AXIS_X}, {"x", AXIS_X}, {"-x", AXIS_MINUS_X},
            {"+y", AXIS_Y}, {"y", AXIS_Y}, {"-y", AXIS_MINUS_Y},
            {"+z", AXIS_Z}, {"z", AXIS_Z}, {"-z", AXIS_MINUS_Z}};

static const struct {
    const char *name;
    double mm;
} units[] = {{"mm", 1.0}, {"cm", 10.0}, {"m", 1000.0}, {"in", 25.4}};

static const struct {
    const char *name;
    double azimuth, elevation;
} views[] = {
    {"iso", -55, 24}, {"below", -55, -24}, {"front", -90, 0}, {"side", 0, 0}, {"top", -90, 89}};

static const char *const fills[] = {"auto", "parity", "winding", "surface"};

static const double degree = 3.14159265358979323846 / 180;

double options_angle_deg(const cli_options *options)
{
    double exact = options->angle_rad / degree, rounded = floor(exact * 1e9 + 0.5) / 1e9;
    return fabs(rounded - exact) < 1e-12 ? rounded : exact;
}

// A list of `least` to `most` numbers parted by commas; returns how many, or 0.
static int parse_numbers(const char *text, double *numbers, int least, int most)
{
    int count = 0;
    for (;;) {
        char *end;
        errno = 0;
        numbers[count] = strtod(text, &end);
        if (end == text || errno != 0 || !isfinite(numbers[count])) {
            return 0;
        }
        count++;
        if (*end == '\0') {
            return count >= least ? count : 0;
        }
        if (*end != ',' || count == most) {
            return 0;
        }
        text = end + 1;
    }
}

static int parse_positive(const char *text, double *number)
{
    return parse_numbers(text, number, 1, 1) && *number > 0;
}

static int parse_count(const char *text, double least, double most, double *number)
{
    return parse_numbers(text, number, 1, 1) && *number >= least && *number <= most &&
           *number == floor(*number);
}

static int parse_pitch(const char *text, cli_options *made)
{
    int count = parse_numbers(text, made->pitch_mm, 1, 3);
    for (int i = count; count > 0 && i < 3; i++) {
        made->pitch_mm[i] = made->pitch_mm[0];
    }
    return count > 0 && made->pitch_mm[0] > 0 && made->pitch_mm[1] > 0 && made->pitch_mm[2] > 0;
}

static int parse_bridge(const char *text, cli_options *made)
{
    made->bridge_mm[1] = 0;
    return parse_numbers(text, made->bridge_mm, 1, 2) > 0 && made->bridge_mm[0] >= 0 &&
           made->bridge_mm[1] >= 0;
}

static int parse_pixels(const char *text, cli_options *made)
{
    double numbers[2];
    if (parse_numbers(text, numbers, 2, 2) != 2 || numbers[0] < 64 || numbers[0] > 16384 ||
        numbers[1] < 64 || numbers[1] > 16384 || numbers[0] != floor(numbers[0]) ||
        numbers[1] != floor(numbers[1])) {
        return 0;
    }
    made->pixels[0] = (uint32_t)numbers[0];
    made->pixels[1] = (uint32_t)numbers[1];
    return 1;
}

static int parse_view(const char *text, cli_options *made)
{
    double numbers[2];
    for (size_t i = 0; i < sizeof views / sizeof views[0]; i++) {
        if (strcmp(text, views[i].name) == 0) {
            made->azimuth_deg = views[i].azimuth;
            made->elevation_deg = views[i].elevation;
            return 1;
        }
    }
    if (parse_numbers(text, numbers, 2, 2) != 2 || fabs(numbers[0]) > 360 ||
        fabs(numbers[1]) > 90) {
        return 0;
    }
    made->azimuth_deg = numbers[0];
    made->elevation_deg = numbers[1];
    return 1;
}

static int parse_up(const char *text, cli_options *made)
{
    for (size_t i = 0; i < sizeof axes / sizeof axes[0]; i++) {
        if (strcmp(text, axes[i].name) == 0) {
            made->up = axes[i].axis;
            return 1;
        }
    }
    return 0;
}

static int parse_units(const char *text, cli_options *made)
{
    for (size_t i = 0; i < sizeof units / sizeof units[0]; i++) {
        if (strcmp(text, units[i].name) == 0) {
            made->unit_mm = units[i].mm;
            return 1;
        }
    }
    return 0;
}

static int parse_rule(const char *text, cli_options *made)
{
    return sf_rule_kind_from_name(text, &made->rule) == SF_OK;
}

static int parse_fill(const char *text, cli_options *made)
{
    for (size_t i = 0; i < sizeof fills / sizeof fills[0]; i++) {
        if (strcmp(text, fills[i]) == 0) {
            made->fill = (sf_fill)i;
            return 1;
        }
    }
    return 0;
}

// Take one option's argument. Returns 0 when it makes no sense.
static int parse_argument(uint32_t bit, const char *text, cli_options *made)
{
    double number = 0;
    int good = 1;
    switch (bit) {
    case OPTION_OUTPUT:
        made->output = text;
        return text[0] != '\0';
    case OPTION_CERTIFICATE:
        made->certificate = text;
        return text[0] != '\0';
    case OPTION_PITCH:
        return parse_pitch(text, made);
    case OPTION_BRIDGE:
        return parse_bridge(text, made);
    case OPTION_RULE:
        return parse_rule(text, made);
    case OPTION_UP:
        return parse_up(text, made);
    case OPTION_UNITS:
        return parse_units(text, made);
    case OPTION_FILL:
        return parse_fill(text, made);
    case OPTION_VIEW:
        return parse_view(text, made);
    case OPTION_PIXELS:
        return parse_pixels(text, made);
    case OPTION_SCALE:
        return parse_positive(text, &made->scale);
    case OPTION_SIZE:
        return parse_positive(text, &made->size_mm);
    case OPTION_MEMORY:
        return parse_positive(text, &made->memory_mib);
    case OPTION_BED:
        return parse_numbers(text, &made->bed_mm, 1, 1);
    case OPTION_ANGLE:
        good = parse_numbers(text, &number, 1, 1) == 1 && number >= 5 && number <= 85;
        made->angle_rad = good ? number * degree : 0;
        return good;
    case OPTION_RESOLUTION:
        good = parse_count(text, 1, SF_EXTENT_MAX - 2, &number);
        made->resolution = good ? (uint32_t)number : 0;
        return good;
    case OPTION_THREADS:
        good = parse_count(text, 1, 1024, &number);
        made->threads = good ? (int)number : 0;
        return good;
    case OPTION_COUNT:
        good = parse_count(text, 1, 1000, &number);
        made->count = good ? (uint32_t)number : 0;
        return good;
    case OPTION_SMOOTH:
        good = parse_count(text, 0, 100, &number);
        made->smooth = good ? (int)number : 0;
        return good;
    default:
        return 0;
    }
}

static cli_options defaults(void)
{
    cli_options made;
    memset(&made, 0, sizeof made);
    made.resolution = 256;
    made.angle_rad = 45 * degree;
    made.rule = SF_RULE_OCTAGON;
    made.up = AXIS_Z;
    made.unit_mm = 1;
    made.scale = 1;
    made.memory_mib = 4096;
    made.azimuth_deg = views[0].azimuth;
    made.elevation_deg = views[0].elevation;
    made.pixels[0] = 1200;
    made.pixels[1] = 900;
    made.count = 5;
    return made;
}

// Options that exclude each other.
static int check_together(const cli_options *made, char *message, size_t size)
{
    const char *why = NULL;
    if ((made->given & OPTION_PITCH) && (made->given & OPTION_RESOLUTION)) {
        why = "--pitch and --resolution both say how large a voxel is; give one of them";
    } else if ((made->given & OPTION_SCALE) && (made->given & OPTION_SIZE)) {
        why = "--scale and --size both say how large the part is; give one of them";
    } else if (made->rule == SF_RULE_BOX3 && (made->given & OPTION_ANGLE)) {
        why = "the rule box3 takes no angle: leave out --angle, or use --rule octagon";
    }
    if (why != NULL) {
        snprintf(message, size, "%s", why);
    }
    return why == NULL ? 0 : -1;
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
    } else if (!parse_argument(entry->bit, optarg, made)) {
        snprintf(message, size, "--%s wants %s, and '%s' will not do (%s)", entry->name,
                 entry->argument, optarg, entry->help);
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
    *made = defaults();
    opterr = 0;
    optind = 1;
    while ((code = getopt_long(argc, argv, shorts, longs, NULL)) != -1) {
        const char *seen = optind > 0 && optind <= argc ? argv[optind - 1] : "";
        if (code == HELP || code == 'h') {
            return 1;
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
        fprintf(to, "  %-29s %s\n", left,
                table[i].bit == OPTION_OUTPUT ? verb->output : table[i].help);
    }
    fprintf(to, "  %-29s %s\n\nexamples:\n%s", "-h, --help", "this text", verb->examples);
    fputs(
        verb->takes & OPTION_RESOLUTION
            ? "\nA FILE is an STL, OBJ, PLY or OFF mesh, a folder with a stack of pictures that sf "
              "wrote,\nor scene:garden, a scene that the program makes itself.\n"
            : "\nA FILE is an STL, OBJ, PLY or OFF mesh.\n",
        to);
    fputs("\nexit status: 0 good, 1 the asked property was not reached, 2 usage, 3 bad input,"
          "\n4 out of memory or disk, 130 cancelled\n",
          to);
}
