// SPDX-License-Identifier: MIT
// The scenes that brushes made are what they are said to be: SHAUN has at least 230 layers and 150
// dabs; after every stroke of every scene the printable shape is support-free and the trim of what
// is drawn, undo gives back the exact bits and redo the next ones (TRUST 33-63); and a session of
// them, written and read again, plays to the same bits.

#include <sf/sf.h>

#include "sculpted.h"
#include "test.h"

static void check_model(const sf_sculpt *model)
{
    sf_check_options check = sf_check_options_default();
    sf_check_report report;
    sf_grid *fresh = NULL;
    check.bed_layer = 0;
    CHECK(sf_grid_check(sf_sculpt_printable(model), &check, NULL, NULL, &report, NULL) == SF_OK);
    CHECK_EQ(report.unsupported_voxels, 0);
    CHECK(sf_grid_clone(sf_sculpt_drawn(model), NULL, &fresh) == SF_OK);
    CHECK(sf_grid_trim(fresh, &check.rule, 0, NULL, NULL) == SF_OK);
    CHECK(sf_grid_equal(fresh, sf_sculpt_printable(model)));
    sf_grid_destroy(fresh);
}

static void check_undo(sf_sculpt *model, const sf_grid *before)
{
    sf_grid *after = NULL;
    CHECK(sf_grid_clone(sf_sculpt_printable(model), NULL, &after) == SF_OK);
    CHECK(sf_sculpt_undo(model, NULL) == SF_OK);
    CHECK(sf_grid_equal(before, sf_sculpt_printable(model)));
    CHECK(sf_sculpt_redo(model, NULL) == SF_OK);
    CHECK(sf_grid_equal(after, sf_sculpt_printable(model)));
    sf_grid_destroy(after);
}

// What brushes did in a scene.
typedef struct tally {
    uint64_t kept_back, lost, paths;
    long changed;
} tally;

static void play_checked(const sf_session *session, tally *t)
{
    sf_sculpt *model = NULL;
    CHECK(sf_session_begin(session, NULL, &model) == SF_OK);
    for (size_t i = 0; i < sf_session_count(session).steps; i++) {
        sf_sculpt_change change;
        sf_grid *before = NULL;
        size_t steps = sf_sculpt_history_of(model).undo_count;
        CHECK(sf_grid_clone(sf_sculpt_printable(model), NULL, &before) == SF_OK);
        CHECK(sf_session_play(session, i, NULL, model, &change) == SF_OK);
        check_model(model);
        if (sf_sculpt_history_of(model).undo_count > steps) {
            check_undo(model, before);
        }
        t->kept_back += change.kept_back_voxels;
        t->lost += change.lost_voxels;
        t->paths += change.path_voxels;
        t->changed += change.added_voxels + change.removed_voxels + change.lost_voxels > 0;
        sf_grid_destroy(before);
    }
    sf_sculpt_destroy(model);
}

static void every_stroke(void)
{
    for (int i = 0; sculpted_names[i] != NULL; i++) {
        sf_session *session = NULL;
        tally t = {0, 0, 0, 0};
        CHECK(sculpted_session(sculpted_names[i], 128, NULL, &session) == SF_OK);
        sf_session_counts c = sf_session_count(session);
        play_checked(session, &t);
        printf("# %s: %zu strokes, %zu dabs; %ld changed the shape, %llu voxels kept back, %llu "
               "fell, %llu of paths\n",
               sculpted_names[i], c.strokes, c.dabs, t.changed, (unsigned long long)t.kept_back,
               (unsigned long long)t.lost, (unsigned long long)t.paths);
        CHECK(t.changed * 10 >= (long)c.strokes * 7);
        CHECK(t.kept_back > 0 && t.paths > 0);
        sf_session_destroy(session);
    }
}

// At the resolution of the paper, 0.25 mm.
static void shaun_is_whole(void)
{
    sf_session *session = NULL;
    sf_sculpt *model = NULL;
    CHECK(sculpted_session("shaun", 512, NULL, &session) == SF_OK);
    CHECK(sf_session_replay(session, NULL, NULL, &model) == SF_OK);
    sf_box b = sf_grid_bounds(sf_sculpt_printable(model));
    sf_session_counts c = sf_session_count(session);
    printf("# %u layers, %.1f x %.1f x %.1f mm, %zu dabs in %zu strokes, %llu voxels\n", b.z1,
           0.25 * (b.x1 - b.x0), 0.25 * (b.y1 - b.y0), 0.25 * b.z1, c.dabs, c.strokes,
           (unsigned long long)sf_grid_popcount(sf_sculpt_printable(model)));
    CHECK(b.z0 == 0 && b.z1 >= 230);
    CHECK(c.strokes >= 150 && c.dabs >= 150);
    check_model(model);
    sf_sculpt_destroy(model);
    sf_session_destroy(session);
}

// Space to write to.
typedef struct text {
    char *bytes;
    size_t size;
} text;

static sf_status append(void *user, const void *data, size_t size)
{
    text *t = user;
    t->bytes = realloc(t->bytes, t->size + size);
    memcpy(t->bytes + t->size, data, size);
    t->size += size;
    return SF_OK;
}

static void written_and_read(void)
{
    for (int i = 0; sculpted_names[i] != NULL; i++) {
        sf_session *session = NULL, *again = NULL;
        sf_sculpt *first = NULL, *second = NULL;
        text t = {NULL, 0};
        sf_sink sink = {append, &t};
        CHECK(sculpted_session(sculpted_names[i], 96, NULL, &session) == SF_OK);
        CHECK(sf_session_replay(session, NULL, NULL, &first) == SF_OK);
        CHECK(sf_session_keep_state(session, first) == SF_OK);
        CHECK(sf_session_write(session, sink) == SF_OK);
        sf_memory_cursor cursor = {t.bytes, t.size, 0};
        CHECK(sf_session_read(sf_memory_source(&cursor), 0, NULL, &again, NULL) == SF_OK);
        CHECK(sf_session_replay(again, NULL, NULL, &second) == SF_OK);
        CHECK(sf_grid_equal(sf_sculpt_printable(first), sf_sculpt_printable(second)));
        CHECK(memcmp(sf_sculpt_materials(first), sf_sculpt_materials(second), 96 * 96 * 96) == 0);
        free(t.bytes);
        sf_sculpt_destroy(first);
        sf_sculpt_destroy(second);
        sf_session_destroy(session);
        sf_session_destroy(again);
    }
}

static void refused(void)
{
    sf_session *session = NULL;
    CHECK(sculpted_session("timmy", 128, NULL, &session) == SF_ERR_ARGUMENT);
    CHECK(sculpted_session("shaun", 63, NULL, &session) == SF_ERR_ARGUMENT);
    CHECK(sculpted_session("shaun", 513, NULL, &session) == SF_ERR_ARGUMENT);
    CHECK(session == NULL);
}

int main(void)
{
    TEST(every_stroke);
    TEST(shaun_is_whole);
    TEST(written_and_read);
    TEST(refused);
    return test_finish();
}
