// SPDX-License-Identifier: MIT
// Arguments out of bytes: numbers, arrays, views and rules. Most are such that a call can do its
// work; some are not, and those that the library must refuse come up in every run.

#include "world.h"

size_t world_few(world *w)
{
    return draw_below(&w->in, 6);
}

#define ARRAY(TYPE, NAME, VALUE)                                                                   \
    const TYPE *NAME(world *w, size_t count)                                                       \
    {                                                                                              \
        if (draw_odd(&w->in, 32) || count > 1u << 20) {                                            \
            return NULL;                                                                           \
        }                                                                                          \
        TYPE *values = world_scratch(w, count * sizeof *values);                                   \
        for (size_t i = 0; i < count; i++) {                                                       \
            values[i] = (TYPE)(VALUE);                                                             \
        }                                                                                          \
        return values;                                                                             \
    }

ARRAY(double, world_doubles, draw_double(&w->in))
ARRAY(double, world_places, draw_place(&w->in) * 4)
ARRAY(float, world_floats, draw_odd(&w->in, 32) ? draw_double(&w->in) : 1 + draw_byte(&w->in) / 64)
ARRAY(uint32_t, world_words, draw_odd(&w->in, 24) ? draw_word(&w->in) : draw_below(&w->in, 8))
ARRAY(uint8_t, world_bytes, draw_byte(&w->in))

const char *world_text(world *w)
{
    static const char *const texts[] = {
        "",
        "box3",
        "octagon",
        "disk",
        "slack",
        "a.stl",
        "b.OBJ",
        "density",
        "Young",
        "poisson",
        ".off",
        "x/y.ply",
        "a name that is much longer than any that a property may have"};
    return draw_odd(&w->in, 16) ? NULL : texts[draw_below(&w->in, sizeof texts / sizeof *texts)];
}

const sf_allocator *world_allocator(world *w)
{
    return &w->allocator;
}

static void on_progress(void *user, double fraction)
{
    world *w = user;
    if (!(fraction >= w->progress && fraction <= 1)) {
        world_fail(w, "progress falls, or leaves [0, 1]");
    }
    w->progress = fraction;
    if (w->cancel_at >= 0 && w->ticks++ >= w->cancel_at) {
        sf_task_cancel(&w->task);
    }
}

// From the last to the first, which no result may depend on.
static void backwards(void *user, size_t count, sf_task_body body, void *context)
{
    (void)user;
    while (count-- > 0) {
        body(context, count);
    }
}

sf_task *world_task(world *w)
{
    uint32_t choice = draw_byte(&w->in);
    w->task = sf_task_default();
    w->task.progress = on_progress;
    w->task.user = w;
    w->task.parallel_for = choice & 2 ? backwards : NULL;
    w->cancel_at = -1;
    if (!w->in.sane && choice % 16 == 0) {
        w->cancel_at = draw_below(&w->in, 4);
    }
    if (w->cancel_wanted >= 0) {
        w->cancel_at = w->cancel_wanted;
    }
    return choice & 1 || w->cancel_wanted >= 0 ? &w->task : NULL;
}

sf_fault *world_fault(world *w)
{
    memset(&w->fault, 0, sizeof w->fault);
    w->fault_given = draw_odd(&w->in, 8) ? NULL : &w->fault;
    return w->fault_given;
}

sf_rect world_sf_rect(world *w)
{
    sf_rect r = {draw_below(&w->in, 12), draw_below(&w->in, 12), draw_below(&w->in, 12),
                 draw_below(&w->in, 12)};
    if (draw_odd(&w->in, 16)) {
        r.x1 = (uint32_t)draw_count(&w->in);
    }
    return r;
}

sf_box world_sf_box(world *w)
{
    sf_box b = {draw_below(&w->in, 4), draw_below(&w->in, 4), draw_below(&w->in, 4), 0, 0, 0};
    b.x1 = b.x0 + draw_below(&w->in, 12);
    b.y1 = b.y0 + draw_below(&w->in, 12);
    b.z1 = b.z0 + draw_below(&w->in, 12);
    if (draw_odd(&w->in, 16)) {
        b.z1 = (uint32_t)draw_count(&w->in);
    }
    return b;
}

sf_voxel world_sf_voxel(world *w)
{
    sf_voxel v = {world_index(w), world_index(w), world_index(w)};
    return v;
}

sf_dab world_sf_dab(world *w)
{
    sf_dab d = {(int32_t)draw_below(&w->in, 14) - 2, (int32_t)draw_below(&w->in, 14) - 2,
                (int32_t)draw_below(&w->in, 14) - 2};
    if (draw_odd(&w->in, 32)) {
        d.z = draw_below(&w->in, 2) ? INT32_MAX : INT32_MIN;
    }
    return d;
}

uint32_t world_index(world *w)
{
    return draw_odd(&w->in, 24) ? (uint32_t)draw_count(&w->in) : draw_below(&w->in, 10);
}

uint32_t world_bed(world *w)
{
    return draw_below(&w->in, 4) ? SF_BED_AUTO : world_index(w);
}

double world_angle(world *w)
{
    static const double usual[] = {0.785398, 0.6, 1, 0.3, 1.2, 0.0873, 1.48, 0.5};
    return draw_odd(&w->in, 16) ? draw_double(&w->in) : usual[draw_below(&w->in, 8)];
}

sf_slice world_layer(world *w)
{
    sf_slice nothing = {NULL, 0, 0, 0};
    const sf_grid *grid = world_need(w, "sf_grid");
    if (grid == NULL) {
        return nothing;
    }
    sf_lattice l = sf_grid_lattice(grid);
    return sf_grid_slice(grid, draw_byte(&w->in) % l.nz);
}

// A slice of its own that ends where its memory ends.
sf_slice world_sf_slice(world *w)
{
    sf_slice s = {NULL, w->lattice.nx, w->lattice.ny, 0};
    if (draw_odd(&w->in, 8)) {
        s.width = 1 + draw_byte(&w->in);
        s.height = 1 + draw_below(&w->in, 20);
    }
    s.stride = (s.width + 63) / 64 + draw_below(&w->in, 2);
    s.words = world_scratch(w, s.height * s.stride * sizeof *s.words);
    for (uint32_t y = 0; y < s.height; y++) {
        for (uint32_t x = 0; x < s.width; x += 7) {
            uint64_t bits = draw_byte(&w->in) & 0x7fu;
            for (uint32_t i = 0; i < 7 && x + i < s.width; i++) {
                s.words[y * s.stride + (x + i) / 64] |= (bits >> i & 1) << (x + i) % 64;
            }
        }
    }
    if (draw_odd(&w->in, 32)) {
        s.stride = (size_t)draw_count(&w->in) % 2;
    }
    if (draw_odd(&w->in, 64)) {
        s.words = NULL;
    }
    return s;
}

sf_lattice world_sf_lattice(world *w)
{
    static const double pitches[] = {1, 0.5, 1, 0.25};
    if (w->lattice.nx > 0 && !draw_odd(&w->in, 6)) {
        return w->lattice;
    }
    sf_lattice l = {1 + draw_below(&w->in, 11),
                    1 + draw_below(&w->in, 9),
                    1 + draw_below(&w->in, 9),
                    1,
                    1,
                    1,
                    NULL,
                    {0, 0, 0}};
    uint32_t kind = draw_byte(&w->in);
    l.pitch_x_mm = l.pitch_y_mm = l.layer_mm = pitches[kind % 4];
    if (kind % 16 == 15) {
        l.pitch_y_mm = 0.75;
    }
    if (kind % 8 == 6) {
        l.heights_mm = world_doubles(w, l.nz);
    }
    if (draw_odd(&w->in, 16)) {
        uint32_t *counts[] = {&l.nx, &l.ny, &l.nz};
        *counts[draw_below(&w->in, 3)] = (uint32_t)draw_count(&w->in);
        l.heights_mm = NULL;
    }
    if (draw_odd(&w->in, 16)) {
        double *sizes[] = {&l.pitch_x_mm, &l.pitch_y_mm, &l.layer_mm, &l.origin_mm[0]};
        *sizes[draw_below(&w->in, 4)] = draw_double(&w->in);
    }
    return l;
}

sf_rule world_sf_rule(world *w)
{
    if (w->terms.struct_size > 0 && draw_below(&w->in, 4)) {
        return w->rule;
    }
    sf_rule rule = sf_rule_box3();
    size_t count = sf_rule_table_count(&w->lattice);
    uint64_t *table = count > 0 ? world_scratch(w, 2 * count * sizeof *table) : NULL;
    if (sf_rule_make((sf_rule_kind)draw_below(&w->in, 4), world_angle(w), &w->lattice, table, &rule,
                     NULL) != SF_OK) {
        return sf_rule_box3();
    }
    if (draw_below(&w->in, 8) == 7) {
        (void)!sf_rule_set_bridges(&rule, draw_double(&w->in), draw_double(&w->in), &w->lattice,
                                   NULL);
    }
    return rule;
}

static sf_terms terms_of(world *w, void *(*grid)(world *, const char *))
{
    sf_terms t = sf_terms_default();
    const sf_grid **masks[] = {&t.exempt, &t.keep, &t.forbid, &t.act};
    t.rule = world_sf_rule(w);
    t.bed_layer = world_bed(w);
    uint32_t choice = draw_byte(&w->in);
    for (int i = 0; i < 4; i++) {
        if ((choice >> 2 * i & 3) == 3) {
            *masks[i] = grid(w, "sf_grid");
        }
    }
    if (draw_odd(&w->in, 32)) {
        t.struct_size = draw_byte(&w->in);
    }
    return t;
}

sf_terms world_sf_terms(world *w)
{
    return terms_of(w, world_pick);
}

// With masks that nothing else changes, for what keeps pointers to them.
sf_terms world_own_terms(world *w)
{
    return terms_of(w, world_own);
}

sf_element world_sf_element(world *w)
{
    sf_element e = draw_below(&w->in, 2) ? sf_element_plus3() : sf_element_box3();
    if (draw_below(&w->in, 2)) {
        (void)!sf_element_ellipse((uint64_t)draw_byte(&w->in) << 11,
                                  (uint64_t)draw_byte(&w->in) << 11, &e);
    }
    if (draw_odd(&w->in, 16)) {
        e.reach_y = (uint16_t)draw_count(&w->in);
        e.half_width[draw_byte(&w->in)] = (uint16_t)draw_count(&w->in);
    }
    return e;
}

sf_run *world_runs(world *w, size_t count)
{
    sf_run *runs = world_scratch(w, count * sizeof *runs);
    uint32_t x = 0, y = 0;
    for (size_t i = 0; i < count; i++) {
        uint32_t step = draw_byte(&w->in);
        if (step % 4 == 0) {
            y++;
            x = 0;
        }
        x += 1 + step / 4 % 4;
        sf_run run = {x, x + 1 + step / 16 % 4, y, draw_below(&w->in, 4)};
        if (draw_odd(&w->in, 24)) {
            run.x1 = (uint32_t)draw_count(&w->in);
        }
        x = run.x1;
        runs[i] = run;
    }
    return runs;
}
