// SPDX-License-Identifier: MIT
// What the writer of 3MF files checks, and the model that it writes.

#ifndef SF_IO_THREEMF_MODEL_H
#define SF_IO_THREEMF_MODEL_H

#include "io/emitter.h"
#include "io/threemf.h"

// Numbers of resources: colours' groups, what fills an object, objects, each from where the one
// before ends.
typedef struct sfi_threemf_numbers {
    uint32_t groups, volume, objects;
} sfi_threemf_numbers;

// Whether all that is to be written can be; a fault where not.
sf_status sfi_threemf_check(const sf_threemf_view *what, const sf_threemf_extras *extras,
                            sf_fault *fault);

// How many of a volume's properties are fractions of materials.
size_t sfi_threemf_mixed(const sf_threemf_view *what, const sf_threemf_volume *volume);

// 3D/3dmodel.model.
void sfi_threemf_emit_model(const sf_threemf_view *what, const sf_threemf_extras *extras,
                            sfi_emitter *out);

// The path of a picture of a volume, with its first slash.
#define SFI_THREEMF_SHEET_SIZE 48
void sfi_threemf_sheet(size_t field, uint32_t layer, char path[SFI_THREEMF_SHEET_SIZE]);

#endif
