// SPDX-License-Identifier: MIT
// The slices of a 3MF file as a stack of contours.
//
// A stack of slices may be a list of other stacks, one above the other; then the top of the one
// before is the bottom of the next, whatever that says itself. Each item brings the stack of its
// object to its place: along z it is only shifted, which the specification demands and which is
// held here to the last bit. Layers of several items are one layer when their heights are the same
// to a billionth, since each was shifted and rounded by itself.

#include "io/threemf.h"

#include "base/status.h"

#include <string.h>

#ifdef SF_HAVE_THREEMF

#include <math.h>

static const double ROUNDING = 1e-9; // of a layer's top

// One stack in its place, walked from its lowest slice up.
typedef struct climb {
    const sf_transform *placed;
    const sfi_threemf_stack *whole; // that the object names
    size_t ref;                     // which of its references is walked
    const sfi_threemf_stack *stack; // that has the slices
    size_t slice;                   // next of them
} climb;

typedef struct builder {
    const sf_threemf *document;
    const sf_allocator *allocator;
    sf_fault *fault;
    sfi_list climbs; // one for each item
    sfi_list points; // double[2], of the layer under construction
    sfi_list starts; // size_t
    sf_contour_stack *made;
    double top_mm; // of it, so far
    size_t left;   // points and slices that may still be placed
} builder;

static int is_printed(const sf_threemf_object *object)
{
    return object->kind == SF_THREEMF_MODEL || object->kind == SF_THREEMF_SOLID_SUPPORT;
}

int sf_threemf_is_sliced(const sf_threemf *document)
{
    sf_threemf_view view = sf_threemf_get_view(document);
    size_t sliced = 0;
    for (size_t i = 0; i < view.item_count; i++) {
        const sf_threemf_object *object = &view.objects[view.items[i].object];
        if (is_printed(object)) {
            if (object->stack == SF_THREEMF_NONE) {
                return 0;
            }
            sliced++;
        }
    }
    return sliced > 0;
}

// ---------------------------------------------------------------------------------------------
// Walking up
// ---------------------------------------------------------------------------------------------

static const sfi_threemf_slice *next_slice(const builder *b, climb *c)
{
    const sfi_threemf_ref *refs = b->document->refs.items;
    const sfi_threemf_stack *stacks = b->document->stacks.items;
    const sfi_threemf_slice *slices = b->document->slices.items;
    while (c->slice == c->stack->slice_count && c->ref + 1 < c->whole->ref_count) {
        c->ref++;
        c->stack = stacks + refs[c->whole->ref_first + c->ref].stack;
        c->slice = 0;
    }
    return c->slice < c->stack->slice_count ? slices + c->stack->slice_first + c->slice : NULL;
}

static int is_level(const sf_transform *map)
{
    const double *m = map->matrix;
    return m[2] == 0 && m[5] == 0 && m[6] == 0 && m[7] == 0 && m[8] == 1;
}

static int is_same(double height_mm, double other_mm)
{
    return fabs(height_mm - other_mm) <= ROUNDING * (1 + fabs(other_mm));
}

static sf_status refuse_heights(const builder *b)
{
    return sfi_fault_set(b->fault, SF_ERR_UNSUPPORTED, 0, 0,
                         "the objects have layers of different heights; export them one by one");
}

static sf_status begin(builder *b)
{
    sf_threemf_view view = sf_threemf_get_view(b->document);
    const sfi_threemf_ref *refs = b->document->refs.items;
    const sfi_threemf_stack *stacks = b->document->stacks.items;
    double bottom_mm = 0;
    for (size_t i = 0; i < view.item_count; i++) {
        const sf_threemf_object *object = &view.objects[view.items[i].object];
        if (!is_printed(object)) {
            continue;
        }
        if (object->stack == SF_THREEMF_NONE || !is_level(&view.items[i].placed)) {
            return sfi_fault_set(b->fault, SF_ERR_FORMAT, 0, 0,
                                 object->stack == SF_THREEMF_NONE
                                     ? "object '%.60s' has no slices"
                                     : "the slices of object '%.60s' are tilted or stretched, so "
                                       "they are no layers",
                                 object->name);
        }
        climb c = {&view.items[i].placed, stacks + object->stack, 0, stacks + object->stack, 0};
        if (c.whole->ref_count > 0) {
            c.stack = stacks + refs[c.whole->ref_first].stack;
        }
        double bottom = c.stack->bottom_mm + c.placed->shift_mm[2];
        if (b->climbs.count > 0 && !is_same(bottom, bottom_mm)) {
            return refuse_heights(b);
        }
        bottom_mm = b->climbs.count == 0 ? bottom : bottom_mm;
        SF_TRY(sfi_list_push(b->allocator, &b->climbs, &c));
    }
    if (b->climbs.count == 0) {
        return sfi_fault_set(b->fault, SF_ERR_FORMAT, 0, 0, "nothing that is built has slices");
    }
    sf_status status = sf_contour_stack_create(bottom_mm, b->allocator, &b->made);
    return status == SF_ERR_ARGUMENT
               ? sfi_fault_set(b->fault, status, 0, 0, "the slices lie beyond 1e12 mm")
               : status;
}

// ---------------------------------------------------------------------------------------------
// Layers
// ---------------------------------------------------------------------------------------------

// Few slices in many places are many points, of which a small file could ask for any number. A
// slice counts for a point, since walking takes time too.
static sf_status count_points(builder *b, const sfi_threemf_slice *slice)
{
    const size_t *starts = (const size_t *)b->document->starts.items + slice->first_start;
    size_t count = starts[slice->contour_count];
    if (count >= b->left) {
        return sfi_fault_set(b->fault, SF_ERR_OVERFLOW, 0, 0,
                             "the slices of all that is built have more than %zu points; raise "
                             "vertices_max where the file is read",
                             b->document->vertices_max);
    }
    b->left -= count + 1;
    return SF_OK;
}

// Append a slice's contours in their place. A map that mirrors turns them around.
static sf_status add_contours(builder *b, const climb *c, const sfi_threemf_slice *slice)
{
    const double *points = (const double *)b->document->points.items + 2 * slice->first_point;
    const size_t *starts = (const size_t *)b->document->starts.items + slice->first_start;
    const double *m = c->placed->matrix, *shift = c->placed->shift_mm;
    int turn = m[0] * m[4] - m[1] * m[3] < 0;
    for (size_t i = 0; i < slice->contour_count; i++) {
        size_t count = starts[i + 1] - starts[i];
        for (size_t k = 0; k < count; k++) {
            const double *p = points + 2 * (starts[i] + (turn ? count - 1 - k : k));
            double at[2] = {m[0] * p[0] + m[1] * p[1] + shift[0],
                            m[3] * p[0] + m[4] * p[1] + shift[1]};
            SF_TRY(sfi_list_push(b->allocator, &b->points, at));
        }
        SF_TRY(sfi_list_push(b->allocator, &b->starts, &b->points.count));
    }
    return SF_OK;
}

// The next layer of all items; `done` when they end together.
static sf_status add_layer(builder *b, int *done)
{
    climb *climbs = b->climbs.items;
    const size_t zero = 0;
    double top_mm = 0;
    size_t ended = 0;
    b->points.count = b->starts.count = 0;
    SF_TRY(sfi_list_push(b->allocator, &b->starts, &zero));
    for (size_t i = 0; i < b->climbs.count; i++) {
        const sfi_threemf_slice *slice = next_slice(b, &climbs[i]);
        double top = slice != NULL ? slice->top_mm + climbs[i].placed->shift_mm[2] : top_mm;
        ended += slice == NULL;
        if ((ended > 0 && ended != i + 1) || (i > 0 && !is_same(top, top_mm))) {
            return refuse_heights(b);
        }
        top_mm = i == 0 ? top : top_mm;
        if (slice != NULL) {
            SF_TRY(count_points(b, slice));
            SF_TRY(add_contours(b, &climbs[i], slice));
            climbs[i].slice++;
        }
    }
    *done = ended > 0;
    if (*done) {
        return SF_OK;
    }
    if (sf_contour_stack_count(b->made) > 0 && !(top_mm > b->top_mm)) {
        return sfi_fault_set(b->fault, SF_ERR_FORMAT, 0, 0,
                             "slice %lu, counted from 0, is not above the one before; export the "
                             "file again",
                             (unsigned long)sf_contour_stack_count(b->made));
    }
    b->top_mm = top_mm;
    sf_contours contours = {b->points.items, b->starts.items, b->starts.count - 1};
    return sf_contour_stack_add(b->made, top_mm, &contours, b->fault);
}

sf_status sf_threemf_contours(const sf_threemf *document, const sf_allocator *allocator,
                              sf_contour_stack **stack, sf_fault *fault)
{
    sf_allocator kept = sfi_allocator_or_default(allocator);
    builder b = {document,
                 &kept,
                 fault,
                 sfi_list_of(sizeof(climb)),
                 sfi_list_of(2 * sizeof(double)),
                 sfi_list_of(sizeof(size_t)),
                 NULL,
                 0,
                 document != NULL ? document->vertices_max : 0};
    if (document == NULL || stack == NULL) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "no document, no place for the stack");
    }
    sf_status status = begin(&b);
    for (int done = 0; status == SF_OK && !done;) {
        status = add_layer(&b, &done);
    }
    sfi_list_free(&kept, &b.climbs);
    sfi_list_free(&kept, &b.points);
    sfi_list_free(&kept, &b.starts);
    if (status != SF_OK) {
        sf_contour_stack_destroy(b.made);
        return status == SF_ERR_MEMORY
                   ? sfi_fault_set(fault, status, 0, 0, "there is not enough memory for the slices")
                   : status;
    }
    *stack = b.made;
    return SF_OK;
}

#else

int sf_threemf_is_sliced(const sf_threemf *document)
{
    (void)document;
    return 0;
}

sf_status sf_threemf_contours(const sf_threemf *document, const sf_allocator *allocator,
                              sf_contour_stack **stack, sf_fault *fault)
{
    (void)allocator;
    if (document == NULL || stack == NULL) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "no document, no place for the stack");
    }
    return sfi_fault_set(fault, SF_ERR_UNSUPPORTED, 0, 0, "this build reads no 3MF");
}

#endif
