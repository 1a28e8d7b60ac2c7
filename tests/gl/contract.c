// SPDX-License-Identifier: MIT
// What gpu_sculpt.h says beside the brushes: which options are refused, and that a sentence says
// why; which calls are; what a view finds in the buffers, read here straight from them; whole
// models put in place; and that the host's picture of the ledger is the shaders' (a list that
// exists twice).

#include <epoxy/gl.h>
#include <stddef.h>

#include "gl/program.h"
#include "gpu/ledger.h"
#include "random_strokes.h"
#include "twin.h"

static void check_refusal(const sf_sculpt_options *options, sf_status expected)
{
    gpu_sculpt *model = NULL;
    const char *why = NULL;
    CHECK_EQ(gpu_sculpt_create(options, &why, &model), expected);
    CHECK(model == NULL);
    size_t length = why != NULL ? strlen(why) : 0;
    CHECK(length > 20 && why[length - 1] == '.');
}

static void models_that_are_refused(void)
{
    sf_sculpt_options options = twin_options(64, 64, 64);
    check_refusal(NULL, SF_ERR_ARGUMENT);
    options.bed_layer = 64;
    check_refusal(&options, SF_ERR_ARGUMENT);
    options = twin_options(64, 64, 64);
    options.struct_size = 0;
    check_refusal(&options, SF_ERR_ARGUMENT);
    options = twin_options(64, 64, 64);
    CHECK(sf_rule_make(SF_RULE_OCTAGON, 0.7, &options.lattice, NULL, &options.rule, NULL) == SF_OK);
    check_refusal(&options, SF_ERR_ARGUMENT);
    options = twin_options(64, 64, 64);
    options.rule.bridge.span_x = 3;
    check_refusal(&options, SF_ERR_ARGUMENT);
    options = twin_options(64, 64, 64);
    options.history_size = (size_t)1 << 40;
    check_refusal(&options, SF_ERR_OVERFLOW);
}

static void calls_that_are_refused(void)
{
    sf_sculpt_options options = twin_options(16, 16, 16);
    twin t = twin_new(&options);
    random_stroke s = random_stroke_new(&options.lattice, 3);
    sf_dab far = {(1 << 30) + 1, 0, 0};
    sf_brush bad = s.brush;
    CHECK(gpu_sculpt_dab(t.gpu, s.dabs, 1) == SF_ERR_ARGUMENT);
    CHECK(gpu_sculpt_end(t.gpu) == SF_ERR_ARGUMENT);
    bad.tip = NULL;
    CHECK(gpu_sculpt_begin(t.gpu, &bad) == SF_ERR_ARGUMENT);
    bad = s.brush;
    bad.passes = 17;
    CHECK(gpu_sculpt_begin(t.gpu, &bad) == SF_ERR_ARGUMENT);
    bad = s.brush;
    bad.material = 0;
    CHECK(gpu_sculpt_begin(t.gpu, &bad) == SF_ERR_ARGUMENT);
    CHECK(gpu_sculpt_begin(t.gpu, &s.brush) == SF_OK);
    CHECK(gpu_sculpt_begin(t.gpu, &s.brush) == SF_ERR_ARGUMENT);
    CHECK(gpu_sculpt_dab(t.gpu, &far, 1) == SF_ERR_ARGUMENT);
    CHECK(gpu_sculpt_dab(t.gpu, NULL, 1) == SF_ERR_ARGUMENT);
    CHECK(gpu_sculpt_dab(t.gpu, NULL, 0) == SF_OK);
    CHECK(gpu_sculpt_undo(t.gpu) == SF_ERR_ARGUMENT);
    CHECK(gpu_sculpt_redo(t.gpu) == SF_ERR_ARGUMENT);
    CHECK(gpu_sculpt_replace(t.gpu, NULL, NULL) == SF_ERR_ARGUMENT);
    CHECK(gpu_sculpt_drop_ghosts(t.gpu) == SF_ERR_ARGUMENT);
    CHECK(gpu_sculpt_abandon(t.gpu) == SF_OK);
    CHECK(gpu_sculpt_abandon(t.gpu) == SF_OK);
    CHECK(gpu_sculpt_begin(t.gpu, &s.brush) == SF_OK);
    CHECK(gpu_sculpt_end(t.gpu) == SF_OK); // a stroke without dabs
    CHECK_EQ(twin_differs(&t), 0);
    sf_sculpt_options other = twin_options(16, 16, 17);
    twin u = twin_new(&other);
    CHECK(gpu_sculpt_replace(t.gpu, u.drawn, NULL) == SF_ERR_SHAPE);
    CHECK(gpu_sculpt_fetch(t.gpu, u.drawn, NULL, NULL) == SF_ERR_SHAPE);
    twin_free(&u);
    random_stroke_free(&s);
    twin_free(&t);
}

// A cloud of random voxels, with materials some of which are 0.
static void scatter(sf_grid *grid, uint8_t *materials, const sf_lattice *l)
{
    for (uint32_t z = 0; z < l->nz; z++) {
        for (uint32_t y = 0; y < l->ny; y++) {
            for (uint32_t x = 0; x < l->nx; x++) {
                int solid = test_random_below(3) != 0;
                CHECK(sf_slice_set(sf_grid_slice(grid, z), x, y, solid) == SF_OK);
                *materials++ = (uint8_t)test_random_below(4);
            }
        }
    }
}

static void whole_models(void)
{
    for (int i = 0; i < 4; i++) {
        sf_sculpt_options options = twin_options(45 + 20 * (uint32_t)i, 31, 24);
        options.keep_drawn = i & 1;
        options.bed_layer = (uint32_t)i;
        twin t = twin_new(&options);
        uint8_t *materials = malloc(t.voxels);
        scatter(t.drawn, materials, &options.lattice);
        CHECK(gpu_sculpt_replace(t.gpu, t.drawn, i < 2 ? materials : NULL) == SF_OK);
        CHECK(sf_sculpt_replace(t.cpu, t.drawn, i < 2 ? materials : NULL, NULL) == SF_OK);
        CHECK_EQ(twin_differs(&t), 0);
        CHECK(gpu_sculpt_drop_ghosts(t.gpu) == SF_OK);
        CHECK(sf_sculpt_drop_ghosts(t.cpu, NULL) == SF_OK);
        CHECK_EQ(twin_differs(&t), 0);
        for (int n = 0; n < 2; n++) {
            CHECK(gpu_sculpt_undo(t.gpu) == SF_OK);
            (void)!sf_sculpt_undo(t.cpu, NULL);
            CHECK_EQ(twin_differs(&t), 0);
        }
        CHECK(gpu_sculpt_redo(t.gpu) == SF_OK);
        (void)!sf_sculpt_redo(t.cpu, NULL);
        CHECK_EQ(twin_differs(&t), 0);
        free(materials);
        twin_free(&t);
    }
}

static uint32_t word_at(unsigned buffer, size_t i)
{
    uint32_t word = 0;
    glGetNamedBufferSubData(buffer, (GLintptr)(i * 4), 4, &word);
    return word;
}

// That the box of the last change holds these boxes of the library's.
static void check_changed(const twin *t, const sf_sculpt_change *c)
{
    uint32_t box[6];
    for (size_t k = 0; k < 6; k++) {
        box[k] = word_at(gpu_sculpt_view(t->gpu).ledger, 12 + k);
    }
    const sf_box parts[3] = {c->drawn, c->printable, c->material};
    for (int k = 0; k < 3; k++) {
        sf_box b = parts[k];
        CHECK(b.x1 == 0 || (box[0] <= b.x0 && box[1] <= b.y0 && box[2] <= b.z0 && box[3] >= b.x1 &&
                            box[4] >= b.y1 && box[5] >= b.z1));
    }
    CHECK(box[3] <= t->options.lattice.nx && box[4] <= t->options.lattice.ny &&
          box[5] <= t->options.lattice.nz);
}

static void the_box_of_what_changed(void)
{
    sf_sculpt_options options = twin_options(150, 40, 30);
    options.keep_drawn = 1;
    twin t = twin_new(&options);
    for (int i = 0; i < 60; i++) {
        random_stroke s = random_stroke_new(&options.lattice, 5);
        sf_sculpt_change c;
        CHECK(sf_sculpt_stroke(t.cpu, &s.brush, s.dabs, s.count, &c) == SF_OK);
        CHECK(gpu_sculpt_begin(t.gpu, &s.brush) == SF_OK);
        CHECK(gpu_sculpt_dab(t.gpu, s.dabs, s.count) == SF_OK);
        check_changed(&t, &c);
        CHECK(gpu_sculpt_end(t.gpu) == SF_OK);
        check_changed(&t, &c);
        sf_status undone = sf_sculpt_undo(t.cpu, &c);
        CHECK(gpu_sculpt_undo(t.gpu) == SF_OK);
        if (undone == SF_OK) {
            check_changed(&t, &c);
        }
        if (i % 4 != 0 && undone == SF_OK) {
            CHECK(sf_sculpt_redo(t.cpu, &c) == SF_OK);
            CHECK(gpu_sculpt_redo(t.gpu) == SF_OK);
            check_changed(&t, &c);
        }
        CHECK(gpu_sculpt_begin(t.gpu, &s.brush) == SF_OK);
        CHECK(gpu_sculpt_dab(t.gpu, s.dabs, s.count) == SF_OK);
        CHECK(gpu_sculpt_abandon(t.gpu) == SF_OK);
        CHECK_EQ(twin_differs(&t), 0);
        random_stroke_free(&s);
    }
    twin_free(&t);
}

// Voxels that are looked up as gpu_sculpt.h tells a view to.
static void what_a_view_finds(void)
{
    sf_sculpt_options options = twin_options(70, 20, 30);
    options.keep_drawn = 1;
    twin t = twin_new(&options);
    for (int i = 0; i < 30; i++) {
        random_stroke s = random_stroke_new(&options.lattice, 8);
        CHECK(gpu_sculpt_stroke(t.gpu, &s.brush, s.dabs, s.count) == SF_OK);
        CHECK(sf_sculpt_stroke(t.cpu, &s.brush, s.dabs, s.count, NULL) == SF_OK);
        random_stroke_free(&s);
    }
    gpu_view v = gpu_sculpt_view(t.gpu);
    for (int n = 0; n < 3000; n++) {
        uint32_t x = test_random_below(70), y = test_random_below(20), z = test_random_below(30);
        size_t i = ((size_t)z * v.ny + y) * v.row_words + x / 32;
        sf_slice d = sf_grid_slice(sf_sculpt_drawn(t.cpu), z);
        sf_slice p = sf_grid_slice(sf_sculpt_printable(t.cpu), z);
        CHECK_EQ(word_at(v.drawn, i) >> x % 32 & 1, sf_slice_get(d, x, y));
        CHECK_EQ(word_at(v.printable, i) >> x % 32 & 1, sf_slice_get(p, x, y));
        CHECK_EQ(word_at(v.materials, i * 8 + x % 32 / 4) >> x % 4 * 8 & 255,
                 sf_sculpt_materials(t.cpu)[((size_t)z * 20 + y) * 70 + x]);
    }
    twin_free(&t);
}

static void the_ledger_is_one(void)
{
    static const struct {
        const char *name;
        size_t offset;
    } members[] = {
        {"ledger_block.edit.x0", offsetof(ledger, edit)},
        {"ledger_block.touched.x0", offsetof(ledger, touched)},
        {"ledger_block.changed.z1", offsetof(ledger, changed.z1)},
        {"ledger_block.added_voxels", offsetof(ledger, added_voxels)},
        {"ledger_block.path_voxels", offsetof(ledger, path_voxels)},
        {"ledger_block.first", offsetof(ledger, first)},
        {"ledger_block.forgotten", offsetof(ledger, forgotten)},
        {"ledger_block.capacity", offsetof(ledger, capacity)},
        {"ledger_block.changed_words", offsetof(ledger, changed_words)},
        {"ledger_block.apply_count", offsetof(ledger, apply_count)},
        {"ledger_block.is_bed_known", offsetof(ledger, is_bed_known)},
        {"ledger_block.steps[0].start", sizeof(ledger)},
        {"ledger_block.steps[0].count", sizeof(ledger) + 4},
    };
    char log[400] = "";
    GLuint program = gl_compute_program("step.comp", log, sizeof log);
    CHECK_STR(log, "");
    for (size_t i = 0; i < sizeof members / sizeof *members; i++) {
        static const GLenum what = GL_OFFSET;
        GLint offset = -1;
        GLuint index = glGetProgramResourceIndex(program, GL_BUFFER_VARIABLE, members[i].name);
        if (index != GL_INVALID_INDEX) {
            glGetProgramResourceiv(program, GL_BUFFER_VARIABLE, index, 1, &what, 1, NULL, &offset);
        }
        CHECK_EQ(offset, members[i].offset);
    }
    glDeleteProgram(program);
    CHECK_EQ(gl_compute_program("no.comp", log, sizeof log), 0);
    CHECK(strstr(log, "no.comp") != NULL);
}

int main(void)
{
    gl_headless *context = NULL;
    if (!gl_begin(&context)) {
        return gl_status;
    }
    TEST(models_that_are_refused);
    TEST(calls_that_are_refused);
    TEST(whole_models);
    TEST(the_box_of_what_changed);
    TEST(what_a_view_finds);
    TEST(the_ledger_is_one);
    gl_headless_destroy(context);
    return test_finish();
}
