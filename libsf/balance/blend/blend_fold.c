// SPDX-License-Identifier: MIT
// Whether a blend folds the solid over itself.
//
// The derivative of v = sum of w_j (A_j p + b_j) by p is sum of w_j A_j + (A_j p + b_j) grad w_j^T.
// Where its determinant is not above 0 the solid is turned inside out. It is looked at in the eight
// corners of each cell, with the gradients of that cell: there they are greatest.
//
// Cells are shared out in stretches of a fixed length; the least of each is kept, and of equals the
// first, so that the result does not depend on threads.

#include "balance/blend/blend_fold.h"

#include "balance/blend/blend.h"
#include "balance/blend/blend_jacobian.h"
#include "base/status.h"
#include "base/task.h"

#include <math.h>

enum { STRETCH = 256, WAVE = 64 };
// Folded places of a stretch that are told, the first ones.
enum { TOLD = 8 };

typedef struct fold_work {
    const sf_weights *weights;
    size_t first; // stretch of this wave
    sf_fold found[WAVE];
    sfi_spot told[WAVE][TOLD];
    sfi_map maps[SF_HANDLE_MAX];
} fold_work;

void sfi_jacobian(const sf_weights *weights, const sfi_map *maps, const sfi_spot *spot,
                  const double p[3], double bent[3], double jacobian[9])
{
    double w[SF_HANDLE_MAX], gradient[3 * SF_HANDLE_MAX], turned[3];
    sfi_map mix;
    sfi_weights_at(weights, spot, w, gradient);
    sfi_maps_mix(maps, w, weights->count, &mix);
    sfi_map_turn(mix.matrix, p, bent);
    for (int n = 0; n < 3; n++) {
        bent[n] += mix.shift[n];
    }
    for (int n = 0; n < 9; n++) {
        jacobian[n] = mix.matrix[n];
    }
    for (size_t j = 0; j < weights->count; j++) {
        sfi_map_turn(maps[j].matrix, p, turned);
        for (int n = 0; n < 9; n++) {
            // Gradients sum to 0: the bent point taken off changes nothing but rounding.
            double away = (turned[n / 3] + maps[j].shift[n / 3]) - bent[n / 3];
            jacobian[n] += away * gradient[3 * j + (size_t)(n % 3)];
        }
    }
}

static void look_at_corner(const fold_work *f, uint32_t cell, size_t corner, sf_fold *found,
                           sfi_spot *told)
{
    const sfi_domain *d = &f->weights->domain;
    sfi_spot spot = {cell, {0, 0, 0}, 0, {0, 0, 0}};
    double bent[3], jacobian[9];
    for (size_t axis = 0; axis < 3; axis++) {
        spot.at[axis] = d->planes[axis][d->place[3 * (size_t)cell + axis] + (corner >> axis & 1)];
    }
    sfi_jacobian(f->weights, f->maps, &spot, spot.at, bent, jacobian);
    double det = sfi_determinant(jacobian);
    found->places++;
    if (!(det > 0)) {
        if (found->folded < TOLD) {
            told[found->folded] = spot;
        }
        found->folded++;
    }
    if (det < found->least_det) {
        found->least_det = det;
        for (int axis = 0; axis < 3; axis++) {
            found->at_mm[axis] = spot.at[axis];
        }
    }
}

static void look_at_stretch(void *context, size_t index)
{
    fold_work *f = context;
    sf_fold none = {INFINITY, {0, 0, 0}, 0, 0}, *found = &f->found[index];
    size_t begin = (f->first + index) * STRETCH, end = begin + STRETCH;
    *found = none;
    for (size_t cell = begin; cell < end && cell < f->weights->domain.cell_count; cell++) {
        for (size_t corner = 0; corner < 8; corner++) {
            look_at_corner(f, (uint32_t)cell, corner, found, f->told[index]);
        }
    }
}

static void tell(const fold_work *f, size_t index, size_t capacity, sfi_spot *spots, size_t *count)
{
    for (size_t i = 0; i < f->found[index].folded && i < TOLD && *count < capacity; i++) {
        spots[(*count)++] = f->told[index][i];
    }
}

sf_status sfi_weights_folds(const sf_weights *weights, const sf_pose *poses, sf_task *task,
                            size_t capacity, sf_fold *fold, sfi_spot *spots, size_t *count)
{
    fold_work f = {.weights = weights};
    sf_fold all = {INFINITY, {0, 0, 0}, 0, 0};
    if (weights == NULL || poses == NULL || fold == NULL ||
        !sfi_maps_make(poses, weights->centers, weights->count, f.maps)) {
        return SF_ERR_ARGUMENT;
    }
    sfi_progress progress = sfi_progress_begin(task);
    *count = 0;
    size_t cells = weights->domain.cell_count, pieces = cells / STRETCH + (cells % STRETCH != 0);
    for (f.first = 0; f.first < pieces; f.first += WAVE) {
        size_t wave = pieces - f.first < WAVE ? pieces - f.first : WAVE;
        if (sf_task_is_cancelled(task)) {
            return SF_ERR_CANCELLED;
        }
        sfi_task_for(task, wave, look_at_stretch, &f);
        for (size_t i = 0; i < wave; i++) {
            uint64_t places = all.places + f.found[i].places;
            uint64_t folded = all.folded + f.found[i].folded;
            all = f.found[i].least_det < all.least_det ? f.found[i] : all;
            all.places = places;
            all.folded = folded;
            tell(&f, i, capacity, spots, count);
        }
        sfi_progress_report(&progress, f.first + wave, pieces);
    }
    *fold = all;
    return SF_OK;
}

sf_status sf_weights_fold(const sf_weights *weights, const sf_pose *poses, sf_task *task,
                          sf_fold *fold)
{
    size_t none;
    return sfi_weights_folds(weights, poses, task, 0, fold, NULL, &none);
}
