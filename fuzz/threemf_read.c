// SPDX-License-Identifier: MIT
// Fuzz target: any bytes as a 3MF file, or as the model in one.
//
// What comes in is a document that is valid, or a refusal with a sentence. Of a document everything
// is asked for: one mesh, which is valid; its slices, which rise; and where it has no slices it is
// written and read again, as the same document. Bytes that do not begin like an archive are put
// into one, stored and with the right checksum, so that a fuzzer meets the XML at once: parts end
// with a zero, the first is the model and the second is 2D/a.model.

#include "target.h"

#include <sf/threemf.h>

typedef struct entry {
    const char *name;
    const uint8_t *bytes;
    size_t size;
} entry;

static void put_number(buffer *b, uint64_t value, int size)
{
    unsigned char bytes[8];
    for (int i = 0; i < size; i++) {
        bytes[i] = (unsigned char)(value >> 8 * i);
    }
    (void)put(b, bytes, (size_t)size);
}

static uint32_t crc_of(const uint8_t *bytes, size_t size)
{
    uint32_t crc = 0xffffffffu;
    for (size_t i = 0; i < size; i++) {
        crc ^= bytes[i];
        for (int k = 0; k < 8; k++) {
            crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0);
        }
    }
    return ~crc;
}

// What both of an entry's headers say.
static void put_entry(buffer *b, const entry *e)
{
    put_number(b, 0, 4); // no flags, stored
    put_number(b, 0x00210000u, 4);
    put_number(b, crc_of(e->bytes, e->size), 4);
    put_number(b, e->size, 4);
    put_number(b, e->size, 4);
    put_number(b, strlen(e->name), 2);
    put_number(b, 0, 2);
}

static buffer wrap(const entry *entries, size_t count)
{
    buffer b = {NULL, 0, 0};
    size_t offsets[4], begin;
    for (size_t i = 0; i < count; i++) {
        offsets[i] = b.size;
        put_number(&b, 0x04034b50u, 4);
        put_number(&b, 20, 2);
        put_entry(&b, &entries[i]);
        (void)put(&b, entries[i].name, strlen(entries[i].name));
        (void)put(&b, entries[i].bytes, entries[i].size);
    }
    begin = b.size;
    for (size_t i = 0; i < count; i++) {
        put_number(&b, 0x02014b50u, 4);
        put_number(&b, 0x00140014u, 4);
        put_entry(&b, &entries[i]);
        put_number(&b, 0, 8);
        put_number(&b, 0, 2);
        put_number(&b, offsets[i], 4);
        (void)put(&b, entries[i].name, strlen(entries[i].name));
    }
    size_t size = b.size - begin;
    put_number(&b, 0x06054b50u, 4);
    put_number(&b, 0, 4);
    put_number(&b, count | count << 16, 4);
    put_number(&b, size, 4);
    put_number(&b, begin, 4);
    put_number(&b, 0, 2);
    return b;
}

static sf_threemf *read_bytes(const void *data, size_t size)
{
    sf_memory_cursor cursor = {data, size, 0};
    sf_read_limits limits = sf_read_limits_default();
    sf_threemf *document = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    limits.bytes_max = 1 << 26;
    limits.triangles_max = limits.vertices_max = 1 << 20;
    sf_status status = sf_threemf_read(sf_memory_source(&cursor), &limits, NULL, &document, &fault);
    must((status == SF_OK) == (document != NULL), "a document exactly on success");
    must(status == SF_OK || (fault.status == status && fault.message[0] != '\0'), "a sentence");
    must(status != SF_ERR_INTERNAL && status != SF_ERR_ARGUMENT, "a status that is documented");
    return document;
}

static void look_at_mesh(const sf_threemf *document)
{
    sf_read_limits limits = sf_read_limits_default();
    sf_mesh *mesh = NULL;
    limits.triangles_max = limits.vertices_max = 1 << 20;
    sf_status status = sf_threemf_merge(document, &limits, NULL, &mesh, NULL);
    must((status == SF_OK) == (mesh != NULL), "a mesh exactly on success");
    if (mesh != NULL) {
        must(sf_mesh_validate(sf_mesh_get_view(mesh), NULL) == SF_OK, "what was merged is valid");
    }
    sf_mesh_destroy(mesh);
}

static void look_at_slices(const sf_threemf *document)
{
    sf_contour_stack *stack = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_status status = sf_threemf_contours(document, NULL, &stack, &fault);
    must((status == SF_OK) == (stack != NULL), "a stack exactly on success");
    must(status == SF_OK || fault.message[0] != '\0', "a sentence");
    double before = -1e13;
    for (uint32_t k = 0; k < sf_contour_stack_count(stack); k++) {
        double bottom = 0, top = 0;
        must(sf_contour_stack_layer(stack, k, NULL, &bottom, &top) == SF_OK, "a layer");
        must(top > bottom && bottom >= before, "layers rise");
        before = top;
    }
    sf_contour_stack_destroy(stack);
}

static void check_view(sf_threemf_view v)
{
    for (size_t i = 0; i < v.item_count; i++) {
        must(v.items[i].object < v.object_count, "an item has an object");
    }
    for (size_t i = 0; i < v.object_count; i++) {
        const sf_threemf_object *o = &v.objects[i];
        must(sf_mesh_validate(o->mesh, NULL) == SF_OK && o->name != NULL, "an object is valid");
        must(o->stack == SF_THREEMF_NONE || o->stack < v.stack_count, "its stack is there");
        for (size_t k = 0; o->colours != NULL && k < 3 * o->mesh.triangle_count; k++) {
            must(o->colours[k] == SF_THREEMF_NONE || o->colours[k] < v.colour_count,
                 "its colours are there");
        }
    }
}

// What was read and can be written is the same when it is read again.
static void round_trip(const sf_threemf *document)
{
    sf_threemf_view v = sf_threemf_get_view(document);
    buffer b = {NULL, 0, 0};
    sf_sink sink = {put, &b};
    if (sf_threemf_write(&v, NULL, sink, NULL, NULL, NULL) == SF_OK) {
        sf_threemf *again = read_bytes(b.bytes, b.size);
        sf_threemf_view w = sf_threemf_get_view(again);
        must(v.object_count == w.object_count && v.item_count == w.item_count &&
                 v.colour_count == w.colour_count,
             "the counts come back");
        for (size_t i = 0; i < v.object_count; i++) {
            sf_mesh_view from = v.objects[i].mesh, to = w.objects[i].mesh;
            must(from.vertex_count == to.vertex_count &&
                     strcmp(v.objects[i].name, w.objects[i].name) == 0,
                 "objects come back");
            for (size_t k = 0; k < 3 * from.vertex_count; k++) {
                must(from.vertices[k] == to.vertices[k], "every coordinate comes back");
            }
        }
        sf_threemf_destroy(again);
    }
    free(b.bytes);
}

static void read_one(const void *data, size_t size)
{
    sf_threemf *document = read_bytes(data, size);
    if (document != NULL) {
        check_view(sf_threemf_get_view(document));
        look_at_mesh(document);
        look_at_slices(document);
        (void)sf_threemf_is_sliced(document);
        round_trip(document);
    }
    sf_threemf_destroy(document);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static const char relations[] =
        "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
        "<Relationship Id=\"a\" Target=\"/m\" "
        "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>";
    if (!sf_threemf_is_served() || (size >= 2 && memcmp(data, "PK", 2) == 0)) {
        if (sf_threemf_is_served()) {
            read_one(data, size);
        }
        return 0;
    }
    const uint8_t *zero = size > 0 ? memchr(data, 0, size) : NULL;
    size_t first = zero != NULL ? (size_t)(zero - data) : size;
    const entry entries[3] = {
        {"_rels/.rels", (const uint8_t *)relations, sizeof relations - 1},
        {"m", data, first},
        {"2D/a.model", zero != NULL ? zero + 1 : data, zero != NULL ? size - first - 1 : 0}};
    buffer b = wrap(entries, 3);
    read_one(b.bytes, b.size);
    free(b.bytes);
    return 0;
}
