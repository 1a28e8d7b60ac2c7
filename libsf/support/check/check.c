// SPDX-License-Identifier: MIT
// The checker: is a stack of slices support-free, told layer by layer in memory of the caller's.
//
// Of the layers pushed so far only the last one matters, as it is (S) and as trimming leaves it
// (T). The next layer's carried part C is what of S_{k+1} is alive on S_k, its kept part T_{k+1}
// what is alive on T_k; three counts and the two differences S \ C (findings) and S \ T (lost
// matter) are all that a report is made of. As long as nothing was lost T is S, and one step does
// for both.
//
// A voxel that is not carried is named once and then stands as if it had been: it goes into S, with
// no reach to spare under slack, so that what rests on it is judged by itself.
//
// Kept are S and T of the last layer, C and T of the one being pushed: four slices, and under slack
// four planes of bytes. The pushed layer itself needs no room, because it can be painted twice:
// first to be cut down to C, and again over the old S once that has served. Only where bridges are
// looked for in it, it waits in a slice of its own. Bits, runs and grey rows differ in how they
// paint only.
//
// Where there is room for a layer's runs, one that is pushed as runs and rests whole on the one
// below is not painted at all (run_front.c); the bits are, from the runs, when they are next used.
//
// A push checks everything, the rule's step included, before it paints anything; so one that fails
// can be put right and pushed again.
//
// Memory: checker, four fronts, with bridges the scratch of their steps and the waiting slice, then
// the rows and runs of finding.c, each on a 64-byte boundary.
// Freestanding: integers, no allocation, no libc but memory moves. A printer's chip can run it.
//
// Source: T. Reiner, S. Lefebvre, "Interactive Modeling of Support-free Shapes for Fabrication",
// Eurographics 2016, section 3.2 (a slice is checked against the one below).

#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"
#include "support/check/finding.h"
#include "support/check/run_front.h"
#include "support/rule/carry.h"
#include "support/rule/rule.h"
#include "voxel/slice.h"

struct sf_checker {
    uint32_t first_layer;
    const unsigned char *memory; // all of it, to see that a pushed slice lies elsewhere
    size_t memory_size;
    sfi_carrier carrier;
    sfi_front below, below_kept; // S and T of the last layer
    sfi_front carried, kept;     // C and T of the one being pushed
    sf_slice painted;            // bridges: the layer being pushed
    uint64_t below_lost;         // voxels of S \ T of the last layer
    sfi_run_front runs;          // the last layer, where it came as runs
    int is_painted;              // whether below and below_kept are the last layer
    int is_apart;           // whether T of the last layer differs from S, or in what it can spare
    sf_check_report report; // all but the findings' counts
    sfi_finder finder;
};

// ---------------------------------------------------------------------------------------------
// Placing
// ---------------------------------------------------------------------------------------------

// Cuts memory into aligned pieces; without a base it only adds up.
typedef struct carver {
    unsigned char *base;
    size_t used;
    int fits; // whether the sum has stayed within size_t
} carver;

static void *carve(carver *c, size_t count, size_t size)
{
    size_t bytes = 0, at = c->used;
    c->fits = c->fits && sfi_size_mul(count, size, &bytes) &&
              sfi_size_align(bytes, SFI_ALIGN, &bytes) && sfi_size_add(c->used, bytes, &c->used);
    return c->base != NULL && c->fits ? c->base + at : NULL;
}

static sf_slice carve_slice(carver *c, uint32_t width, uint32_t height)
{
    size_t words = 0, stride = sf_slice_stride(width);
    c->fits = c->fits && sfi_size_mul(stride, height, &words);
    sf_slice slice = {carve(c, words, sizeof(uint64_t)), width, height, stride};
    return slice;
}

static void carve_finder(carver *c, const sf_check_options *o, sfi_finder *f)
{
    // Without findings there is nobody to hand lost matter to.
    size_t runs = o->finding_capacity > 0 ? o->run_capacity : 0, regions = (o->width + 1) / 2;
    f->width = o->width;
    f->height = o->height;
    f->findings = o->findings;
    f->finding_capacity = (uint32_t)o->finding_capacity;
    f->run_capacity = (uint32_t)runs;
    f->bits = carve(c, sfi_row_words(o->width), sizeof *f->bits);
    f->regions = carve(c, regions, sizeof *f->regions);
    f->moved = carve(c, regions, sizeof *f->moved);
    f->above = carve(c, regions, sizeof *f->above);
    f->current = carve(c, regions, sizeof *f->current);
    f->owner = runs > 0 ? carve(c, o->width, sizeof *f->owner) : NULL;
    f->below.runs = carve(c, runs, sizeof *f->below.runs);
    f->here.runs = carve(c, runs, sizeof *f->here.runs);
}

static sfi_front carve_front(carver *c, const sf_check_options *o)
{
    size_t size = 0;
    c->fits = c->fits && sfi_front_size(&o->rule, o->width, o->height, &size);
    void *memory = carve(c, size, 1);
    sfi_front none = {SFI_NO_SLICE, NULL};
    return memory != NULL ? sfi_front_place(&o->rule, o->width, o->height, memory) : none;
}

static void carve_carrier(carver *c, const sf_check_options *o, sf_checker *checker)
{
    size_t size = 0;
    c->fits = c->fits && sfi_carrier_size(&o->rule, o->width, o->height, &size);
    void *memory = carve(c, size, 1);
    checker->painted = SFI_NO_SLICE;
    if (size > 0) {
        checker->painted = carve_slice(c, o->width, o->height);
    }
    if (c->base != NULL) {
        checker->carrier = sfi_carrier_place(&o->rule, o->width, o->height, memory);
    }
}

// Slack and bridges look at more than the runs of two layers.
static void carve_runs(carver *c, const sf_check_options *o, sfi_run_front *f)
{
    const sf_bridge *b = &o->rule.bridge;
    int has_more = o->rule.kind == SF_RULE_SLACK || (b->span_x | b->span_y | b->span_diagonal) != 0;
    uint32_t capacity = has_more ? 0 : o->layer_run_capacity;
    sfi_run_front made = {NULL, NULL, capacity, 0, o->height, 0};
    made.runs = carve(c, capacity, sizeof *made.runs);
    made.rows = carve(c, capacity > 0 ? (size_t)o->height + 1 : 0, sizeof *made.rows);
    *f = made;
}

static void carve_checker(carver *c, const sf_check_options *o, sf_checker *checker)
{
    (void)carve(c, 1, sizeof *checker);
    checker->below = carve_front(c, o);
    checker->below_kept = carve_front(c, o);
    checker->carried = carve_front(c, o);
    checker->kept = carve_front(c, o);
    carve_carrier(c, o, checker);
    carve_finder(c, o, &checker->finder);
    carve_runs(c, o, &checker->runs);
}

static sf_status check_options(const sf_check_options *o)
{
    if (o == NULL || o->struct_size < sizeof *o || o->width == 0 || o->height == 0 ||
        o->width > SF_EXTENT_MAX || o->height > SF_EXTENT_MAX || o->first_layer >= SF_LAYER_MAX ||
        (o->finding_capacity > 0 && o->findings == NULL) ||
        (o->bed_layer != SF_BED_AUTO &&
         (o->bed_layer < o->first_layer || o->bed_layer >= SF_LAYER_MAX))) {
        return SF_ERR_ARGUMENT;
    }
    if (o->finding_capacity > SFI_FINDING_MAX || o->run_capacity > SFI_FINDING_MAX ||
        o->layer_run_capacity > SFI_FINDING_MAX) {
        return SF_ERR_OVERFLOW;
    }
    return sfi_rule_check(&o->rule, o->first_layer, 1);
}

sf_check_options sf_check_options_default(void)
{
    sf_check_options o = {sizeof o, sf_rule_box3(), 0, 0, 0, SF_BED_AUTO, 0, NULL, 0, 0};
    return o;
}

sf_status sf_checker_size(const sf_check_options *options, size_t *size)
{
    SF_TRY(check_options(options));
    if (size == NULL) {
        return SF_ERR_ARGUMENT;
    }
    carver c = {NULL, 0, 1};
    sf_checker unplaced;
    carve_checker(&c, options, &unplaced);
    if (!c.fits) {
        return SF_ERR_OVERFLOW;
    }
    *size = c.used;
    return SF_OK;
}

sf_status sf_checker_place(const sf_check_options *options, void *memory, size_t memory_size,
                           sf_checker **checker)
{
    size_t size;
    SF_TRY(sf_checker_size(options, &size));
    if (memory == NULL || checker == NULL || (uintptr_t)memory % SFI_ALIGN != 0) {
        return SF_ERR_ARGUMENT;
    }
    if (memory_size < size) {
        return SF_ERR_CAPACITY;
    }
    carver c = {memory, 0, 1};
    sf_checker fresh = {.first_layer = options->first_layer, .memory = memory, .memory_size = size};
    fresh.report.bed_layer = options->bed_layer;
    carve_checker(&c, options, &fresh);
    fresh.is_painted = 1;
    *checker = memory;
    **checker = fresh;
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Layers as bits, runs and grey rows
// ---------------------------------------------------------------------------------------------

// A layer as the caller has it: bits where words are given, else runs, else grey rows.
typedef struct source {
    sf_slice bits;
    const sf_run *runs;
    size_t run_count;
    const uint8_t *pixels;
    size_t row_bytes;
    uint8_t threshold;
} source;

static void paint_grey(const source *s, sf_slice dst)
{
    for (uint32_t y = 0; y < dst.height; y++) {
        const uint8_t *pixels = s->pixels + y * s->row_bytes;
        uint64_t *row = sfi_slice_row(dst, y);
        for (uint32_t x = 0; x < dst.width; x += 64) {
            uint32_t end = dst.width - x < 64 ? dst.width - x : 64;
            uint64_t word = 0;
            for (uint32_t i = 0; i < end; i++) {
                word |= (uint64_t)(pixels[x + i] >= s->threshold) << i;
            }
            row[x / 64] = word;
        }
    }
}

// dst = the layer. What could be refused has been, so this cannot fail; nor can what follows.
static sf_status paint(const source *s, sf_slice dst)
{
    if (s->bits.words != NULL) {
        return sf_slice_copy(dst, s->bits);
    }
    if (s->pixels != NULL) {
        paint_grey(s, dst);
        return SF_OK;
    }
    sfi_slice_clear(dst);
    for (size_t i = 0; i < s->run_count; i++) {
        sf_rect rect = {s->runs[i].x0, s->runs[i].y, s->runs[i].x1, s->runs[i].y + 1};
        SF_TRY(sf_slice_fill(dst, rect, 1));
    }
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Pushing
// ---------------------------------------------------------------------------------------------

// Whether what T of the last layer has to spare differs from what S has.
static int has_other_slack(const sf_checker *c)
{
    size_t codes = sfi_slack_stride(c->below.alive.width) * c->below.alive.height;
    for (size_t i = 0; c->below.slack != NULL && i < codes; i++) {
        if (c->below.slack[i] != c->below_kept.slack[i]) {
            return 1;
        }
    }
    return 0;
}

// The step from layer k - 1 to layer k: C and T. solid may be the slice `carried`.
static sf_status carry(sf_checker *c, uint32_t k, uint32_t bed, sf_slice solid)
{
    if (k < bed) {
        sf_slice nothing = c->kept.alive;
        sfi_slice_clear(nothing);
        SF_TRY(sfi_carry_bed(&c->carrier, nothing, c->kept));
    } else if (c->is_apart) {
        SF_TRY(
            sfi_carry(&c->carrier, k, &c->below_kept, solid, SFI_NO_SLICE, c->kept, SFI_NO_SLICE));
    }
    return sfi_carry(&c->carrier, k, &c->below, solid, SFI_NO_SLICE, c->carried, SFI_NO_SLICE);
}

// The first layer, where it does not rest on the bed: nothing carries it.
static sf_status hang(sf_checker *c)
{
    sfi_slice_clear(c->carried.alive);
    sfi_slice_clear(c->kept.alive);
    SF_TRY(sfi_carry_bed(&c->carrier, c->carried.alive, c->carried));
    return sfi_carry_bed(&c->carrier, c->kept.alive, c->kept);
}

// T = C, as long as they are not apart.
static sf_status keep_carried(sf_checker *c)
{
    SF_TRY(sf_slice_copy(c->kept.alive, c->carried.alive));
    size_t codes = sfi_slack_stride(c->kept.alive.width) * c->kept.alive.height;
    for (size_t i = 0; c->kept.slack != NULL && i < codes; i++) {
        c->kept.slack[i] = c->carried.slack[i];
    }
    return SF_OK;
}

// Layer k has been compared: count it and name what is wrong with it.
static void take_in(sf_checker *c, uint32_t k, const sf_element *element)
{
    sf_slice below = c->below.alive;
    uint64_t solid = sf_slice_popcount(below), carried = sf_slice_popcount(c->carried.alive);
    uint64_t kept = sf_slice_popcount(c->kept.alive);
    sfi_layer layer = {k, below, c->carried.alive, c->kept.alive, element};
    if (carried > kept) {
        sfi_lost_follow(&c->finder, &layer);
    }
    if (solid > carried) {
        sfi_finder_name(&c->finder, &layer);
    }
    sfi_finder_advance(&c->finder);
    c->below_lost = solid - kept;
    c->report.solid_voxels += solid;
    c->report.unsupported_voxels += solid - carried;
    c->report.trimmed_voxels += solid - kept;
    c->report.layer_count++;
    sfi_front swap = c->below_kept;
    c->below_kept = c->kept;
    c->kept = swap;
}

// The new S, over the old one: the layer as it is, with the slack of what is carried.
static sf_status go_on_with(sf_checker *c, const source *s)
{
    if (c->below.slack != NULL) {
        uint8_t *swap = c->below.slack;
        c->below.slack = c->carried.slack;
        c->carried.slack = swap;
    }
    SF_TRY(paint(s, c->below.alive));
    return sfi_carry_anyway(&c->carrier, c->below.alive, c->below);
}

// The last layer, which stands in its runs only, as bits.
static sf_status paint_below(sf_checker *c)
{
    source s = {{NULL, 0, 0, 0}, c->runs.runs, c->runs.count, NULL, 0, 0};
    c->is_painted = 1;
    SF_TRY(paint(&s, c->below.alive));
    return sf_slice_copy(c->below_kept.alive, c->below.alive);
}

// Whether a layer is known to lose nothing, by runs alone; then it is taken in, unpainted.
static int rests(sf_checker *c, const source *s, uint32_t k, const sf_element *element)
{
    uint32_t bed = c->report.bed_layer;
    int has_runs = s->bits.words == NULL && s->pixels == NULL && c->runs.capacity > 0;
    if (!has_runs || s->run_count > c->runs.capacity || c->is_apart) {
        return 0;
    }
    if (bed == SF_BED_AUTO) {
        c->report.bed_layer = s->run_count > 0 ? k : SF_BED_AUTO;
    } else if (k < bed ||
               (k > bed && !(c->runs.is_valid &&
                             sfi_run_front_carries(&c->runs, s->runs, s->run_count, element)))) {
        return 0;
    }
    for (size_t i = 0; i < s->run_count; i++) {
        c->report.solid_voxels += s->runs[i].x1 - s->runs[i].x0;
    }
    c->report.layer_count++;
    c->is_painted = 0;
    sfi_run_front_take(&c->runs, s->runs, s->run_count);
    return 1;
}

static sf_status push(sf_checker *c, const source *s)
{
    uint32_t k = c->first_layer + c->report.layer_count;
    sf_element element = {0, {0}};
    if (k >= SF_LAYER_MAX) {
        return SF_ERR_OVERFLOW;
    }
    if (c->report.layer_count > 0) {
        SF_TRY(sf_rule_element(&c->carrier.rule, k - 1, &element));
    }
    if (rests(c, s, k, &element)) {
        return SF_OK;
    }
    if (!c->is_painted) {
        SF_TRY(paint_below(c));
    }
    sf_slice solid = s->bits;
    if (solid.words == NULL) {
        solid = c->painted.words != NULL ? c->painted : c->carried.alive;
        SF_TRY(paint(s, solid));
    }
    uint32_t bed = c->report.bed_layer;
    if (bed == SF_BED_AUTO && sf_slice_bounds(solid).x1 > 0) {
        bed = k;
    }
    if (k == bed) {
        SF_TRY(sfi_carry_bed(&c->carrier, solid, c->carried));
        SF_TRY(keep_carried(c));
    } else if (c->report.layer_count == 0) {
        SF_TRY(hang(c));
    } else {
        SF_TRY(carry(c, k, bed, solid));
        if (k > bed && !c->is_apart) {
            SF_TRY(keep_carried(c));
        }
    }
    SF_TRY(go_on_with(c, s));
    c->report.bed_layer = bed;
    take_in(c, k, &element);
    // Under slack a loss below can still tell where in this layer nothing was lost.
    c->is_apart = c->below_lost > 0 || (c->is_apart && has_other_slack(c));
    c->runs.is_valid = 0;
    if (s->bits.words == NULL && s->pixels == NULL) {
        sfi_run_front_take(&c->runs, s->runs, s->run_count);
    }
    return SF_OK;
}

sf_status sf_checker_push(sf_checker *checker, sf_slice layer)
{
    if (checker == NULL) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(sfi_slice_validate_pair(layer, checker->below.alive));
    uintptr_t first = (uintptr_t)checker->memory, end = first + checker->memory_size;
    uintptr_t from = (uintptr_t)layer.words;
    uintptr_t to = (uintptr_t)(sfi_slice_row(layer, layer.height - 1) + sfi_row_words(layer.width));
    if (from < end && first < to) {
        return SF_ERR_ARGUMENT;
    }
    source s = {layer, NULL, 0, NULL, 0, 0};
    return push(checker, &s);
}

// Whether runs lie within a slice, in row order, none across another.
static int are_in_order(const sf_run *runs, size_t count, sf_slice slice)
{
    for (size_t i = 0; i < count; i++) {
        const sf_run *r = &runs[i];
        if (r->x0 >= r->x1 || r->x1 > slice.width || r->y >= slice.height) {
            return 0;
        }
        if (i > 0 && (r->y < r[-1].y || (r->y == r[-1].y && r->x0 < r[-1].x1))) {
            return 0;
        }
    }
    return 1;
}

sf_status sf_checker_push_runs(sf_checker *checker, const sf_run *runs, size_t count)
{
    if (checker == NULL || (runs == NULL && count > 0) ||
        !are_in_order(runs, count, checker->below.alive)) {
        return SF_ERR_ARGUMENT;
    }
    source s = {{NULL, 0, 0, 0}, runs, count, NULL, 0, 0};
    return push(checker, &s);
}

sf_status sf_checker_push_grey(sf_checker *checker, const uint8_t *pixels, size_t row_bytes,
                               uint8_t threshold)
{
    if (checker == NULL || pixels == NULL || row_bytes < checker->below.alive.width ||
        row_bytes > SIZE_MAX / checker->below.alive.height) {
        return SF_ERR_ARGUMENT;
    }
    source s = {{NULL, 0, 0, 0}, NULL, 0, pixels, row_bytes, threshold};
    return push(checker, &s);
}

void sfi_checker_extent(const sf_checker *checker, uint32_t *width, uint32_t *height)
{
    *width = checker->below.alive.width;
    *height = checker->below.alive.height;
}

sf_status sf_checker_report(const sf_checker *checker, sf_check_report *report,
                            size_t *finding_count)
{
    if (checker == NULL || report == NULL) {
        return SF_ERR_ARGUMENT;
    }
    const sfi_finder *finder = &checker->finder;
    *report = checker->report;
    report->island_count = finder->island_count;
    report->overhang_count = finder->overhang_count;
    report->findings_dropped = finder->findings_dropped;
    report->runs_dropped = finder->runs_dropped;
    report->unlinked_voxels = finder->unlinked_voxels;
    report->support_free = report->unsupported_voxels == 0;
    if (finding_count != NULL) {
        *finding_count = finder->finding_count;
    }
    return SF_OK;
}
