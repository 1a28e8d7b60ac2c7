// SPDX-License-Identifier: MIT
// Four splines of three parameters at once, with their derivatives.
//
// This is where slicing spends its time: once for each voxel. The four numbers of a point lie side
// by side, and every sum runs over a fixed number of them, so that a compiler can do two or four at
// a time. The last parameter goes first, for it leaves the least to do: of 64 points 16 values and
// 16 derivatives, of these 4 and twice 4, then the four numbers and their three derivatives.

#include "grade/sample/tree.h"

typedef struct weights {
    double value[4], slope[4];
} weights;

static weights weigh(double u)
{
    double v = 1 - u, uu = u * u, vv = v * v;
    weights w = {
        {vv * v / 6, (3 * uu * u - 6 * uu + 4) / 6, (3 * vv * v - 6 * vv + 4) / 6, uu * u / 6},
        {-vv / 2, (3 * uu - 4 * u) / 2, (4 * v - 3 * vv) / 2, uu / 2}};
    return w;
}

// Sums of four lines, `count` numbers each, one after the other.
#define SUM(to, from, count, w)                                                                    \
    for (int i = 0; i < (count); i++) {                                                            \
        (to)[i] = (w)[0] * (from)[i] + (w)[1] * (from)[(count) + i] +                              \
                  (w)[2] * (from)[2 * (count) + i] + (w)[3] * (from)[3 * (count) + i];             \
    }

void sfi_leaf_at(const sfi_leaf *leaf, const double u[3], double value[SFI_TREE_WIDTH],
                 double derivatives[3 * SFI_TREE_WIDTH])
{
    weights x = weigh(u[0]), y = weigh(u[1]), z = weigh(u[2]);
    double plane[64], line[16], last[4];
    SUM(plane, leaf->rest, 64, z.value)
    SUM(line, plane, 16, y.value)
    SUM(last, line, 4, x.value)
    for (int c = 0; c < SFI_TREE_WIDTH; c++) {
        value[c] = leaf->base[c] + last[c];
    }
    if (derivatives == NULL) {
        return;
    }
    SUM(derivatives, line, 4, x.slope)
    SUM(line, plane, 16, y.slope)
    SUM((derivatives + 4), line, 4, x.value)
    SUM(plane, leaf->rest, 64, z.slope)
    SUM(line, plane, 16, y.value)
    SUM((derivatives + 8), line, 4, x.value)
}
