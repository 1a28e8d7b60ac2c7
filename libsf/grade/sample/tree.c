// SPDX-License-Identifier: MIT
// Trees of splines.
//
// Who goes through a solid row by row asks for the same few thousand splines over and over. A
// regular piece is one; an irregular one falls into ever smaller ones, of which those are made that
// somebody asks for. They are kept in one store of fixed size; when it is full everything goes, and
// what is still needed comes again. How much is in the store changes nothing but the time that it
// takes.

#include "grade/sample/tree.h"

#include "base/memory.h"
#include "base/status.h"
#include "grade/limit/descend.h"

#include <string.h>

enum { MOST_NODES = 1 << 16, LEAST_STORE = 1 << 22, DEPTH = 40 };

void sfi_tree_free(sfi_tree *tree)
{
    const sf_allocator *allocator = &tree->allocator;
    if (tree->chart != NULL) {
        sfi_free_array(allocator, tree->roots, tree->chart->pieces, sizeof *tree->roots);
    }
    sfi_free_array(allocator, tree->nodes, MOST_NODES, sizeof *tree->nodes);
    sfi_free_array(allocator, tree->store, tree->store_size, sizeof *tree->store);
    memset(tree, 0, sizeof *tree);
}

// The most numbers that one way down from a piece may take.
static size_t way_down(const sfi_chart *chart)
{
    return (DEPTH + 1) * (4 * (size_t)chart->atlas.most_points + sizeof(sfi_leaf) / sizeof(double));
}

static void forget(sfi_tree *tree)
{
    memset(tree->roots, 0xff, tree->chart->pieces * sizeof *tree->roots);
    tree->node_count = 0;
    tree->stored = 0;
}

sf_status sfi_tree_begin(const sfi_chart *chart, const sfi_tree_source sources[SFI_TREE_WIDTH],
                         double speck, const sf_allocator *allocator, sfi_tree *tree)
{
    memset(tree, 0, sizeof *tree);
    tree->allocator = *allocator;
    tree->chart = chart;
    tree->speck = speck;
    memcpy(tree->sources, sources, sizeof tree->sources);
    tree->roots = sfi_alloc_array(allocator, chart->pieces, sizeof *tree->roots);
    tree->nodes = sfi_alloc_array(allocator, MOST_NODES, sizeof *tree->nodes);
    tree->store_size = LEAST_STORE > 4 * way_down(chart) ? LEAST_STORE : 4 * way_down(chart);
    tree->store = sfi_alloc_array(allocator, tree->store_size, sizeof *tree->store);
    if (tree->roots == NULL || tree->nodes == NULL || tree->store == NULL) {
        sfi_tree_free(tree);
        return SF_ERR_MEMORY;
    }
    forget(tree);
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Making nodes
// ---------------------------------------------------------------------------------------------

// A node with `count` numbers in the store. There is room: sfi_tree_leaf() has seen to it.
static sfi_tree_node *add_node(sfi_tree *tree, uint32_t kind, size_t count)
{
    sfi_tree_node *node = &tree->nodes[tree->node_count++];
    node->kind = kind;
    node->at = tree->stored;
    memset(node->children, 0xff, sizeof node->children);
    tree->stored += count;
    return node;
}

static sfi_leaf *leaf_of(const sfi_tree *tree, const sfi_tree_node *node)
{
    return (sfi_leaf *)(void *)(tree->store + node->at);
}

static sfi_leaf *add_leaf(sfi_tree *tree, const double origin[3], double size)
{
    sfi_leaf *leaf = leaf_of(tree, add_node(tree, SFI_NONE, sizeof(sfi_leaf) / sizeof(double)));
    memcpy(leaf->origin, origin, sizeof leaf->origin);
    leaf->size = size;
    return leaf;
}

// Layers that a net has not follow from those next to them, as in sfi_spline_gather().
static void extend(const sfi_net *net, sfi_leaf *leaf)
{
    for (uint32_t side = 0; side < 6; side++) {
        uint32_t axis = side / 2, step = 1u << 2 * axis;
        for (uint32_t i = 0; (net->outside >> side & 1) && i < 64; i++) {
            if ((i >> 2 * axis & 3) == (side % 2 ? 3u : 0u)) {
                const uint32_t near = side % 2 ? i - step : i + step;
                const uint32_t far = side % 2 ? near - step : near + step;
                for (uint32_t c = 0; c < SFI_TREE_WIDTH; c++) {
                    leaf->rest[4 * i + c] = 2 * leaf->rest[4 * near + c] - leaf->rest[4 * far + c];
                }
            }
        }
    }
}

static void add_spline(sfi_tree *tree, const sfi_net *net, const double *values,
                       const double origin[3], double size)
{
    sfi_leaf *leaf = add_leaf(tree, origin, size);
    memcpy(leaf->base, values, sizeof leaf->base);
    for (uint32_t i = 0; i < 64; i++) {
        const double *from = values + 4 * (size_t)(net->at[i] != SFI_NONE ? net->at[i] : 0);
        for (uint32_t c = 0; c < SFI_TREE_WIDTH; c++) {
            leaf->rest[4 * i + c] = from[c] - leaf->base[c];
        }
    }
    extend(net, leaf);
}

// A part that is not cut any more: what lies linearly between its corners, as a spline, whose
// coefficients lie linearly too.
static void add_speck(sfi_tree *tree, const sfi_kind *kind, const double *values,
                      const double origin[3], double size)
{
    double corners[8][SFI_TREE_WIDTH];
    sfi_leaf *leaf = add_leaf(tree, origin, size);
    for (uint32_t place = 0; place < 8; place++) {
        const double *weights = kind->corners + (size_t)kind->ring.points * place;
        for (uint32_t c = 0; c < SFI_TREE_WIDTH; c++) {
            double base = values[4 * place + c], sum = 0;
            for (uint32_t i = 0; i < kind->ring.points; i++) {
                sum += weights[i] * (values[4 * (size_t)i + c] - base);
            }
            corners[place][c] = base + sum;
        }
    }
    memcpy(leaf->base, corners[0], sizeof leaf->base);
    for (uint32_t i = 0; i < 64; i++) {
        for (uint32_t c = 0; c < SFI_TREE_WIDTH; c++) {
            double sum = 0;
            for (uint32_t place = 1; place < 8; place++) {
                double weight = 1;
                for (uint32_t axis = 0; axis < 3; axis++) {
                    double x = (double)(i >> 2 * axis & 3) - 1;
                    weight *= place >> axis & 1 ? x : 1 - x;
                }
                sum += weight * (corners[place][c] - corners[0][c]);
            }
            leaf->rest[4 * i + c] = sum;
        }
    }
}

// How large the first cell of a ring is, by its corners.
static double extent(const double *values)
{
    double most = 0;
    for (uint32_t axis = 0; axis < 3; axis++) {
        double low = values[axis], high = values[axis];
        for (uint32_t place = 1; place < 8; place++) {
            double x = values[4 * place + axis];
            low = x < low ? x : low;
            high = x > high ? x : high;
        }
        most = high - low > most ? high - low : most;
    }
    return most;
}

// A node for a ring whose values lie at the end of the store, not yet counted.
static uint32_t add_ring(sfi_tree *tree, uint32_t kind, const double origin[3], double size,
                         uint32_t depth)
{
    const sfi_kind *k = &tree->chart->atlas.kinds[kind];
    double *values = tree->store + tree->stored;
    uint32_t number = tree->node_count;
    if (k->is_regular) {
        tree->stored += 4 * (size_t)k->ring.points; // the values stay where they are, unused
        add_spline(tree, &k->net, values, origin, size);
    } else if (depth == DEPTH || extent(values) <= tree->speck) {
        tree->stored += 4 * (size_t)k->ring.points;
        add_speck(tree, k, values, origin, size);
    } else {
        add_node(tree, kind, 4 * (size_t)k->ring.points);
    }
    return number;
}

static uint32_t add_root(sfi_tree *tree, uint32_t piece)
{
    static const double origin[3] = {0, 0, 0};
    const sfi_lists *points = &tree->chart->points;
    double *values = tree->store + tree->stored;
    uint32_t start = points->starts[piece], end = points->starts[piece + 1];
    for (uint32_t i = start; i < end; i++) {
        for (uint32_t c = 0; c < SFI_TREE_WIDTH; c++) {
            const sfi_tree_source *s = &tree->sources[c];
            *values++ = s->values == NULL ? 0 : s->values[s->stride * points->items[i]];
        }
    }
    return add_ring(tree, tree->chart->kinds[piece], origin, 1, 0);
}

// ---------------------------------------------------------------------------------------------
// Asking
// ---------------------------------------------------------------------------------------------

const sfi_leaf *sfi_tree_leaf(sfi_tree *tree, uint32_t piece, const double u[3])
{
    double origin[3] = {0, 0, 0}, size = 1;
    if (tree->node_count + DEPTH + 1 > MOST_NODES ||
        tree->stored + way_down(tree->chart) > tree->store_size) {
        forget(tree);
    }
    uint32_t *link = &tree->roots[piece];
    if (*link == SFI_NONE) {
        *link = add_root(tree, piece);
    }
    sfi_tree_node *node = &tree->nodes[*link];
    for (uint32_t depth = 1; node->kind != SFI_NONE; depth++) {
        const sfi_kind *kind = &tree->chart->atlas.kinds[node->kind];
        uint32_t place = 0;
        size /= 2;
        for (uint32_t axis = 0; axis < 3; axis++) {
            uint32_t high = u[axis] >= origin[axis] + size;
            place |= high << axis;
            origin[axis] += high ? size : 0;
        }
        if (node->children[place] == SFI_NONE) {
            sfi_matrix_apply(&kind->steps[place], SFI_TREE_WIDTH, tree->store + node->at,
                             tree->store + tree->stored, NULL);
            node->children[place] = add_ring(tree, kind->children[place], origin, size, depth);
        }
        node = &tree->nodes[node->children[place]];
    }
    return leaf_of(tree, node);
}

void sfi_tree_at(sfi_tree *tree, const sf_place *place, double value[SFI_TREE_WIDTH])
{
    double local[3];
    const sfi_leaf *leaf = sfi_tree_leaf(tree, place->piece, place->u);
    for (uint32_t axis = 0; axis < 3; axis++) {
        local[axis] = (place->u[axis] - leaf->origin[axis]) / leaf->size;
    }
    sfi_leaf_at(leaf, local, value, NULL);
}
