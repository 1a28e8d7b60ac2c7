// SPDX-License-Identifier: MIT
// A session is what was done: played again it gives the same bits and materials, written and read
// again the same bytes, and a file that is no session is refused in words, whatever it holds and
// whenever memory runs out.

#include <sf/session.h>

#include "../unit/sculpt/random_strokes.h"
#include "failing_allocator.h"
#include "test.h"

// Bytes that a session was written to.
typedef struct text {
    char *bytes;
    size_t size;
} text;

static sf_status append(void *user, const void *data, size_t size)
{
    text *t = user;
    t->bytes = realloc(t->bytes, t->size + size + 1);
    memcpy(t->bytes + t->size, data, size);
    t->size += size;
    t->bytes[t->size] = '\0';
    return SF_OK;
}

static text write_text(const sf_session *session)
{
    text t = {NULL, 0};
    sf_sink sink = {append, &t};
    CHECK_EQ(sf_session_write(session, sink), SF_OK);
    return t;
}

static sf_status read_text(const char *bytes, size_t size, const sf_allocator *allocator,
                           sf_session **session, sf_fault *fault)
{
    sf_memory_cursor cursor = {bytes, size, 0};
    return sf_session_read(sf_memory_source(&cursor), 0, allocator, session, fault);
}

static size_t voxels_of(const sf_sculpt *model)
{
    sf_lattice l = sf_sculpt_options_of(model).lattice;
    return (size_t)l.nx * l.ny * l.nz;
}

static int is_same(const sf_sculpt *a, const sf_sculpt *b)
{
    return sf_grid_equal(sf_sculpt_drawn(a), sf_sculpt_drawn(b)) &&
           sf_grid_equal(sf_sculpt_printable(a), sf_sculpt_printable(b)) &&
           memcmp(sf_sculpt_materials(a), sf_sculpt_materials(b), voxels_of(a)) == 0;
}

static sf_session_options small_space(void)
{
    sf_session_options o = sf_session_options_default();
    sf_lattice lattice = {44, 30, 33, 0.25, 0.3, 0.1, NULL, {-5.5, 0.1, 1e-3}};
    o.lattice = lattice;
    o.history_size = 1 << 18;
    return o;
}

// Random steps, on a model and into a session.
static void record(sf_session *session, sf_sculpt *model, int steps)
{
    sf_lattice l = sf_sculpt_options_of(model).lattice;
    for (int i = 0; i < steps; i++) {
        random_stroke s = random_stroke_new(&l, 6);
        sf_dab anchor;
        const sf_grid *mask = sf_tip_mask(s.tip, &anchor);
        uint32_t tip = 0;
        CHECK_EQ(sf_session_add_mask(session, mask, anchor, &tip), SF_OK);
        CHECK_EQ(sf_session_add_stroke(session, &s.brush, tip, s.dabs, s.count), SF_OK);
        CHECK_EQ(sf_sculpt_stroke(model, &s.brush, s.dabs, s.count, NULL), SF_OK);
        random_stroke_free(&s);
        if (i % 5 == 4) {
            CHECK_EQ(sf_session_add_step(session, SF_SESSION_UNDO), SF_OK);
            (void)!sf_sculpt_undo(model, NULL);
        }
        if (i % 10 == 9) {
            CHECK_EQ(sf_session_add_step(session, SF_SESSION_REDO), SF_OK);
            (void)!sf_sculpt_redo(model, NULL);
        }
        if (i % 17 == 16) {
            CHECK_EQ(sf_session_add_step(session, SF_SESSION_DROP_GHOSTS), SF_OK);
            CHECK_EQ(sf_sculpt_drop_ghosts(model, NULL), SF_OK);
        }
    }
}

// ---------------------------------------------------------------------------------------------
// Cases
// ---------------------------------------------------------------------------------------------

static void round_trip(const sf_session_options *o)
{
    sf_session *session = NULL, *again = NULL;
    sf_sculpt *model = NULL, *played = NULL, *opened = NULL;
    CHECK_EQ(sf_session_create(o, NULL, &session), SF_OK);
    CHECK_EQ(sf_session_begin(session, NULL, &model), SF_OK);
    record(session, model, 40);
    CHECK_EQ(sf_session_keep_state(session, model), SF_OK);
    text first = write_text(session);
    sf_fault fault = {SF_OK, 0, 0, ""};
    CHECK_EQ(read_text(first.bytes, first.size, NULL, &again, &fault), SF_OK);
    CHECK_STR(fault.message, "");
    text second = write_text(again);
    CHECK(first.size == second.size && memcmp(first.bytes, second.bytes, first.size) == 0);
    CHECK_EQ(sf_session_count(again).steps, sf_session_count(session).steps);
    CHECK_EQ(sf_session_count(again).strokes, 40);
    CHECK_EQ(sf_session_replay(again, NULL, NULL, &played), SF_OK);
    CHECK(is_same(model, played));
    CHECK_EQ(sf_session_open(again, NULL, &opened), SF_OK);
    CHECK(is_same(model, opened));
    free(first.bytes);
    free(second.bytes);
    sf_sculpt_destroy(model);
    sf_sculpt_destroy(played);
    sf_sculpt_destroy(opened);
    sf_session_destroy(session);
    sf_session_destroy(again);
}

static void round_trips(void)
{
    sf_session_options o = small_space();
    round_trip(&o);
    o.keep_drawn = 1;
    round_trip(&o);
    o.rule = SF_RULE_OCTAGON;
    o.lattice.pitch_y_mm = 0.25; // its pixels are square
    o.angle_rad = 0.9;
    o.bed_layer = 2;
    round_trip(&o);
}

// A session by hand, with all that there is; one that was changed by hand is found out.
static const char by_hand[] = "libsf-session 1  # a comment\n"
                              "space 20 20 20 0.25 0.25 0.25 0 0 0\n"
                              "rule box3 0.785\nbed 0\nghosts 0\nhistory 65536\n"
                              "tip box 2 2 2\ntip mask 2 1 1 0 0 0 1\n 0 0 0 2\n"
                              "shape 1\n 0 5 5 3 4\n"
                              "stroke add-trim 0 2 1 0 1\n 10 10 2\n"
                              "stroke paint 1 3 1 1 1\n 8 8 0\nundo\nredo\ndrop-ghosts\n";

// A shape and its materials by a formula; 0 in an array counts as 1.
static sf_grid *shape_of(const sf_lattice *lattice, uint8_t *materials)
{
    sf_grid *grid = NULL;
    CHECK_EQ(sf_grid_create(lattice, NULL, &grid), SF_OK);
    for (uint32_t k = 0; k < lattice->nz; k++) {
        sf_slice slice = sf_grid_slice(grid, k);
        for (uint32_t y = 0; y < lattice->ny; y++) {
            for (uint32_t x = 0; x < lattice->nx; x++) {
                size_t at = ((size_t)k * lattice->ny + y) * lattice->nx + x;
                materials[at] = (uint8_t)((x / 3 + y / 5 + k) % 7);
                CHECK_EQ(sf_slice_set(slice, x, y, (x * 7 + y * 3 + k) % 5 != 0), SF_OK);
            }
        }
    }
    return grid;
}

// A shape in a session does what replacing the shape of a model does, also once it was a file.
static void shapes(void)
{
    sf_session_options o = small_space();
    sf_session *session = NULL, *again = NULL;
    sf_sculpt *model = NULL, *played = NULL;
    CHECK_EQ(sf_session_create(&o, NULL, &session), SF_OK);
    CHECK_EQ(sf_session_begin(session, NULL, &model), SF_OK);
    record(session, model, 6);
    uint8_t *materials = calloc(voxels_of(model), 1);
    sf_grid *grid = shape_of(&o.lattice, materials);
    CHECK_EQ(sf_session_add_shape(session, grid, materials), SF_OK);
    CHECK_EQ(sf_sculpt_replace(model, grid, materials, NULL), SF_OK);
    record(session, model, 3);
    CHECK_EQ(sf_session_add_shape(session, grid, NULL), SF_OK);
    CHECK_EQ(sf_sculpt_replace(model, grid, NULL, NULL), SF_OK);
    CHECK_EQ(sf_session_keep_state(session, model), SF_OK);
    text t = write_text(session);
    CHECK_EQ(read_text(t.bytes, t.size, NULL, &again, NULL), SF_OK);
    CHECK_EQ(sf_session_replay(again, NULL, NULL, &played), SF_OK);
    CHECK(is_same(model, played));
    size_t steps = sf_session_count(session).steps;
    sf_lattice lower = o.lattice;
    lower.nz--;
    sf_grid *other = NULL;
    CHECK_EQ(sf_grid_create(&lower, NULL, &other), SF_OK);
    CHECK_EQ(sf_session_add_shape(session, other, NULL), SF_ERR_SHAPE);
    CHECK_EQ(sf_session_add_shape(NULL, grid, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_session_add_shape(session, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_session_count(session).steps, steps);
    free(t.bytes);
    free(materials);
    sf_grid_destroy(grid);
    sf_grid_destroy(other);
    sf_sculpt_destroy(model);
    sf_sculpt_destroy(played);
    sf_session_destroy(session);
    sf_session_destroy(again);
}

static void written_by_hand(void)
{
    char bytes[1024];
    sf_session *session = NULL;
    sf_sculpt *model = NULL;
    snprintf(bytes, sizeof bytes, "%send\n", by_hand);
    CHECK_EQ(read_text(bytes, strlen(bytes), NULL, &session, NULL), SF_OK);
    CHECK_EQ(sf_session_replay(session, NULL, NULL, &model), SF_OK);
    CHECK_EQ(sf_grid_popcount(sf_sculpt_printable(model)), 3 + 5 * 5 * 5);
    const uint8_t *m = sf_sculpt_materials(model);
    CHECK_EQ(m[5 * 20 + 5], 4);
    CHECK_EQ(m[8 * 20 + 8], 3);
    CHECK_EQ(m[8 * 20 + 9], 3);
    CHECK_EQ(m[8 * 20 + 11], 3); // the mirror of 8
    CHECK_EQ(m[9 * 20 + 9], 2);
    sf_sculpt_destroy(model);
    sf_session_destroy(session);
    snprintf(bytes, sizeof bytes, "%sstate 1\n 0 5 5 3 4\nend\n", by_hand);
    CHECK_EQ(read_text(bytes, strlen(bytes), NULL, &session, NULL), SF_OK);
    model = NULL;
    CHECK_EQ(sf_session_replay(session, NULL, NULL, &model), SF_ERR_FORMAT);
    CHECK(model == NULL);
    sf_session_destroy(session);
}

// Each line breaks the session at a place of its own; the sentence names the line.
static void refused(void)
{
    static const struct {
        const char *text;
        sf_status status;
        uint32_t line;
    } bad[] = {
        {"", SF_ERR_FORMAT, 1},
        {"libsf-stack 1", SF_ERR_FORMAT, 1},
        {"libsf-session 2\n", SF_ERR_UNSUPPORTED, 1},
        {"libsf-session 1\nspace 0 1 1 1 1 1 0 0 0\nrule box3 1\nbed 0\nghosts 0\nhistory 0\n",
         SF_ERR_FORMAT, 6},
        {"libsf-session 1\nspace 9 9 9 1 1 1 0 0 0\nrule round 1\n", SF_ERR_FORMAT, 3},
        {"libsf-session 1\nspace 9 9 9 1 1 1 0 0 0\nrule box3 1\nbed 9\nghosts 0\nhistory 0\n",
         SF_ERR_FORMAT, 6},
        {"H tip box 1 1", SF_ERR_FORMAT, 7},
        {"H tip box 1 1 -1\n", SF_ERR_FORMAT, 7},
        {"H tip box 1000 1000 1000\n", SF_ERR_OVERFLOW, 7},
        {"H tip mask 4096 4096 4096 0 0 0 0\n", SF_ERR_OVERFLOW, 7},
        {"H tip mask 2 2 2 0 0 0 0\n", SF_ERR_FORMAT, 7},
        {"H tip mask 2 2 2 0 0 0 1\n 0 0 1 2\n", SF_ERR_FORMAT, 8},
        {"H stroke add-trim 0 1 1 0 0\n", SF_ERR_FORMAT, 7},
        {"H tip box 1 1 1\nstroke add-trim 1 1 1 0 0\n", SF_ERR_FORMAT, 8},
        {"H tip box 1 1 1\nstroke add-trim 0 0 1 0 0\n", SF_ERR_FORMAT, 8},
        {"H tip box 1 1 1\nstroke add-trim 0 1 17 0 0\n", SF_ERR_FORMAT, 8},
        {"H tip box 1 1 1\nstroke add-trim 0 1 1 0 4000000000\n1 1 1\n", SF_ERR_FORMAT, 10},
        {"H tip box 1 1 1\nstroke add-more 0 1 1 0 0\n", SF_ERR_FORMAT, 8},
        {"H shape 1\n 0 0 0 10 1\n", SF_ERR_FORMAT, 8},
        {"H shape 1\n 0 0 0 9 0\n", SF_ERR_FORMAT, 8},
        {"H state 1\n 0 0 0 9 1\nundo\n", SF_ERR_FORMAT, 9},
        {"H undo\n", SF_ERR_FORMAT, 8},
    };
    static const char head[] = "libsf-session 1\nspace 9 9 9 1 1 1 0 0 0\nrule box3 1\nbed 0\n"
                               "ghosts 0\nhistory 4096\n";
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        char bytes[512];
        const char *rest = bad[i].text[0] == 'H' ? bad[i].text + 2 : bad[i].text;
        sf_session *session = NULL;
        sf_fault fault = {SF_OK, 0, 0, ""};
        snprintf(bytes, sizeof bytes, "%s%s", rest != bad[i].text ? head : "", rest);
        CHECK_EQ(read_text(bytes, strlen(bytes), NULL, &session, &fault), bad[i].status);
        CHECK_EQ(fault.line, bad[i].line);
        CHECK(fault.message[0] != '\0' && session == NULL);
        if (fault.line != bad[i].line) {
            printf("# %zu: %s\n", i, fault.message);
        }
    }
}

// Every byte of a session changed, cut or doubled: read or refused, never worse.
static void mangled(void)
{
    char bytes[1024], copy[1100];
    snprintf(bytes, sizeof bytes, "%send\n", by_hand);
    size_t size = strlen(bytes);
    for (size_t i = 0; i < size; i++) {
        for (int way = 0; way < 3; way++) {
            sf_session *session = NULL;
            sf_fault fault = {SF_OK, 0, 0, ""};
            size_t length = way == 0 ? i : size;
            memcpy(copy, bytes, size);
            copy[i] = way == 1 ? (char)(' ' + test_random_below(90)) : way == 2 ? '9' : copy[i];
            sf_status status = read_text(copy, length, NULL, &session, &fault);
            CHECK((status == SF_OK) == (session != NULL));
            CHECK(status == SF_OK || fault.message[0] != '\0');
            sf_session_destroy(session);
        }
    }
}

static void out_of_memory(void)
{
    char bytes[1024];
    sf_status status = SF_ERR_MEMORY;
    long k = 0;
    snprintf(bytes, sizeof bytes, "%sstate 1\n 0 5 5 3 4\nend\n", by_hand);
    for (; status == SF_ERR_MEMORY && k < 200; k++) {
        failing_allocator f;
        sf_session *session = NULL;
        failing_begin(&f, k);
        status = read_text(bytes, strlen(bytes), &f.allocator, &session, NULL);
        CHECK((status == SF_OK) == (session != NULL));
        sf_session_destroy(session);
        CHECK(f.live == 0 && f.faults == 0);
    }
    CHECK(status == SF_OK && k > 8);
}

static void arguments(void)
{
    sf_session_options o = small_space();
    sf_session *session = NULL;
    sf_brush brush = sf_brush_default();
    sf_dab far = {INT32_MAX, 0, 0};
    uint32_t tip = 0;
    const double r[3] = {1, 1, 1};
    double heights[33];
    sf_sink none = {NULL, NULL};
    CHECK_EQ(sf_session_create(NULL, NULL, &session), SF_ERR_ARGUMENT);
    o.bed_layer = 33;
    CHECK_EQ(sf_session_create(&o, NULL, &session), SF_ERR_ARGUMENT);
    o = small_space();
    o.lattice.heights_mm = heights;
    CHECK_EQ(sf_session_create(&o, NULL, &session), SF_ERR_ARGUMENT);
    o = small_space();
    CHECK_EQ(sf_session_create(&o, NULL, &session), SF_OK);
    CHECK_EQ(sf_session_add_stroke(session, &brush, 0, NULL, 0), SF_ERR_ARGUMENT); // no tip yet
    CHECK_EQ(sf_session_add_tip(session, SF_TIP_BOX, r, &tip), SF_OK);
    CHECK_EQ(sf_session_add_stroke(session, &brush, tip, &far, 1), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_session_add_stroke(session, &brush, tip, NULL, 1), SF_ERR_ARGUMENT);
    brush.material = 0;
    CHECK_EQ(sf_session_add_stroke(session, &brush, tip, NULL, 0), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_session_add_step(session, (sf_session_step)3), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_session_count(session).steps, 0);
    CHECK_EQ(sf_session_write(session, none), SF_ERR_ARGUMENT);
    CHECK(sf_session_tip(session, 1) == NULL && sf_session_tip(NULL, 0) == NULL);
    sf_sculpt *model = NULL;
    CHECK_EQ(sf_session_open(session, NULL, &model), SF_ERR_INFEASIBLE);
    sf_session_destroy(session);
    sf_session_destroy(NULL);
}

int main(void)
{
    TEST(round_trips);
    TEST(shapes);
    TEST(written_by_hand);
    TEST(refused);
    TEST(mangled);
    TEST(out_of_memory);
    TEST(arguments);
    return test_finish();
}
