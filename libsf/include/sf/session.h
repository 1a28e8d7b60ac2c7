// SPDX-License-Identifier: MIT
// Sessions: what a person did, as a list of steps, in a file that does it again.
//
// A session begins with the space that a model lives in, and goes on with tips and with steps:
// strokes, undo and redo, ghosts let go, a shape put in place of another. Played on an empty model
// it gives the model that it was recorded from, to the bit, on any machine. It may also hold the
// state at its end, which opens without playing, and which a replay is held against.
//
// The file is text: words and numbers, so that two sessions can be compared and a scene be written
// by hand. docs/sculpt.md tells its grammar.

#ifndef SF_SESSION_H
#define SF_SESSION_H

#include <sf/io.h>
#include <sf/sculpt.h>

#ifdef __cplusplus
extern "C" {
#endif

/** A list of steps. */
typedef struct sf_session sf_session;

/** The space of a session. Fill with sf_session_options_default(). */
typedef struct sf_session_options {
    size_t struct_size;  /**< sizeof(sf_session_options), set by the default */
    sf_lattice lattice;  /**< as in sf_sculpt_options, with layers of one height */
    sf_rule_kind rule;   /**< box3 by default */
    double angle_rad;    /**< of the rule, as sf_rule_make() takes it; 45 degrees by default */
    uint32_t bed_layer;  /**< 0 by default */
    int keep_drawn;      /**< 0 by default */
    size_t history_size; /**< 64 MiB by default */
} sf_session_options;

/** What a session holds. */
typedef struct sf_session_counts {
    size_t tips, steps;   /**< strokes are steps */
    size_t strokes, dabs; /**< dabs of all strokes */
    int has_state;        /**< 1: the state at its end as well */
} sf_session_counts;

/** Steps that are no strokes and need no more said. */
typedef enum sf_session_step {
    SF_SESSION_UNDO = 0,       /**< sf_sculpt_undo() */
    SF_SESSION_REDO = 1,       /**< sf_sculpt_redo() */
    SF_SESSION_DROP_GHOSTS = 2 /**< sf_sculpt_drop_ghosts() */
} sf_session_step;

/**
 * Options of a session: those of sf_sculpt_options_default().
 *
 * @return the options, by value.
 * @cost constant.   @threads any.   @since 0.1
 */
SF_API sf_session_options sf_session_options_default(void);

/**
 * Make a session without steps.
 *
 * @param options    the space
 * @param allocator  for the session; NULL for the C library's
 * @param session    the session
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, options without their struct_size, a lattice with
 * heights, a bed layer that it has not; what sf_lattice_validate() and sf_rule_make() say;
 * SF_ERR_MEMORY.
 * @cost constant.   @threads any; one at a time for each allocator.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_session_create(const sf_session_options *options,
                                              const sf_allocator *allocator, sf_session **session);

/**
 * Free a session and its tips.
 *
 * @param session  the session, freed; NULL does nothing
 * @cost linear.   @threads one, and nobody else with this session.   @since 0.1
 */
SF_API void sf_session_destroy(sf_session *session);

/**
 * The space of a session.
 *
 * @param session  the session, not NULL
 * @return the options, by value.
 * @cost constant.   @threads any.   @since 0.1
 */
SF_API sf_session_options sf_session_options_of(const sf_session *session);

/**
 * What a session holds.
 *
 * @param session  the session, not NULL
 * @return the counts, by value.
 * @cost constant.   @threads any.   @since 0.1
 */
SF_API sf_session_counts sf_session_count(const sf_session *session);

// ---------------------------------------------------------------------------------------------
// Recording
// ---------------------------------------------------------------------------------------------

/**
 * Add a tip by formula, as sf_tip_create() makes it.
 *
 * @param session    the session
 * @param shape      which
 * @param radius_vx  half its extents
 * @param tip        receives its number, counted from 0
 * @return SF_OK; what sf_tip_create() says; SF_ERR_OVERFLOW: 2^20 tips.
 * @cost that of the tip.   @threads one per session.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_session_add_tip(sf_session *session, sf_tip_shape shape,
                                               const double radius_vx[3], uint32_t *tip);

/**
 * Add a tip of a mask, as sf_tip_create_mask() makes it; also what a stamp or a mesh became.
 *
 * @param session  the session
 * @param mask     its voxels, copied
 * @param anchor   its voxel that comes to lie on each dab
 * @param tip      receives its number, counted from 0
 * @return SF_OK; what sf_tip_create_mask() says; SF_ERR_OVERFLOW: 2^20 tips.
 * @cost that of the tip.   @threads one per session.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_session_add_mask(sf_session *session, const sf_grid *mask,
                                                sf_dab anchor, uint32_t *tip);

/**
 * A tip of a session, to put into a brush.
 *
 * @param session  the session; NULL has none
 * @param tip      its number, counted from 0
 * @return the tip, which lives as long as the session; NULL for one that there is not.
 * @cost constant.   @threads any.   @since 0.1
 */
SF_API const sf_tip *sf_session_tip(const sf_session *session, uint32_t tip);

/**
 * Add a stroke.
 *
 * @param session  the session
 * @param brush    what it does; its own tip is not looked at
 * @param tip      number of the tip
 * @param dabs     where, copied; may be NULL where count is 0
 * @param count    how many
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a brush out of its range, a tip that there is
 * not, a dab beyond 2^30; SF_ERR_MEMORY.
 * @cost linear.   @threads one per session.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_session_add_stroke(sf_session *session, const sf_brush *brush,
                                                  uint32_t tip, const sf_dab *dabs, size_t count);

/**
 * Add a step that is no stroke.
 *
 * @param session  the session
 * @param step     which
 * @return SF_OK; SF_ERR_ARGUMENT: NULL, no such step; SF_ERR_MEMORY.
 * @cost constant.   @threads one per session.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_session_add_step(sf_session *session, sf_session_step step);

/**
 * Add a shape that takes the place of what is drawn, as sf_sculpt_replace() does.
 *
 * @param session    the session
 * @param drawn      of the session's counts; copied as runs
 * @param materials  as in sf_sculpt_replace(), or NULL
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer; SF_ERR_SHAPE; SF_ERR_MEMORY.
 * @cost a pass over the grid.   @threads one per session.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_session_add_shape(sf_session *session, const sf_grid *drawn,
                                                 const uint8_t *materials);

/**
 * Keep the state of a model as that at the end of the session; another one is forgotten.
 *
 * @param session  the session
 * @param model    NULL: no state is kept
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL session; SF_ERR_SHAPE: other counts; SF_ERR_MEMORY.
 * @cost a pass over the grid.   @threads one per session.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_session_keep_state(sf_session *session, const sf_sculpt *model);

// ---------------------------------------------------------------------------------------------
// Playing
// ---------------------------------------------------------------------------------------------

/**
 * Make an empty model in the session's space.
 *
 * @param session    the session
 * @param allocator  for the model; NULL for the C library's
 * @param model      receives the model
 * @return as sf_sculpt_create().
 * @cost that.   @threads any; one at a time for each allocator.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_session_begin(const sf_session *session,
                                             const sf_allocator *allocator, sf_sculpt **model);

/**
 * Do one step on a model.
 *
 * @param session    the session
 * @param step       number of the step, counted from 0
 * @param allocator  for a shape that takes the place of another; NULL for the C library's
 * @param model      of the session's space
 * @param change     what changed; may be NULL
 * @return SF_OK, also where there was nothing to undo or redo; SF_ERR_ARGUMENT: a NULL pointer, a
 * step that there is not; SF_ERR_MEMORY: for a shape; what the step's own call says.
 * @cost that of the step.   @threads one per model.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_session_play(const sf_session *session, size_t step,
                                            const sf_allocator *allocator, sf_sculpt *model,
                                            sf_sculpt_change *change);

/**
 * What a step is, where it is a stroke: for a host that does strokes by other means.
 *
 * @param session  the session; NULL has no steps
 * @param step     number of the step
 * @param brush    receives the brush, with its tip, which lives as long as the session; NULL: 0 is
 *                 returned, as for the two others
 * @param dabs     receives its dabs, which live until the next one is added, or NULL where there
 *                 are none
 * @param count    receives how many; NULL as for the brush
 * @return 1; 0, with nothing written, for a step that is no stroke or not there, and for NULL.
 * @cost constant.   @threads any.   @since 0.1
 */
SF_API int sf_session_stroke(const sf_session *session, size_t step, sf_brush *brush,
                             const sf_dab **dabs, size_t *count);

/**
 * Do all steps on a new model, and hold the result against the state that is kept, if one is.
 *
 * @param session    the session
 * @param allocator  for the model; NULL for the C library's
 * @param task       NULL, or progress per step; a cancel is honoured at every step
 * @param model      the model
 * @return SF_OK; SF_ERR_FORMAT: the state that is kept is another; what sf_session_begin() and
 * sf_session_play() say; SF_ERR_CANCELLED.
 * @cost all steps.   @threads any; one at a time for each allocator.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_session_replay(const sf_session *session,
                                              const sf_allocator *allocator, sf_task *task,
                                              sf_sculpt **model);

/**
 * Open the state that is kept, without playing; its history is empty.
 *
 * @param session    the session
 * @param allocator  for the model; NULL for the C library's
 * @param model      the model
 * @return SF_OK; SF_ERR_INFEASIBLE: no state is kept; as sf_session_begin().
 * @cost a trim, and passes over the grid.   @threads any; one at a time for each allocator.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_session_open(const sf_session *session,
                                            const sf_allocator *allocator, sf_sculpt **model);

// ---------------------------------------------------------------------------------------------
// Files
// ---------------------------------------------------------------------------------------------

/**
 * Write a session as text. The same session gives the same bytes; read and written again it stays.
 *
 * @param session  the session
 * @param sink     where the bytes go; on failure it may have had some
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL session, no sink; or what the sink returned.
 * @cost linear.   @threads any, on distinct sinks.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_session_write(const sf_session *session, sf_sink sink);

/**
 * Read a session.
 *
 * No count in a file is believed: memory grows as the bytes come, but for the tips, of which each
 * may ask for a mask of 2^27 voxels at most.
 *
 * @param source     the file
 * @param bytes_max  most bytes read; 0 for 1 GiB
 * @param allocator  for the session; NULL for the C library's
 * @param session    the session; untouched on failure
 * @param fault      NULL, or filled on failure: what is wrong, in which line, and what to do
 * @return SF_OK; SF_ERR_FORMAT: the bytes are no session; SF_ERR_UNSUPPORTED: one of a later
 * version; SF_ERR_OVERFLOW: more than bytes_max, or a space or a tip that is too large;
 * SF_ERR_MEMORY; SF_ERR_ARGUMENT: a NULL pointer; or what the source returned.
 * @cost linear, and the tips.   @threads any, on distinct sources.   @since 0.1
 */
SF_API SF_CHECKED sf_status sf_session_read(sf_source source, uint64_t bytes_max,
                                            const sf_allocator *allocator, sf_session **session,
                                            sf_fault *fault);

#ifdef __cplusplus
}
#endif

#endif
