// SPDX-License-Identifier: MIT
// Why: a printer's processor runs this checker from a library that has neither malloc nor floating
// point. The program links libsf-core alone, gives it memory from a static array, pushes shapes in
// all three forms and holds every count against a judgement voxel by voxel (TRUST 1 to 3).

#include "test.h"

#include <sf/support.h>

#define N 11
#define LAYERS 6

typedef struct shape {
    uint8_t solid[LAYERS][N][N];
} shape;

// The checker's only memory, with room to align it.
static unsigned char memory[32768];

static void *aligned_memory(void)
{
    return memory + (64 - (uintptr_t)memory % 64) % 64;
}

// A rule as a host would hand it to a chip: integers, worked out beforehand.
static sf_rule octagon(uint64_t reach_q24)
{
    sf_rule rule = {.kind = SF_RULE_OCTAGON, .reach_x_q24 = reach_q24, .reach_y_q24 = reach_q24};
    return rule;
}

static int is_carried(const shape *s, int z, int y, int x, const sf_element *element)
{
    for (int dy = -(int)element->reach_y; dy <= (int)element->reach_y; dy++) {
        int w = element->half_width[dy < 0 ? -dy : dy];
        for (int dx = -w; dx <= w; dx++) {
            int v = y + dy, u = x + dx;
            if (v >= 0 && v < N && u >= 0 && u < N && s->solid[z - 1][v][u]) {
                return 1;
            }
        }
    }
    return 0;
}

// What the report must say, and the trim itself in *kept.
static void judge(const shape *s, const sf_rule *rule, sf_check_report *report, shape *kept)
{
    int on_bed = 1;
    *kept = *s;
    for (int z = 0; z < LAYERS; z++) {
        sf_element element = {0, {0}};
        CHECK_EQ(z > 0 ? sf_rule_element(rule, (uint32_t)z - 1, &element) : SF_OK, SF_OK);
        int matter = 0;
        for (int i = 0; i < N * N; i++) {
            int y = i / N, x = i % N;
            if (!s->solid[z][y][x]) {
                continue;
            }
            matter = 1;
            report->solid_voxels++;
            if (on_bed) {
                continue;
            }
            report->unsupported_voxels += !is_carried(s, z, y, x, &element);
            kept->solid[z][y][x] = (uint8_t)is_carried(kept, z, y, x, &element);
            report->trimmed_voxels += !kept->solid[z][y][x];
        }
        on_bed = on_bed && !matter;
    }
}

static void push_bits(sf_checker *checker, const shape *s, int z)
{
    uint64_t words[N];
    sf_slice slice = {words, N, N, 1};
    for (int y = 0; y < N; y++) {
        words[y] = 0;
        for (int x = 0; x < N; x++) {
            words[y] |= (uint64_t)s->solid[z][y][x] << x;
        }
    }
    CHECK_EQ(sf_checker_push(checker, slice), SF_OK);
}

static void push_runs(sf_checker *checker, const shape *s, int z)
{
    sf_run runs[N * N];
    size_t count = 0;
    for (uint32_t y = 0; y < N; y++) {
        for (uint32_t x = 0; x < N; x++) {
            if (s->solid[z][y][x]) {
                sf_run run = {x, x + 1, y, 0};
                runs[count++] = run;
            }
        }
    }
    CHECK_EQ(sf_checker_push_runs(checker, runs, count), SF_OK);
}

static void push_layer(sf_checker *checker, const shape *s, int z, int form)
{
    if (form == 0) {
        push_bits(checker, s, z);
    } else if (form == 1) {
        push_runs(checker, s, z);
    } else {
        CHECK_EQ(sf_checker_push_grey(checker, &s->solid[z][0][0], N, 1), SF_OK);
    }
}

static void try_shape(const shape *s, const sf_rule *rule)
{
    sf_check_report right = {0};
    shape kept;
    judge(s, rule, &right, &kept);
    for (int form = 0; form < 3; form++) {
        sf_finding findings[64];
        sf_check_options options = sf_check_options_default();
        options.rule = *rule;
        options.width = N;
        options.height = N;
        options.findings = findings;
        options.finding_capacity = 64;
        options.run_capacity = N * N;
        size_t size = 0, count = 0;
        sf_checker *checker = NULL;
        CHECK_EQ(sf_checker_size(&options, &size), SF_OK);
        CHECK(size <= sizeof memory - 64);
        CHECK_EQ(sf_checker_place(&options, aligned_memory(), size, &checker), SF_OK);
        for (int z = 0; z < LAYERS && checker != NULL; z++) {
            push_layer(checker, s, z, form);
        }
        sf_check_report report;
        CHECK_EQ(sf_checker_report(checker, &report, &count), SF_OK);
        CHECK_EQ(report.solid_voxels, right.solid_voxels);
        CHECK_EQ(report.unsupported_voxels, right.unsupported_voxels);
        CHECK_EQ(report.trimmed_voxels, right.trimmed_voxels);
        CHECK_EQ(report.support_free, right.unsupported_voxels == 0);
        uint64_t blamed = report.unlinked_voxels;
        for (size_t i = 0; i < count; i++) {
            blamed += findings[i].volume;
        }
        CHECK_EQ(blamed, right.trimmed_voxels);
    }
}

static void random_shape(shape *s, uint32_t percent)
{
    for (int i = 0; i < LAYERS * N * N; i++) {
        s->solid[i / (N * N)][i / N % N][i % N] = test_random_below(100) < percent;
    }
}

// A column with a table top: the top's rim is unsupported, the column is not.
static void a_table(void)
{
    shape s;
    memset(&s, 0, sizeof s);
    for (int z = 0; z < LAYERS - 1; z++) {
        s.solid[z][N / 2][N / 2] = 1;
    }
    memset(s.solid[LAYERS - 1], 1, sizeof s.solid[0]);
    sf_rule rule = sf_rule_box3();
    sf_check_report right = {0};
    shape kept;
    judge(&s, &rule, &right, &kept);
    CHECK_EQ(right.unsupported_voxels, N * N - 9);
    try_shape(&s, &rule);
}

static void random_shapes(void)
{
    for (int round = 0; round < 200; round++) {
        shape s;
        random_shape(&s, 1 + test_random_below(60));
        uint64_t reach = ((uint64_t)1 << 23) + (test_random() >> 39);
        sf_rule rules[2] = {sf_rule_box3(), octagon(reach)};
        try_shape(&s, &rules[round % 2]);
    }
}

// Memory one byte short is refused, and nothing is written into it.
static void too_little_memory(void)
{
    sf_check_options options = sf_check_options_default();
    options.width = N;
    options.height = N;
    size_t size = 0;
    sf_checker *checker = NULL;
    CHECK_EQ(sf_checker_size(&options, &size), SF_OK);
    memset(memory, 0x5a, sizeof memory);
    CHECK_EQ(sf_checker_place(&options, aligned_memory(), size - 1, &checker), SF_ERR_CAPACITY);
    CHECK(checker == NULL);
    for (size_t i = 0; i < sizeof memory; i++) {
        CHECK(memory[i] == 0x5a);
    }
}

int main(void)
{
    TEST(a_table);
    TEST(random_shapes);
    TEST(too_little_memory);
    return test_finish();
}
