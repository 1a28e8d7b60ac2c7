// SPDX-License-Identifier: MIT
// Materials: a file of what was measured, or two ends.
//
// The file is JSON (docs/materials.schema.json): materials with a name, a colour and a density; the
// names of properties; and mixtures, each with a fraction of every material and the value of every
// property that was measured of it.

#include "materials.h"

#include "json_read.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void materials_free(materials *m)
{
    sf_curve_destroy(m->curve);
    sf_mixture_destroy(m->mixture);
    free(m->ladder);
    m->curve = NULL;
    m->mixture = NULL;
    m->ladder = NULL;
}

// Between the two measured mixtures whose values are next to the wanted one. Where one property is
// to be had of more than two materials many mixtures would do; these change the least from value to
// value.
static double climb(const materials *m, double wanted, double *fractions)
{
    size_t width = 1 + m->count, at = 0;
    while (at + 2 < m->rungs && m->ladder[(at + 1) * width] < wanted) {
        at++;
    }
    const double *low = m->ladder + at * width, *high = low + width;
    double t = (wanted - low[0]) / (high[0] - low[0]);
    t = t < 0 ? 0 : t > 1 ? 1 : t;
    for (uint32_t i = 0; i < m->count; i++) {
        fractions[i] = low[1 + i] + t * (high[1 + i] - low[1 + i]);
    }
    return fabs(low[0] + t * (high[0] - low[0]) - wanted);
}

double materials_mix(materials *m, const double *wanted, double *fractions)
{
    double miss = 0;
    if (m->curve != NULL) {
        double x = 0;
        if (sf_curve_inverse(m->curve, wanted[0], &x, &miss) != SF_OK) {
            return INFINITY;
        }
        fractions[1] = x < 0 ? 0 : x > 1 ? 1 : x;
        fractions[0] = 1 - fractions[1];
        return fabs(miss);
    }
    if (m->ladder != NULL) {
        return climb(m, wanted[0], fractions);
    }
    if (sf_mixture_fractions(m->mixture, wanted, &m->hint, fractions, NULL, &miss) != SF_OK) {
        return INFINITY;
    }
    return miss;
}

exit_status materials_between(cli_job *job, const char *property, double low, double high,
                              materials *made)
{
    static const sf_material two[2] = {{"low", {56, 108, 176}, 0}, {"high", {240, 150, 40}, 0}};
    sf_curve_sample ends[2] = {{0, low, 1}, {1, high > low ? high : low + 1, 1}};
    memset(made, 0, sizeof *made);
    made->count = 2;
    memcpy(made->table, two, sizeof two);
    made->property_count = 1;
    snprintf(made->properties[0], SF_PROPERTY_NAME_SIZE, "%s", property);
    sf_status status = sf_curve_create(ends, 2, SF_TREND_RISING, NULL, &made->curve);
    return status == SF_OK ? EXIT_GOOD : job_fail_call(job, status, NULL, property, EXIT_INPUT);
}

#ifdef SF_HAVE_JANSSON

static const char *const keys[] = {"format", "version", "materials", "properties", "mixtures"};
static const char *const material_keys[] = {"name", "colour", "density_g_cm3"};
static const char *const mixture_keys[] = {"fractions", "values"};

static exit_status fail(cli_job *job, const char *what)
{
    return json_fail(job, EXIT_INPUT, "--materials", job->options.materials, what);
}

static int read_name(const json_t *found, char *name, size_t size)
{
    const char *text = json_string_value(found);
    if (text == NULL || text[0] == '\0' || strlen(text) >= size) {
        return 0;
    }
    memcpy(name, text, strlen(text) + 1);
    return 1;
}

// "#rrggbb"; absent it is a grey that differs from material to material.
static int read_colour(const json_t *found, uint32_t index, uint8_t colour[3])
{
    const char *text = json_string_value(found);
    unsigned red, green, blue;
    char end;
    memset(colour, (int)(60 + 40 * index % 180), 3);
    if (found == NULL) {
        return 1;
    }
    if (text == NULL || strlen(text) != 7 || strspn(text + 1, "0123456789abcdefABCDEF") != 6 ||
        sscanf(text, "#%2x%2x%2x%c", &red, &green, &blue, &end) != 3) {
        return 0;
    }
    colour[0] = (uint8_t)red;
    colour[1] = (uint8_t)green;
    colour[2] = (uint8_t)blue;
    return 1;
}

static exit_status read_materials(cli_job *job, const json_t *list, materials *made)
{
    if (!json_is_array(list) || json_array_size(list) < 2 ||
        json_array_size(list) > MATERIALS_MAX) {
        return fail(job, "materials is a list of 2 to 6.");
    }
    made->count = (uint32_t)json_array_size(list);
    for (uint32_t i = 0; i < made->count; i++) {
        const json_t *one = json_array_get(list, i);
        sf_material *m = &made->table[i];
        if (!json_has_only(one, material_keys, 3) ||
            !read_name(json_object_get(one, "name"), m->name, sizeof m->name) ||
            !read_colour(json_object_get(one, "colour"), i, m->colour) ||
            !json_get_number(one, "density_g_cm3", &m->density_g_cm3) || !(m->density_g_cm3 >= 0)) {
            return fail(job,
                        "each material has a name of 1 to 47 bytes, and may have a colour such "
                        "as \"#ff8000\" and a density_g_cm3 of 0 or more; nothing else.");
        }
    }
    return EXIT_GOOD;
}

static exit_status read_properties(cli_job *job, const json_t *list, materials *made)
{
    made->property_count = json_is_array(list) ? json_array_size(list) : 0;
    if (made->property_count < 1 || made->property_count > MATERIALS_PROPERTIES_MAX) {
        return fail(job, "properties is a list of 1 to 8 names.");
    }
    for (size_t i = 0; i < made->property_count; i++) {
        if (!read_name(json_array_get(list, i), made->properties[i], SF_PROPERTY_NAME_SIZE)) {
            return fail(job, "each property is a name of 1 to 47 bytes.");
        }
    }
    return EXIT_GOOD;
}

// One row of numbers, `count` of them.
static int read_row(const json_t *list, size_t count, double *row)
{
    if (!json_is_array(list) || json_array_size(list) != count) {
        return 0;
    }
    for (size_t i = 0; i < count; i++) {
        const json_t *item = json_array_get(list, i);
        row[i] = json_number_value(item);
        if (!json_is_number(item)) {
            return 0;
        }
    }
    return 1;
}

// What was measured, row by row.
typedef struct measured {
    size_t count;
    double fractions[SF_MIXTURE_MAX * MATERIALS_MAX];
    double values[SF_MIXTURE_MAX * MATERIALS_PROPERTIES_MAX];
} measured;

static exit_status make_curve(cli_job *job, const measured *all, materials *made)
{
    sf_curve_sample samples[SF_MIXTURE_MAX];
    for (size_t i = 0; i < all->count; i++) {
        sf_curve_sample sample = {all->fractions[2 * i + 1], all->values[i], 1};
        if (!(all->fractions[2 * i] >= 0 && all->fractions[2 * i + 1] >= 0)) {
            return fail(job, "fractions are not below 0.");
        }
        if (fabs(all->fractions[2 * i] + all->fractions[2 * i + 1] - 1) > 1e-6) {
            return fail(job, "the fractions of each mixture add up to 1.");
        }
        samples[i] = sample;
    }
    sf_status status = sf_curve_create(samples, all->count, SF_TREND_AUTO, NULL, &made->curve);
    return status == SF_OK ? EXIT_GOOD
                           : fail(job, "there are too few mixtures: at least two that differ, best "
                                       "with the pure materials among them.");
}

static int by_value(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static exit_status make_ladder(cli_job *job, const measured *all, materials *made)
{
    size_t width = 1 + made->count;
    made->ladder = malloc(all->count * width * sizeof *made->ladder);
    made->rungs = all->count;
    if (made->ladder == NULL) {
        return job_fail(job, EXIT_RESOURCE, "There is no memory for the mixtures.");
    }
    for (size_t i = 0; i < all->count; i++) {
        double sum = 0, *rung = made->ladder + i * width;
        rung[0] = all->values[i];
        for (uint32_t j = 0; j < made->count; j++) {
            rung[1 + j] = all->fractions[i * made->count + j];
            sum += rung[1 + j];
            if (!(rung[1 + j] >= 0)) {
                return fail(job, "fractions are not below 0.");
            }
        }
        if (fabs(sum - 1) > 1e-6) {
            return fail(job, "the fractions of each mixture add up to 1.");
        }
    }
    qsort(made->ladder, all->count, width * sizeof *made->ladder, by_value);
    for (size_t i = 1; i < all->count; i++) {
        if (!(made->ladder[i * width] > made->ladder[(i - 1) * width])) {
            return fail(job, "no two mixtures can have the same value of the one property.");
        }
    }
    return EXIT_GOOD;
}

static exit_status make_mixture(cli_job *job, const measured *all, materials *made)
{
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_mixture_samples samples = {made->count,    made->property_count, all->count,
                                  all->fractions, all->values,          NULL};
    sf_status status = sf_mixture_create(&samples, NULL, &made->mixture, &fault);
    return status == SF_OK
               ? EXIT_GOOD
               : fail(job, fault.message[0] != '\0' ? fault.message : sf_status_message(status));
}

static exit_status read_mixtures(cli_job *job, const json_t *list, materials *made)
{
    static measured all;
    all.count = json_is_array(list) ? json_array_size(list) : 0;
    if (all.count < 2 || all.count > SF_MIXTURE_MAX) {
        return fail(job, "mixtures is a list of 2 to 256.");
    }
    for (size_t i = 0; i < all.count; i++) {
        const json_t *one = json_array_get(list, i);
        if (!json_has_only(one, mixture_keys, 2) ||
            !read_row(json_object_get(one, "fractions"), made->count,
                      all.fractions + i * made->count) ||
            !read_row(json_object_get(one, "values"), made->property_count,
                      all.values + i * made->property_count)) {
            return fail(job,
                        "each mixture has fractions, a number for each material, and values, one "
                        "for each property; nothing else.");
        }
    }
    if (made->property_count > 1) {
        return make_mixture(job, &all, made);
    }
    return made->count == 2 ? make_curve(job, &all, made) : make_ladder(job, &all, made);
}

static exit_status read_root(cli_job *job, const json_t *root, materials *made)
{
    const char *format = json_string_value(json_object_get(root, "format"));
    double version = 0;
    if (format == NULL || strcmp(format, "libsf-materials") != 0 ||
        !json_get_number(root, "version", &version) || version != 1 ||
        !json_has_only(root, keys, 5)) {
        return fail(job,
                    "format must be libsf-materials, version 1, beside materials, properties and "
                    "mixtures, and nothing else.");
    }
    exit_status status = read_materials(job, json_object_get(root, "materials"), made);
    if (status == EXIT_GOOD) {
        status = read_properties(job, json_object_get(root, "properties"), made);
    }
    if (status == EXIT_GOOD) {
        status = read_mixtures(job, json_object_get(root, "mixtures"), made);
    }
    return status;
}

exit_status materials_read(cli_job *job, materials *made)
{
    json_error_t error;
    json_t *root = json_load_file(job->options.materials, JSON_REJECT_DUPLICATES, &error);
    memset(made, 0, sizeof *made);
    if (root == NULL) {
        char why[JSON_WHY_SIZE];
        json_why(&error, why);
        return fail(job, why);
    }
    exit_status status = read_root(job, root, made);
    json_decref(root);
    if (status != EXIT_GOOD) {
        materials_free(made);
    }
    return status;
}

#else

exit_status materials_read(cli_job *job, materials *made)
{
    memset(made, 0, sizeof *made);
    return json_fail(job, EXIT_INPUT, "--materials", job->options.materials,
                     "this program reads no files of materials; build it with jansson.");
}

#endif
