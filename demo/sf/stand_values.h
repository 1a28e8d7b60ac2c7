// SPDX-License-Identifier: MIT
// What the command line asks of `sf stand`.

#ifndef DEMO_SF_STAND_VALUES_H
#define DEMO_SF_STAND_VALUES_H

#include <sf/stand.h>

// Directions that can point up from the bed.
typedef enum axis { AXIS_X, AXIS_MINUS_X, AXIS_Y, AXIS_MINUS_Y, AXIS_Z, AXIS_MINUS_Z } axis;

typedef struct stand_values {
    axis build;             // where --build was given
    double gamma_rad;       // tilt that it must stand
    double low[3], high[3]; // where contacts can be: axes of the input, mm as printed
    double point[3];        // that it hangs from: the same
    const char *stances;    // a file, or NULL
    const char *handles;    // a file, or NULL
    uint32_t handle_count;  // to place by themselves, where there is no file
    double shift_max_mm;    // that a handle may move; 0: the library's default
    sf_carve_mode carve;
    sf_stand_solver solver;
    double mu;
} stand_values;

stand_values stand_values_default(void);

// Take one option's argument. Returns 0 when it makes no sense, or the option is none of these.
int stand_values_parse(uint64_t bit, const char *text, stand_values *made);

#endif
