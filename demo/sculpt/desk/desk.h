// SPDX-License-Identifier: MIT
// A desk: a workspace beside sculpting. What can be done at it, and what it shows.
//
// It knows no window, no panel and no graphics card. All that a person does comes as the calls
// below, which are made of events, so that it can be recorded, and done again without a window to
// the same bits. Long work is done in pieces, one for each DO_STEP, which is an event as well.

#ifndef SCULPT_DESK_DESK_H
#define SCULPT_DESK_DESK_H

#include <sf/voxel.h>

#include "stage/stage.h"

enum { DESK_WHY_SIZE = 320 };

// Settings and actions that are a desk's own have numbers from these on; those below are the
// editor's. Of its actions a desk gets DO_UNDO, DO_REDO, DO_CLEAR, DO_GIVE_UP and DO_STEP.
enum { DESK_BALANCE_FIRST = 100, DESK_GRADE_FIRST = 200 };

// Where the pointer is, as a ray. All vectors are of length 1.
typedef struct desk_pointer {
    double eye_mm[3], along[3]; // the ray under it
    double forward[3];          // the middle of the picture
    double right[3], up[3];     // in the picture
    double spread;              // mm that a pixel is wide at a depth of 1 mm
    unsigned mods;              // keys that are held, MOD_SHIFT and so on
} desk_pointer;

typedef struct desk desk;

// What a desk does. Those that may fail say why in a sentence, and leave everything as it was.
typedef struct desk_class {
    const char *name; // as --workspace takes it
    void (*destroy)(desk *d);

    // A file in the place of what is there; or a shape that was sculpted (NULL where it takes
    // none). 0 where that fails.
    int (*open)(desk *d, const char *path, char why[DESK_WHY_SIZE]);
    int (*adopt)(desk *d, const sf_grid *shape, char why[DESK_WHY_SIZE]);

    // Write what there is, by the ending of the name. 0 where that fails.
    int (*save)(const desk *d, const char *path, char why[DESK_WHY_SIZE]);

    void (*hover)(desk *d, const desk_pointer *p); // no button is held
    void (*press)(desk *d, const desk_pointer *p);
    void (*drag)(desk *d, const desk_pointer *p); // between press and release
    void (*release)(desk *d);
    void (*key)(desk *d, int code, unsigned mods);
    void (*set)(desk *d, int setting, double x);
    void (*act)(desk *d, int action);

    int (*is_busy)(const desk *d);  // wants a DO_STEP for the next frame
    int (*show)(desk *d, stage *s); // on a clear stage; 0 where there is no memory
    int (*bounds)(const desk *d, double low[3], double high[3]); // 0 where it is empty
    uint64_t (*hash)(const desk *d);                             // of all that it computed
} desk_class;

// What each desk begins with.
struct desk {
    const desk_class *is;
    int is_stale;             // what it shows has changed since show()
    char said[DESK_WHY_SIZE]; // what a person should read; empty where nothing
};

#endif
