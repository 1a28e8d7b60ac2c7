// SPDX-License-Identifier: MIT
// Bottles on their way to standing, with handles on their axes.

#ifndef SF_TEST_BALANCE_STANDING_H
#define SF_TEST_BALANCE_STANDING_H

#include "bottle.h"

#include <sf/stand.h>

// Handles on the axis of a bottle: a third up, two thirds, and the neck.
static inline size_t handles_of(double lean, sf_handle *handles)
{
    for (int j = 0; j < 3; j++) {
        double z = 16 + 13 * j;
        sf_handle h = {.kind = SF_HANDLE_POINT, .at_mm = {lean * z, 0, z}};
        handles[j] = h;
    }
    return 3;
}

static inline sf_stand_options options_of(int deform, sf_carve_mode mode)
{
    sf_stand_options o = sf_stand_options_default();
    o.pitch_mm = 1;
    o.wall_mm = 1.2;
    o.deform = deform;
    o.carve_mode = mode;
    return o;
}

static inline sf_stand *make(double lean, const sf_stand_options *o, size_t stance_count,
                             const sf_stance_options *stances)
{
    sf_handle handles[3];
    sf_stand *stand = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_mesh *mesh = bottle(lean);
    sf_status status = sf_stand_create(sf_mesh_get_view(mesh), stances, stance_count, handles,
                                       handles_of(lean, handles), o, NULL, NULL, &stand, &fault);
    CHECK_EQ(status, SF_OK);
    if (status != SF_OK) {
        printf("# %s\n", fault.message);
    }
    sf_mesh_destroy(mesh);
    return stand;
}

#endif
