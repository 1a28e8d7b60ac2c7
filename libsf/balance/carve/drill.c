// SPDX-License-Identifier: MIT
// A shaft on its way down, out of a void and into the open.
//
// A shaft is a disk in each layer, moved from layer to layer by an offset o of the rule's element,
// or not at all. Nothing above it loses its support, as long as the matter around it is solid: let
// v be a voxel that stays, above a disk D that was taken out of the layer below. If the disk of v's
// own layer is D moved by o, v does not lie in it, and so v - o does not lie in D: it is there, and
// since the element is symmetric it carries v. Where the matter around is not solid this may fail;
// so every hole is followed by a check of the whole part (drainer.c).
//
// Slack has no element that every step may use: there the offset is what the angle has added up to.

#include "balance/carve/drill.h"

#include "base/math.h"
#include "support/rule/terms.h"
#include "voxel/slice.h"

#include <math.h>

const signed char sfi_drill_directions[SFI_DRILL_DIRECTIONS][2] = {
    {0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}, {1, -1}, {-1, 1}};

sfi_drill sfi_drill_begin(uint32_t x, uint32_t y, uint32_t layer, unsigned direction)
{
    sfi_drill drill = {x, y, layer, direction, 0};
    return drill;
}

// ---------------------------------------------------------------------------------------------
// Steps
// ---------------------------------------------------------------------------------------------

// How far an element reaches along a direction. So far a disk can be moved and still overlap by
// more than a third with what it was.
static uint32_t disk_reach(const sf_element *e, const signed char along[2])
{
    uint32_t reach = 0;
    if (along[1] == 0) {
        return e->half_width[0];
    }
    while (reach < e->reach_y && (along[0] == 0 || e->half_width[reach + 1] > reach)) {
        reach++;
    }
    return reach;
}

// The same for the rule's element, from layer k + 1 to layer k.
static uint32_t element_reach(const sf_rule *rule, uint32_t k, const signed char along[2])
{
    sf_element e;
    return sf_rule_element(rule, k, &e) == SF_OK ? disk_reach(&e, along) : 0;
}

// Steps along a direction that the rule's angle allows in this layer, what was left over before
// included.
static uint32_t angle_reach(const sfi_ground_plan *plan, uint32_t k, const signed char along[2],
                            double *left)
{
    const sf_lattice *l = &plan->lattice;
    double x = along[0] * l->pitch_x_mm, y = along[1] * l->pitch_y_mm;
    double angle = along[0] == 0   ? plan->angles.axis_y_rad
                   : along[1] == 0 ? plan->angles.axis_x_rad
                                   : plan->angles.diagonal_rad;
    *left += sfi_tan(angle) * (plan->levels[k + 1] - plan->levels[k]) / sqrt(x * x + y * y);
    double whole = floor(*left);
    *left -= whole;
    return whole < SF_REACH_MAX ? (uint32_t)whole : SF_REACH_MAX;
}

void sfi_drill_step(const sfi_ground_plan *plan, sfi_drill *drill)
{
    const signed char *along = sfi_drill_directions[drill->direction];
    drill->layer--;
    if (drill->layer < 0 || drill->direction == 0) {
        return;
    }
    uint32_t k = (uint32_t)drill->layer, steps = disk_reach(&plan->disk, along);
    if (plan->terms != NULL) {
        uint32_t most = element_reach(&plan->terms->rule, k, along);
        steps = most < steps ? most : steps;
    }
    if (plan->terms != NULL && plan->terms->rule.kind == SF_RULE_SLACK) {
        uint32_t most = angle_reach(plan, k, along, &drill->left);
        steps = most < steps ? most : steps;
    }
    drill->x += along[0] * (int64_t)steps;
    drill->y += along[1] * (int64_t)steps;
}

// ---------------------------------------------------------------------------------------------
// What is there
// ---------------------------------------------------------------------------------------------

static int is_inside(const sf_lattice *l, int64_t x, int64_t y, int64_t layer)
{
    return x >= 0 && y >= 0 && layer >= 0 && x < l->nx && y < l->ny && layer < l->nz;
}

int sfi_drill_is_open(const sfi_ground_plan *plan, int64_t x, int64_t y, int64_t layer)
{
    if (!is_inside(&plan->lattice, x, y, layer)) {
        return 1;
    }
    uint32_t u = (uint32_t)x, v = (uint32_t)y, k = (uint32_t)layer;
    if (sf_slice_get(sf_grid_slice(plan->made, k), u, v)) {
        return 0;
    }
    // What is empty and was not is a hole, and holes are open.
    uint32_t piece = sfi_pieces_at(plan->pieces, u, v, k);
    return piece == UINT32_MAX || plan->is_open[piece];
}

// What to do with a voxel of a shaft that lies in the grid.
typedef void (*visitor)(const sfi_ground_plan *plan, uint32_t x, uint32_t y, uint32_t k,
                        void *context);

// Visit the disk's voxels of one layer; returns whether all of it lies in the open.
static int visit_disk(const sfi_ground_plan *plan, const sfi_drill *at, visitor visit,
                      void *context)
{
    int64_t reach = plan->disk.reach_y;
    int all_open = 1;
    for (int64_t dy = -reach; dy <= reach; dy++) {
        int64_t half = plan->disk.half_width[dy < 0 ? -dy : dy], y = at->y + dy;
        for (int64_t x = at->x - half; x <= at->x + half; x++) {
            all_open = all_open && sfi_drill_is_open(plan, x, y, at->layer);
            if (is_inside(&plan->lattice, x, y, at->layer)) {
                visit(plan, (uint32_t)x, (uint32_t)y, (uint32_t)at->layer, context);
            }
        }
    }
    return all_open;
}

// From the layer below its begin down to the first in which all of it is open, which is returned.
static sfi_drill visit_shaft(const sfi_ground_plan *plan, sfi_drill begin, visitor visit,
                             void *context)
{
    sfi_drill at = begin;
    do {
        sfi_drill_step(plan, &at);
    } while (!visit_disk(plan, &at, visit, context));
    return at;
}

// ---------------------------------------------------------------------------------------------
// Measuring and drilling
// ---------------------------------------------------------------------------------------------

static void add_voxel(const sfi_ground_plan *plan, uint32_t x, uint32_t y, uint32_t k,
                      void *context)
{
    sfi_bore *bore = context;
    const sf_lattice *l = &plan->lattice;
    if (!sf_slice_get(sf_grid_slice(plan->made, k), x, y)) {
        return;
    }
    if (plan->terms != NULL) {
        sf_slice keep = sfi_mask_slice(plan->terms->keep, k);
        sf_slice act = sfi_mask_slice(plan->terms->act, k);
        bore->is_allowed = bore->is_allowed && !sf_slice_get(keep, x, y) &&
                           (act.words == NULL || sf_slice_get(act, x, y));
    }
    double height = plan->levels[k + 1] - plan->levels[k];
    double mass = l->pitch_x_mm * l->pitch_y_mm * height;
    if (plan->density != NULL) {
        mass *= plan->density[((size_t)k * l->ny + y) * l->nx + x];
    }
    sf_body voxel = {mass,
                     {mass * (l->origin_mm[0] + (x + 0.5) * l->pitch_x_mm),
                      mass * (l->origin_mm[1] + (y + 0.5) * l->pitch_y_mm),
                      mass * (plan->levels[k] + 0.5 * height)}};
    bore->body = sf_body_add(bore->body, 1, voxel);
    bore->voxels++;
}

sfi_bore sfi_drill_measure(const sfi_ground_plan *plan, sfi_drill begin)
{
    sfi_bore bore = {1, 0, {0, {0, 0, 0}}, begin};
    bore.end = visit_shaft(plan, begin, add_voxel, &bore);
    return bore;
}

static void remove_voxel(const sfi_ground_plan *plan, uint32_t x, uint32_t y, uint32_t k,
                         void *context)
{
    (void)plan;
    sf_slice slice = sf_grid_slice(context, k);
    sfi_slice_row(slice, y)[x / 64] &= ~(UINT64_C(1) << (x % 64));
}

void sfi_drill_remove(const sfi_ground_plan *plan, sfi_drill begin, sf_grid *grid)
{
    (void)visit_shaft(plan, begin, remove_voxel, grid);
}

static void mark_at(const sfi_ground_plan *plan, int64_t x, int64_t y, int64_t k, sfi_marks *marks)
{
    if (is_inside(&plan->lattice, x, y, k)) {
        uint32_t piece = sfi_pieces_at(plan->pieces, (uint32_t)x, (uint32_t)y, (uint32_t)k);
        if (piece != UINT32_MAX && !marks->is_marked[piece]) {
            marks->is_marked[piece] = 1;
            marks->list[marks->count++] = piece;
        }
    }
}

// A void is opened as well by a shaft that goes past it, face to face.
static void mark_voxel(const sfi_ground_plan *plan, uint32_t x, uint32_t y, uint32_t k,
                       void *context)
{
    mark_at(plan, x, y, k, context);
    for (int i = -1; i <= 1; i += 2) {
        mark_at(plan, (int64_t)x + i, y, k, context);
        mark_at(plan, x, (int64_t)y + i, k, context);
        mark_at(plan, x, y, (int64_t)k + i, context);
    }
}

void sfi_drill_mark(const sfi_ground_plan *plan, sfi_drill begin, sfi_marks *marks)
{
    (void)visit_shaft(plan, begin, mark_voxel, marks);
}

void sfi_drill_mark_around(const sfi_ground_plan *plan, const sf_grid *grid, sf_box box,
                           sfi_marks *marks)
{
    for (uint32_t k = box.z0; k < box.z1; k++) {
        for (uint32_t y = box.y0; y < box.y1; y++) {
            for (uint32_t x = box.x0; x < box.x1; x++) {
                if (sf_slice_get(sf_grid_slice(grid, k), x, y)) {
                    mark_voxel(plan, x, y, k, marks);
                }
            }
        }
    }
}
