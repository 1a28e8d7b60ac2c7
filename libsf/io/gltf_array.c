// SPDX-License-Identifier: MIT
// Accessors: numbers in the buffers of a glTF file.
//
// An accessor says where a list of elements lies: an offset into a view of a buffer, a distance
// from element to element, the kind of number and how many make an element. It may be sparse: some
// elements stand in a list of their own, with a list of their places. Every one of these numbers
// comes from the file, so all are held against the buffers' sizes once, without a sum that could
// overflow, and reading goes unchecked afterwards.

#include "io/gltf_model.h"

#include "base/size.h"
#include "base/status.h"

#include <string.h>

static size_t size_of(int component)
{
    switch (component) {
    case SFI_GLTF_BYTE:
    case SFI_GLTF_UBYTE:
        return 1;
    case SFI_GLTF_SHORT:
    case SFI_GLTF_USHORT:
        return 2;
    case SFI_GLTF_UINT:
    case SFI_GLTF_FLOAT:
        return 4;
    default:
        return 0;
    }
}

// Where `count` elements of `size` bytes begin, if all lie within the view; else NULL.
static const unsigned char *place(const sfi_gltf_model *model, int view, size_t offset,
                                  size_t count, size_t size, size_t *stride)
{
    size_t last, end;
    if (view < 0 || (size_t)view >= model->view_count) {
        return NULL;
    }
    const sfi_gltf_view *v = &model->views[view];
    if (v->buffer < 0 || (size_t)v->buffer >= model->buffer_count) {
        return NULL;
    }
    const sfi_gltf_buffer *b = &model->buffers[v->buffer];
    *stride = v->stride != 0 ? v->stride : size;
    if (count == 0 || *stride < size || v->offset > b->size || v->size > b->size - v->offset ||
        !sfi_size_mul(count - 1, *stride, &last) || !sfi_size_add(last, size, &end) ||
        !sfi_size_add(end, offset, &end) || end > v->size) {
        return NULL;
    }
    return b->bytes + v->offset + offset;
}

static uint32_t bits_at(const unsigned char *bytes, size_t size)
{
    uint32_t bits = 0;
    for (size_t i = size; i > 0; i--) {
        bits = bits << 8 | bytes[i - 1];
    }
    return bits;
}

static sf_status outside(sf_fault *fault, const char *what)
{
    return sfi_fault_set(fault, SF_ERR_FORMAT, 0, 0,
                         "the %s of a mesh do not lie within the file's buffers; the file is "
                         "damaged or cut short: export it again",
                         what);
}

// The places of sparse elements must grow, and stay below the count.
static int are_in_order(const sfi_gltf_array *a)
{
    size_t size = size_of(a->at_component);
    uint32_t before = 0;
    for (size_t i = 0; i < a->sparse_count; i++) {
        uint32_t at = bits_at(a->at + i * size, size);
        if (at >= a->count || (i > 0 && at <= before)) {
            return 0;
        }
        before = at;
    }
    return 1;
}

static sf_status take_sparse(const sfi_gltf_model *model, const sfi_gltf_accessor *from,
                             size_t size, const char *what, sfi_gltf_array *a, sf_fault *fault)
{
    size_t at_stride, stride;
    int kind = from->at_component;
    if (kind != SFI_GLTF_UBYTE && kind != SFI_GLTF_USHORT && kind != SFI_GLTF_UINT) {
        return outside(fault, what);
    }
    a->at_component = kind;
    a->sparse_count = from->sparse_count;
    a->at =
        place(model, from->at_view, from->at_offset, from->sparse_count, size_of(kind), &at_stride);
    a->values =
        place(model, from->value_view, from->value_offset, from->sparse_count, size, &stride);
    if (a->at == NULL || a->values == NULL || at_stride != size_of(kind) || stride != size ||
        !are_in_order(a)) {
        return outside(fault, what);
    }
    return SF_OK;
}

sf_status sfi_gltf_array_of(const sfi_gltf_model *model, int accessor, const char *what,
                            sfi_gltf_array *array, sf_fault *fault)
{
    memset(array, 0, sizeof *array);
    if (accessor < 0 || (size_t)accessor >= model->accessor_count) {
        return outside(fault, what);
    }
    const sfi_gltf_accessor *from = &model->accessors[accessor];
    size_t size = size_of(from->component) * (size_t)from->width;
    if (size == 0 || from->count == 0) {
        return outside(fault, what);
    }
    array->component = from->component;
    array->width = from->width;
    array->is_normalized = from->is_normalized;
    array->count = from->count;
    if (from->view >= 0 || !from->is_sparse) {
        array->bytes = place(model, from->view, from->offset, from->count, size, &array->stride);
        if (array->bytes == NULL) {
            return outside(fault, what);
        }
    } else if (from->count > UINT32_MAX || from->count / 1024 > from->sparse_count) {
        // Zeros that nothing stands behind: a number in the file alone must not cost memory.
        return sfi_fault_set(fault, SF_ERR_FORMAT, 0, 0,
                             "the %s of a mesh are %zu elements, of which the file holds %zu; "
                             "export it again",
                             what, from->count, from->sparse_count);
    }
    return from->is_sparse ? take_sparse(model, from, size, what, array, fault) : SF_OK;
}

// Whole numbers that stand for fractions go to [-1, 1] or [0, 1].
static double number_of(uint32_t bits, int component, int is_normalized)
{
    float single;
    double value, most;
    switch (component) {
    case SFI_GLTF_FLOAT:
        memcpy(&single, &bits, sizeof single);
        return (double)single;
    case SFI_GLTF_BYTE:
        value = (double)bits - (bits >= 128 ? 256.0 : 0.0), most = 127;
        break;
    case SFI_GLTF_SHORT:
        value = (double)bits - (bits >= 32768 ? 65536.0 : 0.0), most = 32767;
        break;
    case SFI_GLTF_UBYTE:
        value = (double)bits, most = 255;
        break;
    default:
        value = (double)bits, most = 65535;
        break;
    }
    if (!is_normalized) {
        return value;
    }
    return value / most < -1 ? -1 : value / most;
}

void sfi_gltf_numbers(const sfi_gltf_array *array, size_t element, size_t *next_sparse,
                      double number[4])
{
    size_t size = size_of(array->component), at_size = size_of(array->at_component);
    const unsigned char *from = NULL;
    if (array->bytes != NULL) {
        from = array->bytes + element * array->stride;
    }
    if (*next_sparse < array->sparse_count &&
        bits_at(array->at + *next_sparse * at_size, at_size) == element) {
        from = array->values + *next_sparse * size * (size_t)array->width;
        (*next_sparse)++;
    }
    for (int i = 0; i < array->width; i++) {
        number[i] = from == NULL ? 0
                                 : number_of(bits_at(from + (size_t)i * size, size),
                                             array->component, array->is_normalized);
    }
}

uint32_t sfi_gltf_whole(const sfi_gltf_array *array, size_t element)
{
    return bits_at(array->bytes + element * array->stride, size_of(array->component));
}
