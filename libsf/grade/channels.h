// SPDX-License-Identifier: MIT
// The properties of one mesh, with arrays of their own.

#ifndef SF_GRADE_CHANNELS_H
#define SF_GRADE_CHANNELS_H

#include <sf/property.h>

// What the channels of a mesh are held against.
typedef struct sfi_channel_shape {
    size_t point_count;  // points of the mesh
    size_t corner_count; // corners of all its cells
} sfi_channel_shape;

// Channels that own their values and indices. All 0: none.
typedef struct sfi_channels {
    size_t count;
    sf_channel at[SF_PROPERTY_MAX]; // values and indices are blocks of the owner's allocator
} sfi_channels;

// Check what a property says of itself. `channel` is its number, for the sentence.
sf_status sfi_property_check(const sf_property *property, size_t channel, sf_fault *fault);

// Whether a value is finite and within its property's bounds.
int sfi_property_allows(const sf_property *property, double value);

// Copy one more channel to the end, once it has been checked, also against those that are there.
// Fails with SF_ERR_ARGUMENT, SF_ERR_OVERFLOW or SF_ERR_MEMORY, and nothing has changed.
sf_status sfi_channels_add(sfi_channels *channels, const sf_channel *channel,
                           sfi_channel_shape shape, const sf_allocator *allocator, sf_fault *fault);

// Copy `count` channels into channels that hold none; on failure they hold none again.
sf_status sfi_channels_copy(sfi_channels *channels, size_t count, const sf_channel *from,
                            sfi_channel_shape shape, const sf_allocator *allocator,
                            sf_fault *fault);

// Free channel `index`; those after it move up by one.
void sfi_channels_remove(sfi_channels *channels, size_t index, sfi_channel_shape shape,
                         const sf_allocator *allocator);

// Free them all.
void sfi_channels_clear(sfi_channels *channels, sfi_channel_shape shape,
                        const sf_allocator *allocator);

// Change `count` values of a channel from `first` on. SF_ERR_ARGUMENT: values that there are not,
// or that the property does not allow; nothing has changed.
sf_status sfi_channel_set(sf_channel *channel, size_t first, size_t count, const double *values);

#endif
