// SPDX-License-Identifier: MIT
// A SpaceMouse that is misread sends the camera where nobody pushed it. What is read is held
// against reports that devices have sent, with what was done to them, and against what devices
// describe of themselves, which a reader of such descriptions, sharing nothing with the other,
// turns into numbers. What is cut off or not meant for us changes nothing.

#include "test.h"

#include "space/report.h"

// ---------------------------------------------------------------------------------------------
// What was sent
// ---------------------------------------------------------------------------------------------

typedef struct sent {
    unsigned char bytes[13];
    size_t size;
    int axes[SPACE_AXES]; // after it
    uint32_t buttons;
} sent;

static void follow(const sent *reports, size_t count)
{
    space_state state = {{0, 0, 0, 0, 0, 0}, 0};
    for (size_t n = 0; n < count; n++) {
        CHECK_EQ(space_report_read(&state, reports[n].bytes, reports[n].size), 1);
        for (int i = 0; i < SPACE_AXES; i++) {
            CHECK_EQ(state.axes[i], reports[n].axes[i]);
        }
        CHECK_EQ(state.buttons, reports[n].buttons);
    }
}

// A SpaceNavigator that is turned with its right side down, and whose buttons are pressed.
static void navigator(void)
{
    static const sent reports[] = {
        {{0x01, 0, 0, 0, 0, 0, 0}, 7, {0, 0, 0, 0, 0, 0}, 0},
        {{0x02, 0, 0, 0xe2, 0xff, 0, 0}, 7, {0, 0, 0, 0, -30, 0}, 0},
        {{0x03, 0x01, 0}, 3, {0, 0, 0, 0, -30, 0}, 1},
        {{0x03, 0x00, 0}, 3, {0, 0, 0, 0, -30, 0}, 0},
        {{0x03, 0x02, 0}, 3, {0, 0, 0, 0, -30, 0}, 2},
        {{0x03, 0x03, 0}, 3, {0, 0, 0, 0, -30, 0}, 3},
    };
    follow(reports, sizeof reports / sizeof *reports);
}

// A SpaceMouse Compact that is pressed down and turned a little.
static void compact(void)
{
    static const sent reports[] = {
        {{0x02, 0x20, 0, 0, 0, 0x17, 0}, 7, {0, 0, 0, 32, 0, 23}, 0},
        {{0x01, 0x12, 0, 0, 0, 0xf8, 0}, 7, {18, 0, 248, 32, 0, 23}, 0},
        {{0x02, 0x20, 0, 0, 0, 0x19, 0}, 7, {18, 0, 248, 32, 0, 25}, 0},
        {{0x01, 0x12, 0, 0, 0, 0x12, 0x01}, 7, {18, 0, 274, 32, 0, 25}, 0},
        {{0x02, 0x1d, 0, 0, 0, 0x1b, 0}, 7, {18, 0, 274, 29, 0, 27}, 0},
        {{0x01, 0x0d, 0, 0, 0, 0x25, 0x01}, 7, {13, 0, 293, 29, 0, 27}, 0},
    };
    follow(reports, sizeof reports / sizeof *reports);
}

// The battery of a SpaceMouse Wireless is full.
static void battery(void)
{
    static const unsigned char bytes[] = {0x17, 0x64, 0x01};
    space_state state = {{1, 2, 3, 4, 5, 6}, 7}, before = state;
    CHECK_EQ(space_report_read(&state, bytes, sizeof bytes), 0);
    CHECK(memcmp(&state, &before, sizeof state) == 0);
}

// ---------------------------------------------------------------------------------------------
// What devices describe
// ---------------------------------------------------------------------------------------------

// A number within a report.
typedef struct field {
    unsigned report, at, bits; // its first bit, after the report's number
    unsigned page, usage;
} field;

typedef struct description {
    field fields[64];
    int count;
    unsigned bits[256]; // of each report
} description;

// Fields of an item `Input`; those that hold a list of usages are no fields of ours.
static void add_input(description *d, const uint32_t global[16], const uint32_t *usages, int count,
                      uint32_t least, unsigned flags)
{
    unsigned report = global[8] & 255;
    for (unsigned i = 0; i < global[9]; i++) {
        field f = {report, d->bits[report], global[7], global[0], 0};
        f.usage = (int)i < count ? usages[i] : least + i;
        if ((flags & 3) == 2 && d->count < 64) {
            d->fields[d->count++] = f;
        }
        d->bits[report] += global[7];
    }
}

// "Device Class Definition for HID" 1.11, section 6.2.2: short items.
static description describe(const unsigned char *bytes, size_t size)
{
    description d;
    uint32_t global[16] = {0}, usages[16], least = 0;
    int count = 0;
    memset(&d, 0, sizeof d);
    for (size_t at = 0; at < size;) {
        unsigned prefix = bytes[at], length = prefix & 3, type = prefix >> 2 & 3, tag = prefix >> 4;
        uint32_t value = 0;
        length = length == 3 ? 4 : length;
        for (unsigned i = 0; i < length && at + 1 + i < size; i++) {
            value |= (uint32_t)bytes[at + 1 + i] << 8 * i;
        }
        at += 1 + length;
        if (type == 1) {
            global[tag] = value;
        } else if (type == 2 && tag == 0 && count < 16) {
            usages[count++] = value;
        } else if (type == 2 && tag == 1) {
            least = value;
        } else if (type == 0) {
            if (tag == 8) {
                add_input(&d, global, usages, count, least, value);
            }
            count = 0;
            least = 0;
        }
    }
    return d;
}

static const unsigned char navigator_says[] = {
    0x05, 0x01, 0x09, 0x08, 0xa1, 0x01, 0xa1, 0x00, 0x85, 0x01, 0x16, 0xa2, 0xfe, 0x26, 0x5e,
    0x01, 0x36, 0x88, 0xfa, 0x46, 0x78, 0x05, 0x55, 0x0c, 0x65, 0x11, 0x09, 0x30, 0x09, 0x31,
    0x09, 0x32, 0x75, 0x10, 0x95, 0x03, 0x81, 0x06, 0xc0, 0xa1, 0x00, 0x85, 0x02, 0x09, 0x33,
    0x09, 0x34, 0x09, 0x35, 0x75, 0x10, 0x95, 0x03, 0x81, 0x06, 0xc0, 0xa1, 0x02, 0x85, 0x03,
    0x05, 0x01, 0x05, 0x09, 0x19, 0x01, 0x29, 0x02, 0x15, 0x00, 0x25, 0x01, 0x35, 0x00, 0x45,
    0x01, 0x75, 0x01, 0x95, 0x02, 0x81, 0x02, 0x95, 0x0e, 0x81, 0x03, 0xc0};

static const unsigned char wireless_says[] = {
    0x05, 0x01, 0x09, 0x08, 0xa1, 0x01, 0xa1, 0x00, 0x85, 0x01, 0x16, 0xa2, 0xfe, 0x26, 0x5e, 0x01,
    0x36, 0x88, 0xfa, 0x46, 0x78, 0x05, 0x55, 0x0c, 0x65, 0x11, 0x09, 0x30, 0x09, 0x31, 0x09, 0x32,
    0x09, 0x33, 0x09, 0x34, 0x09, 0x35, 0x75, 0x10, 0x95, 0x06, 0x81, 0x02, 0xc0, 0xa1, 0x02, 0x85,
    0x03, 0x05, 0x01, 0x05, 0x09, 0x19, 0x01, 0x29, 0x02, 0x15, 0x00, 0x25, 0x01, 0x35, 0x00, 0x45,
    0x01, 0x75, 0x01, 0x95, 0x02, 0x81, 0x02, 0x95, 0x0e, 0x81, 0x03, 0xc0, 0xa1, 0x02, 0x85, 0x04,
    0x05, 0x08, 0x09, 0x4b, 0x15, 0x00, 0x25, 0x01, 0x95, 0x01, 0x75, 0x01, 0x91, 0x02, 0x95, 0x01,
    0x75, 0x07, 0x91, 0x03, 0xc0, 0xa1, 0x02, 0x85, 0x17, 0x15, 0x00, 0x25, 0x64, 0x55, 0x00, 0x65,
    0x00, 0x05, 0x06, 0x09, 0x20, 0x75, 0x08, 0x95, 0x01, 0x81, 0x02, 0x15, 0x00, 0x25, 0x01, 0x06,
    0x00, 0xff, 0x09, 0x27, 0x75, 0x01, 0x95, 0x01, 0x81, 0x02, 0x75, 0x07, 0x81, 0x03, 0xc0};

static const unsigned char enterprise_says[] = {
    0x05, 0x01, 0x09, 0x08, 0xa1, 0x01, 0xa1, 0x00, 0x85, 0x01, 0x16, 0xa2, 0xfe, 0x26, 0x5e,
    0x01, 0x36, 0x88, 0xfa, 0x46, 0x78, 0x05, 0x55, 0x0c, 0x65, 0x11, 0x09, 0x30, 0x09, 0x31,
    0x09, 0x32, 0x09, 0x33, 0x09, 0x34, 0x09, 0x35, 0x75, 0x10, 0x95, 0x06, 0x81, 0x02, 0xc0,
    0xa1, 0x02, 0x85, 0x03, 0x05, 0x01, 0x05, 0x09, 0x19, 0x01, 0x29, 0x1f, 0x15, 0x00, 0x25,
    0x01, 0x35, 0x00, 0x45, 0x01, 0x75, 0x01, 0x95, 0x1f, 0x81, 0x02, 0x95, 0x01, 0x81, 0x03,
    0xc0, 0xa1, 0x02, 0x85, 0x1c, 0x05, 0x01, 0x05, 0x09, 0x19, 0x00, 0x2a, 0xff, 0x00, 0x15,
    0x00, 0x26, 0xff, 0x00, 0x35, 0x00, 0x46, 0xff, 0x00, 0x75, 0x10, 0x95, 0x06, 0x81, 0x00};

// A report of random numbers, as described, and what it does to a state. 1 where it does anything.
static int compose(const description *d, unsigned report, unsigned char *bytes, space_state *state)
{
    int says = 0;
    bytes[0] = (unsigned char)report;
    for (int n = 0; n < d->count; n++) {
        const field *f = &d->fields[n];
        uint32_t value = f->bits == 16 ? test_random_below(0x10000) : test_random_below(2);
        if (f->report != report) {
            continue;
        }
        for (unsigned i = 0; i < f->bits; i++) {
            unsigned at = 8 + f->at + i, bit = value >> i & 1;
            bytes[at / 8] = (unsigned char)(bytes[at / 8] | bit << at % 8);
        }
        if (f->page == 1 && f->usage >= 0x30 && f->usage < 0x36) {
            state->axes[f->usage - 0x30] = value < 0x8000 ? (int)value : (int)value - 0x10000;
            says = 1;
        } else if (f->page == 9) {
            uint32_t mask = (uint32_t)1 << (f->usage - 1);
            state->buttons = value != 0 ? state->buttons | mask : state->buttons & ~mask;
            says = 1;
        }
    }
    return says;
}

static void hold_against(const unsigned char *says, size_t size, int reports, int fields)
{
    description d = describe(says, size);
    space_state state = {{0, 0, 0, 0, 0, 0}, 0}, expected = state;
    int spoken = 0;
    CHECK_EQ(d.count, fields);
    for (unsigned report = 1; report < 256; report++) {
        size_t length = 1 + (d.bits[report] + 7) / 8;
        for (int n = 0; d.bits[report] > 0 && n < 1000; n++) {
            // As large as the report, so that reading past it is seen.
            unsigned char *bytes = calloc(length, 1);
            int says_it = bytes != NULL && compose(&d, report, bytes, &expected);
            CHECK_EQ(space_report_read(&state, bytes, length), says_it);
            CHECK(memcmp(&state, &expected, sizeof state) == 0);
            spoken += says_it && n == 0;
            free(bytes);
        }
    }
    CHECK_EQ(spoken, reports);
}

static void descriptions(void)
{
    hold_against(navigator_says, sizeof navigator_says, 3, 8);
    hold_against(wireless_says, sizeof wireless_says, 2, 10);
    hold_against(enterprise_says, sizeof enterprise_says, 2, 37);
}

// ---------------------------------------------------------------------------------------------
// What is no report
// ---------------------------------------------------------------------------------------------

static void nonsense(void)
{
    for (int n = 0; n < 100000; n++) {
        size_t size = test_random_below(16);
        unsigned char *bytes = malloc(size > 0 ? size : 1);
        space_state state = {{1, 2, 3, 4, 5, 6}, 7}, before = state;
        for (size_t i = 0; bytes != NULL && i < size; i++) {
            bytes[i] = (unsigned char)test_random_below(i == 0 ? 6 : 256);
        }
        int number = size > 0 ? bytes[0] : 0;
        int moves = number == 1 && size >= 7, turns = number == 2 && size >= 7;
        int presses = number == 3 && size >= 2;
        CHECK_EQ(space_report_read(&state, bytes, size), moves || turns || presses);
        CHECK(moves || memcmp(state.axes, before.axes, 3 * sizeof(int)) == 0);
        CHECK(turns || (moves && size >= 13) ||
              memcmp(state.axes + 3, before.axes + 3, 3 * sizeof(int)) == 0);
        uint32_t buttons = presses ? 0 : before.buttons;
        for (size_t i = size < 5 ? size : 5; presses && i > 1; i--) {
            buttons = buttons * 256 + bytes[i - 1];
        }
        CHECK_EQ(state.buttons, buttons);
        free(bytes);
    }
}

static void models(void)
{
    const space_model *m = space_model_of(SPACE_VENDOR_OLD, 0xc626);
    CHECK(m != NULL && space_model_is_known(m) && m->fit == 1 && m->escape == -1);
    CHECK(space_model_of(SPACE_VENDOR_OLD, 0xc603) != NULL);
    m = space_model_of(SPACE_VENDOR_OLD, 0xc627);
    CHECK(m != NULL && m->fit == 10 && m->escape == 6);
    m = space_model_of(SPACE_VENDOR, 0xc633);
    CHECK(m != NULL && space_model_is_known(m) && m->fit == 1 && m->escape == 22);
    m = space_model_of(SPACE_VENDOR, 0xffff);
    CHECK(m != NULL && !space_model_is_known(m));
    CHECK(space_model_of(SPACE_VENDOR_OLD, 0xc077) == NULL); // a mouse
    CHECK(space_model_of(SPACE_VENDOR_OLD, 0) == NULL);
    CHECK(space_model_of(0x1234, 0xc626) == NULL);
}

int main(void)
{
    TEST(navigator);
    TEST(compact);
    TEST(battery);
    TEST(descriptions);
    TEST(nonsense);
    TEST(models);
    return test_finish();
}
