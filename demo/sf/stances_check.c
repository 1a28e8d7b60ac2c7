// SPDX-License-Identifier: MIT
// Whether what a model is to rest on or hang from lies where the model is. A slip of a unit or of
// an axis puts it elsewhere; so who is refused is told where the model lies.

#include "stances_check.h"

#include "extent.h"

#include <math.h>

// How far a place lies from the surface: one voxel around it, small enough to be a point.
static sf_status measure_gap(cli_job *job, const part *p, double pitch_mm, const double at[3],
                             double *gap)
{
    double edge = 1e-4 * pitch_mm;
    sf_lattice one = {1, 1, 1, edge, edge, edge, NULL, {at[0], at[1], at[2]}};
    sf_grid *grid = NULL;
    sf_status status = sf_grid_create(&one, NULL, &grid);
    if (status == SF_OK) {
        status = sf_slice_set(sf_grid_slice(grid, 0), 0, 0, 1);
    }
    if (status == SF_OK) {
        status = sf_grid_clearance(grid, sf_mesh_get_view(p->mesh), NULL, &job->task, gap);
    }
    sf_grid_destroy(grid);
    return status;
}

static int is_inside(const part *p, const double at[3])
{
    sf_lattice l = sf_grid_lattice(p->grid);
    const double edge[3] = {l.pitch_x_mm, l.pitch_y_mm, l.layer_mm};
    const uint32_t count[3] = {l.nx, l.ny, l.nz};
    uint32_t voxel[3];
    for (int i = 0; i < 3; i++) {
        double v = floor((at[i] - l.origin_mm[i]) / edge[i]);
        if (!(v >= 0 && v < count[i])) {
            return 0;
        }
        voxel[i] = (uint32_t)v;
    }
    return sf_slice_get(sf_grid_slice(p->grid, voxel[2]), voxel[0], voxel[1]);
}

static exit_status check_string(cli_job *job, const part *p, const sf_stance_options *s)
{
    double gap = 0, pitch = sf_grid_lattice(p->grid).pitch_x_mm;
    char words[EXTENT_WORDS_SIZE];
    if (is_inside(p, s->point_mm)) {
        return EXIT_GOOD;
    }
    sf_status status = measure_gap(job, p, pitch, s->point_mm, &gap);
    if (status != SF_OK) {
        return job_fail_call(job, status, NULL, "the point it hangs from", EXIT_INPUT);
    }
    extent_words(job, p, words);
    return gap <= pitch ? EXIT_GOOD
                        : job_fail(job, EXIT_INPUT,
                                   "The point that it is to hang from lies %.3g mm outside of the "
                                   "model, which spans %s; give one on its surface.",
                                   gap, words);
}

// The library asks for a vertex of a triangle; any other is none.
static exit_status check_contacts(cli_job *job, const part *p, const sf_stance_options *s)
{
    sf_mesh_view mesh = sf_mesh_get_view(p->mesh);
    char words[EXTENT_WORDS_SIZE];
    for (size_t i = 0; i < 3 * mesh.triangle_count; i++) {
        const double *v = mesh.vertices + 3 * (size_t)mesh.triangles[i];
        int is_in = 1;
        for (int d = 0; d < 3; d++) {
            is_in = is_in && v[d] >= s->region_low_mm[d] && v[d] <= s->region_high_mm[d];
        }
        if (is_in) {
            return EXIT_GOOD;
        }
    }
    extent_words(job, p, words);
    return job_fail(job, EXIT_INPUT,
                    "No vertex of the model lies where it may touch the ground (--contacts, or "
                    "low_mm and high_mm of the stance); the model spans %s.",
                    words);
}

exit_status stances_check(cli_job *job, const part *p, const stances *s)
{
    exit_status status = EXIT_GOOD;
    for (size_t i = 0; status == EXIT_GOOD && i < s->count; i++) {
        status = s->each[i].kind == SF_STANCE_HANG ? check_string(job, p, &s->each[i])
                                                   : check_contacts(job, p, &s->each[i]);
    }
    return status;
}
