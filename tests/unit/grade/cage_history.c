// SPDX-License-Identifier: MIT
// Why: who undoes wants back what was there, to the bit, and who draws all day must not run out of
// memory. Random edits by every call that changes a cage are held against copies of the whole cage
// taken after each, through undo and redo in any order. Promises: exact; within the bytes given;
// what fails has changed neither cage nor history.

#include "cages.h"
#include "failing_allocator.h"

#include <sf/cage_history.h>
#include <sf/paint.h>

enum { MOST = 120, KEPT = 64, CHANNELS = 2 };

// A whole cage.
typedef struct copy {
    double positions[3 * MOST], values[CHANNELS][MOST];
} copy;

static void look(const sf_cage *cage, copy *c)
{
    sf_cage_view v = sf_cage_get_view(cage);
    memset(c, 0, sizeof *c);
    memcpy(c->positions, v.positions, 3 * v.point_count * sizeof(double));
    for (size_t i = 0; i < v.channel_count; i++) {
        memcpy(c->values[i], v.channels[i].values, v.channels[i].value_count * sizeof(double));
    }
}

static int is_as(const sf_cage *cage, const copy *c)
{
    copy now;
    look(cage, &now);
    return memcmp(&now, c, sizeof now) == 0;
}

static sf_cage *make(void)
{
    test_cage c = test_cage_block(4, 3, 3);
    c.values = calloc(c.points, sizeof *c.values);
    for (size_t i = 0; i < c.points; i++) {
        c.values[i] = test_random_unit();
    }
    sf_cage *cage = test_cage_make(&c);
    sf_channel second = {sf_property_young(), c.points, c.values, NULL};
    CHECK_EQ(sf_cage_add_property(cage, &second, NULL), SF_OK);
    test_cage_free(&c);
    return cage;
}

static void edit(sf_cage *cage)
{
    sf_paint_brush b = sf_paint_brush_default();
    double weights[MOST] = {0}, vector[3] = {0.1, -0.2, 0}, zero = -0.0;
    for (int axis = 0; axis < 3; axis++) {
        b.from_mm[axis] = b.to_mm[axis] = 4 * test_random_unit();
    }
    b.radius_mm = 0.5 + 3 * test_random_unit();
    CHECK_EQ(sf_paint_select(cage, &b, weights, NULL), SF_OK);
    switch (test_random() % 5) {
    case 0:
        CHECK_EQ(sf_paint_values(cage, 0, weights, SF_PAINT_SET, test_random_unit(), NULL, NULL),
                 SF_OK);
        break;
    case 1:
        CHECK_EQ(sf_paint_values(cage, 1, weights, SF_PAINT_SMOOTH, 0.5, NULL, NULL), SF_OK);
        break;
    case 2:
        CHECK_EQ(sf_paint_move(cage, weights, vector, NULL, NULL), SF_OK);
        break;
    case 3:
        CHECK_EQ(sf_paint_smooth(cage, weights, 0.5, NULL, NULL), SF_OK);
        break;
    default: // a zero that changes nothing but its sign, and one number alone
        CHECK_EQ(sf_cage_set_values(cage, 0, test_random() % 80, 1, &zero), SF_OK);
    }
}

static void undo_and_redo_are_exact(void)
{
    static copy kept[KEPT];
    sf_cage *cage = make();
    sf_cage_history *history = NULL;
    CHECK_EQ(sf_cage_history_create(cage, (size_t)1 << 24, NULL, &history), SF_OK);
    look(cage, &kept[0]);
    size_t last = 0, at = 0;
    for (int round = 0; round < 400; round++) {
        size_t changed = 0;
        unsigned way = (unsigned)(test_random() % 4);
        if (way < 2 && at + 1 < KEPT) {
            edit(cage);
            if (way == 0) { // two dabs, one step
                edit(cage);
            }
            CHECK_EQ(sf_cage_history_record(history, cage, &changed), SF_OK);
            if (changed > 0) {
                look(cage, &kept[++at]);
                last = at;
            }
            CHECK(is_as(cage, &kept[at]));
        } else if (way == 2) {
            CHECK_EQ(sf_cage_history_undo(history, cage, &changed), SF_OK);
            CHECK_EQ(changed > 0, at > 0);
            at -= at > 0;
        } else {
            CHECK_EQ(sf_cage_history_redo(history, cage, &changed), SF_OK);
            CHECK_EQ(changed > 0, at < last);
            at += at < last;
        }
        CHECK(is_as(cage, &kept[at]));
        sf_cage_history_state state = sf_cage_history_get_state(history);
        CHECK_EQ(state.undo_count, at);
        CHECK_EQ(state.redo_count, last - at);
    }
    sf_cage_history_destroy(history);
    sf_cage_destroy(cage);
}

static void what_was_not_recorded_is_undone_first(void)
{
    sf_cage *cage = make();
    sf_cage_history *history = NULL;
    copy start;
    size_t changed = 0;
    double value = 7;
    look(cage, &start);
    CHECK_EQ(sf_cage_history_create(cage, 4096, NULL, &history), SF_OK);
    CHECK_EQ(sf_cage_set_values(cage, 0, 3, 1, &value), SF_OK);
    CHECK_EQ(sf_cage_history_undo(history, cage, &changed), SF_OK);
    CHECK_EQ(changed, 1);
    CHECK(is_as(cage, &start));
    CHECK_EQ(sf_cage_set_values(cage, 0, 4, 1, &value), SF_OK);
    CHECK_EQ(sf_cage_history_redo(history, cage, &changed), SF_OK); // another way was taken
    CHECK_EQ(changed, 0);
    CHECK(sf_cage_get_view(cage).channels[0].values[4] == 7);
    CHECK_EQ(sf_cage_history_get_state(history).redo_count, 0);
    CHECK_EQ(sf_cage_history_get_state(history).undo_count, 1);
    CHECK_EQ(sf_cage_history_get_state(history).bytes, 32); // one number alone
    sf_cage_history_destroy(history);
    sf_cage_destroy(cage);
}

static void the_oldest_are_forgotten(void)
{
    sf_cage *cage = make();
    sf_cage_history *history = NULL;
    size_t changed = 0;
    CHECK_EQ(sf_cage_history_create(cage, 10 * 32 + 31, NULL, &history), SF_OK);
    for (int i = 1; i <= 25; i++) {
        double value = i;
        CHECK_EQ(sf_cage_set_values(cage, 1, 5, 1, &value), SF_OK);
        CHECK_EQ(sf_cage_history_record(history, cage, NULL), SF_OK);
        CHECK(sf_cage_history_get_state(history).bytes <= 10 * 32 + 31);
    }
    CHECK_EQ(sf_cage_history_get_state(history).undo_count, 10);
    for (int i = 0; i < 12; i++) {
        CHECK_EQ(sf_cage_history_undo(history, cage, &changed), SF_OK);
        CHECK_EQ(changed, i < 10);
    }
    CHECK(sf_cage_get_view(cage).channels[1].values[5] == 15);
    double all[MOST] = {0};
    CHECK_EQ(sf_cage_set_values(cage, 1, 0, sf_cage_get_view(cage).point_count, all), SF_OK);
    CHECK_EQ(sf_cage_history_record(history, cage, &changed), SF_OK);
    CHECK_EQ(changed, sf_cage_get_view(cage).point_count);
    CHECK_EQ(sf_cage_history_get_state(history).undo_count, 0); // too large for any place
    sf_cage_history_destroy(history);
    sf_cage_destroy(cage);
}

static void other_cages_are_refused(void)
{
    sf_cage *cage = make();
    test_cage other = test_cage_block(1, 1, 1);
    sf_cage *small = test_cage_make(&other);
    sf_cage_history *history = NULL;
    double values[MOST] = {0}, seven = 7;
    CHECK_EQ(sf_cage_history_create(NULL, 0, NULL, &history), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_cage_history_create(cage, 4096, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_cage_history_create(cage, 4096, NULL, &history), SF_OK);
    CHECK_EQ(sf_cage_history_record(NULL, cage, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_cage_history_undo(history, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_cage_history_record(history, small, NULL), SF_ERR_SHAPE);
    // One more property is watched from then on, and one less is another cage.
    sf_channel third = {sf_property_poisson(), sf_cage_get_view(cage).point_count, values, NULL};
    size_t changed = 9;
    CHECK_EQ(sf_cage_add_property(cage, &third, NULL), SF_OK);
    CHECK_EQ(sf_cage_history_record(history, cage, &changed), SF_OK);
    CHECK_EQ(changed, 0);
    seven = 0.25;
    CHECK_EQ(sf_cage_set_values(cage, 2, 1, 1, &seven), SF_OK);
    CHECK_EQ(sf_cage_history_undo(history, cage, &changed), SF_OK);
    CHECK_EQ(changed, 1);
    CHECK(sf_cage_get_view(cage).channels[2].values[1] == 0);
    CHECK_EQ(sf_cage_remove_property(cage, 0), SF_OK);
    CHECK_EQ(sf_cage_history_undo(history, cage, NULL), SF_ERR_SHAPE);
    CHECK_EQ(sf_cage_history_get_state(NULL).bytes, 0);
    sf_cage_history_destroy(history);
    sf_cage_history_destroy(NULL);
    sf_cage_destroy(small);
    test_cage_free(&other);
    sf_cage_destroy(cage);
}

static void without_memory_nothing_is_changed(void)
{
    for (long k = 0; k < 12; k++) {
        sf_cage *cage = make();
        sf_cage_history *history = NULL;
        failing_allocator memory;
        failing_begin(&memory, k);
        sf_status status = sf_cage_history_create(cage, 1 << 20, &memory.allocator, &history);
        for (int i = 0; status == SF_OK && i < 4; i++) {
            copy before;
            double values[MOST] = {0};
            sf_channel third = {sf_property_poisson(), sf_cage_get_view(cage).point_count, values,
                                NULL};
            edit(cage);
            if (i == 2) {
                CHECK_EQ(sf_cage_add_property(cage, &third, NULL), SF_OK);
                CHECK_EQ(sf_cage_remove_property(cage, 2), SF_OK);
            }
            look(cage, &before);
            sf_cage_history_state was = sf_cage_history_get_state(history);
            status = i % 2 ? sf_cage_history_undo(history, cage, NULL)
                           : sf_cage_history_record(history, cage, NULL);
            sf_cage_history_state is = sf_cage_history_get_state(history);
            CHECK(status == SF_OK || status == SF_ERR_MEMORY);
            CHECK(status == SF_OK || (is_as(cage, &before) && was.bytes == is.bytes &&
                                      was.undo_count == is.undo_count));
        }
        sf_cage_history_destroy(history);
        CHECK(memory.live == 0 && memory.faults == 0);
        sf_cage_destroy(cage);
    }
}

int main(void)
{
    TEST(undo_and_redo_are_exact);
    TEST(what_was_not_recorded_is_undone_first);
    TEST(the_oldest_are_forgotten);
    TEST(other_cages_are_refused);
    TEST(without_memory_nothing_is_changed);
    return test_finish();
}
