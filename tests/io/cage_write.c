// SPDX-License-Identifier: MIT
// A cage that is written as VTK and read again is the same cage: the same points, cells, creases
// and properties, and the same value at every corner, where a property jumps, too; in text and in
// binary. A sink that fails is told of, and what cannot be written is refused before the first
// byte. Guards: issue 5 part 9 (VTK of cages for ParaView), the strong guarantee.

#include "cage_files.h"

#include "../unit/grade/cages.h"

#include <sf/refine.h>

typedef struct memory_sink {
    unsigned char *bytes;
    size_t size, capacity, fails_after;
} memory_sink;

static sf_status sink_write(void *user, const void *data, size_t size)
{
    memory_sink *sink = user;
    if (sink->size + size > sink->fails_after) {
        return SF_ERR_IO;
    }
    if (sink->size + size > sink->capacity) {
        sink->capacity = 2 * (sink->size + size);
        sink->bytes = realloc(sink->bytes, sink->capacity);
    }
    memcpy(sink->bytes + sink->size, data, size);
    sink->size += size;
    return SF_OK;
}

static memory_sink written(const sf_cage_view *view, int binary)
{
    memory_sink sink = {NULL, 0, 0, SIZE_MAX};
    sf_sink out = {sink_write, &sink};
    sf_fault fault = {SF_OK, 0, 0, ""};
    CHECK_EQ(sf_cage_write_vtk(view, binary, NULL, out, &fault), SF_OK);
    return sink;
}

static sf_cage *read_back(const memory_sink *sink)
{
    sf_cage *cage = NULL;
    sf_cage_reading reading = {SF_CAGE_FORMAT_AUTO, 99, 99};
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_status status =
        read_cage(sink->bytes, sink->size, SF_CAGE_FORMAT_AUTO, NULL, &cage, &reading, &fault);
    CHECK_EQ(status, SF_OK);
    CHECK(reading.turned_cells == 0 && reading.passed_over == 0);
    if (status != SF_OK) {
        printf("# %s\n", fault.message);
        exit(1);
    }
    return cage;
}

// --- a cage with everything ----------------------------------------------------------------------

static void add(sf_cage *cage, sf_property property, size_t count, const double *values,
                const uint32_t *indices)
{
    sf_channel channel = {property, count, values, indices};
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_status status = sf_cage_add_property(cage, &channel, &fault);
    CHECK_EQ(status, SF_OK);
    if (status != SF_OK) {
        printf("# %s\n", fault.message);
    }
}

// Smooth; by cells; with a jump at x = 1, but not where y = 0; with another jump, at z = 1.
static void add_properties(sf_cage *cage)
{
    sf_cage_view v = sf_cage_get_view(cage);
    size_t corners = v.starts[v.cell_count], points = v.point_count;
    double *values = calloc(2 * points + v.cell_count, sizeof *values);
    uint32_t *indices = calloc(corners, sizeof *indices);
    sf_property odd = {"soft \"part\" 50% \xc3\xa9", {1, 2, 255}, {-3, 127, -128}, -4, INFINITY};
    for (size_t i = 0; i < 2 * points + v.cell_count; i++) {
        values[i] = test_random_unit() * ldexp(1, -1 - (int)test_random_below(60)); // < 0.5
    }
    add(cage, sf_property_density(), points, values, NULL);
    for (size_t i = 0; i < v.cell_count; i++) {
        for (uint32_t j = v.starts[i]; j < v.starts[i + 1]; j++) {
            indices[j] = (uint32_t)i;
        }
    }
    add(cage, odd, v.cell_count, values, indices);
    for (int axis = 0; axis < 3; axis += 2) {
        for (size_t i = 0; i < v.cell_count; i++) {
            int above = v.positions[3 * (size_t)v.corners[v.starts[i]] + (size_t)axis] > 0.5;
            for (uint32_t j = v.starts[i]; j < v.starts[i + 1]; j++) {
                uint32_t p = v.corners[j];
                int has_jump = above && v.positions[3 * (size_t)p + 1] > 0.5;
                indices[j] = p + (has_jump ? (uint32_t)points : 0);
            }
        }
        add(cage, axis == 0 ? sf_property_poisson() : sf_property_young(), 2 * points, values,
            indices);
    }
    free(values);
    free(indices);
}

static sf_cage *rich_block(void)
{
    test_cage c = test_cage_block(3, 2, 2);
    c.creases = 2;
    c.crease[0] = (sf_crease){{1, 0}, INFINITY};
    c.crease[1] = (sf_crease){{1, 2}, 2.25};
    c.sharps = 1;
    c.sharp[0] = (sf_sharp_point){3, 0.5};
    for (size_t i = 0; i < 3 * c.points; i++) {
        c.positions[i] += 0.1 * test_random_unit();
    }
    sf_cage *cage = test_cage_make(&c);
    test_cage_free(&c);
    add_properties(cage);
    return cage;
}

// --- comparing -----------------------------------------------------------------------------------

static int same_channel(const sf_cage_view *a, const sf_channel *x, const sf_channel *y)
{
    int good = strcmp(x->property.name, y->property.name) == 0 &&
               memcmp(x->property.uuid, y->property.uuid, 16) == 0 &&
               memcmp(x->property.si, y->property.si, 7) == 0 &&
               x->property.low == y->property.low && x->property.high == y->property.high;
    for (uint32_t i = 0; good && i < a->starts[a->cell_count]; i++) {
        double p = x->values[x->indices != NULL ? x->indices[i] : a->corners[i]];
        double q = y->values[y->indices != NULL ? y->indices[i] : a->corners[i]];
        good = p == q;
    }
    return good;
}

static int same(const sf_cage_view *a, const sf_cage_view *b)
{
    int good = a->dimension == b->dimension && a->point_count == b->point_count &&
               a->cell_count == b->cell_count && a->channel_count == b->channel_count &&
               a->crease_count == b->crease_count && a->sharp_count == b->sharp_count &&
               memcmp(a->positions, b->positions, 3 * a->point_count * sizeof(double)) == 0 &&
               memcmp(a->starts, b->starts, (a->cell_count + 1) * sizeof(uint32_t)) == 0 &&
               memcmp(a->corners, b->corners, a->starts[a->cell_count] * sizeof(uint32_t)) == 0;
    for (size_t i = 0; good && i < a->crease_count; i++) {
        good = memcmp(a->creases[i].points, b->creases[i].points, 2 * sizeof(uint32_t)) == 0 &&
               fmin(a->creases[i].sharpness, SF_SHARP) == b->creases[i].sharpness;
    }
    for (size_t i = 0; good && i < a->sharp_count; i++) {
        good = a->sharps[i].point == b->sharps[i].point &&
               fmin(a->sharps[i].sharpness, SF_SHARP) == b->sharps[i].sharpness;
    }
    for (size_t i = 0; good && i < a->channel_count; i++) {
        good = same_channel(a, &a->channels[i], &b->channels[i]);
    }
    return good;
}

// Write, read, compare, and write again: the same bytes.
static void round_trip(const sf_cage_view *view)
{
    for (int binary = 0; binary < 2; binary++) {
        memory_sink first = written(view, binary);
        sf_cage *back = read_back(&first);
        sf_cage_view again = sf_cage_get_view(back);
        CHECK(same(view, &again));
        memory_sink second = written(&again, binary);
        CHECK(first.size == second.size && memcmp(first.bytes, second.bytes, first.size) == 0);
        sf_cage_destroy(back);
        free(first.bytes);
        free(second.bytes);
    }
}

static void brings_everything_back(void)
{
    for (int round = 0; round < 5; round++) {
        sf_cage *cage = rich_block();
        sf_cage_view view = sf_cage_get_view(cage);
        round_trip(&view);
        sf_cage_destroy(cage);
    }
}

// A value at a jump that does not jump is one value again, so the solid is not cut there.
static void cuts_only_where_values_differ(void)
{
    sf_cage *cage = rich_block();
    sf_cage_view view = sf_cage_get_view(cage);
    memory_sink sink = written(&view, 1);
    sf_cage *back = read_back(&sink);
    sf_cage_view again = sf_cage_get_view(back);
    const sf_channel *poisson = &again.channels[2], *density = &again.channels[0];
    CHECK(density->indices == NULL && density->value_count == view.point_count);
    for (uint32_t i = 0; i < view.starts[view.cell_count]; i++) {
        for (uint32_t j = 0; j < i; j++) {
            if (view.corners[i] == view.corners[j]) {
                const sf_channel *was = &view.channels[2];
                CHECK_EQ(poisson->indices[i] == poisson->indices[j],
                         was->indices[i] == was->indices[j]);
            }
        }
    }
    sf_cage_destroy(back);
    sf_cage_destroy(cage);
    free(sink.bytes);
}

static void writes_every_kind_of_cell(void)
{
    static file f;
    const char *what;
    for (size_t i = 0; (what = make_any_cage(&f, i)) != NULL; i++) {
        sf_cage *cage = NULL;
        CHECK_EQ(read_cage(f.bytes, f.size, SF_CAGE_FORMAT_AUTO, NULL, &cage, NULL, NULL), SF_OK);
        sf_cage_view view = sf_cage_get_view(cage);
        round_trip(&view);
        sf_cage_destroy(cage);
    }
    // Faces of 3, 4 and 5 corners.
    static const double positions[] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0,  1,   0,
                                       2, 0, 0, 3, 0, 0, 3, 1, 0, -1, 0.5, 0};
    static const uint32_t starts[] = {0, 4, 9, 12},
                          corners[] = {0, 1, 2, 3, 1, 4, 5, 6, 2, 0, 3, 7};
    sf_cage_view faces = {2, 8, positions, 3, starts, corners, 0, NULL, 0, NULL, 0, NULL};
    round_trip(&faces);
}

// Refined cages are views, not cages; 3 * 2 * 2 cells become 8 times as many, and again.
static void writes_refined_cages(void)
{
    sf_cage *cage = rich_block();
    sf_refine_options options = sf_refine_options_default();
    sf_refinement *refinement = NULL;
    options.steps = 2;
    CHECK_EQ(sf_refine(cage, &options, NULL, NULL, &refinement), SF_OK);
    sf_cage_view view;
    CHECK_EQ(sf_refinement_get_view(refinement, 2, &view), SF_OK);
    CHECK_EQ(view.cell_count, 12 * 64);
    round_trip(&view);
    sf_refinement_destroy(refinement);
    sf_cage_destroy(cage);
}

// --- failures ------------------------------------------------------------------------------------

static void tells_of_a_failing_sink(void)
{
    sf_cage *cage = rich_block();
    sf_cage_view view = sf_cage_get_view(cage);
    memory_sink whole = written(&view, 0);
    for (size_t limit = 0; limit < whole.size; limit += 97) {
        memory_sink sink = {NULL, 0, 0, limit};
        sf_sink out = {sink_write, &sink};
        CHECK_EQ(sf_cage_write_vtk(&view, 0, NULL, out, NULL), SF_ERR_IO);
        free(sink.bytes);
    }
    sf_status status = SF_ERR_MEMORY;
    for (long k = 0; status != SF_OK && k < 100; k++) {
        failing_allocator memory;
        failing_begin(&memory, k);
        memory_sink sink = {NULL, 0, 0, SIZE_MAX};
        sf_sink out = {sink_write, &sink};
        status = sf_cage_write_vtk(&view, 0, &memory.allocator, out, NULL);
        CHECK(status == SF_OK ? sink.size == whole.size
                              : status == SF_ERR_MEMORY && sink.size == 0);
        CHECK(memory.live == 0 && memory.faults == 0);
        free(sink.bytes);
    }
    CHECK_EQ(status, SF_OK);
    free(whole.bytes);
    sf_cage_destroy(cage);
}

static int not_written(const sf_cage_view *view, sf_status expected, const char *words)
{
    memory_sink sink = {NULL, 0, 0, SIZE_MAX};
    sf_sink out = {sink_write, &sink};
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_status status = sf_cage_write_vtk(view, 1, NULL, out, &fault);
    int good = status == expected && fault.status == expected && sink.size == 0 &&
               strstr(fault.message, words) != NULL;
    if (!good) {
        printf("# expected \"%s\", got %s: \"%s\"\n", words, sf_status_name(status), fault.message);
    }
    free(sink.bytes);
    return good;
}

static void refuses_before_the_first_byte(void)
{
    static const double points[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, wrong[] = {0, 1, NAN, 0};
    static const double beyond[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, INFINITY};
    static const uint32_t starts[] = {0, 4}, back[] = {1, 0}, five[] = {0, 5};
    static const uint32_t corners[] = {0, 1, 2, 3, 0}, none[] = {0, 1, 2, 4},
                          index[] = {0, 0, 0, 4};
    const sf_cage_view fine = {3, 4, points, 1, starts, corners, 0, NULL, 0, NULL, 0, NULL};
    sf_crease crease = {{0, 4}, 1};
    sf_sharp_point sharp = {0, NAN};
    sf_channel channels[2] = {{sf_property_density(), 4, wrong, NULL},
                              {sf_property_density(), 4, points, NULL}};
    sf_cage_view v = fine;
    sf_sink nowhere = {NULL, NULL};
    CHECK_EQ(sf_cage_write_vtk(&fine, 0, NULL, nowhere, NULL), SF_ERR_ARGUMENT);
    CHECK(not_written(NULL, SF_ERR_ARGUMENT, "no cage"));
    v.dimension = 1;
    CHECK(not_written(&v, SF_ERR_ARGUMENT, "no cage"));
    v = fine, v.positions = beyond;
    CHECK(not_written(&v, SF_ERR_ARGUMENT, "point 3"));
    v = fine, v.starts = back;
    CHECK(not_written(&v, SF_ERR_ARGUMENT, "cell 0"));
    v = fine, v.starts = five;
    CHECK(not_written(&v, SF_ERR_UNSUPPORTED, "5 corners"));
    v = fine, v.corners = none;
    CHECK(not_written(&v, SF_ERR_ARGUMENT, "cell 0"));
    v = fine, v.crease_count = 1, v.creases = &crease;
    CHECK(not_written(&v, SF_ERR_ARGUMENT, "crease 0"));
    v = fine, v.sharp_count = 1, v.sharps = &sharp;
    CHECK(not_written(&v, SF_ERR_ARGUMENT, "sharp point 0"));
    v = fine, v.channel_count = 1, v.channels = channels;
    CHECK(not_written(&v, SF_ERR_ARGUMENT, "not finite"));
    channels[0].values = points;
    channels[0].value_count = 3;
    CHECK(not_written(&v, SF_ERR_ARGUMENT, "one value"));
    channels[0].value_count = 4;
    channels[0].indices = index;
    CHECK(not_written(&v, SF_ERR_ARGUMENT, "value that there is not"));
    channels[0].indices = NULL;
    v.channel_count = 2;
    CHECK(not_written(&v, SF_ERR_ARGUMENT, "name of another"));
    strcpy(channels[1].property.name, "sf_point");
    CHECK(not_written(&v, SF_ERR_ARGUMENT, "sf_point"));
    channels[1].property.name[0] = '\0';
    CHECK(not_written(&v, SF_ERR_ARGUMENT, "no name"));
    channels[1].property = sf_property_young();
    channels[1].property.low = NAN;
    CHECK(not_written(&v, SF_ERR_ARGUMENT, "bounds"));
}

// So many faces with values of their own in one point that comparing each with each would take
// minutes.
static void a_hub_of_jumps_takes_no_longer(void)
{
    enum { FACES = 200000 };
    test_cage c = test_cage_begin(2, FACES + 1, FACES, 3);
    c.value_count = 3 * (size_t)FACES;
    c.values = calloc(c.value_count, sizeof *c.values);
    c.indices = calloc(c.value_count, sizeof *c.indices);
    for (uint32_t i = 0; i < FACES; i++) {
        uint32_t corners[3] = {0, 1 + i, 1 + (i + 1) % FACES};
        memcpy(c.corners + 3 * (size_t)i, corners, sizeof corners);
        test_cage_place(&c, 1 + i, i, 1, 0);
    }
    for (uint32_t i = 0; i < c.value_count; i++) {
        c.indices[i] = i;
        c.values[i] = i / 2; // some alike
    }
    sf_cage *cage = test_cage_make(&c);
    sf_cage_view view = sf_cage_get_view(cage);
    round_trip(&view);
    sf_cage_destroy(cage);
    test_cage_free(&c);
}

int main(void)
{
    TEST(brings_everything_back);
    TEST(cuts_only_where_values_differ);
    TEST(writes_every_kind_of_cell);
    TEST(writes_refined_cages);
    TEST(a_hub_of_jumps_takes_no_longer);
    TEST(tells_of_a_failing_sink);
    TEST(refuses_before_the_first_byte);
    return test_finish();
}
