// SPDX-License-Identifier: MIT
// A stack in: stack.json, then its pictures into a grid.
//
// The document says how large the grid is, and a few bytes can say a lot: so before memory is taken
// for the grid, every picture that the document claims must be there and have the claimed size.

#include "io/stack.h"

#include "base/memory.h"
#include "base/status.h"

#include <string.h>

#ifdef SF_HAVE_JANSSON

#include <jansson.h>

// Largest stack.json that is read: room for the heights of some million layers.
#define DOCUMENT_MAX ((size_t)64 << 20)

// What stack.json says. heights are the reader's own.
typedef struct stack_document {
    uint32_t version;
    sf_lattice lattice;
    double *heights;
    sf_stack_info info;
    sfi_picture_kind kind;
} stack_document;

static sf_status document_fault(sf_fault *fault, sf_status status, const char *sentence)
{
    return sfi_fault_set(fault, status, 0, 0, SFI_STACK_DOCUMENT ": %s", sentence);
}

// --- values out of the document ------------------------------------------------------------------

static int get_number(const json_t *object, const char *key, double *value)
{
    const json_t *found = json_object_get(object, key);
    *value = json_number_value(found);
    return json_is_number(found);
}

static int get_count(const json_t *object, const char *key, uint32_t most, uint32_t *value)
{
    const json_t *found = json_object_get(object, key);
    json_int_t number = json_integer_value(found);
    if (!json_is_integer(found) || number < 0 || number > most) {
        return 0;
    }
    *value = (uint32_t)number;
    return 1;
}

static int get_numbers(const json_t *object, const char *key, double *values, size_t count)
{
    const json_t *found = json_object_get(object, key);
    if (!json_is_array(found) || json_array_size(found) != count) {
        return 0;
    }
    for (size_t i = 0; i < count; i++) {
        const json_t *item = json_array_get(found, i);
        values[i] = json_number_value(item);
        if (!json_is_number(item)) {
            return 0;
        }
    }
    return 1;
}

static int is_text(const json_t *object, const char *key, const char *text)
{
    const char *found = json_string_value(json_object_get(object, key));
    return found != NULL && strcmp(found, text) == 0;
}

static sf_status read_lattice(const json_t *root, const sf_allocator *allocator,
                              stack_document *document, sf_fault *fault)
{
    const json_t *object = json_object_get(root, "lattice");
    sf_lattice *lattice = &document->lattice;
    double pitch[2];
    if (!get_count(object, "nx", SF_EXTENT_MAX, &lattice->nx) ||
        !get_count(object, "ny", SF_EXTENT_MAX, &lattice->ny) ||
        !get_count(object, "nz", SF_LAYER_MAX, &lattice->nz) ||
        !get_numbers(object, "pitch_mm", pitch, 2) ||
        !get_numbers(object, "origin_mm", lattice->origin_mm, 3)) {
        return document_fault(fault, SF_ERR_FORMAT,
                              "lattice needs nx, ny, nz, pitch_mm [x, y] and origin_mm [x, y, z]");
    }
    lattice->pitch_x_mm = pitch[0];
    lattice->pitch_y_mm = pitch[1];
    const json_t *heights = json_object_get(object, "heights_mm");
    if (heights != NULL && json_array_size(heights) == lattice->nz && lattice->nz > 0) {
        document->heights = sfi_alloc_array(allocator, lattice->nz, sizeof(double));
        if (document->heights == NULL) {
            return SF_ERR_MEMORY;
        }
        lattice->heights_mm = document->heights;
    }
    int good = heights != NULL
                   ? document->heights != NULL &&
                         get_numbers(object, "heights_mm", document->heights, lattice->nz)
                   : get_number(object, "layer_mm", &lattice->layer_mm);
    if (!good || sf_lattice_validate(lattice) != SF_OK) {
        return document_fault(
            fault, SF_ERR_FORMAT,
            "lattice needs layer_mm or nz numbers in heights_mm, and sizes above 0");
    }
    return SF_OK;
}

static sf_status read_bridge(const json_t *rule, stack_document *document, sf_fault *fault)
{
    sf_stack_info *info = &document->info;
    double bridge[2] = {0.0, 0.0};
    const json_t *found = json_object_get(rule, "bridge_mm");
    if (found != NULL && !(get_numbers(rule, "bridge_mm", bridge, 2) && bridge[0] > 0 &&
                           bridge[0] <= SFI_STACK_BRIDGE_MAX && bridge[1] >= 0 &&
                           bridge[1] <= SFI_STACK_BRIDGE_MAX)) {
        return document_fault(fault, SF_ERR_FORMAT,
                              "bridge_mm of the rule is two lengths, a span above 0 and an anchor");
    }
    if (found != NULL && document->version < SFI_STACK_VERSION_BRIDGED) {
        return document_fault(fault, SF_ERR_FORMAT, "a rule with bridge_mm needs version 2");
    }
    info->bridge_span_mm = bridge[0];
    info->bridge_anchor_mm = bridge[1];
    return SF_OK;
}

static sf_status read_rule(const json_t *root, stack_document *document, sf_fault *fault)
{
    const json_t *object = json_object_get(root, "rule");
    sf_stack_info *info = &document->info;
    if (object == NULL || json_is_null(object)) {
        return SF_OK;
    }
    uint32_t phase;
    const char *kind = json_string_value(json_object_get(object, "kind"));
    if (sf_rule_kind_from_name(kind, &info->rule) != SF_OK) {
        return document_fault(fault, SF_ERR_UNSUPPORTED, "rule is none that this version knows");
    }
    int angle = info->rule == SF_RULE_BOX3 || (get_number(object, "angle_rad", &info->angle_rad) &&
                                               info->angle_rad >= SF_RULE_ANGLE_MIN_RAD &&
                                               info->angle_rad <= SF_RULE_ANGLE_MAX_RAD);
    int bed = json_is_null(json_object_get(object, "bed_layer"));
    info->bed_layer = SF_BED_AUTO;
    if (!angle ||
        !(bed || get_count(object, "bed_layer", document->lattice.nz - 1, &info->bed_layer))) {
        return document_fault(
            fault, SF_ERR_FORMAT,
            "rule needs angle_rad from 5 to 85 degrees and a bed_layer of the stack");
    }
    // Where the steps of an octagon begin; absent, it is where they always began.
    if (json_object_get(object, "phase_layer") != NULL &&
        !get_count(object, "phase_layer", 0, &phase)) {
        return document_fault(fault, SF_ERR_UNSUPPORTED,
                              "the rule's phase_layer is not 0; a newer libsf wrote this stack");
    }
    SF_TRY(read_bridge(object, document, fault));
    info->has_rule = 1;
    return SF_OK;
}

static sf_status read_layers(const json_t *root, stack_document *document, sf_fault *fault)
{
    const json_t *object = json_object_get(root, "layers");
    uint32_t count;
    if (is_text(object, "pattern", SFI_STACK_PATTERN_PNG)) {
        document->kind = SFI_PICTURE_PNG;
    } else if (is_text(object, "pattern", SFI_STACK_PATTERN_PBM)) {
        document->kind = SFI_PICTURE_PBM;
    } else {
        return document_fault(fault, SF_ERR_UNSUPPORTED,
                              "layers.pattern must be " SFI_STACK_PATTERN_PNG
                              " or " SFI_STACK_PATTERN_PBM);
    }
    if (!get_count(object, "count", SF_LAYER_MAX, &count) || count != document->lattice.nz) {
        return document_fault(fault, SF_ERR_FORMAT, "layers.count is not nz of the lattice");
    }
    return SF_OK;
}

static sf_status read_root(const json_t *root, const sf_allocator *allocator,
                           stack_document *document, sf_fault *fault)
{
    uint32_t version;
    if (!is_text(root, "format", SFI_STACK_FORMAT)) {
        return document_fault(fault, SF_ERR_FORMAT, "format is not " SFI_STACK_FORMAT);
    }
    if (!get_count(root, "version", UINT32_MAX, &version) || version < SFI_STACK_VERSION ||
        version > SFI_STACK_VERSION_MATERIALS) {
        return document_fault(fault, SF_ERR_UNSUPPORTED,
                              "the version is none of 1 to 3; a newer libsf wrote this stack");
    }
    const char *solid = version == SFI_STACK_VERSION_MATERIALS ? "not 0" : "white";
    if (!is_text(root, "units", "mm") || !is_text(root, "solid", solid) ||
        !is_text(root, "row_order", "top_is_max_y")) {
        return document_fault(fault, SF_ERR_UNSUPPORTED,
                              "units must be mm, solid white (not 0 with materials), and row_order "
                              "top_is_max_y");
    }
    document->version = version;
    SF_TRY(read_lattice(root, allocator, document, fault));
    SF_TRY(read_rule(root, document, fault));
    SF_TRY(read_layers(root, document, fault));
    if (version == SFI_STACK_VERSION_MATERIALS && document->kind == SFI_PICTURE_PBM) {
        return document_fault(fault, SF_ERR_FORMAT, "PBM has no palette to name materials by");
    }
    document->kind = version == SFI_STACK_VERSION_MATERIALS ? SFI_PICTURE_IDS : document->kind;
    return SF_OK;
}

// --- the document itself -------------------------------------------------------------------------

typedef struct text {
    void *bytes;
    size_t size, capacity;
} text;

static sf_status read_text(sf_source source, const sf_allocator *allocator, text *all,
                           sf_fault *fault)
{
    for (size_t got = 1; got > 0; all->size += got) {
        if (!sfi_grow_array(allocator, &all->bytes, &all->capacity, all->size + 4096, 1)) {
            return SF_ERR_MEMORY;
        }
        sf_status status = source.read(source.user, (char *)all->bytes + all->size, 4096, &got);
        status = status == SF_OK && got > 4096 ? SF_ERR_IO : status; // a broken promise
        if (status != SF_OK) {
            return document_fault(fault, status, "reading failed");
        }
        if (all->size + got > DOCUMENT_MAX) {
            return document_fault(fault, SF_ERR_OVERFLOW, "it is larger than 64 MiB");
        }
    }
    return SF_OK;
}

static sf_status parse_text(const text *all, const sf_allocator *allocator,
                            stack_document *document, sf_fault *fault)
{
    json_error_t error;
    json_t *root = json_loadb(all->bytes, all->size, JSON_REJECT_DUPLICATES, &error);
    if (root == NULL) {
        uint32_t line = error.line > 0 ? (uint32_t)error.line : 0;
        uint64_t offset = error.position > 0 ? (uint64_t)error.position : 0;
        return sfi_fault_set(fault, SF_ERR_FORMAT, line, offset,
                             SFI_STACK_DOCUMENT " is no JSON: %s; write the stack again",
                             error.text);
    }
    sf_status status = read_root(root, allocator, document, fault);
    json_decref(root);
    return status;
}

static sf_status read_document(const sf_folder *folder, const sf_allocator *allocator,
                               stack_document *document, sf_fault *fault)
{
    sf_source source;
    text all = {NULL, 0, 0};
    sf_status status = folder->open(folder->user, SFI_STACK_DOCUMENT, &source);
    if (status != SF_OK) {
        return document_fault(fault, status,
                              "it cannot be opened; a stack is a folder that holds it");
    }
    status = read_text(source, allocator, &all, fault);
    folder->close(folder->user, source);
    if (status == SF_OK) {
        status = parse_text(&all, allocator, document, fault);
    }
    sfi_free_array(allocator, all.bytes, all.capacity, 1);
    return status;
}

// --- the pictures --------------------------------------------------------------------------------

static sf_status read_layer(const sf_folder *folder, const sf_allocator *allocator,
                            sfi_picture_kind kind, uint32_t k, sf_slice slice, int check_only,
                            sf_fault *fault)
{
    char name[SFI_STACK_NAME_SIZE];
    sf_source source;
    sfi_stack_layer_name(kind, k, name);
    sf_status status = folder->open(folder->user, name, &source);
    if (status != SF_OK) {
        return sfi_picture_fault(fault, status, name, "it cannot be opened; write the stack again");
    }
    status = sfi_picture_read(kind, source, allocator, name, slice, check_only, fault);
    folder->close(folder->user, source);
    return status;
}

// All layers, looked at (grid NULL) or read.
static sf_status for_layers(const sf_folder *folder, const sf_allocator *allocator,
                            const stack_document *document, sf_grid *grid, sf_task *task,
                            sf_fault *fault)
{
    for (uint32_t k = 0; k < document->lattice.nz; k++) {
        sf_slice slice = {NULL, document->lattice.nx, document->lattice.ny, 0};
        if (grid != NULL) {
            slice = sf_grid_slice(grid, k);
        }
        if (sf_task_is_cancelled(task)) {
            return sfi_fault_set(fault, SF_ERR_CANCELLED, 0, 0, "reading the stack was cancelled");
        }
        SF_TRY(read_layer(folder, allocator, document->kind, k, slice, grid == NULL, fault));
        sfi_stack_progress(grid != NULL ? task : NULL, k + 1, document->lattice.nz);
    }
    return SF_OK;
}

static sf_status read_grid(const sf_folder *folder, const sf_allocator *allocator,
                           const stack_document *document, sf_task *task, sf_grid **grid,
                           sf_fault *fault)
{
    SF_TRY(for_layers(folder, allocator, document, NULL, task, fault));
    sf_status status = sf_grid_create(&document->lattice, allocator, grid);
    if (status == SF_ERR_OVERFLOW) {
        return document_fault(fault, status, "the stack is larger than this machine can address");
    }
    SF_TRY(status);
    return for_layers(folder, allocator, document, *grid, task, fault);
}

sf_status sf_stack_read(sf_folder folder, const sf_allocator *allocator, sf_task *task,
                        sf_grid **grid, sf_stack_info *info, sf_fault *fault)
{
    if (folder.open == NULL || folder.close == NULL || grid == NULL) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "no folder, or no place for the grid");
    }
    sf_allocator from = sfi_allocator_or_default(allocator);
    stack_document document;
    sf_grid *made = NULL;
    memset(&document, 0, sizeof document);
    document.lattice.heights_mm = NULL;
    sf_status status = read_document(&folder, &from, &document, fault);
    if (status == SF_OK) {
        status = read_grid(&folder, &from, &document, task, &made, fault);
    }
    sfi_free_array(&from, document.heights, document.lattice.nz, sizeof(double));
    if (status != SF_OK) {
        sf_grid_destroy(made);
        return status == SF_ERR_MEMORY
                   ? sfi_fault_set(fault, status, 0, 0, "there is not enough memory for this stack")
                   : status;
    }
    *grid = made;
    if (info != NULL) {
        *info = document.info;
    }
    return SF_OK;
}

#else

sf_status sf_stack_read(sf_folder folder, const sf_allocator *allocator, sf_task *task,
                        sf_grid **grid, sf_stack_info *info, sf_fault *fault)
{
    (void)allocator;
    (void)task;
    (void)info;
    if (folder.open == NULL || folder.close == NULL || grid == NULL) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "no folder, or no place for the grid");
    }
    return sfi_fault_set(fault, SF_ERR_UNSUPPORTED, 0, 0,
                         "this build cannot read " SFI_STACK_DOCUMENT
                         ", so no stacks; build it with jansson");
}

#endif
