// SPDX-License-Identifier: MIT
// Fuzz target: any bytes, read as every cage format.
//
// Whatever comes in, a cage comes out or a refusal with a sentence; and a cage that came out,
// written as VTK and read again, is the same cage with the same value at every corner.

#include "target.h"

#include <sf/cage_io.h>

static sf_cage *read_as(const void *data, size_t size, sf_cage_format format)
{
    sf_memory_cursor cursor = {data, size, 0};
    sf_cage_read_options options = sf_cage_read_options_default();
    sf_cage *cage = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    options.format = format;
    sf_status status = sf_cage_read(sf_memory_source(&cursor), &options, NULL, &cage, NULL, &fault);
    must((status == SF_OK) == (cage != NULL), "a cage exactly on success");
    must(status == SF_OK || (fault.status == status && fault.message[0] != '\0'), "a sentence");
    return cage;
}

static double value_at(const sf_cage_view *view, size_t channel, uint32_t corner)
{
    const sf_channel *c = &view->channels[channel];
    return c->values[c->indices != NULL ? c->indices[corner] : view->corners[corner]];
}

static void compare(const sf_cage_view *a, const sf_cage_view *b)
{
    must(a->dimension == b->dimension && a->point_count == b->point_count &&
             a->cell_count == b->cell_count && a->channel_count == b->channel_count &&
             a->crease_count == b->crease_count && a->sharp_count == b->sharp_count,
         "the counts come back");
    must(memcmp(a->starts, b->starts, (a->cell_count + 1) * sizeof(uint32_t)) == 0 &&
             memcmp(a->corners, b->corners, a->starts[a->cell_count] * sizeof(uint32_t)) == 0,
         "every corner comes back");
    must(memcmp(a->positions, b->positions, 3 * a->point_count * sizeof(double)) == 0,
         "every coordinate comes back");
    for (size_t i = 0; i < a->channel_count; i++) {
        for (uint32_t j = 0; j < a->starts[a->cell_count]; j++) {
            must(value_at(a, i, j) == value_at(b, i, j), "every value comes back");
        }
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    for (sf_cage_format format = SF_CAGE_FORMAT_AUTO; format <= SF_CAGE_FORMAT_VTK; format++) {
        sf_cage *cage = read_as(data, size, format);
        if (cage != NULL) {
            buffer b = {NULL, 0, 0};
            sf_sink sink = {put, &b};
            sf_cage_view view = sf_cage_get_view(cage);
            must(sf_cage_write_vtk(&view, 1, NULL, sink, NULL) == SF_OK,
                 "what was read can be written");
            sf_cage *again = read_as(b.bytes, b.size, SF_CAGE_FORMAT_AUTO);
            must(again != NULL, "what was written can be read");
            sf_cage_view back = sf_cage_get_view(again);
            compare(&view, &back);
            sf_cage_destroy(again);
            sf_cage_destroy(cage);
            free(b.bytes);
        }
    }
    return 0;
}
