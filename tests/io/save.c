// SPDX-License-Identifier: MIT
// Whoever looks at a path while a file is saved there sees the old file or the new one, whole, and
// nothing else is left in the folder, whatever fails. Guards: issue 2 part 6 (atomic save), the
// strong guarantee.

#ifndef _WIN32
#define _XOPEN_SOURCE 700
#include <signal.h>
#include <sys/resource.h>
#endif

#include <sf/io.h>

#include "failing_allocator.h"
#include "folder.h"

#define PATH folder_path("part.bin")

static int holds(const char *path, const char *text)
{
    char found[256] = {0};
    long size = folder_read(path, found, sizeof found - 1);
    return text == NULL ? size < 0 : size == (long)strlen(text) && strcmp(found, text) == 0;
}

static sf_save *begin_with(const char *text)
{
    sf_save *save = NULL;
    sf_fault fault;
    CHECK_EQ(sf_save_begin(PATH, NULL, &save, &fault), SF_OK);
    sf_sink sink = sf_save_sink(save);
    CHECK_EQ(sink.write(sink.user, text, strlen(text)), SF_OK);
    return save;
}

static void shows_nothing_before_commit(void)
{
    folder_begin("save");
    sf_save *save = begin_with("first");
    CHECK(holds(PATH, NULL));
    sf_save_abort(save);
    CHECK(holds(PATH, NULL));
    CHECK_EQ(folder_count(test_folder), 0);

    save = begin_with("first");
    CHECK_EQ(sf_save_commit(save, NULL), SF_OK);
    CHECK(holds(PATH, "first"));
    CHECK_EQ(folder_count(test_folder), 1);

    save = begin_with("second");
    CHECK(holds(PATH, "first"));
    sf_save *other = begin_with("third"); // two at once do not meet
    CHECK_EQ(sf_save_commit(save, NULL), SF_OK);
    CHECK(holds(PATH, "second"));
    sf_save_abort(other);
    CHECK(holds(PATH, "second"));
    CHECK_EQ(folder_count(test_folder), 1);
    folder_end();
}

static void refuses_what_is_no_file(void)
{
    folder_begin("save");
    sf_save *save = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    CHECK_EQ(sf_save_begin(test_folder, NULL, &save, &fault), SF_ERR_IO);
    CHECK(save == NULL && strstr(fault.message, "folder") != NULL);
    CHECK_EQ(sf_save_begin(folder_path("none/part"), NULL, &save, &fault), SF_ERR_IO);
    CHECK(save == NULL && strstr(fault.message, "no such") != NULL);
    CHECK_EQ(sf_save_begin("", NULL, &save, &fault), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_save_begin(NULL, NULL, &save, &fault), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_save_begin("x", NULL, NULL, &fault), SF_ERR_ARGUMENT);
#ifndef _WIN32
    CHECK_EQ(sf_save_begin("/dev/null", NULL, &save, &fault), SF_ERR_IO);
    CHECK(save == NULL && strstr(fault.message, "no ordinary file") != NULL);
#endif
    // A folder that appears at the path before the commit: nothing is lost, nothing is left.
    save = begin_with("first");
    sfi_disk_make_folder(PATH);
    CHECK_EQ(sf_save_commit(save, &fault), SF_ERR_IO);
    CHECK_EQ(folder_count(test_folder), 1);
    CHECK_EQ(sf_save_commit(NULL, &fault), SF_ERR_ARGUMENT);
    sf_save_abort(NULL);
    folder_end();
}

#ifdef __linux__
static void a_long_name_is_told_by_its_end(void)
{
    char path[600];
    memset(path, 'x', sizeof path - 1);
    path[sizeof path - 1] = '\0';
    sf_save *save = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    CHECK_EQ(sf_save_begin(path, NULL, &save, &fault), SF_ERR_IO);
    CHECK(strstr(fault.message, "too long") != NULL && strstr(fault.message, "...") != NULL);
}
#endif

#ifndef _WIN32
// No file may grow beyond some kilobytes, which is how a full disk looks from inside.
static void a_full_disk_leaves_the_old_file(void)
{
    static char block[1000];
    struct rlimit usual, small;
    folder_begin("save");
    folder_write(PATH, "old");
    signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &usual);
    for (int blocks = 5; blocks <= 300; blocks += 59) {
        sf_save *save = NULL;
        sf_fault fault = {SF_OK, 0, 0, ""};
        sf_status status = SF_OK;
        small = usual;
        small.rlim_cur = 4500;
        setrlimit(RLIMIT_FSIZE, &small);
        CHECK_EQ(sf_save_begin(PATH, NULL, &save, &fault), SF_OK);
        sf_sink sink = sf_save_sink(save);
        for (int i = 0; i < blocks && status == SF_OK; i++) {
            status = sink.write(sink.user, block, sizeof block);
        }
        CHECK(blocks < 50 || status == SF_ERR_IO);
        CHECK_EQ(sf_save_commit(save, &fault), SF_ERR_IO); // even where every write was taken
        setrlimit(RLIMIT_FSIZE, &usual);
        CHECK(strstr(fault.message, "part.bin") != NULL);
        CHECK(holds(PATH, "old"));
        CHECK_EQ(folder_count(test_folder), 1);
    }
    folder_end();
}
#endif

static void reads_files(void)
{
    folder_begin("save");
    sf_file *file = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    char text[16] = {0};
    size_t size = 0;
    folder_write(PATH, "hello");
    CHECK_EQ(sf_file_open(PATH, NULL, &file, &fault), SF_OK);
    sf_source source = sf_file_source(file);
    CHECK_EQ(source.read(source.user, text, sizeof text, &size), SF_OK);
    CHECK_EQ(size, 5);
    CHECK_STR(text, "hello");
    CHECK_EQ(source.read(source.user, text, sizeof text, &size), SF_OK);
    CHECK_EQ(size, 0);
    sf_file_close(file);
    file = NULL;
    CHECK_EQ(sf_file_open(folder_path("none"), NULL, &file, &fault), SF_ERR_IO);
    CHECK(file == NULL && strstr(fault.message, "no such file") != NULL);
    CHECK_EQ(sf_file_open(test_folder, NULL, &file, &fault), SF_ERR_IO);
    CHECK(file == NULL && strstr(fault.message, "folder") != NULL);
    CHECK_EQ(sf_file_open(NULL, NULL, &file, &fault), SF_ERR_ARGUMENT);
    sf_file_close(NULL);
    CHECK(sf_file_source(NULL).read == NULL && sf_save_sink(NULL).write == NULL);
    folder_end();
}

static void survives_refused_allocations(void)
{
    folder_begin("save");
    folder_write(PATH, "old");
    sf_status status = SF_ERR_MEMORY;
    for (long k = 0; status != SF_OK && k < 50; k++) {
        failing_allocator memory;
        failing_begin(&memory, k);
        sf_save *save = NULL;
        sf_fault fault = {SF_OK, 0, 0, ""};
        status = sf_save_begin(PATH, &memory.allocator, &save, &fault);
        CHECK(status == SF_OK || (status == SF_ERR_MEMORY && fault.status == SF_ERR_MEMORY));
        if (status == SF_OK) {
            CHECK_EQ(sf_save_commit(save, &fault), SF_OK); // without memory to sync the folder
        } else {
            CHECK(holds(PATH, "old"));
        }
        CHECK_EQ(folder_count(test_folder), 1);
        CHECK(memory.live == 0 && memory.faults == 0);
    }
    CHECK_EQ(status, SF_OK);
    CHECK(holds(PATH, ""));
    for (long k = 0; k < 2; k++) {
        failing_allocator memory;
        failing_begin(&memory, k);
        sf_file *file = NULL;
        sf_status opened = sf_file_open(PATH, &memory.allocator, &file, NULL);
        CHECK_EQ(opened, k == 0 ? SF_ERR_MEMORY : SF_OK);
        sf_file_close(file);
        CHECK(memory.live == 0 && memory.faults == 0);
    }
    folder_end();
}

int main(void)
{
    TEST(shows_nothing_before_commit);
    TEST(refuses_what_is_no_file);
#ifdef __linux__
    TEST(a_long_name_is_told_by_its_end);
#endif
#ifndef _WIN32
    TEST(a_full_disk_leaves_the_old_file);
#endif
    TEST(reads_files);
    TEST(survives_refused_allocations);
    return test_finish();
}
