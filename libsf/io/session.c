// SPDX-License-Identifier: MIT
// Sessions: recording.
//
// A session is lists: of tips, of steps, and of the dabs and runs that these name by their place.
// Nothing is ever taken out again, but for the state, so places stay.

#include "io/session.h"

#include "base/status.h"

const char *const sfi_session_shapes[4] = {"sphere", "box", "cylinder", "cone"};
const char *const sfi_session_steps[3] = {"undo", "redo", "drop-ghosts"};

sf_session_options sf_session_options_default(void)
{
    sf_sculpt_options like = sf_sculpt_options_default();
    sf_session_options options = {.struct_size = sizeof options,
                                  .lattice = like.lattice,
                                  .rule = SF_RULE_BOX3,
                                  .angle_rad = 0.78539816339744831,
                                  .history_size = like.history_size};
    return options;
}

// ---------------------------------------------------------------------------------------------
// Life
// ---------------------------------------------------------------------------------------------

static sf_status make_rule(const sf_session_options *o, sf_rule *rule)
{
    if (o->rule == SF_RULE_BOX3) {
        *rule = sf_rule_box3();
        return SF_OK;
    }
    return sf_rule_make(o->rule, o->angle_rad, &o->lattice, NULL, rule, NULL);
}

sf_status sf_session_create(const sf_session_options *options, const sf_allocator *allocator,
                            sf_session **session)
{
    sf_rule rule;
    if (options == NULL || session == NULL || options->struct_size < sizeof *options ||
        options->lattice.heights_mm != NULL) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(sf_lattice_validate(&options->lattice));
    SF_TRY(make_rule(options, &rule));
    if (options->bed_layer >= options->lattice.nz) {
        return SF_ERR_ARGUMENT;
    }
    sf_allocator from = sfi_allocator_or_default(allocator);
    sf_session *made = sfi_alloc_array(&from, 1, sizeof *made);
    if (made == NULL) {
        return SF_ERR_MEMORY;
    }
    sf_session empty = {.allocator = from,
                        .options = *options,
                        .rule = rule,
                        .tips = sfi_list_of(sizeof(sfi_session_tip)),
                        .items = sfi_list_of(sizeof(sfi_session_item)),
                        .dabs = sfi_list_of(sizeof(sf_dab)),
                        .runs = sfi_list_of(sizeof(sfi_session_run)),
                        .state = sfi_list_of(sizeof(sfi_session_run))};
    *made = empty;
    *session = made;
    return SF_OK;
}

void sf_session_destroy(sf_session *session)
{
    if (session == NULL) {
        return;
    }
    sf_allocator a = session->allocator;
    sfi_session_tip *tips = session->tips.items;
    for (size_t i = 0; i < session->tips.count; i++) {
        sf_tip_destroy(tips[i].tip);
    }
    sfi_list_free(&a, &session->tips);
    sfi_list_free(&a, &session->items);
    sfi_list_free(&a, &session->dabs);
    sfi_list_free(&a, &session->runs);
    sfi_list_free(&a, &session->state);
    sfi_free_array(&a, session, 1, sizeof *session);
}

sf_session_options sf_session_options_of(const sf_session *session)
{
    return session->options;
}

sf_session_counts sf_session_count(const sf_session *session)
{
    sf_session_counts counts = {session->tips.count, session->items.count, session->strokes,
                                session->dabs.count, session->has_state};
    return counts;
}

// ---------------------------------------------------------------------------------------------
// Tips
// ---------------------------------------------------------------------------------------------

// A tip that was made, which the session takes over; also when it fails.
static sf_status take_tip(sf_session *session, const sfi_session_tip *made, uint32_t *number)
{
    sf_status status = session->tips.count < SFI_SESSION_TIPS_MAX
                           ? sfi_list_push(&session->allocator, &session->tips, made)
                           : SF_ERR_OVERFLOW;
    if (status != SF_OK) {
        sf_tip_destroy(made->tip);
        return status;
    }
    *number = (uint32_t)session->tips.count - 1;
    return SF_OK;
}

sf_status sf_session_add_tip(sf_session *session, sf_tip_shape shape, const double radius_vx[3],
                             uint32_t *tip)
{
    sfi_session_tip made = {0, shape, {0, 0, 0}, NULL};
    if (session == NULL || tip == NULL || radius_vx == NULL) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(sf_tip_create(shape, radius_vx, &session->allocator, &made.tip));
    memcpy(made.radius_vx, radius_vx, sizeof made.radius_vx);
    return take_tip(session, &made, tip);
}

sf_status sf_session_add_mask(sf_session *session, const sf_grid *mask, sf_dab anchor,
                              uint32_t *tip)
{
    sfi_session_tip made = {1, SF_TIP_SPHERE, {0, 0, 0}, NULL};
    if (session == NULL || tip == NULL) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(sf_tip_create_mask(mask, anchor, &session->allocator, &made.tip));
    return take_tip(session, &made, tip);
}

const sf_tip *sf_session_tip(const sf_session *session, uint32_t tip)
{
    if (session == NULL || tip >= session->tips.count) {
        return NULL;
    }
    const sfi_session_tip *tips = session->tips.items;
    return tips[tip].tip;
}

// ---------------------------------------------------------------------------------------------
// Steps
// ---------------------------------------------------------------------------------------------

static int is_brush(const sf_brush *b)
{
    return b->struct_size >= sizeof *b && sf_brush_kind_name(b->kind) != NULL && b->material > 0 &&
           b->passes >= 1 && b->passes <= SF_BRUSH_PASSES_MAX && (b->mirror_x & ~1) == 0 &&
           (b->mirror_y & ~1) == 0;
}

static int is_dab(sf_dab d)
{
    const int32_t most = INT32_C(1) << 30;
    return d.x >= -most && d.x <= most && d.y >= -most && d.y <= most && d.z >= -most &&
           d.z <= most;
}

// An item whose dabs or runs have been appended; where it does not fit, they are gone again.
static sf_status push_item(sf_session *session, const sfi_session_item *item, sfi_list *parts)
{
    sf_status status = sfi_list_push(&session->allocator, &session->items, item);
    if (status != SF_OK && parts != NULL) {
        parts->count = item->first;
    }
    return status;
}

sf_status sf_session_add_stroke(sf_session *session, const sf_brush *brush, uint32_t tip,
                                const sf_dab *dabs, size_t count)
{
    if (session == NULL || brush == NULL || (dabs == NULL && count > 0) || !is_brush(brush) ||
        tip >= session->tips.count) {
        return SF_ERR_ARGUMENT;
    }
    for (size_t i = 0; i < count; i++) {
        if (!is_dab(dabs[i])) {
            return SF_ERR_ARGUMENT;
        }
    }
    size_t first = session->dabs.count;
    for (size_t i = 0; i < count; i++) {
        sf_status status = sfi_list_push(&session->allocator, &session->dabs, &dabs[i]);
        if (status != SF_OK) {
            session->dabs.count = first;
            return status;
        }
    }
    sfi_session_item item = {
        .kind = SFI_STEP_STROKE, .brush = *brush, .tip = tip, .first = first, .count = count};
    item.brush.tip = NULL;
    SF_TRY(push_item(session, &item, &session->dabs));
    session->strokes++;
    return SF_OK;
}

sf_status sf_session_add_step(sf_session *session, sf_session_step step)
{
    if (session == NULL || (int)step < SF_SESSION_UNDO || step > SF_SESSION_DROP_GHOSTS) {
        return SF_ERR_ARGUMENT;
    }
    sfi_session_item item = {.kind = SFI_STEP_OTHER, .other = step};
    return push_item(session, &item, NULL);
}

// ---------------------------------------------------------------------------------------------
// Shapes
// ---------------------------------------------------------------------------------------------

int sfi_session_run_is_valid(const sf_session *session, const sfi_session_run *run)
{
    const sf_lattice *l = &session->options.lattice;
    return run->z < l->nz && run->y < l->ny && run->x < l->nx && run->length > 0 &&
           run->length <= l->nx - run->x && run->material > 0;
}

static uint8_t material_at(const uint8_t *row, uint32_t x)
{
    return row == NULL || row[x] == 0 ? 1 : row[x];
}

// Runs of one row; `row` are its materials.
static sf_status runs_of_row(const sf_session *session, sf_slice slice, uint32_t z, uint32_t y,
                             const uint8_t *row, sfi_list *runs)
{
    for (uint32_t x = 0; x < slice.width; x++) {
        if (!sf_slice_get(slice, x, y)) {
            continue;
        }
        sfi_session_run run = {z, y, x, 1, material_at(row, x)};
        while (x + 1 < slice.width && sf_slice_get(slice, x + 1, y) &&
               material_at(row, x + 1) == run.material) {
            x++;
            run.length++;
        }
        SF_TRY(sfi_list_push(&session->allocator, runs, &run));
    }
    return SF_OK;
}

sf_status sfi_session_runs_of(const sf_session *session, const sf_grid *drawn,
                              const uint8_t *materials, sfi_list *runs)
{
    const sf_lattice *l = &session->options.lattice;
    size_t first = runs->count;
    sf_status status = SF_OK;
    for (uint32_t z = 0; status == SF_OK && z < l->nz; z++) {
        sf_slice slice = sf_grid_slice(drawn, z);
        if (sf_slice_bounds(slice).x1 == 0) {
            continue;
        }
        for (uint32_t y = 0; status == SF_OK && y < l->ny; y++) {
            const uint8_t *row =
                materials != NULL ? materials + ((size_t)z * l->ny + y) * l->nx : NULL;
            status = runs_of_row(session, slice, z, y, row, runs);
        }
    }
    runs->count = status == SF_OK ? runs->count : first;
    return status;
}

static sf_status check_counts(const sf_session *session, const sf_grid *grid)
{
    sf_lattice a = session->options.lattice, b = sf_grid_lattice(grid);
    return a.nx == b.nx && a.ny == b.ny && a.nz == b.nz ? SF_OK : SF_ERR_SHAPE;
}

sf_status sf_session_add_shape(sf_session *session, const sf_grid *drawn, const uint8_t *materials)
{
    if (session == NULL || drawn == NULL) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(check_counts(session, drawn));
    sfi_session_item item = {.kind = SFI_STEP_SHAPE, .first = session->runs.count};
    SF_TRY(sfi_session_runs_of(session, drawn, materials, &session->runs));
    item.count = session->runs.count - item.first;
    return push_item(session, &item, &session->runs);
}

sf_status sf_session_keep_state(sf_session *session, const sf_sculpt *model)
{
    sfi_list runs = sfi_list_of(sizeof(sfi_session_run));
    if (session == NULL) {
        return SF_ERR_ARGUMENT;
    }
    if (model != NULL) {
        SF_TRY(check_counts(session, sf_sculpt_drawn(model)));
        sf_status status =
            sfi_session_runs_of(session, sf_sculpt_drawn(model), sf_sculpt_materials(model), &runs);
        if (status != SF_OK) {
            sfi_list_free(&session->allocator, &runs);
            return status;
        }
    }
    sfi_list_free(&session->allocator, &session->state);
    session->state = runs;
    session->has_state = model != NULL;
    return SF_OK;
}
