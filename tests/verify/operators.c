// SPDX-License-Identifier: MIT
// Why: the promise to a user is about real parts. Eight models, and a scene that always runs, are
// trimmed, grown and repaired under octagon and slack at 45 degrees. Of each result sf-verify takes
// the certificate and, where the rule is octagon, the other verifier finds nothing that hangs; its
// STL is a closed 2-manifold once equal corners are merged; grow removes nothing, trim adds
// nothing, repair costs no more than either. Guards issue 3. Models lie in the folder that SF_DATA
// names, 64 voxels along their longest side; OPERATORS=256 asks for 256, as docs/operators.md has
// them.

#include "verified.h"

#include <sf/grow.h>
#include <sf/repair.h>

#include <time.h>

#include "closed.h"
#include "model.h"
#include "scene.h"

static const char *certifier; // sf-verify itself

static int resolution(void)
{
    const char *wish = getenv("OPERATORS");
    return wish != NULL ? atoi(wish) : 64;
}

// ---------------------------------------------------------------------------------------------
// What others say of a result
// ---------------------------------------------------------------------------------------------

static int certifier_agrees(const char *stack_path, const char *certificate_path)
{
    char command[2048];
    snprintf(command, sizeof command, "\"%s\" \"%s\" \"%s\" >\"%s\" 2>&1", certifier, stack_path,
             certificate_path, folder_path("said"));
    return system(command) == 0;
}

static void check_certificate(const sf_grid *shape, const sf_grid *before, const made_rule *made,
                              sf_operation operation)
{
    sf_terms terms = terms_of(made, NULL);
    sf_claim claim = claim_of(made, &terms, operation, before);
    sf_certificate *certificate = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    CHECK_EQ(sf_certificate_make(shape, &claim, NULL, NULL, &certificate, &fault), SF_OK);
    CHECK_STR(fault.message, "");
    if (certificate != NULL) {
        text t = certificate_text(certificate);
        if (made->info.rule == SF_RULE_OCTAGON || resolution() > 64) {
            text_save(&t, folder_path("certificate"));
            CHECK(write_stack(shape, &made->info, folder_path("stack")));
            CHECK(certifier_agrees(folder_path("stack"), folder_path("certificate")));
        } else { // the same verifier, spared the disk
            show_grid(shape, &made->info);
            CHECK(accepts(&t));
        }
        if (made->info.rule == SF_RULE_OCTAGON) {
            CHECK(verifier_exits(folder_path("stack"), "", 0));
        }
        free(t.bytes);
    }
    sf_certificate_destroy(certificate);
}

static void check_surface(const sf_grid *shape)
{
    sf_mesh *mesh = NULL, *merged = NULL;
    sf_topology topology;
    text stl = {NULL, 0, 0};
    sf_sink sink = {text_add, &stl};
    CHECK_EQ(sf_grid_surface(shape, NULL, NULL, NULL, &mesh), SF_OK);
    CHECK_EQ(sf_mesh_write(sf_mesh_get_view(mesh), SF_MESH_FORMAT_STL, sink), SF_OK);
    CHECK(closed_stl(stl.bytes, stl.size));
    CHECK_EQ(sf_mesh_merge(sf_mesh_get_view(mesh), NULL, &merged), SF_OK);
    CHECK_EQ(sf_mesh_analyze(sf_mesh_get_view(merged), NULL, &topology), SF_OK);
    CHECK(topology.closed && topology.oriented && !topology.flipped);
    CHECK_EQ(topology.boundary_edges + topology.nonmanifold_edges, 0);
    free(stl.bytes);
    sf_mesh_destroy(mesh);
    sf_mesh_destroy(merged);
}

// ---------------------------------------------------------------------------------------------
// The three operators
// ---------------------------------------------------------------------------------------------

typedef struct outcome {
    uint64_t added, removed;
    double seconds;
} outcome;

static void operate(sf_grid *grid, const sf_terms *terms, sf_operation operation)
{
    sf_repair_options options = sf_repair_options_default();
    options.terms = *terms;
    sf_status status =
        operation == SF_OPERATION_TRIM   ? sf_grid_trim_on(grid, terms, NULL, NULL, NULL, NULL)
        : operation == SF_OPERATION_GROW ? sf_grid_grow(grid, terms, NULL, NULL, NULL, NULL)
                                         : sf_grid_repair(grid, &options, NULL, NULL, NULL, NULL);
    CHECK_EQ(status, SF_OK);
}

static uint64_t volume_without(const sf_grid *a, const sf_grid *b)
{
    sf_grid *rest = NULL;
    CHECK_EQ(sf_grid_clone(a, NULL, &rest), SF_OK);
    for (uint32_t k = 0; k < sf_grid_lattice(a).nz; k++) {
        sf_slice slice = sf_grid_slice(rest, k);
        CHECK_EQ(sf_slice_subtract(slice, slice, sf_grid_slice(b, k)), SF_OK);
    }
    uint64_t volume = sf_grid_popcount(rest);
    sf_grid_destroy(rest);
    return volume;
}

static double middle(double a, double b, double c)
{
    double low = fmin(a, b), high = fmax(a, b);
    return fmax(low, fmin(high, c));
}

static outcome run(const sf_grid *before, const made_rule *made, sf_operation operation)
{
    sf_grid *after = NULL;
    sf_terms terms = terms_of(made, NULL);
    double seconds[3] = {0, 0, 0};
    int times = resolution() > 64 ? 3 : 1;
    for (int i = 0; i < times; i++) {
        sf_grid_destroy(after);
        CHECK_EQ(sf_grid_clone(before, NULL, &after), SF_OK);
        clock_t begun = clock();
        operate(after, &terms, operation);
        seconds[i] = (double)(clock() - begun) / CLOCKS_PER_SEC;
    }
    check_certificate(after, before, made, operation);
    check_surface(after);
    outcome o = {volume_without(after, before), volume_without(before, after),
                 times == 3 ? middle(seconds[0], seconds[1], seconds[2]) : seconds[0]};
    sf_grid_destroy(after);
    return o;
}

static uint64_t unsupported_voxels(const sf_grid *grid, const made_rule *made)
{
    sf_check_options o = sf_check_options_default();
    sf_check_report report = {0};
    o.rule = made->rule;
    CHECK_EQ(sf_grid_check(grid, &o, NULL, NULL, &report, NULL), SF_OK);
    return report.unsupported_voxels;
}

static void judge_under(const char *name, const sf_grid *shape, sf_rule_kind kind)
{
    static made_rule made;
    sf_lattice lattice = sf_grid_lattice(shape);
    CHECK_EQ(make_rule(&made, &lattice, kind, 45.0, 0, 0, SF_BED_AUTO), SF_OK);
    outcome trim = run(shape, &made, SF_OPERATION_TRIM);
    outcome grow = run(shape, &made, SF_OPERATION_GROW);
    outcome repair = run(shape, &made, SF_OPERATION_REPAIR);
    uint64_t cost = repair.added + repair.removed;
    CHECK_EQ(trim.added, 0);
    CHECK_EQ(grow.removed, 0);
    uint64_t hanging = unsupported_voxels(shape, &made);
    CHECK_EQ(trim.removed > 0, hanging > 0);
    CHECK_EQ(grow.added > 0, hanging > 0);
    CHECK(cost <= trim.removed && cost <= grow.added);
    printf("# | %s | %s | %llu | %llu | %llu | %llu | %llu / %llu | %.4f | %.3f | %.2f |\n", name,
           sf_rule_kind_name(kind), (unsigned long long)sf_grid_popcount(shape),
           (unsigned long long)hanging, (unsigned long long)trim.removed,
           (unsigned long long)grow.added, (unsigned long long)repair.added,
           (unsigned long long)repair.removed, trim.seconds, grow.seconds, repair.seconds);
    fflush(stdout);
}

static void judge_shape(const char *name, sf_grid *shape)
{
    if (shape != NULL) {
        judge_under(name, shape, SF_RULE_OCTAGON);
        judge_under(name, shape, SF_RULE_SLACK);
    }
    sf_grid_destroy(shape);
}

static void the_scene(void)
{
    double size[3] = {0, 0, 0};
    uint32_t n = (uint32_t)resolution();
    sf_grid *grid = NULL;
    CHECK(scene_size("garden", size));
    double p = size[0] / n;
    sf_lattice lattice = {n, (uint32_t)(size[1] / p), (uint32_t)(size[2] / p), p, p, p, NULL, {0}};
    CHECK_EQ(sf_grid_create(&lattice, NULL, &grid), SF_OK);
    CHECK_EQ(scene_draw("garden", grid, NULL), SF_OK);
    judge_shape("scene:garden", grid);
}

static void eight_models(void)
{
    static const char *const names[] = {"characters/armadillo.obj",
                                        "characters/stanford-bunny.obj",
                                        "characters/spot_low_resolution.obj",
                                        "characters/human_man.obj",
                                        "characters/koala_low_resolution.obj",
                                        "parts/A_upsidedown.obj",
                                        "parts/frog_legs.obj",
                                        "parts/ksr_fdmtest_v4.stl"};
    if (getenv("SF_DATA") == NULL) {
        SKIP("SF_DATA is not set");
    }
    snprintf(models, sizeof models, "%s", getenv("SF_DATA"));
    for (int i = 0; i < 8; i++) {
        judge_shape(strchr(names[i], '/') + 1, voxelize(names[i], resolution()));
    }
}

// The judge of surfaces must see what is wrong with one.
static void an_open_surface_is_seen(void)
{
    sf_lattice lattice = stack_lattice(4, 4, 3);
    sf_grid *grid = NULL;
    sf_mesh *mesh = NULL;
    text stl = {NULL, 0, 0};
    sf_sink sink = {text_add, &stl};
    CHECK_EQ(sf_grid_create(&lattice, NULL, &grid), SF_OK);
    CHECK_EQ(sf_slice_set(sf_grid_slice(grid, 1), 1, 2, 1), SF_OK);
    CHECK_EQ(sf_slice_set(sf_grid_slice(grid, 2), 2, 1, 1), SF_OK);
    CHECK_EQ(sf_grid_surface(grid, NULL, NULL, NULL, &mesh), SF_OK);
    CHECK_EQ(sf_mesh_write(sf_mesh_get_view(mesh), SF_MESH_FORMAT_STL, sink), SF_OK);
    uint32_t count = (uint32_t)sf_mesh_get_view(mesh).triangle_count, less = count - 1;
    CHECK(closed_stl(stl.bytes, stl.size));
    for (uint32_t i = 0; i < count; i++) {
        unsigned char *at = (unsigned char *)stl.bytes + 84 + (size_t)i * 50 + 12, kept[24];
        memcpy(kept, at, 24);
        memcpy(at, kept + 12, 12); // turned round
        memcpy(at + 12, kept, 12);
        CHECK(!closed_stl(stl.bytes, stl.size));
        memcpy(at, kept, 24);
    }
    memcpy(stl.bytes + 80, &less, 4);
    CHECK(!closed_stl(stl.bytes, stl.size - 50)); // one is missing
    free(stl.bytes);
    sf_mesh_destroy(mesh);
    sf_grid_destroy(grid);
}

int main(int argc, char **argv)
{
    verifier = argc > 2 ? argv[1] : "./verify";
    certifier = argc > 2 ? argv[2] : "./sf-verify";
    folder_begin("operators");
    TEST(an_open_surface_is_seen);
    TEST(the_scene);
    TEST(eight_models);
    folder_end();
    forget();
    return test_finish();
}
