// SPDX-License-Identifier: MIT
// The oracle of checks: findings by flood fill and voxel by voxel, straight from the definitions in
// <sf/support.h>, and a pushed check to hold against it. Shares no thought with the library.

#ifndef SF_TEST_JUDGE_H
#define SF_TEST_JUDGE_H

#include "law/stack.h"

#define JUDGE_FINDINGS 4096
#define JUDGE_NOBODY UINT32_MAX

typedef struct judged {
    sf_check_report report;
    size_t finding_count;
    sf_finding findings[JUDGE_FINDINGS];
    uint32_t owner[STACK_VOXELS]; // finding that each lost voxel is due to
} judged;

// One region while a layer is judged.
typedef struct judged_region {
    int last_row, left; // where it ends: its last row, and its leftmost voxel there
    uint32_t mark;
} judged_region;

static inline int judge_later(const void *a, const void *b)
{
    const judged_region *p = a, *q = b;
    int rows = p->last_row - q->last_row;
    return rows != 0 ? rows : p->left - q->left;
}

static inline uint32_t *judge_owner(judged *j, const stack *s, int x, int y, int z)
{
    return &j->owner[(z * s->ny + y) * s->nx + x];
}

// Mark the 8-connected region of `unsupported` around (x, y); mark[] is one layer.
static inline void judge_flood(const stack *s, const stack *unsupported, int x, int y, int z,
                               uint32_t *mark, judged_region *region)
{
    static int queue[STACK_VOXELS];
    int tail = 0;
    mark[y * s->nx + x] = region->mark;
    queue[tail++] = y * s->nx + x;
    for (int head = 0; head < tail; head++) {
        int px = queue[head] % s->nx, py = queue[head] / s->nx;
        if (py > region->last_row || (py == region->last_row && px < region->left)) {
            region->last_row = py;
            region->left = px;
        }
        for (int i = 0; i < 9; i++) {
            int qx = px + i % 3 - 1, qy = py + i / 3 - 1;
            if (stack_get(unsupported, qx, qy, z) && mark[qy * s->nx + qx] != region->mark) {
                mark[qy * s->nx + qx] = region->mark;
                queue[tail++] = qy * s->nx + qx;
            }
        }
    }
}

// The finding of one region: what lies beside it decides kind and cause.
static inline void judge_region(judged *j, const stack *s, const stack *unsupported,
                                const stack *kept, int z, const uint32_t *mark, uint32_t wanted)
{
    int beside_carried = 0, beside_kept = 0;
    uint32_t index = (uint32_t)j->finding_count++, cause = SF_FINDING_ROOT;
    sf_finding finding = {SF_FINDING_ISLAND, (uint32_t)z, SF_FINDING_ROOT, 0, 0,
                          {0, 0, 0, 0, 0, 0}};
    for (int i = 0; i < s->nx * s->ny; i++) {
        if (mark[i] != wanted) {
            continue;
        }
        finding.area++;
        *judge_owner(j, s, i % s->nx, i / s->nx, z) = index;
        for (int n = 0; n < 9; n++) {
            int x = i % s->nx + n % 3 - 1, y = i / s->nx + n / 3 - 1;
            if (!stack_get(s, x, y, z) || stack_get(unsupported, x, y, z)) {
                continue;
            }
            beside_carried = 1;
            if (stack_get(kept, x, y, z)) {
                beside_kept = 1;
            } else if (*judge_owner(j, s, x, y, z) < cause) {
                cause = *judge_owner(j, s, x, y, z);
            }
        }
    }
    finding.kind = beside_carried ? SF_FINDING_OVERHANG : SF_FINDING_ISLAND;
    finding.cause = beside_kept ? SF_FINDING_ROOT : cause;
    *(beside_carried ? &j->report.overhang_count : &j->report.island_count) += 1;
    j->findings[index] = finding;
}

// Hand the lost voxels of a layer that something carried to the first finding below.
static inline void judge_follow(judged *j, const stack *s, const stack *unsupported,
                                const stack *kept, int z, const sf_element *e)
{
    for (int i = 0; i < s->nx * s->ny; i++) {
        int x = i % s->nx, y = i / s->nx;
        if (!stack_get(s, x, y, z) || stack_get(unsupported, x, y, z) || stack_get(kept, x, y, z)) {
            continue;
        }
        uint32_t *owner = judge_owner(j, s, x, y, z);
        for (int dy = -(int)e->reach_y; dy <= (int)e->reach_y; dy++) {
            for (int dx = -(int)e->half_width[0]; dx <= (int)e->half_width[0]; dx++) {
                if (element_has(e, dx, dy) && stack_get(s, x + dx, y + dy, z - 1)) {
                    uint32_t below = *judge_owner(j, s, x + dx, y + dy, z - 1);
                    *owner = below < *owner ? below : *owner;
                }
            }
        }
        CHECK(*owner != JUDGE_NOBODY);
    }
}

static inline void judge_name(judged *j, const stack *s, const stack *unsupported,
                              const stack *kept, int z)
{
    static uint32_t mark[STACK_VOXELS];
    static judged_region regions[JUDGE_FINDINGS];
    size_t count = 0;
    memset(mark, 0, sizeof mark);
    for (int i = 0; i < s->nx * s->ny; i++) {
        if (stack_get(unsupported, i % s->nx, i / s->nx, z) && mark[i] == 0) {
            judged_region region = {-1, 0, (uint32_t)count + 1};
            judge_flood(s, unsupported, i % s->nx, i / s->nx, z, mark, &region);
            regions[count++] = region;
        }
    }
    qsort(regions, count, sizeof *regions, judge_later);
    for (size_t i = 0; i < count; i++) {
        judge_region(j, s, unsupported, kept, z, mark, regions[i].mark);
    }
}

// Volumes and boxes, once every lost voxel has its owner.
static inline void judge_measure(judged *j, const stack *s)
{
    for (int i = 0; i < stack_count(s); i++) {
        if (j->owner[i] == JUDGE_NOBODY) {
            continue;
        }
        uint32_t x = (uint32_t)(i % s->nx), y = (uint32_t)(i / s->nx % s->ny);
        uint32_t z = (uint32_t)(i / (s->nx * s->ny));
        sf_finding *f = &j->findings[j->owner[i]];
        sf_box b = f->box, v = {x, y, z, x + 1, y + 1, z + 1};
        if (f->volume++ > 0) {
            v.x0 = b.x0 < x ? b.x0 : x;
            v.y0 = b.y0 < y ? b.y0 : y;
            v.z0 = b.z0 < z ? b.z0 : z;
            v.x1 = b.x1 > x + 1 ? b.x1 : x + 1;
            v.y1 = b.y1 > y + 1 ? b.y1 : y + 1;
            v.z1 = b.z1 > z + 1 ? b.z1 : z + 1;
        }
        f->box = v;
    }
}

static inline void judge(judged *j, const stack *s, const sf_rule *rule, uint32_t bed_layer)
{
    static stack kept, unsupported;
    int bed = stack_bed(s, bed_layer);
    memset(j, 0, sizeof *j);
    memset(j->owner, 0xff, sizeof j->owner);
    stack_trim(&kept, s, rule, bed_layer);
    stack_clear(&unsupported, s->nx, s->ny, s->nz);
    for (int z = 0; z < s->nz; z++) {
        sf_element e = {0, {0}};
        if (z > 0) {
            e = stack_step(rule, z - 1);
        }
        for (int i = 0; i < s->nx * s->ny; i++) {
            int x = i % s->nx, y = i / s->nx;
            *stack_at(&unsupported, x, y, z) =
                stack_get(s, x, y, z) && z != bed && !stack_carried(s, x, y, z, &e);
        }
        if (z != bed) {
            judge_follow(j, s, &unsupported, &kept, z, &e);
            judge_name(j, s, &unsupported, &kept, z);
        }
    }
    judge_measure(j, s);
    j->report.layer_count = (uint32_t)s->nz;
    j->report.bed_layer = bed == s->nz ? SF_BED_AUTO : (uint32_t)bed;
    j->report.solid_voxels = stack_volume(s);
    j->report.unsupported_voxels = stack_unsupported(s, rule, bed_layer);
    j->report.trimmed_voxels = stack_volume(s) - stack_volume(&kept);
    j->report.support_free = j->report.unsupported_voxels == 0;
}

static inline void same_report(const sf_check_report *a, const sf_check_report *b)
{
    CHECK_EQ(a->layer_count, b->layer_count);
    CHECK_EQ(a->bed_layer, b->bed_layer);
    CHECK_EQ(a->solid_voxels, b->solid_voxels);
    CHECK_EQ(a->unsupported_voxels, b->unsupported_voxels);
    CHECK_EQ(a->trimmed_voxels, b->trimmed_voxels);
    CHECK_EQ(a->island_count, b->island_count);
    CHECK_EQ(a->overhang_count, b->overhang_count);
    CHECK_EQ(a->findings_dropped, b->findings_dropped);
    CHECK_EQ(a->runs_dropped, b->runs_dropped);
    CHECK_EQ(a->unlinked_voxels, b->unlinked_voxels);
    CHECK_EQ(a->support_free, b->support_free);
}

static inline void same_finding(const sf_finding *a, const sf_finding *b)
{
    CHECK_EQ(a->kind, b->kind);
    CHECK_EQ(a->layer, b->layer);
    CHECK_EQ(a->cause, b->cause);
    CHECK_EQ(a->area, b->area);
    CHECK_EQ(a->volume, b->volume);
    CHECK(memcmp(&a->box, &b->box, sizeof a->box) == 0);
}

// ---------------------------------------------------------------------------------------------
// A check in the test's own memory
// ---------------------------------------------------------------------------------------------

typedef struct pushed {
    sf_check_report report;
    size_t finding_count;
    sf_finding findings[JUDGE_FINDINGS];
} pushed;

// A checker in a block of its own; free(*block) when done with it.
static inline sf_checker *checker_new(const sf_check_options *options, void **block)
{
    size_t size = 0;
    sf_checker *checker = NULL;
    CHECK_EQ(sf_checker_size(options, &size), SF_OK);
    *block = malloc(size + 63);
    if (*block == NULL) {
        abort();
    }
    memset(*block, 0xa5, size + 63);
    void *memory = (void *)(((uintptr_t)*block + 63) / 64 * 64);
    CHECK_EQ(sf_checker_place(options, memory, size, &checker), SF_OK);
    return checker;
}

static inline sf_check_options pushed_options(const stack *s, const sf_rule *rule, uint32_t bed,
                                              pushed *p)
{
    sf_check_options o = sf_check_options_default();
    o.rule = *rule;
    o.width = (uint32_t)s->nx;
    o.height = (uint32_t)s->ny;
    o.bed_layer = bed;
    o.run_capacity = (uint32_t)stack_count(s);
    o.findings = p->findings;
    o.finding_capacity = JUDGE_FINDINGS;
    return o;
}

// Layer z of a stack as bits with rubbish in the padding; words must hold stride * ny of them.
static inline sf_slice stack_layer_bits(const stack *s, int z, uint64_t *words, size_t stride)
{
    sf_slice slice = {words, (uint32_t)s->nx, (uint32_t)s->ny, stride};
    for (size_t i = 0; i < stride * (size_t)s->ny; i++) {
        words[i] = test_random();
    }
    for (int y = 0; y < s->ny; y++) {
        for (int x = 0; x < s->nx; x++) {
            CHECK_EQ(sf_slice_set(slice, (uint32_t)x, (uint32_t)y, stack_get(s, x, y, z)), SF_OK);
        }
    }
    return slice;
}

static inline void push_stack(pushed *p, const stack *s, const sf_check_options *o)
{
    static uint64_t words[STACK_VOXELS];
    void *block;
    sf_checker *checker = checker_new(o, &block);
    for (int z = 0; z < s->nz; z++) {
        sf_slice slice = stack_layer_bits(s, z, words, (size_t)(s->nx + 63) / 64 + 1);
        CHECK_EQ(sf_checker_push(checker, slice), SF_OK);
    }
    CHECK_EQ(sf_checker_report(checker, &p->report, &p->finding_count), SF_OK);
    free(block);
}

#endif
