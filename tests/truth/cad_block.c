// SPDX-License-Identifier: MIT
// Why: mass, centre of mass and inertia are what everything about balance rests on. A block from a
// CAD system must have the figures of the CAD system, within the tolerance that their source states
// (the volumes of other meshes: io mesh_data). Procedural twin: unit/mesh measure.

#include "data_file.h"

// SolidWorks, by way of trimesh: density 0.036127, tolerance 1e-2.
static void the_angle_block(void)
{
    const double density = 0.036127, com[3] = {0, 0.436105, -0.599006};
    const double inertia[6] = {0.008312, 0.012823, 0.009005, 0, 0, -0.000807};
    sf_mass mass;
    if (getenv("SF_DATA") == NULL) {
        SKIP("SF_DATA is not set");
    }
    sf_mesh *mesh = data_mesh("parts/angle_block.STL");
    CHECK_EQ(sf_mesh_measure(sf_mesh_get_view(mesh), &mass), SF_OK);
    CHECK_NEAR(mass.area_mm2, 9.388587, 1e-2 * 9.388587);
    CHECK_NEAR(density * mass.volume_mm3, 0.041358, 1e-2 * 0.041358);
    for (int i = 0; i < 3; i++) {
        CHECK_NEAR(mass.com_mm[i], com[i], 1e-2);
        CHECK_NEAR(density * mass.inertia_mm5[i], inertia[i], 1e-2 * inertia[i]);
    }
    CHECK_NEAR(fabs(density * mass.inertia_mm5[5]), -inertia[5], 1e-2 * -inertia[5]);
    sf_mesh_destroy(mesh);
}

int main(void)
{
    TEST(the_angle_block);
    return test_finish();
}
