// SPDX-License-Identifier: MIT
// How much a bent surface has lost its details: Laplacian editing with implicit rotations.
//
// The detail at vertex i is d_i = v_i - (mean of its neighbours). Bending turns details, and it may
// scale them, so that what the new detail L_i is compared with is T_i d_i, where T_i is the
// similarity, linearised, that takes the ring around i closest to where it has gone. With the ring
// (i itself and its neighbours) about its middle, p_k, and the new places v'_k, the least squares
//
//     min over s, h of sum_k |s p_k + h x p_k - (v'_k - middle)|^2
//
// come apart, because p and h x p are orthogonal:
//
//     s = sum p_k . v'_k / P,   P = sum |p_k|^2,
//     h = J^-1 sum p_k x v'_k,  J = sum |p_k|^2 I - p_k p_k^T.
//
// Both are linear in v', so that the residual L_i - s d_i - h x d_i is, too: with v' = sum phi_b
// y_b it is sum beta_b y_b, where from the two sums lambda = sum l_k phi_b(k) (l_k the weights of
// L) and pi = sum p_k phi_b(k) over the ring
//
//     beta_b = lambda I - d pi^T / P + [d]x J^-1 [pi]x.
//
// The form is the sum of beta^T beta, which costs 12 N (12 N + 1) 3 / 2 products a vertex for N
// handles, once for a shape. It is zero for every similarity with a small turn. Rings that lie on a
// line have no turn about it that could be seen, and take none.
//
// Vertices are shared out in a fixed number of stretches, each with a sum of its own, so that the
// form is the same bytes for any number of threads. Within a stretch residuals are collected in
// blocks, so that a row of the form is fetched once for many of them.
//
// Source: O. Sorkine, Y. Lipman, D. Cohen-Or, M. Alexa, C. Roessl, H.-P. Seidel, "Laplacian Surface
// Editing", 2004, section 3; R. Prevost and others, "Make It Stand", SIGGRAPH 2013, equation 13.

#include "balance/bend/laplacian.h"

#include "base/memory.h"
#include "base/size.h"
#include "base/task.h"
#include "mesh/vector.h"

#include <math.h>
#include <string.h>

enum { STRETCHES = 16, BLOCK_ROWS = 24 };

// Rings flatter than this, as a share of P^3, lie on a line.
#define ON_A_LINE 1e-12

// Everything about the ring of a vertex that does not depend on how it is bent.
typedef struct ring {
    size_t vertex, degree;
    double middle[3], detail[3];
    double square;   // P
    double turns[9]; // [d]x J^-1
} ring;

typedef struct work {
    sf_mesh_view mesh;
    const sfi_incidence *incidence;
    const sf_blend *basis;
    size_t size;     // 3 * functions
    double *forms;   // of each stretch
    double *scratch; // of each stretch: phi, lambda and pi, then a block of rows
    size_t form_count, scratch_count;
    double norms[STRETCHES];
} work;

// The k-th neighbour of a vertex: the one after it in the k-th triangle. In a closed and oriented
// mesh each comes once.
static size_t neighbour(const work *w, size_t vertex, size_t k)
{
    uint32_t next, last;
    sfi_incidence_others(w->mesh.triangles, w->incidence->corner[w->incidence->start[vertex] + k],
                         &next, &last);
    return next;
}

// Member k of a ring: the vertex itself, then its neighbours.
static size_t member(const work *w, const ring *r, size_t k)
{
    return k == 0 ? r->vertex : neighbour(w, r->vertex, k - 1);
}

static void offset(const work *w, const ring *r, size_t vertex, double p[3])
{
    sfi_subtract(w->mesh.vertices + 3 * vertex, r->middle, p);
}

static void add_inertia(const double p[3], double j[9])
{
    double square = sfi_dot(p, p);
    for (int a = 0; a < 3; a++) {
        for (int b = 0; b < 3; b++) {
            j[3 * a + b] += (a == b ? square : 0) - p[a] * p[b];
        }
    }
}

// out = [d]x times the inverse of the symmetric j; zero where the ring lies on a line.
static void find_turns(const double d[3], const double j[9], double square, double out[9])
{
    double adjoint[9], det;
    sfi_cross(j + 3, j + 6, adjoint);
    sfi_cross(j + 6, j, adjoint + 3);
    sfi_cross(j, j + 3, adjoint + 6);
    det = sfi_dot(j, adjoint);
    for (int c = 0; c < 3; c++) {
        double column[3] = {adjoint[c], adjoint[3 + c], adjoint[6 + c]}, turned[3];
        sfi_cross(d, column, turned);
        for (int a = 0; a < 3; a++) {
            out[3 * a + c] = det > ON_A_LINE * square * square * square ? turned[a] / det : 0;
        }
    }
}

static void look_around(const work *w, size_t vertex, ring *r)
{
    double sum[3] = {0, 0, 0}, inertia[9] = {0};
    const double *own = w->mesh.vertices + 3 * vertex;
    r->vertex = vertex;
    r->degree = w->incidence->start[vertex + 1] - w->incidence->start[vertex];
    for (size_t k = 0; k < r->degree; k++) {
        const double *v = w->mesh.vertices + 3 * neighbour(w, vertex, k);
        for (int d = 0; d < 3; d++) {
            sum[d] += v[d];
        }
    }
    for (int d = 0; d < 3; d++) {
        r->middle[d] = (sum[d] + own[d]) / (double)(r->degree + 1);
        r->detail[d] = r->degree > 0 ? own[d] - sum[d] / (double)r->degree : 0;
    }
    r->square = 0;
    for (size_t k = 0; k <= r->degree; k++) {
        double p[3];
        offset(w, r, member(w, r, k), p);
        r->square += sfi_dot(p, p);
        add_inertia(p, inertia);
    }
    find_turns(r->detail, inertia, r->square, r->turns);
}

// lambda and pi of each function: 4 numbers each.
static void sum_functions(const work *w, const ring *r, double *phi, double *sums)
{
    size_t functions = sfi_basis_size(w->basis);
    memset(sums, 0, 4 * functions * sizeof *sums);
    for (size_t k = 0; k <= r->degree; k++) {
        size_t vertex = member(w, r, k);
        double p[3], share = k == 0 ? 1 : -1 / (double)r->degree;
        offset(w, r, vertex, p);
        sfi_basis_at(w->basis, vertex, phi);
        for (size_t b = 0; b < functions; b++) {
            sums[4 * b] += share * phi[b];
            sums[4 * b + 1] += p[0] * phi[b];
            sums[4 * b + 2] += p[1] * phi[b];
            sums[4 * b + 3] += p[2] * phi[b];
        }
    }
}

// Three rows: component c of the residual in terms of each coefficient.
static void write_rows(const work *w, const ring *r, const double *sums, double *rows)
{
    for (size_t b = 0; b < sfi_basis_size(w->basis); b++) {
        const double *pi = sums + 4 * b + 1;
        for (int c = 0; c < 3; c++) {
            const double *turn = r->turns + 3 * c;
            // Row c of turns times [pi]x is turn x pi.
            double *row = rows + (size_t)c * w->size + 3 * b, crossed[3];
            sfi_cross(turn, pi, crossed);
            for (int d = 0; d < 3; d++) {
                row[d] = (c == d ? sums[4 * b] : 0) - r->detail[c] * pi[d] / r->square + crossed[d];
            }
        }
    }
}

// form += rows^T rows, on and right of the diagonal.
static void add_rows(const double *rows, size_t count, size_t size, double *form)
{
    for (size_t i = 0; i < size; i++) {
        double *to = form + i * size;
        for (size_t r = 0; r < count; r++) {
            const double *row = rows + r * size;
            double factor = row[i];
            for (size_t j = i; j < size; j++) {
                to[j] += factor * row[j];
            }
        }
    }
}

static void run_stretch(void *context, size_t index)
{
    work *w = context;
    size_t count = w->mesh.vertex_count, functions = sfi_basis_size(w->basis), filled = 0;
    double *form = w->forms + index * w->form_count;
    double *phi = w->scratch + index * w->scratch_count, *sums = phi + functions,
           *rows = sums + 4 * functions, norm = 0;
    memset(form, 0, w->form_count * sizeof *form);
    for (size_t v = count / STRETCHES * index + count % STRETCHES * index / STRETCHES,
                end = count / STRETCHES * (index + 1) + count % STRETCHES * (index + 1) / STRETCHES;
         v < end; v++) {
        ring r;
        look_around(w, v, &r);
        if (!(r.square > 0)) {
            continue;
        }
        norm += sfi_dot(r.detail, r.detail);
        sum_functions(w, &r, phi, sums);
        write_rows(w, &r, sums, rows + filled * w->size);
        filled += 3;
        if (filled == BLOCK_ROWS) {
            add_rows(rows, filled, w->size, form);
            filled = 0;
        }
    }
    add_rows(rows, filled, w->size, form);
    w->norms[index] = norm;
}

// The stretches' sums in their order, and what lies left of the diagonal.
static void gather(const work *w, double *form, double *norm)
{
    *norm = 0;
    memset(form, 0, w->form_count * sizeof *form);
    for (size_t s = 0; s < STRETCHES; s++) {
        *norm += w->norms[s];
        for (size_t i = 0; i < w->form_count; i++) {
            form[i] += w->forms[s * w->form_count + i];
        }
    }
    for (size_t i = 0; i < w->size; i++) {
        for (size_t j = 0; j < i; j++) {
            form[i * w->size + j] = form[j * w->size + i];
        }
    }
}

static int take_memory(work *w, const sf_allocator *allocator)
{
    size_t functions = sfi_basis_size(w->basis), forms, scratch;
    if (!sfi_size_mul(functions, 3, &w->size) || !sfi_size_mul(w->size, w->size, &w->form_count) ||
        !sfi_size_mul(functions, 5 + 3 * BLOCK_ROWS, &w->scratch_count) ||
        !sfi_size_mul(w->form_count, STRETCHES, &forms) ||
        !sfi_size_mul(w->scratch_count, STRETCHES, &scratch)) {
        return 0;
    }
    w->forms = sfi_alloc_array(allocator, forms, sizeof *w->forms);
    w->scratch = sfi_alloc_array(allocator, scratch, sizeof *w->scratch);
    return w->forms != NULL && w->scratch != NULL;
}

sf_status sfi_laplacian_form(sf_mesh_view mesh, const sfi_incidence *incidence,
                             const sf_blend *basis, const sf_allocator *allocator, sf_task *task,
                             double *form, double *norm)
{
    work w;
    memset(&w, 0, sizeof w);
    w.mesh = mesh;
    w.incidence = incidence;
    w.basis = basis;
    sf_status status = take_memory(&w, allocator) ? SF_OK : SF_ERR_MEMORY;
    if (status == SF_OK) {
        sfi_task_for(task, STRETCHES, run_stretch, &w);
        status = sf_task_is_cancelled(task) ? SF_ERR_CANCELLED : SF_OK;
    }
    if (status == SF_OK) {
        gather(&w, form, norm);
    }
    sfi_free_array(allocator, w.forms, STRETCHES * w.form_count, sizeof *w.forms);
    sfi_free_array(allocator, w.scratch, STRETCHES * w.scratch_count, sizeof *w.scratch);
    return status;
}
