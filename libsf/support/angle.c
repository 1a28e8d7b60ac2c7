// SPDX-License-Identifier: MIT
// Rules and angles: from an angle to the integers of a rule, and from a rule to the angles that it
// allows.
//
// A step that starts at a layer of height h may reach h tan(angle) in the plane, that is
// h tan(angle) / p voxels of pitch p. The rule keeps that number in 1/2^24 voxel, rounded down, so
// that the asked angle is never exceeded by it. Down, but not blindly: angles arrive as degrees
// times pi / 180 and pitches as decimal fractions, and 45 degrees at h = p would come out as one
// unit less than 1, which takes the disk its plus. So one part in 2^40 is added first; over the
// widest slice that amounts to 6e-8 voxel.
//
// Where heights differ, the octagon needs the reach from layer 0 to each layer (ALGORITHMS: with
// k rho_k instead its error grows without bound), summed with Neumaier's compensation so that ten
// thousand layers of 0.05 mm are no less than one of 500 mm; so does slack; the disk needs the
// reach of each step.
//
// Slack counts reach in units of its own: as small as a byte for the cap allows, the cap being the
// longest distance in any step's element. On pixels that are not square the longer side is rounded
// up to units, so that no distance is taken for shorter than it is.
//
// A lattice that a rule cannot serve is refused with a sentence that says which rule or pitch can.
//
// Source: T. Reiner, S. Lefebvre, "Interactive Modeling of Support-free Shapes for Fabrication",
// Eurographics 2016, section 2.1 (r = h tan theta). A. Neumaier, "Rundungsfehleranalyse einiger
// Verfahren zur Summation endlicher Summen", ZAMM 54, 1974.

#include "base/math.h"
#include "base/status.h"
#include "support/carry.h"
#include "support/rule.h"

#include <math.h>

#define ANGLE_SLACK_RAD 1e-9
#define COS_22_5 0.92387953251128674
#define BRIDGE_SLACK 0x1p-20 // voxels forgiven to a span or an anchor
#define SLACK_CAP_MAX 254u   // 1 + slack is a byte
#define SLACK_UNITS_MIN 4u   // units in the shorter pitch: coarser than that is no exact angle

// What sf_rule_make() works with.
typedef struct request {
    sf_rule_kind kind;
    double tangent;
    const sf_lattice *lattice;
    sf_fault *fault;
} request;

// value rounded up, but for a part in 2^40.
static double ceil_to_unit(double value)
{
    return -floor(-value * (1.0 - 0x1p-40));
}

static uint64_t to_q24(double reach)
{
    return (uint64_t)floor(reach * 0x1p24 * (1.0 + 0x1p-40));
}

// Layers that a table must serve. A single layer takes no step and needs none.
static uint32_t table_layers(const sf_lattice *lattice)
{
    return lattice->heights_mm != NULL && lattice->nz > 1 ? lattice->nz : 0;
}

size_t sf_rule_table_count(const sf_lattice *lattice)
{
    return lattice == NULL ? 0 : (size_t)table_layers(lattice) * 2;
}

// Millimetres as whole micrometres, rounded down, for a sentence.
static unsigned long long micrometres(double mm)
{
    double um = floor(mm * 1000.0);
    return um < 1e15 ? (unsigned long long)um : 1000000000000000u;
}

static sf_status refuse_short(const request *r, uint32_t layer, char axis, double height)
{
    int square = r->lattice->pitch_x_mm == r->lattice->pitch_y_mm;
    return sfi_fault_set(
        r->fault, SF_ERR_UNSUPPORTED, 0, 0,
        "at this angle the disk reaches less than one voxel along %c in layer %u; %s a pitch along "
        "%c of at most %llu micrometres (a third of that is good)",
        axis, (unsigned)layer, square ? "use the rule octagon, or" : "use", axis,
        micrometres(height * r->tangent));
}

static sf_status refuse_long(const request *r, uint32_t layer)
{
    return sfi_fault_set(r->fault, SF_ERR_UNSUPPORTED, 0, 0,
                         "at this angle layer %u reaches more than %u voxels in one step; use "
                         "thinner layers, a larger pitch or a smaller angle",
                         (unsigned)layer, (unsigned)SF_REACH_MAX);
}

// Whether the step that starts at a layer of this height can be served.
static sf_status check_step(const request *r, uint32_t layer, double height)
{
    double x = height * r->tangent / r->lattice->pitch_x_mm;
    double y = height * r->tangent / r->lattice->pitch_y_mm;
    double largest = x > y ? x : y;
    if (largest > 1e6 || to_q24(largest) > SF_REACH_MAX * SFI_REACH_ONE) {
        return refuse_long(r, layer);
    }
    if (r->kind == SF_RULE_DISK && to_q24(x) < SFI_REACH_ONE) {
        return refuse_short(r, layer, 'x', height);
    }
    if (r->kind == SF_RULE_DISK && to_q24(y) < SFI_REACH_ONE) {
        return refuse_short(r, layer, 'y', height);
    }
    return SF_OK;
}

static sf_status check_request(const request *r)
{
    const sf_lattice *lattice = r->lattice;
    if (r->kind == SF_RULE_OCTAGON && lattice->pitch_x_mm != lattice->pitch_y_mm) {
        return sfi_fault_set(r->fault, SF_ERR_UNSUPPORTED, 0, 0,
                             "the rule octagon needs square pixels, and the pitch along x differs "
                             "from the pitch along y; use the rule slack or disk");
    }
    if (table_layers(lattice) == 0) {
        return check_step(r, 0, sf_lattice_layer_height(lattice, 0));
    }
    // Nothing rests on the topmost layer, so its height asks for nothing.
    for (uint32_t k = 0; k + 1 < lattice->nz; k++) {
        SF_TRY(check_step(r, k, lattice->heights_mm[k]));
    }
    return SF_OK;
}

// Reach from layer 0 to each layer.
static void fill_cumulative(const request *r, double pitch, uint64_t *table)
{
    const sf_lattice *lattice = r->lattice;
    double sum = 0.0, lost = 0.0;
    for (uint32_t k = 0; k < lattice->nz; k++) {
        table[k] = to_q24((sum + lost) * r->tangent / pitch);
        double height = lattice->heights_mm[k];
        double next = sum + height;
        lost += sum >= height ? (sum - next) + height : (height - next) + sum;
        sum = next;
    }
}

// Reach of each step; the topmost layer takes none.
static void fill_steps(const request *r, double pitch, uint64_t *table)
{
    const sf_lattice *lattice = r->lattice;
    for (uint32_t k = 0; k + 1 < lattice->nz; k++) {
        table[k] = to_q24(lattice->heights_mm[k] * r->tangent / pitch);
    }
    table[lattice->nz - 1] = 0;
}

static sf_rule build(const request *r, uint64_t *table)
{
    const sf_lattice *lattice = r->lattice;
    sf_rule rule = {.kind = r->kind};
    if (table_layers(lattice) == 0) {
        double reach_mm = sf_lattice_layer_height(lattice, 0) * r->tangent;
        rule.reach_x_q24 = to_q24(reach_mm / lattice->pitch_x_mm);
        rule.reach_y_q24 = to_q24(reach_mm / lattice->pitch_y_mm);
        return rule;
    }
    void (*fill)(const request *, double, uint64_t *) =
        r->kind == SF_RULE_DISK ? fill_steps : fill_cumulative;
    fill(r, lattice->pitch_x_mm, table);
    fill(r, lattice->pitch_y_mm, table + lattice->nz);
    rule.table_count = lattice->nz;
    rule.table = table;
    return rule;
}

// Units in the pitches for `units` in the shorter one, and the cap: the dearest reach of an
// element.
static void set_units(const sf_lattice *lattice, const sf_element *element, uint32_t units,
                      sf_rule *rule)
{
    double px = lattice->pitch_x_mm, py = lattice->pitch_y_mm, shorter = px < py ? px : py;
    double x = ceil_to_unit(px / shorter * units), y = ceil_to_unit(py / shorter * units);
    uint32_t cap = 0;
    rule->slack_x = (uint16_t)(x < 65535.0 ? x : 65535.0);
    rule->slack_y = (uint16_t)(y < 65535.0 ? y : 65535.0);
    for (uint32_t dy = 0; dy <= element->reach_y; dy++) {
        uint32_t cost = sfi_slack_cost(rule, element->half_width[dy], dy);
        cap = cost > cap ? cost : cap;
    }
    rule->slack_cap = (uint16_t)(cap < 65535 ? cap : 65535);
}

// The smallest unit with which the cap of a rule's widest step fits a byte.
static sf_status choose_units(const request *r, sf_rule *rule)
{
    uint32_t widest = 0;
    for (uint32_t k = 1; k + 1 < table_layers(r->lattice); k++) {
        widest = r->lattice->heights_mm[k] > r->lattice->heights_mm[widest] ? k : widest;
    }
    sf_element element;
    rule->slack_x = rule->slack_y = rule->slack_cap = 1; // for the element to be asked for
    SF_TRY(sf_rule_element(rule, widest, &element));
    uint32_t units = SLACK_CAP_MAX;
    for (set_units(r->lattice, &element, units, rule);
         units > SLACK_UNITS_MIN && rule->slack_cap > SLACK_CAP_MAX; units--) {
        set_units(r->lattice, &element, units - 1, rule);
    }
    if (rule->slack_cap > SLACK_CAP_MAX) {
        return sfi_fault_set(r->fault, SF_ERR_UNSUPPORTED, 0, 0,
                             "at this angle a step reaches over more than %u pixels, too many for "
                             "the rule slack; use a larger pitch, thinner layers or the rule disk",
                             (unsigned)(SLACK_CAP_MAX / SLACK_UNITS_MIN));
    }
    return SF_OK;
}

sf_status sf_rule_make(sf_rule_kind kind, double angle_rad, const sf_lattice *lattice,
                       uint64_t *table, sf_rule *rule, sf_fault *fault)
{
    if (lattice == NULL || rule == NULL) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "a lattice and a rule are needed");
    }
    sf_status status = sf_lattice_validate(lattice);
    if (status != SF_OK) {
        return sfi_fault_set(fault, status, 0, 0, "the lattice is not a valid one");
    }
    if (kind == SF_RULE_BOX3) {
        *rule = sf_rule_box3();
        return SF_OK;
    }
    if (kind != SF_RULE_OCTAGON && kind != SF_RULE_DISK && kind != SF_RULE_SLACK) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "there is no rule of this kind");
    }
    if (!(angle_rad >= SF_RULE_ANGLE_MIN_RAD - ANGLE_SLACK_RAD &&
          angle_rad <= SF_RULE_ANGLE_MAX_RAD + ANGLE_SLACK_RAD)) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                             "an overhang angle lies between 5 and 85 degrees, measured from the "
                             "vertical");
    }
    if (table_layers(lattice) > 0 && table == NULL) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                             "layers of different heights need a table");
    }
    request r = {kind, sfi_tan(angle_rad), lattice, fault};
    SF_TRY(check_request(&r));
    sf_rule made = build(&r, table);
    if (kind == SF_RULE_SLACK) {
        SF_TRY(choose_units(&r, &made));
    }
    *rule = made;
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Bridges
// ---------------------------------------------------------------------------------------------

// A length in voxels, rounded up or down; more than the limit where it does not fit.
static uint32_t whole_voxels(double mm, double pitch, int up)
{
    double voxels = mm / pitch;
    if (voxels > SF_BRIDGE_SPAN_MAX) {
        return SF_BRIDGE_SPAN_MAX + 1;
    }
    return (uint32_t)(up ? -floor(-voxels + BRIDGE_SLACK) : floor(voxels + BRIDGE_SLACK));
}

sf_status sf_rule_set_bridges(sf_rule *rule, double span_mm, double anchor_mm,
                              const sf_lattice *lattice, sf_fault *fault)
{
    if (rule == NULL || lattice == NULL) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "a rule and a lattice are needed");
    }
    sf_status status = sf_lattice_validate(lattice);
    if (status != SF_OK) {
        return sfi_fault_set(fault, status, 0, 0, "the lattice is not a valid one");
    }
    if (!(span_mm >= 0.0) || !(anchor_mm >= 0.0)) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                             "the span of a bridge and its anchor are lengths in mm, 0 or more");
    }
    double px = lattice->pitch_x_mm, py = lattice->pitch_y_mm;
    double pitches[3] = {px, py, sqrt(px * px + py * py)};
    uint32_t spans[3], anchors[3], longest = 0;
    for (int i = 0; i < 3; i++) {
        spans[i] = whole_voxels(span_mm, pitches[i], 0);
        anchors[i] = whole_voxels(anchor_mm, pitches[i], 1);
        longest = spans[i] > longest ? spans[i] : longest;
        longest = anchors[i] > longest ? anchors[i] : longest;
    }
    if (longest > SF_BRIDGE_SPAN_MAX) {
        return sfi_fault_set(fault, SF_ERR_UNSUPPORTED, 0, 0,
                             "a bridge or its anchor is longer than %u voxels; use a larger pitch "
                             "or a shorter one",
                             (unsigned)SF_BRIDGE_SPAN_MAX);
    }
    if (span_mm > 0.0 && spans[0] == 0 && spans[1] == 0) {
        return sfi_fault_set(fault, SF_ERR_UNSUPPORTED, 0, 0,
                             "a bridge of this span is shorter than a voxel; use a smaller pitch, "
                             "or a span of 0 for no bridges");
    }
    sf_bridge none = {0, 0, 0, 0, 0, 0};
    sf_bridge some = {(uint16_t)spans[0],   (uint16_t)spans[1],   (uint16_t)spans[2],
                      (uint16_t)anchors[0], (uint16_t)anchors[1], (uint16_t)anchors[2]};
    rule->bridge = span_mm > 0.0 ? some : none;
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// From a rule to angles
// ---------------------------------------------------------------------------------------------

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
    uint32_t layers = table_layers(lattice);
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
    if (rule->kind != SF_RULE_BOX3 && rule->table_count != table_layers(lattice)) {
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
