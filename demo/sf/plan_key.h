// SPDX-License-Identifier: MIT
// What the marks of a plan mean: rows at the bottom of a picture.

#ifndef DEMO_SF_PLAN_KEY_H
#define DEMO_SF_PLAN_KEY_H

#include "canvas.h"
#include "plan_marks.h"

// Words for each mark, or NULL where it is not in the picture.
typedef struct plan_key {
    const char *words[MARK_COUNT];
} plan_key;

// Rows of pixels that it takes at the bottom of a picture of a width, in words of a size.
int key_height(const plan_key *k, int size, int width);

// Draw it; marks are as large as `unit` pixels make them.
void key_draw(const plan_key *k, int size, double unit, canvas *picture);

#endif
