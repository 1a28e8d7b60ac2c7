// SPDX-License-Identifier: MIT
// From words of each material to what the caller asked for.

#ifndef SF_GRADE_TONE_EMIT_H
#define SF_GRADE_TONE_EMIT_H

#include "grade/tone/tones.h"

// Write words i to i + count of row y: at most a stretch. words[j] are those of material j, of
// which no two have a bit in common and none has one past the width; keep-outs change them here.
// The voxels of each are added to counts.
void sfi_emit(const sf_tones *tones, const sf_materials *materials, uint32_t material_count,
              uint32_t y, size_t i, size_t count, uint64_t words[][SFI_STRETCH_WORDS],
              uint64_t *counts);

#endif
