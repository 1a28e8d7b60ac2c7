// SPDX-License-Identifier: MIT
// Ring: the steps of a history in a ring of bytes, which takes no more memory than it was given.
//
// A step is a row of numbers (what they mean is delta.c's affair), between two copies of its
// length, so that it can be found from either end. Where the ring is full the oldest steps are
// forgotten, one after the other, while the new one is written; a step that is larger than the ring
// leaves it empty.

#include "sculpt/ring.h"

// Bytes of a length, before and after each step.
#define LENGTH_SIZE 8u

static uint8_t *place(const sfi_ring *h, uint64_t at)
{
    return h->bytes + at % h->capacity;
}

// The place after one.
static uint8_t *next(const sfi_ring *h, uint8_t *at)
{
    return at + 1 < h->bytes + h->capacity ? at + 1 : h->bytes;
}

static void put_length(const sfi_ring *h, uint64_t at, uint64_t length)
{
    for (unsigned i = 0; i < LENGTH_SIZE; i++) {
        *place(h, at + i) = (uint8_t)(length >> 8 * i);
    }
}

static uint64_t get_length(const sfi_ring *h, uint64_t at)
{
    uint64_t length = 0;
    for (unsigned i = 0; i < LENGTH_SIZE; i++) {
        length |= (uint64_t)*place(h, at + i) << 8 * i;
    }
    return length;
}

static void forget_all(sfi_ring *history)
{
    history->forgotten_count += history->undo_count;
    history->first = history->here = history->end = 0;
    history->undo_count = history->redo_count = 0;
}

// ---------------------------------------------------------------------------------------------
// Writing
// ---------------------------------------------------------------------------------------------

// Room for one more byte, by forgetting.
static void make_room(sfi_step_writer *w)
{
    sfi_ring *h = w->history;
    while (!w->is_full && w->at + 1 - h->first > h->capacity) {
        if (h->undo_count == 0) {
            w->is_full = 1;
            return;
        }
        h->first += get_length(h, h->first) + 2 * LENGTH_SIZE;
        h->undo_count--;
        h->forgotten_count++;
    }
}

static void put_byte(sfi_step_writer *w, uint8_t byte)
{
    make_room(w);
    if (!w->is_full) {
        *w->place = byte;
        w->place = next(w->history, w->place);
        w->at++;
    }
}

sfi_step_writer sfi_ring_begin(sfi_ring *history)
{
    history->end = history->here;
    history->redo_count = 0;
    uint8_t *first = history->capacity > 0 ? place(history, history->here) : NULL;
    sfi_step_writer w = {history, history->here, first, 0};
    for (unsigned i = 0; i < LENGTH_SIZE; i++) {
        put_byte(&w, 0);
    }
    return w;
}

void sfi_step_put(sfi_step_writer *writer, uint64_t number)
{
    for (; number > 127; number >>= 7) {
        put_byte(writer, (uint8_t)(number | 128));
    }
    put_byte(writer, (uint8_t)number);
}

void sfi_ring_end(sfi_step_writer *writer)
{
    sfi_ring *h = writer->history;
    uint64_t length = writer->at - h->here - LENGTH_SIZE;
    for (unsigned i = 0; i < LENGTH_SIZE; i++) {
        put_byte(writer, (uint8_t)(length >> 8 * i));
    }
    if (writer->is_full) {
        forget_all(h);
        h->forgotten_count++;
        return;
    }
    put_length(h, h->here, length);
    h->here = h->end = writer->at;
    h->undo_count++;
}

// ---------------------------------------------------------------------------------------------
// Reading
// ---------------------------------------------------------------------------------------------

// A reader of the step that begins here.
static sfi_step_reader read_at(const sfi_ring *h, uint64_t at)
{
    sfi_step_reader reader = {place(h, at + LENGTH_SIZE), h->bytes, h->bytes + h->capacity};
    return reader;
}

sfi_step_reader sfi_ring_back(sfi_ring *history)
{
    history->here -= get_length(history, history->here - LENGTH_SIZE) + 2 * LENGTH_SIZE;
    history->undo_count--;
    history->redo_count++;
    return read_at(history, history->here);
}

sfi_step_reader sfi_ring_forward(sfi_ring *history)
{
    sfi_step_reader reader = read_at(history, history->here);
    history->here += get_length(history, history->here) + 2 * LENGTH_SIZE;
    history->undo_count++;
    history->redo_count--;
    return reader;
}
