// SPDX-License-Identifier: MIT
// Bridges in millimetres: from a span and an anchor to whole voxels along each direction.
//
// Down for the span, up for the anchor: what is bridged never is longer, nor held by less, than was
// asked for. A little is forgiven first, because 0.3 mm over a pitch of 0.1 mm is a little less
// than 3.

#include "base/status.h"
#include "support/rule/rule.h"

#include <math.h>

#define BRIDGE_SLACK 0x1p-20 // voxels forgiven to a span or an anchor

// A length in voxels, rounded up or down; more than the limit where it does not fit.
static uint32_t whole_voxels(double mm, double pitch, int up)
{
    double voxels = mm / pitch;
    if (voxels > SF_BRIDGE_SPAN_MAX) {
        return SF_BRIDGE_SPAN_MAX + 1;
    }
    return (uint32_t)(up ? -floor(-voxels + BRIDGE_SLACK) : floor(voxels + BRIDGE_SLACK));
}

sf_status sf_rule_set_bridges(sf_rule *rule, double span_mm, double anchor_mm,
                              const sf_lattice *lattice, sf_fault *fault)
{
    if (rule == NULL || lattice == NULL) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "a rule and a lattice are needed");
    }
    sf_status status = sf_lattice_validate(lattice);
    if (status != SF_OK) {
        return sfi_fault_set(fault, status, 0, 0, "the lattice is not a valid one");
    }
    if (!(span_mm >= 0.0) || !(anchor_mm >= 0.0)) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                             "the span of a bridge and its anchor are lengths in mm, 0 or more");
    }
    double px = lattice->pitch_x_mm, py = lattice->pitch_y_mm;
    double pitches[3] = {px, py, sqrt(px * px + py * py)};
    uint32_t spans[3], anchors[3], longest = 0;
    for (int i = 0; i < 3; i++) {
        spans[i] = whole_voxels(span_mm, pitches[i], 0);
        anchors[i] = whole_voxels(anchor_mm, pitches[i], 1);
        longest = spans[i] > longest ? spans[i] : longest;
        longest = anchors[i] > longest ? anchors[i] : longest;
    }
    if (longest > SF_BRIDGE_SPAN_MAX) {
        return sfi_fault_set(fault, SF_ERR_UNSUPPORTED, 0, 0,
                             "a bridge or its anchor is longer than %u voxels; use a larger pitch "
                             "or a shorter one",
                             (unsigned)SF_BRIDGE_SPAN_MAX);
    }
    if (span_mm > 0.0 && spans[0] == 0 && spans[1] == 0) {
        return sfi_fault_set(fault, SF_ERR_UNSUPPORTED, 0, 0,
                             "a bridge of this span is shorter than a voxel; use a smaller pitch, "
                             "or a span of 0 for no bridges");
    }
    sf_bridge none = {0, 0, 0, 0, 0, 0};
    sf_bridge some = {(uint16_t)spans[0],   (uint16_t)spans[1],   (uint16_t)spans[2],
                      (uint16_t)anchors[0], (uint16_t)anchors[1], (uint16_t)anchors[2]};
    rule->bridge = span_mm > 0.0 ? some : none;
    return SF_OK;
}
