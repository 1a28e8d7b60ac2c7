// SPDX-License-Identifier: MIT
// The check of a whole grid: the streaming check, pushed layer by layer.
//
// What the stream asks of its caller is settled here. Memory comes from an allocator. The number of
// runs of lost matter, which nobody knows beforehand, starts at a guess and grows eightfold until
// all fit; the pass is begun anew at the first run that does not, so what was spent on smaller
// guesses is little. As many runs as a slice has voxels always suffice. Findings go to an array of
// the check's own first, so that a cancelled check leaves the caller's as it was.

#include "base/memory.h"
#include "base/status.h"
#include "base/task.h"
#include "support/check/finding.h"
#include "support/rule/rule.h"

#define FIRST_GUESS 262144u

// One call of sf_grid_check().
typedef struct whole {
    const sf_grid *grid;
    sf_check_options options;
    sf_task *task;
    sfi_progress progress;
    sf_check_report report;
    size_t finding_count;
} whole;

// Push all layers; with `all_runs`, stop at the first layer whose runs do not fit.
static sf_status push_all(whole *w, sf_checker *checker, int all_runs)
{
    uint32_t nz = sf_grid_lattice(w->grid).nz;
    for (uint32_t k = 0; k < nz; k++) {
        if (sf_task_is_cancelled(w->task)) {
            return SF_ERR_CANCELLED;
        }
        SF_TRY(sf_checker_push(checker, sf_grid_slice(w->grid, k)));
        SF_TRY(sf_checker_report(checker, &w->report, &w->finding_count));
        if (all_runs && w->report.runs_dropped > 0) {
            return SF_OK;
        }
        sfi_progress_report(&w->progress, k + 1, nz);
    }
    return SF_OK;
}

// One pass with room for this many runs.
static sf_status pass(whole *w, const sf_allocator *allocator, uint32_t run_capacity, int all_runs)
{
    size_t size;
    w->options.run_capacity = run_capacity;
    SF_TRY(sf_checker_size(&w->options, &size));
    void *memory = sfi_alloc_array(allocator, size / SFI_ALIGN, SFI_ALIGN);
    if (memory == NULL) {
        return SF_ERR_MEMORY;
    }
    sf_checker *checker;
    sf_status status = sf_checker_place(&w->options, memory, size, &checker);
    if (status == SF_OK) {
        status = push_all(w, checker, all_runs);
    }
    sfi_free_array(allocator, memory, size / SFI_ALIGN, SFI_ALIGN);
    return status;
}

static sf_status pass_until_all_fit(whole *w, const sf_allocator *allocator)
{
    uint64_t most = (uint64_t)w->options.width * w->options.height;
    most = most < SFI_FINDING_MAX ? most : SFI_FINDING_MAX;
    uint64_t guess = FIRST_GUESS;
    for (;;) {
        guess = guess < most ? guess : most;
        SF_TRY(pass(w, allocator, (uint32_t)guess, guess < most));
        if (guess == most || w->report.runs_dropped == 0) {
            return SF_OK;
        }
        guess *= 8;
    }
}

static sf_status check(whole *w, const sf_allocator *allocator)
{
    return w->options.run_capacity > 0 ? pass(w, allocator, w->options.run_capacity, 0)
                                       : pass_until_all_fit(w, allocator);
}

// The caller's options, for this grid.
static sf_status take_options(whole *w, const sf_check_options *options)
{
    sf_lattice lattice = sf_grid_lattice(w->grid);
    size_t size;
    if (options->struct_size < sizeof *options ||
        (options->bed_layer != SF_BED_AUTO && options->bed_layer >= lattice.nz)) {
        return SF_ERR_ARGUMENT;
    }
    w->options = *options;
    w->options.width = lattice.nx;
    w->options.height = lattice.ny;
    w->options.first_layer = 0;
    SF_TRY(sfi_rule_check(&w->options.rule, 0, lattice.nz));
    return sf_checker_size(&w->options, &size);
}

sf_status sf_grid_check(const sf_grid *grid, const sf_check_options *options,
                        const sf_allocator *allocator, sf_task *task, sf_check_report *report,
                        size_t *finding_count)
{
    if (grid == NULL || options == NULL || report == NULL) {
        return SF_ERR_ARGUMENT;
    }
    whole w = {.grid = grid, .task = task, .progress = sfi_progress_begin(task)};
    SF_TRY(take_options(&w, options));
    sf_allocator memory = sfi_allocator_or_default(allocator);
    size_t capacity = options->finding_capacity;
    if (capacity > 0) {
        w.options.findings = sfi_alloc_array(&memory, capacity, sizeof *w.options.findings);
        if (w.options.findings == NULL) {
            return SF_ERR_MEMORY;
        }
    }
    sf_status status = check(&w, &memory);
    for (size_t i = 0; status == SF_OK && i < w.finding_count; i++) {
        options->findings[i] = w.options.findings[i];
    }
    if (capacity > 0) {
        sfi_free_array(&memory, w.options.findings, capacity, sizeof *w.options.findings);
    }
    SF_TRY(status);
    *report = w.report;
    if (finding_count != NULL) {
        *finding_count = w.finding_count;
    }
    return SF_OK;
}
