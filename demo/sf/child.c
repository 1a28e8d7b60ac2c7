// SPDX-License-Identifier: MIT
// Work that is first tried by a child of this process, which may die of it.
//
// Some formats are read by libraries that do not promise to survive a file that is damaged or means
// harm. So a child reads the bytes first, with limits of time and memory; only if it is well
// afterwards does the parent read the same bytes. Sanitizers reserve more memory than any limit
// leaves.

#include "child.h"

#include <sf/io.h>

#include <stdio.h>
#include <stdlib.h>

#if defined(__unix__) || defined(__APPLE__)
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#define HAVE_CHILDREN 1
#endif

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) ||                         \
    __has_feature(memory_sanitizer)
#define NO_MEMORY_LIMIT 1
#endif
#elif defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define NO_MEMORY_LIMIT 1
#endif

static const size_t MOST_BYTES = (size_t)1 << 31;

#ifdef HAVE_CHILDREN
static void limit(void)
{
    struct rlimit seconds = {60, 60};
    setrlimit(RLIMIT_CPU, &seconds);
#ifndef NO_MEMORY_LIMIT
    if (sizeof(rlim_t) > 4) {
        struct rlimit memory;
        memory.rlim_cur = memory.rlim_max = (rlim_t)8 << 30;
        setrlimit(RLIMIT_AS, &memory);
    }
#endif
}
#endif

int child_survives(int (*work)(void *context), void *context)
{
#ifdef HAVE_CHILDREN
    int status = 0;
    fflush(NULL);
    pid_t child = fork();
    if (child == 0) {
        limit();
        (void)!freopen("/dev/null", "w", stderr);
        _exit(work(context) != 0);
    }
    return child < 0 ||
           (waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0);
#else
    (void)work;
    (void)context;
    return 1;
#endif
}

exit_status child_read_bytes(cli_job *job, const char *path, unsigned char **bytes, size_t *size)
{
    sf_file *file = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_status status = sf_file_open(path, NULL, &file, &fault);
    if (status != SF_OK) {
        return job_fail_call(job, status, &fault, path, EXIT_INPUT);
    }
    sf_source source = sf_file_source(file);
    size_t room = 0, got = 1;
    while (status == SF_OK && got > 0 && *size <= MOST_BYTES) {
        if (room - *size < 65536) {
            room = room < 65536 ? 1 << 20 : 2 * room;
            unsigned char *larger = realloc(*bytes, room);
            status = larger == NULL ? SF_ERR_MEMORY : SF_OK;
            *bytes = larger == NULL ? *bytes : larger;
        }
        if (status == SF_OK) {
            status = source.read(source.user, *bytes + *size, 65536, &got);
            *size += got;
        }
    }
    sf_file_close(file);
    if (*size > MOST_BYTES) {
        return job_fail(job, EXIT_INPUT, "%s is larger than 2 GiB.", path);
    }
    return status == SF_OK ? EXIT_GOOD : job_fail_call(job, status, NULL, path, EXIT_INPUT);
}
