// SPDX-License-Identifier: MIT
// Why: a disk can fail in every call, and a process can end between any two of them. Whoever looks
// at the path then finds the old file or the new one, whole. The calls of the C library that save.c
// and directory.c make are stood in for here and fail one after the other, for every k; and a child
// that saves without end is killed 2,000 times. Guards: promise 6 of the plan for trust, the strong
// guarantee.

#ifdef __linux__

#define _GNU_SOURCE

#include <sf/io.h>

#include "folder.h"

#include <dlfcn.h>
#include <errno.h>
#include <signal.h>
#include <stdarg.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

static long calls, broken_call = -1; // so far, and which one fails

static int is_broken(void)
{
    int broken = calls == broken_call;
    calls++;
    errno = broken ? EIO : errno;
    return broken;
}

// The C library's own, behind the one that stands here.
static void find_real(const char *name, void *pointer)
{
    void *found = dlsym(RTLD_NEXT, name);
    memcpy(pointer, &found, sizeof found);
}

size_t fwrite(const void *data, size_t size, size_t count, FILE *file)
{
    size_t (*real)(const void *, size_t, size_t, FILE *);
    find_real("fwrite", &real);
    return file != stdout && is_broken() ? 0 : real(data, size, count, file);
}

int fsync(int descriptor)
{
    int (*real)(int);
    find_real("fsync", &real);
    return is_broken() ? -1 : real(descriptor);
}

int rename(const char *from, const char *to)
{
    int (*real)(const char *, const char *);
    find_real("rename", &real);
    return is_broken() ? -1 : real(from, to);
}

FILE *fdopen(int descriptor, const char *mode)
{
    FILE *(*real)(int, const char *);
    find_real("fdopen", &real);
    return is_broken() ? NULL : real(descriptor, mode);
}

int mkdir(const char *path, mode_t mode)
{
    int (*real)(const char *, mode_t);
    find_real("mkdir", &real);
    return is_broken() ? -1 : real(path, mode);
}

enum { SIZE = 3000, KILLS = 2000 };

static sf_status save_letters(const char *path, char letter, sf_fault *fault)
{
    static char bytes[SIZE];
    sf_save *save = NULL;
    memset(bytes, letter, SIZE);
    sf_status status = sf_save_begin(path, NULL, &save, fault);
    if (status != SF_OK) {
        return status;
    }
    sf_sink sink = sf_save_sink(save);
    for (int i = 0; i < 3 && status == SF_OK; i++) {
        status = sink.write(sink.user, bytes + i * SIZE / 3, SIZE / 3);
    }
    if (status != SF_OK) {
        sf_save_abort(save);
        return status;
    }
    return sf_save_commit(save, fault);
}

// The letter that a whole file consists of; 0 for any other file.
static char letter_of(const char *path)
{
    char found[SIZE + 8];
    if (folder_read(path, found, sizeof found - 1) != SIZE) {
        return 0;
    }
    for (int i = 1; i < SIZE; i++) {
        if (found[i] != found[0]) {
            return 0;
        }
    }
    return found[0];
}

static void every_call_of_a_save_may_fail(void)
{
    folder_begin("broken_save");
    CHECK_EQ(save_letters(folder_path("file"), 'a', NULL), SF_OK);
    long failed = 0;
    for (long k = 0;; k++) {
        sf_fault fault = {SF_OK, 0, 0, ""};
        calls = 0;
        broken_call = k;
        sf_status status = save_letters(folder_path("file"), 'b', &fault);
        broken_call = -1;
        CHECK_EQ(folder_count(test_folder), 1);
        if (status == SF_OK && calls <= k) {
            CHECK_EQ(letter_of(folder_path("file")), 'b');
            break; // there is no k-th call
        }
        char letter = letter_of(folder_path("file"));
        CHECK(letter == 'a' || letter == 'b');
        CHECK(status == SF_ERR_IO || (status == SF_OK && letter == 'b'));
        CHECK(status != SF_OK || letter == 'b');
        failed += status != SF_OK;
        CHECK_EQ(save_letters(folder_path("file"), 'a', NULL), SF_OK);
    }
    printf("# %ld calls failed in turn\n", failed);
    CHECK(failed >= 4);
    folder_end();
}

static sf_grid *solid(uint32_t layers)
{
    sf_lattice l = {9, 7, layers, 0.5, 0.5, 0.5, NULL, {0, 0, 0}};
    sf_grid *grid = NULL;
    CHECK_EQ(sf_grid_create(&l, NULL, &grid), SF_OK);
    for (uint32_t k = 0; k < layers; k++) {
        sf_rect all = {0, 0, 9, 7};
        CHECK_EQ(sf_slice_fill(sf_grid_slice(grid, k), all, 1), SF_OK);
    }
    return grid;
}

static sf_status save_stack(const char *path, const sf_grid *grid)
{
    sf_directory *directory = NULL;
    sf_status status = sf_directory_write(path, NULL, &directory, NULL);
    if (status != SF_OK) {
        return status;
    }
    status = sf_stack_write(grid, NULL, sf_directory_folder(directory), NULL, NULL);
    if (status != SF_OK) {
        sf_directory_close(directory);
        return status;
    }
    return sf_directory_commit(directory, NULL);
}

// How many layers the stack at a path has; 0 where it is none.
static uint32_t layers_of(const char *path)
{
    sf_directory *directory = NULL;
    sf_grid *grid = NULL;
    uint32_t layers = 0;
    if (sf_directory_read(path, NULL, &directory, NULL) == SF_OK &&
        sf_stack_read(sf_directory_folder(directory), NULL, NULL, &grid, NULL, NULL) == SF_OK) {
        sf_lattice l = sf_grid_lattice(grid);
        layers = sf_grid_popcount(grid) == (uint64_t)l.nx * l.ny * l.nz ? l.nz : 0;
    }
    sf_grid_destroy(grid);
    sf_directory_close(directory);
    return layers;
}

static void every_call_of_a_stack_may_fail(void)
{
    sf_grid *old = solid(2), *new = solid(3);
    folder_begin("broken_stack");
    const char *path = folder_path("stack");
    CHECK_EQ(save_stack(path, old), SF_OK);
    if (layers_of(path) == 0) {
        folder_end();
        sf_grid_destroy(old);
        sf_grid_destroy(new);
        SKIP("this build reads no stacks");
    }
    long failed = 0;
    for (long k = 0;; k++) {
        path = folder_path("stack");
        calls = 0;
        broken_call = k;
        sf_status status = save_stack(path, new);
        broken_call = -1;
        if (status == SF_OK && calls <= k) {
            CHECK_EQ(layers_of(path), 3);
            break;
        }
        uint32_t layers = layers_of(path);
        CHECK(status == SF_OK ? layers == 3 : layers == 2 || layers == 3);
        CHECK(status == SF_OK || status == SF_ERR_IO);
        failed += status != SF_OK;
        CHECK_EQ(save_stack(path, old), SF_OK);
    }
    printf("# %ld calls failed in turn\n", failed);
    CHECK(failed >= 10);
    folder_end();
    sf_grid_destroy(old);
    sf_grid_destroy(new);
}

static void save_without_end(const char *path)
{
    for (char letter = 'a';; letter = letter == 'z' ? 'a' : (char)(letter + 1)) {
        if (save_letters(path, letter, NULL) != SF_OK) {
            _exit(1);
        }
    }
}

static void a_killed_save_leaves_a_whole_file(void)
{
    folder_begin("killed_save");
    CHECK_EQ(save_letters(folder_path("file"), 'A', NULL), SF_OK);
    long changed = 0;
    for (int i = 0; i < KILLS; i++) {
        char before = letter_of(folder_path("file"));
        pid_t child = fork();
        if (child == 0) {
            save_without_end(folder_path("file"));
        }
        CHECK(child > 0);
        struct timespec wait = {0, (long)test_random_below(6000000)};
        nanosleep(&wait, NULL);
        int how = 0;
        CHECK(kill(child, SIGKILL) == 0 && waitpid(child, &how, 0) == child);
        CHECK(WIFSIGNALED(how)); // and did not end by itself
        char after = letter_of(folder_path("file"));
        CHECK(after != 0);
        changed += after != before;
        if (i % 64 == 63) { // what killed ones left beside it
            folder_end();
            folder_begin("killed_save");
            CHECK_EQ(save_letters(folder_path("file"), 'A', NULL), SF_OK);
        }
    }
    printf("# of %d, %ld were killed after a file was published\n", KILLS, changed);
    folder_end();
}

int main(void)
{
    TEST(every_call_of_a_save_may_fail);
    TEST(every_call_of_a_stack_may_fail);
    TEST(a_killed_save_leaves_a_whole_file);
    return test_finish();
}

#else

#include <stdio.h>

int main(void)
{
    printf("1..0 # SKIP the C library's calls are stood in for on Linux only\n");
    return 0;
}

#endif
