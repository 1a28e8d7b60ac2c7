// SPDX-License-Identifier: MIT
// sculpt: model shapes that print without supports.

#include <stdio.h>

#include "app/options.h"
#include "app/shot.h"
#ifdef SCULPT_HAVE_WINDOW
#include "app/window.h"
#endif

int main(int argc, char **argv)
{
    app_options options;
    switch (app_options_read(argc, argv, &options)) {
    case APP_DONE:
        return 0;
    case APP_WRONG:
        return 2;
    default:
        break;
    }
    if (options.headless) {
        return app_run_headless(&options);
    }
#ifdef SCULPT_HAVE_WINDOW
    return app_run_window(&options);
#else
    fputs("sculpt: this build has no window (it was made without GLFW); see --headless.\n", stderr);
    return 2;
#endif
}
