// SPDX-License-Identifier: MIT
// What the command line of sculpt asks for.

#include "options.h"

#include <getopt.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <sf/base.h>

#include "work.h"

#define DEGREE (3.14159265358979323846 / 180)

static const char help[] =
    "sculpt: model shapes that print without supports\n"
    "\n"
    "usage: sculpt [options] [MESH]\n"
    "\n"
    "Opens a window on an empty bed, a mesh (STL, OBJ, PLY, OFF) or a scene. The shape prints\n"
    "without supports after every stroke.\n"
    "\n"
    "  --workspace NAME   begin in a workspace: sculpt, balance (a mesh) or grade (a cage)\n"
    "  --scene NAME       begin with a scene: garden, shaun, pumpkin, intertwined\n"
    "  --session FILE     begin with what a session gives (or --replay FILE)\n"
    "  --input FILE       do what was recorded: pointer, keys and settings\n"
    "  --record FILE      record that, from the window\n"
    "  --save FILE        write the session at the end; at another workspace, what it made\n"
    "  --resolution N     voxels along the longest side of the space, 64 to 512 (default 256)\n"
    "  --size WxH         of the window or the picture, in pixels (default 1280x800)\n"
    "  --view AZ,EL       degrees around and above (default -60,25)\n"
    "  --cut MM           show only what lies below that height\n"
    "  --gpu              brushes on the graphics card as well, and drawn where they lie; with\n"
    "                     --hash, the number is of what the card holds\n"
    "  --ghosts           keep what is trimmed as a ghost, which comes back where support appears\n"
    "  --overhangs        show what leans on its neighbours\n"
    "  --headless         no window; with --shot, --hash or --bench\n"
    "  --shot FILE.png    write a picture; of the window, panel and all, which then closes\n"
    "  --hash             print a number that is the same for the same model\n"
    "  --bench            print what a frame takes\n"
    "  --help, --version\n"
    "\n"
    "examples:\n"
    "  sculpt part.stl\n"
    "  sculpt --workspace balance part.stl\n"
    "  sculpt --headless --scene shaun --shot shaun.png --hash\n"
    "  sculpt --headless --scene shaun --bench --size 1920x1080\n";

static int read_pair(const char *text, char between, double *a, double *b)
{
    char *end;
    *a = strtod(text, &end);
    if (end == text || *end != between) {
        return 0;
    }
    text = end + 1;
    *b = strtod(text, &end);
    return end != text && *end == '\0' && isfinite(*a) && isfinite(*b);
}

static int read_number(const char *text, double least, double most, double *number)
{
    char *end;
    *number = strtod(text, &end);
    return end != text && *end == '\0' && *number >= least && *number <= most;
}

static int find_work(const char *name, int *work)
{
    for (int i = 0; i < WORK_COUNT; i++) {
        if (work_name((workspace)i) != NULL && strcmp(work_name((workspace)i), name) == 0) {
            *work = i;
            return 1;
        }
    }
    return 0;
}

// One option's argument; 0 where it makes no sense.
static int take(app_options *o, int option, const char *text)
{
    double a = 0, b = 0;
    switch (option) {
    case 'W':
        return find_work(text, &o->work);
    case 's':
        o->scene = text;
        return 1;
    case 'o':
        o->shot = text;
        return 1;
    case 'i':
        o->input = text;
        return 1;
    case 'R':
        o->record = text;
        return 1;
    case 'S':
        o->session = text;
        return 1;
    case 'w':
        o->save = text;
        return 1;
    case 'r':
        if (!read_number(text, 64, 512, &a)) {
            return 0;
        }
        o->resolution = (uint32_t)a;
        return 1;
    case 'z':
        if (!read_pair(text, 'x', &a, &b) || a < 1 || b < 1 || a > 8192 || b > 8192) {
            return 0;
        }
        o->width = (uint32_t)a;
        o->height = (uint32_t)b;
        return 1;
    case 'v':
        if (!read_pair(text, ',', &a, &b)) {
            return 0;
        }
        o->azimuth = a * DEGREE;
        o->elevation = b * DEGREE;
        return 1;
    default:
        o->is_cut = 1;
        return read_number(text, 0, 1e6, &o->cut_mm);
    }
}

static app_asked check(const app_options *o)
{
    const char *why = NULL;
    if ((o->file != NULL) + (o->scene != NULL) + (o->session != NULL) > 1) {
        why = "give a mesh, a --scene or a --session, one of them";
    } else if (o->work == WORK_GRADE && (o->scene != NULL || o->session != NULL)) {
        why = "the workspace grade begins with a cage, which no --scene and no --session is";
    } else if (!o->headless && (o->hash || o->bench)) {
        why = "--hash and --bench go with --headless";
    } else if (o->headless && o->shot == NULL && !o->hash && !o->bench && o->save == NULL) {
        why = "--headless does nothing alone: add --shot FILE.png, --hash, --save or --bench";
    } else if (o->headless && o->record != NULL) {
        why = "--record is for the window";
    }
    if (why != NULL) {
        fprintf(stderr, "sculpt: %s.\n", why);
    }
    return why != NULL ? APP_WRONG : APP_GO;
}

static const struct option table[] = {{"workspace", required_argument, NULL, 'W'},
                                      {"scene", required_argument, NULL, 's'},
                                      {"resolution", required_argument, NULL, 'r'},
                                      {"size", required_argument, NULL, 'z'},
                                      {"view", required_argument, NULL, 'v'},
                                      {"cut", required_argument, NULL, 'c'},
                                      {"overhangs", no_argument, NULL, 'g'},
                                      {"ghosts", no_argument, NULL, 'k'},
                                      {"gpu", no_argument, NULL, 'p'},
                                      {"replay", required_argument, NULL, 'S'},
                                      {"headless", no_argument, NULL, 'H'},
                                      {"shot", required_argument, NULL, 'o'},
                                      {"hash", no_argument, NULL, 'x'},
                                      {"bench", no_argument, NULL, 'b'},
                                      {"input", required_argument, NULL, 'i'},
                                      {"record", required_argument, NULL, 'R'},
                                      {"session", required_argument, NULL, 'S'},
                                      {"save", required_argument, NULL, 'w'},
                                      {"help", no_argument, NULL, 'h'},
                                      {"version", no_argument, NULL, 'V'},
                                      {NULL, 0, NULL, 0}};

app_asked app_options_read(int argc, char **argv, app_options *options)
{
    app_options o = {.resolution = 256,
                     .width = 1280,
                     .height = 800,
                     .azimuth = -60 * DEGREE,
                     .elevation = 25 * DEGREE};
    for (int c; (c = getopt_long(argc, argv, "h", table, NULL)) != -1;) {
        switch (c) {
        case 'h':
            fputs(help, stdout);
            return APP_DONE;
        case 'V':
            printf("sculpt %s\n", sf_version());
            return APP_DONE;
        case 'g':
            o.overhangs = 1;
            break;
        case 'H':
            o.headless = 1;
            break;
        case 'k':
            o.keep_drawn = 1;
            break;
        case 'p':
            o.gpu = 1;
            break;
        case 'x':
            o.hash = 1;
            break;
        case 'b':
            o.bench = 1;
            break;
        case '?':
            fputs("sculpt: 'sculpt --help' says what there is.\n", stderr);
            return APP_WRONG;
        default:
            if (!take(&o, c, optarg)) {
                fprintf(stderr, "sculpt: '%s' is no value for that option; see sculpt --help.\n",
                        optarg);
                return APP_WRONG;
            }
        }
    }
    if (optind + 1 < argc) {
        fputs("sculpt: one mesh at a time.\n", stderr);
        return APP_WRONG;
    }
    o.file = optind < argc ? argv[optind] : NULL;
    *options = o;
    return check(&o);
}
