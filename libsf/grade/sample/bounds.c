// SPDX-License-Identifier: MIT
// The box around a shape: that of its skin, and by as much larger as the skin may be off.

#include <sf/sample.h>

#include "base/memory.h"
#include "base/status.h"
#include "grade/limit/boxes.h"
#include "grade/sample/skin.h"

#include <math.h>
#include <string.h>

sf_status sf_limit_bounds(const sf_limit *limit, const sf_allocator *allocator, sf_task *task,
                          double low_mm[3], double high_mm[3])
{
    if (limit == NULL || low_mm == NULL || high_mm == NULL) {
        return SF_ERR_ARGUMENT;
    }
    if (limit->refined->dimension != 3) {
        return SF_ERR_UNSUPPORTED;
    }
    sf_allocator kept = sfi_allocator_or_default(allocator);
    sfi_box points =
        sfi_box_around(limit->refined->positions[1], limit->refined->layouts[0].points[1]);
    double diagonal = 0;
    for (uint32_t axis = 0; axis < 3; axis++) {
        double side = points.high[axis] - points.low[axis];
        diagonal += side * side;
    }
    sfi_skin skin;
    double tolerance = 1e-3 * sqrt(diagonal);
    SF_TRY(sfi_skin_make(limit, tolerance > 0 ? tolerance : 1, &kept, task, &skin));
    sfi_box box = sfi_box_around(skin.vertices, (uint32_t)skin.vertex_count);
    for (uint32_t axis = 0; axis < 3; axis++) {
        low_mm[axis] = box.low[axis] - skin.error_mm;
        high_mm[axis] = box.high[axis] + skin.error_mm;
    }
    sfi_skin_free(&skin);
    return SF_OK;
}
