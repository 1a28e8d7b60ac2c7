// SPDX-License-Identifier: MIT
// Leaving out half-spaces that others imply.
//
// A half-space is implied by others when the least value of its own normal over all of theirs is
// not below its offset: a linear programme with three unknowns. It is solved one constraint after
// the other: as long as the best point so far fulfils the next one, it stays the best; where it
// does not, the best lies on that plane, and is that of a programme with two unknowns among the
// constraints so far, and so on down. In a random order that is linear in their number. The order
// is shuffled by a fixed generator, so that the result is the same everywhere.
//
// Half-spaces are taken in stretches of 256, each together with what stayed so far: what a part of
// them implies, all imply. One is left out only where it is implied with room to spare, a billionth
// of the cube, which is more than rounding can do. So rounding leaves out none that is needed; that
// it keeps one that is not does no harm. Of copies one stays.
//
// Source: R. Seidel, "Small-Dimensional Linear Programming and Convex Hulls Made Easy", 1991.

#include "balance/stance/reduce.h"

#include "base/memory.h"

#include <math.h>
#include <string.h>

enum { STRETCH = 256, BOX = 6 };
#define ROUNDING 1e-12
#define ROOM 1e-9

// normal . x >= offset, in at most three unknowns.
typedef struct row {
    double normal[3], offset;
} row;

typedef struct programme {
    row *rows[4]; // rows[n]: constraints in n unknowns
} programme;

// ---------------------------------------------------------------------------------------------
// Programmes in one, two and three unknowns, each within the cube from -1 to 1
// ---------------------------------------------------------------------------------------------

static int solve_one(const row *rows, size_t count, const double goal[3], double x[3])
{
    double low = -INFINITY, high = INFINITY;
    for (size_t i = 0; i < count; i++) {
        double a = rows[i].normal[0], b = rows[i].offset;
        if (fabs(a) <= ROUNDING) {
            if (b > ROUNDING) {
                return 0;
            }
        } else if (a > 0) {
            low = b / a > low ? b / a : low;
        } else {
            high = b / a < high ? b / a : high;
        }
    }
    if (low > high + ROUNDING) {
        return 0;
    }
    x[0] = goal[0] >= 0 ? low : high;
    return 1;
}

// On the plane of a row, the unknown with its largest factor follows from the others: what another
// row is then, in one unknown less.
static row substitute(const row *r, const row *on, int unknowns, int gone)
{
    row made = {{0, 0, 0}, 0};
    double factor = r->normal[gone] / on->normal[gone];
    for (int i = 0, at = 0; i < unknowns; i++) {
        if (i != gone) {
            made.normal[at++] = r->normal[i] - factor * on->normal[i];
        }
    }
    made.offset = r->offset - factor * on->offset;
    return made;
}

// The least of goal . x over `count` rows, of which the first two for each unknown bound it to the
// cube. Returns 0 where no x fulfils all.
static int solve(programme *p, int unknowns, size_t count, const double goal[3], double x[3]);

// The rows before row `k` on the plane of that row, those of the cube first.
static void descend(programme *p, int unknowns, size_t k, int gone)
{
    const row *rows = p->rows[unknowns], *on = &rows[k];
    row *to = p->rows[unknowns - 1];
    size_t at = 0, cube = 2 * (size_t)unknowns, first = 2 * (size_t)gone;
    for (size_t i = 0; i < cube; i++) {
        if (i / 2 != (size_t)gone) {
            to[at++] = substitute(&rows[i], on, unknowns, gone);
        }
    }
    to[at++] = substitute(&rows[first], on, unknowns, gone);
    to[at++] = substitute(&rows[first + 1], on, unknowns, gone);
    for (size_t i = cube; i < k; i++) {
        to[at++] = substitute(&rows[i], on, unknowns, gone);
    }
}

// The least on the plane of row `k` among the rows before it.
static int solve_on(programme *p, int unknowns, size_t k, const double goal[3], double x[3])
{
    const row *on = &p->rows[unknowns][k];
    row aim = {{goal[0], goal[1], goal[2]}, 0};
    double less[3] = {0, 0, 0}, sum = on->offset;
    int gone = 0;
    for (int i = 1; i < unknowns; i++) {
        gone = fabs(on->normal[i]) > fabs(on->normal[gone]) ? i : gone;
    }
    if (fabs(on->normal[gone]) <= ROUNDING) {
        return 0; // 0 >= something that is more
    }
    descend(p, unknowns, k, gone);
    aim = substitute(&aim, on, unknowns, gone);
    int found = unknowns == 2 ? solve_one(p->rows[1], k, aim.normal, less)
                              : solve(p, unknowns - 1, k, aim.normal, less);
    for (int i = 0, at = 0; found && i < unknowns; i++) {
        if (i != gone) {
            x[i] = less[at++];
            sum -= on->normal[i] * x[i];
        }
    }
    x[gone] = sum / on->normal[gone];
    return found;
}

static int solve(programme *p, int unknowns, size_t count, const double goal[3], double x[3])
{
    for (int i = 0; i < unknowns; i++) {
        x[i] = goal[i] >= 0 ? -1 : 1;
    }
    for (size_t k = 2 * (size_t)unknowns; k < count; k++) {
        const row *r = &p->rows[unknowns][k];
        double value = -r->offset;
        for (int i = 0; i < unknowns; i++) {
            value += r->normal[i] * x[i];
        }
        if (value < -ROUNDING && !solve_on(p, unknowns, k, goal, x)) {
            return 0;
        }
    }
    return 1;
}

// ---------------------------------------------------------------------------------------------
// Half-spaces
// ---------------------------------------------------------------------------------------------

// A half-space in the cube's own measure.
static row row_of(const sf_halfspace *h, const double middle[3], double reach)
{
    row made = {{h->normal[0], h->normal[1], h->normal[2]}, h->offset_mm / reach};
    for (int i = 0; i < 3; i++) {
        made.offset -= h->normal[i] * middle[i] / reach;
    }
    return made;
}

static void bound_cube(row *rows)
{
    memset(rows, 0, BOX * sizeof *rows);
    for (int i = 0; i < BOX; i++) {
        rows[i].normal[i / 2] = i % 2 ? -1 : 1;
        rows[i].offset = -1;
    }
}

// A stretch of half-spaces, some of which are gone.
typedef struct stretch {
    row *rows;
    uint32_t *order; // of asking and of being asked
    uint8_t *is_gone;
    size_t count;
} stretch;

// xorshift (G. Marsaglia, 2003), from the same start each time.
static void shuffle(stretch *s)
{
    uint32_t state = 2463534242u;
    for (size_t i = 0; i < s->count; i++) {
        s->order[i] = (uint32_t)i;
        state ^= state << 13;
        state ^= state >> 17;
        state ^= state << 5;
        size_t j = state % (i + 1);
        uint32_t kept = s->order[i];
        s->order[i] = s->order[j];
        s->order[j] = kept;
    }
}

// Mark all but one of those that are the same but for rounding.
static void mark_copies(stretch *s)
{
    for (size_t i = 0; i < s->count; i++) {
        for (size_t j = 0; j < i && !s->is_gone[i]; j++) {
            const row *a = &s->rows[i], *b = &s->rows[j];
            double apart = fabs(a->offset - b->offset);
            for (int d = 0; d < 3; d++) {
                apart += fabs(a->normal[d] - b->normal[d]);
            }
            s->is_gone[i] = !s->is_gone[j] && apart <= ROUNDING;
        }
    }
}

// Mark what the others that are left imply.
static void mark_implied(programme *p, stretch *s)
{
    for (size_t i = 0; i < s->count; i++) {
        const row *asked = &s->rows[s->order[i]];
        size_t count = BOX;
        double x[3];
        if (s->is_gone[s->order[i]]) {
            continue;
        }
        bound_cube(p->rows[3]);
        for (size_t j = 0; j < s->count; j++) {
            if (j != i && !s->is_gone[s->order[j]]) {
                p->rows[3][count++] = s->rows[s->order[j]];
            }
        }
        if (!solve(p, 3, count, asked->normal, x)) {
            return; // nothing is in all of them, so there is nothing to be said
        }
        double least = x[0] * asked->normal[0] + x[1] * asked->normal[1] + x[2] * asked->normal[2];
        s->is_gone[s->order[i]] = least >= asked->offset + ROOM;
    }
}

static int allocate(programme *p, stretch *s, size_t most, const sf_allocator *allocator)
{
    int good = 1;
    for (int n = 1; n < 4; n++) {
        p->rows[n] = sfi_alloc_array(allocator, most + BOX, sizeof(row));
        good = good && p->rows[n] != NULL;
    }
    s->rows = sfi_alloc_array(allocator, most, sizeof *s->rows);
    s->order = sfi_alloc_array(allocator, most, sizeof *s->order);
    s->is_gone = sfi_alloc_array(allocator, most, sizeof *s->is_gone);
    return good && s->rows != NULL && s->order != NULL && s->is_gone != NULL;
}

static void release(programme *p, stretch *s, size_t most, const sf_allocator *allocator)
{
    for (int n = 1; n < 4; n++) {
        sfi_free_array(allocator, p->rows[n], most + BOX, sizeof(row));
    }
    sfi_free_array(allocator, s->rows, most, sizeof *s->rows);
    sfi_free_array(allocator, s->order, most, sizeof *s->order);
    sfi_free_array(allocator, s->is_gone, most, sizeof *s->is_gone);
}

sf_status sfi_halfspaces_reduce(sf_halfspace *list, size_t count, const double middle[3],
                                double reach, const sf_allocator *allocator, size_t *kept)
{
    programme p = {{NULL, NULL, NULL, NULL}};
    stretch s = {NULL, NULL, NULL, 0};
    size_t stay = 0;
    if (!allocate(&p, &s, count, allocator)) {
        release(&p, &s, count, allocator);
        return SF_ERR_MEMORY;
    }
    for (size_t next = 0; next < count;) {
        for (s.count = 0; s.count < stay; s.count++) {
            s.rows[s.count] = row_of(&list[s.count], middle, reach);
        }
        size_t end = count - next < STRETCH ? count : next + STRETCH;
        memmove(list + stay, list + next, (end - next) * sizeof *list);
        for (; s.count < stay + (end - next); s.count++) {
            s.rows[s.count] = row_of(&list[s.count], middle, reach);
        }
        memset(s.is_gone, 0, s.count);
        mark_copies(&s);
        shuffle(&s);
        mark_implied(&p, &s);
        stay = 0;
        for (size_t i = 0; i < s.count; i++) {
            if (!s.is_gone[i]) {
                list[stay++] = list[i];
            }
        }
        next = end;
    }
    release(&p, &s, count, allocator);
    *kept = stay;
    return SF_OK;
}
