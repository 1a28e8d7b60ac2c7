// SPDX-License-Identifier: MIT
// Jobs that lie: every count, place and size of a small job is spoiled, one at a time, and the file
// is cut at every byte. Each gives a job or a refusal with a sentence, none reads beyond the file
// or takes memory for what is not there; and when memory runs out at any request, nothing stays
// behind. Guards: TRUST B1 (products), B2, B3 (counts and places), B13 (archives that overlap, lie,
// repeat), B15, B16, B18.

#include "io/archive.h"
#include "job_files.h"

static const uint32_t lies[] = {0,          1,          2,          3,          35,
                                36,         0x7f,       0xff,       0xffff,     0x10000,
                                0x7fffffff, 0x80000000, 0xfffffffe, 0xffffffff, 0x7fc00000,
                                0x7f800000, 0xbf800000};

static job_bytes copy_of(const job_bytes *b)
{
    job_bytes copy = {NULL, 0, 0, {NULL, 0, 0}};
    job_put(&copy, b->data, b->size);
    return copy;
}

// Spoil each 32-bit number at each byte of a stretch.
static void spoil(const job_bytes *good, size_t from, size_t to)
{
    sf_fault fault;
    for (size_t at = from; at + 4 <= to; at++) {
        for (size_t i = 0; i < sizeof lies / sizeof lies[0]; i++) {
            job_bytes b = copy_of(good);
            job_set32(&b, at, lies[i]);
            sf_status status = job_try(&b, NULL, -1, &fault);
            CHECK(status != SF_ERR_MEMORY && status != SF_ERR_INTERNAL && status != SF_ERR_IO);
            free(b.data);
        }
    }
}

static void cut(const job_bytes *good)
{
    sf_fault fault;
    for (size_t size = 0; size < good->size; size++) {
        job_bytes b = copy_of(good);
        b.size = size;
        sf_status status = job_try(&b, NULL, -1, &fault);
        CHECK(status == SF_ERR_FORMAT || status == SF_ERR_UNSUPPORTED);
        free(b.data);
    }
}

static void run_out_of_memory(job_bytes *b)
{
    sf_fault fault;
    sf_status status = SF_ERR_MEMORY;
    long k = 0;
    for (; status != SF_OK && k < 500; k++) {
        status = job_try(b, NULL, k, &fault);
        CHECK(status == SF_OK || status == SF_ERR_MEMORY);
    }
    CHECK(status == SF_OK && k > 3);
}

static void photons_that_lie(void)
{
    job_bytes b = {NULL, 0, 0, {NULL, 0, 0}};
    sf_grid *grid = job_grid(13, 5, 3, NULL);
    sf_fault fault;
    job_make_photon(&b, grid, 0);
    CHECK_EQ(job_try(&b, NULL, -1, &fault), SF_OK);
    spoil(&b, 0, PHOTON_TABLE + 3 * PHOTON_ENTRY);
    cut(&b);
    run_out_of_memory(&b);
    // A pixel too many, and one too few.
    size_t last = b.size - 1;
    b.data[last]++;
    CHECK_EQ(job_try(&b, NULL, -1, &fault), SF_ERR_FORMAT);
    CHECK(strstr(fault.message, "layer 2 has more pixels") != NULL);
    b.data[last] = (unsigned char)(b.data[last] - 2);
    CHECK_EQ(job_try(&b, NULL, -1, &fault), SF_ERR_FORMAT);
    CHECK(strstr(fault.message, "layer 2 has fewer pixels") != NULL);
    // Two layers of the same bytes: harmless one by one, a bomb by the thousand.
    job_make_photon(&b, grid, 0);
    size_t entry = PHOTON_TABLE + 2 * PHOTON_ENTRY;
    job_set32(&b, entry + 12, 0);
    job_set32(&b, entry + 16, (uint32_t)b.size);
    CHECK_EQ(job_try(&b, NULL, -1, &fault), SF_ERR_FORMAT);
    CHECK(strstr(fault.message, "share their bytes") != NULL);
    free(b.data);
    sf_grid_destroy(grid);
}

// The file's version of an exposure in greys, and its cousin: refused in words.
static void cousins_are_told(void)
{
    job_bytes b = {NULL, 0, 0, {NULL, 0, 0}};
    sf_grid *grid = job_grid(13, 5, 3, NULL);
    sf_fault fault;
    job_make_photon(&b, grid, 0);
    job_set32(&b, 0x5c, 4);
    CHECK_EQ(job_try(&b, NULL, -1, &fault), SF_ERR_UNSUPPORTED);
    job_set32(&b, 0, 0x12fd0086);
    CHECK_EQ(job_try(&b, NULL, -1, &fault), SF_ERR_UNSUPPORTED);
    CHECK(strstr(fault.message, "SL1") != NULL);
    free(b.data);
    sf_grid_destroy(grid);
}

static void archives_that_lie(void)
{
    if (!sf_job_has_sl1()) {
        SKIP("this build has no SL1");
    }
    job_bytes b = {NULL, 0, 0, {NULL, 0, 0}};
    sf_grid *grid = job_grid(9, 4, 2, NULL);
    sfi_archive a = {.count = 0};
    job_make_sl1(&b, grid);
    CHECK_EQ(sfi_archive_open(&a, job_of(&b), NULL, NULL), SF_OK);
    size_t directory = (size_t)a.directory_at, first = a.entries[2].begin;
    size_t data = a.entries[2].data, end = a.entries[2].end;
    sfi_archive_release(&a);
    spoil(&b, directory, b.size);     // directory and end
    spoil(&b, first, first + 30 + 9); // a record's head
    cut(&b);
    run_out_of_memory(&b);
    // Bytes of a picture, one by one: libspng or a checksum sees them.
    for (size_t at = data; at < end; at++) {
        job_bytes spoiled = copy_of(&b);
        sf_fault fault;
        spoiled.data[at] ^= 0x10;
        sf_status status = job_try(&spoiled, NULL, -1, &fault);
        CHECK(status == SF_ERR_FORMAT || status == SF_ERR_UNSUPPORTED);
        free(spoiled.data);
    }
    free(b.data);
    sf_grid_destroy(grid);
}

// A job with an end of 64-bit sizes: its archive is read, but cannot be written again.
static void jobs_that_are_wide(void)
{
    unsigned char wide[76] = {'P', 'K', 6, 6, 44};
    job_bytes b = {NULL, 0, 0, {NULL, 0, 0}}, made = b;
    sf_grid *grid = job_grid(9, 4, 2, NULL);
    sf_fault fault;
    sfi_archive a = {.count = 0};
    if (!sf_job_has_sl1()) {
        sf_grid_destroy(grid);
        SKIP("this build has no SL1");
    }
    job_make_sl1(&b, grid);
    size_t end = b.size - 22;
    memcpy(wide + 24, b.data + end + 8, 2);
    memcpy(wide + 32, b.data + end + 8, 2);
    memcpy(wide + 40, b.data + end + 12, 4);
    memcpy(wide + 48, b.data + end + 16, 4);
    memcpy(wide + 56, "PK\6\7", 4);
    sfi_archive_put32(wide + 64, (uint32_t)end);
    job_put(&made, b.data, end);
    job_put(&made, wide, sizeof wide);
    job_put(&made, b.data + end, 22);
    CHECK_EQ(sfi_archive_open(&a, job_of(&made), NULL, NULL), SF_OK);
    CHECK(a.is_wide && a.count > 2 && a.end_size == 98);
    sfi_archive_release(&a);
    CHECK_EQ(job_try(&made, NULL, -1, &fault), SF_ERR_UNSUPPORTED);
    CHECK(strstr(fault.message, "64 bits") != NULL);
    free(made.data);
    free(b.data);
    sf_grid_destroy(grid);
}

// One change of a directory at a time, each with the words that it must be refused by.
static void set_text(job_bytes *b, const char *what, const char *to)
{
    size_t size = strlen(what), found = 0;
    for (size_t at = 0; at + size <= b->size; at++) {
        if (memcmp(b->data + at, what, size) == 0) {
            memcpy(b->data + at, to, size);
            found++;
        }
    }
    CHECK(found > 0);
}

static void names_that_lie(void)
{
    static const struct {
        const char *from, *to, *words;
    } cases[] = {
        {"job00001.png", "job00000.png", "twice"},
        {"job00001.png", "job00002.png", "not all from 0 on"},
        {"job00001.png", "jib00001.png", "several names"},
        {"job00001.png", "x/b00001.png", "config.ini says another number"},
        {"config.ini", "config.inj", "no config.ini"},
        {"prusaslicer.ini", "prusaslicer.inj", "how large its pixels are"},
        {"layerHeight = 0", "layerHeight = x", "checksum"},
    };
    if (!sf_job_has_sl1()) {
        SKIP("this build has no SL1");
    }
    sf_grid *grid = job_grid(9, 4, 2, NULL);
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        job_bytes b = {NULL, 0, 0, {NULL, 0, 0}};
        sf_fault fault;
        job_make_sl1(&b, grid);
        set_text(&b, cases[i].from, cases[i].to);
        CHECK(job_try(&b, NULL, -1, &fault) != SF_OK);
        CHECK(strstr(fault.message, cases[i].words) != NULL);
        if (strstr(fault.message, cases[i].words) == NULL) {
            printf("# %s\n", fault.message);
        }
        free(b.data);
    }
    sf_grid_destroy(grid);
}

static void options_are_held(void)
{
    job_bytes b = {NULL, 0, 0, {NULL, 0, 0}};
    sf_grid *grid = job_grid(13, 5, 3, NULL);
    sf_fault fault;
    job_make_photon(&b, grid, 0);
    sf_job_options good = sf_job_options_default(), o = good;
    o.bytes_max = b.size - 1;
    CHECK_EQ(job_try(&b, &o, -1, &fault), SF_ERR_OVERFLOW);
    o = good;
    o.layers_max = 2;
    CHECK_EQ(job_try(&b, &o, -1, &fault), SF_ERR_OVERFLOW);
    o = good;
    o.threshold = 0;
    CHECK_EQ(job_try(&b, &o, -1, &fault), SF_ERR_ARGUMENT);
    o.threshold = 256;
    CHECK_EQ(job_try(&b, &o, -1, &fault), SF_ERR_ARGUMENT);
    o = good;
    o.pitch_mm[0] = 0.1;
    CHECK_EQ(job_try(&b, &o, -1, &fault), SF_ERR_ARGUMENT);
    o.pitch_mm[1] = NAN;
    CHECK_EQ(job_try(&b, &o, -1, &fault), SF_ERR_ARGUMENT);
    o.pitch_mm[1] = 0.2;
    CHECK_EQ(job_try(&b, &o, -1, &fault), SF_OK);
    sf_job *job = NULL;
    CHECK_EQ(sf_job_open(job_of(&b), &o, NULL, &job, NULL), SF_OK);
    sf_lattice l = sf_job_lattice(job);
    uint8_t pixels[65];
    sf_slice none = {NULL, 0, 0, 0}, small = {(uint64_t[1]){0}, 13, 1, 1};
    CHECK(l.pitch_x_mm == 0.1 && l.pitch_y_mm == 0.2);
    CHECK_EQ(sf_job_read(job, 3, small, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_job_read(job, 0, none, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_job_read(job, 0, small, NULL), SF_ERR_SHAPE);
    CHECK_EQ(sf_job_read_grey(job, 0, pixels, 12, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_job_read_grey(job, 0, pixels, 13, NULL), SF_OK);
    CHECK_EQ(sf_job_describe(job, NULL), SF_ERR_ARGUMENT);
    sf_sink sink = {job_put, &b};
    CHECK_EQ(sf_job_rewrite(job, grid, sink, NULL, NULL, &fault), SF_ERR_UNSUPPORTED);
    CHECK_EQ(sf_job_rewrite(NULL, grid, sink, NULL, NULL, &fault), SF_ERR_ARGUMENT);
    sf_job_close(job);
    sf_job_close(NULL);
    free(b.data);
    sf_grid_destroy(grid);
}

static void writing_fails_cleanly(void)
{
    if (!sf_job_has_sl1()) {
        SKIP("this build has no SL1");
    }
    job_bytes b = {NULL, 0, 0, {NULL, 0, 0}}, out = b;
    sf_grid *grid = job_grid(9, 4, 2, NULL), *other = job_grid(9, 4, 2, NULL);
    sf_sink sink = {job_put, &out};
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_status status = SF_ERR_MEMORY;
    sf_sl1_settings settings = sf_sl1_settings_default();
    job_make_sl1(&b, grid);
    for (long k = 0; status != SF_OK && k < 500; k++) {
        failing_allocator f;
        sf_job *job = NULL;
        failing_begin(&f, k);
        status = sf_sl1_write(grid, NULL, &f.allocator, sink, NULL, &fault);
        if (status == SF_OK) {
            status = sf_job_open(job_of(&b), NULL, &f.allocator, &job, &fault);
        }
        if (status == SF_OK) {
            status = sf_job_rewrite(job, other, sink, NULL, NULL, &fault);
        }
        CHECK(status == SF_OK || status == SF_ERR_MEMORY);
        sf_job_close(job);
        CHECK(f.live == 0 && f.faults == 0);
    }
    CHECK_EQ(status, SF_OK);
    settings.name = "../job";
    CHECK_EQ(sf_sl1_write(grid, &settings, NULL, sink, NULL, &fault), SF_ERR_ARGUMENT);
    settings = sf_sl1_settings_default();
    settings.exposure_s = -1;
    CHECK_EQ(sf_sl1_write(grid, &settings, NULL, sink, NULL, &fault), SF_ERR_ARGUMENT);
    double heights[4] = {0.1, 0.1, 0.1, 0.2};
    sf_grid *uneven = job_grid(3, 3, 4, heights);
    CHECK_EQ(sf_sl1_write(uneven, NULL, NULL, sink, NULL, &fault), SF_ERR_UNSUPPORTED);
    sf_task task = sf_task_default();
    sf_task_cancel(&task);
    CHECK_EQ(sf_sl1_write(grid, NULL, NULL, sink, &task, &fault), SF_ERR_CANCELLED);
    sf_grid_destroy(uneven);
    sf_grid_destroy(other);
    sf_grid_destroy(grid);
    free(b.data);
    free(out.data);
}

int main(void)
{
    TEST(photons_that_lie);
    TEST(cousins_are_told);
    TEST(archives_that_lie);
    TEST(jobs_that_are_wide);
    TEST(names_that_lie);
    TEST(options_are_held);
    TEST(writing_fails_cleanly);
    return test_finish();
}
