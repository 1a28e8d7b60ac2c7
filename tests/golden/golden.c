// SPDX-License-Identifier: MIT
// The golden vectors that C, Python and Rust share (make.py): what a few lines of another language
// say of small shapes is what the library says.

#include "test.h"

#include <jansson.h>
#include <math.h>

#include <sf/mesh.h>
#include <sf/stance.h>
#include <sf/support.h>

static const char *path, *bodies_path;

static sf_grid *read_grid(const json_t *one, const char *key)
{
    const json_t *size = json_object_get(one, "size");
    const char *text = json_string_value(json_object_get(one, key));
    sf_lattice l = {0, 0, 0, 1, 1, 1, NULL, {0, 0, 0}};
    sf_grid *grid = NULL;
    l.nx = (uint32_t)json_integer_value(json_array_get(size, 0));
    l.ny = (uint32_t)json_integer_value(json_array_get(size, 1));
    l.nz = (uint32_t)json_integer_value(json_array_get(size, 2));
    CHECK(sf_grid_create(&l, NULL, &grid) == SF_OK);
    for (size_t i = 0; text[i] != '\0'; i++) {
        size_t x = i % l.nx, y = i / l.nx % l.ny, k = i / l.nx / l.ny;
        CHECK(sf_slice_set(sf_grid_slice(grid, (uint32_t)k), (uint32_t)x, (uint32_t)y,
                           text[i] == '1') == SF_OK);
    }
    return grid;
}

static void check_case(const json_t *one)
{
    sf_grid *grid = read_grid(one, "voxels"), *trimmed = read_grid(one, "trimmed");
    sf_grid *unsupported = read_grid(one, "unsupported"), *found = NULL;
    const json_t *bounds = json_object_get(one, "bounds");
    const sf_rule rule = sf_rule_box3();
    sf_lattice l = sf_grid_lattice(grid);
    sf_terms terms = sf_terms_default();
    sf_box b = sf_grid_bounds(grid);
    const uint32_t ends[6] = {b.x0, b.y0, b.z0, b.x1, b.y1, b.z1};
    terms.bed_layer = 0;
    CHECK_EQ(sf_grid_popcount(grid), (uint64_t)json_integer_value(json_object_get(one, "count")));
    for (size_t i = 0; i < 6; i++) {
        CHECK_EQ(ends[i], (uint32_t)json_integer_value(json_array_get(bounds, i)));
    }
    CHECK(sf_grid_create(&l, NULL, &found) == SF_OK);
    CHECK(sf_grid_unsupported(grid, &terms, NULL, NULL, found, NULL) == SF_OK);
    CHECK(sf_grid_equal(found, unsupported));
    CHECK(sf_grid_trim(grid, &rule, 0, NULL, NULL) == SF_OK);
    CHECK(sf_grid_equal(grid, trimmed));
    CHECK_EQ(sf_grid_popcount(grid), (uint64_t)json_integer_value(json_object_get(one, "kept")));
    sf_grid_destroy(grid);
    sf_grid_destroy(trimmed);
    sf_grid_destroy(unsupported);
    sf_grid_destroy(found);
}

static void all_cases(void)
{
    json_t *file = json_load_file(path, 0, NULL);
    const json_t *cases = json_object_get(file, "cases");
    CHECK(json_array_size(cases) == 45);
    for (size_t i = 0; i < json_array_size(cases); i++) {
        check_case(json_array_get(cases, i));
    }
    json_decref(file);
}

static double number_in(const json_t *one, const char *key, size_t i)
{
    return json_number_value(json_array_get(json_object_get(one, key), i));
}

static sf_mesh *read_body(const json_t *one)
{
    const json_t *vertices = json_object_get(one, "vertices");
    const json_t *triangles = json_object_get(one, "triangles");
    sf_mesh *mesh = NULL;
    CHECK(sf_mesh_create(NULL, &mesh) == SF_OK);
    for (size_t v = 0; v < json_array_size(vertices); v++) {
        double xyz[3];
        for (size_t i = 0; i < 3; i++) {
            xyz[i] = json_number_value(json_array_get(json_array_get(vertices, v), i));
        }
        CHECK(sf_mesh_add_vertices(mesh, xyz, 1) == SF_OK);
    }
    for (size_t t = 0; t < json_array_size(triangles); t++) {
        uint32_t corners[3];
        for (size_t i = 0; i < 3; i++) {
            corners[i] =
                (uint32_t)json_integer_value(json_array_get(json_array_get(triangles, t), i));
        }
        CHECK(sf_mesh_add_triangles(mesh, corners, 1) == SF_OK);
    }
    return mesh;
}

static void check_body(const json_t *one)
{
    sf_mesh *mesh = read_body(one);
    const double volume = json_number_value(json_object_get(one, "volume_mm3"));
    const double margin = json_number_value(json_object_get(one, "margin_rad"));
    sf_stance_options options = sf_stance_options_default();
    sf_stance *stance = NULL;
    sf_stance_verdict verdict;
    sf_mass mass;
    CHECK(sf_mesh_measure(sf_mesh_get_view(mesh), &mass) == SF_OK);
    CHECK_NEAR(mass.volume_mm3, volume, 1e-12 * volume);
    for (size_t i = 0; i < 3; i++) {
        CHECK_NEAR(mass.com_mm[i], number_in(one, "com_mm", i), 1e-12);
    }
    for (size_t i = 0; i < 6; i++) {
        CHECK_NEAR(mass.inertia_mm5[i], number_in(one, "inertia_mm5", i), 1e-9);
    }
    CHECK(sf_stance_create(sf_mesh_get_view(mesh), &options, NULL, &stance, NULL) == SF_OK);
    CHECK(sf_stance_judge(stance, mass.com_mm, &verdict) == SF_OK);
    CHECK_NEAR(verdict.margin_rad, margin, 1e-12);
    CHECK(fabs(margin) < 1e-9 || verdict.stands == (margin > 0));
    sf_stance_destroy(stance);
    sf_mesh_destroy(mesh);
}

static void all_bodies(void)
{
    json_t *file = json_load_file(bodies_path, 0, NULL);
    const json_t *cases = json_object_get(file, "cases");
    CHECK(json_array_size(cases) == 39);
    for (size_t i = 0; i < json_array_size(cases); i++) {
        check_body(json_array_get(cases, i));
    }
    json_decref(file);
}

int main(int argc, char **argv)
{
    path = argc > 1 ? argv[1] : "box3.json";
    bodies_path = argc > 2 ? argv[2] : "tetrahedra.json";
    TEST(all_cases);
    TEST(all_bodies);
    return test_finish();
}
