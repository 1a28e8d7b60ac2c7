// SPDX-License-Identifier: MIT
// Formulas, by muParser.

#include "expression.h"

#include <stdio.h>

#ifdef SF_HAVE_MUPARSER

#include <math.h>
#include <muParserDLL.h>
#include <stdlib.h>
#include <string.h>

static const double PROBE = 0.7890625; // of all variables, to see which a formula sets

struct expression {
    muParserHandle_t parser;
    double x, y, z, v;
};

// What is wrong with a formula; NULL where nothing is. muParser takes "0,5" for two formulas of
// which the last counts, and "x=3" for an assignment: whoever writes these means something else.
static const char *fault_of(expression *e)
{
    int count = 0;
    e->x = e->y = e->z = e->v = PROBE;
    (void)mupEvalMulti(e->parser, &count);
    if (mupError(e->parser)) {
        return mupGetErrorMsg(e->parser);
    }
    if (count != 1) {
        return "it has several values; the decimal sign is a point";
    }
    const double *all[4] = {&e->x, &e->y, &e->z, &e->v};
    for (int i = 0; i < 4; i++) {
        if (*all[i] != PROBE) {
            return "it sets a variable; to compare write ==";
        }
    }
    return NULL;
}

expression *expression_read(const char *text, char *why, size_t size)
{
    expression *e = calloc(1, sizeof *e);
    if (e == NULL) {
        snprintf(why, size, "there is no memory for a formula");
        return NULL;
    }
    e->parser = mupCreate(0); // of floating-point numbers
    mupDefineVar(e->parser, "x", &e->x);
    mupDefineVar(e->parser, "y", &e->y);
    mupDefineVar(e->parser, "z", &e->z);
    mupDefineVar(e->parser, "v", &e->v);
    mupSetExpr(e->parser, text);
    const char *wrong = fault_of(e);
    if (wrong != NULL) {
        snprintf(why, size, "'%.100s' is no formula of x, y, z and v: %.200s", text, wrong);
        expression_free(e);
        return NULL;
    }
    return e;
}

void expression_free(expression *e)
{
    if (e != NULL) {
        mupRelease(e->parser);
        free(e);
    }
}

double expression_at(expression *e, const double place[3], double v)
{
    e->x = place[0];
    e->y = place[1];
    e->z = place[2];
    e->v = v;
    double value = mupEval(e->parser);
    return mupError(e->parser) ? NAN : value;
}

#else

expression *expression_read(const char *text, char *why, size_t size)
{
    snprintf(why, size, "this program reads no formulas such as '%.60s'; build it with muparser",
             text);
    return NULL;
}

void expression_free(expression *e)
{
    (void)e;
}

double expression_at(expression *e, const double place[3], double v)
{
    (void)e;
    (void)place;
    return v;
}

#endif
