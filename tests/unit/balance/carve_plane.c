// SPDX-License-Identifier: MIT
// Why: the plane's order is the paper's method, and what others are compared with. It is held
// against a second telling that sums every prefix anew, voxel by voxel, in quadratic time, for one
// base and for several, with densities, ballast and layers of any height; the wall stays, nothing
// is added, each goal does what it says, and the report says what is there.

#include "balance/carve/carve.h"
#include "failing_allocator.h"
#include "law/stack.h"

enum { VOXELS = 2048 };

typedef struct scene {
    sf_lattice lattice;
    sf_grid *solid, *wall, *result;
    float density[VOXELS];
    sf_halfspace h[2][8];
    sfi_base bases[2];
    size_t base_count;
    sf_carve_options options;
} scene;

static const double heights[] = {1, 0.5, 0.75, 1.5, 0.5, 1, 1, 2};

// A polygon of safe places around a point of the ground, its sides slanted.
static void make_base(sfi_base *base, sf_halfspace *h, int count, double x, double y, double size)
{
    double tilt = 0.1 * test_random_unit();
    memset(base, 0, sizeof *base);
    base->up[2] = 1;
    base->halfspaces = h;
    base->count = (size_t)count;
    for (int i = 0; i < count; i++) {
        double turn = 6.283185307179586 * i / count, length = sqrt(1 + tilt * tilt);
        h[i].normal[0] = cos(turn) / length;
        h[i].normal[1] = sin(turn) / length;
        h[i].normal[2] = -tilt / length;
        h[i].offset_mm = h[i].normal[0] * x + h[i].normal[1] * y - size / length;
    }
}

static void begin(scene *s, int kind)
{
    sf_lattice lattice = {14, 9, 8, 0.5, 1, 0.75, kind % 3 == 1 ? heights : NULL, {1, -2, 0}};
    memset(s, 0, sizeof *s);
    s->lattice = lattice;
    CHECK_EQ(sf_grid_create(&lattice, NULL, &s->solid), SF_OK);
    CHECK_EQ(sf_grid_create(&lattice, NULL, &s->wall), SF_OK);
    CHECK_EQ(sf_grid_create(&lattice, NULL, &s->result), SF_OK);
    for (uint32_t i = 0; i < 14 * 9 * 8; i++) {
        uint32_t x = i % 14, y = i / 14 % 9, k = i / 126;
        int in = (int)x + (int)k >= 3 && y < 9 - k / 3;
        int wall = in && (x < 1 || x > 12 || y < 1 || y + 1 >= 9 - k / 3 || k == 0 || k == 7 ||
                          test_random_below(12) == 0);
        CHECK_EQ(sf_slice_set(sf_grid_slice(s->solid, k), x, y, in), SF_OK);
        CHECK_EQ(sf_slice_set(sf_grid_slice(s->wall, k), x, y, wall), SF_OK);
        s->density[i] = (float)(0.5 + test_random_unit());
    }
    s->options = sf_carve_options_default();
    s->options.mode = SF_CARVE_PLANE;
    s->options.density = kind % 2 ? s->density : NULL;
    if (kind % 5 == 3) {
        sf_ballast magnet = {6, {2, 3, 1}};
        s->options.rest = sf_ballast_body(&magnet, 1);
    }
    s->base_count = kind % 4 == 2 ? 2 : 1;
    make_base(&s->bases[0], s->h[0], 3 + kind % 5, 3.5 + 1.5 * test_random_unit(),
              0.5 + 2 * test_random_unit(), 0.4);
    make_base(&s->bases[1], s->h[1], 4, 4 + test_random_unit(), 0.5 + 2 * test_random_unit(), 0.3);
    if (kind % 4 == 2) { // lying on its side: another up
        double *up = s->bases[1].up;
        up[0] = 0.6;
        up[2] = 0.8;
    }
}

static void end(scene *s)
{
    sf_grid_destroy(s->solid);
    sf_grid_destroy(s->wall);
    sf_grid_destroy(s->result);
}

static sf_status carve(scene *s, const sf_allocator *allocator, sf_task *task, sf_carve_report *r)
{
    return sfi_carve(s->solid, s->wall, NULL, &s->options, s->bases, s->base_count, allocator, task,
                     s->result, r);
}

// ---------------------------------------------------------------------------------------------
// The second telling
// ---------------------------------------------------------------------------------------------

typedef struct voxel {
    double r[3], mass, d;
    uint32_t index, key;
    int in, is_free;
} voxel;

typedef struct telling {
    voxel v[VOXELS];
    int count;
    int order[VOXELS]; // voxels beyond the planes, the farthest first
    int order_count;
    double target[2][2];
} telling;

static telling told;

static void tell(const scene *s)
{
    told.count = (int)(s->lattice.nx * s->lattice.ny * s->lattice.nz);
    for (int i = 0; i < told.count; i++) {
        uint32_t x = (uint32_t)i % 14, y = (uint32_t)i / 14 % 9, k = (uint32_t)i / 126;
        voxel *v = &told.v[i];
        double z = sf_lattice_layer_bottom(&s->lattice, k);
        double h = sf_lattice_layer_height(&s->lattice, k);
        v->r[0] = 1 + (x + 0.5) * 0.5;
        v->r[1] = -2 + (y + 0.5);
        v->r[2] = z + 0.5 * h;
        v->mass = 0.5 * h * (s->options.density != NULL ? (double)s->density[i] : 1);
        v->in = sf_slice_get(sf_grid_slice(s->solid, k), x, y);
        v->is_free = v->in && !sf_slice_get(sf_grid_slice(s->wall, k), x, y);
        v->index = (uint32_t)i;
    }
}

static void center(const scene *s, double com[3])
{
    double mass = s->options.rest.mass;
    for (int j = 0; j < 3; j++) {
        com[j] = s->options.rest.moment[j];
    }
    for (int i = 0; i < told.count; i++) {
        for (int j = 0; told.v[i].in && j < 3; j++) {
            com[j] += told.v[i].mass * told.v[i].r[j];
        }
        mass += told.v[i].in ? told.v[i].mass : 0;
    }
    for (int j = 0; j < 3; j++) {
        com[j] /= mass;
    }
}

static double slack(const scene *s, const double com[3])
{
    double least = 1e300;
    for (size_t b = 0; b < s->base_count; b++) {
        for (size_t i = 0; i < s->bases[b].count; i++) {
            const sf_halfspace *h = &s->bases[b].halfspaces[i];
            least = fmin(least, h->normal[0] * com[0] + h->normal[1] * com[1] +
                                    h->normal[2] * com[2] - h->offset_mm);
        }
    }
    return least;
}

static double energy(const scene *s, const double from[3], const double com[3])
{
    double sum = 0;
    for (size_t b = 0; b < s->base_count; b++) {
        double across[2][3];
        sfi_base_across(&s->bases[b], across);
        for (int e = 0; e < 2; e++) {
            double d = -told.target[b][e];
            for (int j = 0; j < 3; j++) {
                d += across[e][j] * (com[j] - from[j]);
            }
            sum += d * d;
        }
    }
    return sum;
}

static int by_key(const void *a, const void *b)
{
    const voxel *p = &told.v[*(const int *)a], *q = &told.v[*(const int *)b];
    return p->key != q->key ? (p->key < q->key) - (p->key > q->key)
                            : (p->index > q->index) - (p->index < q->index);
}

static void sort_by_planes(const scene *s, const double com[3])
{
    double most = 0, scratch[128];
    for (int i = 0; i < told.count; i++) {
        told.v[i].d = 0;
    }
    for (size_t b = 0; b < s->base_count; b++) {
        double across[2][3];
        sfi_base_across(&s->bases[b], across);
        sfi_offset to = sfi_base_target(&s->bases[b], com,
                                        s->options.goal == SF_CARVE_DEEPEST ? SFI_TARGET_DEEPEST
                                                                            : SFI_TARGET_NEAREST,
                                        20, scratch);
        memcpy(told.target[b], to.along, sizeof told.target[b]);
        for (int i = 0; i < told.count; i++) {
            double d = 0; // (r - c*) . (c - c*), across
            for (int e = 0; e < 2; e++) {
                double along = 0;
                for (int j = 0; j < 3; j++) {
                    along += across[e][j] * (told.v[i].r[j] - com[j]);
                }
                d += (along - to.along[e]) * -to.along[e];
            }
            told.v[i].d += d > 0 ? d : 0;
        }
    }
    told.order_count = 0;
    for (int i = 0; i < told.count; i++) {
        if (told.v[i].in && told.v[i].is_free && told.v[i].d > 0) {
            told.order[told.order_count++] = i;
            most = fmax(most, told.v[i].d);
        }
    }
    for (int i = 0; i < told.count; i++) {
        told.v[i].key = most > 0 ? (uint32_t)(told.v[i].d / most * 4294967294.0 + 0.5) : 0;
    }
    qsort(told.order, (size_t)told.order_count, sizeof told.order[0], by_key);
}

// One round; returns how many were removed.
static int carve_once(const scene *s)
{
    double from[3], com[3];
    center(s, from);
    if (s->options.goal == SF_CARVE_ENOUGH && slack(s, from) >= 0) {
        return 0;
    }
    sort_by_planes(s, from);
    int deepest = s->options.goal == SF_CARVE_DEEPEST, best = 0, safe = 0;
    double least = deepest ? -slack(s, from) : energy(s, from, from);
    for (int i = 0; i < told.order_count && !safe; i++) {
        told.v[told.order[i]].in = 0;
        center(s, com);
        double here = deepest ? -slack(s, com) : energy(s, from, com);
        safe = s->options.goal == SF_CARVE_ENOUGH && slack(s, com) >= 1e-10;
        if (safe || here < least) {
            least = here;
            best = i + 1;
        }
    }
    for (int i = best; i < told.order_count; i++) {
        told.v[told.order[i]].in = 1;
    }
    return best;
}

static int carve_slowly(const scene *s)
{
    int first = 0, taken = 1, rounds = 0;
    tell(s);
    while (taken > 0 && rounds < 64) {
        taken = carve_once(s);
        first = rounds == 0 ? told.order_count : first;
        rounds += taken > 0;
        if (taken < first / 1000) {
            break;
        }
    }
    return rounds;
}

// ---------------------------------------------------------------------------------------------
// Comparing
// ---------------------------------------------------------------------------------------------

static void compare(const scene *s, const sf_carve_report *r, int rounds)
{
    uint64_t removed = 0, differ = 0, wall = 0;
    double com[3], found[3];
    for (int i = 0; i < told.count; i++) {
        uint32_t x = (uint32_t)i % 14, y = (uint32_t)i / 14 % 9, k = (uint32_t)i / 126;
        int is = sf_slice_get(sf_grid_slice(s->result, k), x, y);
        int was = sf_slice_get(sf_grid_slice(s->solid, k), x, y);
        CHECK(was || !is);
        CHECK(is || !was || told.v[i].is_free);
        differ += (uint64_t)(is != told.v[i].in);
        removed += (uint64_t)(was && !is);
        wall += (uint64_t)(was && !told.v[i].is_free);
    }
    CHECK_EQ(differ, 0);
    CHECK_EQ(r->rounds, rounds);
    CHECK_EQ(r->removed_voxels, removed);
    CHECK_EQ(r->wall_voxels, wall);
    CHECK_EQ(r->solid_voxels, r->wall_voxels + r->removed_voxels + r->kept_voxels);
    center(s, com);
    CHECK_EQ(sf_body_com(r->after, found), SF_OK);
    for (int j = 0; j < 3; j++) {
        CHECK_NEAR(com[j], found[j], 1e-12);
    }
    CHECK_NEAR(r->slack_mm, slack(s, com), 1e-12);
    CHECK_EQ(r->safe, r->slack_mm >= 0);
}

static void slow_and_fast_agree(void)
{
    int safe = 0, unsafe = 0, several = 0;
    for (int kind = 0; kind < 120; kind++) {
        for (int goal = 0; goal < 3; goal++) {
            static scene s;
            sf_carve_report r;
            test_reseed((uint64_t)kind + 7);
            begin(&s, kind);
            s.options.goal = (sf_carve_goal)goal;
            CHECK_EQ(carve(&s, NULL, NULL, &r), SF_OK);
            compare(&s, &r, carve_slowly(&s));
            CHECK(r.distance_mm <= r.distance_before_mm + 1e-9 || goal == SF_CARVE_DEEPEST);
            CHECK(goal != SF_CARVE_DEEPEST || r.slack_mm >= r.slack_before_mm - 1e-12);
            CHECK_EQ(r.safe, r.distance_mm == 0);
            safe += r.safe && r.slack_before_mm < 0;
            unsafe += !r.safe;
            several += r.rounds > 1;
            end(&s);
        }
    }
    CHECK(safe > 20 && unsafe > 20 && several > 20);
}

// Enough leaves at least as much as the nearest where both are safe; the deepest has most slack.
static void goals_are_what_they_say(void)
{
    for (int kind = 0; kind < 60; kind++) {
        sf_carve_report r[3];
        for (int goal = 0; goal < 3; goal++) {
            static scene s;
            test_reseed((uint64_t)kind + 7);
            begin(&s, kind);
            s.options.goal = (sf_carve_goal)goal;
            CHECK_EQ(carve(&s, NULL, NULL, &r[goal]), SF_OK);
            end(&s);
        }
        if (r[0].slack_before_mm >= 0) {
            CHECK_EQ(r[0].removed_voxels, 0);
            CHECK_EQ(r[1].removed_voxels, 0);
        }
        CHECK(r[2].slack_mm >= r[2].slack_before_mm);
        if (r[0].safe && r[1].safe && r[0].rounds <= 1 && r[1].rounds <= 1) {
            CHECK(r[0].removed_voxels <= r[1].removed_voxels);
        }
    }
}

// ---------------------------------------------------------------------------------------------
// Pieces and calls
// ---------------------------------------------------------------------------------------------

// Voxels of the result that hold together and hang on no wall.
static void floating_pieces_are_counted(void)
{
    sf_lattice lattice = stack_lattice(9, 9, 9);
    scene s;
    memset(&s, 0, sizeof s);
    s.lattice = lattice;
    sf_grid *grids[3];
    for (int i = 0; i < 3; i++) {
        CHECK_EQ(sf_grid_create(&lattice, NULL, &grids[i]), SF_OK);
    }
    for (uint32_t i = 0; i < 729; i++) {
        uint32_t x = i % 9, y = i / 9 % 9, k = i / 81;
        int shell = x % 8 == 0 || y % 8 == 0 || k % 8 == 0;
        int dust = x == 4 && y == 4 && (k == 2 || k == 3 || k == 6);
        CHECK_EQ(sf_slice_set(sf_grid_slice(grids[0], k), x, y, shell || dust), SF_OK);
        CHECK_EQ(sf_slice_set(sf_grid_slice(grids[1], k), x, y, shell), SF_OK);
    }
    s.options = sf_carve_options_default();
    s.options.mode = SF_CARVE_PLANE;
    sf_carve_report r;
    CHECK_EQ(sfi_carve(grids[0], grids[1], NULL, &s.options, NULL, 0, NULL, NULL, grids[2], &r),
             SF_OK);
    CHECK(sf_grid_equal(grids[0], grids[2]));
    CHECK_EQ(r.floating_pieces, 2);
    CHECK_EQ(r.floating_voxels, 3);
    CHECK_EQ(r.kept_voxels, 3);
    CHECK(r.safe && r.slack_mm == 0 && r.distance_mm == 0 && r.rounds == 0);
    for (int i = 0; i < 3; i++) {
        sf_grid_destroy(grids[i]);
    }
}

static void failures_change_nothing(void)
{
    static scene s;
    begin(&s, 6);
    CHECK_EQ(sf_slice_set(sf_grid_slice(s.result, 3), 3, 3, 1), SF_OK);
    sf_grid *was = NULL;
    CHECK_EQ(sf_grid_clone(s.result, NULL, &was), SF_OK);
    sf_status status = SF_ERR_MEMORY;
    for (long at = 0; status != SF_OK && at < 100; at++) {
        failing_allocator f;
        sf_carve_report r;
        memset(&r, 7, sizeof r);
        failing_begin(&f, at);
        status = carve(&s, &f.allocator, NULL, &r);
        CHECK(status == SF_OK ||
              (status == SF_ERR_MEMORY && sf_grid_equal(s.result, was) && r.rounds == 0x07070707));
        CHECK_EQ(f.live, 0);
        CHECK_EQ(f.faults, 0);
    }
    CHECK_EQ(status, SF_OK);
    for (uint32_t k = 0; k < 8; k++) {
        CHECK_EQ(sf_slice_copy(sf_grid_slice(s.result, k), sf_grid_slice(was, k)), SF_OK);
    }
    sf_task task = sf_task_default();
    sf_task_cancel(&task);
    CHECK_EQ(carve(&s, NULL, &task, NULL), SF_ERR_CANCELLED);
    CHECK(sf_grid_equal(s.result, was));
    sf_grid_destroy(was);
    end(&s);
}

int main(void)
{
    TEST(slow_and_fast_agree);
    TEST(goals_are_what_they_say);
    TEST(floating_pieces_are_counted);
    TEST(failures_change_nothing);
    return test_finish();
}
