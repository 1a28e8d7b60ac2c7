// SPDX-License-Identifier: MIT
// The layers of a model that was made to stand, and the certificate of them.
//
// They are the voxels that the carving chose, in build axes, with the rule that it went by: what a
// printer gets, and what somebody can check who does not believe the report. As for `sf hollow`,
// the certificate exempts what hangs in the solid shape: it bears witness that carving added
// nothing to that. What the paper's carving leaves hanging has no such witness, so it is not asked
// for one.

#include "stand_layers.h"

#include "certify.h"
#include "output.h"

#include <stdlib.h>
#include <string.h>

exit_status stand_layers_check(cli_job *job)
{
    const cli_options *asked = &job->options;
    const char *why = NULL;
    if ((asked->layers != NULL || asked->certificate != NULL) && asked->output == NULL) {
        why = "--layers and --certificate go with the meshes: say -o PREFIX as well.";
    } else if (asked->certificate != NULL && asked->layers == NULL) {
        why = "--certificate is of layers: say --layers FOLDER as well.";
    } else if (asked->certificate != NULL && asked->stand.carve == SF_CARVE_PLANE) {
        why = "What --carve paper leaves hanging cannot be certified: leave out --certificate.";
    }
    if (why != NULL) {
        return job_fail(job, EXIT_USAGE, "%s", why);
    }
    exit_status status = EXIT_GOOD;
    if (asked->layers != NULL) {
        status = output_probe(job, asked->layers, OUTPUT_STACK);
    }
    if (status == EXIT_GOOD && asked->certificate != NULL) {
        status = output_probe(job, asked->certificate, OUTPUT_MESH);
    }
    return status;
}

static exit_status fail(cli_job *job, sf_status status)
{
    return job_fail_call(job, status, NULL, "the layers", EXIT_RESOURCE);
}

// The shape without a cavity.
static sf_status make_solid(cli_job *job, const model *m, sf_grid **solid)
{
    sf_lattice lattice = sf_grid_lattice(sf_stand_grid(m->stand));
    sf_voxelize_options how = sf_voxelize_options_default();
    how.fill = SF_FILL_WINDING;
    sf_status status = sf_grid_create(&lattice, NULL, solid);
    return status == SF_OK
               ? sf_grid_voxelize(*solid, sf_stand_outer(m->stand), &how, NULL, &job->task, NULL)
               : status;
}

static exit_status certify(cli_job *job, const part *bent, const sf_grid *carved,
                           sf_save **certificate)
{
    change done;
    sf_terms terms = part_terms(bent);
    if (job->options.certificate == NULL) {
        return EXIT_GOOD;
    }
    exit_status status = change_begin(job, bent, &terms, &done);
    if (status != EXIT_GOOD) {
        return status;
    }
    sf_lattice lattice = sf_grid_lattice(carved);
    sf_status copied = SF_OK;
    for (uint32_t k = 0; copied == SF_OK && k < lattice.nz; k++) {
        sf_slice from = sf_grid_slice(carved, k);
        copied = sf_slice_and(sf_grid_slice(done.after, k), from, from);
    }
    status = copied == SF_OK ? certify_begin(job, bent, &done, certificate) : fail(job, copied);
    change_release(&done);
    return status;
}

exit_status stand_layers_begin(cli_job *job, const model *m, stand_layers *made)
{
    const sf_grid *carved = m->drilled.after != NULL ? m->drilled.after : sf_stand_grid(m->stand);
    part bent;
    memset(made, 0, sizeof *made);
    if (job->options.layers == NULL) {
        return EXIT_GOOD;
    }
    memset(&bent, 0, sizeof bent);
    bent.bed_layer = SF_BED_AUTO;
    sf_status solid = make_solid(job, m, &bent.grid);
    exit_status status = solid == SF_OK ? part_make_rule(job, &bent) : fail(job, solid);
    if (status == EXIT_GOOD) {
        status = certify(job, &bent, carved, &made->certificate);
    }
    if (status == EXIT_GOOD) {
        status = output_begin_stack(job, &bent, carved, job->options.layers, &made->folder);
    }
    sf_grid_destroy(bent.grid);
    free(bent.table);
    if (status != EXIT_GOOD) {
        stand_layers_abort(made);
    }
    return status;
}

exit_status stand_layers_commit(cli_job *job, stand_layers *made)
{
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_status status = SF_OK;
    const char *path = job->options.layers;
    if (made->folder != NULL) {
        status = sf_directory_commit(made->folder, &fault);
        made->folder = NULL;
    }
    if (status == SF_OK && made->certificate != NULL) {
        path = job->options.certificate;
        status = sf_save_commit(made->certificate, &fault);
        made->certificate = NULL;
    }
    stand_layers_abort(made);
    return status == SF_OK ? EXIT_GOOD : job_fail_call(job, status, &fault, path, EXIT_RESOURCE);
}

void stand_layers_abort(stand_layers *made)
{
    if (made->folder != NULL) {
        sf_directory_close(made->folder);
    }
    sf_save_abort(made->certificate);
    memset(made, 0, sizeof *made);
}
