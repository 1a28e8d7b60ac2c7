// SPDX-License-Identifier: MIT
// Rulers: where ticks stand, and what numbers and units say beside them.
//
// Ticks stand at whole multiples of 1, 2 or 5 times a power of ten, the smallest step at which the
// numbers below keep apart. A letter is about half as wide as high, which is all that is asked of
// the font.

#include "ruler.h"

#include "legend.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const colour ink = {40, 40, 40};

// The number that a tick shows; a step's own rounding is not shown as one.
static void write_number(double value, double step, char words[32])
{
    snprintf(words, 32, "%.6g", fabs(value) < 1e-6 * step ? 0.0 : value);
}

// The smallest round step above a length.
static double round_up(double least)
{
    double step = legend_round_length(least);
    static const double more[] = {1, 2, 2.5, 4, 5, 10};
    for (size_t i = 0; i < sizeof more / sizeof more[0]; i++) {
        double made = legend_round_length(step * more[i] * (1 + 1e-9));
        if (made >= least) {
            return made;
        }
    }
    return 10 * step;
}

// How wide the widest number is, in pixels.
static int widest(const ruler *r, int size)
{
    char words[32];
    double step = legend_round_length((r->high - r->low) / 2), most = 0;
    for (double v = ceil(r->low / step) * step; v <= r->high; v += step / 2) {
        write_number(v, step, words);
        most = fmax(most, (double)strlen(words));
    }
    return (int)((most + 2) * 0.6 * size);
}

void ruler_draw(const ruler *r, int y, int size, const char *unit, canvas *to)
{
    double span = r->high - r->low;
    int thick = size / 10 < 1 ? 1 : size / 10, tick = size / 2;
    if (!(span > 0) || r->width < 1) {
        return;
    }
    double step = round_up(span * widest(r, size) / r->width);
    double first = ceil(r->low / step - 1e-9), last = floor(r->high / step + 1e-9);
    canvas_fill(to, r->left, y, r->left + r->width, y + thick, ink);
    for (double i = first; i <= last; i += 1) {
        char words[32];
        int x = r->left + (int)((i * step - r->low) / span * (r->width - thick) + 0.5);
        write_number(i * step, step, words);
        canvas_fill(to, x, y, x + thick, y + tick, ink);
        canvas_text(to, x, y + tick + size, size, TEXT_CENTRE, ink,
                    unit != NULL && i == last && last > first ? unit : words);
    }
}

const char *ruler_unit(const sf_property *property, char words[RULER_UNIT_SIZE])
{
    static const char *const names[7] = {"m", "kg", "s", "A", "K", "mol", "cd"};
    static const int8_t pascal[7] = {-1, 1, -2, 0, 0, 0, 0};
    size_t used = 0;
    int above = 0;
    words[0] = '\0';
    if (memcmp(property->si, pascal, sizeof pascal) == 0) {
        return strcpy(words, "Pa");
    }
    for (int below = 0; below < 2; below++) {
        for (int i = 0; i < 7; i++) {
            int power = below ? -property->si[i] : property->si[i];
            if (power <= 0 || used + 12 > RULER_UNIT_SIZE) {
                continue;
            }
            const char *joint = below      ? (above == 0 && used == 0 ? "1/" : "/")
                                : used > 0 ? " "
                                           : "";
            used += (size_t)snprintf(words + used, RULER_UNIT_SIZE - used, "%s%s", joint, names[i]);
            if (power > 1) {
                used += (size_t)snprintf(words + used, RULER_UNIT_SIZE - used, "^%d", power);
            }
            above += !below;
        }
    }
    return words;
}
