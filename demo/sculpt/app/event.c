// SPDX-License-Identifier: MIT
// Events as lines of text: a word, the code, the keys that are held, and numbers, which are written
// so that they come back as they were.

#include "event.h"

#include <math.h>
#include <string.h>

#include "desk/desk.h"

static const char *const words[EVENT_KIND_COUNT] = {
    "size", "move", "press", "release", "scroll", "key", "set", "do", "fly", "open", "tip"};

void app_event_write(FILE *file, const app_event *event, const char *path)
{
    if (event->kind >= EVENT_OPEN) {
        fprintf(file, "%s %s\n", words[event->kind], path);
        return;
    }
    fprintf(file, "%s %d %u %.17g %.17g %.17g %.17g %.17g\n", words[event->kind], event->code,
            event->mods, event->x, event->y, event->z, event->a, event->b);
}

// No pointer or size is further from 0; what is would end as no number in a camera. A desk bounds
// its settings itself: a stiffness in pascal is a large number.
#define NUMBER_MOST 1e9
#define SETTING_MOST 1e12

int app_event_is_good(const app_event *e)
{
    const double numbers[5] = {e->x, e->y, e->z, e->a, e->b};
    int is_desks = e->kind == EVENT_SET && e->code >= DESK_BALANCE_FIRST;
    for (int i = 0; i < 5; i++) {
        if (!(fabs(numbers[i]) <= (is_desks ? SETTING_MOST : NUMBER_MOST))) {
            return 0;
        }
    }
    return 1;
}

int app_event_can_name(const char *path)
{
    size_t length = strlen(path);
    return length > 0 && length < EVENT_PATH_SIZE && strpbrk(path, "\r\n") == NULL;
}

// The rest of a line that opens a file; 0 where it names none.
static int read_path(char *line, char path[EVENT_PATH_SIZE])
{
    line[strcspn(line, "\r\n")] = '\0';
    if (!app_event_can_name(line)) {
        return 0;
    }
    memcpy(path, line, strlen(line) + 1);
    return 1;
}

int app_event_read(FILE *file, app_event *event, char path[EVENT_PATH_SIZE])
{
    char line[EVENT_PATH_SIZE + 16], word[16];
    app_event e = {EVENT_SIZE, 0, 0, 0, 0, 0, 0, 0};
    if (fgets(line, sizeof line, file) == NULL) {
        return 0;
    }
    for (int k = EVENT_OPEN; k < EVENT_KIND_COUNT; k++) {
        size_t length = strlen(words[k]);
        if (strncmp(line, words[k], length) == 0 && line[length] == ' ') {
            e.kind = (app_event_kind)k;
            *event = e;
            return read_path(line + length + 1, path) ? 1 : -1;
        }
    }
    if (sscanf(line, "%15s %d %u %lf %lf %lf %lf %lf", word, &e.code, &e.mods, &e.x, &e.y, &e.z,
               &e.a, &e.b) != 8) {
        return -1;
    }
    for (int k = 0; k < EVENT_OPEN; k++) {
        if (strcmp(word, words[k]) == 0) {
            e.kind = (app_event_kind)k;
            *event = e;
            return app_event_is_good(&e) ? 1 : -1;
        }
    }
    return -1;
}
