// SPDX-License-Identifier: MIT
// Why: results are the same bytes for any instruction set, number of threads, compiler, level of
// optimisation and machine. A fixed list of jobs is done, and what comes out, every bit of it,
// doubles too, must have the hash that stands here. On one machine it is done with every
// instruction set that the processor has and with 1 to 16 threads; tests/cross/run.sh does it with
// other compilers, other levels and, by qemu, on other machines, one of which keeps numbers the
// other way round.
//
// The shapes are made of rational numbers, so no C library has a say in them. When a result is
// meant to change, `jobs --print` has the new table.

#include "unit/grade/limits.h"
#include "unit/grade/threads.h"

#include <sf/sf.h>

typedef struct work {
    uint64_t hash;
    sf_task *task;
} work;

static int thread_count = 1;

// FNV-1a (Fowler, Noll, Vo, 1991), lowest byte first.
static void add_word(work *w, uint64_t word)
{
    for (int i = 0; i < 8; i++) {
        w->hash = (w->hash ^ (word >> 8 * i & 255)) * UINT64_C(0x100000001b3);
    }
}

static void add_doubles(work *w, const double *values, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        uint64_t bits;
        memcpy(&bits, &values[i], sizeof bits);
        add_word(w, bits);
    }
}

static void add_slice(work *w, sf_slice s)
{
    for (uint32_t y = 0; y < s.height; y++) {
        for (uint32_t i = 0; i < (s.width + 63) / 64; i++) {
            add_word(w, s.words[y * s.stride + i]);
        }
    }
}

static void add_grid(work *w, const sf_grid *grid)
{
    for (uint32_t k = 0; k < sf_grid_lattice(grid).nz; k++) {
        add_slice(w, sf_grid_slice(grid, k));
    }
}

static void add_mesh(work *w, sf_mesh_view mesh)
{
    add_word(w, mesh.vertex_count);
    add_word(w, mesh.triangle_count);
    add_doubles(w, mesh.vertices, 3 * mesh.vertex_count);
    for (size_t i = 0; i < 3 * mesh.triangle_count; i++) {
        add_word(w, mesh.triangles[i]);
    }
}

static void must(sf_status status, const char *what)
{
    CHECK_EQ(status, SF_OK);
    if (status != SF_OK) {
        printf("# %s\n", what);
    }
}

// ---------------------------------------------------------------------------------------------
// Shapes
// ---------------------------------------------------------------------------------------------

enum { RINGS = 25, AROUND = 32, HEIGHT = 48 };

// Place i of AROUND on a circle, by a quarter's rational numbers: no sine has a say.
static void circle(int i, double *x, double *y)
{
    double t = (i % (AROUND / 4)) / (AROUND / 4.0), s = 1 + t * t;
    double a = (1 - t * t) / s, b = 2 * t / s;
    int quarter = i / (AROUND / 4);
    *x = quarter == 0 ? a : quarter == 1 ? -b : quarter == 2 ? -a : b;
    *y = quarter == 0 ? b : quarter == 1 ? a : quarter == 2 ? -b : -a;
}

// A bottle that leans, its foot on z = 0, with a bulge that hangs over.
static sf_mesh *bottle(double lean)
{
    sf_mesh *mesh = NULL;
    must(sf_mesh_create(NULL, &mesh), "a mesh");
    for (int r = 0; r < RINGS; r++) {
        double at = r / (RINGS - 1.0), radius = 5 + 20 * at * (1 - at) - 2 * at;
        for (int i = 0; i < AROUND; i++) {
            double x, y;
            circle(i, &x, &y);
            const double p[3] = {lean * HEIGHT * at + radius * x, radius * y, HEIGHT * at};
            must(sf_mesh_add_vertices(mesh, p, 1), "a vertex");
        }
    }
    const double ends[6] = {0, 0, 0, lean * HEIGHT, 0, HEIGHT};
    must(sf_mesh_add_vertices(mesh, ends, 2), "the ends");
    for (uint32_t i = 0; i < AROUND; i++) {
        uint32_t next = (i + 1) % AROUND, top = (RINGS - 1) * AROUND, foot = RINGS * AROUND;
        const uint32_t lids[6] = {foot, next, i, foot + 1, top + i, top + next};
        must(sf_mesh_add_triangles(mesh, lids, 2), "the lids");
        for (uint32_t r = 0; r + 1 < RINGS; r++) {
            uint32_t a = r * AROUND + i, b = r * AROUND + next;
            const uint32_t side[6] = {a, b, b + AROUND, a, b + AROUND, a + AROUND};
            must(sf_mesh_add_triangles(mesh, side, 2), "a side");
        }
    }
    return mesh;
}

static sf_lattice lattice_of(double pitch)
{
    sf_lattice l = {.pitch_x_mm = pitch, .pitch_y_mm = pitch, .layer_mm = pitch};
    l.nx = (uint32_t)(36 / pitch);
    l.ny = (uint32_t)(22 / pitch);
    l.nz = (uint32_t)(50 / pitch);
    l.origin_mm[0] = -10;
    l.origin_mm[1] = -11;
    l.origin_mm[2] = -0.25;
    return l;
}

// The bottle in voxels, and a roof beside it that hangs in the air.
static sf_grid *bottle_grid(double pitch, work *w)
{
    sf_lattice l = lattice_of(pitch);
    sf_mesh *mesh = bottle(0.3);
    sf_grid *grid = NULL;
    must(sf_grid_create(&l, NULL, &grid), "a grid");
    must(sf_grid_voxelize(grid, sf_mesh_get_view(mesh), NULL, NULL, w->task, NULL), "voxels");
    for (uint32_t k = l.nz / 2; k < l.nz / 2 + 3; k++) {
        sf_rect roof = {l.nx - 9, 3, l.nx - 2, l.ny - 6};
        must(sf_slice_fill(sf_grid_slice(grid, k), roof, 1), "a roof");
    }
    sf_mesh_destroy(mesh);
    return grid;
}

static sf_rule rule_of(sf_rule_kind kind, double angle, const sf_grid *grid)
{
    sf_rule rule = sf_rule_box3();
    sf_lattice l = sf_grid_lattice(grid);
    must(sf_rule_make(kind, angle, &l, NULL, &rule, NULL), "a rule");
    return rule;
}

// ---------------------------------------------------------------------------------------------
// Jobs
// ---------------------------------------------------------------------------------------------

static void voxelise(work *w)
{
    sf_grid *grid = bottle_grid(0.3, w);
    add_grid(w, grid);
    sf_grid_destroy(grid);
}

static void trim(work *w)
{
    for (int kind = 0; kind < 5; kind++) {
        static const double angles[5] = {0.7, 0.6, 1.3, 0.65, 0.8};
        sf_grid *grid = bottle_grid(0.3, w);
        sf_lattice l = sf_grid_lattice(grid);
        sf_rule rule = rule_of(kind < 4 ? (sf_rule_kind)kind : SF_RULE_SLACK, angles[kind], grid);
        if (kind == 4) {
            must(sf_rule_set_bridges(&rule, 4, 0.6, &l, NULL), "bridges");
        }
        must(sf_grid_trim(grid, &rule, SF_BED_AUTO, w->task, NULL), "a trim");
        add_grid(w, grid);
        sf_grid_destroy(grid);
    }
}

// A check with all its findings, and the same by the checker on a chip.
static void check(work *w)
{
    sf_grid *grid = bottle_grid(0.3, w);
    sf_lattice l = sf_grid_lattice(grid);
    static sf_finding findings[200];
    sf_check_options o = sf_check_options_default();
    sf_check_report report;
    size_t count = 0;
    o.rule = rule_of(SF_RULE_OCTAGON, 0.6, grid);
    o.findings = findings;
    o.finding_capacity = 200;
    must(sf_grid_check(grid, &o, NULL, w->task, &report, &count), "a check");
    add_word(w, report.unsupported_voxels);
    add_word(w, report.trimmed_voxels);
    for (size_t i = 0; i < count; i++) {
        add_word(w, (uint64_t)findings[i].kind << 32 | findings[i].cause);
        add_word(w, findings[i].area);
        add_word(w, findings[i].volume);
        add_word(w, (uint64_t)findings[i].box.x0 << 32 | findings[i].box.y1);
    }
    uint8_t digest[SF_SHA256_SIZE];
    must(sf_grid_sha256(grid, w->task, digest), "a fingerprint");
    for (int i = 0; i < SF_SHA256_SIZE; i++) {
        add_word(w, digest[i]);
    }
    add_word(w, l.nz);
    sf_grid_destroy(grid);
}

static void repair(work *w)
{
    for (int width = 1; width < 4; width += 2) {
        sf_grid *grid = bottle_grid(0.6, w);
        sf_repair_options o = sf_repair_options_default();
        sf_repair_report report;
        o.terms.rule = rule_of(SF_RULE_OCTAGON, 0.6, grid);
        o.min_feature_vx = (uint32_t)width;
        must(sf_grid_repair(grid, &o, NULL, w->task, NULL, &report), "a repair");
        add_grid(w, grid);
        add_word(w, report.cost);
        sf_grid_destroy(grid);
    }
}

static void grow(work *w)
{
    sf_grid *grid = bottle_grid(0.6, w);
    sf_terms terms = sf_terms_default();
    terms.rule = rule_of(SF_RULE_SLACK, 0.7, grid);
    must(sf_grid_grow(grid, &terms, NULL, w->task, NULL, NULL), "to grow");
    add_grid(w, grid);
    sf_grid_destroy(grid);
}

static void surface(work *w)
{
    sf_grid *grid = bottle_grid(0.7, w);
    sf_surface_options o = sf_surface_options_default();
    for (o.smooth_passes = 0; o.smooth_passes < 10; o.smooth_passes += 5) {
        sf_mesh *mesh = NULL;
        must(sf_grid_surface(grid, &o, NULL, w->task, &mesh), "a surface");
        add_mesh(w, sf_mesh_get_view(mesh));
        sf_mesh_destroy(mesh);
    }
    sf_grid_destroy(grid);
}

static void carve(work *w)
{
    sf_mesh *mesh = bottle(0.3);
    sf_grid *grid = bottle_grid(0.6, w), *wall = NULL, *result = NULL;
    sf_stance_options upright = sf_stance_options_default();
    sf_stance *stance = NULL;
    sf_terms terms = sf_terms_default();
    must(sf_stance_create(sf_mesh_get_view(mesh), &upright, NULL, &stance, NULL), "a stance");
    must(sf_grid_clone(grid, NULL, &wall), "a wall");
    must(sf_grid_clone(grid, NULL, &result), "a result");
    must(sf_grid_wall(grid, sf_mesh_get_view(mesh), 1.5, NULL, w->task, wall), "the wall");
    add_grid(w, wall);
    terms.rule = rule_of(SF_RULE_OCTAGON, 0.785, grid);
    const sf_stance *stances[1] = {stance};
    for (int mode = 0; mode < 2; mode++) {
        sf_carve_options o = sf_carve_options_default();
        sf_carve_report report;
        o.mode = mode == 0 ? SF_CARVE_SUPPORT_FREE : SF_CARVE_PLANE;
        o.stances = stances;
        o.stance_count = 1;
        must(sf_grid_carve(grid, wall, mode == 0 ? &terms : NULL, &o, NULL, w->task, result,
                           &report),
             "a cavity");
        add_grid(w, result);
        add_doubles(w, &report.slack_mm, 1);
        add_doubles(w, report.after.moment, 3);
    }
    sf_stance_destroy(stance);
    sf_grid_destroy(result);
    sf_grid_destroy(wall);
    sf_grid_destroy(grid);
    sf_mesh_destroy(mesh);
}

static void stand(work *w)
{
    sf_mesh *mesh = bottle(0.35);
    sf_handle handles[3];
    sf_stance_options upright = sf_stance_options_default();
    sf_stand *standing = NULL;
    for (int j = 0; j < 3; j++) {
        double z = 16 + 13 * j;
        sf_handle h = {.kind = SF_HANDLE_POINT, .at_mm = {0.35 * z, 0, z}};
        handles[j] = h;
    }
    sf_stand_options o = sf_stand_options_default();
    o.pitch_mm = 1.5;
    o.wall_mm = 1.6;
    o.rounds_max = 6;
    must(sf_stand_create(sf_mesh_get_view(mesh), &upright, 1, handles, 3, &o, NULL, w->task,
                         &standing, NULL),
         "to begin");
    must(sf_stand_run(standing, w->task, NULL), "to stand");
    add_mesh(w, sf_stand_outer(standing));
    add_mesh(w, sf_stand_cavity(standing));
    add_word(w, sf_stand_describe(standing).rounds);
    sf_stand_destroy(standing);
    sf_mesh_destroy(mesh);
}

// A beam of cells, bent, with a property at its corners that is the same on every machine.
static test_cage beam(void)
{
    test_cage c = test_cage_block(4, 2, 2);
    c.values = calloc(c.points, sizeof *c.values);
    for (size_t i = 0; i < c.points; i++) {
        double *p = c.positions + 3 * i, x = p[0];
        p[2] += 0.11 * x * (4 - x);
        p[1] += 0.07 * x;
        c.values[i] = (double)(i * 7 % 16) / 16;
    }
    return c;
}

// Slices of the beam; each of them is halftoned where ids are given.
static void slice_beam(work *w, const sf_halftone *halftone)
{
    test_cage c = beam();
    sf_limit *limit = limit_of(&c, SF_REFINE_STANDARD);
    sf_lattice l = {.nx = 90,
                    .ny = 60,
                    .nz = 40,
                    .pitch_x_mm = 0.05,
                    .pitch_y_mm = 0.05,
                    .layer_mm = 0.07,
                    .origin_mm = {-0.1, -0.1, -0.1}};
    size_t area = (size_t)l.nx * l.ny;
    static const size_t numbers[1] = {0};
    sf_sampler *sampler = NULL;
    sf_grid *grid = NULL;
    double *values = calloc(area, sizeof *values);
    uint8_t *ids = calloc(area, 1);
    must(sf_sampler_create(limit, &l, NULL, 1, numbers, NULL, w->task, &sampler, NULL), "slices");
    must(sf_grid_create(&l, NULL, &grid), "a grid");
    for (uint32_t k = 0; k < l.nz; k += 3) {
        sf_slice solid = sf_grid_slice(grid, k);
        sf_tone_plane plane = {values, l.nx};
        sf_tones tones = {.struct_size = sizeof tones, .width = l.nx, .height = l.ny, .layer = k};
        sf_materials out = {.ids = ids, .ids_stride = l.nx};
        must(sf_sampler_slice(sampler, k, solid, &values), "a slice");
        if (halftone == NULL) {
            add_slice(w, solid);
            add_doubles(w, values, area);
            continue;
        }
        tones.type = SF_TONE_F64;
        tones.planes = &plane;
        tones.solid = solid;
        must(sf_halftone_slice(halftone, &tones, &out, w->task), "a halftone");
        for (size_t i = 0; i < area; i++) {
            add_word(w, ids[i]);
        }
    }
    free(values);
    free(ids);
    sf_grid_destroy(grid);
    sf_sampler_destroy(sampler);
    sf_limit_destroy(limit);
    test_cage_free(&c);
}

static void grade(work *w)
{
    slice_beam(w, NULL);
}

static void halftone(work *w)
{
    sf_mask_options o = sf_mask_options_default();
    sf_mask *mask = NULL;
    sf_halftone *built_in = NULL, *made = NULL;
    o.nx = o.ny = o.nz = 8;
    must(sf_mask_create(&o, NULL, w->task, &mask), "a mask");
    must(sf_halftone_create(sf_mask_builtin(), 2, NULL, &built_in), "the mask that is there");
    must(sf_halftone_create(mask, 2, NULL, &made), "another one");
    slice_beam(w, built_in);
    slice_beam(w, made);
    sf_halftone_destroy(built_in);
    sf_halftone_destroy(made);
    sf_mask_destroy(mask);
}

static void orient(work *w)
{
    sf_mesh *mesh = bottle(0.3);
    sf_orient_options o = sf_orient_options_default();
    sf_orientation found[3];
    o.coarse_resolution = 24;
    o.resolution = 48;
    o.coarse_count = 12;
    o.fine_count = 3;
    size_t count = 0;
    must(sf_mesh_orient(sf_mesh_get_view(mesh), &o, NULL, w->task, found, 3, &count, NULL),
         "ways up");
    for (size_t i = 0; i < count; i++) {
        add_doubles(w, found[i].up, 3);
        add_doubles(w, &found[i].unsupported_mm2, 1);
        add_doubles(w, &found[i].margin_rad, 1);
        add_doubles(w, &found[i].score, 1);
        add_word(w, found[i].trimmed_voxels);
    }
    sf_mesh_destroy(mesh);
}

// ---------------------------------------------------------------------------------------------
// The list
// ---------------------------------------------------------------------------------------------

static const struct {
    const char *name;
    void (*job)(work *w);
    uint64_t hash;
} jobs[] = {
    {"voxelise", voxelise, UINT64_C(0x870770478766f52a)},
    {"trim", trim, UINT64_C(0x18bf0b34af20cd11)},
    {"check", check, UINT64_C(0x6223cfce3df63852)},
    {"repair", repair, UINT64_C(0x917a72b22b0bd99d)},
    {"grow", grow, UINT64_C(0x5ec12603cb414b52)},
    {"surface", surface, UINT64_C(0xa1c0f58d85631588)},
    {"carve", carve, UINT64_C(0xfc7563a9cec83d68)},
    {"stand", stand, UINT64_C(0x89ee2da432f1782b)},
    {"grade", grade, UINT64_C(0x923d1dff02a71ad9)},
    {"halftone", halftone, UINT64_C(0x44d0819d9814e606)},
    {"orient", orient, UINT64_C(0xb9efb9c570b964a5)},
};
enum { JOBS = sizeof jobs / sizeof jobs[0] };

static uint64_t do_job(int i, int threads)
{
    sf_task task = crowd_task(&thread_count);
    work w = {UINT64_C(0xcbf29ce484222325), threads > 0 ? &task : NULL};
    thread_count = threads;
    jobs[i].job(&w);
    return w.hash;
}

static void check_job(int i, int threads, const char *isa)
{
    uint64_t hash = do_job(i, threads);
    if (hash != jobs[i].hash && test_report(__FILE__, __LINE__, jobs[i].name)) {
        printf("#   %016llx, not %016llx, with %s and %d threads\n", (unsigned long long)hash,
               (unsigned long long)jobs[i].hash, isa, threads);
    }
}

static void alone(void)
{
    for (int i = 0; i < JOBS; i++) {
        check_job(i, 0, sf_isa_limit(SF_ISA_COUNT));
    }
}

static void every_instruction_set(void)
{
    const char *before = "";
    for (int isa = 0; isa < SF_ISA_COUNT; isa++) {
        const char *name = sf_isa_limit((sf_isa)isa);
        for (int i = 0; strcmp(name, before) != 0 && i < JOBS; i++) {
            check_job(i, 0, name);
        }
        before = name;
    }
    sf_isa_limit(SF_ISA_COUNT);
}

static void any_number_of_threads(void)
{
    static const int threads[5] = {1, 2, 3, 7, 16};
    for (int t = 0; t < 5; t++) {
        for (int i = 0; i < JOBS; i++) {
            check_job(i, threads[t], sf_isa_limit(SF_ISA_COUNT));
        }
    }
}

int main(int count, char **words)
{
    if (count == 2 && strcmp(words[1], "--print") == 0) {
        for (int i = 0; i < JOBS; i++) {
            printf("%s %016llx\n", jobs[i].name, (unsigned long long)do_job(i, 0));
        }
        return test_case_failures > 0;
    }
    TEST(alone);
    if (count == 1) { // any word: only once, for a machine that is not really there
        TEST(every_instruction_set);
        TEST(any_number_of_threads);
    }
    return test_finish();
}
