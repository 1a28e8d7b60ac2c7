// SPDX-License-Identifier: MIT
// What the command line asks for.

#ifndef DEMO_SF_OPTIONS_H
#define DEMO_SF_OPTIONS_H

#include <sf/sf.h>

#include <stdio.h>

// Directions that can point up from the bed.
typedef enum axis { AXIS_X, AXIS_MINUS_X, AXIS_Y, AXIS_MINUS_Y, AXIS_Z, AXIS_MINUS_Z } axis;

// Options, one bit each: which ones a verb takes, and which ones were given.
enum {
    OPTION_OUTPUT = 1 << 0,
    OPTION_PITCH = 1 << 1,
    OPTION_RESOLUTION = 1 << 2,
    OPTION_ANGLE = 1 << 3,
    OPTION_RULE = 1 << 4,
    OPTION_UP = 1 << 5,
    OPTION_UNITS = 1 << 6,
    OPTION_SCALE = 1 << 7,
    OPTION_SIZE = 1 << 8,
    OPTION_BED = 1 << 9,
    OPTION_FILL = 1 << 10,
    OPTION_THREADS = 1 << 11,
    OPTION_JSON = 1 << 12,
    OPTION_QUIET = 1 << 13,
    OPTION_SMOOTH = 1 << 14,
    OPTION_MEMORY = 1 << 15,
    OPTION_VIEW = 1 << 16,
    OPTION_PIXELS = 1 << 17,
    OPTION_BRIDGE = 1 << 18,
    OPTION_CERTIFICATE = 1 << 19,
    OPTION_COUNT = 1 << 20,
    OPTION_KEEP = 1 << 21,
    OPTION_FORBID = 1 << 22,
    OPTION_REMOVE = 1 << 23,
    OPTION_MODE = 1 << 24,
    OPTION_MIN_FEATURE = 1 << 25,
    OPTION_STEEPEST = 1 << 26,
    OPTION_CRUMBS = 1 << 27,
    OPTION_PRINTING = 1 << 28
};

typedef struct cli_options {
    uint32_t given; // OPTION_* that were on the command line
    const char *input;
    const char *output;
    const char *certificate;            // file to write, or NULL
    const char *keep, *forbid, *remove; // meshes of masks, or NULL
    double pitch_mm[3];                 // x, y, layer
    uint32_t resolution;
    double angle_rad; // of the command line or of a stack; values_angle_deg() shows it
    sf_rule_kind rule;
    double bridge_mm[2]; // span and anchor
    axis up;
    double unit_mm; // millimetres in one unit of the input
    double scale;
    double size_mm;
    double bed_mm;
    sf_fill fill;
    int threads;
    int json;
    int quiet;
    int smooth;
    double memory_mib;
    double azimuth_deg, elevation_deg; // where the camera stands
    uint32_t pixels[2];
    uint32_t count;        // how many answers
    double min_feature_mm; // 0: none
    sf_preserve_mode mode;
    int steepest;
    uint32_t crumbs; // places of at most that many voxels are not named
    int printing;    // whether it is asked if it topples
} cli_options;

// A verb of the program. The list ends with an entry whose name is NULL.
typedef struct cli_verb {
    const char *name;
    const char *purpose;  // one line
    const char *input;    // name of its argument, in the usage line
    int input_optional;   // whether the argument may be left out
    uint32_t takes;       // OPTION_*
    const char *examples; // whole lines, each ended
    const char *output;   // what --output names; NULL where the verb writes nothing
} cli_verb;

// Fill `made` with defaults, then with the command line after the verb. Returns 0, or 1 when help
// was asked for, or -1 with a sentence in `message`.
int options_parse(const cli_verb *verb, int argc, char **argv, cli_options *made, char *message,
                  size_t message_size);

// What --help prints for a verb.
void options_help(const cli_verb *verb, FILE *to);

#endif
