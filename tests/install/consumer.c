// SPDX-License-Identifier: MIT
// Why: what somebody else's program looks like. It must compile and run against nothing but what is
// installed: both headers, a function of each library, and the reader that brings all that files
// need. SF_ONE_FILE: against sf.c and sf.h instead. It is C99 and C++ both.
#ifdef SF_ONE_FILE
#include "sf.h"
#else
#include <sf/io.h>
#include <sf/sf.h>
#endif

#include <stdio.h>

int main(void)
{
    sf_lattice lattice = {8, 8, 4, 1.0, 1.0, 1.0, NULL, {0.0, 0.0, 0.0}};
    sf_rule rule = sf_rule_box3();
    sf_rect bed = {3, 3, 4, 4}, top = {0, 0, 8, 8};
    sf_trim_report report = {0, 0, 0};
    sf_grid *grid = NULL;
    if (sf_grid_create(&lattice, NULL, &grid) != SF_OK ||
        sf_slice_fill(sf_grid_slice(grid, 0), bed, 1) != SF_OK ||
        sf_slice_fill(sf_grid_slice(grid, 1), top, 1) != SF_OK ||
        sf_grid_trim(grid, &rule, SF_BED_AUTO, NULL, &report) != SF_OK) {
        return 1;
    }
    sf_grid_destroy(grid);
    sf_memory_cursor none = {"glTF", 4, 0};
    sf_mesh *mesh = NULL;
    if (sf_mesh_read(sf_memory_source(&none), SF_MESH_FORMAT_AUTO, NULL, NULL, &mesh, NULL) ==
        SF_OK) {
        return 1; // four bytes are no part
    }
    printf("libsf %s keeps %d of 65, format %d\n", sf_version(), (int)report.kept_voxels,
           (int)sf_mesh_format_from_name("part.stl"));
    return report.kept_voxels != 10 || sf_mesh_format_from_name("part.stl") != SF_MESH_FORMAT_STL;
}
