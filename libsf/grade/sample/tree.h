// SPDX-License-Identifier: MIT
// Splines of the pieces of a limit, and of what irregular pieces fall into, kept for those who come
// back soon.

#ifndef SF_GRADE_SAMPLE_TREE_H
#define SF_GRADE_SAMPLE_TREE_H

#include "grade/limit/limit.h"

enum { SFI_TREE_WIDTH = 4 };

// One spline of four numbers at each of its 4 x 4 x 4 points, less those of `base`, over a part of
// a piece: from `origin` on, `size` long along each axis.
typedef struct sfi_leaf {
    double origin[3], size;
    double base[SFI_TREE_WIDTH];
    double rest[64 * SFI_TREE_WIDTH];
} sfi_leaf;

typedef struct sfi_tree_node {
    uint32_t kind;        // of its ring; SFI_NONE: it is a leaf
    uint32_t children[8]; // SFI_NONE where nobody has been
    size_t at;            // its ring's values, or its leaf, in the store
} sfi_tree_node;

// What the four numbers are: of each where it lies among the values of points, and how far those
// are apart. NULL: 0.
typedef struct sfi_tree_source {
    const double *values;
    size_t stride;
} sfi_tree_source;

// Trees of pieces. What they hold is thrown away when the store is full.
typedef struct sfi_tree {
    sf_allocator allocator;
    const sfi_chart *chart;
    sfi_tree_source sources[SFI_TREE_WIDTH];
    double speck;    // a part that small, in mm, is not cut any more
    uint32_t *roots; // of each piece its first node
    sfi_tree_node *nodes;
    uint32_t node_count;
    double *store;
    size_t store_size, stored;
} sfi_tree;

// Trees of a chart's pieces. SF_ERR_MEMORY.
sf_status sfi_tree_begin(const sfi_chart *chart, const sfi_tree_source sources[SFI_TREE_WIDTH],
                         double speck, const sf_allocator *allocator, sfi_tree *tree);
void sfi_tree_free(sfi_tree *tree);

// The leaf of a piece that holds u, valid until the next call.
const sfi_leaf *sfi_tree_leaf(sfi_tree *tree, uint32_t piece, const double u[3]);

// The four numbers at a place.
void sfi_tree_at(sfi_tree *tree, const sf_place *place, double value[SFI_TREE_WIDTH]);

// The four numbers of a leaf at u, in its own parameters, from 0 to 1, and, unless NULL, their
// derivatives by those: four by the first, four by the second, four by the third.
void sfi_leaf_at(const sfi_leaf *leaf, const double u[3], double value[SFI_TREE_WIDTH],
                 double derivatives[3 * SFI_TREE_WIDTH]);

#endif
