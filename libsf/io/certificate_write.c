// SPDX-License-Identifier: MIT
// A certificate out, as JSON that people can read and a short program can check.
//
// The keys and units are those of stack.json where both say the same thing. Numbers read back as
// the same doubles. The last field is the SHA-256 of all bytes before it, from the first brace to
// the end of the line above: it says that no byte was changed, also in fields that nothing else in
// a stack could contradict, such as the fingerprint of an input that is long gone. It says nothing
// of who wrote the file: whoever changes it can make a new one.

#include "base/sha256.h"
#include "io/stack.h"

#define FORMAT "libsf-certificate"
#define VERSION 1

// A sink that takes the fingerprint of what passes through it.
typedef struct hashing {
    sf_sink sink;
    sfi_sha256 hash;
} hashing;

static sf_status hash_and_hand_on(void *user, const void *data, size_t size)
{
    hashing *h = user;
    sfi_sha256_add(&h->hash, data, size);
    return h->sink.write(h->sink.user, data, size);
}

static void emit_digest(sfi_emitter *out, const uint8_t digest[SF_SHA256_SIZE])
{
    static const char digits[] = "0123456789abcdef";
    char text[2 * SF_SHA256_SIZE];
    for (int i = 0; i < SF_SHA256_SIZE; i++) {
        text[2 * i] = digits[digest[i] >> 4];
        text[2 * i + 1] = digits[digest[i] & 15];
    }
    sfi_emit_text(out, "\"");
    sfi_emit_bytes(out, text, sizeof text);
    sfi_emit_text(out, "\"");
}

static void emit_wholes(sfi_emitter *out, const uint64_t *values, size_t count)
{
    sfi_emit_text(out, "[");
    for (size_t i = 0; i < count; i++) {
        sfi_emit_text(out, i > 0 ? ", " : "");
        sfi_emit_whole(out, values[i]);
    }
    sfi_emit_text(out, "]");
}

// Each entry of a list stands on a line of its own.
static void begin_list(sfi_emitter *out, const char *key)
{
    sfi_emit_text(out, "  \"");
    sfi_emit_text(out, key);
    sfi_emit_text(out, "\": [");
}

static void emit_entry(sfi_emitter *out, size_t index, const uint64_t *values, size_t count)
{
    sfi_emit_text(out, index > 0 ? ",\n    " : "\n    ");
    emit_wholes(out, values, count);
}

static void end_list(sfi_emitter *out, size_t count)
{
    sfi_emit_text(out, count > 0 ? "\n  ],\n" : "],\n");
}

static void emit_grid(sfi_emitter *out, const char *key, const uint8_t digest[SF_SHA256_SIZE],
                      uint64_t voxels)
{
    sfi_emit_text(out, "  \"");
    sfi_emit_text(out, key);
    sfi_emit_text(out, "\": {\n    \"sha256\": ");
    emit_digest(out, digest);
    sfi_emit_text(out, ",\n    \"voxels\": ");
    sfi_emit_whole(out, voxels);
    sfi_emit_text(out, "\n  },\n");
}

static void emit_operation(sfi_emitter *out, const sf_certificate_view *v)
{
    sfi_emit_text(out, "  \"operation\": {\n    \"name\": \"");
    sfi_emit_text(out, sf_operation_name(v->operation));
    sfi_emit_text(out, "\",\n    \"added\": ");
    sfi_emit_whole(out, v->added_voxels);
    sfi_emit_text(out, ",\n    \"removed\": ");
    sfi_emit_whole(out, v->removed_voxels);
    sfi_emit_text(out, "\n  },\n");
    emit_grid(out, "input", v->input_sha256, v->input_voxels);
    emit_grid(out, "output", v->output_sha256, v->output_voxels);
}

static void emit_rule(sfi_emitter *out, const sf_certificate_view *v)
{
    sfi_emit_text(out, "  \"rule\": {\n    \"kind\": \"");
    sfi_emit_text(out, sf_rule_kind_name(v->kind));
    sfi_emit_text(out, "\"");
    if (v->kind != SF_RULE_BOX3) {
        sfi_emit_text(out, ",\n    \"angle_rad\": ");
        sfi_emit_number(out, v->angle_rad);
        sfi_emit_text(out, ",\n    \"tangent\": ");
        sfi_emit_number(out, v->tangent);
    }
    if (v->bridge_span_mm > 0) {
        double bridge[2] = {v->bridge_span_mm, v->bridge_anchor_mm};
        sfi_emit_text(out, ",\n    \"bridge_mm\": ");
        sfi_stack_emit_numbers(out, bridge, 2);
    }
    sfi_emit_text(out, ",\n    \"bed_layer\": ");
    if (v->bed_layer == SF_BED_AUTO) {
        sfi_emit_text(out, "null");
    } else {
        sfi_emit_whole(out, v->bed_layer);
    }
    sfi_emit_text(out, "\n  },\n");
}

// What the rule and the bed became on this lattice. Phase: the lattice layer that the rule's
// schedule begins at.
static void emit_numbers(sfi_emitter *out, const sf_certificate_view *v)
{
    const sf_bridge *b = &v->bridge;
    uint64_t slack[3] = {v->slack_x, v->slack_y, v->slack_cap};
    uint64_t spans[3] = {b->span_x, b->span_y, b->span_diagonal};
    uint64_t anchors[3] = {b->anchor_x, b->anchor_y, b->anchor_diagonal};
    sfi_emit_text(out, "  \"numbers\": {\n    \"phase\": 0,\n    \"bed\": ");
    sfi_emit_whole(out, v->bed);
    sfi_emit_text(out, ",\n    \"slack\": ");
    emit_wholes(out, slack, 3);
    sfi_emit_text(out, ",\n    \"spans\": ");
    emit_wholes(out, spans, 3);
    sfi_emit_text(out, ",\n    \"anchors\": ");
    emit_wholes(out, anchors, 3);
    sfi_emit_text(out, "\n  },\n");
}

// Of each layer its counts, and the integers of the step to it from the layer below.
static void emit_layers(sfi_emitter *out, const sf_certificate_view *v)
{
    begin_list(out, "layers");
    for (size_t k = 0; k < v->lattice.nz; k++) {
        static const sf_certificate_step none = {0, 0, 0};
        const sf_certificate_layer *l = &v->layers[k];
        const sf_certificate_step *s = k > 0 ? &v->steps[k - 1] : &none;
        uint64_t entry[6] = {l->solid, l->exempt, l->bridged, s->first, s->second, s->gain};
        emit_entry(out, k, entry, 6);
    }
    end_list(out, v->lattice.nz);
}

// Exempt runs are written as gaps are: layer, direction (along x), y, x, length.
static void emit_witnesses(sfi_emitter *out, const sf_certificate_view *v)
{
    begin_list(out, "exempt");
    for (size_t i = 0; i < v->exempt_count; i++) {
        const sf_run *run = &v->exempt[i];
        uint64_t entry[5] = {run->label, 0, run->y, run->x0, run->x1 - run->x0};
        emit_entry(out, i, entry, 5);
    }
    end_list(out, v->exempt_count);
    begin_list(out, "bridges");
    for (size_t i = 0; i < v->span_count; i++) {
        const sf_certificate_span *s = &v->spans[i];
        uint64_t entry[5] = {s->layer, s->direction, s->y, s->x, s->length};
        emit_entry(out, i, entry, 5);
    }
    end_list(out, v->span_count);
}

sf_status sf_certificate_write(const sf_certificate *certificate, sf_sink sink)
{
    if (certificate == NULL || sink.write == NULL) {
        return SF_ERR_ARGUMENT;
    }
    sf_certificate_view v = sf_certificate_get_view(certificate);
    hashing through = {.sink = sink};
    sf_sink hashed = {hash_and_hand_on, &through};
    uint8_t digest[SF_SHA256_SIZE];
    sfi_emitter out;
    sfi_sha256_begin(&through.hash);
    sfi_emitter_begin(&out, hashed);
    sfi_emit_text(&out, "{\n  \"format\": \"" FORMAT "\",\n  \"version\": ");
    sfi_emit_whole(&out, VERSION);
    sfi_emit_text(&out, ",\n");
    emit_operation(&out, &v);
    sfi_stack_emit_lattice(&out, &v.lattice);
    emit_rule(&out, &v);
    emit_numbers(&out, &v);
    emit_layers(&out, &v);
    emit_witnesses(&out, &v);
    sf_status status = sfi_emitter_end(&out);
    if (status != SF_OK) {
        return status;
    }
    sfi_sha256_end(&through.hash, digest);
    sfi_emitter_begin(&out, sink);
    sfi_emit_text(&out, "  \"digest\": ");
    emit_digest(&out, digest);
    sfi_emit_text(&out, "\n}\n");
    return sfi_emitter_end(&out);
}
