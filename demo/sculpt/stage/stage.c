// SPDX-License-Identifier: MIT
// A stage: triangles, lines, points and pictures that a workspace wants to have drawn.

#include "stage.h"

#include <stdlib.h>
#include <string.h>

typedef struct list {
    unsigned char *items;
    size_t size, capacity; // bytes
} list;

struct stage {
    list vertices[STAGE_KIND_COUNT];
    list normals;
    list points;
    list pixels;
    uint32_t width, height; // of the picture
    uint64_t version;
};

// Room for more bytes at its end; NULL where there is no memory.
static unsigned char *room(list *l, size_t bytes)
{
    if (bytes > SIZE_MAX / 2 - l->size) {
        return NULL;
    }
    if (l->size + bytes > l->capacity) {
        size_t capacity = 2 * (l->size + bytes);
        unsigned char *items = realloc(l->items, capacity);
        if (items == NULL) {
            return NULL;
        }
        l->items = items;
        l->capacity = capacity;
    }
    return l->items + l->size;
}

stage *stage_create(void)
{
    return calloc(1, sizeof(stage));
}

void stage_destroy(stage *s)
{
    if (s != NULL) {
        for (int i = 0; i < STAGE_KIND_COUNT; i++) {
            free(s->vertices[i].items);
        }
        free(s->normals.items);
        free(s->points.items);
        free(s->pixels.items);
        free(s);
    }
}

void stage_clear(stage *s)
{
    for (int i = 0; i < STAGE_KIND_COUNT; i++) {
        s->vertices[i].size = 0;
    }
    s->normals.size = s->points.size = s->pixels.size = 0;
    s->width = s->height = 0;
    s->version++;
}

int stage_add(stage *s, stage_kind kind, const stage_vertex *vertices, const float *normals,
              size_t count)
{
    if (count > SIZE_MAX / sizeof *vertices) {
        return 0;
    }
    size_t bytes = count * sizeof *vertices;
    size_t normal_bytes = kind == STAGE_SMOOTH ? 3 * count * sizeof *normals : 0;
    unsigned char *to = room(&s->vertices[kind], bytes);
    unsigned char *normals_to = room(&s->normals, normal_bytes);
    if (count == 0) {
        return 1;
    }
    if (to == NULL || (normal_bytes > 0 && normals_to == NULL)) {
        return 0;
    }
    memcpy(to, vertices, bytes);
    s->vertices[kind].size += bytes;
    if (normal_bytes > 0) {
        memcpy(normals_to, normals, normal_bytes);
        s->normals.size += normal_bytes;
    }
    s->version++;
    return 1;
}

int stage_add_point(stage *s, const stage_point *point)
{
    unsigned char *to = room(&s->points, sizeof *point);
    if (to == NULL) {
        return 0;
    }
    memcpy(to, point, sizeof *point);
    s->points.size += sizeof *point;
    s->version++;
    return 1;
}

int stage_set_picture(stage *s, const unsigned char *rgb, uint32_t width, uint32_t height)
{
    s->pixels.size = 0;
    s->width = s->height = 0;
    s->version++;
    size_t bytes = rgb != NULL ? 3 * (size_t)width * height : 0;
    unsigned char *to = bytes > 0 ? room(&s->pixels, bytes) : NULL;
    if (to != NULL) {
        memcpy(to, rgb, bytes);
        s->pixels.size = bytes;
        s->width = width;
        s->height = height;
    }
    return bytes == 0 || to != NULL;
}

const stage_vertex *stage_vertices(const stage *s, stage_kind kind, size_t *count)
{
    *count = s->vertices[kind].size / sizeof(stage_vertex);
    return (const stage_vertex *)(const void *)s->vertices[kind].items;
}

const float *stage_normals(const stage *s)
{
    return (const float *)(const void *)s->normals.items;
}

const stage_point *stage_points(const stage *s, size_t *count)
{
    *count = s->points.size / sizeof(stage_point);
    return (const stage_point *)(const void *)s->points.items;
}

stage_picture stage_get_picture(const stage *s)
{
    const stage_picture picture = {s->pixels.items, s->width, s->height};
    return picture;
}

uint64_t stage_version(const stage *s)
{
    return s->version;
}
