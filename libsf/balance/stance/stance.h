// SPDX-License-Identifier: MIT
// What the files that make up a stance share.

#ifndef SF_BALANCE_STANCE_H
#define SF_BALANCE_STANCE_H

#include <sf/stance.h>

#define SFI_HALF_PI 1.5707963267948966
// The largest tilt that a stance may ask for: 80 degrees.
#define SFI_TILT_MAX (80 * 0.017453292519943295)
// Of the diagonal: how close above the lowest vertex others touch the ground.
#define SFI_CONTACT_SHARE 1e-6

struct sf_stance {
    sf_allocator allocator;
    sf_stance_options options; // `up` of length 1, nothing 0 that stands for something else
    double east[3], north[3];  // with up, right-handed and of length 1
    double low[3], extent[3], diagonal_mm; // the mesh's box
    double ground_mm;
    int is_over_edge;    // whether the mesh goes on below the ground
    size_t vertex_count; // of the mesh
    uint32_t *contacts;
    size_t contact_count;
    double *polygon; // three a corner
    size_t polygon_count, polygon_capacity;
    double *corners; // rocking: of the hull, three numbers each
    size_t corner_count;
    sf_halfspace *halfspaces;
    size_t halfspace_count, halfspace_capacity;
};

// An edge of the support polygon, and the direction that leads inside from it, on the ground.
typedef struct sfi_edge {
    double from[3], to[3], inward[3];
} sfi_edge;

// As many edges as corners; for a segment both sides and both ends, for a point the four sides of a
// square without extent.
size_t sfi_edge_count(const sf_stance *stance);
sfi_edge sfi_edge_get(const sf_stance *stance, size_t index);

// Whether it is a place within 1e12 mm; whether it is a direction of numbers whose length neither
// overflows nor vanishes when it is squared.
int sfi_is_place(const double at[3]);
int sfi_is_direction(const double v[3]);

// Check a mesh, and find the lower corner and the extent of its box.
sf_status sfi_mesh_box(sf_mesh_view mesh, double low[3], double extent[3], sf_fault *fault);

// The vertices inside of a box, x, y, z after each other; at least one. SF_ERR_MEMORY.
sf_status sfi_gather(sf_mesh_view mesh, const double low[3], const double high[3],
                     const sf_allocator *allocator, double **points, size_t *count);

// Find ground, contacts and polygon of a mesh that is valid and has its box in the stance.
sf_status sfi_stance_touch(sf_stance *stance, sf_mesh_view mesh, sf_fault *fault);

// The half-spaces of each kind, into an empty list. SF_ERR_MEMORY leaves it empty.
sf_status sfi_stand_bound(sf_stance *stance);
sf_status sfi_hang_bound(sf_stance *stance);
sf_status sfi_rock_bound(sf_stance *stance, sf_mesh_view mesh, sf_fault *fault);

// The margin, the edge, and whether it stands; `safe` is what the half-spaces say, and may only be
// taken back.
void sfi_stand_judge(const sf_stance *stance, const double com[3], sf_stance_verdict *verdict);
void sfi_hang_judge(const sf_stance *stance, const double com[3], sf_stance_verdict *verdict);
sf_status sfi_rock_judge(const sf_stance *stance, const double com[3], sf_stance_verdict *verdict);

// Room for so many half-spaces. SF_ERR_MEMORY.
sf_status sfi_stance_reserve(sf_stance *stance, size_t count);

// Add the half-space normal . c >= normal . through + least, the normal brought to length 1.
void sfi_stance_bound(sf_stance *stance, const double normal[3], const double through[3],
                      double least);

// The tilt at which a centre of mass that lies so far inside of an edge and so high above the
// ground is straight above the edge.
double sfi_tipping(double inside, double height);

// Two directions that with an up of length 1 make a right-handed frame of length 1.
void sfi_frame_around(const double up[3], double east[3], double north[3]);

// The angle between two directions, neither of them 0; in [0, pi].
double sfi_tilt(const double a[3], const double b[3]);

// Cosine of i thirty-seconds of a turn; of i - 8, the sine.
double sfi_cosine(int i);

// Length of a vector, and the vector brought to length 1; 0 stays 0.
double sfi_length(const double a[3]);
void sfi_normalize(double a[3]);

#endif
