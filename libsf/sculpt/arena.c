// SPDX-License-Identifier: MIT
// Arena: one block of memory, handed out and taken back in pieces, so that a model takes all of its
// memory when it is made and no brush ever waits for the system, or is refused by it.
//
// First fit over a list of gaps in order of address; a piece is cut from the end of its gap, and
// joins its neighbours when it comes back. A piece begins with one unit that holds its size. There
// are never more than a few dozen pieces, and most come back in the reverse order, so that the list
// stays short.
//
// Source: D. E. Knuth, "The Art of Computer Programming", volume 1, section 2.5 (first fit, with a
// list in order of address).

#include "sculpt/arena.h"

#include "base/size.h"

static size_t units_of(size_t size)
{
    size_t padded;
    return sfi_size_add(size, 2 * SFI_ALIGN - 1, &padded) ? padded / SFI_ALIGN : 0;
}

size_t sfi_arena_cost(size_t size)
{
    return units_of(size) * SFI_ALIGN;
}

void sfi_arena_place(sfi_arena *arena, void *block, size_t size)
{
    sfi_gap *gap = size >= SFI_ALIGN ? block : NULL;
    if (gap != NULL) {
        gap->units = size / SFI_ALIGN;
        gap->next = NULL;
    }
    arena->gaps = gap;
}

static void *take(void *user, size_t size, size_t align)
{
    sfi_arena *arena = user;
    size_t units = units_of(size);
    if (units == 0 || align > SFI_ALIGN) {
        return NULL;
    }
    for (sfi_gap **link = &arena->gaps; *link != NULL; link = &(*link)->next) {
        sfi_gap *gap = *link;
        if (gap->units < units) {
            continue;
        }
        gap->units -= units;
        unsigned char *piece = (unsigned char *)gap + gap->units * SFI_ALIGN;
        if (gap->units == 0) {
            *link = gap->next;
        }
        ((sfi_gap *)(void *)piece)->units = units;
        return piece + SFI_ALIGN;
    }
    return NULL;
}

// Whether one gap ends where the next begins.
static int touches(const sfi_gap *gap, const sfi_gap *next)
{
    return (const unsigned char *)gap + gap->units * SFI_ALIGN == (const unsigned char *)next;
}

static void join(sfi_gap *gap)
{
    if (gap->next != NULL && touches(gap, gap->next)) {
        gap->units += gap->next->units;
        gap->next = gap->next->next;
    }
}

static void give_back(void *user, void *memory, size_t size)
{
    sfi_arena *arena = user;
    sfi_gap *piece = (sfi_gap *)(void *)((unsigned char *)memory - SFI_ALIGN), *before = NULL;
    (void)size;
    sfi_gap **link = &arena->gaps;
    while (*link != NULL && *link < piece) {
        before = *link;
        link = &before->next;
    }
    piece->next = *link;
    *link = piece;
    join(piece);
    if (before != NULL) {
        join(before);
    }
}

sf_allocator sfi_arena_allocator(sfi_arena *arena)
{
    sf_allocator allocator = {take, give_back, arena};
    return allocator;
}
