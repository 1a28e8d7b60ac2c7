// SPDX-License-Identifier: MIT
// A stack on the disk stands whole or not at all, an earlier stack gives way to a new one, and
// nobody's other files are ever removed. Guards: issue 2 part 6 (atomic save), nothing leaves half
// a file.

#include <sf/io.h>

#include "failing_allocator.h"
#include "folder.h"

#define PATH folder_path("out")

static sf_grid *grid_of(uint32_t layers)
{
    sf_lattice lattice = {20, 10, layers, 0.1, 0.1, 0.1, NULL, {0, 0, 0}};
    sf_grid *grid = NULL;
    CHECK_EQ(sf_grid_create(&lattice, NULL, &grid), SF_OK);
    CHECK_EQ(sf_slice_set(sf_grid_slice(grid, layers - 1), 3, 4, 1), SF_OK);
    return grid;
}

static sf_status save(const char *path, const sf_grid *grid, sf_fault *fault)
{
    sf_directory *directory = NULL;
    memset(fault, 0, sizeof *fault);
    sf_status status = sf_directory_write(path, NULL, &directory, fault);
    if (status != SF_OK) {
        CHECK(directory == NULL && strlen(fault->message) > 20 && fault->status == status);
        return status;
    }
    CHECK_EQ(sf_stack_write(grid, NULL, sf_directory_folder(directory), NULL, fault), SF_OK);
    return sf_directory_commit(directory, fault);
}

static void writes_and_reads(void)
{
    folder_begin("directory");
    sf_grid *grid = grid_of(5), *back = NULL;
    sf_directory *directory = NULL;
    sf_fault fault;
    CHECK_EQ(save(PATH, grid, &fault), SF_OK);
    CHECK_EQ(folder_count(PATH), 6);
    CHECK_EQ(folder_count(test_folder), 1);
    CHECK_EQ(sf_directory_read(PATH, NULL, &directory, &fault), SF_OK);
    sf_folder folder = sf_directory_folder(directory);
    sf_status status = sf_stack_read(folder, NULL, NULL, &back, NULL, &fault);
    CHECK(status == SF_ERR_UNSUPPORTED || (status == SF_OK && sf_grid_equal(grid, back)));
    sf_sink sink;
    CHECK_EQ(folder.begin(folder.user, "x", &sink), SF_ERR_ARGUMENT); // it is being read
    sf_source source;
    CHECK_EQ(folder.open(folder.user, "../out/stack.json", &source), SF_ERR_ARGUMENT);
    CHECK_EQ(folder.open(folder.user, "none", &source), SF_ERR_IO);
    sf_directory_close(directory);
    sf_grid_destroy(grid);
    sf_grid_destroy(back);
    folder_end();
}

static void replaces_only_what_is_ours(void)
{
    folder_begin("directory");
    sf_grid *large = grid_of(5), *small = grid_of(2);
    sf_fault fault;
    CHECK_EQ(sfi_disk_make_folder(PATH), 0); // empty: gives way
    CHECK_EQ(save(PATH, large, &fault), SF_OK);
    CHECK_EQ(folder_count(PATH), 6);
    char with_separator[600];
    snprintf(with_separator, sizeof with_separator, "%s//", PATH);
    CHECK_EQ(save(with_separator, small, &fault), SF_OK); // an earlier stack: gives way
    CHECK_EQ(folder_count(PATH), 3);
    CHECK_EQ(folder_count(test_folder), 1);

    CHECK(folder_write(folder_path("out/notes.txt"), "dear diary"));
    CHECK_EQ(save(PATH, large, &fault), SF_ERR_IO);
    CHECK(strstr(fault.message, "notes.txt") != NULL);
    CHECK_EQ(folder_count(PATH), 4);
    sfi_disk_remove_file(folder_path("out/notes.txt"));
    sfi_disk_remove_file(folder_path("out/stack.json"));
    CHECK_EQ(save(PATH, large, &fault), SF_ERR_IO); // pictures, but no stack
    CHECK(strstr(fault.message, "no stack.json") != NULL);
    CHECK_EQ(folder_count(PATH), 2);
    CHECK(folder_write(folder_path("file"), "x"));
    CHECK_EQ(save(folder_path("file"), large, &fault), SF_ERR_IO);
    CHECK_EQ(save(folder_path("none/out"), large, &fault), SF_ERR_IO);
    CHECK_EQ(save(folder_path("."), large, &fault), SF_ERR_IO);
    CHECK_EQ(save("..", large, &fault), SF_ERR_IO);
    CHECK_EQ(save("/", large, &fault), SF_ERR_IO);
    CHECK_EQ(save("", large, &fault), SF_ERR_ARGUMENT);
    CHECK_EQ(folder_count(test_folder), 2);
    sf_grid_destroy(large);
    sf_grid_destroy(small);
    folder_end();
}

static void shows_nothing_before_commit(void)
{
    folder_begin("directory");
    sf_grid *grid = grid_of(5), *old = grid_of(2);
    sf_directory *directory = NULL;
    sf_fault fault;
    sf_sink sink;
    CHECK_EQ(sf_directory_write(PATH, NULL, &directory, &fault), SF_OK);
    CHECK_EQ(sf_stack_write(grid, NULL, sf_directory_folder(directory), NULL, &fault), SF_OK);
    CHECK_EQ(sfi_disk_look(PATH), SFI_DISK_NOTHING);
    sf_directory_close(directory);
    CHECK_EQ(folder_count(test_folder), 0);

    // Left in the middle of a file, over an earlier stack.
    CHECK_EQ(save(PATH, old, &fault), SF_OK);
    CHECK_EQ(sf_directory_write(PATH, NULL, &directory, &fault), SF_OK);
    sf_folder folder = sf_directory_folder(directory);
    CHECK_EQ(folder.begin(folder.user, "../x", &sink), SF_ERR_ARGUMENT);
    CHECK_EQ(folder.begin(folder.user, "half.png", &sink), SF_OK);
    CHECK_EQ(folder.begin(folder.user, "other.png", &sink), SF_ERR_ARGUMENT);
    CHECK_EQ(sink.write(sink.user, "abc", 3), SF_OK);
    sf_directory_close(directory);
    CHECK_EQ(folder_count(test_folder), 1);
    CHECK_EQ(folder_count(PATH), 3);

    // Somebody puts a file of theirs into the target while we write.
    CHECK_EQ(sf_directory_write(PATH, NULL, &directory, &fault), SF_OK);
    CHECK_EQ(sf_stack_write(grid, NULL, sf_directory_folder(directory), NULL, &fault), SF_OK);
    CHECK(folder_write(folder_path("out/theirs"), "x"));
    CHECK_EQ(sf_directory_commit(directory, &fault), SF_ERR_IO);
    CHECK_EQ(folder_count(test_folder), 1);
    CHECK_EQ(folder_count(PATH), 4);
    sf_grid_destroy(grid);
    sf_grid_destroy(old);
    folder_end();
}

static void refuses_what_is_no_folder(void)
{
    folder_begin("directory");
    sf_directory *directory = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    CHECK_EQ(sf_directory_read(folder_path("none"), NULL, &directory, &fault), SF_ERR_IO);
    CHECK(strstr(fault.message, "no such") != NULL);
    CHECK(folder_write(folder_path("file"), "x"));
    CHECK_EQ(sf_directory_read(folder_path("file"), NULL, &directory, &fault), SF_ERR_IO);
    CHECK_EQ(sf_directory_read(NULL, NULL, &directory, &fault), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_directory_write("x", NULL, NULL, &fault), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_directory_commit(NULL, &fault), SF_ERR_ARGUMENT);
    CHECK(directory == NULL && sf_directory_folder(NULL).open == NULL);
    sf_directory_close(NULL);
    folder_end();
}

static void survives_refused_allocations(void)
{
    folder_begin("directory");
    sf_grid *grid = grid_of(2);
    sf_fault fault;
    CHECK_EQ(save(PATH, grid, &fault), SF_OK);
    sf_status status = SF_ERR_MEMORY;
    for (long k = 0; status != SF_OK && k < 100; k++) {
        failing_allocator memory;
        sf_directory *directory = NULL;
        failing_begin(&memory, k);
        status = sf_directory_write(PATH, &memory.allocator, &directory, &fault);
        if (status == SF_OK) {
            status = sf_stack_write(grid, NULL, sf_directory_folder(directory), NULL, &fault);
            if (status == SF_OK) {
                status = sf_directory_commit(directory, &fault);
            } else {
                sf_directory_close(directory);
            }
        }
        CHECK_EQ(folder_count(test_folder), 1);
        CHECK(status == SF_OK || status == SF_ERR_MEMORY);
        CHECK_EQ(folder_count(PATH), 3);
        CHECK(memory.live == 0 && memory.faults == 0);
    }
    CHECK_EQ(status, SF_OK);
    sf_grid_destroy(grid);
    folder_end();
}

int main(void)
{
    TEST(writes_and_reads);
    TEST(replaces_only_what_is_ours);
    TEST(shows_nothing_before_commit);
    TEST(refuses_what_is_no_folder);
    TEST(survives_refused_allocations);
    return test_finish();
}
