// SPDX-License-Identifier: MIT
// The jobs of shared/data, made by two slicers of one model: each layer has the number of white
// pixels that another reader counted (TRUTH.md), greys sum up to what it found, and .photon and SL1
// agree on the model. Guards: issue 8 (every file of slices/ read as TRUTH.md says).

#include "base/memory.h"
#include "io/png_grey.h"

#include <sf/job.h>

#include "test.h"

static const uint32_t sl1_white[10] = {2016336, 1618752, 1618751, 1618747, 1618753,
                                       1618749, 1618755, 1618758, 1618753, 1618755};
static const uint32_t photon_white[10] = {2017395, 1620291, 1620291, 1620290, 1620291,
                                          1620291, 1620291, 1620291, 1620290, 1620291};

typedef struct opened {
    sf_file *file;
    sf_job *job;
} opened;

static opened open_job(const char *name)
{
    char path[1024];
    opened o = {NULL, NULL};
    sf_bytes bytes;
    sf_fault fault = {SF_OK, 0, 0, ""};
    snprintf(path, sizeof path, "%s/slices/%s", getenv("SF_DATA"), name);
    sf_status status = sf_file_open(path, NULL, &o.file, &fault);
    if (status == SF_OK) {
        status = sf_file_bytes(o.file, &bytes, &fault);
    }
    if (status == SF_OK) {
        status = sf_job_open(bytes, NULL, NULL, &o.job, &fault);
    }
    CHECK_EQ(status, SF_OK);
    CHECK_STR(fault.message, "");
    return o;
}

static void close_job(opened o)
{
    sf_job_close(o.job);
    sf_file_close(o.file);
}

// White pixels of each layer, the sum of greys / 255 of each; and that the checker likes the model.
static void look(const char *name, const uint32_t *white, double *greys, int has_greys)
{
    opened o = open_job(name);
    sf_lattice l = sf_job_lattice(o.job);
    sf_job_info info;
    if (o.job == NULL) {
        return;
    }
    CHECK(l.nx == 1440 && l.ny == 2560 && l.nz == 10 && l.pitch_x_mm == 0.04725 &&
          l.pitch_y_mm == 0.04725 && l.layer_mm == 0.05 && l.heights_mm == NULL);
    CHECK_EQ(sf_job_describe(o.job, &info), SF_OK);
    CHECK_EQ(info.has_greys, has_greys);
    sf_slice slice = {calloc(2560 * 24, 8), 1440, 2560, 24};
    uint8_t *pixels = malloc(2560 * 1440);
    for (uint32_t k = 0; k < 10; k++) {
        sf_fault fault = {SF_OK, 0, 0, ""};
        uint64_t sum = 0, full = 0;
        CHECK_EQ(sf_job_read(o.job, k, slice, &fault), SF_OK);
        CHECK_EQ(sf_job_read_grey(o.job, k, pixels, 1440, &fault), SF_OK);
        CHECK_STR(fault.message, "");
        for (size_t i = 0; i < 2560 * 1440; i++) {
            sum += pixels[i];
            full += pixels[i] >= 128;
        }
        greys[k] = (double)sum / 255;
        CHECK_EQ(full, sf_slice_popcount(slice));
        CHECK_EQ(sf_slice_popcount(slice), white[k]);
    }
    free(pixels);
    free(slice.words);
    close_job(o);
}

static void sl1_without_greys(void)
{
    if (!sf_job_has_sl1()) {
        SKIP("this build reads no PNG jobs");
    }
    double greys[10];
    look("pyphotonfile_reference_noAA.sl1", sl1_white, greys, 1); // 8 bits, though all 0 or 255
    for (int k = 0; k < 10; k++) {
        CHECK_NEAR(greys[k], sl1_white[k], 1e-9);
    }
}

static void sl1_with_greys(void)
{
    if (!sf_job_has_sl1()) {
        SKIP("this build reads no PNG jobs");
    }
    double greys[10];
    look("pyphotonfile_reference_AA.sl1", sl1_white, greys, 1);
    CHECK_NEAR(greys[0], 2015641.1, 0.05);
    CHECK_NEAR(greys[1], 1618528.7, 0.05);
}

static void photon(void)
{
    double greys[10];
    look("pyphotonfile_reference.photon", photon_white, greys, 0);
    // One model by two slicers: its layers differ by a pixel along the border, one in a thousand.
    for (int k = 0; k < 10; k++) {
        CHECK_NEAR((double)photon_white[k] / sl1_white[k], 1, 0.001);
    }
    CHECK_NEAR(greys[9], photon_white[9], 0);
}

static void count(void *user, uint32_t y, const uint8_t *greys)
{
    uint32_t *white = user;
    for (uint32_t x = 0; x < 1440; x++) {
        *white += greys[x] >= 128;
    }
    *white += y >= 2560; // never
}

static void a_picture_of_colours(void)
{
    if (!sf_job_has_sl1()) {
        SKIP("this build reads no PNG jobs");
    }
    char path[1024];
    sf_file *file = NULL;
    uint32_t white = 0;
    snprintf(path, sizeof path, "%s/slices/uv3dp_00000000.png", getenv("SF_DATA"));
    CHECK_EQ(sf_file_open(path, NULL, &file, NULL), SF_OK);
    sf_allocator from = sfi_allocator_or_default(NULL);
    CHECK_EQ(
        sfi_png_read_rows(sf_file_source(file), &from, "picture", 1440, 2560, count, &white, NULL),
        SF_OK);
    CHECK_EQ(white, 1355910);
    sf_file_close(file);
}

int main(void)
{
    if (getenv("SF_DATA") == NULL) {
        printf("1..0 # SKIP SF_DATA does not name the data\n");
        return 0;
    }
    TEST(photon);
    TEST(sl1_without_greys);
    TEST(sl1_with_greys);
    TEST(a_picture_of_colours);
    return test_finish();
}
