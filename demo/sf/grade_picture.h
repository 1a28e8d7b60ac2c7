// SPDX-License-Identifier: MIT
// A picture of a graded solid: its surface and a cut through it, coloured by a property, and some
// of its layers as they will be printed.

#ifndef DEMO_SF_GRADE_PICTURE_H
#define DEMO_SF_GRADE_PICTURE_H

#include "canvas.h"
#include "materials.h"

enum { GRADE_PICTURE_LAYERS = 3 };

// Where one looks from.
typedef enum grade_view { GRADE_FRONT, GRADE_SIDE, GRADE_TOP } grade_view;

// What is seen of layers while they go by. All of it is of the size of a layer or two.
typedef struct grade_picture {
    sf_lattice lattice;
    grade_view view;
    uint32_t slice;        // voxels across the view that the cut goes through
    uint32_t across, up;   // voxels of the view
    double pitch_mm[2];    // across and up
    double *front, *depth; // of each place in the view: the property where one looks at it, and how
                           // far away that is; negative where there is nothing
    double *cut;           // of each place: the property in the cut
    uint8_t *has_cut;
    uint8_t *layers[GRADE_PICTURE_LAYERS]; // ids
    uint32_t which[GRADE_PICTURE_LAYERS];
} grade_picture;

// How much memory it takes at most.
double grade_picture_bytes(const sf_lattice *lattice);

// Begin with the view and slice that the options say; the lattice must be there. EXIT_USAGE: no
// such view or slice.
exit_status grade_picture_begin(cli_job *job, const sf_lattice *lattice, grade_picture *picture);
void grade_picture_end(grade_picture *picture);

// Look at a layer: what is solid, the property, the materials.
void grade_picture_look(grade_picture *picture, uint32_t k, sf_slice solid, const double *values,
                        const uint8_t *ids);

// Draw what was seen of a property.
exit_status grade_picture_draw(cli_job *job, const grade_picture *picture, const materials *m,
                               const sf_property *property, canvas *to);

#endif
