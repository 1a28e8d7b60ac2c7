// SPDX-License-Identifier: MIT
// Calls of some of the library's functions, in any order, with any arguments: what targets of a
// family of functions share. After the world's bytes, two choose each call; all that is made is
// used by later calls. Arguments are made by calls of other families, too, where a recipe needs
// them.

#ifndef SF_FUZZ_FAMILY_H
#define SF_FUZZ_FAMILY_H

#include "target.h"

#include "world.h"

enum { FAMILY_CALLS = 16, FAMILY_MOST = 512 };

static inline int is_of_family(const world_call *call, const char *const *headers)
{
    for (; *headers != NULL; headers++) {
        if (strcmp(call->header, *headers) == 0) {
            return 1;
        }
    }
    return 0;
}

// The functions of these headers; NULL for all functions.
static inline void call_family(const uint8_t *data, size_t size, const char *const *headers)
{
    static const world_call *family[FAMILY_MOST];
    static size_t count;
    for (size_t i = 0; count == 0 || i > 0; i++) {
        if (i == world_call_count) {
            break;
        }
        if (headers == NULL || is_of_family(&world_calls[i], headers)) {
            family[count++] = &world_calls[i];
        }
    }
    world *w = malloc(sizeof *w);
    world_begin(w, data, size, 0);
    for (int i = 0; i < FAMILY_CALLS && w->in.at < w->in.size; i++) {
        uint32_t choice = draw_byte(&w->in);
        choice = choice << 8 | draw_byte(&w->in);
        const world_call *chosen = family[choice % count];
        if (chosen->rarity == 1 || draw_byte(&w->in) % chosen->rarity == 0) {
            w->break_at = -1;
            (void)!chosen->call(w);
        }
    }
    world_end(w);
    free(w);
}

#endif
