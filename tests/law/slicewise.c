// SPDX-License-Identifier: MIT
// TRUST items 24, 25, 26, 27, 28: what may be done to every slice of a support-free shape. Dilation
// keeps it support-free; erosion, opening, closing, cropping, complement and difference do not, and
// each false law stands here with its counter-example so that nobody smooths, hollows or cuts a
// shape slice by slice and calls it printable.

#include "tiny.h"

// Over all stacks: 24, and 26 as far as it is true.
static void dilation(int nx, int ny, int nz, const sf_rule *rule, const sf_element *e)
{
    tiny t = tiny_new(nx, ny, nz, rule);
    uint32_t *grown = tiny_morph(nx, ny, e, SF_BORDER_EMPTY, TINY_DILATE);
    for (uint32_t a = 0; a < t.count; a++) {
        uint32_t dilated = tiny_each_layer(&t, grown, a);
        if (tiny_is_free(&t, a)) {
            CHECK(tiny_is_free(&t, dilated));
            CHECK_EQ(t.trim[dilated], dilated);
        }
        CHECK((tiny_each_layer(&t, grown, t.trim[a]) & ~t.trim[dilated]) == 0);
    }
    free(grown);
    tiny_delete(&t);
}

static void dilation_keeps_support_free(void)
{
    sf_rule rules[] = {sf_rule_box3(), rule_of_radius(1), rule_of_radius(0)};
    sf_element elements[] = {sf_element_box3(), sf_element_plus3(), element_along_x(1),
                             element_along_x(2)};
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 4; j++) {
            dilation(4, 2, 2, &rules[i], &elements[j]);
            dilation(4, 1, 4, &rules[i], &elements[j]);
        }
    }
    dilation(3, 3, 2, &rules[0], &elements[1]);
    dilation(3, 3, 2, &rules[1], &elements[0]);
}

// A window of three columns and two layers, with steps and elements of one column.
typedef struct window {
    tiny t;
    uint32_t *grown, *shrunk;
} window;

static window window_new(void)
{
    sf_rule rule = sf_rule_box3();
    sf_element e = element_along_x(1);
    window w = {tiny_new(3, 1, 2, &rule), tiny_morph(3, 1, &e, SF_BORDER_EMPTY, TINY_DILATE),
                tiny_morph(3, 1, &e, SF_BORDER_EMPTY, TINY_ERODE)};
    return w;
}

static void window_delete(window *w)
{
    free(w->grown);
    free(w->shrunk);
    tiny_delete(&w->t);
}

static void false_erosion_opening_closing(void)
{
    window w = window_new();
    // 25, erosion: the thin lower slice goes, the wide upper one stays.
    uint32_t a = tiny_parse(".#.|###"), eroded = tiny_each_layer(&w.t, w.shrunk, a);
    CHECK(tiny_is_free(&w.t, a));
    CHECK_EQ(eroded, tiny_parse("...|.#."));
    CHECK(!tiny_is_free(&w.t, eroded));
    // 25, opening: the same shape.
    uint32_t opened = tiny_each_layer(&w.t, w.grown, eroded);
    CHECK_EQ(opened, tiny_parse("...|###"));
    CHECK(!tiny_is_free(&w.t, opened));
    // 25, closing with nothing outside: matter at the rim of the window goes.
    uint32_t c = tiny_parse("#..|.#.");
    uint32_t closed = tiny_each_layer(&w.t, w.shrunk, tiny_each_layer(&w.t, w.grown, c));
    CHECK(tiny_is_free(&w.t, c));
    CHECK_EQ(closed, tiny_parse("...|.#."));
    CHECK(!tiny_is_free(&w.t, closed));
    window_delete(&w);
}

// 26: trim(dilate A) = dilate(trim A). Dilation brings a support near to what floats.
static void false_trim_commutes_with_dilation(void)
{
    window w = window_new();
    uint32_t a = tiny_parse("#..|..#");
    CHECK_EQ(w.t.trim[tiny_each_layer(&w.t, w.grown, a)], tiny_parse("##.|.##"));
    CHECK_EQ(tiny_each_layer(&w.t, w.grown, w.t.trim[a]), tiny_parse("##.|..."));
    window_delete(&w);
}

static void false_cropping_complement_difference(void)
{
    window w = window_new();
    // 27: the same columns of every layer.
    uint32_t a = tiny_parse(".#.|#.."), mask = tiny_parse("#..|#..");
    CHECK(tiny_is_free(&w.t, a) && !tiny_is_free(&w.t, a & mask));
    // 28: complement, and the difference of two support-free shapes.
    uint32_t b = tiny_parse("###|..."), foot = tiny_parse("#..|...");
    CHECK(tiny_is_free(&w.t, b) && !tiny_is_free(&w.t, ~b & (w.t.count - 1)));
    CHECK(tiny_is_free(&w.t, mask) && tiny_is_free(&w.t, foot));
    CHECK(!tiny_is_free(&w.t, mask & ~foot));
    window_delete(&w);
}

int main(void)
{
    TEST(dilation_keeps_support_free);
    TEST(false_erosion_opening_closing);
    TEST(false_trim_commutes_with_dilation);
    TEST(false_cropping_complement_difference);
    return test_finish();
}
