// SPDX-License-Identifier: MIT
// A progress bar on a terminal, and Ctrl-C.
//
// A bar shows itself only for work that lasts longer than half a second, is drawn at most ten times
// a second, and is wiped when its phase ends, so that what remains on the terminal is the report.
// The state is one static object, because a signal handler can be handed nothing.

#include "progress.h"

#include "pool.h"

#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>
#ifndef _WIN32
#include <sys/ioctl.h>
#endif

enum { BAR_WIDTH = 30, FIGURES_WIDTH = 26 }; // " [", "] 100 %, 99999999 s left", the cursor

static struct {
    sf_task *task;
    pool *pool;
    int visible; // whether standard error is a terminal that may be drawn on
    int drawn;   // whether a bar stands there
    int columns; // of the terminal
    const char *phase;
    double begun, last; // seconds
} state;

static double seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static void wipe(void)
{
    if (state.drawn) {
        fputs("\r\033[K", stderr);
        fflush(stderr);
        state.drawn = 0;
    }
}

static int columns_of_terminal(void)
{
#ifdef TIOCGWINSZ
    struct winsize size;
    if (ioctl(2, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) {
        return size.ws_col;
    }
#endif
    return 80;
}

// A line that wraps could not be wiped, so a bar that has no room for itself is shorter.
static int bar_width(void)
{
    int room = state.columns - (int)strlen(state.phase) - FIGURES_WIDTH;
    return room < 0 ? 0 : room < BAR_WIDTH ? room : BAR_WIDTH;
}

static void draw(void *user, double fraction)
{
    double now = seconds(), elapsed = now - state.begun;
    (void)user;
    if (!state.visible || elapsed < 0.5 || now - state.last < 0.1) {
        return;
    }
    char bar[BAR_WIDTH + 1];
    int width = bar_width(), full = (int)(fraction * width);
    for (int i = 0; i < width; i++) {
        bar[i] = i < full ? '#' : '.';
    }
    bar[width] = '\0';
    fprintf(stderr, width > 0 ? "\r\033[K%s [%s] %3d %%" : "\r\033[K%s%s %3d %%", state.phase, bar,
            (int)(100 * fraction));
    double left = fraction > 0.02 && elapsed > 2 ? elapsed * (1 - fraction) / fraction : 0;
    if (left > 0.5) {
        fprintf(stderr, ", %.0f s left", left);
    }
    fflush(stderr);
    state.last = now;
    state.drawn = 1;
}

static void side_by_side(void *user, size_t count, sf_task_body body, void *context)
{
    (void)user;
    pool_for(state.pool, count, body, context);
}

static void interrupted(int number)
{
    signal(number, SIG_DFL); // the second one ends the program
    sf_task_cancel(state.task);
}

void progress_attach(sf_task *task, int quiet, int threads)
{
    memset(&state, 0, sizeof state);
    state.task = task;
    state.visible = !quiet && isatty(2);
    state.phase = "";
    task->progress = draw;
    state.pool = pool_create(threads);
    if (state.pool != NULL) {
        task->parallel_for = side_by_side;
    }
    signal(SIGINT, interrupted);
}

void progress_phase(const char *name)
{
    wipe();
    state.phase = name;
    state.begun = seconds();
    state.columns = state.visible ? columns_of_terminal() : 80;
    state.last = 0;
}

void progress_line(const char *format, ...)
{
    va_list arguments;
    if (!state.visible) {
        return;
    }
    wipe();
    va_start(arguments, format);
    vfprintf(stderr, format, arguments);
    va_end(arguments);
    fputc('\n', stderr);
    fflush(stderr);
}

void progress_end(void)
{
    wipe();
    pool_destroy(state.pool);
    state.pool = NULL;
}
