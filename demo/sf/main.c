// SPDX-License-Identifier: MIT
// sf: the command line of libsf.

#include <sf/base.h>

#include <stdio.h>

int main(void)
{
    printf("sf %s\n", sf_version());
    return 0;
}
