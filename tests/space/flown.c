// SPDX-License-Identifier: MIT
// The sculpting program with a SpaceMouse that a test plays: it is there from the start, its cap is
// held turned to the right, and after half a second it has gone silent. The rest of the program is
// as it is; tests/cli/sculpt.sh opens its window and looks at what was recorded.

#define hid_init stand_in_init
#include "stand_in.h"
#undef hid_init

int hid_init(void);

int hid_init(void)
{
    static char path[] = "played";
    static const unsigned char turned[] = {2, 0, 0, 0, 0, 0x2c, 1};
    reset();
    say(plug(0, 0x046d, 0xc626, 1, 8, path), turned, sizeof turned);
    return stand_in_init();
}
