// SPDX-License-Identifier: MIT
// From what a file said to a cage.
//
// Elements of the largest dimension that the file has become the cells; what they name is looked up
// now that all points are known; cells that are the wrong way out are turned. Data of points stay
// data of points; data of cells become one value for each cell, which all of its corners name. In a
// file of sf_cage_write_vtk() some points are copies of one point, with other values of a property
// that jumps there: they are joined again, and the property's corners name the values of the
// copies. Copies with the same value name it together, so that a property that does not jump at a
// place has one value there, whatever other properties do.

#include "io/cage_raw.h"

#include "base/memory.h"
#include "base/status.h"
#include "io/cage_hanging.h"
#include "io/cage_turn.h"
#include "mesh/heap.h"

#include <string.h>

typedef struct making {
    sfi_raw *raw;
    const sf_allocator *allocator;
    uint32_t dimension;
    size_t cells, corners, points;
    uint32_t *starts;  // cells + 1
    uint32_t *copies;  // corners, as the file names them
    uint32_t *items;   // corners, as points of the cage; where nothing is joined, the same array
    double *positions; // of the points; where nothing is joined, the file's
    sf_crease *creases;
    sf_sharp_point *sharps;
    size_t channel_count;
    sf_channel channels[SF_PROPERTY_MAX]; // values and indices belong to `making`, or to the file
    double *values[SF_PROPERTY_MAX];      // what belongs to `making`, or NULL
    uint32_t *indices[SF_PROPERTY_MAX];
} making;

static const sfi_raw_cell *cell_at(const sfi_raw *raw, size_t index)
{
    return (const sfi_raw_cell *)raw->cells.items + index;
}

static void end(making *m)
{
    const sf_allocator *allocator = m->allocator;
    for (size_t i = 0; i < m->channel_count; i++) {
        sfi_free_array(allocator, m->values[i], m->channels[i].value_count, sizeof(double));
        sfi_free_array(allocator, m->indices[i], m->corners, sizeof(uint32_t));
    }
    if (m->raw->joins != NULL) {
        sfi_free_array(allocator, m->items, m->corners, sizeof *m->items);
        sfi_free_array(allocator, m->positions, 3 * m->points, sizeof *m->positions);
    }
    sfi_free_array(allocator, m->sharps, m->raw->sharps.count, sizeof *m->sharps);
    sfi_free_array(allocator, m->creases, m->raw->creases.count, sizeof *m->creases);
    sfi_free_array(allocator, m->copies, m->corners, sizeof *m->copies);
    sfi_free_array(allocator, m->starts, m->cells + 1, sizeof *m->starts);
    sfi_free_array(allocator, m, 1, sizeof *m);
}

// --- cells ---------------------------------------------------------------------------------------

// Which elements are the cells, and how many corners they have.
static sf_status choose(making *m)
{
    const sfi_raw *raw = m->raw;
    for (size_t i = 0; i < raw->cells.count; i++) {
        const sfi_raw_cell *cell = cell_at(raw, i);
        if (cell->dimension > m->dimension) {
            m->dimension = cell->dimension;
        }
    }
    if (m->dimension < 2) {
        m->dimension = 0;
        return sfi_cursor_fault(raw->cursor, raw->fault,
                                "the file holds no cells and no faces; check what was exported");
    }
    for (size_t i = 0; i < raw->cells.count; i++) {
        const sfi_raw_cell *cell = cell_at(raw, i);
        m->cells += cell->dimension == m->dimension;
        m->corners += cell->dimension == m->dimension ? cell->count : 0;
    }
    return SF_OK;
}

static sf_status check_corners(const sfi_raw *raw, const sfi_raw_cell *cell)
{
    const uint32_t *corners = (const uint32_t *)raw->corners.items + cell->start;
    for (uint32_t i = 0; i < cell->count; i++) {
        if (corners[i] >= raw->positions.count) {
            return sfi_fault_set(raw->fault, SF_ERR_FORMAT, cell->line, 0,
                                 "an element names point %lu; the file has %zu, counted from %lu",
                                 (unsigned long)corners[i] + raw->first_number,
                                 raw->positions.count, (unsigned long)raw->first_number);
        }
    }
    return SF_OK;
}

static sf_status take_cells(making *m)
{
    const sfi_raw *raw = m->raw;
    size_t kept = 0;
    m->starts = sfi_alloc_array(m->allocator, m->cells + 1, sizeof *m->starts);
    m->copies = sfi_alloc_array(m->allocator, m->corners, sizeof *m->copies);
    if (m->starts == NULL || m->copies == NULL) {
        return SF_ERR_MEMORY;
    }
    m->starts[0] = 0;
    for (size_t i = 0; i < raw->cells.count; i++) {
        const sfi_raw_cell *cell = cell_at(raw, i);
        SF_TRY(check_corners(raw, cell));
        if (cell->dimension == m->dimension) {
            memcpy(m->copies + m->starts[kept], (uint32_t *)raw->corners.items + cell->start,
                   cell->count * sizeof *m->copies);
            m->starts[kept + 1] = m->starts[kept] + cell->count;
            kept++;
        }
    }
    return SF_OK;
}

static size_t turn_cells(making *m)
{
    size_t turned = 0;
    for (size_t i = 0; m->dimension == 3 && i < m->cells; i++) {
        uint32_t count = m->starts[i + 1] - m->starts[i];
        turned += (size_t)sfi_cell_turn(m->copies + m->starts[i], count, m->raw->positions.items);
    }
    return turned;
}

// --- points --------------------------------------------------------------------------------------

static sf_status refuse_joins(const sfi_raw *raw)
{
    return sfi_cursor_fault(raw->cursor, raw->fault,
                            "the data \"sf_point\" do not name the points that others are copies "
                            "of; remove them from the file");
}

// One position for all copies of a point; each must have it.
static sf_status join_positions(making *m)
{
    const sfi_raw *raw = m->raw;
    const double *from = raw->positions.items;
    uint8_t *seen = sfi_alloc_array(m->allocator, m->points, 1);
    if (seen == NULL) {
        return SF_ERR_MEMORY;
    }
    memset(seen, 0, m->points);
    size_t found = 0;
    int agree = 1;
    for (size_t i = 0; i < raw->positions.count; i++) {
        double *to = m->positions + 3 * (size_t)raw->joins[i];
        if (!seen[raw->joins[i]]) {
            memcpy(to, from + 3 * i, 3 * sizeof *to);
            seen[raw->joins[i]] = 1;
            found++;
        }
        agree = agree && memcmp(to, from + 3 * i, 3 * sizeof *to) == 0;
    }
    sfi_free_array(m->allocator, seen, m->points, 1);
    return agree && found == m->points ? SF_OK : refuse_joins(raw);
}

static sf_status take_points(making *m)
{
    const sfi_raw *raw = m->raw;
    m->points = raw->positions.count;
    m->positions = raw->positions.items;
    m->items = m->copies;
    if (raw->joins == NULL) {
        return SF_OK;
    }
    m->points = 0;
    for (size_t i = 0; i < raw->positions.count; i++) {
        m->points = raw->joins[i] >= m->points ? (size_t)raw->joins[i] + 1 : m->points;
    }
    m->positions = NULL;
    m->items = NULL;
    if (m->points > raw->positions.count) {
        m->points = 0;
        return refuse_joins(raw);
    }
    m->positions = sfi_alloc_array(m->allocator, 3 * m->points, sizeof *m->positions);
    m->items = sfi_alloc_array(m->allocator, m->corners, sizeof *m->items);
    if (m->positions == NULL || m->items == NULL) {
        return SF_ERR_MEMORY;
    }
    for (size_t i = 0; i < m->corners; i++) {
        m->items[i] = raw->joins[m->copies[i]];
    }
    return join_positions(m);
}

// --- what is sharp -------------------------------------------------------------------------------

static sf_status take_sharp(making *m)
{
    const sfi_raw *raw = m->raw;
    const sfi_raw_mark *creases = raw->creases.items, *sharps = raw->sharps.items;
    if (raw->creases.count > 0) {
        m->creases = sfi_alloc_array(m->allocator, raw->creases.count, sizeof *m->creases);
    }
    if (raw->sharps.count > 0) {
        m->sharps = sfi_alloc_array(m->allocator, raw->sharps.count, sizeof *m->sharps);
    }
    if ((raw->creases.count > 0 && m->creases == NULL) ||
        (raw->sharps.count > 0 && m->sharps == NULL)) {
        return SF_ERR_MEMORY;
    }
    for (size_t i = 0; i < raw->creases.count; i++) {
        sf_crease crease = {{creases[i].points[0], creases[i].points[1]}, creases[i].sharpness};
        m->creases[i] = crease;
    }
    for (size_t i = 0; i < raw->sharps.count; i++) {
        sf_sharp_point sharp = {sharps[i].points[0], sharps[i].sharpness};
        m->sharps[i] = sharp;
    }
    return SF_OK;
}

// --- properties ----------------------------------------------------------------------------------

// The next channel, with places of its own for values and (when `indexed`) indices.
static sf_status add_channel(making *m, const sf_property *property, size_t values, int indexed)
{
    if (m->channel_count == SF_PROPERTY_MAX) {
        return sfi_raw_unsupported(m->raw, "the file has more than 64 sets of data; remove some");
    }
    size_t i = m->channel_count;
    sf_channel channel = {*property, values, NULL, NULL};
    m->values[i] = sfi_alloc_array(m->allocator, values, sizeof(double));
    m->indices[i] = indexed ? sfi_alloc_array(m->allocator, m->corners, sizeof(uint32_t)) : NULL;
    channel.values = m->values[i];
    channel.indices = m->indices[i];
    m->channels[i] = channel;
    m->channel_count++;
    return m->values[i] != NULL && (!indexed || m->indices[i] != NULL) ? SF_OK : SF_ERR_MEMORY;
}

// One value for each cell: those of the file's elements (values), or their references (NULL).
static sf_status add_by_cell(making *m, const sf_property *property, const double *values)
{
    size_t kept = 0;
    SF_TRY(add_channel(m, property, m->cells, 1));
    double *to = m->values[m->channel_count - 1];
    uint32_t *indices = m->indices[m->channel_count - 1];
    for (size_t i = 0; i < m->raw->cells.count; i++) {
        const sfi_raw_cell *cell = cell_at(m->raw, i);
        if (cell->dimension != m->dimension) {
            continue;
        }
        to[kept] = values != NULL ? values[i] : cell->reference;
        for (uint32_t j = m->starts[kept]; j < m->starts[kept + 1]; j++) {
            indices[j] = (uint32_t)kept;
        }
        kept++;
    }
    return SF_OK;
}

static sf_status add_references(making *m)
{
    const sfi_raw *raw = m->raw;
    const sfi_raw_cell *first = NULL;
    int differ = 0;
    for (size_t i = 0; raw->reference_name != NULL && i < raw->cells.count; i++) {
        const sfi_raw_cell *cell = cell_at(raw, i);
        if (cell->dimension == m->dimension) {
            first = first == NULL ? cell : first;
            differ = differ || cell->reference != first->reference;
        }
    }
    if (!differ) {
        return SF_OK;
    }
    sf_property property;
    SF_TRY(sfi_raw_property(m->raw, raw->reference_name, &property));
    return add_by_cell(m, &property, NULL);
}

// Copies in the order of their points, then of their values, then of their numbers.
typedef struct copy_order {
    const uint32_t *joins;
    const double *values;
} copy_order;

static int copy_before(const void *user, uint32_t a, uint32_t b)
{
    const copy_order *o = user;
    if (o->joins[a] != o->joins[b]) {
        return o->joins[a] < o->joins[b];
    }
    return o->values[a] != o->values[b] ? o->values[a] < o->values[b] : a < b;
}

// For each copy the first one of its point that has its value. They are sorted, since thousands of
// cells may meet in a point. `order` is scratch.
static void find_first_alike(const copy_order *o, size_t copies, uint32_t *order, uint32_t *alike)
{
    for (uint32_t i = 0; i < copies; i++) {
        order[i] = i;
    }
    sfi_heap_sort(order, copies, copy_before, o);
    for (size_t i = 0; i < copies; i++) {
        uint32_t copy = order[i], last = i > 0 ? order[i - 1] : copy;
        int same = o->joins[copy] == o->joins[last] && o->values[copy] == o->values[last];
        alike[copy] = i > 0 && same ? alike[last] : copy;
    }
}

// Where all copies of a point have the same value, the points have it; elsewhere each corner names
// the first copy of its point that has its value. `firsts`: for each point, its first copy; `order`
// and `alike`: scratch, one for each copy.
static sf_status add_joined(making *m, const sfi_raw_array *array, const uint32_t *firsts,
                            uint32_t *order, uint32_t *alike)
{
    copy_order o = {m->raw->joins, array->values};
    int jumps = 0;
    for (size_t i = 0; i < array->count && !jumps; i++) {
        jumps = array->values[i] != array->values[firsts[m->raw->joins[i]]];
    }
    SF_TRY(add_channel(m, &array->property, jumps ? array->count : m->points, jumps));
    double *values = m->values[m->channel_count - 1];
    if (!jumps) {
        for (size_t i = 0; i < m->points; i++) {
            values[i] = array->values[firsts[i]];
        }
        return SF_OK;
    }
    memcpy(values, array->values, array->count * sizeof *values);
    find_first_alike(&o, array->count, order, alike);
    for (size_t i = 0; i < m->corners; i++) {
        m->indices[m->channel_count - 1][i] = alike[m->copies[i]];
    }
    return SF_OK;
}

static sf_status add_by_point(making *m, const sfi_raw_array *array)
{
    size_t copies = m->raw->positions.count;
    if (m->raw->joins == NULL) {
        SF_TRY(add_channel(m, &array->property, array->count, 0));
        memcpy(m->values[m->channel_count - 1], array->values, array->count * sizeof(double));
        return SF_OK;
    }
    uint32_t *firsts = sfi_alloc_array(m->allocator, m->points, sizeof *firsts);
    uint32_t *order = sfi_alloc_array(m->allocator, copies, sizeof *order);
    uint32_t *alike = sfi_alloc_array(m->allocator, copies, sizeof *alike);
    sf_status status = SF_ERR_MEMORY;
    if (firsts != NULL && order != NULL && alike != NULL) {
        memset(firsts, 0xff, m->points * sizeof *firsts);
        for (size_t i = copies; i-- > 0;) {
            firsts[m->raw->joins[i]] = (uint32_t)i;
        }
        status = add_joined(m, array, firsts, order, alike);
    }
    sfi_free_array(m->allocator, alike, copies, sizeof *alike);
    sfi_free_array(m->allocator, order, copies, sizeof *order);
    sfi_free_array(m->allocator, firsts, m->points, sizeof *firsts);
    return status;
}

static sf_status take_properties(making *m)
{
    const sfi_raw *raw = m->raw;
    SF_TRY(add_references(m));
    for (size_t i = 0; i < raw->arrays.count; i++) {
        const sfi_raw_array *array = (const sfi_raw_array *)raw->arrays.items + i;
        size_t expected = array->by_cell ? raw->cells.count : raw->positions.count;
        if (array->count != expected) {
            return sfi_fault_set(raw->fault, SF_ERR_FORMAT, raw->cursor->line, 0,
                                 "the data \"%s\" have %zu values for %zu %s", array->property.name,
                                 array->count, expected, array->by_cell ? "elements" : "points");
        }
        SF_TRY(array->by_cell ? add_by_cell(m, &array->property, array->values)
                              : add_by_point(m, array));
    }
    return SF_OK;
}

// --- all of it -----------------------------------------------------------------------------------

// A boundary that meets itself because of hanging nodes is refused with that for a reason.
static void explain(const making *m, const sf_cage_view *view)
{
    sfi_hanging found = {0, {0, 0}};
    if (m->raw->fault != NULL && sfi_hanging_find(view, m->allocator, &found)) {
        unsigned long add = m->raw->first_number;
        (void)sfi_fault_set(
            m->raw->fault, SF_ERR_UNSUPPORTED, 0, 0,
            "the mesh has hanging nodes: point %lu of one cell lies in the middle "
            "of the edge of points %lu and %lu of another; split that cell as well, "
            "or join the others",
            found.point + add, found.ends[0] + add, found.ends[1] + add);
    }
}

// What is wrong with the arrays is wrong with the file.
static sf_status create(const making *m, sf_cage **cage)
{
    const sfi_raw *raw = m->raw;
    sf_cage_view view = {m->dimension,      m->points, m->positions,       m->cells,
                         m->starts,         m->items,  raw->creases.count, m->creases,
                         raw->sharps.count, m->sharps, m->channel_count,   m->channels};
    sf_fault *fault = raw->fault;
    sf_status status = sf_cage_create(&view, m->allocator, cage, fault);
    if (status == SF_ERR_OVERFLOW) {
        return sfi_fault_set(fault, status, 0, 0, "the cage has too many faces or edges");
    }
    if (status == SF_ERR_UNSUPPORTED) {
        explain(m, &view);
    }
    if (status != SF_ERR_ARGUMENT) {
        return status;
    }
    if (fault != NULL) {
        fault->status = SF_ERR_FORMAT;
    }
    return SF_ERR_FORMAT;
}

static sf_status make(making *m, sf_cage **cage, sf_cage_reading *reading)
{
    SF_TRY(choose(m));
    SF_TRY(take_cells(m));
    size_t turned = turn_cells(m);
    SF_TRY(take_points(m));
    SF_TRY(take_sharp(m));
    SF_TRY(take_properties(m));
    SF_TRY(create(m, cage));
    reading->turned_cells = turned;
    reading->passed_over = m->raw->cells.count - m->cells;
    return SF_OK;
}

sf_status sfi_raw_make(sfi_raw *raw, sf_cage **cage, sf_cage_reading *reading)
{
    const sf_allocator *allocator = &raw->cursor->allocator;
    making *m = sfi_alloc_array(allocator, 1, sizeof *m);
    if (m == NULL) {
        return SF_ERR_MEMORY;
    }
    memset(m, 0, sizeof *m);
    m->raw = raw;
    m->allocator = allocator;
    sf_status status = make(m, cage, reading);
    end(m);
    return status;
}
