// SPDX-License-Identifier: MIT
// Sources and sinks as libspng's streams: what they answer is kept, because libspng itself only
// says that reading or writing failed.

#include <sf/io.h>

#ifdef SF_HAVE_SPNG

#include "io/png_stream.h"

int sfi_png_fetch(spng_ctx *context, void *user, void *data, size_t size)
{
    sfi_png_source *in = user;
    (void)context;
    for (size_t done = 0, got = 0; done < size; done += got) {
        in->status =
            in->source.read(in->source.user, (unsigned char *)data + done, size - done, &got);
        if (in->status == SF_OK && got > size - done) {
            in->status = SF_ERR_IO; // the source has broken its promise
        }
        if (in->status != SF_OK) {
            return SPNG_IO_ERROR;
        }
        if (got == 0) {
            return SPNG_IO_EOF;
        }
    }
    return 0;
}

int sfi_png_hand_on(spng_ctx *context, void *user, void *data, size_t size)
{
    sfi_png_sink *out = user;
    (void)context;
    if (out->status == SF_OK) {
        out->status = out->sink.write(out->sink.user, data, size);
    }
    return out->status == SF_OK ? 0 : SPNG_IO_ERROR;
}

sf_status sfi_png_written(const sfi_png_sink *out, int error)
{
    if (error == SPNG_EOI || out->status != SF_OK) {
        return out->status;
    }
    return error == SPNG_EMEM ? SF_ERR_MEMORY : SF_ERR_INTERNAL;
}

#endif
