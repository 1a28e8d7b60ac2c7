// SPDX-License-Identifier: MIT
// Why: rows of voxels must start on 64-byte boundaries whatever malloc gives, growing must keep
// what is there, and a refusal must leave everything as it was.

#include "base/memory.h"
#include "test.h"

static void default_memory_is_aligned_and_writable(void)
{
    sf_allocator allocator = sfi_allocator_or_default(NULL);
    for (size_t size = 1; size < 300; size++) {
        unsigned char *memory = sfi_alloc_array(&allocator, size, 1);
        CHECK(memory != NULL);
        CHECK_EQ((uintptr_t)memory % SFI_ALIGN, 0);
        memset(memory, 0xa5, size);
        sfi_free_array(&allocator, memory, size, 1);
    }
}

static void products_that_overflow_are_refused(void)
{
    sf_allocator allocator = sfi_allocator_or_default(NULL);
    CHECK(sfi_alloc_array(&allocator, SIZE_MAX / 2, 3) == NULL);
    CHECK(sfi_alloc_array(&allocator, SIZE_MAX, 1) == NULL);
    CHECK(sfi_alloc_array(&allocator, 0, 8) == NULL);
}

static void growing_keeps_contents(void)
{
    sf_allocator allocator = sfi_allocator_or_default(NULL);
    void *memory = NULL;
    size_t capacity = 0;
    for (uint32_t i = 0; i < 1000; i++) {
        CHECK(sfi_grow_array(&allocator, &memory, &capacity, i + 1, sizeof(uint32_t)));
        ((uint32_t *)memory)[i] = i * i;
    }
    for (uint32_t i = 0; i < 1000; i++) {
        CHECK_EQ(((uint32_t *)memory)[i], i * i);
    }
    void *before = memory;
    size_t capacity_before = capacity;
    CHECK(!sfi_grow_array(&allocator, &memory, &capacity, SIZE_MAX / 2, sizeof(uint32_t)));
    CHECK(memory == before && capacity == capacity_before);
    sfi_free_array(&allocator, memory, capacity, sizeof(uint32_t));
}

static void a_copy_is_of_all_or_of_nothing(void)
{
    static const uint32_t from[3] = {5, 7, 11};
    sf_allocator allocator = sfi_allocator_or_default(NULL);
    void *copy = &allocator;
    CHECK(sfi_copy_array(&allocator, NULL, 0, sizeof *from, &copy) && copy == NULL);
    CHECK(!sfi_copy_array(&allocator, from, SIZE_MAX / 2, sizeof *from, &copy) && copy == NULL);
    CHECK(sfi_copy_array(&allocator, from, 3, sizeof *from, &copy));
    CHECK(memcmp(copy, from, sizeof from) == 0);
    sfi_free_array(&allocator, copy, 3, sizeof *from);
}

int main(void)
{
    TEST(default_memory_is_aligned_and_writable);
    TEST(products_that_overflow_are_refused);
    TEST(growing_keeps_contents);
    TEST(a_copy_is_of_all_or_of_nothing);
    return test_finish();
}
