// SPDX-License-Identifier: MIT
// sf-chip: what the firmware's author needs on a desk.
//
//     sf-chip table [options]   the rule as a table in C, to be compiled into the firmware
//     sf-chip pack LAYERS JOB   a stack of pictures that sf wrote, as a job of the example firmware
//
// The table is made by the library, so what the chip asks is what `sf check` asks.

#include <sf/io.h>
#include <sf/sf.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char help[] =
    "sf-chip: does a job print without supports, asked by the printer itself\n\n"
    "usage: sf-chip table [--rule box3|octagon|disk] [--angle DEGREES] [--pitch X[,Y]]\n"
    "                     [--height MM] [--layers N] [--size W,H] [--runs N]\n"
    "       sf-chip pack LAYERS JOB\n\n"
    "table prints a header in C: the rule as constants, and how much memory the checker takes\n"
    "  --rule     octagon (default), box3 (takes no angle), or disk\n"
    "  --angle    overhang that prints, from the vertical, 5 to 85 (default 45)\n"
    "  --pitch    size of a pixel in mm (default 0.05)\n"
    "  --height   of a layer, in mm (default 0.05)\n"
    "  --layers   most layers that a job has (default 4000)\n"
    "  --size     pixels of a layer (default 2560,1440)\n"
    "  --runs     most runs of a layer, for the run-length checker (default 3000)\n"
    "pack writes a stack of pictures, such as sf slice makes, as a job\n\n"
    "examples:\n"
    "  sf-chip table --angle 50 --pitch 0.035 --height 0.05 > table.h\n"
    "  sf-chip pack layers part.job\n\n"
    "status: 0 good, 2 usage, 3 bad input, 4 memory or disk\n";

// ---------------------------------------------------------------------------------------------
// table
// ---------------------------------------------------------------------------------------------

typedef struct settings {
    sf_rule_kind kind;
    double angle, pitch_x, pitch_y, height;
    unsigned long layers, width, rows, runs;
} settings;

static int read_numbers(const char *text, double *a, double *b)
{
    char *end;
    *a = *b = strtod(text, &end);
    if (end != text && *end == ',') {
        const char *second = end + 1;
        *b = strtod(second, &end);
        return end != second && *end == '\0';
    }
    return end != text && *end == '\0';
}

static int read_option(settings *s, const char *name, const char *value)
{
    double a = 0, b = 0;
    if (strcmp(name, "--rule") == 0) {
        return sf_rule_kind_from_name(value, &s->kind) == SF_OK;
    }
    if (!read_numbers(value, &a, &b)) {
        return 0;
    }
    int is_count = a >= 1 && b >= 1 && a <= 1e9 && b <= 1e9;
    if (strcmp(name, "--angle") == 0) {
        s->angle = a;
    } else if (strcmp(name, "--pitch") == 0) {
        s->pitch_x = a;
        s->pitch_y = b;
    } else if (strcmp(name, "--height") == 0) {
        s->height = a;
    } else if (strcmp(name, "--layers") == 0 && is_count) {
        s->layers = (unsigned long)a;
    } else if (strcmp(name, "--size") == 0 && is_count) {
        s->width = (unsigned long)a;
        s->rows = (unsigned long)b;
    } else if (strcmp(name, "--runs") == 0 && is_count) {
        s->runs = (unsigned long)a;
    } else {
        return 0;
    }
    return 1;
}

static void print_bytes(const char *name, const uint8_t *bytes, size_t count)
{
    printf("static const uint8_t %s[%zu] = {", name, count);
    for (size_t i = 0; i < count; i++) {
        printf("%s%u,", i % 24 == 0 ? "\n    " : " ", bytes[i]);
    }
    printf("\n};\n\n");
}

static void print_memory(const settings *s, const sf_chip_rule *rule)
{
    sf_chip_options options = sf_chip_options_default();
    size_t size = 0;
    options.rule = *rule;
    options.width = (uint32_t)s->width;
    options.height = (uint32_t)s->rows;
    if (sf_chip_size(&options, &size) == SF_OK) {
        printf("// Memory of a dense checker of %lu x %lu pixels, in bytes.\n", s->width, s->rows);
        printf("#define TABLE_DENSE_MEMORY %zuu\n\n", size);
    }
    options.run_capacity = (uint32_t)s->runs;
    if (sf_chip_size(&options, &size) == SF_OK) {
        printf("// Runs of a layer, and memory of a run-length checker for them, in bytes.\n");
        printf("#define TABLE_RUNS %luu\n#define TABLE_RUNS_MEMORY %zuu\n\n", s->runs, size);
    }
}

static void print_table(const settings *s, const sf_chip_rule *rule)
{
    printf("// Made by sf-chip table: rule %s", sf_rule_kind_name(s->kind));
    if (s->kind != SF_RULE_BOX3) {
        printf(", %g degrees, pixels of %g x %g mm, layers of %g mm", s->angle, s->pitch_x,
               s->pitch_y, s->height);
    }
    printf(", up to %lu layers.\n\n", s->layers);
    printf("#ifndef TABLE_H\n#define TABLE_H\n\n#include <sf/chip.h>\n\n");
    print_memory(s, rule);
    print_bytes("table_elements", rule->elements, rule->element_count * (rule->reach + (size_t)2));
    if (rule->steps != NULL) {
        print_bytes("table_steps", rule->steps, rule->step_count);
    }
    printf("static const sf_chip_rule table = {table_elements, %s, %luu, 0, %u, %u};\n\n#endif\n",
           rule->steps != NULL ? "table_steps" : "NULL", (unsigned long)rule->step_count,
           rule->element_count, rule->reach);
}

static int make_table(const settings *s)
{
    sf_lattice lattice = {(uint32_t)s->width,
                          (uint32_t)s->rows,
                          (uint32_t)s->layers,
                          s->pitch_x,
                          s->pitch_y,
                          s->height,
                          NULL,
                          {0, 0, 0}};
    sf_rule rule;
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_chip_rule table;
    size_t size = 0;
    sf_status status =
        sf_rule_make(s->kind, s->angle * 0.017453292519943295, &lattice, NULL, &rule, &fault);
    if (status != SF_OK) {
        fprintf(stderr, "sf-chip: %s\n",
                fault.message[0] != '\0' ? fault.message : sf_status_message(status));
        return 2;
    }
    // Without memory it says how much it takes.
    status = sf_chip_rule_make(&rule, 0, lattice.nz, NULL, 0, &size, &table);
    uint8_t *memory = status == SF_ERR_CAPACITY ? malloc(size) : NULL;
    if (memory != NULL) {
        status = sf_chip_rule_make(&rule, 0, lattice.nz, memory, size, &size, &table);
    }
    if (status == SF_OK) {
        print_table(s, &table);
    } else if (status == SF_ERR_UNSUPPORTED) {
        fprintf(stderr,
                "sf-chip: %s is more than an element for each step, which is all that a "
                "chip knows; take octagon, box3 or disk\n",
                sf_rule_kind_name(s->kind));
    } else {
        fprintf(stderr, "sf-chip: no table: %s\n", sf_status_message(status));
    }
    free(memory);
    return status == SF_OK ? fflush(stdout) == 0 ? 0 : 4 : status == SF_ERR_UNSUPPORTED ? 2 : 4;
}

static int run_table(int count, char **words)
{
    settings s = {SF_RULE_OCTAGON, 45, 0.05, 0.05, 0.05, 4000, 2560, 1440, 3000};
    for (int i = 0; i < count; i += 2) {
        if (i + 1 == count || !read_option(&s, words[i], words[i + 1])) {
            fprintf(stderr, "sf-chip: %s%s%s is not understood; sf-chip --help has the options\n",
                    words[i], i + 1 < count ? " " : "", i + 1 < count ? words[i + 1] : "");
            return 2;
        }
    }
    return make_table(&s);
}

// ---------------------------------------------------------------------------------------------
// pack
// ---------------------------------------------------------------------------------------------

static void put_number(FILE *file, uint32_t number)
{
    for (; number > 127; number >>= 7) {
        putc((int)(number & 127) | 128, file);
    }
    putc((int)number, file);
}

// Rows of a layer; runs are in row order.
static void put_layer(FILE *file, uint32_t height, const sf_run *runs, size_t count)
{
    size_t i = 0;
    for (uint32_t y = 0; y < height; y++) {
        size_t end = i;
        while (end < count && runs[end].y == y) {
            end++;
        }
        put_number(file, (uint32_t)(end - i));
        for (uint32_t x = 0; i < end; i++) {
            put_number(file, runs[i].x0 - x);
            put_number(file, runs[i].x1 - runs[i].x0);
            x = runs[i].x1;
        }
    }
}

static int put_job(FILE *file, const sf_grid *grid)
{
    sf_lattice lattice = sf_grid_lattice(grid);
    fputs("SFJOB1\n", file);
    put_number(file, lattice.nx);
    put_number(file, lattice.ny);
    put_number(file, lattice.nz);
    for (uint32_t k = 0; k < lattice.nz; k++) {
        sf_slice slice = sf_grid_slice(grid, k);
        size_t count = 0;
        if (sf_slice_run_count(slice, &count) != SF_OK) {
            return 0;
        }
        sf_run *runs = malloc((count + 1) * sizeof *runs);
        sf_status status = runs != NULL ? sf_slice_runs(slice, runs, count, &count) : SF_ERR_MEMORY;
        if (status == SF_OK) {
            put_layer(file, lattice.ny, runs, count);
        }
        free(runs);
        if (status != SF_OK) {
            return 0;
        }
    }
    return ferror(file) == 0;
}

// The job is written beside its place and renamed, so that nobody meets half of one.
static int write_job(const char *path, const sf_grid *grid)
{
    static const char ending[] = ".sf.tmp";
    char *beside = malloc(strlen(path) + sizeof ending);
    if (beside == NULL) {
        return 0;
    }
    strcpy(beside, path);
    strcat(beside, ending);
    FILE *file = fopen(beside, "wb");
    int good = file != NULL && put_job(file, grid);
    good = file != NULL && fclose(file) == 0 && good;
    good = good && rename(beside, path) == 0;
    if (!good) {
        remove(beside);
    }
    free(beside);
    return good;
}

static int run_pack(const char *layers, const char *path)
{
    sf_directory *directory = NULL;
    sf_grid *grid = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_status status = sf_directory_read(layers, NULL, &directory, &fault);
    if (status == SF_OK) {
        status = sf_stack_read(sf_directory_folder(directory), NULL, NULL, &grid, NULL, &fault);
        sf_directory_close(directory);
    }
    if (status != SF_OK) {
        fprintf(stderr, "sf-chip: %s\n",
                fault.message[0] != '\0' ? fault.message : sf_status_message(status));
        return status == SF_ERR_MEMORY ? 4 : 3;
    }
    int good = write_job(path, grid);
    if (!good) {
        fprintf(stderr, "sf-chip: %s cannot be written; is there room, and may it be?\n", path);
    }
    sf_grid_destroy(grid);
    return good ? 0 : 4;
}

int main(int count, char **words)
{
    if (count >= 2 && strcmp(words[1], "table") == 0) {
        return run_table(count - 2, words + 2);
    }
    if (count == 4 && strcmp(words[1], "pack") == 0) {
        return run_pack(words[2], words[3]);
    }
    int asked = count == 2 && (strcmp(words[1], "--help") == 0 || strcmp(words[1], "help") == 0);
    fputs(help, asked ? stdout : stderr);
    return asked ? 0 : 2;
}
