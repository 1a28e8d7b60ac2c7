// SPDX-License-Identifier: MIT
// A refined point as weights of the cage's points: rows of matrices, multiplied one after the
// other.

#include "grade/refine/refinement.h"

#include "base/memory.h"
#include "base/status.h"

#include <string.h>

// Replace the points of a row, of the step above the matrix, by those that the matrix has for them.
static sf_status multiply(const sfi_matrix *m, const sfi_row *row, sfi_row *product)
{
    sfi_row_clear(product);
    for (uint32_t i = 0; i < row->count; i++) {
        uint32_t start = m->starts[row->items[i]], end = m->starts[row->items[i] + 1];
        for (uint32_t j = start; j < end; j++) {
            double weight = m->pool[m->weights[row->items[i]] + (j - start)];
            sfi_row_add(product, m->items[j], row->weights[i] * weight);
        }
    }
    return product->failed ? SF_ERR_MEMORY : SF_OK;
}

// `row` holds the point, and receives the cage's points.
static sf_status descend(const sf_refinement *r, uint32_t step, const sf_allocator *allocator,
                         sfi_row *row)
{
    for (; step > 0; step--) {
        sfi_row product;
        const sfi_matrix *m = &r->layouts[0].matrices[step - 1];
        if (!sfi_row_begin(allocator, m->columns, &product)) {
            return SF_ERR_MEMORY;
        }
        sf_status status = multiply(m, row, &product);
        sfi_row_free(row);
        *row = product;
        SF_TRY(status);
    }
    return SF_OK;
}

sf_status sf_refinement_stencil(const sf_refinement *refinement, uint32_t step, size_t point,
                                const sf_allocator *allocator, size_t capacity, uint32_t *points,
                                double *weights, size_t *count)
{
    if (refinement == NULL || count == NULL || step > refinement->steps ||
        point >= refinement->layouts[0].points[step] ||
        (capacity > 0 && (points == NULL || weights == NULL))) {
        return SF_ERR_ARGUMENT;
    }
    sf_allocator kept = sfi_allocator_or_default(allocator);
    sfi_row row;
    if (!sfi_row_begin(&kept, refinement->layouts[0].points[step], &row)) {
        return SF_ERR_MEMORY;
    }
    sfi_row_add(&row, (uint32_t)point, 1);
    sf_status status = row.failed ? SF_ERR_MEMORY : descend(refinement, step, &kept, &row);
    if (status == SF_OK) {
        *count = row.count;
        status = row.count <= capacity ? SF_OK : SF_ERR_CAPACITY;
    }
    if (status == SF_OK && row.count > 0) {
        memcpy(points, row.items, row.count * sizeof *points);
        memcpy(weights, row.weights, row.count * sizeof *weights);
    }
    sfi_row_free(&row);
    return status;
}
