// SPDX-License-Identifier: MIT
// 3MF out: the archive and its parts, one after the other.
//
// A package says of every part what it is (by its ending), and of the package and of the model
// which parts belong to them. The model comes first, pictures of a volume as they are made, and a
// thumbnail last; none of them is held.

#include <sf/threemf.h>

#include "base/memory.h"
#include "base/status.h"
#include "io/picture.h"
#include "io/stack.h"
#include "io/threemf_model.h"
#include "io/zip_write.h"

#include <string.h>

sf_threemf_extras sf_threemf_extras_default(void)
{
    sf_threemf_extras extras;
    memset(&extras, 0, sizeof extras);
    extras.struct_size = sizeof extras;
    return extras;
}

#ifdef SF_HAVE_THREEMF

typedef struct package {
    const sf_threemf_view *what;
    sf_threemf_extras extras;
    sfi_zip_out *zip;
    const sf_allocator *allocator;
    sf_task *task;
    sf_fault *fault;
} package;

typedef void emit_part(const package *p, sfi_emitter *out);

static sf_status write_part(const package *p, const char *name, emit_part *emit)
{
    sf_sink entry;
    sfi_emitter out;
    SF_TRY(sfi_zip_out_begin(p->zip, name, 0, &entry));
    sfi_emitter_begin(&out, entry);
    emit(p, &out);
    SF_TRY(sfi_emitter_end(&out));
    return sfi_zip_out_end(p->zip);
}

// ---------------------------------------------------------------------------------------------
// What belongs to what
// ---------------------------------------------------------------------------------------------

static void emit_types(const package *p, sfi_emitter *out)
{
    (void)p;
    sfi_emit_text(
        out, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<Types xmlns=\"" SFI_THREEMF_TYPES "\">\n"
             " <Default Extension=\"rels\" "
             "ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>\n"
             " <Default Extension=\"model\" "
             "ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/>\n"
             " <Default Extension=\"png\" ContentType=\"image/png\"/>\n</Types>\n");
}

static void emit_relation(sfi_emitter *out, uint64_t number, const char *type, const char *target)
{
    sfi_emit_text(out, " <Relationship Target=\"");
    sfi_emit_text(out, target);
    sfi_emit_text(out, "\" Id=\"rel");
    sfi_emit_whole(out, number);
    sfi_emit_text(out, "\" Type=\"");
    sfi_emit_text(out, type);
    sfi_emit_text(out, "\"/>\n");
}

static void emit_relations_begin(sfi_emitter *out)
{
    sfi_emit_text(out, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<Relationships "
                       "xmlns=\"" SFI_THREEMF_RELATIONS "\">\n");
}

static void emit_package_relations(const package *p, sfi_emitter *out)
{
    emit_relations_begin(out);
    emit_relation(out, 0, SFI_THREEMF_MODEL, "/3D/3dmodel.model");
    if (p->extras.thumbnail != NULL) {
        emit_relation(out, 1, SFI_THREEMF_THUMBNAIL, "/Metadata/thumbnail.png");
    }
    sfi_emit_text(out, "</Relationships>\n");
}

static void emit_model_relations(const package *p, sfi_emitter *out)
{
    const sf_threemf_volume *v = p->extras.volume;
    uint64_t number = 0;
    emit_relations_begin(out);
    for (size_t f = 0; f < v->field_count; f++) {
        for (uint32_t k = 0; k < v->lattice.nz; k++) {
            char path[SFI_THREEMF_SHEET_SIZE];
            sfi_threemf_sheet(f, k, path);
            emit_relation(out, number++, SFI_THREEMF_TEXTURE, path);
        }
    }
    sfi_emit_text(out, "</Relationships>\n");
}

static void emit_model(const package *p, sfi_emitter *out)
{
    sfi_threemf_emit_model(p->what, &p->extras, out);
}

// ---------------------------------------------------------------------------------------------
// What fills an object
// ---------------------------------------------------------------------------------------------

static sf_status write_sheet(const package *p, size_t field, uint32_t k, const uint16_t *values)
{
    const sf_lattice *l = &p->extras.volume->lattice;
    char path[SFI_THREEMF_SHEET_SIZE];
    sf_sink entry;
    sfi_threemf_sheet(field, k, path);
    SF_TRY(sfi_zip_out_begin(p->zip, path + 1, 1, &entry));
    SF_TRY(sfi_png_write_grey16(values, l->nx, l->ny, entry));
    return sfi_zip_out_end(p->zip);
}

static sf_status write_layers(const package *p, uint16_t *values)
{
    const sf_threemf_volume *v = p->extras.volume;
    size_t plane = (size_t)v->lattice.nx * v->lattice.ny;
    uint16_t *planes[64];
    for (size_t f = 0; f < v->field_count; f++) {
        planes[f] = values + f * plane;
    }
    for (uint32_t k = 0; k < v->lattice.nz; k++) {
        SF_TRY(sf_task_is_cancelled(p->task) ? SF_ERR_CANCELLED : SF_OK);
        memset(values, 0, v->field_count * plane * sizeof *values);
        SF_TRY(v->layer(v->user, k, planes));
        for (size_t f = 0; f < v->field_count; f++) {
            SF_TRY(write_sheet(p, f, k, planes[f]));
        }
        sfi_stack_progress(p->task, k + 1, v->lattice.nz);
    }
    return SF_OK;
}

static sf_status write_volume(const package *p)
{
    const sf_threemf_volume *v = p->extras.volume;
    size_t count;
    if (v == NULL) {
        return SF_OK;
    }
    SF_TRY(write_part(p, "3D/_rels/3dmodel.model.rels", emit_model_relations));
    if (!sfi_size_mul((size_t)v->lattice.nx * v->lattice.ny, v->field_count, &count)) {
        return SF_ERR_OVERFLOW;
    }
    uint16_t *values = sfi_alloc_array(p->allocator, count, sizeof *values);
    if (values == NULL) {
        return SF_ERR_MEMORY;
    }
    sf_status status = write_layers(p, values);
    sfi_free_array(p->allocator, values, count, sizeof *values);
    return status;
}

static sf_status write_thumbnail(const package *p)
{
    sf_sink entry;
    if (p->extras.thumbnail == NULL) {
        return SF_OK;
    }
    SF_TRY(sfi_zip_out_begin(p->zip, "Metadata/thumbnail.png", 1, &entry));
    SF_TRY(entry.write(entry.user, p->extras.thumbnail, p->extras.thumbnail_size));
    return sfi_zip_out_end(p->zip);
}

// ---------------------------------------------------------------------------------------------
// The package
// ---------------------------------------------------------------------------------------------

static sf_status write_all(const package *p)
{
    SF_TRY(write_part(p, "[Content_Types].xml", emit_types));
    SF_TRY(write_part(p, "_rels/.rels", emit_package_relations));
    SF_TRY(write_part(p, "3D/3dmodel.model", emit_model));
    SF_TRY(write_volume(p));
    SF_TRY(write_thumbnail(p));
    return sfi_zip_out_finish(p->zip);
}

static sf_status write_package(package *p, sf_sink sink)
{
    SF_TRY(sfi_threemf_check(p->what, &p->extras, p->fault));
    SF_TRY(sfi_zip_out_create(sink, p->allocator, &p->zip));
    sf_status status = write_all(p);
    sfi_zip_out_destroy(p->zip);
    return status;
}

sf_status sf_threemf_write(const sf_threemf_view *what, const sf_threemf_extras *extras,
                           sf_sink sink, const sf_allocator *allocator, sf_task *task,
                           sf_fault *fault)
{
    sf_allocator kept = sfi_allocator_or_default(allocator);
    package p = {what, sf_threemf_extras_default(), NULL, &kept, task, fault};
    if (what == NULL || sink.write == NULL) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "there is nothing to write, or no sink");
    }
    if (extras != NULL) { // an older caller knows fewer fields, a newer one more
        size_t size = sizeof p.extras;
        memcpy(&p.extras, extras, extras->struct_size < size ? extras->struct_size : size);
    }
    return write_package(&p, sink);
}

#else

sf_status sf_threemf_write(const sf_threemf_view *what, const sf_threemf_extras *extras,
                           sf_sink sink, const sf_allocator *allocator, sf_task *task,
                           sf_fault *fault)
{
    (void)extras, (void)allocator, (void)task;
    if (what == NULL || sink.write == NULL) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "there is nothing to write, or no sink");
    }
    return sfi_fault_set(fault, SF_ERR_UNSUPPORTED, 0, 0,
                         "this build writes no 3MF; take another format, or build with expat and "
                         "zlib");
}

#endif
