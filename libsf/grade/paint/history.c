// SPDX-License-Identifier: MIT
// Undoing what was done to a cage.
//
// A cage is edited by many calls, and cages are small, so nobody is asked to announce an edit: the
// history keeps a copy of all numbers and finds by comparison what a step changed. A step is a list
// of runs, each of an array (positions, or a property's values), the first number, how many, and
// the numbers themselves as they were. To undo, they are exchanged with those of the cage, which
// makes the same block the one that redoes.
//
// Bits are compared and copied, not values, so that a zero keeps its sign. Numbers that come back
// were in the cage before, so that nothing has to be checked again.

#include <sf/cage_history.h>

#include "base/history.h"
#include "base/memory.h"
#include "base/status.h"
#include "grade/cage/cage.h"

#include <string.h>

// A run ends where so many numbers are as they were: as many as its head is long.
enum { GAP = 3, ARRAYS = SF_PROPERTY_MAX + 1 };

// What stands before the numbers of a run.
typedef struct run {
    uint64_t array, first, count;
} run;

// Numbers of the cage, as they were.
typedef struct watched {
    uint8_t uuid[16]; // of a property
    size_t count;
    double *numbers;
} watched;

struct sf_cage_history {
    sf_allocator allocator;
    sfi_history steps;
    size_t points;
    size_t array_count;
    watched arrays[ARRAYS]; // positions, then properties
};

// ---------------------------------------------------------------------------------------------
// The cage as arrays
// ---------------------------------------------------------------------------------------------

static size_t count_of(const sf_cage *cage, size_t array)
{
    return array == 0 ? 3 * (size_t)cage->points : cage->channels.at[array - 1].value_count;
}

static const double *numbers_of(const sf_cage *cage, size_t array)
{
    return array == 0 ? cage->positions : cage->channels.at[array - 1].values;
}

static int is_its_cage(const sf_cage_history *h, const sf_cage *cage)
{
    if (cage->points != h->points || cage->channels.count + 1 < h->array_count) {
        return 0;
    }
    for (size_t i = 1; i < h->array_count; i++) {
        if (memcmp(cage->channels.at[i - 1].property.uuid, h->arrays[i].uuid, 16) != 0 ||
            count_of(cage, i) != h->arrays[i].count) {
            return 0;
        }
    }
    return 1;
}

static void release(const sf_allocator *allocator, watched *arrays, size_t first, size_t last)
{
    for (size_t i = first; i < last; i++) {
        sfi_free_array(allocator, arrays[i].numbers, arrays[i].count, sizeof(double));
    }
}

// Copy arrays from `first` on, to be watched.
static sf_status watch(const sf_allocator *allocator, const sf_cage *cage, size_t first,
                       watched *arrays)
{
    for (size_t i = first; i <= cage->channels.count; i++) {
        memset(&arrays[i], 0, sizeof arrays[i]);
        arrays[i].count = count_of(cage, i);
        if (i > 0) {
            memcpy(arrays[i].uuid, cage->channels.at[i - 1].property.uuid, 16);
        }
        if (!sfi_copy_array(allocator, numbers_of(cage, i), arrays[i].count, sizeof(double),
                            (void **)&arrays[i].numbers)) {
            release(allocator, arrays, first, i);
            return SF_ERR_MEMORY;
        }
    }
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Steps
// ---------------------------------------------------------------------------------------------

static int differs(const double *a, const double *b)
{
    return memcmp(a, b, sizeof *a) != 0;
}

// The next run at or behind `first`; its count is 0 where there is none.
static run next_run(const double *was, const double *is, size_t array, size_t first, size_t count)
{
    while (first < count && !differs(was + first, is + first)) {
        first++;
    }
    run found = {array, first, 0};
    size_t last = first;
    for (size_t i = first; i < count && i - last <= GAP; i++) {
        if (differs(was + i, is + i)) {
            found.count = i + 1 - first;
            last = i;
        }
    }
    return found;
}

// Bytes of the step from what was to what is, written to `to` unless it is NULL.
static size_t write_step(const sf_cage_history *h, const sf_cage *cage, unsigned char *to,
                         size_t *changed)
{
    size_t size = 0;
    *changed = 0;
    for (size_t array = 0; array < h->array_count; array++) {
        const watched *w = &h->arrays[array];
        const double *is = numbers_of(cage, array);
        for (run r = next_run(w->numbers, is, array, 0, w->count); r.count > 0;
             r = next_run(w->numbers, is, array, r.first + r.count, w->count)) {
            size_t bytes = (size_t)r.count * sizeof(double);
            if (to != NULL) {
                memcpy(to + size, &r, sizeof r);
                memcpy(to + size + sizeof r, w->numbers + r.first, bytes);
            }
            for (size_t i = r.first; i < r.first + r.count; i++) {
                *changed += (size_t)differs(w->numbers + i, is + i);
            }
            size += sizeof r + bytes;
        }
    }
    return size;
}

// Exchange the numbers of a step with those that are there; both cage and copy get them.
static size_t exchange(sf_cage_history *h, sf_cage *cage, const sfi_step *step)
{
    size_t changed = 0;
    for (size_t at = 0; at < step->size;) {
        run r;
        unsigned char *bytes = step->bytes;
        memcpy(&r, bytes + at, sizeof r);
        at += sizeof r;
        double *is = (double *)numbers_of(cage, (size_t)r.array) + r.first;
        double *copy = h->arrays[r.array].numbers + r.first;
        for (size_t i = 0; i < r.count; i++, at += sizeof(double)) {
            changed += memcmp(copy + i, bytes + at, sizeof(double)) != 0;
            memcpy(is + i, bytes + at, sizeof(double));
            memcpy(bytes + at, copy + i, sizeof(double));
            memcpy(copy + i, is + i, sizeof(double));
        }
    }
    return changed;
}

// ---------------------------------------------------------------------------------------------
// The interface
// ---------------------------------------------------------------------------------------------

sf_status sf_cage_history_create(const sf_cage *cage, size_t bytes_max,
                                 const sf_allocator *allocator, sf_cage_history **history)
{
    if (cage == NULL || history == NULL) {
        return SF_ERR_ARGUMENT;
    }
    sf_allocator kept = sfi_allocator_or_default(allocator);
    sf_cage_history *made = sfi_alloc_array(&kept, 1, sizeof *made);
    if (made == NULL) {
        return SF_ERR_MEMORY;
    }
    memset(made, 0, sizeof *made);
    made->allocator = kept;
    made->points = cage->points;
    sf_status status = watch(&kept, cage, 0, made->arrays);
    if (status != SF_OK) {
        sfi_free_array(&kept, made, 1, sizeof *made);
        return status;
    }
    made->array_count = cage->channels.count + 1;
    sfi_history_begin(bytes_max, &kept, &made->steps);
    *history = made;
    return SF_OK;
}

void sf_cage_history_destroy(sf_cage_history *history)
{
    if (history == NULL) {
        return;
    }
    sf_allocator allocator = history->allocator;
    sfi_history_end(&history->steps);
    release(&allocator, history->arrays, 0, history->array_count);
    sfi_free_array(&allocator, history, 1, sizeof *history);
}

sf_status sf_cage_history_record(sf_cage_history *history, const sf_cage *cage, size_t *changed)
{
    if (history == NULL || cage == NULL) {
        return SF_ERR_ARGUMENT;
    }
    if (!is_its_cage(history, cage)) {
        return SF_ERR_SHAPE;
    }
    size_t count = 0, size = write_step(history, cage, NULL, &count);
    void *bytes = NULL;
    SF_TRY(watch(&history->allocator, cage, history->array_count, history->arrays));
    sf_status status = size > 0 ? sfi_history_add(&history->steps, size, &bytes) : SF_OK;
    if (status != SF_OK) {
        release(&history->allocator, history->arrays, history->array_count,
                cage->channels.count + 1);
        return status;
    }
    if (bytes != NULL) {
        (void)write_step(history, cage, bytes, &count);
    }
    for (size_t i = 0; size > 0 && i < history->array_count; i++) {
        memcpy(history->arrays[i].numbers, numbers_of(cage, i),
               history->arrays[i].count * sizeof(double));
    }
    history->array_count = cage->channels.count + 1;
    if (changed != NULL) {
        *changed = count;
    }
    return SF_OK;
}

static sf_status take(sf_cage_history *history, sf_cage *cage,
                      const sfi_step *(*next)(sfi_history *), size_t *changed)
{
    SF_TRY(sf_cage_history_record(history, cage, NULL));
    const sfi_step *step = next(&history->steps);
    size_t count = step != NULL ? exchange(history, cage, step) : 0;
    if (changed != NULL) {
        *changed = count;
    }
    return SF_OK;
}

sf_status sf_cage_history_undo(sf_cage_history *history, sf_cage *cage, size_t *changed)
{
    return take(history, cage, sfi_history_back, changed);
}

sf_status sf_cage_history_redo(sf_cage_history *history, sf_cage *cage, size_t *changed)
{
    return take(history, cage, sfi_history_forth, changed);
}

sf_cage_history_state sf_cage_history_get_state(const sf_cage_history *history)
{
    sf_cage_history_state state = {0, 0, 0};
    if (history != NULL) {
        state.undo_count = history->steps.done;
        state.redo_count = history->steps.count - history->steps.done;
        state.bytes = history->steps.bytes;
    }
    return state;
}
