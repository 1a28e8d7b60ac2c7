// SPDX-License-Identifier: MIT
// Legacy VTK files in: an unstructured grid as the file gives it.
//
// Points, cells with their types, and data, for whoever makes a cage or a mesh of tetrahedra of
// them. Nothing is known of what types mean, and nothing is checked but the file itself: counts
// that agree with each other, numbers that are numbers, an end where it should be.

#ifndef SF_IO_VTK_READ_H
#define SF_IO_VTK_READ_H

#include "io/cursor.h"
#include "io/list.h"

// What data belong to.
typedef enum sfi_vtk_home { SFI_VTK_FIELD, SFI_VTK_POINTS, SFI_VTK_CELLS } sfi_vtk_home;

// Data with a name: rows of so many numbers. Kept are data of one component, and all of the grid's
// own field; other data of points and cells are read and dropped.
typedef struct sfi_vtk_array {
    char name[SFI_TOKEN_SIZE]; // with VTK's %20 and the like undone
    sfi_vtk_home home;
    uint32_t components;
    sfi_list values; // double, all rows one behind the other
} sfi_vtk_array;

typedef struct sfi_vtk {
    size_t points_max, corners_max; // to be set before reading
    sfi_list points;                // double[3], finite
    sfi_list starts;  // uint32_t, one more than cells: where the corners of each begin
    sfi_list corners; // uint32_t, not held against the points
    sfi_list types;   // uint32_t, as many as cells
    sfi_list lines;   // uint32_t, of each cell, in text below version 5; none elsewhere
    sfi_list arrays;  // sfi_vtk_array
} sfi_vtk;

// A grid of nothing, with limits as large as they can be.
void sfi_vtk_begin(sfi_vtk *vtk);
void sfi_vtk_end(sfi_vtk *vtk, const sf_allocator *allocator);

// Read a file, from its first line to its end, into a grid of nothing; whatever comes of it, the
// caller ends the grid. SF_ERR_FORMAT, SF_ERR_UNSUPPORTED (another kind of dataset, data that are
// no numbers), SF_ERR_OVERFLOW, SF_ERR_MEMORY, or what the source returned; with a sentence but for
// SF_ERR_MEMORY.
sf_status sfi_vtk_read(sfi_vtk *vtk, sfi_cursor *cursor, sf_fault *fault);

// The array of a name; NULL when there is none.
const sfi_vtk_array *sfi_vtk_find(const sfi_vtk *vtk, sfi_vtk_home home, const char *name);

#endif
