// SPDX-License-Identifier: MIT
// glTF by tinygltf, behind a function of C.
//
// The only file of libsf-io in C++. It lets tinygltf parse, with no way to a disk but a folder that
// the caller gave and with no picture decoded, and copies what the triangles need into plain
// arrays. Nothing is thrown past the two functions at the end, and no number is judged here:
// gltf_walk.c does that.

#include "io/gltf_model.h"

extern "C" {
#include "base/status.h"
}

#include <tiny_gltf.h>

#include <algorithm>
#include <cstring>
#include <new>
#include <string>
#include <vector>

namespace {

// What the arrays of an sfi_gltf_model lie in.
struct owner {
    tinygltf::Model model;
    std::vector<sfi_gltf_buffer> buffers;
    std::vector<sfi_gltf_view> views;
    std::vector<sfi_gltf_accessor> accessors;
    std::vector<sfi_gltf_primitive> primitives;
    std::vector<sfi_gltf_mesh> meshes;
    std::vector<sfi_gltf_node> nodes;
    std::vector<int> children, roots;
    std::vector<const char *> extensions;
};

// ---------------------------------------------------------------------------------------------
// Files and pictures
// ---------------------------------------------------------------------------------------------

bool is_plain(const std::string &name)
{
    return !name.empty() && name.find_first_of("/\\:\0", 0, 4) == std::string::npos &&
           name != "." && name != "..";
}

// Buffers and pictures are asked for in the same way; what is named as a picture is none of ours.
bool is_picture(const std::string &name)
{
    static const char *const endings[] = {".png", ".jpg", ".jpeg", ".webp", ".ktx2", ".dds"};
    for (const char *ending : endings) {
        size_t length = std::strlen(ending);
        if (name.size() >= length && name.compare(name.size() - length, length, ending) == 0) {
            return true;
        }
    }
    return false;
}

bool file_exists(const std::string &name, void *user)
{
    return static_cast<sfi_gltf_files *>(user)->folder != nullptr && is_plain(name) &&
           !is_picture(name);
}

std::string expand_nothing(const std::string &name, void *)
{
    return name;
}

bool write_nothing(std::string *, const std::string &, const std::vector<unsigned char> &, void *)
{
    return false;
}

// All of a source, within what may still be read.
sf_status read_all(sf_source source, sfi_gltf_files *files, std::vector<unsigned char> *bytes)
{
    const size_t step = 65536;
    for (size_t got = 1; got > 0;) {
        size_t have = bytes->size();
        bytes->resize(have + step);
        got = 0;
        sf_status status = source.read(source.user, bytes->data() + have, step, &got);
        bytes->resize(have + (got <= step ? got : 0));
        if (status != SF_OK || got > step) {
            return status != SF_OK ? status : SF_ERR_IO;
        }
        if (got > files->left) {
            return SF_ERR_OVERFLOW;
        }
        files->left -= got;
    }
    return SF_OK;
}

bool read_file(std::vector<unsigned char> *bytes, std::string *, const std::string &name,
               void *user)
{
    sfi_gltf_files *files = static_cast<sfi_gltf_files *>(user);
    sf_source source = {nullptr, nullptr};
    if (files->folder == nullptr || !is_plain(name)) {
        return false;
    }
    files->failure = files->folder->open(files->folder->user, name.c_str(), &source);
    if (files->failure != SF_OK) {
        return false;
    }
    try {
        files->failure = read_all(source, files, bytes);
    } catch (...) {
        files->failure = SF_ERR_MEMORY;
    }
    files->folder->close(files->folder->user, source);
    return files->failure == SF_OK;
}

bool look_at_no_picture(tinygltf::Image *, const int, std::string *, std::string *, int, int,
                        const unsigned char *, int, void *)
{
    return true;
}

// ---------------------------------------------------------------------------------------------
// Copies
// ---------------------------------------------------------------------------------------------

void copy_buffers(owner *o)
{
    for (const tinygltf::Buffer &b : o->model.buffers) {
        o->buffers.push_back({b.data.data(), b.data.size()});
    }
    for (const tinygltf::BufferView &v : o->model.bufferViews) {
        o->views.push_back({v.buffer, v.byteOffset, v.byteLength, v.byteStride});
    }
}

int width_of(int type)
{
    return type == TINYGLTF_TYPE_SCALAR ? 1
           : type == TINYGLTF_TYPE_VEC2 ? 2
           : type == TINYGLTF_TYPE_VEC3 ? 3
           : type == TINYGLTF_TYPE_VEC4 ? 4
                                        : 0;
}

// A negative number becomes one that lies in no buffer.
size_t unsigned_of(int number)
{
    return number < 0 ? SIZE_MAX : static_cast<size_t>(number);
}

void copy_accessors(owner *o)
{
    for (const tinygltf::Accessor &a : o->model.accessors) {
        sfi_gltf_accessor to = {};
        to.view = a.bufferView;
        to.offset = a.byteOffset;
        to.count = a.count;
        to.component = a.componentType;
        to.width = width_of(a.type);
        to.is_normalized = a.normalized;
        to.is_sparse = a.sparse.isSparse;
        if (a.sparse.isSparse) {
            to.sparse_count = unsigned_of(a.sparse.count);
            to.at_view = a.sparse.indices.bufferView;
            to.at_component = a.sparse.indices.componentType;
            to.at_offset = unsigned_of(a.sparse.indices.byteOffset);
            to.value_view = a.sparse.values.bufferView;
            to.value_offset = unsigned_of(a.sparse.values.byteOffset);
        }
        o->accessors.push_back(to);
    }
}

void copy_meshes(owner *o)
{
    for (const tinygltf::Mesh &m : o->model.meshes) {
        o->meshes.push_back({o->primitives.size(), m.primitives.size()});
        for (const tinygltf::Primitive &p : m.primitives) {
            auto position = p.attributes.find("POSITION");
            int positions = position == p.attributes.end() ? -1 : position->second;
            o->primitives.push_back({p.mode, p.indices, positions, !p.targets.empty()});
        }
    }
}

// An array of the right length is copied; an absent one leaves what is there.
bool take(const std::vector<double> &from, size_t count, double *to)
{
    if (!from.empty() && from.size() != count) {
        return false;
    }
    std::copy(from.begin(), from.end(), to);
    return true;
}

void copy_nodes(owner *o)
{
    for (const tinygltf::Node &n : o->model.nodes) {
        sfi_gltf_node to = {};
        to.mesh = n.mesh;
        to.skin = n.skin;
        to.first = o->children.size();
        to.count = n.children.size();
        o->children.insert(o->children.end(), n.children.begin(), n.children.end());
        to.turn[3] = to.stretch[0] = to.stretch[1] = to.stretch[2] = 1;
        to.placing = n.matrix.empty() ? SFI_GLTF_PARTS : SFI_GLTF_MATRIX;
        if (!take(n.matrix, 16, to.matrix) || !take(n.translation, 3, to.move) ||
            !take(n.rotation, 4, to.turn) || !take(n.scale, 3, to.stretch)) {
            to.placing = SFI_GLTF_NO_PLACE;
        }
        o->nodes.push_back(to);
    }
}

// The scene that is shown, else the first, else every node that is nobody's child.
void choose_roots(owner *o)
{
    const tinygltf::Model &m = o->model;
    if (!m.scenes.empty()) {
        bool is_there = m.defaultScene >= 0 && size_t(m.defaultScene) < m.scenes.size();
        o->roots = m.scenes[is_there ? size_t(m.defaultScene) : 0].nodes;
        return;
    }
    std::vector<char> is_child(m.nodes.size());
    for (int child : o->children) {
        if (child >= 0 && size_t(child) < is_child.size()) {
            is_child[size_t(child)] = 1;
        }
    }
    for (size_t i = 0; i < is_child.size(); i++) {
        if (!is_child[i]) {
            o->roots.push_back(int(i));
        }
    }
}

void copy_all(owner *o, sfi_gltf_model *model)
{
    copy_buffers(o);
    copy_accessors(o);
    copy_meshes(o);
    copy_nodes(o);
    choose_roots(o);
    for (const std::string &name : o->model.extensionsRequired) {
        o->extensions.push_back(name.c_str());
    }
    model->buffers = o->buffers.data();
    model->buffer_count = o->buffers.size();
    model->views = o->views.data();
    model->view_count = o->views.size();
    model->accessors = o->accessors.data();
    model->accessor_count = o->accessors.size();
    model->primitives = o->primitives.data();
    model->meshes = o->meshes.data();
    model->mesh_count = o->meshes.size();
    model->nodes = o->nodes.data();
    model->node_count = o->nodes.size();
    model->children = o->children.data();
    model->roots = o->roots.data();
    model->root_count = o->roots.size();
    model->extensions = o->extensions.data();
    model->extension_count = o->extensions.size();
    model->skin_count = o->model.skins.size();
    model->animation_count = o->model.animations.size();
}

// ---------------------------------------------------------------------------------------------
// Parsing
// ---------------------------------------------------------------------------------------------

// The last line of what tinygltf says, which is why it stopped, as far as that is plain text.
std::string last_line(const std::string &text)
{
    size_t end = text.find_last_not_of('\n');
    size_t before = end == std::string::npos ? end : text.rfind('\n', end);
    std::string line;
    for (size_t i = before == std::string::npos ? 0 : before + 1;
         end != std::string::npos && i <= end && line.size() < 160; i++) {
        line += text[i] >= ' ' && text[i] <= '~' ? text[i] : '?';
    }
    return line.empty() ? "tinygltf gives no reason" : line;
}

sf_status refuse(const sfi_gltf_files *files, const std::string &said, sf_fault *fault)
{
    // tinygltf catches what its JSON parser throws, also for want of memory, and keeps the name.
    if (files->failure == SF_ERR_MEMORY || said.find("bad_alloc") != std::string::npos) {
        return SF_ERR_MEMORY;
    }
    if (files->failure == SF_ERR_OVERFLOW) {
        return sfi_fault_set(fault, SF_ERR_OVERFLOW, 0, 0,
                             "the file and its buffers are larger than bytes_max; raise it");
    }
    if (files->failure != SF_OK || said.find("File not found") != std::string::npos) {
        return sfi_fault_set(fault, files->failure != SF_OK ? files->failure : SF_ERR_IO, 0, 0,
                             "a buffer of the file stands in another file, which is not in its "
                             "folder or has no plain name; export it as .glb");
    }
    return sfi_fault_set(fault, SF_ERR_FORMAT, 0, 0, "this is no glTF 2.0, or it is damaged: %s",
                         last_line(said).c_str());
}

sf_status parse(const unsigned char *bytes, size_t size, int is_binary, sfi_gltf_files *files,
                owner *o, sf_fault *fault)
{
    tinygltf::TinyGLTF loader;
    std::string error, warning;
    loader.SetImageLoader(look_at_no_picture, nullptr);
    loader.SetFsCallbacks({file_exists, expand_nothing, read_file, write_nothing, files});
    bool good = is_binary ? loader.LoadBinaryFromMemory(&o->model, &error, &warning, bytes,
                                                        static_cast<unsigned>(size))
                          : loader.LoadASCIIFromString(&o->model, &error, &warning,
                                                       reinterpret_cast<const char *>(bytes),
                                                       static_cast<unsigned>(size), "");
    if (!good || files->failure == SF_ERR_MEMORY) {
        return refuse(files, error, fault);
    }
    if (o->model.asset.version.compare(0, 2, "2.") != 0) {
        return sfi_fault_set(
            fault, SF_ERR_UNSUPPORTED, 0, 0,
            "the file is of another version of glTF than 2, and only that is read");
    }
    return SF_OK;
}

} // namespace

sf_status sfi_gltf_parse(const unsigned char *bytes, size_t size, int is_binary,
                         sfi_gltf_files *files, sfi_gltf_model *model, sf_fault *fault)
{
    owner *o = new (std::nothrow) owner;
    if (o == nullptr) {
        return SF_ERR_MEMORY;
    }
    sf_status status;
    try {
        status = parse(bytes, size, is_binary, files, o, fault);
        if (status == SF_OK) {
            copy_all(o, model);
            model->owner = o;
            return SF_OK;
        }
    } catch (const std::bad_alloc &) {
        status = SF_ERR_MEMORY;
    } catch (const std::exception &error) {
        status = sfi_fault_set(fault, SF_ERR_FORMAT, 0, 0,
                               "this is no glTF 2.0, or it is damaged: %.100s", error.what());
    } catch (...) {
        status = sfi_fault_set(fault, SF_ERR_INTERNAL, 0, 0, "tinygltf failed in an unknown way");
    }
    delete o;
    return status;
}

void sfi_gltf_release(sfi_gltf_model *model)
{
    delete static_cast<owner *>(model->owner);
    model->owner = nullptr;
}
