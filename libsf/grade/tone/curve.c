// SPDX-License-Identifier: MIT
// Monotone curves through measurements, and the way back.
//
// Falling curves are kept upside down, as rising ones with `sign` -1. Sorted samples of distinct x
// are pooled: a block of neighbours that fall becomes their weighted mean, until no block is above
// the next. That is the rising sequence of least squares.
//
// Between knots goes the cubic of Hermite. With d the slope of a segment's chord and m, n those of
// its ends, it is monotone if (m/d)^2 + (n/d)^2 <= 9; steeper ends are scaled back to that circle.
//
// Backwards, the segment is found among the knots' values, which rise strictly across it, and the
// place in it by Newton's steps that fall back on halving whenever they leave what is known to hold
// it.
//
// Source: M. Ayer and others, "An empirical distribution function for sampling with incomplete
// information", 1955; F. N. Fritsch, R. E. Carlson, "Monotone piecewise cubic interpolation", 1980.

#include <sf/mixture.h>

#include "base/memory.h"
#include "base/status.h"

#include <math.h>
#include <string.h>

#define LARGEST 1e100

typedef struct knot {
    double x, y, slope;
} knot;

struct sf_curve {
    knot *knots;
    size_t count;
    double sign; // of y
    double change;
    sf_allocator allocator;
};

// ---------------------------------------------------------------------------------------------
// Samples
// ---------------------------------------------------------------------------------------------

static int samples_are_good(const sf_curve_sample *samples, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        if (!(fabs(samples[i].x) < LARGEST && fabs(samples[i].y) < LARGEST &&
              samples[i].weight > 0.0 && samples[i].weight < LARGEST)) {
            return 0;
        }
    }
    return 1;
}

static int comes_before(const sf_curve_sample *a, const sf_curve_sample *b)
{
    return a->x < b->x ||
           (a->x == b->x && (a->y < b->y || (a->y == b->y && a->weight < b->weight)));
}

// J. W. J. Williams, "Algorithm 232: Heapsort", 1964. Equal samples are the same bytes, so the
// result does not depend on their order.
static void sift(sf_curve_sample *s, size_t root, size_t count)
{
    sf_curve_sample moved = s[root];
    for (size_t child = 2 * root + 1; child < count; child = 2 * root + 1) {
        child += child + 1 < count && comes_before(&s[child], &s[child + 1]);
        if (!comes_before(&moved, &s[child])) {
            break;
        }
        s[root] = s[child];
        root = child;
    }
    s[root] = moved;
}

static void sort(sf_curve_sample *s, size_t count)
{
    for (size_t i = count / 2; i-- > 0;) {
        sift(s, i, count);
    }
    for (size_t end = count; end > 1; end--) {
        sf_curve_sample largest = s[0];
        s[0] = s[end - 1];
        s[end - 1] = largest;
        sift(s, 0, end - 1);
    }
}

// Sorted samples of equal x become one. Returns how many are left.
static size_t merge_equal(sf_curve_sample *s, size_t count)
{
    size_t kept = 0;
    for (size_t i = 0; i < count; i++) {
        if (kept > 0 && s[kept - 1].x == s[i].x) {
            double weight = s[kept - 1].weight + s[i].weight;
            s[kept - 1].y += (s[i].y - s[kept - 1].y) * (s[i].weight / weight);
            s[kept - 1].weight = weight;
        } else {
            s[kept++] = s[i];
        }
    }
    return kept;
}

// A block of pooled samples.
typedef struct block {
    double mean, weight;
    size_t count;
} block;

// The rising values closest to sign * y, into the knots. Returns the sum of squared changes.
static double pool(const sf_curve_sample *s, size_t count, double sign, block *blocks, knot *knots)
{
    size_t used = 0, at = 0;
    double sum = 0.0;
    for (size_t i = 0; i < count; i++) {
        block b = {sign * s[i].y, s[i].weight, 1};
        while (used > 0 && blocks[used - 1].mean >= b.mean) {
            const block *before = &blocks[--used];
            double weight = before->weight + b.weight;
            b.mean = before->mean + (b.mean - before->mean) * (b.weight / weight);
            b.weight = weight;
            b.count += before->count;
        }
        blocks[used++] = b;
    }
    for (size_t i = 0; i < used; i++) {
        for (size_t k = 0; k < blocks[i].count; k++, at++) {
            double change = blocks[i].mean - sign * s[at].y;
            knot made = {s[at].x, blocks[i].mean, 0.0};
            knots[at] = made;
            sum += s[at].weight * change * change;
        }
    }
    return sum;
}

// ---------------------------------------------------------------------------------------------
// Slopes
// ---------------------------------------------------------------------------------------------

static double chord(const knot *k)
{
    return (k[1].y - k[0].y) / (k[1].x - k[0].x);
}

static void set_slopes(knot *k, size_t count)
{
    k[0].slope = chord(k);
    k[count - 1].slope = chord(k + count - 2);
    for (size_t i = 1; i + 1 < count; i++) {
        k[i].slope = 0.5 * (chord(k + i - 1) + chord(k + i));
    }
    for (size_t i = 0; i + 1 < count; i++) {
        double d = chord(k + i);
        if (!(d > 0.0)) {
            k[i].slope = k[i + 1].slope = 0.0;
            continue;
        }
        double a = k[i].slope / d, b = k[i + 1].slope / d, r = a * a + b * b;
        if (r > 9.0) {
            double scale = 3.0 / sqrt(r);
            k[i].slope = scale * a * d;
            k[i + 1].slope = scale * b * d;
        }
    }
}

// ---------------------------------------------------------------------------------------------
// Making and freeing
// ---------------------------------------------------------------------------------------------

typedef struct scratch {
    sf_curve_sample *samples;
    block *blocks;
} scratch;

static void fit(sf_curve *c, const sf_curve_sample *s, size_t count, sf_trend trend, block *blocks)
{
    double rising = pool(s, count, 1.0, blocks, c->knots);
    double falling = pool(s, count, -1.0, blocks, c->knots);
    int falls = trend == SF_TREND_FALLING || (trend == SF_TREND_AUTO && falling < rising);
    c->sign = falls ? -1.0 : 1.0;
    c->count = count;
    pool(s, count, c->sign, blocks, c->knots);
    set_slopes(c->knots, count);
    for (size_t i = 0; i < count; i++) {
        double change = fabs(c->knots[i].y - c->sign * s[i].y);
        c->change = change > c->change ? change : c->change;
    }
}

static sf_status make(const sf_curve_sample *samples, size_t count, sf_trend trend,
                      const sf_allocator *a, scratch *t, sf_curve **curve)
{
    t->samples = sfi_alloc_array(a, count, sizeof *t->samples);
    t->blocks = sfi_alloc_array(a, count, sizeof *t->blocks);
    if (t->samples == NULL || t->blocks == NULL) {
        return SF_ERR_MEMORY;
    }
    memcpy(t->samples, samples, count * sizeof *samples);
    sort(t->samples, count);
    size_t distinct = merge_equal(t->samples, count);
    if (distinct < 2) {
        return SF_ERR_ARGUMENT;
    }
    sf_curve *c = sfi_alloc_array(a, 1, sizeof *c);
    if (c == NULL) {
        return SF_ERR_MEMORY;
    }
    memset(c, 0, sizeof *c);
    c->allocator = *a;
    c->knots = sfi_alloc_array(a, distinct, sizeof *c->knots);
    if (c->knots == NULL) {
        sfi_free_array(a, c, 1, sizeof *c);
        return SF_ERR_MEMORY;
    }
    fit(c, t->samples, distinct, trend, t->blocks);
    *curve = c;
    return SF_OK;
}

sf_status sf_curve_create(const sf_curve_sample *samples, size_t count, sf_trend trend,
                          const sf_allocator *allocator, sf_curve **curve)
{
    sf_allocator a = sfi_allocator_or_default(allocator);
    scratch t = {NULL, NULL};
    if (samples == NULL || curve == NULL || count < 2 ||
        (unsigned)trend > (unsigned)SF_TREND_FALLING) {
        return SF_ERR_ARGUMENT;
    }
    if (count > SF_CURVE_SAMPLE_MAX) {
        return SF_ERR_OVERFLOW;
    }
    if (!samples_are_good(samples, count)) {
        return SF_ERR_ARGUMENT;
    }
    sf_status status = make(samples, count, trend, &a, &t, curve);
    sfi_free_array(&a, t.samples, count, sizeof *t.samples);
    sfi_free_array(&a, t.blocks, count, sizeof *t.blocks);
    return status;
}

void sf_curve_destroy(sf_curve *curve)
{
    if (curve != NULL) {
        sf_allocator a = curve->allocator;
        sfi_free_array(&a, curve->knots, curve->count, sizeof *curve->knots);
        sfi_free_array(&a, curve, 1, sizeof *curve);
    }
}

double sf_curve_change(const sf_curve *curve)
{
    return curve != NULL ? curve->change : 0.0;
}

// ---------------------------------------------------------------------------------------------
// Forwards and backwards
// ---------------------------------------------------------------------------------------------

// The cubic between k[0] and k[1] at a fraction of the way, its derivative by that fraction too.
static double hermite(const knot *k, double t, double *derivative)
{
    double width = k[1].x - k[0].x, rise = k[1].y - k[0].y;
    double m = k[0].slope * width, n = k[1].slope * width;
    // y0 + t (m + t ((3 rise - 2 m - n) + t (m + n - 2 rise)))
    double b = 3.0 * rise - 2.0 * m - n, c = m + n - 2.0 * rise;
    *derivative = m + t * (2.0 * b + t * (3.0 * c));
    return k[0].y + t * (m + t * (b + t * c));
}

// The last knot but one at most whose x (or y) is at most v.
static size_t segment_of(const sf_curve *c, double v, int by_y)
{
    size_t low = 0, high = c->count - 1;
    while (high - low > 1) {
        size_t middle = low + (high - low) / 2;
        const knot *k = &c->knots[middle];
        if (by_y ? k->y < v : k->x <= v) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return low;
}

static double value_at(const sf_curve *c, double x, double *slope)
{
    const knot *first = c->knots, *last = c->knots + c->count - 1;
    *slope = 0.0;
    if (x < first->x || x > last->x) {
        return x < first->x ? first->y : last->y;
    }
    const knot *k = c->knots + segment_of(c, x, 0);
    double derivative, t = (x - k[0].x) / (k[1].x - k[0].x);
    double y = hermite(k, t, &derivative);
    *slope = derivative / (k[1].x - k[0].x);
    return y;
}

sf_status sf_curve_value(const sf_curve *curve, double x, double *y, double *slope)
{
    if (curve == NULL || y == NULL || !(x == x)) {
        return SF_ERR_ARGUMENT;
    }
    double along;
    *y = curve->sign * value_at(curve, x, &along);
    if (slope != NULL) {
        *slope = curve->sign * along;
    }
    return SF_OK;
}

// Where between two knots, of which the first is below y and the second is not, y is reached.
static double place_between(const knot *k, double y)
{
    double low = 0.0, high = 1.0, t = (y - k[0].y) / (k[1].y - k[0].y);
    for (int i = 0; i < 80 && low < high; i++) {
        double derivative, miss = hermite(k, t, &derivative) - y;
        if (miss == 0.0) {
            return t;
        }
        if (miss > 0.0) {
            high = t;
        } else {
            low = t;
        }
        double next = derivative > 0.0 ? t - miss / derivative : low;
        if (!(next > low && next < high)) {
            next = low + 0.5 * (high - low);
        }
        if (fabs(next - t) < 1e-16) {
            return next;
        }
        t = next;
    }
    return t;
}

sf_status sf_curve_inverse(const sf_curve *curve, double y, double *x, double *miss)
{
    if (curve == NULL || x == NULL || !(y == y)) {
        return SF_ERR_ARGUMENT;
    }
    const knot *first = curve->knots, *last = curve->knots + curve->count - 1;
    double wanted = curve->sign * y, at, unused;
    if (wanted <= first->y) {
        at = first->x;
    } else if (wanted > last->y) {
        // The first of those that share the largest value.
        const knot *k = last;
        while (k > first && k[-1].y == last->y) {
            k--;
        }
        at = k->x;
    } else {
        const knot *k = curve->knots + segment_of(curve, wanted, 1);
        at = k[0].x + place_between(k, wanted) * (k[1].x - k[0].x);
    }
    *x = at;
    if (miss != NULL) {
        *miss = curve->sign * value_at(curve, at, &unused) - y;
    }
    return SF_OK;
}
