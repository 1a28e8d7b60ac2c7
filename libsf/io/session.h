// SPDX-License-Identifier: MIT
// A session, seen from inside.

#ifndef SF_IO_SESSION_H
#define SF_IO_SESSION_H

#include <sf/session.h>

#include "io/list.h"

#define SFI_SESSION_WORD "libsf-session"
#define SFI_SESSION_VERSION 1
#define SFI_SESSION_TIPS_MAX (UINT32_C(1) << 20)
#define SFI_SESSION_MASK_MAX (UINT64_C(1) << 27) // voxels

// Words of tips by formula, by sf_tip_shape, and of steps, by sf_session_step.
extern const char *const sfi_session_shapes[4];
extern const char *const sfi_session_steps[3];

// Voxels in a row, of one material.
typedef struct sfi_session_run {
    uint32_t z, y, x, length;
    uint8_t material;
} sfi_session_run;

typedef struct sfi_session_tip {
    int is_mask;
    sf_tip_shape shape; // where it is none
    double radius_vx[3];
    sf_tip *tip;
} sfi_session_tip;

typedef enum sfi_session_kind { SFI_STEP_STROKE, SFI_STEP_SHAPE, SFI_STEP_OTHER } sfi_session_kind;

// A step: a stroke has `count` dabs from `first` on, a shape as many runs.
typedef struct sfi_session_item {
    sfi_session_kind kind;
    sf_session_step other;
    sf_brush brush; // without its tip
    uint32_t tip;
    size_t first, count;
} sfi_session_item;

struct sf_session {
    sf_allocator allocator;
    sf_session_options options;
    sf_rule rule;
    sfi_list tips;  // sfi_session_tip
    sfi_list items; // sfi_session_item
    sfi_list dabs;  // sf_dab
    sfi_list runs;  // sfi_session_run, of shapes
    sfi_list state; // sfi_session_run
    int has_state;
    size_t strokes;
};

// Runs of what is solid, with materials (NULL: 1), appended to a list.
sf_status sfi_session_runs_of(const sf_session *session, const sf_grid *drawn,
                              const uint8_t *materials, sfi_list *runs);

// Whether a run lies in the session's space and has a material.
int sfi_session_run_is_valid(const sf_session *session, const sfi_session_run *run);

#endif
