// SPDX-License-Identifier: MIT
// What 1 mm3 of the part weighs: one number, or a file that says more.
//
// The file is JSON (docs/density.schema.json): a density, the share of it that infill leaves beyond
// a printed wall, regions, each a box or a mesh with a density of its own, and masses in points. A
// region that is denser than the part is a thing, a weight or a magnet, and is not carved away
// unless it says that it may be. Boxes are in the axes
// of the input and in mm of the part as it is printed, as all places are; a mesh lies where the
// part lies in its file, and is turned and sized by the very map that the part was.

#include "densities.h"

#include "extent.h"
#include "json_read.h"
#include "progress.h"
#include "turned.h"

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
#define MASSES_MAX 1024

// What the file says, in build axes.
typedef struct plan {
    sf_density_options options;
    double wall_mm;
    sf_density_region regions[REGIONS_MAX];
    sf_mesh *meshes[REGIONS_MAX]; // of regions that have one
    int keep[REGIONS_MAX];        // 1: must stay, 0: may go, -1: as its density says
    sf_ballast masses[MASSES_MAX];
    size_t mass_count;
} plan;

static const char *const keys[] = {"format",  "version", "density", "infill",
                                   "wall_mm", "regions", "masses"};
static const char *const region_keys[] = {"density", "box", "mesh", "keep"};
static const char *const mass_keys[] = {"mass", "at_mm"};
static const char *const box_keys[] = {"low", "high"};

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
    if (!json_has_only(object, region_keys, 4) || (box == NULL) == (mesh == NULL) ||
        (mesh != NULL && !json_is_string(mesh))) {
        return fail(job, EXIT_INPUT,
                    "each region has a density, and a box or else a mesh, which is a path; it may "
                    "have a keep, and nothing else.");
    }
    if (!json_get_number(object, "density", &region->density) || !(region->density > 0)) {
        return fail(job, EXIT_INPUT, "each region needs a density above 0.");
    }
    made->keep[i] = -1;
    if (json_object_get(object, "keep") != NULL && !json_get_flag(object, "keep", &made->keep[i])) {
        return fail(job, EXIT_INPUT, "the keep of a region is true or false.");
    }
    if (mesh != NULL) {
        return read_mesh(job, p, json_string_value(mesh), made, i);
    }
    if (!json_has_only(box, box_keys, 2) || json_object_size(box) != 2 ||
        !json_get_triple(box, "low", a) || !json_get_triple(box, "high", b)) {
        return fail(job, EXIT_INPUT, "a box has two corners, low and high, of three numbers.");
    }
    turned_box(job, a, b, region->low_mm, region->high_mm);
    return EXIT_GOOD;
}

static exit_status read_masses(cli_job *job, const json_t *masses, plan *made)
{
    if (masses != NULL && (!json_is_array(masses) || json_array_size(masses) > MASSES_MAX)) {
        return fail(job, EXIT_INPUT, "masses is a list of at most 1024.");
    }
    made->mass_count = json_array_size(masses);
    for (size_t i = 0; i < made->mass_count; i++) {
        const json_t *object = json_array_get(masses, i);
        sf_ballast *mass = &made->masses[i];
        if (!json_has_only(object, mass_keys, 2) || json_object_size(object) != 2 ||
            !json_get_number(object, "mass", &mass->mass) || !(mass->mass > 0) ||
            !json_get_triple(object, "at_mm", mass->at_mm)) {
            return fail(job, EXIT_INPUT,
                        "each of masses has a mass above 0 and at_mm, three numbers, and nothing "
                        "else.");
        }
        turned_to_build(job, mass->at_mm, mass->at_mm);
    }
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
                    "beside format and version there may be density, infill, wall_mm, regions and "
                    "masses, and nothing else.");
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
    return status == EXIT_GOOD ? read_masses(job, json_object_get(root, "masses"), made) : status;
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

// The same regions once more: 2 where the last one that holds a voxel must stay, 1 elsewhere.
static sf_status fill_kept(cli_job *job, const part *p, plan *made, float *kept)
{
    sf_lattice lattice = sf_grid_lattice(p->grid);
    sf_density_options options = sf_density_options_default();
    for (size_t i = 0; i < made->options.region_count; i++) {
        double density = made->regions[i].density;
        int stays = made->keep[i] < 0 ? density > made->options.density : made->keep[i];
        made->regions[i].density = stays ? 2 : 1;
    }
    options.regions = made->regions;
    options.region_count = made->options.region_count;
    return sf_lattice_density(&lattice, &options, NULL, &job->task, kept);
}

static int any_stays(const plan *made)
{
    int any = 0;
    for (size_t i = 0; i < made->options.region_count; i++) {
        any |= made->keep[i] < 0 ? made->regions[i].density > made->options.density : made->keep[i];
    }
    return any;
}

// A region beside the part does nothing, and is likely one in other numbers than the file's.
static void warn_of_air(cli_job *job, const part *p, const plan *made)
{
    sf_lattice l = sf_grid_lattice(p->grid);
    char words[EXTENT_WORDS_SIZE];
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
            extent_words(job, p, words);
            job_warn(job,
                     "--density %.300s: region %zu lies beside the part, which spans %s, and does "
                     "nothing.",
                     job->options.density, i + 1, words);
        }
    }
}

static exit_status apply(cli_job *job, const part *p, plan *made, densities *d)
{
    sf_lattice l = sf_grid_lattice(p->grid);
    size_t voxels = (size_t)l.nx * l.ny * l.nz;
    int stays = any_stays(made);
    d->each = malloc(voxels * sizeof *d->each);
    d->kept = stays ? malloc(voxels * sizeof *d->kept) : NULL;
    d->masses = malloc((made->mass_count + 1) * sizeof *d->masses);
    if (d->each == NULL || d->masses == NULL || (stays && d->kept == NULL)) {
        return fail(job, EXIT_RESOURCE, "there is no memory for a number for each voxel.");
    }
    memcpy(d->masses, made->masses, made->mass_count * sizeof *d->masses);
    d->mass_count = made->mass_count;
    warn_of_air(job, p, made);
    progress_phase("weighing");
    sf_status status = fill(job, p, made, d->each);
    if (status == SF_OK && stays) {
        status = fill_kept(job, p, made, d->kept);
    }
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
    memset(d, 0, sizeof *d);
    d->all = 1;
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
    *body = sf_body_add(*body, 1, sf_ballast_body(d->masses, d->mass_count));
    return EXIT_GOOD;
}

void densities_release(densities *d)
{
    free(d->each);
    free(d->kept);
    free(d->masses);
    memset(d, 0, sizeof *d);
}

sf_status densities_keep(const densities *d, sf_grid *wall)
{
    sf_lattice l = sf_grid_lattice(wall);
    sf_status status = SF_OK;
    for (size_t i = 0; d->kept != NULL && status == SF_OK && i < (size_t)l.nx * l.ny * l.nz; i++) {
        if (d->kept[i] > 1) {
            size_t row = i / l.nx;
            status = sf_slice_set(sf_grid_slice(wall, (uint32_t)(row / l.ny)), (uint32_t)(i % l.nx),
                                  (uint32_t)(row % l.ny), 1);
        }
    }
    return status;
}
