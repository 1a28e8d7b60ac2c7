// SPDX-License-Identifier: MIT
// Writing a grid as a stack, calling the verifier on it, and holding what it says of corrupted
// voxels against the library's own check of the whole grid. The path of the verifier is the first
// argument of each program here.

#ifndef SF_TEST_VERIFY_JUDGE_H
#define SF_TEST_VERIFY_JUDGE_H

#include <sf/io.h>

#include "io/folder.h"

static const char *verifier;

// Where a verifier's exit status cannot be told apart, say so by the shell: 1 when it is `status`.
static inline int verifier_exits(const char *folder, const char *more, int status)
{
    char command[2048];
    snprintf(command, sizeof command, "\"%s\" \"%s\" %s >\"%s\" 2>&1; test $? -eq %d", verifier,
             folder, more, folder_path("said"), status);
    return system(command) == 0;
}

static inline int write_stack(const sf_grid *grid, const sf_stack_info *info, const char *path)
{
    sf_directory *directory = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_status status = sf_directory_write(path, NULL, &directory, &fault);
    if (status == SF_OK) {
        status = sf_stack_write(grid, info, sf_directory_folder(directory), NULL, &fault);
        if (status == SF_OK) {
            status = sf_directory_commit(directory, &fault); // which closes it
        } else {
            sf_directory_close(directory);
        }
    }
    if (status != SF_OK) {
        printf("# %s\n", fault.message);
    }
    return status == SF_OK;
}

static inline sf_stack_info stack_info(sf_rule_kind kind, double degrees, uint32_t bed_layer)
{
    sf_stack_info info = {.has_rule = 1,
                          .rule = kind,
                          .angle_rad = degrees * (3.14159265358979323846 / 180.0),
                          .bed_layer = bed_layer};
    return info;
}

static inline int library_says_free(const sf_grid *grid, const sf_rule *rule, uint32_t bed_layer)
{
    sf_check_options o = sf_check_options_default();
    sf_check_report report = {0};
    o.rule = *rule;
    o.bed_layer = bed_layer;
    CHECK_EQ(sf_grid_check(grid, &o, NULL, NULL, &report, NULL), SF_OK);
    return report.support_free;
}

// Flip each voxel that the verifier flipped, and judge the whole grid. Returns how many of them
// left it support-free; `count` different ones must have been judged.
static inline int agree_on_corruptions(sf_grid *grid, const sf_rule *rule, uint32_t bed, int count)
{
    FILE *said = fopen(folder_path("said"), "r");
    int lines = 0, good = 0;
    unsigned x, y, z, verdict;
    sf_grid *judged = NULL;
    sf_lattice lattice = sf_grid_lattice(grid);
    CHECK_EQ(sf_grid_create(&lattice, NULL, &judged), SF_OK);
    CHECK(said != NULL && fscanf(said, "support-free ") == 0);
    while (said != NULL && fscanf(said, "%u %u %u %u", &x, &y, &z, &verdict) == 4) {
        sf_slice slice = sf_grid_slice(grid, z);
        int before = sf_slice_get(slice, x, y);
        CHECK_EQ(sf_slice_set(slice, x, y, !before), SF_OK);
        CHECK_EQ(verdict, library_says_free(grid, rule, bed));
        CHECK_EQ(sf_slice_set(slice, x, y, before), SF_OK);
        CHECK_EQ(sf_slice_set(sf_grid_slice(judged, z), x, y, 1), SF_OK);
        good += verdict == 1;
        lines++;
    }
    CHECK_EQ(lines, count);
    CHECK_EQ(sf_grid_popcount(judged), count);
    sf_grid_destroy(judged);
    if (said != NULL) {
        fclose(said);
    }
    return good;
}

// The six rules of these tests.
static const struct {
    sf_rule_kind kind;
    double degrees;
} verified_rules[] = {{SF_RULE_BOX3, 45.0},    {SF_RULE_OCTAGON, 30.0}, {SF_RULE_OCTAGON, 45.0},
                      {SF_RULE_OCTAGON, 62.0}, {SF_RULE_DISK, 45.0},    {SF_RULE_DISK, 72.0}};
#define VERIFIED_RULES 6

#endif
