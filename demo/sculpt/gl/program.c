// SPDX-License-Identifier: MIT
// Programs: sources put together, compiled and linked.
//
// GLSL has no #include. Here a line `#include "name"` stands for the lines of that source, which
// may include others; each is taken once, and each opens with a #line, so that the compiler names
// places in the files as they are: source 3, line 12 is line 12 of gl_sources[3].

#include "program.h"

#include <epoxy/gl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "source.h"

#define SOURCE_MAX 64u

// A text that grows.
typedef struct text {
    char *bytes;
    size_t size, capacity;
    int has_failed;                  // for want of memory, or of a source
    unsigned char taken[SOURCE_MAX]; // sources that are in it
} text;

static void append(text *t, const char *line)
{
    size_t length = strlen(line);
    if (t->size + length + 1 > t->capacity) {
        size_t capacity = 2 * t->capacity + length + 4096;
        char *bytes = realloc(t->bytes, capacity);
        if (bytes == NULL) {
            t->has_failed = 1;
            return;
        }
        t->bytes = bytes;
        t->capacity = capacity;
    }
    memcpy(t->bytes + t->size, line, length + 1);
    t->size += length;
}

static unsigned find(const char *name, size_t length)
{
    for (unsigned i = 0; gl_sources[i].name != NULL && i < SOURCE_MAX; i++) {
        if (strlen(gl_sources[i].name) == length && memcmp(gl_sources[i].name, name, length) == 0) {
            return i;
        }
    }
    return SOURCE_MAX;
}

// The place of line `line` of source i, said to the compiler.
static void append_place(text *t, unsigned i, unsigned line)
{
    char place[32];
    snprintf(place, sizeof place, "#line %u %u\n", line, i);
    append(t, place);
}

// The lines of a source, and in them those of others. Sources include no deeper than there are
// sources, since each is taken once.
static void append_source(text *t, const char *name, size_t length)
{
    static const char word[] = "#include \"";
    unsigned i = find(name, length);
    if (i == SOURCE_MAX) {
        t->has_failed = 1;
        return;
    }
    if (t->taken[i]) {
        return;
    }
    t->taken[i] = 1;
    append_place(t, i, 1);
    for (unsigned line = 0; gl_sources[i].lines[line] != NULL; line++) {
        const char *here = gl_sources[i].lines[line];
        const char *end = strchr(here, '\n'), *start = here + sizeof word - 1;
        if (strncmp(here, word, sizeof word - 1) == 0 && end != NULL && end > start) {
            append_source(t, start, (size_t)(end - start) - 1);
            append_place(t, i, line + 2);
        } else {
            append(t, here);
        }
    }
}

static int is_good(GLuint object, int is_program, char *log, size_t log_size)
{
    GLint good = 0;
    if (is_program) {
        glGetProgramiv(object, GL_LINK_STATUS, &good);
    } else {
        glGetShaderiv(object, GL_COMPILE_STATUS, &good);
    }
    if (!good && log_size > 0) {
        log[0] = '\0';
        if (is_program) {
            glGetProgramInfoLog(object, (GLsizei)log_size, NULL, log);
        } else {
            glGetShaderInfoLog(object, (GLsizei)log_size, NULL, log);
        }
    }
    return good;
}

static GLuint compile(GLenum kind, const char *name, char *log, size_t log_size)
{
    text t = {.bytes = NULL};
    append(&t, "#version 450\n");
    append_source(&t, name, strlen(name));
    if (t.has_failed) {
        snprintf(log, log_size, "%s: a source that it needs is not there, or there is no memory",
                 name);
        free(t.bytes);
        return 0;
    }
    GLuint shader = glCreateShader(kind);
    const char *source = t.bytes;
    glShaderSource(shader, 1, &source, NULL);
    glCompileShader(shader);
    free(t.bytes);
    if (is_good(shader, 0, log, log_size)) {
        return shader;
    }
    glDeleteShader(shader);
    return 0;
}

// A program of shaders, which go; 0 where one of them is 0.
static GLuint link_all(const GLuint *shaders, int count, char *log, size_t log_size)
{
    int is_whole = 1;
    GLuint program = glCreateProgram();
    for (int i = 0; i < count; i++) {
        is_whole = is_whole && shaders[i] != 0;
        if (shaders[i] != 0) {
            glAttachShader(program, shaders[i]);
        }
    }
    if (is_whole) {
        glLinkProgram(program);
        is_whole = is_good(program, 1, log, log_size);
    }
    for (int i = 0; i < count; i++) {
        if (shaders[i] != 0) {
            glDetachShader(program, shaders[i]);
            glDeleteShader(shaders[i]);
        }
    }
    if (!is_whole) {
        glDeleteProgram(program);
        program = 0;
    }
    return program;
}

unsigned gl_compute_program(const char *name, char *log, size_t log_size)
{
    GLuint shader = compile(GL_COMPUTE_SHADER, name, log, log_size);
    return link_all(&shader, 1, log, log_size);
}

unsigned gl_draw_program(const char *vertex, const char *fragment, char *log, size_t log_size)
{
    GLuint shaders[2] = {compile(GL_VERTEX_SHADER, vertex, log, log_size), 0};
    if (shaders[0] != 0) {
        shaders[1] = compile(GL_FRAGMENT_SHADER, fragment, log, log_size);
    }
    return link_all(shaders, 2, log, log_size);
}
