// SPDX-License-Identifier: MIT
// Why: the promise to a user is about real parts. Eight models, voxelised with 128 voxels along
// their longest side and trimmed under every kind of rule, with bridges and without, get
// certificates that sf-verify takes; before the trim they get none. The models lie in the folder
// that SF_DATA names; the twin that always runs is verify certificate. Guards issue 3, certificate.

#include "verified.h"

#include "model.h"

#define RESOLUTION 128

static void judge_under(const sf_grid *shape, sf_rule_kind kind, double degrees, double span)
{
    static made_rule made;
    sf_lattice lattice = sf_grid_lattice(shape);
    sf_grid *after = NULL;
    sf_certificate *none = NULL, *certificate = NULL;
    double pitch_mm = lattice.pitch_x_mm;
    CHECK_EQ(make_rule(&made, &lattice, kind, degrees, span * pitch_mm, 2 * pitch_mm, SF_BED_AUTO),
             SF_OK);
    CHECK_EQ(sf_grid_clone(shape, NULL, &after), SF_OK);
    sf_terms terms = terms_of(&made, NULL);
    sf_claim claim = claim_of(&made, &terms, SF_OPERATION_CHECK, NULL);
    sf_status status = sf_certificate_make(shape, &claim, NULL, NULL, &none, NULL);
    CHECK_EQ(sf_grid_trim_on(after, &terms, NULL, NULL, NULL, NULL), SF_OK);
    CHECK_EQ(status, sf_grid_equal(shape, after) ? SF_OK : SF_ERR_INFEASIBLE);
    claim = claim_of(&made, &terms, SF_OPERATION_TRIM, shape);
    CHECK_EQ(sf_certificate_make(after, &claim, NULL, NULL, &certificate, NULL), SF_OK);
    if (certificate != NULL) {
        text t = certificate_text(certificate);
        show_grid(after, &made.info);
        CHECK(accepts(&t));
        free(t.bytes);
    }
    sf_certificate_destroy(certificate);
    sf_certificate_destroy(none);
    sf_grid_destroy(after);
}

static void real_models(void)
{
    static const char *const names[] = {"characters/armadillo.obj",
                                        "characters/stanford-bunny.obj",
                                        "characters/spot_low_resolution.obj",
                                        "characters/human_man.obj",
                                        "characters/koala_low_resolution.obj",
                                        "parts/A_upsidedown.obj",
                                        "parts/ksr_fdmtest_v4.stl",
                                        "parts/frog_legs.obj"};
    if (getenv("SF_DATA") == NULL) {
        SKIP("SF_DATA is not set");
    }
    snprintf(models, sizeof models, "%s", getenv("SF_DATA"));
    for (int i = 0; i < 8; i++) {
        sf_grid *grid = voxelize(names[i], RESOLUTION);
        if (grid != NULL) {
            judge_under(grid, SF_RULE_BOX3, 0.0, i % 2 ? 6.0 : 0.0);
            judge_under(grid, SF_RULE_OCTAGON, 45.0, i % 2 ? 0.0 : 6.0);
            judge_under(grid, SF_RULE_DISK, 72.0, i % 2 ? 4.0 : 0.0);
            judge_under(grid, SF_RULE_SLACK, 40.0, i % 2 ? 0.0 : 9.0);
        }
        sf_grid_destroy(grid);
    }
}

int main(void)
{
    TEST(real_models);
    forget();
    return test_finish();
}
