// SPDX-License-Identifier: MIT
// Jobs of resin printers: opened by their first bytes, decoded a layer at a time.
//
// A format fills in the lattice and where each layer lies, and hands on the layer that is asked for
// as rows of greys or as runs of white; what they become is decided here, once: bits at a
// threshold, or bytes. Nothing of a layer is kept.

#include "io/job.h"

#include "base/memory.h"
#include "base/status.h"
#include "voxel/slice.h"

#include <math.h>
#include <string.h>

sf_job_options sf_job_options_default(void)
{
    sf_job_options o = {sizeof o, 128, {0, 0}, (uint64_t)64 << 30, 1000000};
    return o;
}

double sfi_job_round_mm(double mm)
{
    return floor(mm * 1e6 + 0.5) / 1e6;
}

// ---------------------------------------------------------------------------------------------
// Opening
// ---------------------------------------------------------------------------------------------

static sf_status check_options(const sf_job *job, sf_fault *fault)
{
    const sf_job_options *o = &job->options;
    if (o->struct_size < sizeof *o || o->threshold < 1 || o->threshold > 255) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                             "the threshold of a job is 1 to 255, of 255");
    }
    if ((o->pitch_mm[0] == 0) != (o->pitch_mm[1] == 0)) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "say both sizes of a pixel, or none");
    }
    for (int i = 0; i < 2; i++) {
        if (!(o->pitch_mm[i] >= 0 && o->pitch_mm[i] <= 1000)) {
            return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                                 "a pixel is more than 0 and at most 1000 mm long");
        }
    }
    if (job->bytes.size > o->bytes_max) {
        return sfi_fault_set(fault, SF_ERR_OVERFLOW, 0, 0,
                             "the file is larger than %llu bytes; raise bytes_max",
                             (unsigned long long)o->bytes_max);
    }
    return SF_OK;
}

static sf_status open_format(sf_job *job, sf_fault *fault)
{
    unsigned char head[4] = {0, 0, 0, 0};
    size_t size = job->bytes.size < 4 ? (size_t)job->bytes.size : 4;
    SF_TRY(check_options(job, fault));
    SF_TRY(job->bytes.read_at(job->bytes.user, 0, head, size));
    uint32_t magic = sfi_archive_u32(head);
    if (magic == 0x12fd0019) {
        job->info.format = SF_JOB_PHOTON;
        return sfi_photon_open(job, fault);
    }
    if (magic == 0x12fd0086 || magic == 0x12fd0106) {
        return sfi_fault_set(fault, SF_ERR_UNSUPPORTED, 0, 0,
                             "this is a .ctb job, which is not read; export it as SL1");
    }
    if (head[0] == 'P' && head[1] == 'K') {
        job->info.format = SF_JOB_SL1;
        return sfi_sl1_open(job, fault);
    }
    return sfi_fault_set(fault, SF_ERR_FORMAT, 0, 0,
                         "this is no job: it begins neither like SL1 nor like .photon");
}

sf_status sf_job_open(sf_bytes bytes, const sf_job_options *options, const sf_allocator *allocator,
                      sf_job **job, sf_fault *fault)
{
    if (bytes.read_at == NULL || job == NULL) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "no bytes, or no place for the job");
    }
    sf_allocator from = sfi_allocator_or_default(allocator);
    sf_job *made = sfi_alloc_array(&from, 1, sizeof *made);
    sf_status status = SF_ERR_MEMORY;
    if (made != NULL) {
        memset(made, 0, sizeof *made);
        made->allocator = made->archive.allocator = from;
        made->bytes = bytes;
        made->options = options != NULL ? *options : sf_job_options_default();
        status = open_format(made, fault);
        made->lattice.heights_mm = made->heights;
    }
    if (status == SF_OK && sf_lattice_validate(&made->lattice) != SF_OK) {
        status = sfi_fault_set(fault, SF_ERR_FORMAT, 0, 0,
                               "the job's pixels, layers or heights are none that can be");
    }
    if (status != SF_OK) {
        sf_job_close(made);
        return status == SF_ERR_MEMORY
                   ? sfi_fault_set(fault, status, 0, 0, "there is not enough memory for this job")
                   : status;
    }
    *job = made;
    return SF_OK;
}

void sf_job_close(sf_job *job)
{
    if (job != NULL) {
        sf_allocator a = job->allocator;
        sfi_archive_release(&job->archive);
        sfi_free_array(&a, job->heights, job->lattice.nz, sizeof *job->heights);
        sfi_free_array(&a, job->layers, job->layer_count, sizeof *job->layers);
        sfi_free_array(&a, job->photons, job->layer_count, sizeof *job->photons);
        sfi_free_array(&a, job, 1, sizeof *job);
    }
}

sf_lattice sf_job_lattice(const sf_job *job)
{
    sf_lattice none = {0, 0, 0, 0, 0, 0, NULL, {0, 0, 0}};
    return job != NULL ? job->lattice : none;
}

sf_status sf_job_describe(const sf_job *job, sf_job_info *info)
{
    if (job == NULL || info == NULL) {
        return SF_ERR_ARGUMENT;
    }
    *info = job->info;
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Layers
// ---------------------------------------------------------------------------------------------

// Where a layer is decoded to: bits, or bytes.
typedef struct target {
    sf_slice slice;
    unsigned threshold;
    uint8_t *pixels;
    size_t row_bytes;
    uint32_t width;
} target;

static void greys_to_bits(void *user, uint32_t y, const uint8_t *greys)
{
    const target *to = user;
    uint64_t *row = sfi_slice_row(to->slice, y);
    for (uint32_t x = 0; x < to->slice.width; x += 64) {
        uint32_t end = to->slice.width - x < 64 ? to->slice.width - x : 64;
        uint64_t word = 0;
        for (uint32_t i = 0; i < end; i++) {
            word |= (uint64_t)(greys[x + i] >= to->threshold) << i;
        }
        row[x / 64] = word;
    }
}

static void white_to_bits(void *user, uint32_t x0, uint32_t x1, uint32_t y)
{
    const target *to = user;
    sf_rect rect = {x0, y, x1, y + 1};
    sf_status always = sf_slice_fill(to->slice, rect, 1);
    (void)always;
}

static void greys_to_bytes(void *user, uint32_t y, const uint8_t *greys)
{
    const target *to = user;
    memcpy(to->pixels + y * to->row_bytes, greys, to->width);
}

static void white_to_bytes(void *user, uint32_t x0, uint32_t x1, uint32_t y)
{
    const target *to = user;
    memset(to->pixels + y * to->row_bytes + x0, 255, x1 - x0);
}

static sf_status decode(sf_job *job, uint32_t k, const sfi_job_out *out, sf_fault *fault)
{
    sf_status status = job->info.format == SF_JOB_PHOTON ? sfi_photon_read(job, k, out, fault)
                                                         : sfi_sl1_read(job, k, out, fault);
    return status == SF_ERR_MEMORY
               ? sfi_fault_set(fault, status, 0, 0, "there is not enough memory for this layer")
               : status;
}

sf_status sf_job_read(sf_job *job, uint32_t k, sf_slice slice, sf_fault *fault)
{
    sf_rect all = {0, 0, slice.width, slice.height}, none = {0, 0, 0, 0};
    if (job == NULL || k >= job->lattice.nz || sf_slice_fill(slice, none, 0) != SF_OK) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                             "no job, no such layer, or a slice that is none");
    }
    if (slice.width != job->lattice.nx || slice.height != job->lattice.ny) {
        return sfi_fault_set(fault, SF_ERR_SHAPE, 0, 0, "the slice has not the size of the job");
    }
    target to = {slice, job->options.threshold, NULL, 0, slice.width};
    sfi_job_out out = {greys_to_bits, white_to_bits, &to};
    SF_TRY(sf_slice_fill(slice, all, 0));
    return decode(job, k, &out, fault);
}

sf_status sf_job_read_grey(sf_job *job, uint32_t k, uint8_t *pixels, size_t row_bytes,
                           sf_fault *fault)
{
    sf_slice none = {NULL, 0, 0, 0};
    if (job == NULL || k >= job->lattice.nz || pixels == NULL || row_bytes < job->lattice.nx ||
        row_bytes > SIZE_MAX / job->lattice.ny) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                             "no job, no such layer, or rows that are too short");
    }
    target to = {none, 0, pixels, row_bytes, job->lattice.nx};
    sfi_job_out out = {greys_to_bytes, white_to_bytes, &to};
    for (uint32_t y = 0; y < job->lattice.ny; y++) {
        memset(pixels + y * row_bytes, 0, job->lattice.nx);
    }
    return decode(job, k, &out, fault);
}
