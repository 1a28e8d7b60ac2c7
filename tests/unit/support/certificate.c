// SPDX-License-Identifier: MIT
// Why: what a certificate says is what it was asked to certify, counted by brute force; a claim
// that is not true gets none, with a sentence that says why; and a call that fails or is cancelled,
// at whatever request for memory or report of progress, leaves everything as it was (TRUST 84-86).
// That somebody else believes a certificate is what tests/verify is for. Guards issue 3,
// certificate.

#include <sf/certificate.h>

#include "base/sha256.h"
#include "failing_allocator.h"
#include "law/stack.h"

static const double degrees = 3.14159265358979323846 / 180.0;

static void operations_have_names(void)
{
    CHECK_STR(sf_operation_name(SF_OPERATION_CHECK), "check");
    CHECK_STR(sf_operation_name(SF_OPERATION_TRIM), "trim");
    CHECK_STR(sf_operation_name(SF_OPERATION_GROW), "grow");
    CHECK_STR(sf_operation_name(SF_OPERATION_REPAIR), "repair");
    CHECK_STR(sf_operation_name(SF_OPERATION_PRESERVE), "preserve");
    CHECK_STR(sf_operation_name((sf_operation)5), "unknown");
}

// The bytes as the header tells them, bit by bit.
static void fingerprints_are_of_the_pictures_bits(void)
{
    static stack s;
    static uint8_t bytes[STACK_VOXELS];
    for (int width = 1; width <= 140; width += width < 70 ? 1 : 23) {
        size_t size = 0, row = ((size_t)width + 7) / 8;
        uint8_t expected[SF_SHA256_SIZE], digest[SF_SHA256_SIZE];
        sfi_sha256 hash;
        stack_random(&s, width, 5, 3, 0.5);
        memset(bytes, 0, sizeof bytes);
        for (int z = 0; z < s.nz; z++) {
            for (int y = s.ny - 1; y >= 0; y--, size += row) {
                for (int x = 0; x < width; x++) {
                    bytes[size + (size_t)x / 8] |=
                        (uint8_t)(stack_get(&s, x, y, z) ? 128 >> x % 8 : 0);
                }
            }
        }
        sfi_sha256_begin(&hash);
        sfi_sha256_add(&hash, bytes, size);
        sfi_sha256_end(&hash, expected);
        sf_grid *grid = stack_grid(&s);
        CHECK_EQ(sf_grid_sha256(grid, NULL, digest), SF_OK);
        CHECK_EQ(memcmp(digest, expected, sizeof digest), 0);
        sf_grid_destroy(grid);
    }
    uint8_t digest[SF_SHA256_SIZE];
    CHECK_EQ(sf_grid_sha256(NULL, NULL, digest), SF_ERR_ARGUMENT);
}

// Something to certify: random boxes with beams, trimmed.
typedef struct scene {
    sf_grid *before, *after, *exempt;
    sf_terms terms;
    sf_claim claim;
} scene;

static void scene_begin(scene *s, sf_rule_kind kind, double span_mm)
{
    static stack drawn, mask;
    stack_random_boxes(&drawn, 24, 19, 12, 9);
    stack_random(&mask, 24, 19, 12, 0.05);
    for (int x = 0; x < 24; x++) {
        *stack_at(&drawn, x, 7, 6) = *stack_at(&drawn, x, 11, 9) = 1;
    }
    s->before = stack_grid(&drawn);
    s->exempt = stack_grid(&mask);
    s->after = NULL;
    CHECK_EQ(sf_grid_clone(s->before, NULL, &s->after), SF_OK);
    sf_lattice lattice = sf_grid_lattice(s->before);
    s->terms = sf_terms_default();
    CHECK_EQ(sf_rule_make(kind, 40 * degrees, &lattice, NULL, &s->terms.rule, NULL), SF_OK);
    CHECK_EQ(sf_rule_set_bridges(&s->terms.rule, span_mm, 0.1, &lattice, NULL), SF_OK);
    s->terms.exempt = s->exempt;
    CHECK_EQ(sf_grid_trim_on(s->after, &s->terms, NULL, NULL, NULL, NULL), SF_OK);
    s->claim = sf_claim_default();
    s->claim.terms = &s->terms;
    s->claim.angle_rad = 40 * degrees;
    s->claim.bridge_span_mm = span_mm;
    s->claim.bridge_anchor_mm = 0.1;
    s->claim.operation = SF_OPERATION_TRIM;
    s->claim.before = s->before;
}

static void scene_end(scene *s)
{
    sf_grid_destroy(s->before);
    sf_grid_destroy(s->after);
    sf_grid_destroy(s->exempt);
}

static void it_says_what_there_is(void)
{
    static stack before, after, mask;
    scene s;
    scene_begin(&s, SF_RULE_SLACK, 0.6);
    sf_certificate *made = NULL;
    CHECK_EQ(sf_certificate_make(s.after, &s.claim, NULL, NULL, &made, NULL), SF_OK);
    sf_certificate_view v = sf_certificate_get_view(made);
    stack_read(&before, s.before);
    stack_read(&after, s.after);
    stack_read(&mask, s.exempt);
    CHECK_EQ(v.input_voxels, stack_volume(&before));
    CHECK_EQ(v.output_voxels, stack_volume(&after));
    CHECK_EQ(v.removed_voxels, stack_volume(&before) - stack_volume(&after));
    CHECK_EQ(v.added_voxels, 0);
    CHECK_EQ(v.kind, SF_RULE_SLACK);
    CHECK_EQ(v.step_count, 11);
    CHECK_EQ(v.bed, stack_bed(&after, SF_BED_AUTO));
    uint64_t solid[12] = {0}, free_voxels[12] = {0};
    for (int i = 0; i < stack_count(&after); i++) {
        solid[i / (24 * 19)] += after.solid[i];
        free_voxels[i / (24 * 19)] += after.solid[i] & mask.solid[i];
    }
    for (int k = 0; k < 12; k++) {
        CHECK_EQ(v.layers[k].solid, solid[k]);
        CHECK_EQ(v.layers[k].exempt, free_voxels[k]);
    }
    for (size_t i = 0; i < v.exempt_count; i++) {
        const sf_run *r = &v.exempt[i];
        for (uint32_t x = r->x0; x < r->x1; x++) {
            CHECK(stack_get(&after, (int)x, (int)r->y, (int)r->label) &&
                  stack_get(&mask, (int)x, (int)r->y, (int)r->label));
            free_voxels[r->label]--;
        }
    }
    for (int k = 0; k < 12; k++) {
        CHECK_EQ(free_voxels[k], 0);
    }
    CHECK(v.span_count > 0);
    sf_certificate_destroy(made);
    sf_certificate_destroy(NULL);
    CHECK(sf_certificate_get_view(NULL).layers == NULL);
    scene_end(&s);
}

static void refused(const sf_grid *shape, const sf_claim *claim, sf_status status)
{
    sf_certificate *made = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    CHECK_EQ(sf_certificate_make(shape, claim, NULL, NULL, &made, &fault), status);
    CHECK_EQ(fault.status, status);
    CHECK(fault.message[0] != '\0' && made == NULL);
}

static void false_claims_get_none(void)
{
    scene s;
    scene_begin(&s, SF_RULE_OCTAGON, 0.6);
    sf_claim claim = s.claim;
    refused(s.before, &s.claim, SF_ERR_INFEASIBLE);
    refused(NULL, &claim, SF_ERR_ARGUMENT);
    refused(s.after, NULL, SF_ERR_ARGUMENT);
    CHECK_EQ(sf_certificate_make(s.after, &claim, NULL, NULL, NULL, NULL), SF_ERR_ARGUMENT);
    claim.angle_rad = 41 * degrees;
    refused(s.after, &claim, SF_ERR_ARGUMENT);
    claim.angle_rad = NAN;
    refused(s.after, &claim, SF_ERR_ARGUMENT);
    claim = s.claim;
    claim.bridge_span_mm = 0.8;
    refused(s.after, &claim, SF_ERR_ARGUMENT);
    claim.bridge_span_mm = -1;
    refused(s.after, &claim, SF_ERR_ARGUMENT);
    claim = s.claim;
    claim.operation = SF_OPERATION_GROW; // but something was removed
    refused(s.after, &claim, SF_ERR_ARGUMENT);
    claim.operation = SF_OPERATION_CHECK;
    refused(s.after, &claim, SF_ERR_ARGUMENT);
    claim.operation = (sf_operation)5;
    refused(s.after, &claim, SF_ERR_ARGUMENT);
    claim = s.claim;
    claim.struct_size = 8;
    refused(s.after, &claim, SF_ERR_ARGUMENT);
    claim = s.claim;
    claim.terms = NULL;
    refused(s.after, &claim, SF_ERR_ARGUMENT);
    static stack small;
    stack_clear(&small, 4, 4, 4);
    sf_grid *other = stack_grid(&small);
    claim = s.claim;
    claim.before = other;
    refused(s.after, &claim, SF_ERR_SHAPE);
    sf_terms terms = s.terms;
    terms.exempt = other;
    claim = s.claim;
    claim.terms = &terms;
    refused(s.after, &claim, SF_ERR_SHAPE);
    terms.exempt = NULL; // what was exempt hangs in the air
    refused(s.after, &claim, SF_ERR_INFEASIBLE);
    sf_grid_destroy(other);
    scene_end(&s);
}

static void memory_may_run_out_anywhere(void)
{
    scene s;
    scene_begin(&s, SF_RULE_SLACK, 0.6);
    for (long fail_at = 0;; fail_at++) {
        failing_allocator f;
        sf_certificate *made = NULL;
        sf_fault fault = {SF_OK, 0, 0, ""};
        failing_begin(&f, fail_at);
        sf_status status =
            sf_certificate_make(s.after, &s.claim, &f.allocator, NULL, &made, &fault);
        CHECK(status == SF_OK || (status == SF_ERR_MEMORY && made == NULL));
        sf_certificate_destroy(made);
        CHECK_EQ(f.live, 0);
        CHECK_EQ(f.faults, 0);
        if (status == SF_OK || fail_at > 1000) {
            CHECK(fail_at > 8 && fail_at < 1000);
            break;
        }
    }
    scene_end(&s);
}

typedef struct watcher {
    sf_task task;
    int reports, cancel_at;
    double last;
} watcher;

static void watch(void *user, double fraction)
{
    watcher *w = user;
    CHECK(fraction >= w->last && fraction <= 1.0);
    w->last = fraction;
    if (w->reports++ == w->cancel_at) {
        sf_task_cancel(&w->task);
    }
}

static void it_may_be_cancelled_at_any_report(void)
{
    scene s;
    scene_begin(&s, SF_RULE_BOX3, 0.6);
    int reports = 1000;
    for (int cancel_at = -1; cancel_at < reports - 1; cancel_at++) {
        watcher w = {sf_task_default(), 0, cancel_at, 0.0};
        sf_certificate *made = NULL;
        w.task.progress = watch;
        w.task.user = &w;
        sf_status status = sf_certificate_make(s.after, &s.claim, NULL, &w.task, &made, NULL);
        CHECK_EQ(status, cancel_at < 0 ? SF_OK : SF_ERR_CANCELLED);
        CHECK((made != NULL) == (cancel_at < 0));
        sf_certificate_destroy(made);
        reports = cancel_at < 0 ? w.reports : reports;
    }
    CHECK_EQ(reports, 36);
    uint8_t digest[SF_SHA256_SIZE] = {1, 2, 3};
    watcher w = {sf_task_default(), 0, 4, 0.0};
    w.task.progress = watch;
    w.task.user = &w;
    CHECK_EQ(sf_grid_sha256(s.after, &w.task, digest), SF_ERR_CANCELLED);
    CHECK(digest[0] == 1 && digest[1] == 2 && digest[2] == 3 && digest[3] == 0);
    scene_end(&s);
}

int main(void)
{
    TEST(operations_have_names);
    TEST(fingerprints_are_of_the_pictures_bits);
    TEST(it_says_what_there_is);
    TEST(false_claims_get_none);
    TEST(memory_may_run_out_anywhere);
    TEST(it_may_be_cancelled_at_any_report);
    return test_finish();
}
