// SPDX-License-Identifier: MIT
// Voids of the part that hold what they should not, or pull at the film of a resin printer.
//
// A cup is worth a word from a quarter of a square millimetre and half a millimetre of height on:
// below that the film lets go by itself.

#include "hollows.h"

#include "describe.h"
#include "place.h"
#include "progress.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { VOIDS_MAX = 65536, VOIDS_SAID = 4, WORDS_SIZE = 96 };

#define CUP_AREA_MM2 0.25
#define CUP_HEIGHT_MM 0.5

exit_status hollows_begin(cli_job *job, hollows *h)
{
    memset(h, 0, sizeof *h);
    h->voids = malloc(VOIDS_MAX * sizeof *h->voids);
    return h->voids != NULL ? EXIT_GOOD
                            : job_fail(job, EXIT_RESOURCE, "There is no memory for the voids.");
}

sf_voids_options hollows_options(const part *p, const hollows *h)
{
    sf_lattice lattice = part_lattice(p);
    sf_voids_options options = sf_voids_options_default();
    options.bed_layer = p->bed_layer;
    options.voids = h->voids;
    options.void_capacity = VOIDS_MAX;
    options.cup_area_min =
        (uint64_t)fmin(ceil(CUP_AREA_MM2 / (lattice.pitch_x_mm * lattice.pitch_y_mm)), 1e18);
    options.cup_layers_min = (uint32_t)fmin(
        ceil(CUP_HEIGHT_MM / sf_lattice_layer_height(&lattice, 0)), (double)SF_LAYER_MAX);
    return options;
}

exit_status hollows_find(cli_job *job, const part *p, hollows *h)
{
    exit_status begun = hollows_begin(job, h);
    if (begun != EXIT_GOOD) {
        return begun;
    }
    sf_voids_options options = hollows_options(p, h);
    progress_phase("looking for voids");
    sf_status status = sf_grid_voids(p->grid, &options, NULL, &job->task, &h->counts, &h->count);
    return status == SF_OK ? EXIT_GOOD : job_fail_call(job, status, NULL, "the voids", EXIT_INPUT);
}

void hollows_release(hollows *h)
{
    free(h->voids);
    h->voids = NULL;
}

static int is_on_bed(const hollows *h, const sf_void *v)
{
    return v->box.z0 == h->counts.bed_layer;
}

static void report_void(report *r, const places *in, const hollows *h, const sf_void *v)
{
    double low[3], high[3];
    place_box(in, &v->box, low, high);
    report_begin(r, NULL);
    report_text(r, "kind", v->kind == SF_VOID_TRAP ? "trap" : "cup");
    report_count(r, "volume_voxels", v->volume);
    report_count(r, "area_voxels", v->area);
    report_number(r, "area_mm2", (double)v->area * in->lattice.pitch_x_mm * in->lattice.pitch_y_mm);
    report_numbers(r, "low_mm", low, 3);
    report_numbers(r, "high_mm", high, 3);
    report_flag(r, "on_bed", is_on_bed(h, v));
    if (v->kind == SF_VOID_TRAP) {
        report_null(r, "vent_layer");
    } else {
        report_count(r, "vent_layer", v->vent_layer);
    }
    report_end(r);
}

// The largest trap that is smaller than the last one said, or as large and later; NULL when there
// is none.
static const sf_void *next_trap(const hollows *h, const sf_void *last)
{
    const sf_void *best = NULL;
    for (size_t i = 0; i < h->count; i++) {
        const sf_void *v = &h->voids[i];
        int later =
            last == NULL || v->volume < last->volume || (v->volume == last->volume && v > last);
        if (v->kind == SF_VOID_TRAP && later && (best == NULL || v->volume > best->volume)) {
            best = v;
        }
    }
    return best;
}

// "3 voids are shut, 12 mm3"
static void name_traps(const hollows *h, double voxel_mm3, char *words, size_t size)
{
    char together[DESCRIBE_MM3_SIZE];
    snprintf(words, size, "%llu void%s shut, %s", (unsigned long long)h->counts.trap_count,
             h->counts.trap_count == 1 ? " is" : "s are",
             describe_mm3((double)h->counts.trap_voxels * voxel_mm3, together));
}

// "it makes 3 suction cups, the widest of 12 mm2"
static void name_cups(const hollows *h, const sf_lattice *lattice, char *words, size_t size)
{
    uint64_t widest = 0;
    for (size_t i = 0; i < h->count; i++) {
        const sf_void *v = &h->voids[i];
        widest = v->kind == SF_VOID_CUP && v->area > widest ? v->area : widest;
    }
    snprintf(words, size, "it makes %llu suction cup%s, the widest of %.4g mm2",
             (unsigned long long)h->counts.cup_count, h->counts.cup_count == 1 ? "" : "s",
             (double)widest * lattice->pitch_x_mm * lattice->pitch_y_mm);
}

static void say_traps(report *r, const places *in, const hollows *h, double voxel_mm3)
{
    const sf_void *v = next_trap(h, NULL);
    char traps[WORDS_SIZE];
    name_traps(h, voxel_mm3, traps, sizeof traps);
    report_say(r, "%s: what is in %s cannot leave.", traps,
               h->counts.trap_count == 1 ? "it" : "them");
    for (int i = 0; i < VOIDS_SAID && v != NULL; i++, v = next_trap(h, v)) {
        char where[PLACE_WORDS_SIZE], volume[DESCRIBE_MM3_SIZE];
        place_words(in, &v->box, 1, where);
        report_say(r, "  %-8s from %s: %s%s", "trap", where,
                   describe_mm3((double)v->volume * voxel_mm3, volume),
                   is_on_bed(h, v) ? ", until the part is off the bed" : "");
    }
}

// Of layers, where each cup opens: the widest first.
static void say_cups(report *r, const places *in, const hollows *h)
{
    const sf_void *last = NULL;
    for (int i = 0; i < VOIDS_SAID; i++) {
        const sf_void *best = NULL;
        for (size_t n = 0; n < h->count; n++) {
            const sf_void *v = &h->voids[n];
            int later = last == NULL || v->area < last->area || (v->area == last->area && v > last);
            if (v->kind == SF_VOID_CUP && later && (best == NULL || v->area > best->area)) {
                best = v;
            }
        }
        if (best == NULL) {
            return;
        }
        char where[PLACE_WORDS_SIZE], opens[48];
        place_words(in, &best->box, 1, where);
        snprintf(opens, sizeof opens, "opens at layer %u", best->vent_layer);
        report_say(r, "  %-8s from %s: %.4g mm2, %s", "cup", where,
                   (double)best->area * in->lattice.pitch_x_mm * in->lattice.pitch_y_mm,
                   best->vent_layer == in->lattice.nz ? "opens when the print ends" : opens);
        last = best;
    }
}

void hollows_say(cli_job *job, const part *p, const hollows *h, int is_brief)
{
    places in = {part_lattice(p), job->options.up};
    double voxel_mm3 = part_voxel_mm3(p);
    char traps[WORDS_SIZE], cups[WORDS_SIZE];
    name_traps(h, voxel_mm3, traps, sizeof traps);
    name_cups(h, &in.lattice, cups, sizeof cups);
    if (is_brief && h->counts.trap_count > 0) {
        report_say(job->report, "%s%s%s ('sf check' says where).", traps,
                   h->counts.cup_count > 0 ? "; printed from resin " : "",
                   h->counts.cup_count > 0 ? cups : "");
        return;
    }
    if (h->counts.trap_count > 0) {
        say_traps(job->report, &in, h, voxel_mm3);
    }
    if (h->counts.cup_count > 0) {
        report_say(job->report, "Printed from resin, hanging from the bed, %s.", cups);
    }
    if (p->kind == PART_JOB) {
        say_cups(job->report, &in, h);
    }
}

void hollows_report(cli_job *job, const part *p, const hollows *h)
{
    report *r = job->report;
    places in = {part_lattice(p), job->options.up};
    report_begin(r, "voids");
    report_count(r, "traps", h->counts.trap_count);
    report_count(r, "trap_voxels", h->counts.trap_voxels);
    report_count(r, "cups", h->counts.cup_count);
    report_count(r, "cup_voxels", h->counts.cup_voxels);
    report_count(r, "small_cups", h->counts.small_cup_count);
    report_begin_list(r, "list");
    for (size_t i = 0; i < h->count; i++) {
        report_void(r, &in, h, &h->voids[i]);
    }
    report_end(r);
    report_count(r, "dropped", h->counts.voids_dropped);
    report_end(r);
}
