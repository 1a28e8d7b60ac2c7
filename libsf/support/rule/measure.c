// SPDX-License-Identifier: MIT
// From a rule to the angles that it allows, in the long run, in every layer of a lattice.

#include "base/math.h"
#include "base/status.h"
#include "support/rule/carry.h"
#include "support/rule/rule.h"

#include <math.h>

#define COS_22_5 0.92387953251128674

// Tangents of the four angles.
typedef struct tangents {
    double x, y, diagonal, steepest;
} tangents;

// What steps of one element over layers of this height allow. Over many of them the sum of the
// elements grows like the convex hull of one, so an overhang along an axis is accepted up to the
// hull's reach there, which for these elements is a voxel on the axis itself; along the pixel's
// diagonal it is the farthest crossing of the hull with it.
static tangents step_tangents(const sf_element *element, const sf_lattice *lattice, double height)
{
    double px = lattice->pitch_x_mm, py = lattice->pitch_y_mm;
    tangents t = {element->half_width[0] * px / height, element->reach_y * py / height, 0.0, 0.0};
    double diagonal = 0.0;
    for (uint32_t i = 0; i <= element->reach_y; i++) {
        double wi = element->half_width[i];
        double radius = sqrt(wi * px * wi * px + i * py * i * py);
        t.steepest = radius > t.steepest ? radius : t.steepest;
        // Edges of the hull run between rows; the diagonal dx = dy crosses the one from row i to
        // row j at dx = dy = s when the corner of row i lies below it and that of row j above.
        for (uint32_t j = i; j <= element->reach_y; j++) {
            double wj = element->half_width[j];
            double below = wi - i, above = j - wj;
            if (below >= 0.0 && above >= 0.0) {
                double s = below + above > 0.0 ? (above * i + below * j) / (below + above) : i;
                diagonal = s > diagonal ? s : diagonal;
            }
        }
    }
    t.diagonal = diagonal * sqrt(px * px + py * py) / height;
    t.steepest /= height;
    return t;
}

static void keep_worst(tangents *worst, const tangents *t)
{
    worst->x = t->x < worst->x ? t->x : worst->x;
    worst->y = t->y < worst->y ? t->y : worst->y;
    worst->diagonal = t->diagonal < worst->diagonal ? t->diagonal : worst->diagonal;
    worst->steepest = t->steepest > worst->steepest ? t->steepest : worst->steepest;
}

// The worst over all steps of a rule whose steps stand each for itself.
static sf_status measure_steps(const sf_rule *rule, const sf_lattice *lattice, tangents *worst)
{
    uint32_t layers = sfi_table_layers(lattice);
    for (uint32_t k = 0; k == 0 || k + 1 < layers; k++) {
        if (k > 0 && lattice->heights_mm[k] == lattice->heights_mm[k - 1]) {
            continue;
        }
        sf_element element;
        SF_TRY(sf_rule_element(rule, k, &element));
        tangents t = step_tangents(&element, lattice, sf_lattice_layer_height(lattice, k));
        if (k == 0) {
            *worst = t;
        }
        keep_worst(worst, &t);
    }
    return SF_OK;
}

// Tangent that a chain of steps makes good along (dx, dy) of the mean reach's: each step is paid
// for in whole units.
static double slack_share(const sf_rule *rule, const sf_lattice *lattice, uint32_t dx, uint32_t dy)
{
    double px = lattice->pitch_x_mm, py = lattice->pitch_y_mm;
    double units = px < py ? rule->slack_x / px : rule->slack_y / py;
    double paid = sfi_slack_cost(rule, dx, dy), x = dx * px, y = dy * py;
    return sqrt(x * x + y * y) * units / paid;
}

// The mean over all layers. Octagon: its vertices lie at the reach of the rule, its sides at
// cos(22.5) of it. Slack: the reach itself, less what its steps are rounded up by.
static tangents measure_mean(const sf_rule *rule, const sf_lattice *lattice)
{
    double reach = (double)rule->reach_x_q24, height = sf_lattice_layer_height(lattice, 0);
    if (rule->table != NULL) {
        uint32_t top = rule->table_count - 1;
        reach = (double)(rule->table[top] - rule->table[0]);
        height = sf_lattice_layer_bottom(lattice, top) - lattice->origin_mm[2];
    }
    double steepest = reach * 0x1p-24 * lattice->pitch_x_mm / height;
    if (rule->kind == SF_RULE_SLACK) {
        tangents t = {steepest * slack_share(rule, lattice, 1, 0),
                      steepest * slack_share(rule, lattice, 0, 1),
                      steepest * slack_share(rule, lattice, 1, 1), steepest};
        return t;
    }
    double side = steepest * COS_22_5;
    tangents t = {side, side, side, steepest};
    return t;
}

sf_status sf_rule_measure(const sf_rule *rule, const sf_lattice *lattice, sf_rule_angles *angles)
{
    if (rule == NULL || lattice == NULL || angles == NULL) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(sf_lattice_validate(lattice));
    if (rule->kind != SF_RULE_BOX3 && rule->table_count != sfi_table_layers(lattice)) {
        return SF_ERR_SHAPE;
    }
    SF_TRY(sfi_rule_check(rule, 0, lattice->nz));
    tangents t;
    if (rule->kind == SF_RULE_OCTAGON || rule->kind == SF_RULE_SLACK) {
        t = measure_mean(rule, lattice);
    } else {
        SF_TRY(measure_steps(rule, lattice, &t));
    }
    angles->axis_x_rad = sfi_atan(t.x);
    angles->axis_y_rad = sfi_atan(t.y);
    angles->diagonal_rad = sfi_atan(t.diagonal);
    angles->steepest_rad = sfi_atan(t.steepest);
    return SF_OK;
}
