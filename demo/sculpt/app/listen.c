// SPDX-License-Identifier: MIT
// What the window hears becomes the editor's events, unless the panel wants it.

#include "app.h"

void app_take(void *user, const app_event *event)
{
    app *a = user;
    if (!app_event_is_good(event)) {
        return;
    }
    if (a->record != NULL) {
        app_event_write(a->record, event, NULL);
    }
    editor_take(a->editor, event);
    a->is_stale = 1;
}

static unsigned mods_of(int mods)
{
    return ((mods & GLFW_MOD_SHIFT) != 0 ? (unsigned)MOD_SHIFT : 0) |
           ((mods & (GLFW_MOD_CONTROL | GLFW_MOD_SUPER)) != 0 ? (unsigned)MOD_CONTROL : 0) |
           ((mods & GLFW_MOD_ALT) != 0 ? (unsigned)MOD_ALT : 0);
}

static int has_pointer(const app *a)
{
#ifdef SCULPT_HAVE_PANEL
    return !panel_has_pointer(a->panel);
#else
    (void)a;
    return 1;
#endif
}

static int has_keys(const app *a)
{
#ifdef SCULPT_HAVE_PANEL
    return !panel_has_keys(a->panel);
#else
    (void)a;
    return 1;
#endif
}

// From the window's coordinates to pixels of the picture.
static void to_pixels(GLFWwindow *window, double *x, double *y)
{
    int w, h, pw, ph;
    glfwGetWindowSize(window, &w, &h);
    glfwGetFramebufferSize(window, &pw, &ph);
    *x *= w > 0 ? (double)pw / w : 1;
    *y *= h > 0 ? (double)ph / h : 1;
}

static void on_move(GLFWwindow *window, double x, double y)
{
    app *a = glfwGetWindowUserPointer(window);
    app_event event = {EVENT_MOVE, 0, 0, x, y, 0, 0, 0};
    to_pixels(window, &event.x, &event.y);
    if (a->editor->drag != DRAG_NONE || has_pointer(a)) {
        app_take(a, &event);
    }
    a->is_stale = 1;
}

static void on_button(GLFWwindow *window, int button, int action, int mods)
{
    app *a = glfwGetWindowUserPointer(window);
    int code = button == GLFW_MOUSE_BUTTON_LEFT    ? BUTTON_LEFT
               : button == GLFW_MOUSE_BUTTON_RIGHT ? BUTTON_RIGHT
                                                   : BUTTON_MIDDLE;
    app_event event = {
        action == GLFW_PRESS ? EVENT_PRESS : EVENT_RELEASE, code, mods_of(mods), 0, 0, 0, 0, 0};
    glfwGetCursorPos(window, &event.x, &event.y);
    to_pixels(window, &event.x, &event.y);
    if (action == GLFW_RELEASE || has_pointer(a)) {
        app_take(a, &event);
    }
    a->is_stale = 1;
}

static void on_scroll(GLFWwindow *window, double x, double y)
{
    app *a = glfwGetWindowUserPointer(window);
    app_event event = {EVENT_SCROLL, 0, 0, x, y, 0, 0, 0};
    if (has_pointer(a)) {
        app_take(a, &event);
    }
    a->is_stale = 1;
}

static void on_key(GLFWwindow *window, int key, int scancode, int action, int mods)
{
    app *a = glfwGetWindowUserPointer(window);
    app_event event = {EVENT_KEY, key == GLFW_KEY_ESCAPE ? 27 : key, mods_of(mods), 0, 0, 0, 0, 0};
    (void)scancode;
    if (action != GLFW_RELEASE && has_keys(a) && event.code < 128) {
        app_take(a, &event);
    }
    a->is_stale = 1;
}

static void on_size(GLFWwindow *window, int width, int height)
{
    app *a = glfwGetWindowUserPointer(window);
    app_event event = {EVENT_SIZE, 0, 0, width, height, 0, 0, 0};
    app_take(a, &event);
}

static void on_refresh(GLFWwindow *window)
{
    app *a = glfwGetWindowUserPointer(window);
    a->is_stale = 1;
}

static void on_drop(GLFWwindow *window, int count, const char **paths)
{
    app *a = glfwGetWindowUserPointer(window);
    if (count > 0) {
        app_open_file(a, paths[0]);
    }
    a->is_stale = 1;
}

void app_listen(app *a)
{
    glfwSetWindowUserPointer(a->window, a);
    glfwSetCursorPosCallback(a->window, on_move);
    glfwSetMouseButtonCallback(a->window, on_button);
    glfwSetScrollCallback(a->window, on_scroll);
    glfwSetKeyCallback(a->window, on_key);
    glfwSetFramebufferSizeCallback(a->window, on_size);
    glfwSetWindowRefreshCallback(a->window, on_refresh);
    glfwSetDropCallback(a->window, on_drop);
}
