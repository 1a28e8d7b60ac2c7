// SPDX-License-Identifier: MIT
// Why: the limit of a cage's boundary is worked out here by rules of our own; OpenSubdiv's is what
// the world agrees on. On every cage, of faces or of cells, smooth, sharp and half sharp, the limit
// points after none to two steps must be the same set, within 1e-5 of the cage's own unit. Guards:
// issue 8 part
// 5. Also what the adapter refuses, and that it says so.

#include "../unit/grade/cages.h"

#include <sf/limit.h>
#include <sf/link/opensubdiv.h>

#include "../failing_allocator.h"

// ---------------------------------------------------------------------------------------------
// Ours
// ---------------------------------------------------------------------------------------------

typedef struct points {
    double *xyz;
    size_t count;
} points;

// The limit at each point of a cage of hexahedra or quadrilaterals: that of any corner which lies
// there. Piece j of a cell has the cell's axes and its corner j.
static points limits_of(const sf_cage_view *v)
{
    sf_cage *cage = NULL;
    sf_limit *limit = NULL;
    points p = {calloc(3 * v->point_count, sizeof(double)), v->point_count};
    size_t count = v->starts[v->cell_count];
    sf_place *places = calloc(count, sizeof *places);
    double *at = calloc(3 * count, sizeof *at);
    CHECK_EQ(sf_cage_create(v, NULL, &cage, NULL), SF_OK);
    CHECK_EQ(sf_limit_create(cage, SF_REFINE_STANDARD, NULL, NULL, &limit), SF_OK);
    for (size_t i = 0; i < count; i++) {
        uint32_t corner = (uint32_t)i % (v->dimension == 3 ? 8 : 4);
        places[i].piece = (uint32_t)i;
        places[i].u[0] = corner % 4 == 1 || corner % 4 == 2;
        places[i].u[1] = corner % 4 >= 2;
        places[i].u[2] = corner >= 4;
    }
    CHECK_EQ(sf_limit_positions(limit, count, places, NULL, NULL, at, NULL), SF_OK);
    for (size_t i = 0; i < count; i++) {
        memcpy(p.xyz + 3 * (size_t)v->corners[i], at + 3 * i, 3 * sizeof *at);
    }
    free(places);
    free(at);
    sf_limit_destroy(limit);
    sf_cage_destroy(cage);
    return p;
}

// Points after no step have children of the same limit, among cells that are all alike.
static points ours(const sf_cage *cage, uint32_t steps, size_t *outside)
{
    sf_refinement *r = NULL;
    sf_cage_view v = sf_cage_get_view(cage);
    sf_cage *again = NULL;
    sf_cage_report report;
    sf_refine_options options = sf_refine_options_default();
    options.steps = steps > 0 ? steps : 1;
    CHECK_EQ(sf_refine(cage, &options, NULL, NULL, &r), SF_OK);
    if (steps > 0) {
        CHECK_EQ(sf_refinement_get_view(r, steps, &v), SF_OK);
    }
    CHECK_EQ(sf_cage_create(&v, NULL, &again, NULL), SF_OK);
    CHECK_EQ(sf_cage_check(again, NULL, &report, NULL), SF_OK);
    *outside = v.dimension == 3 ? report.boundary_points : v.point_count;
    CHECK_EQ(sf_refinement_get_view(r, options.steps, &v), SF_OK);
    points p = limits_of(&v);
    sf_cage_destroy(again);
    sf_refinement_destroy(r);
    return p;
}

// ---------------------------------------------------------------------------------------------
// Both
// ---------------------------------------------------------------------------------------------

static int by_x(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

// The farthest that a point of one set is from the other's nearest, and how many are farther than
// 1e-5; the other is sorted by x.
static double farthest(const double *from, size_t count, const points *to, size_t *far)
{
    double worst = 0;
    for (size_t i = 0; i < count; i++) {
        const double *p = from + 3 * i;
        double best = 1e-1;
        size_t low = 0, high = to->count;
        while (low < high) {
            size_t middle = (low + high) / 2;
            if (to->xyz[3 * middle] < p[0] - best) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        for (size_t j = low; j < to->count && to->xyz[3 * j] <= p[0] + best; j++) {
            const double *q = to->xyz + 3 * j;
            best = fmin(best, fmax(fmax(fabs(p[0] - q[0]), fabs(p[1] - q[1])), fabs(p[2] - q[2])));
        }
        *far += best > 1e-5;
        worst = fmax(worst, best);
    }
    return worst;
}

// `darts`: how many points end a crease that lasts within the surface. OpenSubdiv's mask there is
// that of a smooth point, as its sources say, so its point is not the limit; ours is (unit/grade
// limit).
static void compare(const sf_cage *cage, const char *name, size_t darts)
{
    for (uint32_t steps = 0; steps <= 2; steps++) {
        sf_opensubdiv_options options = sf_opensubdiv_options_default();
        sf_mesh *mesh = NULL;
        sf_fault fault = {SF_OK, 0, 0, ""};
        size_t outside, far = 0;
        options.steps = steps;
        CHECK_EQ(sf_opensubdiv_mesh(cage, &options, NULL, NULL, &mesh, &fault), SF_OK);
        sf_mesh_view view = sf_mesh_get_view(mesh);
        points mine = ours(cage, steps, &outside);
        CHECK_EQ(view.vertex_count, outside);
        qsort(mine.xyz, mine.count, 3 * sizeof(double), by_x);
        double worst = farthest(view.vertices, view.vertex_count, &mine, &far);
        printf("# %s, %u steps: %zu points, at most %.2g apart, %zu of them at ends of creases\n",
               name, steps, view.vertex_count, worst, far);
        CHECK(view.vertex_count > 0 && far == darts && worst <= (darts > 0 ? 0.02 : 1e-5));
        free(mine.xyz);
        sf_mesh_destroy(mesh);
    }
}

static void compare_made(test_cage *c, const char *name, size_t darts)
{
    sf_cage *cage = test_cage_make(c);
    compare(cage, name, darts);
    sf_cage_destroy(cage);
    test_cage_free(c);
}

static void add_crease(test_cage *c, uint32_t a, uint32_t b, double sharpness)
{
    sf_crease crease = {{a, b}, sharpness};
    c->crease[c->creases++] = crease;
}

// Cells: regular and not, with creases that last, end, and end between two steps.
static void cages_of_cells_are_opensubdivs(void)
{
    static const double sharpness[] = {0, 1, 1.5, 2.3, 10};
    test_cage c = test_cage_block(2, 3, 1);
    compare_made(&c, "a block", 0);
    c = test_cage_wheel(5, 2, 0.3);
    compare_made(&c, "a wheel of five", 0);
    c = test_cage_wheel(3, 1, 0.2);
    compare_made(&c, "a wheel of three", 0);
    for (size_t i = 0; i < sizeof sharpness / sizeof sharpness[0]; i++) {
        char name[64];
        c = test_cage_block(2, 2, 1);
        add_crease(&c, 0, 1, sharpness[i]);
        add_crease(&c, 1, 2, sharpness[i]);
        add_crease(&c, 2, 5, 0.7);
        c.sharp[c.sharps].point = 8;
        c.sharp[c.sharps++].sharpness = sharpness[i];
        snprintf(name, sizeof name, "a block with creases of %g", sharpness[i]);
        compare_made(&c, name, sharpness[i] < SF_SHARP ? 0 : 2);
    }
}

// A tetrahedron and a wedge on it, each of their faces once.
static void other_cells_are_opensubdivs(void)
{
    static const double at[7][3] = {{0, 0, 0},  {2, 0, 0},  {0, 2, 0},   {0.3, 0.4, 2},
                                    {0, 0, -2}, {2, 0, -1}, {0, 2, -1.5}};
    static const uint32_t corners[10] = {0, 1, 2, 3, 4, 5, 6, 0, 1, 2};
    test_cage c = test_cage_begin(3, 7, 2, 6);
    for (size_t i = 0; i < 7; i++) {
        test_cage_place(&c, i, at[i][0], at[i][1], at[i][2]);
    }
    memcpy(c.corners, corners, sizeof corners);
    c.starts[1] = 4, c.starts[2] = 10;
    compare_made(&c, "a tetrahedron on a wedge", 0);
}

// ---------------------------------------------------------------------------------------------
// Files
// ---------------------------------------------------------------------------------------------

// Faces of an OBJ of polygons; corners of an open mesh are sharp, where the file asks for it.
static sf_cage *cage_of_obj(const char *path)
{
    static double xyz[3 * 8000];
    static uint32_t starts[8001], corners[32000], uses[8000];
    sf_crease creases[64];
    sf_sharp_point sharps[8000];
    size_t count = 0, faces = 0, used = 0, crease_count = 0, sharp_count = 0;
    int sharp_corners = 0, kind = 0;
    char line[512];
    FILE *file = fopen(path, "rb");
    memset(uses, 0, sizeof uses);
    while (file != NULL && fgets(line, sizeof line, file) != NULL) {
        double *p = xyz + 3 * count;
        sf_crease *t = &creases[crease_count];
        count += sscanf(line, "v %lf %lf %lf", &p[0], &p[1], &p[2]) == 3;
        crease_count += sscanf(line, "t crease 2/1/0 %u %u %lf", &t->points[0], &t->points[1],
                               &t->sharpness) == 3;
        sharp_corners |= sscanf(line, "t interpolateboundary 1/0/0 %d", &kind) == 1 && kind == 1;
        if (line[0] == 'f' && line[1] == ' ') {
            starts[faces++] = (uint32_t)used;
            for (char *word = strtok(line + 2, " \r\n"); word != NULL;
                 word = strtok(NULL, " \r\n")) {
                corners[used] = (uint32_t)strtoul(word, NULL, 10) - 1;
                uses[corners[used++]]++;
            }
        }
    }
    if (file != NULL) {
        fclose(file);
    }
    starts[faces] = (uint32_t)used;
    for (uint32_t i = 0; i < count && sharp_corners; i++) {
        sf_sharp_point sharp = {i, SF_SHARP};
        if (uses[i] == 1) {
            sharps[sharp_count++] = sharp;
        }
    }
    sf_cage_view view = {2,       count,       xyz,    faces, starts, corners, crease_count,
                         creases, sharp_count, sharps, 0,     NULL};
    sf_cage *cage = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    CHECK_EQ(sf_cage_create(&view, NULL, &cage, &fault), SF_OK);
    if (cage == NULL) {
        printf("# %s: %s\n", path, fault.message);
    }
    return cage;
}

static void cages_of_files_are_opensubdivs(void)
{
    static const char *const names[] = {"catmark_cube",
                                        "catmark_cube_level0",
                                        "catmark_cube_level1",
                                        "catmark_cube_level2",
                                        "catmark_cube_creases0",
                                        "catmark_cube_creases0_level0",
                                        "catmark_cube_creases0_level1",
                                        "catmark_cube_creases0_level2",
                                        "catmark_tent_creases0",
                                        "catmark_tent_creases0_level0",
                                        "catmark_tent_creases0_level1",
                                        "catmark_tent_creases0_level2",
                                        "spot_control_mesh"};
    if (getenv("SF_DATA") == NULL) {
        SKIP("SF_DATA names no folder");
    }
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        char path[1024];
        snprintf(path, sizeof path, "%s/cages/%s.obj", getenv("SF_DATA"), names[i]);
        sf_cage *cage = cage_of_obj(path);
        if (cage != NULL) {
            compare(cage, names[i], 0);
        }
        sf_cage_destroy(cage);
    }
}

// ---------------------------------------------------------------------------------------------
// The adapter itself
// ---------------------------------------------------------------------------------------------

// Outside outwards: of a block of 2 x 3 x 1 that is not moved, the volume.
static void faces_outwards(void)
{
    test_cage c = test_cage_block(2, 3, 1);
    sf_cage *cage = test_cage_make(&c);
    sf_opensubdiv_options options = sf_opensubdiv_options_default();
    sf_mesh *mesh = NULL;
    sf_mass mass;
    options.steps = 0;
    options.on_limit = 0;
    CHECK_EQ(sf_opensubdiv_mesh(cage, &options, NULL, NULL, &mesh, NULL), SF_OK);
    CHECK_EQ(sf_mesh_measure(sf_mesh_get_view(mesh), &mass), SF_OK);
    CHECK_NEAR(mass.volume_mm3, 6, 1e-12);
    CHECK_EQ(sf_mesh_get_view(mesh).triangle_count, 44);
    sf_mesh_destroy(mesh);
    sf_cage_destroy(cage);
    test_cage_free(&c);
}

static double last;

static void note(void *user, double fraction)
{
    CHECK(fraction >= last && fraction <= 1);
    last = fraction;
    if (user != NULL && fraction > 0.3) {
        sf_task_cancel(user);
    }
}

static void tells_and_stops(void)
{
    test_cage c = test_cage_block(2, 2, 2);
    sf_cage *cage = test_cage_make(&c);
    sf_task task = sf_task_default();
    sf_mesh *mesh = NULL;
    sf_opensubdiv_options options = sf_opensubdiv_options_default();
    options.steps = 4;
    task.progress = note;
    last = 0;
    CHECK_EQ(sf_opensubdiv_mesh(cage, &options, NULL, &task, &mesh, NULL), SF_OK);
    CHECK(last == 1);
    sf_mesh_destroy(mesh);
    mesh = NULL;
    last = 0;
    task.user = &task;
    CHECK_EQ(sf_opensubdiv_mesh(cage, &options, NULL, &task, &mesh, NULL), SF_ERR_CANCELLED);
    CHECK(mesh == NULL);
    sf_cage_destroy(cage);
    test_cage_free(&c);
}

static void refuses(void)
{
    test_cage c = test_cage_block(1, 1, 1);
    sf_opensubdiv_options options = sf_opensubdiv_options_default();
    sf_mesh *mesh = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_cage *cage = test_cage_make(&c);
    CHECK_EQ(sf_opensubdiv_mesh(NULL, NULL, NULL, NULL, &mesh, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_opensubdiv_mesh(cage, NULL, NULL, NULL, NULL, NULL), SF_ERR_ARGUMENT);
    options.steps = SF_OPENSUBDIV_STEP_MAX + 1;
    CHECK_EQ(sf_opensubdiv_mesh(cage, &options, NULL, NULL, &mesh, NULL), SF_ERR_ARGUMENT);
    sf_cage_destroy(cage);
    test_cage_free(&c);
    c = test_cage_block(4, 4, 4); // ten levels: 384 faces, times four nine times
    add_crease(&c, 0, 1, 9.5);
    cage = test_cage_make(&c);
    CHECK_EQ(sf_opensubdiv_mesh(cage, NULL, NULL, NULL, &mesh, &fault), SF_ERR_OVERFLOW);
    CHECK(strstr(fault.message, "10 levels") != NULL && mesh == NULL);
    sf_cage_destroy(cage);
    test_cage_free(&c);
}

// The k-th allocation of the mesh that fails: no memory, nothing left behind.
static void survives_every_refused_allocation(void)
{
    test_cage c = test_cage_block(1, 1, 1);
    sf_cage *cage = test_cage_make(&c);
    sf_status status = SF_ERR_MEMORY;
    for (long k = 0; status != SF_OK && k < 100; k++) {
        sf_mesh *mesh = NULL;
        failing_allocator memory;
        failing_begin(&memory, k);
        status = sf_opensubdiv_mesh(cage, NULL, &memory.allocator, NULL, &mesh, NULL);
        CHECK(status == SF_OK || (status == SF_ERR_MEMORY && mesh == NULL));
        sf_mesh_destroy(mesh);
        CHECK(memory.live == 0 && memory.faults == 0);
    }
    CHECK_EQ(status, SF_OK);
    sf_cage_destroy(cage);
    test_cage_free(&c);
}

int main(void)
{
    TEST(cages_of_cells_are_opensubdivs);
    TEST(other_cells_are_opensubdivs);
    TEST(cages_of_files_are_opensubdivs);
    TEST(faces_outwards);
    TEST(tells_and_stops);
    TEST(refuses);
    TEST(survives_every_refused_allocation);
    return test_finish();
}
