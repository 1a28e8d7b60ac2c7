// SPDX-License-Identifier: MIT
// Small jobs made in memory: .photon byte by byte, SL1 by the writer and then spoiled.

#ifndef SF_TEST_JOB_FILES_H
#define SF_TEST_JOB_FILES_H

#include <sf/job.h>

#include "failing_allocator.h"
#include "test.h"

typedef struct job_bytes {
    unsigned char *data;
    size_t size, capacity;
    sf_memory_cursor cursor;
} job_bytes;

static inline sf_status job_put(void *user, const void *data, size_t size)
{
    job_bytes *b = user;
    if (b->size + size > b->capacity) {
        b->capacity = 2 * (b->size + size);
        b->data = realloc(b->data, b->capacity);
    }
    memcpy(b->data + b->size, data, size);
    b->size += size;
    return SF_OK;
}

static inline void job_u32(job_bytes *b, uint32_t value)
{
    unsigned char bytes[4] = {(unsigned char)value, (unsigned char)(value >> 8),
                              (unsigned char)(value >> 16), (unsigned char)(value >> 24)};
    job_put(b, bytes, 4);
}

static inline void job_float(job_bytes *b, double value)
{
    float single = (float)value;
    uint32_t bits;
    memcpy(&bits, &single, sizeof bits);
    job_u32(b, bits);
}

static inline void job_set32(job_bytes *b, size_t at, uint32_t value)
{
    for (int i = 0; i < 4; i++) {
        b->data[at + (size_t)i] = (unsigned char)(value >> 8 * i);
    }
}

static inline uint32_t job_get32(const job_bytes *b, size_t at)
{
    return b->data[at] | (uint32_t)b->data[at + 1] << 8 | (uint32_t)b->data[at + 2] << 16 |
           (uint32_t)b->data[at + 3] << 24;
}

static inline sf_bytes job_of(job_bytes *b)
{
    b->cursor.data = b->data;
    b->cursor.size = b->size;
    return sf_memory_bytes(&b->cursor);
}

static inline sf_grid *job_grid(uint32_t nx, uint32_t ny, uint32_t nz, const double *heights)
{
    sf_lattice lattice = {nx, ny, nz, 0.05, 0.1, 0.025, heights, {0, 0, 0}};
    sf_grid *grid = NULL;
    CHECK_EQ(sf_grid_create(&lattice, NULL, &grid), SF_OK);
    for (uint32_t k = 0; k < nz; k++) {
        for (uint32_t y = 0; y < ny; y++) {
            for (uint32_t x = 0; x < nx; x++) {
                CHECK_EQ(sf_slice_set(sf_grid_slice(grid, k), x, y, test_random_below(3) == 0),
                         SF_OK);
            }
        }
    }
    return grid;
}

// .photon of a grid; tops: heights are where layers end. The table stands at byte 112.
enum { PHOTON_TABLE = 112, PHOTON_ENTRY = 36 };
static inline void job_make_photon(job_bytes *b, const sf_grid *grid, int tops)
{
    sf_lattice l = sf_grid_lattice(grid);
    b->size = 0;
    for (size_t i = 0; i < PHOTON_TABLE / 4; i++) {
        job_u32(b, 0);
    }
    job_bytes head = {b->data, 0, b->capacity, {NULL, 0, 0}};
    job_u32(&head, 0x12fd0019);
    job_u32(&head, 2);
    job_float(&head, l.nx * l.pitch_x_mm);
    job_float(&head, l.ny * l.pitch_y_mm);
    head.size = 0x20;
    job_float(&head, sf_lattice_layer_height(&l, l.nz - 1));
    head.size = 0x34;
    job_u32(&head, l.nx);
    job_u32(&head, l.ny);
    head.size = 0x40;
    job_u32(&head, PHOTON_TABLE);
    job_u32(&head, l.nz);
    head.size = 0x5c;
    job_u32(&head, 1);
    for (uint32_t k = 0; k < l.nz; k++) {
        job_float(b, sf_lattice_layer_bottom(&l, k + (tops != 0)));
        for (int i = 0; i < 8; i++) {
            job_u32(b, 0);
        }
    }
    for (uint32_t k = 0; k < l.nz; k++) {
        sf_slice slice = sf_grid_slice(grid, k);
        uint32_t at = (uint32_t)b->size;
        unsigned char run = 0;
        for (size_t i = 0; i <= (size_t)l.nx * l.ny; i++) {
            int end = i == (size_t)l.nx * l.ny;
            uint32_t y = l.ny - 1 - (uint32_t)(i / l.nx);
            unsigned char bit =
                end ? 0 : (unsigned char)(sf_slice_get(slice, (uint32_t)(i % l.nx), y) << 7);
            if (i > 0 && (end || bit != (run & 128) || (run & 127) == 125)) {
                job_put(b, &run, 1);
                run = 0;
            }
            run = (unsigned char)(((run & 127) + 1) | bit);
        }
        job_set32(b, PHOTON_TABLE + PHOTON_ENTRY * (size_t)k + 12, at);
        job_set32(b, PHOTON_TABLE + PHOTON_ENTRY * (size_t)k + 16, (uint32_t)b->size - at);
    }
}

static inline void job_make_sl1(job_bytes *b, const sf_grid *grid)
{
    sf_sink sink = {job_put, b};
    sf_fault fault = {SF_OK, 0, 0, ""};
    b->size = 0;
    CHECK_EQ(sf_sl1_write(grid, NULL, NULL, sink, NULL, &fault), SF_OK);
    CHECK_STR(fault.message, "");
}

// Whether the job holds just these layers.
static inline int job_holds(sf_job *job, const sf_grid *grid)
{
    sf_lattice l = sf_job_lattice(job), g = sf_grid_lattice(grid);
    if (l.nx != g.nx || l.ny != g.ny || l.nz != g.nz) {
        return 0;
    }
    sf_slice slice = {calloc(l.ny * sf_slice_stride(l.nx), 8), l.nx, l.ny, sf_slice_stride(l.nx)};
    int good = 1;
    for (uint32_t k = 0; k < l.nz; k++) {
        good = good && sf_job_read(job, k, slice, NULL) == SF_OK &&
               sf_slice_equal(slice, sf_grid_slice(grid, k));
    }
    free(slice.words);
    return good;
}

// Open the bytes and read every layer: what became of it, and that a refusal says why. Nothing may
// stay behind.
static inline sf_status job_try(job_bytes *b, const sf_job_options *options, long fail_at,
                                sf_fault *fault)
{
    failing_allocator f;
    sf_job *job = NULL;
    sf_fault none = {SF_OK, 0, 0, ""};
    *fault = none;
    failing_begin(&f, fail_at);
    sf_status status = sf_job_open(job_of(b), options, &f.allocator, &job, fault);
    CHECK((status == SF_OK) == (job != NULL));
    if (status == SF_OK) {
        sf_lattice l = sf_job_lattice(job);
        sf_slice slice = {calloc(l.ny * sf_slice_stride(l.nx), 8), l.nx, l.ny,
                          sf_slice_stride(l.nx)};
        for (uint32_t k = 0; k < l.nz && status == SF_OK; k++) {
            status = sf_job_read(job, k, slice, fault);
        }
        free(slice.words);
    }
    CHECK(status == SF_OK || (fault->status == status && strlen(fault->message) > 20 &&
                              strlen(fault->message) < SF_FAULT_MESSAGE_SIZE - 1));
    sf_job_close(job);
    CHECK(f.live == 0 && f.faults == 0);
    return status;
}

#endif
