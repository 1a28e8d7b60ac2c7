// SPDX-License-Identifier: MIT
// Runs a fuzz target over files, without an engine: the corpus and the crashers of the project in
// its normal tests, with any compiler; and what AFL++ hands over as a file.
//
// usage: TARGET FILE-OR-FOLDER...
//        TARGET --random SEED COUNT          inputs of random bytes instead
//        TARGET --spoil FILE-OR-FOLDER...    each file cut at every byte, with every bit turned,
//        and
//                                            with 00, 7f, 80 and ff in every place
// FUZZ_SAY=1 names each input before it runs. Speaks TAP; what breaks ends the program.

#include "target.h"

#include <dirent.h>
#include <sys/stat.h>
#include <time.h>

// Seconds of the processor that a spoilt file may take.
#define SLOW 0.05

static size_t runs;

static int spoils;
static double longest; // run of all, in seconds of the processor

static void run(const uint8_t *bytes, size_t size)
{
    uint8_t *exact = malloc(size > 0 ? size : 1); // so that a sanitizer sees its end
    memcpy(exact, bytes, size);
    clock_t before = clock();
    (void)LLVMFuzzerTestOneInput(exact, size);
    double took = (double)(clock() - before) / CLOCKS_PER_SEC;
    free(exact);
    runs++;
    longest = took > longest ? took : longest;
}

static void run_spoilt(uint8_t *bytes, size_t size)
{
    static const uint8_t odd[4] = {0x00, 0x7f, 0x80, 0xff};
    for (size_t i = 0; i < size; i++) {
        uint8_t good = bytes[i];
        run(bytes, i);
        for (int bit = 0; bit < 8; bit++) {
            bytes[i] = (uint8_t)(good ^ 1u << bit);
            run(bytes, size);
        }
        for (int j = 0; j < 4; j++) {
            bytes[i] = odd[j];
            run(bytes, size);
        }
        bytes[i] = good;
    }
}

static void run_file(const char *path)
{
    FILE *file = fopen(path, "rb");
    if (file == NULL) {
        perror(path);
        exit(2);
    }
    size_t size = 0, capacity = 0;
    uint8_t *bytes = NULL;
    for (size_t got = 1; got > 0; size += got) {
        if (capacity - size < 4096) {
            capacity = 2 * capacity + 8192;
            bytes = realloc(bytes, capacity);
        }
        got = fread(bytes + size, 1, capacity - size, file);
    }
    fclose(file);
    if (getenv("FUZZ_SAY") != NULL) {
        fprintf(stderr, "%s\n", path);
    }
    run(bytes, size);
    if (spoils) {
        run_spoilt(bytes, size);
    }
    free(bytes);
}

static void run_path(const char *path)
{
    struct stat facts;
    if (stat(path, &facts) == 0 && !S_ISDIR(facts.st_mode)) {
        run_file(path);
        return;
    }
    DIR *folder = opendir(path);
    if (folder == NULL) {
        return; // no crashers yet
    }
    for (const struct dirent *entry; (entry = readdir(folder)) != NULL;) {
        char name[4096];
        if (entry->d_name[0] != '.') {
            snprintf(name, sizeof name, "%s/%s", path, entry->d_name);
            run_file(name);
        }
    }
    closedir(folder);
}

// splitmix64 (Steele, Lea, Flood, 2014)
static uint64_t next(uint64_t *state)
{
    uint64_t z = (*state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

static void run_random(uint64_t seed, unsigned long count)
{
    uint8_t bytes[1024];
    for (unsigned long i = 0; i < count; i++) {
        uint64_t state = seed + i;
        size_t size = next(&state) % sizeof bytes;
        for (size_t j = 0; j < size; j++) {
            bytes[j] = (uint8_t)next(&state);
        }
        if (getenv("FUZZ_SAY") != NULL) {
            fprintf(stderr, "seed %llu\n", (unsigned long long)(seed + i));
        }
        run(bytes, size);
    }
}

int main(int argc, char **argv)
{
    if (argc == 4 && strcmp(argv[1], "--random") == 0) {
        run_random(strtoull(argv[2], NULL, 10), strtoul(argv[3], NULL, 10));
    } else {
        spoils = argc > 1 && strcmp(argv[1], "--spoil") == 0;
        for (int i = 1 + spoils; i < argc; i++) {
            run_path(argv[i]);
        }
    }
    printf("# the longest took %.1f ms of the processor\n", 1e3 * longest);
    printf("%s 1 - %zu inputs, none of which breaks anything\n", runs > 0 ? "ok" : "not ok", runs);
    int slow = spoils && longest > SLOW;
    if (spoils) {
        printf("%s 2 - each is done with in time\n", slow ? "not ok" : "ok");
    }
    printf("1..%d\n", 1 + spoils);
    return runs == 0 || slow;
}
