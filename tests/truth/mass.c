// Why: volume, centre of mass and inertia are what everything about balance rests on. Meshes of
// many sources must give the figures that independent tools gave (MANIFEST.tsv and TRUTH.md beside
// the data), within 1e-6 of the volume and of the box's diagonal; a block from a CAD system those
// of the CAD system, within the tolerance that its source states. Procedural twin: unit/mesh
// measure.

#include "data_file.h"

enum { COLUMNS = 13, LINE = 8192 };

// Split a line at its tabs; returns how many columns there are.
static int split(char *line, char *columns[COLUMNS])
{
    int count = 0;
    for (char *at = line; at != NULL && count < COLUMNS; count++) {
        columns[count] = at;
        at = strchr(at, '\t');
        if (at != NULL) {
            *at++ = '\0';
        }
    }
    return count;
}

static double diagonal(sf_mesh_view view)
{
    double low[3] = {0, 0, 0}, high[3] = {0, 0, 0}, sum = 0;
    CHECK_EQ(sf_mesh_bounds(view, low, high), SF_OK);
    for (int i = 0; i < 3; i++) {
        sum += (high[i] - low[i]) * (high[i] - low[i]);
    }
    return sqrt(sum);
}

static void compare(const char *path, double volume, const double com[3])
{
    sf_mesh *mesh = data_mesh(path);
    sf_mass mass;
    if (mesh == NULL) {
        return;
    }
    sf_mesh_view view = sf_mesh_get_view(mesh);
    double size = diagonal(view);
    CHECK_EQ(sf_mesh_measure(view, &mass), SF_OK);
    CHECK_NEAR(mass.volume_mm3, volume, 1e-6 * fabs(volume));
    for (int i = 0; i < 3 && com != NULL; i++) {
        CHECK_NEAR(mass.com_mm[i], com[i], 1e-6 * size);
    }
    printf("# %s: volume off by %.1e\n", path, fabs(mass.volume_mm3 / volume - 1));
    sf_mesh_destroy(mesh);
}

static int is_mesh_file(const char *path)
{
    return sf_mesh_format_from_name(path) != SF_MESH_FORMAT_AUTO;
}

// Every closed mesh of the manifest whose volume and centre of mass it states.
static void the_manifest(void)
{
    char name[1024], line[LINE], *columns[COLUMNS];
    int compared = 0;
    if (getenv("SF_DATA") == NULL) {
        SKIP("SF_DATA is not set");
    }
    snprintf(name, sizeof name, "%s/MANIFEST.tsv", getenv("SF_DATA"));
    FILE *manifest = fopen(name, "r");
    CHECK(manifest != NULL);
    while (manifest != NULL && fgets(line, sizeof line, manifest) != NULL) {
        double volume, com[3];
        if (split(line, columns) < COLUMNS - 2 || !is_mesh_file(columns[0]) ||
            strncmp(columns[7], "closed", 6) != 0 ||
            strstr(columns[7], "consistent winding True") == NULL ||
            sscanf(columns[9], "%lf", &volume) != 1) {
            continue;
        }
        int has_com = sscanf(columns[10], "(%lf,%lf,%lf)", &com[0], &com[1], &com[2]) == 3;
        compare(columns[0], volume, has_com ? com : NULL);
        compared++;
    }
    if (manifest != NULL) {
        fclose(manifest);
    }
    CHECK(compared >= 10);
}

static void truth(void)
{
    static const double spheres[3] = {0.497724, 0.413541, 0.607710};
    if (getenv("SF_DATA") == NULL) {
        SKIP("SF_DATA is not set");
    }
    compare("characters/armadillo.obj", 0.0686186938, NULL);
    compare("characters/spheres_outer.stl", 0.1010587300, spheres);
    compare("parts/20mmbox-CRLF.stl", 8000, NULL);
    compare("broken/block-good.stl", 61.0237453, NULL);
    compare("slices/pyphotonfile_reference.stl", 1850.9844, NULL);
}

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
    TEST(the_manifest);
    TEST(truth);
    TEST(the_angle_block);
    return test_finish();
}
