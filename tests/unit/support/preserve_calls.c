// SPDX-License-Identifier: MIT
// Why: a call that fails must leave every object as it was (TRUST 84-86). Complete and preserve are
// refused memory at each of their requests and cancelled at each report, in every mode and under
// every kind of rule; wrong arguments name themselves; padding of the inputs may hold anything.

#include "failing_allocator.h"
#include "law/alive.h"

#include <sf/preserve.h>

typedef struct calls {
    sf_grid *shape, *needed, *brush, *result, *exempt, *go;
    sf_grid *was, *result_was;
    sf_terms terms;
    sf_preserve_options options;
} calls;

static void begin(calls *c, const sf_rule *rule)
{
    static stack drawn, s, part;
    alive_rule alive;
    alive_prepare(&alive, rule, 7);
    stack_random_boxes(&drawn, 12, 9, 7, 9);
    alive_trim(&alive, &drawn, NULL, stack_bed(&drawn, SF_BED_AUTO), &s);
    c->shape = stack_grid(&s);
    c->was = stack_grid(&s);
    stack_random(&part, 12, 9, 7, 0.5);
    c->brush = stack_grid(&part);
    stack_combine(&part, &s, &part, STACK_MINUS);
    c->needed = stack_grid(&part);
    stack_random(&part, 12, 9, 7, 0.2);
    c->exempt = stack_grid(&part);
    c->result = stack_grid(&part);
    c->result_was = stack_grid(&part);
    stack_clear(&part, 12, 9, 7);
    c->go = stack_grid(&part);
    c->terms = sf_terms_default();
    c->terms.rule = *rule;
    c->options = sf_preserve_options_default();
}

static void end(calls *c)
{
    sf_grid *all[8] = {c->shape,  c->needed, c->brush, c->result,
                       c->exempt, c->go,     c->was,   c->result_was};
    for (int i = 0; i < 8; i++) {
        sf_grid_destroy(all[i]);
    }
}

// Complete (mode < 0) or preserve; what they wrote is undone.
static sf_status call(calls *c, int mode, const sf_allocator *allocator, sf_task *task)
{
    if (mode < 0) {
        return sf_grid_complete(c->shape, c->needed, &c->terms, allocator, task, c->result);
    }
    sf_preserve_report report = {7, 7, 7, 7};
    c->options.mode = (sf_preserve_mode)mode;
    sf_status status =
        sf_grid_preserve(c->shape, c->brush, &c->terms, &c->options, allocator, task, &report);
    CHECK(status == SF_OK || report.kept_voxels + report.removed_voxels == 14);
    return status;
}

static int is_as_it_was(const calls *c)
{
    return sf_grid_equal(c->shape, c->was) && sf_grid_equal(c->result, c->result_was);
}

static void restore(calls *c)
{
    for (uint32_t k = 0; k < 7; k++) {
        CHECK_EQ(sf_slice_copy(sf_grid_slice(c->shape, k), sf_grid_slice(c->was, k)), SF_OK);
        CHECK_EQ(sf_slice_copy(sf_grid_slice(c->result, k), sf_grid_slice(c->result_was, k)),
                 SF_OK);
    }
}

static void refuse_memory(calls *c, int mode)
{
    failing_allocator f;
    sf_status status = SF_ERR_MEMORY;
    for (long at = 0; status != SF_OK && at < 2000; at++) {
        failing_begin(&f, at);
        status = call(c, mode, &f.allocator, NULL);
        CHECK(status == SF_OK || status == SF_ERR_MEMORY);
        CHECK_EQ(f.live, 0);
        CHECK_EQ(f.faults, 0);
        CHECK(status == SF_OK || is_as_it_was(c));
    }
    CHECK_EQ(status, SF_OK);
    restore(c);
}

typedef struct stopper {
    sf_task task;
    int left;
    double last;
} stopper;

static void on_progress(void *user, double fraction)
{
    stopper *s = user;
    CHECK(fraction >= s->last && fraction <= 1.0);
    s->last = fraction;
    if (s->left-- == 0) {
        sf_task_cancel(&s->task);
    }
}

static void cancel(calls *c, int mode)
{
    int stopped = 0;
    for (int at = -1; at < 100; at++) {
        stopper s = {sf_task_default(), at, 0.0};
        s.task.progress = on_progress;
        s.task.user = &s;
        if (at < 0) {
            sf_task_cancel(&s.task);
        }
        sf_status status = call(c, mode, NULL, &s.task);
        CHECK(status == SF_OK || status == SF_ERR_CANCELLED);
        CHECK(at >= 0 || status == SF_ERR_CANCELLED);
        CHECK(status == SF_OK || is_as_it_was(c));
        stopped += status == SF_ERR_CANCELLED;
        if (status == SF_OK) {
            CHECK_NEAR(s.last, 1.0, 0.0);
            break;
        }
    }
    CHECK(stopped >= 3);
    restore(c);
}

static void every_failure(void)
{
    for (int i = 0; i < 16; i += i % 8 == 0 ? 2 : 3) {
        calls c;
        sf_rule rule = alive_rule_by_number(i);
        begin(&c, &rule);
        for (int mode = -1; mode <= SF_PRESERVE_PAPER_SHADER; mode++) {
            refuse_memory(&c, mode);
            cancel(&c, mode);
            c.options.trim_after = !c.options.trim_after;
            c.options.accept_unsupported = mode >= 0 && mode <= SF_PRESERVE_CORE;
            c.options.must_go = c.options.accept_unsupported ? c.go : NULL;
            refuse_memory(&c, mode);
            cancel(&c, mode);
            c.options.accept_unsupported = 0;
            c.options.must_go = NULL;
        }
        end(&c);
    }
}

// ---------------------------------------------------------------------------------------------
// Arguments
// ---------------------------------------------------------------------------------------------

static void wrong_complete(void)
{
    calls c;
    sf_rule rule = sf_rule_box3();
    begin(&c, &rule);
    stack small;
    stack_clear(&small, 11, 9, 7);
    sf_grid *other = stack_grid(&small);
    sf_terms bad = c.terms;
    bad.struct_size = 1;
    sf_terms exempt = c.terms;
    exempt.exempt = c.result;
#define COMPLETE(shape, needed, terms, result)                                                     \
    sf_grid_complete(shape, needed, terms, stack_allocator(), NULL, result)
    CHECK_EQ(COMPLETE(NULL, c.needed, &c.terms, c.result), SF_ERR_ARGUMENT);
    CHECK_EQ(COMPLETE(c.shape, NULL, &c.terms, c.result), SF_ERR_ARGUMENT);
    CHECK_EQ(COMPLETE(c.shape, c.needed, NULL, c.result), SF_ERR_ARGUMENT);
    CHECK_EQ(COMPLETE(c.shape, c.needed, &c.terms, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(COMPLETE(c.shape, c.needed, &bad, c.result), SF_ERR_ARGUMENT);
    CHECK_EQ(COMPLETE(c.shape, c.needed, &exempt, c.result), SF_ERR_ARGUMENT);
    CHECK_EQ(COMPLETE(c.shape, c.needed, &c.terms, c.shape), SF_ERR_ARGUMENT);
    CHECK_EQ(COMPLETE(c.shape, c.needed, &c.terms, c.needed), SF_ERR_ARGUMENT);
    CHECK_EQ(COMPLETE(c.shape, other, &c.terms, c.result), SF_ERR_SHAPE);
    CHECK_EQ(COMPLETE(c.shape, c.needed, &c.terms, other), SF_ERR_SHAPE);
    // Not within the shape, and a shape that is not support-free.
    CHECK_EQ(COMPLETE(c.shape, c.exempt, &c.terms, c.result), SF_ERR_INFEASIBLE);
    CHECK_EQ(COMPLETE(c.exempt, c.exempt, &c.terms, c.result), SF_ERR_INFEASIBLE);
    CHECK(is_as_it_was(&c));
    // Nothing at all is support-free, and needs nothing.
    CHECK_EQ(COMPLETE(c.go, c.go, &c.terms, c.result), SF_OK);
    CHECK_EQ(sf_grid_popcount(c.result), 0);
    sf_grid_destroy(other);
    end(&c);
}

static void wrong_preserve(void)
{
    calls c;
    sf_rule rule = sf_rule_box3();
    begin(&c, &rule);
    stack small;
    stack_clear(&small, 12, 9, 6);
    sf_grid *other = stack_grid(&small);
#define PRESERVE(grid, brush, terms, options)                                                      \
    sf_grid_preserve(grid, brush, terms, options, stack_allocator(), NULL, NULL)
    CHECK_EQ(PRESERVE(NULL, c.brush, &c.terms, &c.options), SF_ERR_ARGUMENT);
    CHECK_EQ(PRESERVE(c.shape, NULL, &c.terms, &c.options), SF_ERR_ARGUMENT);
    CHECK_EQ(PRESERVE(c.shape, c.brush, NULL, &c.options), SF_ERR_ARGUMENT);
    CHECK_EQ(PRESERVE(c.shape, c.shape, &c.terms, &c.options), SF_ERR_ARGUMENT);
    CHECK_EQ(PRESERVE(c.shape, other, &c.terms, &c.options), SF_ERR_SHAPE);
    sf_preserve_options bad[7];
    for (int i = 0; i < 7; i++) {
        bad[i] = c.options;
    }
    bad[0].struct_size = 0;
    bad[1].mode = (sf_preserve_mode)5;
    bad[2].strut_width = 2;
    bad[3].strut_width = 257;
    bad[4].must_go = c.shape;
    bad[5].brush_box = (sf_box){0, 0, 0, 13, 9, 7};
    bad[6].mode = SF_PRESERVE_PAPER_TEXT;
    bad[6].must_go = c.go;
    for (int i = 0; i < 7; i++) {
        CHECK_EQ(PRESERVE(c.shape, c.brush, &c.terms, &bad[i]), SF_ERR_ARGUMENT);
    }
    bad[0] = c.options;
    bad[0].must_go = other;
    CHECK_EQ(PRESERVE(c.shape, c.brush, &c.terms, &bad[0]), SF_ERR_SHAPE);
    sf_terms terms = c.terms;
    terms.keep = c.shape;
    CHECK_EQ(PRESERVE(c.shape, c.brush, &terms, &c.options), SF_ERR_ARGUMENT);
    CHECK(is_as_it_was(&c));
    // No options are the default's; an empty brush changes nothing, nor does an empty box.
    CHECK_EQ(PRESERVE(c.shape, c.go, &c.terms, NULL), SF_OK);
    c.options.brush_box = (sf_box){3, 3, 3, 3, 9, 7};
    CHECK_EQ(PRESERVE(c.shape, c.brush, &c.terms, &c.options), SF_OK);
    CHECK(is_as_it_was(&c));
    sf_grid_destroy(other);
    end(&c);
}

// Bits past the width are ignored, wherever they stand.
static void padding(void)
{
    for (int i = 0; i < 16; i += 5) {
        calls c, d;
        sf_rule rule = alive_rule_by_number(i);
        for (int mode = -1; mode <= SF_PRESERVE_PAPER_SHADER; mode++) {
            uint64_t seed = test_state;
            begin(&c, &rule);
            test_state = seed;
            begin(&d, &rule);
            c.terms.exempt = c.exempt;
            d.terms.exempt = d.exempt;
            sf_grid *dirty[4] = {d.shape, d.needed, d.brush, d.exempt};
            for (int g = 0; g < 4; g++) {
                for (uint32_t row = 0; row < 63; row++) {
                    sf_slice s = sf_grid_slice(dirty[g], row / 9);
                    s.words[row % 9 * s.stride] |= ~UINT64_C(0) << 12;
                }
            }
            CHECK_EQ(call(&c, mode, NULL, NULL), SF_OK);
            CHECK_EQ(call(&d, mode, NULL, NULL), SF_OK);
            CHECK(sf_grid_equal(c.shape, d.shape) && sf_grid_equal(c.result, d.result));
            end(&c);
            end(&d);
        }
    }
}

int main(void)
{
    TEST(every_failure);
    TEST(wrong_complete);
    TEST(wrong_preserve);
    TEST(padding);
    return test_finish();
}
