// SPDX-License-Identifier: MIT
// Materials, and which mixture of them has which properties.

#ifndef DEMO_SF_MATERIALS_H
#define DEMO_SF_MATERIALS_H

#include "job.h"

#include <sf/layers.h>

enum {
    MATERIALS_MAX = SF_MIXTURE_MATERIAL_MAX,
    MATERIALS_PROPERTIES_MAX = SF_MIXTURE_PROPERTY_MAX
};

typedef struct materials {
    uint32_t count;
    sf_material table[MATERIALS_MAX];
    size_t property_count;
    char properties[MATERIALS_PROPERTIES_MAX][SF_PROPERTY_NAME_SIZE];
    sf_curve *curve;     // of two materials and one property: the second one's fraction
    sf_mixture *mixture; // of several properties
    size_t hint;         // where the last answer was
    // Of more materials and one property: what was measured, by rising value.
    size_t rungs;
    double *ladder; // of each the value, then a fraction of each material
} materials;

// Read the file that --materials names.
exit_status materials_read(cli_job *job, materials *made);

// Two materials, of which there is the more of the second the higher the property: from one value
// to another.
exit_status materials_between(cli_job *job, const char *property, double low, double high,
                              materials *made);

void materials_free(materials *m);

// What fractions have the wanted properties, or the nearest; returns how far off those are: in the
// property's unit where there is one, in spans of what was measured where there are several.
double materials_mix(materials *m, const double *wanted, double *fractions);

#endif
