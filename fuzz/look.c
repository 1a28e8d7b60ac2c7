// SPDX-License-Identifier: MIT
// What can be seen of an object, as one number; and whether it is as all of its kind must be.
//
// A call that fails leaves every object as it was, and one that only reads leaves what it reads:
// the world looks at all its objects before and after each call. FNV-1a (Fowler, Noll, Vo) is
// enough, because nobody here means to deceive it.

#include "world.h"

typedef struct mix {
    uint64_t hash;
} mix;

static void add(mix *m, const void *data, size_t size)
{
    const unsigned char *bytes = data;
    for (size_t i = 0; i < size; i++) {
        m->hash = (m->hash ^ bytes[i]) * 0x100000001b3u;
    }
}

static void add_count(mix *m, uint64_t count)
{
    add(m, &count, sizeof count);
}

static sf_status sink_mix(void *user, const void *data, size_t size)
{
    add(user, data, size);
    return SF_OK;
}

static void look_at_slice(const world *w, mix *m, sf_slice s)
{
    for (uint32_t y = 0; y < s.height; y++) {
        const uint64_t *row = s.words + y * s.stride;
        size_t words = (s.width + 63) / 64;
        if (s.width % 64 != 0 && row[words - 1] >> s.width % 64 != 0) {
            world_fail(w, "a bit past the width of a grid is not zero");
        }
        add(m, row, words * sizeof *row);
    }
}

static void look_at_grid(const world *w, mix *m, const sf_grid *grid)
{
    sf_lattice l = sf_grid_lattice(grid);
    if (sf_lattice_validate(&l) != SF_OK) {
        world_fail(w, "a grid's lattice is not valid");
    }
    add_count(m, l.nx);
    add_count(m, l.ny);
    add_count(m, l.nz);
    add(m, &l.pitch_x_mm, sizeof(double));
    add(m, &l.pitch_y_mm, sizeof(double));
    add(m, l.origin_mm, sizeof l.origin_mm);
    for (uint32_t k = 0; k < l.nz; k++) {
        double height = sf_lattice_layer_height(&l, k);
        add(m, &height, sizeof height);
        look_at_slice(w, m, sf_grid_slice(grid, k));
    }
}

static void look_at_mesh(const world *w, mix *m, sf_mesh_view v)
{
    if (sf_mesh_validate(v, NULL) != SF_OK) {
        world_fail(w, "a mesh is not valid");
    }
    add(m, v.vertices, 3 * v.vertex_count * sizeof *v.vertices);
    add(m, v.triangles, 3 * v.triangle_count * sizeof *v.triangles);
}

static void look_at_channels(mix *m, const sf_channel *channels, size_t count, size_t corners)
{
    for (size_t i = 0; i < count; i++) {
        const sf_channel *c = &channels[i];
        add(m, c->property.name, strlen(c->property.name));
        add(m, c->values, c->value_count * sizeof *c->values);
        add(m, c->indices, c->indices != NULL ? corners * sizeof *c->indices : 0);
    }
}

static void look_at_cage(mix *m, sf_cage_view v)
{
    add_count(m, v.dimension);
    add(m, v.positions, 3 * v.point_count * sizeof *v.positions);
    add(m, v.starts, (v.cell_count + 1) * sizeof *v.starts);
    add(m, v.corners, v.starts[v.cell_count] * sizeof *v.corners);
    for (size_t i = 0; i < v.crease_count; i++) {
        add(m, v.creases[i].points, sizeof v.creases[i].points);
        add(m, &v.creases[i].sharpness, sizeof(double));
    }
    for (size_t i = 0; i < v.sharp_count; i++) {
        add_count(m, v.sharps[i].point);
        add(m, &v.sharps[i].sharpness, sizeof(double));
    }
    look_at_channels(m, v.channels, v.channel_count, v.starts[v.cell_count]);
}

static void look_at_tets(mix *m, sf_tets_view v)
{
    add(m, v.positions, 3 * v.point_count * sizeof *v.positions);
    add(m, v.corners, 4 * v.tet_count * sizeof *v.corners);
    look_at_channels(m, v.channels, v.channel_count, 4 * v.tet_count);
}

static void look_at_sculpt(const world *w, mix *m, const sf_sculpt *model)
{
    const sf_grid *drawn = sf_sculpt_drawn(model);
    sf_sculpt_history history = sf_sculpt_history_of(model);
    look_at_grid(w, m, sf_sculpt_printable(model));
    if (drawn != NULL) {
        look_at_grid(w, m, drawn);
    }
    add_count(m, history.undo_count);
    add_count(m, history.redo_count);
}

static void look_at_stance(mix *m, const sf_stance *stance)
{
    double ground = sf_stance_ground(stance), corners[3 * 64];
    size_t count = 0;
    add(m, &ground, sizeof ground);
    if (sf_stance_polygon(stance, corners, 64, &count) == SF_OK) {
        add(m, corners, 3 * count * sizeof *corners);
    }
}

static void look_at_weights(mix *m, const sf_weights *weights)
{
    sf_weights_facts facts = sf_weights_describe(weights);
    double w[SF_HANDLE_MAX], middle[3];
    const double *centers = sf_weights_centers(weights);
    add(m, centers, 3 * facts.handle_count * sizeof *centers);
    memcpy(middle, centers, sizeof middle);
    if (sf_weights_at(weights, middle, w, NULL) == SF_OK) {
        add(m, w, facts.handle_count * sizeof *w);
    }
}

static void look_at_history(mix *m, const sf_cage_history *history)
{
    sf_cage_history_state s = sf_cage_history_get_state(history);
    add_count(m, s.undo_count);
    add_count(m, s.redo_count);
    add_count(m, s.bytes);
}

static void look_at_stand(const world *w, mix *m, const sf_stand *stand)
{
    sf_mesh_view outer = sf_stand_outer(stand);
    if (sf_stand_grid(stand) != NULL) { // there is none before the first round
        look_at_grid(w, m, sf_stand_grid(stand));
    }
    add(m, outer.vertices, 3 * outer.vertex_count * sizeof *outer.vertices);
    add_count(m, sf_stand_describe(stand).rounds);
}

static void look_at_contours(mix *m, const sf_contour_stack *stack)
{
    for (uint32_t k = 0; k < sf_contour_stack_count(stack); k++) {
        sf_contours c;
        double heights[2];
        if (sf_contour_stack_layer(stack, k, &c, &heights[0], &heights[1]) == SF_OK) {
            add(m, heights, sizeof heights);
            add(m, c.starts, (c.contour_count + 1) * sizeof *c.starts);
            add(m, c.points_mm, 2 * c.starts[c.contour_count] * sizeof *c.points_mm);
        }
    }
}

uint64_t world_look(const world *w, const char *kind, const void *object)
{
    mix m = {0xcbf29ce484222325u};
    if (strcmp(kind, "sf_grid") == 0) {
        look_at_grid(w, &m, object);
    } else if (strcmp(kind, "sf_mesh") == 0) {
        look_at_mesh(w, &m, sf_mesh_get_view(object));
    } else if (strcmp(kind, "sf_cage") == 0) {
        look_at_cage(&m, sf_cage_get_view(object));
    } else if (strcmp(kind, "sf_tets") == 0) {
        look_at_tets(&m, sf_tets_get_view(object));
    } else if (strcmp(kind, "sf_sculpt") == 0) {
        look_at_sculpt(w, &m, object);
    } else if (strcmp(kind, "sf_session") == 0) {
        sf_sink sink = {sink_mix, &m};
        add_count(&m, sf_session_write(object, sink) == SF_OK);
    } else if (strcmp(kind, "sf_contour_stack") == 0) {
        look_at_contours(&m, object);
    } else if (strcmp(kind, "sf_stance") == 0) {
        look_at_stance(&m, object);
    } else if (strcmp(kind, "sf_weights") == 0) {
        look_at_weights(&m, object);
    } else if (strcmp(kind, "sf_cage_history") == 0) {
        look_at_history(&m, object);
    } else if (strcmp(kind, "sf_stand") == 0) {
        look_at_stand(w, &m, object);
    } else if (strcmp(kind, "sf_tip") == 0) {
        look_at_grid(w, &m, sf_tip_mask(object, NULL));
    } else if (strcmp(kind, "sf_mask") == 0) {
        uint32_t size[3];
        sf_mask_size(object, size);
        add(&m, size, sizeof size);
    }
    return m.hash;
}
