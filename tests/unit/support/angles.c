// SPDX-License-Identifier: MIT
// Why: a rule is made for an angle, and people want to know which one they get. From one voxel on
// the bed under solid layers, what a rule keeps is its whole cone: its hull is held against the
// asked angle over all azimuths. Slack never reaches beyond the asked cone by more than its cap and
// stays within 3 % of its tangent everywhere (ALGORITHMS 1.6, as corrected); octagon within 1.502
// voxel and cos(22.5 degrees). What sf_rule_measure() says is what is found. The table of
// docs/rules.md is printed here.

#include "law/stack.h"

#define AZIMUTHS 360
#define DEGREES (180.0 / 3.14159265358979323846)

typedef struct point {
    double x, y;
} point;

static double cross(point o, point a, point b)
{
    return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
}

// Add p to one side of a hull whose points come in order.
static int turn_left(point *hull, int count, point p)
{
    while (count >= 2 && cross(hull[count - 2], hull[count - 1], p) <= 0) {
        count--;
    }
    hull[count] = p;
    return count + 1;
}

// Hull of a slice's voxels in mm around its middle voxel, counterclockwise: up along the last
// voxels of the rows, down along the first ones. Returns its size.
static int hull_of(sf_slice slice, const sf_lattice *lattice, point *hull)
{
    static point first[1 << 12];
    int rows = 0, count = 0;
    for (uint32_t y = 0; y < slice.height; y++) {
        uint32_t x0 = slice.width, x1 = 0;
        for (uint32_t x = 0; x < slice.width; x++) {
            if (sf_slice_get(slice, x, y)) {
                x0 = x < x0 ? x : x0;
                x1 = x;
            }
        }
        if (x0 < slice.width) {
            double v = ((double)y - slice.height / 2) * lattice->pitch_y_mm;
            point left = {((double)x0 - slice.width / 2) * lattice->pitch_x_mm, v};
            point right = {((double)x1 - slice.width / 2) * lattice->pitch_x_mm, v};
            first[rows++] = left;
            count = turn_left(hull, count, right);
        }
    }
    while (rows-- > 0) {
        count = turn_left(hull, count, first[rows]);
    }
    return count;
}

// How far a hull reaches in direction (c, s).
static double radius(const point *hull, int count, double c, double s)
{
    double best = 0;
    for (int i = 0; i < count; i++) {
        point a = hull[i], b = hull[(i + 1) % count];
        double da = a.y * c - a.x * s, db = b.y * c - b.x * s, t = da != db ? da / (da - db) : 0;
        if (da * db <= 0 && t >= 0 && t <= 1) {
            double r = (a.x + t * (b.x - a.x)) * c + (a.y + t * (b.y - a.y)) * s;
            best = r > best ? r : best;
        }
    }
    return best;
}

// The cone of a rule over `nz` layers: least and largest reach over all azimuths, in mm.
static void measure_cone(const sf_rule *rule, const sf_lattice *lattice, double *least,
                         double *most)
{
    static point hull[1 << 13];
    sf_grid *grid;
    CHECK_EQ(sf_grid_create(lattice, NULL, &grid), SF_OK);
    for (uint32_t k = 0; k < lattice->nz; k++) {
        uint32_t x = lattice->nx / 2, y = lattice->ny / 2;
        sf_rect all = {0, 0, lattice->nx, lattice->ny}, one = {x, y, x + 1, y + 1};
        CHECK_EQ(sf_slice_fill(sf_grid_slice(grid, k), k > 0 ? all : one, 1), SF_OK);
    }
    CHECK_EQ(sf_grid_trim(grid, rule, 0, NULL, NULL), SF_OK);
    int count = hull_of(sf_grid_slice(grid, lattice->nz - 1), lattice, hull);
    *least = HUGE_VAL;
    *most = 0;
    for (int i = 0; i < AZIMUTHS; i++) {
        double a = i * 2 * 3.14159265358979323846 / AZIMUTHS;
        double r = radius(hull, count, cos(a), sin(a));
        *least = r < *least ? r : *least;
        *most = r > *most ? r : *most;
    }
    sf_grid_destroy(grid);
}

// A lattice in which the cone of this angle over `layers` layers has room.
static sf_lattice room_for(double degrees, double px, double py, double h, uint32_t layers)
{
    double reach = layers * h * tan(degrees / DEGREES);
    sf_lattice lattice = {0, 0, layers + 1, px, py, h, NULL, {0, 0, 0}};
    lattice.nx = 2 * (uint32_t)(reach / px + 14) + 1;
    lattice.ny = 2 * (uint32_t)(reach / py + 14) + 1;
    return lattice;
}

static void slack_is_exact(void)
{
    static const double asked[] = {5, 10, 20, 30, 40, 45, 50, 60, 70, 80, 85};
    static const double pixels[][3] = {
        {0.1, 0.1, 0.1}, {0.1, 0.1, 0.05}, {0.05, 0.08, 0.05}, {0.1, 0.033, 0.1}, {0.02, 0.2, 0.1}};
    printf("# rule     asked  pixel            layers  obtained, degrees\n");
    for (size_t p = 0; p < sizeof pixels / sizeof pixels[0]; p++) {
        for (size_t i = 0; i < sizeof asked / sizeof asked[0]; i++) {
            double px = pixels[p][0], py = pixels[p][1], h = pixels[p][2], least, most;
            double shorter = px < py ? px : py, slope = tan(asked[i] / DEGREES);
            uint32_t layers = slope * h / px < 0.5 ? 200 : slope * h / px < 1.5 ? 100 : 12;
            sf_lattice lattice = room_for(asked[i], px, py, h, layers);
            sf_rule rule;
            sf_rule_angles angles;
            if (sf_rule_make(SF_RULE_SLACK, asked[i] / DEGREES, &lattice, NULL, &rule, NULL) !=
                SF_OK) {
                CHECK(slope * h / shorter > 10); // and only then
                continue;
            }
            measure_cone(&rule, &lattice, &least, &most);
            double reach = layers * h * slope;
            double units = px < py ? rule.slack_x : rule.slack_y;
            double cap = rule.slack_cap / units * shorter;
            CHECK(most <= reach + cap + 1e-9);
            double part = px == py ? 0.97 : 0.93;
            CHECK(least >= part * reach - shorter);
            CHECK_EQ(sf_rule_measure(&rule, &lattice, &angles), SF_OK);
            CHECK_NEAR(angles.steepest_rad * DEGREES, asked[i], 1e-5);
            CHECK(tan(angles.axis_x_rad) <= slope + 1e-9 && tan(angles.axis_x_rad) > part * slope);
            CHECK(tan(angles.diagonal_rad) > part * slope);
            printf("# slack    %4.0f  %.2f x %.2f x %.2f %5u  %5.2f .. %5.2f\n", asked[i], px, py,
                   h, layers, atan(least / (layers * h)) * DEGREES,
                   atan(most / (layers * h)) * DEGREES);
        }
    }
}

static void octagon_and_disk_beside_it(void)
{
    static const double asked[] = {20, 30, 45, 60, 75};
    for (size_t i = 0; i < sizeof asked / sizeof asked[0]; i++) {
        for (int kind = SF_RULE_BOX3; kind <= SF_RULE_DISK; kind++) {
            uint32_t layers = asked[i] < 50 ? 100 : 30;
            double slope = tan(asked[i] / DEGREES), least, most;
            sf_lattice lattice = room_for(asked[i] < 46 ? 46 : asked[i], 0.1, 0.1, 0.1, layers);
            sf_rule rule;
            if (sf_rule_make((sf_rule_kind)kind, asked[i] / DEGREES, &lattice, NULL, &rule, NULL) !=
                SF_OK) {
                continue; // a disk of less than a voxel
            }
            measure_cone(&rule, &lattice, &least, &most);
            if (kind == SF_RULE_OCTAGON) {
                CHECK(most <= layers * 0.1 * slope + 0.1502);
                CHECK(least >= layers * 0.1 * slope * 0.9238 - 0.1502);
            }
            if (kind == SF_RULE_DISK) {
                CHECK(most <= layers * 0.1 * slope + 1e-9);
            }
            printf("# %-8s %4.0f  0.10 x 0.10 x 0.10 %5u  %5.2f .. %5.2f\n",
                   sf_rule_kind_name((sf_rule_kind)kind), asked[i], layers,
                   atan(least / (layers * 0.1)) * DEGREES, atan(most / (layers * 0.1)) * DEGREES);
        }
    }
}

// Heights that differ: the cone is that of their sum, whatever the order.
static void slack_over_layers_of_any_height(void)
{
    for (int i = 0; i < 6; i++) {
        double heights[61], sum = 0, least, most;
        static uint64_t table[122];
        for (int k = 0; k < 61; k++) {
            heights[k] = 0.05 + 0.1 * test_random_unit();
            sum += k < 60 ? heights[k] : 0;
        }
        double degrees = 20 + 8 * i, slope = tan(degrees / DEGREES);
        sf_lattice lattice = room_for(degrees, 0.1, 0.1, 0.15, 60);
        lattice.nz = 61;
        lattice.heights_mm = heights;
        sf_rule rule;
        CHECK_EQ(sf_rule_make(SF_RULE_SLACK, degrees / DEGREES, &lattice, table, &rule, NULL),
                 SF_OK);
        measure_cone(&rule, &lattice, &least, &most);
        CHECK(most <= sum * slope + rule.slack_cap * 0.1 / rule.slack_x + 1e-9);
        CHECK(least >= 0.97 * sum * slope - 0.1);
    }
}

// The rule is the same wherever the shape begins, but for the rounding of a unit.
static void slack_does_not_depend_on_where_it_starts(void)
{
    sf_lattice lattice = room_for(40, 0.1, 0.1, 0.1, 40);
    sf_rule rule;
    double first = 0;
    CHECK_EQ(sf_rule_make(SF_RULE_SLACK, 40 / DEGREES, &lattice, NULL, &rule, NULL), SF_OK);
    for (uint32_t bed = 0; bed < 8; bed++) {
        sf_lattice longer = lattice;
        sf_grid *grid;
        longer.nz += bed;
        CHECK_EQ(sf_grid_create(&longer, NULL, &grid), SF_OK);
        for (uint32_t k = bed; k < longer.nz; k++) {
            uint32_t x = longer.nx / 2, y = longer.ny / 2;
            sf_rect all = {0, 0, longer.nx, longer.ny}, one = {x, y, x + 1, y + 1};
            CHECK_EQ(sf_slice_fill(sf_grid_slice(grid, k), k > bed ? all : one, 1), SF_OK);
        }
        CHECK_EQ(sf_grid_trim(grid, &rule, bed, NULL, NULL), SF_OK);
        double area = (double)sf_slice_popcount(sf_grid_slice(grid, longer.nz - 1));
        first = bed == 0 ? area : first;
        CHECK(fabs(area - first) <= 0.03 * first);
        sf_grid_destroy(grid);
    }
}

// From one degree to the next nothing jumps, and every refusal says what to do.
static void every_angle_is_served(void)
{
    sf_lattice lattice = {8, 8, 8, 0.1, 0.1, 0.1, NULL, {0, 0, 0}};
    sf_rule rule;
    sf_fault fault;
    for (int i = 50; i <= 850; i++) {
        CHECK_EQ(sf_rule_make(SF_RULE_SLACK, i / 10.0 / DEGREES, &lattice, NULL, &rule, NULL),
                 SF_OK);
        CHECK(rule.slack_cap <= 254 && rule.slack_x >= 4 && rule.slack_y == rule.slack_x);
    }
    lattice.layer_mm = 2.0; // 228 voxels in one step
    CHECK_EQ(sf_rule_make(SF_RULE_SLACK, 85 / DEGREES, &lattice, NULL, &rule, &fault),
             SF_ERR_UNSUPPORTED);
    CHECK(strstr(fault.message, "rule disk") != NULL);
}

int main(void)
{
    TEST(slack_is_exact);
    TEST(octagon_and_disk_beside_it);
    TEST(slack_over_layers_of_any_height);
    TEST(slack_does_not_depend_on_where_it_starts);
    TEST(every_angle_is_served);
    return test_finish();
}
