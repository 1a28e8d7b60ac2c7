// SPDX-License-Identifier: MIT
// How the surface of voxels comes apart at a corner of the lattice.
//
// The faces between solid and empty voxels around a lattice vertex form closed fans. Voxels that
// touch only along an edge or in a corner are taken for parted: solid octants belong together where
// they share a face, empty ones also where they share an edge. On the sphere around the vertex
// these regions are a map, each fan is the border between two of them, and no border is met twice:
// the regions with the fans between them are a tree. Where a vertex has several fans the surface
// would pinch, so each fan gets a copy of the vertex. A fan around a leaf of the tree moves towards
// the leaf: a corner of matter draws back into the matter, the tip of a hollow into the hollow, and
// the copies come apart without crossing. A fan between two regions that are no leaves stays.

#include "mesh/fans.h"

#include <string.h>

enum { OCTANTS = 8, NONE = 255 };

// Whether two octants of one kind (solid or empty) touch.
static int touch(unsigned a, unsigned b, int solid)
{
    unsigned differ = a ^ b, bits = (differ & 1) + (differ >> 1 & 1) + (differ >> 2);
    return bits == 1 || (bits == 2 && !solid);
}

// Number the region of each octant. A few rounds of taking the lowest number of a neighbour.
static void find_regions(unsigned arrangement, uint8_t region[OCTANTS])
{
    for (unsigned o = 0; o < OCTANTS; o++) {
        region[o] = (uint8_t)o;
    }
    for (int round = 0; round < OCTANTS; round++) {
        for (unsigned a = 0; a < OCTANTS; a++) {
            for (unsigned b = 0; b < OCTANTS; b++) {
                int solid = (int)(arrangement >> a & 1),
                    same = solid == (int)(arrangement >> b & 1);
                if (same && touch(a, b, solid) && region[b] < region[a]) {
                    region[a] = region[b];
                }
            }
        }
    }
}

// Signs of the sum of the directions of a region's octants.
static void point_to(const uint8_t region[OCTANTS], uint8_t which, int8_t shift[3])
{
    for (unsigned axis = 0; axis < 3; axis++) {
        int sum = 0;
        for (unsigned o = 0; o < OCTANTS; o++) {
            sum += region[o] == which ? ((o >> axis & 1) != 0 ? 1 : -1) : 0;
        }
        shift[axis] = (int8_t)((sum > 0) - (sum < 0));
    }
}

static void make_one(sfi_fans *fans, unsigned arrangement)
{
    uint8_t region[OCTANTS], borders[4][2], degree[OCTANTS] = {0}, count = 0;
    find_regions(arrangement, region);
    for (unsigned o = 0; o < OCTANTS; o++) {
        for (unsigned axis = 0; axis < 3; axis++) {
            unsigned across = o ^ 1u << axis;
            uint8_t *fan = &fans->fan[arrangement][3 * o + axis];
            *fan = NONE;
            if ((arrangement >> o & 1) == 0 || (arrangement >> across & 1) != 0) {
                continue;
            }
            for (*fan = 0; *fan < count; (*fan)++) {
                if (borders[*fan][0] == region[o] && borders[*fan][1] == region[across]) {
                    break;
                }
            }
            if (*fan == count) {
                borders[count][0] = region[o];
                borders[count++][1] = region[across];
                degree[region[o]]++;
                degree[region[across]]++;
            }
        }
    }
    fans->count[arrangement] = count;
    for (uint8_t f = 0; f < count && count > 1; f++) {
        for (int side = 0; side < 2; side++) {
            if (degree[borders[f][side]] == 1) {
                point_to(region, borders[f][side], fans->shift[arrangement][f]);
            }
        }
    }
}

void sfi_fans_make(sfi_fans *fans)
{
    memset(fans, 0, sizeof *fans);
    for (unsigned arrangement = 0; arrangement < 256; arrangement++) {
        make_one(fans, arrangement);
    }
}
