// SPDX-License-Identifier: MIT
// A model part as it is read: where reading stands, and what its elements do.
//
// threemf_part.c knows which element may stand in which; threemf_shape.c and threemf_slice.c know
// what they mean.

#ifndef SF_IO_THREEMF_PART_H
#define SF_IO_THREEMF_PART_H

#include "io/threemf.h"
#include "io/xml.h"

typedef struct sfi_threemf_part {
    sfi_threemf_reader *all;
    sf_threemf *document;
    const sfi_xml *place;
    const char *name;
    uint32_t number;
    double unit_mm;
    unsigned char states[80];
    int depth;
    sfi_list prefixes; // char *, prefix and namespace in turn
    // What is under construction.
    sfi_threemf_object object;
    char foreign[48]; // what an object holds that is not known, or ""
    sfi_threemf_group group;
    sfi_threemf_stack stack;
    sfi_threemf_slice slice;
    sfi_list corners; // double[2], the points of a slice that its polygons name
    uint32_t first_corner, last_corner;
} sfi_threemf_part;

// What an element does; `attributes` as in xml.h.
typedef sf_status sfi_threemf_element(sfi_threemf_part *part, const char **attributes);

sfi_threemf_element sfi_threemf_begin_object, sfi_threemf_end_object, sfi_threemf_begin_mesh,
    sfi_threemf_end_mesh, sfi_threemf_vertex, sfi_threemf_triangle, sfi_threemf_component,
    sfi_threemf_build_item, sfi_threemf_begin_group, sfi_threemf_end_group, sfi_threemf_base,
    sfi_threemf_colour_of_group;
sfi_threemf_element sfi_threemf_begin_stack, sfi_threemf_end_stack, sfi_threemf_begin_slice,
    sfi_threemf_end_slice, sfi_threemf_stack_ref, sfi_threemf_slice_point,
    sfi_threemf_begin_polygon, sfi_threemf_end_polygon, sfi_threemf_segment;

// A fault at the place where reading stands; the second for an attribute that is not what it should
// be.
sf_status sfi_threemf_wrong(const sfi_threemf_part *part, const char *sentence);
sf_status sfi_threemf_wrong_value(const sfi_threemf_part *part, const char *attribute,
                                  const char *expected);

// A finite number, a whole one from 0 below 2^31, a resource's number from 1; each a fault where it
// is missing or none. The last two leave `value` where the attribute is not there.
sf_status sfi_threemf_number(const sfi_threemf_part *part, const char **attributes,
                             const char *name, double *value);
sf_status sfi_threemf_index(const sfi_threemf_part *part, const char **attributes, const char *name,
                            uint32_t *value);
sf_status sfi_threemf_id(const sfi_threemf_part *part, const char **attributes, const char *name,
                         uint32_t *value);

// The same of attributes that may be missing; `value` stays then.
sf_status sfi_threemf_index_if(const sfi_threemf_part *part, const char **attributes,
                               const char *name, uint32_t *value);
sf_status sfi_threemf_number_if(const sfi_threemf_part *part, const char **attributes,
                                const char *name, double *value);

// Another vertex or point, within the limits.
sf_status sfi_threemf_count_vertex(sfi_threemf_part *part);

#endif
