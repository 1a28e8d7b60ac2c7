// SPDX-License-Identifier: MIT
// sf stand: make a model stand, hang or rock as it is meant to, by carving its inside and bending
// its outside.

#include "stand_files.h"
#include "stand_prints.h"
#include "stand_rest.h"
#include "stand_say.h"
#include "verbs.h"

#include <string.h>

enum { RESOLUTION = 64 };

static exit_status balance(cli_job *job, model *m)
{
    exit_status status = model_run(job, m);
    if (status != EXIT_GOOD) {
        return status;
    }
    stand_report(job, m);
    status = stand_prints(job, m);
    if (status != EXIT_GOOD) {
        return status;
    }
    if (job->options.output != NULL) {
        status = stand_files_save(job, m);
    } else {
        report_number(job->report, "seconds", job_seconds(job));
        report_say(job->report, "Nothing was written; -o PREFIX says where to.");
    }
    return status == EXIT_GOOD && !model_holds(m) ? EXIT_PROPERTY : status;
}

// Options of which one says what the other would.
static exit_status check(cli_job *job)
{
    uint64_t given = job->options.given;
    const char *why = NULL;
    if ((given & OPTION_STANCE) && (given & (OPTION_GAMMA | OPTION_CONTACTS | OPTION_SUSPEND))) {
        why = "--stance FILE says it all: leave out --gamma, --contacts and --suspend.";
    } else if ((given & OPTION_SUSPEND) && (given & (OPTION_GAMMA | OPTION_CONTACTS))) {
        why = "What hangs has no contacts and no --gamma: leave out one or the other.";
    } else if ((given & OPTION_NO_DEFORM) &&
               (given & (OPTION_HANDLES | OPTION_MAX_SHIFT | OPTION_TURN | OPTION_SOLVER |
                         OPTION_MU | OPTION_NO_LAPLACIAN))) {
        why = "--no-deform bends nothing: leave out --handles, --max-shift, --turn, --solver, --mu "
              "and --no-laplacian.";
    } else if ((given & OPTION_NO_CARVE) && (given & (OPTION_CARVE | OPTION_WALL | OPTION_DRAIN))) {
        why = "--no-carve leaves the inside solid: leave out --carve, --wall and --drain.";
    } else if ((given & OPTION_MU) && job->options.stand.solver != SF_STAND_DESCENT) {
        why = "--mu is the paper's: say --solver paper as well.";
    } else if ((given & OPTION_MAX_SHIFT) && job->options.stand.solver == SF_STAND_DESCENT) {
        why = "The paper's solver knows no --max-shift: leave it out, or --solver paper.";
    } else if ((given & OPTION_REST) && (given & OPTION_OUTPUT)) {
        why = "--rest changes nothing, so that there is nothing to write: leave out -o.";
    }
    return why == NULL ? stand_files_check(job) : job_fail(job, EXIT_USAGE, "%s", why);
}

// Everything that reads a part takes `up` for the build direction.
static void choose_axes(cli_job *job, model *m)
{
    cli_options *asked = &job->options;
    m->up = asked->up;
    if (asked->given & OPTION_BUILD) {
        asked->up = asked->stand.build;
    }
    if ((asked->given & (OPTION_RESOLUTION | OPTION_PITCH)) == 0) {
        asked->resolution = RESOLUTION;
    }
}

exit_status verb_stand(cli_job *job)
{
    model m;
    memset(&m, 0, sizeof m);
    exit_status status = check(job);
    if (status != EXIT_GOOD) {
        return status;
    }
    choose_axes(job, &m);
    status = model_read(job, &m);
    if (status == EXIT_GOOD) {
        status = (job->options.given & OPTION_REST) ? stand_rest(job, &m) : balance(job, &m);
    }
    model_release(&m);
    return status;
}
