// SPDX-License-Identifier: MIT
// The mesh readers behind sf_mesh_read(), and what they share.
//
// Each reads from a cursor at the start of the file into an empty mesh, which the caller destroys
// when they fail. Arrays grow as data arrives: no count in a file is ever trusted for memory.

#ifndef SF_IO_READERS_H
#define SF_IO_READERS_H

#include "io/cursor.h"

typedef struct sfi_mesh_reader {
    sfi_cursor *cursor;
    sf_mesh *mesh;
    sf_read_limits limits;
    sf_fault *fault;
    void *corners; // uint32_t, of the polygon being read
    size_t corner_count, corner_capacity;
} sfi_mesh_reader;

sf_status sfi_stl_read(sfi_mesh_reader *reader);
sf_status sfi_obj_read(sfi_mesh_reader *reader);
sf_status sfi_ply_read(sfi_mesh_reader *reader);
sf_status sfi_off_read(sfi_mesh_reader *reader);
sf_status sfi_threemf_read_mesh(sfi_mesh_reader *reader);
sf_status sfi_gltf_read(sfi_mesh_reader *reader);

// Append a vertex: finite and within the limits, or a fault at the cursor's place.
sf_status sfi_reader_vertex(sfi_mesh_reader *reader, const double xyz[3]);

// Add a corner to the polygon being read: one of the vertices read so far, counted from 0, or a
// fault.
sf_status sfi_reader_corner(sfi_mesh_reader *reader, uint32_t vertex);

// Append the polygon as a fan of triangles about its first corner, and begin the next. A polygon of
// fewer than three corners is refused.
sf_status sfi_reader_polygon(sfi_mesh_reader *reader);

// The next token as a number, on this line only or (lines != 0) anywhere.
sf_status sfi_reader_number(sfi_mesh_reader *reader, double *value, int lines);

// Whether the bytes ahead look like ASCII STL; whether these bytes begin an OFF file, or binary
// glTF.
int sfi_stl_is_text(sfi_cursor *cursor);
int sfi_off_begins(const unsigned char *bytes, size_t have);
int sfi_gltf_begins(const unsigned char *bytes, size_t have);

#endif
