// SPDX-License-Identifier: MIT
// Properties of a mesh: what they must be like, and copies of them.
//
// Cages and meshes of tetrahedra carry the same channels, and files bring them from anywhere, so
// the checks are in one place. All of a channel is checked before any of it is copied.

#include "grade/channels.h"

#include "base/memory.h"
#include "base/status.h"

#include <math.h>
#include <string.h>

static sf_status refuse(sf_fault *fault, size_t channel, const char *what)
{
    return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "property %zu (counted from 0) %s", channel,
                         what);
}

// Bytes before the first 0; SF_PROPERTY_NAME_SIZE where there is none.
static size_t name_length(const char *name)
{
    size_t length = 0;
    while (length < SF_PROPERTY_NAME_SIZE && name[length] != 0) {
        length++;
    }
    return length;
}

static int same_name(const sf_property *a, const sf_property *b)
{
    size_t length = name_length(a->name);
    return length == name_length(b->name) && memcmp(a->name, b->name, length) == 0;
}

// Whether bytes are UTF-8 without control characters.
static int is_text(const char *name, size_t length)
{
    for (size_t i = 0; i < length;) {
        unsigned char lead = (unsigned char)name[i];
        size_t more = lead < 0x80 ? 0 : lead >= 0xf0 ? 3 : lead >= 0xe0 ? 2 : 1;
        if (lead < 0x20 || lead == 0x7f || (lead >= 0x80 && lead < 0xc2) || lead > 0xf4 ||
            more >= length - i) {
            return 0;
        }
        for (size_t j = 1; j <= more; j++) {
            if (((unsigned char)name[i + j] & 0xc0) != 0x80) {
                return 0;
            }
        }
        i += more + 1;
    }
    return 1;
}

sf_status sfi_property_check(const sf_property *property, size_t channel, sf_fault *fault)
{
    static const uint8_t none[sizeof property->uuid];
    size_t length = name_length(property->name);
    if (length == 0 || length == SF_PROPERTY_NAME_SIZE) {
        return refuse(fault, channel, "has no name, or one that does not end");
    }
    if (!is_text(property->name, length)) {
        return refuse(fault, channel, "has a name that is not UTF-8, or with control characters");
    }
    if (memcmp(property->uuid, none, sizeof none) == 0) {
        return refuse(fault, channel, "has no UUID: all its bytes are 0");
    }
    // Written so that no number at all is refused too.
    if (!(property->low <= property->high) || property->low == INFINITY ||
        property->high == -INFINITY) {
        return refuse(fault, channel, "has bounds that no value lies between");
    }
    return SF_OK;
}

int sfi_property_allows(const sf_property *property, double value)
{
    return isfinite(value) && value >= property->low && value <= property->high;
}

static sf_status check_values(const sf_channel *channel, size_t number, sf_fault *fault)
{
    for (size_t i = 0; i < channel->value_count; i++) {
        if (!sfi_property_allows(&channel->property, channel->values[i])) {
            return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                                 "value %zu of property %zu (\"%s\") is not finite or lies outside "
                                 "the property's bounds",
                                 i, number, channel->property.name);
        }
    }
    return SF_OK;
}

static sf_status check_indices(const sf_channel *channel, size_t number, sfi_channel_shape shape,
                               sf_fault *fault)
{
    if (channel->indices == NULL) {
        return channel->value_count == shape.point_count
                   ? SF_OK
                   : sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                                   "property %zu (\"%s\") has %zu values for %zu points; give one "
                                   "for each, or indices",
                                   number, channel->property.name, channel->value_count,
                                   shape.point_count);
    }
    for (size_t i = 0; i < shape.corner_count; i++) {
        if (channel->indices[i] >= channel->value_count) {
            return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                                 "corner %zu of property %zu (\"%s\") names value %lu of %zu", i,
                                 number, channel->property.name, (unsigned long)channel->indices[i],
                                 channel->value_count);
        }
    }
    return SF_OK;
}

static sf_status check_channel(const sfi_channels *channels, const sf_channel *channel,
                               sfi_channel_shape shape, sf_fault *fault)
{
    size_t number = channels->count;
    if (number == SF_PROPERTY_MAX) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "more than %d properties",
                             SF_PROPERTY_MAX);
    }
    SF_TRY(sfi_property_check(&channel->property, number, fault));
    for (size_t i = 0; i < number; i++) {
        const sf_property *other = &channels->at[i].property;
        if (memcmp(other->uuid, channel->property.uuid, sizeof other->uuid) == 0 ||
            same_name(other, &channel->property)) {
            return refuse(fault, number, "has the name or the UUID of another");
        }
    }
    if (channel->values == NULL || channel->value_count == 0 || channel->value_count > UINT32_MAX) {
        return refuse(fault, number, "has no values, or more than an index can name");
    }
    SF_TRY(check_indices(channel, number, shape, fault));
    return check_values(channel, number, fault);
}

sf_status sfi_channels_add(sfi_channels *channels, const sf_channel *channel,
                           sfi_channel_shape shape, const sf_allocator *allocator, sf_fault *fault)
{
    SF_TRY(check_channel(channels, channel, shape, fault));
    double *values = sfi_alloc_array(allocator, channel->value_count, sizeof *values);
    uint32_t *indices = channel->indices == NULL
                            ? NULL
                            : sfi_alloc_array(allocator, shape.corner_count, sizeof *indices);
    if (values == NULL || (indices == NULL && channel->indices != NULL)) {
        sfi_free_array(allocator, values, channel->value_count, sizeof *values);
        sfi_free_array(allocator, indices, shape.corner_count, sizeof *indices);
        return SF_ERR_MEMORY;
    }
    memcpy(values, channel->values, channel->value_count * sizeof *values);
    if (indices != NULL) {
        memcpy(indices, channel->indices, shape.corner_count * sizeof *indices);
    }
    sf_channel *copy = &channels->at[channels->count++];
    *copy = *channel;
    copy->values = values;
    copy->indices = indices;
    return SF_OK;
}

sf_status sfi_channels_copy(sfi_channels *channels, size_t count, const sf_channel *from,
                            sfi_channel_shape shape, const sf_allocator *allocator, sf_fault *fault)
{
    for (size_t i = 0; i < count; i++) {
        sf_status status = sfi_channels_add(channels, &from[i], shape, allocator, fault);
        if (status != SF_OK) {
            sfi_channels_clear(channels, shape, allocator);
            return status;
        }
    }
    return SF_OK;
}

static void free_channel(const sf_channel *channel, sfi_channel_shape shape,
                         const sf_allocator *allocator)
{
    sfi_free_array(allocator, (void *)channel->values, channel->value_count,
                   sizeof *channel->values);
    sfi_free_array(allocator, (void *)channel->indices, shape.corner_count,
                   sizeof *channel->indices);
}

void sfi_channels_remove(sfi_channels *channels, size_t index, sfi_channel_shape shape,
                         const sf_allocator *allocator)
{
    free_channel(&channels->at[index], shape, allocator);
    channels->count--;
    memmove(&channels->at[index], &channels->at[index + 1],
            (channels->count - index) * sizeof channels->at[0]);
}

void sfi_channels_clear(sfi_channels *channels, sfi_channel_shape shape,
                        const sf_allocator *allocator)
{
    for (size_t i = 0; i < channels->count; i++) {
        free_channel(&channels->at[i], shape, allocator);
    }
    channels->count = 0;
}

sf_status sfi_channel_set(sf_channel *channel, size_t first, size_t count, const double *values)
{
    if (values == NULL || first > channel->value_count || count > channel->value_count - first) {
        return SF_ERR_ARGUMENT;
    }
    for (size_t i = 0; i < count; i++) {
        if (!sfi_property_allows(&channel->property, values[i])) {
            return SF_ERR_ARGUMENT;
        }
    }
    memcpy((double *)channel->values + first, values, count * sizeof *values);
    return SF_OK;
}
