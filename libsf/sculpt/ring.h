// SPDX-License-Identifier: MIT
// Ring: the steps of a history in a ring of bytes, which takes no more memory than it was given.

#ifndef SF_SCULPT_RING_H
#define SF_SCULPT_RING_H

#include <stddef.h>
#include <stdint.h>

// Steps lie one after the other in a ring: what can be undone from `first` to `here`, what can be
// done again from there to `end`. The three only grow; a place in the ring is one of them modulo
// the capacity.
typedef struct sfi_ring {
    uint8_t *bytes;
    size_t capacity;
    uint64_t first, here, end;
    size_t undo_count, redo_count, forgotten_count;
} sfi_ring;

// A step being written: begins at `here`, and takes the place of what could be done again.
typedef struct sfi_step_writer {
    sfi_ring *history;
    uint64_t at;
    uint8_t *place; // of `at` in the ring
    int is_full;    // it does not fit, even alone
} sfi_step_writer;

// A step being read: the next byte, and the ring's first and past its last.
typedef struct sfi_step_reader {
    const uint8_t *place, *bytes, *end;
} sfi_step_reader;

sfi_step_writer sfi_ring_begin(sfi_ring *history);
void sfi_step_put(sfi_step_writer *writer, uint64_t number); // 7 bits a byte
void sfi_ring_end(sfi_step_writer *writer);

// The step before `here`, or the one after it, which must be there; moving `here` past it.
sfi_step_reader sfi_ring_back(sfi_ring *history);
sfi_step_reader sfi_ring_forward(sfi_ring *history);

// The next number. Here, so that whoever reads a whole step keeps its place in a register.
static inline uint64_t sfi_step_get(sfi_step_reader *reader)
{
    uint64_t number = 0;
    for (unsigned shift = 0;; shift += 7) {
        uint8_t byte = *reader->place++;
        reader->place = reader->place < reader->end ? reader->place : reader->bytes;
        number |= (uint64_t)(byte & 127) << shift;
        if (byte < 128) {
            return number;
        }
    }
}

#endif
