// SPDX-License-Identifier: MIT
// Files of tetrahedra.
//
// The .xdmf beside an exchange file says to ParaView where in it points, tetrahedra and properties
// are. XDMF has no values by corners, so a property that jumps is named there and not shown; the
// VTK file has it, with points doubled.

#include "tets_write.h"

#include "output.h"
#include "progress.h"

#include <sf/cage_io.h>
#include <sf/exchange.h>
#include <sf/io.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int ends_with(const char *path, const char *end)
{
    size_t length = strlen(path), tail = strlen(end);
    return length >= tail && strcmp(path + length - tail, end) == 0;
}

exit_status tets_check_output(cli_job *job, int exchange_allowed)
{
    const char *path = job->options.output;
    if (path == NULL) {
        return job_fail(job, EXIT_USAGE, "Say where the result goes: -o FILE%s.",
                        exchange_allowed ? ".h5 or .vtk" : ".vtk");
    }
    if (!ends_with(path, ".vtk") && !(exchange_allowed && ends_with(path, ".h5"))) {
        return job_fail(job, EXIT_USAGE, "-o %s: this verb writes %s.", path,
                        exchange_allowed ? ".h5 (exchange) and .vtk" : ".vtk");
    }
    return output_probe(job, path, OUTPUT_UNKNOWN);
}

// What goes into a file.
typedef sf_status put(const void *what, sf_sink sink, sf_fault *fault);

static exit_status save(cli_job *job, const char *path, put *content, const void *what)
{
    sf_save *file = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    progress_phase("writing");
    sf_status status = sf_save_begin(path, NULL, &file, &fault);
    if (status == SF_OK) {
        status = content(what, sf_save_sink(file), &fault);
        if (status == SF_OK) {
            status = sf_save_commit(file, &fault);
        } else {
            sf_save_abort(file);
        }
    }
    return status == SF_OK ? EXIT_GOOD : job_fail_call(job, status, &fault, path, EXIT_RESOURCE);
}

static sf_status put_cage(const void *what, sf_sink sink, sf_fault *fault)
{
    return sf_cage_write_vtk(what, 1, NULL, sink, fault);
}

exit_status tets_write_cage(cli_job *job, const sf_cage_view *view, const char *path)
{
    return save(job, path, put_cage, view);
}

static sf_status put_exchange(const void *what, sf_sink sink, sf_fault *fault)
{
    return sf_exchange_write(what, sink, fault);
}

// ---------------------------------------------------------------------------------------------
// XDMF
// ---------------------------------------------------------------------------------------------

typedef struct xdmf {
    sf_tets_view view;
    const char *file; // the exchange file's name without its folder
} xdmf;

static sf_status say(sf_sink sink, const char *text)
{
    return sink.write(sink.user, text, strlen(text));
}

static sf_status say_escaped(sf_sink sink, const char *text)
{
    sf_status status = SF_OK;
    for (; status == SF_OK && *text != '\0'; text++) {
        char plain[2] = {*text, '\0'};
        status = say(sink, *text == '&'   ? "&amp;"
                           : *text == '<' ? "&lt;"
                           : *text == '"' ? "&quot;"
                                          : plain);
    }
    return status;
}

// A table of the exchange file; "VALUES" in the path stands for a property's.
static sf_status say_table(const xdmf *x, sf_sink sink, const char *kind, const char *dimensions,
                           const char *path)
{
    sf_status status = say(sink, "        <DataItem Format=\"HDF\" ");
    status = status == SF_OK ? say(sink, kind) : status;
    status = status == SF_OK ? say(sink, " Dimensions=\"") : status;
    status = status == SF_OK ? say(sink, dimensions) : status;
    status = status == SF_OK ? say(sink, "\">") : status;
    status = status == SF_OK ? say_escaped(sink, x->file) : status;
    status = status == SF_OK ? say(sink, ":") : status;
    status = status == SF_OK ? say(sink, path) : status;
    return status == SF_OK ? say(sink, "</DataItem>\n") : status;
}

static void name_values(const sf_property *p, char path[80])
{
    size_t at = (size_t)snprintf(path, 80, "/properties/");
    for (int i = 0; i < 16; i++) {
        at += (size_t)snprintf(path + at, 80 - at, "%s%02x",
                               i == 4 || i == 6 || i == 8 || i == 10 ? "-" : "", p->uuid[i]);
    }
    snprintf(path + at, 80 - at, "/values");
}

static sf_status say_property(const xdmf *x, sf_sink sink, const sf_channel *c)
{
    char path[80], count[32];
    int jumps = c->indices != NULL;
    sf_status status = say(sink, jumps ? "      <Information Name=\"jumps, see the VTK file: "
                                       : "      <Attribute Center=\"Node\" Name=\"");
    status = status == SF_OK ? say_escaped(sink, c->property.name) : status;
    if (jumps) {
        return status == SF_OK ? say(sink, "\"/>\n") : status;
    }
    name_values(&c->property, path);
    snprintf(count, sizeof count, "%zu", c->value_count);
    status = status == SF_OK ? say(sink, "\">\n") : status;
    status = status == SF_OK
                 ? say_table(x, sink, "NumberType=\"Float\" Precision=\"8\"", count, path)
                 : status;
    return status == SF_OK ? say(sink, "      </Attribute>\n") : status;
}

static sf_status put_xdmf(const void *what, sf_sink sink, sf_fault *fault)
{
    const xdmf *x = what;
    char text[320], points[48], tets[48];
    (void)fault;
    snprintf(points, sizeof points, "%zu 3", x->view.point_count);
    snprintf(tets, sizeof tets, "%zu 4", x->view.tet_count);
    snprintf(text, sizeof text,
             "<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\">\n  <Domain>\n    <Grid>\n"
             "      <Topology TopologyType=\"Tetrahedron\" NumberOfElements=\"%zu\">\n",
             x->view.tet_count);
    sf_status status = say(sink, text);
    status = status == SF_OK
                 ? say_table(x, sink, "NumberType=\"UInt\" Precision=\"4\"", tets, "/tets")
                 : status;
    status = status == SF_OK
                 ? say(sink, "      </Topology>\n      <Geometry GeometryType=\"XYZ\">\n")
                 : status;
    status = status == SF_OK
                 ? say_table(x, sink, "NumberType=\"Float\" Precision=\"8\"", points, "/positions")
                 : status;
    status = status == SF_OK ? say(sink, "      </Geometry>\n") : status;
    for (size_t i = 0; status == SF_OK && i < x->view.channel_count; i++) {
        status = say_property(x, sink, &x->view.channels[i]);
    }
    return status == SF_OK ? say(sink, "    </Grid>\n  </Domain>\n</Xdmf>\n") : status;
}

static exit_status write_xdmf(cli_job *job, const sf_tets *tets, const char *path)
{
    const char *slash = strrchr(path, '/');
    xdmf x = {sf_tets_get_view(tets), slash != NULL ? slash + 1 : path};
    size_t stem = strlen(path) - strlen(".h5");
    char *beside = malloc(stem + sizeof ".xdmf");
    if (beside == NULL) {
        return job_fail(job, EXIT_RESOURCE, "There is no memory for a name.");
    }
    memcpy(beside, path, stem);
    memcpy(beside + stem, ".xdmf", sizeof ".xdmf");
    exit_status status = save(job, beside, put_xdmf, &x);
    free(beside);
    return status;
}

exit_status tets_write(cli_job *job, const sf_tets *tets, const char *path)
{
    if (ends_with(path, ".h5")) {
        exit_status status = save(job, path, put_exchange, tets);
        return status == EXIT_GOOD ? write_xdmf(job, tets, path) : status;
    }
    sf_tets_view v = sf_tets_get_view(tets);
    uint32_t *starts = malloc((v.tet_count + 1) * sizeof *starts);
    if (starts == NULL) {
        return job_fail(job, EXIT_RESOURCE, "There is no memory for the tetrahedra.");
    }
    for (size_t i = 0; i <= v.tet_count; i++) {
        starts[i] = (uint32_t)(4 * i);
    }
    sf_cage_view view = {3, v.point_count, v.positions, v.tet_count, starts,          v.corners,
                         0, NULL,          0,           NULL,        v.channel_count, v.channels};
    exit_status status = tets_write_cage(job, &view, path);
    free(starts);
    return status;
}
