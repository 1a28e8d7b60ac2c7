// SPDX-License-Identifier: MIT
// Meshes of a hollow part.

#ifndef DEMO_SF_HOLLOW_MESH_H
#define DEMO_SF_HOLLOW_MESH_H

#include "cavity.h"
#include "halves.h"

// Write the part as a mesh: the input's own surface, and that of the cavity inside it. Where holes
// go through the surface, or the input has none that is closed, all of it is the voxels'. With
// --cut also its halves, which the caller releases.
exit_status hollow_save(cli_job *job, const part *p, const cavity *c, const char *path, halves *h);

// An outside and what is inside it, as it is or turned around, as one mesh. It is for the caller to
// free whatever is returned.
sf_status hollow_join(sf_mesh_view outer, sf_mesh_view inner, int turned, sf_mesh **made);

// Make, or write, the cavity alone, holes included, as a body that is to be taken from the input.
// Holes go on beyond the part by a voxel, so that they cut through its surface.
exit_status hollow_cavity_mesh(cli_job *job, const part *p, const cavity *c, sf_mesh **made);
exit_status hollow_save_cavity(cli_job *job, const part *p, const cavity *c, const char *path);

#endif
