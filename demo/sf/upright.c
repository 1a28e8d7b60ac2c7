// SPDX-License-Identifier: MIT
// Turning a part so that the axis that points up becomes z.
//
// Row i of a map says which input axis becomes build axis i, and its sign. One axis stays in place
// wherever that is possible, so that pictures show the part from the side that one expects.

#include "upright.h"

#include <string.h>

static const signed char turns[6][9] = {
    [AXIS_X] = {0, 0, -1, 0, 1, 0, 1, 0, 0}, [AXIS_MINUS_X] = {0, 0, 1, 0, 1, 0, -1, 0, 0},
    [AXIS_Y] = {1, 0, 0, 0, 0, -1, 0, 1, 0}, [AXIS_MINUS_Y] = {1, 0, 0, 0, 0, 1, 0, -1, 0},
    [AXIS_Z] = {1, 0, 0, 0, 1, 0, 0, 0, 1},  [AXIS_MINUS_Z] = {1, 0, 0, 0, -1, 0, 0, 0, -1},
};

sf_transform upright(axis up, double factor)
{
    sf_transform made;
    memset(&made, 0, sizeof made);
    for (int i = 0; i < 9; i++) {
        made.matrix[i] = factor * turns[up][i] + 0.0; // no negative zeros
    }
    return made;
}

sf_transform upright_back(axis up)
{
    sf_transform made;
    memset(&made, 0, sizeof made);
    for (int i = 0; i < 9; i++) {
        made.matrix[i] = turns[up][3 * (i % 3) + i / 3];
    }
    return made;
}
