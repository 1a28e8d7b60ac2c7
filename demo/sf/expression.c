// SPDX-License-Identifier: MIT
// Formulas, by muParser.

#include "expression.h"

#include <stdio.h>

#ifdef SF_HAVE_MUPARSER

#include <math.h>
#include <muParserDLL.h>
#include <stdlib.h>
#include <string.h>

struct expression {
    muParserHandle_t parser;
    double x, y, z, v;
};

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
    (void)mupEval(e->parser);
    if (mupError(e->parser)) {
        snprintf(why, size, "'%.100s' is no formula of x, y, z and v: %.200s", text,
                 mupGetErrorMsg(e->parser));
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
