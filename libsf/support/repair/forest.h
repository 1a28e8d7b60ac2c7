// SPDX-License-Identifier: MIT
// The forest of supporters: its nodes, and the greedy choice of one layer's supporters.

#ifndef SF_SUPPORT_FOREST_H
#define SF_SUPPORT_FOREST_H

#include "support/repair/repair.h"

// Where a node's `next` leads: nowhere, to what needs no more, or to node next - SFI_NEXT_NODE of
// the layer below.
#define SFI_NEXT_NONE 0u
#define SFI_NEXT_ROOT 1u
#define SFI_NEXT_NODE 2u
// Set in `next` where the node is wanted, if what it rests on is there.
#define SFI_NEXT_WANTED 0x80000000u

// A node while its layer is worked on.
typedef struct sfi_node {
    int64_t profit; // what having it, and all that then pays, saves; negative: costs
    uint32_t at;    // place in a plane
    uint32_t next;
    int16_t least;  // least price that it can rest on; SFI_PRICE_NONE: not known yet
    uint8_t demand; // slack that it must have, in units
    uint8_t forced; // it must stay, or something that rests on it
} sfi_node;

// The nodes of one layer; drawn voxels come first.
typedef struct sfi_layer {
    uint32_t k, count, drawn;
    sfi_node *nodes;
    size_t capacity;
} sfi_layer;

// A place that some node may rest on, in the list of its tally.
typedef struct sfi_candidate {
    uint32_t place, link;
} sfi_candidate;

// Add a node. SF_ERR_MEMORY; SF_ERR_OVERFLOW beyond 2^31 - 3 nodes.
sf_status sfi_layer_add(const sfi_job *job, sfi_layer *layer, uint32_t at, int64_t profit,
                        int16_t least, int forced);

// What the choice works with: planes of the layer below, and planes and arrays of its own.
typedef struct sfi_chooser {
    const sfi_job *job;
    sfi_plane plane;
    int prefer_drawn;
    int16_t *prices; // of the layer below
    uint8_t *codes;  // of the layer below, or NULL
    uint8_t *roots;  // codes of the roots there, or NULL
    uint32_t *slot;  // node of the layer below at a place, plus 1; 0: none
    uint32_t *due;   // node of this layer that waits at a place, plus 1; 0: none
    uint32_t *tally; // how many of those a place below would carry
    sfi_step *steps;
    size_t step_count, steps_most;
    uint32_t gain; // under slack
    sfi_candidate *candidates;
    size_t candidate_count, candidate_capacity;
    uint32_t *heads; // of the lists, by tally; index of a candidate, plus 1
} sfi_chooser;

sf_status sfi_chooser_create(const sfi_job *job, int prefer_drawn, sfi_chooser *chooser);
void sfi_chooser_destroy(sfi_chooser *chooser);

// Prices and codes of layer `below` into the planes, and the steps down to it.
void sfi_chooser_load(sfi_chooser *chooser, const sfi_price *price, uint32_t below);

// Choose a supporter in `low` for each node of `here` whose next is SFI_NEXT_WANTED, adding nodes
// to low; the next of those that have none becomes SFI_NEXT_NONE. `all` grows by what the new nodes
// cost.
sf_status sfi_choose(sfi_chooser *chooser, sfi_layer *here, sfi_layer *low, uint64_t *all);

// Slack that a supporter must have for a node with this demand.
static inline uint32_t sfi_step_demand(const sfi_chooser *c, uint32_t demand, const sfi_step *step)
{
    uint32_t need = demand + step->cost;
    return need > c->gain ? need - c->gain : 0;
}

#endif
