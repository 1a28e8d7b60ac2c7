// SPDX-License-Identifier: MIT
// Layers as runs: as long as all of a layer rests on the one below, nothing else has to be known.
//
// Of a resin job almost every layer is of that kind, and a layer has a few thousand runs where it
// has millions of pixels. So a run is compared with what is below it, row by row of the element,
// nearest row first: from the run is taken what the runs of that row, each widened by the element's
// half width there, cover; mostly nothing is left after the first. What is left after the last row
// is not carried, and then the bits are asked, which name it. They are also asked where one run
// falls into more pieces than there is room for; a yes is therefore exact, a no is only a question.
//
// Both lists are sorted, so in each row of the element a cursor moves on with the runs: the cost is
// the runs of both layers times the rows that were needed, whatever the size of the slice.
//
// Freestanding; no memory but the checker's.
// Source: ALGORITHMS of this project, 10.7; the sweep is that of F. P. Preparata, M. I. Shamos,
// "Computational Geometry", 1985, on intervals of one line.

#include "support/check/run_front.h"

#define PIECES_MAX 24u
#define ROWS_MAX (2 * SF_REACH_MAX + 1)

void sfi_run_front_take(sfi_run_front *front, const sf_run *runs, size_t count)
{
    front->is_valid = count <= front->capacity && front->capacity > 0;
    if (!front->is_valid) {
        return;
    }
    uint32_t row = 0;
    for (uint32_t i = 0; i < count; i++) {
        for (; row <= runs[i].y; row++) {
            front->rows[row] = i;
        }
        front->runs[i] = runs[i];
    }
    for (; row <= front->height; row++) {
        front->rows[row] = (uint32_t)count;
    }
    front->count = (uint32_t)count;
}

// Half-open stretches of a row, in order.
typedef struct pieces {
    uint32_t count;
    uint32_t x0[PIECES_MAX], x1[PIECES_MAX];
} pieces;

static int add(pieces *to, uint32_t x0, uint32_t x1)
{
    if (to->count == PIECES_MAX) {
        return 0;
    }
    to->x0[to->count] = x0;
    to->x1[to->count++] = x1;
    return 1;
}

// What of the stretch x..end the runs from *at to `last`, widened by w, leave uncovered; 0 where
// there is no room for it.
static int subtract(const sf_run *at, const sf_run *last, uint32_t w, uint32_t x, uint32_t end,
                    pieces *left)
{
    for (; at < last && x < end; at++) {
        uint32_t low = at->x0 > w ? at->x0 - w : 0, high = at->x1 + w;
        if (low >= end) {
            break;
        }
        if (low > x && !add(left, x, low)) {
            return 0;
        }
        x = high > x ? high : x;
    }
    return x >= end || add(left, x, end);
}

// The rows of an element around row y of the front: which there are, and where each has come to.
typedef struct window {
    const sfi_run_front *front;
    const sf_element *element;
    uint32_t y;
    uint32_t cursors[ROWS_MAX]; // of row y - reach + i
    uint8_t begun[ROWS_MAX];
} window;

static void move_to(window *w, uint32_t y)
{
    w->y = y;
    for (uint32_t i = 0; i <= 2u * w->element->reach_y; i++) {
        w->begun[i] = 0;
    }
}

// Take from the pieces what row y + dy covers. Runs are asked for from left to right, `x` being
// where the one that the pieces are of begins.
static int take_row(window *w, int dy, uint32_t x, const pieces *from, pieces *left)
{
    const sfi_run_front *f = w->front;
    int64_t row = (int64_t)w->y + dy;
    uint32_t reach = w->element->reach_y, slot = (uint32_t)((int)reach + dy);
    uint32_t wide = w->element->half_width[dy < 0 ? -dy : dy];
    left->count = 0;
    if (row < 0 || row >= f->height) {
        *left = *from;
        return 1;
    }
    uint32_t last = f->rows[row + 1];
    uint32_t at = w->begun[slot] ? w->cursors[slot] : f->rows[row];
    while (at < last && f->runs[at].x1 + wide <= x) {
        at++;
    }
    w->cursors[slot] = at;
    w->begun[slot] = 1;
    for (uint32_t i = 0; i < from->count; i++) {
        if (!subtract(f->runs + at, f->runs + last, wide, from->x0[i], from->x1[i], left)) {
            return 0;
        }
    }
    return 1;
}

// A run that the row below it does not carry alone.
static int is_carried(window *w, const sf_run *run)
{
    pieces both[2];
    int which = 0, reach = w->element->reach_y;
    both[0].count = 1;
    both[0].x0[0] = run->x0;
    both[0].x1[0] = run->x1;
    for (int d = 0; d <= reach; d++) {
        for (int side = 0; side < (d > 0 ? 2 : 1); side++) {
            if (!take_row(w, side == 0 ? d : -d, run->x0, &both[which], &both[1 - which])) {
                return 0;
            }
            which = 1 - which;
            if (both[which].count == 0) {
                return 1;
            }
        }
    }
    return 0;
}

int sfi_run_front_carries(const sfi_run_front *front, const sf_run *runs, size_t count,
                          const sf_element *element)
{
    window w = {.front = front, .element = element};
    uint32_t wide = element->half_width[0];
    for (size_t i = 0; i < count;) {
        uint32_t y = runs[i].y, at = front->rows[y], last = front->rows[y + 1];
        move_to(&w, y);
        // Mostly one run below covers it; the rest is asked of all rows.
        for (; i < count && runs[i].y == y; i++) {
            while (at < last && front->runs[at].x1 + wide < runs[i].x1) {
                at++;
            }
            if ((at == last || front->runs[at].x0 > runs[i].x0 + wide) &&
                !is_carried(&w, &runs[i])) {
                return 0;
            }
        }
    }
    return 1;
}
