// SPDX-License-Identifier: MIT
// An editor: a model, the brush in hand, the camera, and what is shown. It knows no window.
//
// All that a person can do to it is an event (event.h), so what was done can be written down and
// done again without a window, to the same bits.

#ifndef SCULPT_APP_EDITOR_H
#define SCULPT_APP_EDITOR_H

#include <sf/session.h>

#include "desk/desk.h"
#include "event.h"
#include "open.h"
#include "view/view.h"

#ifdef __cplusplus
extern "C" {
#endif

// What the pointer is doing.
typedef enum editor_drag {
    DRAG_NONE,
    DRAG_STROKE /* or what a desk does with it */,
    DRAG_ORBIT,
    DRAG_PAN,
    DRAG_ZOOM
} editor_drag;

// The brush in hand. Lengths in mm, so that they mean the same on any lattice.
typedef struct editor_brush {
    sf_brush_kind kind;
    int shape; // one of sf_tip_shape, or TIP_MESH
    double radius_mm;
    uint8_t material;
    uint32_t passes;
    int mirror_x, mirror_y;
    int plane; // a sketch plane at right angles to: -1 none, 0 x, 1 y, 2 z
} editor_brush;

// Who does all that the model does as well. Called after the model has done it.
typedef struct editor_twin {
    void *user;
    void (*begin)(void *user, const sf_brush *brush);
    void (*dab)(void *user, const sf_dab *dabs, size_t count);
    void (*end)(void *user);
    void (*give_up)(void *user);
    void (*step)(void *user, sf_session_step which);
    void (*replace)(void *user); // the model is another shape now
} editor_twin;

// What is worked at.
typedef enum workspace { WORK_SCULPT, WORK_BALANCE, WORK_GRADE, WORK_COUNT } workspace;

typedef struct editor {
    workspace work;
    desk *desks[WORK_COUNT]; // each made when it is first gone to; sculpting has none
    sf_sculpt *model;
    sf_session *session;     // of all that was done, what can be undone above all
    const editor_twin *twin; // or NULL
    sf_grid *base;           // what was printable when the stroke began: where places are picked
    sf_tip *tip;             // of the brush; NULL where it must be made anew
    sf_mesh *tip_mesh;       // of tips that are no formula; NULL where none was opened
    editor_brush brush;
    sf_brush_kind kind_under_way; // a held key may make it another than the brush's
    view_camera camera;
    view_overlays overlays;
    uint32_t width, height; // of the picture
    double x, y;            // where the pointer is, pixels from the upper left
    editor_drag drag;
    int button;    // that drags
    int has_place; // whether the pointer is over a place
    sf_dab place;  // which
    double at_mm[3];
    sf_dab last;  // dab of the stroke
    sf_dab *dabs; // all of them
    size_t dab_count, dab_capacity;
    sf_box touched;          // by the stroke
    sf_box changed;          // what has to be copied to the card; empty where nothing has
    sf_sculpt_change change; // what the last call said
    int is_recorded; // the session holds all that was done; 0 where it could not be written down
    int wants_close;
    char said[APP_WHY_SIZE]; // what a person should read; empty where nothing
} editor;

// An editor of a model and of the session that made it, both of which it takes over; a NULL session
// is one that begins with what the model is now. NULL where there is no memory: then they go as
// well.
editor *editor_create(sf_sculpt *model, sf_session *session, uint32_t width, uint32_t height);
void editor_destroy(editor *e);

// Take an event.
void editor_take(editor *e, const app_event *event);

// Put another model in the place of this one; the view has to look at it anew. 0 where there is no
// memory: then model and session stay the caller's.
int editor_replace(editor *e, sf_sculpt *model, sf_session *session);

// A session that makes what the model is: that of all that was done, or, where it could not all be
// written down, one that begins with the shape. NULL where there is no memory.
const sf_session *editor_session(editor *e);

// The desk that is worked at; NULL while sculpting.
desk *editor_desk(const editor *e);

// Show all, from the side that the camera is on.
void editor_frame_all(editor *e);

double editor_aspect(const editor *e);

// What is drawn beside the shape, the cursor included.
view_overlays editor_overlays(const editor *e);

#ifdef __cplusplus
}
#endif

#endif
