// SPDX-License-Identifier: MIT
// SL1 out: a job written again with other layers, and a new one from a grid.
//
// Of a job that is written again only the pictures change whose voxels do. In such a picture each
// pixel has a reason: what was added is white; what was taken away is black, and so is the dim rim
// around it that printers' anti-aliasing leaves, for dim pixels alone would harden nothing and yet
// stay in the resin's light. The rim is found from what was taken away, a pixel at a time through
// dim pixels and at most 8 of them; pixels beside matter that stays are left alone, for they are
// the rim of that. All else keeps its grey.

#include "base/memory.h"
#include "base/status.h"
#include "io/archive_write.h"
#include "io/emitter.h"
#include "io/job.h"
#include "io/picture.h"
#include "voxel/slice.h"

#include <stdio.h>
#include <string.h>

#define RIM 8

sf_sl1_settings sf_sl1_settings_default(void)
{
    sf_sl1_settings s = {sizeof s, "job", 8, 35, 10};
    return s;
}

#if defined(SF_HAVE_SPNG) && defined(SF_HAVE_ZLIB)

static void report(sf_task *task, uint32_t done, uint32_t total)
{
    if (task != NULL && task->progress != NULL) {
        task->progress(task->user, (double)done / total);
    }
}

// ---------------------------------------------------------------------------------------------
// Written again
// ---------------------------------------------------------------------------------------------

typedef struct rewriting {
    sf_job *job;
    const sf_grid *grid;
    sf_task *task;
    sf_fault *fault;
    uint8_t *pixels;
    uint64_t *words;
    sf_slice was, gone, dim, near, stays; // was: as it is in the job
    uint32_t *layer_of;                   // of each entry, or UINT32_MAX
    uint32_t done, changed;
} rewriting;

// dim = pixels that have light, but not enough, and do not lie beside what stays.
static sf_status find_dim(rewriting *r, sf_slice now)
{
    sf_element box = sf_element_box3();
    unsigned threshold = r->job->options.threshold;
    for (uint32_t y = 0; y < now.height; y++) {
        const uint8_t *row = r->pixels + (size_t)y * now.width;
        uint64_t *dim = sfi_slice_row(r->dim, y);
        memset(dim, 0, r->dim.stride * sizeof *dim);
        for (uint32_t x = 0; x < now.width; x++) {
            dim[x / 64] |= (uint64_t)(row[x] > 0 && row[x] < threshold) << (x % 64);
        }
    }
    SF_TRY(sf_slice_and(r->stays, now, r->was));
    SF_TRY(sf_slice_and_dilate(r->near, r->dim, r->stays, &box));
    return sf_slice_subtract(r->dim, r->dim, r->near);
}

// gone = what was taken away, with its rim.
static sf_status find_gone(rewriting *r, sf_slice now)
{
    sf_element box = sf_element_box3();
    SF_TRY(sf_slice_subtract(r->gone, r->was, now));
    SF_TRY(find_dim(r, now));
    for (int i = 0; i < RIM; i++) {
        SF_TRY(sf_slice_and_dilate(r->near, r->dim, r->gone, &box));
        SF_TRY(sf_slice_or(r->near, r->near, r->gone));
        if (sf_slice_equal(r->near, r->gone)) {
            break;
        }
        SF_TRY(sf_slice_copy(r->gone, r->near));
    }
    return SF_OK;
}

static sf_status draw(rewriting *r, uint32_t k, sf_slice now, sfi_archive_blob *blob)
{
    uint32_t width = now.width;
    SF_TRY(sf_job_read_grey(r->job, k, r->pixels, width, r->fault));
    SF_TRY(find_gone(r, now));
    for (uint32_t y = 0; y < now.height; y++) {
        const uint64_t *solid = sfi_slice_row(now, y), *was = sfi_slice_row(r->was, y);
        const uint64_t *gone = sfi_slice_row(r->gone, y);
        uint8_t *row = r->pixels + (size_t)y * width;
        for (uint32_t x = 0; x < width; x++) {
            uint64_t bit = UINT64_C(1) << (x % 64);
            if ((solid[x / 64] & ~was[x / 64] & bit) != 0) {
                row[x] = 255;
            } else if ((gone[x / 64] & bit) != 0) {
                row[x] = 0;
            }
        }
    }
    return sfi_png_write_grey(r->pixels, width, width, now.height, sfi_archive_blob_sink(blob));
}

static sf_status replace(void *user, size_t entry, sfi_archive_blob *blob)
{
    rewriting *r = user;
    uint32_t k = r->layer_of[entry];
    if (k == UINT32_MAX) {
        return SF_OK;
    }
    if (sf_task_is_cancelled(r->task)) {
        return sfi_fault_set(r->fault, SF_ERR_CANCELLED, 0, 0, "writing the job was cancelled");
    }
    sf_slice now = sf_grid_slice(r->grid, k);
    SF_TRY(sf_job_read(r->job, k, r->was, r->fault));
    if (!sf_slice_equal(now, r->was)) {
        r->changed++;
        SF_TRY(draw(r, k, now, blob));
    }
    report(r->task, ++r->done, r->job->lattice.nz);
    return SF_OK;
}

static sf_slice cut(rewriting *r, size_t words, int which)
{
    const sf_lattice *l = &r->job->lattice;
    sf_slice slice = {r->words + (size_t)which * words, l->nx, l->ny, sf_slice_stride(l->nx)};
    return slice;
}

static sf_status rewrite(rewriting *r, sf_sink sink)
{
    const sf_allocator *a = &r->job->allocator;
    const sf_lattice *l = &r->job->lattice;
    size_t words, all_words, pixels, entries = r->job->archive.count;
    if (!sfi_size_mul(sf_slice_stride(l->nx), l->ny, &words) ||
        !sfi_size_mul(words, 5, &all_words) || !sfi_size_mul(l->nx, l->ny, &pixels)) {
        return SF_ERR_OVERFLOW;
    }
    r->words = sfi_alloc_array(a, all_words, sizeof *r->words);
    r->pixels = sfi_alloc_array(a, pixels, 1);
    r->layer_of = sfi_alloc_array(a, entries, sizeof *r->layer_of);
    sf_status status = SF_ERR_MEMORY;
    if (r->words != NULL && r->pixels != NULL && r->layer_of != NULL) {
        r->was = cut(r, words, 0);
        r->gone = cut(r, words, 1);
        r->dim = cut(r, words, 2);
        r->near = cut(r, words, 3);
        r->stays = cut(r, words, 4);
        memset(r->layer_of, 0xff, entries * sizeof *r->layer_of);
        for (uint32_t k = 0; k < l->nz; k++) {
            r->layer_of[r->job->layers[k]] = k;
        }
        status = sfi_archive_copy(&r->job->archive, sink, replace, r);
    }
    sfi_free_array(a, r->layer_of, entries, sizeof *r->layer_of);
    sfi_free_array(a, r->pixels, pixels, 1);
    sfi_free_array(a, r->words, all_words, sizeof *r->words);
    return status;
}

sf_status sf_job_rewrite(sf_job *job, const sf_grid *grid, sf_sink sink, sf_task *task,
                         uint32_t *changed, sf_fault *fault)
{
    if (job == NULL || grid == NULL || sink.write == NULL) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "no job, no grid, or no sink");
    }
    if (job->info.format != SF_JOB_SL1) {
        return sfi_fault_set(fault, SF_ERR_UNSUPPORTED, 0, 0,
                             "only SL1 jobs are written again; export this one as SL1");
    }
    sf_lattice l = sf_grid_lattice(grid);
    if (l.nx != job->lattice.nx || l.ny != job->lattice.ny || l.nz != job->lattice.nz) {
        return sfi_fault_set(fault, SF_ERR_SHAPE, 0, 0, "the grid has not the counts of the job");
    }
    rewriting r = {.job = job, .grid = grid, .task = task, .fault = fault};
    SF_TRY(rewrite(&r, sink));
    if (changed != NULL) {
        *changed = r.changed;
    }
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// A new job
// ---------------------------------------------------------------------------------------------

static int is_name(const char *name)
{
    size_t length = strlen(name);
    for (size_t i = 0; i < length; i++) {
        char c = name[i];
        if (!((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
              c == '-' || c == '_')) {
            return 0;
        }
    }
    return length > 0 && length <= 60;
}

static sf_status check_settings(const sf_sl1_settings *s, const sf_lattice *l, sf_fault *fault)
{
    if (s->struct_size < sizeof *s || s->name == NULL || !is_name(s->name) ||
        !(s->exposure_s > 0 && s->exposure_s <= 1e6) ||
        !(s->first_exposure_s > 0 && s->first_exposure_s <= 1e6)) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                             "a job has a name of 1 to 60 letters, digits, - and _, and exposures "
                             "above 0");
    }
    for (uint32_t k = 2; k < l->nz; k++) {
        if (sf_lattice_layer_height(l, k) != sf_lattice_layer_height(l, 1)) {
            return sfi_fault_set(fault, SF_ERR_UNSUPPORTED, 0, 0,
                                 "an SL1 job has layers of one height, but for the first; layer "
                                 "%lu differs",
                                 (unsigned long)k);
        }
    }
    return l->nz <= 65532 ? SF_OK
                          : sfi_fault_set(fault, SF_ERR_UNSUPPORTED, 0, 0,
                                          "an SL1 job has at most 65532 layers");
}

static void emit_line(sfi_emitter *out, const char *key, double value)
{
    sfi_emit_text(out, key);
    sfi_emit_text(out, " = ");
    sfi_emit_number(out, value);
    sfi_emit_text(out, "\n");
}

static sf_status write_config(const sf_grid *grid, const sf_sl1_settings *s, sfi_archive_blob *blob)
{
    sf_lattice l = sf_grid_lattice(grid);
    double voxel = l.pitch_x_mm * l.pitch_y_mm, ml = 0;
    sfi_emitter out;
    for (uint32_t k = 0; k < l.nz; k++) {
        ml += (double)sf_slice_popcount(sf_grid_slice(grid, k)) * voxel *
              sf_lattice_layer_height(&l, k) / 1000;
    }
    uint32_t slow = s->fade_layers < l.nz ? s->fade_layers : l.nz;
    sfi_emitter_begin(&out, sfi_archive_blob_sink(blob));
    sfi_emit_text(&out, "action = print\njobDir = ");
    sfi_emit_text(&out, s->name);
    sfi_emit_text(&out, "\n");
    emit_line(&out, "expTime", s->exposure_s);
    emit_line(&out, "expTimeFirst", s->first_exposure_s);
    emit_line(&out, "numFade", s->fade_layers);
    emit_line(&out, "layerHeight", sf_lattice_layer_height(&l, l.nz > 1 ? 1 : 0));
    emit_line(&out, "usedMaterial", ml);
    emit_line(&out, "numSlow", slow);
    emit_line(&out, "numFast", l.nz - slow);
    return sfi_emitter_end(&out);
}

static sf_status write_display(const sf_grid *grid, sfi_archive_blob *blob)
{
    sf_lattice l = sf_grid_lattice(grid);
    sfi_emitter out;
    sfi_emitter_begin(&out, sfi_archive_blob_sink(blob));
    emit_line(&out, "display_width", l.nx * l.pitch_x_mm);
    emit_line(&out, "display_height", l.ny * l.pitch_y_mm);
    emit_line(&out, "display_pixels_x", l.nx);
    emit_line(&out, "display_pixels_y", l.ny);
    emit_line(&out, "layer_height", sf_lattice_layer_height(&l, l.nz > 1 ? 1 : 0));
    emit_line(&out, "initial_layer_height", sf_lattice_layer_height(&l, 0));
    return sfi_emitter_end(&out);
}

static sf_status add_entry(sfi_archive_out *out, const char *name, sfi_archive_blob *blob,
                           sf_status made)
{
    SF_TRY(made);
    SF_TRY(sfi_archive_add(out, name, blob->bytes, blob->size));
    blob->size = 0;
    return SF_OK;
}

static sf_status write_job(const sf_grid *grid, const sf_sl1_settings *s, sfi_archive_out *out,
                           sfi_archive_blob *blob, sf_task *task, sf_fault *fault)
{
    char name[96];
    uint32_t nz = sf_grid_lattice(grid).nz;
    SF_TRY(add_entry(out, "config.ini", blob, write_config(grid, s, blob)));
    SF_TRY(add_entry(out, "prusaslicer.ini", blob, write_display(grid, blob)));
    for (uint32_t k = 0; k < nz; k++) {
        if (sf_task_is_cancelled(task)) {
            return sfi_fault_set(fault, SF_ERR_CANCELLED, 0, 0, "writing the job was cancelled");
        }
        snprintf(name, sizeof name, "%s%05lu.png", s->name, (unsigned long)k);
        SF_TRY(add_entry(out, name, blob,
                         sfi_png_write(sf_grid_slice(grid, k), sfi_archive_blob_sink(blob))));
        report(task, k + 1, nz);
    }
    return sfi_archive_close(out);
}

sf_status sf_sl1_write(const sf_grid *grid, const sf_sl1_settings *settings,
                       const sf_allocator *allocator, sf_sink sink, sf_task *task, sf_fault *fault)
{
    sf_sl1_settings chosen = settings != NULL ? *settings : sf_sl1_settings_default();
    if (grid == NULL || sink.write == NULL) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "no grid, or no sink");
    }
    sf_lattice l = sf_grid_lattice(grid);
    SF_TRY(check_settings(&chosen, &l, fault));
    sfi_archive_out out = {.allocator = sfi_allocator_or_default(allocator), .sink = sink};
    sfi_archive_blob blob = {.allocator = out.allocator};
    sf_status status = write_job(grid, &chosen, &out, &blob, task, fault);
    sfi_archive_blob_release(&blob);
    sfi_archive_out_release(&out);
    return status;
}

#else

sf_status sf_job_rewrite(sf_job *job, const sf_grid *grid, sf_sink sink, sf_task *task,
                         uint32_t *changed, sf_fault *fault)
{
    (void)task;
    (void)changed;
    if (job == NULL || grid == NULL || sink.write == NULL) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "no job, no grid, or no sink");
    }
    return sfi_fault_set(fault, SF_ERR_UNSUPPORTED, 0, 0,
                         "this build writes no SL1 jobs; build it with libspng and zlib");
}

sf_status sf_sl1_write(const sf_grid *grid, const sf_sl1_settings *settings,
                       const sf_allocator *allocator, sf_sink sink, sf_task *task, sf_fault *fault)
{
    (void)settings;
    (void)allocator;
    (void)task;
    if (grid == NULL || sink.write == NULL) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "no grid, or no sink");
    }
    return sfi_fault_set(fault, SF_ERR_UNSUPPORTED, 0, 0,
                         "this build writes no SL1 jobs; build it with libspng and zlib");
}

#endif
