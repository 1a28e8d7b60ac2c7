// SPDX-License-Identifier: MIT
// Why: <sf/voxel.h> promises once, for the whole library, that bits past the width are ignored on
// entry and zero in whatever a call has written (TRUST 31). A host that maps its own buffers cannot
// know what stands there. So every public call that takes a slice or a grid is made twice, with
// padding of zeros and with padding of ones, and must say and write the same.

#include "../io/stack_files.h"
#include "twins.h"

#include <sf/io.h>
#include <sf/mesh.h>

// --- slices --------------------------------------------------------------------------------------

typedef sf_status (*combination)(sf_slice dst, sf_slice a, sf_slice b);

// dst, a, b are layers 2, 0, 1.
static void slices_combine(twins t)
{
    static const combination all[] = {sf_slice_and, sf_slice_or, sf_slice_xor, sf_slice_subtract};
    sf_slice to = sf_grid_slice(t.clean, 2), out = sf_grid_slice(t.soiled, 2);
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        CHECK_EQ(all[i](to, sf_grid_slice(t.clean, 0), sf_grid_slice(t.clean, 1)), SF_OK);
        CHECK_EQ(all[i](out, sf_grid_slice(t.soiled, 0), sf_grid_slice(t.soiled, 1)), SF_OK);
        CHECK(sf_slice_equal(to, out) && is_clean(out));
        soil(out);
    }
    CHECK_EQ(sf_slice_copy(to, sf_grid_slice(t.clean, 0)), SF_OK);
    CHECK_EQ(sf_slice_copy(out, sf_grid_slice(t.soiled, 0)), SF_OK);
    CHECK(sf_slice_equal(to, out) && is_clean(out));
}

static void slices_grow_and_shrink(twins t)
{
    sf_element element = sf_element_box3();
    sf_slice to = sf_grid_slice(t.clean, 2), out = sf_grid_slice(t.soiled, 2);
    sf_slice a = sf_grid_slice(t.clean, 0), b = sf_grid_slice(t.soiled, 0);
    sf_slice a1 = sf_grid_slice(t.clean, 1), b1 = sf_grid_slice(t.soiled, 1);
    for (int i = 0; i < 6; i++) {
        sf_border border = i % 2 == 0 ? SF_BORDER_EMPTY : SF_BORDER_SOLID;
        if (i == 2) {
            element = sf_element_plus3();
        } else if (i == 4) {
            CHECK_EQ(sf_element_ellipse(5 << 16, 3 << 16, &element), SF_OK);
        }
        soil(out);
        CHECK_EQ(sf_slice_dilate(to, a, &element, border), SF_OK);
        CHECK_EQ(sf_slice_dilate(out, b, &element, border), SF_OK);
        CHECK(sf_slice_equal(to, out) && is_clean(out));
        soil(out);
        CHECK_EQ(sf_slice_erode(to, a, &element, border), SF_OK);
        CHECK_EQ(sf_slice_erode(out, b, &element, border), SF_OK);
        CHECK(sf_slice_equal(to, out) && is_clean(out));
        soil(out);
        CHECK_EQ(sf_slice_and_dilate(to, a, a1, &element), SF_OK);
        CHECK_EQ(sf_slice_and_dilate(out, b, b1, &element), SF_OK);
        CHECK(sf_slice_equal(to, out) && is_clean(out));
    }
}

static void slices_tell(twins t)
{
    static sf_run runs[2][STACK_VOXELS];
    sf_slice a = sf_grid_slice(t.clean, 0), b = sf_grid_slice(t.soiled, 0);
    sf_slice_sums p, q;
    size_t n[2] = {0, 0};
    CHECK(sf_slice_equal(a, b));
    CHECK_EQ(sf_slice_popcount(a), sf_slice_popcount(b));
    sf_rect r = sf_slice_bounds(a), s = sf_slice_bounds(b);
    CHECK(memcmp(&r, &s, sizeof r) == 0);
    CHECK_EQ(sf_slice_measure(a, &p), SF_OK);
    CHECK_EQ(sf_slice_measure(b, &q), SF_OK);
    CHECK(memcmp(&p, &q, sizeof p) == 0);
    CHECK_EQ(sf_slice_run_count(a, &n[0]), SF_OK);
    CHECK_EQ(sf_slice_run_count(b, &n[1]), SF_OK);
    CHECK_EQ(n[0], n[1]);
    CHECK_EQ(sf_slice_runs(a, runs[0], STACK_VOXELS, &n[0]), SF_OK);
    CHECK_EQ(sf_slice_runs(b, runs[1], STACK_VOXELS, &n[1]), SF_OK);
    CHECK(n[0] == n[1] && memcmp(runs[0], runs[1], n[0] * sizeof(sf_run)) == 0);
    CHECK_EQ(sf_slice_from_runs(b, runs[1], n[1]), SF_OK);
    CHECK(sf_slice_equal(a, b) && is_clean(b));
    for (uint32_t x = a.width - 1; x < a.width + 64; x++) {
        CHECK_EQ(sf_slice_get(a, x, 0), sf_slice_get(b, x, 0));
    }
    sf_rect all = {0, 0, a.width, a.height};
    soil(b);
    CHECK_EQ(sf_slice_set(a, a.width - 1, 0, 1), SF_OK);
    CHECK_EQ(sf_slice_set(b, a.width - 1, 0, 1), SF_OK);
    CHECK(sf_slice_equal(a, b));
    CHECK_EQ(sf_slice_fill(b, all, 1), SF_OK);
    CHECK(sf_slice_popcount(b) == (uint64_t)a.width * a.height && is_clean(b));
}

// --- grids ---------------------------------------------------------------------------------------

static void grids_tell(twins t)
{
    sf_moments p, q;
    sf_grid *clone = NULL;
    CHECK(sf_grid_equal(t.clean, t.soiled));
    CHECK_EQ(sf_grid_popcount(t.clean), sf_grid_popcount(t.soiled));
    sf_box a = sf_grid_bounds(t.clean), b = sf_grid_bounds(t.soiled);
    CHECK(memcmp(&a, &b, sizeof a) == 0);
    CHECK_EQ(sf_grid_measure(t.clean, NULL, &p), SF_OK);
    CHECK_EQ(sf_grid_measure(t.soiled, NULL, &q), SF_OK);
    CHECK(memcmp(&p, &q, sizeof p) == 0);
    CHECK_EQ(sf_grid_clone(t.soiled, stack_allocator(), &clone), SF_OK);
    CHECK(sf_grid_equal(clone, t.clean) && grid_is_clean(clone));
    sf_grid_destroy(clone);
}

static void grids_have_one_surface(twins t)
{
    sf_surface_options options = sf_surface_options_default();
    for (options.smooth_passes = 0; options.smooth_passes < 2; options.smooth_passes++) {
        sf_mesh *a = NULL, *b = NULL;
        CHECK_EQ(sf_grid_surface(t.clean, &options, NULL, NULL, &a), SF_OK);
        CHECK_EQ(sf_grid_surface(t.soiled, &options, NULL, NULL, &b), SF_OK);
        sf_mesh_view u = sf_mesh_get_view(a), v = sf_mesh_get_view(b);
        CHECK_EQ(u.vertex_count, v.vertex_count);
        CHECK_EQ(u.triangle_count, v.triangle_count);
        if (u.vertex_count == v.vertex_count && u.triangle_count == v.triangle_count) {
            CHECK(memcmp(u.vertices, v.vertices, u.vertex_count * 3 * sizeof(double)) == 0);
            CHECK(memcmp(u.triangles, v.triangles, u.triangle_count * 3 * sizeof(uint32_t)) == 0);
        }
        sf_mesh_destroy(a);
        sf_mesh_destroy(b);
    }
}

// What stood in the grid, or in the slice, has no say.
static void grids_are_filled(twins t)
{
    sf_mesh *mesh = NULL;
    sf_grid *into = NULL;
    sf_lattice lattice = sf_grid_lattice(t.clean);
    CHECK_EQ(sf_grid_surface(t.clean, NULL, NULL, NULL, &mesh), SF_OK);
    CHECK_EQ(sf_grid_create(&lattice, stack_allocator(), &into), SF_OK);
    sf_voxelize_options options = sf_voxelize_options_default();
    for (int fill = SF_FILL_AUTO; fill <= SF_FILL_SURFACE; fill++) {
        sf_voxelizer *voxelizer = NULL;
        sf_mesh_view view = sf_mesh_get_view(mesh);
        sf_grid *again = NULL;
        options.fill = (sf_fill)fill;
        CHECK_EQ(sf_grid_create(&lattice, stack_allocator(), &again), SF_OK);
        CHECK_EQ(sf_grid_voxelize(again, view, &options, NULL, NULL, NULL), SF_OK);
        soil_grid(into);
        CHECK_EQ(sf_grid_voxelize(into, view, &options, NULL, NULL, NULL), SF_OK);
        CHECK(sf_grid_equal(again, into) && grid_is_clean(into));
        CHECK_EQ(sf_voxelizer_create(view, &lattice, &options, NULL, &voxelizer, NULL), SF_OK);
        for (uint32_t k = 0; k < lattice.nz; k++) {
            sf_slice slice = sf_grid_slice(into, k);
            soil(slice);
            CHECK_EQ(sf_voxelizer_slice(voxelizer, k, slice), SF_OK);
            CHECK(sf_slice_equal(slice, sf_grid_slice(again, k)) && is_clean(slice));
        }
        sf_voxelizer_destroy(voxelizer);
        sf_grid_destroy(again);
    }
    sf_grid_destroy(into);
    sf_mesh_destroy(mesh);
}

// --- support -------------------------------------------------------------------------------------

static void same_report(const sf_check_report *a, const sf_check_report *b)
{
    CHECK_EQ(a->bed_layer, b->bed_layer);
    CHECK_EQ(a->solid_voxels, b->solid_voxels);
    CHECK_EQ(a->unsupported_voxels, b->unsupported_voxels);
    CHECK_EQ(a->trimmed_voxels, b->trimmed_voxels);
    CHECK_EQ(a->island_count, b->island_count);
    CHECK_EQ(a->overhang_count, b->overhang_count);
    CHECK_EQ(a->support_free, b->support_free);
}

static void same_findings(const sf_finding *a, const sf_finding *b, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        CHECK_EQ(a[i].area, b[i].area);
        CHECK_EQ(a[i].volume, b[i].volume);
        CHECK_EQ(a[i].cause, b[i].cause);
        CHECK(memcmp(&a[i].box, &b[i].box, sizeof a[i].box) == 0);
    }
}

static void layers_pushed(const sf_grid *grid, sf_check_options options, sf_check_report *report)
{
    sf_lattice lattice = sf_grid_lattice(grid);
    sf_checker *checker = NULL;
    size_t size = 0, count = 0;
    options.width = lattice.nx;
    options.height = lattice.ny;
    options.findings = NULL;
    options.finding_capacity = 0;
    CHECK_EQ(sf_checker_size(&options, &size), SF_OK);
    unsigned char *memory = malloc(size + 64);
    unsigned char *aligned = memory + (64 - (uintptr_t)memory % 64) % 64;
    CHECK_EQ(sf_checker_place(&options, aligned, size, &checker), SF_OK);
    for (uint32_t k = 0; k < lattice.nz; k++) {
        CHECK_EQ(sf_checker_push(checker, sf_grid_slice(grid, k)), SF_OK);
    }
    CHECK_EQ(sf_checker_report(checker, report, &count), SF_OK);
    free(memory);
}

static void grids_are_checked(twins t, const sf_rule *rule)
{
    static sf_finding found[2][256];
    sf_check_options options = sf_check_options_default();
    sf_check_report a, b;
    size_t n[2] = {0, 0};
    options.rule = *rule;
    options.finding_capacity = 256;
    options.findings = found[0];
    CHECK_EQ(sf_grid_check(t.clean, &options, stack_allocator(), NULL, &a, &n[0]), SF_OK);
    options.findings = found[1];
    CHECK_EQ(sf_grid_check(t.soiled, &options, stack_allocator(), NULL, &b, &n[1]), SF_OK);
    CHECK_EQ(n[0], n[1]);
    same_report(&a, &b);
    same_findings(found[0], found[1], n[0] < n[1] ? n[0] : n[1]);
    layers_pushed(t.clean, options, &a);
    layers_pushed(t.soiled, options, &b);
    same_report(&a, &b);
}

static void grids_are_trimmed(twins t, const sf_rule *rule)
{
    sf_lattice l = sf_grid_lattice(t.clean);
    sf_grid *a = NULL, *b = NULL;
    CHECK_EQ(sf_grid_clone(t.clean, stack_allocator(), &a), SF_OK);
    CHECK_EQ(sf_grid_clone(t.soiled, stack_allocator(), &b), SF_OK);
    soil_grid(b);
    CHECK_EQ(sf_grid_trim(a, rule, SF_BED_AUTO, NULL, NULL), SF_OK);
    CHECK_EQ(sf_grid_trim(b, rule, SF_BED_AUTO, NULL, NULL), SF_OK);
    CHECK(sf_grid_equal(a, b));
    // An edit of the drawn grids, trimmed within its box.
    sf_box box = {l.nx - 1, 0, 1, l.nx, l.ny, 2};
    sf_rect edit = {l.nx - 1, 0, l.nx, l.ny};
    CHECK_EQ(sf_slice_fill(sf_grid_slice(t.clean, 1), edit, 1), SF_OK);
    CHECK_EQ(sf_slice_fill(sf_grid_slice(t.soiled, 1), edit, 1), SF_OK);
    soil_grid(t.soiled);
    soil_grid(b);
    sf_box p, q;
    CHECK_EQ(sf_grid_trim_box(t.clean, a, rule, 0, box, &p), SF_OK);
    CHECK_EQ(sf_grid_trim_box(t.soiled, b, rule, 0, box, &q), SF_OK);
    CHECK(sf_grid_equal(a, b) && memcmp(&p, &q, sizeof p) == 0);
    sf_grid_destroy(a);
    sf_grid_destroy(b);
}

// --- files ---------------------------------------------------------------------------------------

static void stacks_are_written(twins t)
{
    static memory_folder a, b;
    sf_folder to = memory_begin_folder(&a), out = memory_begin_folder(&b);
    CHECK_EQ(sf_stack_write(t.clean, NULL, to, NULL, NULL), SF_OK);
    CHECK_EQ(sf_stack_write(t.soiled, NULL, out, NULL, NULL), SF_OK);
    CHECK_EQ(a.count, b.count);
    for (int i = 0; i < a.count && i < b.count; i++) {
        CHECK_EQ(a.files[i].size, b.files[i].size);
        CHECK(a.files[i].size == b.files[i].size &&
              memcmp(a.files[i].bytes, b.files[i].bytes, a.files[i].size) == 0);
    }
    memory_end_folder(&a);
    memory_end_folder(&b);
}

// --- all of it -----------------------------------------------------------------------------------

static void by_every_rule(twins t)
{
    for (int i = 0; i < 7; i++) {
        sf_rule rule = rule_by_number(i);
        grids_are_checked(t, &rule);
        grids_are_trimmed(t, &rule);
    }
}

static void padding_has_no_say_in_slices(void)
{
    with_twins(slices_combine);
    with_twins(slices_grow_and_shrink);
    with_twins(slices_tell);
}

static void padding_has_no_say_in_grids(void)
{
    with_twins(grids_tell);
    with_twins(grids_are_filled);
}

static void padding_has_no_say_in_surfaces(void)
{
    with_twins(grids_have_one_surface);
}

static void padding_has_no_say_in_support(void)
{
    with_twins(by_every_rule);
}

static void padding_has_no_say_in_files(void)
{
    with_twins(stacks_are_written);
}

int main(void)
{
    TEST(padding_has_no_say_in_slices);
    TEST(padding_has_no_say_in_grids);
    TEST(padding_has_no_say_in_surfaces);
    TEST(padding_has_no_say_in_support);
    TEST(padding_has_no_say_in_files);
    return test_finish();
}
