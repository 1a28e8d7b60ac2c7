// SPDX-License-Identifier: MIT
// Sculpt: brushes that never leave the printable set.
//
// A model is a shape that a person works on. It holds two grids on one lattice: what is drawn, D,
// and what of it prints without supports, T = trim(D), by the model's rule and bed layer. It holds
// a material number for each drawn voxel as well. A brush changes the model along a stroke, and
// after every call T is the trim of D, bit for bit. When a stroke ends D becomes T, unless the
// model keeps what is drawn: then the rest, D without T, stays as a ghost, which becomes printable
// by itself once there is support for it.
//
// A brush is a tip, the voxels that it covers around where it is put, and what it does there. A
// stroke is a set of dabs: places where the tip is put. What it does depends on the union U of its
// tips and on the model before the stroke, and on nothing else: neither on the order of the dabs,
// nor on how many calls bring them. With D, T before and D', T' after:
//
//     add-trim          D' = D with U
//     remove-trim       D' = D without U
//     remove-preserve   T' = T without what of U carries nothing outside it (sf_grid_preserve(),
//                       SF_PRESERVE_FAST), D' = D without the rest of U
//     add-grow          D' = D with U, with the tip at every voxel of the closest supporting path
//                       in T of each dab, and with what the voxels of U still lack: so all of U
//                       that lies on or above the bed is printable
//     smooth-trim       D' = D where in U, `passes` times for all voxels at once, a voxel is solid
//                       just when at least 14 of the 27 around it are, itself among them
//     paint             only materials change, of what is drawn within U
//
// and T' = trim(D') in each. A voxel that is added takes the brush's material, under smooth-trim
// the one that most of the solid voxels around it have, of equals the lowest. What is outside the
// grid is empty.
//
// Every stroke, and every other change, is one step of a history, which can be undone and done
// again, exactly, as far as the memory set aside for it reaches. All memory is taken when a model
// is made; no later call allocates.

#ifndef SF_SCULPT_H
#define SF_SCULPT_H

#include <sf/mesh.h>
#include <sf/support.h>

#ifdef __cplusplus
extern "C" {
#endif

// ---------------------------------------------------------------------------------------------
// Tips
// ---------------------------------------------------------------------------------------------

/** Where a tip is put: a voxel, or one that would be there beyond the grid's border. */
typedef struct sf_dab {
    int32_t x, y, z; /**< column, row, layer; each within 2^30 of 0 */
} sf_dab;

/** The shapes of tips that are made by formula. */
typedef enum sf_tip_shape {
    SF_TIP_SPHERE = 0,   /**< an ellipsoid */
    SF_TIP_BOX = 1,      /**< a box along the axes */
    SF_TIP_CYLINDER = 2, /**< an elliptic cylinder, upright */
    SF_TIP_CONE = 3      /**< an elliptic cone, its point up */
} sf_tip_shape;

/** The voxels that a brush covers, around an anchor, which comes to lie on each dab. */
typedef struct sf_tip sf_tip;

/**
 * Make a tip by formula: the voxels whose centres lie in the shape, its centre on a voxel's centre.
 *
 * The anchor is the middle voxel, which is always covered.
 *
 * @param shape      which
 * @param radius_vx  half its extents along x, y and z, in voxels; each 0 to 1024
 * @param allocator  for the tip; NULL for the C library's
 * @param tip        the tip
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, no such shape, a radius outside its range or not
 * a number; SF_ERR_OVERFLOW; SF_ERR_MEMORY.
 * @cost the voxels of the box around it.   @threads any; one at a time for each allocator.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_tip_create(sf_tip_shape shape, const double radius_vx[3],
                                          const sf_allocator *allocator, sf_tip **tip);

/**
 * Make a tip of any mask: its solid voxels.
 *
 * A mesh becomes a tip by way of sf_grid_voxelize() on the model's pitch and layer height.
 *
 * @param mask       a grid of any size; only its voxels count, not where its lattice lies
 * @param anchor     its voxel that comes to lie on each dab; may lie outside it
 * @param allocator  for the tip; NULL for the C library's
 * @param tip        the tip
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, an anchor beyond 2^30, a mask without solid
 * voxels; SF_ERR_OVERFLOW: a mask larger than 4096 voxels along an axis; SF_ERR_MEMORY.
 * @cost a pass over the mask.   @threads any; one at a time for each allocator.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_tip_create_mask(const sf_grid *mask, sf_dab anchor,
                                               const sf_allocator *allocator, sf_tip **tip);

/**
 * Make a stamp of an image of heights: above pixel (x, y) as many voxels as its value says.
 *
 * Pixel values 0 to 255 stand for 0 to depth_vx voxels, rounded to the nearest. The anchor lies in
 * the lowest layer, in the middle of the image.
 *
 * @param heights    the pixel of voxel (0, 0), then those along x
 * @param row_bytes  bytes from one row to the next, at least the width
 * @param width      pixels along x, 1 to 4096
 * @param height     rows, 1 to 4096
 * @param depth_vx   voxels that 255 stands for, 1 to 4096
 * @param allocator  for the tip; NULL for the C library's
 * @param tip        the tip
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a size outside its range, rows that are too
 * short, an image that is 0 or rounds to it everywhere; SF_ERR_OVERFLOW; SF_ERR_MEMORY.
 * @cost the voxels of the box around it.   @threads any; one at a time for each allocator.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_tip_create_stamp(const uint8_t *heights, size_t row_bytes,
                                                uint32_t width, uint32_t height, uint32_t depth_vx,
                                                const sf_allocator *allocator, sf_tip **tip);

/**
 * The mask of a tip, and its anchor in it.
 *
 * @param tip     the tip; NULL has none
 * @param anchor  the anchor's place in the mask; may be NULL
 * @return the mask, which lives as long as the tip; NULL for NULL.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API const sf_grid *sf_tip_mask(const sf_tip *tip, sf_dab *anchor);

/**
 * Free a tip.
 *
 * @param tip  the tip, freed; NULL does nothing
 * @cost constant.   @threads one, and nobody else with this tip.   @since 0.1
 */
SF_API void sf_tip_destroy(sf_tip *tip);

// ---------------------------------------------------------------------------------------------
// Brushes
// ---------------------------------------------------------------------------------------------

/** What a brush does. */
typedef enum sf_brush_kind {
    SF_BRUSH_ADD_TRIM = 0,        /**< adds what of the tips is carried; touches nothing else */
    SF_BRUSH_REMOVE_PRESERVE = 1, /**< removes what carries nothing; touches nothing else */
    SF_BRUSH_ADD_GROW = 2,        /**< adds the tips, and below them what they need */
    SF_BRUSH_REMOVE_TRIM = 3,     /**< removes the tips, and above them what then hangs */
    SF_BRUSH_SMOOTH_TRIM = 4,     /**< levels bumps and dents, then removes what hangs */
    SF_BRUSH_PAINT = 5,           /**< gives what is there another material */
    SF_BRUSH_KIND_COUNT = 6       /**< number of kinds, not one of them */
} sf_brush_kind;

/**
 * Name of a kind of brush, as a person reads and types it: "add-trim", "remove-preserve".
 *
 * @param kind  any value; one that is no kind has no name
 * @return a static string; NULL for one that is no kind.
 * @cost constant.   @threads any.   @since 0.1
 */
SF_API const char *sf_brush_kind_name(sf_brush_kind kind);

/** Most passes of a smooth-trim. */
#define SF_BRUSH_PASSES_MAX 16u

/** A brush. Fill with sf_brush_default(). */
typedef struct sf_brush {
    size_t struct_size; /**< sizeof(sf_brush), set by the default */
    sf_brush_kind kind; /**< add-trim by default */
    const sf_tip *tip;  /**< must outlive the stroke; NULL by default, which no stroke takes */
    uint8_t material;   /**< of what is added or painted: 1 (default) to 255 */
    uint32_t passes;    /**< of smooth-trim: 1 (default) to SF_BRUSH_PASSES_MAX */
    int mirror_x;       /**< 1: every tip is also put mirrored, x to nx - 1 - x; 0 by default */
    int mirror_y;       /**< the same along y; both give four tips for each dab */
} sf_brush;

/**
 * A brush without a tip: add-trim, material 1, one pass, no mirrors.
 *
 * @return the brush, by value.
 * @cost constant.   @threads any.   @since 0.1
 */
SF_API sf_brush sf_brush_default(void);

/** What a call changed, and what of a stroke was kept back or lost. */
typedef struct sf_sculpt_change {
    sf_box drawn;     /**< box around the voxels of D that this call changed, and around no more
                           than the stroke changes or did before the call; empty (all zero) where
                           there are none */
    sf_box printable; /**< the same for T */
    sf_box material;  /**< the same for materials */
    // Of the whole stroke so far (of an undo or redo: of that step), in voxels:
    uint64_t added_voxels;     /**< printable now and not before */
    uint64_t removed_voxels;   /**< within the union of the tips printable before and not now */
    uint64_t lost_voxels;      /**< outside it printable before and not now: what fell */
    uint64_t kept_back_voxels; /**< adding: of the tips, not printable, because nothing carries
                                    them; remove-preserve: of the tips, left, because they carry */
    uint64_t path_voxels;      /**< add-grow: of the supporting paths, each voxel once for each */
} sf_sculpt_change;

// ---------------------------------------------------------------------------------------------
// Models
// ---------------------------------------------------------------------------------------------

/** A shape that is worked on. */
typedef struct sf_sculpt sf_sculpt;

/** How a model is made. Fill with sf_sculpt_options_default(). */
typedef struct sf_sculpt_options {
    size_t struct_size;  /**< sizeof(sf_sculpt_options), set by the default */
    sf_lattice lattice;  /**< 512 x 512 x 512 voxels of 0.25 mm by default, as in the paper */
    sf_rule rule;        /**< box3 by default; its table must outlive the model */
    uint32_t bed_layer;  /**< layer that rests on the bed: 0 by default. SF_BED_AUTO is refused: the
                              bed does not move while one works */
    int keep_drawn;      /**< 1: what is trimmed stays as a ghost; 0 by default */
    size_t history_size; /**< bytes for undo and redo: 64 MiB by default */
} sf_sculpt_options;

/**
 * Options of a model: those of the paper.
 *
 * @return the options, by value.
 * @cost constant.   @threads any.   @since 0.1
 */
SF_API sf_sculpt_options sf_sculpt_options_default(void);

/**
 * Make an empty model.
 *
 * @param options    lattice, rule and bed
 * @param allocator  for all that the model will ever need: for each voxel two bytes and some six
 *                   bits, one more where ghosts are kept, more where a rule has slack or bridges,
 *                   and the history; NULL for the C library's
 * @param model      the model
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, options without their struct_size, a bed layer
 * that the lattice has not, a rule that does not serve all its layers; what sf_lattice_validate()
 * says; SF_ERR_OVERFLOW; SF_ERR_MEMORY.
 * @cost a pass over new memory.   @threads any; one at a time for each allocator.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_sculpt_create(const sf_sculpt_options *options,
                                             const sf_allocator *allocator, sf_sculpt **model);

/**
 * Free a model.
 *
 * @param model  the model, freed; NULL does nothing
 * @cost constant.   @threads one, and nobody else with this model.   @since 0.1
 */
SF_API void sf_sculpt_destroy(sf_sculpt *model);

/**
 * The options that a model was made with; its lattice's heights belong to the model.
 *
 * @param model  the model, not NULL
 * @return the options, by value.
 * @cost constant.   @threads any.   @since 0.1
 */
SF_API sf_sculpt_options sf_sculpt_options_of(const sf_sculpt *model);

/**
 * What prints without supports, T; during a stroke as far as the stroke has come.
 *
 * @param model  the model; NULL has none
 * @return the grid, which lives as long as the model and must not be written; NULL for NULL.
 * @cost constant.   @threads any, while no call changes the model.   @since 0.1
 */
SF_API const sf_grid *sf_sculpt_printable(const sf_sculpt *model);

/**
 * What is drawn, D: T and the ghosts.
 *
 * @param model  the model; NULL has none
 * @return as sf_sculpt_printable(); NULL for NULL.
 * @cost constant.   @threads any, while no call changes the model.   @since 0.1
 */
SF_API const sf_grid *sf_sculpt_drawn(const sf_sculpt *model);

/**
 * Materials of all voxels in (layer, y, x) order, a byte each: 0 where nothing is drawn.
 *
 * @param model  the model; NULL has none
 * @return the first of nz * ny * nx bytes, which live as long as the model; NULL for NULL.
 * @cost constant.   @threads any, while no call changes the model.   @since 0.1
 */
SF_API const uint8_t *sf_sculpt_materials(const sf_sculpt *model);

// ---------------------------------------------------------------------------------------------
// Strokes
// ---------------------------------------------------------------------------------------------

/**
 * Begin a stroke; the model is not changed before it has dabs.
 *
 * @param model  no stroke under way
 * @param brush  copied
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a brush without its struct_size or tip or with
 * values outside their range, a stroke under way; under slack and with bridges, add-grow only:
 * SF_ERR_MEMORY.
 * @cost constant; add-grow under a rule with slack, a trim.   @threads one per model.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_sculpt_begin(sf_sculpt *model, const sf_brush *brush);

/**
 * Put the brush on more places in the stroke that is under way.
 *
 * @param model   a stroke under way
 * @param dabs    where; may be NULL where count is 0
 * @param count   how many
 * @param change  what changed; may be NULL, which saves counting
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, no stroke under way, a dab beyond 2^30: the
 * stroke is as it was, and goes on; SF_ERR_MEMORY: what was set aside does not suffice, which a
 * rule with slack or bridges can meet: the stroke is given up, as by sf_sculpt_abandon().
 * @cost add-trim, remove-trim, paint: the new tips' boxes and what changes above them; the others:
 * the box around the whole stroke; add-grow also a search for each dab. Under a rule with slack a
 * trim.
 * @threads one per model.
 * @source T. Reiner, S. Lefebvre, "Interactive Modeling of Support-free Shapes for Fabrication",
 * Eurographics 2016, sections 2.2 and 3.2 (the brushes); one union for a stroke, and that add-grow
 * carries all of its tips, are the library's own.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_sculpt_dab(sf_sculpt *model, const sf_dab *dabs, size_t count,
                                          sf_sculpt_change *change);

/**
 * End the stroke that is under way: it becomes one step of the history, unless it changed nothing.
 *
 * The oldest steps are forgotten where the history's memory asks for it. A step that does not fit
 * at all is done and cannot be undone, and all before it are forgotten.
 *
 * @param model   a stroke under way
 * @param change  what this call changed (ghosts that go), and the stroke's counts; may be NULL
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, no stroke under way.
 * @cost the box around all that the stroke changed.   @threads one per model.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_sculpt_end(sf_sculpt *model, sf_sculpt_change *change);

/**
 * Give up the stroke that is under way: the model is as it was before it.
 *
 * @param model   with no stroke under way nothing happens
 * @param change  the boxes that this call changed; may be NULL
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL model.
 * @cost the box around all that the stroke changed.   @threads one per model.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_sculpt_abandon(sf_sculpt *model, sf_sculpt_change *change);

/**
 * A whole stroke: begin, dab, end. A call that fails leaves the model as it was.
 *
 * @param model   no stroke under way
 * @param brush   the brush
 * @param dabs    where; may be NULL where count is 0
 * @param count   how many
 * @param change  what changed; its boxes are those of the three calls together, with what was drawn
 *                and went again as a ghost; may be NULL
 * @return as sf_sculpt_begin() and sf_sculpt_dab().
 * @cost as these.   @threads one per model.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_sculpt_stroke(sf_sculpt *model, const sf_brush *brush,
                                             const sf_dab *dabs, size_t count,
                                             sf_sculpt_change *change);

/**
 * The dabs from one to another, a voxel apart: the digital line between them.
 *
 * The line has max(|dx|, |dy|, |dz|) steps; each dab is the nearest to the straight line, halves
 * rounded away from `from`.
 *
 * @param from      the first
 * @param to        the last
 * @param dabs      may be NULL where capacity is 0
 * @param capacity  places in the array
 * @param count     how many there are, both ends counted
 * @return SF_OK; SF_ERR_CAPACITY: too few places, with `count` set; SF_ERR_ARGUMENT: a NULL
 * pointer, a dab beyond 2^30.
 * @cost linear.   @threads any.
 * @source J. E. Bresenham, "Algorithm for computer control of a digital plotter", 1965.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_dab_line(sf_dab from, sf_dab to, sf_dab *dabs, size_t capacity,
                                        size_t *count);

// ---------------------------------------------------------------------------------------------
// Whole models
// ---------------------------------------------------------------------------------------------

/**
 * Put another shape in place of what is drawn: one step of the history.
 *
 * @param model      no stroke under way
 * @param drawn      the new D, of the model's counts; not a grid of the model; NULL: empty
 * @param materials  a byte for each voxel in (layer, y, x) order, looked at where drawn is solid,
 *                   where 0 counts as 1; NULL: all 1
 * @param change     what changed; may be NULL
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL model, a stroke under way, a grid of the model;
 * SF_ERR_SHAPE: other counts; SF_ERR_MEMORY: as sf_sculpt_dab().
 * @cost a trim, and some passes over the grid.   @threads one per model.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_sculpt_replace(sf_sculpt *model, const sf_grid *drawn,
                                              const uint8_t *materials, sf_sculpt_change *change);

/**
 * Let the ghosts go: D becomes T. One step of the history where there were any.
 *
 * @param model   no stroke under way
 * @param change  what changed; may be NULL
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL model, a stroke under way.
 * @cost some passes over the grid.   @threads one per model.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_sculpt_drop_ghosts(sf_sculpt *model, sf_sculpt_change *change);

// ---------------------------------------------------------------------------------------------
// History
// ---------------------------------------------------------------------------------------------

/** What a history holds. */
typedef struct sf_sculpt_history {
    size_t undo_count;      /**< steps that can be undone */
    size_t redo_count;      /**< steps that were undone and can be done again */
    size_t size;            /**< bytes that they take */
    size_t forgotten_count; /**< steps that were forgotten for want of memory */
} sf_sculpt_history;

/**
 * What the history of a model holds; the model must not be NULL.
 *
 * @param model  the model, not NULL
 * @return the counts, by value.
 * @cost constant.   @threads any, while no call changes the model.   @since 0.1
 */
SF_API sf_sculpt_history sf_sculpt_history_of(const sf_sculpt *model);

/**
 * Take back the last step: D, T and materials are what they were before it, bit for bit.
 *
 * @param model   no stroke under way
 * @param change  what changed; its counts say what this step adds and removes; may be NULL
 * @return SF_OK; SF_ERR_INFEASIBLE: there is no step to take back; SF_ERR_ARGUMENT: a NULL model, a
 * stroke under way.
 * @cost the step's size.   @threads one per model.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_sculpt_undo(sf_sculpt *model, sf_sculpt_change *change);

/**
 * Do again what was taken back last, unless something else was done since.
 *
 * @param model   no stroke under way
 * @param change  as in sf_sculpt_undo()
 * @return SF_OK; SF_ERR_INFEASIBLE: there is nothing to do again; SF_ERR_ARGUMENT as
 * sf_sculpt_undo().
 * @cost the step's size.   @threads one per model.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_sculpt_redo(sf_sculpt *model, sf_sculpt_change *change);

#ifdef __cplusplus
}
#endif

#endif
