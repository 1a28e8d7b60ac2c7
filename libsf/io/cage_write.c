// SPDX-License-Identifier: MIT
// Cages out, as legacy VTK.
//
// Everything that is read of a view is checked before the first byte goes out; what only topology
// can tell is left to sf_cage_create(), so that a refined cage is written without being taken apart
// again. Wedges have their lower triangle counter-clockwise seen from above, as the shape functions
// of VTK want it, and not as its manual draws it.

#include <sf/cage_io.h>

#include "base/memory.h"
#include "base/status.h"
#include "io/cage_copies.h"
#include "io/cage_vtk.h"
#include "io/vtk_write.h"

#include <float.h>
#include <math.h>
#include <string.h>

static int is_finite(double value)
{
    return fabs(value) <= DBL_MAX;
}

// --- checks --------------------------------------------------------------------------------------

static sf_status refuse(sf_fault *fault, const char *what, size_t which, const char *why)
{
    return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "%s %zu %s", what, which, why);
}

static sf_status check_counts(const sf_cage_view *v, sf_fault *fault)
{
    if ((v->dimension != 2 && v->dimension != 3) || v->point_count == 0 || v->cell_count == 0 ||
        v->positions == NULL || v->starts == NULL || v->corners == NULL ||
        (v->crease_count > 0 && v->creases == NULL) || (v->sharp_count > 0 && v->sharps == NULL) ||
        (v->channel_count > 0 && v->channels == NULL) || v->channel_count > SF_PROPERTY_MAX) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                             "this is no cage: an array is missing, or the dimension is not 2 or "
                             "3, or there are more than 64 properties");
    }
    if (v->point_count > SF_CAGE_POINT_MAX || v->cell_count > SF_CAGE_POINT_MAX) {
        return sfi_fault_set(fault, SF_ERR_OVERFLOW, 0, 0,
                             "the cage has more points or cells than VTK can number");
    }
    return SF_OK;
}

// VTK's type of a cell; 0 if it has none.
static uint32_t type_of(uint32_t dimension, uint32_t corners)
{
    static const uint8_t cells[13] = {0, 0, 0, 0, 10, 0, 13, 0, 12, 0, 15, 0, 16};
    if (dimension == 2) {
        return corners == 3 ? 5 : corners == 4 ? 9 : corners > 4 ? 7 : 0;
    }
    return corners < sizeof cells ? cells[corners] : 0;
}

static sf_status check_cell(const sf_cage_view *v, size_t cell, sf_fault *fault)
{
    uint32_t start = v->starts[cell], end = v->starts[cell + 1];
    if (v->starts[0] != 0 || end < start || end > SF_CAGE_POINT_MAX) {
        return refuse(fault, "the corners of cell", cell, "begin behind those of the next");
    }
    if (type_of(v->dimension, end - start) == 0) {
        return sfi_fault_set(fault, SF_ERR_UNSUPPORTED, 0, 0,
                             "cell %zu has %lu corners; VTK has no type for it", cell,
                             (unsigned long)(end - start));
    }
    for (uint32_t j = start; j < end; j++) {
        if (v->corners[j] >= v->point_count) {
            return refuse(fault, "cell", cell, "names a point that there is not");
        }
    }
    return SF_OK;
}

static sf_status check_sharp(const sf_cage_view *v, sf_fault *fault)
{
    for (size_t i = 0; i < v->crease_count; i++) {
        if (v->creases[i].points[0] >= v->point_count ||
            v->creases[i].points[1] >= v->point_count || !(v->creases[i].sharpness >= 0)) {
            return refuse(fault, "crease", i, "names a point that there is not, or is not sharp");
        }
    }
    for (size_t i = 0; i < v->sharp_count; i++) {
        if (v->sharps[i].point >= v->point_count || !(v->sharps[i].sharpness >= 0)) {
            return refuse(fault, "sharp point", i,
                          "names a point that there is not, or is not sharp");
        }
    }
    return SF_OK;
}

static sf_status check_name(const sf_cage_view *v, size_t channel, sf_fault *fault)
{
    const sf_property *p = &v->channels[channel].property;
    if (p->name[0] == '\0' || memchr(p->name, '\0', sizeof p->name) == NULL) {
        return refuse(fault, "property", channel, "has no name, or one that does not end");
    }
    if (strcmp(p->name, SFI_VTK_POINT_NAME) == 0) {
        return refuse(fault, "property", channel, "has the name sf_point, which means copies");
    }
    for (size_t i = 0; i < channel; i++) {
        if (strcmp(p->name, v->channels[i].property.name) == 0) {
            return refuse(fault, "property", channel, "has the name of another");
        }
    }
    return p->low <= p->high ? SF_OK : refuse(fault, "property", channel, "has no bounds");
}

static sf_status check_channel(const sf_cage_view *v, size_t channel, sf_fault *fault)
{
    const sf_channel *c = &v->channels[channel];
    SF_TRY(check_name(v, channel, fault));
    if (c->values == NULL || (c->indices == NULL && c->value_count != v->point_count)) {
        return refuse(fault, "property", channel, "does not have one value for each point");
    }
    for (uint32_t i = 0; c->indices != NULL && i < v->starts[v->cell_count]; i++) {
        if (c->indices[i] >= c->value_count) {
            return refuse(fault, "property", channel, "names a value that there is not");
        }
    }
    for (size_t i = 0; i < c->value_count; i++) {
        if (!is_finite(c->values[i])) {
            return refuse(fault, "property", channel, "has a value that is not finite");
        }
    }
    return SF_OK;
}

static sf_status check(const sf_cage_view *v, sf_fault *fault)
{
    SF_TRY(check_counts(v, fault));
    for (size_t i = 0; i < v->cell_count; i++) {
        SF_TRY(check_cell(v, i, fault));
    }
    for (size_t i = 0; i < 3 * v->point_count; i++) {
        if (!is_finite(v->positions[i])) {
            return refuse(fault, "point", i / 3, "has a coordinate that is not finite");
        }
    }
    SF_TRY(check_sharp(v, fault));
    for (size_t i = 0; i < v->channel_count; i++) {
        SF_TRY(check_channel(v, i, fault));
    }
    return SF_OK;
}

// --- fields of the grid --------------------------------------------------------------------------

static double capped(double sharpness)
{
    return sharpness < SF_SHARP ? sharpness : SF_SHARP;
}

// "NAME components rows double", the line before an array of a field.
static void begin_array(sfi_vtk_writer *w, const char *before, const char *name, size_t components,
                        size_t rows, const char *type)
{
    sfi_vtk_write_text(w, before);
    sfi_vtk_write_name(w, name);
    sfi_vtk_write_text(w, " ");
    sfi_vtk_write_count(w, components);
    sfi_vtk_write_text(w, " ");
    sfi_vtk_write_count(w, rows);
    sfi_vtk_write_text(w, type);
}

static void write_property(sfi_vtk_writer *w, const sf_property *p)
{
    begin_array(w, SFI_VTK_PROPERTY_NAME, p->name, SFI_VTK_PROPERTY_NUMBERS, 1, " double\n");
    for (int i = 0; i < 16; i++) {
        sfi_vtk_write_double(w, p->uuid[i], 0);
    }
    for (int i = 0; i < 7; i++) {
        sfi_vtk_write_double(w, p->si[i], 0);
    }
    sfi_vtk_write_double(w, is_finite(p->low), 0);
    sfi_vtk_write_double(w, is_finite(p->low) ? p->low : 0, 0);
    sfi_vtk_write_double(w, is_finite(p->high), 0);
    sfi_vtk_write_double(w, is_finite(p->high) ? p->high : 0, 1);
    sfi_vtk_write_break(w);
}

static void begin_field(sfi_vtk_writer *w, size_t arrays)
{
    sfi_vtk_write_text(w, "FIELD FieldData ");
    sfi_vtk_write_count(w, arrays);
    sfi_vtk_write_text(w, "\n");
}

static void write_fields(sfi_vtk_writer *w, const sf_cage_view *v)
{
    size_t arrays = v->channel_count + (v->crease_count > 0) + (v->sharp_count > 0);
    if (arrays == 0) {
        return;
    }
    begin_field(w, arrays);
    if (v->crease_count > 0) {
        begin_array(w, "", SFI_VTK_CREASES_NAME, 3, v->crease_count, " double\n");
        for (size_t i = 0; i < v->crease_count; i++) {
            sfi_vtk_write_double(w, v->creases[i].points[0], 0);
            sfi_vtk_write_double(w, v->creases[i].points[1], 0);
            sfi_vtk_write_double(w, capped(v->creases[i].sharpness), 1);
        }
        sfi_vtk_write_break(w);
    }
    if (v->sharp_count > 0) {
        begin_array(w, "", SFI_VTK_SHARPS_NAME, 2, v->sharp_count, " double\n");
        for (size_t i = 0; i < v->sharp_count; i++) {
            sfi_vtk_write_double(w, v->sharps[i].point, 0);
            sfi_vtk_write_double(w, capped(v->sharps[i].sharpness), 1);
        }
        sfi_vtk_write_break(w);
    }
    for (size_t i = 0; i < v->channel_count; i++) {
        write_property(w, &v->channels[i].property);
    }
}

// --- points and cells ----------------------------------------------------------------------------

static void write_points(sfi_vtk_writer *w, const sf_cage_view *v, const sfi_copies *c)
{
    sfi_vtk_write_text(w, "POINTS ");
    sfi_vtk_write_count(w, c->points + c->extra);
    sfi_vtk_write_text(w, " double\n");
    for (size_t i = 0; i < c->points + c->extra; i++) {
        const double *p = v->positions + 3 * (i < c->points ? i : (size_t)c->point_of[i]);
        sfi_vtk_write_double(w, p[0], 0);
        sfi_vtk_write_double(w, p[1], 0);
        sfi_vtk_write_double(w, p[2], 1);
    }
    sfi_vtk_write_break(w);
}

static void write_cells(sfi_vtk_writer *w, const sf_cage_view *v, const sfi_copies *c)
{
    const uint32_t *corners = c->items != NULL ? c->items : v->corners;
    sfi_vtk_write_text(w, "CELLS ");
    sfi_vtk_write_count(w, v->cell_count);
    sfi_vtk_write_text(w, " ");
    sfi_vtk_write_count(w, v->cell_count + c->corners);
    sfi_vtk_write_text(w, "\n");
    for (size_t i = 0; i < v->cell_count; i++) {
        uint32_t start = v->starts[i], end = v->starts[i + 1];
        sfi_vtk_write_int(w, end - start, 0);
        for (uint32_t j = start; j < end; j++) {
            sfi_vtk_write_int(w, corners[j], j + 1 == end);
        }
    }
    sfi_vtk_write_break(w);
    sfi_vtk_write_text(w, "CELL_TYPES ");
    sfi_vtk_write_count(w, v->cell_count);
    sfi_vtk_write_text(w, "\n");
    for (size_t i = 0; i < v->cell_count; i++) {
        sfi_vtk_write_int(w, type_of(v->dimension, v->starts[i + 1] - v->starts[i]), 1);
    }
    sfi_vtk_write_break(w);
}

// --- data ----------------------------------------------------------------------------------------

static void begin_data(sfi_vtk_writer *w, const char *word, size_t rows, size_t arrays)
{
    sfi_vtk_write_text(w, word);
    sfi_vtk_write_count(w, rows);
    sfi_vtk_write_text(w, "\n");
    begin_field(w, arrays);
}

static size_t count_forms(const sf_cage_view *v, const sfi_channel_form *forms, int by_cell)
{
    size_t count = 0;
    for (size_t i = 0; i < v->channel_count; i++) {
        count += (forms[i] == SFI_BY_CELL) == by_cell;
    }
    return count;
}

static void write_cell_data(sfi_vtk_writer *w, const sf_cage_view *v, const sfi_channel_form *forms)
{
    size_t arrays = count_forms(v, forms, 1);
    if (arrays == 0) {
        return;
    }
    begin_data(w, "CELL_DATA ", v->cell_count, arrays);
    for (size_t i = 0; i < v->channel_count; i++) {
        if (forms[i] != SFI_BY_CELL) {
            continue;
        }
        begin_array(w, "", v->channels[i].property.name, 1, v->cell_count, " double\n");
        for (size_t j = 0; j < v->cell_count; j++) {
            sfi_vtk_write_double(w, sfi_corner_value(v, i, v->starts[j]), 1);
        }
        sfi_vtk_write_break(w);
    }
}

// What a copy of a point has; points without a cell have any value that the property allows.
static double copy_value(const sf_cage_view *v, size_t channel, sfi_channel_form form,
                         const sfi_copies *c, size_t copy)
{
    const double *values = v->channels[channel].values;
    if (form == SFI_BY_POINT) {
        return values[copy < c->points ? copy : (size_t)c->point_of[copy]];
    }
    return c->corner_of[copy] != UINT32_MAX ? sfi_corner_value(v, channel, c->corner_of[copy])
                                            : values[0];
}

static void write_point_data(sfi_vtk_writer *w, const sf_cage_view *v,
                             const sfi_channel_form *forms, const sfi_copies *c)
{
    size_t arrays = count_forms(v, forms, 0) + (c->extra > 0), rows = c->points + c->extra;
    if (arrays == 0) {
        return;
    }
    begin_data(w, "POINT_DATA ", rows, arrays);
    for (size_t i = 0; i < v->channel_count; i++) {
        if (forms[i] == SFI_BY_CELL) {
            continue;
        }
        begin_array(w, "", v->channels[i].property.name, 1, rows, " double\n");
        for (size_t j = 0; j < rows; j++) {
            sfi_vtk_write_double(w, copy_value(v, i, forms[i], c, j), 1);
        }
        sfi_vtk_write_break(w);
    }
    if (c->extra > 0) {
        begin_array(w, "", SFI_VTK_POINT_NAME, 1, rows, " int\n");
        for (size_t j = 0; j < rows; j++) {
            sfi_vtk_write_int(w, c->point_of[j], 1);
        }
        sfi_vtk_write_break(w);
    }
}

sf_status sf_cage_write_vtk(const sf_cage_view *view, int binary, const sf_allocator *allocator,
                            sf_sink sink, sf_fault *fault)
{
    if (view == NULL || sink.write == NULL) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "no cage, or no sink");
    }
    SF_TRY(check(view, fault));
    sf_allocator kept = sfi_allocator_or_default(allocator);
    sfi_channel_form forms[SF_PROPERTY_MAX];
    sfi_copies copies;
    sfi_channel_forms(view, forms);
    sf_status status = sfi_copies_make(&copies, view, forms, &kept);
    if (status == SF_ERR_OVERFLOW) {
        (void)sfi_fault_set(fault, status, 0, 0,
                            "points and their copies are more than VTK can number");
    }
    if (status == SF_OK) {
        sfi_vtk_writer w;
        sfi_vtk_write_head(&w, sink, binary != 0, "cage written by libsf, mm");
        write_fields(&w, view);
        write_points(&w, view, &copies);
        write_cells(&w, view, &copies);
        write_cell_data(&w, view, forms);
        write_point_data(&w, view, forms, &copies);
        status = sfi_vtk_write_end(&w);
    }
    sfi_copies_free(&copies, &kept);
    return status;
}
