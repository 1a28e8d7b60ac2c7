// SPDX-License-Identifier: MIT
// Strokes: the union of tips, put on a model step by step, with one result however it is cut.
//
// A stroke keeps the union of its tips and the state before it. Each call stamps its dabs into the
// union, and brings the model to what the brush makes of the union and that state (brush_*.c).
// Where the stroke ends, ghosts go unless the model keeps them, and the difference between the two
// states becomes a step of the history.
//
// Where an operator is refused memory the stroke is given up: with the state before it at hand that
// is exact. Under rules that are elements it cannot happen.

#include "base/status.h"
#include "sculpt/delta.h"
#include "sculpt/rows.h"
#include "sculpt/tip.h"
#include "support/rule/carry.h"
#include "voxel/slice.h"
#include "voxel/stamp.h"

static const char *const names[SF_BRUSH_KIND_COUNT] = {"add-trim",    "remove-preserve", "add-grow",
                                                       "remove-trim", "smooth-trim",     "paint"};

const char *sf_brush_kind_name(sf_brush_kind kind)
{
    return (int)kind >= 0 && kind < SF_BRUSH_KIND_COUNT ? names[kind] : NULL;
}

sf_brush sf_brush_default(void)
{
    sf_brush brush = {.struct_size = sizeof brush, .material = 1, .passes = 1};
    return brush;
}

// ---------------------------------------------------------------------------------------------
// Begin
// ---------------------------------------------------------------------------------------------

sf_status sf_sculpt_begin(sf_sculpt *model, const sf_brush *brush)
{
    if (model == NULL || brush == NULL || brush->struct_size < sizeof *brush ||
        sf_brush_kind_name(brush->kind) == NULL || brush->tip == NULL || brush->material == 0 ||
        brush->passes < 1 || brush->passes > SF_BRUSH_PASSES_MAX || model->is_under_way) {
        return SF_ERR_ARGUMENT;
    }
    if (brush->kind == SF_BRUSH_ADD_GROW && !sfi_rule_is_element(&model->terms.rule)) {
        SF_TRY(sf_path_finder_refresh(model->finder, NULL));
    }
    model->is_under_way = 1;
    model->brush = *brush;
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Dabs
// ---------------------------------------------------------------------------------------------

// One dab, put in one of the ways that the mirrors ask for.
static sf_status put_tip(sf_sculpt *m, sf_dab d, unsigned way)
{
    const sf_tip *tip = m->brush.tip;
    sf_dab anchor = tip->anchors[way];
    int64_t at[3] = {way & 1 ? (int64_t)m->lattice.nx - 1 - d.x : d.x,
                     way & 2 ? (int64_t)m->lattice.ny - 1 - d.y : d.y, d.z};
    int64_t by[3] = {at[0] - anchor.x, at[1] - anchor.y, at[2] - anchor.z};
    sf_box part = sfi_grid_stamp(m->tips, tip->masks[way], by);
    sfi_area_add_box(&m->in_tips, part);
    sfi_area_add_box(&m->fresh, part);
    return m->brush.kind == SF_BRUSH_ADD_GROW ? sfi_grow_paths(m, at, way) : SF_OK;
}

static sf_status put_tips(sf_sculpt *m, const sf_dab *dabs, size_t count)
{
    unsigned mirrors = (m->brush.mirror_x ? 1u : 0) | (m->brush.mirror_y ? 2u : 0);
    for (size_t i = 0; i < count; i++) {
        for (unsigned way = 0; way < SFI_FLIP_COUNT; way++) {
            if ((way & ~mirrors) == 0) {
                SF_TRY(put_tip(m, dabs[i], way));
            }
        }
    }
    return SF_OK;
}

static sf_status apply(sf_sculpt *m)
{
    switch (m->brush.kind) {
    case SF_BRUSH_ADD_TRIM:
        return sfi_brush_add(m);
    case SF_BRUSH_REMOVE_PRESERVE:
        return sfi_brush_preserve(m);
    case SF_BRUSH_ADD_GROW:
        return sfi_brush_grow(m);
    case SF_BRUSH_REMOVE_TRIM:
        return sfi_brush_remove(m);
    case SF_BRUSH_SMOOTH_TRIM:
        return sfi_brush_smooth(m);
    default:
        return sfi_brush_paint(m);
    }
}

// Both, and what they touched joined to what the stroke did, also when they fail half way.
static sf_status extend(sf_sculpt *m, const sf_dab *dabs, size_t count)
{
    sfi_area_clear(&m->fresh);
    sfi_touch_clear(&m->called);
    sf_status status = put_tips(m, dabs, count);
    if (status == SF_OK && !sfi_area_is_empty(&m->fresh)) {
        status = apply(m);
    }
    sfi_touch_join(&m->touched, &m->called);
    return status;
}

static void report(const sf_sculpt *m, const sfi_touch *touched, sf_sculpt_change *change)
{
    if (change != NULL) {
        sf_sculpt_change made = {.added_voxels = 0};
        sfi_sculpt_boxes(touched, &made);
        sfi_sculpt_count(m, &made);
        *change = made;
    }
}

sf_status sf_sculpt_dab(sf_sculpt *model, const sf_dab *dabs, size_t count,
                        sf_sculpt_change *change)
{
    if (model == NULL || (dabs == NULL && count > 0) || !model->is_under_way) {
        return SF_ERR_ARGUMENT;
    }
    for (size_t i = 0; i < count; i++) {
        if (!sfi_dab_is_valid(dabs[i])) {
            return SF_ERR_ARGUMENT;
        }
    }
    sf_status status = extend(model, dabs, count);
    if (status != SF_OK) {
        (void)!sf_sculpt_abandon(model, NULL);
        return status;
    }
    report(model, &model->called, change);
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// End
// ---------------------------------------------------------------------------------------------

// Empty a grid where it holds anything.
static void wipe(sf_grid *grid, sfi_area *area)
{
    for (uint32_t z = area->z0; z < area->z1; z++) {
        (void)!sf_slice_fill(sf_grid_slice(grid, z), area->rects[z], 0);
    }
    sfi_area_clear(area);
}

// The stroke is over: nothing of it is left in what a stroke works with.
static void clear(sf_sculpt *m)
{
    wipe(m->tips, &m->in_tips);
    wipe(m->grown, &m->in_grown);
    sfi_area_clear(&m->braced);
    sfi_touch_clear(&m->touched);
    m->is_under_way = 0;
    m->path_voxels = 0;
}

// D = T where the stroke changed either; their materials go as well.
static void drop_ghosts(sf_sculpt *m)
{
    sfi_area *area = &m->work;
    sfi_area_clear(area);
    sfi_area_join(area, &m->touched.drawn);
    sfi_area_join(area, &m->touched.printable);
    for (uint32_t z = area->z0; z < area->z1; z++) {
        sf_slice drawn = sf_grid_slice(m->now.drawn, z);
        sf_slice printable = sf_grid_slice(m->now.printable, z);
        sf_rect r = area->rects[z];
        for (uint32_t y = r.y0; y < r.y1; y++) {
            uint64_t *d = sfi_slice_row(drawn, y), *t = sfi_slice_row(printable, y);
            uint8_t *materials = sfi_material_row(m, &m->now, y, z);
            for (size_t i = sfi_rect_first_word(r); i < sfi_rect_end_word(r); i++) {
                uint64_t gone = d[i] & ~t[i];
                d[i] = t[i];
                sfi_bytes_set(materials, i, gone, 0);
                sfi_area_note(&m->called.drawn, i, gone, y, z);
                sfi_area_note(&m->called.material, i, gone, y, z);
            }
        }
    }
}

void sfi_sculpt_commit(sf_sculpt *m, int keep_ghosts, sf_sculpt_change *change)
{
    sfi_touch_clear(&m->called);
    if (!keep_ghosts) {
        drop_ghosts(m);
        sfi_touch_join(&m->touched, &m->called);
    }
    report(m, &m->called, change);
    (void)sfi_delta_write(m);
    clear(m);
}

sf_status sf_sculpt_end(sf_sculpt *model, sf_sculpt_change *change)
{
    if (model == NULL || !model->is_under_way) {
        return SF_ERR_ARGUMENT;
    }
    sfi_sculpt_commit(model, model->options.keep_drawn, change);
    return SF_OK;
}

sf_status sf_sculpt_abandon(sf_sculpt *model, sf_sculpt_change *change)
{
    if (model == NULL) {
        return SF_ERR_ARGUMENT;
    }
    sf_sculpt_change made = {.added_voxels = 0};
    sfi_sculpt_boxes(&model->touched, &made);
    sfi_sculpt_copy(model, &model->now, &model->before, &model->touched);
    clear(model);
    if (change != NULL) {
        *change = made;
    }
    return SF_OK;
}

// The boxes of `change` are those of all calls together.
sf_status sf_sculpt_stroke(sf_sculpt *model, const sf_brush *brush, const sf_dab *dabs,
                           size_t count, sf_sculpt_change *change)
{
    SF_TRY(sf_sculpt_begin(model, brush));
    sf_sculpt_change first, last;
    sf_status status = sf_sculpt_dab(model, dabs, count, NULL);
    if (status != SF_OK) {
        (void)!sf_sculpt_abandon(model, NULL); // it is, unless the dabs were refused
        return status;
    }
    sfi_sculpt_boxes(&model->touched, &first);
    (void)!sf_sculpt_end(model, change != NULL ? &last : NULL);
    if (change != NULL) {
        last.drawn = sfi_box_join(last.drawn, first.drawn);
        last.printable = sfi_box_join(last.printable, first.printable);
        last.material = sfi_box_join(last.material, first.material);
        *change = last;
    }
    return SF_OK;
}
