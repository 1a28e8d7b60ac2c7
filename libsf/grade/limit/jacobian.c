// SPDX-License-Identifier: MIT
// The determinant of a spline's derivatives, bounded.
//
// Over a cell a spline is a polynomial, its derivatives are, and the determinant of these is one of
// degree 8 along each axis. In Bernstein's basis a polynomial lies between its least and its
// greatest coefficient. There products are convolutions, once each coefficient is multiplied by its
// binomial.

#include "grade/limit/jacobian.h"

#include <string.h>

enum { SLOPE = 3 * 4 * 4, CROSS = 7 * 6 * 6, MOST = 9 * 9 * 9 };

// Coefficients times their binomials; x fastest.
typedef struct polynomial {
    uint32_t counts[3]; // along each axis: degree + 1
    double *c;
} polynomial;

static const double binomials[9][9] = {{1},
                                       {1, 1},
                                       {1, 2, 1},
                                       {1, 3, 3, 1},
                                       {1, 4, 6, 4, 1},
                                       {1, 5, 10, 10, 5, 1},
                                       {1, 6, 15, 20, 15, 6, 1},
                                       {1, 7, 21, 35, 35, 21, 7, 1},
                                       {1, 8, 28, 56, 70, 56, 28, 8, 1}};

static size_t place(const polynomial *p, uint32_t x, uint32_t y, uint32_t z)
{
    return x + (size_t)p->counts[0] * (y + (size_t)p->counts[1] * z);
}

// The factor of the coefficient at a place.
static double factor(const polynomial *p, uint32_t x, uint32_t y, uint32_t z)
{
    return binomials[p->counts[0] - 1][x] * binomials[p->counts[1] - 1][y] *
           binomials[p->counts[2] - 1][z];
}

// One coordinate of the spline's 64 points as Bernstein coefficients, axis by axis.
static void to_bernstein(const sfi_spline *spline, uint32_t coordinate, double b[64])
{
    for (uint32_t i = 0; i < 64; i++) {
        b[i] = spline->rest[3 * i + coordinate];
    }
    for (uint32_t axis = 0; axis < 3; axis++) {
        uint32_t step = 1u << 2 * axis;
        for (uint32_t i = 0; i < 64; i++) {
            if ((i >> 2 * axis & 3) == 0) {
                double p = b[i], q = b[i + step], r = b[i + 2 * step], s = b[i + 3 * step];
                b[i] = (p + 4 * q + r) / 6;
                b[i + step] = (4 * q + 2 * r) / 6;
                b[i + 2 * step] = (2 * q + 4 * r) / 6;
                b[i + 3 * step] = (q + 4 * r + s) / 6;
            }
        }
    }
}

static void derive(const double b[64], uint32_t axis, polynomial *d)
{
    uint32_t step = 1u << 2 * axis;
    for (uint32_t i = 0; i < 3; i++) {
        d->counts[i] = i == axis ? 3 : 4;
    }
    for (uint32_t z = 0; z < d->counts[2]; z++) {
        for (uint32_t y = 0; y < d->counts[1]; y++) {
            for (uint32_t x = 0; x < d->counts[0]; x++) {
                uint32_t i = x + 4 * y + 16 * z;
                d->c[place(d, x, y, z)] = 3 * (b[i + step] - b[i]) * factor(d, x, y, z);
            }
        }
    }
}

// sum += sign * a * b; the sum has the product's degrees.
static void add_product(const polynomial *a, const polynomial *b, double sign, polynomial *sum)
{
    for (uint32_t i = 0; i < a->counts[0] * a->counts[1] * a->counts[2]; i++) {
        uint32_t x = i % a->counts[0], y = i / a->counts[0] % a->counts[1];
        uint32_t z = i / a->counts[0] / a->counts[1];
        double scale = sign * a->c[i];
        for (uint32_t w = 0; w < b->counts[2]; w++) {
            for (uint32_t v = 0; v < b->counts[1]; v++) {
                double *to = sum->c + place(sum, x, y + v, z + w);
                const double *from = b->c + place(b, 0, v, w);
                for (uint32_t u = 0; u < b->counts[0]; u++) {
                    to[u] += scale * from[u];
                }
            }
        }
    }
}

static void begin_product(const polynomial *a, const polynomial *b, polynomial *sum)
{
    size_t count = 1;
    for (uint32_t i = 0; i < 3; i++) {
        sum->counts[i] = a->counts[i] + b->counts[i] - 1;
        count *= sum->counts[i];
    }
    memset(sum->c, 0, count * sizeof *sum->c);
}

void sfi_jacobian_bounds(const sfi_spline *spline, double *least, double *greatest)
{
    double slopes[9][SLOPE], products[CROSS], all[MOST];
    polynomial d[3][3]; // of each coordinate by each axis
    polynomial cross = {{0}, products}, determinant = {{0}, all};
    for (uint32_t coordinate = 0; coordinate < 3; coordinate++) {
        double b[64];
        to_bernstein(spline, coordinate, b);
        for (uint32_t axis = 0; axis < 3; axis++) {
            d[coordinate][axis].c = slopes[3 * coordinate + axis];
            derive(b, axis, &d[coordinate][axis]);
        }
    }
    for (uint32_t i = 0; i < 3; i++) {
        uint32_t j = (i + 1) % 3, k = (i + 2) % 3;
        begin_product(&d[j][1], &d[k][2], &cross);
        add_product(&d[j][1], &d[k][2], 1, &cross);
        add_product(&d[k][1], &d[j][2], -1, &cross);
        if (i == 0) {
            begin_product(&d[i][0], &cross, &determinant);
        }
        add_product(&d[i][0], &cross, 1, &determinant);
    }
    *least = *greatest = determinant.c[0];
    for (uint32_t i = 0; i < MOST; i++) {
        double c = determinant.c[i] / factor(&determinant, i % 9, i / 9 % 9, i / 81);
        *least = c < *least ? c : *least;
        *greatest = c > *greatest ? c : *greatest;
    }
}
