// SPDX-License-Identifier: MIT
// Sessions in.
//
// The file is words and numbers, parted by blanks and line ends; a # begins a comment. Counts stand
// before what they count, and are not believed: each dab and each run is appended as it comes. Only
// a tip's mask is made before its runs, and is bounded.

#include <math.h>

#include "base/status.h"
#include "io/cursor.h"
#include "io/number.h"
#include "io/session.h"

#define BYTES_MAX (UINT64_C(1) << 30)

typedef struct reader {
    sfi_cursor cursor;
    sf_fault *fault;
    sf_session *session;
    char word[SFI_TOKEN_SIZE];
} reader;

// ---------------------------------------------------------------------------------------------
// Words and numbers
// ---------------------------------------------------------------------------------------------

static void next_word(reader *r)
{
    while (sfi_cursor_token(&r->cursor, r->word, 1) > 0 && r->word[0] == '#') {
        sfi_cursor_skip_line(&r->cursor);
    }
}

static sf_status wrong(reader *r, const char *expected)
{
    return sfi_cursor_fault_token(&r->cursor, r->fault, expected, r->word);
}

// A sentence about what the numbers say together.
static sf_status refuse(reader *r, sf_status status, const char *sentence)
{
    return sfi_fault_set(r->fault, status, r->cursor.line, sfi_cursor_offset(&r->cursor), "%s",
                         sentence);
}

static sf_status read_word(reader *r, const char *expected)
{
    next_word(r);
    return strcmp(r->word, expected) == 0 ? SF_OK : wrong(r, expected);
}

static sf_status read_signed(reader *r, const char *expected, int64_t least, int64_t most,
                             int64_t *value)
{
    next_word(r);
    return sfi_integer_parse(r->word, value) && *value >= least && *value <= most
               ? SF_OK
               : wrong(r, expected);
}

static sf_status read_u32(reader *r, const char *expected, uint32_t most, uint32_t *value)
{
    int64_t number;
    SF_TRY(read_signed(r, expected, 0, most, &number));
    *value = (uint32_t)number;
    return SF_OK;
}

static sf_status read_number(reader *r, const char *expected, double *value)
{
    next_word(r);
    return sfi_number_parse(r->word, value) && isfinite(*value) ? SF_OK : wrong(r, expected);
}

// The place of the word that was read in a list; -1 where it is none of them.
static int find(const reader *r, const char *const *list, int count)
{
    for (int i = 0; i < count; i++) {
        if (strcmp(r->word, list[i]) == 0) {
            return i;
        }
    }
    return -1;
}

// ---------------------------------------------------------------------------------------------
// Head
// ---------------------------------------------------------------------------------------------

static sf_status read_space(reader *r, sf_lattice *l)
{
    uint32_t *const counts[3] = {&l->nx, &l->ny, &l->nz};
    double *const lengths[6] = {&l->pitch_x_mm,   &l->pitch_y_mm,   &l->layer_mm,
                                &l->origin_mm[0], &l->origin_mm[1], &l->origin_mm[2]};
    SF_TRY(read_word(r, "space"));
    for (int i = 0; i < 3; i++) {
        SF_TRY(read_u32(r, "a count of voxels", i < 2 ? SF_EXTENT_MAX : SF_LAYER_MAX, counts[i]));
    }
    for (int i = 0; i < 6; i++) {
        SF_TRY(read_number(r, "a length in mm", lengths[i]));
    }
    l->heights_mm = NULL;
    return SF_OK;
}

static sf_status read_rule(reader *r, sf_session_options *o)
{
    SF_TRY(read_word(r, "rule"));
    next_word(r);
    if (sf_rule_kind_from_name(r->word, &o->rule) != SF_OK) {
        return wrong(r, "the name of a rule (box3, octagon, disk, slack)");
    }
    return read_number(r, "an angle in radians", &o->angle_rad);
}

static sf_status read_head(reader *r, const sf_allocator *allocator)
{
    sf_session_options o = sf_session_options_default();
    uint32_t version, ghosts;
    int64_t history;
    SF_TRY(read_word(r, SFI_SESSION_WORD));
    SF_TRY(read_u32(r, "a version", UINT32_MAX, &version));
    if (version != SFI_SESSION_VERSION) {
        return refuse(r, SF_ERR_UNSUPPORTED,
                      "the session is of a version that this library does not know; read it with a "
                      "newer one");
    }
    SF_TRY(read_space(r, &o.lattice));
    SF_TRY(read_rule(r, &o));
    SF_TRY(read_word(r, "bed"));
    SF_TRY(read_u32(r, "a layer", SF_LAYER_MAX, &o.bed_layer));
    SF_TRY(read_word(r, "ghosts"));
    SF_TRY(read_u32(r, "0 or 1", 1, &ghosts));
    SF_TRY(read_word(r, "history"));
    SF_TRY(read_signed(r, "a number of bytes", 0, INT64_C(1) << 40, &history));
    o.keep_drawn = (int)ghosts;
    o.history_size = (size_t)history;
    sf_status status = sf_session_create(&o, allocator, &r->session);
    if (status == SF_ERR_MEMORY) {
        return status;
    }
    return status == SF_OK
               ? SF_OK
               : refuse(r, SF_ERR_FORMAT,
                        "the space, its rule or its bed is none: counts and lengths are above 0, "
                        "the angle serves the lattice, and the bed is one of its layers");
}

// ---------------------------------------------------------------------------------------------
// Tips
// ---------------------------------------------------------------------------------------------

static sf_status read_mask_runs(reader *r, sf_grid *mask)
{
    sf_lattice l = sf_grid_lattice(mask);
    uint32_t count;
    SF_TRY(read_u32(r, "a count of runs", UINT32_MAX, &count));
    for (uint32_t i = 0; i < count; i++) {
        uint32_t z, y, x, length;
        SF_TRY(read_u32(r, "a layer of the tip", l.nz - 1, &z));
        SF_TRY(read_u32(r, "a row of the tip", l.ny - 1, &y));
        SF_TRY(read_u32(r, "a column of the tip", l.nx - 1, &x));
        SF_TRY(read_u32(r, "a length within the row", l.nx - x, &length));
        sf_rect rect = {x, y, x + length, y + 1};
        SF_TRY(sf_slice_fill(sf_grid_slice(mask, z), rect, 1));
    }
    return SF_OK;
}

static sf_status read_mask(reader *r)
{
    uint32_t counts[3], number;
    int64_t anchor[3];
    const int64_t far = INT64_C(1) << 30;
    for (int i = 0; i < 3; i++) {
        SF_TRY(read_u32(r, "a count of voxels", 4096, &counts[i]));
    }
    for (int i = 0; i < 3; i++) {
        SF_TRY(read_signed(r, "a place of the anchor", -far, far, &anchor[i]));
    }
    if (counts[0] == 0 || counts[1] == 0 || counts[2] == 0 ||
        (uint64_t)counts[0] * counts[1] * counts[2] > SFI_SESSION_MASK_MAX) {
        return refuse(r, SF_ERR_OVERFLOW,
                      "the mask of a tip has no voxels, or more than 2^27; take a smaller tip");
    }
    sf_lattice l = {counts[0], counts[1], counts[2], 1, 1, 1, NULL, {0, 0, 0}};
    sf_dab place = {(int32_t)anchor[0], (int32_t)anchor[1], (int32_t)anchor[2]};
    sf_grid *mask = NULL;
    SF_TRY(sf_grid_create(&l, &r->session->allocator, &mask));
    sf_status status = read_mask_runs(r, mask);
    if (status == SF_OK) {
        status = sf_session_add_mask(r->session, mask, place, &number);
        status = status == SF_ERR_ARGUMENT
                     ? refuse(r, SF_ERR_FORMAT, "the mask of a tip is empty; give it runs")
                     : status;
    }
    sf_grid_destroy(mask);
    return status;
}

static sf_status read_tip(reader *r)
{
    double radius[3];
    uint32_t number;
    next_word(r);
    if (strcmp(r->word, "mask") == 0) {
        return read_mask(r);
    }
    int shape = find(r, sfi_session_shapes, 4);
    if (shape < 0) {
        return wrong(r, "sphere, box, cylinder, cone or mask");
    }
    for (int i = 0; i < 3; i++) {
        SF_TRY(read_number(r, "a radius in voxels", &radius[i]));
    }
    double voxels = (2 * radius[0] + 1) * (2 * radius[1] + 1) * (2 * radius[2] + 1);
    if (!(voxels <= (double)SFI_SESSION_MASK_MAX)) {
        return refuse(r, SF_ERR_OVERFLOW, "a tip has more than 2^27 voxels; take a smaller one");
    }
    sf_status status = sf_session_add_tip(r->session, (sf_tip_shape)shape, radius, &number);
    return status == SF_ERR_ARGUMENT
               ? refuse(r, SF_ERR_FORMAT, "a radius of a tip lies outside 0 to 1024")
               : status;
}

// ---------------------------------------------------------------------------------------------
// Steps
// ---------------------------------------------------------------------------------------------

static sf_status read_kind(reader *r, sf_brush_kind *kind)
{
    next_word(r);
    for (int k = 0; k < SF_BRUSH_KIND_COUNT; k++) {
        if (strcmp(r->word, sf_brush_kind_name((sf_brush_kind)k)) == 0) {
            *kind = (sf_brush_kind)k;
            return SF_OK;
        }
    }
    return wrong(r, "a brush, such as add-trim");
}

static sf_status read_dab(reader *r, sf_dab *dab)
{
    int32_t *const parts[3] = {&dab->x, &dab->y, &dab->z};
    const int64_t far = INT64_C(1) << 30;
    for (int i = 0; i < 3; i++) {
        int64_t number;
        SF_TRY(read_signed(r, "a place of a dab", -far, far, &number));
        *parts[i] = (int32_t)number;
    }
    return SF_OK;
}

static sf_status read_dabs(reader *r, uint32_t count, sfi_list *dabs)
{
    for (uint32_t i = 0; i < count; i++) {
        sf_dab dab;
        SF_TRY(read_dab(r, &dab));
        SF_TRY(sfi_list_push(&r->session->allocator, dabs, &dab));
    }
    return SF_OK;
}

static sf_status read_stroke(reader *r)
{
    sf_brush brush = sf_brush_default();
    sfi_list dabs = sfi_list_of(sizeof(sf_dab));
    uint32_t tip, material, mirrors, count, tips = (uint32_t)r->session->tips.count;
    SF_TRY(read_kind(r, &brush.kind));
    if (tips == 0) {
        return refuse(r, SF_ERR_FORMAT, "a stroke stands before the first tip; give its tip first");
    }
    SF_TRY(read_u32(r, "the number of a tip that was given", tips - 1, &tip));
    SF_TRY(read_u32(r, "a material, 1 to 255", 255, &material));
    SF_TRY(read_u32(r, "a number of passes, 1 to 16", SF_BRUSH_PASSES_MAX, &brush.passes));
    SF_TRY(read_u32(r, "mirrors, 0 to 3", 3, &mirrors));
    SF_TRY(read_u32(r, "a count of dabs", UINT32_MAX, &count));
    brush.material = (uint8_t)material;
    brush.mirror_x = (int)(mirrors & 1);
    brush.mirror_y = (int)(mirrors >> 1);
    sf_status status = read_dabs(r, count, &dabs);
    if (status == SF_OK) {
        status = sf_session_add_stroke(r->session, &brush, tip, dabs.items, dabs.count);
        status = status == SF_ERR_ARGUMENT
                     ? refuse(r, SF_ERR_FORMAT, "a material or a number of passes is 0")
                     : status;
    }
    sfi_list_free(&r->session->allocator, &dabs);
    return status;
}

static sf_status read_runs(reader *r, sfi_list *runs)
{
    uint32_t count;
    SF_TRY(read_u32(r, "a count of runs", UINT32_MAX, &count));
    for (uint32_t i = 0; i < count; i++) {
        sfi_session_run run = {0, 0, 0, 0, 0};
        uint32_t material;
        SF_TRY(read_u32(r, "a layer", SF_LAYER_MAX, &run.z));
        SF_TRY(read_u32(r, "a row", SF_EXTENT_MAX, &run.y));
        SF_TRY(read_u32(r, "a column", SF_EXTENT_MAX, &run.x));
        SF_TRY(read_u32(r, "a length", SF_EXTENT_MAX, &run.length));
        SF_TRY(read_u32(r, "a material, 1 to 255", 255, &material));
        run.material = (uint8_t)material;
        if (!sfi_session_run_is_valid(r->session, &run)) {
            return refuse(r, SF_ERR_FORMAT,
                          "a run leaves the space, is empty or has no material; correct that line");
        }
        SF_TRY(sfi_list_push(&r->session->allocator, runs, &run));
    }
    return SF_OK;
}

static sf_status read_shape(reader *r)
{
    sf_session *s = r->session;
    sfi_session_item item = {.kind = SFI_STEP_SHAPE, .first = s->runs.count};
    SF_TRY(read_runs(r, &s->runs));
    item.count = s->runs.count - item.first;
    return sfi_list_push(&s->allocator, &s->items, &item);
}

// All that follows the head. A state is the last thing before the end.
static sf_status read_steps(reader *r)
{
    for (;;) {
        next_word(r);
        int other = find(r, sfi_session_steps, 3);
        if (strcmp(r->word, "end") == 0) {
            return SF_OK;
        }
        if (strcmp(r->word, "state") == 0) {
            r->session->has_state = 1;
            SF_TRY(read_runs(r, &r->session->state));
            return read_word(r, "end");
        }
        if (strcmp(r->word, "tip") == 0) {
            SF_TRY(read_tip(r));
        } else if (strcmp(r->word, "stroke") == 0) {
            SF_TRY(read_stroke(r));
        } else if (strcmp(r->word, "shape") == 0) {
            SF_TRY(read_shape(r));
        } else if (other >= 0) {
            SF_TRY(sf_session_add_step(r->session, (sf_session_step)other));
        } else {
            return wrong(r, "tip, stroke, undo, redo, drop-ghosts, shape, state or end");
        }
    }
}

sf_status sf_session_read(sf_source source, uint64_t bytes_max, const sf_allocator *allocator,
                          sf_session **session, sf_fault *fault)
{
    reader r = {.fault = fault};
    if (session == NULL) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(sfi_cursor_begin(&r.cursor, source, bytes_max > 0 ? bytes_max : BYTES_MAX, allocator));
    sf_status status = read_head(&r, allocator);
    if (status == SF_OK) {
        status = read_steps(&r);
    }
    if (status != SF_OK && r.cursor.failure != SF_OK) {
        status = sfi_cursor_fault(&r.cursor, fault, "the file is cut short");
    }
    sfi_cursor_end(&r.cursor);
    if (status != SF_OK) {
        sf_session_destroy(r.session);
        return status == SF_ERR_MEMORY
                   ? sfi_fault_set(fault, status, 0, 0, "there is no memory for the session")
                   : status;
    }
    *session = r.session;
    return SF_OK;
}
