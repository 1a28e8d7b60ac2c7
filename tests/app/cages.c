// SPDX-License-Identifier: MIT
// Odd cages at the Grade workspace: faces that are saddles, surfaces with open edges, shapes
// without an outside or a size. What is shown of them is the limit surface, all of it that lies
// beside the cut and nothing else; what cannot be shown is told in words.

#include "test.h"

#include <math.h>

#include "app/event.h"
#include "grade/grade.h"

static desk *make(void)
{
    desk *d = grade_desk_create();
    CHECK(d != NULL);
    return d;
}

static void go_on(desk *d)
{
    for (int i = 0; i < 10 && d->is->is_busy(d); i++) {
        d->is->act(d, DO_STEP);
    }
    CHECK(!d->is->is_busy(d));
}

// A cage of one cell, as a desk takes it; 0 where it is refused.
static int take_one(desk *d, uint32_t dimension, const double *positions, uint32_t points)
{
    static const uint32_t corners[8] = {0, 1, 2, 3, 4, 5, 6, 7};
    const uint32_t starts[2] = {0, points};
    const sf_cage_view v = {.dimension = dimension,
                            .point_count = points,
                            .positions = positions,
                            .cell_count = 1,
                            .starts = starts,
                            .corners = corners};
    char why[DESK_WHY_SIZE];
    sf_cage *cage = NULL;
    CHECK(sf_cage_create(&v, NULL, &cage, NULL) == SF_OK);
    int good = grade_take((grade *)d, cage, why);
    if (!good) {
        sf_cage_destroy(cage);
    }
    return good;
}

// A face that is a saddle is cut into two pieces: all of it that lies beside the cut is shown, and
// what lies before and beyond makes up the whole.
static void a_saddle_is_cut(void)
{
    static const double corners[12] = {0, 0, 0, 10, 0, 10.7, 10, 10, 0.3, 0, 10, 9.1};
    desk *d = make();
    stage *s = stage_create();
    CHECK(s != NULL && take_one(d, 2, corners, 4));
    d->is->set(d, GRADE_CUT_AXIS, 2);
    double all = -1;
    for (int i = 0; i <= 600; i++) {
        double area = 0;
        d->is->set(d, GRADE_CUT_SHARE, 0.4 + 0.2 * i / 600);
        for (int side = 0; side < 2; side++) {
            size_t count;
            d->is->set(d, GRADE_CUT_SIDE, side);
            stage_clear(s);
            CHECK(d->is->show(d, s));
            const stage_vertex *v = stage_vertices(s, STAGE_SMOOTH, &count);
            for (size_t k = 0; k + 2 < count; k += 3) { // seen from above
                const float *a = v[k].at_mm, *b = v[k + 1].at_mm, *c = v[k + 2].at_mm;
                area += 0.5 * fabs((double)(b[0] - a[0]) * (double)(c[1] - a[1]) -
                                   (double)(b[1] - a[1]) * (double)(c[0] - a[0]));
            }
        }
        all = all < 0 ? area : all;
        CHECK(all > 60 && fabs(area - all) < 1e-3);
    }
    stage_destroy(s);
    d->is->destroy(d);
}

// Faces with open edges: these are sharp by themselves, so their limit is that of a crease.
static void an_open_surface_is_the_limit(void)
{
    static const double corners[12] = {0, 0, 0, 10, 0, 6, 10, 10, 0, 0, 10, 3};
    desk *d = make();
    CHECK(take_one(d, 2, corners, 4));
    const grade *g = (const grade *)d;
    sf_limit *limit = NULL;
    CHECK(sf_limit_create(g->cage, SF_REFINE_STANDARD, NULL, NULL, &limit) == SF_OK);
    double worst = 0;
    uint32_t n = 1u << g->surface.steps;
    for (uint32_t i = 0; i <= n; i++) {
        for (uint32_t j = 0; j <= n; j++) {
            const double u[3] = {(double)i / n, (double)j / n, 0};
            sf_place place;
            double at[3], least = INFINITY;
            CHECK(sf_limit_place(limit, 0, u, &place) == SF_OK);
            CHECK(sf_limit_positions(limit, 1, &place, NULL, NULL, at, NULL) == SF_OK);
            for (size_t k = 0; k < 4 * g->surface.face_count; k++) {
                const double *p = g->surface.points + 3 * (size_t)g->surface.corners[k];
                least = fmin(least, hypot(hypot(p[0] - at[0], p[1] - at[1]), p[2] - at[2]));
            }
            worst = fmax(worst, least);
        }
    }
    printf("# off by %.2g mm\n", worst);
    CHECK(worst < 1e-9);
    sf_limit_destroy(limit);
    d->is->destroy(d);
}

// What has no outside is refused, what has no size is told in words, and no numbers of a slice stay
// that is not there any more.
static void odd_shapes(void)
{
    static const double far[24] = {1e9, 0, 0, 1e9 + 8, 0, 0, 1e9 + 8, 8, 0, 1e9, 8, 0,
                                   1e9, 0, 8, 1e9 + 8, 0, 8, 1e9 + 8, 8, 8, 1e9, 8, 8};
    static const double nowhere[24] = {5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5,
                                       5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5};
    static const double five[15] = {0, 0, 0, 9, 0, 0, 0, 9, 0, 0, 0, 9, 3, 3, 3};
    static const uint32_t starts[6] = {0, 4, 8, 12, 16, 20};
    static const uint32_t corners[20] = {1, 2, 3, 4, 2, 0, 3, 4, 0, 1,
                                         3, 4, 1, 0, 2, 4, 0, 1, 2, 3};
    char why[DESK_WHY_SIZE] = "";
    desk *d = make();
    const grade_state *s = grade_desk_state(d);
    go_on(d);
    uint64_t before = d->is->hash(d);
    // The five sides of a simplex of four dimensions: each face lies between two of them.
    const sf_cage_view v = {.dimension = 3,
                            .point_count = 5,
                            .positions = five,
                            .cell_count = 5,
                            .starts = starts,
                            .corners = corners};
    sf_cage *cage = NULL;
    CHECK(sf_cage_create(&v, NULL, &cage, NULL) == SF_OK);
    int is_taken = grade_take((grade *)d, cage, why);
    CHECK(!is_taken && strstr(why, "no outside") != NULL);
    if (!is_taken) {
        sf_cage_destroy(cage);
    }
    CHECK(d->is->hash(d) == before);
    d->is->set(d, GRADE_CUT_AXIS, 0);
    CHECK(take_one(d, 3, far, 8));
    go_on(d);
    CHECK(s->counts[0] > 1000 && d->said[0] == '\0');
    CHECK(take_one(d, 3, nowhere, 8));
    go_on(d);
    CHECK(s->counts[0] == 0 && strstr(d->said, "no size") != NULL);
    stage *st = stage_create();
    CHECK(st != NULL && d->is->show(d, st));
    stage_destroy(st);
    d->is->set(d, GRADE_CUT, 0);
    d->is->act(d, DO_STEP);
    CHECK(strstr(d->said, "No section") == NULL && strstr(d->said, "inside out") != NULL);
    d->is->destroy(d);
}

int main(void)
{
    TEST(a_saddle_is_cut);
    TEST(an_open_surface_is_the_limit);
    TEST(odd_shapes);
    return test_finish();
}
