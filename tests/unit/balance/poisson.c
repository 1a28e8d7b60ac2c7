// SPDX-License-Identifier: MIT
// Why: weights are as good as the Laplacian below them, and are found as fast as cycles invert it.
// The Laplacian and the volumes are held against a sum over the boxes of voxels, written from the
// definition; a cycle must be a symmetric positive matrix that leaves little of an error, whatever
// the shape and whatever is held; and what is fixed stays 0.

#include "balance/handle/poisson.h"
#include "base/memory.h"
#include "law/stack.h"
#include "solid.h"

typedef struct site {
    sf_grid *grid;
    sf_allocator allocator;
    sfi_domain domain;
    sfi_poisson poisson;
    sfi_cycle cycle;
    size_t nodes;
} site;

static void site_begin(site *s, sf_grid *grid)
{
    s->grid = grid;
    s->allocator = sfi_allocator_or_default(NULL);
    CHECK_EQ(sfi_domain_create(grid, 0, UINT32_MAX, &s->allocator, &s->domain), SF_OK);
    CHECK_EQ(sfi_poisson_create(&s->domain, &s->poisson), SF_OK);
    CHECK_EQ(sfi_cycle_create(&s->poisson, &s->allocator, &s->cycle), SF_OK);
    s->nodes = s->domain.node_count;
}

static void site_end(site *s)
{
    sfi_cycle_destroy(&s->cycle, &s->allocator);
    sfi_poisson_destroy(&s->poisson);
    sfi_domain_destroy(&s->domain);
    sf_grid_destroy(s->grid);
}

// On a lattice with pitches and layers of its own: cells are voxels here, because most_cells is
// large and the pitches are near to each other.
static void the_laplacian_is_that_of_the_boxes(void)
{
    const double heights[] = {1, 1.25, 0.75, 1, 1, 1.25};
    sf_lattice lattice = {9, 7, 6, 1, 1.125, 1, heights, {3, -4, 5}};
    sf_grid *grid = random_solid(&lattice, 0.6);
    solid s;
    site t;
    solid_begin(&s, grid);
    site_begin(&t, grid);
    CHECK_EQ(t.nodes, s.count);
    double *x = malloc(SFI_LANES * t.nodes * sizeof *x),
           *y = malloc(SFI_LANES * t.nodes * sizeof *y);
    for (size_t i = 0; i < SFI_LANES * t.nodes; i++) {
        x[i] = test_random_unit();
    }
    sfi_poisson_apply(&t.poisson, x, y);
    double unit = t.domain.unit_mm;
    for (size_t i = 0; i < s.count && t.nodes == s.count; i++) {
        CHECK_NEAR(t.poisson.mass[i] * unit * unit * unit, s.mass[i], 1e-6);
        for (size_t k = 0; k < SFI_LANES; k++) {
            double sum = 0;
            for (size_t j = 0; j < s.count; j++) {
                sum += s.laplacian[i * s.count + j] * x[SFI_LANES * j + k];
            }
            CHECK_NEAR(y[SFI_LANES * i + k] * unit, sum, 1e-5);
        }
    }
    free(x);
    free(y);
    solid_end(&s);
    site_end(&t);
}

// One cycle on every unit vector, four at a time: the columns of V.
static void find_columns(site *t, double *v)
{
    for (size_t from = 0; from < t->nodes; from += SFI_LANES) {
        for (size_t n = 0; n < SFI_LANES * t->nodes; n++) {
            t->cycle.b[0][n] = n / SFI_LANES == from + n % SFI_LANES;
        }
        sfi_cycle_run(&t->cycle);
        for (size_t n = 0; n < SFI_LANES * t->nodes; n++) {
            if (from + n % SFI_LANES < t->nodes) {
                v[(from + n % SFI_LANES) * t->nodes + n / SFI_LANES] = (double)t->cycle.x[0][n];
            }
        }
    }
}

static void a_cycle_is_a_symmetric_positive_matrix(void)
{
    for (int round = 0; round < 6; round++) {
        sf_lattice lattice = {12, 5, 7, 1, 1, 1, NULL, {0, 0, 0}};
        site t;
        site_begin(&t, random_solid(&lattice, 0.5));
        uint8_t *fixed = calloc(t.nodes, 1);
        float *pin = calloc(SFI_LANES * t.nodes, sizeof *pin);
        fixed[0] = fixed[t.nodes / 2] = 1;
        // Every piece is held: a little everywhere, and much in some places.
        for (size_t n = 0; n < SFI_LANES * t.nodes; n++) {
            size_t i = n / SFI_LANES;
            pin[n] = i % 7 == 0 ? 2.0f : 0.01f;
        }
        sfi_cycle_hold(&t.cycle, fixed, pin);
        double *v = malloc(t.nodes * t.nodes * sizeof *v);
        find_columns(&t, v);
        for (size_t i = 0; i < t.nodes; i++) {
            for (size_t j = 0; j < i; j++) {
                CHECK_NEAR(v[i * t.nodes + j], v[j * t.nodes + i], 1e-5);
            }
            CHECK(fixed[i] ? v[i * t.nodes + i] == 0 : v[i * t.nodes + i] > 0);
            CHECK(!fixed[i] || v[i * t.nodes] == 0);
        }
        for (int trial = 0; trial < 20; trial++) {
            double sum = 0;
            double *b = malloc(t.nodes * sizeof *b);
            for (size_t i = 0; i < t.nodes; i++) {
                b[i] = test_random_unit() - 0.5;
            }
            for (size_t n = 0; n < t.nodes * t.nodes; n++) {
                sum += b[n / t.nodes] * v[n] * b[n % t.nodes];
            }
            CHECK(sum > 0);
            free(b);
        }
        free(v);
        free(pin);
        free(fixed);
        site_end(&t);
    }
}

// b = L x + pin x on free nodes.
static void multiply(const site *t, const uint8_t *fixed, const double *x, double *b)
{
    sfi_poisson_apply(&t->poisson, x, b);
    for (size_t n = 0; n < SFI_LANES * t->nodes; n++) {
        b[n] = fixed[n / SFI_LANES] ? 0 : b[n];
    }
}

// Iterated cycles: what a cycle leaves of the error at last, in the norm of energy.
static double contraction(site *t, const uint8_t *fixed, int rounds)
{
    size_t numbers = SFI_LANES * t->nodes;
    double *error = malloc(2 * numbers * sizeof *error), *image = error + numbers, before = 0,
           rate = 0;
    for (size_t n = 0; n < numbers; n++) {
        error[n] = fixed[n / SFI_LANES] ? 0 : test_random_unit() - 0.5;
    }
    sfi_cycle_hold(&t->cycle, fixed, NULL);
    for (int round = 0; round < rounds; round++) {
        double energy = 0;
        multiply(t, fixed, error, image);
        for (size_t n = 0; n < numbers; n++) {
            energy += error[n] * image[n];
            t->cycle.b[0][n] = (float)image[n];
        }
        rate = round > 0 ? sqrt(energy / before) : 0;
        before = energy;
        sfi_cycle_run(&t->cycle);
        for (size_t n = 0; n < numbers; n++) {
            error[n] -= (double)t->cycle.x[0][n];
        }
    }
    free(error);
    return rate;
}

static sf_grid *figure(uint32_t size)
{
    sf_lattice lattice = {size, size, size, 1, 1, 1, NULL, {0, 0, 0}};
    sf_grid *grid = NULL;
    CHECK_EQ(sf_grid_create(&lattice, NULL, &grid), SF_OK);
    double part = size / 24.0;
    for (uint32_t n = 0; n < size * size * size; n++) {
        double x = (n % size + 0.5) / part, y = (n / size % size + 0.5) / part,
               z = (n / size / size + 0.5) / part;
        // A trunk, two arms, two legs.
        int trunk = (x - 12) * (x - 12) + (y - 12) * (y - 12) < 16 && z > 8 && z < 20;
        int arm = fabs(y - 12) < 1.5 && fabs(z - 16) < 1.5 && fabs(x - 12) < 11;
        int leg = fabs(fabs(x - 12) - 3) < 1.5 && fabs(y - 12) < 1.5 && z <= 8;
        CHECK_EQ(sf_slice_set(sf_grid_slice(grid, n / size / size), n % size, n / size % size,
                              trunk || arm || leg),
                 SF_OK);
    }
    return grid;
}

static void a_cycle_leaves_little_of_an_error(void)
{
    for (uint32_t size = 12; size <= 48; size *= 2) {
        site t;
        site_begin(&t, figure(size));
        uint8_t *fixed = calloc(t.nodes, 1);
        for (size_t i = 0; i < t.nodes; i++) {
            fixed[i] = t.domain.node_place[3 * i + 2] == 0;
        }
        double rate = contraction(&t, fixed, 12);
        printf("# %zu nodes, %u levels: a cycle leaves %.2f of an error\n", t.nodes,
               t.poisson.level_count, rate);
        CHECK(rate < 0.7);
        free(fixed);
        site_end(&t);
    }
}

// Fewer nodes than the coarsest level has at most: the cycle is the exact inverse.
static void a_small_domain_is_solved_exactly(void)
{
    sf_lattice lattice = {3, 2, 2, 1, 1, 1, NULL, {0, 0, 0}};
    site t;
    site_begin(&t, random_solid(&lattice, 1));
    uint8_t fixed[36] = {1};
    CHECK_EQ(t.nodes, 36);
    CHECK_EQ(t.poisson.level_count, 1);
    CHECK(contraction(&t, fixed, 2) < 1e-5);
    site_end(&t);
}

int main(void)
{
    TEST(the_laplacian_is_that_of_the_boxes);
    TEST(a_cycle_is_a_symmetric_positive_matrix);
    TEST(a_cycle_leaves_little_of_an_error);
    TEST(a_small_domain_is_solved_exactly);
    return test_finish();
}
