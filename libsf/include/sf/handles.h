// SPDX-License-Identifier: MIT
// Handles: a few places of a solid, and how the whole follows them.

#ifndef SF_HANDLES_H
#define SF_HANDLES_H

#include <sf/mesh.h>

#ifdef __cplusplus
extern "C" {
#endif

/** What becomes of a handle: p -> scale * turn (p - centre) + centre + shift. */
typedef struct sf_pose {
    double scale;       /**< 1 leaves the size */
    double turn[9];     /**< a rotation, row after row; not checked to be one */
    double shift_mm[3]; /**< added last */
} sf_pose;

#ifdef __cplusplus
}
#endif

#endif
