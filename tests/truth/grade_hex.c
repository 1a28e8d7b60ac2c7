// SPDX-License-Identifier: MIT
// Why: what grade promises must hold on meshes that others made, not only on blocks and wheels. For
// each model of shared/data/hex the limit is held against local refinements, its derivatives
// against differences, its inverse against the places that points were made of; its tetrahedra must
// conform and be positive wherever the shape is proved to be; and fandisk's slices at 512 must be
// nearly the same by tetrahedra, with the properties that the inverse finds. Asked: 1e-6, 1e-7 and
// 1e-6, 0.15 % and 1e-4. amr-hex has hanging nodes and is refused for that.

#include "plain.h"

#include <sf/cage_io.h>
#include <sf/io.h>
#include <sf/locate.h>
#include <sf/sample.h>

// A model, with a property that is bent as places are.
static sf_cage *model(const char *name, double *size)
{
    char path[1024];
    sf_cage *cage = NULL;
    sf_file *file = NULL;
    sf_fault fault = {0};
    double low[3] = {1e300, 1e300, 1e300}, high[3] = {-1e300, -1e300, -1e300};
    snprintf(path, sizeof path, "%s/hex/%s", getenv("SF_DATA"), name);
    CHECK_EQ(sf_file_open(path, NULL, &file, &fault), SF_OK);
    if (file == NULL) {
        return NULL;
    }
    sf_status status = sf_cage_read(sf_file_source(file), NULL, NULL, &cage, NULL, &fault);
    sf_file_close(file);
    if (status != SF_OK) {
        printf("# %s: %s\n", name, fault.message);
        return NULL;
    }
    sf_cage_view v = sf_cage_get_view(cage);
    while (sf_cage_get_view(cage).channel_count > 0) { // references of the file
        CHECK_EQ(sf_cage_remove_property(cage, 0), SF_OK);
    }
    for (size_t i = 0; i < 3 * v.point_count; i++) {
        low[i % 3] = fmin(low[i % 3], v.positions[i]);
        high[i % 3] = fmax(high[i % 3], v.positions[i]);
    }
    *size = sqrt(pow(high[0] - low[0], 2) + pow(high[1] - low[1], 2) + pow(high[2] - low[2], 2));
    double *values = calloc(v.point_count, sizeof *values);
    for (size_t i = 0; i < v.point_count; i++) {
        const double *p = v.positions + 3 * i;
        values[i] = 10 + (p[0] - low[0]) / *size + sin(5 * p[1] / *size) * p[2] / *size;
    }
    sf_channel density = {sf_property_density(), v.point_count, values, NULL};
    CHECK_EQ(sf_cage_add_property(cage, &density, NULL), SF_OK);
    free(values);
    return cage;
}

static sf_place random_place(const sf_limit *limit)
{
    sf_place place = {test_random_below((uint32_t)sf_limit_piece_count(limit)), {0, 0, 0}};
    for (int axis = 0; axis < 3; axis++) {
        place.u[axis] = test_random_unit();
    }
    return place;
}

static double apart(const double *a, const double *b)
{
    return sqrt(pow(a[0] - b[0], 2) + pow(a[1] - b[1], 2) + pow(a[2] - b[2], 2));
}

static double determinant(const double *j)
{
    return j[0] * (j[4] * j[8] - j[5] * j[7]) - j[1] * (j[3] * j[8] - j[5] * j[6]) +
           j[2] * (j[3] * j[7] - j[4] * j[6]);
}

static void position(const sf_limit *limit, sf_place place, double at[3], double *d)
{
    CHECK_EQ(sf_limit_positions(limit, 1, &place, NULL, NULL, at, d), SF_OK);
}

static void check_limit(const sf_cage *cage, const sf_limit *limit, double size)
{
    double worst = 0, slope = 0;
    for (int i = 0; i < 20; i++) {
        sf_place place = random_place(limit);
        double expected[4], at[3], value;
        plain(cage, SF_REFINE_STANDARD, place, 32, expected);
        position(limit, place, at, NULL);
        CHECK_EQ(sf_limit_values(limit, 0, 1, &place, NULL, NULL, &value, NULL), SF_OK);
        worst = fmax(worst, apart(at, expected) / size);
        CHECK_NEAR(value, expected[3], 1e-7);
    }
    for (int i = 0; i < 200; i++) {
        const double h = 1e-5;
        sf_place place = random_place(limit), before, behind;
        double at[3], d[9], p[3], q[3];
        int axis = i % 3;
        place.u[axis] = 0.01 + 0.98 * place.u[axis];
        before = behind = place;
        before.u[axis] -= h;
        behind.u[axis] += h;
        position(limit, place, at, d);
        position(limit, before, p, NULL);
        position(limit, behind, q, NULL);
        for (int x = 0; x < 3; x++) {
            slope = fmax(slope, fabs(d[3 * x + axis] - (q[x] - p[x]) / (2 * h)) / size);
        }
    }
    printf("# limit %.2g of its size from local refinement, derivatives %.2g from differences\n",
           worst, slope);
    CHECK(worst < 1e-6 && slope < 1e-6);
}

static void check_inverse(const sf_limit *limit, double size)
{
    enum { COUNT = 2000 };
    static sf_place places[COUNT], found[COUNT];
    static double at[3 * COUNT], d[9 * COUNT], again[3];
    double mean = 0, worst = 0, slip = 0;
    sf_locator *locator = NULL;
    CHECK_EQ(sf_locator_create(limit, NULL, &locator), SF_OK);
    for (int i = 0; i < COUNT; i++) {
        places[i] = random_place(limit);
    }
    CHECK_EQ(sf_limit_positions(limit, COUNT, places, NULL, NULL, at, d), SF_OK);
    CHECK_EQ(sf_locator_find(locator, COUNT, at, 0, NULL, NULL, found, NULL), SF_OK);
    for (int i = 0; i < COUNT; i++) {
        mean += determinant(d + 9 * i) / COUNT;
    }
    for (int i = 0; i < COUNT; i++) {
        CHECK(found[i].piece != SF_NO_PIECE);
        if (found[i].piece == SF_NO_PIECE) {
            continue;
        }
        position(limit, found[i], again, NULL);
        worst = fmax(worst, apart(again, at + 3 * i) / size);
        if (determinant(d + 9 * i) > 0.05 * mean && found[i].piece == places[i].piece) {
            slip = fmax(slip, apart(found[i].u, places[i].u));
        }
    }
    printf("# inverse %.2g of its size from the points, parameters %.2g apart\n", worst, slip);
    CHECK(worst <= 1e-7 && slip <= 1e-6);
    sf_locator_destroy(locator);
}

// Tetrahedra of a step; those of a piece that is proved to be right are positive.
static void check_tets(const sf_cage *cage, const sf_limit *limit, uint32_t steps)
{
    sf_refine_options options = sf_refine_options_default();
    sf_refinement *r = NULL;
    sf_tets *tets = NULL;
    sf_tets_report report;
    sf_limit_report shape;
    options.steps = steps;
    CHECK_EQ(sf_refine(cage, &options, NULL, NULL, &r), SF_OK);
    CHECK_EQ(sf_limit_check(limit, NULL, NULL, &shape), SF_OK);
    for (uint32_t step = 1; step <= steps; step++) {
        CHECK_EQ(sf_tets_of_refinement(r, step, NULL, &tets), SF_OK);
        CHECK_EQ(sf_tets_check(tets, NULL, &report), SF_OK);
        printf("# step %u: %zu tetrahedra, %.7g mm3, %zu inverted, %zu faces crowded\n", step,
               sf_tets_get_view(tets).tet_count, report.volume_mm3, report.inverted,
               report.crowded_faces);
        CHECK_EQ(report.crowded_faces, 0);
        CHECK_EQ(report.inverted, 0);
        sf_tets_destroy(tets);
    }
    printf("# pieces: %zu proved, %zu open, %zu inverted\n", shape.positive, shape.open,
           shape.inverted);
    CHECK(shape.inverted == 0);
    sf_refinement_destroy(r);
}

static void check_model(const char *name, uint32_t steps)
{
    double size = 0;
    if (getenv("SF_DATA") == NULL) {
        SKIP("SF_DATA does not name the folder of models");
    }
    sf_cage *cage = model(name, &size);
    sf_limit *limit = NULL;
    CHECK(cage != NULL);
    if (cage == NULL) {
        return;
    }
    CHECK_EQ(sf_limit_create(cage, SF_REFINE_STANDARD, NULL, NULL, &limit), SF_OK);
    printf("# %s: %zu cells\n", name, sf_cage_get_view(cage).cell_count);
    check_limit(cage, limit, size);
    check_inverse(limit, size);
    check_tets(cage, limit, steps);
    sf_limit_destroy(limit);
    sf_cage_destroy(cage);
}

static void beam(void)
{
    check_model("beam-hex.vtk", 3);
}

static void hexbeam(void)
{
    check_model("hexbeam.vtk", 3);
}

static void fandisk(void)
{
    check_model("fandisk_pone.0177603.s002.mesh", 3);
}

static void toroid(void)
{
    check_model("toroid-hex.mesh", 3);
}

static void rockerarm(void)
{
    check_model("rockerarm.mesh", 1);
}

static void hanging_nodes_are_refused(void)
{
    double size = 0;
    if (getenv("SF_DATA") == NULL) {
        SKIP("SF_DATA does not name the folder of models");
    }
    CHECK(model("amr-hex.mesh", &size) == NULL); // and the reason is printed
}

// ---------------------------------------------------------------------------------------------
// Slices
// ---------------------------------------------------------------------------------------------

static int bit(sf_slice s, uint32_t x, uint32_t y)
{
    return (int)(s.words[(size_t)y * s.stride + x / 64] >> x % 64 & 1);
}

static sf_lattice lattice_of(const sf_limit *limit, uint32_t resolution)
{
    double low[3], high[3];
    CHECK_EQ(sf_limit_bounds(limit, NULL, NULL, low, high), SF_OK);
    double longest = fmax(high[0] - low[0], fmax(high[1] - low[1], high[2] - low[2]));
    sf_lattice l = {0};
    l.pitch_x_mm = l.pitch_y_mm = l.layer_mm = longest / resolution;
    l.nx = (uint32_t)((high[0] - low[0]) / l.layer_mm) + 2;
    l.ny = (uint32_t)((high[1] - low[1]) / l.layer_mm) + 2;
    l.nz = (uint32_t)((high[2] - low[2]) / l.layer_mm) + 2;
    for (int axis = 0; axis < 3; axis++) {
        l.origin_mm[axis] = low[axis] - 0.5 * l.layer_mm;
    }
    return l;
}

// What the inverse finds at voxels of a slice, at random.
static double compare_properties(const sf_limit *limit, const sf_locator *locator,
                                 const sf_lattice *l, uint32_t k, sf_slice s, const double *plane,
                                 int *count)
{
    double worst = 0;
    for (int i = 0; i < 2000; i++) {
        uint32_t x = test_random_below(l->nx), y = test_random_below(l->ny);
        double at[3] = {l->origin_mm[0] + (x + 0.5) * l->pitch_x_mm,
                        l->origin_mm[1] + (y + 0.5) * l->pitch_y_mm,
                        l->origin_mm[2] + (k + 0.5) * l->layer_mm};
        double value;
        sf_place place;
        if (!bit(s, x, y)) {
            continue;
        }
        CHECK_EQ(sf_locator_find(locator, 1, at, l->layer_mm, NULL, NULL, &place, NULL), SF_OK);
        CHECK(place.piece != SF_NO_PIECE);
        CHECK_EQ(sf_limit_values(limit, 0, 1, &place, NULL, NULL, &value, NULL), SF_OK);
        worst = fmax(worst, fabs(value - plane[(size_t)l->nx * y + x]));
        (*count)++;
    }
    return worst;
}

static void slices_of_fandisk(void)
{
    double size = 0, worst = 0;
    size_t zero = 0;
    int count = 0;
    uint64_t solid = 0, differ = 0;
    if (getenv("SF_DATA") == NULL) {
        SKIP("SF_DATA does not name the folder of models");
    }
    sf_cage *cage = model("fandisk_pone.0177603.s002.mesh", &size);
    sf_limit *limit = NULL;
    sf_locator *locator = NULL;
    sf_refinement *r = NULL;
    sf_tets *tets = NULL;
    sf_sampler *a = NULL, *b = NULL;
    sf_grid *p = NULL, *q = NULL;
    sf_refine_options options = sf_refine_options_default();
    options.steps = 3;
    CHECK_EQ(sf_limit_create(cage, SF_REFINE_STANDARD, NULL, NULL, &limit), SF_OK);
    sf_lattice l = lattice_of(limit, 512), one = l;
    one.nz = 1;
    CHECK_EQ(sf_locator_create(limit, NULL, &locator), SF_OK);
    CHECK_EQ(sf_refine(cage, &options, NULL, NULL, &r), SF_OK);
    CHECK_EQ(sf_tets_of_refinement(r, 3, NULL, &tets), SF_OK);
    CHECK_EQ(sf_sampler_create(limit, &l, NULL, 1, &zero, NULL, NULL, &a, NULL), SF_OK);
    CHECK_EQ(sf_sampler_of_tets(tets, &l, 1, &zero, NULL, &b, NULL), SF_OK);
    CHECK_EQ(sf_grid_create(&one, NULL, &p), SF_OK);
    CHECK_EQ(sf_grid_create(&one, NULL, &q), SF_OK);
    sf_slice s = sf_grid_slice(p, 0), t = sf_grid_slice(q, 0);
    size_t plane = (size_t)l.nx * l.ny;
    double *x = calloc(plane, sizeof *x), *y = calloc(plane, sizeof *y);
    for (uint32_t k = 0; k < l.nz; k += 12) {
        CHECK_EQ(sf_sampler_slice(a, k, s, &x), SF_OK);
        CHECK_EQ(sf_sampler_slice(b, k, t, &y), SF_OK);
        for (uint32_t i = 0; i < plane; i++) {
            solid += (uint64_t)bit(s, i % l.nx, i / l.nx);
            differ += bit(s, i % l.nx, i / l.nx) != bit(t, i % l.nx, i / l.nx);
        }
        worst = fmax(worst, compare_properties(limit, locator, &l, k, s, x, &count));
    }
    printf("# %llu solid voxels, %.4f %% differ by tetrahedra; %d properties at most %.2g apart\n",
           (unsigned long long)solid, 100.0 * (double)differ / (double)solid, count, worst);
    CHECK(solid > 1000000 && differ * 10000 <= 15 * solid);
    CHECK(count >= 10000 && worst <= 1e-4);
    free(x);
    free(y);
    sf_grid_destroy(p);
    sf_grid_destroy(q);
    sf_sampler_destroy(a);
    sf_sampler_destroy(b);
    sf_tets_destroy(tets);
    sf_refinement_destroy(r);
    sf_locator_destroy(locator);
    sf_limit_destroy(limit);
    sf_cage_destroy(cage);
}

int main(void)
{
    TEST(beam);
    TEST(hexbeam);
    TEST(fandisk);
    TEST(toroid);
    TEST(rockerarm);
    TEST(hanging_nodes_are_refused);
    TEST(slices_of_fandisk);
    return test_finish();
}
