// SPDX-License-Identifier: MIT
// Why: under slack a path finder asks no search but the windows of a cone, so these must be what
// chains through empty space can do, for every angle, pixel and layer (ALGORITHMS 2.2, 10.2, 10.6).
// Here they are compared with the recursion over whole planes, the closed form with the least costs
// of chains, and on a large grid what a finder finds with what the search layer by layer finds.

#include "law/stack.h"

#include "support/grow/cone.h"
#include "support/grow/search.h"
#include "support/rule/carry.h"

#define SIDE 40
#define LAYERS 34
#define NONE 100000

typedef struct plane {
    int at[SIDE][SIDE]; // of one quadrant
} plane;

static int least(int a, int b)
{
    return a < b ? a : b;
}

// The least of from[D - s] + c(s) - gain, not below `floor`, over all s of the element.
static int over_steps(const sf_rule *rule, const sf_element *e, const plane *from, int x, int y,
                      int gain, int floor)
{
    int best = NONE;
    for (int sy = -(int)e->reach_y; sy <= e->reach_y; sy++) {
        int half = e->half_width[abs(sy)];
        for (int sx = -half; sx <= half; sx++) {
            int px = abs(x - sx), py = abs(y - sy);
            if (px < SIDE && py < SIDE && from->at[py][px] < NONE) {
                int cost = (int)sfi_slack_cost(rule, (uint32_t)abs(sx), (uint32_t)abs(sy));
                int sum = from->at[py][px] + cost - gain;
                best = least(best, sum > floor ? sum : floor);
            }
        }
    }
    return best;
}

static void make_plane(const sf_rule *rule, int k, const plane *from, int clamps, plane *to)
{
    sf_element e = stack_step(rule, k);
    int gain = clamps ? (int)sfi_slack_gain(rule, (uint32_t)k) : 0;
    for (int y = 0; y < SIDE; y++) {
        for (int x = 0; x < SIDE; x++) {
            int d = over_steps(rule, &e, from, x, y, gain, clamps ? 0 : -NONE);
            to->at[y][x] = clamps && d > rule->slack_cap ? NONE : d;
        }
    }
}

static void begin_plane(plane *p)
{
    for (int i = 0; i < SIDE * SIDE; i++) {
        p->at[i / SIDE][i % SIDE] = NONE;
    }
    p->at[0][0] = 0;
}

// Columns near the border lack what chains beyond it could do: the recursion over quadrants folds
// at 0 only. Chains need not go there, which is what this compares too.
static void check_window(const sfi_window *w, const plane *p)
{
    for (uint32_t y = 0; y < SIDE; y++) {
        uint32_t half = sfi_window_half_width(w, y);
        for (uint32_t x = 0; x < SIDE; x++) {
            int is_in = half != SFI_WINDOW_NONE && x <= half, d = p->at[y][x];
            CHECK_EQ(is_in, d < NONE);
            CHECK(!is_in || d == (int)sfi_window_demand(w, x, y));
        }
    }
}

static sf_rule make_rule(double degrees, const double *pitch, double h, const double *heights,
                         uint64_t *table)
{
    sf_lattice lattice = {8, 8, LAYERS, pitch[0], pitch[1], h, heights, {0.0, 0.0, 0.0}};
    sf_rule rule = sf_rule_box3();
    CHECK_EQ(sf_rule_make(SF_RULE_SLACK, degrees * (3.14159265358979323846 / 180.0), &lattice,
                          table, &rule, NULL),
             SF_OK);
    return rule;
}

static void check_below(const sf_rule *rule, sfi_cone *cone, int top)
{
    static plane planes[2];
    sfi_cone_begin(cone, (uint32_t)top);
    begin_plane(&planes[0]);
    for (int t = 1; t <= top; t++) {
        sfi_window window;
        CHECK_EQ(sfi_cone_deepen(cone, &window), SF_OK);
        make_plane(rule, top - t, &planes[(t + 1) % 2], 1, &planes[t % 2]);
        check_window(&window, &planes[t % 2]);
    }
}

static const double pitches[4][2] = {{0.1, 0.1}, {0.1, 0.17}, {0.3, 0.1}, {0.1, 0.1}};
static const double angles[6] = {18.0, 33.0, 45.0, 52.0, 64.0, 71.0};

static void windows_are_what_chains_reach(void)
{
    for (int i = 0; i < 24; i++) {
        sf_rule rule = make_rule(angles[i % 6], pitches[i / 6], 0.1, NULL, NULL);
        sfi_cone cone;
        CHECK_EQ(sfi_cone_create(&rule, SIDE, SIDE, NULL, &cone), SF_OK);
        CHECK(cone.fringe.is_lasting);
        for (int j = 0; j < 4; j++) {
            check_below(&rule, &cone, LAYERS - 1 - (int)test_random_below(LAYERS - 1));
        }
        sfi_cone_destroy(&cone);
    }
}

static void windows_of_layers_that_differ(void)
{
    for (int i = 0; i < 16; i++) {
        double heights[LAYERS];
        uint64_t table[2 * LAYERS];
        for (int k = 0; k < LAYERS; k++) {
            heights[k] = 0.02 + 0.15 * test_random_unit();
        }
        sf_rule rule = make_rule(angles[i % 4], pitches[i / 4], 0.1, heights, table);
        sfi_cone cone;
        CHECK_EQ(sfi_cone_create(&rule, SIDE, SIDE, NULL, &cone), SF_OK);
        CHECK(!cone.fringe.is_lasting);
        for (int j = 0; j < 3; j++) {
            int top = LAYERS - 1 - (int)test_random_below(LAYERS - 1);
            check_below(&rule, &cone, top);
            check_below(&rule, &cone, top); // from what is kept
        }
        sfi_cone_destroy(&cone);
    }
}

// A cap that is less than the longest step costs is no rule that sf_rule_make() makes, but it is
// one that the library takes.
static void a_cap_below_the_longest_step(void)
{
    sf_rule rule = make_rule(45.0, pitches[0], 0.1, NULL, NULL);
    sfi_cone cone;
    rule.slack_cap = (uint16_t)(rule.slack_x * 3 / 2);
    CHECK_EQ(sfi_cone_create(&rule, SIDE, SIDE, NULL, &cone), SF_OK);
    CHECK(!cone.fringe.is_lasting);
    for (int top = 1; top < LAYERS; top += 6) {
        check_below(&rule, &cone, top);
    }
    sfi_cone_destroy(&cone);
}

// d = max(0, ch - G), where heights are one: the essay of fringe.c.
static void demands_in_closed_form(void)
{
    static plane chains[2];
    for (int i = 0; i < 24; i++) {
        sf_rule rule = make_rule(angles[i % 6], pitches[i / 6], 0.1, NULL, NULL);
        int top = LAYERS - 1 - (int)test_random_below(6), gains = 0;
        sfi_cone cone;
        CHECK_EQ(sfi_cone_create(&rule, SIDE, SIDE, NULL, &cone), SF_OK);
        sfi_cone_begin(&cone, (uint32_t)top);
        begin_plane(&chains[0]);
        for (int t = 1; t <= top; t++) {
            sfi_window window;
            static plane expected;
            CHECK_EQ(sfi_cone_deepen(&cone, &window), SF_OK);
            make_plane(&rule, top - t, &chains[(t + 1) % 2], 0, &chains[t % 2]);
            gains += (int)sfi_slack_gain(&rule, (uint32_t)(top - t));
            for (int j = 0; j < SIDE * SIDE; j++) {
                int d = chains[t % 2].at[j / SIDE][j % SIDE] - gains;
                expected.at[j / SIDE][j % SIDE] = d > rule.slack_cap ? NONE : d > 0 ? d : 0;
            }
            check_window(&window, &expected);
        }
        sfi_cone_destroy(&cone);
    }
}

// Where heights differ the closed form promises too much: three thin layers over three thick ones,
// and a chain along the diagonal, of which the cap cuts off what the thin layers cannot pay for.
static void no_closed_form_where_heights_differ(void)
{
    static plane chains[2];
    double heights[LAYERS];
    uint64_t table[2 * LAYERS];
    for (int k = 0; k < LAYERS; k++) {
        heights[k] = k < 3 ? 0.2 : 0.05;
    }
    sf_rule rule = make_rule(45.0, pitches[0], 0.1, heights, table);
    sfi_cone cone;
    sfi_window window = {0};
    int gains = 0;
    CHECK_EQ(sfi_cone_create(&rule, SIDE, SIDE, NULL, &cone), SF_OK);
    sfi_cone_begin(&cone, 6);
    begin_plane(&chains[0]);
    for (int t = 1; t <= 6; t++) {
        CHECK_EQ(sfi_cone_deepen(&cone, &window), SF_OK);
        make_plane(&rule, 6 - t, &chains[(t + 1) % 2], 0, &chains[t % 2]);
        gains += (int)sfi_slack_gain(&rule, (uint32_t)(6 - t));
    }
    int promised = chains[0].at[6][6] - gains;
    CHECK(promised > 0 && promised < (int)sfi_window_demand(&window, 6, 6));
    CHECK(sfi_window_half_width(&window, 6) >= 6);
    sfi_cone_destroy(&cone);
}

// --- a finder and the search -------------------------------------------------------------------

// Boxes, beams and grains in a grid that no oracle of bytes could take; few leave the bed to most.
static sf_grid *random_grid(const sf_lattice *lattice, int boxes)
{
    sf_grid *grid = NULL;
    CHECK_EQ(sf_grid_create(lattice, NULL, &grid), SF_OK);
    for (int i = 0; i < boxes; i++) {
        uint32_t x = test_random_below(lattice->nx), y = test_random_below(lattice->ny);
        uint32_t z = test_random_below(lattice->nz), most = i % 4 > 0 ? 4 : 24;
        uint32_t x1 = x + 1 + test_random_below(most), y1 = y + 1 + test_random_below(most);
        uint32_t z1 = z + 1 + test_random_below(most);
        sf_rect rect = {x, y, x1 < lattice->nx ? x1 : lattice->nx,
                        y1 < lattice->ny ? y1 : lattice->ny};
        for (; z < z1 && z < lattice->nz; z++) {
            CHECK_EQ(sf_slice_fill(sf_grid_slice(grid, z), rect, 1), SF_OK);
        }
    }
    return grid;
}

static void compare(const sf_grid *grid, const sf_terms *terms, sf_landing landing, int count)
{
    static sf_voxel path[128], chain[128];
    sf_lattice lattice = sf_grid_lattice(grid);
    sf_path_finder *finder = NULL;
    sfi_site site;
    sfi_bed bed = {0};
    sfi_progress progress = sfi_progress_begin(NULL);
    sfi_stage stage = {NULL, &progress, 0, lattice.nz};
    CHECK_EQ(sf_path_finder_create(grid, terms, landing, NULL, NULL, &finder), SF_OK);
    CHECK_EQ(sfi_site_open(&site, grid, terms, landing, NULL, &stage), SF_OK);
    for (int i = 0; i < count; i++) {
        sf_voxel from = {test_random_below(lattice.nx), test_random_below(lattice.ny),
                         site.bed + 1 + test_random_below(lattice.nz - site.bed - 1)};
        sf_path a, b;
        int is_held = sf_slice_get(sfi_mask_slice(terms->exempt, from.z), from.x, from.y);
        sf_status status = sfi_descend(&site, &bed, from, chain, &b);
        CHECK_EQ(sf_path_finder_find(finder, from, path, 128, &a), is_held ? SF_OK : status);
        if (is_held || status != SF_OK) {
            continue; // a held voxel needs no search
        }
        CHECK(a.count == b.count && a.end == b.end && a.cost == b.cost);
        CHECK(a.landing.x == b.landing.x && a.landing.y == b.landing.y &&
              a.landing.z == b.landing.z && a.bed_square == b.bed_square);
    }
    sfi_bed_destroy(&bed, &site);
    sfi_site_close(&site);
    sf_path_finder_destroy(finder);
}

// Now and then masks, thin enough for paths to be found with and without regard to them.
static void add_masks(int i, const sf_lattice *lattice, sf_terms *terms, sf_grid *masks[2])
{
    for (int m = 0; m < 2; m++) {
        CHECK_EQ(sf_grid_create(lattice, NULL, &masks[m]), SF_OK);
        for (uint32_t k = 0; k < (m == 0 ? 30u : 2000u); k++) {
            sf_slice slice = sf_grid_slice(masks[m], test_random_below(lattice->nz));
            uint32_t x = test_random_below(lattice->nx), y = test_random_below(lattice->ny);
            CHECK_EQ(sf_slice_set(slice, x, y, 1), SF_OK);
        }
    }
    terms->exempt = i % 5 == 1 || i % 5 == 3 ? masks[0] : NULL;
    terms->forbid = i % 5 == 2 || i % 5 == 3 ? masks[1] : NULL;
}

static void a_finder_finds_what_a_search_finds(void)
{
    static const sf_rule_kind kinds[6] = {SF_RULE_SLACK, SF_RULE_DISK,    SF_RULE_SLACK,
                                          SF_RULE_SLACK, SF_RULE_OCTAGON, SF_RULE_BOX3};
    for (int i = 0; i < 60; i++) {
        double heights[70];
        uint64_t table[140];
        sf_lattice lattice = {150, 70, 70, 0.1, i % 12 == 2 ? 0.14 : 0.1, 0.1, NULL, {0}};
        sf_grid *masks[2];
        for (int k = 0; k < 70; k++) {
            heights[k] = 0.1 + 0.1 * test_random_unit();
        }
        lattice.heights_mm = i % 12 == 0 ? heights : NULL;
        sf_terms terms = sf_terms_default();
        double radians = 0.8 + 0.3 * test_random_unit();
        CHECK_EQ(sf_rule_make(kinds[i % 6], radians, &lattice, table, &terms.rule, NULL), SF_OK);
        sf_grid *grid = random_grid(&lattice, i % 3 == 2 ? 40 : 5);
        CHECK_EQ(sf_slice_set(sf_grid_slice(grid, 0), i % 2 == 0 ? 0 : 149, (uint32_t)i % 70, 1),
                 SF_OK);
        add_masks(i, &lattice, &terms, masks);
        compare(grid, &terms, i % 7 == 0 ? SF_LANDING_ALIVE : SF_LANDING_ANY, 90);
        sf_grid_destroy(grid);
        sf_grid_destroy(masks[0]);
        sf_grid_destroy(masks[1]);
    }
}

int main(void)
{
    TEST(windows_are_what_chains_reach);
    TEST(windows_of_layers_that_differ);
    TEST(a_cap_below_the_longest_step);
    TEST(demands_in_closed_form);
    TEST(no_closed_form_where_heights_differ);
    TEST(a_finder_finds_what_a_search_finds);
    return test_finish();
}
