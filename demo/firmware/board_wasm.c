// SPDX-License-Identifier: MIT
// A page, or node: the firmware as WebAssembly, with files and console from JavaScript (run.mjs).
//
// Nothing stands behind it but eight functions that the host gives. clang may call memcpy and
// memset whatever is asked of it, so they are here: a printer has them from its C library.

#include "board.h"

#define FROM_HOST(name) __attribute__((import_module("board"), import_name(#name)))

FROM_HOST(argument) uint32_t host_argument(int index, char *text, uint32_t capacity);
FROM_HOST(print) void host_print(const char *text, uint32_t size);
FROM_HOST(open) int host_open(const char *path, uint32_t size, int to_change);
FROM_HOST(read) uint32_t host_read(int file, void *bytes, uint32_t size);
FROM_HOST(seek) int host_seek(int file, uint32_t offset);
FROM_HOST(write) int host_write(int file, const void *bytes, uint32_t size);

void *memcpy(void *to, const void *from, size_t size);
void *memset(void *to, int byte, size_t size);

void *memcpy(void *to, const void *from, size_t size)
{
    volatile uint8_t *out = to;
    const uint8_t *in = from;
    for (size_t i = 0; i < size; i++) {
        out[i] = in[i];
    }
    return to;
}

void *memset(void *to, int byte, size_t size)
{
    volatile uint8_t *out = to;
    for (size_t i = 0; i < size; i++) {
        out[i] = (uint8_t)byte;
    }
    return to;
}

static uint32_t length_of(const char *text)
{
    uint32_t length = 0;
    while (text[length] != '\0') {
        length++;
    }
    return length;
}

const char *board_argument(int index)
{
    static char texts[8][256];
    if (index < 0 || index >= 8) {
        return NULL;
    }
    uint32_t size = host_argument(index, texts[index], sizeof texts[index] - 1);
    texts[index][size] = '\0';
    return size > 0 ? texts[index] : NULL;
}

void board_print(const char *text)
{
    host_print(text, length_of(text));
}

int board_open(const char *path)
{
    return host_open(path, length_of(path), 0);
}

int board_open_to_change(const char *path)
{
    return host_open(path, length_of(path), 1);
}

size_t board_read(int file, void *bytes, size_t size)
{
    return host_read(file, bytes, size);
}

int board_seek(int file, uint32_t offset)
{
    return host_seek(file, offset);
}

int board_write(int file, const void *bytes, size_t size)
{
    return host_write(file, bytes, size);
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
