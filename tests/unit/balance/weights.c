// SPDX-License-Identifier: MIT
// Why: a bend is as good as its weights. CLAMPED weights are held against dense matrices written
// from the definition and solved by elimination; BOUNDED ones against the conditions that tell the
// least of a convex function within bounds, and against a relaxation from number to number.

#include "solid.h"

#include <sf/weights.h>

enum { HANDLES_MAX = 4 };

typedef struct site {
    solid solid;
    sf_grid *grid, *region;
    sf_handle handles[HANDLES_MAX];
    size_t count;
    uint8_t *owner; // of each node: a handle, or 255
} site;

static const double heights[] = {1, 1.125, 0.75, 1, 1, 1.25, 1};

// Whether all nodes hang together.
static int is_one_piece(const solid *s)
{
    uint8_t *seen = calloc(s->count, 1);
    size_t *queue = malloc(s->count * sizeof *queue), length = 1;
    queue[0] = 0;
    seen[0] = 1;
    for (size_t at = 0; at < length; at++) {
        for (size_t j = 0; j < s->count; j++) {
            if (!seen[j] && s->laplacian[queue[at] * s->count + j] != 0) {
                seen[j] = 1;
                queue[length++] = j;
            }
        }
    }
    free(seen);
    free(queue);
    return length == s->count;
}

// The middle of a voxel, made solid; its corners are held.
static void put_handle(site *s, size_t j, sf_handle_kind kind, double radius, uint32_t x,
                       uint32_t y, uint32_t z)
{
    sf_lattice l = sf_grid_lattice(s->grid);
    sf_handle h = {kind, {0, 0, 0}, radius, NULL, 0};
    h.at_mm[0] = l.origin_mm[0] + (x + 0.3) * l.pitch_x_mm;
    h.at_mm[1] = l.origin_mm[1] + (y + 0.6) * l.pitch_y_mm;
    h.at_mm[2] = sf_lattice_layer_bottom(&l, z) + 0.45 * sf_lattice_layer_height(&l, z);
    s->handles[j] = h;
    CHECK_EQ(sf_slice_set(sf_grid_slice(s->grid, z), x, y, 1), SF_OK);
}

static void own_voxel(site *s, size_t j, uint32_t x, uint32_t y, uint32_t z)
{
    for (int c = 0; c < 8; c++) {
        s->owner[s->solid.node_of[solid_corner(&s->solid.lattice, x, y, z, c)]] = (uint8_t)j;
    }
}

// A lump of one piece, with two points, a ball and a base of three voxels in a row.
static void site_begin(site *s, uint32_t nx, uint32_t ny, uint32_t nz, size_t count)
{
    sf_lattice lattice = {nx, ny, nz, 1, 1.125, 1, heights, {3, -40, 5}};
    // With two handles the second one sits halfway: beyond it bounds are met.
    const uint32_t far[3] = {count > 2 ? nx - 1 : nx / 2, count > 2 ? ny - 1 : ny / 2,
                             count > 2 ? nz - 1 : nz / 2};
    for (;;) {
        s->grid = random_solid(&lattice, 0.75);
        s->count = count;
        CHECK_EQ(sf_grid_create(&lattice, NULL, &s->region), SF_OK);
        put_handle(s, 0, SF_HANDLE_POINT, 0, 0, 0, 0);
        put_handle(s, 1, SF_HANDLE_POINT, 0, far[0], far[1], far[2]);
        put_handle(s, 2, SF_HANDLE_BALL, 1.2, nx - 1, 1, 1);
        for (uint32_t x = 0; x < 3; x++) {
            CHECK_EQ(sf_slice_set(sf_grid_slice(s->grid, nz - 1), x, 0, 1), SF_OK);
            CHECK_EQ(sf_slice_set(sf_grid_slice(s->region, nz - 1), x, 0, 1), SF_OK);
        }
        CHECK_EQ(sf_handle_base(s->region, &s->handles[3]), SF_OK);
        solid_begin(&s->solid, s->grid);
        if (is_one_piece(&s->solid)) {
            break;
        }
        solid_end(&s->solid);
        sf_grid_destroy(s->grid);
        sf_grid_destroy(s->region);
    }
    s->owner = malloc(s->solid.count);
    memset(s->owner, 255, s->solid.count);
    own_voxel(s, 0, 0, 0, 0);
    own_voxel(s, 1, far[0], far[1], far[2]);
    if (count > 2) {
        own_voxel(s, 2, nx - 1, 1, 1);
        for (size_t i = 0; i < s->solid.count; i++) {
            double square = 0;
            for (size_t d = 0; d < 3; d++) {
                double by = s->solid.at[3 * i + d] - s->handles[2].at_mm[d];
                square += by * by;
            }
            s->owner[i] = square <= 1.2 * 1.2 ? 2 : s->owner[i];
        }
    }
    for (uint32_t x = 0; count > 3 && x < 3; x++) {
        own_voxel(s, 3, x, 0, nz - 1);
    }
}

static void site_end(site *s)
{
    solid_end(&s->solid);
    sf_grid_destroy(s->grid);
    sf_grid_destroy(s->region);
    free(s->owner);
}

// All weights at the nodes, from the library.
static double *find_weights(const site *s, sf_weights_method method)
{
    sf_weights *weights = NULL;
    sf_weights_options options = sf_weights_options_default();
    sf_fault fault;
    double *w = malloc(s->solid.count * s->count * sizeof *w);
    options.method = method;
    options.tolerance = 1e-9;
    sf_status status =
        sf_weights_create(s->grid, s->handles, s->count, &options, NULL, NULL, &weights, &fault);
    if (status != SF_OK) {
        printf("# %s\n", fault.message);
    }
    CHECK_EQ(status, SF_OK);
    sf_weights_facts facts = sf_weights_describe(weights);
    CHECK_EQ(facts.node_count, s->solid.count);
    CHECK_EQ(facts.cell_count, sf_grid_popcount(s->grid));
    CHECK(facts.loose_count == 0 && facts.residual <= 1e-9 && facts.iterations > 0);
    CHECK_EQ(sf_weights_sample(weights, s->solid.at, s->solid.count, NULL, w), SF_OK);
    sf_weights_destroy(weights);
    return w;
}

static void check_laws(const site *s, const double *w)
{
    for (size_t i = 0; i < s->solid.count; i++) {
        double sum = 0;
        for (size_t j = 0; j < s->count; j++) {
            double x = w[i * s->count + j];
            CHECK(x >= 0 && x <= 1);
            CHECK(s->owner[i] == 255 || x == (s->owner[i] == j));
            sum += x;
        }
        CHECK_NEAR(sum, 1, 1e-14);
    }
}

// Dense, for each handle: column j of `w`.
static void solve_dense(const site *s, double *w)
{
    size_t n = s->solid.count;
    uint8_t *held = malloc(n);
    double *column = malloc(n * sizeof *column);
    for (size_t j = 0; j < s->count; j++) {
        for (size_t i = 0; i < n; i++) {
            held[i] = s->owner[i] != 255;
            column[i] = s->owner[i] == j;
        }
        solid_solve(&s->solid, held, column);
        for (size_t i = 0; i < n; i++) {
            w[i * s->count + j] = column[i];
        }
    }
    free(held);
    free(column);
}

static void clamp_and_divide(const site *s, double *w)
{
    for (size_t i = 0; i < s->solid.count; i++) {
        double sum = 0;
        for (size_t j = 0; j < s->count; j++) {
            double *x = &w[i * s->count + j];
            *x = *x < 0 ? 0 : *x > 1 ? 1 : *x;
            sum += *x;
        }
        for (size_t j = 0; j < s->count; j++) {
            w[i * s->count + j] /= sum;
        }
    }
}

static void clamped_weights_are_those_of_dense_matrices(void)
{
    for (int round = 0; round < 3; round++) {
        site s;
        site_begin(&s, 7, 6, 6, 4);
        double *w = find_weights(&s, SF_WEIGHTS_CLAMPED), worst = 0, lowest = 0;
        double *dense = malloc(s.solid.count * s.count * sizeof *dense);
        check_laws(&s, w);
        solve_dense(&s, dense);
        for (size_t n = 0; n < s.solid.count * s.count; n++) {
            lowest = dense[n] < lowest ? dense[n] : lowest;
        }
        clamp_and_divide(&s, dense);
        for (size_t n = 0; n < s.solid.count * s.count; n++) {
            worst = fabs(w[n] - dense[n]) > worst ? fabs(w[n] - dense[n]) : worst;
        }
        printf("# %zu corners, unbounded down to %.3f: off by %.1e at most\n", s.solid.count,
               lowest, worst);
        CHECK(worst < 1e-6);
        free(dense);
        free(w);
        site_end(&s);
    }
}

// Weights of two handles within bounds add up to 1 by themselves (1 - w solves the other's
// problem), so that the quotient is the solution itself.
static void bounded_weights_meet_the_conditions(void)
{
    for (int round = 0; round < 3; round++) {
        site s;
        site_begin(&s, 7, 6, 7, 2);
        double *w = find_weights(&s, SF_WEIGHTS_BOUNDED), worst = 0;
        size_t at_bound = 0;
        check_laws(&s, w);
        for (size_t i = 0; i < s.solid.count; i++) {
            double gradient = 0, x = w[2 * i], own = s.solid.energy[i * s.solid.count + i];
            for (size_t j = 0; j < s.solid.count; j++) {
                gradient += s.solid.energy[i * s.solid.count + j] * w[2 * j];
            }
            double to = x - gradient / own, off = x - (to < 0 ? 0 : to > 1 ? 1 : to);
            if (s.owner[i] == 255) {
                worst = fabs(off) > worst ? fabs(off) : worst;
                at_bound += x < 1e-8 || x > 1 - 1e-8;
            }
        }
        printf("# %zu corners, %zu at a bound: off by %.1e at most\n", s.solid.count, at_bound,
               worst);
        CHECK(worst < 1e-6 && at_bound > 0);
        free(w);
        site_end(&s);
    }
}

// Go through the numbers, each to its least within bounds, until nothing changes.
static void relax(const site *s, double *w)
{
    size_t n = s->solid.count;
    for (size_t j = 0; j < s->count; j++) {
        double change = 1;
        for (int round = 0; round < 200000 && change > 1e-11; round++) {
            change = 0;
            for (size_t i = 0; i < n; i++) {
                const double *row = s->solid.energy + i * n;
                double gradient = 0, *x = &w[i * s->count + j], before = *x;
                if (s->owner[i] != 255) {
                    continue;
                }
                for (size_t k = 0; k < n; k++) {
                    gradient += row[k] * w[k * s->count + j];
                }
                *x -= 1.6 * gradient / row[i];
                *x = *x < 0 ? 0 : *x > 1 ? 1 : *x;
                change = fabs(*x - before) > change ? fabs(*x - before) : change;
            }
        }
        CHECK(change <= 1e-11);
    }
}

static void bounded_weights_are_those_of_relaxation(void)
{
    for (int round = 0; round < 3; round++) {
        site s;
        site_begin(&s, 5, 5, 5, 4);
        double *w = find_weights(&s, SF_WEIGHTS_BOUNDED), worst = 0;
        double *slow = malloc(s.solid.count * s.count * sizeof *slow);
        check_laws(&s, w);
        solve_dense(&s, slow);
        clamp_and_divide(&s, slow);
        relax(&s, slow);
        clamp_and_divide(&s, slow);
        for (size_t n = 0; n < s.solid.count * s.count; n++) {
            worst = fabs(w[n] - slow[n]) > worst ? fabs(w[n] - slow[n]) : worst;
        }
        printf("# %zu corners: off by %.1e at most\n", s.solid.count, worst);
        CHECK(worst < 1e-6);
        free(slow);
        free(w);
        site_end(&s);
    }
}

int main(void)
{
    TEST(clamped_weights_are_those_of_dense_matrices);
    TEST(bounded_weights_meet_the_conditions);
    TEST(bounded_weights_are_those_of_relaxation);
    return test_finish();
}
