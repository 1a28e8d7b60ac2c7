// SPDX-License-Identifier: MIT
// Views out of bytes, and how many numbers a call will look at behind a pointer.
//
// Arrays end where their memory ends, so a sanitizer sees whoever looks one number too far.

#include "world.h"

size_t world_voxels(const world *w)
{
    return (size_t)w->lattice.nx * w->lattice.ny * w->lattice.nz;
}

size_t voxels_of(const sf_grid *grid)
{
    if (grid == NULL) {
        return 0;
    }
    sf_lattice l = sf_grid_lattice(grid);
    return (size_t)l.nx * l.ny * l.nz;
}

size_t handles_of(const sf_weights *weights)
{
    return weights != NULL ? sf_weights_describe(weights).handle_count : 0;
}

size_t points_of(const sf_cage *cage)
{
    return cage != NULL ? sf_cage_get_view(cage).point_count : 0;
}

sf_mesh_view world_sf_mesh_view(world *w)
{
    sf_mesh_view v = {NULL, 0, NULL, 0};
    if (draw_odd(&w->in, 12)) {
        v.vertex_count = draw_below(&w->in, 12);
        v.triangle_count = draw_below(&w->in, 12);
        v.vertices = world_places(w, 3 * v.vertex_count);
        v.triangles = world_words(w, 3 * v.triangle_count);
        return v;
    }
    const sf_mesh *mesh = world_need(w, "sf_mesh");
    return mesh != NULL ? sf_mesh_get_view(mesh) : v;
}

sf_contours world_sf_contours(world *w)
{
    sf_contours c = {NULL, NULL, draw_below(&w->in, 4)};
    size_t *starts = world_scratch(w, 4 * sizeof *starts);
    for (size_t i = 1; i <= 3; i++) {
        starts[i] =
            draw_odd(&w->in, 32) ? draw_byte(&w->in) : starts[i - 1] + draw_below(&w->in, 6);
    }
    size_t most = 0; // what is read of points before a fall of starts is seen
    for (size_t i = 0; i <= c.contour_count; i++) {
        most = starts[i] > most ? starts[i] : most;
    }
    c.starts = starts;
    c.points_mm = world_places(w, 2 * most);
    return c;
}

sf_property world_sf_property(world *w)
{
    uint32_t choice = draw_below(&w->in, 5);
    sf_property p = choice == 0   ? sf_property_density()
                    : choice == 1 ? sf_property_young()
                                  : sf_property_poisson();
    if (choice == 3) {
        (void)!sf_property_named("own", &p);
    }
    if (draw_odd(&w->in, 16)) {
        p.low = draw_double(&w->in);
        p.high = draw_double(&w->in);
        memset(p.name, 'n', draw_byte(&w->in) % (sizeof p.name + 1));
    }
    return p;
}

sf_channel world_sf_channel(world *w)
{
    sf_channel c = {world_sf_property(w), 0, NULL, NULL};
    const sf_cage *cage = world_need(w, "sf_cage");
    sf_cage_view none = {0};
    sf_cage_view v = cage != NULL ? sf_cage_get_view(cage) : none;
    c.value_count = v.point_count;
    double *values = world_scratch(w, c.value_count * sizeof *values);
    for (size_t i = 0; i < c.value_count; i++) {
        values[i] = draw_odd(&w->in, 64) ? draw_double(&w->in) : draw_byte(&w->in) / 600.0;
    }
    c.values = values;
    return c;
}

// The view of a cage that is there, some of its numbers others.
sf_cage_view world_sf_cage_view(world *w)
{
    sf_cage_view v = {0};
    const sf_cage *cage = world_need(w, "sf_cage");
    if (cage == NULL) {
        return v;
    }
    v = sf_cage_get_view(cage);
    if (draw_odd(&w->in, 3) && v.starts[v.cell_count] > 0) {
        uint32_t count = v.starts[v.cell_count];
        uint32_t *corners = world_scratch(w, count * sizeof *corners);
        memcpy(corners, v.corners, count * sizeof *corners);
        corners[draw_word(&w->in) % count] = world_index(w);
        v.corners = corners;
    }
    if (draw_odd(&w->in, 4)) {
        double *positions = world_scratch(w, 3 * v.point_count * sizeof *positions);
        memcpy(positions, v.positions, 3 * v.point_count * sizeof *positions);
        positions[draw_word(&w->in) % (3 * v.point_count)] = draw_double(&w->in);
        v.positions = positions;
    }
    if (draw_odd(&w->in, 4)) {
        sf_crease *creases = world_scratch(w, 2 * sizeof *creases);
        for (int i = 0; i < 2; i++) {
            creases[i].points[0] = world_index(w);
            creases[i].points[1] = world_index(w);
            creases[i].sharpness = draw_double(&w->in);
        }
        v.creases = creases;
        v.crease_count = 2;
    }
    return v;
}

sf_tets_view world_sf_tets_view(world *w)
{
    sf_tets_view v = {0};
    const sf_tets *tets = world_need(w, "sf_tets");
    if (tets == NULL) {
        return v;
    }
    v = sf_tets_get_view(tets);
    if (draw_odd(&w->in, 3) && v.tet_count > 0) {
        uint32_t *corners = world_scratch(w, 4 * v.tet_count * sizeof *corners);
        memcpy(corners, v.corners, 4 * v.tet_count * sizeof *corners);
        corners[draw_word(&w->in) % (4 * v.tet_count)] = world_index(w);
        v.corners = corners;
    }
    return v;
}

sf_handle world_sf_handle(world *w)
{
    sf_handle h = {SF_HANDLE_POINT, {0, 0, 0}, 1, NULL, 0};
    uint32_t choice = draw_byte(&w->in);
    h.kind = choice % 4 == 1 ? SF_HANDLE_BALL : SF_HANDLE_POINT;
    h.locked = choice % 8 == 5;
    const double sizes[3] = {w->lattice.nx * w->lattice.pitch_x_mm,
                             w->lattice.ny * w->lattice.pitch_y_mm,
                             w->lattice.nz * w->lattice.layer_mm};
    for (int i = 0; i < 3; i++) {
        h.at_mm[i] = w->lattice.origin_mm[i] + sizes[i] * draw_byte(&w->in) / 256;
    }
    if (draw_odd(&w->in, 16)) {
        h.kind = (sf_handle_kind)draw_below(&w->in, 5);
        h.radius_mm = draw_double(&w->in);
        h.region = world_need(w, "sf_grid");
    }
    return h;
}

sf_pose world_sf_pose(world *w)
{
    sf_pose p = sf_pose_identity();
    sf_pose_change change = {draw_byte(&w->in) / 1024.0, {0, 0, 0}, {0, 0, 0}};
    for (int i = 0; i < 3; i++) {
        change.shift_mm[i] = draw_place(&w->in) / 8;
        change.spin_rad[i] = draw_byte(&w->in) / 1024.0;
    }
    if (sf_pose_move(&p, &change) != SF_OK) {
        p = sf_pose_identity();
    }
    if (draw_odd(&w->in, 16)) {
        p.scale = draw_double(&w->in);
        p.turn[draw_below(&w->in, 9)] = draw_double(&w->in);
    }
    return p;
}

sf_blend world_sf_blend(world *w)
{
    sf_blend b = {NULL, NULL, world_few(w), NULL, 1 + world_few(w)};
    double *weights = world_scratch(w, b.point_count * b.handle_count * sizeof *weights);
    for (size_t i = 0; i < b.point_count * b.handle_count; i++) {
        weights[i] = draw_odd(&w->in, 64) ? draw_double(&w->in) : 1.0 / (double)b.handle_count;
    }
    b.weights = weights;
    b.rest_mm = world_places(w, 3 * b.point_count);
    b.centers_mm = world_places(w, 3 * b.handle_count);
    return b;
}

sf_stroke world_sf_stroke(world *w)
{
    sf_stroke s = {world_pick(w, "sf_grid"), {0, 0, 0}, NULL, world_few(w)};
    s.anchor.x = draw_below(&w->in, 3);
    s.anchor.z = draw_below(&w->in, 3);
    sf_voxel *path = world_scratch(w, s.count * sizeof *path);
    sf_voxel at = world_sf_voxel(w);
    for (size_t i = 0; i < s.count; i++) {
        path[i] = at;
        at.z -= at.z > 0;
        at.x += draw_below(&w->in, 3) == 1;
    }
    s.path = path;
    return s;
}

// --- tones ---------------------------------------------------------------------------------------

static const void *tone_values(world *w, sf_tone_type type, size_t count)
{
    if (type == SF_TONE_U8) {
        uint8_t *values = world_scratch(w, count);
        for (size_t i = 0; i < count; i++) {
            values[i] = draw_odd(&w->in, 64) ? 255 : draw_byte(&w->in) / 16;
        }
        return values;
    }
    double *values = world_scratch(w, count * sizeof *values);
    for (size_t i = 0; i < count; i++) {
        double value = draw_odd(&w->in, 64) ? draw_double(&w->in) : draw_byte(&w->in) / 5000.0;
        if (type == SF_TONE_F64) {
            values[i] = value;
        } else {
            float single = (float)value;
            memcpy((char *)values + i * sizeof single, &single, sizeof single);
        }
    }
    return values;
}

sf_tones world_sf_tones(world *w)
{
    sf_tones t = {sizeof t,   w->lattice.nx, w->lattice.ny,   0,    0, world_index(w),
                  SF_TONE_U8, NULL,          {NULL, 0, 0, 0}, NULL, 0};
    t.type = (sf_tone_type)draw_below(&w->in, 3);
    sf_tone_plane *planes = world_scratch(w, SF_MATERIAL_MAX * sizeof *planes);
    for (uint32_t i = 0; i < SF_MATERIAL_MAX; i++) { // as many as any halftone may look at
        planes[i].stride = t.width + draw_below(&w->in, 2);
        planes[i].values = tone_values(w, t.type, planes[i].stride * t.height);
    }
    t.planes = planes;
    if (draw_below(&w->in, 4) == 3) {
        t.solid = world_sf_slice(w);
    }
    if (draw_below(&w->in, 4) == 3) {
        sf_keep_out *outs = world_scratch(w, sizeof *outs);
        outs->where = world_sf_slice(w);
        outs->material = draw_below(&w->in, 3);
        outs->instead = draw_below(&w->in, 3);
        t.keep_outs = outs;
        t.keep_out_count = 1;
    }
    if (draw_odd(&w->in, 32)) {
        t.planes = NULL;
    }
    return t;
}

sf_materials world_sf_materials(world *w)
{
    sf_materials m = {NULL, NULL, w->lattice.nx + draw_below(&w->in, 3), NULL};
    uint32_t choice = draw_byte(&w->in);
    sf_slice *slices = world_scratch(w, SF_MATERIAL_MAX * sizeof *slices);
    for (uint32_t i = 0; i < SF_MATERIAL_MAX && choice % 2; i++) {
        sf_slice s = {NULL, w->lattice.nx, w->lattice.ny, (w->lattice.nx + 63) / 64};
        s.words = world_room(w, i < 2 ? s.stride * s.height * sizeof *s.words : 0, 0);
        if (i >= 2) {
            s.words = NULL;
        }
        slices[i] = s;
    }
    m.slices = choice % 2 ? slices : NULL;
    m.ids = choice % 4 >= 2 ? world_room(w, m.ids_stride * w->lattice.ny, 0) : NULL;
    m.counts = choice % 8 >= 4 ? world_room(w, SF_MATERIAL_MAX * sizeof *m.counts, 0) : NULL;
    return m;
}
