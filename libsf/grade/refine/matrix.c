// SPDX-License-Identifier: MIT
// Sparse matrices of subdivision.
//
// Most rows of a refinement are one of a few: the weights of a regular edge are the same for all of
// them. So rows keep their columns, sorted by falling weight, and share their weights: what is read
// for a row is little more than the numbers of its columns.
//
// A row is evaluated as x0 + w1 (x1 - x0) + w2 (x2 - x0) + ...: where all inputs are equal the
// output is the same number, not one that rounding has moved. A property that is constant on one
// side of an interface stays exactly that.

#include "grade/refine/matrix.h"

#include "base/memory.h"
#include "base/status.h"
#include "base/task.h"

#include <string.h>

enum { BLOCK_ROWS = 8192 };

int sfi_row_begin(const sf_allocator *allocator, uint32_t columns, sfi_row *row)
{
    sfi_row made = {0};
    made.allocator = *allocator;
    made.columns = columns;
    made.places = sfi_alloc_array(allocator, columns, sizeof *made.places);
    if (made.places == NULL) {
        return 0;
    }
    memset(made.places, 0, columns * sizeof *made.places);
    *row = made;
    return 1;
}

void sfi_row_free(sfi_row *row)
{
    sfi_free_array(&row->allocator, row->items, row->capacity, sizeof *row->items);
    sfi_free_array(&row->allocator, row->weights, row->capacity, sizeof *row->weights);
    sfi_free_array(&row->allocator, row->places, row->columns, sizeof *row->places);
    memset(row, 0, sizeof *row);
}

void sfi_row_clear(sfi_row *row)
{
    row->count = 0;
}

static int row_grow(sfi_row *row)
{
    size_t capacity = row->capacity;
    if (row->count < capacity) {
        return 1;
    }
    size_t wanted = capacity < 32 ? 64 : 2 * capacity;
    uint32_t *items = sfi_alloc_array(&row->allocator, wanted, sizeof *items);
    double *weights = sfi_alloc_array(&row->allocator, wanted, sizeof *weights);
    if (items == NULL || weights == NULL) {
        sfi_free_array(&row->allocator, items, wanted, sizeof *items);
        sfi_free_array(&row->allocator, weights, wanted, sizeof *weights);
        return 0;
    }
    if (capacity > 0) {
        memcpy(items, row->items, capacity * sizeof *items);
        memcpy(weights, row->weights, capacity * sizeof *weights);
    }
    sfi_free_array(&row->allocator, row->items, capacity, sizeof *items);
    sfi_free_array(&row->allocator, row->weights, capacity, sizeof *weights);
    row->items = items;
    row->weights = weights;
    row->capacity = wanted;
    return 1;
}

void sfi_row_add(sfi_row *row, uint32_t column, double weight)
{
    uint32_t place = row->places[column];
    if (place < row->count && row->items[place] == column) {
        row->weights[place] += weight;
        return;
    }
    if (!row_grow(row)) {
        row->failed = 1;
        return;
    }
    row->items[row->count] = column;
    row->weights[row->count] = weight;
    row->places[column] = row->count++;
}

// By falling weight, then by column: rows are short, so by insertion.
static void row_sort(sfi_row *row)
{
    for (uint32_t i = 1; i < row->count; i++) {
        double weight = row->weights[i];
        uint32_t item = row->items[i], j = i;
        for (; j > 0 && (row->weights[j - 1] < weight ||
                         (row->weights[j - 1] == weight && row->items[j - 1] > item));
             j--) {
            row->weights[j] = row->weights[j - 1];
            row->items[j] = row->items[j - 1];
        }
        row->weights[j] = weight;
        row->items[j] = item;
    }
    while (row->count > 0 && row->weights[row->count - 1] == 0) {
        row->count--;
    }
}

sf_status sfi_matrix_begin(const sf_allocator *allocator, uint32_t rows, uint32_t columns,
                           sfi_matrix_maker *maker)
{
    memset(maker, 0, sizeof *maker);
    sfi_matrix *m = &maker->matrix;
    m->allocator = *allocator;
    m->rows = rows;
    m->columns = columns;
    m->starts = sfi_alloc_array(allocator, (size_t)rows + 1, sizeof *m->starts);
    m->weights = sfi_alloc_array(allocator, (size_t)rows + 1, sizeof *m->weights);
    maker->slot_count = 1024;
    maker->slots = sfi_alloc_array(allocator, maker->slot_count, sizeof *maker->slots);
    if (m->starts == NULL || m->weights == NULL || maker->slots == NULL) {
        sfi_matrix_end(maker, NULL);
        return SF_ERR_MEMORY;
    }
    memset(maker->slots, 0xff, maker->slot_count * sizeof *maker->slots);
    m->starts[0] = 0;
    return SF_OK;
}

static uint64_t hash_weights(const double *weights, uint32_t count)
{
    uint64_t h = count;
    for (uint32_t i = 0; i < count; i++) {
        uint64_t bits;
        memcpy(&bits, &weights[i], sizeof bits);
        h = (h ^ bits) * 0x9e3779b97f4a7c15u;
        h ^= h >> 29;
    }
    return h;
}

static size_t find_slot(const sfi_matrix_maker *maker, const double *weights, uint32_t count)
{
    const sfi_matrix *m = &maker->matrix;
    size_t at = (size_t)hash_weights(weights, count) & (maker->slot_count - 1);
    for (; maker->slots[at] != UINT32_MAX; at = (at + 1) & (maker->slot_count - 1)) {
        uint32_t row = maker->slots[at];
        if (m->starts[row + 1] - m->starts[row] == count &&
            memcmp(m->pool + m->weights[row], weights, count * sizeof *weights) == 0) {
            break;
        }
    }
    return at;
}

static sf_status grow_slots(sfi_matrix_maker *maker)
{
    if (2 * maker->slots_used < maker->slot_count) {
        return SF_OK;
    }
    sfi_matrix *m = &maker->matrix;
    sfi_matrix_maker larger = *maker;
    larger.slot_count = 2 * maker->slot_count;
    larger.slots = sfi_alloc_array(&m->allocator, larger.slot_count, sizeof *larger.slots);
    if (larger.slots == NULL) {
        return SF_ERR_MEMORY;
    }
    memset(larger.slots, 0xff, larger.slot_count * sizeof *larger.slots);
    for (size_t i = 0; i < maker->slot_count; i++) {
        uint32_t row = maker->slots[i];
        if (row != UINT32_MAX) {
            size_t at =
                find_slot(&larger, m->pool + m->weights[row], m->starts[row + 1] - m->starts[row]);
            larger.slots[at] = row;
        }
    }
    sfi_free_array(&m->allocator, maker->slots, maker->slot_count, sizeof *maker->slots);
    maker->slots = larger.slots;
    maker->slot_count = larger.slot_count;
    return SF_OK;
}

sf_status sfi_matrix_append(sfi_matrix_maker *maker, uint32_t row_number, sfi_row *row)
{
    sfi_matrix *m = &maker->matrix;
    size_t need = maker->item_count + row->count, pool_need = maker->pool_count + row->count;
    if (row->failed) {
        return SF_ERR_MEMORY;
    }
    if (need > INT32_MAX) {
        return SF_ERR_OVERFLOW;
    }
    if (!sfi_grow_array(&m->allocator, (void **)&m->items, &m->item_capacity, need,
                        sizeof *m->items) ||
        !sfi_grow_array(&m->allocator, (void **)&m->pool, &m->pool_capacity, pool_need,
                        sizeof *m->pool)) {
        return SF_ERR_MEMORY;
    }
    row_sort(row);
    memcpy(m->items + maker->item_count, row->items, row->count * sizeof *m->items);
    maker->item_count += row->count;
    m->starts[row_number + 1] = (uint32_t)maker->item_count;
    size_t slot = find_slot(maker, row->weights, row->count);
    if (maker->slots[slot] != UINT32_MAX) {
        m->weights[row_number] = m->weights[maker->slots[slot]];
        return SF_OK;
    }
    memcpy(m->pool + maker->pool_count, row->weights, row->count * sizeof *m->pool);
    m->weights[row_number] = (uint32_t)maker->pool_count;
    maker->pool_count += row->count;
    maker->slots[slot] = row_number;
    maker->slots_used++;
    return grow_slots(maker);
}

void sfi_matrix_end(sfi_matrix_maker *maker, sfi_matrix *matrix)
{
    sfi_free_array(&maker->matrix.allocator, maker->slots, maker->slot_count, sizeof *maker->slots);
    if (matrix != NULL) {
        *matrix = maker->matrix;
    } else {
        sfi_matrix_free(&maker->matrix);
    }
    memset(maker, 0, sizeof *maker);
}

void sfi_matrix_free(sfi_matrix *matrix)
{
    const sf_allocator *allocator = &matrix->allocator;
    size_t rows = (size_t)matrix->rows + 1;
    sfi_free_array(allocator, matrix->starts, rows, sizeof *matrix->starts);
    sfi_free_array(allocator, matrix->weights, rows, sizeof *matrix->weights);
    sfi_free_array(allocator, matrix->items, matrix->item_capacity, sizeof *matrix->items);
    sfi_free_array(allocator, matrix->pool, matrix->pool_capacity, sizeof *matrix->pool);
    memset(matrix, 0, sizeof *matrix);
}

typedef struct product {
    const sfi_matrix *matrix;
    uint32_t width;
    const double *in;
    double *out;
} product;

// Rows for `width` numbers at a point. Called with a constant, so that a compiler can lay the sums
// side by side.
static inline void apply_rows(const sfi_matrix *m, uint32_t width, uint32_t from, uint32_t to,
                              const double *in, double *out)
{
    for (uint32_t row = from; row < to; row++) {
        const uint32_t *items = m->items + m->starts[row];
        const double *weights = m->pool + m->weights[row];
        uint32_t count = m->starts[row + 1] - m->starts[row];
        const double *base = in + (size_t)items[0] * width;
        double sum[4] = {0, 0, 0, 0};
        for (uint32_t i = 1; i < count; i++) {
            const double *p = in + (size_t)items[i] * width;
            for (uint32_t c = 0; c < width; c++) {
                sum[c] += weights[i] * (p[c] - base[c]);
            }
        }
        for (uint32_t c = 0; c < width; c++) {
            out[(size_t)row * width + c] = base[c] + sum[c];
        }
    }
}

static void apply_block(void *context, size_t index)
{
    const product *p = context;
    uint32_t from = (uint32_t)(index * BLOCK_ROWS), to = from + BLOCK_ROWS;
    to = to < p->matrix->rows ? to : p->matrix->rows;
    switch (p->width) {
    case 1:
        apply_rows(p->matrix, 1, from, to, p->in, p->out);
        break;
    case 3:
        apply_rows(p->matrix, 3, from, to, p->in, p->out);
        break;
    default:
        apply_rows(p->matrix, 4, from, to, p->in, p->out);
    }
}

void sfi_matrix_apply(const sfi_matrix *matrix, uint32_t width, const double *in, double *out,
                      sf_task *task)
{
    product p = {matrix, width, in, out};
    sfi_task_for(task, ((size_t)matrix->rows + BLOCK_ROWS - 1) / BLOCK_ROWS, apply_block, &p);
}
