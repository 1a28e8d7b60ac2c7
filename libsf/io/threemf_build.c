// SPDX-License-Identifier: MIT
// What a 3MF file builds: names resolved, one item for each place that an object takes.
//
// Objects may be made of others, which may be made of others again. The walk is a loop over a stack
// of frames, at most 64 deep, and an object that is met within itself is refused: a file of a
// kilobyte could otherwise ask for more places than there are atoms. For the same reason places are
// counted.

#include "io/threemf.h"

#include "base/status.h"

#ifdef SF_HAVE_THREEMF

#include <string.h>

enum { DEPTH = 64, ITEMS_MAX = 100000 };

static sfi_threemf_object *objects_of(const sf_threemf *document)
{
    return document->objects.items;
}

static const char *part_name(const sf_threemf *document, uint32_t part)
{
    return ((char *const *)document->parts.items)[part];
}

// ---------------------------------------------------------------------------------------------
// Names
// ---------------------------------------------------------------------------------------------

static int compare(sfi_threemf_name a, sfi_threemf_name b)
{
    return a.part != b.part ? (a.part < b.part ? -1 : 1) : a.id < b.id ? -1 : a.id > b.id;
}

// The place of a name in a sorted list of numbers of objects: of it, or of where it would stand.
static size_t place_of(const sf_threemf *document, const uint32_t *sorted, size_t count,
                       sfi_threemf_name name)
{
    const sfi_threemf_object *objects = document->objects.items;
    size_t low = 0, high = count;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (compare(objects[sorted[middle]].self, name) < 0) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low;
}

// Let number `root` sink in a heap whose greatest name is on top.
static void sink(const sf_threemf *document, uint32_t *heap, size_t root, size_t count)
{
    const sfi_threemf_object *objects = document->objects.items;
    for (size_t child = 2 * root + 1; child < count; child = 2 * root + 1) {
        if (child + 1 < count &&
            compare(objects[heap[child]].self, objects[heap[child + 1]].self) < 0) {
            child++;
        }
        if (compare(objects[heap[root]].self, objects[heap[child]].self) >= 0) {
            return;
        }
        uint32_t moved = heap[root];
        heap[root] = heap[child];
        heap[child] = moved;
        root = child;
    }
}

// Numbers of objects, sorted by name; two of one name are refused.
static sf_status sort_objects(const sfi_threemf_reader *reader, uint32_t *sorted)
{
    const sf_threemf *document = reader->document;
    const sfi_threemf_object *objects = document->objects.items;
    size_t count = document->objects.count;
    for (size_t i = 0; i < count; i++) {
        sorted[i] = (uint32_t)i;
    }
    for (size_t i = count / 2; i-- > 0;) {
        sink(document, sorted, i, count);
    }
    for (size_t left = count; left > 1; left--) {
        uint32_t last = sorted[left - 1];
        sorted[left - 1] = sorted[0];
        sorted[0] = last;
        sink(document, sorted, 0, left - 1);
    }
    for (size_t i = 1; i < count; i++) {
        sfi_threemf_name name = objects[sorted[i]].self;
        if (compare(objects[sorted[i - 1]].self, name) == 0) {
            return sfi_fault_set(reader->fault, SF_ERR_FORMAT, 0, 0,
                                 "%.80s has two objects %lu; export the file again",
                                 part_name(document, name.part), (unsigned long)name.id);
        }
    }
    return SF_OK;
}

static sf_status find_object(const sfi_threemf_reader *reader, const uint32_t *sorted,
                             sfi_threemf_name name, uint32_t *object)
{
    const sf_threemf *document = reader->document;
    const sfi_threemf_object *objects = document->objects.items;
    size_t at = place_of(document, sorted, document->objects.count, name);
    if (at == document->objects.count || compare(objects[sorted[at]].self, name) != 0) {
        return sfi_fault_set(reader->fault, SF_ERR_FORMAT, 0, 0,
                             "%.80s has no object %lu, which is to be built; export the file again",
                             part_name(document, name.part), (unsigned long)name.id);
    }
    *object = sorted[at];
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Places
// ---------------------------------------------------------------------------------------------

// The map that does `first` and then `then`.
static sf_transform chain(const sf_transform *first, const sf_transform *then)
{
    sf_transform made;
    for (int i = 0; i < 3; i++) {
        const double *row = then->matrix + 3 * i;
        for (int j = 0; j < 3; j++) {
            made.matrix[3 * i + j] = row[0] * first->matrix[j] + row[1] * first->matrix[3 + j] +
                                     row[2] * first->matrix[6 + j];
        }
        made.shift_mm[i] = row[0] * first->shift_mm[0] + row[1] * first->shift_mm[1] +
                           row[2] * first->shift_mm[2] + then->shift_mm[i];
    }
    return made;
}

// An object that is being walked: where it lies, and which of its components comes next.
typedef struct frame {
    uint32_t object;
    size_t next;
    sf_transform placed;
} frame;

static sf_status add_item(const sfi_threemf_reader *reader, const frame *f)
{
    sf_threemf *document = reader->document;
    sf_threemf_item item = {objects_of(document)[f->object].number, f->placed};
    if (!sfi_threemf_is_map(&f->placed)) { // each one was, but not all of them together
        return sfi_fault_set(reader->fault, SF_ERR_OVERFLOW, 0, 0,
                             "transforms of the file together move object '%.60s' beyond all "
                             "bounds, or flatten it; export the file again",
                             objects_of(document)[f->object].name);
    }
    if (document->items.count >= ITEMS_MAX) {
        return sfi_fault_set(reader->fault, SF_ERR_OVERFLOW, 0, 0,
                             "the file places more than %d objects; this looks like an attack",
                             ITEMS_MAX);
    }
    return sfi_list_push(&document->allocator, &document->items, &item);
}

static sf_status refuse_nesting(const sfi_threemf_reader *reader, const frame *frames, int depth,
                                uint32_t object)
{
    sfi_threemf_name name = objects_of(reader->document)[object].self;
    int is_cycle = 0;
    for (int i = 0; i < depth; i++) {
        is_cycle = is_cycle || frames[i].object == object;
    }
    if (!is_cycle && depth < DEPTH) {
        return SF_OK;
    }
    return sfi_fault_set(reader->fault, SF_ERR_FORMAT, 0, 0,
                         is_cycle ? "%.80s: object %lu contains itself; export the file again"
                                  : "%.80s: object %lu lies too deep in others; export the file "
                                    "again with fewer levels",
                         part_name(reader->document, name.part), (unsigned long)name.id);
}

static sf_status walk(const sfi_threemf_reader *reader, const uint32_t *sorted,
                      const sfi_threemf_placing *build)
{
    const sf_threemf *document = reader->document;
    const sfi_threemf_placing *components = document->components.items;
    frame frames[DEPTH];
    int depth = 1;
    frames[0].next = 0;
    frames[0].placed = build->placed;
    SF_TRY(find_object(reader, sorted, build->object, &frames[0].object));
    while (depth > 0) { // each step leads on to a place: no object is without a mesh and components
        frame *top = &frames[depth - 1];
        const sfi_threemf_object *object = objects_of(document) + top->object;
        if (object->mesh != NULL) {
            SF_TRY(add_item(reader, top));
            depth--;
        } else if (top->next == object->component_count) {
            depth--;
        } else {
            const sfi_threemf_placing *c = components + object->component_first + top->next++;
            uint32_t inner = 0;
            SF_TRY(find_object(reader, sorted, c->object, &inner));
            SF_TRY(refuse_nesting(reader, frames, depth, inner));
            frame below = {inner, 0, chain(&c->placed, &top->placed)};
            frames[depth++] = below;
        }
    }
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Stacks and views
// ---------------------------------------------------------------------------------------------

static sf_status find_stack(const sfi_threemf_reader *reader, sfi_threemf_name name,
                            uint32_t *number)
{
    const sfi_threemf_stack *stacks = reader->document->stacks.items;
    *number = SF_THREEMF_NONE;
    for (size_t i = 0; name.id != 0 && i < reader->document->stacks.count; i++) {
        if (compare(stacks[i].self, name) == 0) {
            *number = (uint32_t)i;
            return SF_OK;
        }
    }
    return name.id == 0
               ? SF_OK
               : sfi_fault_set(reader->fault, SF_ERR_FORMAT, 0, 0,
                               "%.80s has no stack of slices %lu; export the file again",
                               part_name(reader->document, name.part), (unsigned long)name.id);
}

// References lead to slices, never on to references, nor to nothing: what walks up a stack of them
// passes at most one of each layer's.
static sf_status resolve_refs(const sfi_threemf_reader *reader)
{
    sfi_threemf_ref *refs = reader->document->refs.items;
    const sfi_threemf_stack *stacks = reader->document->stacks.items;
    for (size_t i = 0; i < reader->document->refs.count; i++) {
        uint32_t number = 0;
        SF_TRY(find_stack(reader, refs[i].name, &number));
        if (stacks[number].slice_count == 0) {
            return sfi_fault_set(reader->fault, SF_ERR_FORMAT, 0, 0,
                                 stacks[number].ref_count > 0
                                     ? "a reference to slices leads to references; export the "
                                       "file again"
                                     : "a reference to slices leads to none; export the file "
                                       "again");
        }
        refs[i].stack = number;
    }
    return SF_OK;
}

static sf_status make_views(const sfi_threemf_reader *reader)
{
    sf_threemf *document = reader->document;
    for (size_t i = 0; i < document->objects.count; i++) {
        sfi_threemf_object *object = objects_of(document) + i;
        sf_threemf_object view;
        memset(&view, 0, sizeof view);
        object->number = (uint32_t)document->views.count;
        SF_TRY(find_stack(reader, object->stack, &view.stack));
        if (object->mesh != NULL) {
            view.name = object->name;
            view.kind = object->kind;
            view.is_rough = object->is_rough;
            view.mesh = sf_mesh_get_view(object->mesh);
            view.colours = object->has_colours ? object->colours.items : NULL;
            SF_TRY(sfi_list_push(&document->allocator, &document->views, &view));
        }
    }
    return SF_OK;
}

static sf_status build_all(const sfi_threemf_reader *reader, uint32_t *sorted)
{
    const sf_threemf *document = reader->document;
    const sfi_threemf_placing *builds = document->builds.items;
    SF_TRY(sort_objects(reader, sorted));
    SF_TRY(resolve_refs(reader));
    SF_TRY(make_views(reader));
    for (size_t i = 0; i < document->builds.count; i++) {
        SF_TRY(walk(reader, sorted, &builds[i]));
    }
    return document->items.count > 0
               ? SF_OK
               : sfi_fault_set(reader->fault, SF_ERR_FORMAT, 0, 0,
                               "the file builds nothing; check what was exported");
}

sf_status sfi_threemf_build(sfi_threemf_reader *reader)
{
    const sf_threemf *document = reader->document;
    size_t count = document->objects.count;
    if (count == 0) {
        return sfi_fault_set(reader->fault, SF_ERR_FORMAT, 0, 0,
                             "the file holds no objects; check what was exported");
    }
    uint32_t *sorted =
        count < UINT32_MAX ? sfi_alloc_array(&document->allocator, count, sizeof *sorted) : NULL;
    if (sorted == NULL) {
        return SF_ERR_MEMORY;
    }
    sf_status status = build_all(reader, sorted);
    sfi_free_array(&document->allocator, sorted, count, sizeof *sorted);
    return status;
}

#endif
