// SPDX-License-Identifier: MIT
// Why: 3MF files are for other programs, most of which read them by lib3mf. What libsf writes opens
// there without a warning, with the same counts, volume and materials. Guards: issue 8 part 1.
//
// lib3mf 1 is a library of C functions whose headers are C++, so this test is C++.

#include <sf/threemf.h>

#include <Model/COM/NMR_DLLInterfaces.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

using namespace NMR;

namespace {

int count, failures;

void check(bool good, const char *what)
{
    failures += !good;
    std::printf("%s %d - %s\n", good ? "ok" : "not ok", ++count, what);
}

sf_status put(void *user, const void *data, size_t size)
{
    static_cast<std::string *>(user)->append(static_cast<const char *>(data), size);
    return SF_OK;
}

// A torus, with a colour for each corner or one of two materials for each triangle.
struct torus {
    std::vector<double> vertices;
    std::vector<uint32_t> triangles, colours;
};

torus make_torus(bool with_materials)
{
    const uint32_t around = 48, across = 24;
    torus t;
    for (uint32_t i = 0; i < around * across; i++) {
        double u = 6.283185307179586 * (i / across) / around;
        double v = 6.283185307179586 * (i % across) / across;
        t.vertices.push_back((10 + 3 * std::cos(v)) * std::cos(u));
        t.vertices.push_back((10 + 3 * std::cos(v)) * std::sin(u));
        t.vertices.push_back(3 * std::sin(v) + 4);
    }
    for (uint32_t i = 0; i < around; i++) {
        for (uint32_t k = 0; k < across; k++) {
            uint32_t next = (i + 1) % around, up = (k + 1) % across;
            uint32_t a = i * across + k, b = next * across + k, c = next * across + up;
            uint32_t d = i * across + up;
            const uint32_t corners[6] = {a, b, c, a, c, d};
            t.triangles.insert(t.triangles.end(), corners, corners + 6);
        }
    }
    for (uint32_t i = 0; i < t.triangles.size(); i++) {
        t.colours.push_back(with_materials ? i / 300 % 2 : 2 + i % 3);
    }
    return t;
}

sf_mesh_view view_of(const torus &t)
{
    sf_mesh_view view = {t.vertices.data(), t.vertices.size() / 3, t.triangles.data(),
                         t.triangles.size() / 3};
    return view;
}

double volume_of(sf_mesh_view view)
{
    sf_mass mass;
    return sf_mesh_measure(view, &mass) == SF_OK ? mass.volume_mm3 : -1;
}

// Volume of all mesh objects, as lib3mf has them; its numbers are floats.
double volume_of(PLib3MFModelMeshObject *mesh)
{
    DWORD triangles = 0;
    double volume = 0;
    lib3mf_meshobject_gettrianglecount(mesh, &triangles);
    for (DWORD i = 0; i < triangles; i++) {
        MODELMESHTRIANGLE t;
        MODELMESHVERTEX p[3];
        lib3mf_meshobject_gettriangle(mesh, i, &t);
        for (int k = 0; k < 3; k++) {
            lib3mf_meshobject_getvertex(mesh, t.m_nIndices[k], &p[k]);
        }
        const float *a = p[0].m_fPosition, *b = p[1].m_fPosition, *c = p[2].m_fPosition;
        volume += (double(a[0]) * (double(b[1]) * c[2] - double(b[2]) * c[1]) +
                   double(a[1]) * (double(b[2]) * c[0] - double(b[0]) * c[2]) +
                   double(a[2]) * (double(b[0]) * c[1] - double(b[1]) * c[0])) /
                  6;
    }
    return volume;
}

struct found {
    bool opened;
    DWORD warnings;
    int objects;
    double volume;
};

found read_by_lib3mf(const char *path)
{
    found f = {false, 0, 0, 0};
    PLib3MFModel *model = nullptr;
    PLib3MFModelReader *reader = nullptr;
    PLib3MFModelResourceIterator *meshes = nullptr;
    BOOL more = 0;
    if (lib3mf_createmodel(&model) != 0 || lib3mf_model_queryreader(model, "3mf", &reader) != 0) {
        return f;
    }
    f.opened = lib3mf_reader_readfromfileutf8(reader, path) == 0;
    lib3mf_reader_getwarningcount(reader, &f.warnings);
    if (f.opened && lib3mf_model_getmeshobjects(model, &meshes) == 0) {
        while (lib3mf_resourceiterator_movenext(meshes, &more) == 0 && more) {
            PLib3MFModelResource *resource = nullptr;
            lib3mf_resourceiterator_getcurrent(meshes, &resource);
            f.volume += volume_of(static_cast<PLib3MFModelMeshObject *>(resource));
            f.objects++;
            lib3mf_release(resource);
        }
        lib3mf_release(meshes);
    }
    lib3mf_release(reader);
    lib3mf_release(model);
    return f;
}

bool save(const char *path, const std::string &bytes)
{
    std::FILE *file = std::fopen(path, "wb");
    bool good = file != nullptr && std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
    return file != nullptr && std::fclose(file) == 0 && good;
}

void opens_what_is_written(const char *path)
{
    torus materials = make_torus(true), colours = make_torus(false);
    const sf_threemf_colour table[5] = {{"hard & <fast>", {10, 20, 30, 255}, 0},
                                        {"soft", {200, 100, 50, 255}, 0},
                                        {"", {255, 0, 0, 255}, 1},
                                        {"", {0, 255, 0, 255}, 1},
                                        {"", {0, 0, 255, 128}, 1}};
    const sf_threemf_object objects[2] = {
        {"one", SF_THREEMF_MODEL, view_of(materials), materials.colours.data(), SF_THREEMF_NONE, 0},
        {"two", SF_THREEMF_MODEL, view_of(colours), colours.colours.data(), SF_THREEMF_NONE, 0}};
    const sf_threemf_item items[2] = {{0, {{1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 0, 0}}},
                                      {1, {{1, 0, 0, 0, 1, 0, 0, 0, 1}, {40, 0, 0}}}};
    const sf_threemf_view view = {table, 5, objects, 2, items, 2, 0};
    std::string bytes;
    sf_sink sink = {put, &bytes};
    check(sf_threemf_write(&view, nullptr, sink, nullptr, nullptr, nullptr) == SF_OK &&
              save(path, bytes),
          "a file with materials and colours is written");
    found f = read_by_lib3mf(path);
    check(f.opened && f.warnings == 0, "lib3mf opens it without a warning");
    check(f.objects == 2, "with its objects");
    double expected = 2 * volume_of(objects[0].mesh);
    std::printf("# %.6f mm3 by lib3mf, %.6f here\n", f.volume, expected);
    check(std::fabs(f.volume - expected) < 1e-5 * expected, "and their volume");
    bytes.clear();
    check(sf_mesh_write(objects[0].mesh, SF_MESH_FORMAT_THREEMF, sink) == SF_OK &&
              save(path, bytes) && read_by_lib3mf(path).warnings == 0,
          "so it does a single mesh");
    std::remove(path);
}

// Files of other programs have the same volume to both readers.
void agrees_on_the_files_of_others()
{
    const char *names[] = {"dodeca_chain_loop_color", "pyramid_vertexcolor", "heartgears"};
    const char *data = std::getenv("SF_DATA");
    if (data == nullptr) {
        std::printf("ok %d - files of others # SKIP SF_DATA names no folder\n", ++count);
        return;
    }
    for (const char *name : names) {
        std::string path = std::string(data) + "/3mf/" + name + ".3mf";
        sf_file *file = nullptr;
        sf_mesh *mesh = nullptr;
        bool good = sf_file_open(path.c_str(), nullptr, &file, nullptr) == SF_OK &&
                    sf_mesh_read(sf_file_source(file), SF_MESH_FORMAT_AUTO, nullptr, nullptr, &mesh,
                                 nullptr) == SF_OK;
        sf_file_close(file);
        double here = volume_of(sf_mesh_get_view(mesh)),
               there = read_by_lib3mf(path.c_str()).volume;
        std::printf("# %s: %.6f mm3 by lib3mf, %.6f here\n", name, there, here);
        check(good && std::fabs(here - there) < 1e-5 * here, name);
        sf_mesh_destroy(mesh);
    }
}

} // namespace

int main()
{
    if (!sf_threemf_is_served()) {
        std::printf("1..0 # SKIP this build has no 3MF\n");
        return 0;
    }
    std::string path = "threemf_lib3mf_" + std::to_string(std::rand()) + ".3mf";
    opens_what_is_written(path.c_str());
    agrees_on_the_files_of_others();
    std::printf("1..%d\n", count);
    return failures > 0;
}
