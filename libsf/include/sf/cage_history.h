// SPDX-License-Identifier: MIT
// Undo and redo for cages: what was painted, moved or set, step by step, to the bit.
//
// A history remembers how a cage was when it was last recorded. Edit the cage by whatever calls,
// as many as make up one step for the person who draws (the dabs of a stroke), then record: what
// differs is kept as one step. Steps live within a number of bytes that the caller gives; the
// oldest are forgotten first. Who shows the cage updates a refinement or a limit of it after an
// undo, as after any edit.

#ifndef SF_CAGE_HISTORY_H
#define SF_CAGE_HISTORY_H

#include <sf/base.h>
#include <sf/cage.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The steps of one cage. */
typedef struct sf_cage_history sf_cage_history;

/** What a history holds. */
typedef struct sf_cage_history_state {
    size_t undo_count; /**< steps that can be undone */
    size_t redo_count; /**< steps that can be redone */
    size_t bytes;      /**< of both */
} sf_cage_history_state;

/**
 * A history without steps, of a cage as it is now.
 *
 * @param cage       the cage; the history copies its positions and values and does not keep it
 * @param bytes_max  most bytes of all steps together, besides that copy: 8 for each number that a
 * step changes, and up to 24 more where it stands alone
 * @param allocator  for the history; NULL for the C library's
 * @param history    receives the history
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer; SF_ERR_MEMORY.
 * @cost O(points and values).   @threads any, while nobody changes the cage.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_cage_history_create(const sf_cage *cage, size_t bytes_max,
                                                   const sf_allocator *allocator,
                                                   sf_cage_history **history);

/**
 * Free a history. The cage stays as it is.
 *
 * @param history  the history, freed; NULL does nothing
 * @cost O(steps).   @threads one, and nobody else with this history.
 * @since 0.1
 */
SF_API void sf_cage_history_destroy(sf_cage_history *history);

/**
 * Keep what has changed since the last call as one step; nothing, if nothing has.
 *
 * Steps that could be redone are forgotten then. A step that takes more than all the bytes there
 * are empties the history: it cannot be undone, nor what was before it. Properties that were added
 * at the cage's end are watched from now on; that they were added is no step.
 *
 * @param history  the history; on failure it is as it was
 * @param cage     its cage
 * @param changed  NULL, or receives how many numbers are not what they were
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer; SF_ERR_SHAPE: not its cage, or one that a
 * property was removed from; SF_ERR_MEMORY.
 * @cost O(points and values).   @threads one for each history, while nobody changes the cage.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_cage_history_record(sf_cage_history *history, const sf_cage *cage,
                                                   size_t *changed);

/**
 * Undo the last step; where something has changed that was not recorded, record it first and undo
 * that.
 *
 * @param history  the history; on failure it is as it was
 * @param cage     its cage; on failure it is as it was
 * @param changed  NULL, or receives how many numbers are not what they were; 0: there was no step
 * @return as sf_cage_history_record().
 * @cost O(points and values).   @threads one for each history and cage.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_cage_history_undo(sf_cage_history *history, sf_cage *cage,
                                                 size_t *changed);

/**
 * Redo the step that was undone last; where something has changed since, record that instead, after
 * which there is nothing to redo.
 *
 * @param history  the history; on failure it is as it was
 * @param cage     its cage; on failure it is as it was
 * @param changed  NULL, or receives how many numbers are not what they were; 0: there was no step
 * @return as sf_cage_history_record().
 * @cost O(points and values).   @threads one for each history and cage.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_cage_history_redo(sf_cage_history *history, sf_cage *cage,
                                                 size_t *changed);

/**
 * What a history holds.
 *
 * @param history  the history; of NULL nothing
 * @return the counts, by value.
 * @cost constant.   @threads any, while nobody changes the history.
 * @since 0.1
 */
SF_API sf_cage_history_state sf_cage_history_get_state(const sf_cage_history *history);

#ifdef __cplusplus
}
#endif

#endif
