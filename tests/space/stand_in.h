// SPDX-License-Identifier: MIT
// A stand-in for hidapi: devices that a test plugs in, pulls out, lets speak and forbids.

#ifndef TEST_SPACE_STAND_IN_H
#define TEST_SPACE_STAND_IN_H

#include <hidapi.h>
#include <stdlib.h>
#include <string.h>

enum { PLACES = 8, REPORTS = 8 };

typedef struct hid_device_ {
    int is_there, is_forbidden, is_broken, is_endless;
    unsigned short vendor, product, page, usage;
    char *path;
    unsigned char reports[REPORTS][16];
    size_t sizes[REPORTS];
    int first, last; // of what it has yet to say
    int is_open;
} place;

static place places[PLACES];
static int init_fails, inits, exits, looks, opens, closes, reads, nodes;

static void reset(void)
{
    memset(places, 0, sizeof places);
    init_fails = inits = exits = looks = opens = closes = reads = nodes = 0;
}

static place *plug(int at, unsigned short vendor, unsigned short product, unsigned short page,
                   unsigned short usage, char *path)
{
    place fresh;
    memset(&fresh, 0, sizeof fresh);
    fresh.is_there = 1;
    fresh.vendor = vendor;
    fresh.product = product;
    fresh.page = page;
    fresh.usage = usage;
    fresh.path = path;
    places[at] = fresh;
    return &places[at];
}

static void say(place *p, const unsigned char *bytes, size_t size)
{
    memcpy(p->reports[p->last], bytes, size);
    p->sizes[p->last++] = size;
}

int hid_init(void)
{
    inits++;
    return init_fails ? -1 : 0;
}

int hid_exit(void)
{
    exits++;
    return 0;
}

struct hid_device_info *hid_enumerate(unsigned short vendor_id, unsigned short product_id)
{
    struct hid_device_info *all = NULL;
    looks++;
    for (int i = PLACES - 1; i >= 0; i--) {
        const place *p = &places[i];
        if (p->is_there && p->vendor == vendor_id &&
            (product_id == 0 || product_id == p->product)) {
            struct hid_device_info *info = calloc(1, sizeof *info);
            if (info == NULL) {
                abort();
            }
            info->path = p->path;
            info->vendor_id = p->vendor;
            info->product_id = p->product;
            info->usage_page = p->page;
            info->usage = p->usage;
            info->next = all;
            all = info;
            nodes++;
        }
    }
    return all;
}

void hid_free_enumeration(struct hid_device_info *devs)
{
    while (devs != NULL) {
        struct hid_device_info *next = devs->next;
        free(devs);
        nodes--;
        devs = next;
    }
}

hid_device *hid_open_path(const char *path)
{
    for (int i = 0; i < PLACES; i++) {
        place *p = &places[i];
        if (p->is_there && !p->is_forbidden && p->path != NULL && strcmp(p->path, path) == 0) {
            p->is_open++;
            opens++;
            return p;
        }
    }
    return NULL;
}

void hid_close(hid_device *dev)
{
    dev->is_open--;
    closes++;
}

int hid_read_timeout(hid_device *dev, unsigned char *data, size_t length, int milliseconds)
{
    reads++;
    if (milliseconds != 0) {
        abort(); // a poll never waits
    }
    if (!dev->is_there || dev->is_broken) {
        return -1;
    }
    if (dev->is_endless) {
        memset(data, 0, length);
        data[0] = 1;
        data[1] = 100;
        return 7;
    }
    if (dev->first == dev->last) {
        return 0;
    }
    size_t size = dev->sizes[dev->first];
    memcpy(data, dev->reports[dev->first], size < length ? size : length);
    dev->first++;
    return (int)size;
}

#endif
