// SPDX-License-Identifier: MIT
// What the values of options mean, and what they are where none is given. Whatever is no number, or
// none that any part or printer could want, is refused here, so that nothing behind has to ask.

#include "values.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

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

static const struct {
    const char *name;
    sf_preserve_mode mode;
} modes[] = {{"fast", SF_PRESERVE_FAST},
             {"irredundant", SF_PRESERVE_IRREDUNDANT},
             {"core", SF_PRESERVE_CORE}};

static const double degree = 3.14159265358979323846 / 180;

double values_angle_deg(const cli_options *options)
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

static int parse_drain(const char *text, cli_options *made)
{
    double numbers[2] = {0, 1};
    int good = parse_numbers(text, numbers, 1, 2) > 0 && numbers[0] > 0 && numbers[1] >= 1 &&
               numbers[1] <= 1000 && numbers[1] == floor(numbers[1]);
    made->drain_mm = good ? numbers[0] : 0;
    made->drain_count = good ? (uint32_t)numbers[1] : 0;
    return good;
}

static int parse_cut(const char *text, cli_options *made)
{
    const char *names = "xyz", *found = text[0] != '\0' ? strchr(names, text[0]) : NULL;
    made->cut_mm = INFINITY;
    made->cut_axis = found != NULL ? (int)(found - names) : 0;
    return found != NULL &&
           (text[1] == '\0' || (text[1] == ',' && parse_numbers(text + 2, &made->cut_mm, 1, 1)));
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

static int parse_axis(const char *text, axis *found)
{
    for (size_t i = 0; i < sizeof axes / sizeof axes[0]; i++) {
        if (strcmp(text, axes[i].name) == 0) {
            *found = axes[i].axis;
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

static int parse_mode(const char *text, cli_options *made)
{
    for (size_t i = 0; i < sizeof modes / sizeof modes[0]; i++) {
        if (strcmp(text, modes[i].name) == 0) {
            made->mode = modes[i].mode;
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

static int parse_mask(const char *text, cli_options *made)
{
    static const char *const names[] = {"slice", "isotropic", "diffuse"};
    for (int i = 0; i < 3; i++) {
        if (strcmp(text, names[i]) == 0) {
            made->mask = (cli_mask)i;
            return 1;
        }
    }
    return 0;
}

// A length above 0, and names behind it.
static int parse_shell(const char *text, int wants_name, cli_options *made)
{
    char *end;
    errno = 0;
    made->shell_mm = strtod(text, &end);
    made->shell = *end == ',' ? end + 1 : NULL;
    return end != text && errno == 0 && isfinite(made->shell_mm) && made->shell_mm > 0 &&
           (made->shell != NULL ? made->shell[0] != '\0' : *end == '\0' && !wants_name);
}

// Where the file or name goes that an option gives; NULL where it gives none.
static const char **place_of_name(uint64_t bit, cli_options *made)
{
    switch (bit) {
    case OPTION_OUTPUT:
        return &made->output;
    case OPTION_CERTIFICATE:
        return &made->certificate;
    case OPTION_KEEP:
        return &made->keep;
    case OPTION_FORBID:
        return &made->forbid;
    case OPTION_REMOVE:
        return &made->remove;
    case OPTION_CAVITY:
        return &made->cavity;
    case OPTION_INNER:
        return &made->inner;
    case OPTION_LAYERS:
        return &made->layers;
    case OPTION_PICTURE:
        return &made->picture;
    case OPTION_DENSITY:
        return &made->density;
    case OPTION_PROPERTY:
        return &made->property;
    case OPTION_MATERIALS:
        return &made->materials;
    case OPTION_PAINT:
        return &made->paint;
    default:
        return NULL;
    }
}

// Whole numbers, and an angle.
static int parse_bounded(uint64_t bit, const char *text, cli_options *made)
{
    double number = 0;
    int good = 0;
    switch (bit) {
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
    case OPTION_CRUMBS:
        good = parse_count(text, 0, 1e9, &number);
        made->crumbs = good ? (uint32_t)number : 0;
        return good;
    case OPTION_THRESHOLD:
        good = parse_count(text, 1, 255, &number);
        made->threshold = good ? (uint32_t)number : 0;
        return good;
    case OPTION_SLICE:
        good = parse_count(text, 0, SF_LAYER_MAX, &number);
        made->slice = good ? (uint32_t)number : 0;
        return good;
    case OPTION_STEPS:
        good = parse_count(text, 1, 6, &number);
        made->steps = good ? (uint32_t)number : 0;
        return good;
    case OPTION_SMOOTH:
        good = parse_count(text, 0, 100, &number);
        made->smooth = good ? (int)number : 0;
        return good;
    default:
        return 0;
    }
}

int values_parse(uint64_t bit, const char *text, cli_options *made)
{
    const char **name = place_of_name(bit, made);
    if (name != NULL) {
        *name = text;
        return text[0] != '\0';
    }
    switch (bit) {
    case OPTION_MASK:
        return parse_mask(text, made);
    case OPTION_PITCH:
        return parse_pitch(text, made);
    case OPTION_BRIDGE:
        return parse_bridge(text, made);
    case OPTION_DRAIN:
        return parse_drain(text, made);
    case OPTION_CUT:
        return parse_cut(text, made);
    case OPTION_WALL:
        return parse_positive(text, &made->wall_mm);
    case OPTION_RULE:
        return parse_rule(text, made);
    case OPTION_MODE:
        return parse_mode(text, made);
    case OPTION_UP:
        return parse_axis(text, &made->up);
    case OPTION_UNITS:
        return parse_units(text, made);
    case OPTION_FILL:
        return parse_fill(text, made);
    case OPTION_VIEW:
        return parse_view(text, made);
    case OPTION_SHELL:
    case OPTION_KEEP_OUT:
        return parse_shell(text, bit == OPTION_KEEP_OUT, made);
    case OPTION_PIXELS:
        return parse_pixels(text, made);
    case OPTION_SCALE:
        return parse_positive(text, &made->scale);
    case OPTION_SIZE:
        return parse_positive(text, &made->size_mm);
    case OPTION_MEMORY:
        return parse_positive(text, &made->memory_mib);
    case OPTION_MIN_FEATURE:
        return parse_positive(text, &made->min_feature_mm);
    case OPTION_BED:
        return parse_numbers(text, &made->bed_mm, 1, 1);
    case OPTION_BUILD:
        return parse_axis(text, &made->stand.build);
    default:
        return parse_bounded(bit, text, made) || stand_values_parse(bit, text, &made->stand);
    }
}

cli_options values_default(void)
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
    made.crumbs = 8;
    made.steps = 2;
    made.stand = stand_values_default();
    return made;
}
