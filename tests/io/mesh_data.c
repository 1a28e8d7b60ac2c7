// The meshes of shared/data, made by many programs: each gives the number of triangles that was
// counted by another reader, and of those in broken/ only the three that hold no shape are refused,
// with a line or a byte. Guards: issue 2 (broken/, TRUTH.md). The procedural twins are in mesh_read
// and mesh_refuse.

#include <sf/io.h>

#include "test.h"

static const struct {
    const char *path;
    size_t triangles; // 0: must be refused
} meshes[] = {
    {"characters/human_man.obj", 13776},
    {"characters/koala_low_resolution.obj", 7116},
    {"characters/penguin_hr.obj", 26880},
    {"characters/spot_low_resolution.obj", 1654},
    {"characters/armadillo.obj", 86482},
    {"characters/horse.ply", 96966},
    {"characters/spheres_outer.stl", 12080},
    {"characters/stanford-bunny.obj", 69451},
    {"parts/20mmbox-CRLF.stl", 12},
    {"parts/20mmbox-LF.stl", 12},
    {"parts/20mmbox-nonstandard.stl", 12},
    {"parts/A_upsidedown.obj", 1246},
    {"parts/U_overhang.obj", 28},
    {"parts/V_standing.obj", 24},
    {"parts/angle_block.STL", 704},
    {"parts/cube_with_concave_hole_enlarged_standing.obj", 48},
    {"parts/frog_legs.obj", 18334},
    {"parts/ksr_fdmtest_v4.stl", 12234},
    {"parts/teapot.stl", 894},
    {"slices/pyphotonfile_reference.stl", 7932},
    {"cages/catmark_cube.obj", 12},
    {"cages/catmark_cube_creases0.obj", 12},
    {"cages/catmark_cube_creases0_level2.obj", 768},
    {"cages/catmark_tent_creases0.obj", 18},
    {"cages/catmark_tent_creases0_level2.obj", 1152},
    {"cages/spot_control_mesh.obj", 372},
    {"broken/bad-stl-tardis.stl", 3636},
    {"broken/block-fill-holes-bad.stl", 11},
    {"broken/block-good.stl", 12},
    {"broken/block-nearby-bad.stl", 12},
    {"broken/block-normal-directions-bad.stl", 12},
    {"broken/block-remove-unconnected-bad.stl", 25},
    {"broken/block-remove-unconnected-good.stl", 24},
    {"broken/cubes-touching.stl", 24},
    {"broken/many_small_holes.ply", 3524},
    {"broken/non_manif_hole.ply", 755},
    {"broken/nonmanifold.stl", 11},
    {"broken/self_intersectA.obj", 17160},
    {"broken/soup.stl", 100},
    {"broken/empty2.stl", 0},
    {"broken/inf_nan.obj", 0},
    {"broken/invalidvertex.stl", 0},
};

static sf_status file_read(void *user, void *data, size_t capacity, size_t *size)
{
    *size = fread(data, 1, capacity, user);
    return ferror((FILE *)user) ? SF_ERR_IO : SF_OK;
}

static int read_one(const char *folder, const char *path, size_t triangles)
{
    char name[1024];
    snprintf(name, sizeof name, "%s/%s", folder, path);
    FILE *file = fopen(name, "rb");
    if (file == NULL) {
        printf("# %s is not there\n", name);
        return 0;
    }
    sf_source source = {file_read, file};
    sf_mesh *mesh = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_status status = sf_mesh_read(source, SF_MESH_FORMAT_AUTO, NULL, NULL, &mesh, &fault);
    size_t found = sf_mesh_get_view(mesh).triangle_count;
    int good = triangles > 0 ? status == SF_OK && found == triangles
                             : status == SF_ERR_FORMAT && (fault.line > 0 || fault.offset > 0);
    if (!good) {
        printf("# %s: %s, %zu triangles instead of %zu, \"%s\"\n", path, sf_status_name(status),
               found, triangles, fault.message);
    }
    sf_mesh_destroy(mesh);
    fclose(file);
    return good;
}

static void reads_the_data(void)
{
    const char *folder = getenv("SF_DATA");
    if (folder == NULL) {
        SKIP("SF_DATA is not set");
    }
    for (size_t i = 0; i < sizeof meshes / sizeof meshes[0]; i++) {
        CHECK(read_one(folder, meshes[i].path, meshes[i].triangles));
    }
}

int main(void)
{
    TEST(reads_the_data);
    return test_finish();
}
