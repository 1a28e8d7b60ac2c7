// SPDX-License-Identifier: MIT
// History: steps that can be taken back and done again, in a ring of bytes.

#ifndef SF_SCULPT_HISTORY_H
#define SF_SCULPT_HISTORY_H

#include <stddef.h>
#include <stdint.h>

// Steps lie one after the other in a ring: what can be undone from `first` to `here`, what can be
// done again from there to `end`. The three only grow; a place in the ring is one of them modulo
// the capacity.
typedef struct sfi_history {
    uint8_t *bytes;
    size_t capacity;
    uint64_t first, here, end;
    size_t undo_count, redo_count, forgotten_count;
} sfi_history;

// A step being written: begins at `here`, and takes the place of what could be done again.
typedef struct sfi_step_writer {
    sfi_history *history;
    uint64_t at;
    uint8_t *place; // of `at` in the ring
    int is_full;    // it does not fit, even alone
} sfi_step_writer;

// A step being read.
typedef struct sfi_step_reader {
    const sfi_history *history;
    uint8_t *place;
} sfi_step_reader;

sfi_step_writer sfi_history_begin(sfi_history *history);
void sfi_step_put(sfi_step_writer *writer, uint64_t number); // 7 bits a byte
void sfi_history_end(sfi_step_writer *writer);

// The step before `here`, or the one after it, which must be there; moving `here` past it.
sfi_step_reader sfi_history_back(sfi_history *history);
sfi_step_reader sfi_history_forward(sfi_history *history);
uint64_t sfi_step_get(sfi_step_reader *reader);

#endif
