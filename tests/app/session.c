// SPDX-License-Identifier: MIT
// What a person saves is what a person sees, also where there was no memory to write a step down:
// then the session begins with the shape. It was saved without the step, and nobody was told. And
// what the pointer draws has no gaps.

#include "test.h"

#include "app/editor.h"

enum { SIZE = 400 };

static editor *make(void)
{
    sf_sculpt_options o = sf_sculpt_options_default();
    sf_sculpt *model = NULL;
    o.lattice.nx = o.lattice.ny = o.lattice.nz = 32;
    CHECK(sf_sculpt_create(&o, NULL, &model) == SF_OK);
    editor *e = editor_create(model, NULL, SIZE, SIZE);
    CHECK(e != NULL);
    return e;
}

static void stroke_at(editor *e, double x, double y)
{
    const app_event down = {EVENT_PRESS, BUTTON_LEFT, 0, x, y, 0, 0, 0};
    const app_event up = {EVENT_RELEASE, BUTTON_LEFT, 0, x, y, 0, 0, 0};
    editor_take(e, &down);
    editor_take(e, &up);
}

static void check_session(editor *e)
{
    sf_sculpt *again = NULL;
    const sf_session *session = editor_session(e);
    CHECK(session != NULL);
    CHECK(sf_session_replay(session, NULL, NULL, &again) == SF_OK);
    CHECK(sf_grid_equal(sf_sculpt_drawn(again), sf_sculpt_drawn(e->model)));
    CHECK(memcmp(sf_sculpt_materials(again), sf_sculpt_materials(e->model), 32 * 32 * 32) == 0);
    sf_sculpt_destroy(again);
}

static void all_was_recorded(void)
{
    editor *e = make();
    stroke_at(e, 200, 200);
    CHECK(sf_grid_popcount(sf_sculpt_drawn(e->model)) > 0);
    CHECK_EQ(sf_session_count(editor_session(e)).strokes, 1);
    check_session(e);
    editor_destroy(e);
}

static void something_was_not(void)
{
    editor *e = make();
    const app_event undo = {EVENT_DO, DO_UNDO, 0, 0, 0, 0, 0, 0};
    stroke_at(e, 200, 200);
    e->is_recorded = 0; // as where there was no memory for what follows
    stroke_at(e, 220, 240);
    uint64_t voxels = sf_grid_popcount(sf_sculpt_drawn(e->model));
    check_session(e);
    editor_take(e, &undo);
    CHECK(sf_grid_popcount(sf_sculpt_drawn(e->model)) < voxels);
    check_session(e); // the session that began with the shape has no stroke to undo
    editor_destroy(e);
}

// A pointer that is moved fast leaves no gap, however long the space.
static void a_fast_move(void)
{
    sf_sculpt_options o = sf_sculpt_options_default();
    sf_sculpt *model = NULL;
    o.lattice.nx = 1200;
    o.lattice.ny = o.lattice.nz = 8;
    CHECK(sf_sculpt_create(&o, NULL, &model) == SF_OK);
    editor *e = editor_create(model, NULL, 1200, SIZE);
    CHECK(e != NULL);
    const app_event above[2] = {{EVENT_SET, SET_RADIUS, 0, 0.5, 0, 0, 0, 0},
                                {EVENT_DO, DO_FRAME, 0, 0, 0, 0, 0, 0}};
    e->camera.azimuth = -1.5707963;
    editor_take(e, &above[0]);
    editor_take(e, &above[1]);
    const app_event moves[3] = {{EVENT_PRESS, BUTTON_LEFT, 0, 150, 200, 0, 0, 0},
                                {EVENT_MOVE, 0, 0, 1050, 200, 0, 0, 0},
                                {EVENT_RELEASE, BUTTON_LEFT, 0, 1050, 200, 0, 0, 0}};
    for (int i = 0; i < 3; i++) {
        editor_take(e, &moves[i]);
    }
    const sf_grid *drawn = sf_sculpt_drawn(e->model);
    sf_box b = sf_grid_bounds(drawn);
    CHECK(b.x1 - b.x0 > 600);
    for (uint32_t x = b.x0; x < b.x1; x++) {
        int filled = 0;
        for (uint32_t y = 0; y < 8; y++) {
            filled = filled || sf_slice_get(sf_grid_slice(drawn, 0), x, y);
        }
        CHECK(filled);
    }
    editor_destroy(e);
}

// What is written down is read again, to the bit; what could not be read is not taken at all.
static void events_come_back(void)
{
    static const app_event all[5] = {{EVENT_MOVE, 0, 5, 0.1, -3e8, 1e-17, 0, 0},
                                     {EVENT_SET, 203, 0, 2.1e11, 0, 0, 0, 0}, // steel, in pascal
                                     {EVENT_DO, DO_STEP, 0, 0, 0, 0, 0, 0},
                                     {EVENT_SET, SET_RADIUS, 0, 2.1e11, 0, 0, 0, 0},
                                     {EVENT_SET, 203, 0, INFINITY, 0, 0, 0, 0}};
    char path[EVENT_PATH_SIZE];
    for (int i = 0; i < 5; i++) {
        app_event back;
        FILE *f = tmpfile();
        CHECK(f != NULL);
        app_event_write(f, &all[i], NULL);
        rewind(f);
        int found = app_event_read(f, &back, path);
        CHECK_EQ(found, app_event_is_good(&all[i]) ? 1 : -1);
        CHECK_EQ(found, i < 3 ? 1 : -1);
        CHECK(found < 0 || memcmp(&back.x, &all[i].x, 5 * sizeof back.x) == 0);
        CHECK(fclose(f) == 0);
    }
    CHECK(app_event_can_name("a name.vtk") && !app_event_can_name(""));
    CHECK(!app_event_can_name("two\nlines"));
}

int main(void)
{
    TEST(a_fast_move);
    TEST(events_come_back);
    TEST(all_was_recorded);
    TEST(something_was_not);
    return test_finish();
}
