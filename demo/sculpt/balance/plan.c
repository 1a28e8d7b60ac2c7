// SPDX-License-Identifier: MIT
// Plans: what a person has asked for, before and after each change.
//
// A plan is small, so whole ones are kept. What rounds have made of it is not: it is computed anew.

#include <string.h>

#include "balance.h"

static void push(balance_plan *list, size_t *count, const balance_plan *plan)
{
    if (*count == BALANCE_UNDO_MAX) {
        memmove(list, list + 1, (BALANCE_UNDO_MAX - 1) * sizeof *list);
        (*count)--;
    }
    list[(*count)++] = *plan;
}

void balance_remember(balance *b, int setting)
{
    if (setting >= 0 && setting == b->last_setting) {
        return;
    }
    push(b->undo, &b->state.undo_count, &b->state.plan);
    b->state.redo_count = 0;
    b->last_setting = setting;
}

static void go(balance *b, balance_plan *from, size_t *from_count, balance_plan *to,
               size_t *to_count)
{
    if (*from_count == 0) {
        return;
    }
    push(to, to_count, &b->state.plan);
    b->state.plan = from[--*from_count];
    b->last_setting = -1;
    b->state.selected = b->state.hovered = -1;
    b->is_dragging = 0;
    balance_drop(b);
    (void)balance_place(b);
}

void balance_undo(balance *b)
{
    go(b, b->undo, &b->state.undo_count, b->redo, &b->state.redo_count);
}

void balance_redo(balance *b)
{
    go(b, b->redo, &b->state.redo_count, b->undo, &b->state.undo_count);
}

void balance_forget(balance *b)
{
    b->state.undo_count = b->state.redo_count = 0;
    b->last_setting = -1;
}
