// SPDX-License-Identifier: MIT
// A picture of a graded solid: its surface and a cut through it, coloured by a property, and some
// of its layers as they will be printed.

#ifndef DEMO_SF_GRADE_PICTURE_H
#define DEMO_SF_GRADE_PICTURE_H

#include "canvas.h"
#include "materials.h"

enum { GRADE_PICTURE_LAYERS = 3 };

// What is seen of layers while they go by. All of it is of the size of a layer or two.
typedef struct grade_picture {
    sf_lattice lattice;
    double *front, *depth; // of each x and layer: the property where one looks at it along y, and
                           // how far away that is; negative where there is nothing
    double *cut;           // of each x and layer in the middle
    uint8_t *has_cut;
    uint8_t *layers[GRADE_PICTURE_LAYERS]; // ids
    uint32_t which[GRADE_PICTURE_LAYERS];
} grade_picture;

// How much memory it takes.
double grade_picture_bytes(const sf_lattice *lattice);

// Returns 0 without memory.
int grade_picture_begin(const sf_lattice *lattice, grade_picture *picture);
void grade_picture_end(grade_picture *picture);

// Look at a layer: what is solid, the property, the materials.
void grade_picture_look(grade_picture *picture, uint32_t k, sf_slice solid, const double *values,
                        const uint8_t *ids);

// Draw what was seen.
exit_status grade_picture_draw(cli_job *job, const grade_picture *picture, const materials *m,
                               canvas *to);

#endif
