// SPDX-License-Identifier: MIT
// CLI in: geometry in binary.
//
// Behind the head stand commands to the end of the file: two bytes say which, with two more where
// the head asks for alignment, then its numbers, little-endian. Short ones are whole numbers of 16
// bits, long ones of 32 bits and floats.
//
// Source: "Common Layer Interface (CLI), Version 2.0", Brite EuRam BE 2578, 1994, section 3.

#include "base/status.h"
#include "io/contours.h"

#include <string.h>

enum {
    LAYER_LONG = 127,
    LAYER_SHORT = 128,
    POLYLINE_SHORT = 129,
    POLYLINE_LONG = 130,
    HATCHES_SHORT = 131,
    HATCHES_LONG = 132
};

static sf_status cut_short(sfi_cli *cli)
{
    return sfi_cursor_fault(&cli->cursor, cli->fault,
                            "the file is cut short; copy or export it again");
}

static sf_status read_u16(sfi_cli *cli, uint32_t *value)
{
    unsigned char b[2];
    if (sfi_cursor_read(&cli->cursor, b, 2) < 2) {
        return cut_short(cli);
    }
    *value = b[0] | (uint32_t)b[1] << 8;
    return SF_OK;
}

static sf_status read_u32(sfi_cli *cli, uint32_t *value)
{
    unsigned char b[4];
    if (sfi_cursor_read(&cli->cursor, b, 4) < 4) {
        return cut_short(cli);
    }
    *value = b[0] | (uint32_t)b[1] << 8 | (uint32_t)b[2] << 16 | (uint32_t)b[3] << 24;
    return SF_OK;
}

static sf_status read_count(sfi_cli *cli, int is_long, uint32_t *value)
{
    return is_long ? read_u32(cli, value) : read_u16(cli, value);
}

static sf_status read_real(sfi_cli *cli, int is_long, double *value)
{
    uint32_t bits = 0;
    float single;
    SF_TRY(read_count(cli, is_long, &bits));
    memcpy(&single, &bits, sizeof single);
    *value = is_long ? (double)single : (double)bits;
    return SF_OK;
}

static sf_status read_polyline(sfi_cli *cli, int is_long)
{
    uint32_t id = 0, way = 0, count = 0;
    double x = 0, y = 0;
    SF_TRY(read_count(cli, is_long, &id));
    SF_TRY(read_count(cli, is_long, &way));
    SF_TRY(read_count(cli, is_long, &count));
    SF_TRY(sfi_cli_contour(cli));
    for (uint32_t i = 0; i < count; i++) {
        SF_TRY(read_real(cli, is_long, &x));
        SF_TRY(read_real(cli, is_long, &y));
        SF_TRY(sfi_cli_point(cli, x, y));
    }
    return sfi_cli_contour_end(cli, way);
}

static sf_status skip_hatches(sfi_cli *cli, int is_long)
{
    uint32_t id = 0, count = 0, number = 0;
    SF_TRY(read_count(cli, is_long, &id));
    SF_TRY(read_count(cli, is_long, &count));
    for (uint64_t i = 0; i < (uint64_t)4 * count; i++) {
        SF_TRY(read_count(cli, is_long, &number));
    }
    return SF_OK;
}

static sf_status read_command(sfi_cli *cli, uint32_t command)
{
    double height = 0;
    switch (command) {
    case LAYER_LONG:
    case LAYER_SHORT:
        SF_TRY(read_real(cli, command == LAYER_LONG, &height));
        return sfi_cli_layer(cli, height);
    case POLYLINE_SHORT:
    case POLYLINE_LONG:
        return read_polyline(cli, command == POLYLINE_LONG);
    case HATCHES_SHORT:
    case HATCHES_LONG:
        return skip_hatches(cli, command == HATCHES_LONG);
    default:
        return sfi_cursor_fault(&cli->cursor, cli->fault,
                                "a command that CLI does not know; export the file again");
    }
}

sf_status sfi_cli_read_binary(sfi_cli *cli)
{
    size_t have = 0;
    uint32_t command = 0, padding = 0;
    for (;;) {
        (void)sfi_cursor_peek(&cli->cursor, 1, &have);
        if (have == 0) {
            return cli->cursor.failure != SF_OK ? cut_short(cli) : SF_OK;
        }
        SF_TRY(read_u16(cli, &command));
        if (cli->is_aligned) {
            SF_TRY(read_u16(cli, &padding));
        }
        SF_TRY(read_command(cli, command));
    }
}
