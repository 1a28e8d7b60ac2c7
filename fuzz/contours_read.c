// SPDX-License-Identifier: MIT
// Fuzz target: any bytes as a CLI file of contours.
//
// A stack comes out, or a refusal with a sentence. Of a stack, heights rise and points are finite;
// it is drawn on a coarse lattice, and written in text and read again as the same stack.

#include "target.h"

#include <sf/contour_io.h>

static void same(const sf_contour_stack *a, const sf_contour_stack *b)
{
    must(sf_contour_stack_count(a) == sf_contour_stack_count(b), "as many layers");
    for (uint32_t k = 0; k < sf_contour_stack_count(a); k++) {
        sf_contours p, q;
        double bottom, top, top_again;
        must(sf_contour_stack_layer(a, k, &p, &bottom, &top) == SF_OK, "a layer");
        must(sf_contour_stack_layer(b, k, &q, NULL, &top_again) == SF_OK, "a layer");
        must(bottom < top && top == top_again, "heights rise");
        must(p.contour_count == q.contour_count, "as many contours");
        for (size_t i = 0; i < p.contour_count; i++) {
            must(p.starts[i + 1] == q.starts[i + 1], "as many points");
        }
    }
}

static void draw(const sf_contour_stack *stack)
{
    double heights[64], pitch = 1e-6;
    sf_lattice lattice;
    sf_grid *grid = NULL;
    uint32_t count = sf_contour_stack_count(stack);
    if (count > 64) {
        return;
    }
    sf_status status = SF_ERR_OVERFLOW;
    while (pitch < 1e12 && ((status = sf_contour_stack_lattice(stack, pitch, pitch, heights, 64,
                                                               &lattice)) == SF_ERR_OVERFLOW ||
                            (status == SF_OK && (uint64_t)lattice.nx * lattice.ny > 4096))) {
        pitch *= 4;
    }
    if (status == SF_OK && (uint64_t)lattice.nx * lattice.ny <= 4096) {
        must(sf_grid_from_contours(stack, &lattice, SF_CONTOUR_EVEN_ODD, NULL, NULL, &grid) ==
                 SF_OK,
             "contours within their lattice can be drawn");
        sf_grid_destroy(grid);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    sf_memory_cursor cursor = {data, size, 0};
    sf_read_limits limits = sf_read_limits_default();
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_contour_stack *stack = NULL, *again = NULL;
    limits.vertices_max = 10000;
    sf_status status =
        sf_contour_stack_read(sf_memory_source(&cursor), &limits, NULL, &stack, &fault);
    must((status == SF_OK) == (stack != NULL), "a stack exactly on success");
    must(status == SF_OK || (fault.status == status && fault.message[0] != '\0'), "a sentence");
    if (stack == NULL) {
        return 0;
    }
    buffer text = {NULL, 0, 0};
    sf_sink sink = {put, &text};
    must(sf_contour_stack_write(stack, SF_CONTOUR_CLI_TEXT, sink) == SF_OK, "it can be written");
    sf_memory_cursor back = {text.bytes, text.size, 0};
    must(sf_contour_stack_read(sf_memory_source(&back), NULL, NULL, &again, &fault) == SF_OK,
         "what was written can be read");
    same(stack, again);
    draw(stack);
    sf_contour_stack_destroy(stack);
    sf_contour_stack_destroy(again);
    free(text.bytes);
    return 0;
}
