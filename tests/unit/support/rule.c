// SPDX-License-Identifier: MIT
// Why: everything rests on the rule. That the octagon never lets a chain reach beyond the asked
// angle but for less than 1.502 voxel, over any window of layers of any heights (ALGORITHMS 1.6,
// 10.6, section 0 item 1), is the promise made to whoever gives an angle; that a lattice which a
// rule cannot serve is refused with a sentence is the promise made to everybody else.

#include "support/rule/rule.h"
#include "test.h"

#define DEGREE (3.14159265358979323846 / 180.0)
#define LAYERS 400

static sf_lattice lattice_of(double px, double py, double h, uint32_t nz, const double *heights)
{
    sf_lattice lattice = {64, 64, nz, px, py, h, heights, {0.0, 0.0, 0.0}};
    return lattice;
}

// How far m pluses and n squares reach, by summing them one after the other.
static sf_element summed(unsigned pluses, unsigned squares)
{
    sf_element total = {0, {0}}, plus = sf_element_plus3(), box = sf_element_box3();
    for (unsigned i = 0; i < pluses + squares; i++) {
        sf_element next;
        CHECK_EQ(sf_element_sum(&total, i < pluses ? &plus : &box, &next), SF_OK);
        total = next;
    }
    return total;
}

static int same(const sf_element *a, const sf_element *b)
{
    return a->reach_y == b->reach_y &&
           memcmp(a->half_width, b->half_width, (a->reach_y + 1u) * sizeof a->half_width[0]) == 0;
}

static void octagon_steps_are_sums_of_pluses_and_squares(void)
{
    for (int i = 0; i < 400; i++) {
        sf_rule rule = {.kind = SF_RULE_OCTAGON};
        rule.reach_x_q24 = rule.reach_y_q24 = test_random_below(30u << 24);
        sf_element element;
        CHECK_EQ(sf_rule_element(&rule, test_random_below(1000000), &element), SF_OK);
        unsigned axis = element.reach_y, squares = element.half_width[axis];
        CHECK(squares <= axis);
        sf_element expected = summed(axis - squares, squares);
        CHECK(same(&element, &expected));
    }
}

// Radial excess, in voxels, of the worst chain over any window of the stack's layers: the sum of
// the steps is an octagon with vertices (A, B), held against the reach by the C library's tangent.
static double worst_excess(const sf_rule *rule, const double *bottom, uint32_t layers, double slope)
{
    static double a[LAYERS], b[LAYERS];
    a[0] = b[0] = 0.0;
    for (uint32_t k = 0; k + 1 < layers; k++) {
        sf_element element;
        CHECK_EQ(sf_rule_element(rule, k, &element), SF_OK);
        a[k + 1] = a[k] + element.half_width[0];
        b[k + 1] = b[k] + element.half_width[element.reach_y];
        CHECK_EQ(element.half_width[0], element.reach_y);
    }
    double worst = -1e9;
    for (uint32_t i = 0; i + 1 < layers; i++) {
        for (uint32_t j = i + 1; j < layers; j++) {
            double A = a[j] - a[i], B = b[j] - b[i];
            double excess = sqrt(A * A + B * B) - (bottom[j] - bottom[i]) * slope;
            worst = excess > worst ? excess : worst;
        }
    }
    return worst;
}

static double stack_excess(double degrees, double pitch, double h, const double *heights,
                           uint32_t layers)
{
    static double bottom[LAYERS];
    static uint64_t table[2 * LAYERS];
    sf_lattice lattice = lattice_of(pitch, pitch, h, layers, heights);
    sf_rule rule;
    sf_fault fault;
    double angle = degrees * DEGREE;
    sf_status status = sf_rule_make(SF_RULE_OCTAGON, angle, &lattice, table, &rule, &fault);
    CHECK_EQ(status, SF_OK);
    if (status != SF_OK) {
        return 0.0;
    }
    bottom[0] = 0.0;
    for (uint32_t k = 1; k < layers; k++) {
        bottom[k] = bottom[k - 1] + (heights != NULL ? heights[k - 1] : h);
    }
    return worst_excess(&rule, bottom, layers, tan(angle) / pitch);
}

static void octagon_excess_over_uniform_layers(void)
{
    static const double ratios[] = {0.1, 0.25, 0.5, 1.0, 1.0582, 2.0, 3.7};
    double worst = -1e9;
    for (int degrees = 5; degrees <= 85; degrees++) {
        for (size_t i = 0; i < sizeof ratios / sizeof ratios[0]; i++) {
            double excess = stack_excess(degrees, 0.1, 0.1 * ratios[i], NULL, 150);
            worst = excess > worst ? excess : worst;
        }
    }
    printf("# uniform layers, 5 to 85 degrees: worst excess %.4f voxel\n", worst);
    CHECK(worst < 1.502);
    CHECK(worst > 1.0);
}

static void octagon_excess_over_random_layers(void)
{
    static double heights[LAYERS];
    double worst = -1e9;
    for (int i = 0; i < 250; i++) {
        double degrees = 5.0 + 80.0 * test_random_unit();
        double spread = test_random_unit() * 4.0;
        for (int k = 0; k < LAYERS; k++) {
            heights[k] =
                0.02 * ldexp(1.0, (int)test_random_below(2)) * (0.2 + spread * test_random_unit());
        }
        double excess = stack_excess(degrees, 0.05, 0.0, heights, 200);
        worst = excess > worst ? excess : worst;
    }
    printf("# random layers: worst excess %.4f voxel\n", worst);
    CHECK(worst < 1.502);
}

// Chains really walked, voxel by voxel, not only the corners of the sums.
static void octagon_chains_stay_in_the_cone(void)
{
    for (int i = 0; i < 200; i++) {
        double degrees = 5.0 + 75.0 * test_random_unit();
        sf_lattice lattice = lattice_of(0.1, 0.1, 0.1, 300, NULL);
        sf_rule rule;
        CHECK_EQ(sf_rule_make(SF_RULE_OCTAGON, degrees * DEGREE, &lattice, NULL, &rule, NULL),
                 SF_OK);
        double slope = tan(degrees * DEGREE), direction = test_random_unit() * 6.2832;
        double ux = cos(direction), uy = sin(direction);
        uint32_t start = test_random_below(100);
        int x = 0, y = 0;
        for (uint32_t k = start; k < start + 200; k++) {
            sf_element e;
            CHECK_EQ(sf_rule_element(&rule, k, &e), SF_OK);
            int best_x = 0, best_y = 0;
            for (int dy = -(int)e.reach_y; dy <= (int)e.reach_y; dy++) {
                int w = e.half_width[dy < 0 ? -dy : dy];
                int dx = ux < 0 ? -w : w;
                if (dx * ux + dy * uy > best_x * ux + best_y * uy) {
                    best_x = dx;
                    best_y = dy;
                }
            }
            x += best_x;
            y += best_y;
            CHECK(sqrt((double)x * x + (double)y * y) < (k + 1 - start) * slope + 1.502);
        }
    }
}

// What the octagon obtains, as numbers to look at; and its lower end, which is promised too: the
// sides of the octagon are at cos(22.5 degrees) of the reach, rounding takes less than a voxel.
static void octagon_obtained_angles(void)
{
    static const double asked[] = {20, 30, 40, 45, 50, 60, 70};
    static const uint32_t lengths[] = {10, 50, 200};
    printf("# octagon: asked, h/p, layers: obtained on axes, at most at vertices (degrees)\n");
    for (size_t i = 0; i < 7; i++) {
        for (int half = 0; half < 2; half++) {
            double ratio = half ? 0.5 : 1.0, slope = tan(asked[i] * DEGREE);
            sf_lattice lattice = lattice_of(1.0, 1.0, ratio, 500, NULL);
            sf_rule rule;
            CHECK_EQ(sf_rule_make(SF_RULE_OCTAGON, asked[i] * DEGREE, &lattice, NULL, &rule, NULL),
                     SF_OK);
            for (size_t l = 0; l < 3; l++) {
                double least = 1e9, most = 0.0, length = lengths[l] * ratio;
                for (uint32_t start = 0; start < 100; start++) {
                    double a = 0.0, b = 0.0;
                    for (uint32_t k = start; k < start + lengths[l]; k++) {
                        sf_element e;
                        CHECK_EQ(sf_rule_element(&rule, k, &e), SF_OK);
                        a += e.reach_y;
                        b += e.half_width[e.reach_y];
                    }
                    least = a < least ? a : least;
                    double radius = sqrt(a * a + b * b);
                    most = radius > most ? radius : most;
                }
                CHECK(least > 0.92387 * slope * length - 1.0);
                CHECK(most < slope * length + 1.502);
                printf("#   %2.0f  %3.1f  %3u: %5.2f  %5.2f\n", asked[i], ratio, lengths[l],
                       atan(least / length) / DEGREE, atan(most / length) / DEGREE);
            }
        }
    }
}

static void forty_five_degrees_on_cubes_is_one(void)
{
    static const double pitches[] = {0.1, 0.05, 0.3, 0.04725, 1.0 / 3.0, 25.4 / 300.0};
    for (size_t i = 0; i < sizeof pitches / sizeof pitches[0]; i++) {
        for (int ulp = -2; ulp <= 2; ulp++) {
            sf_lattice lattice = lattice_of(pitches[i], pitches[i], pitches[i], 10, NULL);
            lattice.layer_mm += ulp * ldexp(lattice.layer_mm, -52);
            sf_rule rule;
            CHECK_EQ(sf_rule_make(SF_RULE_DISK, 45.0 * DEGREE, &lattice, NULL, &rule, NULL), SF_OK);
            CHECK_EQ(rule.reach_x_q24, SFI_REACH_ONE);
            sf_element element, plus = sf_element_plus3();
            CHECK_EQ(sf_rule_element(&rule, 3, &element), SF_OK);
            CHECK(same(&element, &plus));
        }
    }
}

// Many equal layers given one by one are the same rule as one height for all. (The one rounds down
// each layer's reach, the other each step's; at these angles no element falls between.)
static void table_of_equal_heights_is_the_uniform_rule(void)
{
    static double heights[3000];
    static uint64_t table[6000];
    for (int k = 0; k < 3000; k++) {
        heights[k] = 0.05;
    }
    for (int degrees = 5; degrees <= 85; degrees += 5) {
        sf_lattice listed = lattice_of(0.1, 0.1, 0.0, 3000, heights);
        sf_lattice uniform = lattice_of(0.1, 0.1, 0.05, 3000, NULL);
        CHECK_EQ(sf_rule_table_count(&listed), 6000);
        CHECK_EQ(sf_rule_table_count(&uniform), 0);
        for (int kind = SF_RULE_OCTAGON; kind <= SF_RULE_DISK; kind++) {
            sf_rule a, b;
            double angle = degrees * DEGREE;
            sf_status status = sf_rule_make((sf_rule_kind)kind, angle, &listed, table, &a, NULL);
            CHECK_EQ(sf_rule_make((sf_rule_kind)kind, angle, &uniform, NULL, &b, NULL), status);
            for (uint32_t k = 0; status == SF_OK && k + 1 < 3000; k++) {
                sf_element ea, eb;
                CHECK_EQ(sf_rule_element(&a, k, &ea), SF_OK);
                CHECK_EQ(sf_rule_element(&b, k, &eb), SF_OK);
                CHECK(same(&ea, &eb));
            }
        }
    }
}

static void disk_is_the_ellipse_in_millimetres(void)
{
    for (int i = 0; i < 300; i++) {
        double px = 0.02 + 0.1 * test_random_unit(), py = 0.02 + 0.1 * test_random_unit();
        double h = 0.05 + 0.3 * test_random_unit(),
               angle = (20.0 + 50.0 * test_random_unit()) * DEGREE;
        sf_lattice lattice = lattice_of(px, py, h, 5, NULL);
        sf_rule rule;
        double rx = h * tan(angle) / px, ry = h * tan(angle) / py;
        sf_status status = sf_rule_make(SF_RULE_DISK, angle, &lattice, NULL, &rule, NULL);
        CHECK_EQ(status, rx >= 1.0 && ry >= 1.0 ? SF_OK : SF_ERR_UNSUPPORTED);
        sf_element e;
        if (status != SF_OK || sf_rule_element(&rule, 0, &e) != SF_OK) {
            continue;
        }
        for (int y = 0; y <= (int)ry + 1; y++) {
            for (int x = 0; x <= (int)rx + 1; x++) {
                double level = x / rx * (x / rx) + y / ry * (y / ry);
                int inside = y <= (int)e.reach_y && x <= (int)e.half_width[y];
                // Rounding down to 1/65536 voxel may lose what lies on the very edge.
                CHECK(inside ? level <= 1.0 + 1e-9 : level > 1.0 - 1e-4);
            }
        }
    }
}

static void angles_that_rules_allow(void)
{
    sf_lattice cubes = lattice_of(0.1, 0.1, 0.1, 50, NULL);
    sf_rule rule = sf_rule_box3();
    sf_rule_angles angles;
    CHECK_EQ(sf_rule_measure(&rule, &cubes, &angles), SF_OK);
    CHECK_NEAR(angles.axis_x_rad / DEGREE, 45.0, 1e-12);
    CHECK_NEAR(angles.axis_y_rad / DEGREE, 45.0, 1e-12);
    CHECK_NEAR(angles.diagonal_rad / DEGREE, 54.735610317245346, 1e-12);
    CHECK_NEAR(angles.steepest_rad / DEGREE, 54.735610317245346, 1e-12);

    sf_lattice flat = lattice_of(0.03, 0.05, 0.1, 50, NULL);
    CHECK_EQ(sf_rule_measure(&rule, &flat, &angles), SF_OK);
    CHECK_NEAR(angles.axis_x_rad, atan(0.3), 1e-15);
    CHECK_NEAR(angles.axis_y_rad, atan(0.5), 1e-15);
    CHECK_NEAR(angles.diagonal_rad, atan(sqrt(0.3 * 0.3 + 0.5 * 0.5)), 1e-15);

    // Heights that differ: the least that holds in every layer, the most that occurs in any.
    double heights[4] = {0.1, 0.2, 0.05, 9.0};
    sf_lattice uneven = lattice_of(0.1, 0.1, 0.0, 4, heights);
    CHECK_EQ(sf_rule_measure(&rule, &uneven, &angles), SF_OK);
    CHECK_NEAR(angles.axis_x_rad, atan(0.5), 1e-15);
    CHECK_NEAR(angles.steepest_rad, atan(sqrt(8.0)), 1e-15);

    uint64_t table[8];
    CHECK_EQ(sf_rule_make(SF_RULE_OCTAGON, 0.7, &cubes, NULL, &rule, NULL), SF_OK);
    CHECK_EQ(sf_rule_measure(&rule, &cubes, &angles), SF_OK);
    CHECK_NEAR(angles.steepest_rad, 0.7, 1e-6);
    CHECK_NEAR(angles.axis_x_rad, atan(0.9238795 * tan(0.7)), 1e-6);
    CHECK_EQ(sf_rule_measure(&rule, &uneven, &angles), SF_ERR_SHAPE);
    CHECK_EQ(sf_rule_make(SF_RULE_OCTAGON, 0.7, &uneven, table, &rule, NULL), SF_OK);
    CHECK_EQ(sf_rule_measure(&rule, &uneven, &angles), SF_OK);
    CHECK_NEAR(angles.steepest_rad, 0.7, 1e-6);

    // A plus has its diagonal at half a voxel: the hull counts, not the lattice point.
    CHECK_EQ(sf_rule_make(SF_RULE_DISK, 45.0 * DEGREE, &cubes, NULL, &rule, NULL), SF_OK);
    CHECK_EQ(sf_rule_measure(&rule, &cubes, &angles), SF_OK);
    CHECK_NEAR(angles.diagonal_rad, atan(sqrt(0.5)), 1e-15);
    CHECK_NEAR(angles.steepest_rad, atan(1.0), 1e-15);
}

static void refused(sf_rule_kind kind, double angle, sf_lattice lattice, sf_status expected,
                    const char *word)
{
    uint64_t table[64];
    memset(table, 0x5a, sizeof table);
    sf_rule rule, before;
    memset(&rule, 0x5a, sizeof rule);
    before = rule;
    sf_fault fault = {SF_OK, 0, 0, ""};
    CHECK_EQ(sf_rule_make(kind, angle, &lattice, table, &rule, &fault), expected);
    CHECK_EQ(fault.status, expected);
    CHECK(strstr(fault.message, word) != NULL);
    CHECK(memcmp(&rule, &before, sizeof rule) == 0);
    for (int i = 0; i < 64; i++) {
        CHECK(table[i] == 0x5a5a5a5a5a5a5a5au);
    }
    CHECK_EQ(sf_rule_make(kind, angle, &lattice, table, &rule, NULL), expected);
}

static void refusals_say_what_to_do(void)
{
    double heights[3] = {0.1, 0.01, 0.1};
    sf_lattice square = lattice_of(0.1, 0.1, 0.1, 3, NULL);
    sf_lattice oblong = lattice_of(0.1, 0.05, 0.1, 3, NULL);
    sf_lattice thin = lattice_of(0.1, 0.1, 0.0, 3, heights);
    sf_lattice fine = lattice_of(0.0001, 0.0001, 0.1, 3, NULL);
    sf_lattice broken = lattice_of(0.0, 0.1, 0.1, 3, NULL);
    refused(SF_RULE_OCTAGON, 0.7, oblong, SF_ERR_UNSUPPORTED, "rule slack or disk");
    refused(SF_RULE_DISK, 0.7, oblong, SF_ERR_UNSUPPORTED, "along x of at most 84 micrometres");
    refused(SF_RULE_DISK, 0.9, thin, SF_ERR_UNSUPPORTED, "layer 1; use the rule octagon");
    refused(SF_RULE_OCTAGON, 0.7, fine, SF_ERR_UNSUPPORTED, "255 voxels");
    refused(SF_RULE_DISK, 1.48, fine, SF_ERR_UNSUPPORTED, "255 voxels");
    refused(SF_RULE_OCTAGON, 4.9 * DEGREE, square, SF_ERR_ARGUMENT, "5 and 85");
    refused(SF_RULE_DISK, 85.1 * DEGREE, square, SF_ERR_ARGUMENT, "from the vertical");
    refused(SF_RULE_OCTAGON, -0.7, square, SF_ERR_ARGUMENT, "5 and 85");
    refused(SF_RULE_OCTAGON, HUGE_VAL, square, SF_ERR_ARGUMENT, "5 and 85");
    refused(SF_RULE_OCTAGON, HUGE_VAL - HUGE_VAL, square, SF_ERR_ARGUMENT, "5 and 85");
    refused((sf_rule_kind)7, 0.7, square, SF_ERR_ARGUMENT, "no rule");
    refused(SF_RULE_BOX3, 0.7, broken, SF_ERR_ARGUMENT, "lattice");
}

static void bounds_of_the_angle_are_accepted(void)
{
    sf_lattice lattice = lattice_of(0.1, 0.1, 0.1, 3, NULL);
    sf_rule rule;
    CHECK_EQ(sf_rule_make(SF_RULE_OCTAGON, 5.0 * DEGREE, &lattice, NULL, &rule, NULL), SF_OK);
    CHECK_EQ(sf_rule_make(SF_RULE_OCTAGON, 85.0 * DEGREE, &lattice, NULL, &rule, NULL), SF_OK);
    CHECK_EQ(sf_rule_make(SF_RULE_BOX3, HUGE_VAL - HUGE_VAL, &lattice, NULL, &rule, NULL), SF_OK);
    CHECK_EQ(rule.kind, SF_RULE_BOX3);
}

static void elements_of_broken_rules_are_refused(void)
{
    uint64_t table[8] = {0, 1 << 24, 0, 3 << 24, 0, 0, 0, 0};
    sf_element element;
    sf_rule none = {.kind = (sf_rule_kind)9};
    sf_rule falling = {.kind = SF_RULE_OCTAGON, .table_count = 4, .table = table};
    sf_rule lopsided = {.kind = SF_RULE_OCTAGON, .reach_x_q24 = 5, .reach_y_q24 = 6};
    sf_rule endless = {
        .kind = SF_RULE_DISK, .reach_x_q24 = (uint64_t)256 << 24, .reach_y_q24 = 1 << 24};
    sf_rule lost = {.kind = SF_RULE_DISK, .table_count = 4};
    CHECK_EQ(sf_rule_element(&none, 0, &element), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_rule_element(&falling, 0, &element), SF_OK);
    CHECK_EQ(sf_rule_element(&falling, 1, &element), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_rule_element(&falling, 3, &element), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_rule_element(&lopsided, 0, &element), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_rule_element(&endless, 0, &element), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_rule_element(&lost, 0, &element), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_rule_element(NULL, 0, &element), SF_ERR_ARGUMENT);
    sf_rule box = sf_rule_box3();
    CHECK_EQ(sf_rule_element(&box, 0, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_rule_element(&box, SF_LAYER_MAX, &element), SF_ERR_ARGUMENT);
    CHECK_EQ(sfi_rule_check(&falling, 0, 2), SF_OK);
    CHECK_EQ(sfi_rule_check(&falling, 0, 3), SF_ERR_ARGUMENT);
    CHECK_EQ(sfi_rule_check(&box, 5, SF_LAYER_MAX - 5), SF_OK);
    CHECK_EQ(sfi_rule_check(&box, 5, SF_LAYER_MAX), SF_ERR_ARGUMENT);
}

// Wherever the phase stands, up to the last layer there can be.
static void schedule_holds_at_the_far_end(void)
{
    sf_rule rule = {.kind = SF_RULE_OCTAGON};
    for (int i = 0; i < 2000; i++) {
        rule.reach_x_q24 = rule.reach_y_q24 = test_random_below(255) * SFI_REACH_ONE + 12345;
        sf_element element;
        uint32_t k = SF_LAYER_MAX - 1 - test_random_below(1000);
        CHECK_EQ(sf_rule_element(&rule, k, &element), SF_OK);
        double rho = (double)rule.reach_x_q24 * 0x1p-24;
        CHECK_NEAR(element.reach_y, 0.9238795 * rho, 1.0);
        CHECK_NEAR(element.half_width[element.reach_y], 0.3826834 * rho, 1.5);
    }
}

static void names(void)
{
    CHECK_STR(sf_rule_kind_name(SF_RULE_BOX3), "box3");
    CHECK_STR(sf_rule_kind_name(SF_RULE_OCTAGON), "octagon");
    CHECK_STR(sf_rule_kind_name(SF_RULE_DISK), "disk");
    CHECK_STR(sf_rule_kind_name(SF_RULE_SLACK), "slack");
    CHECK_STR(sf_rule_kind_name((sf_rule_kind)77), "unknown");
}

static void kinds_of_names(void)
{
    const char *const said[] = {"box3", "octagon", "disk", "slack"};
    for (int i = 0; i < 4; i++) {
        sf_rule_kind kind = (sf_rule_kind)77;
        CHECK_EQ(sf_rule_kind_from_name(said[i], &kind), SF_OK);
        CHECK_STR(sf_rule_kind_name(kind), said[i]);
    }
    const char *const none[] = {"", "box", "box33", "Disk", "unknown", " slack", NULL};
    for (int i = 0; i < 7; i++) {
        sf_rule_kind kind = (sf_rule_kind)77;
        CHECK_EQ(sf_rule_kind_from_name(none[i], &kind), SF_ERR_ARGUMENT);
        CHECK_EQ((int)kind, 77);
    }
    CHECK_EQ(sf_rule_kind_from_name("disk", NULL), SF_ERR_ARGUMENT);
}

int main(void)
{
    TEST(octagon_steps_are_sums_of_pluses_and_squares);
    TEST(octagon_excess_over_uniform_layers);
    TEST(octagon_excess_over_random_layers);
    TEST(octagon_chains_stay_in_the_cone);
    TEST(octagon_obtained_angles);
    TEST(forty_five_degrees_on_cubes_is_one);
    TEST(table_of_equal_heights_is_the_uniform_rule);
    TEST(disk_is_the_ellipse_in_millimetres);
    TEST(angles_that_rules_allow);
    TEST(refusals_say_what_to_do);
    TEST(bounds_of_the_angle_are_accepted);
    TEST(elements_of_broken_rules_are_refused);
    TEST(schedule_holds_at_the_far_end);
    TEST(names);
    TEST(kinds_of_names);
    return test_finish();
}
