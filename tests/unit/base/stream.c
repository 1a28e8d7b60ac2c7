// SPDX-License-Identifier: MIT
// Why: readers trust a source to give what it says and no more; the one over memory must hold to
// that wherever its cursor stands, which is the caller's to set.

#include "test.h"

#include <sf/base.h>

static void memory_is_read_front_to_back(void)
{
    unsigned char bytes[8];
    sf_memory_cursor cursor = {"abcdefg", 7, 0};
    sf_source source = sf_memory_source(&cursor);
    size_t size = 99;
    CHECK_EQ(source.read(source.user, bytes, 3, &size), SF_OK);
    CHECK(size == 3 && memcmp(bytes, "abc", 3) == 0 && cursor.position == 3);
    CHECK_EQ(source.read(source.user, bytes, 8, &size), SF_OK);
    CHECK(size == 4 && memcmp(bytes, "defg", 4) == 0 && cursor.position == 7);
    CHECK_EQ(source.read(source.user, bytes, 8, &size), SF_OK);
    CHECK_EQ(size, 0);
}

static void a_cursor_beyond_the_end_is_at_the_end(void)
{
    unsigned char bytes[8] = {9};
    sf_memory_cursor cursor = {"abc", 3, 4};
    sf_source source = sf_memory_source(&cursor);
    size_t size = 99;
    CHECK_EQ(source.read(source.user, bytes, 8, &size), SF_OK);
    CHECK_EQ(size, 0);
    CHECK_EQ(bytes[0], 9);
    CHECK_EQ(cursor.position, 4);
}

int main(void)
{
    TEST(memory_is_read_front_to_back);
    TEST(a_cursor_beyond_the_end_is_at_the_end);
    return test_finish();
}
