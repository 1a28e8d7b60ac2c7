// SPDX-License-Identifier: MIT
// A stack that is written and read again is the same grid on the same lattice under the same rule,
// and written once more the same bytes. Pictures that others made are read the right way up.
// Guards: TRUST 79 (read(write(S)) = S, write of read of write equal bytes), issue 2 part 6.

#include "stack_files.h"

#include "io/picture.h"

static sf_grid *random_grid(uint32_t nx, uint32_t ny, uint32_t nz, int heights)
{
    static double own[16];
    sf_lattice lattice = {nx, ny, nz, 0.1, 1.0 / 3.0, 0.05, NULL, {-1.5e-7, 1e12, 0.1 + 0.2}};
    for (int i = 0; i < 16; i++) {
        own[i] = 0.01 + test_random_unit();
    }
    lattice.heights_mm = heights ? own : NULL;
    sf_grid *grid = NULL;
    CHECK_EQ(sf_grid_create(&lattice, NULL, &grid), SF_OK);
    for (uint32_t k = 0; k < nz; k++) {
        for (uint32_t y = 0; y < ny; y++) {
            for (uint32_t x = 0; x < nx; x++) {
                CHECK_EQ(sf_slice_set(sf_grid_slice(grid, k), x, y, test_random_below(3) == 0),
                         SF_OK);
            }
        }
    }
    return grid;
}

static int same_lattice(const sf_grid *a, const sf_grid *b)
{
    sf_lattice p = sf_grid_lattice(a), q = sf_grid_lattice(b);
    int good = p.nx == q.nx && p.ny == q.ny && p.nz == q.nz && p.pitch_x_mm == q.pitch_x_mm &&
               p.pitch_y_mm == q.pitch_y_mm && (p.heights_mm == NULL) == (q.heights_mm == NULL) &&
               memcmp(p.origin_mm, q.origin_mm, sizeof p.origin_mm) == 0;
    for (uint32_t k = 0; good && k < p.nz; k++) {
        good = sf_lattice_layer_height(&p, k) == sf_lattice_layer_height(&q, k);
    }
    return good;
}

static sf_stack_info random_info(uint32_t nz)
{
    sf_stack_info info = {.rule = (sf_rule_kind)test_random_below(4),
                          .bed_layer = test_random_below(nz)};
    if (test_random_below(3) == 0) {
        info.bridge_span_mm = 0.1 + test_random_unit();
        info.bridge_anchor_mm = test_random_unit();
    }
    info.has_rule = test_random_below(4) != 0;
    if (info.rule != SF_RULE_BOX3) {
        info.angle_rad = SF_RULE_ANGLE_MIN_RAD +
                         test_random_unit() * (SF_RULE_ANGLE_MAX_RAD - SF_RULE_ANGLE_MIN_RAD);
    }
    if (test_random_below(5) == 0) {
        info.bed_layer = SF_BED_AUTO;
    }
    if (!info.has_rule) {
        memset(&info, 0, sizeof info);
    }
    return info;
}

static int can_read(void)
{
    memory_folder folder;
    sf_folder files = memory_begin_folder(&folder);
    sf_grid *grid = NULL;
    sf_status status = sf_stack_read(files, NULL, NULL, &grid, NULL, NULL);
    return status != SF_ERR_UNSUPPORTED;
}

static void round_trips(void)
{
    if (!can_read()) {
        SKIP("this build has no jansson");
    }
    for (uint32_t round = 0; round < 80; round++) {
        memory_folder first, second;
        sf_folder out = memory_begin_folder(&first), again = memory_begin_folder(&second);
        uint32_t nx = round < 70 ? 1 + round : 1 + test_random_below(200);
        uint32_t ny = 1 + test_random_below(20), nz = 1 + test_random_below(8);
        sf_grid *grid = random_grid(nx, ny, nz, round % 2 != 0), *back = NULL;
        sf_stack_info info = random_info(nz), found;
        sf_fault fault = {SF_OK, 0, 0, ""};
        memset(&found, 0xff, sizeof found);
        CHECK_EQ(sf_stack_write(grid, round % 7 == 0 ? NULL : &info, out, NULL, &fault), SF_OK);
        CHECK_EQ(sf_stack_read(out, NULL, NULL, &back, &found, &fault), SF_OK);
        CHECK_STR(fault.message, "");
        if (back != NULL) {
            CHECK(sf_grid_equal(grid, back) && same_lattice(grid, back));
            CHECK(round % 7 == 0
                      ? !found.has_rule
                      : found.has_rule == info.has_rule && found.rule == info.rule &&
                            found.angle_rad == info.angle_rad && found.bed_layer == info.bed_layer);
            CHECK_EQ(sf_stack_write(back, &found, again, NULL, NULL), SF_OK);
            CHECK(memory_same(&first, &second));
        }
        CHECK_EQ(first.count, nz + 1);
        CHECK_STR(first.files[nz].name, "stack.json"); // last, so that it vouches for the rest
        CHECK_EQ(first.faults + second.faults, 0);
        sf_grid_destroy(grid);
        sf_grid_destroy(back);
        memory_end_folder(&first);
        memory_end_folder(&second);
    }
}

// Three voxels wide, two high: (0, 1) and (2, 1) in the upper row, (1, 0) in the lower.
static int is_known(sf_grid *grid)
{
    static const int solid[2][3] = {{0, 1, 0}, {1, 0, 1}};
    int good = grid != NULL;
    for (uint32_t y = 0; good && y < 2; y++) {
        for (uint32_t x = 0; x < 3; x++) {
            good = good && sf_slice_get(sf_grid_slice(grid, 0), x, y) == solid[y][x];
        }
    }
    good = good && sf_grid_popcount(grid) == 3;
    sf_grid_destroy(grid);
    return good;
}

static sf_grid *read_picture(const char *pattern, const char *name, const void *bytes, size_t size,
                             sf_status expected)
{
    memory_folder folder;
    sf_folder files = memory_begin_folder(&folder);
    sf_grid *grid = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    memory_put_document(&folder, pattern);
    memory_put(&folder, name, bytes, size);
    sf_status status = sf_stack_read(files, NULL, NULL, &grid, NULL, &fault);
    CHECK_EQ(status, expected);
    CHECK((status == SF_OK) == (grid != NULL));
    CHECK(status == SF_OK || (fault.status == status && strlen(fault.message) > 20));
    CHECK_EQ(folder.faults + folder.is_open, 0);
    memory_end_folder(&folder);
    return grid;
}

static void reads_pbm_the_right_way_up(void)
{
    if (!can_read()) {
        SKIP("this build has no jansson");
    }
    // 1 is black and so empty; what stands past the width does not matter.
    static const char plain[] = "P4\n3 2\n\x40\xbf",
                      wordy[] = "P4 # made by hand\n# 9 9\n3\t2 \x5f\xa0";
    CHECK(is_known(
        read_picture("layer_%05u.pbm", "layer_00000.pbm", plain, sizeof plain - 1, SF_OK)));
    CHECK(is_known(
        read_picture("layer_%05u.pbm", "layer_00000.pbm", wordy, sizeof wordy - 1, SF_OK)));
    for (size_t size = 0; size < sizeof plain - 1; size++) {
        CHECK(read_picture("layer_%05u.pbm", "layer_00000.pbm", plain, size, SF_ERR_FORMAT) ==
              NULL);
    }
    static const char *const wrong[] = {"P1\n3 2\n1", "P4\n2 3\n123", "P4\n3 x\n12",
                                        "P4\n3000000 2\n12", "P4\n-3 2\n12"};
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        CHECK(read_picture("layer_%05u.pbm", "layer_00000.pbm", wrong[i], strlen(wrong[i]),
                           SF_ERR_FORMAT) == NULL);
    }
}

static void reads_png_the_right_way_up(void)
{
    if (!can_read() || !sf_stack_has_png()) {
        SKIP("this build has no jansson or no libspng");
    }
    static const unsigned char bits[] = {0xa0, 0x5f}, grey[] = {255, 127, 128, 0, 200, 1};
    static const unsigned char colour[18] = {0};
    hand_png png;
    png_make(&png, 3, 2, 1, 0, 0, bits, 1);
    CHECK(is_known(read_picture("layer_%05u.png", "layer_00000.png", png.bytes, png.size, SF_OK)));
    for (size_t size = 0; size < png.size - 24; size++) { // the last bytes say nothing of pixels
        CHECK(read_picture("layer_%05u.png", "layer_00000.png", png.bytes, size, SF_ERR_FORMAT) ==
              NULL);
    }
    png.bytes[45] ^= 1; // in the pixels: the check sum finds it
    CHECK(read_picture("layer_%05u.png", "layer_00000.png", png.bytes, png.size, SF_ERR_FORMAT) ==
          NULL);
    png_make(&png, 3, 2, 8, 0, 0, grey, 3);
    CHECK(is_known(read_picture("layer_%05u.png", "layer_00000.png", png.bytes, png.size, SF_OK)));
    png_make(&png, 2, 3, 8, 0, 0, grey, 2);
    CHECK(read_picture("layer_%05u.png", "layer_00000.png", png.bytes, png.size, SF_ERR_FORMAT) ==
          NULL);
    png_make(&png, 3, 2, 8, 2, 0, colour, 9);
    CHECK(read_picture("layer_%05u.png", "layer_00000.png", png.bytes, png.size,
                       SF_ERR_UNSUPPORTED) == NULL);
}

// What this build writes as PBM and as PNG is the same picture.
static void both_kinds_agree(void)
{
    sf_grid *grid = random_grid(77, 13, 1, 0), *other = random_grid(77, 13, 1, 0);
    for (int kind = 0; kind <= sf_stack_has_png(); kind++) {
        memory_folder folder;
        sf_folder files = memory_begin_folder(&folder);
        sf_sink sink;
        sf_source source;
        sf_fault fault;
        CHECK_EQ(files.begin(files.user, "x", &sink), SF_OK);
        CHECK_EQ(sfi_picture_write((sfi_picture_kind)kind, sf_grid_slice(grid, 0), sink), SF_OK);
        CHECK_EQ(files.commit(files.user, 1), SF_OK);
        CHECK_EQ(files.open(files.user, "x", &source), SF_OK);
        CHECK_EQ(sfi_picture_read((sfi_picture_kind)kind, source, NULL, "x",
                                  sf_grid_slice(other, 0), 0, &fault),
                 SF_OK);
        files.close(files.user, source);
        CHECK(sf_grid_equal(grid, other));
        memory_end_folder(&folder);
    }
    sf_grid_destroy(grid);
    sf_grid_destroy(other);
}

static void writes_pictures_in_colour(void)
{
    static const uint8_t pixels[2 * 3 * 3] = {255, 0, 0};
    memory_folder folder;
    sf_folder files = memory_begin_folder(&folder);
    sf_sink sink, none = {NULL, NULL};
    CHECK_EQ(files.begin(files.user, "x", &sink), SF_OK);
    if (!sf_stack_has_png()) {
        CHECK_EQ(sf_png_write_rgb(pixels, 3, 2, sink), SF_ERR_UNSUPPORTED);
        return;
    }
    CHECK_EQ(sf_png_write_rgb(pixels, 3, 2, sink), SF_OK);
    CHECK_EQ(files.commit(files.user, 1), SF_OK);
    static const unsigned char head[] = {0x89, 'P', 'N', 'G', 13, 10, 26, 10, 0, 0, 0, 13, 'I',
                                         'H',  'D', 'R', 0,   0,  0,  3,  0,  0, 0, 2, 8,  2};
    CHECK(folder.files[0].size > 40 && memcmp(folder.files[0].bytes, head, sizeof head) == 0);
    CHECK_EQ(sf_png_write_rgb(NULL, 3, 2, sink), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_png_write_rgb(pixels, 0, 2, sink), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_png_write_rgb(pixels, 3, 70000, sink), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_png_write_rgb(pixels, 3, 2, none), SF_ERR_ARGUMENT);
    folder.budget = 30;
    CHECK_EQ(files.begin(files.user, "y", &sink), SF_OK);
    CHECK_EQ(sf_png_write_rgb(pixels, 3, 2, sink), SF_ERR_IO);
    CHECK_EQ(files.commit(files.user, 0), SF_OK);
    memory_end_folder(&folder);
}

int main(void)
{
    TEST(round_trips);
    TEST(reads_pbm_the_right_way_up);
    TEST(reads_png_the_right_way_up);
    TEST(both_kinds_agree);
    TEST(writes_pictures_in_colour);
    return test_finish();
}
