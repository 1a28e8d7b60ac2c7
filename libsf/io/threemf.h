// SPDX-License-Identifier: MIT
// What the reader of 3MF files keeps, and what its files share.
//
// A file is a handful of XML parts. Each is read once, front to back, into flat lists: objects,
// components, materials, slices. Parts name one another and their resources by number, and nothing
// says in which order; so numbers are kept as they come, and looked up when all parts are read
// (threemf_build.c).

#ifndef SF_IO_THREEMF_H
#define SF_IO_THREEMF_H

#include <sf/threemf.h>

#include "io/list.h"
#include "io/zip_read.h"

#define SFI_THREEMF_CORE "http://schemas.microsoft.com/3dmanufacturing/core/2015/02"
#define SFI_THREEMF_MATERIAL "http://schemas.microsoft.com/3dmanufacturing/material/2015/02"
#define SFI_THREEMF_PRODUCTION "http://schemas.microsoft.com/3dmanufacturing/production/2015/06"
#define SFI_THREEMF_SLICE "http://schemas.microsoft.com/3dmanufacturing/slice/2015/07"
#define SFI_THREEMF_VOLUMETRIC "http://schemas.3mf.io/3dmanufacturing/volumetric/2022/01"
#define SFI_THREEMF_RELATIONS "http://schemas.openxmlformats.org/package/2006/relationships"
#define SFI_THREEMF_TYPES "http://schemas.openxmlformats.org/package/2006/content-types"
#define SFI_THREEMF_MODEL "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"
#define SFI_THREEMF_TEXTURE "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dtexture"
#define SFI_THREEMF_THUMBNAIL                                                                      \
    "http://schemas.openxmlformats.org/package/2006/relationships/metadata/thumbnail"

// A resource by its number, and the part that it is in. Number 0 is nothing.
typedef struct sfi_threemf_name {
    uint32_t part, id;
} sfi_threemf_name;

// An object as it is read. One that is made of others has no mesh.
typedef struct sfi_threemf_object {
    sfi_threemf_name self, stack;
    sf_threemf_kind kind;
    char *name; // NULL: none
    sf_mesh *mesh;
    sfi_list colours; // uint32_t[3] for each triangle
    int has_colours;
    int is_rough;          // its triangles only stand for its slices
    uint32_t group, entry; // what its triangles have where they do not say; 0: nothing
    size_t component_first, component_count;
    uint32_t number; // among those that have a mesh
} sfi_threemf_object;

// An object placed, in another one or in the build.
typedef struct sfi_threemf_placing {
    sfi_threemf_name object;
    sf_transform placed;
} sfi_threemf_placing;

// Colours of a group are neighbours in the document's list.
typedef struct sfi_threemf_group {
    sfi_threemf_name self;
    size_t first, count;
} sfi_threemf_group;

typedef struct sfi_threemf_slice {
    double top_mm;
    size_t first_point, first_start, contour_count;
} sfi_threemf_slice;

// A stack by its name, and from sfi_threemf_build() on by its number.
typedef struct sfi_threemf_ref {
    sfi_threemf_name name;
    uint32_t stack;
} sfi_threemf_ref;

// A stack of slices, or of names of other stacks.
typedef struct sfi_threemf_stack {
    sfi_threemf_name self;
    double bottom_mm;
    size_t slice_first, slice_count, ref_first, ref_count;
} sfi_threemf_stack;

struct sf_threemf {
    sf_allocator allocator;
    sfi_list parts;      // char *, names of entries, without the first slash
    sfi_list objects;    // sfi_threemf_object
    sfi_list components; // sfi_threemf_placing
    sfi_list builds;     // sfi_threemf_placing
    sfi_list groups;     // sfi_threemf_group
    sfi_list colours;    // sf_threemf_colour
    sfi_list stacks;     // sfi_threemf_stack
    sfi_list refs;       // sfi_threemf_ref
    sfi_list slices;     // sfi_threemf_slice
    sfi_list points;     // double[2], of all slices
    sfi_list starts;     // size_t, of each slice its own from 0
    sfi_list views;      // sf_threemf_object
    sfi_list items;      // sf_threemf_item
    size_t vertices_max; // of the slices in their places, as of the file
};

// Where reading stands; the fault is told of there.
typedef struct sfi_threemf_reader {
    sf_threemf *document;
    sfi_zip *zip;
    sf_read_limits limits;
    size_t triangles, vertices; // of all objects so far, points of slices among the latter
    sf_fault *fault;
} sfi_threemf_reader;

// Read a model part. `part` is its number in the document's list.
sf_status sfi_threemf_read_part(sfi_threemf_reader *reader, uint32_t part);

// The number of a part by the path that a model or a relationship names it by. New ones are
// appended to the list. A path that is none is refused with a fault.
sf_status sfi_threemf_add_part(sfi_threemf_reader *reader, const char *path, uint32_t *part);

// Resolve names: what is built, one item for each place, and the views.
sf_status sfi_threemf_build(sfi_threemf_reader *reader);

// "1 0 0 0 1 0 0 0 1 0 0 0" in a unit of length, to a map; returns 0 where it is none.
int sfi_threemf_transform(const char *text, double unit_mm, sf_transform *made);

// Whether a map is of finite numbers and keeps a volume.
int sfi_threemf_is_map(const sf_transform *map);

#endif
