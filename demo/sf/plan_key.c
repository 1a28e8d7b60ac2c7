// SPDX-License-Identifier: MIT
// What the marks of a plan mean: a mark and its words after the other, in as many rows as it takes.
// It has room of its own, so that it covers nothing.

#include "plan_key.h"

#include <stddef.h>

enum { SIDE = 4 };

static const colour ink = {60, 64, 70};

static int row_height(int size)
{
    return 7 * size / 4;
}

static int entry_width(const plan_key *k, int mark, int size)
{
    return 4 * size + canvas_text_width(size, k->words[mark]);
}

static void draw_mark(plan_mark mark, int x, int y, double unit, canvas *picture)
{
    int reach = (int)(MARKS_REACH * unit) + 1;
    for (int i = -reach; i <= reach; i++) {
        for (int j = -reach; j <= reach; j++) {
            double sum[3] = {0, 0, 0};
            for (int s = 0; s < SIDE * SIDE; s++) {
                const double *found = marks_colour(mark, (j - 0.5 + (s % SIDE + 0.5) / SIDE) / unit,
                                                   (i - 0.5 + (s / SIDE + 0.5) / SIDE) / unit);
                for (int c = 0; c < 3; c++) {
                    sum[c] += (found != NULL ? found[c] : 1) / (SIDE * SIDE);
                }
            }
            colour mixed = {(uint8_t)(255 * sum[0] + 0.5), (uint8_t)(255 * sum[1] + 0.5),
                            (uint8_t)(255 * sum[2] + 0.5)};
            canvas_fill(picture, x + j, y + i, x + j + 1, y + i + 1, mixed);
        }
    }
}

// Where each entry goes; returns the number of rows.
static int lay_out(const plan_key *k, int size, int width, int column[MARK_COUNT],
                   int row[MARK_COUNT])
{
    int rows = 1, x = size;
    for (int i = 0; i < MARK_COUNT; i++) {
        int wide = k->words[i] != NULL ? entry_width(k, i, size) : 0;
        if (x > size && x + wide - size > width) {
            x = size;
            rows++;
        }
        column[i] = x;
        row[i] = rows - 1;
        x += wide;
    }
    return rows;
}

int key_height(const plan_key *k, int size, int width)
{
    int column[MARK_COUNT], row[MARK_COUNT];
    return lay_out(k, size, width, column, row) * row_height(size) + size / 2;
}

void key_draw(const plan_key *k, int size, double unit, canvas *picture)
{
    int column[MARK_COUNT], row[MARK_COUNT], width = (int)picture->width;
    int top = (int)picture->height - key_height(k, size, width);
    (void)lay_out(k, size, width, column, row);
    for (int i = 0; i < MARK_COUNT; i++) {
        int x = column[i], y = top + row[i] * row_height(size) + row_height(size) / 2;
        if (k->words[i] != NULL) {
            draw_mark((plan_mark)i, x + size / 2, y, unit, picture);
            canvas_text(picture, x + 7 * size / 4, y + size * 3 / 8, size, TEXT_LEFT, ink,
                        k->words[i]);
        }
    }
}
