// SPDX-License-Identifier: MIT
// Firmware that looks at a job before it exposes a layer of it: an example to start from.
//
//     firmware dense|runs[=N] JOB [STATE [LAYERS]]
//
// It decodes JOB layer by layer, asks whether each is carried by the one below, and prints counts
// and the first places. With STATE it saves after each layer and, when it starts, goes on from what
// it finds there; LAYERS stops it after so many, as a power cut would.
//
// What a printer does differently: it asks before each exposure and stops there, its decoder reads
// another format, its STATE is a page of flash. What stays is the five calls: sf_chip_place,
// sf_chip_resume, sf_chip_push, sf_chip_save, sf_chip_report. The rule lies in read-only memory:
// table.h is what `sf-chip table` prints.

#include "board.h"
#include "job.h"
#include "table.h"

// Memory for the checker: dense, a slice of 2048 x 4096 and its rows; or any number of runs.
static uint64_t memory[(384 + 256 * (4096 + 8)) / 8];
static sf_chip_finding findings[8];

// How long rows took, apart from their decoding.
typedef struct stopwatch {
    job *job;
    uint32_t since, longest;
} stopwatch;

static int is_same(const char *a, const char *b)
{
    while (*a != '\0' && *a == *b) {
        a++;
        b++;
    }
    return *a == *b;
}

// ---------------------------------------------------------------------------------------------
// What it says
// ---------------------------------------------------------------------------------------------

static void print_digits(uint64_t number, uint32_t base)
{
    char text[21];
    int at = 20;
    text[at] = '\0';
    do {
        // Numbers of 64 bits without a division of 64 bits: two halves, from the top.
        uint32_t high = (uint32_t)(number >> 32), low = (uint32_t)number, rest = high % base;
        uint32_t middle = rest << 16 | low >> 16, last = (middle % base) << 16 | (low & 0xffff);
        text[--at] = "0123456789abcdef"[last % base];
        number = (uint64_t)(high / base) << 32 | (uint64_t)(middle / base) << 16 | last / base;
    } while (number != 0);
    board_print(text + at);
}

static void print_line(const char *name, uint64_t number, uint32_t base)
{
    board_print(name);
    board_print(" ");
    print_digits(number, base);
    board_print("\n");
}

static void print_counts(const sf_chip_counts *c)
{
    print_line("layers", c->layer_count, 10);
    print_line("bed", c->bed_layer, 10);
    print_line("solid", c->solid_voxels, 10);
    print_line("unsupported", c->unsupported_voxels, 10);
    print_line("unsupported_layers", c->unsupported_layers, 10);
    print_line("unsupported_runs", c->unsupported_runs, 10);
    print_line("layers_hash", c->layers_hash, 16);
    print_line("unsupported_hash", c->unsupported_hash, 16);
    for (uint32_t i = 0; i < c->finding_count; i++) {
        const uint32_t numbers[4] = {findings[i].layer, findings[i].y, findings[i].x0,
                                     findings[i].x1};
        board_print("finding");
        for (int n = 0; n < 4; n++) {
            board_print(" ");
            print_digits(numbers[n], 10);
        }
        board_print("\n");
    }
    board_print(c->support_free ? "support-free\n" : "not support-free\n");
}

static int fail(const char *what, sf_status status)
{
    board_print("firmware: ");
    board_print(what);
    board_print(": ");
    board_print(sf_status_message(status));
    board_print("\n");
    return 2;
}

// ---------------------------------------------------------------------------------------------
// Files
// ---------------------------------------------------------------------------------------------

static size_t read_job(void *user, uint8_t *bytes, size_t capacity)
{
    return board_read(*(int *)user, bytes, capacity);
}

static sf_status read_state(void *user, uint32_t offset, void *data, size_t size)
{
    uint8_t *bytes = data;
    int file = *(int *)user;
    size_t got = board_seek(file, offset) ? board_read(file, data, size) : 0;
    for (size_t i = got; i < size; i++) {
        bytes[i] = 0xff; // what was never written
    }
    return SF_OK;
}

static sf_status write_state(void *user, uint32_t offset, const void *data, size_t size)
{
    int file = *(int *)user;
    return board_seek(file, offset) && board_write(file, data, size) ? SF_OK : SF_ERR_IO;
}

// ---------------------------------------------------------------------------------------------
// The work
// ---------------------------------------------------------------------------------------------

static sf_status decode(void *user, sf_chip *chip, uint32_t layer, uint32_t y)
{
    stopwatch *w = user;
    uint32_t took = board_since(w->since);
    w->longest = y > 0 && took > w->longest ? took : w->longest;
    sf_status status = job_decode(w->job, chip, layer, y);
    w->since = board_clock();
    return status;
}

static sf_status check(sf_chip *chip, job *j, const sf_chip_store *store, uint32_t stop)
{
    sf_chip_counts counts;
    stopwatch watch = {j, 0, 0};
    sf_status status = sf_chip_report(chip, &counts);
    for (uint32_t k = 0; status == SF_OK && k < counts.layer_count; k++) {
        status = job_skip_layer(j);
    }
    for (uint32_t k = counts.layer_count; status == SF_OK && k < j->layers && k < stop; k++) {
        status = sf_chip_push(chip, decode, &watch);
        if (status == SF_OK && store != NULL) {
            status = sf_chip_save(chip, store);
        }
    }
    print_line("longest_row", watch.longest, 10);
    return status;
}

static uint32_t number_of(const char *text)
{
    uint32_t number = 0;
    for (; text != NULL && *text >= '0' && *text <= '9'; text++) {
        number = number * 10 + (uint32_t)(*text - '0');
    }
    return text == NULL ? UINT32_MAX : number;
}

// Runs of a layer: 0 for "dense", else what stands behind "runs=".
static uint32_t runs_of(const char *form)
{
    if (is_same(form, "dense")) {
        return 0;
    }
    return is_same(form, "runs") ? TABLE_RUNS : number_of(form + 5);
}

static int run(const char *form, const char *path, const char *state, uint32_t stop)
{
    int file = board_open(path), state_file = -1;
    job j = {read_job, &file, 0, 0, 0, 0, 0, {0}};
    sf_status status = file < 0 ? SF_ERR_IO : job_begin(&j);
    if (status != SF_OK) {
        return fail(path, status);
    }
    sf_chip_options options = sf_chip_options_default();
    options.rule = table;
    options.width = j.width;
    options.height = j.height;
    options.run_capacity = runs_of(form);
    options.findings = findings;
    options.finding_capacity = 8;
    sf_chip *chip = NULL;
    sf_chip_counts counts;
    size_t size = 0;
    status = sf_chip_size(&options, &size);
    if (status == SF_OK) {
        status = sf_chip_place(&options, memory, sizeof memory, &chip);
    }
    if (status != SF_OK) {
        return fail("the job's layers", status);
    }
    sf_chip_store store = {read_state, write_state, &state_file, 0};
    if (state != NULL) {
        state_file = board_open_to_change(state);
        status = state_file < 0 ? SF_ERR_IO : sf_chip_slot_size(chip, &store.slot_size);
        if (status != SF_OK) {
            return fail(state, status);
        }
        status = sf_chip_resume(chip, &store);
        board_print(status == SF_OK ? "going on\n" : "from the beginning\n");
    }
    status = check(chip, &j, state != NULL ? &store : NULL, stop);
    if (status != SF_OK) {
        return fail("a layer", status);
    }
    status = sf_chip_report(chip, &counts);
    print_counts(&counts);
    print_line("memory", size, 10);
    print_line("stack", board_stack_used(), 10);
    return counts.support_free ? 0 : 1;
}

int firmware(void)
{
    const char *form = board_argument(1), *path = board_argument(2);
    if (form == NULL || path == NULL || (form[0] != 'd' && form[0] != 'r')) {
        board_print("usage: firmware dense|runs[=N] JOB [STATE [LAYERS]]\n");
        return 2;
    }
    const char *state = board_argument(3), *stop = state != NULL ? board_argument(4) : NULL;
    return run(form, path, state, number_of(stop));
}
