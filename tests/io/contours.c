// SPDX-License-Identifier: MIT
// CLI files: what is written is read again, in text to the same doubles and in binary to the same
// floats; short numbers, alignment, comments, open lines and hatches are what the format says;
// polygons turn as they say; the file of shared/data is what TRUTH.md says. Files that lie or end
// early are refused with a sentence, and nothing stays behind when memory runs out.
// Guards: issue 8 part 3; TRUST B3, B6, B10, B15, B16, 79.

#include <sf/contour_io.h>
#include <sf/sf.h>

#include "failing_allocator.h"
#include "test.h"

typedef struct text {
    unsigned char bytes[65536];
    size_t size;
} text;

static sf_status put(void *user, const void *data, size_t size)
{
    text *t = user;
    if (t->size + size > sizeof t->bytes) {
        return SF_ERR_IO;
    }
    memcpy(t->bytes + t->size, data, size);
    t->size += size;
    return SF_OK;
}

static sf_status read_bytes(const void *bytes, size_t size, const sf_read_limits *limits,
                            const sf_allocator *allocator, sf_contour_stack **stack,
                            sf_fault *fault)
{
    sf_memory_cursor cursor = {bytes, size, 0};
    sf_fault none = {SF_OK, 0, 0, ""};
    *fault = none;
    *stack = NULL;
    sf_status status =
        sf_contour_stack_read(sf_memory_source(&cursor), limits, allocator, stack, fault);
    CHECK((status == SF_OK) == (*stack != NULL));
    CHECK(status == SF_OK || (fault->status == status && strlen(fault->message) > 10));
    return status;
}

static sf_contour_stack *random_stack(void)
{
    sf_contour_stack *stack = NULL;
    double top = test_random_unit() - 0.5;
    double step = 0.1 + test_random_unit();
    CHECK_EQ(sf_contour_stack_create(top, NULL, &stack), SF_OK);
    for (int k = 0; k < 5; k++) {
        double p[60];
        size_t starts[6] = {0};
        for (int i = 0; i < 60; i++) {
            p[i] = (test_random_unit() - 0.5) * 100;
        }
        for (int i = 1; i < 6; i++) {
            starts[i] = starts[i - 1] + 3 + test_random_below(4);
        }
        sf_contours c = {p, starts, test_random_below(6)};
        top += step;
        CHECK_EQ(sf_contour_stack_add(stack, top, &c, NULL), SF_OK);
    }
    return stack;
}

static int same(const sf_contour_stack *a, const sf_contour_stack *b, double tolerance)
{
    int good = sf_contour_stack_count(a) == sf_contour_stack_count(b);
    for (uint32_t k = 0; good && k < sf_contour_stack_count(a); k++) {
        sf_contours p, q;
        double tops[2];
        CHECK_EQ(sf_contour_stack_layer(a, k, &p, NULL, &tops[0]), SF_OK);
        CHECK_EQ(sf_contour_stack_layer(b, k, &q, NULL, &tops[1]), SF_OK);
        good = p.contour_count == q.contour_count && fabs(tops[0] - tops[1]) <= tolerance;
        for (size_t i = 0; good && i < p.contour_count; i++) {
            good = p.starts[i + 1] == q.starts[i + 1];
            for (size_t n = 2 * p.starts[i]; good && n < 2 * p.starts[i + 1]; n++) {
                good = fabs(p.points_mm[n] - q.points_mm[n]) <= tolerance;
            }
        }
    }
    return good;
}

static void round_trips(void)
{
    static text t;
    for (int round = 0; round < 60; round++) {
        sf_contour_stack *stack = random_stack(), *back = NULL;
        sf_sink sink = {put, &t};
        sf_fault fault;
        int binary = round % 2;
        t.size = 0;
        CHECK_EQ(sf_contour_stack_write(stack, (sf_contour_format)binary, sink), SF_OK);
        CHECK_EQ(read_bytes(t.bytes, t.size, NULL, NULL, &back, &fault), SF_OK);
        CHECK_STR(fault.message, "");
        CHECK(same(stack, back, binary ? 1e-5 : 0));
        sf_contour_stack_destroy(stack);
        sf_contour_stack_destroy(back);
    }
}

static const char small[] =
    "$$HEADERSTART\n// made by\nhand // $$ASCII\r\n$$UNITS/0.5 $$VERSION/200\n$$LABEL/1,a part\n"
    "$$LAYERS/2\n$$HEADEREND\n$$GEOMETRYSTART\n$$LAYER/2\n"
    "$$POLYLINE/1,1,4,0,0,0,4,4,4,4,0\n" // an outside that turns to the right
    "$$POLYLINE/1, 0, 4, 1,1, 3,1, 3,3, 1,3\n$$POLYLINE/1,2,2,9,9,8,8\n"
    "$$HATCHES/1,1,0,0,1,1\n$$LAYER/3.5\n$$GEOMETRYEND\n";

static void what_a_file_says(void)
{
    sf_contour_stack *stack = NULL;
    sf_fault fault;
    sf_contours c;
    double bottom, top;
    CHECK_EQ(read_bytes(small, strlen(small), NULL, NULL, &stack, &fault), SF_OK);
    CHECK_STR(fault.message, "");
    CHECK_EQ(sf_contour_stack_count(stack), 2);
    CHECK_EQ(sf_contour_stack_layer(stack, 0, &c, &bottom, &top), SF_OK);
    CHECK(bottom == 0.25 && top == 1.0 && c.contour_count == 2);
    CHECK_EQ(sf_contours_area_mm2(&c), 4 - 1);
    CHECK_EQ(sf_contour_stack_layer(stack, 1, &c, NULL, &top), SF_OK);
    CHECK(top == 1.75 && c.contour_count == 0);
    sf_contour_stack_destroy(stack);
}

static void put16(text *t, unsigned value)
{
    unsigned char b[2] = {(unsigned char)value, (unsigned char)(value >> 8)};
    (void)put(t, b, 2);
}

static void short_numbers_and_alignment(void)
{
    static text t;
    for (int aligned = 0; aligned < 2; aligned++) {
        static const unsigned square[8] = {0, 0, 40, 0, 40, 40, 0, 40};
        const char *head = aligned ? "$$HEADERSTART\n$$BINARY\n$$UNITS/0.1\n$$ALIGN\n$$HEADEREND"
                                   : "$$HEADERSTART\n$$BINARY\n$$UNITS/0.1\n$$HEADEREND";
        sf_contour_stack *stack = NULL;
        sf_fault fault;
        sf_contours c;
        double top;
        t.size = 0;
        (void)put(&t, head, strlen(head));
        for (unsigned k = 1; k < 3; k++) {
            put16(&t, 128);
            for (int i = 0; i < aligned; i++) {
                put16(&t, 0);
            }
            put16(&t, 10 * k);
            put16(&t, 131);
            for (int i = 0; i < aligned; i++) {
                put16(&t, 0);
            }
            put16(&t, 1);
            put16(&t, 1);
            for (int i = 0; i < 4; i++) {
                put16(&t, 77);
            }
            put16(&t, 129);
            for (int i = 0; i < aligned; i++) {
                put16(&t, 0);
            }
            put16(&t, 1);
            put16(&t, 1);
            put16(&t, 4);
            for (int i = 0; i < 8; i++) {
                put16(&t, square[i]);
            }
        }
        CHECK_EQ(read_bytes(t.bytes, t.size, NULL, NULL, &stack, &fault), SF_OK);
        CHECK_STR(fault.message, "");
        CHECK_EQ(sf_contour_stack_layer(stack, 1, &c, NULL, &top), SF_OK);
        CHECK_EQ(top, 2);
        CHECK_NEAR(sf_contours_area_mm2(&c), 16, 1e-12);
        sf_contour_stack_destroy(stack);
    }
}

static void files_that_lie(void)
{
    static const struct {
        const char *from, *to, *words;
    } cases[] = {
        {"LAYERS/2", "LAYERS/3", "the head says 3 layers"},
        {"LAYER/3.5", "LAYER/1.5", "below the one before"},
        {"LAYER/3.5", "LAYER/nan", "a number"},
        {"LAYER/3.5", "LAYER/1e3", ""}, // good
        {"1,1,4,0", "1,1,5,0", "a comma was expected"},
        {"1,1,4,0", "1,1,3,0", "more points than it says"},
        {"1,1,4,0", "1,7,4,0", "a hole (0)"},
        {"1,1,4,0", "1,1,-,0", "a number"},
        {"UNITS/0.5", "UNITS/0.0", "the unit"},
        {"UNITS/0.5", "UNITS/-.5", "the unit"},
        {"$$LAYER/2\n", "$$LABEL/2\n", "before the first layer"},
        {"$$HEADERSTART", "$$HEADERSTOPP", "does not begin with"},
        {"$$GEOMETRYEND", "$$GEOMETRYENX", "ends before"},
        {"$$GEOMETRYSTART", "$$GEOMETRYSTARX", "does not follow"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        char copy[sizeof small];
        sf_contour_stack *stack = NULL;
        sf_fault fault;
        memcpy(copy, small, sizeof small);
        char *at = strstr(copy, cases[i].from);
        CHECK(at != NULL && strlen(cases[i].from) == strlen(cases[i].to));
        memcpy(at, cases[i].to, strlen(cases[i].to));
        sf_status status = read_bytes(copy, strlen(copy), NULL, NULL, &stack, &fault);
        CHECK_EQ(status, cases[i].words[0] == '\0' ? SF_OK : SF_ERR_FORMAT);
        CHECK(strstr(fault.message, cases[i].words) != NULL);
        sf_contour_stack_destroy(stack);
    }
    for (size_t size = 0; size + 1 < strlen(small); size++) { // the last line feed may go
        sf_contour_stack *stack = NULL;
        sf_fault fault;
        CHECK_EQ(read_bytes(small, size, NULL, NULL, &stack, &fault), SF_ERR_FORMAT);
    }
}

static void binary_that_lies(void)
{
    static text t;
    sf_contour_stack *stack = random_stack(), *back = NULL;
    sf_sink sink = {put, &t};
    sf_fault fault;
    CHECK_EQ(sf_contour_stack_write(stack, SF_CONTOUR_CLI_BINARY, sink), SF_OK);
    for (size_t at = 0; at < t.size; at++) {
        for (int i = 0; i < 3; i++) {
            static const unsigned char spoilt[3] = {0xff, 0x7f, 0x00};
            unsigned char held = t.bytes[at];
            t.bytes[at] = spoilt[i];
            sf_status status = read_bytes(t.bytes, t.size, NULL, NULL, &back, &fault);
            CHECK(status == SF_OK || status == SF_ERR_FORMAT);
            sf_contour_stack_destroy(back);
            t.bytes[at] = held;
        }
    }
    // Binary has no mark at its end: only between the polygons of the last layer can it be cut.
    size_t taken = 0;
    for (size_t size = 0; size < t.size; size++) {
        sf_status status = read_bytes(t.bytes, size, NULL, NULL, &back, &fault);
        CHECK(status == SF_OK || status == SF_ERR_FORMAT);
        taken += status == SF_OK;
        sf_contour_stack_destroy(back);
    }
    sf_contours last;
    CHECK_EQ(sf_contour_stack_layer(stack, 4, &last, NULL, NULL), SF_OK);
    CHECK_EQ(taken, last.contour_count);
    sf_contour_stack_destroy(stack);
}

static void bounds_and_memory(void)
{
    sf_read_limits limits = sf_read_limits_default();
    sf_contour_stack *stack = NULL;
    sf_fault fault;
    sf_status status = SF_ERR_MEMORY;
    sf_sink none = {NULL, NULL};
    sf_source no_source = {NULL, NULL};
    limits.vertices_max = 9;
    CHECK_EQ(read_bytes(small, strlen(small), &limits, NULL, &stack, &fault), SF_ERR_OVERFLOW);
    limits.vertices_max = 10;
    CHECK_EQ(read_bytes(small, strlen(small), &limits, NULL, &stack, &fault), SF_OK);
    CHECK_EQ(sf_contour_stack_write(stack, SF_CONTOUR_CLI_TEXT, none), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_contour_stack_write(NULL, SF_CONTOUR_CLI_TEXT, none), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_contour_stack_read(no_source, NULL, NULL, &stack, &fault), SF_ERR_ARGUMENT);
    sf_contour_stack_destroy(stack);
    limits.bytes_max = 50;
    CHECK_EQ(read_bytes(small, strlen(small), &limits, NULL, &stack, &fault), SF_ERR_OVERFLOW);
    for (long k = 0; status != SF_OK && k < 100; k++) {
        failing_allocator f;
        failing_begin(&f, k);
        status = read_bytes(small, strlen(small), NULL, &f.allocator, &stack, &fault);
        CHECK(status == SF_OK || status == SF_ERR_MEMORY);
        sf_contour_stack_destroy(stack);
        CHECK(f.live == 0 && f.faults == 0);
    }
    CHECK_EQ(status, SF_OK);
}

// 60 layers of 0.1 mm, 444 polylines of which 60 enclose something: 1 mm2 below, 5 mm2 on top.
static void the_file_of_the_data(void)
{
    char path[1024];
    sf_file *file = NULL;
    sf_contour_stack *stack = NULL;
    if (getenv("SF_DATA") == NULL) {
        SKIP("SF_DATA does not name the data");
    }
    snprintf(path, sizeof path, "%s/slices/T_supported.cli", getenv("SF_DATA"));
    CHECK_EQ(sf_file_open(path, NULL, &file, NULL), SF_OK);
    CHECK_EQ(sf_contour_stack_read(sf_file_source(file), NULL, NULL, &stack, NULL), SF_OK);
    CHECK_EQ(sf_contour_stack_count(stack), 60);
    size_t closed = 0;
    for (uint32_t k = 0; k < sf_contour_stack_count(stack); k++) {
        sf_contours c;
        double bottom, top;
        CHECK_EQ(sf_contour_stack_layer(stack, k, &c, &bottom, &top), SF_OK);
        CHECK_NEAR(top, 0.1 * k, 1e-9);
        CHECK_NEAR(top - bottom, 0.1, 1e-9);
        double area = sf_contours_area_mm2(&c);
        CHECK(fabs(area - 1) < 1e-12 || fabs(area - 5) < 1e-12);
        closed += c.contour_count;
    }
    CHECK_EQ(closed, 60);
    sf_contour_stack_destroy(stack);
    sf_file_close(file);
}

int main(void)
{
    TEST(round_trips);
    TEST(what_a_file_says);
    TEST(short_numbers_and_alignment);
    TEST(files_that_lie);
    TEST(binary_that_lies);
    TEST(bounds_and_memory);
    TEST(the_file_of_the_data);
    return test_finish();
}
