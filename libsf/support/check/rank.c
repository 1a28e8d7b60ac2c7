// SPDX-License-Identifier: MIT
// Rank: findings by what they cost to fix, the dearest first.
//
// What a finding costs is the cheaper way to fix it. What follows from another finding may go away
// with it, so of equal costs roots come first; then the index decides, so the order is total and
// the same everywhere. Sorted in place by a heap, which needs no memory and has no bad input (J. W.
// J. Williams, "Algorithm 232: Heapsort", 1964).

#include <sf/finding.h>

typedef struct ranking {
    const sf_finding *findings;
    const sf_finding_cost *costs;
    uint32_t *order;
} ranking;

static uint64_t cheaper(const sf_finding_cost *cost)
{
    return cost->grow_voxels < cost->trim_voxels ? cost->grow_voxels : cost->trim_voxels;
}

// Whether finding a comes before finding b.
static int is_before(const ranking *r, uint32_t a, uint32_t b)
{
    uint64_t p = cheaper(&r->costs[a]), q = cheaper(&r->costs[b]);
    int root_a = r->findings[a].cause == SF_FINDING_ROOT;
    int root_b = r->findings[b].cause == SF_FINDING_ROOT;
    if (p != q) {
        return p > q;
    }
    return root_a != root_b ? root_a : a < b;
}

// Let place i sink; the last in the order is at the top.
static void sink(const ranking *r, size_t count, size_t i)
{
    uint32_t moving = r->order[i];
    for (;;) {
        size_t child = 2 * i + 1;
        if (child >= count) {
            break;
        }
        if (child + 1 < count && is_before(r, r->order[child], r->order[child + 1])) {
            child++;
        }
        if (!is_before(r, moving, r->order[child])) {
            break;
        }
        r->order[i] = r->order[child];
        i = child;
    }
    r->order[i] = moving;
}

sf_status sf_findings_rank(const sf_finding *findings, const sf_finding_cost *costs,
                           size_t finding_count, uint32_t *order)
{
    ranking r = {findings, costs, order};
    if (finding_count > 0 && (findings == NULL || costs == NULL || order == NULL)) {
        return SF_ERR_ARGUMENT;
    }
    if (finding_count > UINT32_MAX) {
        return SF_ERR_OVERFLOW;
    }
    for (size_t i = 0; i < finding_count; i++) {
        order[i] = (uint32_t)i;
    }
    for (size_t i = finding_count / 2; i-- > 0;) {
        sink(&r, finding_count, i);
    }
    for (size_t end = finding_count; end-- > 1;) {
        uint32_t last = order[0];
        order[0] = order[end];
        order[end] = last;
        sink(&r, end, 0);
    }
    return SF_OK;
}
