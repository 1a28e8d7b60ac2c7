// SPDX-License-Identifier: MIT
// Makes what fuzz targets begin with: for each of them a folder of small inputs, the good files
// that the library's own writers make, and for the targets api and chip strings of bytes.
//
// usage: fuzz-make-seeds FOLDER

#include "world.h"

#include <sf/contour_io.h>
#include <sf/gltf.h>
#include <sf/job.h>
#include <sf/threemf.h>

#include <errno.h>
#include <sys/stat.h>

static char root[3000];

static void fail(const char *what)
{
    perror(what);
    exit(1);
}

static void save(const char *target, const char *name, const void *bytes, size_t size)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/%s", root, target);
    if (mkdir(path, 0777) != 0 && errno != EEXIST) {
        fail(path);
    }
    snprintf(path, sizeof path, "%s/%s/%s", root, target, name);
    FILE *file = fopen(path, "wb");
    if (file == NULL || (size > 0 && fwrite(bytes, 1, size, file) != size) || fclose(file) != 0) {
        fail(path);
    }
}

typedef struct bytes {
    unsigned char *data;
    size_t size;
} bytes;

static sf_status gather(void *user, const void *data, size_t size)
{
    bytes *b = user;
    b->data = realloc(b->data, b->size + size + 1);
    memcpy(b->data + b->size, data, size);
    b->size += size;
    return SF_OK;
}

static void save_good(sf_status status, const char *target, const char *name, bytes *b)
{
    if (status != SF_OK) {
        fprintf(stderr, "%s/%s: %s\n", target, name, sf_status_name(status));
        exit(1);
    }
    save(target, name, b->data, b->size);
    free(b->data);
}

// The kind is one that the world can make; another seed of bytes makes another object.
static void *make(world *w, const char *kind, uint32_t seed)
{
    static uint8_t entropy[256]; // it is drawn from until the world ends
    for (uint32_t i = 0; i < sizeof entropy; i++) {
        entropy[i] = (uint8_t)((i * 2654435761u + seed * 40503u) >> 13);
    }
    world_begin(w, entropy, sizeof entropy, 1);
    void *object = world_need(w, kind);
    if (object == NULL) {
        fprintf(stderr, "no %s comes of seed %u\n", kind, seed);
        exit(1);
    }
    return object;
}

static void save_meshes(world *w, uint32_t seed)
{
    static const char *const names[] = {"", "stl", "obj", "ply"};
    for (int format = SF_MESH_FORMAT_STL; format <= SF_MESH_FORMAT_PLY; format++) {
        bytes b = {NULL, 0};
        char name[64];
        sf_sink sink = {gather, &b};
        const sf_mesh *mesh = make(w, "sf_mesh", seed);
        sf_status status = sf_mesh_write(sf_mesh_get_view(mesh), (sf_mesh_format)format, sink);
        snprintf(name, sizeof name, "%u.%s", seed, names[format]);
        save_good(status, "mesh_read", name, &b);
        world_end(w);
    }
}

static void save_scene(world *w, uint32_t seed)
{
    bytes b = {NULL, 0};
    char name[64];
    sf_sink sink = {gather, &b};
    const sf_mesh *mesh = make(w, "sf_mesh", seed);
    snprintf(name, sizeof name, "%u.glb", seed);
    save_good(sf_gltf_write(sf_mesh_get_view(mesh), NULL, sink), "gltf_read", name, &b);
    world_end(w);
}

static void save_package(world *w, uint32_t seed)
{
    bytes b = {NULL, 0};
    char name[64];
    sf_sink sink = {gather, &b};
    const sf_mesh *mesh = make(w, "sf_mesh", seed);
    snprintf(name, sizeof name, "%u.3mf", seed);
    if (sf_threemf_is_served()) {
        save_good(sf_mesh_write(sf_mesh_get_view(mesh), SF_MESH_FORMAT_THREEMF, sink),
                  "threemf_read", name, &b);
    }
    world_end(w);
}

// Jobs of either format, with the byte in front that the target takes its threshold from.
static void save_jobs(world *w, uint32_t seed)
{
    bytes b = {NULL, 0};
    char name[64];
    sf_sink sink = {gather, &b};
    const sf_grid *grid = make(w, "sf_grid", seed);
    snprintf(name, sizeof name, "%u.sl1", seed);
    if (sf_job_has_sl1() && gather(&b, "\x7e", 1) == SF_OK) {
        sf_status status = sf_sl1_write(grid, NULL, NULL, sink, NULL, NULL);
        if (status == SF_ERR_UNSUPPORTED) { // layers of several heights
            free(b.data);
        } else {
            save_good(status, "job_read", name, &b);
        }
    }
    world_end(w);
}

// Two pixels by two, in two layers: the first all white, the second half.
static void save_photon(void)
{
    static unsigned char job[1 + 112 + 72 + 3] = {0x7e, 0x19, 0x00, 0xfd, 0x12, 1};
    static const unsigned char floats[3][4] = {
        {0, 0, 0x80, 0x3f}, {0, 0, 0x80, 0x3f}, {0, 0, 0, 0x3f}};
    unsigned char *head = job + 1, *table = head + 112;
    memcpy(head + 8, floats[0], 4);
    memcpy(head + 12, floats[1], 4);
    memcpy(head + 0x20, floats[2], 4);
    head[0x34] = head[0x38] = 2;
    head[0x40] = 112;
    head[0x44] = 2;
    memcpy(table + 36, floats[2], 4);
    table[12] = 112 + 72;
    table[16] = 1;
    table[36 + 12] = 112 + 73;
    table[36 + 16] = 2;
    job[1 + 112 + 72] = 0x80 | 4;
    job[1 + 112 + 73] = 2;
    job[1 + 112 + 74] = 0x80 | 2;
    save("job_read", "photon", job, sizeof job);
}

static void save_contours(world *w, uint32_t seed)
{
    for (int format = 0; format < 2; format++) {
        bytes b = {NULL, 0};
        char name[64];
        sf_sink sink = {gather, &b};
        const sf_contour_stack *stack = make(w, "sf_contour_stack", seed);
        snprintf(name, sizeof name, "%u-%s.cli", seed, format == 0 ? "text" : "binary");
        save_good(sf_contour_stack_write(stack, (sf_contour_format)format, sink), "contours_read",
                  name, &b);
        world_end(w);
    }
}

// A model with something of everything that is read, and a part that it names.
static void save_model(void)
{
#define MODEL_XML                                                                                  \
    "<model xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" "                  \
    "xmlns:m=\"http://schemas.microsoft.com/3dmanufacturing/material/2015/02\" "                   \
    "xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\" "                 \
    "xmlns:s=\"http://schemas.microsoft.com/3dmanufacturing/slice/2015/07\" "
    static const char model[] = MODEL_XML
        "requiredextensions=\"p s\" unit=\"inch\"><resources><basematerials id=\"4\"><base "
        "name=\"a\" displaycolor=\"#010203\"/></basematerials><m:colorgroup id=\"5\"><m:color "
        "color=\"#FF000080\"/></m:colorgroup><s:slicestack id=\"3\"><s:sliceref "
        "slicestackid=\"1\" slicepath=\"/2D/a.model\"/></s:slicestack><object id=\"1\" pid=\"4\" "
        "pindex=\"0\" s:slicestackid=\"3\"><mesh><vertices><vertex x=\"0\" y=\"0\" "
        "z=\"0\"/><vertex x=\"1\" y=\"0\" z=\"0\"/><vertex x=\"0\" y=\"1\" z=\"0\"/>"
        "</vertices><triangles><triangle v1=\"0\" v2=\"1\" v3=\"2\" pid=\"5\" p1=\"0\" "
        "p2=\"0\"/></triangles></mesh></object><object id=\"2\"><components><component "
        "objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 5 0 0\"/></components></object>"
        "</resources><build><item objectid=\"2\"/><item objectid=\"1\"/></build></model>";
    static const char slices[] = MODEL_XML
        "><resources><s:slicestack id=\"1\" zbottom=\"0\"><s:slice ztop=\"1\"><s:vertices>"
        "<s:vertex x=\"0\" y=\"0\"/><s:vertex x=\"1\" y=\"0\"/><s:vertex x=\"0\" y=\"1\"/>"
        "</s:vertices><s:polygon startv=\"0\"><s:segment v2=\"1\"/><s:segment v2=\"2\"/>"
        "<s:segment v2=\"0\"/></s:polygon></s:slice><s:slice ztop=\"2\"/></s:slicestack>"
        "</resources></model>";
    static char both[sizeof model + sizeof slices];
    memcpy(both, model, sizeof model); // and the zero between them
    memcpy(both + sizeof model, slices, sizeof slices - 1);
    save("threemf_read", "model", both, sizeof model + sizeof slices - 1);
}

static void save_cages(world *w, uint32_t seed)
{
    for (int binary = 0; binary < 2; binary++) {
        bytes b = {NULL, 0};
        char name[64];
        sf_sink sink = {gather, &b};
        sf_cage_view view = sf_cage_get_view(make(w, "sf_cage", seed));
        snprintf(name, sizeof name, "%u-%s.vtk", seed, binary ? "binary" : "text");
        save_good(sf_cage_write_vtk(&view, binary, NULL, sink, NULL), "cage_read", name, &b);
        world_end(w);
    }
}

static void save_session(world *w, uint32_t seed)
{
    bytes b = {NULL, 0};
    char name[64];
    sf_sink sink = {gather, &b};
    snprintf(name, sizeof name, "%u.session", seed);
    save_good(sf_session_write(make(w, "sf_session", seed), sink), "session_read", name, &b);
    world_end(w);
}

static void save_words(void)
{
    static const char cube[] =
        "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
        "vertex 0 1 0\nendloop\nendfacet\nendsolid a\n";
    static const char off[] = "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n4 0 1 2 3\n";
    static const char medit[] =
        "MeshVersionFormatted 2\nDimension 3\nVertices\n4\n0 0 0 0\n1 0 0 0\n"
        "0 1 0 0\n0 0 1 0\nTetrahedra\n1\n1 2 3 4 7\nEnd\n";
    static const char mfem[] = "MFEM mesh v1.0\n\ndimension\n3\n\nelements\n1\n1 4 0 1 2 3\n\n"
                               "boundary\n0\n\nvertices\n4\n3\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
    static const char document[] =
        "{\"format\":\"libsf-stack\",\"version\":1,\"units\":\"mm\",\"lattice\":{\"nx\":13,\"ny\":"
        "5,"
        "\"nz\":2,\"pitch_mm\":[0.1,0.2],\"layer_mm\":0.3,\"origin_mm\":[1,-2,3.5]},\"rule\":null,"
        "\"layers\":{\"pattern\":\"layer_%05u.pbm\",\"count\":2},\"solid\":\"white\","
        "\"row_order\":\"top_is_max_y\"}";
    static const char picture[] = "\2P4\n13 5\n0123456789";
    char first[sizeof document] = "";
    memcpy(first + 1, document, sizeof document - 1);
    save("mesh_read", "text.stl", cube, sizeof cube - 1);
    save("mesh_read", "text.off", off, sizeof off - 1);
    save("cage_read", "one.mesh", medit, sizeof medit - 1);
    save("cage_read", "one.mfem", mfem, sizeof mfem - 1);
    save("stack_read", "document", first, sizeof document);
    save("stack_read", "pbm", picture, sizeof picture - 1);
}

// Strings of bytes in which every function is chosen; the engine finds better ones.
static void save_calls(void)
{
    static const char *const called[] = {
        "api",          "calls_balance", "calls_grade", "calls_io", "calls_mesh",
        "calls_sculpt", "calls_support", "calls_voxel", "chip",     "ops"};
    uint8_t string[400];
    for (uint32_t i = 0; i < 16; i++) {
        uint64_t state = 0x9e3779b97f4a7c15u * (i + 1);
        char name[32];
        for (size_t j = 0; j < sizeof string; j++) {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            string[j] = (uint8_t)(state >> 24);
        }
        snprintf(name, sizeof name, "%02u", i);
        for (size_t j = 0; j < sizeof called / sizeof *called; j++) {
            save(called[j], name, string, sizeof string);
        }
    }
}

int main(int argc, char **argv)
{
    if (argc != 2 || strlen(argv[1]) >= sizeof root) {
        fprintf(stderr, "usage: fuzz-make-seeds FOLDER\n");
        return 2;
    }
    strcpy(root, argv[1]);
    if (mkdir(root, 0777) != 0 && errno != EEXIST) {
        fail(root);
    }
    world *w = calloc(1, sizeof *w);
    for (uint32_t seed = 1; seed <= 3; seed++) {
        save_meshes(w, seed);
        save_scene(w, seed);
        save_package(w, seed);
        save_cages(w, seed);
        save_session(w, seed);
        save_jobs(w, seed);
        save_contours(w, seed);
    }
    save_model();
    save_photon();
    save_words();
    save_calls();
    free(w);
    return 0;
}
