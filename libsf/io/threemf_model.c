// SPDX-License-Identifier: MIT
// The model of a 3MF file: its XML.
//
// Resources stand before those that name them: colours, then what fills an object, then objects.
// Coordinates are the shortest numbers that read back as the same doubles. Triangles with two equal
// corners are left out, since the specification forbids them.

#include "io/threemf_model.h"

#ifdef SF_HAVE_THREEMF

#include <stdio.h>
#include <string.h>

// Text where XML has a value of an attribute.
static void emit_escaped(sfi_emitter *out, const char *text)
{
    for (; *text != '\0'; text++) {
        switch (*text) {
        case '&':
            sfi_emit_text(out, "&amp;");
            break;
        case '<':
            sfi_emit_text(out, "&lt;");
            break;
        case '>':
            sfi_emit_text(out, "&gt;");
            break;
        case '"':
            sfi_emit_text(out, "&quot;");
            break;
        case '\t':
            sfi_emit_text(out, "&#9;");
            break;
        default:
            sfi_emit_bytes(out, text, 1);
        }
    }
}

static void emit_attribute(sfi_emitter *out, const char *name, uint64_t value)
{
    sfi_emit_text(out, " ");
    sfi_emit_text(out, name);
    sfi_emit_text(out, "=\"");
    sfi_emit_whole(out, value);
    sfi_emit_text(out, "\"");
}

static void emit_words(sfi_emitter *out, const char *name, const char *text)
{
    sfi_emit_text(out, " ");
    sfi_emit_text(out, name);
    sfi_emit_text(out, "=\"");
    emit_escaped(out, text);
    sfi_emit_text(out, "\"");
}

// ---------------------------------------------------------------------------------------------
// Colours
// ---------------------------------------------------------------------------------------------

static void emit_colours(const sf_threemf_view *what, uint32_t first, sfi_emitter *out)
{
    for (size_t i = 0; i < what->colour_count; i++) {
        const sf_threemf_colour *c = &what->colours[i];
        int is_base = c->name[0] != '\0';
        char value[16];
        snprintf(value, sizeof value, "#%02X%02X%02X%02X", c->rgba[0], c->rgba[1], c->rgba[2],
                 c->rgba[3]);
        if (i == 0 || c->group != c[-1].group) {
            sfi_emit_text(out, is_base ? "  <basematerials" : "  <m:colorgroup");
            emit_attribute(out, "id", (uint64_t)first + c->group);
            sfi_emit_text(out, ">\n");
        }
        sfi_emit_text(out, is_base ? "   <base" : "   <m:color");
        if (is_base) {
            emit_words(out, "name", c->name);
        }
        emit_words(out, is_base ? "displaycolor" : "color", value);
        sfi_emit_text(out, "/>\n");
        if (i + 1 == what->colour_count || c->group != c[1].group) {
            sfi_emit_text(out, is_base ? "  </basematerials>\n" : "  </m:colorgroup>\n");
        }
    }
}

// The number of a colour within its group; groups never fall in the list.
static uint32_t entry_of(const sf_threemf_view *what, uint32_t colour)
{
    uint32_t low = 0, high = colour;
    while (low < high) {
        uint32_t middle = low + (high - low) / 2;
        if (what->colours[middle].group < what->colours[colour].group) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return colour - low;
}

// ---------------------------------------------------------------------------------------------
// What fills an object
// ---------------------------------------------------------------------------------------------

void sfi_threemf_sheet(size_t field, uint32_t layer, char path[SFI_THREEMF_SHEET_SIZE])
{
    snprintf(path, SFI_THREEMF_SHEET_SIZE, "/3D/volume_%zu_%05lu.png", field, (unsigned long)layer);
}

// The property's name as XML can have it: "libsf:" and what is a letter, a digit, or else '_'.
// Names that would be the same by that are told apart by a number.
static void emit_property_name(const sf_threemf_volume *v, size_t field, sfi_emitter *out)
{
    sfi_emit_text(out, " name=\"libsf:p");
    sfi_emit_whole(out, field);
    sfi_emit_text(out, "_");
    for (const char *at = v->fields[field].name; *at != '\0'; at++) {
        int is_plain =
            (*at >= 'a' && *at <= 'z') || (*at >= 'A' && *at <= 'Z') || (*at >= '0' && *at <= '9');
        sfi_emit_bytes(out, is_plain ? at : "_", 1);
    }
    sfi_emit_text(out, "\"");
}

static void emit_stack(const sf_threemf_volume *v, size_t field, uint64_t id, sfi_emitter *out)
{
    const sf_lattice *l = &v->lattice;
    sfi_emit_text(out, "  <v:image3d");
    emit_attribute(out, "id", id);
    sfi_emit_text(out, ">\n   <v:imagestack");
    emit_attribute(out, "rowcount", l->ny);
    emit_attribute(out, "columncount", l->nx);
    emit_attribute(out, "sheetcount", l->nz);
    sfi_emit_text(out, ">\n");
    for (uint32_t k = 0; k < l->nz; k++) {
        char path[SFI_THREEMF_SHEET_SIZE];
        sfi_threemf_sheet(field, k, path);
        sfi_emit_text(out, "    <v:imagesheet");
        emit_words(out, "path", path);
        sfi_emit_text(out, "/>\n");
    }
    sfi_emit_text(out, "   </v:imagestack>\n  </v:image3d>\n  <v:functionfromimage3d");
    emit_attribute(out, "id", id + 1);
    emit_words(out, "displayname", v->fields[field].name);
    emit_attribute(out, "image3did", id);
    sfi_emit_text(out, " valueoffset=\"");
    sfi_emit_number(out, v->fields[field].low);
    sfi_emit_text(out, "\" valuescale=\"");
    sfi_emit_number(out, v->fields[field].high - v->fields[field].low);
    sfi_emit_text(out, "\" tilestyleu=\"clamp\" tilestylev=\"clamp\" tilestylew=\"clamp\" "
                       "filter=\"linear\"/>\n");
}

// From the object's axes to the pictures', where the lattice goes from 0 to 1.
static void emit_unit_map(const sf_lattice *l, sfi_emitter *out)
{
    const double size[3] = {l->nx * l->pitch_x_mm, l->ny * l->pitch_y_mm, l->nz * l->layer_mm};
    sfi_emit_text(out, " transform=\"");
    for (int i = 0; i < 9; i++) {
        sfi_emit_number(out, i % 4 == 0 ? 1 / size[i / 4] : 0);
        sfi_emit_text(out, " ");
    }
    for (int i = 0; i < 3; i++) {
        sfi_emit_number(out, -l->origin_mm[i] / size[i]);
        sfi_emit_text(out, i < 2 ? " " : "\"");
    }
}

// Fractions of base materials: a mapping for each, in their order. They are properties besides, for
// readers that know no composites.
static void emit_composite(const sf_threemf_volume *v, sfi_threemf_numbers ids, size_t mixed,
                           sfi_emitter *out)
{
    sfi_emit_text(out, "   <v:composite");
    emit_attribute(out, "basematerialid", (uint64_t)ids.groups + v->mixed_group);
    sfi_emit_text(out, ">\n");
    for (size_t f = 0; f < mixed; f++) {
        sfi_emit_text(out, "    <v:materialmapping");
        emit_attribute(out, "functionid", (uint64_t)ids.volume + 2 * f + 1);
        sfi_emit_text(out, " channel=\"red\"");
        emit_unit_map(&v->lattice, out);
        sfi_emit_text(out, "/>\n");
    }
    sfi_emit_text(out, "   </v:composite>\n");
}

static void emit_volume(const sf_threemf_view *what, const sf_threemf_volume *v,
                        sfi_threemf_numbers ids, sfi_emitter *out)
{
    uint32_t first = ids.volume;
    uint64_t last = (uint64_t)first + 2 * v->field_count;
    for (size_t f = 0; f < v->field_count; f++) {
        emit_stack(v, f, (uint64_t)first + 2 * f, out);
    }
    size_t mixed = sfi_threemf_mixed(what, v);
    sfi_emit_text(out, "  <v:volumedata");
    emit_attribute(out, "id", last);
    sfi_emit_text(out, ">\n");
    if (mixed > 0) {
        emit_composite(v, ids, mixed, out);
    }
    for (size_t f = 0; f < v->field_count; f++) {
        sfi_emit_text(out, "   <v:property");
        emit_property_name(v, f, out);
        emit_attribute(out, "functionid", (uint64_t)first + 2 * f + 1);
        sfi_emit_text(out, " channel=\"red\"");
        emit_unit_map(&v->lattice, out);
        sfi_emit_text(out, "/>\n");
    }
    sfi_emit_text(out, "  </v:volumedata>\n");
}

// ---------------------------------------------------------------------------------------------
// Objects
// ---------------------------------------------------------------------------------------------

static void emit_vertices(sf_mesh_view mesh, sfi_emitter *out)
{
    static const char *const names[3] = {"    <vertex x=\"", "\" y=\"", "\" z=\""};
    sfi_emit_text(out, "   <vertices>\n");
    for (size_t i = 0; i < 3 * mesh.vertex_count; i++) {
        sfi_emit_text(out, names[i % 3]);
        sfi_emit_number(out, mesh.vertices[i]);
        sfi_emit_text(out, i % 3 == 2 ? "\"/>\n" : "");
    }
    sfi_emit_text(out, "   </vertices>\n");
}

static void emit_colours_of(const sf_threemf_view *what, const uint32_t *colours, uint32_t groups,
                            sfi_emitter *out)
{
    if (colours[0] == SF_THREEMF_NONE) {
        return;
    }
    emit_attribute(out, "pid", (uint64_t)groups + what->colours[colours[0]].group);
    emit_attribute(out, "p1", entry_of(what, colours[0]));
    if (colours[1] != colours[0] || colours[2] != colours[0]) {
        emit_attribute(out, "p2", entry_of(what, colours[1]));
        emit_attribute(out, "p3", entry_of(what, colours[2]));
    }
}

static void emit_triangles(const sf_threemf_view *what, const sf_threemf_object *o, uint32_t groups,
                           sfi_emitter *out)
{
    static const char *const names[3] = {"v1", "v2", "v3"};
    sfi_emit_text(out, "   <triangles>\n");
    for (size_t t = 0; t < o->mesh.triangle_count; t++) {
        const uint32_t *c = o->mesh.triangles + 3 * t;
        if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0]) {
            continue;
        }
        sfi_emit_text(out, "    <triangle");
        for (int i = 0; i < 3; i++) {
            emit_attribute(out, names[i], c[i]);
        }
        if (o->colours != NULL) {
            emit_colours_of(what, o->colours + 3 * t, groups, out);
        }
        sfi_emit_text(out, "/>\n");
    }
    sfi_emit_text(out, "   </triangles>\n");
}

// The first colour of an object all of whose triangles have one: what holds where none is said.
static uint32_t default_colour(const sf_threemf_object *o)
{
    for (size_t t = 0; o->colours != NULL && t < o->mesh.triangle_count; t++) {
        if (o->colours[3 * t] == SF_THREEMF_NONE) {
            return SF_THREEMF_NONE;
        }
    }
    return o->colours != NULL ? o->colours[0] : SF_THREEMF_NONE;
}

static void emit_object(const sf_threemf_view *what, size_t number, sfi_threemf_numbers ids,
                        const sf_threemf_volume *volume, sfi_emitter *out)
{
    static const char *const kinds[] = {"model", "solidsupport", "support", "surface", "other"};
    const sf_threemf_object *o = &what->objects[number];
    uint32_t colour = default_colour(o);
    sfi_emit_text(out, "  <object");
    emit_attribute(out, "id", (uint64_t)ids.objects + number);
    if (o->name[0] != '\0') {
        emit_words(out, "name", o->name);
    }
    emit_words(out, "type", kinds[o->kind]);
    if (colour != SF_THREEMF_NONE) {
        emit_attribute(out, "pid", (uint64_t)ids.groups + what->colours[colour].group);
        emit_attribute(out, "pindex", entry_of(what, colour));
    }
    sfi_emit_text(out, ">\n   <mesh");
    if (volume != NULL && volume->object == number) {
        emit_attribute(out, "v:volumeid", (uint64_t)ids.volume + 2 * volume->field_count);
    }
    sfi_emit_text(out, ">\n");
    emit_vertices(o->mesh, out);
    emit_triangles(what, o, ids.groups, out);
    sfi_emit_text(out, "   </mesh>\n  </object>\n");
}

static void emit_item(const sf_threemf_item *item, uint32_t objects, sfi_emitter *out)
{
    const sf_transform *t = &item->placed;
    sfi_emit_text(out, "  <item");
    emit_attribute(out, "objectid", (uint64_t)objects + item->object);
    sfi_emit_text(out, " transform=\"");
    for (int i = 0; i < 9; i++) { // columns become rows
        sfi_emit_number(out, t->matrix[3 * (i % 3) + i / 3]);
        sfi_emit_text(out, " ");
    }
    for (int i = 0; i < 3; i++) {
        sfi_emit_number(out, t->shift_mm[i]);
        sfi_emit_text(out, i < 2 ? " " : "\"/>\n");
    }
}

void sfi_threemf_emit_model(const sf_threemf_view *what, const sf_threemf_extras *extras,
                            sfi_emitter *out)
{
    const sf_threemf_volume *volume = extras->volume;
    uint32_t groups = what->colour_count > 0 ? what->colours[what->colour_count - 1].group + 1 : 0;
    uint32_t filled = volume != NULL ? (uint32_t)(2 * volume->field_count + 1) : 0;
    sfi_threemf_numbers ids = {1, 1 + groups, 1 + groups + filled};
    sfi_emit_text(out, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model unit=\"millimeter\" "
                       "xml:lang=\"en-US\" xmlns=\"" SFI_THREEMF_CORE
                       "\" xmlns:m=\"" SFI_THREEMF_MATERIAL "\"");
    if (volume != NULL) {
        sfi_emit_text(out, " xmlns:v=\"" SFI_THREEMF_VOLUMETRIC
                           "\" xmlns:libsf=\"urn:libsf:property:1\"");
    }
    sfi_emit_text(out, ">\n <metadata name=\"Application\">libsf</metadata>\n <resources>\n");
    emit_colours(what, ids.groups, out);
    if (volume != NULL) {
        emit_volume(what, volume, ids, out);
    }
    for (size_t i = 0; i < what->object_count; i++) {
        emit_object(what, i, ids, volume, out);
    }
    sfi_emit_text(out, " </resources>\n <build>\n");
    for (size_t i = 0; i < what->item_count; i++) {
        emit_item(&what->items[i], ids.objects, out);
    }
    sfi_emit_text(out, " </build>\n</model>\n");
}

#endif
