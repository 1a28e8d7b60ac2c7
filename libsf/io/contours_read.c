// SPDX-License-Identifier: MIT
// CLI in: the head, and geometry as text.
//
// Text is read a byte at a time: a polygon is one line of any length, so there are no tokens that
// could be cut. What stands between two pairs of slashes is a comment, and commands that are not
// known are passed over to the end of their line.
//
// Source: "Common Layer Interface (CLI), Version 2.0", Brite EuRam BE 2578, 1994.

#include "base/memory.h"
#include "base/status.h"
#include "io/contours.h"
#include "io/number.h"

#include <math.h>
#include <string.h>

#define WORD_SIZE 32
#define NUMBER_SIZE 64

// ---------------------------------------------------------------------------------------------
// A layer under way
// ---------------------------------------------------------------------------------------------

static sf_status add_layer(sfi_cli *cli)
{
    size_t end = cli->points.count;
    SF_TRY(sfi_list_push(&cli->cursor.allocator, &cli->starts, &end));
    sf_contours view = {cli->points.items, cli->starts.items, cli->starts.count - 1};
    sf_status status = sf_contour_stack_add(cli->stack, cli->height_mm, &view, cli->fault);
    cli->points.count = cli->starts.count = 0;
    return status == SF_ERR_ARGUMENT
               ? sfi_cursor_fault(&cli->cursor, cli->fault,
                                  "the layer above ends too close to this one, or too far out; "
                                  "export the file again")
               : status;
}

// The first layer is under way, and this is how thick it is.
static sf_status begin_stack(sfi_cli *cli, double thick_mm)
{
    sf_status status =
        sf_contour_stack_create(cli->height_mm - thick_mm, &cli->cursor.allocator, &cli->stack);
    return status == SF_ERR_ARGUMENT
               ? sfi_cursor_fault(&cli->cursor, cli->fault, "a height beyond 1e12 mm")
               : status;
}

sf_status sfi_cli_layer(sfi_cli *cli, double height)
{
    double height_mm = height * cli->unit_mm;
    if (!(fabs(height_mm) <= 1e12)) {
        return sfi_cursor_fault(&cli->cursor, cli->fault, "a height that is none");
    }
    cli->layers++;
    if (cli->layers > 1 && height_mm == cli->height_mm) {
        return SF_OK;
    }
    if (cli->layers > 1 && !(height_mm > cli->height_mm)) {
        return sfi_cursor_fault(&cli->cursor, cli->fault,
                                "this layer lies below the one before it; sort the layers upward");
    }
    if (cli->layers > 1) {
        if (cli->stack == NULL) {
            SF_TRY(begin_stack(cli, height_mm - cli->height_mm));
        }
        SF_TRY(add_layer(cli));
    }
    cli->height_mm = height_mm;
    return SF_OK;
}

sf_status sfi_cli_contour(sfi_cli *cli)
{
    size_t start = cli->points.count;
    if (cli->layers == 0) {
        return sfi_cursor_fault(&cli->cursor, cli->fault, "a polygon before the first layer");
    }
    return sfi_list_push(&cli->cursor.allocator, &cli->starts, &start);
}

sf_status sfi_cli_point(sfi_cli *cli, double x, double y)
{
    double point[2] = {x * cli->unit_mm, y * cli->unit_mm};
    if (!(fabs(point[0]) <= 1e12) || !(fabs(point[1]) <= 1e12)) {
        return sfi_cursor_fault(&cli->cursor, cli->fault, "a point that is not finite");
    }
    if (cli->points_left-- == 0) {
        return sfi_fault_set(cli->fault, SF_ERR_OVERFLOW, cli->cursor.line,
                             sfi_cursor_offset(&cli->cursor),
                             "the file has more points than vertices_max; raise it");
    }
    return sfi_list_push(&cli->cursor.allocator, &cli->points, point);
}

static void turn_round(double *points, size_t count)
{
    for (size_t i = 0, j = count; i + 1 < j--; i++) {
        for (int axis = 0; axis < 2; axis++) {
            double held = points[2 * i + (size_t)axis];
            points[2 * i + (size_t)axis] = points[2 * j + (size_t)axis];
            points[2 * j + (size_t)axis] = held;
        }
    }
}

sf_status sfi_cli_contour_end(sfi_cli *cli, int64_t way)
{
    size_t *starts = cli->starts.items, from = starts[cli->starts.count - 1];
    size_t ends[2] = {0, cli->points.count - from};
    double *points = (double *)cli->points.items + 2 * from;
    if (way < 0 || way > 2) {
        return sfi_cursor_fault(&cli->cursor, cli->fault,
                                "a polygon is a hole (0), an outside (1) or open (2)");
    }
    if (way == 2 || ends[1] < 3) { // it encloses nothing
        cli->points.count = from;
        cli->starts.count--;
        return SF_OK;
    }
    sf_contours one = {points, ends, 1};
    double area = sf_contours_area_mm2(&one);
    if (way == 1 ? area < 0 : area > 0) {
        turn_round(points, ends[1]);
    }
    return SF_OK;
}

static sf_status finish(sfi_cli *cli)
{
    if (cli->layers == 0) {
        return sfi_cursor_fault(&cli->cursor, cli->fault, "the file has no layers");
    }
    if (cli->has_layers && cli->said_layers != cli->layers) {
        return sfi_fault_set(cli->fault, SF_ERR_FORMAT, 0, 0,
                             "the head says %llu layers, and there are %llu; export the file again",
                             (unsigned long long)cli->said_layers, (unsigned long long)cli->layers);
    }
    if (cli->stack == NULL) {
        SF_TRY(begin_stack(cli, cli->height_mm > 0 ? cli->height_mm : 1));
    }
    return add_layer(cli);
}

// ---------------------------------------------------------------------------------------------
// Text
// ---------------------------------------------------------------------------------------------

static sf_status damaged(sfi_cli *cli, const char *sentence)
{
    return sfi_cursor_fault(&cli->cursor, cli->fault, sentence);
}

static int is_blank(int c)
{
    return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == '\v';
}

// The next byte that is no blank and in no comment, not taken; -1 at the end.
static int look(sfi_cli *cli)
{
    int c = sfi_cursor_look(&cli->cursor);
    while (is_blank(c)) {
        (void)sfi_cursor_next(&cli->cursor);
        c = sfi_cursor_look(&cli->cursor);
    }
    return c;
}

// Behind the first two slashes of a comment: up to the two that end it.
static void skip_comment(sfi_cli *cli)
{
    int before = 0, c = sfi_cursor_next(&cli->cursor);
    while (c >= 0 && !(before == '/' && c == '/')) {
        before = c;
        c = sfi_cursor_next(&cli->cursor);
    }
}

// The next command: letters behind two dollars. Empty at the end of the file.
static sf_status read_word(sfi_cli *cli, char word[WORD_SIZE])
{
    size_t length = 0;
    word[0] = '\0';
    while (look(cli) == '/') {
        (void)sfi_cursor_next(&cli->cursor);
        if (sfi_cursor_next(&cli->cursor) != '/') {
            return damaged(cli, "this is no CLI file: a command begins with $$");
        }
        skip_comment(cli);
    }
    if (look(cli) < 0) {
        return cli->cursor.failure != SF_OK ? damaged(cli, "") : SF_OK;
    }
    for (int i = 0; i < 2; i++) {
        if (sfi_cursor_next(&cli->cursor) != '$') {
            return damaged(cli, "this is no CLI file: a command begins with $$");
        }
    }
    for (int c; (c = sfi_cursor_look(&cli->cursor)) >= 'A' && c <= 'Z' && length + 1 < WORD_SIZE;) {
        word[length++] = (char)sfi_cursor_next(&cli->cursor);
    }
    word[length] = '\0';
    return length > 0 ? SF_OK : damaged(cli, "a command without a name");
}

// The number behind a slash or a comma, which is taken first.
static sf_status read_number(sfi_cli *cli, int before, double *value)
{
    char text[NUMBER_SIZE];
    size_t length = 0;
    if (look(cli) != before) {
        return damaged(cli, before == ',' ? "a number is missing: a comma was expected"
                                          : "a number is missing: a slash was expected");
    }
    (void)sfi_cursor_next(&cli->cursor);
    int c = look(cli);
    while (c > ' ' && c != ',' && c != '/' && c != '$' && length + 1 < NUMBER_SIZE) {
        text[length++] = (char)sfi_cursor_next(&cli->cursor);
        c = sfi_cursor_look(&cli->cursor);
    }
    text[length] = '\0';
    if (!sfi_number_parse(text, value) || !isfinite(*value)) {
        return sfi_cursor_fault_token(&cli->cursor, cli->fault, "a number", text);
    }
    return SF_OK;
}

static sf_status read_count(sfi_cli *cli, int before, uint64_t *count)
{
    double value;
    SF_TRY(read_number(cli, before, &value));
    if (!(value >= 0 && value <= 9007199254740992.0) || floor(value) != value) {
        return damaged(cli, "a count is not a whole number from 0 on");
    }
    *count = (uint64_t)value;
    return SF_OK;
}

static sf_status read_polyline(sfi_cli *cli)
{
    uint64_t id, way, count;
    double x, y;
    SF_TRY(read_count(cli, '/', &id));
    SF_TRY(read_count(cli, ',', &way));
    SF_TRY(read_count(cli, ',', &count));
    SF_TRY(sfi_cli_contour(cli));
    for (uint64_t i = 0; i < count; i++) {
        SF_TRY(read_number(cli, ',', &x));
        SF_TRY(read_number(cli, ',', &y));
        SF_TRY(sfi_cli_point(cli, x, y));
    }
    if (look(cli) == ',') {
        return damaged(cli, "a polygon has more points than it says");
    }
    return sfi_cli_contour_end(cli, way <= 2 ? (int64_t)way : 3);
}

static sf_status read_geometry(sfi_cli *cli)
{
    char word[WORD_SIZE];
    double height;
    for (;;) {
        SF_TRY(read_word(cli, word));
        if (strcmp(word, "GEOMETRYEND") == 0) {
            return SF_OK;
        }
        if (word[0] == '\0') {
            return damaged(cli, "the file ends before $$GEOMETRYEND; copy or export it again");
        }
        if (strcmp(word, "LAYER") == 0) {
            SF_TRY(read_number(cli, '/', &height));
            SF_TRY(sfi_cli_layer(cli, height));
        } else if (strcmp(word, "POLYLINE") == 0) {
            SF_TRY(read_polyline(cli));
        } else {
            sfi_cursor_skip_line(&cli->cursor); // hatches, and what is not known
        }
    }
}

// ---------------------------------------------------------------------------------------------
// Head
// ---------------------------------------------------------------------------------------------

static sf_status read_head_line(sfi_cli *cli, const char *word)
{
    if (strcmp(word, "UNITS") == 0) {
        SF_TRY(read_number(cli, '/', &cli->unit_mm));
        return cli->unit_mm > 0 && cli->unit_mm <= 1e6
                   ? SF_OK
                   : damaged(cli, "the unit is not above 0, or beyond 1e6 mm");
    }
    if (strcmp(word, "LAYERS") == 0) {
        cli->has_layers = 1;
        return read_count(cli, '/', &cli->said_layers);
    }
    if (strcmp(word, "BINARY") == 0 || strcmp(word, "ASCII") == 0) {
        cli->is_binary = word[0] == 'B';
        return SF_OK;
    }
    if (strcmp(word, "ALIGN") == 0) {
        cli->is_aligned = 1;
        return SF_OK;
    }
    sfi_cursor_skip_line(&cli->cursor); // dates, labels, whatever else
    return SF_OK;
}

static sf_status read_head(sfi_cli *cli)
{
    char word[WORD_SIZE];
    sfi_cursor_skip_mark(&cli->cursor);
    SF_TRY(read_word(cli, word));
    if (strcmp(word, "HEADERSTART") != 0) {
        return damaged(cli, "this is no CLI file: it does not begin with $$HEADERSTART");
    }
    for (;;) {
        SF_TRY(read_word(cli, word));
        if (strcmp(word, "HEADEREND") == 0) {
            return SF_OK;
        }
        if (word[0] == '\0') {
            return damaged(cli, "the file ends in its head; copy or export it again");
        }
        SF_TRY(read_head_line(cli, word));
    }
}

static sf_status read_file(sfi_cli *cli)
{
    char word[WORD_SIZE];
    SF_TRY(read_head(cli));
    if (cli->is_binary) {
        SF_TRY(sfi_cli_read_binary(cli));
        return finish(cli);
    }
    SF_TRY(read_word(cli, word));
    if (strcmp(word, "GEOMETRYSTART") != 0) {
        return damaged(cli, "$$GEOMETRYSTART does not follow the head");
    }
    SF_TRY(read_geometry(cli));
    return finish(cli);
}

sf_status sf_contour_stack_read(sf_source source, const sf_read_limits *limits,
                                const sf_allocator *allocator, sf_contour_stack **stack,
                                sf_fault *fault)
{
    sf_read_limits bounds = sf_read_limits_default();
    if (source.read == NULL || stack == NULL ||
        (limits != NULL && limits->struct_size < sizeof bounds)) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                             "no source, no place for the stack, or limits without their size");
    }
    bounds = limits != NULL ? *limits : bounds;
    sfi_cli cli = {.fault = fault, .unit_mm = 1, .points_left = bounds.vertices_max};
    cli.points = sfi_list_of(2 * sizeof(double));
    cli.starts = sfi_list_of(sizeof(size_t));
    sf_status status = sfi_cursor_begin(&cli.cursor, source, bounds.bytes_max, allocator);
    if (status == SF_OK) {
        status = read_file(&cli);
    }
    sfi_list_free(&cli.cursor.allocator, &cli.points);
    sfi_list_free(&cli.cursor.allocator, &cli.starts);
    sfi_cursor_end(&cli.cursor);
    if (status != SF_OK) {
        sf_contour_stack_destroy(cli.stack);
        return status == SF_ERR_MEMORY
                   ? sfi_fault_set(fault, status, 0, 0, "there is not enough memory for this file")
                   : status;
    }
    *stack = cli.stack;
    return SF_OK;
}
