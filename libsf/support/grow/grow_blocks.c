// SPDX-License-Identifier: MIT
// Blocks: where paths of equal cost had better go, so that they meet.
//
// High above a flat bed all ways down cost the same, and pillars that each go straight never meet.
// So space is divided into squares of 3, 9, 27, ... voxels, one within the other, and each voxel
// that needs a supporter is drawn to the middle of the smallest square in which it is not alone,
// provided it can get there before it lands. Voxels of one square of 3 share a supporter at once;
// the nine of a square of 9 that are left meet within three layers, those of 27 within nine, and so
// on: in all a third, a ninth, ... of the ceiling's voxels, instead of a ninth of them in each
// layer down to the bed. A voxel that is alone everywhere in reach goes straight down.

#include "base/memory.h"
#include "base/status.h"
#include "support/grow/grow_cover.h"

#define BLOCK 3u

sf_status sfi_blocks_create(sfi_blocks *b, uint32_t width, uint32_t height,
                            const sf_allocator *allocator)
{
    uint32_t size = BLOCK;
    *b = (sfi_blocks){.width = width, .height = height};
    while (b->levels < SFI_BLOCK_LEVELS) {
        // Level by level a ninth of the voxels, rounded up: no more than those of the slice.
        uint32_t columns = (width + size - 1) / size, rows = (height + size - 1) / size;
        b->first[b->levels++] = b->places;
        b->places += (size_t)columns * rows;
        if (columns == 1 && rows == 1) {
            break;
        }
        size *= BLOCK;
    }
    b->count = sfi_alloc_array(allocator, b->places, sizeof *b->count);
    for (size_t i = 0; b->count != NULL && i < b->places; i++) {
        b->count[i] = 0;
    }
    return b->count != NULL ? SF_OK : SF_ERR_MEMORY;
}

void sfi_blocks_destroy(sfi_blocks *b, const sf_allocator *allocator)
{
    sfi_free_array(allocator, b->count, b->places, sizeof *b->count);
    b->count = NULL;
}

static uint32_t *block_of(const sfi_blocks *b, uint32_t level, uint32_t size, uint32_t v)
{
    uint32_t columns = (b->width + size - 1) / size;
    uint32_t x = v % b->width / size, y = v / b->width / size;
    return b->count + b->first[level] + (size_t)y * columns + x;
}

void sfi_blocks_add(sfi_blocks *b, uint32_t v, uint32_t add)
{
    uint32_t size = BLOCK;
    for (uint32_t level = 0; level < b->levels; level++, size *= BLOCK) {
        *block_of(b, level, size, v) += add;
    }
}

static uint32_t distance(uint32_t a, uint32_t b)
{
    return a > b ? a - b : b - a;
}

uint32_t sfi_blocks_goal(const sfi_blocks *b, uint32_t v, uint32_t steps)
{
    uint32_t size = BLOCK, x = v % b->width, y = v / b->width;
    for (uint32_t level = 0; level < b->levels; level++, size *= BLOCK) {
        if (*block_of(b, level, size, v) < 2) {
            continue;
        }
        uint32_t goal_x = x / size * size + size / 2, goal_y = y / size * size + size / 2;
        goal_x = goal_x < b->width ? goal_x : b->width - 1;
        goal_y = goal_y < b->height ? goal_y : b->height - 1;
        int is_near = distance(x, goal_x) <= steps && distance(y, goal_y) <= steps;
        return is_near ? goal_y * b->width + goal_x : v;
    }
    return v;
}
