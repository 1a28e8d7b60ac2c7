// SPDX-License-Identifier: MIT
// Fuzz target: any bytes as a printer's job, SL1 or .photon.
//
// A valid job comes out, or a refusal with a sentence. Of a job some layers are decoded twice, as
// bits and as greys, which must agree at the threshold; and an SL1 job is written again with its
// own layers, which must be the same bytes.

#include "target.h"

#include <sf/job.h>

// Pixels of all layers that are looked at; a small file can say that it has far more.
#define PIXELS_MAX ((uint64_t)1 << 20)

static int decode(sf_job *job, uint32_t k, sf_slice slice, uint8_t *greys, unsigned threshold)
{
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_status status = sf_job_read(job, k, slice, &fault);
    must(status == SF_OK || (fault.status == status && fault.message[0] != '\0'), "a sentence");
    must(sf_job_read_grey(job, k, greys, slice.width, NULL) == status, "one layer, one answer");
    uint64_t solid = 0;
    for (size_t i = 0; status == SF_OK && i < (size_t)slice.width * slice.height; i++) {
        solid += greys[i] >= threshold;
    }
    must(status != SF_OK || solid == sf_slice_popcount(slice), "bits are greys at the threshold");
    return status == SF_OK;
}

static void write_again(sf_job *job, const sf_grid *grid, const uint8_t *data, size_t size)
{
    buffer again = {NULL, 0, 0};
    uint32_t changed = 1;
    sf_sink sink = {put, &again};
    sf_status status = sf_job_rewrite(job, grid, sink, NULL, &changed, NULL);
    must(status == SF_OK && changed == 0, "its own layers are no change");
    must(again.size == size && memcmp(again.bytes, data, size) == 0, "the same bytes");
    free(again.bytes);
}

static void look(sf_job *job, const uint8_t *data, size_t size, unsigned threshold)
{
    sf_lattice l = sf_job_lattice(job);
    sf_job_info info;
    sf_grid *grid = NULL;
    must(sf_lattice_validate(&l) == SF_OK, "what was read is valid");
    must(sf_job_describe(job, &info) == SF_OK, "a job can be described");
    uint64_t pixels = (uint64_t)l.nx * l.ny;
    if (pixels > PIXELS_MAX || l.nz > PIXELS_MAX / pixels) {
        return;
    }
    must(sf_grid_create(&l, NULL, &grid) == SF_OK, "a grid");
    uint8_t *greys = malloc((size_t)pixels);
    int whole = 1;
    for (uint32_t k = 0; k < l.nz; k++) {
        whole = decode(job, k, sf_grid_slice(grid, k), greys, threshold) && whole;
    }
    if (whole && info.format == SF_JOB_SL1) {
        write_again(job, grid, data, size);
    }
    free(greys);
    sf_grid_destroy(grid);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    if (size == 0) {
        return 0;
    }
    sf_memory_cursor cursor = {data + 1, size - 1, 0};
    sf_job_options options = sf_job_options_default();
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_job *job = NULL;
    options.threshold = 1 + data[0] % 255u;
    options.layers_max = 64;
    if (data[0] % 2 != 0) { // pictures of any size, though the job says none
        options.pitch_mm[0] = 0.1;
        options.pitch_mm[1] = 0.2;
    }
    sf_status status = sf_job_open(sf_memory_bytes(&cursor), &options, NULL, &job, &fault);
    must((status == SF_OK) == (job != NULL), "a job exactly on success");
    must(status == SF_OK || (fault.status == status && fault.message[0] != '\0'), "a sentence");
    if (job != NULL) {
        look(job, data + 1, size - 1, options.threshold);
    }
    sf_job_close(job);
    return 0;
}
