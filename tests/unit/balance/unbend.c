// SPDX-License-Identifier: MIT
// Why: what is carved in a bent shape is a place in the shape as it was. Points of a solid are bent
// and must come back to where they were, from poor guesses too; what is found must be bent to
// where it was asked for; and folds must show where a determinant of differences is negative.
// Promise: the same bytes for any number of threads, nothing changed in calls that fail.

#include "backwards.h"
#include "failing_allocator.h"
#include "solid.h"

#include <sf/blend.h>

enum { COUNT = 5, POINTS = 5000 };

typedef struct site {
    sf_grid *grid;
    sf_weights *weights;
    sf_pose poses[COUNT];
} site;

static double spread(void)
{
    return 2 * test_random_unit() - 1;
}

// A figure with handles in its hands, head and trunk, and its feet held; moved by so much.
static void site_begin(site *s, double much)
{
    sf_lattice lattice = {32, 12, 32, 1, 1, 1, NULL, {-16, -6, 0}};
    s->grid = random_solid(&lattice, 0);
    for (uint32_t n = 0; n < 32 * 12 * 32; n++) {
        double x = n % 32 - 15.5, y = n / 32 % 12 - 5.5, z = n / 384 + 0.5;
        int trunk = x * x + y * y < 16 && z > 10 && z < 22;
        int arm = y * y + (z - 19) * (z - 19) < 4 && fabs(x) < 15;
        int leg = (fabs(x) - 3) * (fabs(x) - 3) + y * y < 5 && z <= 10;
        int head = x * x + y * y + (z - 26) * (z - 26) < 25;
        CHECK_EQ(sf_slice_set(sf_grid_slice(s->grid, n / 384), n % 32, n / 32 % 12,
                              trunk || arm || leg || head),
                 SF_OK);
    }
    sf_handle handles[COUNT];
    sf_grid *feet = NULL;
    const double up[3] = {0, 0, 1};
    const double at[4][3] = {{-13.5, 0, 19}, {13.5, 0, 19}, {0, 0, 26}, {0, 0, 15}};
    CHECK_EQ(sf_grid_foot(s->grid, up, 1, NULL, &feet), SF_OK);
    CHECK_EQ(sf_handle_base(feet, &handles[0]), SF_OK);
    for (int j = 1; j < COUNT; j++) {
        sf_handle h = {SF_HANDLE_POINT, {at[j - 1][0], at[j - 1][1], at[j - 1][2]}, 0, NULL, 0};
        handles[j] = h;
    }
    CHECK_EQ(sf_weights_create(s->grid, handles, COUNT, NULL, NULL, NULL, &s->weights, NULL),
             SF_OK);
    for (int j = 0; j < COUNT; j++) {
        sf_pose_change change = {
            0.2 * much * spread(),
            {2 * much * spread(), 2 * much * spread(), 2 * much * spread()},
            {0.4 * much * spread(), 0.4 * much * spread(), 0.4 * much * spread()}};
        s->poses[j] = sf_pose_identity();
        if (j > 0) {
            CHECK_EQ(sf_pose_move(&s->poses[j], &change), SF_OK);
        }
    }
    sf_grid_destroy(feet);
}

static void site_end(site *s)
{
    sf_weights_destroy(s->weights);
    sf_grid_destroy(s->grid);
}

static int is_solid(const site *s, const double p[3])
{
    double x = floor(p[0] + 16), y = floor(p[1] + 6), z = floor(p[2]);
    return x >= 0 && y >= 0 && z >= 0 && x < 32 && y < 12 && z < 32 &&
           sf_slice_get(sf_grid_slice(s->grid, (uint32_t)z), (uint32_t)x, (uint32_t)y);
}

// Points in solid voxels.
static void fill_points(const site *s, double *p)
{
    for (int i = 0; i < POINTS;) {
        p[3 * i] = 32 * test_random_unit() - 16;
        p[3 * i + 1] = 12 * test_random_unit() - 6;
        p[3 * i + 2] = 32 * test_random_unit();
        if (is_solid(s, p + 3 * i)) {
            i++;
        }
    }
}

static void bend(const site *s, const double *p, size_t count, double *out)
{
    double *w = malloc(COUNT * count * sizeof *w);
    CHECK_EQ(sf_weights_sample(s->weights, p, count, NULL, w), SF_OK);
    sf_blend blend = {p, w, count, sf_weights_centers(s->weights), COUNT};
    CHECK_EQ(sf_blend_apply(blend, s->poses, NULL, out), SF_OK);
    free(w);
}

static double distance(const double *a, const double *b)
{
    double sum = 0;
    for (int d = 0; d < 3; d++) {
        sum += (a[d] - b[d]) * (a[d] - b[d]);
    }
    return sqrt(sum);
}

static void bent_points_come_back(void)
{
    double *p = malloc(9 * POINTS * sizeof *p), *bent = p + 3 * POINTS, *rest = bent + 3 * POINTS;
    for (int round = 0; round < 4; round++) {
        site s;
        size_t missed = 7;
        sf_fold fold;
        site_begin(&s, 0.8);
        fill_points(&s, p);
        bend(&s, p, POINTS, bent);
        CHECK_EQ(sf_weights_fold(s.weights, s.poses, NULL, &fold), SF_OK);
        printf("# least determinant %.2f\n", fold.least_det);
        for (int guess = 0; guess < 3; guess++) {
            for (int n = 0; n < 3 * POINTS; n++) {
                rest[n] = guess == 0 ? bent[n] : guess == 1 ? p[n] + spread() : 0;
            }
            CHECK_EQ(sf_weights_unbend(s.weights, s.poses, bent, POINTS, 1e-9, NULL, NULL, rest,
                                       NULL, &missed),
                     SF_OK);
            CHECK_EQ(missed, 0);
            // Where two limbs run through each other there are two answers.
            size_t others = 0;
            for (size_t i = 0; i < POINTS; i++) {
                int same = distance(rest + 3 * i, p + 3 * i) < 1e-6;
                others += !same;
                CHECK(same || is_solid(&s, rest + 3 * i));
            }
            CHECK(others < POINTS / 50);
        }
        CHECK(round > 0 || fold.folded == 0);
        site_end(&s);
    }
    free(p);
}

// Volume of a hexahedron, in five tetrahedra.
static double volume_of(double corner[8][3])
{
    const int t[5][4] = {{0, 1, 2, 4}, {3, 2, 1, 7}, {5, 1, 4, 7}, {6, 4, 2, 7}, {1, 2, 4, 7}};
    double volume = 0;
    for (int k = 0; k < 5; k++) {
        double m[3][3], det;
        for (int e = 0; e < 3; e++) {
            for (int d = 0; d < 3; d++) {
                m[e][d] = corner[t[k][e + 1]][d] - corner[t[k][0]][d];
            }
        }
        det = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
              m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
              m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
        volume += fabs(det) / 6;
    }
    return volume;
}

static double bent_volume(const site *s)
{
    double volume = 0;
    for (int v = 0; v < 32 * 12 * 32; v++) {
        double corner[8][3], out[8][3];
        int x = v % 32, y = v / 32 % 12, z = v / 384;
        if (!sf_slice_get(sf_grid_slice(s->grid, (uint32_t)z), (uint32_t)x, (uint32_t)y)) {
            continue;
        }
        for (int c = 0; c < 8; c++) {
            corner[c][0] = x + (c & 1) - 16.0;
            corner[c][1] = y + (c >> 1 & 1) - 6.0;
            corner[c][2] = z + (c >> 2);
        }
        bend(s, corner[0], 8, out[0]);
        volume += volume_of(out);
    }
    return volume;
}

// Rows of a grid around the bent figure: most of its points lie outside.
static void what_is_found_is_bent_to_its_place(void)
{
    site s;
    enum { SIDE = 30, ALL = SIDE * SIDE * SIDE };
    double *bent = malloc(10 * ALL * sizeof *bent), *rest = bent + 3 * ALL, *back = rest + 3 * ALL,
           *residual = back + 3 * ALL;
    size_t missed = 0, found = 0, inside = 0;
    site_begin(&s, 0.7);
    for (int n = 0; n < ALL; n++) {
        bent[3 * n] = 44.0 * (n % SIDE) / SIDE - 22;
        bent[3 * n + 1] = 24.0 * (n / SIDE % SIDE) / SIDE - 12;
        bent[3 * n + 2] = 44.0 * (n / SIDE / SIDE) / SIDE - 4;
    }
    memcpy(rest, bent, 3 * ALL * sizeof *rest);
    CHECK_EQ(
        sf_weights_unbend(s.weights, s.poses, bent, ALL, 1e-7, NULL, NULL, rest, residual, &missed),
        SF_OK);
    bend(&s, rest, ALL, back);
    for (size_t i = 0; i < ALL; i++) {
        CHECK_NEAR(distance(back + 3 * i, bent + 3 * i), residual[i], 1e-12);
        found += residual[i] <= 1e-7;
        inside += residual[i] <= 1e-7 && is_solid(&s, rest + 3 * i);
    }
    CHECK_EQ(found + missed, ALL);
    // As many inside as the bent solid holds: its volume over that of a cell of the rows.
    double expected = bent_volume(&s) / (44.0 * 24 * 44 / ALL);
    printf("# %zu inside, %.0f by volume, %zu missed\n", inside, expected, missed);
    CHECK_NEAR((double)inside, expected, 0.06 * expected);
    free(bent);
    site_end(&s);
}

static void folds_are_found(void)
{
    site s;
    sf_fold fold;
    site_begin(&s, 0);
    CHECK_EQ(sf_weights_fold(s.weights, s.poses, NULL, &fold), SF_OK);
    CHECK_NEAR(fold.least_det, 1, 1e-12);
    CHECK(fold.folded == 0 && fold.places == 8 * sf_grid_popcount(s.grid));
    // All scaled alike: the factor of volume is the cube, everywhere.
    for (int j = 0; j < COUNT; j++) {
        s.poses[j].scale = 0.5;
    }
    // ... about one centre.
    const double *c = sf_weights_centers(s.weights);
    for (int j = 0; j < COUNT; j++) {
        for (int d = 0; d < 3; d++) {
            s.poses[j].shift_mm[d] = -0.5 * c[3 * j + d];
        }
    }
    CHECK_EQ(sf_weights_fold(s.weights, s.poses, NULL, &fold), SF_OK);
    CHECK_NEAR(fold.least_det, 0.125, 1e-12);
    site_end(&s);
    // A head pushed down through the trunk: differences tell the same determinant.
    site_begin(&s, 0.3);
    s.poses[3].shift_mm[2] = -20;
    CHECK_EQ(sf_weights_fold(s.weights, s.poses, NULL, &fold), SF_OK);
    CHECK(fold.folded > 0 && fold.least_det < 0);
    double worst = INFINITY;
    for (int side = 0; side < 8; side++) {
        double p[4][3], out[4][3], m[9], q[3];
        for (int d = 0; d < 3; d++) {
            q[d] = fold.at_mm[d] + (side >> d & 1 ? 0.5 : -0.5);
        }
        if (!is_solid(&s, q)) {
            continue;
        }
        for (int k = 0; k < 4; k++) {
            for (int d = 0; d < 3; d++) {
                double away = side >> d & 1 ? 1e-6 : -1e-6;
                p[k][d] = fold.at_mm[d] + 1e-9 * (side >> d & 1 ? 1 : -1) + (k == d + 1 ? away : 0);
            }
        }
        bend(&s, p[0], 4, out[0]);
        for (int n = 0; n < 9; n++) {
            m[n] = (out[n / 3 + 1][n % 3] - out[0][n % 3]) / (side >> (n / 3) & 1 ? 1e-6 : -1e-6);
        }
        double det = m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) +
                     m[2] * (m[3] * m[7] - m[4] * m[6]);
        worst = det < worst ? det : worst;
    }
    CHECK_NEAR(worst, fold.least_det, 1e-3 * fabs(fold.least_det));
    site_end(&s);
}

static void folds_refuse_nonsense(void)
{
    site s;
    sf_fold fold = {7, {7, 7, 7}, 7, 7}, again;
    site_begin(&s, 0.3);
    sf_task task = sf_task_default();
    sf_task_cancel(&task);
    again = fold;
    CHECK_EQ(sf_weights_fold(s.weights, s.poses, &task, &again), SF_ERR_CANCELLED);
    CHECK_EQ(sf_weights_fold(NULL, s.poses, NULL, &again), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_weights_fold(s.weights, NULL, NULL, &again), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_weights_fold(s.weights, s.poses, NULL, NULL), SF_ERR_ARGUMENT);
    s.poses[1].scale = NAN;
    CHECK_EQ(sf_weights_fold(s.weights, s.poses, NULL, &again), SF_ERR_ARGUMENT);
    CHECK(memcmp(&fold, &again, sizeof fold) == 0);
    site_end(&s);
}

static void the_same_bytes(void)
{
    site s;
    double *p = malloc(12 * POINTS * sizeof *p), *bent = p + 3 * POINTS, *a = bent + 3 * POINTS,
           *b = a + 3 * POINTS;
    sf_task task = sf_task_default();
    task.parallel_for = backwards;
    site_begin(&s, 1.5);
    fill_points(&s, p);
    bend(&s, p, POINTS, bent);
    memcpy(a, bent, 3 * POINTS * sizeof *a);
    memcpy(b, bent, 3 * POINTS * sizeof *b);
    CHECK_EQ(sf_weights_unbend(s.weights, s.poses, bent, POINTS, 1e-9, NULL, NULL, a, NULL, NULL),
             SF_OK);
    CHECK_EQ(sf_weights_unbend(s.weights, s.poses, bent, POINTS, 1e-9, NULL, &task, b, NULL, NULL),
             SF_OK);
    CHECK(memcmp(a, b, 3 * POINTS * sizeof *a) == 0);
    sf_fold one, two;
    CHECK_EQ(sf_weights_fold(s.weights, s.poses, NULL, &one), SF_OK);
    CHECK_EQ(sf_weights_fold(s.weights, s.poses, &task, &two), SF_OK);
    CHECK(memcmp(&one, &two, sizeof one) == 0);
    free(p);
    site_end(&s);
}

static void nonsense_and_memory(void)
{
    site s;
    double bent[6] = {0, 0, 15, 0, 0, 16}, rest[6] = {7, 7, 7, 7, 7, 7}, before[6], residual[2];
    size_t missed = 7;
    site_begin(&s, 0.5);
    sf_weights *w = s.weights;
    sf_pose *q = s.poses;
    memcpy(before, rest, sizeof rest);
    CHECK_EQ(sf_weights_unbend(NULL, q, bent, 2, 1, NULL, NULL, rest, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_weights_unbend(w, NULL, bent, 2, 1, NULL, NULL, rest, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_weights_unbend(w, q, NULL, 2, 1, NULL, NULL, rest, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_weights_unbend(w, q, bent, 2, 1, NULL, NULL, NULL, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_weights_unbend(w, q, bent, 2, 0, NULL, NULL, rest, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_weights_unbend(w, q, bent, 2, NAN, NULL, NULL, rest, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_weights_unbend(w, q, NULL, 0, 1, NULL, NULL, NULL, NULL, &missed), SF_OK);
    CHECK_EQ(missed, 0);
    bent[3] = INFINITY;
    CHECK_EQ(sf_weights_unbend(w, q, bent, 2, 1, NULL, NULL, rest, NULL, NULL), SF_ERR_ARGUMENT);
    bent[3] = 0;
    rest[4] = before[4] = NAN;
    CHECK_EQ(sf_weights_unbend(w, q, bent, 2, 1, NULL, NULL, rest, NULL, NULL), SF_ERR_ARGUMENT);
    rest[4] = before[4] = 7;
    sf_task task = sf_task_default();
    sf_task_cancel(&task);
    CHECK_EQ(sf_weights_unbend(w, q, bent, 2, 1, NULL, &task, rest, NULL, NULL), SF_ERR_CANCELLED);
    sf_status status = SF_ERR_MEMORY;
    failing_allocator failing;
    for (long k = 0; status == SF_ERR_MEMORY && k < 100; k++) {
        CHECK(memcmp(rest, before, sizeof rest) == 0);
        failing_begin(&failing, k);
        status = sf_weights_unbend(w, q, bent, 2, 1e-9, &failing.allocator, NULL, rest,
                                   k % 2 ? NULL : residual, &missed);
        CHECK(failing.live == 0 && failing.faults == 0);
    }
    CHECK_EQ(status, SF_OK);
    CHECK_EQ(missed, 0);
    // A handle that is scaled to nothing has no inverse; that is no error, but missed.
    for (int j = 0; j < COUNT; j++) {
        q[j].scale = 0;
    }
    CHECK_EQ(sf_weights_unbend(w, q, bent, 2, 1e-9, NULL, NULL, rest, residual, &missed), SF_OK);
    CHECK(missed > 0 && residual[0] > 0);
    site_end(&s);
}

int main(void)
{
    TEST(bent_points_come_back);
    TEST(what_is_found_is_bent_to_its_place);
    TEST(folds_are_found);
    TEST(folds_refuse_nonsense);
    TEST(the_same_bytes);
    TEST(nonsense_and_memory);
    return test_finish();
}
