// SPDX-License-Identifier: MIT
// Printing: does a part topple while it is printed?
//
// A part that stands when it is done need not have stood all the time: an arm that is printed
// before what balances it pulls it over, and two legs that are joined at the top stand alone until
// they are. So after each layer every piece of what is there, each connected set of solid voxels,
// is looked at by itself: its own centre of mass over its own contact with the bed. That glue or
// suction holds it down is not counted on.

#ifndef SF_PRINTING_H
#define SF_PRINTING_H

#include <sf/support.h>

#ifdef __cplusplus
extern "C" {
#endif

/** How sf_grid_printing() looks. Fill with sf_printing_options_default(). */
typedef struct sf_printing_options {
    size_t struct_size;           /**< sizeof(sf_printing_options), set by the default */
    uint32_t bed_layer;           /**< the layer on the bed, or SF_BED_AUTO, the default: the first
                                       that holds matter. What lies below it is left out */
    sf_connectivity connectivity; /**< SF_CONNECT_CORNERS, the default: voxels that touch in as much
                                       as a corner are one piece, so that what is support-free under
                                       the rule box3 never floats; SF_CONNECT_EDGES: only those that
                                       share a face */
    double *margins_rad;          /**< NULL, or receives a margin for each layer */
    size_t margin_capacity;       /**< places in it: at least the grid's nz, where it is not NULL */
} sf_printing_options;

/** How a print stands, from the first layer to the last. */
typedef struct sf_printing_report {
    uint32_t bed_layer;    /**< the layer on the bed; SF_BED_AUTO where nothing is solid */
    double margin_rad;     /**< the least tilt, over all layers and pieces on the bed, that makes a
                                piece fall; negative where one falls as it is; 90 degrees where
                                nothing stands on the bed */
    uint32_t layer;        /**< after which layer: the lowest, where several are as bad; SF_BED_AUTO
                                where nothing stands on the bed; what follows is then all zero */
    sf_box piece;          /**< the box around the piece, as it was then */
    uint64_t piece_voxels; /**< how many voxels it had */
    double com_mm[3];      /**< its centre of mass, in the lattice's frame */
    double edge_mm[2][3];  /**< the edge of its contact with the bed over which it falls */
    uint32_t toppling_layers; /**< after how many layers some piece falls as it is */
    uint64_t floating_count;  /**< how many pieces begin in the air, connected with nothing */
    uint32_t floating_layer;  /**< the lowest layer that one begins in, or SF_BED_AUTO */
    uint32_t standing_count;  /**< the largest number of pieces on the bed after any layer */
} sf_printing_report;

/**
 * Options of a look at printing, each at its default.
 *
 * @return the options, by value.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API sf_printing_options sf_printing_options_default(void);

/**
 * How far from toppling a part is, after each of its layers.
 *
 * For every layer k from the bed up, take what is solid from the bed to k, and each connected piece
 * of it that has voxels in the bed layer. It stands on the convex hull of its voxels' squares
 * there; its margin is the least angle by which the bed must be tilted for its centre of mass to
 * pass over an edge of that hull. All voxels have one density, each layer its own height. The
 * margin of layer k is the least over the pieces; below the bed, and where no piece has voxels on
 * the bed, it is 90 degrees.
 *
 * Pieces that float are counted, and do not count in margins until they are connected with one that
 * stands; sf_grid_check() says more about them.
 *
 * Sums are integers: with layers of one height the centre of mass is exact before its last
 * division; heights of layers are rounded to 2^-40 of the whole, and up to it where they are less.
 *
 * @param grid       the voxels, only read
 * @param options    NULL for the default
 * @param allocator  for scratch: the runs of two layers, and a record of some 200 bytes for each
 *                   piece of a layer and each on the bed; NULL for the C library's
 * @param task       NULL, or progress and cancel, which is heeded at every layer
 * @param report     receives the report
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, options without their struct_size, no such
 * connectivity, a bed_layer that the grid does not have; SF_ERR_CAPACITY: fewer places for margins
 * than the grid has layers; SF_ERR_OVERFLOW: more than UINT32_MAX runs in a layer, or pieces;
 * SF_ERR_MEMORY; SF_ERR_CANCELLED.
 * @cost nearly linear in the runs of all layers, and, for each layer, in the pieces on the bed.
 * @threads any; one at a time for each allocator.
 * @source the margin: R. Prevost, E. Whiting, S. Lefebvre, O. Sorkine-Hornung, "Make It Stand",
 * 2013, section 3; the pieces: R. E. Tarjan, "Efficiency of a Good But Not Linear Set Union
 * Algorithm", 1975.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_grid_printing(const sf_grid *grid,
                                             const sf_printing_options *options,
                                             const sf_allocator *allocator, sf_task *task,
                                             sf_printing_report *report);

#ifdef __cplusplus
}
#endif

#endif
