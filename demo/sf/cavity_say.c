// SPDX-License-Identifier: MIT
// What there is to say of a cavity: how much came out, how thin the wall is, where the holes are
// and what they weigh, and what is shut in.

#include "cavity.h"

#include "describe.h"
#include "place.h"

#include <math.h>
#include <stdio.h>

enum { DRAINS_SAID = 6 };

static void report_drain(report *r, axis up, const sf_drain *d)
{
    double from[3], to[3];
    place_point(up, d->from_mm, from);
    place_point(up, d->to_mm, to);
    report_begin(r, NULL);
    report_numbers(r, "from_mm", from, 3);
    report_numbers(r, "to_mm", to, 3);
    report_count(r, "voxels", d->voxels);
    report_number(r, "volume_mm3", d->body.mass);
    report_count(r, "void_voxels", d->void_voxels);
    report_end(r);
}

static void report_voids(const cli_job *job, const cavity *c)
{
    report *r = job->report;
    int was_drained = job->options.drain_mm > 0;
    report_begin(r, "voids");
    report_count(r, "count", c->void_count);
    report_count(r, "voxels", c->void_voxels);
    report_count(r, "drained", c->drained.drained_count);
    report_count(r, "filled", c->drained.filled_count);
    report_count(r, "filled_voxels", c->drained.filled_voxels);
    report_count(r, "closed", was_drained ? c->drained.closed_count : c->void_count);
    report_end(r);
    report_begin_list(r, "drains");
    for (size_t i = 0; i < c->drain_count; i++) {
        report_drain(r, job->options.up, &c->drains[i]);
    }
    report_end(r);
    report_count(r, "drains_dropped", c->drained.drains_dropped);
    report_number(r, "drains_mm3", c->drained.removed.mass);
}

static void report_mass(const cli_job *job, const sf_body *body, const char *mass,
                        const char *where)
{
    report *r = job->report;
    double com[3];
    report_number(r, mass, body->mass);
    if (sf_body_com(*body, com) == SF_OK) {
        place_point(job->options.up, com, com);
        report_numbers(r, where, com, 3);
    } else {
        report_null(r, where);
    }
}

static void say_voids(cli_job *job, const cavity *c)
{
    report *r = job->report;
    char volume[DESCRIBE_MM3_SIZE];
    double voxel_mm3 = place_voxel_mm3(c->done.after);
    if (job->options.drain_mm == 0) {
        if (c->void_count > 0) {
            report_say(r, "%llu void%s shut, %s: what is in %s cannot leave; --drain MM drills.",
                       (unsigned long long)c->void_count, c->void_count == 1 ? " is" : "s are",
                       describe_mm3((double)c->void_voxels * voxel_mm3, volume),
                       c->void_count == 1 ? "it" : "them");
        }
        return;
    }
    report_say(r, "%llu of %llu voids drained by %llu hole%s of %g mm, %s in all.",
               (unsigned long long)c->drained.drained_count, (unsigned long long)c->void_count,
               (unsigned long long)c->drained.drain_count, c->drained.drain_count == 1 ? "" : "s",
               job->options.drain_mm, describe_mm3(c->drained.removed.mass, volume));
    for (size_t i = 0; i < c->drain_count && i < DRAINS_SAID; i++) {
        const sf_drain *d = &c->drains[i];
        double from[3], to[3];
        place_point(job->options.up, d->from_mm, from);
        place_point(job->options.up, d->to_mm, to);
        report_say(r, "  hole from x %.2f, y %.2f, z %.2f down to x %.2f, y %.2f, z %.2f: %s",
                   from[0], from[1], from[2], to[0], to[1], to[2],
                   describe_mm3(d->body.mass, volume));
    }
    if (c->drained.filled_count > 0) {
        report_say(r, "%llu void%s too small for a hole and filled again, %s.",
                   (unsigned long long)c->drained.filled_count,
                   c->drained.filled_count == 1 ? " was" : "s were",
                   describe_mm3((double)c->drained.filled_voxels * voxel_mm3, volume));
    }
    if (c->drained.closed_count > 0) {
        report_say(r, "%llu void%s shut: wherever a hole was tried, something would hang.",
                   (unsigned long long)c->drained.closed_count,
                   c->drained.closed_count == 1 ? " stays" : "s stay");
    }
}

static void say_support(report *r, const change *done)
{
    char hung[DESCRIBE_MM3_SIZE];
    if (done->support_free) {
        report_say(r, "What is left prints without supports.");
    } else {
        report_say(
            r,
            "%s hang in the air, as before hollowing, and need supports; hollowing adds nothing "
            "that "
            "does.",
            describe_mm3((double)done->accepted_voxels * place_voxel_mm3(done->after), hung));
    }
}

// In the unit of --density, which is whatever the person thinks in.
static void say_mass(cli_job *job, const cavity *c)
{
    char before[DESCRIBE_MM3_SIZE], after[DESCRIBE_MM3_SIZE];
    if (job->options.given & OPTION_DENSITY) {
        report_say(job->report,
                   "Solid, its %s weigh %.5g; hollow, its %s weigh %.5g, by --density %s.",
                   describe_mm3(c->done.before_mm3, before), c->before.mass,
                   describe_mm3(c->done.after_mm3, after), c->after.mass, job->options.density);
    }
}

static void say(cli_job *job, const cavity *c)
{
    report *r = job->report;
    char out[DESCRIBE_MM3_SIZE], in[DESCRIBE_MM3_SIZE], kept[64] = "";
    if (c->kept_mm3 > 0) {
        snprintf(kept, sizeof kept, "; %s stay inside to carry them",
                 describe_mm3(c->kept_mm3, in));
    }
    report_say(r, "Hollowing took %s out (%.3g %%); walls are %.4g mm or more%s.",
               describe_mm3(c->carved_mm3, out), 100 * c->carved_mm3 / c->done.before_mm3,
               c->wall_min_mm, kept);
    say_mass(job, c);
    say_support(r, &c->done);
    say_voids(job, c);
}

void cavity_report(cli_job *job, const part *p, const cavity *c)
{
    report *r = job->report;
    (void)p;
    report_number(r, "wall_mm", job->options.wall_mm);
    report_number(r, "wall_min_mm", c->wall_min_mm);
    report_count(r, "wall_voxels", c->wall_voxels);
    report_count(r, "carved_voxels", c->carved_voxels);
    report_number(r, "carved_mm3", c->carved_mm3);
    report_number(r, "kept_inside_mm3", c->kept_mm3);
    change_report(r, NULL, &c->done);
    report_voids(job, c);
    report_number(r, "solid_mm3", c->done.before_mm3);
    report_mass(job, &c->before, "mass_before", "com_before_mm");
    report_mass(job, &c->after, "mass", "com_mm");
    say(job, c);
}
