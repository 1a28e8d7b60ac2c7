// SPDX-License-Identifier: MIT
// The sculpting program on a graphics card that is lost after some frames: the driver says so from
// then on, as one does after a reset. The rest of the program is as it is; tests/cli/sculpt.sh
// opens its window and looks at what was rescued.

#include <epoxy/gl.h>

enum { FRAMES = 60 };

static GLenum GLAPIENTRY lose(void)
{
    static int frames;
    return ++frames < FRAMES ? GL_NO_ERROR : GL_INNOCENT_CONTEXT_RESET;
}

__attribute__((constructor)) static void take_place(void)
{
    epoxy_glGetGraphicsResetStatus = lose;
}
