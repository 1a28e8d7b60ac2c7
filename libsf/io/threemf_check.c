// SPDX-License-Identifier: MIT
// What a 3MF file can say, held against what it is to say, before its first byte is written.

#include "io/threemf_model.h"

#include "base/status.h"

#ifdef SF_HAVE_THREEMF

#include <float.h>
#include <math.h>
#include <string.h>

// Most bytes that a vertex, a triangle and all else of an entry take; the archive's sizes have 32
// bits.
enum { VERTEX_SIZE = 112, TRIANGLE_SIZE = 120, SHEETS_MAX = 65000, FIELDS_MAX = 64 };
static const uint64_t MODEL_MOST = (uint64_t)4000 << 20;

static sf_status refuse(sf_fault *fault, size_t object, const char *sentence)
{
    return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "object %zu %s", object, sentence);
}

// UTF-8 without characters that XML has no words for.
static int is_text(const char *text)
{
    const unsigned char *at = (const unsigned char *)text;
    while (*at != '\0') {
        int more = *at < 0x80 ? 0 : *at < 0xc2 ? -1 : *at < 0xe0 ? 1 : *at < 0xf0 ? 2 : 3;
        uint32_t code = more <= 0 ? *at : *at & (0x3fu >> more);
        if (more < 0 || *at > 0xf4 || (*at < 0x20 && *at != '\t')) {
            return 0;
        }
        at++;
        for (int i = 0; i < more; i++, at++) {
            if ((*at & 0xc0) != 0x80) {
                return 0;
            }
            code = code << 6 | (*at & 0x3fu);
        }
        int is_short = (more == 2 && code < 0x800) || (more == 3 && code < 0x10000);
        if (is_short || code > 0x10ffff || (code >= 0xd800 && code < 0xe000) ||
            (code & 0xfffe) == 0xfffe) {
            return 0;
        }
    }
    return 1;
}

static sf_status check_colours(const sf_threemf_view *what, sf_fault *fault)
{
    for (size_t i = 0; i < what->colour_count; i++) {
        const sf_threemf_colour *c = &what->colours[i];
        int is_first = i == 0 || c->group != c[-1].group;
        int is_next = c->group == (i == 0 ? 0 : c[-1].group + (is_first ? 1u : 0u));
        if (c->name == NULL || !is_text(c->name) || !is_next ||
            (!is_first && (c->name[0] == '\0') != (c[-1].name[0] == '\0'))) {
            return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                                 "colour %zu has a name that is no text, a group out of its turn, "
                                 "or neighbours with names where it has none",
                                 i);
        }
    }
    return SF_OK;
}

static int is_triangle(const uint32_t *corners)
{
    return corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0];
}

// Colours of a triangle's corners: none, or of one group, and one where they are materials.
static int can_colour(const sf_threemf_view *what, const uint32_t *colours)
{
    uint32_t first = colours[0];
    if (first == SF_THREEMF_NONE) {
        return colours[1] == first && colours[2] == first;
    }
    for (int i = 0; i < 3; i++) {
        if (colours[i] >= what->colour_count ||
            what->colours[colours[i]].group != what->colours[first].group ||
            (what->colours[first].name[0] != '\0' && colours[i] != first)) {
            return 0;
        }
    }
    return 1;
}

static sf_status check_object(const sf_threemf_view *what, size_t number, uint64_t *bytes,
                              sf_fault *fault)
{
    const sf_threemf_object *o = &what->objects[number];
    size_t triangles = 0;
    SF_TRY(sf_mesh_validate(o->mesh, fault));
    if (o->name == NULL || !is_text(o->name) || (unsigned)o->kind > SF_THREEMF_OTHER) {
        return refuse(fault, number, "has a name that is no text, or a kind that there is not");
    }
    if (o->stack != SF_THREEMF_NONE || o->is_rough) {
        return sfi_fault_set(fault, SF_ERR_UNSUPPORTED, 0, 0,
                             "object %zu has slices, which are not written", number);
    }
    for (size_t t = 0; t < o->mesh.triangle_count; t++) {
        triangles += (size_t)is_triangle(o->mesh.triangles + 3 * t);
        if (o->colours != NULL && !can_colour(what, o->colours + 3 * t)) {
            return refuse(fault, number,
                          "has a triangle whose colours are not there, are of two groups, or mix "
                          "materials");
        }
    }
    if (triangles == 0) {
        return refuse(fault, number, "has no triangles of three corners");
    }
    *bytes += (uint64_t)o->mesh.vertex_count * VERTEX_SIZE +
              (uint64_t)o->mesh.triangle_count * TRIANGLE_SIZE + 6 * strlen(o->name);
    return SF_OK;
}

static sf_status check_items(const sf_threemf_view *what, sf_fault *fault)
{
    for (size_t i = 0; i < what->item_count; i++) {
        const sf_threemf_item *item = &what->items[i];
        if (item->object >= what->object_count || !sfi_threemf_is_map(&item->placed) ||
            what->objects[item->object].kind == SF_THREEMF_OTHER) {
            return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                                 "item %zu names an object that there is not or that is of no "
                                 "printed kind, or its map flattens",
                                 i);
        }
    }
    return what->item_count > 0
               ? SF_OK
               : sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "there are no items to be built");
}

size_t sfi_threemf_mixed(const sf_threemf_view *what, const sf_threemf_volume *volume)
{
    size_t count = 0;
    for (size_t i = 0; volume->mixed_group != SF_THREEMF_NONE && i < what->colour_count; i++) {
        count += what->colours[i].group == volume->mixed_group;
    }
    return count;
}

// Whether the group that is mixed is one of base materials, with a fraction for each.
static int can_mix(const sf_threemf_view *what, const sf_threemf_volume *v)
{
    size_t mixed = sfi_threemf_mixed(what, v);
    for (size_t i = 0; i < what->colour_count; i++) {
        if (what->colours[i].group == v->mixed_group && what->colours[i].name[0] == '\0') {
            return 0;
        }
    }
    return v->mixed_group == SF_THREEMF_NONE || (mixed > 0 && mixed <= v->field_count);
}

static sf_status check_volume(const sf_threemf_view *what, const sf_threemf_volume *v,
                              sf_fault *fault)
{
    SF_TRY(sf_lattice_validate(&v->lattice));
    if (v->object >= what->object_count || v->layer == NULL || v->fields == NULL ||
        v->field_count < 1 || v->field_count > FIELDS_MAX || v->lattice.heights_mm != NULL) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                             "a volume needs an object, 1 to %d properties, layers of one height, "
                             "and something that fills them",
                             FIELDS_MAX);
    }
    for (size_t i = 0; i < v->field_count; i++) {
        const sf_threemf_field *f = &v->fields[i];
        if (f->name == NULL || f->name[0] == '\0' || !is_text(f->name) || !(f->low < f->high) ||
            !(f->low >= -DBL_MAX) || !(f->high <= DBL_MAX) || !isfinite(f->high - f->low)) {
            return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                                 "property %zu has no name, or no range of values", i);
        }
    }
    if (!can_mix(what, v)) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                             "a volume mixes no group of base materials, or has fewer properties "
                             "than that has materials");
    }
    if (v->field_count * (uint64_t)v->lattice.nz > SHEETS_MAX) {
        return sfi_fault_set(fault, SF_ERR_OVERFLOW, 0, 0,
                             "there are more than %d layers of properties; take thicker ones",
                             SHEETS_MAX);
    }
    return sf_stack_has_png()
               ? SF_OK
               : sfi_fault_set(fault, SF_ERR_UNSUPPORTED, 0, 0,
                               "properties are PNG pictures, which this build does not write; "
                               "build it with libspng");
}

static int is_png(const void *bytes, size_t size)
{
    return size > 8 && memcmp(bytes, "\211PNG\r\n\032\n", 8) == 0;
}

sf_status sfi_threemf_check(const sf_threemf_view *what, const sf_threemf_extras *extras,
                            sf_fault *fault)
{
    uint64_t bytes = 96 * (uint64_t)what->colour_count + 512 * (uint64_t)what->item_count;
    if ((what->object_count > 0 && what->objects == NULL) ||
        (what->item_count > 0 && what->items == NULL) ||
        (what->colour_count > 0 && what->colours == NULL) || what->object_count >= INT32_MAX / 4 ||
        what->colour_count >= INT32_MAX / 4) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                             "a list of objects, items or colours is missing or too long");
    }
    SF_TRY(check_colours(what, fault));
    for (size_t i = 0; i < what->object_count; i++) {
        SF_TRY(check_object(what, i, &bytes, fault));
    }
    SF_TRY(check_items(what, fault));
    if (extras->volume != NULL) {
        SF_TRY(check_volume(what, extras->volume, fault));
    }
    if (extras->thumbnail != NULL && !is_png(extras->thumbnail, extras->thumbnail_size)) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "the thumbnail is no PNG picture");
    }
    return bytes <= MODEL_MOST && extras->thumbnail_size <= MODEL_MOST
               ? SF_OK
               : sfi_fault_set(fault, SF_ERR_OVERFLOW, 0, 0,
                               "the mesh is too large for 3MF, whose parts are of 4 GiB at most; "
                               "write PLY");
}

#endif
