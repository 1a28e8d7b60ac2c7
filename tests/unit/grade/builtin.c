// SPDX-License-Identifier: MIT
// Why: the mask that is part of the library is a list of 32,768 numbers, and a list that exists
// twice must not differ: it is what the generator makes, byte for byte. Promise: the same ranks on
// every machine.
//
// usage: unit-grade-builtin [--write]; --write prints libsf/grade/tone/builtin.inc.

#include <sf/halftone.h>

#include "test.h"

static sf_mask *made;

static void write_ranks(void)
{
    for (uint32_t row = 0; row < 32 * 32; row++) {
        for (uint32_t x = 0; x < 32; x++) {
            printf("%u,", (unsigned)sf_mask_rank(made, x, row % 32, row / 32));
        }
        printf("\n");
    }
}

static void the_table_is_what_the_generator_makes(void)
{
    uint32_t size[3], differing = 0;
    sf_mask_size(sf_mask_builtin(), size);
    CHECK(size[0] == 32 && size[1] == 32 && size[2] == 32);
    for (uint32_t i = 0; i < 32768; i++) {
        uint32_t x = i % 32, y = i / 32 % 32, z = i / 1024;
        differing +=
            sf_mask_rank(made, x, y, z) != sf_mask_rank(sf_mask_builtin(), x + 32, y + 64, z + 96);
    }
    CHECK_EQ(differing, 0);
}

static void it_cannot_be_destroyed(void)
{
    sf_mask_destroy((sf_mask *)(uintptr_t)sf_mask_builtin());
    CHECK(sf_mask_rank(sf_mask_builtin(), 1, 2, 3) < 32768);
}

int main(int argc, char **argv)
{
    sf_status status = sf_mask_create(NULL, NULL, NULL, &made);
    if (status != SF_OK) {
        printf("Bail out! %s\n", sf_status_message(status));
        return 1;
    }
    if (argc > 1 && strcmp(argv[1], "--write") == 0) {
        write_ranks();
        sf_mask_destroy(made);
        return 0;
    }
    TEST(the_table_is_what_the_generator_makes);
    TEST(it_cannot_be_destroyed);
    sf_mask_destroy(made);
    return test_finish();
}
