// SPDX-License-Identifier: MIT
// sf render: a picture of the part, what cannot print coloured.

#include "colored.h"
#include "describe.h"
#include "output.h"
#include "picture.h"
#include "progress.h"
#include "verbs.h"

static exit_status draw(cli_job *job, const part *p)
{
    canvas picture = {NULL, 0, 0};
    sf_grid *shape = NULL;
    double bar_mm = 0;
    sf_trim_report done;
    sf_status made = sf_grid_clone(p->grid, NULL, &shape);
    if (made == SF_OK) {
        progress_phase("checking");
        made = sf_grid_trim(p->grid, &p->rule, p->bed_layer, &job->task, &done);
    }
    if (made != SF_OK) {
        sf_grid_destroy(shape);
        return job_fail_call(job, made, NULL, "the picture", EXIT_RESOURCE);
    }
    subject what = {shape, done.removed_voxels > 0 ? p->grid : shape, picture_lost,
                    sf_grid_bounds(shape)};
    int is_colored = colored_is_asked(job->options.output);
    exit_status status = is_colored ? colored_save(job, &what, job->options.output)
                                    : picture_draw(job, &what, &picture, &bar_mm);
    if (status == EXIT_GOOD && !is_colored) {
        status = output_save_picture(job, &picture, job->options.output);
    }
    if (status == EXIT_GOOD) {
        report_count(job->report, "removed_voxels", done.removed_voxels);
        if (!is_colored) {
            report_number(job->report, "scale_bar_mm", bar_mm);
        }
        report_number(job->report, "seconds", job_seconds(job));
        report_text(job->report, "output", job->options.output);
        if (is_colored) {
            report_say(job->report, "Written to %s, what cannot print in red.",
                       job->options.output);
        } else {
            report_say(job->report, "Drawn to %s; the bar is %g mm long.", job->options.output,
                       bar_mm);
        }
    }
    canvas_destroy(&picture);
    sf_grid_destroy(shape);
    return status;
}

static exit_status render(cli_job *job, part *p)
{
    exit_status status = part_voxelize(job, p);
    if (status == EXIT_GOOD) {
        status = part_make_rule(job, p);
    }
    if (status == EXIT_GOOD) {
        describe_part(job, p, "render");
        status = draw(job, p);
    }
    return status;
}

exit_status verb_render(cli_job *job)
{
    part p;
    if (job->options.output == NULL) {
        job->options.output = "render.png";
    }
    int is_colored = colored_is_asked(job->options.output);
    if (!is_colored && output_kind_of(job->options.output) != OUTPUT_PICTURE) {
        return job_fail(job, EXIT_USAGE,
                        "-o %s: a picture's name ends in .png, a coloured mesh's in .glb.",
                        job->options.output);
    }
    if (!is_colored && !sf_stack_has_png()) {
        return job_fail(job, EXIT_USAGE, "This build draws no pictures: it was made without PNG.");
    }
    exit_status status =
        output_probe(job, job->options.output, is_colored ? OUTPUT_MESH : OUTPUT_PICTURE);
    if (status != EXIT_GOOD) {
        return status;
    }
    status = part_read(job, &p);
    if (status == EXIT_GOOD) {
        status = render(job, &p);
    }
    part_release(&p);
    return status;
}
