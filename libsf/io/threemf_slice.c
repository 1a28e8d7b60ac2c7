// SPDX-License-Identifier: MIT
// What elements of a 3MF model mean: slices.
//
// A slice names its points by number, as a mesh does; here each polygon has its own, one after the
// other. A polygon must come back to where it began, since what is filled needs a border; so its
// last point, which is its first, is left out.

#include "io/threemf_part.h"

#include "base/status.h"

#ifdef SF_HAVE_THREEMF

#include <string.h>

// Stacks are looked for one by one.
enum { STACKS_MAX = 1024, REFS_MAX = 65536 };

sf_status sfi_threemf_begin_stack(sfi_threemf_part *part, const char **attributes)
{
    sfi_threemf_stack *stack = &part->stack;
    memset(stack, 0, sizeof *stack);
    stack->self.part = part->number;
    stack->slice_first = part->document->slices.count;
    stack->ref_first = part->document->refs.count;
    SF_TRY(sfi_threemf_id(part, attributes, "id", &stack->self.id));
    SF_TRY(sfi_threemf_number_if(part, attributes, "zbottom", &stack->bottom_mm));
    stack->bottom_mm *= part->unit_mm;
    return SF_OK;
}

sf_status sfi_threemf_end_stack(sfi_threemf_part *part, const char **attributes)
{
    sfi_threemf_stack *stack = &part->stack;
    (void)attributes;
    if (part->document->stacks.count >= STACKS_MAX) {
        return sfi_threemf_wrong(part, "there are more than 1024 stacks of slices");
    }
    stack->slice_count = part->document->slices.count - stack->slice_first;
    stack->ref_count = part->document->refs.count - stack->ref_first;
    return stack->slice_count > 0 && stack->ref_count > 0
               ? sfi_threemf_wrong(part, "a stack has both slices and references to slices")
               : sfi_list_push(&part->document->allocator, &part->document->stacks, stack);
}

sf_status sfi_threemf_stack_ref(sfi_threemf_part *part, const char **attributes)
{
    const char *path = sfi_xml_value(attributes, "slicepath");
    sfi_threemf_ref made = {{part->number, 0}, 0};
    if (part->document->refs.count >= REFS_MAX) {
        return sfi_threemf_wrong(part, "there are more than 65536 references to stacks of slices");
    }
    SF_TRY(sfi_threemf_id(part, attributes, "slicestackid", &made.name.id));
    if (path == NULL) {
        return sfi_threemf_wrong_value(part, "slicepath", "path of a part");
    }
    SF_TRY(sfi_threemf_add_part(part->all, path, &made.name.part));
    return sfi_list_push(&part->document->allocator, &part->document->refs, &made);
}

sf_status sfi_threemf_begin_slice(sfi_threemf_part *part, const char **attributes)
{
    sfi_threemf_slice *slice = &part->slice;
    const size_t zero = 0;
    slice->first_point = part->document->points.count;
    slice->first_start = part->document->starts.count;
    slice->contour_count = 0;
    part->corners.count = 0;
    SF_TRY(sfi_threemf_number(part, attributes, "ztop", &slice->top_mm));
    slice->top_mm *= part->unit_mm;
    return sfi_list_push(&part->document->allocator, &part->document->starts, &zero);
}

sf_status sfi_threemf_end_slice(sfi_threemf_part *part, const char **attributes)
{
    const sf_threemf *document = part->document;
    const sfi_threemf_slice *slices = document->slices.items;
    (void)attributes;
    double below = document->slices.count > part->stack.slice_first
                       ? slices[document->slices.count - 1].top_mm
                       : part->stack.bottom_mm;
    return part->slice.top_mm > below
               ? sfi_list_push(&document->allocator, &part->document->slices, &part->slice)
               : sfi_threemf_wrong(part, "the ztop of a slice is not above the one before; export "
                                         "the file again");
}

sf_status sfi_threemf_slice_point(sfi_threemf_part *part, const char **attributes)
{
    double xy[2] = {0, 0};
    SF_TRY(sfi_threemf_number(part, attributes, "x", &xy[0]));
    SF_TRY(sfi_threemf_number(part, attributes, "y", &xy[1]));
    xy[0] *= part->unit_mm;
    xy[1] *= part->unit_mm;
    SF_TRY(sfi_threemf_count_vertex(part));
    return sfi_list_push(&part->document->allocator, &part->corners, xy);
}

static sf_status add_point(sfi_threemf_part *part, uint32_t corner)
{
    const double *corners = part->corners.items;
    if (corner >= part->corners.count) {
        return sfi_threemf_wrong(part, "a polygon names a point that its slice does not have; "
                                       "export the file again");
    }
    SF_TRY(sfi_threemf_count_vertex(part));
    part->last_corner = corner;
    return sfi_list_push(&part->document->allocator, &part->document->points,
                         corners + 2 * (size_t)corner);
}

sf_status sfi_threemf_begin_polygon(sfi_threemf_part *part, const char **attributes)
{
    SF_TRY(sfi_threemf_index(part, attributes, "startv", &part->first_corner));
    return add_point(part, part->first_corner);
}

sf_status sfi_threemf_segment(sfi_threemf_part *part, const char **attributes)
{
    uint32_t corner = 0;
    SF_TRY(sfi_threemf_index(part, attributes, "v2", &corner));
    return add_point(part, corner);
}

sf_status sfi_threemf_end_polygon(sfi_threemf_part *part, const char **attributes)
{
    sf_threemf *document = part->document;
    size_t end = document->points.count - part->slice.first_point;
    const size_t *starts = document->starts.items;
    (void)attributes;
    if (part->last_corner != part->first_corner || end - starts[document->starts.count - 1] < 2) {
        return sfi_threemf_wrong(part, "a polygon of a slice is open; export the file again");
    }
    document->points.count--;
    end--;
    part->slice.contour_count++;
    return sfi_list_push(&document->allocator, &document->starts, &end);
}

#endif
