// SPDX-License-Identifier: MIT
// 3MF in: from the archive's relationships to its parts, and all of them into one document.
//
// The first part is the one that the relationships name; others are read because one that was read
// names them. Their paths are names of entries of the archive and nothing else: they begin with a
// slash, and no step of them leads up.

#include "io/threemf.h"

#include "base/memory.h"
#include "base/status.h"
#include "io/path.h"
#include "io/readers.h"
#include "io/xml.h"

#include <string.h>

#ifdef SF_HAVE_THREEMF

#include <math.h>

// Parts are looked for one by one.
enum { PARTS_MAX = 1024 };

int sf_threemf_is_served(void)
{
    return 1;
}

// ---------------------------------------------------------------------------------------------
// Parts
// ---------------------------------------------------------------------------------------------

// "/3D/one.model": plain characters, and no step that is empty, "." or "..".
static int is_path(const char *path)
{
    size_t step = 0;
    for (size_t i = 0; path[0] == '/'; i++) {
        unsigned char c = (unsigned char)path[i];
        if (c == '/' || c == '\0') {
            const char *begin = path + i - step;
            int is_up =
                (step == 1 && begin[0] == '.') || (step == 2 && begin[0] == '.' && begin[1] == '.');
            if (is_up || (step == 0 && i > 0)) {
                return 0;
            }
            if (c == '\0') {
                return i > 0;
            }
            step = 0;
        } else if (c <= ' ' || c > '~' || c == '\\' || c == ':') {
            return 0;
        } else {
            step++;
        }
    }
    return 0;
}

sf_status sfi_threemf_add_part(sfi_threemf_reader *reader, const char *path, uint32_t *part)
{
    sf_threemf *document = reader->document;
    char *const *names = document->parts.items;
    if (!is_path(path)) {
        return sfi_fault_set(reader->fault, SF_ERR_FORMAT, 0, 0,
                             "the file names a part by a path that is none, or that leads out of "
                             "the archive; export it again");
    }
    for (size_t i = document->parts.count; i-- > 0;) {
        if (strcmp(names[i], path + 1) == 0) {
            *part = (uint32_t)i;
            return SF_OK;
        }
    }
    if (document->parts.count >= PARTS_MAX) {
        return sfi_fault_set(reader->fault, SF_ERR_OVERFLOW, 0, 0,
                             "the file has more than %d parts", PARTS_MAX);
    }
    char *copy = sfi_path_join(&document->allocator, path + 1, 0, "");
    if (copy == NULL) {
        return SF_ERR_MEMORY;
    }
    sf_status status = sfi_list_push(&document->allocator, &document->parts, &copy);
    if (status != SF_OK) {
        sfi_path_free(&document->allocator, copy);
        return status;
    }
    *part = (uint32_t)(document->parts.count - 1);
    return SF_OK;
}

static sf_status on_relation(void *user, const char *name, const char **attributes)
{
    sfi_threemf_reader *reader = user;
    const char *type = sfi_xml_value(attributes, "Type");
    const char *target = sfi_xml_value(attributes, "Target");
    uint32_t part = 0;
    if (strcmp(name, SFI_THREEMF_RELATIONS "\nRelationship") != 0 || type == NULL ||
        target == NULL || strcmp(type, SFI_THREEMF_MODEL) != 0 ||
        reader->document->parts.count > 0) {
        return SF_OK;
    }
    if (target[0] == '/') {
        return sfi_threemf_add_part(reader, target, &part);
    }
    char *path = sfi_path_join(&reader->document->allocator, "", '/', target);
    if (path == NULL) {
        return SF_ERR_MEMORY;
    }
    sf_status status = sfi_threemf_add_part(reader, path, &part);
    sfi_path_free(&reader->document->allocator, path);
    return status;
}

static sf_status on_end(void *user)
{
    (void)user;
    return SF_OK;
}

// The part to begin with is the one that the archive's relationships name.
static sf_status find_root(sfi_threemf_reader *reader)
{
    const sfi_xml *place = NULL;
    sfi_xml_hearer hearer = {on_relation, on_end, NULL, reader};
    SF_TRY(sfi_xml_read(reader->zip, "_rels/.rels", &hearer, &place, reader->fault));
    return reader->document->parts.count > 0
               ? SF_OK
               : sfi_fault_set(reader->fault, SF_ERR_FORMAT, 0, 0,
                               "this archive has no 3D model in it; is it a 3MF file?");
}

// ---------------------------------------------------------------------------------------------
// Documents
// ---------------------------------------------------------------------------------------------

static sf_status create(const sf_allocator *allocator, size_t vertices_max, sf_threemf **document)
{
    sf_threemf *made = sfi_alloc_array(allocator, 1, sizeof *made);
    if (made == NULL) {
        return SF_ERR_MEMORY;
    }
    sf_threemf empty = {*allocator,
                        sfi_list_of(sizeof(char *)),
                        sfi_list_of(sizeof(sfi_threemf_object)),
                        sfi_list_of(sizeof(sfi_threemf_placing)),
                        sfi_list_of(sizeof(sfi_threemf_placing)),
                        sfi_list_of(sizeof(sfi_threemf_group)),
                        sfi_list_of(sizeof(sf_threemf_colour)),
                        sfi_list_of(sizeof(sfi_threemf_stack)),
                        sfi_list_of(sizeof(sfi_threemf_ref)),
                        sfi_list_of(sizeof(sfi_threemf_slice)),
                        sfi_list_of(2 * sizeof(double)),
                        sfi_list_of(sizeof(size_t)),
                        sfi_list_of(sizeof(sf_threemf_object)),
                        sfi_list_of(sizeof(sf_threemf_item)),
                        vertices_max};
    *made = empty;
    *document = made;
    return SF_OK;
}

static void free_texts(sf_threemf *document)
{
    char **parts = document->parts.items;
    sf_threemf_colour *colours = document->colours.items;
    for (size_t i = 0; i < document->parts.count; i++) {
        sfi_path_free(&document->allocator, parts[i]);
    }
    for (size_t i = 0; i < document->colours.count; i++) {
        sfi_path_free(&document->allocator, (char *)colours[i].name);
    }
}

void sf_threemf_destroy(sf_threemf *document)
{
    if (document == NULL) {
        return;
    }
    sf_allocator allocator = document->allocator;
    sfi_list *lists[] = {&document->parts,  &document->objects, &document->components,
                         &document->builds, &document->groups,  &document->colours,
                         &document->stacks, &document->refs,    &document->slices,
                         &document->points, &document->starts,  &document->views,
                         &document->items};
    free_texts(document);
    for (size_t i = 0; i < document->objects.count; i++) {
        sfi_threemf_object *object = (sfi_threemf_object *)document->objects.items + i;
        sf_mesh_destroy(object->mesh);
        sfi_list_free(&allocator, &object->colours);
        sfi_path_free(&allocator, object->name);
    }
    for (size_t i = 0; i < sizeof lists / sizeof lists[0]; i++) {
        sfi_list_free(&allocator, lists[i]);
    }
    sfi_free_array(&allocator, document, 1, sizeof *document);
}

sf_threemf_view sf_threemf_get_view(const sf_threemf *document)
{
    sf_threemf_view view;
    memset(&view, 0, sizeof view);
    if (document != NULL) {
        view.colours = document->colours.items;
        view.colour_count = document->colours.count;
        view.objects = document->views.items;
        view.object_count = document->views.count;
        view.items = document->items.items;
        view.item_count = document->items.count;
        view.stack_count = document->stacks.count;
    }
    return view;
}

static sf_status read_parts(sfi_threemf_reader *reader)
{
    SF_TRY(find_root(reader));
    for (uint32_t part = 0; part < reader->document->parts.count; part++) { // it grows meanwhile
        SF_TRY(sfi_threemf_read_part(reader, part));
    }
    return sfi_threemf_build(reader);
}

static sf_status read_document(sf_source source, const sf_read_limits *limits,
                               const sf_allocator *allocator, sf_threemf **document,
                               sf_fault *fault)
{
    sfi_threemf_reader reader = {NULL, NULL, *limits, 0, 0, fault};
    SF_TRY(sfi_zip_open(source, limits->bytes_max, allocator, &reader.zip, fault));
    sf_status status = create(allocator, limits->vertices_max, &reader.document);
    if (status == SF_OK) {
        status = read_parts(&reader);
    }
    sfi_zip_close(reader.zip);
    if (status != SF_OK) {
        sf_threemf_destroy(reader.document);
        return status;
    }
    *document = reader.document;
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// One mesh of all
// ---------------------------------------------------------------------------------------------

static int is_printed(const sf_threemf_object *object)
{
    return object->kind == SF_THREEMF_MODEL || object->kind == SF_THREEMF_SOLID_SUPPORT;
}

static int mirrors(const sf_transform *map)
{
    const double *m = map->matrix;
    return m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) +
               m[2] * (m[3] * m[7] - m[4] * m[6]) <
           0;
}

static sf_status place_vertices(const sf_threemf_item *item, sf_mesh_view from, sf_mesh *mesh,
                                sf_fault *fault)
{
    const double *m = item->placed.matrix, *shift = item->placed.shift_mm;
    for (size_t i = 0; i < from.vertex_count; i++) {
        const double *v = from.vertices + 3 * i;
        double at[3];
        for (int k = 0; k < 3; k++) {
            at[k] = m[3 * k] * v[0] + m[3 * k + 1] * v[1] + m[3 * k + 2] * v[2] + shift[k];
        }
        if (!isfinite(at[0]) || !isfinite(at[1]) || !isfinite(at[2])) {
            return sfi_fault_set(fault, SF_ERR_OVERFLOW, 0, 0,
                                 "a transform of the file moves a vertex beyond all bounds; export "
                                 "the file again");
        }
        SF_TRY(sf_mesh_add_vertices(mesh, at, 1));
    }
    return SF_OK;
}

static sf_status place(const sf_threemf_item *item, sf_mesh_view from, sf_mesh *mesh,
                       sf_fault *fault)
{
    uint32_t first = (uint32_t)sf_mesh_get_view(mesh).vertex_count;
    int turn = mirrors(&item->placed);
    SF_TRY(place_vertices(item, from, mesh, fault));
    for (size_t i = 0; i < from.triangle_count; i++) {
        const uint32_t *t = from.triangles + 3 * i;
        uint32_t corners[3] = {first + t[0], first + t[turn ? 2 : 1], first + t[turn ? 1 : 2]};
        SF_TRY(sf_mesh_add_triangles(mesh, corners, 1));
    }
    return SF_OK;
}

static sf_status check_room(sf_mesh_view have, sf_mesh_view more, const sf_read_limits *limits,
                            sf_fault *fault)
{
    size_t vertices = limits->vertices_max < UINT32_MAX ? limits->vertices_max : UINT32_MAX;
    if (more.vertex_count > vertices || have.vertex_count > vertices - more.vertex_count) {
        return sfi_fault_set(fault, SF_ERR_OVERFLOW, 0, 0,
                             "what the file builds has more than %zu vertices", vertices);
    }
    if (more.triangle_count > limits->triangles_max ||
        have.triangle_count > limits->triangles_max - more.triangle_count) {
        return sfi_fault_set(fault, SF_ERR_OVERFLOW, 0, 0,
                             "what the file builds has more than %zu triangles; raise "
                             "triangles_max",
                             limits->triangles_max);
    }
    return SF_OK;
}

static sf_status merge_into(const sf_threemf *document, const sf_read_limits *limits, sf_mesh *mesh,
                            sf_fault *fault)
{
    sf_threemf_view view = sf_threemf_get_view(document);
    size_t placed = 0;
    for (size_t i = 0; i < view.item_count; i++) {
        const sf_threemf_object *object = &view.objects[view.items[i].object];
        if (!is_printed(object)) {
            continue;
        }
        if (object->is_rough) {
            return sfi_fault_set(fault, SF_ERR_UNSUPPORTED, 0, 0,
                                 "the triangles of object '%.60s' only stand for its slices; take "
                                 "the slices, or export the part as triangles",
                                 object->name);
        }
        SF_TRY(check_room(sf_mesh_get_view(mesh), object->mesh, limits, fault));
        SF_TRY(place(&view.items[i], object->mesh, mesh, fault));
        placed++;
    }
    return placed > 0 ? SF_OK
                      : sfi_fault_set(fault, SF_ERR_FORMAT, 0, 0,
                                      "the file builds supports or surfaces, and nothing that has "
                                      "an inside");
}

// What is left of a source that a cursor has looked at.
static sf_status read_on(void *user, void *data, size_t capacity, size_t *size)
{
    sfi_cursor *cursor = user;
    *size = sfi_cursor_read(cursor, data, capacity);
    return cursor->failure;
}

sf_status sfi_threemf_read_mesh(sfi_mesh_reader *reader)
{
    sf_source rest = {read_on, reader->cursor};
    sf_threemf *document = NULL;
    SF_TRY(
        read_document(rest, &reader->limits, &reader->cursor->allocator, &document, reader->fault));
    sf_status status = merge_into(document, &reader->limits, reader->mesh, reader->fault);
    sf_threemf_destroy(document);
    return status;
}

#else

int sf_threemf_is_served(void)
{
    return 0;
}

static sf_status not_served(sf_fault *fault)
{
    return sfi_fault_set(fault, SF_ERR_UNSUPPORTED, 0, 0,
                         "this build reads no 3MF; save the part as STL, OBJ, PLY or OFF, or build "
                         "with expat and zlib");
}

static sf_status read_document(sf_source source, const sf_read_limits *limits,
                               const sf_allocator *allocator, sf_threemf **document,
                               sf_fault *fault)
{
    (void)source, (void)limits, (void)allocator, (void)document;
    return not_served(fault);
}

static sf_status merge_into(const sf_threemf *document, const sf_read_limits *limits, sf_mesh *mesh,
                            sf_fault *fault)
{
    (void)document, (void)limits, (void)mesh;
    return not_served(fault);
}

sf_threemf_view sf_threemf_get_view(const sf_threemf *document)
{
    sf_threemf_view view;
    (void)document;
    memset(&view, 0, sizeof view);
    return view;
}

void sf_threemf_destroy(sf_threemf *document)
{
    (void)document;
}

sf_status sfi_threemf_read_mesh(sfi_mesh_reader *reader)
{
    return not_served(reader->fault);
}

#endif

// ---------------------------------------------------------------------------------------------
// What is called
// ---------------------------------------------------------------------------------------------

// The caller's limits: an older one knows fewer fields, a newer one more.
static sf_read_limits limits_of(const sf_read_limits *limits)
{
    sf_read_limits within = sf_read_limits_default();
    if (limits != NULL) {
        size_t known = limits->struct_size < sizeof within ? limits->struct_size : sizeof within;
        memcpy(&within, limits, known);
    }
    return within;
}

static sf_status say_memory(sf_status status, sf_fault *fault)
{
    return status == SF_ERR_MEMORY
               ? sfi_fault_set(fault, status, 0, 0, "there is not enough memory for this file")
               : status;
}

sf_status sf_threemf_read(sf_source source, const sf_read_limits *limits,
                          const sf_allocator *allocator, sf_threemf **document, sf_fault *fault)
{
    if (source.read == NULL || document == NULL) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "no source, no place for the document");
    }
    sf_read_limits within = limits_of(limits);
    sf_allocator kept = sfi_allocator_or_default(allocator);
    return say_memory(read_document(source, &within, &kept, document, fault), fault);
}

sf_status sf_threemf_merge(const sf_threemf *document, const sf_read_limits *limits,
                           const sf_allocator *allocator, sf_mesh **mesh, sf_fault *fault)
{
    sf_mesh *made = NULL;
    if (document == NULL || mesh == NULL) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "no document, no place for the mesh");
    }
    sf_read_limits within = limits_of(limits);
    sf_status status = sf_mesh_create(allocator, &made);
    if (status == SF_OK) {
        status = merge_into(document, &within, made, fault);
    }
    if (status != SF_OK) {
        sf_mesh_destroy(made);
        return say_memory(status, fault);
    }
    *mesh = made;
    return SF_OK;
}
