// SPDX-License-Identifier: MIT
// Why: glTF gives the same triangles in many ways, and moves them by a tree of nodes. Whatever the
// way, a box that was made here must come out where the specification puts it, in mm with z up, its
// outside outwards. Guards: issue 8 part 2. The files of shared/data are held against what another
// reader counted (their manifest).

#include "gltf_files.h"

typedef struct box {
    double low[3], high[3], volume; // 0: it is open, and has none
    size_t triangles;
} box;

static const box plain = {{0, -3, 0}, {1, 0, 2}, 6, 12};

static int lies_at(const sf_mesh *mesh, const box *b, const char *what)
{
    double low[3], high[3];
    sf_mass mass;
    sf_mesh_view view = sf_mesh_get_view(mesh);
    int good = sf_mesh_bounds(view, low, high) == SF_OK && sf_mesh_measure(view, &mass) == SF_OK &&
               view.triangle_count == b->triangles &&
               (b->volume == 0 || fabs(mass.volume_mm3 - b->volume) < 1e-5 * b->volume);
    for (int i = 0; good && i < 3; i++) {
        good = fabs(low[i] - b->low[i]) < 1e-5 && fabs(high[i] - b->high[i]) < 1e-5;
    }
    if (!good) {
        printf("# %s: %zu triangles, volume %g, (%g %g %g) to (%g %g %g)\n", what,
               view.triangle_count, mass.volume_mm3, low[0], low[1], low[2], high[0], high[1],
               high[2]);
    }
    return good;
}

static void must_lie(const file *f, const box *b, const char *what)
{
    sf_mesh *mesh = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_status status = read_gltf(f->bytes, f->size, NULL, NULL, &mesh, NULL, &fault);
    CHECK_EQ(status, SF_OK);
    if (status != SF_OK) {
        printf("# %s: %s\n", what, fault.message);
    } else {
        CHECK(lies_at(mesh, b, what));
    }
    sf_mesh_destroy(mesh);
}

static void must_read(const char *json, const file *arrays, const box *b)
{
    static file f;
    make_glb(&f, json, arrays);
    must_lie(&f, b, json);
}

// ---------------------------------------------------------------------------------------------
// Numbers
// ---------------------------------------------------------------------------------------------

static void reads_every_kind_of_corner(void)
{
    static const int kind[3] = {5121, 5123, 5125}, size[3] = {1, 2, 4};
    static file arrays;
    char json[1200];
    for (int i = 0; i < 3; i++) {
        put_box(&arrays, size[i]);
        snprintf(json, sizeof json,
                 GLTF_HEAD GLTF_SCENE GLTF_NODE GLTF_MESH
                 "\"bufferViews\":[{\"buffer\":0,\"byteLength\":%d},{\"buffer\":0,"
                 "\"byteOffset\":%d,\"byteLength\":96}],\"accessors\":[{\"bufferView\":0,"
                 "\"componentType\":%d,\"count\":36,\"type\":\"SCALAR\"},{\"bufferView\":1,"
                 "\"componentType\":5126,\"count\":8,\"type\":\"VEC3\"}],"
                 "\"buffers\":[{\"byteLength\":%d}]}",
                 36 * size[i], 36 * size[i], kind[i], 36 * size[i] + 96);
        must_read(json, &arrays, &plain);
    }
}

// 24 bytes from vertex to vertex, of which the middle twelve are the position.
static void reads_interleaved(void)
{
    static file arrays;
    put_box(&arrays, 1);
    arrays.size = 36;
    for (int i = 0; i < 64; i++) {
        put_float(&arrays, i % 8 >= 2 && i % 8 < 5 ? box_number(i / 8, i % 8 - 2) : 7, 0);
    }
    must_read(GLTF_HEAD GLTF_SCENE GLTF_NODE GLTF_MESH
              "\"bufferViews\":[{\"buffer\":0,\"byteLength\":36},{\"buffer\":0,\"byteOffset\":36,"
              "\"byteLength\":256,\"byteStride\":32}],\"accessors\":[{\"bufferView\":0,"
              "\"componentType\":5121,\"count\":36,\"type\":\"SCALAR\"},{\"bufferView\":1,"
              "\"byteOffset\":8,\"componentType\":5126,\"count\":8,\"type\":\"VEC3\"}],"
              "\"buffers\":[{\"byteLength\":292}]}",
              &arrays, &plain);
}

// All zeros, or all as they are but some; the others stand in lists of places and values.
static void reads_sparse(void)
{
    static file arrays;
    for (int has_base = 0; has_base < 2; has_base++) {
        char json[1500];
        put_box(&arrays, 1);
        for (int i = 0; i < 24 && has_base; i++) { // spoilt, to be mended by the values
            memset(arrays.bytes + 36 + 12, 0x3f, 84);
        }
        for (int i = 1; i < 8; i++) {
            put_bits(&arrays, (uint64_t)i, 1, 0);
        }
        put_bits(&arrays, 0, 1, 0);
        for (int i = 3; i < 24; i++) {
            put_float(&arrays, box_number(i / 3, i % 3), 0);
        }
        snprintf(json, sizeof json,
                 GLTF_HEAD GLTF_SCENE GLTF_NODE GLTF_MESH
                 "\"bufferViews\":[{\"buffer\":0,\"byteLength\":36},{\"buffer\":0,\"byteOffset\":"
                 "36,\"byteLength\":96},{\"buffer\":0,\"byteOffset\":132,\"byteLength\":7},"
                 "{\"buffer\":0,\"byteOffset\":140,\"byteLength\":84}],\"accessors\":[{"
                 "\"bufferView\":0,\"componentType\":5121,\"count\":36,\"type\":\"SCALAR\"},{%s"
                 "\"componentType\":5126,\"count\":8,\"type\":\"VEC3\",\"sparse\":{\"count\":7,"
                 "\"indices\":{\"bufferView\":2,\"componentType\":5121},\"values\":{"
                 "\"bufferView\":3}}}],\"buffers\":[{\"byteLength\":224}]}",
                 has_base ? "\"bufferView\":1," : "");
        must_read(json, &arrays, &plain);
    }
}

// KHR_mesh_quantization: whole numbers, as they are or as fractions, and a node that scales them.
static void reads_quantized(void)
{
    static const struct {
        int kind, size, one;
        const char *normalized, *scale;
    } kinds[] = {{5120, 1, 127, "true", "0.001,0.002,0.003"},
                 {5121, 1, 255, "true", "0.001,0.002,0.003"},
                 {5122, 2, 32767, "true", "0.001,0.002,0.003"},
                 {5123, 2, 65535, "true", "0.001,0.002,0.003"},
                 {5121, 1, 200, "false", "0.000005,0.00001,0.000015"},
                 {5123, 2, 50000, "false", "0.00000002,0.00000004,0.00000006"}};
    for (size_t i = 0; i < sizeof kinds / sizeof kinds[0]; i++) {
        static file arrays;
        char json[1500];
        int stride = 4 * kinds[i].size;
        put_box(&arrays, 1);
        arrays.size = 36;
        for (int k = 0; k < 32; k++) {
            int value = k % 4 < 3 ? (k / 4 >> k % 4 & 1) * kinds[i].one : 99;
            put_bits(&arrays, (uint64_t)value, kinds[i].size, 0);
        }
        snprintf(json, sizeof json,
                 GLTF_HEAD "\"extensionsRequired\":[\"KHR_mesh_quantization\"]," GLTF_SCENE
                           "\"nodes\":[{\"mesh\":0,\"scale\":[%s]}]," GLTF_MESH
                           "\"bufferViews\":[{\"buffer\":0,\"byteLength\":36},{\"buffer\":0,"
                           "\"byteOffset\":36,\"byteLength\":%d,\"byteStride\":%d}],"
                           "\"accessors\":[{\"bufferView\":0,\"componentType\":5121,\"count\":36,"
                           "\"type\":\"SCALAR\"},{\"bufferView\":1,\"componentType\":%d,"
                           "\"normalized\":%s,\"count\":8,\"type\":\"VEC3\"}],"
                           "\"buffers\":[{\"byteLength\":%d}]}",
                 kinds[i].scale, 8 * stride, stride, kinds[i].kind, kinds[i].normalized,
                 36 + 8 * stride);
        must_read(json, &arrays, &plain);
    }
}

// ---------------------------------------------------------------------------------------------
// Triangles
// ---------------------------------------------------------------------------------------------

// A tetrahedron by its legs of 1 mm, as a list without corners, a strip and a fan.
static void reads_strips_and_fans(void)
{
    static const int list[12] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
    static const int strip[6] = {0, 2, 1, 3, 0, 2}, fan[5] = {0, 2, 1, 3, 2};
    static const struct {
        const int *corners;
        int mode, count;
        box is;
    } kinds[] = {{list, 4, 12, {{0, -1, 0}, {1, 0, 1}, 1 / 6.0, 4}},
                 {strip, 5, 6, {{0, -1, 0}, {1, 0, 1}, 1 / 6.0, 4}},
                 {fan, 6, 5, {{0, -1, 0}, {1, 0, 1}, 0, 3}}};
    for (int i = 0; i < 3; i++) {
        static file arrays;
        char json[1200];
        arrays.size = 0;
        for (int k = 0; k < 3 * kinds[i].count; k++) {
            put_float(&arrays, kinds[i].corners[k / 3] == k % 3 + 1 ? 0.001 : 0, 0);
        }
        snprintf(json, sizeof json,
                 GLTF_HEAD GLTF_SCENE GLTF_NODE
                 "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"mode\":%d}]}],"
                 "\"bufferViews\":[{\"buffer\":0,\"byteLength\":%zu}],\"accessors\":[{"
                 "\"bufferView\":0,\"componentType\":5126,\"count\":%d,\"type\":\"VEC3\"}],"
                 "\"buffers\":[{\"byteLength\":%zu}]}",
                 kinds[i].mode, arrays.size, kinds[i].count, arrays.size);
        must_read(json, &arrays, &kinds[i].is);
    }
}

// ---------------------------------------------------------------------------------------------
// Nodes
// ---------------------------------------------------------------------------------------------

// The box under nodes. In glTF's axes it reaches to (1, 2, 3) mm; all moves are in metres.
static void places_nodes(void)
{
    static const struct {
        const char *nodes;
        box is;
    } kinds[] = {
        // Moved by (10, 20, 30) mm.
        {"{\"mesh\":0,\"translation\":[0.01,0.02,0.03]}", {{10, -33, 20}, {11, -30, 22}, 6, 12}},
        // The same as a matrix, column after column.
        {"{\"mesh\":0,\"matrix\":[1,0,0,0,0,1,0,0,0,0,1,0,0.01,0.02,0.03,1]}",
         {{10, -33, 20}, {11, -30, 22}, 6, 12}},
        // A quarter turn about y, by a quaternion of another length: (x, y, z) to (z, y, -x).
        {"{\"mesh\":0,\"rotation\":[0,2,0,2]}", {{0, 0, 0}, {3, 1, 2}, 6, 12}},
        // Scaled, then turned, then moved.
        {"{\"mesh\":0,\"scale\":[2,1,1],\"rotation\":[0,0.70710678118654757,0,0.70710678118654757],"
         "\"translation\":[0,0,0.004]}",
         {{0, -4, 0}, {3, -2, 2}, 12, 12}},
        // Mirrored: the outside must stay outside.
        {"{\"mesh\":0,\"scale\":[-1,1,1]}", {{-1, -3, 0}, {0, 0, 2}, 6, 12}},
        // A child of a child: (x + 1) * 2 + 4, in mm.
        {"{\"children\":[1],\"translation\":[0.004,0,0]},{\"children\":[2],\"scale\":[2,2,2]},"
         "{\"mesh\":0,\"translation\":[0.001,0,0]}",
         {{6, -6, 0}, {8, 0, 4}, 48, 12}},
        // One mesh in two places.
        {"{\"children\":[1,2]},{\"mesh\":0},{\"mesh\":0,\"translation\":[0.01,0,0]}",
         {{0, -3, 0}, {11, 0, 2}, 12, 24}},
        // A node that is in no scene is not shown.
        {"{\"mesh\":0},{\"mesh\":0,\"translation\":[5,0,0]}", {{0, -3, 0}, {1, 0, 2}, 6, 12}},
    };
    for (size_t i = 0; i < sizeof kinds / sizeof kinds[0]; i++) {
        static file arrays;
        char json[1500];
        put_box(&arrays, 1);
        snprintf(json, sizeof json,
                 GLTF_HEAD GLTF_SCENE "\"nodes\":[%s]," GLTF_MESH GLTF_VIEWS GLTF_LISTS GLTF_BUFFER,
                 kinds[i].nodes);
        must_read(json, &arrays, &kinds[i].is);
    }
}

// Without scenes all nodes are shown that are nobody's child; without a default, the first scene.
static void chooses_a_scene(void)
{
    static file arrays;
    static const box two = {{0, -3, 0}, {11, 0, 2}, 12, 24};
    static const box second = {{10, -3, 0}, {11, 0, 2}, 6, 12};
#define TWO_NODES "\"nodes\":[{\"mesh\":0},{\"mesh\":0,\"translation\":[0.01,0,0]}],"
#define REST GLTF_MESH GLTF_VIEWS GLTF_LISTS GLTF_BUFFER
    put_box(&arrays, 1);
    must_read(GLTF_HEAD TWO_NODES REST, &arrays, &two);
    must_read(GLTF_HEAD "\"scenes\":[{\"nodes\":[1]},{\"nodes\":[0]}]," TWO_NODES REST, &arrays,
              &second);
    must_read(GLTF_HEAD "\"scene\":1,\"scenes\":[{\"nodes\":[0]},{\"nodes\":[1]}]," TWO_NODES REST,
              &arrays, &second);
}

// What is not read is counted, not lost without a word.
static void counts_what_is_passed_over(void)
{
    static file f;
    sf_mesh *mesh = NULL;
    sf_gltf_report report;
    make_plain_glb(
        &f, GLTF_HEAD GLTF_SCENE
        "\"nodes\":[{\"mesh\":0,\"skin\":0,\"children\":[1]},{}],\"skins\":[{\"joints\":[1]}],"
        "\"animations\":[{\"channels\":[],\"samplers\":[]}],\"materials\":[{}],"
        "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":1},\"indices\":0,"
        "\"targets\":[{\"POSITION\":1}]},{\"attributes\":{\"POSITION\":1},\"mode\":1}]}]"
        "," GLTF_VIEWS GLTF_LISTS GLTF_BUFFER);
    CHECK_EQ(read_gltf(f.bytes, f.size, NULL, NULL, &mesh, &report, NULL), SF_OK);
    CHECK_EQ(report.nodes, 2);
    CHECK_EQ(report.pieces, 1);
    CHECK_EQ(report.passed, 1);
    CHECK_EQ(report.skinned, 1);
    CHECK_EQ(report.morphed, 1);
    CHECK_EQ(report.animations, 1);
    sf_mesh_destroy(mesh);
}

// ---------------------------------------------------------------------------------------------
// Where bytes come from
// ---------------------------------------------------------------------------------------------

typedef struct shelf {
    file *f;
    sf_memory_cursor cursor;
    char asked[64];
    int open;
} shelf;

static sf_status open_shelf(void *user, const char *name, sf_source *source)
{
    shelf *s = user;
    snprintf(s->asked, sizeof s->asked, "%s", name);
    if (strcmp(name, "box 1.bin") != 0) {
        return SF_ERR_IO;
    }
    s->cursor.data = s->f->bytes, s->cursor.size = s->f->size, s->cursor.position = 0;
    s->open++;
    *source = sf_memory_source(&s->cursor);
    return SF_OK;
}

static void close_shelf(void *user, sf_source source)
{
    (void)source;
    ((shelf *)user)->open--;
}

static void reads_text_with_a_buffer(const char *uri, const sf_folder *folder, sf_status expected)
{
    char json[2000];
    sf_mesh *mesh = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_gltf_options options = sf_gltf_options_default();
    options.folder = folder;
    snprintf(json, sizeof json,
             GLTF_HEAD GLTF_SCENE GLTF_NODE GLTF_MESH GLTF_VIEWS GLTF_LISTS
             "\"buffers\":[{\"byteLength\":132,\"uri\":\"%s\"}]}",
             uri);
    sf_status status = read_gltf(json, strlen(json), &options, NULL, &mesh, NULL, &fault);
    CHECK_EQ(status, expected);
    if (status == SF_OK) {
        CHECK(lies_at(mesh, &plain, uri));
    } else {
        CHECK(refused_well(status, &fault, mesh));
    }
    sf_mesh_destroy(mesh);
}

static void encode(const file *f, char *text)
{
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (size_t i = 0; i < f->size; i += 3) { // the size is a multiple of three
        uint32_t bits =
            (uint32_t)f->bytes[i] << 16 | (uint32_t)f->bytes[i + 1] << 8 | f->bytes[i + 2];
        for (int k = 3; k >= 0; k--) {
            *text++ = digits[bits >> 6 * k & 63];
        }
    }
    *text = '\0';
}

static void reads_buffers_of_text_files(void)
{
    static file arrays;
    char uri[400] = "data:application/octet-stream;base64,";
    shelf s = {&arrays, {NULL, 0, 0}, "", 0};
    sf_folder folder = {open_shelf, close_shelf, NULL, NULL, &s};
    put_box(&arrays, 1);
    encode(&arrays, uri + strlen(uri));
    reads_text_with_a_buffer(uri, NULL, SF_OK);
    reads_text_with_a_buffer("box%201.bin", &folder, SF_OK);
    CHECK_STR(s.asked, "box 1.bin");
    reads_text_with_a_buffer("other.bin", &folder, SF_ERR_IO);
    reads_text_with_a_buffer("box%201.bin", NULL, SF_ERR_IO);
    CHECK_EQ(s.open, 0);
    arrays.size--; // a file that is cut short
    reads_text_with_a_buffer("box%201.bin", &folder, SF_ERR_FORMAT);
}

// Nothing but plain names is ever asked of a folder.
static void follows_no_path(void)
{
    static const char *const paths[] = {"../box 1.bin",
                                        "..%2fbox 1.bin",
                                        "/box 1.bin",
                                        "a/box 1.bin",
                                        "a\\\\box 1.bin",
                                        "..",
                                        ".",
                                        "file:box 1.bin",
                                        "c:box 1.bin",
                                        "http://x/box 1.bin",
                                        "",
                                        "%2e%2e",
                                        "box 1.bin%00.x",
                                        "./box 1.bin",
                                        "%2e%2e%5cbox 1.bin"};
    static file arrays;
    shelf s = {&arrays, {NULL, 0, 0}, "", 0};
    sf_folder folder = {open_shelf, close_shelf, NULL, NULL, &s};
    put_box(&arrays, 1);
    for (size_t i = 0; i < sizeof paths / sizeof paths[0]; i++) {
        reads_text_with_a_buffer(paths[i], &folder, SF_ERR_IO);
        CHECK_STR(s.asked, "");
    }
}

// Pictures, in the file or beside it, are not looked at, however broken.
static void opens_no_picture(void)
{
    static file f;
    shelf s = {&f, {NULL, 0, 0}, "", 0};
    sf_folder folder = {open_shelf, close_shelf, NULL, NULL, &s};
    sf_gltf_options options = sf_gltf_options_default();
    sf_mesh *mesh = NULL;
    options.folder = &folder;
    make_plain_glb(
        &f, GLTF_HEAD GLTF_SCENE GLTF_NODE GLTF_MESH GLTF_VIEWS GLTF_LISTS
        "\"images\":[{\"uri\":\"skin.png\"},{\"bufferView\":0,\"mimeType\":\"image/png\"}]"
        "," GLTF_BUFFER);
    CHECK_EQ(read_gltf(f.bytes, f.size, &options, NULL, &mesh, NULL, NULL), SF_OK);
    CHECK_STR(s.asked, "");
    sf_mesh_destroy(mesh);
}

// ---------------------------------------------------------------------------------------------
// Real files
// ---------------------------------------------------------------------------------------------

static void reads_real_files(void)
{
    // From the manifest, turned: x, -z, y, in mm.
    static const struct {
        const char *path;
        size_t triangles;
        double low[3], high[3];
    } known[] = {
        {"BoxInterleaved.glb", 12, {-500, -500, -500}, {500, 500, 500}},
        {"Duck.glb", 4212, {-692.985, -539.252, 99.2937}, {961.799, 613.282, 1639.7}},
        {"monkey.glb", 968, {-1367.19, -851.562, -984.375}, {1367.19, 851.562, 984.375}},
        {"BoxWithInfinites.glb", 0, {0, 0, 0}, {0, 0, 0}},
    };
    if (getenv("SF_DATA") == NULL) {
        SKIP("SF_DATA names no folder");
    }
    for (size_t i = 0; i < sizeof known / sizeof known[0]; i++) {
        char name[1024];
        double low[3] = {0, 0, 0}, high[3] = {0, 0, 0};
        sf_file *opened = NULL;
        sf_mesh *mesh = NULL;
        sf_fault fault = {SF_OK, 0, 0, ""};
        snprintf(name, sizeof name, "%s/gltf/%s", getenv("SF_DATA"), known[i].path);
        CHECK_EQ(sf_file_open(name, NULL, &opened, NULL), SF_OK);
        sf_status status =
            sf_mesh_read(sf_file_source(opened), SF_MESH_FORMAT_AUTO, NULL, NULL, &mesh, &fault);
        sf_file_close(opened);
        if (known[i].triangles == 0) {
            CHECK(refused_well(status, &fault, mesh) && strstr(fault.message, "not a number"));
            continue;
        }
        CHECK_EQ(status, SF_OK);
        CHECK_EQ(sf_mesh_get_view(mesh).triangle_count, known[i].triangles);
        CHECK(mesh != NULL && sf_mesh_bounds(sf_mesh_get_view(mesh), low, high) == SF_OK);
        for (int k = 0; k < 3; k++) {
            CHECK_NEAR(low[k], known[i].low[k], 0.006);
            CHECK_NEAR(high[k], known[i].high[k], 0.006);
        }
        sf_mesh_destroy(mesh);
    }
}

int main(void)
{
    if (!sf_gltf_is_served()) {
        printf("1..0 # SKIP this build does not read glTF\n");
        return 0;
    }
    TEST(reads_every_kind_of_corner);
    TEST(reads_interleaved);
    TEST(reads_sparse);
    TEST(reads_quantized);
    TEST(reads_strips_and_fans);
    TEST(places_nodes);
    TEST(chooses_a_scene);
    TEST(counts_what_is_passed_over);
    TEST(reads_buffers_of_text_files);
    TEST(follows_no_path);
    TEST(opens_no_picture);
    TEST(reads_real_files);
    return test_finish();
}
