// SPDX-License-Identifier: MIT
// What 1 mm3 of the part weighs: one number, or a file that says more.
//
// The file is JSON (docs/density.schema.json): a density, the share of it that infill leaves beyond
// a printed wall, and regions, each a box or a mesh with a density of its own. Regions lie where
// the part lies in its file: they are turned and sized by the very map that the part was.

#include "densities.h"

#include "json_read.h"
#include "progress.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// What voxels can hold, with room to spare.
#define DENSITY_LEAST 1e-30
#define DENSITY_MOST 1e30

static exit_status fail(cli_job *job, exit_status status, const char *what)
{
    return job_fail(job, status, "--density %.300s: %s", job->options.density, what);
}

#ifdef SF_HAVE_JANSSON

#define REGIONS_MAX 1024

// What the file says, in build axes.
typedef struct plan {
    sf_density_options options;
    double wall_mm;
    sf_density_region regions[REGIONS_MAX];
    sf_mesh *meshes[REGIONS_MAX]; // of regions that have one
} plan;

static const char *const keys[] = {"format", "version", "density", "infill", "wall_mm", "regions"};
static const char *const region_keys[] = {"density", "box", "mesh"};
static const char *const box_keys[] = {"low", "high"};

// A box stays one: the map only swaps and turns axes around, and scales.
static void map_box(const sf_transform *map, const double a[3], const double b[3],
                    sf_density_region *region)
{
    for (int i = 0; i < 3; i++) {
        double u = map->shift_mm[i], v = u;
        for (int j = 0; j < 3; j++) {
            u += map->matrix[3 * i + j] * a[j];
            v += map->matrix[3 * i + j] * b[j];
        }
        region->low_mm[i] = fmin(u, v);
        region->high_mm[i] = fmax(u, v);
    }
}

static exit_status read_mesh(cli_job *job, const part *p, const char *path, plan *made, size_t i)
{
    exit_status status = part_load_mesh(job, path, &made->meshes[i]);
    if (status != EXIT_GOOD) {
        return status;
    }
    if (sf_mesh_transform(made->meshes[i], &p->to_build) != SF_OK) {
        return fail(job, EXIT_INPUT, "a mesh cannot be brought to the part's size.");
    }
    made->regions[i].shape = SF_DENSITY_MESH;
    made->regions[i].mesh = sf_mesh_get_view(made->meshes[i]);
    return EXIT_GOOD;
}

static exit_status read_region(cli_job *job, const part *p, const json_t *object, plan *made,
                               size_t i)
{
    sf_density_region *region = &made->regions[i];
    const json_t *box = json_object_get(object, "box"), *mesh = json_object_get(object, "mesh");
    double a[3], b[3];
    if (!json_has_only(object, region_keys, 3) || (box == NULL) == (mesh == NULL) ||
        (mesh != NULL && !json_is_string(mesh))) {
        return fail(job, EXIT_INPUT,
                    "each region has a density, and a box or else a mesh, which is a path; and "
                    "nothing else.");
    }
    if (!json_get_number(object, "density", &region->density) || !(region->density > 0)) {
        return fail(job, EXIT_INPUT, "each region needs a density above 0.");
    }
    if (mesh != NULL) {
        return read_mesh(job, p, json_string_value(mesh), made, i);
    }
    if (!json_has_only(box, box_keys, 2) || json_object_size(box) != 2 ||
        !json_get_triple(box, "low", a) || !json_get_triple(box, "high", b)) {
        return fail(job, EXIT_INPUT, "a box has two corners, low and high, of three numbers.");
    }
    map_box(&p->to_build, a, b, region);
    return EXIT_GOOD;
}

static exit_status read_plan(cli_job *job, const part *p, const json_t *root, plan *made)
{
    const char *format = json_string_value(json_object_get(root, "format"));
    const json_t *regions = json_object_get(root, "regions");
    double version = 0;
    if (format == NULL || strcmp(format, "libsf-density") != 0 ||
        !json_get_number(root, "version", &version) || version != 1) {
        return fail(job, EXIT_INPUT, "format must be libsf-density, and version 1.");
    }
    if (!json_has_only(root, keys, sizeof keys / sizeof keys[0])) {
        return fail(job, EXIT_INPUT,
                    "beside format and version there may be density, infill, wall_mm and regions, "
                    "and nothing else.");
    }
    if (!json_get_number(root, "density", &made->options.density) ||
        !json_get_number(root, "infill", &made->options.infill) ||
        !json_get_number(root, "wall_mm", &made->wall_mm) || !(made->options.density > 0) ||
        !(made->options.infill > 0 && made->options.infill <= 1) || !(made->wall_mm >= 0)) {
        return fail(job, EXIT_INPUT,
                    "density is a number above 0, infill one above 0 and at most 1, wall_mm one "
                    "that is not negative.");
    }
    if ((regions != NULL && !json_is_array(regions)) || json_array_size(regions) > REGIONS_MAX) {
        return fail(job, EXIT_INPUT, "regions is a list of at most 1024.");
    }
    made->options.regions = made->regions;
    made->options.region_count = json_array_size(regions);
    exit_status status = EXIT_GOOD;
    for (size_t i = 0; status == EXIT_GOOD && i < made->options.region_count; i++) {
        status = read_region(job, p, json_array_get(regions, i), made, i);
    }
    return status;
}

static sf_status fill(cli_job *job, const part *p, plan *made, float *each)
{
    sf_lattice lattice = sf_grid_lattice(p->grid);
    sf_grid *wall = NULL;
    sf_status status = sf_grid_create(&lattice, NULL, &wall);
    if (status == SF_OK) {
        status = p->mesh != NULL
                     ? sf_grid_wall(p->grid, sf_mesh_get_view(p->mesh), made->wall_mm, NULL,
                                    &job->task, wall)
                     : sf_grid_wall_inside(p->grid, made->wall_mm, NULL, &job->task, wall);
    }
    if (status == SF_OK) {
        made->options.wall = wall;
        status = sf_lattice_density(&lattice, &made->options, NULL, &job->task, each);
    }
    sf_grid_destroy(wall);
    return status;
}

// A region beside the part does nothing, and is likely one in other numbers than the file's.
static void warn_of_air(cli_job *job, const part *p, const plan *made)
{
    sf_lattice l = sf_grid_lattice(p->grid);
    const double *low = l.origin_mm;
    const double high[3] = {low[0] + l.nx * l.pitch_x_mm, low[1] + l.ny * l.pitch_y_mm,
                            sf_lattice_layer_bottom(&l, l.nz)};
    for (size_t i = 0; i < made->options.region_count; i++) {
        const sf_density_region *r = &made->regions[i];
        double from[3], to[3];
        memcpy(from, r->low_mm, sizeof from);
        memcpy(to, r->high_mm, sizeof to);
        if (r->shape == SF_DENSITY_MESH && sf_mesh_bounds(r->mesh, from, to) != SF_OK) {
            continue;
        }
        int meets = 1;
        for (int n = 0; n < 3; n++) {
            meets = meets && from[n] < high[n] && to[n] > low[n];
        }
        if (!meets) {
            job_warn(job,
                     "--density %.300s: region %zu lies beside the part and does nothing; its "
                     "places are those of the part's file, before --up, --units, --scale and "
                     "--size.",
                     job->options.density, i + 1);
        }
    }
}

static exit_status apply(cli_job *job, const part *p, plan *made, densities *d)
{
    sf_lattice l = sf_grid_lattice(p->grid);
    d->each = malloc((size_t)l.nx * l.ny * l.nz * sizeof *d->each);
    if (d->each == NULL) {
        return fail(job, EXIT_RESOURCE, "there is no memory for a number for each voxel.");
    }
    warn_of_air(job, p, made);
    progress_phase("weighing");
    sf_status status = fill(job, p, made, d->each);
    return status == SF_OK ? EXIT_GOOD
                           : job_fail_call(job, status, NULL, job->options.density, EXIT_INPUT);
}

static exit_status read_file(cli_job *job, const part *p, densities *d)
{
    json_error_t error;
    json_t *root = json_load_file(job->options.density, JSON_REJECT_DUPLICATES, &error);
    if (root == NULL) {
        char why[JSON_WHY_SIZE];
        json_why(&error, why);
        return fail(job, EXIT_INPUT, why);
    }
    plan *made = calloc(1, sizeof *made);
    exit_status status = EXIT_RESOURCE;
    if (made != NULL) {
        made->options = sf_density_options_default();
        status = read_plan(job, p, root, made);
        if (status == EXIT_GOOD) {
            status = apply(job, p, made, d);
        }
        for (size_t i = 0; i < REGIONS_MAX; i++) {
            sf_mesh_destroy(made->meshes[i]);
        }
    }
    free(made);
    json_decref(root);
    return status;
}

#else

static exit_status read_file(cli_job *job, const part *p, densities *d)
{
    (void)p;
    (void)d;
    return fail(job, EXIT_USAGE, "this build reads no JSON; give a number.");
}

#endif

exit_status densities_read(cli_job *job, const part *p, densities *d)
{
    const char *text = job->options.density;
    char *end;
    d->all = 1;
    d->each = NULL;
    if (text == NULL) {
        return EXIT_GOOD;
    }
    errno = 0;
    double number = strtod(text, &end);
    if (end == text || *end != '\0') {
        return read_file(job, p, d);
    }
    if (errno != 0 || !(number >= DENSITY_LEAST && number <= DENSITY_MOST)) {
        return fail(job, EXIT_USAGE, "a density is above 0: a number from 1e-30 to 1e30.");
    }
    d->all = number;
    return EXIT_GOOD;
}

exit_status densities_weigh(cli_job *job, const densities *d, const sf_grid *grid, sf_body *body)
{
    sf_body none = {0, {0, 0, 0}}, found;
    sf_status status = sf_grid_body(grid, d->each, &job->task, &found);
    if (status != SF_OK) {
        return job_fail_call(job, status, NULL, "the weight", EXIT_INPUT);
    }
    *body = sf_body_add(none, d->each != NULL ? 1 : d->all, found);
    return EXIT_GOOD;
}

void densities_release(densities *d)
{
    free(d->each);
    d->each = NULL;
}
