// SPDX-License-Identifier: MIT
// Shells: which material stays away from the surface, and what takes its place.
//
// --shell names the one material that the outside is of, so that all others are kept out;
// --keep-out names the one that is kept out. Names come from the table of materials and may hold
// commas, so that the longest name that fits is taken.

#include "shells.h"

#include <stdio.h>
#include <string.h>

// The material whose name is the first `length` bytes of a text, or the number of materials.
static uint32_t find(const materials *m, const char *text, size_t length)
{
    uint32_t i = 0;
    while (i < m->count &&
           !(strlen(m->table[i].name) == length && memcmp(m->table[i].name, text, length) == 0)) {
        i++;
    }
    return i;
}

static exit_status fail(cli_job *job, const materials *m, const char *option, const char *text)
{
    char names[400] = "";
    for (uint32_t i = 0; i < m->count; i++) {
        size_t used = strlen(names);
        snprintf(names + used, sizeof names - used, "%s'%s'", i > 0 ? ", " : "", m->table[i].name);
    }
    return job_fail(job, EXIT_USAGE, "%s: '%.100s' names no material; there are %s.", option, text,
                    names);
}

static void keep_out(shells *made, uint32_t material, uint32_t instead)
{
    sf_keep_out *to = &made->outs[made->count++];
    memset(to, 0, sizeof *to);
    to->material = material;
    to->instead = instead;
}

static exit_status choose_shell(cli_job *job, const materials *m, shells *made)
{
    const char *name = job->options.shell;
    uint32_t only = name == NULL ? 0 : find(m, name, strlen(name));
    if (only == m->count) {
        return fail(job, m, "--shell", name);
    }
    for (uint32_t i = 0; i < m->count; i++) {
        if (i != only) {
            keep_out(made, i, only);
        }
    }
    return EXIT_GOOD;
}

// NAME, or NAME,INSTEAD.
static exit_status choose_keep_out(cli_job *job, const materials *m, shells *made)
{
    const char *text = job->options.shell;
    uint32_t which = find(m, text, strlen(text));
    if (which < m->count) {
        keep_out(made, which, which == 0 ? 1 : 0);
        return EXIT_GOOD;
    }
    for (const char *comma = strchr(text, ','); comma != NULL; comma = strchr(comma + 1, ',')) {
        uint32_t instead = find(m, comma + 1, strlen(comma + 1));
        which = find(m, text, (size_t)(comma - text));
        if (which < m->count && instead < m->count && which != instead) {
            keep_out(made, which, instead);
            return EXIT_GOOD;
        }
    }
    return fail(job, m, "--keep-out", text);
}

exit_status shells_choose(cli_job *job, const materials *m, shells *made)
{
    memset(made, 0, sizeof *made);
    made->distance_mm = job->options.shell_mm;
    return job->options.given & OPTION_SHELL      ? choose_shell(job, m, made)
           : job->options.given & OPTION_KEEP_OUT ? choose_keep_out(job, m, made)
                                                  : EXIT_GOOD;
}
