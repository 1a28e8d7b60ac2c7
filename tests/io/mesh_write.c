// SPDX-License-Identifier: MIT
// A mesh that is written and read again is the same mesh: bit for bit in OBJ and PLY, to the
// nearest float in STL. A sink that fails is told of, and what cannot be written is refused before
// the first byte. Guards: issue 2 part 4 (writers), the strong guarantee.

#include "files.h"

typedef struct memory_sink {
    unsigned char *bytes;
    size_t size, capacity, fails_after;
    long writes;
} memory_sink;

static sf_status sink_write(void *user, const void *data, size_t size)
{
    memory_sink *sink = user;
    sink->writes++;
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

static memory_sink empty_sink(void)
{
    memory_sink sink = {NULL, 0, 0, SIZE_MAX, 0};
    return sink;
}

// Vertices that are hard to write, each used by some triangle.
static sf_mesh *random_mesh(size_t vertices, size_t triangles, int wild)
{
    sf_mesh *mesh = NULL;
    CHECK_EQ(sf_mesh_create(NULL, &mesh), SF_OK);
    for (size_t i = 0; i < vertices; i++) {
        double p[3];
        for (int k = 0; k < 3; k++) {
            p[k] = (test_random_unit() - 0.5) * (wild ? ldexp(1, (int)test_random_below(900)) : 90);
        }
        CHECK_EQ(sf_mesh_add_vertices(mesh, p, 1), SF_OK);
    }
    for (size_t i = 0; i < triangles; i++) {
        uint32_t t[3] = {test_random_below((uint32_t)vertices),
                         test_random_below((uint32_t)vertices),
                         test_random_below((uint32_t)vertices)};
        CHECK_EQ(sf_mesh_add_triangles(mesh, t, 1), SF_OK);
    }
    return mesh;
}

static int same(sf_mesh_view a, sf_mesh_view b)
{
    return a.vertex_count == b.vertex_count && a.triangle_count == b.triangle_count &&
           memcmp(a.vertices, b.vertices, a.vertex_count * 3 * sizeof(double)) == 0 &&
           memcmp(a.triangles, b.triangles, a.triangle_count * 3 * sizeof(uint32_t)) == 0;
}

static void round_trips_exactly(void)
{
    static const sf_mesh_format formats[] = {SF_MESH_FORMAT_OBJ, SF_MESH_FORMAT_PLY};
    for (int round = 0; round < 20; round++) {
        sf_mesh *mesh =
            random_mesh(3 + test_random_below(200), 1 + test_random_below(400), round % 2);
        for (size_t i = 0; i < 2; i++) {
            memory_sink sink = empty_sink(), again = empty_sink();
            sf_sink out = {sink_write, &sink}, out_again = {sink_write, &again};
            sf_mesh *back = NULL;
            CHECK_EQ(sf_mesh_write(sf_mesh_get_view(mesh), formats[i], out), SF_OK);
            CHECK_EQ(
                read_bytes(sink.bytes, sink.size, SF_MESH_FORMAT_AUTO, NULL, NULL, &back, NULL),
                SF_OK);
            CHECK(same(sf_mesh_get_view(mesh), sf_mesh_get_view(back)));
            CHECK_EQ(sf_mesh_write(sf_mesh_get_view(back), formats[i], out_again), SF_OK);
            CHECK(again.size == sink.size && memcmp(again.bytes, sink.bytes, sink.size) == 0);
            sf_mesh_destroy(back);
            free(sink.bytes);
            free(again.bytes);
        }
        sf_mesh_destroy(mesh);
    }
}

static void stl_is_the_nearest_float(void)
{
    sf_mesh *mesh = random_mesh(100, 300, 0), *back = NULL;
    memory_sink sink = empty_sink();
    sf_sink out = {sink_write, &sink};
    sf_mesh_view view = sf_mesh_get_view(mesh);
    CHECK_EQ(sf_mesh_write(view, SF_MESH_FORMAT_STL, out), SF_OK);
    CHECK_EQ(sink.size, 84 + 50 * 300);
    CHECK_EQ(read_bytes(sink.bytes, sink.size, SF_MESH_FORMAT_AUTO, NULL, NULL, &back, NULL),
             SF_OK);
    sf_mesh_view got = sf_mesh_get_view(back);
    CHECK_EQ(got.triangle_count, 300);
    for (size_t i = 0; i < 3 * got.triangle_count && got.triangle_count == 300; i++) {
        for (size_t k = 0; k < 3; k++) {
            CHECK((float)view.vertices[3 * (size_t)view.triangles[i] + k] ==
                  (float)got.vertices[3 * (size_t)got.triangles[i] + k]);
        }
    }
    sf_mesh_destroy(mesh);
    sf_mesh_destroy(back);
    free(sink.bytes);
}

// Normals of STL: of the right-hand rule, length one, and zero for a triangle that has none.
static void stl_has_normals(void)
{
    static const double vertices[] = {0, 0, 0, 3, 0, 0, 0, 5, 0};
    static const uint32_t triangles[] = {0, 1, 2, 0, 2, 1, 0, 1, 1};
    sf_mesh_view view = {vertices, 3, triangles, 3};
    memory_sink sink = empty_sink();
    sf_sink out = {sink_write, &sink};
    CHECK_EQ(sf_mesh_write(view, SF_MESH_FORMAT_STL, out), SF_OK);
    for (size_t t = 0; t < 3 && sink.size == 84 + 150; t++) {
        uint32_t z = 0;
        for (size_t i = 0; i < 4; i++) {
            z |= (uint32_t)sink.bytes[84 + 50 * t + 8 + i] << 8 * i;
        }
        CHECK_EQ(z, t == 0 ? 0x3f800000 : t == 1 ? 0xbf800000 : 0);
    }
    free(sink.bytes);
}

static void tells_of_a_failing_sink(void)
{
    sf_mesh *mesh = random_mesh(300, 400, 0);
    for (sf_mesh_format format = SF_MESH_FORMAT_STL; format <= SF_MESH_FORMAT_PLY; format++) {
        memory_sink whole = empty_sink();
        sf_sink out = {sink_write, &whole};
        CHECK_EQ(sf_mesh_write(sf_mesh_get_view(mesh), format, out), SF_OK);
        for (size_t limit = 0; limit < whole.size; limit += 997) {
            memory_sink sink = empty_sink();
            sink.fails_after = limit;
            sf_sink failing = {sink_write, &sink};
            CHECK_EQ(sf_mesh_write(sf_mesh_get_view(mesh), format, failing), SF_ERR_IO);
            free(sink.bytes);
        }
        free(whole.bytes);
    }
    sf_mesh_destroy(mesh);
}

static void refuses_before_the_first_byte(void)
{
    static const double big[] = {0, 0, 0, 1e39, 0, 0, 0, 1, 0},
                        bad[] = {0, 0, 0, NAN, 0, 0, 0, 1, 0};
    static const double good[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    static const uint32_t triangle[] = {0, 1, 2}, beyond[] = {0, 1, 3};
    sf_mesh_view too_big = {big, 3, triangle, 1}, no_number = {bad, 3, triangle, 1};
    sf_mesh_view no_vertex = {good, 3, beyond, 1}, fine = {good, 3, triangle, 1};
    memory_sink sink = empty_sink();
    sf_sink out = {sink_write, &sink}, none = {NULL, NULL};
    CHECK_EQ(sf_mesh_write(too_big, SF_MESH_FORMAT_STL, out), SF_ERR_OVERFLOW);
    for (sf_mesh_format format = SF_MESH_FORMAT_STL; format <= SF_MESH_FORMAT_PLY; format++) {
        CHECK_EQ(sf_mesh_write(no_number, format, out), SF_ERR_ARGUMENT);
        CHECK_EQ(sf_mesh_write(no_vertex, format, out), SF_ERR_ARGUMENT);
        CHECK_EQ(sf_mesh_write(fine, format, none), SF_ERR_ARGUMENT);
    }
    CHECK_EQ(sf_mesh_write(fine, SF_MESH_FORMAT_AUTO, out), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_mesh_write(fine, (sf_mesh_format)17, out), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_mesh_write(fine, SF_MESH_FORMAT_OFF, out), SF_ERR_UNSUPPORTED);
    CHECK_EQ(sink.writes, 0);
    CHECK_EQ(sf_mesh_write(too_big, SF_MESH_FORMAT_PLY, out), SF_OK);
    free(sink.bytes);
}

int main(void)
{
    TEST(round_trips_exactly);
    TEST(stl_is_the_nearest_float);
    TEST(stl_has_normals);
    TEST(tells_of_a_failing_sink);
    TEST(refuses_before_the_first_byte);
    return test_finish();
}
