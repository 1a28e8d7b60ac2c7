// SPDX-License-Identifier: MIT
// Certificates made, written and shown to sf-verify: as the program that people run, and as its own
// functions in this process, so that it can be asked ten thousand times.

#ifndef SF_TEST_VERIFY_VERIFIED_H
#define SF_TEST_VERIFY_VERIFIED_H

// The verifier's source as it is, but for names that tests use for something else.
#define main verifier_main
#define stack verifier_stack
#include "verify/sf_verify.c"
#undef main
#undef stack

#include "judge.h"
#include "law/stack.h"

// A rule with all that it is made of.
typedef struct made_rule {
    sf_rule rule;
    sf_stack_info info;
    uint64_t table[256];
} made_rule;

static inline sf_status make_rule(made_rule *made, const sf_lattice *lattice, sf_rule_kind kind,
                                  double degrees, double span_mm, double anchor_mm, uint32_t bed_k)
{
    made->info = stack_info(kind, degrees, bed_k);
    made->info.angle_rad = kind == SF_RULE_BOX3 ? 0.0 : made->info.angle_rad;
    made->info.bridge_span_mm = span_mm;
    made->info.bridge_anchor_mm = span_mm > 0 ? anchor_mm : 0.0;
    sf_status status =
        sf_rule_make(kind, made->info.angle_rad, lattice, made->table, &made->rule, NULL);
    return status == SF_OK ? sf_rule_set_bridges(&made->rule, span_mm, anchor_mm, lattice, NULL)
                           : status;
}

static inline sf_terms terms_of(const made_rule *made, const sf_grid *exempt)
{
    sf_terms terms = sf_terms_default();
    terms.rule = made->rule;
    terms.bed_layer = made->info.bed_layer;
    terms.exempt = exempt;
    return terms;
}

static inline sf_claim claim_of(const made_rule *made, const sf_terms *terms,
                                sf_operation operation, const sf_grid *before)
{
    sf_claim claim = sf_claim_default();
    claim.terms = terms;
    claim.angle_rad = made->info.angle_rad;
    claim.bridge_span_mm = made->info.bridge_span_mm;
    claim.bridge_anchor_mm = made->info.bridge_anchor_mm;
    claim.operation = operation;
    claim.before = before;
    return claim;
}

// Text that grows.
typedef struct text {
    char *bytes;
    size_t size, capacity;
} text;

static inline sf_status text_add(void *user, const void *data, size_t size)
{
    text *t = user;
    if (t->size + size + 1 > t->capacity) {
        t->capacity = 2 * (t->size + size + 1);
        t->bytes = realloc(t->bytes, t->capacity);
    }
    memcpy(t->bytes + t->size, data, size);
    t->size += size;
    t->bytes[t->size] = '\0';
    return SF_OK;
}

static inline text certificate_text(const sf_certificate *certificate)
{
    text t = {NULL, 0, 0};
    sf_sink sink = {text_add, &t};
    CHECK_EQ(sf_certificate_write(certificate, sink), SF_OK);
    return t;
}

static inline void text_save(const text *t, const char *path)
{
    FILE *file = fopen(path, "wb");
    CHECK(file != NULL && fwrite(t->bytes, 1, t->size, file) == t->size);
    if (file != NULL) {
        fclose(file);
    }
}

// ---------------------------------------------------------------------------------------------
// The verifier in this process
// ---------------------------------------------------------------------------------------------

static inline void forget(void)
{
    free(bits);
    free(codes);
    free(step);
    json_decref(verifier_stack);
    bits = NULL;
    codes = NULL;
    step = NULL;
    verifier_stack = heights = NULL;
}

static inline void show_stack(const char *folder)
{
    forget();
    CHECK(load(folder));
}

// A folder that keeps the document of a stack, and drops the pictures.
static inline sf_status drop(void *user, const void *data, size_t size)
{
    (void)user;
    (void)data;
    (void)size;
    return SF_OK;
}

static inline sf_status begin_file(void *user, const char *name, sf_sink *sink)
{
    sink->user = user;
    sink->write = strcmp(name, "stack.json") == 0 ? text_add : drop;
    return SF_OK;
}

static inline sf_status commit_file(void *user, int keep)
{
    (void)user;
    (void)keep;
    return SF_OK;
}

// The same voxels again, as pictures have them.
static inline void show_voxels(const sf_grid *grid)
{
    memset(bits, 0, (size_t)(layer * nz));
    for (int k = 0; k < nz; k++) {
        for (long v = 0; v < area; v++) {
            int x = (int)(v % nx), y = (int)(v / nx);
            int is = sf_slice_get(sf_grid_slice(grid, (uint32_t)k), (uint32_t)x, (uint32_t)y);
            *at(x, y, k) = (short)is;
            bits[k * layer + (ny - 1 - y) * row + x / 8] |= (unsigned char)(is << (7 - x % 8));
        }
    }
}

// What load() does of a stack that this grid is written as, without the disk.
static inline void show_grid(const sf_grid *grid, const sf_stack_info *info)
{
    text t = {NULL, 0, 0};
    sf_folder folder = {NULL, NULL, begin_file, commit_file, &t};
    sf_lattice l = sf_grid_lattice(grid);
    CHECK_EQ(sf_stack_write(grid, info, folder, NULL, NULL), SF_OK);
    forget();
    verifier_stack = json_loadb(t.bytes, t.size, 0, NULL);
    json_t *lattice = json_object_get(verifier_stack, "lattice");
    heights = json_object_get(lattice, "heights_mm");
    mm = l.layer_mm;
    pitch[0] = l.pitch_x_mm;
    pitch[1] = l.pitch_y_mm;
    nx = (int)l.nx;
    ny = (int)l.ny;
    nz = (int)l.nz;
    row = (nx + 7) / 8;
    layer = row * ny;
    area = (long)nx * ny;
    bits = calloc((size_t)layer, (size_t)nz);
    codes = calloc((size_t)area, (size_t)nz * sizeof *codes);
    step = calloc((size_t)nz + 1, sizeof *step);
    show_voxels(grid);
    free(t.bytes);
}

static inline int accepts(const text *t)
{
    for (long v = 0; v < nz * area; v++) {
        codes[v] = (short)(codes[v] != 0 ? WAITS : 0);
    }
    int good = verify(t->bytes, t->size) != 0;
    json_decref(given);
    json_decref(mine);
    json_decref(layers);
    given = mine = layers = NULL;
    return good;
}

#endif
