// SPDX-License-Identifier: MIT
// Why: a trap that is not named spoils a part, and one that is not there wastes somebody's time
// (ALGORITHMS 8.6). The voids of a grid are held against flood fill, prefix by prefix, straight
// from the definition in <sf/finding.h>; and a call that fails leaves everything as it was (P2).

#include "failing_allocator.h"
#include "law/stack.h"

#include <sf/finding.h>

#define SETS 4096
#define VOIDS 512

// One sealed component of one prefix, as the set of its voxels.
typedef struct sealed {
    uint8_t has[512];
    int volume, here, top;
} sealed;

typedef struct oracle {
    int count;
    sf_void voids[VOIDS];
} oracle;

// Flood the component of empty voxels of layers bed..k around `start`; returns whether it is
// sealed.
static int flood(const stack *s, int bed, int bed_is_open, int k, int start, uint8_t *seen,
                 sealed *out)
{
    static const int steps[6][3] = {{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                    {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
    static int queue[512];
    int tail = 0, closed = 1, layer = s->nx * s->ny;
    memset(out, 0, sizeof *out);
    queue[tail++] = start;
    seen[start] = 1;
    for (int head = 0; head < tail; head++) {
        int i = queue[head], x = i % s->nx, y = i % layer / s->nx, z = i / layer;
        out->has[i] = 1;
        out->volume++;
        out->here += z == k;
        out->top = z > out->top ? z : out->top;
        for (int d = 0; d < 6; d++) {
            int px = x + steps[d][0], py = y + steps[d][1], pz = z + steps[d][2];
            if (pz > k) {
                continue;
            }
            if (px < 0 || py < 0 || px >= s->nx || py >= s->ny) {
                closed = 0;
            } else if (pz < bed) {
                closed = closed && !bed_is_open;
            } else if (!stack_get(s, px, py, pz) && !seen[(pz * s->ny + py) * s->nx + px]) {
                seen[(pz * s->ny + py) * s->nx + px] = 1;
                queue[tail++] = (pz * s->ny + py) * s->nx + px;
            }
        }
    }
    return closed;
}

static int contains(const sealed *big, const sealed *small, int count)
{
    for (int i = 0; i < count; i++) {
        if (small->has[i] && !big->has[i]) {
            return 0;
        }
    }
    return 1;
}

static sf_void describe(const stack *s, const sealed *set)
{
    int layer = s->nx * s->ny, is_shut = set->top + 1 < s->nz;
    sf_void v = {SF_VOID_CUP,
                 (uint32_t)set->top + 1,
                 (uint64_t)set->volume,
                 0,
                 {UINT32_MAX, UINT32_MAX, UINT32_MAX, 0, 0, 0}};
    for (int i = 0; i < stack_count(s); i++) {
        uint32_t x = (uint32_t)(i % s->nx), y = (uint32_t)(i % layer / s->nx),
                 z = (uint32_t)(i / layer);
        if (!set->has[i]) {
            continue;
        }
        v.box.x0 = x < v.box.x0 ? x : v.box.x0;
        v.box.y0 = y < v.box.y0 ? y : v.box.y0;
        v.box.z0 = z < v.box.z0 ? z : v.box.z0;
        v.box.x1 = x + 1 > v.box.x1 ? x + 1 : v.box.x1;
        v.box.y1 = y + 1 > v.box.y1 ? y + 1 : v.box.y1;
        v.box.z1 = z + 1 > v.box.z1 ? z + 1 : v.box.z1;
        is_shut = is_shut && (z != (uint32_t)set->top || s->solid[i + layer]);
    }
    if (is_shut) {
        v.kind = SF_VOID_TRAP;
        v.vent_layer = UINT32_MAX;
    }
    return v;
}

// First voxel of the last layer.
static int place(const stack *s, const sealed *set)
{
    int i = set->top * s->nx * s->ny;
    while (!set->has[i]) {
        i++;
    }
    return i;
}

static void find_voids(const stack *s, int bed, int bed_is_open, oracle *o)
{
    static sealed sets[SETS];
    static int chosen[VOIDS];
    static uint8_t seen[512];
    int count = 0, layer = s->nx * s->ny;
    o->count = 0;
    for (int k = bed; k < s->nz; k++) {
        memset(seen, 0, sizeof seen);
        for (int i = bed * layer; i < (k + 1) * layer; i++) {
            if (!s->solid[i] && !seen[i] && count < SETS) {
                count += flood(s, bed, bed_is_open, k, i, seen, &sets[count]);
            }
        }
    }
    for (int i = 0; i < count; i++) {
        int largest = 1;
        for (int j = 0; j < count && largest; j++) {
            // Of equal sets the first counts.
            int more =
                sets[j].volume > sets[i].volume || (sets[j].volume == sets[i].volume && j < i);
            largest = !(more && contains(&sets[j], &sets[i], stack_count(s)));
        }
        if (!largest) {
            continue;
        }
        int at = o->count++;
        while (at > 0 && place(s, &sets[chosen[at - 1]]) > place(s, &sets[i])) {
            chosen[at] = chosen[at - 1];
            at--;
        }
        chosen[at] = i;
    }
    for (int n = 0; n < o->count; n++) {
        const sealed *set = &sets[chosen[n]];
        o->voids[n] = describe(s, set);
        for (int j = 0; j < count; j++) {
            if (contains(set, &sets[j], stack_count(s)) &&
                (uint64_t)sets[j].here > o->voids[n].area) {
                o->voids[n].area = (uint64_t)sets[j].here;
            }
        }
    }
}

static void same_void(const sf_void *a, const sf_void *b)
{
    CHECK_EQ(a->kind, b->kind);
    CHECK_EQ(a->vent_layer, b->vent_layer);
    CHECK_EQ(a->volume, b->volume);
    CHECK_EQ(a->area, b->area);
    CHECK(memcmp(&a->box, &b->box, sizeof a->box) == 0);
}

// Bed given, or SF_BED_AUTO; open or closed; a short array.
static void compare(const stack *s, sf_grid *grid, uint32_t bed_layer, int bed_is_open)
{
    static oracle o;
    static sf_void voids[VOIDS];
    sf_voids_options options = sf_voids_options_default();
    sf_voids_report report;
    size_t count = 0;
    uint64_t traps = 0, trapped = 0, cups = 0, cupped = 0;
    stack_write(s, grid);
    find_voids(s, stack_bed(s, bed_layer), bed_is_open, &o);
    options.bed_layer = bed_layer;
    options.bed_is_open = bed_is_open;
    options.voids = voids;
    options.void_capacity = s->solid[0] ? VOIDS : 2;
    CHECK_EQ(sf_grid_voids(grid, &options, NULL, NULL, &report, &count), SF_OK);
    for (int i = 0; i < o.count; i++) {
        int is_trap = o.voids[i].kind == SF_VOID_TRAP;
        *(is_trap ? &traps : &cups) += 1;
        *(is_trap ? &trapped : &cupped) += o.voids[i].volume;
        if ((size_t)i < count) {
            same_void(&voids[i], &o.voids[i]);
        }
    }
    CHECK_EQ(report.trap_count, traps);
    CHECK_EQ(report.trap_voxels, trapped);
    CHECK_EQ(report.cup_count, cups);
    CHECK_EQ(report.cup_voxels, cupped);
    CHECK_EQ(report.small_cup_count, 0);
    CHECK_EQ(count + report.voids_dropped, o.count);
    CHECK(count == (size_t)o.count || count == options.void_capacity);
}

static sf_grid *grid_of(int nx, int ny, int nz)
{
    static stack s;
    stack_clear(&s, nx, ny, nz);
    return stack_grid(&s);
}

// All 2 x 2 x 4 rooms in a solid wall without floor and roof.
static void every_small_room(void)
{
    static stack s;
    sf_grid *grid = grid_of(4, 4, 4);
    stack_clear(&s, 4, 4, 4);
    for (unsigned bits = 0; bits < 65536; bits++) {
        for (int i = 0; i < 64; i++) {
            int x = i % 4, y = i / 4 % 4, z = i / 16;
            int inside = x > 0 && x < 3 && y > 0 && y < 3;
            s.solid[i] = (uint8_t)(!inside || (bits >> (4 * z + 2 * (y - 1) + x - 1) & 1));
        }
        compare(&s, grid, 0, (int)(bits & 1));
    }
    sf_grid_destroy(grid);
}

static void random_shapes(void)
{
    static stack s;
    sf_grid *grid = grid_of(8, 8, 8);
    for (int i = 0; i < 3000; i++) {
        if (i % 3 == 0) {
            stack_random_boxes(&s, 8, 8, 8, 14);
        } else {
            stack_random(&s, 8, 8, 8, i % 3 == 1 ? 0.72 : 0.5 + 0.4 * test_random_unit());
        }
        uint32_t bed = i % 4 == 0 ? test_random_below(8) : SF_BED_AUTO;
        compare(&s, grid, bed, i % 5 == 0);
    }
    sf_grid_destroy(grid);
}

// Walls more than a word wide: runs across words.
static void wide_shapes(void)
{
    static stack s;
    sf_grid *grid = grid_of(130, 3, 1);
    for (int i = 0; i < 300; i++) {
        stack_random(&s, 130, 3, 1, 0.6);
        compare(&s, grid, SF_BED_AUTO, 0);
    }
    sf_grid_destroy(grid);
}

static void names_by_hand(void)
{
    static stack s;
    static const struct {
        const char *text;
        int open;
        uint64_t traps, cups;
        uint32_t vent;
    } cases[] = {
        // a mug: sealed until the print ends
        {"###/###/###|###/#.#/###|###/#.#/###", 0, 0, 1, 3},
        // a hollow box, a box whose only way out is an edge, a corner
        {"###/###/###|###/#.#/###|###/###/###", 0, 1, 0, UINT32_MAX},
        {"###/###/###|.##/#.#/###|###/###/###", 0, 1, 0, UINT32_MAX},
        {"###/###/###|###/#.#/###|.##/###/###", 0, 1, 0, UINT32_MAX},
        // a hole in the wall of the second layer vents what the first held
        {"###/#.#/###|###/..#/###|###/###/###", 0, 0, 1, 1},
        // a bell: a trap on the bed, nothing at all where the bed is open
        {"###/#.#/###|###/###/###", 0, 1, 0, UINT32_MAX},
        {"###/#.#/###|###/###/###", 1, 0, 0, 0},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        sf_voids_options options = sf_voids_options_default();
        sf_voids_report report;
        sf_void found;
        size_t count;
        stack_parse(&s, cases[i].text);
        sf_grid *grid = stack_grid(&s);
        options.bed_is_open = cases[i].open;
        options.voids = &found;
        options.void_capacity = 1;
        CHECK_EQ(sf_grid_voids(grid, &options, NULL, NULL, &report, &count), SF_OK);
        CHECK_EQ(report.trap_count, cases[i].traps);
        CHECK_EQ(report.cup_count, cases[i].cups);
        CHECK(count == 0 || found.vent_layer == cases[i].vent);
        sf_grid_destroy(grid);
    }
}

static void small_cups_are_counted_apart(void)
{
    static stack s;
    stack_parse(&s, "#######/#######/#######|#######/#.#...#/#######");
    sf_grid *grid = stack_grid(&s);
    sf_voids_options options = sf_voids_options_default();
    sf_voids_report report;
    options.cup_area_min = 2;
    CHECK_EQ(sf_grid_voids(grid, &options, NULL, NULL, &report, NULL), SF_OK);
    CHECK_EQ(report.cup_count, 1);
    CHECK_EQ(report.small_cup_count, 1);
    CHECK_EQ(report.voids_dropped, 1);
    options.cup_layers_min = 2;
    CHECK_EQ(sf_grid_voids(grid, &options, NULL, NULL, &report, NULL), SF_OK);
    CHECK_EQ(report.cup_count, 0);
    CHECK_EQ(report.small_cup_count, 2);
    sf_grid_destroy(grid);
}

typedef struct watch {
    int calls, cancel_at;
    sf_task *task;
} watch;

static void watching(void *user, double fraction)
{
    watch *w = user;
    CHECK(fraction >= 0 && fraction <= 1);
    if (++w->calls == w->cancel_at) {
        sf_task_cancel(w->task);
    }
}

static void failing_calls_change_nothing(void)
{
    static stack s;
    static sf_void voids[VOIDS], before[VOIDS];
    sf_voids_report report, report_before;
    sf_voids_options options = sf_voids_options_default(), bad;
    stack_random(&s, 12, 12, 6, 0.75);
    sf_grid *grid = stack_grid(&s);
    memset(before, 0x5a, sizeof before);
    memcpy(voids, before, sizeof before);
    memset(&report, 0x5a, sizeof report);
    report_before = report;
    options.voids = voids;
    options.void_capacity = VOIDS;
    CHECK_EQ(sf_grid_voids(NULL, &options, NULL, NULL, &report, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_grid_voids(grid, NULL, NULL, NULL, &report, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_grid_voids(grid, &options, NULL, NULL, NULL, NULL), SF_ERR_ARGUMENT);
    bad = options;
    bad.struct_size = 8;
    CHECK_EQ(sf_grid_voids(grid, &bad, NULL, NULL, &report, NULL), SF_ERR_ARGUMENT);
    bad = options;
    bad.voids = NULL;
    CHECK_EQ(sf_grid_voids(grid, &bad, NULL, NULL, &report, NULL), SF_ERR_ARGUMENT);
    bad = options;
    bad.bed_layer = 6;
    CHECK_EQ(sf_grid_voids(grid, &bad, NULL, NULL, &report, NULL), SF_ERR_ARGUMENT);
    for (int cancel_at = 1; cancel_at < 6; cancel_at++) {
        sf_task task = sf_task_default();
        watch w = {0, cancel_at, &task};
        task.progress = watching;
        task.user = &w;
        CHECK_EQ(sf_grid_voids(grid, &options, NULL, &task, &report, NULL), SF_ERR_CANCELLED);
    }
    failing_allocator f;
    sf_status status = SF_ERR_MEMORY;
    for (long k = 0; status == SF_ERR_MEMORY && k < 100; k++) {
        CHECK(memcmp(voids, before, sizeof before) == 0);
        CHECK(memcmp(&report, &report_before, sizeof report) == 0);
        failing_begin(&f, k);
        status = sf_grid_voids(grid, &options, &f.allocator, NULL, &report, NULL);
        CHECK_EQ(f.live, 0);
        CHECK_EQ(f.faults, 0);
    }
    CHECK_EQ(status, SF_OK);
    CHECK(f.requests >= 5);
    sf_grid_destroy(grid);
}

// Pushed one at a time the layers say the same; a search that is finished, or short of memory,
// takes nothing more.
static void layers_as_they_come(void)
{
    static stack s;
    static sf_void voids[VOIDS], whole[VOIDS];
    sf_voids_options options = sf_voids_options_default();
    sf_voids_report report, expected;
    size_t count = 0, whole_count = 0;
    sf_void_search *search = NULL;
    sf_slice none = {NULL, 0, 0, 0};
    stack_random(&s, 12, 12, 6, 0.75);
    sf_grid *grid = stack_grid(&s);
    options.voids = whole;
    options.void_capacity = VOIDS;
    CHECK_EQ(sf_grid_voids(grid, &options, NULL, NULL, &expected, &whole_count), SF_OK);
    options.voids = voids;
    CHECK_EQ(sf_void_search_create(&options, 0, 12, NULL, &search), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_void_search_create(&options, 12, 12, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_void_search_push(NULL, none), SF_ERR_ARGUMENT);
    sf_status status = SF_ERR_MEMORY;
    long k = 0;
    for (; status == SF_ERR_MEMORY && k < 100; k++) {
        failing_allocator f;
        failing_begin(&f, k);
        search = NULL;
        status = sf_void_search_create(&options, 12, 12, &f.allocator, &search);
        for (uint32_t z = 0; status == SF_OK && z < 6; z++) {
            status = sf_void_search_push(search, sf_grid_slice(grid, z));
            if (status != SF_OK) {
                CHECK_EQ(sf_void_search_push(search, sf_grid_slice(grid, z)), status);
            }
        }
        if (status == SF_OK) {
            CHECK_EQ(sf_void_search_push(search, none), SF_ERR_ARGUMENT);
            CHECK_EQ(sf_void_search_finish(search, NULL, NULL), SF_ERR_ARGUMENT);
            status = sf_void_search_finish(search, &report, &count);
        }
        if (status == SF_OK) {
            CHECK_EQ(sf_void_search_push(search, sf_grid_slice(grid, 0)), SF_ERR_ARGUMENT);
            CHECK_EQ(sf_void_search_finish(search, &report, &count), SF_ERR_ARGUMENT);
        }
        sf_void_search_destroy(search);
        CHECK(f.live == 0 && f.faults == 0);
    }
    CHECK(status == SF_OK && k > 5 && count == whole_count && count > 0);
    CHECK(memcmp(&report, &expected, sizeof report) == 0);
    for (size_t i = 0; i < count; i++) {
        same_void(&voids[i], &whole[i]);
    }
    sf_void_search_destroy(NULL);
    sf_grid_destroy(grid);
}

static void nothing_at_all(void)
{
    sf_grid *grid = grid_of(5, 4, 3);
    sf_voids_options options = sf_voids_options_default();
    sf_voids_report report;
    CHECK_EQ(sf_grid_voids(grid, &options, NULL, NULL, &report, NULL), SF_OK);
    CHECK_EQ(report.bed_layer, SF_BED_AUTO);
    CHECK_EQ(report.trap_count + report.cup_count, 0);
    sf_grid_destroy(grid);
}

int main(void)
{
    TEST(names_by_hand);
    TEST(every_small_room);
    TEST(random_shapes);
    TEST(wide_shapes);
    TEST(small_cups_are_counted_apart);
    TEST(failing_calls_change_nothing);
    TEST(layers_as_they_come);
    TEST(nothing_at_all);
    return test_finish();
}
