// SPDX-License-Identifier: MIT
// A folder of results that appears whole, beside whatever else it holds.
//
// A run takes its time between the mesh and the last picture, and may be cancelled or meet a full
// disk anywhere. So everything is made in a folder aside. Where there was no folder, that one gets
// the name. Where there is one, its other files are none of ours: each result is renamed over its
// predecessor, one after the other, the report last; a rename needs no room and nothing cancels it.

#include "results.h"

#include <sf/io.h>

#include <dirent.h>
#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

// What a run makes, in the order in which it is published. The folder is a stack.
static const char *const names[] = {"layers",     "printable.stl", "trimmed.stl", "grown.stl",
                                    "before.png", "after.png",     "report.json"};
enum { NAME_COUNT = sizeof names / sizeof names[0], LAYERS = 0 };

static int make_folder(const char *path)
{
#ifdef _WIN32
    return mkdir(path);
#else
    return mkdir(path, 0777);
#endif
}

static int is_folder(const char *path)
{
    struct stat entry;
    return stat(path, &entry) == 0 && S_ISDIR(entry.st_mode);
}

static int exists(const char *path)
{
    struct stat entry;
    return stat(path, &entry) == 0;
}

static exit_status join(cli_job *job, const char *folder, const char *name,
                        char path[RESULTS_PATH_SIZE])
{
    int length = snprintf(path, RESULTS_PATH_SIZE, "%s/%s", folder, name);
    return length < RESULTS_PATH_SIZE ? EXIT_GOOD
                                      : job_fail(job, EXIT_USAGE, "-o: The path is too long.");
}

// Without the slashes at its end.
static int copy_folder(const char *folder, char path[RESULTS_PATH_SIZE])
{
    size_t length = strlen(folder);
    while (length > 1 && folder[length - 1] == '/') {
        length--;
    }
    if (length + 64 > RESULTS_PATH_SIZE) {
        return 0;
    }
    memcpy(path, folder, length);
    path[length] = '\0';
    return 1;
}

// Whether the layers of an earlier run may be replaced: asked of whoever will write them.
static exit_status check_layers(cli_job *job, const results *r)
{
    char path[RESULTS_PATH_SIZE];
    sf_directory *directory = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    exit_status status = join(job, r->folder, names[LAYERS], path);
    if (status != EXIT_GOOD || !exists(path)) {
        return status;
    }
    sf_status begun = sf_directory_write(path, NULL, &directory, &fault);
    if (begun != SF_OK) {
        return job_fail_call(job, begun, &fault, path, EXIT_RESOURCE);
    }
    sf_directory_close(directory);
    return EXIT_GOOD;
}

exit_status results_begin(cli_job *job, const char *folder, results *r)
{
    memset(r, 0, sizeof *r);
    if (!copy_folder(folder, r->folder)) {
        return job_fail(job, EXIT_USAGE, "-o: The path is too long.");
    }
    r->is_new = !exists(r->folder);
    exit_status status = r->is_new ? EXIT_GOOD : check_layers(job, r);
    if (status != EXIT_GOOD) {
        return status;
    }
    int error = EEXIST;
    for (int i = 0; i < 100 && error == EEXIST; i++) {
        int length = snprintf(r->aside, sizeof r->aside, "%s%s.sf-%ld-%d.tmp", r->folder,
                              r->is_new ? "" : "/", (long)getpid(), i);
        error = length >= RESULTS_PATH_SIZE ? ENAMETOOLONG : make_folder(r->aside) ? errno : 0;
    }
    if (error != 0) {
        r->aside[0] = '\0';
        return job_fail(job, EXIT_RESOURCE, "%s: The folder could not be made: %s.", folder,
                        strerror(error));
    }
    return EXIT_GOOD;
}

exit_status results_path(cli_job *job, const results *r, const char *name,
                         char path[RESULTS_PATH_SIZE])
{
    return join(job, r->aside, name, path);
}

void results_name_target(cli_job *job, const results *r)
{
    char told[sizeof job->message];
    size_t aside = strlen(r->aside), used = 0;
    for (const char *at = job->message; *at != '\0' && used + 1 < sizeof told;) {
        int is_aside = aside > 0 && strncmp(at, r->aside, aside) == 0;
        size_t length = is_aside ? strlen(r->folder) : 1, room = sizeof told - 1 - used;
        length = length < room ? length : room;
        memcpy(told + used, is_aside ? r->folder : at, length);
        used += length;
        at += is_aside ? aside : 1;
    }
    told[used] = '\0';
    memcpy(job->message, told, used + 1);
}

static int move_file(const char *from, const char *to)
{
#ifdef _WIN32
    remove(to); // rename() of Windows replaces nothing
#endif
    return rename(from, to);
}

// A folder cannot be renamed over another that is not empty: that one goes aside first, and comes
// back when the new one cannot take its place.
static int move_layers(const results *r, const char *from, const char *to)
{
    char old[RESULTS_PATH_SIZE];
    int there = exists(to), length = snprintf(old, sizeof old, "%s/old", r->aside);
    if (length >= RESULTS_PATH_SIZE || (there && rename(to, old) != 0)) {
        return -1;
    }
    if (rename(from, to) == 0) {
        return 0;
    }
    int error = errno;
    if (there) {
        (void)!rename(old, to);
    }
    errno = error;
    return -1;
}

exit_status results_publish(cli_job *job, results *r)
{
    char from[RESULTS_PATH_SIZE], to[RESULTS_PATH_SIZE], done[128] = "nothing";
    if (r->is_new && rename(r->aside, r->folder) == 0) {
        r->aside[0] = '\0';
        return EXIT_GOOD;
    }
    for (int i = 0; i < NAME_COUNT && is_folder(r->folder); i++) {
        exit_status status = join(job, r->aside, names[i], from);
        status = status == EXIT_GOOD ? join(job, r->folder, names[i], to) : status;
        if (status != EXIT_GOOD) {
            return status;
        }
        if (!exists(from)) {
            remove(to); // of an earlier run: it would not belong to this report
            continue;
        }
        if ((i == LAYERS ? move_layers(r, from, to) : move_file(from, to)) != 0) {
            return job_fail(job, EXIT_RESOURCE, "%s: %s. Of this run, %s was written.", to,
                            strerror(errno), done);
        }
        size_t used = strcmp(done, "nothing") == 0 ? 0 : strlen(done);
        snprintf(done + used, sizeof done - used, "%s%s", used > 0 ? " and " : "", names[i]);
    }
    if (!is_folder(r->folder)) {
        return job_fail(job, EXIT_RESOURCE, "%s: The folder could not be made: %s.", r->folder,
                        exists(r->folder) ? "something else stands there" : strerror(errno));
    }
    results_drop(r);
    return EXIT_GOOD;
}

// Remove a folder's files and, in it, one level of folders: what a run makes is no deeper.
static void remove_tree(const char *folder, int depth)
{
    char path[RESULTS_PATH_SIZE];
    DIR *entries = opendir(folder);
    for (struct dirent *e; entries != NULL && (e = readdir(entries)) != NULL;) {
        int length = snprintf(path, sizeof path, "%s/%s", folder, e->d_name);
        if (strcmp(e->d_name, ".") == 0 || strcmp(e->d_name, "..") == 0 ||
            length >= RESULTS_PATH_SIZE) {
            continue;
        }
        if (remove(path) != 0 && depth < 2) {
            remove_tree(path, depth + 1);
        }
    }
    if (entries != NULL) {
        closedir(entries);
    }
    rmdir(folder);
}

void results_drop(results *r)
{
    if (r->aside[0] != '\0') {
        remove_tree(r->aside, 0);
        r->aside[0] = '\0';
    }
}
