// SPDX-License-Identifier: MIT
// Why: slicing asks of every voxel which place of the solid it is. Points are made from places, so
// the answer is known: the place found must lie where the point is, within 1e-7 of the size, on all
// kinds of cages, also on edges, corners and where a block's smooth edge makes derivatives vanish;
// and away from there it must be the same place. Outside, nothing is found beyond reach, and within
// it what is about the nearest, held against thousands of places of the boundary.

#include "failing_allocator.h"
#include "limits.h"

#include <sf/locate.h>

static sf_locator *locator_of(const sf_limit *limit)
{
    sf_locator *locator = NULL;
    CHECK_EQ(sf_locator_create(limit, NULL, &locator), SF_OK);
    return locator;
}

static double determinant(const double *j)
{
    return j[0] * (j[4] * j[8] - j[5] * j[7]) - j[1] * (j[3] * j[8] - j[5] * j[6]) +
           j[2] * (j[3] * j[7] - j[4] * j[6]);
}

static double apart(const double *a, const double *b)
{
    return sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) +
                (a[2] - b[2]) * (a[2] - b[2]));
}

// The mean of the determinant over a cage: where it falls to a twentieth of that, parameters are
// not determined well by points.
static double mean_determinant(const sf_limit *limit)
{
    double sum = 0;
    for (int i = 0; i < 500; i++) {
        sf_place place = {test_random_below((uint32_t)sf_limit_piece_count(limit)), {0, 0, 0}};
        double x[3], j[9];
        for (int axis = 0; axis < 3; axis++) {
            place.u[axis] = test_random_unit();
        }
        CHECK_EQ(sf_limit_positions(limit, 1, &place, NULL, NULL, x, j), SF_OK);
        sum += determinant(j) / 500;
    }
    return sum;
}

static void points_of_places_are_found(void)
{
    double worst = 0, slip = 0;
    int compared = 0;
    for (int kind = 0; kind < KINDS; kind++) {
        test_cage c = kind_of(kind);
        sf_limit *limit = limit_of(&c, SF_REFINE_STANDARD);
        sf_locator *locator = locator_of(limit);
        double mean = mean_determinant(limit);
        for (int i = 0; i < 400; i++) {
            sf_place place = random_place(limit), found;
            double x[3], j[9], again[3], distance;
            CHECK_EQ(sf_limit_positions(limit, 1, &place, NULL, NULL, x, j), SF_OK);
            CHECK_EQ(sf_locator_find(locator, 1, x, 0, NULL, NULL, &found, &distance), SF_OK);
            CHECK(found.piece != SF_NO_PIECE);
            if (found.piece == SF_NO_PIECE) {
                continue;
            }
            CHECK_EQ(sf_limit_positions(limit, 1, &found, NULL, NULL, again, NULL), SF_OK);
            worst = fmax(worst, apart(x, again));
            CHECK_NEAR(distance, apart(x, again), 1e-9);
            if (determinant(j) > 0.05 * mean && place.piece == found.piece) {
                slip = fmax(slip, apart(place.u, found.u));
                compared++;
            }
        }
        sf_locator_destroy(locator);
        sf_limit_destroy(limit);
        test_cage_free(&c);
    }
    printf("# at most %.2g apart, of cages of size 1 to 3\n", worst);
    printf("# parameters of %d places at most %.2g apart\n", compared, slip);
    CHECK(worst <= 1e-7 && slip <= 1e-6 && compared > 500);
}

static void outside_the_nearest_is_found_within_reach(void)
{
    enum { SAMPLES = 20000 };
    static sf_place places[SAMPLES];
    static double surface[3 * SAMPLES];
    test_cage c = test_cage_wheel(5, 2, 0);
    sf_limit *limit = limit_of(&c, SF_REFINE_STANDARD);
    sf_locator *locator = locator_of(limit);
    for (int i = 0; i < SAMPLES; i++) {
        places[i] = random_place(limit);
        places[i].u[test_random_below(3)] = test_random_below(2);
    }
    CHECK_EQ(sf_limit_positions(limit, SAMPLES, places, NULL, NULL, surface, NULL), SF_OK);
    int within = 0;
    for (int i = 0; i < 200; i++) {
        double x[3] = {3 * test_random_unit() - 1.5, 3 * test_random_unit() - 1.5,
                       4 * test_random_unit() - 1};
        double nearest = INFINITY, distance = NAN, reach = 0.3, none = NAN;
        sf_place found;
        CHECK_EQ(sf_locator_find(locator, 1, x, 0, NULL, NULL, &found, &none), SF_OK);
        if (found.piece != SF_NO_PIECE) {
            continue; // inside
        }
        CHECK(none == INFINITY);
        for (int j = 0; j < SAMPLES; j++) {
            nearest = fmin(nearest, apart(x, surface + 3 * j));
        }
        CHECK_EQ(sf_locator_find(locator, 1, x, reach, NULL, NULL, &found, &distance), SF_OK);
        if (nearest <= reach) {
            CHECK(found.piece != SF_NO_PIECE && distance <= nearest + 0.02);
            within++;
        } else if (nearest > reach + 0.05) { // samples are a little apart
            CHECK(found.piece == SF_NO_PIECE && distance == INFINITY);
        }
    }
    CHECK(within > 20);
    sf_locator_destroy(locator);
    sf_limit_destroy(limit);
    test_cage_free(&c);
}

// A solid that is folded onto a line: every point of that is the same in a whole plane of
// parameters, Newton's method has nowhere to go, and halving has no end. The search has one.
static void what_is_folded_flat_takes_no_for_an_answer(void)
{
    test_cage c = kind_of(0);
    for (size_t i = 0; i < c.points; i++) {
        c.positions[3 * i + 1] = c.positions[3 * i + 2] = 0;
    }
    sf_limit *limit = limit_of(&c, SF_REFINE_STANDARD);
    sf_locator *locator = locator_of(limit);
    for (int i = 0; i < 5; i++) {
        sf_place place = {77, {0, 0, 0}};
        const double x[3] = {0.7123 + 0.3 * i, 0, 0};
        CHECK_EQ(sf_locator_find(locator, 1, x, 0.1, NULL, NULL, &place, NULL), SF_OK);
        CHECK(place.piece != 77);
    }
    sf_locator_destroy(locator);
    sf_limit_destroy(limit);
    test_cage_free(&c);
}

static void what_cannot_be_asked_is_refused(void)
{
    test_cage c = kind_of(0), flat = test_cage_begin(2, 4, 1, 4);
    for (uint32_t i = 0; i < 4; i++) {
        flat.corners[i] = i;
    }
    sf_limit *limit = limit_of(&c, SF_REFINE_STANDARD), *surface = limit_of(&flat, 0);
    sf_locator *locator = locator_of(limit), *none = NULL;
    CHECK_EQ(sf_locator_create(surface, NULL, &none), SF_ERR_UNSUPPORTED);
    CHECK_EQ(sf_locator_create(NULL, NULL, &none), SF_ERR_ARGUMENT);
    sf_place place = {77, {0, 0, 0}};
    double x[3] = {1, 1, 1}, nowhere[3] = {NAN, 0, 0};
    CHECK_EQ(sf_locator_find(locator, 1, nowhere, 0, NULL, NULL, &place, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_locator_find(locator, 1, x, -1, NULL, NULL, &place, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_locator_find(locator, 1, x, INFINITY, NULL, NULL, &place, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_locator_find(locator, 1, NULL, 0, NULL, NULL, &place, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_locator_find(locator, 0, NULL, 0, NULL, NULL, NULL, NULL), SF_OK);
    sf_task task = sf_task_default();
    sf_task_cancel(&task);
    CHECK_EQ(sf_locator_find(locator, 1, x, 0, NULL, &task, &place, NULL), SF_ERR_CANCELLED);
    failing_allocator memory;
    failing_begin(&memory, 0);
    CHECK_EQ(sf_locator_find(locator, 1, x, 0, &memory.allocator, NULL, &place, NULL),
             SF_ERR_MEMORY);
    CHECK_EQ(place.piece, 77);
    for (long k = 0;; k++) {
        failing_begin(&memory, k);
        sf_status status = sf_locator_create(limit, &memory.allocator, &none);
        sf_locator_destroy(none);
        none = NULL;
        CHECK(memory.live == 0 && memory.faults == 0);
        if (status == SF_OK) {
            break;
        }
        CHECK_EQ(status, SF_ERR_MEMORY);
    }
    sf_locator_destroy(locator);
    sf_locator_destroy(NULL);
    sf_limit_destroy(limit);
    sf_limit_destroy(surface);
    test_cage_free(&flat);
    test_cage_free(&c);
}

int main(void)
{
    TEST(points_of_places_are_found);
    TEST(outside_the_nearest_is_found_within_reach);
    TEST(what_is_folded_flat_takes_no_for_an_answer);
    TEST(what_cannot_be_asked_is_refused);
    return test_finish();
}
