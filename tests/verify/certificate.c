// SPDX-License-Identifier: MIT
// Why: a certificate must convince somebody who does not trust the library. For every rule, with
// bridges and without, layers of one height and of many, oblong pixels, a bed that is given or
// found, voxels that are exempt or not, a trimmed shape gets a certificate and sf-verify, which
// shares no line with the library, agrees; an untrimmed one gets none. The same on real models,
// where SF_DATA names them. Guards issue 3, certificate.

#include "verified.h"

static const char *program; // sf-verify itself

static int program_exits(const char *stack_path, const char *certificate_path, int status)
{
    char command[2048];
    snprintf(command, sizeof command, "\"%s\" \"%s\" \"%s\" >\"%s\" 2>&1; test $? -eq %d", program,
             stack_path, certificate_path, folder_path("said"), status);
    return system(command) == 0;
}

static const struct {
    sf_rule_kind kind;
    double degrees;
} kinds[] = {{SF_RULE_BOX3, 45.0},  {SF_RULE_OCTAGON, 30.0}, {SF_RULE_OCTAGON, 52.0},
             {SF_RULE_DISK, 50.0},  {SF_RULE_DISK, 74.0},    {SF_RULE_SLACK, 20.0},
             {SF_RULE_SLACK, 45.0}, {SF_RULE_SLACK, 68.0}};
#define KINDS 8

// Boxes and specks; beams are what bridges need.
static void draw(sf_grid *grid)
{
    static stack s;
    sf_lattice lattice = sf_grid_lattice(grid);
    stack_random_boxes(&s, (int)lattice.nx, (int)lattice.ny, (int)lattice.nz, 9);
    for (int i = 0; i < 12; i++) {
        int z = (int)test_random_below(lattice.nz), y = (int)test_random_below(lattice.ny);
        int x = (int)test_random_below(lattice.nx), d = (int)test_random_below(4);
        for (int n = 0; n < 14; n++, x += d == 3 ? -1 : d != 1, y += d > 0) {
            if (x >= 0 && x < s.nx && y < s.ny) {
                *stack_at(&s, x, y, z) = 1;
            }
        }
    }
    for (int i = 0; i < stack_count(&s); i++) {
        s.solid[i] |= test_random_below(40) == 0;
    }
    stack_write(&s, grid);
}

static sf_grid *random_mask(const sf_lattice *lattice)
{
    static stack s;
    sf_grid *mask = NULL;
    CHECK_EQ(sf_grid_create(lattice, NULL, &mask), SF_OK);
    stack_random(&s, (int)lattice->nx, (int)lattice->ny, (int)lattice->nz, 0.03);
    stack_write(&s, mask);
    return mask;
}

static void judge_grid(const sf_grid *before, const sf_grid *after, const made_rule *made,
                       const sf_grid *exempt, int to_disk, uint64_t *spans)
{
    sf_terms terms = terms_of(made, exempt);
    sf_claim claim = claim_of(made, &terms, SF_OPERATION_TRIM, before);
    sf_certificate *certificate = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    CHECK_EQ(sf_certificate_make(after, &claim, NULL, NULL, &certificate, &fault), SF_OK);
    CHECK_STR(fault.message, "");
    if (certificate == NULL) {
        return;
    }
    text t = certificate_text(certificate);
    show_grid(after, &made->info);
    if (!accepts(&t)) {
        printf("# %s\n", found);
        CHECK(!"the verifier agrees");
    }
    if (to_disk) {
        CHECK(write_stack(after, &made->info, folder_path("stack")));
        text_save(&t, folder_path("certificate"));
        CHECK(program_exits(folder_path("stack"), folder_path("certificate"), 0));
    }
    *spans += sf_certificate_get_view(certificate).span_count;
    free(t.bytes);
    sf_certificate_destroy(certificate);
}

static void judge_on(const sf_lattice *lattice, int which, double span_mm, uint32_t bed_k,
                     int with_exempt, uint64_t *spans)
{
    static made_rule made;
    sf_grid *before = NULL, *after = NULL, *exempt = with_exempt ? random_mask(lattice) : NULL;
    sf_status status = make_rule(&made, lattice, kinds[which].kind, kinds[which].degrees, span_mm,
                                 span_mm > 0 ? 0.15 : 0.0, bed_k);
    if (status == SF_OK) {
        CHECK_EQ(sf_grid_create(lattice, NULL, &before), SF_OK);
        draw(before);
        CHECK_EQ(sf_grid_clone(before, NULL, &after), SF_OK);
        sf_terms terms = terms_of(&made, exempt);
        sf_claim claim = claim_of(&made, &terms, SF_OPERATION_CHECK, NULL);
        sf_certificate *none = NULL;
        CHECK_EQ(sf_certificate_make(before, &claim, NULL, NULL, &none, NULL), SF_ERR_INFEASIBLE);
        CHECK(none == NULL);
        CHECK_EQ(sf_grid_trim_on(after, &terms, NULL, NULL, NULL, NULL), SF_OK);
        judge_grid(before, after, &made, exempt, which == KINDS - 1 && span_mm > 0, spans);
    } else {
        CHECK_EQ(status, SF_ERR_UNSUPPORTED);
    }
    sf_grid_destroy(before);
    sf_grid_destroy(after);
    sf_grid_destroy(exempt);
}

// All kinds; bed and exempt voxels take turns. The program itself looks at the last kind.
static void judge_lattice(const sf_lattice *lattice)
{
    uint64_t spans = 0;
    for (int i = 0; i < KINDS; i++) {
        for (int turn = 0; turn < 4; turn++) {
            double span_mm = turn % 2 ? 0.55 : 0.0;
            judge_on(lattice, i, span_mm, (i + turn) % 3 ? SF_BED_AUTO : 2, turn > 1, &spans);
        }
    }
    CHECK(spans > 20);
}

static void cubes(void)
{
    sf_lattice lattice = stack_lattice(25, 22, 13);
    judge_lattice(&lattice);
}

static void layers_of_different_heights(void)
{
    double thick[14];
    for (int k = 0; k < 14; k++) {
        thick[k] = 0.07 + 0.1 * test_random_unit();
    }
    sf_lattice lattice = stack_lattice(21, 18, 14);
    lattice.heights_mm = thick;
    judge_lattice(&lattice);
}

static void oblong_pixels(void)
{
    sf_lattice lattice = stack_lattice(24, 17, 11);
    lattice.pitch_y_mm = 0.073;
    lattice.layer_mm = 0.09;
    judge_lattice(&lattice);
}

int main(int argc, char **argv)
{
    program = argc > 1 ? argv[1] : "./sf-verify";
    folder_begin("certificate");
    TEST(cubes);
    TEST(layers_of_different_heights);
    TEST(oblong_pixels);
    forget();
    folder_end();
    return test_finish();
}
