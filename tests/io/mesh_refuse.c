// SPDX-License-Identifier: MIT
// What must not be read is refused with one sentence that names a line or a byte, unless it is
// about the file as a whole, takes no memory in proportion to what a file claims, and leaves
// nothing behind. Guards: issue 2 (broken/), TRUST
// B4, B5, B6 (counts, indices and tokens from a file), and the strong guarantee under a failing
// allocator.

#include "files.h"

#define WHOLE UINT32_MAX // for a line: what is wrong is wrong with the file, and has no place

static int refused(const void *data, size_t size, sf_mesh_format format,
                   const sf_read_limits *limits, sf_status expected, const char *words,
                   uint32_t line)
{
    sf_mesh *mesh = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    failing_allocator memory;
    failing_begin(&memory, -1);
    sf_status status = read_bytes(data, size, format, limits, &memory.allocator, &mesh, &fault);
    int good = status == expected && refused_well(status, &fault, mesh) &&
               strstr(fault.message, words) != NULL && memory.live == 0 && memory.faults == 0;
    if (line == WHOLE) {
        good = good && fault.line == 0 && fault.offset == 0;
    } else {
        good = good && (line == 0 || fault.line == line) && (fault.line > 0 || fault.offset > 0);
    }
    if (!good) {
        printf("# expected \"%s\" at line %u; got %s, line %u, byte %llu: \"%s\"\n", words, line,
               sf_status_name(status), fault.line, (unsigned long long)fault.offset, fault.message);
    }
    sf_mesh_destroy(mesh);
    return good;
}

static int text_refused(const char *text, sf_mesh_format format, const char *words, uint32_t line)
{
    return refused(text, strlen(text), format, NULL, SF_ERR_FORMAT, words, line);
}

static void refuses_broken_text(void)
{
    // The twins of empty2.stl, invalidvertex.stl and inf_nan.obj.
    CHECK(
        text_refused("solid Model\nendsolid Model\n", SF_MESH_FORMAT_AUTO, "no triangles", WHOLE));
    CHECK(text_refused("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 zero\n",
                       SF_MESH_FORMAT_AUTO, "\"zero\"", 4));
    CHECK(text_refused("v inf nan +inf\nv nan -nan -Inf\nv 3 NaN 1\nf 1 2 3\n", SF_MESH_FORMAT_AUTO,
                       "not a number", 1));
    CHECK(text_refused("solid\nfacet\nvertex 0 0\nvertex 1 0 0\n", SF_MESH_FORMAT_STL, "cut short",
                       3));
    CHECK(text_refused("solid\nfacet\nvertex 0 0 0\nvertex 1 0 0\nendfacet\nendsolid\n",
                       SF_MESH_FORMAT_STL, "fewer than three", 5));
    CHECK(text_refused("solid\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n", SF_MESH_FORMAT_STL,
                       "endsolid", 0));
    CHECK(text_refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", SF_MESH_FORMAT_OBJ, "vertex 4", 4));
    CHECK(text_refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 0\n", SF_MESH_FORMAT_OBJ, "vertex 0", 4));
    CHECK(text_refused("v 0 0 0\nv 1 0 0\nv 0 1 0\n\nf 1 2 -4\n", SF_MESH_FORMAT_OBJ, "vertex -4",
                       5));
    CHECK(text_refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\n", SF_MESH_FORMAT_OBJ, "fewer than three",
                       4));
    CHECK(text_refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3.5\n", SF_MESH_FORMAT_OBJ, "\"3.5\"", 4));
    CHECK(text_refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 99999999999999999999\n",
                       SF_MESH_FORMAT_OBJ, "999", 4));
    CHECK(text_refused("v 0 1e999 0\n", SF_MESH_FORMAT_OBJ, "infinite", 1));
    CHECK(text_refused("v 0 1\nv 1 1 1\n", SF_MESH_FORMAT_OBJ, "cut short", 1));
    CHECK(text_refused("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", SF_MESH_FORMAT_AUTO,
                       "vertex 3", 6));
    CHECK(
        text_refused("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n", SF_MESH_FORMAT_AUTO, "fewer", 6));
    CHECK(text_refused("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n9999 0 1\n", SF_MESH_FORMAT_AUTO,
                       "cut short", 0));
    CHECK(text_refused("4OFF\n1 1 0\n", SF_MESH_FORMAT_OFF, "\"4OFF\"", 1));
    CHECK(text_refused("OFF BINARY\n\001\n", SF_MESH_FORMAT_OFF, "BINARY", 1));
    CHECK(text_refused("Dear reader, this is a letter.\n", SF_MESH_FORMAT_AUTO, "no STL, OBJ",
                       WHOLE));
    CHECK(text_refused("", SF_MESH_FORMAT_AUTO, "no STL, OBJ", WHOLE));
}

#define PLY_HEAD "ply\nformat ascii 1.0\n"
#define PLY_VERTEX "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
#define PLY_FACE "element face 1\nproperty list uchar int vertex_index\nend_header\n"
#define PLY_XYZ "0 0 0\n1 0 0\n0 1 0\n"

// A newcomer's first file is often one that cannot be read: the sentence says what it is.
static void names_foreign_formats(void)
{
    CHECK(refused("\211PNG\r\n", 6, SF_MESH_FORMAT_AUTO, NULL, SF_ERR_FORMAT, "picture", WHOLE));
    CHECK(text_refused("ISO-10303-21;\nHEADER;\n", SF_MESH_FORMAT_AUTO, "STEP", WHOLE));
}

// Binary STL has no lines, so what is wrong lies at a byte.
static void names_the_byte_of_binary_stl(void)
{
    unsigned char bytes[84 + 50] = {0};
    sf_mesh *mesh = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    bytes[80] = 1;
    memset(bytes + 84 + 12, 0xff, 4); // not a number
    CHECK_EQ(read_bytes(bytes, sizeof bytes, SF_MESH_FORMAT_STL, NULL, NULL, &mesh, &fault),
             SF_ERR_FORMAT);
    CHECK_EQ(fault.line, 0);
    CHECK(fault.offset >= 84);
    CHECK(mesh == NULL);
}

static void refuses_broken_ply(void)
{
    CHECK(text_refused(PLY_HEAD PLY_VERTEX PLY_FACE PLY_XYZ "3 0 1 3\n", SF_MESH_FORMAT_AUTO,
                       "vertex 3", 13));
    CHECK(text_refused(PLY_HEAD PLY_VERTEX PLY_FACE PLY_XYZ "3 0 1 -1\n", SF_MESH_FORMAT_AUTO,
                       "negative", 13));
    CHECK(text_refused(PLY_HEAD PLY_VERTEX PLY_FACE PLY_XYZ "3.5 0 1 2\n", SF_MESH_FORMAT_AUTO,
                       "not whole", 13));
    CHECK(text_refused(PLY_HEAD PLY_VERTEX PLY_FACE PLY_XYZ "3 0 1 nan\n", SF_MESH_FORMAT_AUTO,
                       "not whole", 13));
    CHECK(text_refused(PLY_HEAD PLY_VERTEX PLY_FACE "0 0 0\n1 inf 0\n", SF_MESH_FORMAT_AUTO,
                       "infinite", 11));
    CHECK(text_refused(PLY_HEAD PLY_VERTEX PLY_FACE PLY_XYZ, SF_MESH_FORMAT_AUTO, "cut short", 0));
    CHECK(text_refused(PLY_HEAD PLY_VERTEX "end_header\n" PLY_XYZ, SF_MESH_FORMAT_AUTO,
                       "no triangles", WHOLE));
    CHECK(text_refused(PLY_HEAD PLY_VERTEX, SF_MESH_FORMAT_AUTO, "header", 0));
    CHECK(text_refused("ply\n" PLY_VERTEX PLY_FACE, SF_MESH_FORMAT_AUTO, "no format", 0));
    CHECK(
        text_refused("ply\nformat binary_pdp_endian 1.0\n", SF_MESH_FORMAT_AUTO, "binary_pdp", 2));
    CHECK(
        text_refused(PLY_HEAD "property float x\n", SF_MESH_FORMAT_AUTO, "before any element", 3));
    CHECK(text_refused(PLY_HEAD "element vertex -3\n", SF_MESH_FORMAT_AUTO, "\"-3\"", 3));
    CHECK(text_refused(PLY_HEAD "element vertex 3\nproperty quad x\n", SF_MESH_FORMAT_AUTO,
                       "\"quad\"", 4));
    CHECK(text_refused(PLY_HEAD
                       "element vertex 3\nproperty float x\nproperty float x\nend_header\n",
                       SF_MESH_FORMAT_AUTO, "one x, one y", 0));
    CHECK(text_refused(PLY_HEAD PLY_VERTEX PLY_VERTEX PLY_FACE, SF_MESH_FORMAT_AUTO, "vertex once",
                       0));
    CHECK(text_refused(PLY_HEAD PLY_VERTEX "element face 1\nproperty list float int vertex_index\n",
                       SF_MESH_FORMAT_AUTO, "no integer", 8));
    CHECK(text_refused(PLY_HEAD PLY_VERTEX
                       "element face 1\nproperty list uchar float vertex_index\n",
                       SF_MESH_FORMAT_AUTO, "no integers", 8));
    CHECK(text_refused(PLY_HEAD "nonsense\n", SF_MESH_FORMAT_AUTO, "\"nonsense\"", 3));
    // Elements of nothing, 2^62 of them, take no time.
    CHECK(text_refused(PLY_HEAD
                       "element vertex 0\nproperty float x\nproperty float y\nproperty float "
                       "z\nelement nothing 4611686018427387904\nend_header\n",
                       SF_MESH_FORMAT_AUTO, "no triangles", WHOLE));
}

// Half of a number token is not a number.
static void refuses_endless_tokens(void)
{
    static char text[20000];
    strcpy(text, "v ");
    memset(text + 2, '1', 10000);
    strcpy(text + 10002, "e-9990 0 0\n");
    CHECK(text_refused(text, SF_MESH_FORMAT_OBJ, "expected a coordinate", 1));
}

static sf_status fail_after(void *user, void *data, size_t capacity, size_t *size)
{
    sf_memory_cursor *cursor = user;
    size_t left = cursor->size - cursor->position;
    if (left == 0) {
        return SF_ERR_IO;
    }
    *size = capacity < left ? capacity : left;
    memcpy(data, (const char *)cursor->data + cursor->position, *size);
    cursor->position += *size;
    return SF_OK;
}

// However far a file goes, a source that fails is named as the reason, and what it said comes out.
static void passes_a_failing_source_on(void)
{
    static file f;
    for (size_t i = 0; make_any(&f, i) != NULL; i++) {
        for (size_t size = 0; size < f.size; size += 1 + f.size / 40) {
            sf_memory_cursor cursor = {f.bytes, size, 0};
            sf_source source = {fail_after, &cursor};
            sf_mesh *mesh = NULL;
            sf_fault fault = {SF_OK, 0, 0, ""};
            CHECK_EQ(sf_mesh_read(source, SF_MESH_FORMAT_AUTO, NULL, NULL, &mesh, &fault),
                     SF_ERR_IO);
            CHECK(refused_well(SF_ERR_IO, &fault, mesh));
        }
    }
}

// A file cut at any byte is read or refused, never half of both. Binary files know their length, so
// all their pieces are refused.
static void survives_every_truncation(void)
{
    static file f;
    const char *what;
    for (size_t i = 0; (what = make_any(&f, i)) != NULL; i++) {
        for (size_t size = 0; size < f.size; size++) {
            void *exact = malloc(size + !size); // so that a sanitizer sees the first byte too many
            memcpy(exact, f.bytes, size);
            failing_allocator memory;
            failing_begin(&memory, -1);
            sf_mesh *mesh = NULL;
            sf_fault fault = {SF_OK, 0, 0, ""};
            sf_status status = read_bytes(exact, size, SF_MESH_FORMAT_AUTO, NULL, &memory.allocator,
                                          &mesh, &fault);
            CHECK(status == SF_OK ? mesh != NULL : refused_well(status, &fault, mesh));
            CHECK(status != SF_OK || strcmp(what, "binary STL") != 0);
            sf_mesh_destroy(mesh);
            CHECK(memory.live == 0 && memory.faults == 0);
            free(exact);
        }
    }
}

// A byte changed at random must never do more than change the mesh or refuse it.
static void survives_changed_bytes(void)
{
    static file f;
    for (size_t i = 0; make_any(&f, i) != NULL; i++) {
        for (int round = 0; round < 300; round++) {
            make_any(&f, i);
            for (uint32_t k = 1 + test_random_below(3); k > 0; k--) {
                f.bytes[test_random_below((uint32_t)f.size)] = (unsigned char)test_random();
            }
            sf_mesh *mesh = NULL;
            sf_fault fault = {SF_OK, 0, 0, ""};
            sf_status status =
                read_bytes(f.bytes, f.size, SF_MESH_FORMAT_AUTO, NULL, NULL, &mesh, &fault);
            CHECK(status == SF_OK ? sf_mesh_validate(sf_mesh_get_view(mesh), NULL) == SF_OK
                                  : refused_well(status, &fault, mesh));
            sf_mesh_destroy(mesh);
        }
    }
}

static void survives_every_refused_allocation(void)
{
    static file f;
    for (size_t i = 0; make_any(&f, i) != NULL; i++) {
        sf_status status = SF_ERR_MEMORY;
        for (long k = 0; status != SF_OK && k < 1000; k++) {
            failing_allocator memory;
            failing_begin(&memory, k);
            sf_mesh *mesh = NULL;
            sf_fault fault = {SF_OK, 0, 0, ""};
            status = read_bytes(f.bytes, f.size, SF_MESH_FORMAT_AUTO, NULL, &memory.allocator,
                                &mesh, &fault);
            CHECK(status == SF_OK ||
                  (status == SF_ERR_MEMORY && refused_well(status, &fault, mesh)));
            sf_mesh_destroy(mesh);
            CHECK(memory.live == 0 && memory.faults == 0);
        }
        CHECK_EQ(status, SF_OK);
    }
}

typedef struct counting {
    size_t largest;
    failing_allocator inner;
} counting;

static void *count_alloc(void *user, size_t size, size_t align)
{
    counting *c = user;
    c->largest = size > c->largest ? size : c->largest;
    return size < (size_t)1 << 24 ? failing_alloc(&c->inner, size, align) : NULL;
}

static void count_free(void *user, void *memory, size_t size)
{
    counting *c = user;
    failing_free(&c->inner, memory, size);
}

static int asks_little(const void *data, size_t size)
{
    counting c = {0, {0}};
    failing_begin(&c.inner, -1);
    sf_allocator allocator = {count_alloc, count_free, &c};
    sf_mesh *mesh = NULL;
    sf_fault fault;
    sf_status status = read_bytes(data, size, SF_MESH_FORMAT_AUTO, NULL, &allocator, &mesh, &fault);
    if (c.largest > 100000) {
        printf("# %zu bytes asked for at once by a file of %zu\n", c.largest, size);
    }
    return status == SF_ERR_FORMAT && mesh == NULL && c.largest <= 100000;
}

static void believes_no_count(void)
{
    static file f;
    make_binary_stl(&f, "liar", 4000000000u);
    CHECK(asks_little(f.bytes, f.size));
    f.size = 0;
    put_text(&f, PLY_HEAD "element vertex 2147483648\nproperty float x\nproperty float y\nproperty "
                          "float z\nelement face 2147483648\nproperty list uint uint "
                          "vertex_indices\nend_header\n0 0 0\n");
    CHECK(asks_little(f.bytes, f.size));
    f.size = 0;
    put_text(&f, PLY_HEAD PLY_VERTEX
             "element face 1\nproperty list uint uint vertex_indices\nend_header\n" PLY_XYZ
             "4294967295 0 1 2");
    CHECK(asks_little(f.bytes, f.size));
    f.size = 0;
    put_text(&f, "OFF 4000000000 4000000000 4000000000\n0 0 0\n");
    CHECK(asks_little(f.bytes, f.size));
}

static void obeys_limits(void)
{
    static file f;
    for (size_t i = 0; make_any(&f, i) != NULL; i++) {
        sf_read_limits limits = sf_read_limits_default();
        sf_mesh *mesh = NULL;
        limits.bytes_max = f.size;
        limits.triangles_max = 12;
        CHECK_EQ(read_bytes(f.bytes, f.size, SF_MESH_FORMAT_AUTO, &limits, NULL, &mesh, NULL),
                 SF_OK);
        sf_mesh_destroy(mesh);
        limits.bytes_max = f.size - 1;
        CHECK(refused(f.bytes, f.size, SF_MESH_FORMAT_AUTO, &limits, SF_ERR_OVERFLOW, "bytes_max",
                      0) ||
              f.bytes[f.size - 1] == '\n');
        limits = sf_read_limits_default();
        limits.triangles_max = 11;
        CHECK(refused(f.bytes, f.size, SF_MESH_FORMAT_AUTO, &limits, SF_ERR_OVERFLOW,
                      "triangles_max", 0));
        limits = sf_read_limits_default();
        limits.vertices_max = 7;
        CHECK(refused(f.bytes, f.size, SF_MESH_FORMAT_AUTO, &limits, SF_ERR_OVERFLOW,
                      "vertices_max", 0));
    }
}

static void refuses_wrong_arguments(void)
{
    sf_mesh *mesh = NULL;
    sf_source none = {NULL, NULL};
    sf_memory_cursor cursor = {"", 0, 0};
    sf_source source = sf_memory_source(&cursor);
    CHECK_EQ(sf_mesh_read(none, SF_MESH_FORMAT_AUTO, NULL, NULL, &mesh, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_mesh_read(source, SF_MESH_FORMAT_AUTO, NULL, NULL, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_mesh_read(source, (sf_mesh_format)99, NULL, NULL, &mesh, NULL), SF_ERR_ARGUMENT);
    CHECK(mesh == NULL);
}

int main(void)
{
    TEST(refuses_broken_text);
    TEST(names_foreign_formats);
    TEST(names_the_byte_of_binary_stl);
    TEST(refuses_broken_ply);
    TEST(refuses_endless_tokens);
    TEST(passes_a_failing_source_on);
    TEST(survives_every_truncation);
    TEST(survives_changed_bytes);
    TEST(survives_every_refused_allocation);
    TEST(believes_no_count);
    TEST(obeys_limits);
    TEST(refuses_wrong_arguments);
    return test_finish();
}
