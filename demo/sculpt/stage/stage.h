// SPDX-License-Identifier: MIT
// A stage: triangles, lines, points and pictures that a workspace wants to have drawn.
//
// It is a list and knows no graphics card; stage_view.h draws it. A workspace clears it and fills
// it anew whenever what it shows has changed.

#ifndef SCULPT_STAGE_STAGE_H
#define SCULPT_STAGE_STAGE_H

#include <stddef.h>
#include <stdint.h>

typedef struct stage_vertex {
    float at_mm[3];
    uint8_t rgba[4]; // sRGB, and how opaque: 255 entirely
} stage_vertex;

// A disc that faces the viewer, drawn over all that is solid.
typedef struct stage_point {
    float at_mm[3];
    float radius_px;
    uint8_t rgba[4];
} stage_point;

// Kinds of what is made of vertices.
typedef enum stage_kind {
    STAGE_SOLID,     // triangles, lit, each flat; alpha is not looked at
    STAGE_SMOOTH,    // triangles, lit, with the normals that go with them
    STAGE_BARE,      // triangles, unlit: a cut plane, whose colours are to be read
    STAGE_GLASS,     // triangles, lit on both sides, blended over what is behind
    STAGE_LINE,      // pairs, hidden by what is solid before them
    STAGE_LINE_OVER, // pairs, over all
    STAGE_KIND_COUNT
} stage_kind;

// A picture in the window's upper right corner, drawn pixel for pixel, magnified by a whole number
// where there is room.
typedef struct stage_picture {
    const unsigned char *rgb; // row 0 on top, 3 bytes a pixel; the stage's own copy
    uint32_t width, height;
} stage_picture;

typedef struct stage stage;

stage *stage_create(void); // NULL where there is no memory
void stage_destroy(stage *s);

// Nothing is on it.
void stage_clear(stage *s);

// Add vertices, three for each triangle or two for each line; copied. STAGE_SMOOTH has `normals`,
// three numbers a vertex, of any length; the others have NULL. 0 where there is no memory, and then
// nothing was added.
int stage_add(stage *s, stage_kind kind, const stage_vertex *vertices, const float *normals,
              size_t count);
int stage_add_point(stage *s, const stage_point *point);

// The one picture; NULL takes it away. 0 where there is no memory: then none is there.
int stage_set_picture(stage *s, const unsigned char *rgb, uint32_t width, uint32_t height);

// What is on it. They stay until it is changed.
const stage_vertex *stage_vertices(const stage *s, stage_kind kind, size_t *count);
const float *stage_normals(const stage *s); // of STAGE_SMOOTH
const stage_point *stage_points(const stage *s, size_t *count);
stage_picture stage_get_picture(const stage *s);

// Goes up with each change.
uint64_t stage_version(const stage *s);

#endif
