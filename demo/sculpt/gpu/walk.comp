// SPDX-License-Identifier: MIT
// Walk: what is printable, brought up to date after a change of what is drawn within a box.
//
// The change of T in a layer lies within the box's rectangle there and the dilation of the change
// in the layer below: one rectangle walks up, and past the box the first layer without a change is
// the last. How far a cascade reaches is known to nobody before it is over, so one work group does
// all of it: between layers it needs a barrier, where a dispatch for each layer would need the host
// to ask how it went, or to go up to the top each time. Mirrors walk_up() of
// libsf/support/trim/trim_box.c, with D and T two grids.
//
// The rectangle of layer k is kept in slot k % 3: while it is written, the one below is read and
// the one above is emptied, so that a barrier for each layer is enough.
#define SHARED coherent
#include "grid.glsl"
#include "state.glsl"

layout(local_size_x = 256) in;

READ(printable_at, printable)
DILATE(carried, printable_at)

shared uint low_x[3], low_y[3], high_x[3], high_y[3];

void clear(uint slot)
{
    low_x[slot] = low_y[slot] = NONE;
    high_x[slot] = high_y[slot] = 0u;
}

box rectangle(uint slot, uint z)
{
    return box(low_x[slot], low_y[slot], z, high_x[slot], high_y[slot], z + 1u);
}

// A rectangle grown by a voxel, or nothing.
box grow(box r)
{
    return r.x0 >= r.x1 ? empty_box()
                        : box(max(r.x0, 1u) - 1u, max(r.y0, 1u) - 1u, r.z0,
                              min(r.x1 + 1u, counts.x), min(r.y1 + 1u, counts.y), r.z1);
}

// One word of a layer; notes what changes.
void renew(uint w, uint y, uint z)
{
    uint i = place(w, y, z), fresh = drawn[i], slot = z % 3u;
    fresh = z < bed ? 0u : z == bed ? fresh : fresh & carried(w, y, z - 1u);
    uint change = fresh ^ printable[i];
    if (change != 0u) {
        printable[i] = fresh;
        atomicMin(low_x[slot], w * 32u + uint(findLSB(change)));
        atomicMax(high_x[slot], w * 32u + uint(findMSB(change)) + 1u);
        atomicMin(low_y[slot], y);
        atomicMax(high_y[slot], y + 1u);
    }
}

void main()
{
    uint me = gl_LocalInvocationIndex, z;
    box e = ledger.edit, all = e;
    if (me < 3u) {
        clear(me);
    }
    memoryBarrierShared();
    barrier();
    for (z = e.z0; z < counts.z; z++) {
        box below = rectangle((z + 2u) % 3u, z - 1u), r = grow(below);
        if (below.x0 < below.x1) {
            all = join(all, below);
        }
        if (z < e.z1) {
            r = join(r, box(e.x0, e.y0, z, e.x1, e.y1, z + 1u));
        }
        if (r.x0 >= r.x1) {
            break;
        }
        if (me == 0u) {
            clear((z + 1u) % 3u);
        }
        r.z0 = z;
        r.z1 = z + 1u;
        uint n = words_in(r);
        for (uint i = me; i < n; i += 256u) {
            uvec3 at = word_of(r, i);
            renew(at.x, at.y, z);
        }
        memoryBarrierShared();
        memoryBarrierBuffer();
        barrier();
    }
    if (me == 0u && e.x0 < e.x1) {
        box top = rectangle((z + 2u) % 3u, z - 1u);
        all = top.x0 < top.x1 ? join(all, top) : all;
        ledger.changed = join(ledger.changed, all);
        ledger.touched = join(ledger.touched, all);
    }
}
