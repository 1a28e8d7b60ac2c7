// SPDX-License-Identifier: MIT
// A grid out as a stack: one picture a layer, then stack.json.
//
// stack.json comes last, so a folder that has it has all the pictures; one that has not is no
// stack. All numbers in it read back as the same doubles, so a stack that is read and written again
// is the same bytes. The angle stands twice: in radians, which is what the reader takes, and in
// degrees for people and other programs.

#include "io/stack.h"

#include "base/status.h"
#include "io/emitter.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

void sfi_stack_layer_name(sfi_picture_kind kind, uint32_t layer, char name[SFI_STACK_NAME_SIZE])
{
    snprintf(name, SFI_STACK_NAME_SIZE,
             kind == SFI_PICTURE_PBM ? SFI_STACK_PATTERN_PBM : SFI_STACK_PATTERN_PNG,
             (unsigned)layer);
}

void sfi_stack_progress(sf_task *task, uint32_t done, uint32_t total)
{
    if (task != NULL && task->progress != NULL) {
        task->progress(task->user, (double)done / (double)total);
    }
}

int sfi_stack_owns(const char *name)
{
    size_t digits = 0, start = strlen("layer_");
    if (strcmp(name, SFI_STACK_DOCUMENT) == 0) {
        return 1;
    }
    if (strncmp(name, "layer_", start) != 0) {
        return 0;
    }
    while (name[start + digits] >= '0' && name[start + digits] <= '9') {
        digits++;
    }
    const char *ending = name + start + digits;
    return digits >= 5 && (strcmp(ending, ".png") == 0 || strcmp(ending, ".pbm") == 0);
}

// Degrees of an angle: the round number that it was made from, where there is one.
static double degrees(double angle_rad)
{
    double exact = angle_rad * (180.0 / 3.14159265358979323846);
    double rounded = floor(exact * 1e9 + 0.5) / 1e9;
    return fabs(rounded - exact) < 1e-12 ? rounded : exact;
}

void sfi_stack_emit_numbers(sfi_emitter *out, const double *values, size_t count)
{
    sfi_emit_text(out, "[");
    for (size_t i = 0; i < count; i++) {
        sfi_emit_text(out, i > 0 ? ", " : "");
        sfi_emit_number(out, values[i]);
    }
    sfi_emit_text(out, "]");
}

void sfi_stack_emit_lattice(sfi_emitter *out, const sf_lattice *lattice)
{
    double pitch[2] = {lattice->pitch_x_mm, lattice->pitch_y_mm};
    sfi_emit_text(out, "  \"lattice\": {\n    \"nx\": ");
    sfi_emit_whole(out, lattice->nx);
    sfi_emit_text(out, ",\n    \"ny\": ");
    sfi_emit_whole(out, lattice->ny);
    sfi_emit_text(out, ",\n    \"nz\": ");
    sfi_emit_whole(out, lattice->nz);
    sfi_emit_text(out, ",\n    \"pitch_mm\": ");
    sfi_stack_emit_numbers(out, pitch, 2);
    if (lattice->heights_mm != NULL) {
        sfi_emit_text(out, ",\n    \"heights_mm\": ");
        sfi_stack_emit_numbers(out, lattice->heights_mm, lattice->nz);
    } else {
        sfi_emit_text(out, ",\n    \"layer_mm\": ");
        sfi_emit_number(out, lattice->layer_mm);
    }
    sfi_emit_text(out, ",\n    \"origin_mm\": ");
    sfi_stack_emit_numbers(out, lattice->origin_mm, 3);
    sfi_emit_text(out, "\n  },\n");
}

static void emit_rule(sfi_emitter *out, const sf_stack_info *info)
{
    if (info == NULL || !info->has_rule) {
        sfi_emit_text(out, "  \"rule\": null,\n");
        return;
    }
    sfi_emit_text(out, "  \"rule\": {\n    \"kind\": \"");
    sfi_emit_text(out, sf_rule_kind_name(info->rule));
    if (info->rule != SF_RULE_BOX3) {
        sfi_emit_text(out, "\",\n    \"angle_deg\": ");
        sfi_emit_number(out, degrees(info->angle_rad));
        sfi_emit_text(out, ",\n    \"angle_rad\": ");
        sfi_emit_number(out, info->angle_rad);
    } else {
        sfi_emit_text(out, "\"");
    }
    if (info->bridge_span_mm > 0) {
        double bridge[2] = {info->bridge_span_mm, info->bridge_anchor_mm};
        sfi_emit_text(out, ",\n    \"bridge_mm\": ");
        sfi_stack_emit_numbers(out, bridge, 2);
    }
    sfi_emit_text(out, ",\n    \"bed_layer\": ");
    if (info->bed_layer == SF_BED_AUTO) {
        sfi_emit_text(out, "null");
    } else {
        sfi_emit_whole(out, info->bed_layer);
    }
    sfi_emit_text(out, ",\n    \"phase_layer\": 0\n  },\n");
}

static sf_status write_document(const sf_lattice *lattice, const sf_stack_info *info,
                                sfi_picture_kind kind, sf_sink sink)
{
    sfi_emitter out;
    sfi_emitter_begin(&out, sink);
    sfi_emit_text(&out, "{\n  \"format\": \"" SFI_STACK_FORMAT "\",\n  \"version\": ");
    int bridged = info != NULL && info->has_rule && info->bridge_span_mm > 0;
    sfi_emit_whole(&out, bridged ? SFI_STACK_VERSION_BRIDGED : SFI_STACK_VERSION);
    sfi_emit_text(&out, ",\n  \"units\": \"mm\",\n");
    sfi_stack_emit_lattice(&out, lattice);
    emit_rule(&out, info);
    sfi_emit_text(&out, "  \"layers\": {\n    \"pattern\": \"");
    sfi_emit_text(&out, kind == SFI_PICTURE_PNG ? SFI_STACK_PATTERN_PNG : SFI_STACK_PATTERN_PBM);
    sfi_emit_text(&out, "\",\n    \"count\": ");
    sfi_emit_whole(&out, lattice->nz);
    sfi_emit_text(&out, "\n  },\n  \"solid\": \"white\",\n  \"row_order\": \"top_is_max_y\"\n}\n");
    return sfi_emitter_end(&out);
}

// One file: begin, write, publish or drop. `slice` NULL stands for the document.
typedef struct stack_writer {
    const sf_folder *folder;
    const sf_lattice *lattice;
    const sf_stack_info *info;
    sfi_picture_kind kind;
} stack_writer;

static sf_status write_file(const stack_writer *writer, const char *name, const sf_slice *slice,
                            sf_fault *fault)
{
    sf_sink sink;
    sf_status status = writer->folder->begin(writer->folder->user, name, &sink);
    if (status == SF_OK) {
        status = slice != NULL ? sfi_picture_write(writer->kind, *slice, sink)
                               : write_document(writer->lattice, writer->info, writer->kind, sink);
        sf_status published = writer->folder->commit(writer->folder->user, status == SF_OK);
        status = status == SF_OK ? published : status;
    }
    if (status != SF_OK) {
        return sfi_fault_set(fault, status, 0, 0, "writing %s failed: %s", name,
                             sf_status_message(status));
    }
    return SF_OK;
}

static sf_status check_info(const sf_stack_info *info, const sf_lattice *lattice, sf_fault *fault)
{
    if (info == NULL || !info->has_rule) {
        return SF_OK;
    }
    sf_rule_kind kind;
    if (sf_rule_kind_from_name(sf_rule_kind_name(info->rule), &kind) != SF_OK ||
        !(info->bridge_span_mm >= 0 && info->bridge_span_mm <= SFI_STACK_BRIDGE_MAX) ||
        !(info->bridge_anchor_mm >= 0 && info->bridge_anchor_mm <= SFI_STACK_BRIDGE_MAX) ||
        (info->rule != SF_RULE_BOX3 &&
         !(info->angle_rad >= SF_RULE_ANGLE_MIN_RAD && info->angle_rad <= SF_RULE_ANGLE_MAX_RAD)) ||
        (info->bed_layer >= lattice->nz && info->bed_layer != SF_BED_AUTO)) {
        return sfi_fault_set(
            fault, SF_ERR_ARGUMENT, 0, 0,
            "the rule's kind, angle, bridge or bed layer is none that this stack can have");
    }
    return SF_OK;
}

sf_status sf_stack_write(const sf_grid *grid, const sf_stack_info *info, sf_folder folder,
                         sf_task *task, sf_fault *fault)
{
    if (grid == NULL || folder.begin == NULL || folder.commit == NULL) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "no grid, or no folder to write to");
    }
    sf_lattice lattice = sf_grid_lattice(grid);
    sfi_picture_kind kind = sf_stack_has_png() ? SFI_PICTURE_PNG : SFI_PICTURE_PBM;
    stack_writer writer = {&folder, &lattice, info, kind};
    SF_TRY(check_info(info, &lattice, fault));
    for (uint32_t k = 0; k < lattice.nz; k++) {
        char name[SFI_STACK_NAME_SIZE];
        if (sf_task_is_cancelled(task)) {
            return sfi_fault_set(fault, SF_ERR_CANCELLED, 0, 0, "writing the stack was cancelled");
        }
        sfi_stack_layer_name(kind, k, name);
        sf_slice slice = sf_grid_slice(grid, k);
        SF_TRY(write_file(&writer, name, &slice, fault));
        sfi_stack_progress(task, k + 1, lattice.nz);
    }
    return write_file(&writer, SFI_STACK_DOCUMENT, NULL, fault);
}
