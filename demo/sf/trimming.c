// SPDX-License-Identifier: MIT
// Trimming the part, and looking again.
//
// What is reported is what a check of the result and a comparison of both grids found, not what the
// trim promised.

#include "trimming.h"

#include "describe.h"
#include "judgement.h"
#include "progress.h"

// How many voxels are solid in one grid and not in another of the same lattice.
static uint64_t count_missing(const sf_grid *here, const sf_grid *there)
{
    uint64_t count = 0;
    for (uint32_t k = 0; k < sf_grid_lattice(here).nz; k++) {
        sf_slice a = sf_grid_slice(here, k), b = sf_grid_slice(there, k);
        for (uint32_t y = 0; y < a.height; y++) {
            for (size_t w = 0; w < ((size_t)a.width + 63) / 64; w++) {
                uint64_t word = a.words[y * a.stride + w] & ~b.words[y * b.stride + w];
                for (; word != 0; word &= word - 1) {
                    count++;
                }
            }
        }
    }
    return count;
}

static void report_fields(report *r, const char *key, const sf_grid *before, const sf_grid *after,
                          int support_free)
{
    if (key != NULL) {
        report_begin(r, key);
    }
    report_count(r, "kept_voxels", sf_grid_popcount(after));
    report_count(r, "removed_voxels", count_missing(before, after));
    report_count(r, "added_voxels", count_missing(after, before));
    report_number(r, "volume_mm3", describe_volume(after));
    report_flag(r, "support_free", support_free);
    if (key != NULL) {
        report_end(r);
    }
}

static void say(report *r, double before_mm3, double after_mm3)
{
    if (before_mm3 == after_mm3) {
        report_say(r, "It prints without supports as it is; nothing was taken away.");
    } else {
        char taken[DESCRIBE_MM3_SIZE], left[DESCRIBE_MM3_SIZE];
        report_say(r,
                   "Trimming took %s away (%.3g %%) and left %s, which print without "
                   "supports.",
                   describe_mm3(before_mm3 - after_mm3, taken),
                   100 * (before_mm3 - after_mm3) / before_mm3, describe_mm3(after_mm3, left));
    }
}

exit_status trim_part(cli_job *job, part *p, const char *key, sf_check_report *after,
                      sf_grid **before)
{
    sf_trim_report done;
    *before = NULL;
    sf_status status = sf_grid_clone(p->grid, NULL, before);
    if (status != SF_OK) {
        return job_fail_call(job, status, NULL, "a second grid", EXIT_RESOURCE);
    }
    progress_phase("trimming");
    status = sf_grid_trim(p->grid, &p->rule, p->bed_layer, &job->task, &done);
    if (status == SF_OK) {
        progress_phase("checking");
        status = count_unsupported(job, p, p->grid, after);
    }
    if (status != SF_OK) {
        return job_fail_call(job, status, NULL, "the trim", EXIT_INPUT);
    }
    report_fields(job->report, key, *before, p->grid, after->support_free);
    say(job->report, describe_volume(*before), describe_volume(p->grid));
    return EXIT_GOOD;
}
