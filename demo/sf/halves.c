// SPDX-License-Identifier: MIT
// A model cut in two, so that it can be opened: powder comes out, a weight goes in.
//
// What is cut is the mesh that is written, cavity and all, in the axes of the input, so that the
// plane stands where a person sees it in the file. A plane that misses the part is refused before
// any work is done; only a shape that was bent can escape it after that.

#include "halves.h"

#include "describe.h"
#include "turned.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static char axis_name(const cli_job *job)
{
    return "xyz"[job->options.cut_axis];
}

exit_status halves_check(cli_job *job, int writes_mesh)
{
    if ((job->options.given & OPTION_CUT) == 0 || writes_mesh) {
        return EXIT_GOOD;
    }
    return job_fail(job, EXIT_USAGE,
                    "--cut cuts the mesh that is written: say with -o where that goes (.stl, .obj, "
                    ".ply; a prefix for 'sf stand').");
}

exit_status halves_check_part(cli_job *job, const part *p)
{
    double low[3], high[3], a[3], b[3], at = job->options.cut_mm;
    int across = job->options.cut_axis;
    if ((job->options.given & OPTION_CUT) == 0 || !isfinite(at) || p->mesh == NULL ||
        sf_mesh_bounds(sf_mesh_get_view(p->mesh), low, high) != SF_OK) {
        return EXIT_GOOD;
    }
    turned_to_input(job, low, a);
    turned_to_input(job, high, b);
    if (at > fmin(a[across], b[across]) && at < fmax(a[across], b[across])) {
        return EXIT_GOOD;
    }
    return job_fail(job, EXIT_USAGE,
                    "--cut %c,%g leaves nothing on one side: the part goes from %.6g to %.6g mm "
                    "along %c.",
                    axis_name(job), at, fmin(a[across], b[across]), fmax(a[across], b[across]),
                    axis_name(job));
}

static sf_status measure(halves *h)
{
    sf_status status = SF_OK;
    for (int i = 0; status == SF_OK && i < 2; i++) {
        sf_topology topology;
        sf_mass mass;
        status = sf_mesh_measure(sf_mesh_get_view(h->mesh[i]), &mass);
        h->volume_mm3[i] = mass.volume_mm3;
        if (status == SF_OK) {
            status = sf_mesh_analyze(sf_mesh_get_view(h->mesh[i]), NULL, &topology);
            h->shut += topology.flipped_shells;
        }
    }
    return status;
}

// Whether two vertices are one in a file of 32-bit floats.
static int is_one(const double *p, const double *q)
{
    for (int i = 0; i < 3; i++) {
        float a = (float)p[i], b = (float)q[i];
        if (a < b || b < a) {
            return 0;
        }
    }
    return 1;
}

// Without the triangles of which an STL would keep nothing: where the plane passes close to a
// vertex.
static sf_status tidy(sf_mesh **mesh)
{
    sf_mesh_view view = sf_mesh_get_view(*mesh);
    const double *v = view.vertices;
    sf_mesh *made = NULL;
    sf_status status = sf_mesh_create(NULL, &made);
    if (status == SF_OK) {
        status = sf_mesh_add_vertices(made, v, view.vertex_count);
    }
    for (size_t t = 0; status == SF_OK && t < view.triangle_count; t++) {
        const uint32_t *c = view.triangles + 3 * t;
        size_t a = 3 * (size_t)c[0], b = 3 * (size_t)c[1], d = 3 * (size_t)c[2];
        if (!is_one(v + a, v + b) && !is_one(v + b, v + d) && !is_one(v + d, v + a)) {
            status = sf_mesh_add_triangles(made, c, 1);
        }
    }
    sf_mesh_destroy(status == SF_OK ? *mesh : made);
    *mesh = status == SF_OK ? made : *mesh;
    return status;
}

exit_status halves_make(cli_job *job, const sf_mesh *whole, sf_mesh_format format, halves *h)
{
    sf_mesh_view view = sf_mesh_get_view(whole);
    double low[3], high[3];
    int across = job->options.cut_axis;
    sf_fault fault = {SF_OK, 0, 0, ""};
    memset(h, 0, sizeof *h);
    sf_status status = sf_mesh_bounds(view, low, high);
    h->at_mm = job->options.cut_mm;
    if (status == SF_OK && !isfinite(h->at_mm)) {
        h->at_mm = low[across] + 0.5 * (high[across] - low[across]);
    }
    if (status == SF_OK) {
        status = sf_mesh_cut(view, across, h->at_mm, NULL, &h->mesh[0], &h->mesh[1], &fault);
    }
    if (status == SF_ERR_INFEASIBLE) {
        h->missed = 1;
        job_warn(job, "It was not cut as it came out. %s", fault.message);
        return EXIT_GOOD;
    }
    if (status == SF_OK) {
        status = measure(h);
    }
    for (int i = 0; status == SF_OK && format == SF_MESH_FORMAT_STL && i < 2; i++) {
        status = tidy(&h->mesh[i]);
    }
    return status == SF_OK ? EXIT_GOOD
                           : job_fail_call(job, status, &fault, "the halves", EXIT_INPUT);
}

exit_status halves_name(cli_job *job, const char *path, int is_high, char name[HALVES_PATH_SIZE])
{
    const char *dot = strrchr(path, '.');
    int length = snprintf(name, HALVES_PATH_SIZE, "%.*s_%s%s", (int)(dot - path), path,
                          is_high ? "high" : "low", dot);
    return length > 0 && length < HALVES_PATH_SIZE
               ? EXIT_GOOD
               : job_fail(job, EXIT_USAGE, "-o: The path is too long.");
}

static void report_half(report *r, const char *key, const char *path, double volume_mm3)
{
    report_begin(r, key);
    report_text(r, "output", path);
    report_number(r, "volume_mm3", volume_mm3);
    report_end(r);
}

void halves_report(cli_job *job, const halves *h, const char *low, const char *high)
{
    report *r = job->report;
    char across[2] = {axis_name(job), '\0'}, one[DESCRIBE_MM3_SIZE], other[DESCRIBE_MM3_SIZE];
    if (h->missed) {
        report_null(r, "halves");
        return;
    }
    report_begin(r, "halves");
    report_text(r, "axis", across);
    report_number(r, "at_mm", h->at_mm);
    report_half(r, "low", low, h->volume_mm3[0]);
    report_half(r, "high", high, h->volume_mm3[1]);
    report_count(r, "shut_cavities", h->shut);
    report_end(r);
    report_say(r, "Cut at %s %.6g mm: %s (%s) and %s (%s).", across, h->at_mm, low,
               describe_mm3(h->volume_mm3[0], one), high, describe_mm3(h->volume_mm3[1], other));
    if (h->shut > 0) {
        report_say(r, "%zu cavit%s not opened: the plane does not meet %s.", h->shut,
                   h->shut == 1 ? "y is" : "ies are", h->shut == 1 ? "it" : "them");
    }
}

void halves_release(halves *h)
{
    sf_mesh_destroy(h->mesh[0]);
    sf_mesh_destroy(h->mesh[1]);
    memset(h, 0, sizeof *h);
}
