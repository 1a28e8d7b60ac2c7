// SPDX-License-Identifier: MIT
// The small linear program of the multipliers: which mixture of bodies is best.

#ifndef SF_BALANCE_PROGRAM_H
#define SF_BALANCE_PROGRAM_H

#include <stddef.h>

enum { SFI_PROGRAM_COLUMNS = 96, SFI_PROGRAM_ROWS = 12 };

// Over mixtures mix >= 0 that sum up to 1, and a shortfall t that each row may be helped by:
//
//     least   sum cost_i mix_i + penalty * t      where   sum gain_ei mix_i + t >= 0  for each e
//
// t >= 0, or of either sign where `is_free` is set.
typedef struct sfi_program {
    size_t row_count, column_count; // at least 1 column; with is_free at least 1 row
    double cost[SFI_PROGRAM_COLUMNS];
    double gain[SFI_PROGRAM_ROWS][SFI_PROGRAM_COLUMNS];
    double penalty; // above 0
    int is_free;
} sfi_program;

// Prices are of the rows: what the least would rise by if one were to be above 0, not only at it.
typedef struct sfi_program_answer {
    double mix[SFI_PROGRAM_COLUMNS];
    double price[SFI_PROGRAM_ROWS]; // >= 0; their sum is at most the penalty, and is it where t is
                                    // free
    double shortfall;               // t
    double least;
} sfi_program_answer;

void sfi_program_solve(const sfi_program *program, sfi_program_answer *answer);

#endif
