// SPDX-License-Identifier: MIT
// Why: a printer is told by these pictures what goes where. Layers of random materials, of all
// numbers of them, are written and read back as a stack: solid where a material is; the pixels
// themselves are held by the tests of the command line, in another language. The table's voxels,
// mm3 and grams are counted here once more. Promises: stack.json comes last, so a folder without it
// is no stack; what fails leaves none; names that need quoting are quoted.

#include <sf/layers.h>

#include "failing_allocator.h"
#include "stack_files.h"

enum { NX = 21, NY = 13, NZ = 5 };

static const sf_lattice lattice = {NX, NY, NZ, 0.04, 0.08, 0.03, NULL, {1, 2, 3}};

static sf_material material(uint32_t i)
{
    sf_material m = {"", {(uint8_t)(40 * i), 200, (uint8_t)i}, i % 3 == 0 ? 0 : 1.0 + 0.25 * i};
    snprintf(m.name, sizeof m.name, i == 1 ? "\"hard\\%u" : "material %u", (unsigned)i);
    return m;
}

static void fill(uint8_t *ids, uint32_t materials)
{
    for (int i = 0; i < NX * NY * NZ; i++) {
        ids[i] = (uint8_t)test_random_below(materials + 1);
    }
}

static sf_status write(sf_folder folder, uint32_t count, const uint8_t *ids,
                       const sf_allocator *allocator, sf_material_use *uses)
{
    sf_material materials[SF_MATERIAL_MAX];
    sf_layers *layers = NULL;
    for (uint32_t i = 0; i < count; i++) {
        materials[i] = material(i);
    }
    sf_status status =
        sf_layers_begin(folder, &lattice, count, materials, allocator, &layers, NULL);
    for (uint32_t k = 0; status == SF_OK && k < NZ; k++) {
        status = sf_layers_add(layers, ids + k * NX * NY, NX, NULL);
    }
    if (status == SF_OK) {
        status = sf_layers_finish(layers, uses, NULL);
    }
    sf_layers_end(layers);
    return status;
}

static void layers_are_read_back_as_what_is_solid(void)
{
    if (!sf_stack_has_png()) {
        SKIP("this build writes no PNG");
    }
    for (uint32_t count = 1; count <= SF_MATERIAL_MAX; count++) {
        static uint8_t ids[NX * NY * NZ];
        memory_folder memory;
        sf_folder folder = memory_begin_folder(&memory);
        sf_material_use uses[SF_MATERIAL_MAX];
        fill(ids, count);
        CHECK_EQ(write(folder, count, ids, NULL, uses), SF_OK);
        CHECK_EQ(memory.count, NZ + 1);
        CHECK_STR(memory.files[NZ].name, "stack.json"); // last
        for (uint32_t i = 0; i < count; i++) {
            uint64_t voxels = 0;
            for (int j = 0; j < NX * NY * NZ; j++) {
                voxels += ids[j] == i + 1;
            }
            CHECK_EQ(uses[i].voxels, voxels);
            CHECK_NEAR(uses[i].volume_mm3, (double)voxels * 0.04 * 0.08 * 0.03, 1e-12);
            CHECK_NEAR(uses[i].mass_g, uses[i].volume_mm3 * material(i).density_g_cm3 / 1000,
                       1e-12);
        }
        sf_grid *grid = NULL;
        sf_fault fault = {0};
        sf_status status = sf_stack_read(folder, NULL, NULL, &grid, NULL, &fault);
        if (status == SF_ERR_UNSUPPORTED) {
            memory_end_folder(&memory);
            SKIP("this build reads no stacks");
        }
        CHECK_EQ(status, SF_OK);
        for (uint32_t k = 0; status == SF_OK && k < NZ; k++) {
            sf_slice s = sf_grid_slice(grid, k);
            for (uint32_t i = 0; i < NX * NY; i++) {
                uint32_t x = i % NX, y = i / NX;
                CHECK_EQ(s.words[y * s.stride] >> x & 1, ids[k * NX * NY + i] != 0);
            }
        }
        sf_grid_destroy(grid);
        CHECK_EQ(memory.faults, 0);
        memory_end_folder(&memory);
    }
}

static void the_table_is_json(void)
{
    static uint8_t ids[NX * NY * NZ];
    memory_folder memory;
    sf_folder folder = memory_begin_folder(&memory);
    if (!sf_stack_has_png()) {
        SKIP("this build writes no PNG");
    }
    ids[0] = 2;
    CHECK_EQ(write(folder, 3, ids, NULL, NULL), SF_OK);
    char text[4096] = "";
    const memory_file *file = memory_find(&memory, "stack.json");
    CHECK(file != NULL && file->size < sizeof text);
    memcpy(text, file->bytes, file->size);
    CHECK(strstr(text, "\"version\": 3") != NULL);
    CHECK(strstr(text, "{\"index\": 2, \"name\": \"\\\"hard\\\\1\", \"colour\": \"#28c801\", "
                       "\"density_g_cm3\": 1.25,\n     \"voxels\": 1, \"volume_mm3\": ") != NULL);
    CHECK(strstr(text, "\"density_g_cm3\": null,\n     \"voxels\": 0, \"volume_mm3\": 0, "
                       "\"grams\": null}") != NULL);
    memory_end_folder(&memory);
}

static void what_fails_leaves_no_stack(void)
{
    static uint8_t ids[NX * NY * NZ];
    if (!sf_stack_has_png()) {
        SKIP("this build writes no PNG");
    }
    fill(ids, 4);
    for (long budget = 0;; budget += 97) {
        memory_folder memory;
        sf_folder folder = memory_begin_folder(&memory);
        memory.budget = budget;
        sf_status status = write(folder, 4, ids, NULL, NULL);
        CHECK((status == SF_OK) == (memory_find(&memory, "stack.json") != NULL));
        CHECK(status == SF_OK || status == SF_ERR_IO);
        CHECK_EQ(memory.faults, 0);
        memory_end_folder(&memory);
        if (status == SF_OK) {
            break;
        }
    }
    for (long k = 0; k < 3; k++) {
        memory_folder memory;
        failing_allocator none;
        sf_folder folder = memory_begin_folder(&memory);
        failing_begin(&none, k);
        sf_status status = write(folder, 4, ids, &none.allocator, NULL);
        CHECK_EQ(status, k < 2 ? SF_ERR_MEMORY : SF_OK);
        CHECK(none.live == 0 && none.faults == 0);
        memory_end_folder(&memory);
    }
}

static void what_cannot_be_is_refused(void)
{
    static uint8_t ids[NX * NY];
    memory_folder memory;
    sf_folder folder = memory_begin_folder(&memory);
    sf_material two[2] = {material(1), material(1)};
    sf_layers *layers = NULL;
    sf_fault fault = {0};
    if (!sf_stack_has_png()) {
        SKIP("this build writes no PNG");
    }
    CHECK_EQ(sf_layers_begin(folder, &lattice, 2, two, NULL, &layers, &fault), SF_ERR_ARGUMENT);
    CHECK(strstr(fault.message, "material 1 has the name of another") != NULL);
    two[1] = material(2);
    two[1].density_g_cm3 = NAN;
    CHECK_EQ(sf_layers_begin(folder, &lattice, 2, two, NULL, &layers, &fault), SF_ERR_ARGUMENT);
    two[1].density_g_cm3 = 1;
    memset(two[1].name, 'x', sizeof two[1].name);
    CHECK_EQ(sf_layers_begin(folder, &lattice, 2, two, NULL, &layers, &fault), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_layers_begin(folder, &lattice, 0, two, NULL, &layers, &fault), SF_ERR_ARGUMENT);
    two[1] = material(2);
    CHECK_EQ(sf_layers_begin(folder, &lattice, 2, two, NULL, &layers, &fault), SF_OK);
    CHECK_EQ(sf_layers_add(layers, ids, NX - 1, &fault), SF_ERR_ARGUMENT);
    ids[NX] = 3;
    CHECK_EQ(sf_layers_add(layers, ids, NX, &fault), SF_ERR_ARGUMENT);
    CHECK(strstr(fault.message, "layer 0 names material 2") != NULL);
    CHECK_EQ(sf_layers_finish(layers, NULL, &fault), SF_ERR_ARGUMENT);
    CHECK_EQ(memory.count, 0);
    ids[NX] = 2;
    for (int k = 0; k < NZ; k++) {
        CHECK_EQ(sf_layers_add(layers, ids, NX, &fault), SF_OK);
    }
    CHECK_EQ(sf_layers_add(layers, ids, NX, &fault), SF_ERR_ARGUMENT);
    sf_layers_end(layers);
    sf_layers_end(NULL);
    memory_end_folder(&memory);
}

int main(void)
{
    TEST(layers_are_read_back_as_what_is_solid);
    TEST(the_table_is_json);
    TEST(what_fails_leaves_no_stack);
    TEST(what_cannot_be_is_refused);
    return test_finish();
}
