// SPDX-License-Identifier: MIT
// A part changed so that it prints, and looked at again.
//
// What is reported is what a check of the result and a comparison of both grids found, not what the
// operator promised. The operator works on a copy; the part stays as it came, for the comparison,
// for the certificate, and for the next operator.

#include "change.h"

#include "describe.h"
#include "judgement.h"
#include "operators.h"
#include "place.h"
#include "progress.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

// ---------------------------------------------------------------------------------------------
// Comparing
// ---------------------------------------------------------------------------------------------

static uint64_t count_bits(uint64_t word)
{
    uint64_t count = 0;
    for (; word != 0; word &= word - 1) {
        count++;
    }
    return count;
}

// Voxels of a slice that are solid in one grid and not in another of the same lattice.
static uint64_t count_missing(sf_slice here, sf_slice there)
{
    uint64_t count = 0;
    for (uint32_t y = 0; y < here.height; y++) {
        for (size_t w = 0; w < ((size_t)here.width + 63) / 64; w++) {
            count +=
                count_bits(here.words[y * here.stride + w] & ~there.words[y * there.stride + w]);
        }
    }
    return count;
}

static void compare(const sf_grid *before, change *made)
{
    sf_lattice lattice = sf_grid_lattice(before);
    for (uint32_t k = 0; k < lattice.nz; k++) {
        sf_slice a = sf_grid_slice(before, k), b = sf_grid_slice(made->after, k);
        uint64_t removed = count_missing(a, b), added = count_missing(b, a);
        double voxel_mm3 =
            lattice.pitch_x_mm * lattice.pitch_y_mm * sf_lattice_layer_height(&lattice, k);
        made->removed_voxels += removed;
        made->added_voxels += added;
        if (made->accepted != NULL) {
            sf_slice hung = sf_grid_slice(made->accepted, k);
            made->accepted_voxels += sf_slice_popcount(hung) - count_missing(hung, b);
        }
        made->removed_mm3 += voxel_mm3 * (double)removed;
        made->added_mm3 += voxel_mm3 * (double)added;
    }
    made->kept_voxels = sf_grid_popcount(before) - made->removed_voxels;
    made->before_mm3 = describe_volume(before);
    made->after_mm3 = describe_volume(made->after);
}

// ---------------------------------------------------------------------------------------------
// Doing
// ---------------------------------------------------------------------------------------------

static const char *what_cannot_stay(sf_operation operation)
{
    switch (operation) {
    case SF_OPERATION_TRIM:
        return "of what --keep names cannot be carried by the part alone";
    case SF_OPERATION_GROW:
        return "of the part cannot be carried, whatever may be added";
    default:
        return "of what --keep names cannot be carried, whatever may be added";
    }
}

static exit_status refuse(cli_job *job, const sf_grid *culprits, sf_operation operation)
{
    double low[3] = {0, 0, 0}, high[3] = {0, 0, 0};
    places in = {sf_grid_lattice(culprits), job->options.up};
    sf_box box = sf_grid_bounds(culprits);
    place_box(&in, &box, low, high);
    memcpy(job->culprit_low_mm, low, sizeof low);
    memcpy(job->culprit_high_mm, high, sizeof high);
    job->culprits = sf_grid_popcount(culprits);
    job->fault.status = SF_ERR_INFEASIBLE;
    return job_fail(job, EXIT_PROPERTY,
                    "%llu voxel%s %s; x %.2f to %.2f, y %.2f to %.2f, z %.2f to %.2f mm. "
                    "Nothing was written.",
                    (unsigned long long)job->culprits, job->culprits == 1 ? "" : "s",
                    what_cannot_stay(operation), low[0], high[0], low[1], high[1], low[2], high[2]);
}

// Squares of at least that many mm each way; of unequal pixels the smaller one decides.
exit_status change_width(cli_job *job, const part *p, uint32_t *width)
{
    sf_lattice lattice = sf_grid_lattice(p->grid);
    double pitch = fmin(lattice.pitch_x_mm, lattice.pitch_y_mm);
    double voxels = ceil(job->options.min_feature_mm / pitch - 1e-6);
    if (voxels > SF_REACH_MAX) {
        return job_fail(job, EXIT_USAGE,
                        "--min-feature %g is %.0f voxels of %.4g mm, and at most %u will do.",
                        job->options.min_feature_mm, voxels, pitch, SF_REACH_MAX);
    }
    *width = voxels > 1 ? (uint32_t)voxels : 1;
    return EXIT_GOOD;
}

// What hangs in the part before anything is removed may hang on: the voxels that no trim keeps.
static sf_status accept(cli_job *job, const part *p, sf_terms *terms, change *made)
{
    sf_lattice lattice = sf_grid_lattice(p->grid);
    uint64_t count = 0;
    sf_status status = sf_grid_create(&lattice, NULL, &made->accepted);
    if (status == SF_OK) {
        status =
            sf_grid_feasible(p->grid, p->grid, terms, NULL, &job->task, made->accepted, &count);
    }
    if (status == SF_ERR_INFEASIBLE) {
        terms->exempt = made->accepted;
        return SF_OK;
    }
    sf_grid_destroy(made->accepted);
    made->accepted = NULL;
    return status;
}

static exit_status apply(cli_job *job, const part *p, const order *o, change *made)
{
    sf_lattice lattice = sf_grid_lattice(p->grid);
    sf_grid *culprits = NULL;
    sf_status status = sf_grid_clone(p->grid, NULL, &made->after);
    if (status == SF_OK && operators_may_refuse(o)) {
        status = sf_grid_create(&lattice, NULL, &culprits);
    }
    if (status == SF_OK) {
        progress_phase(operators_phase(o->operation));
        status = operators_apply(o, made->after, culprits, &job->task, &made->cost);
    }
    exit_status done = EXIT_GOOD;
    if (status == SF_ERR_INFEASIBLE && culprits != NULL) {
        done = refuse(job, culprits, o->operation);
    } else if (status != SF_OK) {
        done = job_fail_call(job, status, NULL, sf_operation_name(o->operation), EXIT_PROPERTY);
    }
    sf_grid_destroy(culprits);
    return done;
}

// Look at the result under the whole rule, and then but for what was accepted.
static exit_status look_again(cli_job *job, const part *p, const sf_terms *terms, change *made)
{
    sf_check_report counts;
    progress_phase("checking");
    sf_status status = count_unsupported(job, p, made->after, &counts);
    if (status != SF_OK) {
        return job_fail_call(job, status, NULL, "the check", EXIT_RESOURCE);
    }
    made->support_free = made->holds = counts.support_free;
    if (made->accepted != NULL && !counts.support_free) {
        status = sf_grid_feasible(made->after, made->after, terms, NULL, &job->task, NULL, NULL);
        made->holds = status == SF_OK;
        if (status != SF_OK && status != SF_ERR_INFEASIBLE) {
            return job_fail_call(job, status, NULL, "the check", EXIT_RESOURCE);
        }
    }
    made->hanging_voxels = counts.trimmed_voxels;
    return EXIT_GOOD;
}

static exit_status place_order(cli_job *job, const part *p, const masks *m, order *o, change *made)
{
    o->terms = masks_terms(p, m);
    o->brush = m->brush;
    o->mode = job->options.mode;
    o->min_feature_vx = 1;
    if (o->operation == SF_OPERATION_PRESERVE) {
        sf_status status = accept(job, p, &o->terms, made);
        return status == SF_OK ? EXIT_GOOD
                               : job_fail_call(job, status, NULL, "preserve", EXIT_RESOURCE);
    }
    return job->options.min_feature_mm > 0 ? change_width(job, p, &o->min_feature_vx) : EXIT_GOOD;
}

exit_status change_begin(cli_job *job, const part *p, sf_terms *terms, change *made)
{
    sf_lattice lattice = sf_grid_lattice(p->grid);
    uint64_t count = 0;
    memset(made, 0, sizeof *made);
    made->operation = SF_OPERATION_PRESERVE;
    sf_status status = sf_grid_create(&lattice, NULL, &made->accepted);
    if (status == SF_OK) {
        status = sf_grid_unsupported(p->grid, terms, NULL, &job->task, made->accepted, &count);
    }
    if (status == SF_OK && count > 0) {
        terms->exempt = made->accepted;
    } else {
        sf_grid_destroy(made->accepted);
        made->accepted = NULL;
    }
    if (status == SF_OK) {
        status = sf_grid_clone(p->grid, NULL, &made->after);
    }
    return status == SF_OK ? EXIT_GOOD
                           : job_fail_call(job, status, NULL, "the part", EXIT_RESOURCE);
}

exit_status change_end(cli_job *job, const part *p, const sf_terms *terms, double start,
                       change *made)
{
    exit_status status = look_again(job, p, terms, made);
    if (status == EXIT_GOOD) {
        compare(p->grid, made);
        made->cost = made->added_voxels + made->removed_voxels;
        made->seconds = job_seconds(job) - start;
    }
    return status;
}

exit_status change_make(cli_job *job, const part *p, const masks *m, sf_operation operation,
                        change *made)
{
    order o = {.operation = operation};
    double start = job_seconds(job);
    memset(made, 0, sizeof *made);
    made->operation = operation;
    exit_status status = place_order(job, p, m, &o, made);
    if (status == EXIT_GOOD) {
        status = apply(job, p, &o, made);
    }
    uint64_t cost = made->cost;
    if (status == EXIT_GOOD) {
        status = change_end(job, p, &o.terms, start, made);
        made->cost = cost == UINT64_MAX ? made->cost : cost;
    }
    return status;
}

int change_is_empty(const change *made)
{
    return made->removed_voxels > 0 && made->kept_voxels + made->added_voxels == 0;
}

void change_release(change *made)
{
    sf_grid_destroy(made->after);
    sf_grid_destroy(made->accepted);
    memset(made, 0, sizeof *made);
}

// ---------------------------------------------------------------------------------------------
// Saying
// ---------------------------------------------------------------------------------------------

void change_report(report *r, const char *key, const change *made)
{
    if (key != NULL) {
        report_begin(r, key);
    }
    report_count(r, "kept_voxels", made->kept_voxels);
    report_count(r, "removed_voxels", made->removed_voxels);
    report_count(r, "added_voxels", made->added_voxels);
    report_count(r, "cost", made->cost);
    report_number(r, "volume_mm3", made->after_mm3);
    report_number(r, "removed_mm3", made->removed_mm3);
    report_number(r, "added_mm3", made->added_mm3);
    report_flag(r, "support_free", made->support_free);
    if (made->operation == SF_OPERATION_PRESERVE) {
        report_count(r, "accepted_voxels", made->accepted_voxels);
        report_count(r, "hanging_voxels", made->hanging_voxels);
    }
    if (key != NULL) {
        report_number(r, "seconds", made->seconds);
        report_end(r);
    }
}

static void say_preserved(report *r, const change *made, const char *taken)
{
    if (made->removed_voxels == 0) {
        report_say(r, "Nothing was taken away: all that --remove names carries something, is kept, "
                      "or is empty.");
    } else {
        report_say(r, "Removing took %s away, and nothing outside of --remove.", taken);
    }
    if (made->support_free) {
        report_say(r, "What is left prints without supports.");
        return;
    }
    char hung[DESCRIBE_MM3_SIZE], more[DESCRIBE_MM3_SIZE], resting[96] = "";
    double voxel_mm3 = place_voxel_mm3(made->after);
    if (made->hanging_voxels > made->accepted_voxels) {
        double added = (double)(made->hanging_voxels - made->accepted_voxels);
        snprintf(resting, sizeof resting, ", and %s more rest on that alone now",
                 describe_mm3(added * voxel_mm3, more));
    }
    report_say(r,
               "%s hung before and were accepted: they hang still%s. Everything else prints "
               "without supports.",
               describe_mm3((double)made->accepted_voxels * voxel_mm3, hung), resting);
}

void change_say(report *r, const change *made)
{
    char taken[DESCRIBE_MM3_SIZE], given[DESCRIBE_MM3_SIZE], left[DESCRIBE_MM3_SIZE];
    describe_mm3(made->removed_mm3, taken);
    describe_mm3(made->added_mm3, given);
    describe_mm3(made->after_mm3, left);
    double share = made->before_mm3 > 0 ? 100 / made->before_mm3 : 0;
    if (made->operation == SF_OPERATION_PRESERVE) {
        say_preserved(r, made, taken);
    } else if (made->removed_voxels + made->added_voxels == 0) {
        report_say(r, "It prints without supports as it is; nothing was changed.");
    } else if (made->operation == SF_OPERATION_TRIM) {
        report_say(r, "Trimming took %s away (%.3g %%) and left %s, which print without supports.",
                   taken, share * made->removed_mm3, left);
    } else if (made->operation == SF_OPERATION_GROW) {
        report_say(r, "Growing added %s (%.3g %%); all %s print without supports.", given,
                   share * made->added_mm3, left);
    } else {
        report_say(r,
                   "Repair took %s away and added %s (%.3g %% changed); the %s print without "
                   "supports.",
                   taken, given, share * (made->removed_mm3 + made->added_mm3), left);
    }
}
