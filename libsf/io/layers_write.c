// SPDX-License-Identifier: MIT
// Layers of several materials out: a picture each, and last stack.json with the table.
//
// Every picture is whole when it is published, and the document comes last, so that a folder that
// has it has them all. What was counted while pictures went by is what the table says.

#include <sf/layers.h>

#include "base/memory.h"
#include "base/status.h"
#include "io/picture.h"
#include "io/stack.h"

#include <string.h>

struct sf_layers {
    sf_allocator allocator;
    sf_folder folder;
    sf_lattice lattice;
    double *heights; // a copy; NULL where all are the same
    uint32_t material_count, written;
    sf_material materials[SF_MATERIAL_MAX];
    sfi_palette palette;
    uint64_t *counts; // of each layer and material
};

void sf_layers_end(sf_layers *layers)
{
    if (layers != NULL) {
        sf_allocator allocator = layers->allocator;
        size_t counts = (size_t)layers->lattice.nz * layers->material_count;
        sfi_free_array(&allocator, layers->heights, layers->lattice.nz, sizeof *layers->heights);
        sfi_free_array(&allocator, layers->counts, counts, sizeof *layers->counts);
        sfi_free_array(&allocator, layers, 1, sizeof *layers);
    }
}

// Text that can stand in a JSON string as it is, but for quotes and backslashes.
static int is_name(const char *name)
{
    size_t length = 0;
    while (length < SF_MATERIAL_NAME_SIZE && name[length] != 0) {
        if ((unsigned char)name[length++] < 0x20) {
            return 0;
        }
    }
    return length > 0 && length < SF_MATERIAL_NAME_SIZE;
}

static sf_status check_materials(uint32_t count, const sf_material *materials, sf_fault *fault)
{
    if (count < 1 || count > SF_MATERIAL_MAX) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                             "there are %lu materials; 1 to %u can be", (unsigned long)count,
                             SF_MATERIAL_MAX);
    }
    for (uint32_t i = 0; i < count; i++) {
        const char *what =
            !is_name(materials[i].name) ? "has no name, or one that cannot be"
            : !(materials[i].density_g_cm3 >= 0 && materials[i].density_g_cm3 <= 1e12)
                ? "has a density that is no number of 0 or more"
                : NULL;
        for (uint32_t j = 0; what == NULL && j < i; j++) {
            what = strcmp(materials[i].name, materials[j].name) == 0 ? "has the name of another"
                                                                     : NULL;
        }
        if (what != NULL) {
            return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "material %lu %s", (unsigned long)i,
                                 what);
        }
    }
    return SF_OK;
}

static sf_status copy_lattice(const sf_lattice *lattice, sf_layers *layers)
{
    size_t counts = (size_t)lattice->nz * layers->material_count;
    layers->lattice = *lattice;
    layers->lattice.heights_mm = NULL;
    layers->counts = sfi_alloc_array(&layers->allocator, counts, sizeof *layers->counts);
    if (layers->counts == NULL) {
        return SF_ERR_MEMORY;
    }
    if (lattice->heights_mm != NULL) {
        layers->heights = sfi_alloc_array(&layers->allocator, lattice->nz, sizeof(double));
        if (layers->heights == NULL) {
            return SF_ERR_MEMORY;
        }
        memcpy(layers->heights, lattice->heights_mm, lattice->nz * sizeof(double));
        layers->lattice.heights_mm = layers->heights;
    }
    return SF_OK;
}

sf_status sf_layers_begin(sf_folder folder, const sf_lattice *lattice, uint32_t material_count,
                          const sf_material *materials, const sf_allocator *allocator,
                          sf_layers **layers, sf_fault *fault)
{
    if (folder.begin == NULL || folder.commit == NULL || lattice == NULL || materials == NULL ||
        layers == NULL) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                             "a folder, lattice or material is missing");
    }
    SF_TRY(sf_lattice_validate(lattice));
    SF_TRY(check_materials(material_count, materials, fault));
    if (!sf_stack_has_png()) {
        return sfi_fault_set(
            fault, SF_ERR_UNSUPPORTED, 0, 0,
            "layers of materials are PNG pictures, which this build does not write; "
            "build it with libspng");
    }
    sf_allocator kept = sfi_allocator_or_default(allocator);
    sf_layers *made = sfi_alloc_array(&kept, 1, sizeof *made);
    if (made == NULL) {
        return SF_ERR_MEMORY;
    }
    memset(made, 0, sizeof *made);
    made->allocator = kept;
    made->folder = folder;
    made->material_count = material_count;
    made->palette.count = material_count + 1;
    for (uint32_t i = 0; i < material_count; i++) {
        made->materials[i] = materials[i];
        memcpy(made->palette.colours[i + 1], materials[i].colour, 3);
    }
    sf_status status = copy_lattice(lattice, made);
    if (status != SF_OK) {
        sf_layers_end(made);
        return status;
    }
    *layers = made;
    return SF_OK;
}

// One file: begin, write, publish or drop.
typedef sf_status write_content(const sf_layers *layers, const void *what, sf_sink sink);

static sf_status write_file(sf_layers *layers, const char *name, write_content *content,
                            const void *what, sf_fault *fault)
{
    sf_sink sink;
    sf_status status = layers->folder.begin(layers->folder.user, name, &sink);
    if (status == SF_OK) {
        status = content(layers, what, sink);
        sf_status published = layers->folder.commit(layers->folder.user, status == SF_OK);
        status = status == SF_OK ? published : status;
    }
    return status == SF_OK ? SF_OK
                           : sfi_fault_set(fault, status, 0, 0, "writing %s failed: %s", name,
                                           sf_status_message(status));
}

// ---------------------------------------------------------------------------------------------
// Layers
// ---------------------------------------------------------------------------------------------

typedef struct plane {
    const uint8_t *ids;
    size_t stride;
} plane;

static sf_status write_picture(const sf_layers *layers, const void *what, sf_sink sink)
{
    const plane *p = what;
    return sfi_png_write_ids(p->ids, p->stride, layers->lattice.nx, layers->lattice.ny,
                             &layers->palette, sink);
}

static sf_status count_ids(const sf_layers *layers, const plane *p, uint64_t *counts,
                           sf_fault *fault)
{
    uint64_t all[256] = {0};
    for (uint32_t y = 0; y < layers->lattice.ny; y++) {
        for (uint32_t x = 0; x < layers->lattice.nx; x++) {
            all[p->ids[p->stride * y + x]]++;
        }
    }
    for (uint32_t i = layers->material_count + 1; i < 256; i++) {
        if (all[i] > 0) {
            return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                                 "layer %lu names material %lu, counted from 0; there are %lu",
                                 (unsigned long)layers->written, (unsigned long)i - 1,
                                 (unsigned long)layers->material_count);
        }
    }
    memcpy(counts, all + 1, layers->material_count * sizeof *counts);
    return SF_OK;
}

sf_status sf_layers_add(sf_layers *layers, const uint8_t *ids, size_t stride, sf_fault *fault)
{
    uint64_t counts[SF_MATERIAL_MAX];
    char name[SFI_STACK_NAME_SIZE];
    plane p = {ids, stride};
    if (layers == NULL || ids == NULL || stride < layers->lattice.nx ||
        layers->written == layers->lattice.nz) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                             "no layers, no voxels, a stride that is too small, or all layers are "
                             "written already");
    }
    SF_TRY(count_ids(layers, &p, counts, fault));
    sfi_stack_layer_name(SFI_PICTURE_PNG, layers->written, name);
    SF_TRY(write_file(layers, name, write_picture, &p, fault));
    memcpy(layers->counts + (size_t)layers->written * layers->material_count, counts,
           layers->material_count * sizeof *counts);
    layers->written++;
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// The document
// ---------------------------------------------------------------------------------------------

static void emit_name(sfi_emitter *out, const char *name)
{
    for (; *name != 0; name++) {
        if (*name == '"' || *name == '\\') {
            sfi_emit_text(out, "\\");
        }
        sfi_emit_bytes(out, name, 1);
    }
}

static void emit_colour(sfi_emitter *out, const uint8_t colour[3])
{
    static const char digits[] = "0123456789abcdef";
    char text[8] = "#";
    for (int i = 0; i < 3; i++) {
        text[1 + 2 * i] = digits[colour[i] / 16];
        text[2 + 2 * i] = digits[colour[i] % 16];
    }
    sfi_emit_text(out, text);
}

static void emit_material(sfi_emitter *out, uint32_t index, const sf_material *material,
                          const sf_material_use *use)
{
    sfi_emit_text(out, "    {\"index\": ");
    sfi_emit_whole(out, index);
    sfi_emit_text(out, ", \"name\": \"");
    emit_name(out, material->name);
    sfi_emit_text(out, "\", \"colour\": \"");
    emit_colour(out, material->colour);
    sfi_emit_text(out, "\", \"density_g_cm3\": ");
    if (material->density_g_cm3 > 0) {
        sfi_emit_number(out, material->density_g_cm3);
    } else {
        sfi_emit_text(out, "null");
    }
    sfi_emit_text(out, ",\n     \"voxels\": ");
    sfi_emit_whole(out, use->voxels);
    sfi_emit_text(out, ", \"volume_mm3\": ");
    sfi_emit_number(out, use->volume_mm3);
    sfi_emit_text(out, ", \"grams\": ");
    if (material->density_g_cm3 > 0) {
        sfi_emit_number(out, use->mass_g);
    } else {
        sfi_emit_text(out, "null");
    }
    sfi_emit_text(out, "}");
}

static sf_status write_document(const sf_layers *layers, const void *what, sf_sink sink)
{
    const sf_material_use *uses = what;
    sfi_emitter out;
    sfi_emitter_begin(&out, sink);
    sfi_emit_text(&out, "{\n  \"format\": \"" SFI_STACK_FORMAT "\",\n  \"version\": ");
    sfi_emit_whole(&out, SFI_STACK_VERSION_MATERIALS);
    sfi_emit_text(&out, ",\n  \"units\": \"mm\",\n");
    sfi_stack_emit_lattice(&out, &layers->lattice);
    sfi_emit_text(&out,
                  "  \"rule\": null,\n  \"layers\": {\n    \"pattern\": \"" SFI_STACK_PATTERN_PNG
                  "\",\n    \"count\": ");
    sfi_emit_whole(&out, layers->lattice.nz);
    sfi_emit_text(&out, "\n  },\n  \"materials\": [\n");
    for (uint32_t i = 0; i < layers->material_count; i++) {
        emit_material(&out, i + 1, &layers->materials[i], &uses[i]);
        sfi_emit_text(&out, i + 1 < layers->material_count ? ",\n" : "\n");
    }
    sfi_emit_text(&out, "  ],\n  \"solid\": \"not 0\",\n  \"row_order\": \"top_is_max_y\"\n}\n");
    return sfi_emitter_end(&out);
}

sf_status sf_layers_finish(sf_layers *layers, sf_material_use *uses, sf_fault *fault)
{
    sf_material_use found[SF_MATERIAL_MAX];
    double densities[SF_MATERIAL_MAX];
    if (layers == NULL || layers->written < layers->lattice.nz) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "layers are missing");
    }
    for (uint32_t i = 0; i < layers->material_count; i++) {
        densities[i] = layers->materials[i].density_g_cm3;
    }
    SF_TRY(sf_material_uses(&layers->lattice, layers->counts, layers->material_count, densities,
                            found));
    SF_TRY(write_file(layers, SFI_STACK_DOCUMENT, write_document, found, fault));
    if (uses != NULL) {
        memcpy(uses, found, layers->material_count * sizeof *uses);
    }
    return SF_OK;
}
