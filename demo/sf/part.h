// SPDX-License-Identifier: MIT
// The part that a verb works on: read, turned upright, sized, and put on a lattice.

#ifndef DEMO_SF_PART_H
#define DEMO_SF_PART_H

#include "job.h"

#include <sf/job.h>

// Where a part came from.
typedef enum part_kind { PART_MESH, PART_STACK, PART_SCENE, PART_JOB } part_kind;

typedef struct part {
    part_kind kind;
    sf_mesh *mesh;             // in build axes (z up) and mm; NULL unless read from a mesh
    sf_mesh *inner;            // a cavity to be taken from it, or NULL
    sf_transform to_build;     // from the axes and unit of the input to build axes and mm
    sf_grid *grid;             // NULL until part_voxelize()
    sf_job *layers;            // a printer's job, which is open, or NULL
    sf_file *file;             // what it is read from
    sf_lattice lattice;        // its lattice
    uint64_t solid_voxels;     // of a job that was judged without a grid
    double volume_mm3;         // the same
    int own_rule, own_bridges; // whether these are the stack's, and not of the command line
    int has_rule;              // whether part_make_rule() was called
    sf_rule rule;
    uint64_t *table;    // the rule's numbers
    uint32_t bed_layer; // SF_BED_AUTO unless --bed was given or the stack names one
    uint32_t lift;      // layers that were added below the part to reach the bed
} part;

// Read the input, whatever it is. A stack or a scene has its grid afterwards, a mesh has none.
exit_status part_read(cli_job *job, part *p);

// The same, but a printer's job is only opened: part_voxelize() reads it.
exit_status part_open(cli_job *job, part *p);

// Where its voxels lie; their volume, all together and each in the mean.
sf_lattice part_lattice(const part *p);
double part_volume_mm3(const part *p);
double part_voxel_mm3(const part *p);

// Choose a lattice and fill a grid; nothing to do for a stack or a scene.
exit_status part_voxelize(cli_job *job, part *p);

// The rule that was asked for, on the part's lattice, and the bed.
exit_status part_make_rule(cli_job *job, part *p);

// The terms that the part is judged by: its rule and its bed, no masks.
sf_terms part_terms(const part *p);

// Read a mesh file as it is.
exit_status part_load_mesh(cli_job *job, const char *path, sf_mesh **mesh);

// Map from build axes back to the axes of the input.
sf_transform part_to_input(const cli_job *job);

void part_release(part *p);

#endif
