// SPDX-License-Identifier: MIT
// What the example firmware asks of the machine that it runs on.

#ifndef FIRMWARE_BOARD_H
#define FIRMWARE_BOARD_H

#include <stddef.h>
#include <stdint.h>

// Words on the command line, as a debugger passes them; NULL past the last.
const char *board_argument(int index);

void board_print(const char *text);

// Bytes of a file, front to back, and at any place; a negative number is no file.
int board_open(const char *path);
int board_open_to_change(const char *path); // made anew where it is not there
size_t board_read(int file, void *bytes, size_t size);
int board_seek(int file, uint32_t offset); // 0: it could not
int board_write(int file, const void *bytes, size_t size);

// A clock, and how many instructions ran since it showed `then`: 0 where the machine does not
// count.
uint32_t board_clock(void);
uint32_t board_since(uint32_t then);

// The most bytes of stack that were in use since the start: 0 where nobody knows.
uint32_t board_stack_used(void);

// The program.
int firmware(void);

#endif
