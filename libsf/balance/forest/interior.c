// SPDX-License-Identifier: MIT
// Interior: which voxels of a solid need what, and where struts may be.
//
// With S the solid, F what must stay, N(v) the voxels below that may carry v under the plain rule,
// which is an element for each step (sfi_rule_plain()):
//
//     E       of S, what the terms exempt, and what S does not carry itself: a check of S counts
//     it,
//             and it may hang on as it did
//     held    E, all of S that is on the bed or below it, what of F is carried by F under the full
//             rule (judged layer by layer, as a check does: what is not carried counts as carried
//             for the layers above), and what of S \ F has a voxel of F in N
//     asked   F without `held`: the ceilings. Each needs a voxel of N that is added
//     rooted  squares of the struts' width that lie in `held` and F: they need nothing more
//     places  squares in S, but not within F, that are rooted or have a place in N below them
//
// Claim: let R be F and squares of places, such that each square is rooted or has a place of R in
// N, and each asked voxel has a voxel of R in N. Then all of R but E is supported under the full
// rule, with the bed and E as they are. Upwards, layer by layer: a voxel of F that F carries has in
// R at least what it has in that judgement, because the rule is monotone and asked voxels, which
// count there as carried with no reach to spare, are carried in R; every other voxel has one in N
// that is alive, and steps of the plain rule use up no reach.
//
// The step from a square to the one below keeps the offset in the square, so that each of its
// voxels has its supporter; landing on a voxel of F alone would leave the others of the square
// hanging, which is why `rooted` asks it of all of them. That is more than the squares that lie in
// F: a wall thinner than a strut can be landed on too.
//
// Steps that use up no reach lean by less than a voxel under slack where layers are thin or the
// angle is small. Squares could then only stand on themselves, all the way down. So there the
// ceilings are carried by single voxels of `complete`, which knows how to save up reach, and
// squares only balance.
//
// Thin voxels: where no square fits under a ceiling, `complete` finds single voxels in S that carry
// it, given all squares that may be; these join F, and all is looked at again. One look more is
// enough for a rule that is an element, for then everything that complete relied on is in N of what
// it carries. Under slack and with bridges it may rely on reach that the squares that stay do not
// have; what then is left is marked, and the whole result completed in the end.

#include "balance/forest/interior.h"

#include "balance/forest/question.h"
#include "base/memory.h"
#include "base/status.h"
#include "support/preserve/complete.h"
#include "support/rule/carry.h"
#include "voxel/grid.h"
#include "voxel/slice.h"
#include "voxel/square.h"

// Looks after which what is still asked in vain is left to the end.
#define LOOKS_MOST 6

sf_terms sfi_interior_terms(const sfi_interior *in)
{
    sf_terms terms = sf_terms_default();
    terms.rule = in->full;
    terms.bed_layer = in->bed < in->lattice.nz ? in->bed : SF_BED_AUTO; // auto: there is no matter
    terms.exempt = in->exempt;
    return terms;
}

// ---------------------------------------------------------------------------------------------
// What is held, and where squares may be
// ---------------------------------------------------------------------------------------------

// E: what the terms exempt of the solid, and what it does not carry itself.
static sf_status find_exempt(sfi_interior *in, const sf_terms *terms)
{
    sf_terms own = sfi_interior_terms(in);
    own.exempt = terms->exempt;
    if (sf_task_is_cancelled(in->task)) {
        return SF_ERR_CANCELLED;
    }
    SF_TRY(sf_grid_unsupported(in->solid, &own, &in->allocator, NULL, in->exempt, NULL));
    for (uint32_t k = 0; terms->exempt != NULL && k < in->lattice.nz; k++) {
        sf_slice out = sf_grid_slice(in->exempt, k);
        SF_TRY(sf_slice_or(out, out, sf_grid_slice(terms->exempt, k)));
        SF_TRY(sf_slice_and(out, out, sf_grid_slice(in->solid, k)));
    }
    return SF_OK;
}

// From what of the wall hangs by itself, which is in `held` before.
static sf_status find_held(const sfi_interior *in, uint32_t k, sf_slice scratch)
{
    sf_slice held = sf_grid_slice(in->held, k), solid = sf_grid_slice(in->solid, k);
    if (k <= in->bed) {
        return sf_slice_copy(held, solid);
    }
    sf_element element;
    SF_TRY(sf_rule_element(&in->plain, k - 1, &element));
    SF_TRY(sf_slice_subtract(held, sf_grid_slice(in->wall, k), held));
    SF_TRY(sf_slice_subtract(scratch, solid, sf_grid_slice(in->wall, k)));
    SF_TRY(sf_slice_and_dilate(scratch, scratch, sf_grid_slice(in->wall, k - 1), &element));
    SF_TRY(sf_slice_or(held, held, scratch));
    return sf_slice_or(held, held, sf_grid_slice(in->exempt, k));
}

static sf_status find_places(const sfi_interior *in, uint32_t k, sf_slice scratch)
{
    sf_slice places = sf_grid_slice(in->places, k), rooted = sf_grid_slice(in->rooted, k);
    SF_TRY(sf_slice_or(rooted, sf_grid_slice(in->held, k), sf_grid_slice(in->wall, k)));
    sfi_square_corners(rooted, in->width);
    SF_TRY(sf_slice_copy(places, sf_grid_slice(in->solid, k)));
    sfi_square_corners(places, in->width);
    if (k > in->bed) {
        sf_element element;
        SF_TRY(sf_rule_element(&in->plain, k - 1, &element));
        SF_TRY(sf_slice_and_dilate(places, places, sf_grid_slice(in->places, k - 1), &element));
        SF_TRY(sf_slice_or(places, places, rooted));
    }
    SF_TRY(sf_slice_copy(scratch, sf_grid_slice(in->wall, k)));
    sfi_square_corners(scratch, in->width);
    SF_TRY(sf_slice_subtract(places, places, scratch));
    return sf_slice_and(rooted, rooted, places);
}

// open = asked voxels of layer k that no square of a place carries; scratch is all squares below.
static sf_status find_open(const sfi_interior *in, uint32_t k, sf_slice scratch, sf_slice open)
{
    SF_TRY(sf_slice_subtract(open, sf_grid_slice(in->wall, k), sf_grid_slice(in->held, k)));
    if (!sfi_slice_any(open)) {
        return SF_OK;
    }
    sf_element element;
    SF_TRY(sf_rule_element(&in->plain, k - 1, &element));
    SF_TRY(sf_slice_copy(scratch, sf_grid_slice(in->places, k - 1)));
    sfi_square_fill(scratch, in->width);
    sf_slice carried = sf_grid_slice(in->rooted, k); // not needed yet
    SF_TRY(sf_slice_and_dilate(carried, open, scratch, &element));
    return sf_slice_subtract(open, open, carried);
}

// One look from the bed up; is_open tells whether something is asked in vain. Where `forgive` is
// set that counts as held.
static sf_status look(sfi_interior *in, sf_slice scratch, sf_slice open, int forgive)
{
    sf_terms terms = sfi_interior_terms(in);
    if (sf_task_is_cancelled(in->task)) {
        return SF_ERR_CANCELLED;
    }
    SF_TRY(sf_grid_unsupported(in->wall, &terms, &in->allocator, NULL, in->held, NULL));
    in->is_open = 0;
    in->asked_voxels = 0;
    for (uint32_t k = 0; k < in->lattice.nz; k++) {
        SF_TRY(find_held(in, k, scratch));
        if (k > in->bed) {
            sf_slice held = sf_grid_slice(in->held, k);
            SF_TRY(find_open(in, k, scratch, open));
            in->is_open |= sfi_slice_any(open);
            if (forgive) {
                SF_TRY(sf_slice_or(held, held, open));
            }
            SF_TRY(sf_slice_subtract(open, sf_grid_slice(in->wall, k), held));
            in->asked_voxels += sf_slice_popcount(open);
        }
        SF_TRY(find_places(in, k, scratch));
    }
    return SF_OK;
}

// needed = the wall, and all squares that may be added.
static sf_status find_needed(const sfi_interior *in, sf_grid *needed)
{
    for (uint32_t k = 0; k < in->lattice.nz; k++) {
        sf_slice slice = sf_grid_slice(needed, k);
        SF_TRY(sf_slice_copy(slice, sf_grid_slice(in->places, k)));
        sfi_square_fill(slice, in->width);
        SF_TRY(sf_slice_or(slice, slice, sf_grid_slice(in->wall, k)));
    }
    return SF_OK;
}

// What complete adds to what is needed joins the wall.
static sf_status add_thin(sfi_interior *in)
{
    sf_grid *needed = NULL, *whole = NULL;
    sf_terms terms = sfi_interior_terms(in);
    sf_status status = sf_grid_create(&in->lattice, &in->allocator, &needed);
    if (status == SF_OK) {
        status = sf_grid_create(&in->lattice, &in->allocator, &whole);
    }
    if (status == SF_OK) {
        status = find_needed(in, needed);
    }
    if (status == SF_OK) {
        sfi_completion completion = {in->solid, needed, &terms, in->bed, 0};
        status = sfi_complete_into(whole, &completion, &in->allocator, NULL);
    }
    for (uint32_t k = 0; status == SF_OK && k < in->lattice.nz; k++) {
        sf_slice thin = sf_grid_slice(whole, k), wall = sf_grid_slice(in->wall, k);
        status = sf_slice_subtract(thin, thin, sf_grid_slice(needed, k));
        in->thin_voxels += sf_slice_popcount(thin);
        if (status == SF_OK) {
            status = sf_slice_or(wall, wall, thin);
        }
    }
    sf_grid_destroy(needed);
    sf_grid_destroy(whole);
    return status;
}

static sf_status look_all(sfi_interior *in)
{
    sf_slice slices[2];
    size_t stride = sf_slice_stride(in->lattice.nx), row = stride * sizeof(uint64_t);
    size_t height = in->lattice.ny;
    uint64_t *words = sfi_alloc_array(&in->allocator, 2 * height, row);
    sf_status status = words != NULL ? SF_OK : SF_ERR_MEMORY;
    for (int i = 0; i < 2; i++) {
        slices[i] =
            (sf_slice){words + (size_t)i * height * stride, in->lattice.nx, in->lattice.ny, stride};
    }
    for (int i = 1; status == SF_OK; i++) {
        int is_last = i >= LOOKS_MOST;
        status = look(in, slices[0], slices[1], is_last);
        if (status != SF_OK || !in->is_open || is_last) {
            break;
        }
        uint64_t before = in->thin_voxels;
        status = add_thin(in);
        i = in->thin_voxels == before ? LOOKS_MOST : i;
    }
    sfi_free_array(&in->allocator, words, 2 * height, row);
    return status;
}

// ---------------------------------------------------------------------------------------------
// Whole
// ---------------------------------------------------------------------------------------------

static sf_status find_reach(sfi_interior *in)
{
    for (uint32_t k = 0; k + 1 < in->lattice.nz; k++) {
        sf_element e;
        SF_TRY(sf_rule_element(&in->plain, k, &e));
        in->reach_x = in->reach_x > e.half_width[0] ? in->reach_x : e.half_width[0];
        in->reach_y = in->reach_y > e.reach_y ? in->reach_y : e.reach_y;
    }
    return SF_OK;
}

static sf_status create(sfi_interior *in, const sf_grid *wall, const sf_terms *terms)
{
    sf_grid **grids[6] = {&in->given, &in->exempt, &in->wall, &in->held, &in->places, &in->rooted};
    for (int i = 0; i < 6; i++) {
        SF_TRY(sf_grid_create(&in->lattice, &in->allocator, grids[i]));
    }
    SF_TRY(find_reach(in));
    SF_TRY(sfi_question_given(in->solid, wall, terms, in->given));
    SF_TRY(sfi_grid_copy(in->wall, in->given));
    SF_TRY(find_exempt(in, terms));
    if (in->full.kind == SF_RULE_SLACK && (in->reach_x == 0 || in->reach_y == 0)) {
        SF_TRY(add_thin(in)); // there are no places yet, so all of it
    }
    return look_all(in);
}

sf_status sfi_interior_create(const sf_grid *solid, const sf_grid *wall, const sf_terms *terms,
                              uint32_t bed, uint32_t strut_width, const sf_allocator *allocator,
                              sf_task *task, sfi_interior *in)
{
    *in = (sfi_interior){.lattice = sf_grid_lattice(solid),
                         .bed = bed,
                         .width = strut_width,
                         .full = terms->rule,
                         .allocator = sfi_allocator_or_default(allocator),
                         .task = task,
                         .solid = solid};
    in->plain = sfi_rule_plain(&terms->rule, in->lattice.nz);
    sf_status status = create(in, wall, terms);
    if (status != SF_OK) {
        sfi_interior_destroy(in);
    }
    return status;
}

void sfi_interior_destroy(sfi_interior *in)
{
    sf_grid_destroy(in->given);
    sf_grid_destroy(in->exempt);
    sf_grid_destroy(in->wall);
    sf_grid_destroy(in->held);
    sf_grid_destroy(in->places);
    sf_grid_destroy(in->rooted);
    in->given = in->exempt = in->wall = in->held = in->places = in->rooted = NULL;
}

sf_status sfi_interior_thicken(sfi_interior *in, const sf_grid *more)
{
    for (uint32_t k = 0; k < in->lattice.nz; k++) {
        sf_slice wall = sf_grid_slice(in->wall, k);
        in->thin_voxels -= sf_slice_popcount(wall);
        SF_TRY(sf_slice_or(wall, wall, sf_grid_slice(more, k)));
        SF_TRY(sf_slice_and(wall, wall, sf_grid_slice(in->solid, k)));
        in->thin_voxels += sf_slice_popcount(wall);
    }
    return look_all(in);
}
