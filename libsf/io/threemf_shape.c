// SPDX-License-Identifier: MIT
// What elements of a 3MF model mean: objects, triangles, components, materials and colours.
//
// A colour of a corner is kept as a number in the document's one list. A group must stand before
// the triangles that name it, as the specification asks; a number that names no group that is known
// (textures, mixtures) leaves the corner without a colour.

#include "io/threemf_part.h"

#include "base/status.h"
#include "io/path.h"

#ifdef SF_HAVE_THREEMF

#include <math.h>
#include <string.h>

// Groups are kept sorted, and more of them are nobody's.
enum { GROUPS_MAX = 8192 };

// ---------------------------------------------------------------------------------------------
// Groups
// ---------------------------------------------------------------------------------------------

sf_status sfi_threemf_begin_group(sfi_threemf_part *part, const char **attributes)
{
    sfi_threemf_group empty = {{part->number, 0}, part->document->colours.count, 0};
    part->group = empty;
    return sfi_threemf_id(part, attributes, "id", &part->group.self.id);
}

// The place of group `id` of this part in the sorted list: of it, or of where it would stand.
static size_t place_of_group(const sfi_threemf_part *part, uint32_t id)
{
    const sfi_threemf_group *groups = part->document->groups.items;
    size_t low = 0, high = part->document->groups.count;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        sfi_threemf_name name = groups[middle].self;
        if (name.part < part->number || (name.part == part->number && name.id < id)) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low;
}

static const sfi_threemf_group *find_group(const sfi_threemf_part *part, uint32_t id)
{
    const sfi_threemf_group *groups = part->document->groups.items;
    size_t at = place_of_group(part, id);
    return at < part->document->groups.count && groups[at].self.id == id &&
                   groups[at].self.part == part->number
               ? groups + at
               : NULL;
}

sf_status sfi_threemf_end_group(sfi_threemf_part *part, const char **attributes)
{
    sfi_list *list = &part->document->groups;
    size_t at = place_of_group(part, part->group.self.id);
    (void)attributes;
    part->group.count = part->document->colours.count - part->group.first;
    if (find_group(part, part->group.self.id) != NULL || list->count >= GROUPS_MAX) {
        return sfi_threemf_wrong(part, list->count >= GROUPS_MAX
                                           ? "there are more than 8192 groups of colours"
                                           : "two groups of colours have one number; export the "
                                             "file again");
    }
    SF_TRY(sfi_list_push(&part->document->allocator, list, &part->group));
    sfi_threemf_group *groups = list->items;
    memmove(groups + at + 1, groups + at, (list->count - 1 - at) * sizeof *groups);
    groups[at] = part->group;
    return SF_OK;
}

static int hex(char c)
{
    return c >= '0' && c <= '9'   ? c - '0'
           : c >= 'a' && c <= 'f' ? c - 'a' + 10
           : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                  : -1;
}

// "#rrggbb" or "#rrggbbaa".
static int parse_colour(const char *text, uint8_t rgba[4])
{
    size_t length = text != NULL ? strlen(text) : 0;
    if ((length != 7 && length != 9) || text[0] != '#') {
        return 0;
    }
    rgba[3] = 255;
    for (size_t i = 0; 2 * i + 2 < length; i++) {
        int high = hex(text[2 * i + 1]), low = hex(text[2 * i + 2]);
        if (high < 0 || low < 0) {
            return 0;
        }
        rgba[i] = (uint8_t)(16 * high + low);
    }
    return 1;
}

static sf_status add_colour(sfi_threemf_part *part, const char *name, const char *attribute,
                            const char *text)
{
    const sf_allocator *allocator = &part->document->allocator;
    sf_threemf_colour made = {NULL, {0, 0, 0, 0}, (uint32_t)part->document->groups.count};
    if (!parse_colour(text, made.rgba)) {
        return sfi_threemf_wrong_value(part, attribute, "colour like #RRGGBB");
    }
    char *copy = sfi_path_join(allocator, name, 0, "");
    if (copy == NULL) {
        return SF_ERR_MEMORY;
    }
    made.name = copy;
    sf_status status = part->document->colours.count < SF_THREEMF_NONE
                           ? sfi_list_push(allocator, &part->document->colours, &made)
                           : SF_ERR_OVERFLOW;
    if (status != SF_OK) {
        sfi_path_free(allocator, copy);
    }
    return status;
}

sf_status sfi_threemf_base(sfi_threemf_part *part, const char **attributes)
{
    const char *name = sfi_xml_value(attributes, "name");
    return name == NULL
               ? sfi_threemf_wrong_value(part, "name", "name of a material")
               : add_colour(part, name, "displaycolor", sfi_xml_value(attributes, "displaycolor"));
}

sf_status sfi_threemf_colour_of_group(sfi_threemf_part *part, const char **attributes)
{
    return add_colour(part, "", "color", sfi_xml_value(attributes, "color"));
}

// Number `entry` of group `id` of this part, in the document's list.
static sf_status find_colour(const sfi_threemf_part *part, uint32_t id, uint32_t entry,
                             uint32_t *colour)
{
    const sfi_threemf_group *group = find_group(part, id);
    *colour = SF_THREEMF_NONE;
    if (group != NULL && entry >= group->count) {
        return sfi_threemf_wrong(part, "a colour is named that its group does not have; export the "
                                       "file again");
    }
    if (group != NULL) {
        *colour = (uint32_t)(group->first + entry);
    }
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Objects
// ---------------------------------------------------------------------------------------------

static int parse_kind(const char *text, sf_threemf_kind *kind)
{
    static const char *const names[] = {"model", "solidsupport", "support", "surface", "other"};
    for (int i = 0; i < 5; i++) {
        if (text == NULL || strcmp(text, names[i]) == 0) {
            *kind = text == NULL ? SF_THREEMF_MODEL : (sf_threemf_kind)i;
            return 1;
        }
    }
    return 0;
}

static sf_status find_stack(sfi_threemf_part *part, const char **attributes)
{
    sfi_threemf_object *object = &part->object;
    const char *path = sfi_xml_value(attributes, SFI_THREEMF_SLICE "\nslicepath");
    const char *how = sfi_xml_value(attributes, SFI_THREEMF_SLICE "\nmeshresolution");
    if (sfi_xml_value(attributes, SFI_THREEMF_SLICE "\nslicestackid") == NULL) {
        return SF_OK;
    }
    SF_TRY(sfi_threemf_id(part, attributes, SFI_THREEMF_SLICE "\nslicestackid", &object->stack.id));
    object->stack.part = part->number;
    object->is_rough = how != NULL && strcmp(how, "lowres") == 0;
    return path != NULL ? sfi_threemf_add_part(part->all, path, &object->stack.part) : SF_OK;
}

sf_status sfi_threemf_begin_object(sfi_threemf_part *part, const char **attributes)
{
    const char *name = sfi_xml_value(attributes, "name");
    sfi_threemf_object *object = &part->object;
    memset(object, 0, sizeof *object);
    object->colours = sfi_list_of(3 * sizeof(uint32_t));
    object->self.part = part->number;
    object->component_first = part->document->components.count;
    part->foreign[0] = '\0';
    SF_TRY(sfi_threemf_id(part, attributes, "id", &object->self.id));
    if (!parse_kind(sfi_xml_value(attributes, "type"), &object->kind)) {
        return sfi_threemf_wrong_value(part, "type", "type that 3MF knows");
    }
    SF_TRY(sfi_threemf_index_if(part, attributes, "pid", &object->group));
    SF_TRY(sfi_threemf_index_if(part, attributes, "pindex", &object->entry));
    SF_TRY(find_stack(part, attributes));
    object->name = sfi_path_join(&part->document->allocator, name != NULL ? name : "", 0, "");
    return object->name != NULL ? SF_OK : SF_ERR_MEMORY;
}

sf_status sfi_threemf_end_object(sfi_threemf_part *part, const char **attributes)
{
    sfi_threemf_object *object = &part->object;
    (void)attributes;
    object->component_count = part->document->components.count - object->component_first;
    if (object->mesh == NULL && object->component_count == 0) {
        return part->foreign[0] == '\0'
                   ? sfi_threemf_wrong(part, "an object has neither triangles nor components; "
                                             "export the file again")
                   : sfi_fault_set(part->all->fault, SF_ERR_UNSUPPORTED, sfi_xml_line(part->place),
                                   0,
                                   "%.80s: object %lu is made by '%s', which is not read; export "
                                   "the part as triangles",
                                   part->name, (unsigned long)object->self.id, part->foreign);
    }
    if (object->mesh != NULL && object->component_count > 0) {
        return sfi_threemf_wrong(part, "an object has both triangles and components");
    }
    SF_TRY(sfi_list_push(&part->document->allocator, &part->document->objects, object));
    memset(object, 0, sizeof *object); // it is the document's now
    return SF_OK;
}

sf_status sfi_threemf_begin_mesh(sfi_threemf_part *part, const char **attributes)
{
    (void)attributes;
    return part->object.mesh == NULL
               ? sf_mesh_create(&part->document->allocator, &part->object.mesh)
               : sfi_threemf_wrong(part, "an object has two meshes");
}

sf_status sfi_threemf_end_mesh(sfi_threemf_part *part, const char **attributes)
{
    (void)attributes;
    return sf_mesh_get_view(part->object.mesh).triangle_count > 0
               ? SF_OK
               : sfi_threemf_wrong(part, "an object has no triangles; check what was exported");
}

sf_status sfi_threemf_vertex(sfi_threemf_part *part, const char **attributes)
{
    static const char *const names[3] = {"x", "y", "z"};
    double xyz[3] = {0, 0, 0};
    for (int i = 0; i < 3; i++) {
        SF_TRY(sfi_threemf_number(part, attributes, names[i], &xyz[i]));
        xyz[i] *= part->unit_mm;
        if (!isfinite(xyz[i])) {
            return sfi_threemf_wrong_value(part, names[i], "coordinate that is finite in mm");
        }
    }
    SF_TRY(sfi_threemf_count_vertex(part));
    return sf_mesh_add_vertices(part->object.mesh, xyz, 1);
}

// The colours of a triangle's corners: its own, or the object's.
static sf_status read_colours(sfi_threemf_part *part, const char **attributes)
{
    static const char *const names[3] = {"p1", "p2", "p3"};
    sfi_threemf_object *object = &part->object;
    uint32_t group = object->group, entries[3], colours[3];
    int is_own = sfi_xml_value(attributes, "p1") != NULL;
    entries[0] = object->entry;
    SF_TRY(sfi_threemf_index_if(part, attributes, "pid", &group));
    if (is_own) {
        SF_TRY(sfi_threemf_index(part, attributes, "p1", &entries[0]));
    }
    entries[1] = entries[2] = entries[0];
    for (int i = 1; is_own && i < 3; i++) {
        SF_TRY(sfi_threemf_index_if(part, attributes, names[i], &entries[i]));
    }
    for (int i = 0; i < 3; i++) {
        colours[i] = SF_THREEMF_NONE;
        if (group != 0) {
            SF_TRY(find_colour(part, group, entries[i], &colours[i]));
        }
        object->has_colours = object->has_colours || colours[i] != SF_THREEMF_NONE;
    }
    return sfi_list_push(&part->document->allocator, &object->colours, colours);
}

sf_status sfi_threemf_triangle(sfi_threemf_part *part, const char **attributes)
{
    static const char *const names[3] = {"v1", "v2", "v3"};
    size_t count = sf_mesh_get_view(part->object.mesh).vertex_count;
    uint32_t corners[3] = {0, 0, 0};
    for (int i = 0; i < 3; i++) {
        SF_TRY(sfi_threemf_index(part, attributes, names[i], &corners[i]));
        if (corners[i] >= count) {
            return sfi_fault_set(part->all->fault, SF_ERR_FORMAT, sfi_xml_line(part->place), 0,
                                 "%.80s: a triangle names vertex %lu, counted from 0, but only %zu "
                                 "are there; export the file again",
                                 part->name, (unsigned long)corners[i], count);
        }
    }
    if (part->all->triangles >= part->all->limits.triangles_max) {
        return sfi_fault_set(part->all->fault, SF_ERR_OVERFLOW, sfi_xml_line(part->place), 0,
                             "%.80s: the file has more than %zu triangles; raise triangles_max",
                             part->name, part->all->limits.triangles_max);
    }
    part->all->triangles++;
    SF_TRY(read_colours(part, attributes));
    return sf_mesh_add_triangles(part->object.mesh, corners, 1);
}

// ---------------------------------------------------------------------------------------------
// Places
// ---------------------------------------------------------------------------------------------

static sf_status read_placing(sfi_threemf_part *part, const char **attributes, sfi_list *list)
{
    sfi_threemf_placing made = {{part->number, 0}, {{1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 0, 0}}};
    const char *path = sfi_xml_value(attributes, SFI_THREEMF_PRODUCTION "\npath");
    const char *transform = sfi_xml_value(attributes, "transform");
    SF_TRY(sfi_threemf_id(part, attributes, "objectid", &made.object.id));
    if (path != NULL) {
        SF_TRY(sfi_threemf_add_part(part->all, path, &made.object.part));
    }
    if (transform != NULL && !sfi_threemf_transform(transform, part->unit_mm, &made.placed)) {
        return sfi_threemf_wrong_value(part, "transform",
                                       "list of 12 finite numbers that keeps a volume");
    }
    return sfi_list_push(&part->document->allocator, list, &made);
}

sf_status sfi_threemf_component(sfi_threemf_part *part, const char **attributes)
{
    return read_placing(part, attributes, &part->document->components);
}

sf_status sfi_threemf_build_item(sfi_threemf_part *part, const char **attributes)
{
    // Only the first part says what is built; the builds of others are there for those who print
    // them alone.
    return part->number == 0 ? read_placing(part, attributes, &part->document->builds) : SF_OK;
}

#endif
