// SPDX-License-Identifier: MIT
// A 3MF file, whose parts may bring the slices that they will be printed from.
//
// Where all that is built has slices, these are what is judged: they are what will be printed, and
// the triangles beside them may be a box that stands for the part. Layers are the file's own; only
// the pixels are chosen here.

#include "sliced.h"

#include "lattice.h"
#include "progress.h"

#include <math.h>
#include <stdlib.h>

exit_status sliced_open(cli_job *job, const char *path, sf_threemf **document)
{
    sf_file *file = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_status status = sf_file_open(path, NULL, &file, &fault);
    if (status == SF_OK) {
        progress_phase("reading");
        status = sf_threemf_read(sf_file_source(file), NULL, NULL, document, &fault);
        sf_file_close(file);
    }
    return status == SF_OK ? EXIT_GOOD : job_fail_call(job, status, &fault, path, EXIT_INPUT);
}

// The longest side of the box around a stack.
static double longest_side(const sf_contour_stack *stack)
{
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY}, bottom = 0, top = 0;
    sf_contours contours;
    for (uint32_t k = 0; k < sf_contour_stack_count(stack); k++) {
        if (sf_contour_stack_layer(stack, k, &contours, k == 0 ? &bottom : NULL, &top) != SF_OK) {
            return 0;
        }
        for (size_t i = 0; i < 2 * contours.starts[contours.contour_count]; i++) {
            low[i % 2] = fmin(low[i % 2], contours.points_mm[i]);
            high[i % 2] = fmax(high[i % 2], contours.points_mm[i]);
        }
    }
    return fmax(top - bottom, fmax(high[0] - low[0], high[1] - low[1]));
}

static exit_status choose(cli_job *job, const sf_contour_stack *stack, double *heights,
                          sf_lattice *lattice)
{
    const cli_options *asked = &job->options;
    double longest = longest_side(stack), pitch[2];
    for (int i = 0; i < 2; i++) {
        pitch[i] = (asked->given & OPTION_PITCH) ? asked->pitch_mm[i] : longest / asked->resolution;
    }
    sf_status status = sf_contour_stack_lattice(stack, pitch[0], pitch[1], heights,
                                                sf_contour_stack_count(stack), lattice);
    if (status == SF_ERR_OVERFLOW) {
        return job_fail(job, EXIT_USAGE,
                        "Pixels of %g x %g mm are too many for slices of %g mm; take a coarser "
                        "--pitch or a lower --resolution.",
                        pitch[0], pitch[1], longest);
    }
    if (status != SF_OK) {
        return job_fail(job, EXIT_INPUT, "%s: Its slices are empty; there is nothing to print.",
                        asked->input);
    }
    return lattice_check_memory(job, lattice, 0);
}

static exit_status draw(cli_job *job, const sf_contour_stack *stack, part *p)
{
    sf_lattice lattice;
    uint32_t count = sf_contour_stack_count(stack);
    double *heights = malloc((count > 0 ? count : 1) * sizeof *heights);
    exit_status status = heights != NULL ? choose(job, stack, heights, &lattice)
                                         : job_fail(job, EXIT_RESOURCE, "There is no memory.");
    if (status == EXIT_GOOD) {
        progress_phase("drawing the slices");
        sf_status made =
            sf_grid_from_contours(stack, &lattice, SF_CONTOUR_NONZERO, NULL, &job->task, &p->grid);
        status = made == SF_OK ? EXIT_GOOD
                               : job_fail_call(job, made, NULL, job->options.input, EXIT_INPUT);
    }
    free(heights);
    return status;
}

exit_status sliced_draw(cli_job *job, const sf_threemf *document, part *p)
{
    sf_contour_stack *stack = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_status made = sf_threemf_contours(document, NULL, &stack, &fault);
    if (made != SF_OK) {
        return job_fail_call(job, made, &fault, job->options.input, EXIT_INPUT);
    }
    exit_status status = draw(job, stack, p);
    uint32_t count = sf_contour_stack_count(stack);
    sf_contour_stack_destroy(stack);
    if (status == EXIT_GOOD) {
        report_count(job->report, "slices", count);
        report_say(job->report,
                   "The file has %lu slices of its own: they are the layers, and its "
                   "triangles are not looked at.",
                   (unsigned long)count);
    }
    return status;
}
