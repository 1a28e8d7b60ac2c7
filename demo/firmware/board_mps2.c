// SPDX-License-Identifier: MIT
// The boards mps2-an386 (Cortex-M4) and mps2-an500 (Cortex-M7): start, and files through the
// debugger.
//
// A start in C needs three things: a table whose first words are the stack and where to begin, the
// variables that have values copied out of read-only memory, and the others zeroed. Files and the
// console are those of whoever debugs the board, by Arm's semihosting, which qemu-system-arm
// speaks: a breakpoint with a number in r0 and an argument in r1.
//
// The stack is painted at the start, so that it can be told how much of it was ever used. The clock
// is SysTick, which counts 24 bits down; under `qemu-system-arm -icount shift=0` an instruction
// takes a nanosecond, and a tick of the boards' 25 MHz is 40 instructions.

#include "board.h"

// From mps2.ld.
extern uint32_t stack_low[], stack_top[], data_from[], data_begin[], data_end[], bss_begin[],
    bss_end[];

#define PAINT 0xa5a5a5a5u
#define SYSTICK ((volatile uint32_t *)0xe000e010u) // control, reload, value

// Semihosting operations.
enum {
    OPEN = 1,
    WRITE0 = 4,
    WRITE = 5,
    READ = 6,
    SEEK = 0x0a,
    GET_CMDLINE = 0x15,
    EXIT_EXTENDED = 0x20
};

static uint32_t host(uint32_t operation, const void *argument)
{
    register uint32_t r0 __asm__("r0") = operation;
    register const void *r1 __asm__("r1") = argument;
    __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
    return r0;
}

static uint32_t length_of(const char *text)
{
    uint32_t length = 0;
    while (text[length] != '\0') {
        length++;
    }
    return length;
}

static int open_as(const char *path, uint32_t mode)
{
    uint32_t block[3] = {(uint32_t)(uintptr_t)path, mode, length_of(path)};
    return (int)host(OPEN, block);
}

int board_open(const char *path)
{
    return open_as(path, 1); // "rb"
}

int board_open_to_change(const char *path)
{
    int file = open_as(path, 3);                // "r+b"
    return file >= 0 ? file : open_as(path, 7); // "w+b"
}

size_t board_read(int file, void *bytes, size_t size)
{
    uint32_t block[3] = {(uint32_t)file, (uint32_t)(uintptr_t)bytes, size};
    uint32_t left = host(READ, block);
    return left <= size ? size - left : 0;
}

int board_seek(int file, uint32_t offset)
{
    uint32_t block[2] = {(uint32_t)file, offset};
    return host(SEEK, block) == 0;
}

int board_write(int file, const void *bytes, size_t size)
{
    uint32_t block[3] = {(uint32_t)file, (uint32_t)(uintptr_t)bytes, size};
    return host(WRITE, block) == 0;
}

void board_print(const char *text)
{
    host(WRITE0, text);
}

// Cut a line into words, in place; returns how many there are, at most `capacity`.
static int cut(char *line, const char **words, int capacity)
{
    int count = 0;
    char *at = line;
    while (*at != '\0' && count < capacity) {
        if (*at == ' ') {
            *at++ = '\0';
            continue;
        }
        words[count++] = at;
        while (*at != ' ' && *at != '\0') {
            at++;
        }
    }
    return count;
}

const char *board_argument(int index)
{
    static char line[512];
    static const char *words[8];
    static int count;
    uint32_t block[2] = {(uint32_t)(uintptr_t)line, sizeof line};
    if (count == 0 && host(GET_CMDLINE, block) == 0) {
        count = cut(line, words, 8);
    }
    return index < count ? words[index] : NULL;
}

uint32_t board_clock(void)
{
    return 0xffffffu - SYSTICK[2];
}

uint32_t board_since(uint32_t then)
{
    return ((board_clock() - then) & 0xffffffu) * 40u;
}

uint32_t board_stack_used(void)
{
    const uint32_t *at = stack_low;
    while (at < stack_top && *at == PAINT) {
        at++;
    }
    return (uint32_t)(stack_top - at) * 4;
}

static void stop(int status)
{
    uint32_t block[2] = {0x20026u, (uint32_t)status}; // the application has come to its end
    host(EXIT_EXTENDED, block);
    for (;;) {
    }
}

static void paint_stack(void)
{
    uint32_t here;
    volatile uint32_t *at = stack_low;
    while (at < &here - 32) {
        *at++ = PAINT;
    }
}

void start(void);

void start(void)
{
    uint32_t *from = data_from;
    for (uint32_t *to = data_begin; to < data_end; to++) {
        *to = *from++;
    }
    for (uint32_t *to = bss_begin; to < bss_end; to++) {
        *to = 0;
    }
    paint_stack();
    SYSTICK[1] = 0xffffffu;
    SYSTICK[2] = 0;
    SYSTICK[0] = 5; // on, by the processor's clock
    stop(firmware());
}

static void fault(void)
{
    board_print("firmware: the processor met a fault\n");
    stop(3);
}

__attribute__((section(".vectors"), used)) static void (*const vectors[16])(void) = {
    (void (*)(void))(uintptr_t)stack_top,
    start,
    fault,
    fault,
    fault,
    fault,
    fault,
    fault,
    fault,
    fault,
    fault,
    fault,
    fault,
    fault,
    fault,
    fault};
