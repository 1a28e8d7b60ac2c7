// SPDX-License-Identifier: MIT
// Why: how far weights that are cut off at their bounds are from those that are found within them
// depends on the shape; so it is held to a limit on four models, with points and with balls. Every
// vertex must lie in the domain of the covered solid, bend, and come back. docs/balance.md has the
// figures that this prints; a number on the command line asks for that many cells.

#include "data_file.h"

#include <sf/blend.h>

#include <time.h>

static double cells_wanted = 6000;

static const char *const models[] = {"characters/horse.ply", "characters/armadillo.obj",
                                     "characters/human_man.obj", "characters/spheres_outer.stl"};

enum { HANDLES_MAX = 6 };

typedef struct figure {
    sf_mesh *mesh;
    sf_mesh_view view;
    double size_mm;
    sf_grid *covered, *foot;
    sf_handle handles[HANDLES_MAX];
    size_t count;
} figure;

static double milliseconds(void)
{
    return 1000.0 * (double)clock() / CLOCKS_PER_SEC;
}

static sf_grid *cover(sf_mesh_view mesh, double pitch)
{
    double low[3] = {0, 0, 0}, high[3] = {1, 1, 1};
    uint32_t n[3];
    sf_grid *solid = NULL, *covered = NULL;
    CHECK_EQ(sf_mesh_bounds(mesh, low, high), SF_OK);
    for (int d = 0; d < 3; d++) {
        n[d] = (uint32_t)ceil((high[d] - low[d]) / pitch) + 2;
    }
    sf_lattice lattice = {n[0],  n[1],  n[2], pitch,
                          pitch, pitch, NULL, {low[0] - pitch, low[1] - pitch, low[2] - pitch}};
    CHECK_EQ(sf_grid_create(&lattice, NULL, &solid), SF_OK);
    CHECK_EQ(sf_grid_voxelize(solid, mesh, NULL, NULL, NULL, NULL), SF_OK);
    CHECK_EQ(sf_grid_cover(solid, mesh, NULL, NULL, &covered), SF_OK);
    sf_grid_destroy(solid);
    return covered;
}

// The figure in about as many voxels as wanted, with a foot and five handles that find their
// places. y of these files is up.
static int begin(figure *f, const char *path, double ball)
{
    double low[3] = {0, 0, 0}, high[3] = {1, 1, 1}, fine, coarse;
    const double up[3] = {0, 1, 0};
    memset(f, 0, sizeof *f);
    sf_mesh *soup = data_mesh(path);
    if (soup == NULL) {
        return 0;
    }
    CHECK_EQ(sf_mesh_merge(sf_mesh_get_view(soup), NULL, &f->mesh), SF_OK);
    sf_mesh_destroy(soup);
    f->view = sf_mesh_get_view(f->mesh);
    CHECK_EQ(sf_mesh_bounds(f->view, low, high), SF_OK);
    for (int d = 0; d < 3; d++) {
        f->size_mm = high[d] - low[d] > f->size_mm ? high[d] - low[d] : f->size_mm;
    }
    fine = f->size_mm / 400;
    coarse = f->size_mm / 4;
    for (int round = 0; round < 14; round++) {
        double pitch = sqrt(fine * coarse);
        sf_grid_destroy(f->covered);
        f->covered = cover(f->view, pitch);
        int many = (double)sf_grid_popcount(f->covered) > cells_wanted;
        fine = many ? pitch : fine;
        coarse = many ? coarse : pitch;
    }
    sf_place_options options = sf_place_options_default();
    CHECK_EQ(sf_grid_foot(f->covered, up, 0.02 * f->size_mm, NULL, &f->foot), SF_OK);
    CHECK_EQ(sf_handle_base(f->foot, &f->handles[0]), SF_OK);
    options.base = f->foot;
    options.ball = ball;
    CHECK_EQ(sf_handles_place(f->covered, &options, NULL, NULL, f->handles + 1, HANDLES_MAX - 1,
                              &f->count, NULL),
             SF_OK);
    f->count++;
    return 1;
}

static void end(figure *f)
{
    sf_mesh_destroy(f->mesh);
    sf_grid_destroy(f->covered);
    sf_grid_destroy(f->foot);
}

static sf_weights *make(const figure *f, sf_weights_method method, double *took)
{
    sf_weights *weights = NULL;
    sf_weights_options options = sf_weights_options_default();
    sf_fault fault = {SF_OK, 0, 0, ""};
    options.method = method;
    options.most_cells = UINT32_MAX;
    double start = milliseconds();
    CHECK_EQ(
        sf_weights_create(f->covered, f->handles, f->count, &options, NULL, NULL, &weights, &fault),
        SF_OK);
    *took = milliseconds() - start;
    printf("%s%s", fault.message[0] != '\0' ? "# " : "", fault.message);
    return weights;
}

// Weights of all vertices, which must lie in the domain: in voxels of the covered solid.
static double *sample(const figure *f, const sf_weights *weights)
{
    sf_lattice l = sf_grid_lattice(f->covered);
    size_t count = f->view.vertex_count;
    double *w = malloc(count * f->count * sizeof *w);
    CHECK_EQ(sf_weights_sample(weights, f->view.vertices, count, NULL, w), SF_OK);
    for (size_t i = 0; i < count; i++) {
        const double *p = f->view.vertices + 3 * i;
        double sum = 0;
        int near = 0;
        for (size_t j = 0; j < f->count; j++) {
            CHECK(w[i * f->count + j] >= 0 && w[i * f->count + j] <= 1);
            sum += w[i * f->count + j];
        }
        CHECK_NEAR(sum, 1, 1e-14);
        // On a plane between two voxels either will do.
        for (int c = 0; c < 8; c++) {
            double q[3];
            for (int d = 0; d < 3; d++) {
                q[d] = (p[d] - l.origin_mm[d]) / l.layer_mm + (c >> d & 1 ? 4e-3 : -4e-3);
            }
            near |= sf_slice_get(sf_grid_slice(f->covered, (uint32_t)q[2]), (uint32_t)q[0],
                                 (uint32_t)q[1]);
        }
        CHECK(near);
    }
    return w;
}

// Bend all vertices a little, and look for where they came from.
static void there_and_back(const figure *f, const sf_weights *weights, const double *w)
{
    size_t count = f->view.vertex_count, missed = 7, strayed = 0;
    double *bent = malloc(6 * count * sizeof *bent), *rest = bent + 3 * count;
    sf_pose poses[HANDLES_MAX];
    for (size_t j = 0; j < f->count; j++) {
        double a = 0.02 * f->size_mm * (j % 3 == 1 ? 1 : -1), turn = j % 2 == 0 ? 0.1 : -0.1;
        sf_pose_change change = {j % 3 == 0 ? 0.1 : -0.05, {a, 0.5 * a, -a}, {turn, 0, turn}};
        poses[j] = sf_pose_identity();
        if (j > 0) {
            CHECK_EQ(sf_pose_move(&poses[j], &change), SF_OK);
        }
    }
    sf_blend blend = {f->view.vertices, w, count, sf_weights_centers(weights), f->count};
    sf_fold fold;
    CHECK_EQ(sf_blend_apply(blend, poses, NULL, bent), SF_OK);
    CHECK_EQ(sf_weights_fold(weights, poses, NULL, &fold), SF_OK);
    memcpy(rest, bent, 3 * count * sizeof *rest);
    double start = milliseconds();
    CHECK_EQ(sf_weights_unbend(weights, poses, bent, count, 1e-9 * f->size_mm, NULL, NULL, rest,
                               NULL, &missed),
             SF_OK);
    double took = milliseconds() - start;
    for (size_t i = 0; i < 3 * count; i++) {
        strayed += fabs(rest[i] - f->view.vertices[i]) > 1e-6 * f->size_mm;
    }
    printf("#     least determinant %.2f; %zu vertices come back in %.0f ms, %zu missed, %zu of "
           "3 coordinates elsewhere\n",
           fold.least_det, count, took, missed, strayed);
    CHECK_EQ(missed, 0);
    CHECK(strayed * 50 < count);
    free(bent);
}

static void compare(const char *path, double ball, double most, double most_rms)
{
    figure f;
    double took[2], worst = 0, square = 0;
    if (!begin(&f, path, ball)) {
        return;
    }
    sf_weights *clamped = make(&f, SF_WEIGHTS_CLAMPED, &took[0]),
               *bounded = make(&f, SF_WEIGHTS_BOUNDED, &took[1]);
    sf_weights_facts a = sf_weights_describe(clamped), b = sf_weights_describe(bounded);
    double *v = sample(&f, clamped), *w = sample(&f, bounded);
    size_t numbers = f.view.vertex_count * f.count;
    for (size_t n = 0; n < numbers; n++) {
        worst = fabs(v[n] - w[n]) > worst ? fabs(v[n] - w[n]) : worst;
        square += (v[n] - w[n]) * (v[n] - w[n]);
    }
    double rms = sqrt(square / (double)numbers);
    printf("# %s, %zu %s: %zu cells, %zu corners; clamped %.0f ms, %u steps; bounded %.0f ms, %u "
           "steps, residual %.0e; apart by %.3f at most, %.4f rms\n",
           path, f.count - 1, ball > 0 ? "balls" : "points", a.cell_count, a.node_count, took[0],
           a.iterations, took[1], b.iterations, b.residual, worst, rms);
    CHECK(worst <= most && rms <= most_rms);
    CHECK(f.count >= 3 && a.loose_count == 0 && a.residual <= 1e-5 && b.residual <= 1e-5);
    there_and_back(&f, clamped, v);
    free(v);
    free(w);
    sf_weights_destroy(clamped);
    sf_weights_destroy(bounded);
    end(&f);
}

static void points_on_models(void)
{
    if (getenv("SF_DATA") == NULL) {
        SKIP("SF_DATA is not set");
    }
    for (int m = 0; m < 4; m++) {
        compare(models[m], 0, 0.2, 0.04);
    }
}

static void balls_on_models(void)
{
    if (getenv("SF_DATA") == NULL) {
        SKIP("SF_DATA is not set");
    }
    for (int m = 0; m < 4; m++) {
        compare(models[m], 0.5, 0.15, 0.04);
    }
}

int main(int argc, char **argv)
{
    cells_wanted = argc > 1 ? atof(argv[1]) : cells_wanted;
    TEST(points_on_models);
    TEST(balls_on_models);
    return test_finish();
}
