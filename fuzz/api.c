// SPDX-License-Identifier: MIT
// Fuzz target: any functions of the library, in any order, with any arguments.
//
// After the world's bytes two choose each call. All that is made is used by later calls. What each
// call promises is held by world.c: documented statuses only, what fails changes nothing and says
// why, what is read stays, memory comes back, half of the runs with an allocator that refuses now
// and then.

#include "target.h"

#include "world.h"

enum { CALLS = 16 };

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    world *w = malloc(sizeof *w);
    world_begin(w, data, size, 0);
    for (int i = 0; i < CALLS && w->in.at < w->in.size; i++) {
        uint32_t choice = draw_byte(&w->in);
        choice = choice << 8 | draw_byte(&w->in);
        const world_call *chosen = &world_calls[choice % world_call_count];
        if (chosen->rarity == 1 || draw_byte(&w->in) % chosen->rarity == 0) {
            w->break_at = -1;
            (void)!chosen->call(w);
        }
    }
    world_end(w);
    free(w);
    return 0;
}
