// SPDX-License-Identifier: MIT
// Open: a call begins, and so may a stroke.
//
// The host knows the box around the tips, this shader writes it down. Mirrors extend() of
// libsf/sculpt/stroke.c.
#include "grid.glsl"
#include "state.glsl"

layout(local_size_x = 1) in;
layout(location = 2) uniform uvec3 low; // the box; low.x >= high.x where it is empty
layout(location = 3) uniform uvec3 high;
layout(location = 4) uniform uint is_first; // call of a stroke

void main()
{
    box b = low.x < high.x ? box(low.x, low.y, low.z, high.x, high.y, high.z) : empty_box();
    if (is_first != 0u) {
        ledger.touched = empty_box();
        ledger.path_voxels = 0u;
    }
    ledger.edit = b;
    ledger.changed = b;
    ledger.touched = join(ledger.touched, b);
    ledger.is_bed_wanted = 0u;
}
