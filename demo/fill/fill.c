// SPDX-License-Identifier: MIT
// A closed surface with values at its vertices, as tetrahedra with the values spread inside.
//
// Two programs are made of this file. sf-fill goes by voxels, and needs nothing but libsf.
// sf-tetgen goes by TetGen, whose licence is the GNU Affero General Public Licence, version 3, and
// so is that of the program; it is built only where it is asked for. What either writes, an
// exchange file or VTK, is printed by `sf grade`. A child does the work, with limits, because
// TetGen may die of a surface.

#include "painted.h"

#include <sf/cage_io.h>
#include <sf/exchange.h>
#include <sf/io.h>

#ifdef SF_FILL_BY_TETGEN
#include <sf/link/tetgen.h>
#endif

#include <getopt.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#ifdef SF_FILL_BY_TETGEN
#define NAME "sf-tetgen"
#define OWN                                                                                        \
    "  --quality Q       most radius of a ball around a tetrahedron by its shortest edge (2)\n"    \
    "  --volume MM3      most volume of a tetrahedron (that of the part by 20000)\n"
#define EXAMPLE "  sf-tetgen part.obj --values stiffness.txt --property stiffness -o part.h5\n"
#else
#define NAME "sf-fill"
#define OWN "  --pitch MM        size of a voxel (the longest side by 100)\n"
#define EXAMPLE                                                                                    \
    "  sf-fill part.obj --values stiffness.txt --property stiffness --pitch 0.5 -o part.h5\n"
#endif

static const char usage[] =
    NAME ": a closed surface as tetrahedra, what is painted on it spread inside\n\n"
         "usage: " NAME " MESH --values FILE -o FILE.h5|FILE.vtk [options]\n\n"
         "A MESH is an STL, OBJ, PLY or OFF file. FILE has a number for each vertex, in their "
         "order, or\n"
         "- where a vertex is free.\n\n"
         "  -o FILE           an exchange file (.h5) or legacy VTK (.vtk)\n"
         "  --property NAME   what the values are: density, young, poisson or a name of your own "
         "(value)\n" OWN "  --json            say it in JSON\n"
         "  --help            this\n\n"
         "examples:\n" EXAMPLE "  sf grade part.h5 --property stiffness -o graded\n\n"
         "exit status: 0 done, 2 usage, 3 bad input, 4 memory or disk\n";

typedef struct options {
    const char *mesh, *values, *output, *property;
    double pitch_mm, quality, most_mm3;
    int json;
} options;

// ---------------------------------------------------------------------------------------------
// Saying
// ---------------------------------------------------------------------------------------------

static void print_quoted(const char *text)
{
    putchar('"');
    for (; *text != '\0'; text++) {
        unsigned char c = (unsigned char)*text;
        if (c == '"' || c == '\\') {
            printf("\\%c", c);
        } else if (c < ' ') {
            printf("\\u%04x", c);
        } else {
            putchar(c);
        }
    }
    putchar('"');
}

static int fail(const options *o, int status, const char *subject, const char *sentence)
{
    fprintf(stderr, NAME ": %s%s%s\n", subject, subject[0] != '\0' ? ": " : "", sentence);
    if (o->json) {
        printf("{\"error\": ");
        print_quoted(sentence);
        printf("}\n");
    }
    return status;
}

static int fail_call(const options *o, sf_status status, const sf_fault *fault, const char *subject)
{
    int is_resource = status == SF_ERR_MEMORY || status == SF_ERR_OVERFLOW;
    return fail(o, is_resource ? 4 : 3, subject,
                fault->message[0] != '\0' ? fault->message : sf_status_message(status));
}

// ---------------------------------------------------------------------------------------------
// Reading and writing
// ---------------------------------------------------------------------------------------------

static int ends_with(const char *path, const char *end)
{
    size_t length = strlen(path), tail = strlen(end);
    return length >= tail && strcmp(path + length - tail, end) == 0;
}

static sf_status read_mesh(const char *path, sf_mesh **mesh, sf_fault *fault)
{
    sf_file *file = NULL;
    sf_status status = sf_file_open(path, NULL, &file, fault);
    if (status == SF_OK) {
        status = sf_mesh_read(sf_file_source(file), sf_mesh_format_from_name(path), NULL, NULL,
                              mesh, fault);
        sf_file_close(file);
    }
    return status;
}

// A number a vertex. Returns 0, or the line that is none, or one more than there are lines.
static size_t read_values(FILE *file, size_t count, double *values)
{
    char line[256];
    size_t i = 0;
    for (; i < count && fgets(line, sizeof line, file) != NULL; i++) {
        char *end;
        values[i] = strtod(line, &end);
        int is_number = end != line && isfinite(values[i]);
        end = is_number ? end : line + (line[0] == '-');
        values[i] = is_number ? values[i] : NAN;
        if (end == line || end[strspn(end, " \t\r\n")] != '\0') {
            return i + 1;
        }
    }
    return i < count ? i + 1 : 0;
}

static int load_values(const options *o, size_t count, double *values)
{
    char sentence[160];
    FILE *file = fopen(o->values, "r");
    if (file == NULL) {
        return fail(o, 3, o->values, "The file cannot be read.");
    }
    size_t line = read_values(file, count, values);
    int more = line == 0 && fgetc(file) != EOF;
    fclose(file);
    if (line != 0 || more) {
        snprintf(sentence, sizeof sentence,
                 "Line %zu is no number and no -, or there are not as many lines as vertices, %zu.",
                 more ? count + 1 : line, count);
        return fail(o, 3, o->values, sentence);
    }
    return 0;
}

static sf_status name_property(const char *name, sf_property *property)
{
    sf_property known[3] = {sf_property_density(), sf_property_young(), sf_property_poisson()};
    static const char *const names[3] = {"density", "young", "poisson"};
    for (int i = 0; i < 3; i++) {
        if (strcmp(names[i], name) == 0) {
            *property = known[i];
            return SF_OK;
        }
    }
    return sf_property_named(name, property);
}

// Tetrahedra are a cage of cells with four corners each.
static sf_status write_vtk(const sf_tets *tets, sf_sink sink, sf_fault *fault)
{
    sf_tets_view t = sf_tets_get_view(tets);
    uint32_t *starts = malloc((t.tet_count + 1) * sizeof *starts);
    if (starts == NULL) {
        return SF_ERR_MEMORY;
    }
    for (size_t i = 0; i <= t.tet_count; i++) {
        starts[i] = (uint32_t)(4 * i);
    }
    sf_cage_view view = {3, t.point_count, t.positions, t.tet_count, starts,          t.corners,
                         0, NULL,          0,           NULL,        t.channel_count, t.channels};
    sf_status status = sf_cage_write_vtk(&view, 1, NULL, sink, fault);
    free(starts);
    return status;
}

static sf_status save(const options *o, const sf_tets *tets, sf_fault *fault)
{
    sf_save *file = NULL;
    sf_status status = sf_save_begin(o->output, NULL, &file, fault);
    if (status == SF_OK) {
        status = ends_with(o->output, ".h5") ? sf_exchange_write(tets, sf_save_sink(file), fault)
                                             : write_vtk(tets, sf_save_sink(file), fault);
        if (status == SF_OK) {
            return sf_save_commit(file, fault);
        }
        sf_save_abort(file);
    }
    return status;
}

// ---------------------------------------------------------------------------------------------
// The work
// ---------------------------------------------------------------------------------------------

static sf_status fill(const options *o, sf_mesh_view mesh, const double *values, sf_tets **tets,
                      sf_fault *fault)
{
    sf_property property;
    sf_status status = name_property(o->property, &property);
    if (status != SF_OK) {
        return status;
    }
#ifdef SF_FILL_BY_TETGEN
    sf_tetgen_options how = sf_tetgen_options_default();
    how.values = values;
    how.property = &property;
    how.quality = o->quality > 0 ? o->quality : how.quality;
    how.most_mm3 = o->most_mm3;
    return sf_tetgen_fill(mesh, &how, NULL, NULL, tets, fault);
#else
    double low[3], high[3], pitch = o->pitch_mm;
    for (size_t i = 0; i < mesh.vertex_count; i++) {
        if (values[i] < property.low || values[i] > property.high) {
            fault->status = SF_ERR_ARGUMENT;
            snprintf(fault->message, sizeof fault->message,
                     "the value of vertex %zu lies outside of its property's bounds", i);
            return SF_ERR_ARGUMENT;
        }
    }
    if (pitch <= 0 && sf_mesh_bounds(mesh, low, high) == SF_OK) {
        pitch = fmax(fmax(high[0] - low[0], high[1] - low[1]), high[2] - low[2]) / 100;
    }
    return painted_voxels(mesh, values, &property, pitch, tets, fault);
#endif
}

static int report(const options *o, const sf_tets *tets)
{
    sf_tets_report found;
    sf_tets_view v = sf_tets_get_view(tets);
    if (sf_tets_check(tets, NULL, &found) != SF_OK) {
        return fail(o, 4, "", "There is not enough memory.");
    }
    if (o->json) {
        printf("{\"points\": %zu, \"tetrahedra\": %zu, \"volume_mm3\": %.15g, \"output\": ",
               v.point_count, v.tet_count, found.volume_mm3);
        print_quoted(o->output);
        printf("}\n");
    } else {
        printf("%s: %zu tetrahedra of %zu points, %.6g mm3\n", o->output, v.tet_count,
               v.point_count, found.volume_mm3);
    }
    return 0;
}

static int work(const options *o)
{
    sf_mesh *mesh = NULL;
    sf_tets *tets = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_status status = read_mesh(o->mesh, &mesh, &fault);
    if (status != SF_OK) {
        return fail_call(o, status, &fault, o->mesh);
    }
    sf_mesh_view view = sf_mesh_get_view(mesh);
    double *values = malloc(view.vertex_count * sizeof *values);
    int end = values == NULL ? fail(o, 4, "", "There is not enough memory.")
                             : load_values(o, view.vertex_count, values);
    if (end == 0) {
        status = fill(o, view, values, &tets, &fault);
        end = status == SF_OK ? 0 : fail_call(o, status, &fault, o->mesh);
    }
    if (end == 0) {
        status = save(o, tets, &fault);
        end = status == SF_OK ? report(o, tets) : fail_call(o, status, &fault, o->output);
    }
    sf_tets_destroy(tets);
    sf_mesh_destroy(mesh);
    free(values);
    return end;
}

// ---------------------------------------------------------------------------------------------
// The command line
// ---------------------------------------------------------------------------------------------

static int number(const char *text, double *value)
{
    char *end;
    *value = strtod(text, &end);
    return end != text && *end == '\0' && *value > 0 && isfinite(*value);
}

static int parse(int argc, char **argv, options *o)
{
    static const struct option known[] = {
        {"values", 1, NULL, 'v'},  {"property", 1, NULL, 'p'}, {"pitch", 1, NULL, 'i'},
        {"quality", 1, NULL, 'q'}, {"volume", 1, NULL, 'm'},   {"output", 1, NULL, 'o'},
        {"json", 0, NULL, 'j'},    {"help", 0, NULL, 'h'},     {NULL, 0, NULL, 0}};
    int good = 1, c;
    while ((c = getopt_long(argc, argv, "o:h", known, NULL)) != -1) {
        switch (c) {
        case 'v':
            o->values = optarg;
            break;
        case 'p':
            o->property = optarg;
            break;
        case 'o':
            o->output = optarg;
            break;
        case 'j':
            o->json = 1;
            break;
        case 'i':
            good = number(optarg, &o->pitch_mm) && good;
            break;
        case 'q':
            good = number(optarg, &o->quality) && good;
            break;
        case 'm':
            good = number(optarg, &o->most_mm3) && good;
            break;
        case 'h':
            return 1;
        default:
            return -1;
        }
    }
    o->mesh = optind + 1 == argc ? argv[optind] : NULL;
    return good && o->mesh != NULL && o->values != NULL && o->output != NULL ? 0 : -1;
}

// In a child: whatever becomes of it, no file is half written.
static int work_aside(const options *o)
{
    int status = 0;
    fflush(NULL);
    pid_t child = fork();
    if (child == 0) {
        struct rlimit seconds = {3600, 3600};
        setrlimit(RLIMIT_CPU, &seconds);
        int end = work(o);
        fflush(NULL);
        _exit(end);
    }
    if (child < 0) {
        return work(o);
    }
    if (waitpid(child, &status, 0) == child && WIFEXITED(status)) {
        return WEXITSTATUS(status);
    }
    return fail(o, 3, o->mesh, "The surface is such that filling it failed; repair it first.");
}

int main(int argc, char **argv)
{
    options o = {NULL, NULL, NULL, "value", 0, 0, 0, 0};
    int asked = parse(argc, argv, &o);
    if (asked != 0) {
        fputs(usage, asked > 0 ? stdout : stderr);
        return asked > 0 ? 0 : 2;
    }
    if (!ends_with(o.output, ".h5") && !ends_with(o.output, ".vtk")) {
        return fail(&o, 2, o.output, "The name of the result ends in .h5 or .vtk.");
    }
    if (ends_with(o.output, ".h5") && !sf_exchange_is_served()) {
        return fail(&o, 2, o.output, "This build writes no exchange files; write .vtk.");
    }
    return work_aside(&o);
}
