// SPDX-License-Identifier: MIT
// The command line, as a function.

#ifndef DEMO_SF_CLI_H
#define DEMO_SF_CLI_H

// What `sf` does with these words, argv[0] the program's name; its exit status.
int sf_cli_main(int argc, char **argv);

#endif
