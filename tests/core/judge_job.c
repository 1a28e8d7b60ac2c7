// SPDX-License-Identifier: MIT
// What the library's own checker says of a job: the counts that the firmware must come to, printed
// in its words. usage: judge_job JOB [box3]; without it the rule is the octagon of 45 degrees on
// cubes, which is that of the example's table.

#include "job.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static size_t read_file(void *user, uint8_t *bytes, size_t capacity)
{
    return fread(bytes, 1, capacity, user);
}

// Runs of one layer, read without the chip's checker: its own reading of the bytes.
typedef struct runs {
    sf_run *runs;
    size_t count, capacity;
} runs;

static uint32_t number(FILE *file)
{
    uint32_t value = 0;
    for (unsigned shift = 0; shift < 32; shift += 7) {
        int byte = getc(file);
        value |= (uint32_t)(byte & 127) << shift;
        if (byte < 128) {
            break;
        }
    }
    return value;
}

static void read_layer(FILE *file, uint32_t height, runs *r)
{
    r->count = 0;
    for (uint32_t y = 0; y < height; y++) {
        uint32_t x = 0;
        for (uint32_t left = number(file); left > 0; left--) {
            if (r->count == r->capacity) {
                r->capacity = r->capacity * 2 + 1024;
                r->runs = realloc(r->runs, r->capacity * sizeof *r->runs);
                if (r->runs == NULL) {
                    exit(4);
                }
            }
            sf_run run = {0, 0, y, 0};
            run.x0 = x += number(file);
            run.x1 = x += number(file);
            r->runs[r->count++] = run;
        }
    }
}

int main(int count, char **words)
{
    FILE *file = count > 1 ? fopen(words[1], "rb") : NULL;
    job j = {read_file, file, 0, 0, 0, 0, 0, {0}};
    if (file == NULL || job_begin(&j) != SF_OK) {
        return 3;
    }
    rewind(file);
    (void)fseek(file, 7, SEEK_SET);
    uint32_t width = number(file), height = number(file), layers = number(file);
    sf_check_options options = sf_check_options_default();
    options.width = width;
    options.height = height;
    if (count == 2) {
        sf_rule octagon = {.kind = SF_RULE_OCTAGON, .reach_x_q24 = 1 << 24, .reach_y_q24 = 1 << 24};
        options.rule = octagon;
    }
    size_t size = 0;
    sf_checker *checker = NULL;
    sf_check_report report;
    if (sf_checker_size(&options, &size) != SF_OK) {
        return 3;
    }
    unsigned char *memory = malloc(size + 64);
    if (memory == NULL || sf_checker_place(&options, memory + (64 - (uintptr_t)memory % 64) % 64,
                                           size, &checker) != SF_OK) {
        return 4;
    }
    runs layer = {NULL, 0, 0};
    for (uint32_t k = 0; k < layers; k++) {
        read_layer(file, height, &layer);
        if (sf_checker_push_runs(checker, layer.runs, layer.count) != SF_OK) {
            return 3;
        }
    }
    if (sf_checker_report(checker, &report, NULL) != SF_OK) {
        return 3;
    }
    printf("layers %u\nbed %u\nsolid %llu\nunsupported %llu\n%s\n", report.layer_count,
           report.bed_layer, (unsigned long long)report.solid_voxels,
           (unsigned long long)report.unsupported_voxels,
           report.support_free ? "support-free" : "not support-free");
    free(layer.runs);
    free(memory);
    fclose(file);
    return 0;
}
