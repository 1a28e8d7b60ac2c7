// SPDX-License-Identifier: MIT
// CLI out, in mm: text with numbers that read back the same, or long binary.

#include "base/status.h"
#include "io/contours.h"
#include "io/emitter.h"

static void emit_u16(sfi_emitter *out, unsigned value)
{
    unsigned char bytes[2] = {(unsigned char)value, (unsigned char)(value >> 8)};
    sfi_emit_bytes(out, bytes, 2);
}

static void emit_head(sfi_emitter *out, const sf_contour_stack *stack, sf_contour_format format)
{
    sfi_emit_text(out, "$$HEADERSTART\n");
    sfi_emit_text(out, format == SF_CONTOUR_CLI_BINARY ? "$$BINARY\n" : "$$ASCII\n");
    sfi_emit_text(out, "$$UNITS/1\n$$VERSION/200\n$$LAYERS/");
    sfi_emit_whole(out, sf_contour_stack_count(stack));
    sfi_emit_text(out, "\n$$HEADEREND"); // in binary the commands follow at once
}

// Contour i of a layer; way: 1 an outside, 0 a hole.
static void emit_text(sfi_emitter *out, const sf_contours *c, size_t i, unsigned way)
{
    sfi_emit_text(out, way != 0 ? "$$POLYLINE/1,1," : "$$POLYLINE/1,0,");
    sfi_emit_whole(out, c->starts[i + 1] - c->starts[i]);
    for (size_t k = 2 * c->starts[i]; k < 2 * c->starts[i + 1]; k++) {
        sfi_emit_text(out, ",");
        sfi_emit_number(out, c->points_mm[k]);
    }
    sfi_emit_text(out, "\n");
}

static void emit_binary(sfi_emitter *out, const sf_contours *c, size_t i, unsigned way)
{
    emit_u16(out, 130);
    sfi_emit_u32(out, 1);
    sfi_emit_u32(out, way);
    sfi_emit_u32(out, (uint32_t)(c->starts[i + 1] - c->starts[i]));
    for (size_t k = 2 * c->starts[i]; k < 2 * c->starts[i + 1]; k++) {
        sfi_emit_float(out, (float)c->points_mm[k]);
    }
}

static sf_status emit_layer(sfi_emitter *out, const sf_contour_stack *stack, uint32_t k,
                            int is_binary)
{
    sf_contours c;
    double top;
    SF_TRY(sf_contour_stack_layer(stack, k, &c, NULL, &top));
    if (is_binary) {
        emit_u16(out, 127);
        sfi_emit_float(out, (float)top);
    } else {
        sfi_emit_text(out, "$$LAYER/");
        sfi_emit_number(out, top);
        sfi_emit_text(out, "\n");
    }
    for (size_t i = 0; i < c.contour_count; i++) {
        size_t ends[2] = {0, c.starts[i + 1] - c.starts[i]};
        sf_contours one = {c.points_mm + 2 * c.starts[i], ends, 1};
        unsigned way = sf_contours_area_mm2(&one) >= 0;
        if (is_binary && ends[1] > INT32_MAX) {
            return SF_ERR_OVERFLOW;
        }
        (is_binary ? emit_binary : emit_text)(out, &c, i, way);
    }
    return SF_OK;
}

sf_status sf_contour_stack_write(const sf_contour_stack *stack, sf_contour_format format,
                                 sf_sink sink)
{
    sfi_emitter out;
    int is_binary = format == SF_CONTOUR_CLI_BINARY;
    if (stack == NULL || sink.write == NULL || (!is_binary && format != SF_CONTOUR_CLI_TEXT)) {
        return SF_ERR_ARGUMENT;
    }
    sfi_emitter_begin(&out, sink);
    emit_head(&out, stack, format);
    if (!is_binary) {
        sfi_emit_text(&out, "\n$$GEOMETRYSTART\n");
    }
    for (uint32_t k = 0; k < sf_contour_stack_count(stack); k++) {
        SF_TRY(emit_layer(&out, stack, k, is_binary));
    }
    if (!is_binary) {
        sfi_emit_text(&out, "$$GEOMETRYEND\n");
    }
    return sfi_emitter_end(&out);
}
