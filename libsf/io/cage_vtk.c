// SPDX-License-Identifier: MIT
// Cages from legacy VTK files: which cells a cage can have, and which data are properties.
//
// The type of a cell says how many corners it has; a file in which the two disagree is refused,
// because either may be the one that is wrong, and both readings give a cage. Voxels and pixels
// have their corners in rows and are turned into cells that have them in rings. Data of points and
// cells with one component are properties. Programs like to give both the same name; those of cells
// are then called "NAME of cells".

#include "io/cage_vtk.h"

#include "base/status.h"
#include "io/cage_raw.h"
#include "io/vtk_read.h"

#include <math.h>

typedef struct kind {
    uint32_t dimension, corners; // dimension 0 with no corners: no cage has it; corners 0: any
    int in_rows;
} kind;

// By VTK's numbers.
static const kind kinds[] = {
    {0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {1, 2, 0},  {1, 0, 0},  {2, 3, 0},
    {0, 0, 0}, {2, 0, 0}, {2, 4, 1}, {2, 4, 0},  {3, 4, 0},  {3, 8, 1},
    {3, 8, 0}, {3, 6, 0}, {0, 0, 0}, {3, 10, 0}, {3, 12, 0},
};

static sf_status take_cell(sfi_raw *raw, const sfi_vtk *vtk, size_t index)
{
    const uint32_t *starts = vtk->starts.items;
    uint32_t type = ((const uint32_t *)vtk->types.items)[index], start = starts[index];
    uint32_t count = starts[index + 1] - start;
    uint32_t line = index < vtk->lines.count ? ((const uint32_t *)vtk->lines.items)[index] : 0;
    kind k = type < sizeof kinds / sizeof kinds[0] ? kinds[type] : kinds[0];
    if (k.dimension == 0) {
        return sfi_fault_set(raw->fault, SF_ERR_UNSUPPORTED, line, 0,
                             "cell %zu of the file is of VTK's type %lu; a cage has tetrahedra, "
                             "prisms and hexahedra, or faces, all with straight edges",
                             index, (unsigned long)type);
    }
    if (k.corners != 0 ? count != k.corners : count < k.dimension + 1) {
        return sfi_fault_set(raw->fault, SF_ERR_FORMAT, line, 0,
                             "cell %zu of the file is of VTK's type %lu and has %lu corners, which "
                             "disagree; one of the two is wrong",
                             index, (unsigned long)type, (unsigned long)count);
    }
    uint32_t *corners = (uint32_t *)raw->corners.items + start;
    for (uint32_t i = 2; k.in_rows && i < count; i += 4) {
        uint32_t kept = corners[i];
        corners[i] = corners[i + 1];
        corners[i + 1] = kept;
    }
    sfi_raw_cell cell = {0, start, count, line, k.dimension};
    return sfi_raw_push(raw, &raw->cells, &cell);
}

// Points and corners change hands; cells are made.
static sf_status take_cells(sfi_raw *raw, sfi_vtk *vtk)
{
    raw->positions = vtk->points;
    raw->corners = vtk->corners;
    vtk->points = sfi_list_of(vtk->points.size);
    vtk->corners = sfi_list_of(vtk->corners.size);
    for (size_t i = 0; i < vtk->types.count; i++) {
        SF_TRY(take_cell(raw, vtk, i));
    }
    return SF_OK;
}

// --- what our own writer adds --------------------------------------------------------------------

static sf_status refuse(sfi_raw *raw, const char *name)
{
    return sfi_fault_set(raw->fault, SF_ERR_FORMAT, 0, 0,
                         "the data \"%.40s\" are not as libsf writes them; remove them from the "
                         "file",
                         name);
}

static int is_whole(double value, double low, double high)
{
    return value >= low && value <= high && value == floor(value);
}

// Rows of `columns` numbers, the last one a sharpness, the others points.
static sf_status take_marks(sfi_raw *raw, const sfi_vtk *vtk, const char *name, uint32_t columns,
                            sfi_list *marks)
{
    const sfi_vtk_array *array = sfi_vtk_find(vtk, SFI_VTK_FIELD, name);
    if (array == NULL) {
        return SF_OK;
    }
    if (array->components != columns || array->values.count / columns >= SF_CAGE_POINT_MAX) {
        return refuse(raw, name);
    }
    const double *values = array->values.items;
    for (size_t i = 0; i < array->values.count; i += columns) {
        if (!is_whole(values[i], 0, SF_CAGE_POINT_MAX) ||
            !is_whole(values[i + columns - 2], 0, SF_CAGE_POINT_MAX)) {
            return refuse(raw, name);
        }
        sfi_raw_mark mark = {
            values[i + columns - 1], {(uint32_t)values[i], (uint32_t)values[i + columns - 2]}, 0};
        SF_TRY(sfi_raw_push(raw, marks, &mark));
    }
    return SF_OK;
}

// What a property is, where the file says so; else what its name makes of it.
static sf_status describe(sfi_raw *raw, const sfi_vtk *vtk, const char *name, sf_property *property)
{
    char field[sizeof SFI_VTK_PROPERTY_NAME + SF_PROPERTY_NAME_SIZE] = SFI_VTK_PROPERTY_NAME;
    SF_TRY(sfi_raw_property(raw, name, property));
    strcat(field, property->name);
    const sfi_vtk_array *array = sfi_vtk_find(vtk, SFI_VTK_FIELD, field);
    if (array == NULL) {
        return SF_OK;
    }
    const double *v = array->values.items;
    if (array->values.count != SFI_VTK_PROPERTY_NUMBERS) {
        return refuse(raw, field);
    }
    for (size_t i = 0; i < 23; i++) {
        if (!is_whole(v[i], i < 16 ? 0 : INT8_MIN, i < 16 ? UINT8_MAX : INT8_MAX)) {
            return refuse(raw, field);
        }
    }
    for (size_t i = 0; i < 16; i++) {
        property->uuid[i] = (uint8_t)v[i];
    }
    for (size_t i = 0; i < 7; i++) {
        property->si[i] = (int8_t)v[16 + i];
    }
    property->low = v[23] != 0 ? v[24] : -INFINITY;
    property->high = v[25] != 0 ? v[26] : INFINITY;
    return SF_OK;
}

static sf_status take_joins(sfi_raw *raw, const sfi_vtk *vtk)
{
    const sfi_vtk_array *array = sfi_vtk_find(vtk, SFI_VTK_POINTS, SFI_VTK_POINT_NAME);
    size_t count = raw->positions.count;
    if (array == NULL || count == 0) {
        return SF_OK;
    }
    if (array->values.count != count) {
        return refuse(raw, SFI_VTK_POINT_NAME);
    }
    raw->joins = sfi_alloc_array(&raw->cursor->allocator, count, sizeof *raw->joins);
    if (raw->joins == NULL) {
        return SF_ERR_MEMORY;
    }
    const double *values = array->values.items;
    for (size_t i = 0; i < count; i++) {
        if (!is_whole(values[i], 0, SF_CAGE_POINT_MAX)) {
            return refuse(raw, SFI_VTK_POINT_NAME);
        }
        raw->joins[i] = (uint32_t)values[i];
    }
    return SF_OK;
}

// --- data ----------------------------------------------------------------------------------------

static sf_status take_array(sfi_raw *raw, const sfi_vtk *vtk, const sfi_vtk_array *array)
{
    static const char of_cells[] = " of cells";
    char name[SFI_TOKEN_SIZE + sizeof of_cells];
    sfi_raw_array made;
    memcpy(name, array->name, strlen(array->name) + 1);
    if (array->home == SFI_VTK_CELLS && sfi_vtk_find(vtk, SFI_VTK_POINTS, name) != NULL) {
        strcat(name, of_cells);
    }
    SF_TRY(describe(raw, vtk, name, &made.property));
    made.by_cell = array->home == SFI_VTK_CELLS;
    made.values = array->values.items;
    made.count = array->values.count;
    return sfi_raw_push(raw, &raw->arrays, &made);
}

// The data that a field describes, by the name behind its prefix; NULL where it describes none.
static const sfi_vtk_array *described(const sfi_vtk *vtk, const sfi_vtk_array *field)
{
    size_t prefix = sizeof SFI_VTK_PROPERTY_NAME - 1;
    if (field->home != SFI_VTK_FIELD || strncmp(field->name, SFI_VTK_PROPERTY_NAME, prefix) != 0) {
        return NULL;
    }
    const sfi_vtk_array *found = sfi_vtk_find(vtk, SFI_VTK_POINTS, field->name + prefix);
    return found != NULL ? found : sfi_vtk_find(vtk, SFI_VTK_CELLS, field->name + prefix);
}

// Whether data are taken for a field's sake.
static int is_described(const sfi_vtk *vtk, const sfi_vtk_array *array)
{
    const sfi_vtk_array *arrays = vtk->arrays.items;
    for (size_t i = 0; i < vtk->arrays.count; i++) {
        if (described(vtk, &arrays[i]) == array) {
            return 1;
        }
    }
    return 0;
}

// First, in the order of the fields, the data that those describe; then all others.
static sf_status take_arrays(sfi_raw *raw, const sfi_vtk *vtk)
{
    const sfi_vtk_array *arrays = vtk->arrays.items;
    for (size_t i = 0; i < vtk->arrays.count; i++) {
        const sfi_vtk_array *array = described(vtk, &arrays[i]);
        if (array != NULL) {
            SF_TRY(take_array(raw, vtk, array));
        }
    }
    for (size_t i = 0; i < vtk->arrays.count; i++) {
        int is_join = strcmp(arrays[i].name, SFI_VTK_POINT_NAME) == 0;
        if (arrays[i].home != SFI_VTK_FIELD && !is_join && !is_described(vtk, &arrays[i])) {
            SF_TRY(take_array(raw, vtk, &arrays[i]));
        }
    }
    return SF_OK;
}

static sf_status take_all(sfi_raw *raw, sfi_vtk *vtk)
{
    SF_TRY(take_cells(raw, vtk));
    SF_TRY(take_marks(raw, vtk, SFI_VTK_CREASES_NAME, 3, &raw->creases));
    SF_TRY(take_marks(raw, vtk, SFI_VTK_SHARPS_NAME, 2, &raw->sharps));
    SF_TRY(take_joins(raw, vtk));
    return take_arrays(raw, vtk);
}

sf_status sfi_cage_vtk_read(sfi_raw *raw, sf_cage **cage, sf_cage_reading *reading)
{
    const sf_allocator *allocator = &raw->cursor->allocator;
    sfi_vtk vtk;
    sfi_vtk_begin(&vtk);
    vtk.points_max = raw->options.points_max;
    vtk.corners_max = raw->options.corners_max;
    sf_status status = sfi_vtk_read(&vtk, raw->cursor, raw->fault);
    if (status == SF_OK) {
        status = take_all(raw, &vtk);
    }
    if (status == SF_OK) {
        status = sfi_raw_make(raw, cage, reading);
    }
    sfi_free_array(allocator, raw->joins, raw->positions.count, sizeof *raw->joins);
    raw->joins = NULL;
    sfi_vtk_end(&vtk, allocator);
    return status;
}
