// SPDX-License-Identifier: MIT
// Masks: where an operator must keep what there is, where it may add nothing, and what is to go.
//
// A mask is a mesh, because that is what people can draw, and it lies where the part lies in their
// drawing. So it is turned and sized by the very map that the part was, --size included, whose
// factor comes from the part's own length and not from the mask's.

#include "masks.h"

#include "progress.h"

#include <string.h>

typedef struct mask {
    const char *option; // with its dashes
    const char *field;  // its voxels, in the report
    const char *path;   // NULL where it was not given
    sf_grid **grid;
} mask;

// The sentence names the option; the file it names already.
static exit_status fail(cli_job *job, const mask *m, exit_status status)
{
    char why[sizeof job->message];
    if (status == EXIT_CANCELLED) {
        return status;
    }
    memcpy(why, job->message, sizeof why);
    return job_fail(job, status, "%s: %.600s", m->option, why);
}

static void report_mask(cli_job *job, const mask *m, const sf_voxelize_report *done)
{
    report_count(job->report, m->field, done->solid_voxels);
    if (done->solid_voxels == 0) {
        job_warn(job,
                 "%s %s: No voxel of the part's lattice lies in it, so it changes nothing; it must "
                 "lie where the part does, in the same axes and units.",
                 m->option, m->path);
    } else if (done->boundary_edges > 0) {
        job_warn(job, "%s %s: The mesh is not closed (%llu open edges).", m->option, m->path,
                 (unsigned long long)done->boundary_edges);
    }
}

static exit_status voxelize(cli_job *job, const part *p, const mask *m, const sf_mesh *mesh)
{
    sf_lattice lattice = sf_grid_lattice(p->grid);
    sf_voxelize_report done;
    progress_phase("turning a mask into voxels");
    sf_status status = sf_grid_create(&lattice, NULL, m->grid);
    if (status == SF_OK) {
        status = sf_grid_voxelize(*m->grid, sf_mesh_get_view(mesh), NULL, NULL, &job->task, &done);
    }
    if (status != SF_OK) {
        return fail(job, m, job_fail_call(job, status, NULL, m->path, EXIT_INPUT));
    }
    report_mask(job, m, &done);
    return EXIT_GOOD;
}

static exit_status read_mask(cli_job *job, const part *p, const mask *m)
{
    sf_mesh *mesh = NULL;
    exit_status status = part_load_mesh(job, m->path, &mesh);
    if (status != EXIT_GOOD) {
        return fail(job, m, status);
    }
    sf_status turned = sf_mesh_transform(mesh, &p->to_build);
    status = turned == SF_OK ? voxelize(job, p, m, mesh)
                             : fail(job, m, job_fail_call(job, turned, NULL, m->path, EXIT_INPUT));
    sf_mesh_destroy(mesh);
    return status;
}

exit_status masks_read(cli_job *job, const part *p, masks *m)
{
    const cli_options *asked = &job->options;
    const mask all[] = {{"--keep", "keep_mask_voxels", asked->keep, &m->keep},
                        {"--forbid", "forbid_mask_voxels", asked->forbid, &m->forbid},
                        {"--remove", "remove_mask_voxels", asked->remove, &m->brush}};
    exit_status status = EXIT_GOOD;
    memset(m, 0, sizeof *m);
    for (size_t i = 0; i < sizeof all / sizeof all[0] && status == EXIT_GOOD; i++) {
        if (all[i].path != NULL) {
            status = read_mask(job, p, &all[i]);
        }
    }
    return status;
}

sf_terms masks_terms(const part *p, const masks *m)
{
    sf_terms terms = part_terms(p);
    terms.keep = m->keep;
    terms.forbid = m->forbid;
    return terms;
}

void masks_release(masks *m)
{
    sf_grid_destroy(m->keep);
    sf_grid_destroy(m->forbid);
    sf_grid_destroy(m->brush);
    memset(m, 0, sizeof *m);
}
