// SPDX-License-Identifier: MIT
// Why: a job of a large printer is fifteen gigabytes of bits, and must be judged in the memory of a
// few layers, however many there are. Layers of 11520 x 5120 pixels are read from a job that exists
// nowhere, whose bytes are made as they are asked for; all of it is decoded, checked, and searched
// for voids. Ten times the layers must not take more memory, and never more than 96 MiB.
// With an argument, that many layers: 2000 take a minute. Guards: issue 8.

#define _XOPEN_SOURCE 700

#include <sf/job.h>

#include <sf/finding.h>

#include "test.h"

#if defined(__unix__) && !defined(__SANITIZE_ADDRESS__)
#include <sys/resource.h>

static long peak_kib(void)
{
    struct rusage usage;
    return getrusage(RUSAGE_SELF, &usage) == 0 ? usage.ru_maxrss : 0;
}
#else
static long peak_kib(void)
{
    return 0;
}
#endif

enum { NX = 11520, NY = 5120, HEAD = 112, ENTRY = 36, SEGMENT = 12, ROW = 8 * SEGMENT };
enum { LAYER = ROW * NY };

static uint32_t layers;

static void put32(unsigned char *at, uint32_t value)
{
    for (int i = 0; i < 4; i++) {
        at[i] = (unsigned char)(value >> 8 * i);
    }
}

static void put_float(unsigned char *at, float value)
{
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    put32(at, bits);
}

static unsigned char head_byte(uint64_t at)
{
    unsigned char head[HEAD] = {0};
    put32(head, 0x12fd0019);
    put32(head + 4, 1);
    put_float(head + 8, NX * 0.02f);
    put_float(head + 12, NY * 0.025f);
    put_float(head + 0x20, 0.05f);
    put32(head + 0x34, NX);
    put32(head + 0x38, NY);
    put32(head + 0x40, HEAD);
    put32(head + 0x44, layers);
    return head[at];
}

static unsigned char table_byte(uint64_t at)
{
    unsigned char entry[ENTRY] = {0};
    uint32_t k = (uint32_t)(at / ENTRY);
    put_float(entry, 0.05f * (float)k);
    put32(entry + 12, HEAD + ENTRY * layers + LAYER * k);
    put32(entry + 16, LAYER);
    return entry[at % ENTRY];
}

// Eight stripes a row: 1270 black, 100 white, 70 black.
static unsigned char run_byte(uint64_t at)
{
    uint64_t i = at % SEGMENT;
    return i < 10 ? 127 : i == 10 ? 128 | 100 : 70;
}

static sf_status read_at(void *user, uint64_t offset, void *data, size_t size)
{
    unsigned char *bytes = data;
    uint64_t table = HEAD + (uint64_t)ENTRY * layers;
    (void)user;
    for (size_t i = 0; i < size; i++) {
        uint64_t at = offset + i;
        bytes[i] = at < HEAD    ? head_byte(at)
                   : at < table ? table_byte(at - HEAD)
                                : run_byte(at - table);
    }
    return SF_OK;
}

// Check a job of so many layers as sf check does.
static void judge(uint32_t count)
{
    layers = count;
    sf_bytes bytes = {read_at, HEAD + ((uint64_t)ENTRY + LAYER) * count, NULL};
    static sf_finding findings[4096];
    static sf_void voids[4096];
    sf_job *job = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    CHECK_EQ(sf_job_open(bytes, NULL, NULL, &job, &fault), SF_OK);
    CHECK_STR(fault.message, "");
    sf_lattice l = sf_job_lattice(job);
    CHECK(l.nx == NX && l.ny == NY && l.nz == count && l.pitch_x_mm == 0.02 &&
          l.pitch_y_mm == 0.025);
    sf_check_options o = sf_check_options_default();
    sf_voids_options v = sf_voids_options_default();
    sf_checker *checker = NULL;
    sf_void_search *search = NULL;
    sf_check_report report;
    sf_voids_report found;
    size_t size = 0;
    o.width = NX;
    o.height = NY;
    o.findings = findings;
    o.finding_capacity = 4096;
    o.run_capacity = 262144;
    v.voids = voids;
    v.void_capacity = 4096;
    CHECK_EQ(sf_checker_size(&o, &size), SF_OK);
    char *memory = malloc(size + 64);
    sf_slice slice = {calloc((size_t)NY * sf_slice_stride(NX), 8), NX, NY, sf_slice_stride(NX)};
    CHECK_EQ(sf_checker_place(&o, memory + (64 - (uintptr_t)memory % 64) % 64, size, &checker),
             SF_OK);
    CHECK_EQ(sf_void_search_create(&v, NX, NY, NULL, &search), SF_OK);
    for (uint32_t k = 0; k < count; k++) {
        CHECK_EQ(sf_job_read(job, k, slice, &fault), SF_OK);
        CHECK_EQ(sf_checker_push(checker, slice), SF_OK);
        CHECK_EQ(sf_void_search_push(search, slice), SF_OK);
    }
    CHECK_EQ(sf_checker_report(checker, &report, NULL), SF_OK);
    CHECK_EQ(sf_void_search_finish(search, &found, NULL), SF_OK);
    CHECK_EQ(report.solid_voxels, (uint64_t)800 * NY * count);
    CHECK(report.support_free && found.trap_count + found.cup_count == 0);
    sf_void_search_destroy(search);
    free(slice.words);
    free(memory);
    sf_job_close(job);
}

static uint32_t many = 30;

static void memory_does_not_know_the_count(void)
{
    judge(3);
    long few = peak_kib();
    if (few == 0) {
        SKIP("this machine or build does not tell a peak that would mean something");
    }
    judge(many);
    long more = peak_kib();
    printf("# peak %ld KiB with 3 layers, %ld KiB with %lu\n", few, more, (unsigned long)many);
    CHECK(more - few <= 2048);
    CHECK(more <= 96 * 1024);
}

int main(int argc, char **argv)
{
    many = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : many;
    TEST(memory_does_not_know_the_count);
    return test_finish();
}
