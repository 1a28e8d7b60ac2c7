// SPDX-License-Identifier: MIT
// A document that is written and read again is the same document: objects, colours and places, bit
// for bit; written twice it is the same bytes. What cannot be written is refused before the first
// byte, and a sink or an allocator that fails is told of. Guards: issue 8 part 1, the strong
// guarantee.

#include "stored_zip.h"

static const double points[12] = {0, 0, 0, 1, 0, 0, 0, 1e-7, 0, 0.1, 0, 1.0 / 3};
static const uint32_t faces[12] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
static const uint32_t materials[12] = {1, 1, 1, 0, 0, 0, 1, 1, 1, 1, 1, 1};
static const uint32_t corners[12] = {
    2, 3, 4, SF_THREEMF_NONE, SF_THREEMF_NONE, SF_THREEMF_NONE, 4, 4, 4, 3, 2, 3};

// Two objects in three places, one of them mirrored, with materials and with a colour for each
// corner.
typedef struct sample {
    sf_threemf_colour colours[5];
    sf_threemf_object objects[2];
    sf_threemf_item items[3];
    sf_threemf_view view;
} sample;

static void make_sample(sample *s)
{
    static const sf_threemf_colour colours[5] = {{"hard <&\"> \xc3\xa4", {1, 2, 3, 255}, 0},
                                                 {"soft", {200, 100, 50, 128}, 0},
                                                 {"", {255, 0, 0, 255}, 1},
                                                 {"", {0, 255, 0, 255}, 1},
                                                 {"", {0, 0, 255, 0}, 1}};
    sf_mesh_view mesh = {points, 4, faces, 4};
    sf_threemf_object first = {"outside\tin", SF_THREEMF_MODEL, mesh,
                               materials,     SF_THREEMF_NONE,  0};
    sf_threemf_object second = {"", SF_THREEMF_SOLID_SUPPORT, mesh, corners, SF_THREEMF_NONE, 0};
    sf_transform same = {{1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 0, 0}};
    sf_transform turned = {{0, -0.1, 0, 1e-5, 0, 0, 0, 0, -3}, {1, 1.0 / 3, -2e10}};
    memset(s, 0, sizeof *s);
    memcpy(s->colours, colours, sizeof colours);
    s->objects[0] = first;
    s->objects[1] = second;
    for (uint32_t i = 0; i < 3; i++) {
        s->items[i].object = i % 2;
        s->items[i].placed = i == 2 ? turned : same;
    }
    sf_threemf_view view = {s->colours, 5, s->objects, 2, s->items, 3, 0};
    s->view = view;
}

static sf_status write_to(const sf_threemf_view *view, const sf_threemf_extras *extras, bucket *b)
{
    return sf_threemf_write(view, extras, bucket_sink(b), NULL, NULL, NULL);
}

static int same_object(const sf_threemf_object *a, const sf_threemf_object *b)
{
    size_t triangles = a->mesh.triangle_count;
    return strcmp(a->name, b->name) == 0 && a->kind == b->kind &&
           a->mesh.vertex_count == b->mesh.vertex_count && triangles == b->mesh.triangle_count &&
           memcmp(a->mesh.vertices, b->mesh.vertices, 3 * a->mesh.vertex_count * sizeof(double)) ==
               0 &&
           memcmp(a->mesh.triangles, b->mesh.triangles, 3 * triangles * sizeof(uint32_t)) == 0 &&
           b->colours != NULL &&
           memcmp(a->colours, b->colours, 3 * triangles * sizeof(uint32_t)) == 0;
}

static void check_same(const sf_threemf_view *a, const sf_threemf_view *b)
{
    CHECK_EQ(a->colour_count, b->colour_count);
    CHECK_EQ(a->object_count, b->object_count);
    CHECK_EQ(a->item_count, b->item_count);
    for (size_t i = 0; i < a->colour_count && i < b->colour_count; i++) {
        CHECK_STR(a->colours[i].name, b->colours[i].name);
        CHECK(memcmp(a->colours[i].rgba, b->colours[i].rgba, 4) == 0);
        CHECK_EQ(a->colours[i].group, b->colours[i].group);
    }
    for (size_t i = 0; i < a->object_count && i < b->object_count; i++) {
        CHECK(same_object(&a->objects[i], &b->objects[i]));
    }
    for (size_t i = 0; i < a->item_count && i < b->item_count; i++) {
        CHECK_EQ(a->items[i].object, b->items[i].object);
        for (int k = 0; k < 9; k++) {
            CHECK_NEAR(a->items[i].placed.matrix[k], b->items[i].placed.matrix[k], 0);
        }
        for (int k = 0; k < 3; k++) {
            CHECK_NEAR(a->items[i].placed.shift_mm[k], b->items[i].placed.shift_mm[k], 0);
        }
    }
}

static void comes_back_the_same(void)
{
    sample s;
    bucket b, again;
    sf_threemf *document = NULL;
    make_sample(&s);
    CHECK_EQ(write_to(&s.view, NULL, &b), SF_OK);
    sf_memory_cursor cursor = {b.bytes, b.size, 0};
    CHECK_EQ(sf_threemf_read(sf_memory_source(&cursor), NULL, NULL, &document, NULL), SF_OK);
    sf_threemf_view view = sf_threemf_get_view(document);
    check_same(&s.view, &view);
    CHECK_EQ(write_to(&view, NULL, &again), SF_OK);
    CHECK(b.size == again.size && memcmp(b.bytes, again.bytes, b.size) == 0);
    sf_threemf_destroy(document);
    free(b.bytes);
    free(again.bytes);
}

// Large enough that the compressor and the directory pass through their buffers many times.
static void writes_large_meshes(void)
{
    enum { SIDE = 200 };
    sf_mesh *mesh = NULL, *back = NULL;
    bucket b;
    CHECK_EQ(sf_mesh_create(NULL, &mesh), SF_OK);
    for (uint32_t i = 0; i < SIDE * SIDE; i++) {
        double p[3] = {test_random_unit(), test_random_unit() * 1e-9, -1e9 * test_random_unit()};
        CHECK_EQ(sf_mesh_add_vertices(mesh, p, 1), SF_OK);
    }
    for (uint32_t i = 0; i + SIDE + 1 < SIDE * SIDE; i++) {
        uint32_t t[3] = {i, i + 1, i + SIDE};
        CHECK_EQ(sf_mesh_add_triangles(mesh, t, 1), SF_OK);
    }
    sf_mesh_view from = sf_mesh_get_view(mesh);
    CHECK_EQ(sf_mesh_write(from, SF_MESH_FORMAT_THREEMF, bucket_sink(&b)), SF_OK);
    sf_memory_cursor cursor = {b.bytes, b.size, 0};
    CHECK_EQ(sf_mesh_read(sf_memory_source(&cursor), SF_MESH_FORMAT_AUTO, NULL, NULL, &back, NULL),
             SF_OK);
    sf_mesh_view to = sf_mesh_get_view(back);
    CHECK_EQ(from.vertex_count, to.vertex_count);
    CHECK_EQ(from.triangle_count, to.triangle_count);
    CHECK(back != NULL &&
          memcmp(from.vertices, to.vertices, 3 * from.vertex_count * sizeof(double)) == 0 &&
          memcmp(from.triangles, to.triangles, 3 * from.triangle_count * sizeof(uint32_t)) == 0);
    sf_mesh_destroy(mesh);
    sf_mesh_destroy(back);
    free(b.bytes);
}

static void leaves_out_flat_triangles(void)
{
    static const uint32_t flat[6] = {0, 1, 2, 1, 1, 3};
    sf_mesh_view mesh = {points, 4, flat, 2};
    sf_mesh *back = NULL;
    bucket b;
    CHECK_EQ(sf_mesh_write(mesh, SF_MESH_FORMAT_THREEMF, bucket_sink(&b)), SF_OK);
    sf_memory_cursor cursor = {b.bytes, b.size, 0};
    CHECK_EQ(
        sf_mesh_read(sf_memory_source(&cursor), SF_MESH_FORMAT_THREEMF, NULL, NULL, &back, NULL),
        SF_OK);
    CHECK_EQ(sf_mesh_get_view(back).triangle_count, 1);
    sf_mesh_destroy(back);
    free(b.bytes);
    sf_mesh_view nothing = {points, 4, flat + 3, 1};
    CHECK_EQ(sf_mesh_write(nothing, SF_MESH_FORMAT_THREEMF, bucket_sink(&b)), SF_ERR_ARGUMENT);
    CHECK_EQ(b.size, 0);
}

// ---------------------------------------------------------------------------------------------
// What cannot be
// ---------------------------------------------------------------------------------------------

static sf_status no_layer(void *user, uint32_t k, uint16_t *const *planes)
{
    uint32_t *most = user;
    planes[0][0] = (uint16_t)k;
    return k < *most ? SF_OK : SF_ERR_IO;
}

static const sf_threemf_field field = {"stiffness", 1, 2};

static sf_threemf_volume volume_of(uint32_t *most)
{
    sf_lattice lattice = {3, 2, 4, 0.5, 0.25, 0.1, NULL, {0, 0, 0}};
    sf_threemf_volume v = {0, lattice, 1, &field, SF_THREEMF_NONE, no_layer, most};
    return v;
}

// Each spoils one thing.
static void spoil_objects(sample *s, int how)
{
    static const uint32_t wrong[4][12] = {
        {9}, {2, 1, 2}, {0, 1, 0}, {2, SF_THREEMF_NONE, 2}}; // far, mixed, a blend, half
    static const char *const names[4] = {"\xff", "\x01", "\xed\xa0\x80", NULL};
    if (how < 4) {
        s->objects[0].name = names[how];
    } else if (how < 8) {
        s->objects[1].colours = wrong[how - 4];
    } else if (how == 8) {
        s->objects[1].kind = SF_THREEMF_OTHER;
    } else if (how == 9) {
        s->objects[1].mesh.vertex_count = 3;
    } else {
        s->view.objects = NULL;
    }
}

static void spoil_places(sample *s, int how)
{
    s->view.item_count = how == 0 ? 0 : 3;
    s->items[1].object = how == 1 ? 2 : 1;
    s->items[2].placed.matrix[8] = how == 2 ? 0 : -3;
    s->items[2].placed.shift_mm[0] = how == 3 ? INFINITY : 0;
    s->colours[2].group = how == 4 ? 3 : 1;
    s->colours[1].name = how == 5 ? "" : "soft";
}

static void spoil_volume(sf_threemf_volume *v, sf_threemf_field *f, int how)
{
    v->object = how == 0 ? 2 : 0;
    v->field_count = how == 1 ? 0 : 1;
    v->layer = how == 2 ? NULL : no_layer;
    v->lattice.nx = how == 3 ? 0 : 3;
    f->name = how == 4 ? "" : "stiffness";
    f->high = how == 5 ? f->low : how == 6 ? INFINITY : 2;
    v->mixed_group = how == 7 ? 1 : how == 8 ? 0 : how == 9 ? 9 : SF_THREEMF_NONE;
}

enum { OBJECTS = 11, PLACES = 6, VOLUMES = 10 };

static void refuses_before_the_first_byte(void)
{
    for (int how = 0; how < OBJECTS + PLACES + VOLUMES; how++) {
        sample s;
        bucket b;
        uint32_t most = 10;
        sf_fault fault = {SF_OK, 0, 0, ""};
        sf_threemf_field f = field;
        sf_threemf_volume v = volume_of(&most);
        sf_threemf_extras extras = sf_threemf_extras_default();
        make_sample(&s);
        v.fields = &f;
        if (how < OBJECTS) {
            spoil_objects(&s, how);
        } else if (how < OBJECTS + PLACES) {
            spoil_places(&s, how - OBJECTS);
        } else {
            spoil_volume(&v, &f, how - OBJECTS - PLACES);
            extras.volume = &v;
        }
        sf_status status = sf_threemf_write(&s.view, &extras, bucket_sink(&b), NULL, NULL, &fault);
        CHECK_EQ(status, SF_ERR_ARGUMENT);
        CHECK(b.size == 0);
        CHECK(v.lattice.nx == 0 || fault.message[0] != '\0');
        free(b.bytes);
    }
    sample s;
    bucket b;
    sf_threemf_extras extras = sf_threemf_extras_default();
    sf_sink none = {NULL, NULL};
    make_sample(&s);
    extras.thumbnail = "not a picture";
    extras.thumbnail_size = 13;
    CHECK_EQ(write_to(&s.view, &extras, &b), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_threemf_write(NULL, NULL, bucket_sink(&b), NULL, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_threemf_write(&s.view, NULL, none, NULL, NULL, NULL), SF_ERR_ARGUMENT);
    s.objects[0].stack = 0;
    CHECK_EQ(write_to(&s.view, NULL, &b), SF_ERR_UNSUPPORTED);
    CHECK_EQ(b.size, 0);
}

static void passes_on_failures(void)
{
    sample s;
    bucket b;
    uint32_t most = 10;
    sf_threemf_volume v = volume_of(&most);
    sf_threemf_extras extras = sf_threemf_extras_default();
    make_sample(&s);
    extras.volume = sf_stack_has_png() ? &v : NULL;
    CHECK_EQ(write_to(&s.view, &extras, &b), SF_OK);
    size_t size = b.size;
    free(b.bytes);
    for (size_t most_size = 0; most_size < size; most_size += 1 + size / 50) {
        sf_sink sink = bucket_sink(&b);
        b.most = most_size;
        CHECK_EQ(sf_threemf_write(&s.view, &extras, sink, NULL, NULL, NULL), SF_ERR_IO);
        free(b.bytes);
    }
    if (sf_stack_has_png()) {
        sf_task task = sf_task_default();
        most = 2;
        CHECK_EQ(write_to(&s.view, &extras, &b), SF_ERR_IO);
        free(b.bytes);
        sf_task_cancel(&task);
        CHECK_EQ(sf_threemf_write(&s.view, &extras, bucket_sink(&b), NULL, &task, NULL),
                 SF_ERR_CANCELLED);
        free(b.bytes);
    }
}

static void survives_failing_memory(void)
{
    sample s;
    failing_allocator memory;
    uint32_t most = 10;
    sf_threemf_volume v = volume_of(&most);
    sf_threemf_extras extras = sf_threemf_extras_default();
    make_sample(&s);
    extras.volume = sf_stack_has_png() ? &v : NULL;
    long k = 0;
    for (sf_status status = SF_ERR_MEMORY; status == SF_ERR_MEMORY && k < 1000; k++) {
        bucket b;
        failing_begin(&memory, k);
        status = sf_threemf_write(&s.view, &extras, bucket_sink(&b), &memory.allocator, NULL, NULL);
        CHECK(status == SF_OK || status == SF_ERR_MEMORY);
        CHECK_EQ(memory.live, 0);
        CHECK_EQ(memory.faults, 0);
        free(b.bytes);
    }
    CHECK(k > 10 && k < 1000);
}

static void says_that_it_is_left_out(void)
{
    sample s;
    bucket b;
    make_sample(&s);
    CHECK_EQ(write_to(&s.view, NULL, &b), SF_ERR_UNSUPPORTED);
    CHECK_EQ(b.size, 0);
}

int main(void)
{
    if (!sf_threemf_is_served()) {
        TEST(says_that_it_is_left_out);
        return test_finish();
    }
    TEST(comes_back_the_same);
    TEST(writes_large_meshes);
    TEST(leaves_out_flat_triangles);
    TEST(refuses_before_the_first_byte);
    TEST(passes_on_failures);
    TEST(survives_failing_memory);
    return test_finish();
}
