// SPDX-License-Identifier: MIT
// What the command line asks for.

#ifndef DEMO_SF_OPTIONS_H
#define DEMO_SF_OPTIONS_H

#include "stand_values.h"

#include <sf/sf.h>

#include <stdio.h>

// Options, one bit each: which ones a verb takes, and which ones were given.
#define OPTION_OUTPUT (UINT64_C(1) << 0)
#define OPTION_PITCH (UINT64_C(1) << 1)
#define OPTION_RESOLUTION (UINT64_C(1) << 2)
#define OPTION_ANGLE (UINT64_C(1) << 3)
#define OPTION_RULE (UINT64_C(1) << 4)
#define OPTION_UP (UINT64_C(1) << 5)
#define OPTION_UNITS (UINT64_C(1) << 6)
#define OPTION_SCALE (UINT64_C(1) << 7)
#define OPTION_SIZE (UINT64_C(1) << 8)
#define OPTION_BED (UINT64_C(1) << 9)
#define OPTION_FILL (UINT64_C(1) << 10)
#define OPTION_THREADS (UINT64_C(1) << 11)
#define OPTION_JSON (UINT64_C(1) << 12)
#define OPTION_QUIET (UINT64_C(1) << 13)
#define OPTION_SMOOTH (UINT64_C(1) << 14)
#define OPTION_MEMORY (UINT64_C(1) << 15)
#define OPTION_VIEW (UINT64_C(1) << 16)
#define OPTION_PIXELS (UINT64_C(1) << 17)
#define OPTION_BRIDGE (UINT64_C(1) << 18)
#define OPTION_CERTIFICATE (UINT64_C(1) << 19)
#define OPTION_COUNT (UINT64_C(1) << 20)
#define OPTION_KEEP (UINT64_C(1) << 21)
#define OPTION_FORBID (UINT64_C(1) << 22)
#define OPTION_REMOVE (UINT64_C(1) << 23)
#define OPTION_MODE (UINT64_C(1) << 24)
#define OPTION_MIN_FEATURE (UINT64_C(1) << 25)
#define OPTION_STEEPEST (UINT64_C(1) << 26)
#define OPTION_CRUMBS (UINT64_C(1) << 27)
#define OPTION_PRINTING (UINT64_C(1) << 28)
#define OPTION_WALL (UINT64_C(1) << 29)
#define OPTION_DRAIN (UINT64_C(1) << 30)
#define OPTION_DENSITY (UINT64_C(1) << 31)
#define OPTION_PICTURE (UINT64_C(1) << 32)
#define OPTION_CAVITY (UINT64_C(1) << 33)
#define OPTION_INNER (UINT64_C(1) << 60)
#define OPTION_BUILD (UINT64_C(1) << 34)
#define OPTION_GAMMA (UINT64_C(1) << 35)
#define OPTION_CONTACTS (UINT64_C(1) << 36)
#define OPTION_HANDLES (UINT64_C(1) << 37)
#define OPTION_SUSPEND (UINT64_C(1) << 38)
#define OPTION_STANCE (UINT64_C(1) << 39)
#define OPTION_CARVE (UINT64_C(1) << 40)
#define OPTION_SOLVER (UINT64_C(1) << 41)
#define OPTION_MU (UINT64_C(1) << 42)
#define OPTION_NO_CARVE (UINT64_C(1) << 43)
#define OPTION_NO_DEFORM (UINT64_C(1) << 44)
#define OPTION_NO_LAPLACIAN (UINT64_C(1) << 45)
#define OPTION_REST (UINT64_C(1) << 46)
#define OPTION_LAYERS (UINT64_C(1) << 47)
#define OPTION_MAX_SHIFT (UINT64_C(1) << 48)
#define OPTION_TURN (UINT64_C(1) << 49)
#define OPTION_CUT (UINT64_C(1) << 50)
#define OPTION_PROPERTY (UINT64_C(1) << 51)
#define OPTION_MATERIALS (UINT64_C(1) << 52)
#define OPTION_MASK (UINT64_C(1) << 53)
#define OPTION_STEPS (UINT64_C(1) << 54)
#define OPTION_SEPARABLE (UINT64_C(1) << 55)
#define OPTION_PAINT (UINT64_C(1) << 56)
#define OPTION_SHELL (UINT64_C(1) << 57)
#define OPTION_KEEP_OUT (UINT64_C(1) << 58)
#define OPTION_SLICE (UINT64_C(1) << 59)
#define OPTION_THRESHOLD (UINT64_C(1) << 61)

// How tones become materials.
typedef enum cli_mask { CLI_MASK_SLICE, CLI_MASK_ISOTROPIC, CLI_MASK_DIFFUSE } cli_mask;

typedef struct cli_options {
    uint64_t given; // OPTION_* that were on the command line
    const char *input;
    const char *output;
    const char *certificate;            // file to write, or NULL
    const char *keep, *forbid, *remove; // meshes of masks, or NULL
    const char *cavity, *picture;       // files to write, or NULL
    const char *inner;                  // a mesh, or NULL
    const char *layers;                 // folder to write, or NULL
    const char *density;                // a number or a file, or NULL
    const char *property, *materials;   // a name, a file; or NULL
    const char *paint;                  // a file, or NULL
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
    uint32_t slice; // voxels across the view, that a picture is cut through; where it was given
    uint32_t count; // how many answers
    double min_feature_mm;    // 0: none
    double wall_mm, drain_mm; // 0: not given
    uint32_t drain_count;     // holes for each void
    int cut_axis;             // 0 to 2, where --cut was given
    double cut_mm;            // infinite: in the middle
    sf_preserve_mode mode;
    int steepest;
    uint32_t threshold; // least grey of 255 that is solid, in a job
    uint32_t crumbs;    // places of at most that many voxels are not named
    int printing;       // whether it is asked if it topples
    cli_mask mask;
    uint32_t steps; // of refinement
    double shell_mm;
    const char *shell; // what --shell or --keep-out names, or NULL
    stand_values stand;
} cli_options;

// A verb of the program. The list ends with an entry whose name is NULL.
typedef struct cli_verb {
    const char *name;
    const char *purpose;  // one line
    const char *input;    // name of its argument, in the usage line
    int input_optional;   // whether the argument may be left out
    uint64_t takes;       // OPTION_*
    const char *examples; // whole lines, each ended
    const char *output;   // what --output names; NULL where the verb writes nothing
    const char *missed;   // what exit status 1 means; NULL where there is none
} cli_verb;

// Fill `made` with defaults, then with the command line after the verb. Returns 0, or 1 when help
// was asked for, or -1 with a sentence in `message`.
int options_parse(const cli_verb *verb, int argc, char **argv, cli_options *made, char *message,
                  size_t message_size);

// What --help prints for a verb.
void options_help(const cli_verb *verb, FILE *to);

#endif
