// SPDX-License-Identifier: MIT
// What the command line of sculpt asks for.

#ifndef SCULPT_APP_OPTIONS_H
#define SCULPT_APP_OPTIONS_H

#include <stdint.h>

typedef struct app_options {
    int work;            // the workspace to begin in
    const char *file;    // a mesh to begin with, or what its desk opens, or NULL
    const char *scene;   // a scene to begin with, or NULL
    const char *shot;    // a picture to write, or NULL
    const char *input;   // events to replay, or NULL
    const char *record;  // where to write events, or NULL
    const char *session; // a session to begin with, or NULL
    const char *save;    // where to write the session, or what the desk has, at the end; or NULL
    int headless;        // no window
    int hash;            // say what the model is, in a number
    int bench;           // time frames
    int gpu;             // brushes on the graphics card as well
    int keep_drawn;      // what is trimmed stays, as a ghost
    int overhangs;       // show them
    uint32_t resolution;
    uint32_t width, height;    // of the window or the picture
    double azimuth, elevation; // radians
    int is_cut;
    double cut_mm; // above the bed
} app_options;

// What became of the command line.
typedef enum app_asked { APP_GO, APP_DONE, APP_WRONG } app_asked;

// Read it. APP_DONE: help or the version was printed; APP_WRONG: a sentence went to stderr.
app_asked app_options_read(int argc, char **argv, app_options *options);

#endif
