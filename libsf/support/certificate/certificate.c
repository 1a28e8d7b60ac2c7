// SPDX-License-Identifier: MIT
// Certificates: what is claimed, held against the shape, and kept.
//
// A certificate is made in three steps, and nothing of it leaves before all are done. First the
// claim: the rule is made again from the claimed angle and spans, and must be the one in the terms,
// integer by integer, so that what people read (degrees, millimetres) is what was checked. Then the
// shape: a sweep over all its layers (witness.c) ends at the first voxel that nothing carries.
// Last the past: what was added and removed, and that the operation is one that does so.
//
// The tangent is kept because it is the one number between the claim and the integers that another
// program might round otherwise: from it on every step is a product, a quotient or a floor, which
// are the same everywhere.

#include <sf/certificate.h>

#include "base/math.h"
#include "base/memory.h"
#include "base/status.h"
#include "support/certificate/fingerprint.h"
#include "support/certificate/witness.h"
#include "support/rule/carry.h"
#include "support/rule/rule.h"
#include "support/rule/terms.h"
#include "voxel/slice.h"

#include <string.h>

struct sf_certificate {
    sf_allocator allocator;
    sf_certificate_view view; // its arrays are the ones below
    sfi_witness witness;
    sf_certificate_step *steps;
    double *heights;
};

const char *sf_operation_name(sf_operation operation)
{
    static const char *const names[] = {"check", "trim", "grow", "repair", "preserve"};
    unsigned i = (unsigned)operation;
    return i < sizeof names / sizeof names[0] ? names[i] : "unknown";
}

sf_claim sf_claim_default(void)
{
    sf_claim claim = {sizeof claim, NULL, 0.0, 0.0, 0.0, SF_OPERATION_CHECK, NULL};
    return claim;
}

// ---------------------------------------------------------------------------------------------
// The claim
// ---------------------------------------------------------------------------------------------

static sf_status refuse(sf_fault *fault, const char *sentence)
{
    return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "%s", sentence);
}

// Whether two rules for one lattice are the same integers.
static int is_same_rule(const sf_rule *a, const sf_rule *b)
{
    const sf_bridge *p = &a->bridge, *q = &b->bridge;
    int same = a->kind == b->kind && p->span_x == q->span_x && p->span_y == q->span_y &&
               p->span_diagonal == q->span_diagonal && p->anchor_x == q->anchor_x &&
               p->anchor_y == q->anchor_y && p->anchor_diagonal == q->anchor_diagonal;
    if (!same || a->kind == SF_RULE_BOX3) {
        return same;
    }
    same = a->table_count == b->table_count && a->slack_x == b->slack_x &&
           a->slack_y == b->slack_y && a->slack_cap == b->slack_cap;
    if (same && a->table != NULL) {
        return memcmp(a->table, b->table, (size_t)a->table_count * 2 * sizeof *a->table) == 0;
    }
    return same && a->reach_x_q24 == b->reach_x_q24 && a->reach_y_q24 == b->reach_y_q24;
}

// Whether the rule of the terms is the one that the claimed numbers make.
static sf_status check_rule(const sf_claim *claim, const sf_lattice *lattice,
                            const sf_allocator *allocator, sf_fault *fault)
{
    const sf_rule *rule = &claim->terms->rule;
    size_t count = rule->kind == SF_RULE_BOX3 ? 0 : sf_rule_table_count(lattice);
    uint64_t *table = NULL;
    sf_rule made;
    if (count > 0) {
        table = sfi_alloc_array(allocator, count, sizeof *table);
        if (table == NULL) {
            return SF_ERR_MEMORY;
        }
    }
    sf_status status = sf_rule_make(rule->kind, claim->angle_rad, lattice, table, &made, fault);
    if (status == SF_OK) {
        status = sf_rule_set_bridges(&made, claim->bridge_span_mm, claim->bridge_anchor_mm, lattice,
                                     fault);
    }
    if (status == SF_OK && !is_same_rule(&made, rule)) {
        status = refuse(fault, "the rule is not the one that the claimed angle and bridges make on "
                               "this lattice");
    }
    sfi_free_array(allocator, table, count, sizeof *table);
    return status;
}

static sf_status check_claim(const sf_claim *claim, const sf_grid *shape, sfi_ground *ground,
                             sf_fault *fault)
{
    if (shape == NULL || claim == NULL || claim->struct_size < sizeof *claim ||
        claim->terms == NULL) {
        return refuse(fault, "a shape and a claim with its terms are needed");
    }
    if ((unsigned)claim->operation > SF_OPERATION_PRESERVE) {
        return refuse(fault, "there is no operation of this kind");
    }
    sf_status status = sfi_terms_check(claim->terms, shape, ground);
    if (status == SF_OK && claim->before != NULL) {
        status = sfi_terms_match(&ground->lattice, claim->before);
    }
    return status == SF_OK ? SF_OK
                           : sfi_fault_set(fault, status, 0, 0, "the terms do not serve the shape");
}

// ---------------------------------------------------------------------------------------------
// Contents
// ---------------------------------------------------------------------------------------------

// What the view says of the claim; arrays come later.
static void take_claim(sf_certificate_view *view, const sf_claim *claim, const sfi_ground *ground)
{
    const sf_rule *rule = &claim->terms->rule;
    int has_angle = rule->kind != SF_RULE_BOX3, has_slack = rule->kind == SF_RULE_SLACK;
    view->operation = claim->operation;
    view->lattice = ground->lattice;
    view->kind = rule->kind;
    view->angle_rad = has_angle ? claim->angle_rad : 0.0;
    view->tangent = has_angle ? sfi_tan(claim->angle_rad) : 0.0;
    view->bridge = rule->bridge;
    if (claim->bridge_span_mm > 0.0) {
        view->bridge_span_mm = claim->bridge_span_mm;
        view->bridge_anchor_mm = claim->bridge_anchor_mm;
    }
    view->slack_x = (uint16_t)(has_slack ? rule->slack_x : 0);
    view->slack_y = (uint16_t)(has_slack ? rule->slack_y : 0);
    view->slack_cap = (uint16_t)(has_slack ? rule->slack_cap : 0);
    view->bed_layer = claim->terms->bed_layer;
    view->bed = ground->bed;
    view->step_count = ground->lattice.nz - 1;
}

// The integers of the step from layer k.
static sf_status take_step(const sf_rule *rule, uint32_t k, sf_certificate_step *step)
{
    if (rule->kind == SF_RULE_BOX3 || rule->kind == SF_RULE_OCTAGON) {
        sf_element element;
        SF_TRY(sf_rule_element(rule, k, &element));
        step->first = element.reach_y;
        step->second = (uint64_t)element.reach_y + element.half_width[element.reach_y];
        step->gain = 0;
        return SF_OK;
    }
    const uint64_t *x = rule->table, *y = x != NULL ? x + rule->table_count : NULL;
    int is_sum = rule->kind == SF_RULE_SLACK; // whose table holds sums
    step->first = x == NULL ? rule->reach_x_q24 : is_sum ? x[k + 1] - x[k] : x[k];
    step->second = y == NULL ? rule->reach_y_q24 : is_sum ? y[k + 1] - y[k] : y[k];
    step->gain = is_sum ? sfi_slack_gain(rule, k) : 0;
    return SF_OK;
}

// Memory of the certificate's own for what the view points to.
static sf_status take_arrays(sf_certificate *c, const sf_rule *rule)
{
    sf_lattice *lattice = &c->view.lattice;
    if (lattice->heights_mm != NULL) {
        c->heights = sfi_alloc_array(&c->allocator, lattice->nz, sizeof *c->heights);
        if (c->heights == NULL) {
            return SF_ERR_MEMORY;
        }
        memcpy(c->heights, lattice->heights_mm, lattice->nz * sizeof *c->heights);
        lattice->heights_mm = c->heights;
    }
    if (c->view.step_count == 0) {
        return SF_OK;
    }
    c->steps = sfi_alloc_array(&c->allocator, c->view.step_count, sizeof *c->steps);
    if (c->steps == NULL) {
        return SF_ERR_MEMORY;
    }
    for (uint32_t k = 0; k < c->view.step_count; k++) {
        SF_TRY(take_step(rule, k, &c->steps[k]));
    }
    c->view.steps = c->steps;
    return SF_OK;
}

static sf_status take_evidence(sf_certificate *c, const sf_grid *shape, const sf_claim *claim,
                               sfi_progress *progress, uint64_t total, sf_fault *fault)
{
    sfi_witness *w = &c->witness;
    SF_TRY(sfi_witness_find(w, shape, claim->terms, c->view.bed, progress, 0, total, fault));
    c->view.layers = w->layers;
    c->view.exempt = w->exempt;
    c->view.exempt_count = w->exempt_count;
    c->view.spans = w->spans;
    c->view.span_count = w->span_count;
    return SF_OK;
}

// |a without b|.
static sf_status count_without(const sf_grid *a, const sf_grid *b, uint32_t k, sf_slice scratch,
                               uint64_t *count)
{
    SF_TRY(sf_slice_subtract(scratch, sf_grid_slice(a, k), sf_grid_slice(b, k)));
    *count += sf_slice_popcount(scratch);
    return SF_OK;
}

static sf_status count_changes(sf_certificate_view *view, const sf_grid *before,
                               const sf_grid *shape, const sf_allocator *allocator)
{
    sf_lattice one = view->lattice;
    sf_grid *memory;
    one.nz = 1;
    SF_TRY(sf_grid_create(&one, allocator, &memory));
    sf_slice scratch = sf_grid_slice(memory, 0);
    sf_status status = SF_OK;
    for (uint32_t k = 0; status == SF_OK && k < view->lattice.nz; k++) {
        status = count_without(shape, before, k, scratch, &view->added_voxels);
        if (status == SF_OK) {
            status = count_without(before, shape, k, scratch, &view->removed_voxels);
        }
    }
    sf_grid_destroy(memory);
    view->input_voxels = sf_grid_popcount(before);
    view->output_voxels = sf_grid_popcount(shape);
    return status;
}

static sf_status check_changes(const sf_certificate_view *view, sf_fault *fault)
{
    int adds = view->operation == SF_OPERATION_GROW || view->operation == SF_OPERATION_REPAIR;
    int removes = view->operation != SF_OPERATION_CHECK && view->operation != SF_OPERATION_GROW;
    if ((view->added_voxels > 0 && !adds) || (view->removed_voxels > 0 && !removes)) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                             "%llu voxels were added and %llu removed, which is not what a %s does",
                             (unsigned long long)view->added_voxels,
                             (unsigned long long)view->removed_voxels,
                             sf_operation_name(view->operation));
    }
    return SF_OK;
}

static sf_status take_past(sf_certificate *c, const sf_grid *shape, const sf_claim *claim,
                           sfi_progress *progress, uint64_t total, sf_fault *fault)
{
    sf_certificate_view *view = &c->view;
    const sf_grid *before = claim->before != NULL ? claim->before : shape;
    uint64_t nz = view->lattice.nz;
    SF_TRY(count_changes(view, before, shape, &c->allocator));
    SF_TRY(check_changes(view, fault));
    SF_TRY(sfi_grid_sha256(shape, progress, nz, total, view->output_sha256));
    return sfi_grid_sha256(before, progress, 2 * nz, total, view->input_sha256);
}

static sf_status fill(sf_certificate *c, const sf_grid *shape, const sf_claim *claim,
                      const sfi_ground *ground, sf_task *task, sf_fault *fault)
{
    sfi_progress progress = sfi_progress_begin(task);
    uint64_t total = (uint64_t)ground->lattice.nz * 3;
    take_claim(&c->view, claim, ground);
    SF_TRY(take_arrays(c, &claim->terms->rule));
    SF_TRY(take_evidence(c, shape, claim, &progress, total, fault));
    return take_past(c, shape, claim, &progress, total, fault);
}

sf_status sf_certificate_make(const sf_grid *shape, const sf_claim *claim,
                              const sf_allocator *allocator, sf_task *task,
                              sf_certificate **certificate, sf_fault *fault)
{
    sfi_ground ground;
    if (certificate == NULL) {
        return refuse(fault, "there is no place for the certificate");
    }
    SF_TRY(check_claim(claim, shape, &ground, fault));
    sf_allocator from = sfi_allocator_or_default(allocator);
    sf_status status = check_rule(claim, &ground.lattice, &from, fault);
    sf_certificate *made = NULL;
    if (status == SF_OK) {
        made = sfi_alloc_array(&from, 1, sizeof *made);
        status = made != NULL ? SF_OK : SF_ERR_MEMORY;
    }
    if (status == SF_OK) {
        sf_certificate empty = {.allocator = from, .witness = {.allocator = from}};
        *made = empty;
        status = fill(made, shape, claim, &ground, task, fault);
    }
    if (status != SF_OK) {
        sf_certificate_destroy(made);
        int told = status == SF_ERR_INFEASIBLE || status == SF_ERR_ARGUMENT ||
                   status == SF_ERR_UNSUPPORTED;
        return told ? status : sfi_fault_set(fault, status, 0, 0, "%s", sf_status_message(status));
    }
    *certificate = made;
    return SF_OK;
}

sf_certificate_view sf_certificate_get_view(const sf_certificate *certificate)
{
    static const sf_certificate nothing;
    return certificate != NULL ? certificate->view : nothing.view;
}

void sf_certificate_destroy(sf_certificate *certificate)
{
    if (certificate != NULL) {
        sf_allocator allocator = certificate->allocator;
        uint32_t nz = certificate->view.lattice.nz;
        sfi_witness_release(&certificate->witness, nz);
        sfi_free_array(&allocator, certificate->steps, certificate->view.step_count,
                       sizeof *certificate->steps);
        sfi_free_array(&allocator, certificate->heights, nz, sizeof *certificate->heights);
        sfi_free_array(&allocator, certificate, 1, sizeof *certificate);
    }
}
