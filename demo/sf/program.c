// SPDX-License-Identifier: MIT
// The program itself: all it does is in a library, so that others can be it as well.

#include "cli.h"

int main(int argc, char **argv)
{
    return sf_cli_main(argc, argv);
}
