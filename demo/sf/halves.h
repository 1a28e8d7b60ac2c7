// SPDX-License-Identifier: MIT
// A model cut in two, so that it can be opened.

#ifndef DEMO_SF_HALVES_H
#define DEMO_SF_HALVES_H

#include "part.h"

enum { HALVES_PATH_SIZE = 4096 };

typedef struct halves {
    sf_mesh *mesh[2];     // with the lower coordinates, and the other; NULL where none was made
    double at_mm;         // where they were cut
    double volume_mm3[2]; // of each
    size_t shut;          // cavities that the cut did not open
    int missed;           // whether the plane leaves nothing on one side
} halves;

// Refuse, before any work is done, a --cut without a mesh to be written.
exit_status halves_check(cli_job *job, int writes_mesh);

// Refuse a plane that leaves nothing of the part on one side. A stack's size is not known yet.
exit_status halves_check_part(cli_job *job, const part *p);

// Cut a mesh in the axes of the input where --cut says, for a file of a format. What changed so
// much that the plane misses it is not cut, and a warning says so.
exit_status halves_make(cli_job *job, const sf_mesh *whole, sf_mesh_format format, halves *h);

// The name of a half that goes with a mesh: "a/part.stl" has "a/part_low.stl" and
// "a/part_high.stl".
exit_status halves_name(cli_job *job, const char *path, int is_high, char name[HALVES_PATH_SIZE]);

// An object "halves", and sentences.
void halves_report(cli_job *job, const halves *h, const char *low, const char *high);

void halves_release(halves *h);

#endif
