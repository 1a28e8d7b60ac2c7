// SPDX-License-Identifier: MIT
// Sessions out: words and numbers, in the order in which things were done.

#include "base/status.h"
#include "io/emitter.h"
#include "io/session.h"

static void put_wholes(sfi_emitter *e, const uint64_t *numbers, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        sfi_emit_text(e, " ");
        sfi_emit_whole(e, numbers[i]);
    }
}

static void put_signed(sfi_emitter *e, int64_t number)
{
    sfi_emit_text(e, number < 0 ? " -" : " ");
    sfi_emit_whole(e, (uint64_t)(number < 0 ? -number : number));
}

static void put_numbers(sfi_emitter *e, const double *numbers, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        sfi_emit_text(e, " ");
        sfi_emit_number(e, numbers[i]);
    }
}

static void put_head(sfi_emitter *e, const sf_session_options *o)
{
    const sf_lattice *l = &o->lattice;
    const uint64_t counts[3] = {l->nx, l->ny, l->nz}, version = SFI_SESSION_VERSION;
    const double lengths[6] = {l->pitch_x_mm,   l->pitch_y_mm,   l->layer_mm,
                               l->origin_mm[0], l->origin_mm[1], l->origin_mm[2]};
    const uint64_t bed = o->bed_layer, ghosts = o->keep_drawn != 0, history = o->history_size;
    sfi_emit_text(e, SFI_SESSION_WORD);
    put_wholes(e, &version, 1);
    sfi_emit_text(e, "\nspace");
    put_wholes(e, counts, 3);
    put_numbers(e, lengths, 6);
    sfi_emit_text(e, "\nrule ");
    sfi_emit_text(e, sf_rule_kind_name(o->rule));
    put_numbers(e, &o->angle_rad, 1);
    sfi_emit_text(e, "\nbed");
    put_wholes(e, &bed, 1);
    sfi_emit_text(e, "\nghosts");
    put_wholes(e, &ghosts, 1);
    sfi_emit_text(e, "\nhistory");
    put_wholes(e, &history, 1);
    sfi_emit_text(e, "\n");
}

// ---------------------------------------------------------------------------------------------
// Tips
// ---------------------------------------------------------------------------------------------

// Runs of a mask: visited with a NULL emitter they are counted.
static uint64_t put_mask(sfi_emitter *e, const sf_grid *mask)
{
    sf_lattice l = sf_grid_lattice(mask);
    uint64_t runs = 0;
    for (uint32_t z = 0; z < l.nz; z++) {
        sf_slice slice = sf_grid_slice(mask, z);
        for (uint32_t y = 0; y < l.ny; y++) {
            for (uint32_t x = 0; x < l.nx; x++) {
                uint32_t end = x;
                while (end < l.nx && sf_slice_get(slice, end, y)) {
                    end++;
                }
                if (end > x) {
                    const uint64_t run[4] = {z, y, x, end - x};
                    runs++;
                    if (e != NULL) {
                        put_wholes(e, run, 4);
                        sfi_emit_text(e, "\n");
                    }
                    x = end;
                }
            }
        }
    }
    return runs;
}

static void put_tip(sfi_emitter *e, const sfi_session_tip *tip)
{
    sfi_emit_text(e, "tip ");
    if (!tip->is_mask) {
        sfi_emit_text(e, sfi_session_shapes[tip->shape]);
        put_numbers(e, tip->radius_vx, 3);
        sfi_emit_text(e, "\n");
        return;
    }
    sf_dab anchor;
    const sf_grid *mask = sf_tip_mask(tip->tip, &anchor);
    sf_lattice l = sf_grid_lattice(mask);
    const uint64_t counts[3] = {l.nx, l.ny, l.nz}, runs = put_mask(NULL, mask);
    sfi_emit_text(e, "mask");
    put_wholes(e, counts, 3);
    put_signed(e, anchor.x);
    put_signed(e, anchor.y);
    put_signed(e, anchor.z);
    put_wholes(e, &runs, 1);
    sfi_emit_text(e, "\n");
    put_mask(e, mask);
}

// ---------------------------------------------------------------------------------------------
// Steps
// ---------------------------------------------------------------------------------------------

static void put_stroke(sfi_emitter *e, const sf_session *session, const sfi_session_item *item)
{
    const sf_brush *b = &item->brush;
    const uint64_t mirrors = (uint64_t)b->mirror_x + 2 * (uint64_t)b->mirror_y;
    const uint64_t rest[5] = {item->tip, b->material, b->passes, mirrors, item->count};
    const sf_dab *dabs = session->dabs.items;
    sfi_emit_text(e, "stroke ");
    sfi_emit_text(e, sf_brush_kind_name(b->kind));
    put_wholes(e, rest, 5);
    sfi_emit_text(e, "\n");
    for (size_t i = item->first; i < item->first + item->count; i++) {
        put_signed(e, dabs[i].x);
        put_signed(e, dabs[i].y);
        put_signed(e, dabs[i].z);
        sfi_emit_text(e, "\n");
    }
}

static void put_runs(sfi_emitter *e, const char *word, const sfi_session_run *runs, size_t count)
{
    const uint64_t all = count;
    sfi_emit_text(e, word);
    put_wholes(e, &all, 1);
    sfi_emit_text(e, "\n");
    for (size_t i = 0; i < count; i++) {
        const uint64_t run[5] = {runs[i].z, runs[i].y, runs[i].x, runs[i].length, runs[i].material};
        put_wholes(e, run, 5);
        sfi_emit_text(e, "\n");
    }
}

static void put_item(sfi_emitter *e, const sf_session *session, const sfi_session_item *item)
{
    if (item->kind == SFI_STEP_STROKE) {
        put_stroke(e, session, item);
    } else if (item->kind == SFI_STEP_SHAPE) {
        const sfi_session_run *runs = session->runs.items;
        put_runs(e, "shape", item->count > 0 ? runs + item->first : NULL, item->count);
    } else {
        sfi_emit_text(e, sfi_session_steps[item->other]);
        sfi_emit_text(e, "\n");
    }
}

sf_status sf_session_write(const sf_session *session, sf_sink sink)
{
    sfi_emitter e;
    if (session == NULL || sink.write == NULL) {
        return SF_ERR_ARGUMENT;
    }
    sfi_emitter_begin(&e, sink);
    put_head(&e, &session->options);
    for (size_t i = 0; i < session->tips.count; i++) {
        put_tip(&e, (const sfi_session_tip *)session->tips.items + i);
    }
    for (size_t i = 0; i < session->items.count; i++) {
        put_item(&e, session, (const sfi_session_item *)session->items.items + i);
    }
    if (session->has_state) {
        put_runs(&e, "state", session->state.items, session->state.count);
    }
    sfi_emit_text(&e, "end\n");
    return sfi_emitter_end(&e);
}
