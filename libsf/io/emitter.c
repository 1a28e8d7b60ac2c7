// SPDX-License-Identifier: MIT
// Writing bytes, text and numbers to a sink through one buffer.

#include "io/emitter.h"

#include "io/number.h"

#include <string.h>

void sfi_emitter_begin(sfi_emitter *emitter, sf_sink sink)
{
    emitter->sink = sink;
    emitter->status = SF_OK;
    emitter->used = 0;
}

static void hand_on(sfi_emitter *emitter, const void *data, size_t size)
{
    if (emitter->status == SF_OK && size > 0) {
        emitter->status = emitter->sink.write(emitter->sink.user, data, size);
    }
}

sf_status sfi_emitter_end(sfi_emitter *emitter)
{
    hand_on(emitter, emitter->buffer, emitter->used);
    emitter->used = 0;
    return emitter->status;
}

void sfi_emit_bytes(sfi_emitter *emitter, const void *data, size_t size)
{
    if (size > SFI_EMITTER_BYTES - emitter->used) {
        hand_on(emitter, emitter->buffer, emitter->used);
        emitter->used = 0;
    }
    if (size > SFI_EMITTER_BYTES) {
        hand_on(emitter, data, size);
        return;
    }
    memcpy(emitter->buffer + emitter->used, data, size);
    emitter->used += size;
}

void sfi_emit_text(sfi_emitter *emitter, const char *text)
{
    sfi_emit_bytes(emitter, text, strlen(text));
}

void sfi_emit_number(sfi_emitter *emitter, double value)
{
    char text[SFI_NUMBER_SIZE];
    sfi_emit_bytes(emitter, text, sfi_number_format(value, text));
}

void sfi_emit_whole(sfi_emitter *emitter, uint64_t value)
{
    char text[20];
    size_t start = sizeof text;
    do {
        text[--start] = (char)('0' + value % 10);
        value /= 10;
    } while (value != 0);
    sfi_emit_bytes(emitter, text + start, sizeof text - start);
}

static void emit_bits(sfi_emitter *emitter, uint64_t bits, size_t size)
{
    unsigned char bytes[8];
    for (size_t i = 0; i < size; i++) {
        bytes[i] = (unsigned char)(bits >> 8 * i);
    }
    sfi_emit_bytes(emitter, bytes, size);
}

void sfi_emit_u32(sfi_emitter *emitter, uint32_t value)
{
    emit_bits(emitter, value, 4);
}

void sfi_emit_float(sfi_emitter *emitter, float value)
{
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    emit_bits(emitter, bits, 4);
}

void sfi_emit_double(sfi_emitter *emitter, double value)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    emit_bits(emitter, bits, 8);
}
