// SPDX-License-Identifier: MIT
// A model part of a 3MF file: which element may stand in which.
//
// Reading is a table: a state for each element that is known, and what to do as it begins and ends.
// An element that is not in the table is passed over with all that it holds, which is what the
// specification asks of extensions that are not required; those that change a shape are refused
// where the shape is (threemf_shape.c).

#include "io/threemf_part.h"

#include "base/status.h"
#include "io/cursor.h"
#include "io/number.h"
#include "io/path.h"

#ifdef SF_HAVE_THREEMF

#include <math.h>
#include <string.h>

enum {
    BEFORE,
    MODEL,
    RESOURCES,
    BUILD,
    GROUP_BASE,
    GROUP,
    OBJECT,
    MESH,
    VERTICES,
    TRIANGLES,
    COMPONENTS,
    STACK,
    SLICE,
    POINTS,
    POLYGON,
    LEAF,
    SKIPPED
};

// Namespaces that a part declares; more are of no use to anybody.
enum { PREFIX_MAX = 256 };

// ---------------------------------------------------------------------------------------------
// Attributes
// ---------------------------------------------------------------------------------------------

sf_status sfi_threemf_wrong(const sfi_threemf_part *part, const char *sentence)
{
    return sfi_fault_set(part->all->fault, SF_ERR_FORMAT, sfi_xml_line(part->place), 0, "%.80s: %s",
                         part->name, sentence);
}

sf_status sfi_threemf_wrong_value(const sfi_threemf_part *part, const char *attribute,
                                  const char *expected)
{
    return sfi_fault_set(part->all->fault, SF_ERR_FORMAT, sfi_xml_line(part->place), 0,
                         "%.80s: %s is missing or no %s; export the file again", part->name,
                         attribute, expected);
}

static int is_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

// The text without blanks around it; one that does not fit is no number.
static const char *bare(const char *text, char buffer[SFI_TOKEN_SIZE])
{
    while (is_blank(*text)) {
        text++;
    }
    size_t length = strlen(text);
    if (length == 0 || !is_blank(text[length - 1])) {
        return text;
    }
    while (length > 0 && is_blank(text[length - 1])) {
        length--;
    }
    if (length >= SFI_TOKEN_SIZE) {
        return "";
    }
    memcpy(buffer, text, length);
    buffer[length] = '\0';
    return buffer;
}

static int parse_number(const char *text, double *value)
{
    char buffer[SFI_TOKEN_SIZE];
    double read = 0;
    if (!sfi_number_parse(bare(text, buffer), &read) || !isfinite(read)) {
        return 0;
    }
    *value = read;
    return 1;
}

static int parse_index(const char *text, uint32_t *value)
{
    char buffer[SFI_TOKEN_SIZE];
    int64_t read = 0;
    if (!sfi_integer_parse(bare(text, buffer), &read) || read < 0 || read > INT32_MAX) {
        return 0;
    }
    *value = (uint32_t)read;
    return 1;
}

sf_status sfi_threemf_number(const sfi_threemf_part *part, const char **attributes,
                             const char *name, double *value)
{
    const char *text = sfi_xml_value(attributes, name);
    return text != NULL && parse_number(text, value)
               ? SF_OK
               : sfi_threemf_wrong_value(part, name, "finite number");
}

sf_status sfi_threemf_number_if(const sfi_threemf_part *part, const char **attributes,
                                const char *name, double *value)
{
    return sfi_xml_value(attributes, name) == NULL
               ? SF_OK
               : sfi_threemf_number(part, attributes, name, value);
}

sf_status sfi_threemf_index(const sfi_threemf_part *part, const char **attributes, const char *name,
                            uint32_t *value)
{
    const char *text = sfi_xml_value(attributes, name);
    return text != NULL && parse_index(text, value)
               ? SF_OK
               : sfi_threemf_wrong_value(part, name, "whole number from 0");
}

sf_status sfi_threemf_index_if(const sfi_threemf_part *part, const char **attributes,
                               const char *name, uint32_t *value)
{
    return sfi_xml_value(attributes, name) == NULL
               ? SF_OK
               : sfi_threemf_index(part, attributes, name, value);
}

sf_status sfi_threemf_id(const sfi_threemf_part *part, const char **attributes, const char *name,
                         uint32_t *value)
{
    const char *text = sfi_xml_value(attributes, name);
    return text != NULL && parse_index(text, value) && *value > 0
               ? SF_OK
               : sfi_threemf_wrong_value(part, name, "whole number from 1");
}

sf_status sfi_threemf_count_vertex(sfi_threemf_part *part)
{
    if (part->all->vertices >= part->all->limits.vertices_max) {
        return sfi_fault_set(part->all->fault, SF_ERR_OVERFLOW, sfi_xml_line(part->place), 0,
                             "%.80s: the file has more than %zu vertices; raise vertices_max",
                             part->name, part->all->limits.vertices_max);
    }
    part->all->vertices++;
    return SF_OK;
}

int sfi_threemf_is_map(const sf_transform *map)
{
    const double *m = map->matrix;
    double volume = m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) +
                    m[2] * (m[3] * m[7] - m[4] * m[6]);
    return isfinite(volume) && volume != 0 && isfinite(map->shift_mm[0]) &&
           isfinite(map->shift_mm[1]) && isfinite(map->shift_mm[2]);
}

int sfi_threemf_transform(const char *text, double unit_mm, sf_transform *made)
{
    double t[12];
    char word[SFI_TOKEN_SIZE];
    for (int i = 0; i < 12; i++) {
        size_t length = 0;
        while (is_blank(*text)) {
            text++;
        }
        while (text[length] != '\0' && !is_blank(text[length]) && length + 1 < sizeof word) {
            word[length] = text[length];
            length++;
        }
        word[length] = '\0';
        text += length;
        if (!parse_number(word, &t[i])) {
            return 0;
        }
    }
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) { // rows multiplied from the left become columns
            made->matrix[3 * i + j] = t[3 * j + i];
        }
        made->shift_mm[i] = t[9 + i] * unit_mm;
    }
    while (is_blank(*text)) {
        text++;
    }
    return *text == '\0' && sfi_threemf_is_map(made);
}

// ---------------------------------------------------------------------------------------------
// The model itself
// ---------------------------------------------------------------------------------------------

// What people call an extension, by a word of its namespace.
static const char *extension_name(const char *space)
{
    static const char *const known[][2] = {
        {"beamlattice", "beam lattices"},  {"implicit", "implicit functions"},
        {"volumetric", "volumetric data"}, {"securecontent", "encryption"},
        {"boolean", "boolean operations"}, {"displacement", "displacements"},
        {"toolpath", "toolpaths"},
    };
    for (size_t i = 0; i < sizeof known / sizeof known[0]; i++) {
        if (strstr(space, known[i][0]) != NULL) {
            return known[i][1];
        }
    }
    return "an extension";
}

static const char *space_of(const sfi_threemf_part *part, const char *prefix, size_t length)
{
    char *const *at = part->prefixes.items;
    for (size_t i = 0; i < part->prefixes.count; i += 2) {
        if (strlen(at[i]) == length && memcmp(at[i], prefix, length) == 0) {
            return at[i + 1];
        }
    }
    return NULL;
}

static int is_served(const char *space)
{
    return strcmp(space, SFI_THREEMF_CORE) == 0 || strcmp(space, SFI_THREEMF_MATERIAL) == 0 ||
           strcmp(space, SFI_THREEMF_PRODUCTION) == 0 || strcmp(space, SFI_THREEMF_SLICE) == 0;
}

// A list of prefixes, which are declared by now. It names each of them once.
static sf_status check_required(const sfi_threemf_part *part, const char *list)
{
    for (size_t count = 0; *list != '\0'; count++) {
        size_t length = 0;
        if (count > PREFIX_MAX) {
            return sfi_threemf_wrong(part, "it requires more extensions than there are");
        }
        while (is_blank(*list)) {
            list++;
        }
        while (list[length] != '\0' && !is_blank(list[length])) {
            length++;
        }
        const char *space = length > 0 ? space_of(part, list, length) : SFI_THREEMF_CORE;
        if (space == NULL) {
            return sfi_threemf_wrong(part, "it requires an extension that it does not name");
        }
        if (!is_served(space)) {
            return sfi_fault_set(part->all->fault, SF_ERR_UNSUPPORTED, sfi_xml_line(part->place), 0,
                                 "%.60s: the file requires %s (%.70s), which is not read; export "
                                 "the part as triangles",
                                 part->name, extension_name(space), space);
        }
        list += length;
    }
    return SF_OK;
}

static sf_status begin_model(sfi_threemf_part *part, const char **attributes)
{
    static const struct {
        const char *name;
        double mm;
    } units[] = {{"micron", 1e-3}, {"millimeter", 1}, {"centimeter", 10},
                 {"inch", 25.4},   {"foot", 304.8},   {"meter", 1000}};
    const char *unit = sfi_xml_value(attributes, "unit");
    const char *required = sfi_xml_value(attributes, "requiredextensions");
    part->unit_mm = unit == NULL ? 1 : 0;
    for (size_t i = 0; unit != NULL && i < sizeof units / sizeof units[0]; i++) {
        part->unit_mm = strcmp(unit, units[i].name) == 0 ? units[i].mm : part->unit_mm;
    }
    if (part->unit_mm == 0) {
        return sfi_threemf_wrong_value(part, "unit", "unit of length that 3MF knows");
    }
    return required != NULL ? check_required(part, required) : SF_OK;
}

// ---------------------------------------------------------------------------------------------
// The table
// ---------------------------------------------------------------------------------------------

static const struct rule {
    unsigned char in;
    unsigned char to;
    const char *name;
    sfi_threemf_element *begin, *end;
} rules[] = {
    {BEFORE, MODEL, SFI_THREEMF_CORE "\nmodel", begin_model, NULL},
    {TRIANGLES, LEAF, SFI_THREEMF_CORE "\ntriangle", sfi_threemf_triangle, NULL},
    {VERTICES, LEAF, SFI_THREEMF_CORE "\nvertex", sfi_threemf_vertex, NULL},
    {POLYGON, LEAF, SFI_THREEMF_SLICE "\nsegment", sfi_threemf_segment, NULL},
    {POINTS, LEAF, SFI_THREEMF_SLICE "\nvertex", sfi_threemf_slice_point, NULL},
    {MODEL, RESOURCES, SFI_THREEMF_CORE "\nresources", NULL, NULL},
    {MODEL, BUILD, SFI_THREEMF_CORE "\nbuild", NULL, NULL},
    {RESOURCES, OBJECT, SFI_THREEMF_CORE "\nobject", sfi_threemf_begin_object,
     sfi_threemf_end_object},
    {RESOURCES, GROUP_BASE, SFI_THREEMF_CORE "\nbasematerials", sfi_threemf_begin_group,
     sfi_threemf_end_group},
    {RESOURCES, GROUP, SFI_THREEMF_MATERIAL "\ncolorgroup", sfi_threemf_begin_group,
     sfi_threemf_end_group},
    {RESOURCES, STACK, SFI_THREEMF_SLICE "\nslicestack", sfi_threemf_begin_stack,
     sfi_threemf_end_stack},
    {GROUP_BASE, LEAF, SFI_THREEMF_CORE "\nbase", sfi_threemf_base, NULL},
    {GROUP, LEAF, SFI_THREEMF_MATERIAL "\ncolor", sfi_threemf_colour_of_group, NULL},
    {OBJECT, MESH, SFI_THREEMF_CORE "\nmesh", sfi_threemf_begin_mesh, sfi_threemf_end_mesh},
    {OBJECT, COMPONENTS, SFI_THREEMF_CORE "\ncomponents", NULL, NULL},
    {MESH, VERTICES, SFI_THREEMF_CORE "\nvertices", NULL, NULL},
    {MESH, TRIANGLES, SFI_THREEMF_CORE "\ntriangles", NULL, NULL},
    {COMPONENTS, LEAF, SFI_THREEMF_CORE "\ncomponent", sfi_threemf_component, NULL},
    {BUILD, LEAF, SFI_THREEMF_CORE "\nitem", sfi_threemf_build_item, NULL},
    {STACK, SLICE, SFI_THREEMF_SLICE "\nslice", sfi_threemf_begin_slice, sfi_threemf_end_slice},
    {STACK, LEAF, SFI_THREEMF_SLICE "\nsliceref", sfi_threemf_stack_ref, NULL},
    {SLICE, POINTS, SFI_THREEMF_SLICE "\nvertices", NULL, NULL},
    {SLICE, POLYGON, SFI_THREEMF_SLICE "\npolygon", sfi_threemf_begin_polygon,
     sfi_threemf_end_polygon},
};
enum { RULES = sizeof rules / sizeof rules[0], NO_RULE = 255 };

// Elements of extensions that make the shape of an object, in its stead or beside its triangles.
static sf_status look_at_foreign(sfi_threemf_part *part, int in, const char *name)
{
    const char *local = strchr(name, '\n');
    local = local != NULL ? local + 1 : name;
    if (in == OBJECT && strcmp(local, "metadatagroup") != 0) {
        size_t length = strlen(local);
        length = length < sizeof part->foreign ? length : sizeof part->foreign - 1;
        memcpy(part->foreign, local, length);
        part->foreign[length] = '\0';
    }
    if (in == MESH && strcmp(local, "beamlattice") == 0) {
        return sfi_fault_set(part->all->fault, SF_ERR_UNSUPPORTED, sfi_xml_line(part->place), 0,
                             "%.80s: object %lu is a beam lattice, which is not read; export the "
                             "part as triangles",
                             part->name, (unsigned long)part->object.self.id);
    }
    return SF_OK;
}

// `states` holds what an element is in, or by NO_RULE that it is passed over.
static int state_of(const sfi_threemf_part *part)
{
    unsigned char rule = part->depth > 0 ? part->states[part->depth - 1] : 0;
    return part->depth == 0 ? BEFORE : rule == NO_RULE ? SKIPPED : rules[rule].to;
}

static sf_status on_begin(void *user, const char *name, const char **attributes)
{
    sfi_threemf_part *part = user;
    int in = state_of(part);
    size_t i = 0;
    while (i < RULES && (rules[i].in != in || strcmp(rules[i].name, name) != 0)) {
        i++;
    }
    part->states[part->depth++] = i < RULES ? (unsigned char)i : NO_RULE;
    if (i < RULES) {
        return rules[i].begin != NULL ? rules[i].begin(part, attributes) : SF_OK;
    }
    if (in == BEFORE) {
        return sfi_threemf_wrong(part, "this is no model of 3MF; export the file again");
    }
    return look_at_foreign(part, in, name);
}

static sf_status on_end(void *user)
{
    sfi_threemf_part *part = user;
    unsigned char rule = part->states[--part->depth];
    return rule != NO_RULE && rules[rule].end != NULL ? rules[rule].end(part, NULL) : SF_OK;
}

static sf_status on_prefix(void *user, const char *prefix, const char *space)
{
    sfi_threemf_part *part = user;
    const char *both[2] = {prefix, space};
    if (part->depth > 0) {
        return SF_OK; // the list of what is required stands in the first element
    }
    for (int i = 0; i < 2 && part->prefixes.count < 2 * PREFIX_MAX; i++) {
        char *copy = sfi_path_join(&part->document->allocator, both[i], 0, "");
        if (copy == NULL) {
            return SF_ERR_MEMORY;
        }
        sf_status status = sfi_list_push(&part->document->allocator, &part->prefixes, &copy);
        if (status != SF_OK) {
            sfi_path_free(&part->document->allocator, copy);
            return status;
        }
    }
    return SF_OK;
}

static void release(sfi_threemf_part *part)
{
    const sf_allocator *allocator = &part->document->allocator;
    char **prefixes = part->prefixes.items;
    for (size_t i = 0; i < part->prefixes.count; i++) {
        sfi_path_free(allocator, prefixes[i]);
    }
    sfi_list_free(allocator, &part->prefixes);
    sfi_list_free(allocator, &part->corners);
    sfi_list_free(allocator, &part->object.colours);
    sf_mesh_destroy(part->object.mesh);
    sfi_path_free(allocator, part->object.name);
}

sf_status sfi_threemf_read_part(sfi_threemf_reader *reader, uint32_t number)
{
    sfi_threemf_part part;
    memset(&part, 0, sizeof part);
    part.all = reader;
    part.document = reader->document;
    part.number = number;
    part.name = ((char **)reader->document->parts.items)[number];
    part.prefixes = sfi_list_of(sizeof(char *));
    part.corners = sfi_list_of(2 * sizeof(double));
    part.object.colours = sfi_list_of(3 * sizeof(uint32_t));
    sfi_xml_hearer hearer = {on_begin, on_end, on_prefix, &part};
    sf_status status = sfi_xml_read(reader->zip, part.name, &hearer, &part.place, reader->fault);
    release(&part);
    return status;
}

#endif
