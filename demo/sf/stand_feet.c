// SPDX-License-Identifier: MIT
// Feet: whether they have to be put flat at all.
//
// What is within a hundredth of the height from the ground counts as a foot and is put onto it,
// because the feet of models are seldom flat; so a model stands on more, and more safely, than it
// was modelled to. One that is safe on the few corners that really touch the ground needs none of
// that, and whoever made it wants it back as it was.

#include "stand_feet.h"

#include <math.h>

sf_status stand_weigh(cli_job *job, const model *m, double com_mm[3])
{
    sf_body body;
    sf_status status = m->densities.each != NULL
                           ? sf_grid_body(m->part.grid, m->densities.each, &job->task, &body)
                           : sf_mesh_body(sf_mesh_get_view(m->part.mesh), m->densities.all, &body);
    if (status == SF_OK) {
        body = sf_body_add(body, 1, sf_ballast_body(m->densities.masses, m->densities.mass_count));
        status = sf_body_com(body, com_mm);
    }
    return status;
}

// One stance on the corners that touch the ground as they are.
static sf_status judge(const model *m, size_t i, const double com_mm[3], sf_stance_verdict *v,
                       sf_fault *fault)
{
    sf_stance *stance = NULL;
    sf_stance_options asked = m->stances.each[i];
    asked.contact_mm = 0;
    sf_status status =
        sf_stance_create(sf_mesh_get_view(m->part.mesh), &asked, NULL, &stance, fault);
    if (status == SF_OK) {
        status = sf_stance_judge(stance, com_mm, v);
    }
    sf_stance_destroy(stance);
    return status;
}

exit_status stand_feet(cli_job *job, model *m)
{
    double com[3];
    int is_safe = 1;
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_status status = stand_weigh(job, m, com);
    m->modelled_rad = INFINITY;
    for (size_t i = 0; status == SF_OK && i < m->stances.count; i++) {
        sf_stance_verdict v;
        status = judge(m, i, com, &v, &fault);
        if (status == SF_OK) {
            is_safe = is_safe && v.safe;
            m->modelled_rad = fmin(m->modelled_rad, v.margin_rad);
        }
    }
    for (size_t i = 0; status == SF_OK && is_safe && i < m->stances.count; i++) {
        m->stances.each[i].contact_mm = 0;
    }
    return status == SF_OK ? EXIT_GOOD
                           : job_fail_call(job, status, &fault, job->options.input, EXIT_INPUT);
}
