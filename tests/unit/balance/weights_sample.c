// SPDX-License-Identifier: MIT
// Why: vertices are bent by weights between corners, and Newton's method trusts their gradients.
// Values are held against interpolation written out from the values at corners, gradients against
// differences, and points outside against the closest point of all boxes, found by looking at each.

#include "solid.h"

#include "balance/handle/weights_domain.h"
#include "base/memory.h"

#include <sf/weights.h>

enum { COUNT = 3 };

typedef struct site {
    sf_grid *grid;
    sf_weights *weights;
    sf_lattice lattice;
} site;

static const double heights[] = {1, 1.25, 0.75, 1, 1, 1.25, 1, 1};

static void site_begin(site *s)
{
    sf_lattice lattice = {9, 8, 8, 1, 1.125, 1, heights, {30, -4, 5}};
    s->grid = random_solid(&lattice, 0.5);
    s->lattice = sf_grid_lattice(s->grid);
    sf_handle handles[COUNT];
    const uint32_t at[COUNT][3] = {{0, 0, 0}, {8, 7, 7}, {4, 1, 5}};
    for (int j = 0; j < COUNT; j++) {
        sf_handle h = {SF_HANDLE_POINT, {0, 0, 0}, 0, NULL, 0};
        h.at_mm[0] = 30 + at[j][0] + 0.5;
        h.at_mm[1] = -4 + 1.125 * (at[j][1] + 0.5);
        h.at_mm[2] = sf_lattice_layer_bottom(&s->lattice, at[j][2]) + 0.25;
        handles[j] = h;
        CHECK_EQ(sf_slice_set(sf_grid_slice(s->grid, at[j][2]), at[j][0], at[j][1], 1), SF_OK);
    }
    CHECK_EQ(sf_weights_create(s->grid, handles, COUNT, NULL, NULL, NULL, &s->weights, NULL),
             SF_OK);
    CHECK(memcmp(sf_weights_centers(s->weights), handles[0].at_mm, 3 * sizeof(double)) == 0);
}

static void site_end(site *s)
{
    sf_weights_destroy(s->weights);
    sf_grid_destroy(s->grid);
}

static void box_of(const sf_lattice *l, uint32_t v, double low[3], double high[3])
{
    uint32_t x = v % l->nx, y = v / l->nx % l->ny, z = v / l->nx / l->ny;
    low[0] = l->origin_mm[0] + x * l->pitch_x_mm;
    low[1] = l->origin_mm[1] + y * l->pitch_y_mm;
    low[2] = sf_lattice_layer_bottom(l, z);
    high[0] = l->origin_mm[0] + (x + 1) * l->pitch_x_mm;
    high[1] = l->origin_mm[1] + (y + 1) * l->pitch_y_mm;
    high[2] = sf_lattice_layer_bottom(l, z + 1);
}

// The closest point of all solid boxes, and the last of the boxes that hold it.
static double closest(const site *s, const double p[3], double at[3], uint32_t *box)
{
    const sf_lattice *l = &s->lattice;
    double least = INFINITY;
    for (uint32_t v = 0; v < l->nx * l->ny * l->nz; v++) {
        double low[3], high[3], q[3], square = 0;
        if (!sf_slice_get(sf_grid_slice(s->grid, v / l->nx / l->ny), v % l->nx,
                          v / l->nx % l->ny)) {
            continue;
        }
        box_of(l, v, low, high);
        for (int d = 0; d < 3; d++) {
            q[d] = p[d] < low[d] ? low[d] : p[d] > high[d] ? high[d] : p[d];
            square += (p[d] - q[d]) * (p[d] - q[d]);
        }
        if (square <= least) {
            least = square;
            *box = v;
            memcpy(at, q, sizeof q);
        }
    }
    return sqrt(least);
}

// Interpolation from the eight corners of a box, whose values the library gives.
static void interpolate(const site *s, uint32_t box, const double at[3], double w[COUNT])
{
    double low[3], high[3];
    box_of(&s->lattice, box, low, high);
    memset(w, 0, COUNT * sizeof *w);
    for (int c = 0; c < 8; c++) {
        double corner[3], value[COUNT], share = 1;
        for (int d = 0; d < 3; d++) {
            double t = (at[d] - low[d]) / (high[d] - low[d]);
            corner[d] = c >> d & 1 ? high[d] : low[d];
            share *= c >> d & 1 ? t : 1 - t;
        }
        CHECK_EQ(sf_weights_at(s->weights, corner, value, NULL), SF_OK);
        for (int j = 0; j < COUNT; j++) {
            w[j] += share * value[j];
        }
    }
}

static void points_have_the_weights_of_the_closest(void)
{
    site s;
    site_begin(&s);
    for (int i = 0; i < 20000; i++) {
        double p[3], at[3] = {0}, w[COUNT], expected[COUNT];
        uint32_t box = 0;
        for (int d = 0; d < 3; d++) {
            p[d] = s.lattice.origin_mm[d] + 11 * test_random_unit() - 1;
        }
        // Now and then on a plane of the lattice.
        p[0] = i % 5 == 0 ? floor(p[0]) : p[0];
        closest(&s, p, at, &box);
        CHECK_EQ(sf_weights_at(s.weights, p, w, NULL), SF_OK);
        interpolate(&s, box, at, expected);
        for (int j = 0; j < COUNT; j++) {
            CHECK_NEAR(w[j], expected[j], 1e-12);
        }
    }
    site_end(&s);
}

static void gradients_are_differences(void)
{
    site s;
    site_begin(&s);
    for (int i = 0; i < 5000; i++) {
        double p[3], w[COUNT], up[COUNT], down[COUNT], gradient[3 * COUNT];
        for (int d = 0; d < 3; d++) {
            p[d] = s.lattice.origin_mm[d] + 11 * test_random_unit() - 1;
        }
        CHECK_EQ(sf_weights_at(s.weights, p, w, gradient), SF_OK);
        for (int d = 0; d < 3; d++) {
            double q[3] = {p[0], p[1], p[2]};
            q[d] = p[d] + 1e-6;
            CHECK_EQ(sf_weights_at(s.weights, q, up, NULL), SF_OK);
            q[d] = p[d] - 1e-6;
            CHECK_EQ(sf_weights_at(s.weights, q, down, NULL), SF_OK);
            for (int j = 0; j < COUNT; j++) {
                double forth = (up[j] - w[j]) / 1e-6, back = (w[j] - down[j]) / 1e-6;
                // Where a plane lies between, the gradient jumps.
                CHECK(fabs(gradient[3 * j + d] - forth) < 1e-6 ||
                      fabs(gradient[3 * j + d] - back) < 1e-6);
            }
        }
    }
    site_end(&s);
}

static void many_points_are_one_and_one(void)
{
    site s;
    site_begin(&s);
    enum { POINTS = 9000 };
    double *xyz = malloc(3 * POINTS * sizeof *xyz), *w = malloc(COUNT * POINTS * sizeof *w);
    for (int n = 0; n < 3 * POINTS; n++) {
        xyz[n] = s.lattice.origin_mm[n % 3] + 10 * test_random_unit();
    }
    CHECK_EQ(sf_weights_sample(s.weights, xyz, POINTS, NULL, w), SF_OK);
    for (size_t i = 0; i < POINTS; i++) {
        double one[COUNT];
        CHECK_EQ(sf_weights_at(s.weights, xyz + 3 * i, one, NULL), SF_OK);
        CHECK(memcmp(one, w + COUNT * i, sizeof one) == 0);
    }
    CHECK_EQ(sf_weights_sample(s.weights, NULL, 0, NULL, NULL), SF_OK);
    free(xyz);
    free(w);
    site_end(&s);
}

// In a box of which a corner is solid: near, the table's cell is the closest; far, it is about so,
// and costs no search.
static void far_points_find_a_close_cell(void)
{
    sf_lattice lattice = {60, 50, 40, 1, 1, 1, NULL, {0, 0, 0}};
    sf_grid *grid = random_solid(&lattice, 0);
    sf_allocator allocator = sfi_allocator_or_default(NULL);
    sfi_domain domain;
    for (int i = 0; i < 40; i++) {
        uint32_t x = test_random_below(60), y = test_random_below(50), z = test_random_below(40);
        CHECK_EQ(sf_slice_set(sf_grid_slice(grid, z), x, y, 1), SF_OK);
    }
    CHECK_EQ(sfi_domain_create(grid, 0, 1000, &allocator, &domain), SF_OK);
    CHECK_EQ(sfi_domain_reach(&domain), SF_OK);
    for (int i = 0; i < 20000; i++) {
        double p[3];
        for (int d = 0; d < 3; d++) {
            p[d] = 80 * test_random_unit() - 10;
        }
        sfi_spot near = sfi_domain_find(&domain, p);
        sfi_spot best = sfi_domain_search(&domain, p, NULL, INFINITY);
        CHECK(near.square >= best.square);
        CHECK(sqrt(near.square) <= 1.8 * sqrt(best.square) + 2);
        CHECK(best.square > 1 || near.square == best.square);
    }
    sfi_domain_destroy(&domain);
    sf_grid_destroy(grid);
}

static void nonsense_is_refused(void)
{
    site s;
    site_begin(&s);
    double p[6] = {31, -3, 6, 31, -3, NAN}, w[2 * COUNT] = {7, 7, 7, 7, 7, 7};
    sf_task task = sf_task_default();
    sf_task_cancel(&task);
    CHECK_EQ(sf_weights_at(NULL, p, w, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_weights_at(s.weights, NULL, w, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_weights_at(s.weights, p, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_weights_at(s.weights, p + 3, w, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_weights_sample(s.weights, p, 2, NULL, w), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_weights_sample(s.weights, NULL, 2, NULL, w), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_weights_sample(s.weights, p, 1, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_weights_sample(NULL, p, 1, NULL, w), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_weights_sample(s.weights, p, 1, &task, w), SF_ERR_CANCELLED);
    CHECK(w[0] == 7 && w[5] == 7);
    CHECK(sf_weights_centers(NULL) == NULL && sf_weights_describe(NULL).cell_count == 0);
    p[0] = 1e300;
    CHECK_EQ(sf_weights_at(s.weights, p, w, NULL), SF_OK);
    site_end(&s);
}

int main(void)
{
    TEST(points_have_the_weights_of_the_closest);
    TEST(gradients_are_differences);
    TEST(many_points_are_one_and_one);
    TEST(far_points_find_a_close_cell);
    TEST(nonsense_is_refused);
    return test_finish();
}
