// SPDX-License-Identifier: MIT
// Why: a file of ours must be what other programs take for glTF: lengths that add up, bounds, light
// for colours. It is taken apart here without the library's reader; and read back, by tinygltf
// where it is there, as the same floats. Guards: issue 8 part 2 (GLB with colours), the strong
// guarantee of writers.

#include "gltf_files.h"

static sf_status into_file(void *user, const void *data, size_t size)
{
    put(user, data, size);
    return SF_OK;
}

static sf_status into_nothing(void *user, const void *data, size_t size)
{
    (void)data;
    long *left = user;
    *left -= (long)size;
    return *left < 0 ? SF_ERR_IO : SF_OK;
}

static const double points[12] = {0, 0, 0, 10.1, 0, 0, 0, -7.3, 0, 0, 0, 1e-3};
static const uint32_t corners[12] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
static const sf_mesh_view tetrahedron = {points, 4, corners, 4};
static const uint8_t colors[12] = {0, 10, 11, 127, 128, 254, 255, 1, 2, 64, 192, 32};

static uint32_t word(const file *f, size_t at)
{
    return (uint32_t)f->bytes[at] | (uint32_t)f->bytes[at + 1] << 8 |
           (uint32_t)f->bytes[at + 2] << 16 | (uint32_t)f->bytes[at + 3] << 24;
}

static void adds_up(void)
{
    for (int has_colors = 0; has_colors < 2; has_colors++) {
        static file f;
        sf_sink sink = {into_file, &f};
        char json[2048] = "";
        f.size = 0;
        CHECK_EQ(sf_gltf_write(tetrahedron, has_colors ? colors : NULL, sink), SF_OK);
        CHECK(memcmp(f.bytes, "glTF", 4) == 0 && memcmp(f.bytes + 16, "JSON", 4) == 0);
        CHECK_EQ(word(&f, 4), 2);
        CHECK_EQ(word(&f, 8), f.size);
        size_t length = word(&f, 12), bytes = word(&f, 20 + length);
        CHECK(length % 4 == 0 && memcmp(f.bytes + 24 + length, "BIN", 4) == 0);
        CHECK_EQ(28 + length + bytes, f.size);
        CHECK_EQ(bytes, 48 + 48 + (has_colors ? 32 : 0));
        memcpy(json, f.bytes + 20, length);
        CHECK(strstr(json, has_colors ? "\"byteLength\":128}]" : "\"byteLength\":96}]") != NULL);
        CHECK(strstr(json, "\"min\":[0,-7.300000190734863,0]") != NULL);
        CHECK(strstr(json, "\"max\":[10.100000381469727,0,0.0010000000474974513]") != NULL);
        CHECK((strstr(json, "COLOR_0") != NULL) == has_colors);
        CHECK(memcmp(f.bytes + 28 + length, corners, 48) == 0); // of a machine with low bytes first
    }
}

// sRGB's curve as IEC 61966-2-1 has it, by the C library's pow().
static void writes_light(void)
{
    static file f;
    static uint8_t all[3 * 256];
    static double many[3 * 256];
    sf_sink sink = {into_file, &f};
    sf_mesh_view view = {many, 256, corners, 4};
    for (int i = 0; i < 768; i++) {
        all[i] = (uint8_t)(i / 3);
    }
    f.size = 0;
    CHECK_EQ(sf_gltf_write(view, all, sink), SF_OK);
    const unsigned char *at = f.bytes + f.size - 256 * 8;
    for (int i = 0; i < 256; i++, at += 8) {
        double v = i / 255.0, light = v <= 0.04045 ? v / 12.92 : pow((v + 0.055) / 1.055, 2.4);
        CHECK_NEAR(at[0] + 256 * at[1], 65535 * light, 0.5001);
        CHECK(memcmp(at, at + 2, 2) == 0 && memcmp(at, at + 4, 2) == 0);
        CHECK_EQ(at[6] + 256 * at[7], 65535);
    }
}

static void comes_back(void)
{
    static file f;
    sf_sink sink = {into_file, &f};
    sf_mesh *mesh = NULL;
    if (!sf_gltf_is_served()) {
        SKIP("this build does not read glTF");
    }
    f.size = 0;
    CHECK_EQ(sf_mesh_write(tetrahedron, SF_MESH_FORMAT_GLTF, sink), SF_OK);
    CHECK_EQ(read_bytes(f.bytes, f.size, SF_MESH_FORMAT_AUTO, NULL, NULL, &mesh, NULL), SF_OK);
    sf_mesh_view back = sf_mesh_get_view(mesh);
    CHECK(back.vertex_count == 4 && back.triangle_count == 4);
    for (size_t i = 0; i < 12 && back.vertex_count == 4; i++) {
        CHECK(back.vertices[i] == (double)(float)points[i] && back.triangles[i] == corners[i]);
    }
    sf_mesh_destroy(mesh);
}

static void refuses(void)
{
    static file f;
    sf_sink sink = {into_file, &f}, none = {NULL, NULL};
    sf_mesh_view empty = {points, 4, NULL, 0};
    double far[12];
    uint32_t beyond[3] = {0, 1, 4};
    sf_mesh_view large = {far, 4, corners, 4}, broken = {points, 4, beyond, 1};
    memcpy(far, points, sizeof far);
    far[5] = 1e39;
    f.size = 0;
    CHECK_EQ(sf_gltf_write(tetrahedron, colors, none), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_gltf_write(empty, NULL, sink), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_gltf_write(large, NULL, sink), SF_ERR_OVERFLOW);
    CHECK(sf_gltf_write(broken, NULL, sink) != SF_OK);
    CHECK_EQ(f.size, 0); // nothing was written
    CHECK_EQ(sf_mesh_format_from_name("a.GLB"), SF_MESH_FORMAT_GLTF);
    CHECK_EQ(sf_mesh_format_from_name("a.gltf"), SF_MESH_FORMAT_GLTF);
}

// A disk that is full after any number of bytes is passed on.
static void passes_a_full_disk_on(void)
{
    static file f;
    sf_sink sink = {into_file, &f};
    f.size = 0;
    CHECK_EQ(sf_gltf_write(tetrahedron, colors, sink), SF_OK);
    for (long room = 0; room <= (long)f.size; room++) {
        long left = room;
        sf_sink small = {into_nothing, &left};
        CHECK_EQ(sf_gltf_write(tetrahedron, colors, small),
                 room < (long)f.size ? SF_ERR_IO : SF_OK);
    }
}

int main(void)
{
    TEST(adds_up);
    TEST(writes_light);
    TEST(comes_back);
    TEST(refuses);
    TEST(passes_a_full_disk_on);
    return test_finish();
}
