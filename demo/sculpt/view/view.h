// SPDX-License-Identifier: MIT
// The view of a model: its voxels ray-marched where they lie, in the memory of the graphics card.
//
// Drawing is deferred. A ray for each pixel goes through the bits and leaves what it meets: how far
// away, which face of a voxel, which material, whether a ghost lies before it. Normals are smoothed
// in the picture, with what lies near; then light falls on it. So what drawing costs depends on the
// picture, and hardly on the shape.
//
// A context of OpenGL 4.5 must be current in all calls.

#ifndef SCULPT_VIEW_VIEW_H
#define SCULPT_VIEW_VIEW_H

#include <sf/sculpt.h>

#include "camera.h"
#include "gpu/gpu_sculpt.h"

typedef struct view view;

// The colours of materials 1 to 8, and of 9 and on again: RGB, told apart by most who see colours
// otherwise.
#define VIEW_PALETTE_COUNT 8
extern const unsigned char view_palette[VIEW_PALETTE_COUNT][3];

// What is drawn beside the shape.
typedef struct view_overlays {
    int ghosts;       // what is drawn and not printable, translucent
    int overhangs;    // faces below what leans on its neighbours, in a colour of their own
    int ground;       // the bed, with lines each 10 mm
    int shadows;      // of the light
    int is_cut;       // cut away what lies on the near side of cut_mm along cut_axis
    int cut_axis;     // 0, 1, 2: x, y, z; what is above cut_mm goes
    double cut_mm;    // in the lattice's frame
    int has_cursor;   // where a brush would be put
    double cursor[3]; // its centre, mm
    double reach[3];  // half its extents, mm
    int is_box;       // its shape: a box, else an ellipsoid
    int has_plane;    // a sketch plane through the cursor
    int plane_axis;   // that it is at right angles to
} view_overlays;

view_overlays view_overlays_default(void);

// Make a view. NULL where that fails, and *why is a sentence that says why.
view *view_create(const char **why);
void view_destroy(view *v);

// What is looked at: buffers as gpu_sculpt_view() gives them, and the lattice that they are on, of
// layers of one height. They must stay while the view draws.
void view_look_at(view *v, const gpu_view *buffers, const sf_lattice *lattice, uint32_t bed_layer);

// Voxels within a box have changed; all of them where box is NULL.
void view_changed(view *v, const sf_box *box);

// Draw into a framebuffer of OpenGL; 0 is the window's. A size of 0 draws nothing. 0 where there
// is no memory for the picture.
int view_draw(view *v, const view_camera *camera, const view_overlays *overlays,
              unsigned framebuffer, uint32_t width, uint32_t height);

// Draw a picture, row 0 on top, 3 bytes a pixel. 0 where there is no memory.
int view_shot(view *v, const view_camera *camera, const view_overlays *overlays, uint32_t width,
              uint32_t height, unsigned char *pixels);

#endif
