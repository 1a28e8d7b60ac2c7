// SPDX-License-Identifier: MIT
// What the parts of a repair hand to each other: the job, the price map, the forest, cleanup,
// struts.

#ifndef SF_SUPPORT_REPAIR_H
#define SF_SUPPORT_REPAIR_H

#include <sf/repair.h>

#include "support/repair/sweep.h"
#include "support/rule/terms.h"

// One repair. The rule has no bridges (see bridged.c), and `exempt` what they hold in its stead.
// Sets are named as in repair.c: V drawn, P must, G room, T roots.
typedef struct sfi_job {
    sf_rule rule;
    sf_lattice lattice;
    uint32_t bed;
    uint32_t reach_x, reach_y; // most of any step
    const uint8_t *add, *remove;
    uint32_t scale; // that costs of adding are multiplied by; at most 128
    const sf_allocator *allocator;
    sfi_pace *pace; // of every sweep that the job makes
    const sf_grid *drawn;
    const sf_grid *must;   // or NULL
    const sf_grid *exempt; // or NULL
    const sf_grid *room;
    const sf_grid *roots;
    const sf_grid *resting; // what of the roots rests on roots, where that is not all; or NULL
} sfi_job;

// What a forest need not look at: the roots that rest on roots.
static inline const sf_grid *sfi_job_settled(const sfi_job *job)
{
    return job->resting != NULL ? job->resting : job->roots;
}

// Terms that a trim under the job's rule takes.
sf_terms sfi_job_terms(const sfi_job *job);

// Fill the reach.
sf_status sfi_job_find_reach(sfi_job *job);

// Let a job work with another rule that lets less stand: the roots count as exempt, and the room is
// what this leaves. Both go to grids that are made here, also by a call that fails.
sf_status sfi_job_set_aside(sfi_job *job, sf_rule rule, sf_grid **room, sf_grid **exempt);

// What a result costs: the additions and the removals, and their sum at their prices.
typedef struct sfi_bill {
    uint64_t added, removed, cost;
} sfi_bill;

sfi_bill sfi_job_bill(const sfi_job *job, const sf_grid *result);

// What giving up costs that the room has no place for, whatever is done.
uint64_t sfi_job_cost_of_lost(const sfi_job *job);

// Drawn voxels that do not stand by themselves; and how many of them are few, so that slow searches
// are made too.
uint64_t sfi_job_hanging(const sfi_job *job);
#define SFI_HANGING_FEW 1000000u

// What it costs to add a voxel, or to remove it.
static inline uint32_t sfi_job_cost(const sfi_job *job, const uint8_t *costs, uint32_t k,
                                    uint32_t x, uint32_t y)
{
    return costs == NULL ? 1 : costs[((size_t)k * job->lattice.ny + y) * job->lattice.nx + x];
}
static inline uint32_t sfi_job_add(const sfi_job *job, uint32_t k, uint32_t x, uint32_t y)
{
    return job->scale * sfi_job_cost(job, job->add, k, x, y);
}
static inline uint32_t sfi_job_remove(const sfi_job *job, uint32_t k, uint32_t x, uint32_t y)
{
    return sfi_job_cost(job, job->remove, k, x, y);
}

// ---------------------------------------------------------------------------------------------
// Price map (price.c)
// ---------------------------------------------------------------------------------------------

// Prices are kept as int16_t, moved down by 32768: SFI_PRICE_FREE is 0, SFI_PRICE_NONE means that
// nothing there can be carried, and all that can but costs 65534 or more has SFI_PRICE_MOST.
#define SFI_PRICE_FREE (-32767 - 1)
#define SFI_PRICE_MOST 32766
#define SFI_PRICE_NONE 32767

// What to make a price map of.
typedef struct sfi_price_terms {
    const sf_grid *room;    // where matter can be carried at all
    const sf_grid *free;    // where a step costs nothing
    const sf_grid *targets; // whose prices are asked for, and of all that may carry them; NULL: all
    const sf_grid *settled; // of the targets these are not asked for; or NULL
} sfi_price_terms;

// Prices of layers bed..top - 1, each within the rectangle that the targets above it reach; under
// slack also the codes that go with them.
typedef struct sfi_price {
    uint32_t layers, top;
    sf_rect *rects;
    size_t *starts;
    size_t count, capacity; // prices in use, and room for them
    int16_t *prices;
    uint8_t *codes, *root_codes; // of what is priced, and of the roots by themselves; or NULL
    const sf_grid *rooted; // the roots that root_codes are of, if they are; they do not change
} sfi_price;

// Make a map, in the memory of an earlier one of this job or from all zero. SF_ERR_MEMORY,
// SF_ERR_OVERFLOW, SF_ERR_CANCELLED; the map is then destroyed.
sf_status sfi_price_make(const sfi_job *job, const sfi_price_terms *terms, sfi_price *price);
void sfi_price_destroy(const sfi_job *job, sfi_price *price);

// Row y of layer k, such that element x is voxel x; x and y within the layer's rectangle.
static inline int16_t *sfi_price_row(const sfi_price *p, uint32_t k, uint32_t y)
{
    sf_rect r = p->rects[k];
    return p->prices + p->starts[k] + (size_t)(y - r.y0) * (r.x1 - r.x0) - r.x0;
}
static inline uint8_t *sfi_price_codes(const sfi_price *p, uint8_t *codes, uint32_t k, uint32_t y)
{
    sf_rect r = p->rects[k];
    return codes + p->starts[k] + (size_t)(y - r.y0) * (r.x1 - r.x0) - r.x0;
}

// Under slack (field.c): the codes of a grid, laid out as the prices are.
sf_status sfi_price_field(const sfi_job *job, const sfi_price *price, const sf_grid *grid,
                          uint8_t *codes);

// The job's rule, or under slack a disk of what every step gains: steps within it use up no reach,
// so that chains of them stand on whatever is alive.
sf_rule sfi_careful_rule(const sfi_job *job);

// Make the codes those of the whole room: what can be had at most, instead of what the cheapest
// chain leaves.
sf_status sfi_price_by_demand(const sfi_job *job, sfi_price *price);

// ---------------------------------------------------------------------------------------------
// Planes
// ---------------------------------------------------------------------------------------------

// A layer with a border as wide as the reach: voxel (x, y) is element (y + reach_y) * stride + x +
// reach_x. The number of elements fits a uint32_t.
typedef struct sfi_plane {
    size_t stride, count;
    uint32_t reach_x, reach_y;
} sfi_plane;

// SF_ERR_OVERFLOW.
sf_status sfi_plane_make(const sfi_job *job, sfi_plane *plane);

static inline size_t sfi_plane_at(const sfi_plane *p, uint32_t x, uint32_t y)
{
    return ((size_t)y + p->reach_y) * p->stride + x + p->reach_x;
}

// A voxel of an element as a step in planes, and what it costs under slack.
typedef struct sfi_step {
    ptrdiff_t offset;
    int16_t dx, dy;
    uint32_t cost;
} sfi_step;

// Voxels of the rule's largest element; and the steps of one layer's, nearest first. Returns their
// number.
size_t sfi_steps_most(const sfi_job *job);
size_t sfi_steps_of(const sfi_job *job, const sfi_plane *plane, uint32_t below, sfi_step *steps);

// ---------------------------------------------------------------------------------------------
// Forest (forest.c), cleanup (cleanup.c)
// ---------------------------------------------------------------------------------------------

// A support-free result along a forest of the cheapest supporters, the best there is along it.
// `all` is what keeping all nodes along it costs; UINT64_MAX where some are carried by nothing.
// With is_feasible 0 the forest carries not all that must stay, and the result is none.
typedef struct sfi_forest {
    int prefer_drawn; // take a drawn supporter among those of one price
    uint64_t all;
    int is_feasible;
    uint64_t nodes; // that it had
} sfi_forest;

sf_status sfi_forest_grow(const sfi_job *job, const sfi_price *price, sfi_forest *forest,
                          sf_grid *result);

// Where the rule is an element: everything drawn that is in the room, on paths that are found one
// after the other (in_turn.c). `price` is a map with what is drawn free and all that is drawn and
// no root for targets. *is_done is 0 where it was given up, because what is added costs `bound` or
// more, or because it takes too long.
sf_status sfi_grow_in_turn(const sfi_job *job, const sfi_price *price, uint64_t bound,
                           sf_grid *result, int *is_done);

// Put back what the result now carries, and take away additions that carry nothing, from the top
// down. Never costs more; the result stays support-free.
sf_status sfi_cleanup(const sfi_job *job, sf_grid *result);

// Where the rule is an element: replace branches of additions by cheaper ones (reroute.c), once
// from the top down, or as far as that goes in bounded time. Never costs more; the result stays
// support-free.
sf_status sfi_reroute(const sfi_job *job, sf_grid *result);

#endif
