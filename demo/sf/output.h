// SPDX-License-Identifier: MIT
// Files that a verb writes: a mesh, a folder with a stack, a picture, a report. Each appears whole
// or not at all.

#ifndef DEMO_SF_OUTPUT_H
#define DEMO_SF_OUTPUT_H

#include "canvas.h"
#include "part.h"

// What the name of an output asks for.
typedef enum output_kind {
    OUTPUT_MESH,
    OUTPUT_STACK,
    OUTPUT_PICTURE,
    OUTPUT_JOB,
    OUTPUT_UNKNOWN
} output_kind;

// Judge by the name: .stl, .obj, .ply, .3mf; .png; .sl1; a folder is there, ends with a slash, or
// has no
// extension.
output_kind output_kind_of(const char *path);

// Refuse, before any work is done, an -o that a verb cannot write, or nobody.
exit_status output_check(cli_job *job, int mesh_allowed);

// Whether a file of that name, or for OUTPUT_STACK a folder, could be written now; nothing stays of
// the attempt. NULL can.
exit_status output_probe(cli_job *job, const char *path, output_kind kind);

// What smoothing did to support: voxelise a mesh that will be written, in build axes, and look. An
// object of the name `key` says it.
exit_status output_look_at_smoothed(cli_job *job, const part *p, const sf_mesh *mesh,
                                    const char *key);

// The surface of a grid on the part's lattice, in the axes of the input. Where it is smoothed, an
// object of the name `key` says what that did to it. The caller frees it, whatever is returned.
exit_status output_make_mesh(cli_job *job, const part *p, const sf_grid *grid, const char *key,
                             sf_mesh **mesh);

// Write a mesh as it is.
exit_status output_write_mesh(cli_job *job, const sf_mesh *mesh, const char *path);

// Write that surface, or the grid's slices.
exit_status output_save_mesh(cli_job *job, const part *p, const sf_grid *grid, const char *path,
                             const char *key);
exit_status output_save_stack(cli_job *job, const part *p, const sf_grid *grid, const char *path);

// The slices in a folder that has no name yet: sf_directory_commit() gives it its name.
exit_status output_begin_stack(cli_job *job, const part *p, const sf_grid *grid, const char *path,
                               sf_directory **directory);

// The one of the two that the name asks for.
exit_status output_save(cli_job *job, const part *p, const sf_grid *grid, const char *path);

exit_status output_save_picture(cli_job *job, const canvas *picture, const char *path);
exit_status output_save_report(cli_job *job, const char *path);

#endif
