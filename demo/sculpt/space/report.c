// SPDX-License-Identifier: MIT
// Reports of SpaceMice. All models speak alike, but for where they put the turns:
//
//     1  x y z              in models on a cable: three numbers of 16 bits, low byte first
//     2  rx ry rz
//     1  x y z rx ry rz     in models without a cable, and those with a screen
//     3  a bit for each button, 2 to 6 bytes
//
// So the length tells which a report 1 is, and no table of models is needed for the axes. Others
// (the battery, 23; keys of the Enterprise that have no bit, 28 and 29) are left alone. What a
// device describes about itself, in the terms of USB's "Device Class Definition for HID" 1.11, says
// the same; tests/space/report.c reads such descriptions and compares.
//
// Axes are those of the "HID Usage Tables", section 4.2.

#include "report.h"

enum { REPORT_MOVE = 1, REPORT_TURN = 2, REPORT_BUTTONS = 3 };
enum { LOGITECH = SPACE_VENDOR_OLD, CONNEXION = SPACE_VENDOR };

// The buttons of all but the two oldest with many keys continue the layout of those that have two:
// menu, fit, and escape as the 23rd. What its maker brings after this table is taken to as well.
static const space_model models[] = {
    {LOGITECH, 0xc603, 0, 1, -1},  // SpaceMouse Plus XT
    {LOGITECH, 0xc605, 0, 1, -1},  // CADman
    {LOGITECH, 0xc606, 0, 1, -1},  // SpaceMouse Classic
    {LOGITECH, 0xc621, 0, 1, -1},  // Spaceball 5000
    {LOGITECH, 0xc623, 0, 1, -1},  // SpaceTraveler
    {LOGITECH, 0xc625, 0, 14, 10}, // SpacePilot
    {LOGITECH, 0xc626, 0, 1, -1},  // SpaceNavigator
    {LOGITECH, 0xc627, 0, 10, 6},  // SpaceExplorer
    {LOGITECH, 0xc628, 0, 1, -1},  // SpaceNavigator for Notebooks
    {LOGITECH, 0xc629, 0, 1, 22},  // SpacePilot Pro
    {LOGITECH, 0xc62b, 0, 1, 22},  // SpaceMouse Pro
    {CONNEXION, 0xc62e, 0, 1, -1}, // SpaceMouse Wireless, on its cable
    {CONNEXION, 0xc62f, 0, 1, -1}, // and by its receiver
    {CONNEXION, 0xc631, 0, 1, 22}, // SpaceMouse Pro Wireless, on its cable
    {CONNEXION, 0xc632, 0, 1, 22}, // and by its receiver
    {CONNEXION, 0xc633, 0, 1, 22}, // SpaceMouse Enterprise
    {CONNEXION, 0xc635, 0, 1, -1}, // SpaceMouse Compact
    {CONNEXION, 0xc636, 0, 1, -1}, // SpaceMouse Module
    {CONNEXION, 0xc638, 0, 1, 22}, // SpaceMouse Pro Wireless, by Bluetooth
    {CONNEXION, 0xc63a, 0, 1, -1}, // SpaceMouse Wireless, by Bluetooth
    {CONNEXION, 0xc641, 0, 1, -1}, // SpaceMouse Module, on USB
    {CONNEXION, 0xc652, 0, 1, 22}, // Universal Receiver
    {CONNEXION, 0, 0, 1, 22},
};

const space_model *space_model_of(unsigned short vendor, unsigned short product)
{
    for (size_t i = 0; i < sizeof models / sizeof *models; i++) {
        if (models[i].vendor == vendor &&
            (models[i].product == product || models[i].product == 0)) {
            return &models[i];
        }
    }
    return NULL;
}

int space_model_is_known(const space_model *model)
{
    return model->product != 0;
}

static void read_axes(int *axes, const unsigned char *bytes, int count)
{
    for (int i = 0; i < count; i++) {
        int number = bytes[2 * i] | bytes[2 * i + 1] << 8;
        axes[i] = number < 0x8000 ? number : number - 0x10000;
    }
}

int space_report_read(space_state *state, const unsigned char *bytes, size_t size)
{
    if (size >= 13 && bytes[0] == REPORT_MOVE) {
        read_axes(state->axes, bytes + 1, 6);
    } else if (size >= 7 && bytes[0] == REPORT_MOVE) {
        read_axes(state->axes + SPACE_X, bytes + 1, 3);
    } else if (size >= 7 && bytes[0] == REPORT_TURN) {
        read_axes(state->axes + SPACE_RX, bytes + 1, 3);
    } else if (size >= 2 && bytes[0] == REPORT_BUTTONS) {
        state->buttons = 0;
        for (size_t i = 1; i < size && i < 5; i++) {
            state->buttons |= (uint32_t)bytes[i] << 8 * (i - 1);
        }
    } else {
        return 0;
    }
    return 1;
}
