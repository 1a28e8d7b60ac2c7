// SPDX-License-Identifier: MIT
// Rules and angles: from an angle and a lattice to the integers of a rule.
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
#include "support/rule/carry.h"
#include "support/rule/rule.h"

#include <math.h>

#define ANGLE_SLACK_RAD 1e-9
#define SLACK_RATIO_MAX 25 // with which sqrt(5) of the longer pitch is still within the cap

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

uint32_t sfi_table_layers(const sf_lattice *lattice)
{
    return lattice->heights_mm != NULL && lattice->nz > 1 ? lattice->nz : 0;
}

size_t sf_rule_table_count(const sf_lattice *lattice)
{
    return lattice == NULL ? 0 : (size_t)sfi_table_layers(lattice) * 2;
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
    if (sfi_table_layers(lattice) == 0) {
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
    if (sfi_table_layers(lattice) == 0) {
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

// The widest step of the lattice, in 1/2^24 voxel along x and y.
static void widest_step(const request *r, uint64_t *x_q24, uint64_t *y_q24)
{
    const sf_lattice *lattice = r->lattice;
    double highest = sf_lattice_layer_height(lattice, 0);
    for (uint32_t k = 1; k + 1 < sfi_table_layers(lattice); k++) {
        highest = lattice->heights_mm[k] > highest ? lattice->heights_mm[k] : highest;
    }
    *x_q24 = to_q24(highest * r->tangent / lattice->pitch_x_mm);
    *y_q24 = to_q24(highest * r->tangent / lattice->pitch_y_mm);
}

// Units in the pitches for `units` in the shorter one, and the cap: the dearest reach of the widest
// step. Returns whether they serve.
static int set_units(const request *r, uint32_t units, sf_rule *rule)
{
    const sf_lattice *lattice = r->lattice;
    double px = lattice->pitch_x_mm, py = lattice->pitch_y_mm, shorter = px < py ? px : py;
    double x = ceil_to_unit(px / shorter * units), y = ceil_to_unit(py / shorter * units);
    uint64_t x_q24, y_q24;
    sf_element element;
    widest_step(r, &x_q24, &y_q24);
    if (x > SFI_SLACK_CAP_MAX || y > SFI_SLACK_CAP_MAX) {
        return 0;
    }
    rule->slack_x = (uint16_t)x;
    rule->slack_y = (uint16_t)y;
    if (sfi_slack_element(rule, x_q24, y_q24, &element) != SF_OK) {
        return 0;
    }
    uint32_t cap = 0;
    for (uint32_t dy = 0; dy <= element.reach_y; dy++) {
        uint32_t cost = sfi_slack_cost(rule, element.half_width[dy], dy);
        cap = cost > cap ? cost : cap;
    }
    rule->slack_cap = (uint16_t)(cap < 65535 ? cap : 65535);
    return cap <= SFI_SLACK_CAP_MAX;
}

// The smallest unit with which the cap fits a byte.
static sf_status choose_units(const request *r, sf_rule *rule)
{
    uint32_t units = SFI_SLACK_CAP_MAX;
    while (units >= SFI_SLACK_UNITS_MIN && !set_units(r, units, rule)) {
        units--;
    }
    if (units >= SFI_SLACK_UNITS_MIN) {
        return SF_OK;
    }
    double px = r->lattice->pitch_x_mm, py = r->lattice->pitch_y_mm;
    double ratio = px > py ? px / py : py / px;
    if (ratio > SLACK_RATIO_MAX) {
        return sfi_fault_set(r->fault, SF_ERR_UNSUPPORTED, 0, 0,
                             "pixels are more than %d times as long as wide, too oblong for the "
                             "rule slack; use the rule disk",
                             SLACK_RATIO_MAX);
    }
    return sfi_fault_set(r->fault, SF_ERR_UNSUPPORTED, 0, 0,
                         "at this angle a step reaches over more than %u pixels, too many for the "
                         "rule slack; use a larger pitch, thinner layers or the rule disk",
                         (unsigned)SFI_SLACK_REACH_MAX);
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
    if (sfi_table_layers(lattice) > 0 && table == NULL) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                             "layers of different heights need a table");
    }
    request r = {kind, sfi_tan(angle_rad), lattice, fault};
    SF_TRY(check_request(&r));
    sf_rule units = {.kind = kind};
    if (kind == SF_RULE_SLACK) {
        SF_TRY(choose_units(&r, &units)); // before anything is written
    }
    *rule = build(&r, table);
    rule->slack_x = units.slack_x;
    rule->slack_y = units.slack_y;
    rule->slack_cap = units.slack_cap;
    return SF_OK;
}
