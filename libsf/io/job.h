// SPDX-License-Identifier: MIT
// Inside a job: what its formats fill in, and how they hand on a layer.

#ifndef SF_IO_JOB_H
#define SF_IO_JOB_H

#include "io/archive.h"
#include "io/png_grey.h"

#include <sf/job.h>

// Lengths out of a file are whole nanometres after this: floats and divisions leave pixels square
// and layers of one height.
double sfi_job_round_mm(double mm);

// Where a layer of .photon lies.
typedef struct sfi_photon_layer {
    uint32_t offset, size;
} sfi_photon_layer;

struct sf_job {
    sf_allocator allocator;
    sf_bytes bytes;
    sf_job_options options;
    sf_job_info info;
    sf_lattice lattice;
    double *heights;           // nz of them, or NULL
    sfi_archive archive;       // SL1
    uint32_t *layers;          // SL1: entry of each layer
    sfi_photon_layer *photons; // .photon: of each layer
    uint32_t layer_count;      // places in both
};

// How a decoded layer is handed on: greys of a row, as in sfi_png_row, or a run of pixels that are
// white, for formats that have no greys. A layer comes as one or the other.
typedef struct sfi_job_out {
    sfi_png_row greys;
    void (*white)(void *user, uint32_t x0, uint32_t x1, uint32_t y);
    void *user;
} sfi_job_out;

// job_sl1.c
sf_status sfi_sl1_open(sf_job *job, sf_fault *fault);
sf_status sfi_sl1_read(sf_job *job, uint32_t k, const sfi_job_out *out, sf_fault *fault);

// job_photon.c
sf_status sfi_photon_open(sf_job *job, sf_fault *fault);
sf_status sfi_photon_read(sf_job *job, uint32_t k, const sfi_job_out *out, sf_fault *fault);

// job_config.c: the value of a key in lines of "key = value"; 0 where there is none, or no number.
int sfi_config_number(const char *text, size_t size, const char *key, double *value);

#endif
