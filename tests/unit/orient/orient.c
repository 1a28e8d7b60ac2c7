// SPDX-License-Identifier: MIT
// Why: parts that plainly print best one way up must be put that way (issue 3 item 9): a T on its
// head, a table on its top, a wedge on a flat side, and the two models of the data folder that are
// named for what is wrong with them, with twins that need no folder.

#include "data_file.h"
#include "solids.h"
#include "test.h"

#include <sf/orient.h>

static shape part;

static sf_orient_options quick(void)
{
    sf_orient_options options = sf_orient_options_default();
    options.direction_count = 150;
    options.coarse_count = 20;
    options.coarse_resolution = 32;
    options.resolution = 64;
    return options;
}

// The best way up, and how the part was given.
static sf_orientation best_of(sf_mesh_view mesh, const sf_orient_options *options,
                              sf_orientation *given)
{
    static sf_orientation found[50];
    size_t count = 0;
    memset(found, 0, sizeof found);
    CHECK_EQ(sf_mesh_orient(mesh, options, NULL, NULL, found, 50, &count, given), SF_OK);
    CHECK_EQ(count, options->fine_count);
    for (size_t i = 1; i < count; i++) {
        CHECK(found[i - 1].score <= found[i].score);
    }
    CHECK(found[0].score <= given->score);
    return found[0];
}

static void points_to(const sf_orientation *o, double x, double y, double z)
{
    CHECK_NEAR(o->up[0], x, 1e-9);
    CHECK_NEAR(o->up[1], y, 1e-9);
    CHECK_NEAR(o->up[2], z, 1e-9);
}

static void a_t_stands_on_its_head(void)
{
    sf_orient_options options = quick();
    sf_orientation given;
    solid_t(&part);
    sf_orientation best = best_of(shape_view(&part), &options, &given);
    points_to(&best, 0, 0, -1);
    CHECK_EQ(best.trimmed_voxels, 0);
    CHECK_NEAR(best.height_mm, 24, 1e-9);
    CHECK(given.trimmed_voxels > given.solid_voxels / 5);
    // Four faces of the plate look down: 20 x 20 less the post.
    CHECK_NEAR(given.unsupported_mm2, 400, 1e-9);
    points_to(&given, 0, 0, 1);
}

static void a_table_stands_on_its_top(void)
{
    sf_orient_options options = quick();
    sf_orientation given;
    solid_table(&part);
    sf_orientation best = best_of(shape_view(&part), &options, &given);
    points_to(&best, 0, 0, -1);
    CHECK_EQ(best.trimmed_voxels, 0);
    CHECK(given.trimmed_voxels > 0);
    CHECK(best.margin_rad > given.margin_rad);
}

static void a_wedge_lies_on_a_face(void)
{
    sf_orient_options options = quick();
    sf_orientation given;
    solid_wedge(&part);
    sf_orientation best = best_of(shape_view(&part), &options, &given);
    CHECK_EQ(best.trimmed_voxels, 0);
    CHECK(best.margin_rad > 0.5);
    CHECK(given.margin_rad < 0.1);
    // It lies on a face: some face's normal is straight down.
    int lies = 0;
    for (size_t i = 0; i < part.triangle_count; i++) {
        const uint32_t *t = part.triangles + 3 * i;
        double z[3];
        for (int c = 0; c < 3; c++) {
            const double *p = part.vertices + 3 * (size_t)t[c], *row = best.turn.matrix + 6;
            z[c] = row[0] * p[0] + row[1] * p[1] + row[2] * p[2] + best.turn.shift_mm[2];
        }
        lies = lies || (fabs(z[0]) < 1e-9 && fabs(z[1]) < 1e-9 && fabs(z[2]) < 1e-9);
    }
    CHECK(lies);
}

static void twins_of_the_data(void)
{
    sf_orient_options options = quick();
    sf_orientation given;
    solid_u(&part);
    sf_orientation best = best_of(shape_view(&part), &options, &given);
    CHECK_EQ(best.trimmed_voxels, 0);
    CHECK(given.trimmed_voxels > 0);
    solid_a(&part);
    best = best_of(shape_view(&part), &options, &given);
    CHECK_EQ(best.trimmed_voxels, 0);
    CHECK(given.trimmed_voxels > 0);
}

static void models_of_the_data(void)
{
    static const char *const names[] = {"parts/U_overhang.obj", "parts/A_upsidedown.obj"};
    if (getenv("SF_DATA") == NULL) {
        SKIP("SF_DATA is not set");
    }
    for (int i = 0; i < 2; i++) {
        sf_orient_options options = quick();
        sf_orientation given;
        sf_mesh *mesh = data_mesh(names[i]);
        if (mesh == NULL) {
            continue;
        }
        sf_orientation best = best_of(sf_mesh_get_view(mesh), &options, &given);
        printf("# %s: up %.3f %.3f %.3f, lost %llu of %llu voxels, as given %llu\n", names[i],
               best.up[0], best.up[1], best.up[2], (unsigned long long)best.trimmed_voxels,
               (unsigned long long)best.solid_voxels, (unsigned long long)given.trimmed_voxels);
        CHECK(best.trimmed_voxels <= best.solid_voxels / 200);
        CHECK(given.trimmed_voxels > given.solid_voxels / 20);
        sf_mesh_destroy(mesh);
    }
}

// Of all directions, looked at as voxels: more pairs must be ranked alike by unsupported area and
// by what a trim takes than the other way round, and the quarter with the least area must hold one
// that loses least.
static void compare_scores(const char *name)
{
    static sf_orientation found[300];
    sf_orient_options options = quick();
    size_t count, agree = 0, differ = 0;
    uint64_t least = UINT64_MAX, least_of_quarter = UINT64_MAX;
    options.direction_count = 100;
    options.coarse_count = options.fine_count = 300;
    options.coarse_resolution = options.resolution = 24;
    CHECK_EQ(sf_mesh_orient(shape_view(&part), &options, NULL, NULL, found, 300, &count, NULL),
             SF_OK);
    CHECK(count > 100 && count < 300);
    for (size_t i = 0; i < count; i++) {
        size_t better = 0;
        for (size_t j = 0; j < count; j++) {
            double a = found[i].unsupported_mm2 - found[j].unsupported_mm2;
            double b = (double)found[i].trimmed_voxels - (double)found[j].trimmed_voxels;
            agree += a * b > 0;
            differ += a * b < 0;
            better += a > 0;
        }
        uint64_t lost = found[i].trimmed_voxels;
        least = lost < least ? lost : least;
        least_of_quarter = 4 * better < count && lost < least_of_quarter ? lost : least_of_quarter;
    }
    printf("# %s: %zu pairs agree, %zu differ\n", name, agree / 2, differ / 2);
    CHECK(agree > differ);
    CHECK_EQ(least, least_of_quarter);
}

// The cheap score is only good for choosing if what it likes is what a trim likes.
static void cheap_score_agrees_with_volume(void)
{
    solid_t(&part);
    compare_scores("T");
    solid_table(&part);
    compare_scores("table");
    solid_a(&part);
    compare_scores("A");
    solid_clear(&part);
    double centre[3] = {0, 0, 0};
    shape_sphere(&part, centre, 10, 12);
    solid_box(&part, -2, -2, 9, 2, 2, 20);
    compare_scores("pin");
}

int main(void)
{
    TEST(a_t_stands_on_its_head);
    TEST(a_table_stands_on_its_top);
    TEST(a_wedge_lies_on_a_face);
    TEST(twins_of_the_data);
    TEST(models_of_the_data);
    TEST(cheap_score_agrees_with_volume);
    return test_finish();
}
