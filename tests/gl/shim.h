// SPDX-License-Identifier: MIT
// A shim between a program and OpenGL: it counts dispatches, and every call by which a program can
// wait for the graphics card or get anything back from it.
//
// libepoxy calls through pointers that anyone may exchange. Each starts as a function that looks
// the real one up when it is first called; the shim looks it up itself.

#ifndef SF_TEST_GL_SHIM_H
#define SF_TEST_GL_SHIM_H

#include <epoxy/egl.h>
#include <epoxy/gl.h>

static long shim_dispatches, shim_readbacks;

// `name` is a macro of libepoxy for its pointer, so it stands alone where the pointer is meant.
#define SHIM_VOID(name, parameters, arguments, counter)                                            \
    typedef void(EPOXY_CALLSPEC * shim_type_##name) parameters;                                    \
    static shim_type_##name shim_real_##name;                                                      \
    static void EPOXY_CALLSPEC shim_##name parameters                                              \
    {                                                                                              \
        counter++;                                                                                 \
        shim_real_##name arguments;                                                                \
    }                                                                                              \
    static void shim_install_##name(void)                                                          \
    {                                                                                              \
        shim_real_##name = (shim_type_##name)eglGetProcAddress(#name);                             \
        name = shim_##name;                                                                        \
    }

#define SHIM_VALUE(name, result, parameters, arguments, counter)                                   \
    typedef result(EPOXY_CALLSPEC *shim_type_##name) parameters;                                   \
    static shim_type_##name shim_real_##name;                                                      \
    static result EPOXY_CALLSPEC shim_##name parameters                                            \
    {                                                                                              \
        counter++;                                                                                 \
        return shim_real_##name arguments;                                                         \
    }                                                                                              \
    static void shim_install_##name(void)                                                          \
    {                                                                                              \
        shim_real_##name = (shim_type_##name)eglGetProcAddress(#name);                             \
        name = shim_##name;                                                                        \
    }

SHIM_VOID(glDispatchCompute, (GLuint x, GLuint y, GLuint z), (x, y, z), shim_dispatches)
SHIM_VOID(glDispatchComputeIndirect, (GLintptr at), (at), shim_dispatches)

SHIM_VOID(glFinish, (void), (), shim_readbacks)
SHIM_VOID(glGetBufferSubData, (GLenum t, GLintptr at, GLsizeiptr n, void *to), (t, at, n, to),
          shim_readbacks)
SHIM_VOID(glGetNamedBufferSubData, (GLuint b, GLintptr at, GLsizeiptr n, void *to), (b, at, n, to),
          shim_readbacks)
SHIM_VALUE(glMapBuffer, void *, (GLenum t, GLenum access), (t, access), shim_readbacks)
SHIM_VALUE(glMapNamedBuffer, void *, (GLuint b, GLenum access), (b, access), shim_readbacks)
SHIM_VALUE(glMapBufferRange, void *, (GLenum t, GLintptr at, GLsizeiptr n, GLbitfield access),
           (t, at, n, access), shim_readbacks)
SHIM_VALUE(glMapNamedBufferRange, void *, (GLuint b, GLintptr at, GLsizeiptr n, GLbitfield access),
           (b, at, n, access), shim_readbacks)
SHIM_VOID(glReadPixels,
          (GLint x, GLint y, GLsizei w, GLsizei h, GLenum format, GLenum type, void *to),
          (x, y, w, h, format, type, to), shim_readbacks)
SHIM_VOID(glReadnPixels,
          (GLint x, GLint y, GLsizei w, GLsizei h, GLenum format, GLenum type, GLsizei n, void *to),
          (x, y, w, h, format, type, n, to), shim_readbacks)
SHIM_VOID(glGetTexImage, (GLenum t, GLint level, GLenum format, GLenum type, void *to),
          (t, level, format, type, to), shim_readbacks)
SHIM_VOID(glGetTextureImage,
          (GLuint t, GLint level, GLenum format, GLenum type, GLsizei n, void *to),
          (t, level, format, type, n, to), shim_readbacks)
SHIM_VALUE(glClientWaitSync, GLenum, (GLsync s, GLbitfield flags, GLuint64 ns), (s, flags, ns),
           shim_readbacks)
SHIM_VOID(glGetQueryObjectuiv, (GLuint q, GLenum what, GLuint *to), (q, what, to), shim_readbacks)
SHIM_VOID(glGetQueryObjectui64v, (GLuint q, GLenum what, GLuint64 *to), (q, what, to),
          shim_readbacks)

// With a context current.
static inline void shim_install(void)
{
    shim_install_glDispatchCompute();
    shim_install_glDispatchComputeIndirect();
    shim_install_glFinish();
    shim_install_glGetBufferSubData();
    shim_install_glGetNamedBufferSubData();
    shim_install_glMapBuffer();
    shim_install_glMapNamedBuffer();
    shim_install_glMapBufferRange();
    shim_install_glMapNamedBufferRange();
    shim_install_glReadPixels();
    shim_install_glReadnPixels();
    shim_install_glGetTexImage();
    shim_install_glGetTextureImage();
    shim_install_glClientWaitSync();
    shim_install_glGetQueryObjectuiv();
    shim_install_glGetQueryObjectui64v();
}

#endif
