// SPDX-License-Identifier: MIT
// Dilation of a layer by disks. The limit copies the layer.

#include "bench.h"
#include "scenes.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct disk_work {
    sf_slice src, dst;
    sf_element element;
} disk_work;

static void dilate(void *user)
{
    disk_work *w = user;
    bench_must(sf_slice_dilate(w->dst, w->src, &w->element, SF_BORDER_EMPTY));
}

static void copy(void *user)
{
    disk_work *w = user;
    memcpy(w->dst.words, w->src.words, w->src.stride * w->src.height * sizeof(uint64_t));
}

void bench_morphology(void)
{
    static const unsigned radii[4] = {2, 3, 5, 10};
    static const double goals[4] = {0, 5, 0, 0};
    const uint32_t width = 3840, height = 2160;
    if (!bench_wants("disk")) {
        return;
    }
    disk_work w = {scene_plate(width, height), scene_noise_slice(width, height), {0, {0}}};
    for (int i = 0; i < 4; i++) {
        uint64_t radius = (uint64_t)radii[i] << 16;
        char job[32];
        snprintf(job, sizeof job, "disk r=%u", radii[i]);
        bench_must(sf_element_ellipse(radius, radius, &w.element));
        bench_work work = {NULL, dilate, copy, &w};
        bench_measure(job, "3840x2160", goals[i], 1e-3, "klayer", &work);
    }
    free(w.src.words);
    free(w.dst.words);
}
