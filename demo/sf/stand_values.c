// SPDX-License-Identifier: MIT
// What the command line asks of `sf stand`. As elsewhere, what is no number, or none that anybody
// could want, is refused here.

#include "stand_values.h"

#include "options.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double degree = 3.14159265358979323846 / 180;

// One number up to `end`, which is left where it ends.
static int read_number(const char *text, const char **end, double *number)
{
    char *after;
    errno = 0;
    *number = strtod(text, &after);
    *end = after;
    return after != text && errno == 0 && isfinite(*number);
}

static int parse_between(const char *text, double least, double most, double *number)
{
    const char *end;
    return read_number(text, &end, number) && *end == '\0' && *number >= least && *number <= most;
}

static int parse_point(const char *text, double point[3])
{
    for (int i = 0; i < 3; i++) {
        if (!read_number(text, &text, &point[i]) || *text != (i < 2 ? ',' : '\0')) {
            return 0;
        }
        text++;
    }
    return 1;
}

// "x>0,y<2.5": sides of planes, all of which must hold.
static int parse_contacts(const char *text, stand_values *made)
{
    for (;; text++) {
        const char *name = text[0] != '\0' ? strchr("xyz", text[0]) : NULL;
        double number;
        if (name == NULL || (text[1] != '<' && text[1] != '>')) {
            return 0;
        }
        int along = text[0] - 'x', above = text[1] == '>';
        if (!read_number(text + 2, &text, &number) || (*text != '\0' && *text != ',')) {
            return 0;
        }
        if (above) {
            made->low[along] = fmax(made->low[along], number);
        } else {
            made->high[along] = fmin(made->high[along], number);
        }
        if (*text == '\0') {
            return made->low[along] <= made->high[along];
        }
    }
}

static int parse_handles(const char *text, stand_values *made)
{
    double number;
    if (strncmp(text, "auto:", 5) != 0) {
        made->handles = text;
        return text[0] != '\0';
    }
    int good = parse_between(text + 5, 0, SF_HANDLE_MAX - 1, &number) && number == floor(number);
    made->handle_count = good ? (uint32_t)number : 0;
    return good;
}

static int parse_way(const char *text, const char *first, const char *second, int *is_second)
{
    *is_second = strcmp(text, second) == 0;
    return *is_second || strcmp(text, first) == 0;
}

int stand_values_parse(uint64_t bit, const char *text, stand_values *made)
{
    int good, second;
    switch (bit) {
    case OPTION_GAMMA:
        good = parse_between(text, 0, 80, &made->gamma_rad);
        made->gamma_rad *= degree;
        return good;
    case OPTION_MU:
        return parse_between(text, 0, 1, &made->mu);
    case OPTION_MAX_SHIFT:
        return parse_between(text, 0, 1e6, &made->shift_max_mm) && made->shift_max_mm > 0;
    case OPTION_CONTACTS:
        return parse_contacts(text, made);
    case OPTION_SUSPEND:
        return parse_point(text, made->point);
    case OPTION_HANDLES:
        return parse_handles(text, made);
    case OPTION_STANCE:
        made->stances = text;
        return text[0] != '\0';
    case OPTION_CARVE:
        good = parse_way(text, "support-free", "paper", &second);
        made->carve = second ? SF_CARVE_PLANE : SF_CARVE_SUPPORT_FREE;
        return good;
    case OPTION_SOLVER:
        good = parse_way(text, "sqp", "paper", &second);
        made->solver = second ? SF_STAND_DESCENT : SF_STAND_PROGRAMS;
        return good;
    default:
        return 0;
    }
}

stand_values stand_values_default(void)
{
    stand_values made;
    memset(&made, 0, sizeof made);
    made.build = AXIS_Z;
    made.gamma_rad = 4 * degree;
    made.handle_count = 8;
    made.carve = SF_CARVE_SUPPORT_FREE;
    made.solver = SF_STAND_PROGRAMS;
    made.mu = 0.5;
    for (int i = 0; i < 3; i++) {
        made.low[i] = -INFINITY;
        made.high[i] = INFINITY;
    }
    return made;
}
