// SPDX-License-Identifier: MIT
// Why: whatever is asked of masks, halftones, shells, curves and mixtures that cannot be had is
// refused with its status and changes nothing; when memory runs out at any request nothing is kept
// and nothing changed; a cancel is heeded, progress never falls. Voxels, volumes and grams are sums
// that can be taken by hand.

#include "failing_allocator.h"
#include "test.h"

#include <sf/halftone.h>
#include <sf/mixture.h>

static void masks_refuse(void)
{
    sf_mask *mask = NULL;
    sf_mask_options good = sf_mask_options_default(), o[16];
    for (int i = 0; i < 16; i++) {
        o[i] = good;
    }
    o[0].struct_size = 8;
    o[1].kind = (sf_mask_kind)2;
    o[2].nx = 48;
    o[3].nx = 2;
    o[4].nx = 512;
    o[5].ny = 0;
    o[6].nz = 257;
    o[7].pitch_mm[0] = 0;
    o[8].pitch_mm[1] = NAN;
    o[9].pitch_mm[2] = INFINITY;
    o[10].pitch_mm[2] = 65;
    o[11].spread = 0.4;
    o[12].spread = NAN;
    o[13].spread = 4.1;
    o[14].pitch_mm[1] = -1;
    o[15].ny = 300;
    for (int i = 0; i < 16; i++) {
        CHECK_EQ(sf_mask_create(&o[i], NULL, NULL, &mask), SF_ERR_ARGUMENT);
    }
    good.nx = good.ny = good.nz = 256;
    CHECK_EQ(sf_mask_create(&good, NULL, NULL, &mask), SF_ERR_OVERFLOW);
    CHECK_EQ(sf_mask_create(NULL, NULL, NULL, NULL), SF_ERR_ARGUMENT);
    uint32_t ranks[8] = {0, 1, 2, 3, 4, 5, 6, 7}, size[3] = {1, 1, 1};
    CHECK_EQ(sf_mask_from_ranks(4, 2, 1, NULL, NULL, &mask), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_mask_from_ranks(3, 2, 1, ranks, NULL, &mask), SF_ERR_ARGUMENT);
    ranks[3] = 8;
    CHECK_EQ(sf_mask_from_ranks(4, 2, 1, ranks, NULL, &mask), SF_ERR_FORMAT);
    ranks[3] = 7;
    CHECK_EQ(sf_mask_from_ranks(4, 2, 1, ranks, NULL, &mask), SF_ERR_FORMAT);
    CHECK(mask == NULL);
    ranks[3] = 3;
    CHECK_EQ(sf_mask_from_ranks(4, 2, 1, ranks, NULL, &mask), SF_OK);
    CHECK_EQ(sf_mask_rank(mask, 5, 3, 9), 5);
    sf_mask_size(NULL, size);
    CHECK(size[0] == 0 && sf_mask_rank(NULL, 0, 0, 0) == 0);
    sf_mask_destroy(mask);
    sf_mask_destroy(NULL);
}

enum { W = 70, H = 5 };

typedef struct input {
    double values[2 * W * H];
    sf_tone_plane planes[2];
    uint64_t words[5][2 * H];
    sf_slice slices[3];
    uint8_t ids[W * H];
    uint64_t counts[3];
    sf_keep_out keep_out;
    sf_tones tones;
    sf_materials out;
} input;

static void input_begin(input *in)
{
    memset(in, 0, sizeof *in);
    for (int i = 0; i < 2 * W * H; i++) {
        in->values[i] = 0.5;
    }
    for (int j = 0; j < 2; j++) {
        in->planes[j].values = in->values + j * W * H;
        in->planes[j].stride = W;
    }
    for (int j = 0; j < 3; j++) {
        sf_slice s = {in->words[j], W, H, 2};
        in->slices[j] = s;
    }
    sf_slice where = {in->words[3], W, H, 2}, solid = {in->words[4], W, H, 2};
    memset(in->words, 0xff, sizeof in->words);
    memset(in->ids, 0xdb, sizeof in->ids);
    in->keep_out.where = where;
    in->keep_out.instead = 1;
    in->tones.struct_size = sizeof in->tones;
    in->tones.width = W;
    in->tones.height = H;
    in->tones.type = SF_TONE_F64;
    in->tones.planes = in->planes;
    in->tones.solid = solid;
    in->tones.keep_outs = &in->keep_out;
    in->tones.keep_out_count = 1;
    in->out.slices = in->slices;
    in->out.ids = in->ids;
    in->out.ids_stride = W;
    in->out.counts = in->counts;
}

// Break input number i; returns what must be answered, or SF_STATUS_COUNT after the last.
static sf_status input_break(input *in, int i)
{
    in->tones.struct_size -= i == 0;
    in->tones.width = i == 1 ? 0 : i == 2 ? 65536 : in->tones.width;
    in->tones.height = i == 3 ? 0 : in->tones.height;
    in->tones.type = i == 4 ? (sf_tone_type)3 : in->tones.type;
    in->tones.planes = i == 5 ? NULL : in->tones.planes;
    in->planes[1].values = i == 6 ? NULL : in->planes[1].values;
    in->planes[0].stride -= i == 7;
    in->out.ids_stride -= i == 8;
    in->keep_out.material = i == 9 ? 3 : i == 10 ? 1 : 0;
    in->keep_out.instead = i == 11 ? 3 : 1;
    in->tones.keep_outs = i == 12 ? NULL : in->tones.keep_outs;
    in->values[W * H + W + 3] = i == 13 ? NAN : i == 14 ? -0.001 : i == 15 ? 0.501 : 0.5;
    in->values[W * H - 1] = i == 16 ? INFINITY : 0.5;
    in->slices[2].words = i == 17 ? in->slices[0].words : in->slices[2].words;
    in->slices[1].words = i == 18 ? in->tones.solid.words : in->slices[1].words;
    in->slices[0].words = i == 19 ? in->keep_out.where.words : in->slices[0].words;
    in->slices[0].stride -= i == 20;
    in->slices[1].width -= i == 21;
    in->tones.solid.height -= i == 22;
    in->keep_out.where.width -= i == 23;
    return i <= 20 ? SF_ERR_ARGUMENT : i <= 23 ? SF_ERR_SHAPE : SF_STATUS_COUNT;
}

static void halftones_refuse(void)
{
    const double pitch[3] = {1, 1, 1};
    sf_halftone *halftone = NULL;
    sf_diffuser *diffuser = NULL;
    CHECK_EQ(sf_halftone_create(NULL, 2, NULL, &halftone), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_halftone_create(sf_mask_builtin(), 1, NULL, &halftone), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_halftone_create(sf_mask_builtin(), 17, NULL, &halftone), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_halftone_create(sf_mask_builtin(), 3, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_halftone_create(sf_mask_builtin(), 3, NULL, &halftone), SF_OK);
    CHECK_EQ(sf_diffuser_create(W, H, 3, pitch, NULL, &diffuser), SF_OK);
    input in, before;
    for (int way = 0; way < 2; way++) {
        for (int i = 0;; i++) {
            input_begin(&in);
            sf_status want = input_break(&in, i);
            if (want == SF_STATUS_COUNT) {
                break;
            }
            memcpy(&before, &in, sizeof in);
            sf_status got = way == 0 ? sf_halftone_slice(halftone, &in.tones, &in.out, NULL)
                                     : sf_diffuser_slice(diffuser, &in.tones, &in.out);
            CHECK_EQ(got, want);
            CHECK(memcmp(&before, &in, sizeof in) == 0);
        }
    }
    // Where nothing is solid nobody looks, and whatever is there is left.
    input_begin(&in);
    in.words[4][2] = ~UINT64_C(8);
    in.values[W * H + W + 3] = NAN;
    CHECK_EQ(sf_halftone_slice(halftone, &in.tones, &in.out, NULL), SF_OK);
    CHECK_EQ(sf_diffuser_slice(diffuser, &in.tones, &in.out), SF_OK);
    CHECK_EQ(in.ids[W + 3], 0);
    CHECK_EQ(sf_halftone_slice(NULL, &in.tones, &in.out, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_halftone_slice(halftone, NULL, &in.out, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_halftone_slice(halftone, &in.tones, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_diffuser_slice(NULL, &in.tones, &in.out), SF_ERR_ARGUMENT);
    sf_task task = sf_task_default();
    sf_task_cancel(&task);
    memcpy(&before, &in, sizeof in);
    CHECK_EQ(sf_halftone_slice(halftone, &in.tones, &in.out, &task), SF_ERR_CANCELLED);
    CHECK(memcmp(&before, &in, sizeof in) == 0);
    in.tones.width--;
    CHECK_EQ(sf_diffuser_slice(diffuser, &in.tones, &in.out), SF_ERR_SHAPE);
    sf_diffusion report[3];
    CHECK_EQ(sf_diffuser_report(NULL, report), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_diffuser_report(diffuser, NULL), SF_ERR_ARGUMENT);
    sf_halftone_destroy(halftone);
    sf_diffuser_destroy(diffuser);
    sf_halftone_destroy(NULL);
    sf_diffuser_destroy(NULL);
}

static void diffusers_and_shells_refuse(void)
{
    const double good[3] = {1, 1, 1}, wide[3] = {1, 1, 65}, none[3] = {1, 0, 1};
    sf_diffuser *d = NULL;
    CHECK_EQ(sf_diffuser_create(0, 1, 2, good, NULL, &d), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_diffuser_create(1, 65536, 2, good, NULL, &d), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_diffuser_create(1, 1, 1, good, NULL, &d), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_diffuser_create(1, 1, 17, good, NULL, &d), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_diffuser_create(1, 1, 2, wide, NULL, &d), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_diffuser_create(1, 1, 2, none, NULL, &d), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_diffuser_create(1, 1, 2, NULL, NULL, &d), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_diffuser_create(1, 1, 2, good, NULL, NULL), SF_ERR_ARGUMENT);
    sf_mesh_view mesh = {NULL, 0, NULL, 0};
    sf_lattice lattice = {8, 8, 8, 1, 1, 1, NULL, {0, 0, 0}}, bad = lattice;
    sf_shell *shell = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    bad.nx = 0;
    CHECK_EQ(sf_shell_create(mesh, NULL, 1, NULL, &shell, &fault), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_shell_create(mesh, &bad, 1, NULL, &shell, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_shell_create(mesh, &lattice, -1, NULL, &shell, &fault), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_shell_create(mesh, &lattice, NAN, NULL, &shell, &fault), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_shell_create(mesh, &lattice, 256, NULL, &shell, &fault), SF_ERR_OVERFLOW);
    CHECK(fault.status == SF_ERR_OVERFLOW && fault.message[0] != '\0');
    CHECK_EQ(sf_shell_create(mesh, &lattice, 1, NULL, NULL, &fault), SF_ERR_ARGUMENT);
    CHECK(shell == NULL && d == NULL);
    CHECK_EQ(sf_shell_create(mesh, &lattice, 1, NULL, &shell, &fault), SF_OK);
    uint64_t words[8];
    sf_slice slice = {words, 8, 8, 1}, small = {words, 7, 8, 1}, nothing = {NULL, 8, 8, 1};
    CHECK_EQ(sf_shell_slice(shell, 8, slice), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_shell_slice(shell, 0, nothing), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_shell_slice(shell, 0, small), SF_ERR_SHAPE);
    CHECK_EQ(sf_shell_slice(NULL, 0, slice), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_shell_slice(shell, 7, slice), SF_OK);
    CHECK_EQ(sf_slice_popcount(slice), 0);
    sf_shell_destroy(shell);
    sf_shell_destroy(NULL);
}

static void curves_refuse(void)
{
    sf_curve_sample s[3] = {{0, 1, 1}, {0, 2, 1}, {1, 3, 1}};
    sf_curve *curve = NULL;
    double x;
    CHECK_EQ(sf_curve_create(NULL, 3, SF_TREND_AUTO, NULL, &curve), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_curve_create(s, 2, SF_TREND_AUTO, NULL, &curve), SF_ERR_ARGUMENT); // one x
    CHECK_EQ(sf_curve_create(s, 1, SF_TREND_AUTO, NULL, &curve), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_curve_create(s, 3, (sf_trend)3, NULL, &curve), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_curve_create(s, 65537, SF_TREND_AUTO, NULL, &curve), SF_ERR_OVERFLOW);
    s[1].y = NAN;
    CHECK_EQ(sf_curve_create(s, 3, SF_TREND_AUTO, NULL, &curve), SF_ERR_ARGUMENT);
    s[1].y = 2;
    s[1].weight = 0;
    CHECK_EQ(sf_curve_create(s, 3, SF_TREND_AUTO, NULL, &curve), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_curve_value(NULL, 0, &x, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_curve_inverse(NULL, 0, &x, NULL), SF_ERR_ARGUMENT);
    CHECK(curve == NULL && sf_curve_change(NULL) == 0);
    sf_curve_destroy(NULL);
}

static void mixtures_refuse(void)
{
    double f[8] = {1, 0, 0, 1, 0.5, 0.5, 0.5, 0.5}, p[4] = {1, 2, 3, 4}, scale = 0;
    sf_mixture_samples good = {2, 1, 3, f, p, NULL}, bad[7];
    sf_mixture *mixture = NULL;
    sf_fault fault;
    for (int i = 0; i < 7; i++) {
        bad[i] = good;
    }
    bad[0].material_count = 1;
    bad[1].material_count = 7;
    bad[2].property_count = 0;
    bad[3].count = 1;
    bad[4].fractions = NULL;
    bad[5].scales = &scale;
    bad[6].count = 4; // twice the same
    for (int i = 0; i < 7; i++) {
        CHECK_EQ(sf_mixture_create(&bad[i], NULL, &mixture, &fault), SF_ERR_ARGUMENT);
        CHECK(fault.message[0] != '\0');
    }
    f[1] = 0.1;
    CHECK_EQ(sf_mixture_create(&good, NULL, &mixture, &fault), SF_ERR_ARGUMENT);
    f[1] = 0;
    p[1] = INFINITY;
    CHECK_EQ(sf_mixture_create(&good, NULL, &mixture, NULL), SF_ERR_ARGUMENT);
    // Three on a line in the space of three materials.
    double flat[9] = {1, 0, 0, 0, 1, 0, 0.5, 0.5, 0}, q[3] = {1, 2, 3};
    sf_mixture_samples line = {3, 1, 3, flat, q, NULL};
    CHECK_EQ(sf_mixture_create(&line, NULL, &mixture, &fault), SF_ERR_ARGUMENT);
    static double many[256 * 6], one[256];
    sf_mixture_samples lots = {6, 1, 256, many, one, NULL};
    for (int i = 0; i < 256; i++) {
        many[6 * i] = 1;
    }
    CHECK_EQ(sf_mixture_create(&lots, NULL, &mixture, &fault), SF_ERR_OVERFLOW);
    CHECK(mixture == NULL && sf_mixture_simplex_count(NULL) == 0);
    p[1] = 2;
    CHECK_EQ(sf_mixture_create(&good, NULL, &mixture, &fault), SF_OK);
    uint32_t corners[2];
    double nan = NAN, out[2];
    CHECK_EQ(sf_mixture_simplex(mixture, 2, corners), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_mixture_simplex(mixture, 1, corners), SF_OK);
    CHECK_EQ(sf_mixture_fractions(mixture, &nan, NULL, out, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_mixture_properties(mixture, NULL, out, NULL), SF_ERR_ARGUMENT);
    sf_mixture_destroy(mixture);
    sf_mixture_destroy(NULL);
}

// ---------------------------------------------------------------------------------------------
// Memory
// ---------------------------------------------------------------------------------------------

static sf_status make_mask(const sf_allocator *a)
{
    sf_mask_options o = sf_mask_options_default();
    sf_mask *mask = NULL;
    o.nx = o.ny = o.nz = 8;
    sf_status status = sf_mask_create(&o, a, NULL, &mask);
    CHECK((status == SF_OK) == (mask != NULL));
    sf_mask_destroy(mask);
    return status;
}

static sf_status read_mask(const sf_allocator *a)
{
    uint32_t ranks[4] = {3, 0, 2, 1};
    sf_mask *mask = NULL;
    sf_status status = sf_mask_from_ranks(4, 1, 1, ranks, a, &mask);
    CHECK((status == SF_OK) == (mask != NULL));
    sf_mask_destroy(mask);
    return status;
}

static sf_status make_halftone(const sf_allocator *a)
{
    sf_halftone *halftone = NULL;
    sf_status status = sf_halftone_create(sf_mask_builtin(), 4, a, &halftone);
    CHECK((status == SF_OK) == (halftone != NULL));
    sf_halftone_destroy(halftone);
    return status;
}

static sf_status make_diffuser(const sf_allocator *a)
{
    const double pitch[3] = {1, 1, 1};
    sf_diffuser *diffuser = NULL;
    sf_status status = sf_diffuser_create(9, 9, 3, pitch, a, &diffuser);
    CHECK((status == SF_OK) == (diffuser != NULL));
    sf_diffuser_destroy(diffuser);
    return status;
}

static sf_status make_shell(const sf_allocator *a)
{
    static const double corners[9] = {1, 1, 1, 6, 2, 3, 3, 6, 5};
    static const uint32_t triangle[3] = {0, 1, 2};
    const double heights[8] = {1, 2, 1, 1, 1, 1, 1, 1};
    sf_mesh_view mesh = {corners, 3, triangle, 1};
    sf_lattice lattice = {8, 8, 8, 1, 1, 1, heights, {0, 0, 0}};
    sf_shell *shell = NULL;
    sf_status status = sf_shell_create(mesh, &lattice, 1.5, a, &shell, NULL);
    CHECK((status == SF_OK) == (shell != NULL));
    sf_shell_destroy(shell);
    return status;
}

static sf_status make_curve(const sf_allocator *a)
{
    const sf_curve_sample s[3] = {{0, 1, 1}, {2, 2, 1}, {1, 3, 1}};
    sf_curve *curve = NULL;
    sf_status status = sf_curve_create(s, 3, SF_TREND_AUTO, a, &curve);
    CHECK((status == SF_OK) == (curve != NULL));
    sf_curve_destroy(curve);
    return status;
}

static sf_status make_mixture(const sf_allocator *a)
{
    static double f[2 * 30], p[30];
    sf_mixture_samples s = {2, 1, 30, f, p, NULL};
    for (int i = 0; i < 30; i++) {
        f[2 * i] = i / 29.0;
        f[2 * i + 1] = 1 - i / 29.0;
    }
    sf_mixture *mixture = NULL;
    sf_status status = sf_mixture_create(&s, a, &mixture, NULL);
    CHECK((status == SF_OK) == (mixture != NULL));
    sf_mixture_destroy(mixture);
    return status;
}

static void memory_runs_out(void)
{
    sf_status (*const makers[])(const sf_allocator *) = {
        make_mask, read_mask, make_halftone, make_diffuser, make_shell, make_curve, make_mixture};
    for (size_t i = 0; i < sizeof makers / sizeof makers[0]; i++) {
        failing_allocator f;
        failing_begin(&f, -1);
        CHECK_EQ(makers[i](&f.allocator), SF_OK);
        CHECK(f.live == 0 && f.faults == 0);
        long requests = f.requests;
        CHECK(requests > 0);
        for (long k = 0; k < requests; k++) {
            failing_begin(&f, k);
            CHECK_EQ(makers[i](&f.allocator), SF_ERR_MEMORY);
            CHECK(f.live == 0 && f.faults == 0);
        }
    }
}

// ---------------------------------------------------------------------------------------------
// Tasks, sums
// ---------------------------------------------------------------------------------------------

typedef struct watch {
    sf_task task;
    double last, stop_at;
} watch;

static void look(void *user, double fraction)
{
    watch *w = user;
    CHECK(fraction >= w->last && fraction <= 1);
    w->last = fraction;
    if (fraction >= w->stop_at) {
        sf_task_cancel(&w->task);
    }
}

static void masks_can_be_cancelled(void)
{
    watch w = {sf_task_default(), 0, 2};
    sf_mask *mask = NULL;
    w.task.progress = look;
    w.task.user = &w;
    CHECK_EQ(sf_mask_create(NULL, NULL, &w.task, &mask), SF_OK);
    CHECK(w.last == 1);
    sf_mask_destroy(mask);
    mask = NULL;
    w.last = 0;
    w.stop_at = 0.3;
    CHECK_EQ(sf_mask_create(NULL, NULL, &w.task, &mask), SF_ERR_CANCELLED);
    CHECK(w.last >= 0.3 && w.last < 0.5);
    CHECK_EQ(sf_mask_create(NULL, NULL, &w.task, &mask), SF_ERR_CANCELLED);
    CHECK(mask == NULL);
}

static void uses_are_sums(void)
{
    const double heights[3] = {0.1, 0.3, 0.2}, density[2] = {1.2, 0.9};
    sf_lattice lattice = {10, 10, 3, 0.5, 0.4, 0.25, NULL, {0, 0, 0}};
    uint64_t counts[6] = {10, 1, 20, 0, 40, 7};
    sf_material_use uses[2];
    CHECK_EQ(sf_material_uses(&lattice, counts, 2, density, uses), SF_OK);
    CHECK(uses[0].voxels == 70 && uses[1].voxels == 8);
    CHECK_NEAR(uses[0].volume_mm3, 70 * 0.5 * 0.4 * 0.25, 1e-15);
    CHECK_NEAR(uses[0].mass_g, 70 * 0.05 * 1.2e-3, 1e-15);
    CHECK_NEAR(uses[1].mass_g, 8 * 0.05 * 0.9e-3, 1e-15);
    lattice.heights_mm = heights;
    CHECK_EQ(sf_material_uses(&lattice, counts, 2, NULL, uses), SF_OK);
    CHECK_NEAR(uses[0].volume_mm3, (10 * 0.1 + 20 * 0.3 + 40 * 0.2) * 0.2, 1e-14);
    CHECK(uses[0].mass_g == 0);
    double bad = -1;
    CHECK_EQ(sf_material_uses(NULL, counts, 2, NULL, uses), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_material_uses(&lattice, NULL, 2, NULL, uses), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_material_uses(&lattice, counts, 0, NULL, uses), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_material_uses(&lattice, counts, 1, &bad, uses), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_material_uses(&lattice, counts, 2, NULL, NULL), SF_ERR_ARGUMENT);
    counts[4] = UINT64_MAX;
    CHECK_EQ(sf_material_uses(&lattice, counts, 2, NULL, uses), SF_ERR_OVERFLOW);
}

int main(void)
{
    TEST(masks_refuse);
    TEST(halftones_refuse);
    TEST(diffusers_and_shells_refuse);
    TEST(curves_refuse);
    TEST(mixtures_refuse);
    TEST(memory_runs_out);
    TEST(masks_can_be_cancelled);
    TEST(uses_are_sums);
    return test_finish();
}
