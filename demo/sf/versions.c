// SPDX-License-Identifier: MIT
// The three ways to make a part printable, side by side.
//
// Trimming loses whatever hangs, growing builds below all of it, and repair weighs the two. Which
// is right nobody but the owner of the part knows, so that all three are made and shown; the one
// that is offered as printable is the repair, which changes least. A version without matter is
// none.

#include "versions.h"

#include "describe.h"

#include <stdio.h>
#include <string.h>

static const struct {
    sf_operation operation;
    const char *name, *file;
} kinds[VERSION_COUNT] = {{SF_OPERATION_TRIM, "trim", "trimmed.stl"},
                          {SF_OPERATION_GROW, "grow", "grown.stl"},
                          {SF_OPERATION_REPAIR, "repair", "repaired.stl"}};

// The two that add take about two bytes a voxel.
static int has_memory(const cli_job *job, const part *p)
{
    sf_lattice lattice = sf_grid_lattice(p->grid);
    return 2.0 * lattice.nx * lattice.ny * lattice.nz / 1048576 <= job->options.memory_mib;
}

// What cannot be grown is a finding here, not a failure.
static void report_refusal(cli_job *job, int which)
{
    report_begin(job->report, kinds[which].name);
    report_flag(job->report, "support_free", 0);
    job_report_culprits(job, job->report);
    report_end(job->report);
    job->culprits = 0;
    job->message[0] = '\0';
    job->fault.status = SF_OK;
}

// The repair changes least; but where it takes all of the part away, that is not what one wants.
static exit_status choose(cli_job *job, versions *v)
{
    static const int order[] = {VERSION_REPAIR, VERSION_GROW, VERSION_TRIM};
    for (int i = 0; i < VERSION_COUNT; i++) {
        if (v->there[order[i]]) {
            v->printable = order[i];
            return EXIT_GOOD;
        }
    }
    return job_fail(job, EXIT_PROPERTY,
                    "Nothing is left: all of it hangs in the air, and nothing can be grown below "
                    "it. Nothing was written.");
}

exit_status versions_make(cli_job *job, const part *p, versions *v)
{
    const masks none = {NULL, NULL, NULL};
    int count = has_memory(job, p) ? VERSION_COUNT : 1;
    memset(v, 0, sizeof *v);
    if (count == 1) {
        job_warn(job, "Only trimmed: growing and repairing would take more than --memory %g.",
                 job->options.memory_mib);
    }
    for (int i = 0; i < count; i++) {
        exit_status status = change_make(job, p, &none, kinds[i].operation, &v->made[i]);
        if (status == EXIT_GOOD) {
            v->is_empty[i] = change_is_empty(&v->made[i]);
            v->there[i] = !v->is_empty[i];
            change_report(job->report, kinds[i].name, &v->made[i]);
        } else if (status == EXIT_PROPERTY && job->culprits > 0) {
            report_refusal(job, i);
        } else {
            return status;
        }
    }
    return choose(job, v);
}

const char *versions_file(const versions *v, int which)
{
    return which == v->printable ? "printable.stl" : kinds[which].file;
}

const char *versions_name(int which)
{
    return kinds[which].name;
}

const char *versions_figures(const versions *v, int which, char text[VERSIONS_FIGURES_SIZE])
{
    const change *c = &v->made[which];
    char removed[DESCRIBE_MM3_SIZE], added[DESCRIBE_MM3_SIZE];
    describe_mm3(c->removed_mm3, removed);
    describe_mm3(c->added_mm3, added);
    if (c->removed_voxels > 0 && c->added_voxels > 0) {
        snprintf(text, VERSIONS_FIGURES_SIZE, "-%s, +%s", removed, added);
    } else if (c->removed_voxels + c->added_voxels > 0) {
        snprintf(text, VERSIONS_FIGURES_SIZE, "%s%s", c->removed_voxels > 0 ? "-" : "+",
                 c->removed_voxels > 0 ? removed : added);
    } else {
        snprintf(text, VERSIONS_FIGURES_SIZE, "nothing to change");
    }
    return text;
}

void versions_say(report *r, const versions *v, const char *folder)
{
    for (int i = 0; i < VERSION_COUNT; i++) {
        const change *c = &v->made[i];
        char figures[VERSIONS_FIGURES_SIZE];
        if (!v->there[i]) {
            report_say(r, "  %-8s %s", kinds[i].name,
                       v->is_empty[i] ? "nothing would be left" : "not possible here");
            continue;
        }
        report_say(r, "  %-8s %s (%.3g %% changed): %s/%s", kinds[i].name,
                   versions_figures(v, i, figures),
                   100 * (c->removed_mm3 + c->added_mm3) / (c->before_mm3 > 0 ? c->before_mm3 : 1),
                   folder, versions_file(v, i));
    }
}

void versions_release(versions *v)
{
    for (int i = 0; i < VERSION_COUNT; i++) {
        change_release(&v->made[i]);
    }
}
