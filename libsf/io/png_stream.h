// SPDX-License-Identifier: MIT
// What libspng reads from and writes to: the caller's source and sink, which know why they failed.

#ifndef SF_IO_PNG_STREAM_H
#define SF_IO_PNG_STREAM_H

#include <sf/io.h>

#include <spng.h>

typedef struct sfi_png_source {
    sf_source source;
    sf_status status; // SF_OK, or what the source said last
} sfi_png_source;

typedef struct sfi_png_sink {
    sf_sink sink;
    sf_status status; // SF_OK, or what the sink said first
} sfi_png_sink;

// For spng_set_png_stream(); `user` is an sfi_png_source, or an sfi_png_sink.
int sfi_png_fetch(spng_ctx *context, void *user, void *data, size_t size);
int sfi_png_hand_on(spng_ctx *context, void *user, void *data, size_t size);

// What the end of writing means, SPNG_EOI or a failure: what the sink said, or memory, the only
// other thing that libspng runs out of.
sf_status sfi_png_written(const sfi_png_sink *out, int error);

#endif
