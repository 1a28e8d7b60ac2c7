// SPDX-License-Identifier: MIT
// The matrix of one step of subdivision.

#include "grade/refine/rules.h"

#include "base/status.h"
#include "base/task.h"

#include <string.h>

static sf_status append_all(const sfi_rules *rules, uint32_t rows, sf_task *task, sfi_row *row,
                            sfi_matrix_maker *maker)
{
    for (uint32_t i = 0; i < rows; i++) {
        if (i % 4096 == 0 && sf_task_is_cancelled(task)) {
            return SF_ERR_CANCELLED;
        }
        sfi_row_clear(row);
        sfi_rules_row(rules, i, row);
        SF_TRY(sfi_matrix_append(maker, i, row));
    }
    return SF_OK;
}

sf_status sfi_rules_matrix(const sfi_complex *complex, int separable, sf_task *task,
                           sfi_matrix *matrix)
{
    const sf_allocator *allocator = &complex->allocator;
    uint32_t rows = sfi_complex_split_points(complex);
    if (rows == 0) {
        return SF_ERR_OVERFLOW;
    }
    sfi_rules rules = {0};
    sfi_row row = {0};
    sfi_matrix_maker maker = {0};
    sf_status status = sfi_rules_begin(complex, separable, &rules);
    if (status == SF_OK && !sfi_row_begin(allocator, complex->points, &row)) {
        status = SF_ERR_MEMORY;
    }
    if (status == SF_OK) {
        status = sfi_matrix_begin(allocator, rows, complex->points, &maker);
    }
    if (status == SF_OK) {
        status = append_all(&rules, rows, task, &row, &maker);
    }
    sfi_matrix_end(&maker, status == SF_OK ? matrix : NULL);
    sfi_row_free(&row);
    sfi_rules_free(&rules);
    return status;
}
