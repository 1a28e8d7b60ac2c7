// SPDX-License-Identifier: MIT
// Why: glTF is JSON that points into arrays that point into buffers, each number of which may lie,
// and it is parsed by a library that was not made for liars. What must not be read is refused with
// a sentence, costs no memory in proportion to what a file claims, and leaves nothing behind.
// Guards: issue 8 part 2, TRUST B4, B5, B10, the strong guarantee under a failing allocator.

#include "gltf_files.h"

static int refused(const file *f, sf_status expected, const char *words)
{
    sf_mesh *mesh = NULL;
    sf_gltf_report report = {99, 0, 0, 0, 0, 0};
    sf_fault fault = {SF_OK, 0, 0, ""};
    failing_allocator memory;
    failing_begin(&memory, -1);
    sf_status status =
        read_gltf(f->bytes, f->size, NULL, &memory.allocator, &mesh, &report, &fault);
    int good = status == expected && refused_well(status, &fault, mesh) && report.nodes == 99 &&
               strstr(fault.message, words) != NULL && memory.live == 0 && memory.faults == 0;
    if (!good) {
        printf("# expected \"%s\"; got %s: \"%s\"\n", words, sf_status_name(status), fault.message);
    }
    sf_mesh_destroy(mesh);
    return good;
}

static int json_refused(const char *json, sf_status expected, const char *words)
{
    static file f;
    make_plain_glb(&f, json);
    return refused(&f, expected, words);
}

static void refuses_broken_heads(void)
{
    static file f;
    make_plain_glb(&f, GLTF_PLAIN);
    f.bytes[4] = 1;
    CHECK(refused(&f, SF_ERR_UNSUPPORTED, "version 1"));
    make_plain_glb(&f, GLTF_PLAIN);
    f.bytes[16] = 'X';
    CHECK(refused(&f, SF_ERR_FORMAT, "chunk"));
    make_plain_glb(&f, GLTF_PLAIN);
    memset(f.bytes + 12, 0xff, 4);
    CHECK(refused(&f, SF_ERR_FORMAT, "chunk"));
    make_plain_glb(&f, GLTF_PLAIN);
    memset(f.bytes + 8, 0xff, 4);
    CHECK(refused(&f, SF_ERR_FORMAT, "cut short"));
    f.size = 12;
    CHECK(refused(&f, SF_ERR_FORMAT, "cut short"));
    f.size = 0;
    CHECK(refused(&f, SF_ERR_FORMAT, "glTF"));
}

static void refuses_broken_json(void)
{
    CHECK(json_refused("{\"asset\":", SF_ERR_FORMAT, "glTF 2.0"));
    CHECK(json_refused("[1, 2, 3]", SF_ERR_FORMAT, "JSON object"));
    CHECK(json_refused("{\"meshes\":[]}", SF_ERR_FORMAT, "asset"));
    CHECK(json_refused("{\"asset\":{\"version\":\"1.0\"}}", SF_ERR_UNSUPPORTED, "version"));
    CHECK(json_refused("{\"asset\":{\"version\":\"2.0\"}}", SF_ERR_FORMAT, "no nodes"));
    CHECK(json_refused(GLTF_HEAD "\"nodes\":[{}]}", SF_ERR_FORMAT, "no triangles"));
    CHECK(json_refused(GLTF_HEAD "\"nodes\":[7]}", SF_ERR_FORMAT, "nodes"));
}

#define BEHIND GLTF_MESH GLTF_VIEWS GLTF_LISTS GLTF_BUFFER

static void refuses_broken_trees(void)
{
    CHECK(json_refused(GLTF_HEAD GLTF_SCENE "\"nodes\":[{\"mesh\":0,\"children\":[0]}]," BEHIND,
                       SF_ERR_FORMAT, "twice"));
    CHECK(json_refused(GLTF_HEAD GLTF_SCENE
                       "\"nodes\":[{\"children\":[1,2]},{\"children\":[2]},{\"mesh\":0}]," BEHIND,
                       SF_ERR_FORMAT, "twice"));
    CHECK(json_refused(GLTF_HEAD "\"scenes\":[{\"nodes\":[1]}]," GLTF_NODE BEHIND, SF_ERR_FORMAT,
                       "not there"));
    CHECK(json_refused(GLTF_HEAD GLTF_SCENE "\"nodes\":[{\"children\":[-1]}]," BEHIND,
                       SF_ERR_FORMAT, "not there"));
    CHECK(json_refused(GLTF_HEAD GLTF_SCENE "\"nodes\":[{\"mesh\":1}]," BEHIND, SF_ERR_FORMAT,
                       "mesh that is not there"));
    static const char *const places[] = {"\"matrix\":[1,2,3]",
                                         "\"scale\":[1,2]",
                                         "\"rotation\":[0,0,0,0]",
                                         "\"rotation\":[1]",
                                         "\"matrix\":[1,0,0,1,0,1,0,0,0,0,1,0,0,0,0,1]",
                                         "\"translation\":[0,0,0,0]"};
    for (size_t i = 0; i < sizeof places / sizeof places[0]; i++) {
        char json[1500];
        snprintf(json, sizeof json, GLTF_HEAD GLTF_SCENE "\"nodes\":[{\"mesh\":0,%s}]," BEHIND,
                 places[i]);
        CHECK(json_refused(json, SF_ERR_FORMAT, "matrix, rotation"));
    }
    CHECK(json_refused(GLTF_HEAD GLTF_SCENE
                       "\"nodes\":[{\"mesh\":0,\"scale\":[1e308,1e308,1e308]}]," BEHIND,
                       SF_ERR_FORMAT, "ertex"));
}

// Each number of a view and a list, as a liar would have it.
static void refuses_arrays_outside_of_buffers(void)
{
    static const struct {
        const char *views, *lists;
    } lies[] = {
        {"{\"buffer\":1,\"byteLength\":36}", NULL},
        {"{\"buffer\":-1,\"byteLength\":36}", NULL},
        {"{\"buffer\":0,\"byteLength\":133}", NULL},
        {"{\"buffer\":0,\"byteOffset\":18446744073709551615,\"byteLength\":36}", NULL},
        {"{\"buffer\":0,\"byteOffset\":97,\"byteLength\":36}", NULL},
        {NULL, "\"bufferView\":2,\"componentType\":5121,\"count\":36"},
        {NULL, "\"bufferView\":0,\"componentType\":5121,\"count\":37"},
        {NULL, "\"bufferView\":0,\"componentType\":5125,\"count\":36"},
        {NULL, "\"bufferView\":0,\"componentType\":5121,\"count\":18446744073709551615"},
        {NULL, "\"bufferView\":0,\"componentType\":5125,\"count\":4611686018427387905"},
        {NULL, "\"bufferView\":0,\"byteOffset\":1,\"componentType\":5121,\"count\":36"},
        {NULL, "\"bufferView\":0,\"byteOffset\":18446744073709551615,\"componentType\":5121,"
               "\"count\":36"},
        {NULL, "\"bufferView\":0,\"componentType\":5121,\"count\":0"},
        {NULL, "\"bufferView\":0,\"componentType\":5130,\"count\":4"},
        {NULL, "\"bufferView\":0,\"componentType\":5120,\"count\":36"},
        {NULL, "\"bufferView\":0,\"componentType\":5126,\"count\":9"},
        {NULL, "\"componentType\":5121,\"count\":36"},
    };
    for (size_t i = 0; i < sizeof lies / sizeof lies[0]; i++) {
        char json[1500];
        snprintf(json, sizeof json,
                 GLTF_HEAD GLTF_SCENE GLTF_NODE GLTF_MESH
                 "\"bufferViews\":[%s,{\"buffer\":0,\"byteOffset\":36,\"byteLength\":96}],"
                 "\"accessors\":[{%s,\"type\":\"SCALAR\"},{\"bufferView\":1,\"componentType\":5126,"
                 "\"count\":8,\"type\":\"VEC3\"}]," GLTF_BUFFER,
                 lies[i].views != NULL ? lies[i].views : "{\"buffer\":0,\"byteLength\":36}",
                 lies[i].lists != NULL ? lies[i].lists
                                       : "\"bufferView\":0,\"componentType\":5121,\"count\":36");
        CHECK(json_refused(json, SF_ERR_FORMAT, ""));
    }
}

static void refuses_broken_meshes(void)
{
    static file f;
    static const char *const meshes[] = {
        "{\"attributes\":{\"POSITION\":0},\"indices\":0}", // one number a vertex
        "{\"attributes\":{\"POSITION\":1},\"indices\":1}", // three a corner
        "{\"attributes\":{\"POSITION\":9},\"indices\":0}",
        "{\"attributes\":{\"NORMAL\":1}}",
        "{\"attributes\":{\"POSITION\":1},\"indices\":0,\"mode\":7}",
        "{\"attributes\":{\"POSITION\":1},\"indices\":0,\"mode\":-1}"};
    for (size_t i = 0; i < sizeof meshes / sizeof meshes[0]; i++) {
        char json[1500];
        snprintf(json, sizeof json,
                 GLTF_HEAD GLTF_SCENE GLTF_NODE
                 "\"meshes\":[{\"primitives\":[%s]}]," GLTF_VIEWS GLTF_LISTS GLTF_BUFFER,
                 meshes[i]);
        CHECK(json_refused(json, SF_ERR_FORMAT, "mesh"));
    }
    make_plain_glb(&f, GLTF_PLAIN);
    f.bytes[f.size - 132 + 5] = 8; // a corner beyond the eighth vertex
    CHECK(refused(&f, SF_ERR_FORMAT, "vertex 8"));
    make_plain_glb(&f, GLTF_PLAIN);
    memset(f.bytes + f.size - 8, 0xff, 4); // not a number
    CHECK(refused(&f, SF_ERR_FORMAT, "not a number"));
}

static void refuses_extensions_that_change_the_shape(void)
{
    static const char *const names[] = {"KHR_draco_mesh_compression", "EXT_meshopt_compression",
                                        "EXT_mesh_gpu_instancing", "MADE_up"};
    for (size_t i = 0; i < 4; i++) {
        char json[1500];
        snprintf(json, sizeof json,
                 GLTF_HEAD "\"extensionsRequired\":[\"%s\"]," GLTF_SCENE GLTF_NODE BEHIND,
                 names[i]);
        CHECK(json_refused(json, SF_ERR_UNSUPPORTED, names[i]));
    }
}

// --- what costs more than it says ----------------------------------------------------------------

static int text_refused(char *text, size_t size, sf_status expected, const char *words)
{
    sf_mesh *mesh = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_status status = read_gltf(text, size, NULL, NULL, &mesh, NULL, &fault);
    int good = status == expected && refused_well(status, &fault, mesh) &&
               strstr(fault.message, words) != NULL;
    if (!good) {
        printf("# expected \"%s\"; got %s: \"%s\"\n", words, sf_status_name(status), fault.message);
    }
    free(text);
    return good;
}

// `count` times a piece of text, between two others.
static char *repeat(const char *before, const char *piece, size_t count, const char *after,
                    size_t *size)
{
    size_t one = strlen(piece), head = strlen(before), tail = strlen(after);
    char *text = malloc(head + count * one + tail);
    memcpy(text, before, head);
    for (size_t i = 0; i < count; i++) {
        memcpy(text + head + i * one, piece, one);
    }
    memcpy(text + head + count * one, after, tail);
    *size = head + count * one + tail;
    return text;
}

static void believes_no_count(void)
{
    size_t size;
    char *text = repeat(GLTF_HEAD "\"extras\":", "[", 5000000, "", &size);
    CHECK(text_refused(text, size, SF_ERR_OVERFLOW, "deeper"));
    text = repeat(GLTF_HEAD "\"materials\":[", "{},", 1000000, "{}]}", &size);
    CHECK(text_refused(text, size, SF_ERR_OVERFLOW, "objects"));
    text = repeat(GLTF_HEAD "\"extras\":[", "0,", 5000000, "0]}", &size);
    CHECK(text_refused(text, size, SF_ERR_OVERFLOW, "values"));
    // A name in escapes could hide a list of buffers.
    CHECK(json_refused(GLTF_HEAD "\"b\\u0075ffers\":[]}", SF_ERR_FORMAT, "escapes"));
    // An array of zeros that the file does not hold.
    CHECK(json_refused(GLTF_HEAD GLTF_SCENE GLTF_NODE GLTF_MESH GLTF_VIEWS
                       "\"accessors\":[{\"bufferView\":0,\"componentType\":5121,\"count\":36,"
                       "\"type\":\"SCALAR\"},{\"componentType\":5126,\"count\":4000000000,"
                       "\"type\":\"VEC3\",\"sparse\":{\"count\":1,\"indices\":{\"bufferView\":0,"
                       "\"componentType\":5121},\"values\":{\"bufferView\":1}}}]," GLTF_BUFFER,
                       SF_ERR_FORMAT, "of which the file holds"));
}

// Many buffers without a name are as many copies of the same bytes.
static void copies_no_bytes_without_end(void)
{
    size_t size, bytes = (size_t)1 << 20;
    char *json = repeat(GLTF_HEAD "\"buffers\":[", "{\"byteLength\":1048576},", 400,
                        "{\"byteLength\":4}]}", &size);
    size_t padded = (size + 3) / 4 * 4;
    unsigned char *glb = calloc(28 + padded + bytes, 1);
    uint32_t head[5] = {0x46546c67, 2, (uint32_t)(28 + padded + bytes), (uint32_t)padded,
                        0x4e4f534a};
    uint32_t chunk[2] = {(uint32_t)bytes, 0x004e4942};
    memcpy(glb, head, 20);
    memset(glb + 20, ' ', padded);
    memcpy(glb + 20, json, size);
    memcpy(glb + 20 + padded, chunk, 8);
    free(json);
    CHECK(text_refused((char *)glb, 28 + padded + bytes, SF_ERR_OVERFLOW, "buffers claim"));
}

// 3,000 lines that 3,000 nodes repeat: nothing is made of them, nine million times.
static void passes_no_lines_without_end(void)
{
    size_t node_size, line_size;
    char *nodes = repeat("", "{\"mesh\":0},", 2999, "{\"mesh\":0}", &node_size);
    char *lines = repeat("", "{\"mode\":1,\"attributes\":{\"POSITION\":0}},", 2999,
                         "{\"mode\":1,\"attributes\":{\"POSITION\":0}}", &line_size);
    char *json = malloc(node_size + line_size + 1000);
    int length = snprintf(json, node_size + line_size + 1000,
                          GLTF_HEAD "\"nodes\":[%.*s],\"meshes\":[{\"primitives\":[%.*s]}]}",
                          (int)node_size, nodes, (int)line_size, lines);
    free(nodes);
    free(lines);
    CHECK(text_refused(json, (size_t)length, SF_ERR_OVERFLOW, "repeat"));
}

// A mesh of 600 kB that 30,000 nodes repeat would be 30 GB.
static void repeats_no_mesh_without_end(void)
{
    size_t size, count = 50000;
    char *nodes = repeat("", "{\"mesh\":0},", 30000, "{\"mesh\":0}", &size);
    char *json = malloc(size + 1000);
    int length =
        snprintf(json, size + 1000,
                 GLTF_HEAD "\"nodes\":[%.*s],\"meshes\":[{\"primitives\":[{\"attributes\":{"
                           "\"POSITION\":0}}]}],\"bufferViews\":[{\"buffer\":0,"
                           "\"byteLength\":600000}],\"accessors\":[{\"bufferView\":0,"
                           "\"componentType\":5126,\"count\":50000,\"type\":\"VEC3\"}],"
                           "\"buffers\":[{\"byteLength\":600000}]}",
                 (int)size, nodes);
    size_t padded = ((size_t)length + 3) / 4 * 4, total = 28 + padded + 12 * count;
    unsigned char *glb = calloc(total, 1);
    uint32_t head[5] = {0x46546c67, 2, (uint32_t)total, (uint32_t)padded, 0x4e4f534a};
    uint32_t chunk[2] = {(uint32_t)(12 * count), 0x004e4942};
    memcpy(glb, head, 20);
    memset(glb + 20, ' ', padded);
    memcpy(glb + 20, json, (size_t)length);
    memcpy(glb + 20 + padded, chunk, 8);
    free(nodes);
    free(json);
    CHECK(text_refused((char *)glb, total, SF_ERR_OVERFLOW, "repeat"));
}

static void obeys_limits(void)
{
    static file f;
    static const struct {
        uint64_t bytes;
        size_t triangles, vertices;
        const char *words;
    } limits[] = {{400, 1000, 1000, "bytes_max"},
                  {1 << 20, 11, 1000, "triangles_max"},
                  {1 << 20, 1000, 7, "vertices_max"}};
    make_plain_glb(&f, GLTF_PLAIN);
    for (size_t i = 0; i < 3; i++) {
        sf_gltf_options options = sf_gltf_options_default();
        sf_mesh *mesh = NULL;
        sf_fault fault = {SF_OK, 0, 0, ""};
        options.limits.bytes_max = limits[i].bytes;
        options.limits.triangles_max = limits[i].triangles;
        options.limits.vertices_max = limits[i].vertices;
        sf_status status = read_gltf(f.bytes, f.size, &options, NULL, &mesh, NULL, &fault);
        CHECK_EQ(status, SF_ERR_OVERFLOW);
        CHECK(refused_well(status, &fault, mesh));
        CHECK(strstr(fault.message, limits[i].words) != NULL);
    }
}

// --- every cut, every byte, every allocation --------------------------------------------------

static int is_read_or_refused(const void *bytes, size_t size, const sf_allocator *allocator)
{
    sf_mesh *mesh = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_status status = read_gltf(bytes, size, NULL, allocator, &mesh, NULL, &fault);
    int good = status == SF_OK ? mesh != NULL : refused_well(status, &fault, mesh);
    if (status == SF_OK) {
        good = good && sf_mesh_validate(sf_mesh_get_view(mesh), NULL) == SF_OK;
    }
    if (!good) {
        printf("# %s: \"%s\"\n", sf_status_name(status), fault.message);
    }
    sf_mesh_destroy(mesh);
    return good;
}

static void survives_every_truncation(void)
{
    static file f;
    make_plain_glb(&f, GLTF_PLAIN);
    for (size_t size = 0; size < f.size; size++) {
        void *exact = malloc(size + !size); // so that a sanitizer sees the first byte too many
        memcpy(exact, f.bytes, size);
        sf_mesh *mesh = NULL;
        CHECK(read_gltf(exact, size, NULL, NULL, &mesh, NULL, NULL) != SF_OK);
        free(exact);
    }
}

static void survives_changed_bytes(void)
{
    static file f;
    static const unsigned char values[] = {0,   1,   0x7f, 0x80, 0xff, '"',
                                           '{', ']', ',',  '-',  '9',  'e'};
    make_plain_glb(&f, GLTF_PLAIN);
    for (size_t i = 0; i < f.size; i++) {
        for (size_t v = 0; v < sizeof values; v++) {
            unsigned char before = f.bytes[i];
            f.bytes[i] = values[v];
            CHECK(is_read_or_refused(f.bytes, f.size, NULL));
            f.bytes[i] = before;
        }
    }
}

static void survives_every_refused_allocation(void)
{
    static file f;
    sf_status status = SF_ERR_MEMORY;
    make_plain_glb(&f, GLTF_PLAIN);
    for (long k = 0; status != SF_OK && k < 1000; k++) {
        sf_mesh *mesh = NULL;
        sf_fault fault = {SF_OK, 0, 0, ""};
        failing_allocator memory;
        failing_begin(&memory, k);
        status = read_gltf(f.bytes, f.size, NULL, &memory.allocator, &mesh, NULL, &fault);
        CHECK(status == SF_OK || (status == SF_ERR_MEMORY && refused_well(status, &fault, mesh)));
        sf_mesh_destroy(mesh);
        CHECK(memory.live == 0 && memory.faults == 0);
    }
    CHECK_EQ(status, SF_OK);
}

static void refuses_wrong_arguments(void)
{
    sf_mesh *mesh = NULL;
    sf_source none = {NULL, NULL};
    sf_memory_cursor cursor = {"", 0, 0};
    sf_folder blind = {NULL, NULL, NULL, NULL, NULL};
    sf_gltf_options options = sf_gltf_options_default();
    options.folder = &blind;
    CHECK_EQ(sf_gltf_read(none, NULL, NULL, &mesh, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_gltf_read(sf_memory_source(&cursor), NULL, NULL, NULL, NULL, NULL),
             SF_ERR_ARGUMENT);
    CHECK_EQ(sf_gltf_read(sf_memory_source(&cursor), &options, NULL, &mesh, NULL, NULL),
             SF_ERR_ARGUMENT);
    CHECK(mesh == NULL);
}

int main(void)
{
    if (!sf_gltf_is_served()) {
        static file f;
        sf_mesh *mesh = NULL;
        sf_fault fault = {SF_OK, 0, 0, ""};
        make_plain_glb(&f, GLTF_PLAIN);
        int good =
            read_gltf(f.bytes, f.size, NULL, NULL, &mesh, NULL, &fault) == SF_ERR_UNSUPPORTED &&
            strstr(fault.message, "tinygltf") != NULL;
        printf("%s 1 - a build without tinygltf says so\n1..1\n", good ? "ok" : "not ok");
        return !good;
    }
    TEST(refuses_broken_heads);
    TEST(refuses_broken_json);
    TEST(refuses_broken_trees);
    TEST(refuses_arrays_outside_of_buffers);
    TEST(refuses_broken_meshes);
    TEST(refuses_extensions_that_change_the_shape);
    TEST(believes_no_count);
    TEST(copies_no_bytes_without_end);
    TEST(passes_no_lines_without_end);
    TEST(repeats_no_mesh_without_end);
    TEST(obeys_limits);
    TEST(survives_every_truncation);
    TEST(survives_changed_bytes);
    TEST(survives_every_refused_allocation);
    TEST(refuses_wrong_arguments);
    return test_finish();
}
