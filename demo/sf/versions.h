// SPDX-License-Identifier: MIT
// The three ways to make a part printable, side by side.

#ifndef DEMO_SF_VERSIONS_H
#define DEMO_SF_VERSIONS_H

#include "change.h"

enum { VERSION_TRIM, VERSION_GROW, VERSION_REPAIR, VERSION_COUNT };

typedef struct versions {
    change made[VERSION_COUNT];
    int there[VERSION_COUNT];    // whether it could be made, and holds something
    int is_empty[VERSION_COUNT]; // whether it took all of the part away
    int printable;               // the one that is offered
} versions;

// Make them all. Where what the part needs cannot be grown, --memory is too little for growing and
// repairing, or nothing is left by a version, the others stand; EXIT_PROPERTY where none does.
exit_status versions_make(cli_job *job, const part *p, versions *v);

// The file that a version is written to, in the folder of results.
const char *versions_file(const versions *v, int which);

// A name, and figures such as "-12.3 mm3, +4.5 mm3". In `text`, which is returned.
enum { VERSIONS_FIGURES_SIZE = 80 };
const char *versions_name(int which);
const char *versions_figures(const versions *v, int which, char text[VERSIONS_FIGURES_SIZE]);

// A line for each: what it costs, and which file in which folder it is.
void versions_say(report *r, const versions *v, const char *folder);

void versions_release(versions *v);

#endif
