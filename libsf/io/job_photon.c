// SPDX-License-Identifier: MIT
// .photon in: a head, a table of layers, and run lengths of one bit a pixel.
//
// All numbers are little-endian, those with a point are floats of 32 bits:
//     0x00 0x12fd0019, 0x04 version, 0x08 size of the display along x and y, 0x20 layer height,
//     0x34 pixels along x and y, 0x40 where the table is, 0x44 layers, 0x5c exposures a layer
// and in the table, 36 bytes each: height of the layer, two times, where its bytes are, how many.
// A byte of a layer is the colour in bit 7 and a count of pixels in the other seven, along rows
// from the top. The runs of a layer must fill its pixels exactly.
//
// Heights say where a layer begins in some files and where it ends in others; those whose first is
// below half a layer begin there. The thickness of a layer is the step to the next one, of the last
// one (or the first) that of the head.
//
// The bytes of all layers together must not be more than the file has, so no byte is decoded in the
// name of many layers.
//
// Source: the files themselves; the layout is that of the "cbddlp" family.

#include "base/memory.h"
#include "base/status.h"
#include "io/job.h"

#include <math.h>
#include <string.h>

#define HEAD_SIZE 0x70u
#define ENTRY_SIZE 36u
#define BLOCK 65536u

static double get_float(const unsigned char *at)
{
    uint32_t bits = sfi_archive_u32(at);
    float value;
    memcpy(&value, &bits, sizeof value);
    return (double)value;
}

static sf_status damaged(sf_fault *fault, uint64_t offset, const char *what)
{
    return sfi_fault_set(fault, SF_ERR_FORMAT, 0, offset, "%s; export the job again", what);
}

// ---------------------------------------------------------------------------------------------
// Head and table
// ---------------------------------------------------------------------------------------------

static sf_status read_head(sf_job *job, const unsigned char *head, sf_fault *fault)
{
    sf_lattice *l = &job->lattice;
    uint32_t version = sfi_archive_u32(head + 4), count = sfi_archive_u32(head + 0x44);
    uint32_t table = sfi_archive_u32(head + 0x40);
    l->nx = sfi_archive_u32(head + 0x34);
    l->ny = sfi_archive_u32(head + 0x38);
    double layer = sfi_job_round_mm(get_float(head + 0x20));
    if (version < 1 || version > 2 || sfi_archive_u32(head + 0x5c) > 1) {
        return sfi_fault_set(fault, SF_ERR_UNSUPPORTED, 0, 4,
                             "only .photon of versions 1 and 2 with one exposure a layer is read; "
                             "export the job without anti-aliasing, or as SL1");
    }
    if (l->nx < 1 || l->nx > SF_EXTENT_MAX || l->ny < 1 || l->ny > SF_EXTENT_MAX) {
        return damaged(fault, 0x34, "its pictures have a size that cannot be");
    }
    if (count < 1 || table > job->bytes.size || count > (job->bytes.size - table) / ENTRY_SIZE) {
        return damaged(fault, 0x40, "its table of layers does not lie in the file");
    }
    if (count > job->options.layers_max) {
        return sfi_fault_set(fault, SF_ERR_OVERFLOW, 0, 0x44,
                             "the job has %u layers; raise layers_max", (unsigned)count);
    }
    if (!(layer > 0 && layer <= 1000)) {
        return damaged(fault, 0x20, "its layers have a height that cannot be");
    }
    for (int i = 0; i < 2; i++) {
        double pixels = i == 0 ? l->nx : l->ny;
        double pitch = sfi_job_round_mm(get_float(head + 8 + 4 * i) / pixels);
        int is_asked = job->options.pitch_mm[i] > 0;
        if (!is_asked && !(pitch > 0 && pitch <= 1000)) {
            return damaged(fault, 8, "its display has a size that cannot be");
        }
        *(i == 0 ? &l->pitch_x_mm : &l->pitch_y_mm) = is_asked ? job->options.pitch_mm[i] : pitch;
    }
    job->info.has_pitch = job->options.pitch_mm[0] == 0;
    l->layer_mm = layer;
    job->layer_count = count;
    return SF_OK;
}

static sf_status read_entry(sf_job *job, uint32_t k, const unsigned char *entry, uint64_t *left,
                            sf_fault *fault)
{
    sfi_photon_layer *layer = &job->photons[k];
    double height = get_float(entry);
    layer->offset = sfi_archive_u32(entry + 12);
    layer->size = sfi_archive_u32(entry + 16);
    if (layer->size > job->bytes.size || layer->offset > job->bytes.size - layer->size) {
        return sfi_fault_set(fault, SF_ERR_FORMAT, 0, layer->offset,
                             "layer %lu does not lie in the file; export the job again",
                             (unsigned long)k);
    }
    if (layer->size > *left) {
        return damaged(fault, layer->offset, "its layers share their bytes");
    }
    *left -= layer->size;
    if (!(height >= 0 && height <= 1e5) || (k > 0 && !(height > job->heights[k - 1]))) {
        return sfi_fault_set(fault, SF_ERR_FORMAT, 0, 0,
                             "layer %lu does not lie above the one below; export the job again",
                             (unsigned long)k);
    }
    job->heights[k] = height;
    return SF_OK;
}

// Places of layers become heights; where all are the same, one number says so.
static sf_status settle_heights(sf_job *job, sf_fault *fault)
{
    uint32_t count = job->layer_count;
    double *h = job->heights, layer = job->lattice.layer_mm, first = h[0];
    int is_top = first >= 0.5 * layer, is_even = 1;
    if (is_top) {
        for (uint32_t k = count; k-- > 1;) {
            h[k] = sfi_job_round_mm(h[k] - h[k - 1]);
        }
        h[0] = sfi_job_round_mm(first);
    } else {
        for (uint32_t k = 0; k + 1 < count; k++) {
            h[k] = sfi_job_round_mm(h[k + 1] - h[k]);
        }
        h[count - 1] = layer;
    }
    for (uint32_t k = 0; k < count; k++) {
        is_even = is_even && h[k] == h[0];
        if (!(h[k] > 0)) {
            return sfi_fault_set(fault, SF_ERR_FORMAT, 0, 0,
                                 "layer %lu is less than a nanometre thick; export the job again",
                                 (unsigned long)k);
        }
    }
    if (is_even) {
        job->lattice.layer_mm = h[0];
        sfi_free_array(&job->allocator, job->heights, count, sizeof *job->heights);
        job->heights = NULL;
    }
    return SF_OK;
}

sf_status sfi_photon_open(sf_job *job, sf_fault *fault)
{
    unsigned char head[HEAD_SIZE], entry[ENTRY_SIZE];
    uint64_t left = job->bytes.size;
    if (job->bytes.size < HEAD_SIZE) {
        return damaged(fault, 0, "the file is cut short");
    }
    SF_TRY(job->bytes.read_at(job->bytes.user, 0, head, sizeof head));
    SF_TRY(read_head(job, head, fault));
    job->lattice.nz = job->layer_count;
    job->photons = sfi_alloc_array(&job->allocator, job->layer_count, sizeof *job->photons);
    job->heights = sfi_alloc_array(&job->allocator, job->layer_count, sizeof *job->heights);
    if (job->photons == NULL || job->heights == NULL) {
        return SF_ERR_MEMORY;
    }
    for (uint32_t k = 0; k < job->layer_count; k++) {
        uint64_t at = (uint64_t)sfi_archive_u32(head + 0x40) + (uint64_t)k * ENTRY_SIZE;
        SF_TRY(job->bytes.read_at(job->bytes.user, at, entry, sizeof entry));
        SF_TRY(read_entry(job, k, entry, &left, fault));
    }
    return settle_heights(job, fault);
}

// ---------------------------------------------------------------------------------------------
// Runs
// ---------------------------------------------------------------------------------------------

// Hand on `count` pixels from place `at` on, counted from the top left, row by row.
static void white(const sf_job *job, const sfi_job_out *out, uint64_t at, uint32_t count)
{
    uint32_t nx = job->lattice.nx;
    while (count > 0) {
        uint32_t row = (uint32_t)(at / nx), x = (uint32_t)(at % nx);
        uint32_t step = count < nx - x ? count : nx - x;
        out->white(out->user, x, x + step, job->lattice.ny - 1 - row);
        at += step;
        count -= step;
    }
}

// Hand on the runs of a block; runs of one colour that follow each other are one.
static int take_block(const sf_job *job, const sfi_job_out *out, const unsigned char *block,
                      uint32_t size, uint64_t *at)
{
    uint64_t all = (uint64_t)job->lattice.nx * job->lattice.ny;
    for (uint32_t i = 0; i < size;) {
        unsigned colour = block[i] >> 7;
        uint32_t count = 0;
        for (; i < size && block[i] >> 7 == colour; i++) {
            count += block[i] & 0x7fu;
        }
        if (count > all - *at) {
            return 0;
        }
        if (colour != 0) {
            white(job, out, *at, count);
        }
        *at += count;
    }
    return 1;
}

static sf_status read_runs(sf_job *job, uint32_t k, const sfi_job_out *out, unsigned char *block,
                           sf_fault *fault)
{
    const sfi_photon_layer *layer = &job->photons[k];
    uint64_t at = 0;
    for (uint32_t done = 0, step; done < layer->size; done += step) {
        step = layer->size - done < BLOCK ? layer->size - done : BLOCK;
        SF_TRY(job->bytes.read_at(job->bytes.user, (uint64_t)layer->offset + done, block, step));
        if (!take_block(job, out, block, step, &at)) {
            return sfi_fault_set(fault, SF_ERR_FORMAT, 0, (uint64_t)layer->offset + done,
                                 "layer %lu has more pixels than its picture; export the job again",
                                 (unsigned long)k);
        }
    }
    return at == (uint64_t)job->lattice.nx * job->lattice.ny
               ? SF_OK
               : sfi_fault_set(fault, SF_ERR_FORMAT, 0, layer->offset,
                               "layer %lu has fewer pixels than its picture; export the job again",
                               (unsigned long)k);
}

sf_status sfi_photon_read(sf_job *job, uint32_t k, const sfi_job_out *out, sf_fault *fault)
{
    unsigned char *block = sfi_alloc_array(&job->allocator, BLOCK, 1);
    if (block == NULL) {
        return SF_ERR_MEMORY;
    }
    sf_status status = read_runs(job, k, out, block, fault);
    sfi_free_array(&job->allocator, block, BLOCK, 1);
    return status;
}
