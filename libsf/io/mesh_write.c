// SPDX-License-Identifier: MIT
// Meshes out: binary STL, OBJ, binary little-endian PLY (3MF and binary glTF have files of their
// own).
//
// OBJ and PLY keep every bit of every coordinate: OBJ by the fewest digits that read back as the
// same double, PLY by doubles. STL has floats, because every reader of it expects them, and no
// shared vertices; corners that were one vertex are still equal in it, bit for bit, since equal
// doubles round to equal floats. All that can be wrong with a mesh is found before the first byte
// is written.

#include <sf/gltf.h>
#include <sf/threemf.h>

#include "base/status.h"
#include "io/emitter.h"

#include <float.h>
#include <math.h>
#include <string.h>

// One object, in its place.
static sf_status write_3mf(sf_mesh_view mesh, sf_sink sink)
{
    sf_threemf_object object = {"", SF_THREEMF_MODEL, mesh, NULL, SF_THREEMF_NONE, 0};
    sf_threemf_item item = {0, {{1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 0, 0}}};
    sf_threemf_view view = {NULL, 0, &object, 1, &item, 1, 0};
    return sf_threemf_write(&view, NULL, sink, NULL, NULL, NULL);
}

static const double *corner_of(sf_mesh_view mesh, size_t triangle, int corner)
{
    return mesh.vertices + 3 * (size_t)mesh.triangles[3 * triangle + (size_t)corner];
}

// The unit normal of a triangle; zero where it has none.
static void unit_normal(sf_mesh_view mesh, size_t triangle, double normal[3])
{
    const double *a = corner_of(mesh, triangle, 0), *b = corner_of(mesh, triangle, 1);
    const double *c = corner_of(mesh, triangle, 2);
    double u[3], v[3];
    for (int i = 0; i < 3; i++) {
        u[i] = b[i] - a[i];
        v[i] = c[i] - a[i];
    }
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        normal[i] = u[j] * v[k] - u[k] * v[j];
    }
    double length = sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
    int has_normal = length > 0.0 && length <= DBL_MAX;
    for (int i = 0; i < 3; i++) {
        normal[i] = has_normal ? normal[i] / length : 0.0;
    }
}

static sf_status check_stl(sf_mesh_view mesh)
{
    if (mesh.triangle_count > UINT32_MAX) {
        return SF_ERR_OVERFLOW;
    }
    for (size_t i = 0; i < 3 * mesh.vertex_count; i++) {
        if (fabs(mesh.vertices[i]) > (double)FLT_MAX) {
            return SF_ERR_OVERFLOW;
        }
    }
    return SF_OK;
}

static void write_stl(sf_mesh_view mesh, sfi_emitter *out)
{
    // The header must not begin with "solid", which is how text begins.
    static const char header[80] = "binary STL, mm, written by libsf";
    static const unsigned char attribute[2] = {0, 0};
    sfi_emit_bytes(out, header, sizeof header);
    sfi_emit_u32(out, (uint32_t)mesh.triangle_count);
    for (size_t t = 0; t < mesh.triangle_count; t++) {
        double normal[3];
        unit_normal(mesh, t, normal);
        for (int i = 0; i < 3; i++) {
            sfi_emit_float(out, (float)normal[i]);
        }
        for (int i = 0; i < 9; i++) {
            sfi_emit_float(out, (float)corner_of(mesh, t, i / 3)[i % 3]);
        }
        sfi_emit_bytes(out, attribute, sizeof attribute);
    }
}

static void write_obj(sf_mesh_view mesh, sfi_emitter *out)
{
    sfi_emit_text(out, "# written by libsf, mm\n");
    for (size_t i = 0; i < 3 * mesh.vertex_count; i++) {
        sfi_emit_text(out, i % 3 == 0 ? "v " : " ");
        sfi_emit_number(out, mesh.vertices[i]);
        sfi_emit_text(out, i % 3 == 2 ? "\n" : "");
    }
    for (size_t i = 0; i < 3 * mesh.triangle_count; i++) {
        sfi_emit_text(out, i % 3 == 0 ? "f " : " ");
        sfi_emit_whole(out, (uint64_t)mesh.triangles[i] + 1);
        sfi_emit_text(out, i % 3 == 2 ? "\n" : "");
    }
}

static void write_ply(sf_mesh_view mesh, sfi_emitter *out)
{
    static const unsigned char three = 3;
    sfi_emit_text(out, "ply\nformat binary_little_endian 1.0\ncomment written by libsf, mm\n"
                       "element vertex ");
    sfi_emit_whole(out, mesh.vertex_count);
    sfi_emit_text(out, "\nproperty double x\nproperty double y\nproperty double z\nelement face ");
    sfi_emit_whole(out, mesh.triangle_count);
    // Some readers know int only, and int does where it can.
    sfi_emit_text(out, mesh.vertex_count <= INT32_MAX
                           ? "\nproperty list uchar int vertex_indices\nend_header\n"
                           : "\nproperty list uchar uint vertex_indices\nend_header\n");
    for (size_t i = 0; i < 3 * mesh.vertex_count; i++) {
        sfi_emit_double(out, mesh.vertices[i]);
    }
    for (size_t t = 0; t < mesh.triangle_count; t++) {
        sfi_emit_bytes(out, &three, 1);
        for (size_t i = 3 * t; i < 3 * t + 3; i++) {
            sfi_emit_u32(out, mesh.triangles[i]);
        }
    }
}

sf_status sf_mesh_write(sf_mesh_view mesh, sf_mesh_format format, sf_sink sink)
{
    static void (*const writers[])(sf_mesh_view, sfi_emitter *) = {
        NULL, write_stl, write_obj, write_ply, NULL, NULL, NULL};
    if (sink.write == NULL || format == SF_MESH_FORMAT_AUTO ||
        (unsigned)format > SF_MESH_FORMAT_GLTF) {
        return SF_ERR_ARGUMENT;
    }
    if (format == SF_MESH_FORMAT_THREEMF) {
        return write_3mf(mesh, sink);
    }
    if (format == SF_MESH_FORMAT_GLTF) {
        return sf_gltf_write(mesh, NULL, sink);
    }
    if (writers[format] == NULL) {
        return SF_ERR_UNSUPPORTED;
    }
    SF_TRY(sf_mesh_validate(mesh, NULL));
    if (format == SF_MESH_FORMAT_STL) {
        SF_TRY(check_stl(mesh));
    }
    sfi_emitter out;
    sfi_emitter_begin(&out, sink);
    writers[format](mesh, &out);
    return sfi_emitter_end(&out);
}
