// SPDX-License-Identifier: MIT
// Multigrid cycles for the Laplacian of a domain.
//
// One cycle smooths from the finest level down, solves the coarsest exactly, and smooths on the way
// back. Down, a Gauss-Seidel sweep goes from the first node to the last, starting from zero, so
// that it looks at lower neighbours only, and what is left is the flow from upper ones. Up, the
// sweep goes the other way. So the cycle is a symmetric positive matrix V, nearly the inverse of L
// where something is held, and can stand in a conjugate gradient iteration.
//
// What is held comes in two kinds. Fixed nodes are zero: they are left out on the finest level.
// Pins are added to the diagonal. Coarser levels know pins only, each shared out among the parents.
//
// A pin is worth less to a coarse node. To reach a single node the flow has to narrow down to it,
// against a resistance of 1 / (0.66 diagonal), from the value of the Green's function of a lattice
// at its origin; on a level of twice the edge that is half as much, and the pin makes up for the
// other half: 1 / pin' = 1 / pin + 1 / (1.32 diagonal). So V inverts L best. The energy of weights
// holds the slope beside a held node as well, and there V should hold more than L does: with 16
// for 1.32 weights take the fewest steps, with 8 or 20 about as many, with 1.32 or 1 up to twice as
// many.
//
// All of it is in floats: it only has to point the way. The order of operations is fixed.
//
// Source: A. Brandt, "Multi-Level Adaptive Solutions to Boundary-Value Problems", 1977.

#include "balance/handle/poisson.h"

#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"

#include <math.h>
#include <string.h>

// The most that a pin is worth on the next level, in units of the diagonal.
#define WORTH_MAX 16.0f

// ---------------------------------------------------------------------------------------------
// Memory
// ---------------------------------------------------------------------------------------------

sf_status sfi_cycle_create(const sfi_poisson *poisson, const sf_allocator *allocator,
                           sfi_cycle *cycle)
{
    size_t nodes = 0, bottom = poisson->level[poisson->level_count - 1].count;
    for (uint32_t i = 0; i < poisson->level_count; i++) {
        nodes += poisson->level[i].count;
    }
    memset(cycle, 0, sizeof *cycle);
    cycle->poisson = poisson;
    cycle->bottom_count = SFI_LANES * bottom * bottom;
    if (!sfi_size_mul(nodes, 4 * SFI_LANES, &cycle->memory_count)) {
        return SF_ERR_OVERFLOW;
    }
    cycle->memory = sfi_alloc_array(allocator, cycle->memory_count, sizeof *cycle->memory);
    cycle->bottom = sfi_alloc_array(allocator, cycle->bottom_count, sizeof *cycle->bottom);
    if (cycle->memory == NULL || cycle->bottom == NULL) {
        sfi_cycle_destroy(cycle, allocator);
        return SF_ERR_MEMORY;
    }
    memset(cycle->memory, 0, cycle->memory_count * sizeof *cycle->memory);
    float *next = cycle->memory;
    for (uint32_t i = 0; i < poisson->level_count; i++) {
        size_t count = SFI_LANES * poisson->level[i].count;
        cycle->inverse[i] = next;
        cycle->pin[i] = next + count;
        cycle->x[i] = next + 2 * count;
        cycle->b[i] = next + 3 * count;
        next += 4 * count;
    }
    return SF_OK;
}

void sfi_cycle_destroy(sfi_cycle *cycle, const sf_allocator *allocator)
{
    sfi_free_array(allocator, cycle->memory, cycle->memory_count, sizeof *cycle->memory);
    sfi_free_array(allocator, cycle->bottom, cycle->bottom_count, sizeof *cycle->bottom);
}

// ---------------------------------------------------------------------------------------------
// What is held
// ---------------------------------------------------------------------------------------------

// Add `from` to the parents of a node, an equal part to each.
static inline void share(const sfi_level *l, size_t node, const float *from, float *to)
{
    uint32_t begin = l->begin[node], end = l->begin[node + 1];
    float part = 1.0f / (float)(end - begin);
    for (uint32_t p = begin; p < end; p++) {
        float *at = to + SFI_LANES * (size_t)l->parent[p];
        for (int lane = 0; lane < SFI_LANES; lane++) {
            at[lane] += part * from[lane];
        }
    }
}

// Factor the coarsest level, lane by lane: its matrix is symmetric, and positive where each piece
// is held. C = lower triangle with the inverse of its diagonal in place.
static void factor_bottom(sfi_cycle *c)
{
    const sfi_level *l = &c->poisson->level[c->poisson->level_count - 1];
    const float *pin = c->pin[c->poisson->level_count - 1],
                *inverse = c->inverse[c->poisson->level_count - 1];
    size_t n = l->count;
    memset(c->bottom, 0, c->bottom_count * sizeof *c->bottom);
    for (size_t lane = 0; lane < SFI_LANES; lane++) {
        double *m = c->bottom + lane * n * n;
        for (size_t i = 0; i < n; i++) {
            for (size_t k = 0; k < 6; k++) {
                size_t j = l->neighbour[6 * i + k];
                int is_free = inverse[SFI_LANES * i] != 0 && inverse[SFI_LANES * j] != 0;
                m[i * n + j] -= is_free ? (double)l->flow[6 * i + k] : 0;
            }
            if (inverse[SFI_LANES * i] != 0) {
                m[i * n + i] += (double)l->diagonal[i] + (double)pin[SFI_LANES * i + lane];
            }
        }
        for (size_t j = 0; j < n; j++) {
            for (size_t i = j; i < n; i++) {
                double sum = m[i * n + j];
                for (size_t k = 0; k < j; k++) {
                    sum -= m[i * n + k] * m[j * n + k];
                }
                m[i * n + j] = i == j ? sum : sum * m[j * n + j];
                if (i == j) {
                    // Zero only by rounding: nothing is held there, and nothing asked for.
                    m[j * n + j] = sum > 0 ? 1 / sqrt(sum) : 0;
                }
            }
        }
    }
}

// What the pins of a node are worth on the next level.
static void weaken(float diagonal, int is_fixed, const float *pin, float *out)
{
    float most = WORTH_MAX * diagonal;
    for (size_t k = 0; k < SFI_LANES; k++) {
        out[k] = is_fixed ? most : most > 0 ? pin[k] * most / (pin[k] + most) : pin[k];
    }
}

void sfi_cycle_hold(sfi_cycle *cycle, const uint8_t *fixed, const float *pin)
{
    const sfi_poisson *p = cycle->poisson;
    for (size_t i = 0; i < SFI_LANES * p->level[0].count; i++) {
        cycle->pin[0][i] = pin != NULL ? pin[i] : 0;
    }
    for (uint32_t k = 1; k < p->level_count; k++) {
        const sfi_level *above = &p->level[k - 1];
        memset(cycle->pin[k], 0, SFI_LANES * p->level[k].count * sizeof(float));
        for (size_t i = 0; i < above->count; i++) {
            float worth[SFI_LANES];
            weaken(above->diagonal[i], k == 1 && fixed[i], cycle->pin[k - 1] + SFI_LANES * i,
                   worth);
            share(above, i, worth, cycle->pin[k]);
        }
    }
    for (uint32_t k = 0; k < p->level_count; k++) {
        for (size_t i = 0; i < SFI_LANES * p->level[k].count; i++) {
            float sum = p->level[k].diagonal[i / SFI_LANES] + cycle->pin[k][i];
            int held = k == 0 && fixed[i / SFI_LANES];
            cycle->inverse[k][i] = held || !(sum > 0) ? 0 : 1 / sum;
        }
    }
    factor_bottom(cycle);
}

// ---------------------------------------------------------------------------------------------
// The cycle
// ---------------------------------------------------------------------------------------------

static void sweep_down(const sfi_level *l, const float *inverse, const float *b, float *x)
{
    for (size_t i = 0; i < l->count; i++) {
        const uint32_t *nb = l->neighbour + 6 * i;
        const float *f = l->flow + 6 * i;
        const float *x0 = x + SFI_LANES * (size_t)nb[0], *x1 = x + SFI_LANES * (size_t)nb[1],
                    *x2 = x + SFI_LANES * (size_t)nb[2];
        float sum[SFI_LANES];
        for (int k = 0; k < SFI_LANES; k++) {
            sum[k] = (b[SFI_LANES * i + (size_t)k] + (f[0] * x0[k] + f[1] * x1[k])) + f[2] * x2[k];
        }
        for (int k = 0; k < SFI_LANES; k++) {
            x[SFI_LANES * i + (size_t)k] = sum[k] * inverse[SFI_LANES * i + (size_t)k];
        }
    }
}

// What is left after a sweep down, shared out among the parents. Fixed nodes ask for nothing.
static void restrict_rest(const sfi_level *l, const float *inverse, const float *x, float *coarse)
{
    for (size_t i = 0; i < l->count; i++) {
        const uint32_t *nb = l->neighbour + 6 * i;
        const float *f = l->flow + 6 * i;
        const float *x3 = x + SFI_LANES * (size_t)nb[3], *x4 = x + SFI_LANES * (size_t)nb[4],
                    *x5 = x + SFI_LANES * (size_t)nb[5];
        float rest[SFI_LANES];
        if (inverse[SFI_LANES * i] == 0) {
            continue;
        }
        for (int k = 0; k < SFI_LANES; k++) {
            rest[k] = (f[3] * x3[k] + f[4] * x4[k]) + f[5] * x5[k];
        }
        share(l, i, rest, coarse);
    }
}

static void prolong(const sfi_level *l, const float *inverse, const float *coarse, float *x)
{
    for (size_t i = 0; i < l->count; i++) {
        uint32_t begin = l->begin[i], end = l->begin[i + 1];
        float sum[SFI_LANES] = {0}, part = 1.0f / (float)(end - begin);
        if (inverse[SFI_LANES * i] == 0) {
            continue;
        }
        for (uint32_t p = begin; p < end; p++) {
            const float *from = coarse + SFI_LANES * (size_t)l->parent[p];
            for (int k = 0; k < SFI_LANES; k++) {
                sum[k] += from[k];
            }
        }
        for (int k = 0; k < SFI_LANES; k++) {
            x[SFI_LANES * i + (size_t)k] += part * sum[k];
        }
    }
}

static void sweep_up(const sfi_level *l, const float *inverse, const float *b, float *x)
{
    for (size_t i = l->count; i-- > 0;) {
        const uint32_t *nb = l->neighbour + 6 * i;
        const float *f = l->flow + 6 * i;
        const float *x0 = x + SFI_LANES * (size_t)nb[0], *x1 = x + SFI_LANES * (size_t)nb[1],
                    *x2 = x + SFI_LANES * (size_t)nb[2], *x3 = x + SFI_LANES * (size_t)nb[3],
                    *x4 = x + SFI_LANES * (size_t)nb[4], *x5 = x + SFI_LANES * (size_t)nb[5];
        float sum[SFI_LANES];
        for (int k = 0; k < SFI_LANES; k++) {
            sum[k] = ((b[SFI_LANES * i + (size_t)k] + (f[0] * x0[k] + f[1] * x1[k])) +
                      (f[2] * x2[k] + (f[4] * x4[k] + f[5] * x5[k]))) +
                     f[3] * x3[k];
        }
        for (int k = 0; k < SFI_LANES; k++) {
            x[SFI_LANES * i + (size_t)k] = sum[k] * inverse[SFI_LANES * i + (size_t)k];
        }
    }
}

static void solve_bottom(const sfi_cycle *c, const float *b, float *x)
{
    size_t n = c->poisson->level[c->poisson->level_count - 1].count;
    double y[SFI_BOTTOM_NODES];
    for (size_t lane = 0; lane < SFI_LANES; lane++) {
        const double *m = c->bottom + lane * n * n;
        for (size_t i = 0; i < n; i++) {
            double sum = (double)b[SFI_LANES * i + lane];
            for (size_t k = 0; k < i; k++) {
                sum -= m[i * n + k] * y[k];
            }
            y[i] = sum * m[i * n + i];
        }
        for (size_t i = n; i-- > 0;) {
            double sum = y[i];
            for (size_t k = i + 1; k < n; k++) {
                sum -= m[k * n + i] * y[k];
            }
            y[i] = sum * m[i * n + i];
            x[SFI_LANES * i + lane] = (float)y[i];
        }
    }
}

void sfi_cycle_run(sfi_cycle *c)
{
    const sfi_poisson *p = c->poisson;
    uint32_t last = p->level_count - 1;
    for (uint32_t k = 0; k < last; k++) {
        sweep_down(&p->level[k], c->inverse[k], c->b[k], c->x[k]);
        memset(c->b[k + 1], 0, SFI_LANES * p->level[k + 1].count * sizeof(float));
        restrict_rest(&p->level[k], c->inverse[k], c->x[k], c->b[k + 1]);
    }
    solve_bottom(c, c->b[last], c->x[last]);
    for (uint32_t k = last; k-- > 0;) {
        prolong(&p->level[k], c->inverse[k], c->x[k + 1], c->x[k]);
        sweep_up(&p->level[k], c->inverse[k], c->b[k], c->x[k]);
    }
}

// ---------------------------------------------------------------------------------------------
// The Laplacian
// ---------------------------------------------------------------------------------------------

void sfi_poisson_apply(const sfi_poisson *poisson, const double *x, double *out)
{
    const sfi_level *l = &poisson->level[0];
    for (size_t i = 0; i < l->count; i++) {
        const double *own = x + SFI_LANES * i;
        double sum[SFI_LANES] = {0};
        for (size_t n = 0; n < 6; n++) {
            const double *other = x + SFI_LANES * (size_t)l->neighbour[6 * i + n];
            double flow = (double)l->flow[6 * i + n];
            for (int k = 0; k < SFI_LANES; k++) {
                sum[k] += flow * (own[k] - other[k]);
            }
        }
        for (int k = 0; k < SFI_LANES; k++) {
            out[SFI_LANES * i + (size_t)k] = sum[k];
        }
    }
}
