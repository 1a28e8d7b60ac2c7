// SPDX-License-Identifier: MIT
// A `new` of C++ that fails the k-th time, for gltf_memory.c.

#include <cstddef>
#include <cstdlib>
#include <new>

static long requests, fail_at = -1, live;

extern "C" void new_fails_at(long k)
{
    requests = 0;
    fail_at = k;
}

extern "C" long new_live(void)
{
    return live;
}

static void *take(std::size_t size) noexcept
{
    bool refused = fail_at >= 0 && requests++ == fail_at;
    void *memory = refused ? nullptr : std::malloc(size > 0 ? size : 1);
    live += memory != nullptr;
    return memory;
}

void *operator new(std::size_t size)
{
    void *memory = take(size);
    if (memory == nullptr) {
        throw std::bad_alloc();
    }
    return memory;
}

void *operator new(std::size_t size, const std::nothrow_t &) noexcept
{
    return take(size);
}

void operator delete(void *memory) noexcept
{
    live -= memory != nullptr;
    std::free(memory);
}

void operator delete(void *memory, std::size_t) noexcept
{
    operator delete(memory);
}
