// SPDX-License-Identifier: MIT
// Why: a handle is put behind a point of a surface by whoever can cast rays. Of lists of hits the
// middle is known by hand; overlapping shells are one solid; and a caster that fails, ends or lies
// leaves the place untouched. Guards: issue 8 part 4 (picking for handles).

#include <sf/handles.h>

#include "test.h"

typedef struct list {
    sf_ray_hit hits[8];
    int count, calls;
    sf_status says;
} list;

static sf_status next(void *user, const double from_mm[3], const double direction[3], double beyond,
                      sf_ray_hit *hit, int *found)
{
    list *l = user;
    (void)from_mm;
    (void)direction;
    l->calls++;
    *found = 0;
    for (int i = 0; i < l->count && !*found; i++) {
        if (l->hits[i].along > beyond) {
            *hit = l->hits[i];
            *found = 1;
        }
    }
    return l->says;
}

// The stretch's middle, in lengths of the direction; -1 where it is refused as leading nowhere.
static double middle_of(list l)
{
    sf_ray_caster caster = {next, &l};
    double from[3] = {1, 2, 3}, direction[3] = {0, -2, 0}, at[3] = {7, 7, 7};
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_status status = sf_handle_center_by_rays(caster, from, direction, at, &fault);
    if (status == SF_ERR_INFEASIBLE) {
        CHECK(at[0] == 7 && at[1] == 7 && at[2] == 7 && strstr(fault.message, "ray") != NULL);
        return -1;
    }
    CHECK_EQ(status, SF_OK);
    CHECK(at[0] == 1 && at[2] == 3);
    return (at[1] - 2) / -2;
}

static void stretches_end_where_the_solid_does(void)
{
    list plain = {{{1, 0, 0}, {4, 1, 1}, {6, 2, 0}, {9, 3, 1}}, 4, 0, SF_OK};
    list inside = {{{4, 1, 1}, {6, 2, 0}, {9, 3, 1}}, 3, 0, SF_OK};
    list shells = {{{1, 0, 0}, {2, 1, 0}, {4, 2, 1}, {9, 3, 1}}, 4, 0, SF_OK};
    list open = {{{1, 0, 0}}, 1, 0, SF_OK};
    list none = {{{0, 0, 0}}, 0, 0, SF_OK};
    CHECK_NEAR(middle_of(plain), 2.5, 1e-15);
    CHECK_NEAR(middle_of(inside), 2, 1e-15);
    CHECK_NEAR(middle_of(shells), 5, 1e-15);
    CHECK(middle_of(open) == -1);
    CHECK(middle_of(none) == -1);
}

static sf_status goes_back(void *user, const double from_mm[3], const double direction[3],
                           double beyond, sf_ray_hit *hit, int *found)
{
    (void)user;
    (void)from_mm;
    (void)direction;
    hit->along = beyond;
    *found = 1;
    return SF_OK;
}

static sf_status never_leaves(void *user, const double from_mm[3], const double direction[3],
                              double beyond, sf_ray_hit *hit, int *found)
{
    (void)from_mm;
    (void)direction;
    hit->along = beyond + 1;
    hit->leaves = 0;
    *found = 1;
    ++*(long *)user;
    return SF_OK;
}

static void casters_are_not_trusted(void)
{
    list broken = {{{1, 0, 0}}, 1, 0, SF_ERR_MEMORY};
    long calls = 0;
    sf_ray_caster fails = {next, &broken}, back = {goes_back, NULL},
                  no_end = {never_leaves, &calls};
    sf_ray_caster none = {NULL, NULL};
    double from[3] = {1, 2, 3}, direction[3] = {0, 0, 1}, at[3] = {7, 7, 7};
    double nowhere[3] = {0, 0, 0}, nan[3] = {0, NAN, 1};
    CHECK_EQ(sf_handle_center_by_rays(fails, from, direction, at, NULL), SF_ERR_MEMORY);
    CHECK_EQ(sf_handle_center_by_rays(back, from, direction, at, NULL), SF_ERR_INTERNAL);
    CHECK_EQ(sf_handle_center_by_rays(no_end, from, direction, at, NULL), SF_ERR_INFEASIBLE);
    CHECK_EQ(calls, 100000);
    CHECK_EQ(sf_handle_center_by_rays(none, from, direction, at, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_handle_center_by_rays(fails, nan, direction, at, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_handle_center_by_rays(fails, from, nowhere, at, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_handle_center_by_rays(fails, NULL, direction, at, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_handle_center_by_rays(fails, from, direction, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK(at[0] == 7 && at[1] == 7 && at[2] == 7);
}

int main(void)
{
    TEST(stretches_end_where_the_solid_does);
    TEST(casters_are_not_trusted);
    return test_finish();
}
