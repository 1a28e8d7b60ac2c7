// SPDX-License-Identifier: MIT
// SpaceMice by hidapi: found, heard, lost and found again.
//
// One looks for devices once a second while no cap is held, because looking takes longer than
// listening. All that are there are listened to: a receiver stays where its mouse is on the cable,
// and says nothing. A device that fails is let go, cap and buttons with it, and found again when it
// is back. A cap that is held reports many times a second; one that has been silent for longer is
// taken to be free, so that a mouse that goes out of reach does not leave the camera turning.

#include "space.h"

#include <hidapi.h>
#include <stdlib.h>
#include <string.h>

enum { DEVICES_MOST = 4, REPORTS_MOST = 64, REPORT_SIZE = 64, PATH_SIZE = 512 };

// USB's numbers for a device of many axes.
enum { PAGE_DESKTOP = 1, USAGE_MULTI_AXIS = 8 };

// Seconds.
#define LOOK 1.0
#define SILENCE 0.5
#define FRAME 0.016
#define STEP_MOST 0.1

typedef struct device {
    hid_device *hid; // NULL: none in this place
    const space_model *model;
    char path[PATH_SIZE];
    space_state state;
    double heard_s;
} device;

struct space {
    int is_ready; // whether hidapi is
    device devices[DEVICES_MOST];
    int has_looked, has_polled;
    double looked_s, polled_s;
    const char *trouble;
};

// ---------------------------------------------------------------------------------------------
// Life
// ---------------------------------------------------------------------------------------------

space *space_create(void)
{
    space *s = calloc(1, sizeof *s);
    if (s != NULL) {
        s->is_ready = hid_init() == 0;
    }
    return s;
}

static void let_go(device *d)
{
    if (d->hid != NULL) {
        hid_close(d->hid);
    }
    memset(d, 0, sizeof *d);
}

void space_destroy(space *s)
{
    if (s == NULL) {
        return;
    }
    for (int i = 0; i < DEVICES_MOST; i++) {
        let_go(&s->devices[i]);
    }
    if (s->is_ready) {
        hid_exit();
    }
    free(s);
}

// ---------------------------------------------------------------------------------------------
// Finding
// ---------------------------------------------------------------------------------------------

// What a device is, or NULL where it is none of ours. Where hidapi cannot say what it is for (by
// libusb it cannot) its number has to be one that is known: its maker has plain mice as well.
static const space_model *model_of(const struct hid_device_info *info)
{
    const space_model *model = space_model_of(info->vendor_id, info->product_id);
    if (model == NULL || info->path == NULL || strlen(info->path) >= PATH_SIZE) {
        return NULL;
    }
    if (info->usage_page == 0 && info->usage == 0) {
        return space_model_is_known(model) ? model : NULL;
    }
    return info->usage_page == PAGE_DESKTOP && info->usage == USAGE_MULTI_AXIS ? model : NULL;
}

static int is_open(const space *s, const char *path)
{
    for (int i = 0; i < DEVICES_MOST; i++) {
        if (s->devices[i].hid != NULL && strcmp(s->devices[i].path, path) == 0) {
            return 1;
        }
    }
    return 0;
}

static device *free_place(space *s)
{
    for (int i = 0; i < DEVICES_MOST; i++) {
        if (s->devices[i].hid == NULL) {
            return &s->devices[i];
        }
    }
    return NULL;
}

static void find(space *s, unsigned short vendor)
{
    struct hid_device_info *all = hid_enumerate(vendor, 0);
    for (const struct hid_device_info *info = all; info != NULL; info = info->next) {
        const space_model *model = model_of(info);
        device *d = free_place(s);
        if (model == NULL || d == NULL || is_open(s, info->path)) {
            continue;
        }
        d->hid = hid_open_path(info->path);
        if (d->hid == NULL) {
            s->trouble = "There is a SpaceMouse that may not be read; docs/sculpt.md says what "
                         "lets you.";
            continue;
        }
        d->model = model;
        memcpy(d->path, info->path, strlen(info->path) + 1);
    }
    hid_free_enumeration(all);
}

static void look(space *s, double now_s)
{
    s->has_looked = 1;
    s->looked_s = now_s;
    s->trouble = NULL;
    find(s, SPACE_VENDOR_OLD);
    find(s, SPACE_VENDOR);
}

// ---------------------------------------------------------------------------------------------
// Hearing
// ---------------------------------------------------------------------------------------------

static int is_held(const device *d)
{
    const space_state rest = {{0, 0, 0, 0, 0, 0}, 0};
    return memcmp(d->state.axes, rest.axes, sizeof rest.axes) != 0;
}

static int is_any_held(const space *s)
{
    for (int i = 0; i < DEVICES_MOST; i++) {
        if (is_held(&s->devices[i])) {
            return 1;
        }
    }
    return 0;
}

// All that a device has said, up to as many reports as no device says between two frames.
static void hear(device *d, double now_s, double step_s, space_motion *motion)
{
    unsigned char bytes[REPORT_SIZE];
    int size = 1;
    for (int n = 0; size > 0 && n < REPORTS_MOST; n++) {
        uint32_t before = d->state.buttons;
        size = hid_read_timeout(d->hid, bytes, sizeof bytes, 0);
        if (size > 0 && space_report_read(&d->state, bytes, (size_t)size)) {
            d->heard_s = now_s;
            space_motion_press(motion, d->model, before, d->state.buttons);
        }
    }
    if (size < 0) {
        let_go(d);
        return;
    }
    if (now_s - d->heard_s > SILENCE) {
        memset(d->state.axes, 0, sizeof d->state.axes);
    }
    space_motion_add(motion, &d->state, step_s);
}

int space_poll(space *s, double now_s, space_motion *motion)
{
    memset(motion, 0, sizeof *motion);
    if (!s->is_ready) {
        return 0;
    }
    if (!s->has_looked || (now_s - s->looked_s >= LOOK && !is_any_held(s))) {
        look(s, now_s);
    }
    double step_s = s->has_polled ? now_s - s->polled_s : 0;
    step_s = step_s < 0 ? 0 : step_s > STEP_MOST ? STEP_MOST : step_s;
    s->has_polled = 1;
    s->polled_s = now_s;
    for (int i = 0; i < DEVICES_MOST; i++) {
        if (s->devices[i].hid != NULL) {
            hear(&s->devices[i], now_s, step_s, motion);
        }
    }
    return !space_motion_is_none(motion);
}

double space_patience(const space *s)
{
    for (int i = 0; i < DEVICES_MOST; i++) {
        if (s->devices[i].hid != NULL) {
            return FRAME;
        }
    }
    return LOOK;
}

const char *space_trouble(const space *s)
{
    return s->trouble;
}
