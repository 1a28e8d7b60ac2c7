// SPDX-License-Identifier: MIT
// What bends a model: handles of a file, or places found by themselves, deep in it and away from
// what it stands on or hangs from.

#include "handles_read.h"

#include "extent.h"
#include "json_read.h"
#include "progress.h"
#include "turned.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

// ---------------------------------------------------------------------------------------------
// By themselves
// ---------------------------------------------------------------------------------------------

// Mark the voxel that holds a place; one on the grid's border counts to the voxel inside.
static sf_status mark(const sf_lattice *l, const double at[3], sf_grid *base)
{
    const double pitch[3] = {l->pitch_x_mm, l->pitch_y_mm, l->layer_mm};
    const uint32_t count[3] = {l->nx, l->ny, l->nz};
    uint32_t voxel[3];
    for (int d = 0; d < 3; d++) {
        double v = floor((at[d] - l->origin_mm[d]) / pitch[d]);
        voxel[d] = v < 0 ? 0 : v >= count[d] ? count[d] - 1 : (uint32_t)v;
    }
    return sf_slice_set(sf_grid_slice(base, voxel[2]), voxel[0], voxel[1], 1);
}

static sf_status mark_contacts(const sf_lattice *l, sf_mesh_view mesh, const sf_stance *stance,
                               sf_grid *base)
{
    size_t count = 0;
    sf_status status = sf_stance_contacts(stance, NULL, 0, &count);
    if (status != SF_ERR_CAPACITY) {
        return status;
    }
    uint32_t *touch = malloc(count * sizeof *touch);
    status = touch == NULL ? SF_ERR_MEMORY : sf_stance_contacts(stance, touch, count, &count);
    for (size_t i = 0; status == SF_OK && i < count; i++) {
        status = mark(l, mesh.vertices + 3 * (size_t)touch[i], base);
    }
    free(touch);
    return status;
}

// What all stances touch.
static exit_status mark_base(cli_job *job, const part *p, const stances *s, sf_grid *base)
{
    sf_lattice l = sf_grid_lattice(p->grid);
    sf_mesh_view mesh = sf_mesh_get_view(p->mesh);
    for (size_t i = 0; i < s->count; i++) {
        sf_fault fault = {SF_OK, 0, 0, ""};
        sf_stance *stance = NULL;
        sf_status status = sf_stance_create(mesh, &s->each[i], NULL, &stance, &fault);
        if (status == SF_OK) {
            status = s->each[i].kind == SF_STANCE_HANG ? mark(&l, s->each[i].point_mm, base)
                                                       : mark_contacts(&l, mesh, stance, base);
        }
        sf_stance_destroy(stance);
        if (status != SF_OK) {
            return job_fail_call(job, status, &fault, job->options.input, EXIT_INPUT);
        }
    }
    return EXIT_GOOD;
}

static exit_status find_places(cli_job *job, const part *p, const sf_grid *base, handles *h)
{
    sf_place_options how = sf_place_options_default();
    sf_fault fault = {SF_OK, 0, 0, ""};
    how.count = job->options.stand.handle_count;
    how.base = base;
    sf_status status = sf_handles_place(p->grid, &how, NULL, &job->task, h->each, SF_HANDLE_MAX,
                                        &h->count, &fault);
    if (status == SF_ERR_INFEASIBLE) {
        job_warn(job, "There is no room for a handle: the outside stays as it is.");
        h->count = 0;
        return EXIT_GOOD;
    }
    return status == SF_OK ? EXIT_GOOD
                           : job_fail_call(job, status, &fault, "the handles", EXIT_INPUT);
}

static exit_status place(cli_job *job, const part *p, const stances *s, handles *h)
{
    sf_lattice l = sf_grid_lattice(p->grid);
    sf_grid *base = NULL;
    h->are_placed = 1;
    if (job->options.stand.handle_count == 0) {
        return EXIT_GOOD;
    }
    progress_phase("placing handles");
    sf_status made = sf_grid_create(&l, NULL, &base);
    exit_status status = made == SF_OK
                             ? mark_base(job, p, s, base)
                             : job_fail_call(job, made, NULL, "the handles", EXIT_RESOURCE);
    if (status == EXIT_GOOD) {
        status = find_places(job, p, base, h);
    }
    sf_grid_destroy(base);
    return status;
}

// ---------------------------------------------------------------------------------------------
// From a file
// ---------------------------------------------------------------------------------------------

#ifdef SF_HAVE_JANSSON

static const char *const kinds[] = {[SF_HANDLE_POINT] = "point", [SF_HANDLE_BALL] = "ball"};
static const char *const keys[] = {"kind", "at_mm", "ray", "radius_mm", "locked", "pose"};
static const char *const ray_keys[] = {"from_mm", "direction"};
static const char *const pose_keys[] = {"scale", "shift_mm", "turn_deg"};

static exit_status fail(cli_job *job, const char *what)
{
    return json_fail(job, EXIT_INPUT, "--handles", job->options.stand.handles, what);
}

static exit_status read_pose(cli_job *job, const json_t *object, handles *h, size_t i)
{
    const json_t *pose = json_object_get(object, "pose");
    double shift[3] = {0, 0, 0}, turn[3] = {0, 0, 0};
    sf_pose_change by = {0, {0, 0, 0}, {0, 0, 0}};
    if (pose == NULL) {
        return EXIT_GOOD;
    }
    if (!json_has_only(pose, pose_keys, 3) || !json_get_number(pose, "scale", &h->poses[i].scale) ||
        !(h->poses[i].scale > 0) || !json_get_triple(pose, "shift_mm", shift) ||
        !json_get_triple(pose, "turn_deg", turn)) {
        return fail(job, "a pose has a scale above 0, a shift_mm of three numbers, and a turn_deg "
                         "of three, the axis times the angle.");
    }
    turned_to_build(job, shift, h->poses[i].shift_mm);
    turned_to_build(job, turn, turn);
    for (int d = 0; d < 3; d++) {
        by.spin_rad[d] = turn[d] * (3.14159265358979323846 / 180);
    }
    h->posed[i] = 1;
    return sf_pose_move(&h->poses[i], &by) == SF_OK
               ? EXIT_GOOD
               : fail(job, "a turn_deg is larger than anybody could mean.");
}

// The middle of the part where a ray from outside, or from its surface, enters it.
static exit_status follow_ray(cli_job *job, const part *p, const json_t *ray, size_t i,
                              double at[3])
{
    char words[EXTENT_WORDS_SIZE];
    double direction[3];
    sf_fault fault = {SF_OK, 0, 0, ""};
    if (!json_has_only(ray, ray_keys, 2) || json_object_size(ray) != 2 ||
        !json_get_triple(ray, "from_mm", at) || !json_get_triple(ray, "direction", direction)) {
        return fail(job, "a ray has from_mm and direction, of three numbers each.");
    }
    turned_to_build(job, at, at);
    turned_to_build(job, direction, direction);
    sf_status status = sf_handle_center(p->grid, at, direction, at, &fault);
    if (status == SF_ERR_INFEASIBLE) {
        extent_words(job, p, words);
        return job_fail(job, EXIT_INPUT,
                        "--handles %.300s: the ray of handle %zu misses the model, which spans %s.",
                        job->options.stand.handles, i + 1, words);
    }
    return status == SF_OK
               ? EXIT_GOOD
               : job_fail_call(job, status, &fault, job->options.stand.handles, EXIT_INPUT);
}

static exit_status read_place(cli_job *job, const part *p, const json_t *object, size_t i,
                              double at[3])
{
    const json_t *ray = json_object_get(object, "ray"), *place = json_object_get(object, "at_mm");
    if ((ray == NULL) == (place == NULL)) {
        return fail(job, "a handle lies at_mm, or where a ray leads.");
    }
    if (ray != NULL) {
        return follow_ray(job, p, ray, i, at);
    }
    if (!json_get_triple(object, "at_mm", at)) {
        return fail(job, "at_mm is three numbers.");
    }
    turned_to_build(job, at, at);
    return EXIT_GOOD;
}

static exit_status read_one(cli_job *job, const part *p, const json_t *object, handles *h, size_t i)
{
    sf_handle *made = &h->each[i];
    int kind = json_get_choice(object, "kind", kinds, 2, SF_HANDLE_POINT);
    if (!json_has_only(object, keys, sizeof keys / sizeof keys[0]) || kind < 0) {
        return fail(job, "a handle has at_mm or a ray, and may have a kind (point, ball), "
                         "radius_mm, locked and a pose, and nothing else.");
    }
    made->kind = (sf_handle_kind)kind;
    if (!json_get_number(object, "radius_mm", &made->radius_mm) ||
        !json_get_flag(object, "locked", &made->locked)) {
        return fail(job, "radius_mm is a number, locked true or false.");
    }
    if (kind == SF_HANDLE_BALL && !(made->radius_mm > 0)) {
        return fail(job, "a ball has a radius_mm above 0.");
    }
    h->poses[i] = sf_pose_identity();
    exit_status status = read_place(job, p, object, i, made->at_mm);
    return status == EXIT_GOOD ? read_pose(job, object, h, i) : status;
}

static exit_status from_file(cli_job *job, const part *p, handles *h)
{
    json_t *root;
    const json_t *items;
    exit_status status =
        json_read_list(job, "--handles", job->options.stand.handles, "libsf-handles", "handles",
                       SF_HANDLE_MAX - 1, &root, &items);
    if (status != EXIT_GOOD) {
        return status;
    }
    h->count = json_array_size(items);
    for (size_t i = 0; status == EXIT_GOOD && i < h->count; i++) {
        status = read_one(job, p, json_array_get(items, i), h, i);
    }
    json_decref(root);
    return status;
}

#else

static exit_status from_file(cli_job *job, const part *p, handles *h)
{
    (void)p;
    (void)h;
    return json_fail(job, EXIT_INPUT, "--handles", job->options.stand.handles,
                     "this build reads no JSON; build it with jansson.");
}

#endif

exit_status handles_read(cli_job *job, const part *p, const stances *s, handles *h)
{
    memset(h, 0, sizeof *h);
    if (job->options.given & OPTION_NO_DEFORM) {
        return EXIT_GOOD;
    }
    return job->options.stand.handles != NULL ? from_file(job, p, h) : place(job, p, s, h);
}
