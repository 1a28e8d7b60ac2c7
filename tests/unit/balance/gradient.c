// SPDX-License-Identifier: MIT
// Why: optimisers believe their gradients. Those of mass and first moments are held against central
// differences to 1e-8 of the largest entry, gathered around vertices against scattered over
// triangles, and the sums that moving the whole must give against zero and the mass, to 1e-14 of
// the sum of absolute terms.

#include "balance/bend/gradient.h"
#include "base/memory.h"
#include "failing_allocator.h"
#include "lump.h"

#include <sf/bend.h>

static double *gradient_of(sf_mesh_view mesh, double density)
{
    double *gradient = malloc(12 * mesh.vertex_count * sizeof *gradient);
    CHECK_EQ(sf_mesh_body_gradient(mesh, density, gradient), SF_OK);
    return gradient;
}

// The four figures of a mesh with one coordinate moved.
static void measure_moved(sf_mesh_view mesh, double *at, double by, double figures[4])
{
    sf_body body = {0, {0, 0, 0}};
    double was = *at;
    *at = was + by;
    CHECK_EQ(sf_mesh_body(mesh, 2.5, &body), SF_OK);
    *at = was;
    figures[0] = body.mass;
    memcpy(figures + 1, body.moment, sizeof body.moment);
}

static void differences_agree(void)
{
    sf_mesh *mesh = lump(0);
    sf_mesh_view view = sf_mesh_get_view(mesh);
    double *copy = malloc(3 * view.vertex_count * sizeof *copy), worst[4] = {0}, most[4] = {0};
    memcpy(copy, view.vertices, 3 * view.vertex_count * sizeof *copy);
    view.vertices = copy;
    double *gradient = gradient_of(view, 2.5);
    for (size_t i = 0; i < 3 * view.vertex_count; i++) {
        double up[4], down[4], step = 1e-4;
        measure_moved(view, copy + i, step, up);
        measure_moved(view, copy + i, -step, down);
        for (size_t f = 0; f < 4; f++) {
            double exact = gradient[12 * (i / 3) + 3 * f + i % 3];
            worst[f] = fmax(worst[f], fabs((up[f] - down[f]) / (2 * step) - exact));
            most[f] = fmax(most[f], fabs(exact));
        }
    }
    for (int f = 0; f < 4; f++) {
        CHECK(most[f] > 0.1);
        CHECK_NEAR(worst[f] / most[f], 0, 1e-8);
        printf("# entry %d: off by %.1e of the largest\n", f, worst[f] / most[f]);
    }
    free(copy);
    free(gradient);
    sf_mesh_destroy(mesh);
}

// Also a thousand sizes away from the origin, where single terms are a million times too large.
static void moving_the_whole_moves_the_centre(void)
{
    for (int far = 0; far < 2; far++) {
        sf_mesh *mesh = lump(far * 4096.0);
        sf_mesh_view view = sf_mesh_get_view(mesh);
        double *gradient = gradient_of(view, 1), sum[12] = {0}, terms[12] = {0};
        sf_body body = {0, {0, 0, 0}};
        CHECK_EQ(sf_mesh_body(view, 1, &body), SF_OK);
        for (size_t i = 0; i < 12 * view.vertex_count; i++) {
            sum[i % 12] += gradient[i];
            terms[i % 12] += fabs(gradient[i]);
        }
        double worst = 0;
        for (int i = 0; i < 12; i++) {
            double expected = i >= 3 && (i - 3) / 3 == i % 3 ? body.mass : 0;
            CHECK_NEAR(sum[i], expected, 1e-14 * terms[i]);
            worst = fmax(worst, fabs(sum[i] - expected) / terms[i]);
        }
        printf("# sums off by %.1e of their terms\n", worst);
        free(gradient);
        sf_mesh_destroy(mesh);
    }
}

static void gathered_is_scattered(void)
{
    sf_allocator allocator = sfi_allocator_or_default(NULL);
    sf_mesh *mesh = lump(0);
    sf_mesh_view view = sf_mesh_get_view(mesh);
    double *gradient = gradient_of(view, 1), middle[3] = {2, 3, 1};
    sfi_incidence incidence;
    CHECK_EQ(sfi_incidence_make(view, &allocator, &incidence), SF_OK);
    for (size_t v = 0; v < view.vertex_count; v++) {
        double g[12];
        sfi_vertex_gradient(view.vertices, view.triangles, &incidence, v, middle, g);
        for (int i = 0; i < 12; i++) {
            double here = g[i] + (i < 3 ? 0 : middle[(i - 3) / 3] * g[i % 3]);
            CHECK_NEAR(here, gradient[12 * v + (size_t)i], 1e-12);
        }
    }
    sfi_incidence_free(&allocator, &incidence);
    free(gradient);
    sf_mesh_destroy(mesh);
}

// d c against the quotient of differences of the centre itself.
static void centres_follow(void)
{
    sf_mesh *mesh = lump(0);
    sf_mesh_view view = sf_mesh_get_view(mesh);
    double *copy = malloc(3 * view.vertex_count * sizeof *copy);
    memcpy(copy, view.vertices, 3 * view.vertex_count * sizeof *copy);
    view.vertices = copy;
    double *gradient = gradient_of(view, 2.5),
           *of_com = malloc(9 * view.vertex_count * sizeof(double));
    sf_body body = {0, {0, 0, 0}};
    CHECK_EQ(sf_mesh_body(view, 2.5, &body), SF_OK);
    CHECK_EQ(sf_body_com_gradient(body, gradient, view.vertex_count, of_com), SF_OK);
    for (size_t i = 0; i < 3 * view.vertex_count; i++) {
        double up[4], down[4], step = 1e-4;
        measure_moved(view, copy + i, step, up);
        measure_moved(view, copy + i, -step, down);
        for (size_t d = 0; d < 3; d++) {
            double slope = (up[1 + d] / up[0] - down[1 + d] / down[0]) / (2 * step);
            CHECK_NEAR(of_com[9 * (i / 3) + 3 * d + i % 3], slope, 1e-8);
        }
    }
    free(of_com);
    free(gradient);
    free(copy);
    sf_mesh_destroy(mesh);
}

static void nonsense_is_refused(void)
{
    sf_mesh *mesh = lump(0);
    sf_mesh_view view = sf_mesh_get_view(mesh), none = {NULL, 0, NULL, 0};
    double *gradient = gradient_of(view, 1), kept = gradient[5];
    sf_body weightless = {0, {1, 0, 0}};
    CHECK_EQ(sf_mesh_body_gradient(view, NAN, gradient), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_mesh_body_gradient(view, 1, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_mesh_body_gradient(none, 1, gradient), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_body_com_gradient(weightless, gradient, 1, gradient + 12), SF_ERR_ARGUMENT);
    CHECK(gradient[5] == kept);
    failing_allocator failing;
    for (long k = 0; k < 2; k++) {
        sfi_incidence incidence;
        failing_begin(&failing, k);
        CHECK_EQ(sfi_incidence_make(view, &failing.allocator, &incidence), SF_ERR_MEMORY);
        CHECK(failing.live == 0 && failing.faults == 0);
    }
    free(gradient);
    sf_mesh_destroy(mesh);
}

int main(void)
{
    TEST(differences_agree);
    TEST(moving_the_whole_moves_the_centre);
    TEST(gathered_is_scattered);
    TEST(centres_follow);
    TEST(nonsense_is_refused);
    return test_finish();
}
