// SPDX-License-Identifier: MIT
// The scenes that brushes made come out of the graphics card as they come out of the library, bit
// for bit, looked at after every stroke.

#include "sculpted.h"
#include "twin.h"

static void scene(const char *name)
{
    sf_session *session = NULL;
    CHECK(sculpted_session(name, 96, NULL, &session) == SF_OK);
    sf_session_options space = sf_session_options_of(session);
    sf_sculpt_options options = twin_options(96, 96, 96);
    options.lattice = space.lattice;
    twin t = twin_new(&options);
    for (size_t i = 0; i < sf_session_count(session).steps && test_case_failures == 0; i++) {
        sf_brush brush;
        const sf_dab *dabs;
        size_t count;
        CHECK(sf_session_stroke(session, i, &brush, &dabs, &count));
        CHECK(sf_session_play(session, i, NULL, t.cpu, NULL) == SF_OK);
        CHECK(gpu_sculpt_stroke(t.gpu, &brush, dabs, count) == SF_OK);
        CHECK_EQ(twin_differs(&t), 0);
    }
    twin_free(&t);
    sf_session_destroy(session);
}

static void shaun(void)
{
    scene("shaun");
}

static void pumpkin(void)
{
    scene("pumpkin");
}

static void intertwined(void)
{
    scene("intertwined");
}

int main(void)
{
    gl_headless *context = NULL;
    if (!gl_begin(&context)) {
        return gl_status;
    }
    TEST(shaun);
    TEST(pumpkin);
    TEST(intertwined);
    gl_headless_destroy(context);
    return test_finish();
}
