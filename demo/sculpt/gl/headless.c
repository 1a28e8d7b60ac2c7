// SPDX-License-Identifier: MIT
// Headless: OpenGL through EGL on a platform that has no surfaces.
//
// Mesa offers it with and without a graphics card; without one its own renderer draws. Nothing of
// an X server is asked for. The display belongs to the whole program, so it stays when a context
// goes.

#include "headless.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <stdlib.h>

struct gl_headless {
    EGLDisplay display;
    EGLContext context;
};

static EGLDisplay find_display(void)
{
    if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_base") ||
        !epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
        return EGL_NO_DISPLAY;
    }
    return eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
}

static EGLContext make_context(EGLDisplay display)
{
    static const EGLint wanted[] = {EGL_CONTEXT_MAJOR_VERSION,
                                    4,
                                    EGL_CONTEXT_MINOR_VERSION,
                                    5,
                                    EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                    EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                    EGL_NONE};
    if (!eglBindAPI(EGL_OPENGL_API)) {
        return EGL_NO_CONTEXT;
    }
    return eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wanted);
}

gl_headless *gl_headless_create(const char **why)
{
    gl_headless *made = malloc(sizeof *made);
    *why = "There is no memory for a context of OpenGL.";
    if (made == NULL) {
        return NULL;
    }
    made->display = find_display();
    *why = "There is no EGL without surfaces here; Mesa's libEGL has it.";
    if (made->display == EGL_NO_DISPLAY || !eglInitialize(made->display, NULL, NULL)) {
        free(made);
        return NULL;
    }
    made->context = make_context(made->display);
    *why = "There is no OpenGL 4.5 here.";
    if (made->context == EGL_NO_CONTEXT ||
        !eglMakeCurrent(made->display, EGL_NO_SURFACE, EGL_NO_SURFACE, made->context)) {
        free(made);
        return NULL;
    }
    *why = NULL;
    return made;
}

void gl_headless_destroy(gl_headless *headless)
{
    if (headless != NULL) {
        eglMakeCurrent(headless->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(headless->display, headless->context);
        free(headless);
    }
}
