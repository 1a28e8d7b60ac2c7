// SPDX-License-Identifier: MIT
// A checker's state in memory that lasts: saved in two slots in turn, found again after a power
// cut.
//
// A slot is 21 numbers of 32 bits and then the body: the last layer, and the findings so far. The
// body is written first, the numbers last, and both have a checksum; a slot that was being written
// when the power went has one that does not fit, and the other slot was not touched. Which is newer
// says a sequence number, which goes on from whatever the store holds, be it of another job.
//
// All is numbers of 32 bits, lowest byte first, so the bytes are the same on every machine. They go
// through a buffer of 64 bytes. Reading makes two passes: nothing is taken over before all of it
// has been found whole.
//
//     0 magic   1 version   2 sequence   3 numbers of the body   4 its checksum   5 checksum of the
//     options   6 layers   7 bed   8 unsupported layers   9 findings   10.. five numbers of 64 bits
//     20 checksum of these
//
// Freestanding. Source of the scheme: two copies and a sequence number are what journals of small
// memories have always been; the checksum is CRC-32 (W. W. Peterson, D. T. Brown, "Cyclic Codes for
// Error Detection", Proc. IRE 49(1), 1961).

#include "base/bytes.h"
#include "base/status.h"
#include "support/chip/chip.h"

#define MAGIC UINT32_C(0x48434653) // SFCH
#define VERSION 1u
#define HEAD 21u
#define BUFFER 16u // numbers that are moved at once

enum {
    AT_MAGIC,
    AT_VERSION,
    AT_SEQUENCE,
    AT_COUNT,
    AT_BODY,
    AT_OPTIONS,
    AT_LAYERS,
    AT_BED,
    AT_UNSUPPORTED,
    AT_FINDINGS,
    AT_WIDE,
    AT_HEAD = 20
};

// ---------------------------------------------------------------------------------------------
// Checksums
// ---------------------------------------------------------------------------------------------

// CRC-32 of one more number, in steps of four bits.
static uint32_t crc_add(uint32_t crc, uint32_t number)
{
    static const uint32_t table[16] = {0x00000000u, 0x1db71064u, 0x3b6e20c8u, 0x26d930acu,
                                       0x76dc4190u, 0x6b6b51f4u, 0x4db26158u, 0x5005713cu,
                                       0xedb88320u, 0xf00f9344u, 0xd6d6a3e8u, 0xcb61b38cu,
                                       0x9b64c2b0u, 0x86d3d2d4u, 0xa00ae278u, 0xbdbdf21cu};
    for (int i = 0; i < 8; i++) {
        crc = crc >> 4 ^ table[(crc ^ number) & 15];
        number >>= 4;
    }
    return crc;
}

uint32_t sfi_chip_options_crc(const sf_chip_options *o)
{
    const sf_chip_rule *rule = &o->rule;
    const uint32_t numbers[10] = {
        o->width,          o->height,           o->first_layer, o->bed_layer,
        o->run_capacity,   o->finding_capacity, o->job,         rule->step_count,
        rule->first_layer, rule->element_count};
    uint32_t crc = ~UINT32_C(0);
    for (int i = 0; i < 10; i++) {
        crc = crc_add(crc, numbers[i]);
    }
    for (uint32_t i = 0; i < rule->element_count * (rule->reach + 2u); i++) {
        crc = crc_add(crc, rule->elements[i]);
    }
    for (uint32_t i = 0; i < rule->step_count; i++) {
        crc = crc_add(crc, rule->steps[i]);
    }
    return crc;
}

// ---------------------------------------------------------------------------------------------
// Numbers through a buffer
// ---------------------------------------------------------------------------------------------

static void store_number(uint8_t *bytes, uint32_t number)
{
    for (int i = 0; i < 4; i++) {
        bytes[i] = (uint8_t)(number >> 8 * i);
    }
}

static uint32_t load_number(const uint8_t *bytes)
{
    return bytes[0] | (uint32_t)bytes[1] << 8 | (uint32_t)bytes[2] << 16 | (uint32_t)bytes[3] << 24;
}

// A stretch of a store that is written or read from front to back.
typedef struct stretch {
    const sf_chip_store *store;
    uint32_t offset; // of what comes after the buffer
    uint32_t crc, used, filled;
    uint32_t left; // reading: numbers that have not been read yet
    uint8_t bytes[4 * BUFFER];
} stretch;

static void begin_stretch(stretch *s, const sf_chip_store *store, uint32_t offset, uint32_t left)
{
    s->store = store;
    s->offset = offset;
    s->crc = ~UINT32_C(0);
    s->used = s->filled = 0;
    s->left = left;
}

static sf_status flush(stretch *s)
{
    uint32_t size = 4 * s->used;
    if (size > 0) {
        SF_TRY(s->store->write(s->store->user, s->offset, s->bytes, size));
    }
    s->offset += size;
    s->used = 0;
    return SF_OK;
}

static sf_status put(stretch *s, uint32_t number)
{
    if (s->used == BUFFER) {
        SF_TRY(flush(s));
    }
    store_number(s->bytes + 4 * s->used++, number);
    s->crc = crc_add(s->crc, number);
    return SF_OK;
}

// The next number; no more are asked for than the stretch has.
static sf_status get(stretch *s, uint32_t *number)
{
    if (s->used == s->filled) {
        s->filled = s->left < BUFFER ? s->left : BUFFER;
        s->used = 0;
        SF_TRY(s->store->read(s->store->user, s->offset, s->bytes, 4 * s->filled));
        s->offset += 4 * s->filled;
        s->left -= s->filled;
    }
    *number = load_number(s->bytes + 4 * s->used++);
    s->crc = crc_add(s->crc, *number);
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Slots
// ---------------------------------------------------------------------------------------------

sf_status sf_chip_slot_size(const sf_chip *chip, uint32_t *size)
{
    if (chip == NULL || size == NULL) {
        return SF_ERR_ARGUMENT;
    }
    uint64_t numbers = HEAD + 4 * (uint64_t)chip->finding_capacity;
    numbers += sfi_chip_is_dense(chip) ? (uint64_t)chip->form.dense.words * chip->height
                                       : 1 + 2 * (uint64_t)chip->run_capacity;
    if (numbers > UINT32_MAX / 8) {
        return SF_ERR_OVERFLOW;
    }
    *size = (uint32_t)numbers * 4;
    return SF_OK;
}

// The head of a slot, and whether it is whole.
static sf_status read_head(const sf_chip_store *store, uint32_t slot, uint32_t *head, int *is_whole)
{
    stretch s;
    begin_stretch(&s, store, slot * store->slot_size, HEAD);
    uint32_t crc = 0;
    *is_whole = 0;
    for (uint32_t i = 0; i < HEAD; i++) {
        crc = s.crc;
        SF_TRY(get(&s, &head[i]));
    }
    *is_whole = head[AT_HEAD] == crc && head[AT_MAGIC] == MAGIC && head[AT_VERSION] == VERSION;
    return SF_OK;
}

// Whether sequence a is newer than b; numbers wrap around.
static int is_newer(uint32_t a, uint32_t b)
{
    return a - b - 1 < UINT32_C(0x7fffffff);
}

// Go on from the newest sequence number in the store.
static void find_sequence(sf_chip *chip, const sf_chip_store *store)
{
    uint32_t head[HEAD];
    for (uint32_t slot = 0; slot < 2; slot++) {
        int is_whole = 0;
        if (read_head(store, slot, head, &is_whole) == SF_OK && is_whole &&
            (chip->sequence == 0 || is_newer(head[AT_SEQUENCE], chip->sequence))) {
            chip->sequence = head[AT_SEQUENCE];
        }
    }
}

// ---------------------------------------------------------------------------------------------
// Saving
// ---------------------------------------------------------------------------------------------

static sf_status put_layer(const sf_chip *chip, stretch *s)
{
    if (sfi_chip_is_dense(chip)) {
        const sfi_chip_dense *d = &chip->form.dense;
        for (size_t i = 0; i < (size_t)d->words * chip->height; i++) {
            SF_TRY(put(s, d->slice[i]));
        }
        return SF_OK;
    }
    const sfi_chip_runs *r = &chip->form.runs;
    SF_TRY(put(s, r->below_count));
    for (uint32_t i = 0; i < r->below_count; i++) {
        SF_TRY(put(s, r->below[i].x0 | (uint32_t)r->below[i].x1 << 16));
        SF_TRY(put(s, r->below[i].y));
    }
    return SF_OK;
}

static sf_status put_findings(const sf_chip *chip, stretch *s)
{
    for (uint32_t i = 0; i < chip->counts.finding_count; i++) {
        const sf_chip_finding *f = &chip->findings[i];
        SF_TRY(put(s, f->layer));
        SF_TRY(put(s, f->y));
        SF_TRY(put(s, f->x0));
        SF_TRY(put(s, f->x1));
    }
    return SF_OK;
}

static sf_status put_head(const sf_chip *chip, stretch *s, uint32_t sequence, uint32_t count,
                          uint32_t crc)
{
    const sf_chip_counts *c = &chip->counts;
    const uint32_t numbers[AT_WIDE] = {MAGIC,           VERSION,      sequence,
                                       count,           crc,          chip->options_crc,
                                       c->layer_count,  c->bed_layer, c->unsupported_layers,
                                       c->finding_count};
    const uint64_t *wide[5] = {&c->solid_voxels, &c->unsupported_voxels, &c->unsupported_runs,
                               &c->layers_hash, &c->unsupported_hash};
    for (int i = 0; i < AT_WIDE; i++) {
        SF_TRY(put(s, numbers[i]));
    }
    for (int i = 0; i < 5; i++) {
        SF_TRY(put(s, (uint32_t)*wide[i]));
        SF_TRY(put(s, (uint32_t)(*wide[i] >> 32)));
    }
    return put(s, s->crc);
}

sf_status sf_chip_save(sf_chip *chip, const sf_chip_store *store)
{
    uint32_t size;
    if (chip == NULL || store == NULL || store->read == NULL || store->write == NULL ||
        chip->is_open || chip->failed != SF_OK) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(sf_chip_slot_size(chip, &size));
    if (store->slot_size < size || store->slot_size > UINT32_MAX / 2) {
        return SF_ERR_ARGUMENT;
    }
    if (chip->sequence == 0) {
        find_sequence(chip, store);
    }
    uint32_t sequence = chip->sequence + 1 != 0 ? chip->sequence + 1 : 2;
    uint32_t slot = sequence % 2 * store->slot_size;
    stretch s;
    begin_stretch(&s, store, slot + 4 * HEAD, 0);
    SF_TRY(put_layer(chip, &s));
    SF_TRY(put_findings(chip, &s));
    SF_TRY(flush(&s));
    uint32_t count = (s.offset - slot) / 4 - HEAD, crc = s.crc;
    begin_stretch(&s, store, slot, 0);
    SF_TRY(put_head(chip, &s, sequence, count, crc));
    SF_TRY(flush(&s));
    chip->sequence = sequence;
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Resuming
// ---------------------------------------------------------------------------------------------

// A slot's head; SF_ERR_FORMAT where that or the body that it speaks of is not whole.
static sf_status check_slot(const sf_chip_store *store, uint32_t slot, uint32_t *head)
{
    stretch s;
    uint32_t number, most = store->slot_size / 4;
    int is_whole;
    SF_TRY(read_head(store, slot, head, &is_whole));
    if (!is_whole || most < HEAD || head[AT_COUNT] > most - HEAD) {
        return SF_ERR_FORMAT;
    }
    begin_stretch(&s, store, slot * store->slot_size + 4 * HEAD, head[AT_COUNT]);
    for (uint32_t i = 0; i < head[AT_COUNT]; i++) {
        SF_TRY(get(&s, &number));
    }
    return s.crc == head[AT_BODY] ? SF_OK : SF_ERR_FORMAT;
}

// The newest slot that is whole, and its head.
static sf_status find_slot(const sf_chip_store *store, uint32_t *slot, uint32_t *head)
{
    uint32_t other[HEAD];
    sf_status first = check_slot(store, 0, head), second = check_slot(store, 1, other);
    *slot = 0;
    if (second == SF_OK && (first != SF_OK || is_newer(other[AT_SEQUENCE], head[AT_SEQUENCE]))) {
        *slot = 1;
        memcpy(head, other, sizeof other);
        return SF_OK;
    }
    return first == SF_OK || first != SF_ERR_FORMAT ? first : second;
}

// Whether the body has as many numbers as a layer and the findings take.
static int is_body_good(const sf_chip *chip, const uint32_t *head)
{
    uint32_t findings = head[AT_FINDINGS], count = head[AT_COUNT];
    if (findings > chip->finding_capacity || count < 4 * findings) {
        return 0;
    }
    count -= 4 * findings;
    if (sfi_chip_is_dense(chip)) {
        return count == (uint64_t)chip->form.dense.words * chip->height;
    }
    return count % 2 == 1 && count / 2 <= chip->run_capacity;
}

static sf_status get_layer(sf_chip *chip, stretch *s, uint32_t count)
{
    uint32_t number;
    if (sfi_chip_is_dense(chip)) {
        for (uint32_t i = 0; i < count; i++) {
            SF_TRY(get(s, &chip->form.dense.slice[i]));
        }
        return SF_OK;
    }
    sfi_chip_runs *r = &chip->form.runs;
    SF_TRY(get(s, &number));
    r->below_count = count / 2;
    for (uint32_t i = 0; i < r->below_count; i++) {
        SF_TRY(get(s, &number));
        r->below[i].x0 = (uint16_t)number;
        r->below[i].x1 = (uint16_t)(number >> 16);
        SF_TRY(get(s, &number));
        r->below[i].y = (uint16_t)number;
    }
    return SF_OK;
}

static sf_status get_findings(sf_chip *chip, stretch *s, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        sf_chip_finding *f = &chip->findings[i];
        SF_TRY(get(s, &f->layer));
        SF_TRY(get(s, &f->y));
        SF_TRY(get(s, &f->x0));
        SF_TRY(get(s, &f->x1));
    }
    return SF_OK;
}

static void take_head(sf_chip *chip, const uint32_t *head)
{
    sf_chip_counts *c = &chip->counts;
    uint64_t *wide[5] = {&c->solid_voxels, &c->unsupported_voxels, &c->unsupported_runs,
                         &c->layers_hash, &c->unsupported_hash};
    chip->sequence = head[AT_SEQUENCE];
    c->layer_count = head[AT_LAYERS];
    c->bed_layer = head[AT_BED];
    c->unsupported_layers = head[AT_UNSUPPORTED];
    c->finding_count = head[AT_FINDINGS];
    for (int i = 0; i < 5; i++) {
        *wide[i] = head[AT_WIDE + 2 * i] | (uint64_t)head[AT_WIDE + 2 * i + 1] << 32;
    }
    c->support_free = c->unsupported_voxels == 0;
}

sf_status sf_chip_resume(sf_chip *chip, const sf_chip_store *store)
{
    uint32_t head[HEAD], slot;
    if (chip == NULL || store == NULL || store->read == NULL || chip->is_open ||
        store->slot_size > UINT32_MAX / 2) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(find_slot(store, &slot, head));
    if (head[AT_OPTIONS] != chip->options_crc) {
        return SF_ERR_SHAPE;
    }
    if (!is_body_good(chip, head)) {
        return SF_ERR_FORMAT;
    }
    stretch s;
    begin_stretch(&s, store, slot * store->slot_size + 4 * HEAD, head[AT_COUNT]);
    sf_status status = get_layer(chip, &s, head[AT_COUNT] - 4 * head[AT_FINDINGS]);
    if (status == SF_OK) {
        status = get_findings(chip, &s, head[AT_FINDINGS]);
    }
    if (status != SF_OK || s.crc != head[AT_BODY]) {
        chip->failed = SF_ERR_IO;
        return SF_ERR_IO;
    }
    chip->failed = SF_OK;
    take_head(chip, head);
    return SF_OK;
}
