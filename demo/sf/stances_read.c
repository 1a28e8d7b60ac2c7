// SPDX-License-Identifier: MIT
// What a model is to rest on: by options, or a file with several stances.
//
// Options and a file speak alike: in the axes of the input, in millimetres of the part as it is
// printed; both are turned to build axes here. Feet of models are seldom flat to a
// millionth of their size, so what is within a hundredth of the height from the ground stands on
// it, and is put onto it; but not where the outside is to stay as it is.

#include "stances_read.h"

#include "json_read.h"
#include "turned.h"

#include <math.h>
#include <string.h>

#define CONTACT_PART 0.01

// How far the part reaches along a direction.
static double height_along(const part *p, const double up[3])
{
    sf_mesh_view mesh = sf_mesh_get_view(p->mesh);
    double low = INFINITY, high = -INFINITY;
    for (size_t i = 0; i < 3 * mesh.triangle_count;
         i++) { // vertices that no triangle uses are none
        const double *v = mesh.vertices + 3 * (size_t)mesh.triangles[i];
        double h = v[0] * up[0] + v[1] * up[1] + v[2] * up[2];
        low = fmin(low, h);
        high = fmax(high, h);
    }
    return high > low ? high - low : 0;
}

// A stance that the input's axes give: `up` of length 1.
static sf_stance_options begin(const cli_job *job, const part *p, const double up[3])
{
    sf_stance_options made = sf_stance_options_default();
    turned_to_build(job, up, made.up);
    made.gamma_rad = job->options.stand.gamma_rad;
    if ((job->options.given & OPTION_NO_DEFORM) == 0) {
        made.contact_mm = CONTACT_PART * height_along(p, made.up);
    }
    return made;
}

static void from_options(const cli_job *job, const part *p, axis up, stances *s)
{
    const stand_values *asked = &job->options.stand;
    double direction[3];
    turned_axis(up, direction);
    s->count = 1;
    s->each[0] = begin(job, p, direction);
    turned_box(job, asked->low, asked->high, s->each[0].region_low_mm, s->each[0].region_high_mm);
    if (job->options.given & OPTION_SUSPEND) {
        s->each[0].kind = SF_STANCE_HANG;
        turned_to_build(job, asked->point, s->each[0].point_mm);
    }
}

#ifdef SF_HAVE_JANSSON

static const char *const kinds[] = {
    [SF_STANCE_STAND] = "stand", [SF_STANCE_HANG] = "hang", [SF_STANCE_ROCK] = "rock"};
static const char *const keys[] = {"kind",   "up",      "gamma_deg",  "tolerance_deg", "range_deg",
                                   "low_mm", "high_mm", "contact_mm", "point_mm",      "lever_mm"};

static exit_status fail(cli_job *job, const char *what)
{
    return json_fail(job, EXIT_INPUT, "--stance", job->options.stand.stances, what);
}

static int get_degrees(const json_t *object, const char *key, double *radians)
{
    const double degree = 3.14159265358979323846 / 180;
    double degrees = *radians / degree;
    int good = json_get_number(object, key, &degrees);
    if (json_object_get(object, key) != NULL) {
        *radians = degrees * degree;
    }
    return good;
}

static int get_numbers(const json_t *object, sf_stance_options *made)
{
    return get_degrees(object, "gamma_deg", &made->gamma_rad) &&
           get_degrees(object, "tolerance_deg", &made->tolerance_rad) &&
           get_degrees(object, "range_deg", &made->range_rad) &&
           json_get_number(object, "contact_mm", &made->contact_mm) &&
           json_get_number(object, "lever_mm", &made->lever_mm);
}

static exit_status read_one(cli_job *job, const part *p, axis axis_up, const json_t *object,
                            sf_stance_options *made)
{
    double up[3], low[3] = {-INFINITY, -INFINITY, -INFINITY},
                  high[3] = {INFINITY, INFINITY, INFINITY}, point[3] = {0, 0, 0};
    int kind = json_get_choice(object, "kind", kinds, 3, SF_STANCE_STAND);
    turned_axis(axis_up, up);
    if (!json_has_only(object, keys, sizeof keys / sizeof keys[0]) || kind < 0) {
        return fail(job, "a stance has a kind (stand, hang, rock), up, gamma_deg, tolerance_deg, "
                         "range_deg, low_mm, high_mm, contact_mm, point_mm and lever_mm, and "
                         "nothing else.");
    }
    if (!json_get_triple(object, "up", up) || !json_get_triple(object, "low_mm", low) ||
        !json_get_triple(object, "high_mm", high) || !json_get_triple(object, "point_mm", point)) {
        return fail(job, "up, low_mm, high_mm and point_mm are three numbers each.");
    }
    double length = sqrt(up[0] * up[0] + up[1] * up[1] + up[2] * up[2]);
    if (!(length > 0) || !isfinite(length)) {
        return fail(job, "up is a direction of any length but 0.");
    }
    for (int i = 0; i < 3; i++) {
        up[i] /= length;
    }
    *made = begin(job, p, up);
    made->kind = (sf_stance_kind)kind;
    turned_box(job, low, high, made->region_low_mm, made->region_high_mm);
    turned_to_build(job, point, made->point_mm);
    return get_numbers(object, made) ? EXIT_GOOD
                                     : fail(job, "angles and lengths are numbers, one each.");
}

static exit_status from_file(cli_job *job, const part *p, axis up, stances *s)
{
    json_t *root;
    const json_t *items;
    exit_status status = json_read_list(job, "--stance", job->options.stand.stances, "libsf-stance",
                                        "stances", STANCES_MAX, &root, &items);
    if (status != EXIT_GOOD) {
        return status;
    }
    s->count = json_array_size(items);
    for (size_t i = 0; status == EXIT_GOOD && i < s->count; i++) {
        status = read_one(job, p, up, json_array_get(items, i), &s->each[i]);
    }
    json_decref(root);
    return status;
}

#else

static exit_status from_file(cli_job *job, const part *p, axis up, stances *s)
{
    (void)p, (void)up, (void)s;
    return json_fail(job, EXIT_INPUT, "--stance", job->options.stand.stances,
                     "this build reads no JSON; build it with jansson.");
}

#endif

exit_status stances_read(cli_job *job, const part *p, axis up, stances *s)
{
    memset(s, 0, sizeof *s);
    if (job->options.stand.stances != NULL) {
        return from_file(job, p, up, s);
    }
    from_options(job, p, up, s);
    return EXIT_GOOD;
}
