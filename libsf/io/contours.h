// SPDX-License-Identifier: MIT
// What a CLI file is read into, in text and in binary alike: a layer at a time.

#ifndef SF_IO_CONTOURS_H
#define SF_IO_CONTOURS_H

#include "io/cursor.h"
#include "io/list.h"

#include <sf/contour_io.h>

// A file under way. The first layer waits for the second, whose height says how thick it is.
typedef struct sfi_cli {
    sfi_cursor cursor;
    sf_fault *fault;
    sf_contour_stack *stack; // made with the first layer
    sfi_list points;         // of the layer under way, two doubles each
    sfi_list starts;         // of its contours
    double unit_mm;
    double height_mm; // of the layer under way
    uint64_t layers, said_layers;
    int has_layers, is_binary, is_aligned; // what the head said
    size_t points_left;                    // of the limits
} sfi_cli;

// A layer begins at this height, in the file's unit; what was under way is added to the stack.
sf_status sfi_cli_layer(sfi_cli *cli, double height);

// A contour begins; its points follow, in the file's unit; it ends. way: 0 a hole, 1 an outside, 2
// an open line, which is dropped.
sf_status sfi_cli_contour(sfi_cli *cli);
sf_status sfi_cli_point(sfi_cli *cli, double x, double y);
sf_status sfi_cli_contour_end(sfi_cli *cli, int64_t way);

// contours_binary.c
sf_status sfi_cli_read_binary(sfi_cli *cli);

#endif
