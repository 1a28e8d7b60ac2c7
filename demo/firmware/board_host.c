// SPDX-License-Identifier: MIT
// The machine that the firmware is written on: the same program, to try it and to compare with.

#include "board.h"

#include <stdio.h>

static char **arguments;
static int argument_count;
static FILE *opened[4];
static int opened_count;

const char *board_argument(int index)
{
    return index < argument_count ? arguments[index] : NULL;
}

void board_print(const char *text)
{
    fputs(text, stdout);
}

static int open_as(const char *path, const char *mode)
{
    if (opened_count == 4) {
        return -1;
    }
    opened[opened_count] = fopen(path, mode);
    return opened[opened_count] != NULL ? opened_count++ : -1;
}

int board_open(const char *path)
{
    return open_as(path, "rb");
}

int board_open_to_change(const char *path)
{
    int file = open_as(path, "r+b");
    return file >= 0 ? file : open_as(path, "w+b");
}

size_t board_read(int file, void *bytes, size_t size)
{
    return fread(bytes, 1, size, opened[file]);
}

int board_seek(int file, uint32_t offset)
{
    return fseek(opened[file], (long)offset, SEEK_SET) == 0;
}

int board_write(int file, const void *bytes, size_t size)
{
    return fwrite(bytes, 1, size, opened[file]) == size && fflush(opened[file]) == 0;
}

uint32_t board_clock(void)
{
    return 0;
}

uint32_t board_since(uint32_t then)
{
    (void)then;
    return 0;
}

uint32_t board_stack_used(void)
{
    return 0;
}

int main(int count, char **words)
{
    arguments = words;
    argument_count = count;
    return firmware();
}
