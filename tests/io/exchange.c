// SPDX-License-Identifier: MIT
// Why: exchange files carry a solid from one program to another, for years. What is written must be
// read back to the bit, with jumps, units and bounds, and be the same bytes each time; what others
// damage must end in a status. libhdf5 is not ours and was not made for that, so damaged files are
// read in a child with limits of time and memory: it may say no, run out of them, or even die, but
// what it reads must be tetrahedra, and nothing of that may reach the parent. With a path as
// argument, a file is written there, for the test that reads it by h5py; with "read" and a path,
// what is read there is said, for the test whose files are made by h5py.

#include <sf/exchange.h>
#include <sf/io.h>

#include "failing_allocator.h"
#include "test.h"

#if defined(__unix__) || defined(__APPLE__)
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#define HAVE_CHILDREN 1
#endif

typedef struct bytes {
    unsigned char *data;
    size_t size;
    long budget; // bytes that may be written; negative: any number
} bytes;

static sf_status append(void *user, const void *data, size_t size)
{
    bytes *b = user;
    if (b->budget >= 0 && (long)size > b->budget) {
        return SF_ERR_IO;
    }
    b->data = realloc(b->data, b->size + size);
    memcpy(b->data + b->size, data, size);
    b->size += size;
    return SF_OK;
}

// Two tetrahedra on a face; one property that jumps there, one that does not.
static sf_tets *pair(void)
{
    static const double points[15] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1.0 / 3};
    static const uint32_t corners[8] = {0, 1, 2, 3, 1, 4, 2, 3}, jump[8] = {0, 0, 0, 0, 1, 1, 1, 1};
    static const double two[2] = {1000, 1200.5}, five[5] = {1e9, 2e9, 3e9, 4e9, 5e9};
    sf_channel channels[2] = {{sf_property_density(), 2, two, jump},
                              {sf_property_young(), 5, five, NULL}};
    sf_tets_view view = {5, points, 2, corners, 2, channels};
    sf_tets *tets = NULL;
    CHECK_EQ(sf_tets_create(&view, NULL, &tets, NULL), SF_OK);
    return tets;
}

static bytes write_pair(void)
{
    sf_tets *tets = pair();
    bytes b = {NULL, 0, -1};
    sf_sink sink = {append, &b};
    CHECK_EQ(sf_exchange_write(tets, sink, NULL), SF_OK);
    sf_tets_destroy(tets);
    return b;
}

static sf_status read_bytes(const void *data, size_t size, sf_tets **tets, sf_fault *fault)
{
    sf_memory_cursor cursor = {data, size, 0};
    return sf_exchange_read(sf_memory_source(&cursor), 0, NULL, tets, fault);
}

static int same_channel(const sf_channel *a, const sf_channel *b, size_t tets)
{
    return memcmp(a->property.uuid, b->property.uuid, 16) == 0 &&
           memcmp(a->property.si, b->property.si, 7) == 0 && a->property.low == b->property.low &&
           a->property.high == b->property.high &&
           strcmp(a->property.name, b->property.name) == 0 && a->value_count == b->value_count &&
           memcmp(a->values, b->values, a->value_count * sizeof(double)) == 0 &&
           (a->indices == NULL) == (b->indices == NULL) &&
           (a->indices == NULL || memcmp(a->indices, b->indices, 16 * tets) == 0);
}

static void what_is_written_is_read_back_to_the_bit(void)
{
    if (!sf_exchange_is_served()) {
        SKIP("this build has no libhdf5");
    }
    bytes b = write_pair(), again = write_pair();
    sf_tets *a = pair(), *c = NULL;
    sf_fault fault = {0};
    CHECK(b.size == again.size && memcmp(b.data, again.data, b.size) == 0);
    CHECK_EQ(read_bytes(b.data, b.size, &c, &fault), SF_OK);
    sf_tets_view x = sf_tets_get_view(a), y = sf_tets_get_view(c);
    CHECK(x.point_count == y.point_count && x.tet_count == y.tet_count &&
          x.channel_count == y.channel_count);
    CHECK(memcmp(x.positions, y.positions, 3 * x.point_count * sizeof(double)) == 0);
    CHECK(memcmp(x.corners, y.corners, 16 * x.tet_count) == 0);
    for (size_t i = 0; i < x.channel_count; i++) { // files list them by their UUIDs
        int found = 0;
        for (size_t j = 0; j < y.channel_count; j++) {
            found |= same_channel(&x.channels[i], &y.channels[j], x.tet_count);
        }
        CHECK(found);
    }
    sf_tets_destroy(a);
    sf_tets_destroy(c);
    free(b.data);
    free(again.data);
}

static void what_fails_leaves_nothing(void)
{
    if (!sf_exchange_is_served()) {
        SKIP("this build has no libhdf5");
    }
    bytes b = write_pair(), none = {NULL, 0, 10};
    sf_sink sink = {append, &none};
    sf_tets *tets = pair(), *made = NULL;
    sf_fault fault = {0};
    CHECK_EQ(sf_exchange_write(tets, sink, &fault), SF_ERR_IO);
    CHECK_EQ(none.size, 0);
    sf_tets_destroy(tets);
    for (long k = 0;; k++) {
        failing_allocator memory;
        sf_memory_cursor cursor = {b.data, b.size, 0};
        failing_begin(&memory, k);
        sf_status status =
            sf_exchange_read(sf_memory_source(&cursor), 0, &memory.allocator, &made, NULL);
        sf_tets_destroy(made);
        made = NULL;
        CHECK(memory.live == 0 && memory.faults == 0);
        if (status == SF_OK) {
            CHECK(k > 8);
            break;
        }
        CHECK_EQ(status, SF_ERR_MEMORY);
    }
    sf_memory_cursor cursor = {b.data, b.size, 0};
    CHECK_EQ(sf_exchange_read(sf_memory_source(&cursor), 100, NULL, &made, &fault),
             SF_ERR_OVERFLOW);
    CHECK_EQ(read_bytes("no file", 7, &made, &fault), SF_ERR_FORMAT);
    CHECK(strstr(fault.message, "no HDF5 file") != NULL);
    CHECK_EQ(read_bytes("", 0, &made, &fault), SF_ERR_FORMAT);
    free(b.data);
}

#ifdef HAVE_CHILDREN

enum { ACCEPTED = 0, REFUSED = 1, BROKEN = 2 };
// Of all places every so many, so that it is quick; primes, so that all bits of bytes have their
// turn.
enum { FLIP_STRIDE = 17, CUT_STRIDE = 7 };

// In a child: read, and look at what came of it.
static int judge(const unsigned char *data, size_t size)
{
    sf_tets *tets = NULL;
    sf_tets_report report;
    sf_fault fault = {0};
    sf_status status = read_bytes(data, size, &tets, &fault);
    if (status != SF_OK) {
        return tets == NULL && (status == SF_ERR_MEMORY || fault.message[0] != '\0') ? REFUSED
                                                                                     : BROKEN;
    }
    int good = sf_tets_check(tets, NULL, &report) == SF_OK;
    sf_tets_destroy(tets);
    return good ? ACCEPTED : BROKEN;
}

// One child for many files: it says what became of each, and where it dies the parent goes on
// behind.
static size_t run_child(const bytes *b, size_t from, size_t to, int counts[3], int flips)
{
    int ends[2];
    if (pipe(ends) != 0) {
        return to;
    }
    pid_t child = fork();
    if (child == 0) {
        struct rlimit seconds = {20, 20};
        setrlimit(RLIMIT_CPU, &seconds);
        unsigned char *copy = malloc(b->size);
        for (size_t i = from; i < to; i++) {
            size_t at = i * (flips ? FLIP_STRIDE : CUT_STRIDE);
            memcpy(copy, b->data, b->size);
            if (flips) {
                copy[at / 8] ^= (unsigned char)(1 << at % 8);
            }
            unsigned char word = (unsigned char)judge(copy, flips ? b->size : at);
            if (write(ends[1], &word, 1) != 1) {
                break;
            }
        }
        _exit(0);
    }
    close(ends[1]);
    unsigned char word;
    size_t at = from;
    while (read(ends[0], &word, 1) == 1) {
        counts[word < 3 ? word : 2]++;
        at++;
    }
    close(ends[0]);
    int status;
    waitpid(child, &status, 0);
    return at;
}

static void judge_all(const bytes *b, size_t count, size_t step, int flips)
{
    int counts[3] = {0, 0, 0}, died = 0;
    for (size_t i = 0; i < count && died < 200;) {
        size_t end = i + step < count ? i + step : count,
               reached = run_child(b, i, end, counts, flips);
        if (reached < end) {
            died++; // libhdf5's own affair
            reached++;
        }
        i = reached;
    }
    printf("# %s: %d accepted, %d refused, %d children died\n", flips ? "bits turned" : "cut short",
           counts[ACCEPTED], counts[REFUSED], died);
    CHECK_EQ(counts[BROKEN], 0);
    CHECK(counts[REFUSED] > 0 && died < 200);
}

static void damaged_files_end_in_a_status(void)
{
    if (!sf_exchange_is_served()) {
        SKIP("this build has no libhdf5");
    }
    bytes b = write_pair();
    judge_all(&b, b.size / CUT_STRIDE, 1024, 0);
    judge_all(&b, 8 * b.size / FLIP_STRIDE, 2048, 1);
    free(b.data);
}

#endif

// Say what reading a file ends in.
static int read_file(const char *path)
{
    static unsigned char data[1 << 20];
    FILE *file = fopen(path, "rb");
    size_t size = file == NULL ? 0 : fread(data, 1, sizeof data, file);
    sf_tets *tets = NULL;
    sf_fault fault = {0};
    sf_status status = read_bytes(data, size, &tets, &fault);
    sf_tets_view view = sf_tets_get_view(tets);
    printf("%d %zu tetrahedra, %zu properties. %s\n", (int)status, view.tet_count,
           view.channel_count, fault.message);
    sf_tets_destroy(tets);
    return file == NULL || fclose(file) != 0;
}

int main(int argc, char **argv)
{
    if (argc > 2) {
        return read_file(argv[2]);
    }
    if (argc > 1 && sf_exchange_is_served()) {
        bytes b = write_pair();
        FILE *file = fopen(argv[1], "wb");
        int good = file != NULL && fwrite(b.data, 1, b.size, file) == b.size && fclose(file) == 0;
        free(b.data);
        return good ? 0 : 1;
    }
    TEST(what_is_written_is_read_back_to_the_bit);
    TEST(what_fails_leaves_nothing);
#ifdef HAVE_CHILDREN
    TEST(damaged_files_end_in_a_status);
#endif
    return test_finish();
}
