// SPDX-License-Identifier: MIT
// Fuzz target: any bytes, as stack.json and as the pictures of a stack.
//
// The first byte chooses: the bytes are the document of a stack with good PBM pictures, or the PNG
// or the PBM pictures of a stack with a good document. A valid grid comes out, or a refusal with a
// sentence.

#include "target.h"

typedef struct files {
    const uint8_t *document, *picture;
    size_t document_size, picture_size;
    sf_memory_cursor open;
} files;

static const char good_png[] =
    "{\"format\":\"libsf-stack\",\"version\":1,\"units\":\"mm\",\"lattice\":{\"nx\":13,\"ny\":5,"
    "\"nz\":2,"
    "\"pitch_mm\":[0.1,0.2],\"layer_mm\":0.3,\"origin_mm\":[1,-2,3.5]},\"rule\":null,\"layers\":{"
    "\"pattern\":\"layer_%05u.png\",\"count\":2},\"solid\":\"white\",\"row_order\":\"top_is_max_"
    "y\"}";
static const char good_pbm[] =
    "{\"format\":\"libsf-stack\",\"version\":1,\"units\":\"mm\",\"lattice\":{\"nx\":13,\"ny\":5,"
    "\"nz\":2,"
    "\"pitch_mm\":[0.1,0.2],\"layer_mm\":0.3,\"origin_mm\":[1,-2,3.5]},\"rule\":null,\"layers\":{"
    "\"pattern\":\"layer_%05u.pbm\",\"count\":2},\"solid\":\"white\",\"row_order\":\"top_is_max_"
    "y\"}";
static const char good_picture[] = "P4\n13 5\n0123456789";

static sf_status open_file(void *user, const char *name, sf_source *source)
{
    files *f = user;
    int document = strcmp(name, "stack.json") == 0;
    if (!document && strcmp(name, "layer_00000.png") != 0 && strcmp(name, "layer_00001.png") != 0 &&
        strcmp(name, "layer_00000.pbm") != 0 && strcmp(name, "layer_00001.pbm") != 0) {
        return SF_ERR_IO;
    }
    sf_memory_cursor cursor = {document ? f->document : f->picture,
                               document ? f->document_size : f->picture_size, 0};
    f->open = cursor;
    *source = sf_memory_source(&f->open);
    return SF_OK;
}

static void close_file(void *user, sf_source source)
{
    (void)user;
    (void)source;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    if (size == 0) {
        return 0;
    }
    const char *good = data[0] % 3 == 1 ? good_png : good_pbm;
    files f = {(const uint8_t *)good, data + 1, strlen(good), size - 1, {NULL, 0, 0}};
    if (data[0] % 3 == 0) {
        f.document = data + 1;
        f.document_size = size - 1;
        f.picture = (const uint8_t *)good_picture;
        f.picture_size = sizeof good_picture - 1;
    }
    sf_folder folder = {open_file, close_file, NULL, NULL, &f};
    sf_grid *grid = NULL;
    sf_stack_info info;
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_status status = sf_stack_read(folder, NULL, NULL, &grid, &info, &fault);
    must((status == SF_OK) == (grid != NULL), "a grid exactly on success");
    must(status == SF_OK || (fault.status == status && fault.message[0] != '\0'), "a sentence");
    if (grid != NULL) {
        sf_lattice lattice = sf_grid_lattice(grid);
        must(sf_lattice_validate(&lattice) == SF_OK, "what was read is valid");
        must(sf_grid_popcount(grid) <= (uint64_t)lattice.nx * lattice.ny * lattice.nz,
             "nothing stands past the width");
        sf_grid_destroy(grid);
    }
    return 0;
}
