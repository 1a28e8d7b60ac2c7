// SPDX-License-Identifier: MIT
// What a SpaceMouse says, and which of its buttons mean what.

#ifndef SCULPT_SPACE_REPORT_H
#define SCULPT_SPACE_REPORT_H

#include <stddef.h>
#include <stdint.h>

// Where the cap is pushed to and how it is turned: x to the right, y towards the person, z down,
// and turns about these by the rule of the right hand.
enum { SPACE_X, SPACE_Y, SPACE_Z, SPACE_RX, SPACE_RY, SPACE_RZ, SPACE_AXES };

// The number for a cap that is pushed as far as it goes; some say a little more.
#define SPACE_FULL 350

typedef struct space_state {
    int axes[SPACE_AXES];
    uint32_t buttons; // bit i: button i is held
} space_state;

// Their maker's number, and that of the one before.
enum { SPACE_VENDOR = 0x256f, SPACE_VENDOR_OLD = 0x046d };

// A kind of device. Buttons are numbers of bits, -1 where it has none.
typedef struct space_model {
    unsigned short vendor, product; // product 0: any that is not listed
    signed char undo, fit, escape;
} space_model;

// The model, or NULL where that is no SpaceMouse.
const space_model *space_model_of(unsigned short vendor, unsigned short product);

// Whether the model is listed, rather than one that may be any device of its maker.
int space_model_is_known(const space_model *model);

// Take a report, whose first byte is its number. 0: it says nothing about cap or buttons, or is cut
// off, and the state is as it was.
int space_report_read(space_state *state, const unsigned char *bytes, size_t size);

#endif
