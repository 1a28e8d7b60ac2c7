// SPDX-License-Identifier: MIT
// Jobs of resin printers: what is written is read again, .photon is what its bytes say, and a job
// that is written again keeps every byte that does not have to change. The last is asked of the
// bytes themselves, entry by entry. Guards: issue 8 part 3, TRUST 79.

#include "io/archive.h"
#include "io/png_grey.h"
#include "job_files.h"

static sf_job *open_job(job_bytes *b, const sf_job_options *options)
{
    sf_job *job = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    CHECK_EQ(sf_job_open(job_of(b), options, NULL, &job, &fault), SF_OK);
    CHECK_STR(fault.message, "");
    return job;
}

static void photons_are_read(void)
{
    job_bytes b = {NULL, 0, 0, {NULL, 0, 0}};
    for (uint32_t round = 0; round < 40; round++) {
        double heights[6] = {0.05, 0.05, 0.05, 0.05, 0.05, 0.05};
        int uneven = round % 3 == 0;
        heights[1] = uneven ? 0.1 : 0.05;
        sf_grid *grid = job_grid(1 + 7 * round, 1 + test_random_below(30), 6, heights);
        job_make_photon(&b, grid, round % 2 != 0);
        sf_job *job = open_job(&b, NULL);
        sf_lattice l = sf_job_lattice(job);
        sf_job_info info;
        CHECK(job_holds(job, grid));
        CHECK_EQ(sf_job_describe(job, &info), SF_OK);
        CHECK(info.format == SF_JOB_PHOTON && info.has_pitch && !info.has_greys);
        CHECK(l.pitch_x_mm == 0.05 && l.pitch_y_mm == 0.1 && (l.heights_mm != NULL) == uneven);
        for (uint32_t k = 0; k < 6; k++) {
            CHECK_EQ(sf_lattice_layer_height(&l, k) == heights[k], 1);
        }
        sf_job_close(job);
        sf_grid_destroy(grid);
    }
    free(b.data);
}

static void sl1_is_written_and_read(void)
{
    if (!sf_job_has_sl1()) {
        SKIP("this build has no SL1");
    }
    job_bytes b = {NULL, 0, 0, {NULL, 0, 0}};
    for (uint32_t round = 0; round < 30; round++) {
        double heights[4] = {0.3, 0.05, 0.05, 0.05};
        int uneven = round % 2;
        sf_grid *grid =
            job_grid(1 + 9 * round, 1 + test_random_below(30), 4, uneven ? heights : NULL);
        job_make_sl1(&b, grid);
        sf_job *job = open_job(&b, NULL);
        sf_lattice l = sf_job_lattice(job), wanted = sf_grid_lattice(grid);
        CHECK(job_holds(job, grid));
        CHECK(l.pitch_x_mm == 0.05 && l.pitch_y_mm == 0.1);
        for (uint32_t k = 0; k < 4; k++) {
            CHECK_EQ(sf_lattice_layer_height(&l, k) == sf_lattice_layer_height(&wanted, k), 1);
        }
        sf_job_close(job);
        sf_grid_destroy(grid);
    }
    free(b.data);
}

// Layers are numbered behind the job's name, which may end in digits of its own.
static void names_may_end_in_digits(void)
{
    if (!sf_job_has_sl1()) {
        SKIP("this build has no SL1");
    }
    static const char *const names[] = {"part-1", "2", "00000", "v20240131", "a_9999999999"};
    job_bytes b = {NULL, 0, 0, {NULL, 0, 0}};
    sf_sink sink = {job_put, &b};
    sf_grid *grid = job_grid(40, 20, 12, NULL);
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        sf_sl1_settings settings = sf_sl1_settings_default();
        settings.name = names[i];
        b.size = 0;
        CHECK_EQ(sf_sl1_write(grid, &settings, NULL, sink, NULL, NULL), SF_OK);
        sf_job *job = open_job(&b, NULL);
        CHECK(job != NULL && job_holds(job, grid));
        sf_job_close(job);
    }
    sf_grid_destroy(grid);
    free(b.data);
}

// ---------------------------------------------------------------------------------------------
// Written again
// ---------------------------------------------------------------------------------------------

static sfi_archive open_archive(job_bytes *b)
{
    sfi_archive a = {.count = 0};
    CHECK_EQ(sfi_archive_open(&a, job_of(b), NULL, NULL), SF_OK);
    return a;
}

// How many entries of two archives differ in a byte of their records, that of their place aside.
static size_t differing(job_bytes *before, job_bytes *after)
{
    sfi_archive a = open_archive(before), b = open_archive(after);
    size_t found = 0;
    CHECK(a.count == b.count && a.directory_size == b.directory_size && a.end_size == b.end_size);
    for (size_t i = 0; i < a.count && i < b.count; i++) {
        const sfi_archive_entry *p = &a.entries[i], *q = &b.entries[i];
        int same = p->end - p->begin == q->end - q->begin &&
                   memcmp(before->data + p->begin, after->data + q->begin, p->end - p->begin) == 0;
        int same_central = memcmp(a.directory + p->central, b.directory + q->central, 42) == 0;
        CHECK_EQ(same, same_central);
        // Behind the place stand name, extra fields and comment, which never change.
        CHECK(memcmp(a.directory + p->name, b.directory + q->name, p->central_size - 46u) == 0);
        found += !same;
    }
    sfi_archive_release(&a);
    sfi_archive_release(&b);
    return found;
}

static void what_does_not_change_stays(void)
{
    if (!sf_job_has_sl1()) {
        SKIP("this build has no SL1");
    }
    job_bytes b = {NULL, 0, 0, {NULL, 0, 0}}, again = b, twice = b;
    sf_grid *grid = job_grid(77, 31, 9, NULL);
    uint32_t changed = 99;
    job_make_sl1(&b, grid);
    sf_job *job = open_job(&b, NULL);
    sf_sink sink = {job_put, &again}, sink_twice = {job_put, &twice};
    CHECK_EQ(sf_job_rewrite(job, grid, sink, NULL, &changed, NULL), SF_OK);
    CHECK_EQ(changed, 0);
    CHECK(again.size == b.size && memcmp(again.data, b.data, b.size) == 0);
    sf_rect rect = {5, 5, 30, 20};
    CHECK_EQ(sf_slice_fill(sf_grid_slice(grid, 3), rect, 1), SF_OK);
    CHECK_EQ(sf_slice_fill(sf_grid_slice(grid, 8), rect, 0), SF_OK);
    CHECK_EQ(sf_job_rewrite(job, grid, sink_twice, NULL, &changed, NULL), SF_OK);
    CHECK_EQ(changed, 2);
    CHECK_EQ(differing(&b, &twice), 2);
    sf_job *fixed = open_job(&twice, NULL);
    CHECK(job_holds(fixed, grid));
    CHECK(!job_holds(job, grid));
    sf_job_close(fixed);
    sf_job_close(job);
    sf_grid_destroy(grid);
    free(b.data);
    free(again.data);
    free(twice.data);
}

enum { W = 60, H = 20 };
static uint8_t grey[H][W], after[H][W];

// Two discs with dim rims; the slice holds the right one alone.
static void draw_discs(sf_slice slice)
{
    for (uint32_t y = 0; y < H; y++) {
        for (uint32_t x = 0; x < W; x++) {
            double left = hypot(x - 12.0, y - 9.0), right = hypot(x - 42.0, y - 9.0);
            double from = (left < right ? left : right) - 5;
            grey[y][x] = (uint8_t)(from <= 0 ? 255 : from < 3 ? 100 - 30 * from : 0);
            CHECK_EQ(sf_slice_set(slice, x, y, right <= 5), SF_OK);
        }
    }
}

// The writer makes bits only, so a picture of greys takes the place of the last one that it made:
// the record anew, by hand, and the directory behind it.
static job_bytes job_of_greys(const sf_grid *grid)
{
    job_bytes b = {NULL, 0, 0, {NULL, 0, 0}}, png = b, made = b;
    sf_sink to_png = {job_put, &png};
    job_make_sl1(&b, grid);
    CHECK_EQ(sfi_png_write_grey(&grey[0][0], W, W, H, to_png), SF_OK);
    sfi_archive a = open_archive(&b);
    CHECK_EQ(a.count, 3);
    const sfi_archive_entry *e = &a.entries[2];
    uint32_t size = (uint32_t)png.size;
    uint32_t numbers[3] = {sfi_archive_crc(0, png.data, png.size), size, size};
    job_put(&made, b.data, e->data);
    job_put(&made, png.data, png.size);
    size_t directory = made.size;
    job_put(&made, b.data + a.directory_at, a.directory_size + a.end_size);
    for (size_t i = 0; i < 3; i++) {
        job_set32(&made, e->begin + 14 + 4 * i, numbers[i]);
        job_set32(&made, directory + e->central + 16 + 4 * i, numbers[i]);
    }
    job_set32(&made, directory + a.directory_size + 16, (uint32_t)directory);
    sfi_archive_release(&a);
    free(b.data);
    free(png.data);
    return made;
}

// One disc is taken away: with it goes its rim, and the other's stays.
static void the_rim_of_what_is_taken_goes(void)
{
    if (!sf_job_has_sl1()) {
        SKIP("this build has no SL1");
    }
    job_bytes made = {NULL, 0, 0, {NULL, 0, 0}};
    sf_grid *grid = job_grid(W, H, 1, NULL);
    sf_slice slice = sf_grid_slice(grid, 0);
    sf_sink sink = {job_put, &made};
    draw_discs(slice);
    job_bytes file = job_of_greys(grid);
    sf_job *job = open_job(&file, NULL);
    uint32_t changed = 0;
    CHECK_EQ(sf_job_rewrite(job, grid, sink, NULL, &changed, NULL), SF_OK);
    CHECK_EQ(changed, 1);
    sf_job *fixed = open_job(&made, NULL);
    CHECK(job_holds(fixed, grid));
    CHECK_EQ(sf_job_read_grey(fixed, 0, &after[0][0], W, NULL), SF_OK);
    for (uint32_t y = 0; y < H; y++) {
        for (uint32_t x = 0; x < W; x++) {
            CHECK_EQ(after[y][x], x < 27 ? 0 : grey[y][x]);
        }
    }
    // With another threshold the same greys are another shape.
    sf_job_options strict = sf_job_options_default();
    strict.threshold = 60;
    sf_job *wide = open_job(&file, &strict);
    sf_slice other = {calloc(H * 8, 8), W, H, 8};
    CHECK_EQ(sf_job_read(wide, 0, other, NULL), SF_OK);
    CHECK(sf_slice_popcount(other) > 2 * sf_slice_popcount(slice));
    free(other.words);
    sf_job_close(wide);
    sf_job_close(fixed);
    sf_job_close(job);
    sf_grid_destroy(grid);
    free(file.data);
    free(made.data);
}

static void files_have_bytes(void)
{
    sf_file *file = NULL;
    sf_bytes bytes;
    unsigned char two[2] = {0, 0};
    FILE *made = fopen("io-job.bytes", "wb");
    CHECK(made != NULL && fwrite("01234567", 1, 8, made) == 8 && fclose(made) == 0);
    CHECK_EQ(sf_file_open("io-job.bytes", NULL, &file, NULL), SF_OK);
    CHECK_EQ(sf_file_bytes(file, &bytes, NULL), SF_OK);
    CHECK_EQ(bytes.size, 8);
    CHECK_EQ(bytes.read_at(bytes.user, 5, two, 2), SF_OK);
    CHECK(two[0] == '5' && two[1] == '6');
    CHECK_EQ(bytes.read_at(bytes.user, 0, two, 2), SF_OK);
    CHECK(two[0] == '0' && two[1] == '1');
    CHECK_EQ(bytes.read_at(bytes.user, 7, two, 2), SF_ERR_IO);
    CHECK_EQ(sf_file_bytes(NULL, &bytes, NULL), SF_ERR_ARGUMENT);
    sf_file_close(file);
    remove("io-job.bytes");
}

int main(void)
{
    TEST(photons_are_read);
    TEST(sl1_is_written_and_read);
    TEST(names_may_end_in_digits);
    TEST(what_does_not_change_stays);
    TEST(the_rim_of_what_is_taken_goes);
    TEST(files_have_bytes);
    return test_finish();
}
