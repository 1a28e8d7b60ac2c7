// SPDX-License-Identifier: MIT
// A buffered way to a sink: what every writer writes through.
//
// It keeps the first failure and from then on does nothing, so that a writer can say all it has to
// say and ask once, at the end.

#ifndef SF_IO_EMITTER_H
#define SF_IO_EMITTER_H

#include <sf/base.h>

#define SFI_EMITTER_BYTES 4096

typedef struct sfi_emitter {
    sf_sink sink;
    sf_status status; // SF_OK, or what the sink said first
    size_t used;
    unsigned char buffer[SFI_EMITTER_BYTES];
} sfi_emitter;

void sfi_emitter_begin(sfi_emitter *emitter, sf_sink sink);

// Hand on what is left; returns SF_OK, or the first failure.
sf_status sfi_emitter_end(sfi_emitter *emitter);

void sfi_emit_bytes(sfi_emitter *emitter, const void *data, size_t size);
void sfi_emit_text(sfi_emitter *emitter, const char *text);

// A number in decimal: one that reads back as the same double; a whole one.
void sfi_emit_number(sfi_emitter *emitter, double value);
void sfi_emit_whole(sfi_emitter *emitter, uint64_t value);

// Little-endian binary.
void sfi_emit_u32(sfi_emitter *emitter, uint32_t value);
void sfi_emit_float(sfi_emitter *emitter, float value);
void sfi_emit_double(sfi_emitter *emitter, double value);

#endif
