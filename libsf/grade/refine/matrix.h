// SPDX-License-Identifier: MIT
// Sparse matrices that turn values at the points of a mesh into those of a finer one.

#ifndef SF_GRADE_REFINE_MATRIX_H
#define SF_GRADE_REFINE_MATRIX_H

#include <sf/base.h>

// Rows of weights that sum to 1. Rows of the same weights share them.
typedef struct sfi_matrix {
    sf_allocator allocator;
    uint32_t rows, columns;
    uint32_t *starts;  // one more than rows: where the columns of each row begin
    uint32_t *items;   // columns; in each row by falling weight
    uint32_t *weights; // of each row, where its weights begin in the pool
    double *pool;
    size_t item_capacity, pool_capacity;
} sfi_matrix;

// One row while it is put together: columns in the order in which they were first added.
typedef struct sfi_row {
    sf_allocator allocator;
    uint32_t count;
    uint32_t *items;
    double *weights;
    uint32_t *places; // of each column its place in the row, where that holds it
    size_t capacity, columns;
    int failed; // memory ran out
} sfi_row;

// A row over `columns` columns, empty. Returns 0 without memory.
int sfi_row_begin(const sf_allocator *allocator, uint32_t columns, sfi_row *row);
void sfi_row_free(sfi_row *row);

// Make a row empty again.
void sfi_row_clear(sfi_row *row);

// Add to the weight of a column.
void sfi_row_add(sfi_row *row, uint32_t column, double weight);

// A matrix being filled row by row; what it needs beside the matrix.
typedef struct sfi_matrix_maker {
    sfi_matrix matrix;
    uint32_t *slots; // a hash table of rows that brought new weights
    size_t slot_count, slots_used;
    size_t item_count, pool_count;
} sfi_matrix_maker;

// Begin a matrix of `rows` rows. SF_ERR_MEMORY.
sf_status sfi_matrix_begin(const sf_allocator *allocator, uint32_t rows, uint32_t columns,
                           sfi_matrix_maker *maker);

// Append a row. SF_ERR_MEMORY; SF_ERR_OVERFLOW.
sf_status sfi_matrix_append(sfi_matrix_maker *maker, uint32_t row_number, sfi_row *row);

// Finish: the maker holds nothing afterwards. Also to give up, with NULL.
void sfi_matrix_end(sfi_matrix_maker *maker, sfi_matrix *matrix);

void sfi_matrix_free(sfi_matrix *matrix);

// out = matrix * in, for 1, 3 or 4 numbers at each point, by blocks of rows on the task's threads.
// A row whose inputs are all equal gives just that. `out` is not `in`.
void sfi_matrix_apply(const sfi_matrix *matrix, uint32_t width, const double *in, double *out,
                      sf_task *task);

#endif
