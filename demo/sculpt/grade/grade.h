// SPDX-License-Identifier: MIT
// The Grade workspace, seen from inside.

#ifndef SCULPT_GRADE_GRADE_H
#define SCULPT_GRADE_GRADE_H

#include <sf/limit.h>
#include <sf/refine.h>
#include <sf/voxel.h>

#include "grade_desk.h"

// The surface of the shape: where the cage's refined boundary goes in the end. Its corners are
// those of the finest faces, so that a property may jump between these.
typedef struct grade_surface {
    sf_refinement *refinement;
    uint32_t steps;
    uint32_t *corners; // four points of each face, seen counter-clockwise from outside
    uint32_t *places;  // of each of them the place in the finest cage's list of corners
    size_t face_count;
    uint32_t *starts, *ring;  // of each point its neighbours on the surface: edges, then the points
                              // across faces
    double *points, *normals; // 3 each, of all points; what is not on the surface stays as it is
    double *values;           // of each corner of each face
} grade_surface;

// A cut: the solid voxels in a plane, and what they print.
typedef struct grade_section {
    uint32_t width, height;
    double pitch_mm, origin_mm[3];
    int axis;
    double at_mm;
    uint8_t *solid;    // 1 for each that is
    double *values;    // of the property
    uint8_t *material; // 0 none, else its number and 1
} grade_section;

typedef struct grade {
    desk base;
    grade_state state;
    sf_cage *cage;
    sf_cage_history *history;
    double *selected; // of each point
    double *weights;  // scratch
    grade_surface surface;
    grade_section section;
    int is_section_old;
    int is_pressed, has_moved;
    double grip_mm[3];
} grade;

// ---------------------------------------------------------------------------------------------
// The cage (cage.c)
// ---------------------------------------------------------------------------------------------

// Another cage, the desk's from now on. 0 where that fails: it stays the caller's, all is as it
// was, and `why` gets a sentence.
int grade_take(grade *g, sf_cage *cage, char why[DESK_WHY_SIZE]);

// The cage has been changed: what follows from it is brought up to date, but for the section.
void grade_follow(grade *g, int places_too);

// Say a sentence; nothing: then that cells lie inside out, where some do.
void grade_say(grade *g, const char *text);

// Keep what has been changed as one step.
void grade_record(grade *g);

void grade_undo(grade *g, int is_redo);

// The cage that a desk begins with; NULL where there is no memory.
sf_cage *grade_first_cage(void);

// ---------------------------------------------------------------------------------------------
// The surface (surface.c)
// ---------------------------------------------------------------------------------------------

sf_status grade_surface_make(const sf_cage *cage, grade_surface *s);
void grade_surface_free(grade_surface *s);

// New places, or new values of a property.
sf_status grade_surface_move(grade_surface *s, const double *positions);
sf_status grade_surface_paint(grade_surface *s, size_t channel, const double *values);

// ---------------------------------------------------------------------------------------------
// The section (section.c)
// ---------------------------------------------------------------------------------------------

// Compute it anew. said says why where that fails; then it is empty.
void grade_section_make(grade *g);
void grade_section_free(grade_section *s);

// Where the cut lies.
double grade_cut_mm(const grade *g);

// ---------------------------------------------------------------------------------------------
// The pointer (hand.c)
// ---------------------------------------------------------------------------------------------

void grade_hover(desk *d, const desk_pointer *p);
void grade_press(desk *d, const desk_pointer *p);
void grade_drag(desk *d, const desk_pointer *p);
void grade_release(desk *d);
void grade_count_selected(grade *g);

// ---------------------------------------------------------------------------------------------
// Showing (show.c)
// ---------------------------------------------------------------------------------------------

int grade_show(desk *d, stage *s);

#endif
