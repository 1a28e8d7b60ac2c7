// SPDX-License-Identifier: MIT
// Why: printers lose power. A state is saved after every layer while the power is cut at every byte
// that is written; whatever is left, the check goes on from the newest whole state and comes to the
// same counts, findings and hashes. What was damaged is never believed: not with any byte changed,
// not with other options, not of another job.

#include "stacks.h"

#define W 37u
#define H 9u
#define LAYERS 6u
#define RUNS 180u
#define PLACES 12u
#define STORE_SIZE 8192u

static uint64_t memory[2][1024];
static stack shape;
static judgement right;

// A store that loses power after so many bytes, or fails at a call.
typedef struct disk {
    uint8_t bytes[STORE_SIZE];
    long power; // bytes that can still be written; negative: no end
    long calls; // calls that still work; negative: no end
} disk;

static sf_status disk_read(void *user, uint32_t offset, void *data, size_t size)
{
    disk *d = user;
    if (d->calls == 0) {
        return SF_ERR_IO;
    }
    d->calls -= d->calls > 0;
    CHECK(offset + size <= STORE_SIZE);
    memcpy(data, d->bytes + offset, size);
    return SF_OK;
}

static sf_status disk_write(void *user, uint32_t offset, const void *data, size_t size)
{
    disk *d = user;
    if (d->calls == 0) {
        return SF_ERR_IO;
    }
    d->calls -= d->calls > 0;
    CHECK(offset + size <= STORE_SIZE);
    const uint8_t *from = data;
    for (size_t i = 0; i < size; i++) {
        if (d->power == 0) {
            return SF_ERR_IO;
        }
        d->power -= d->power > 0;
        d->bytes[offset + i] = from[i];
    }
    return SF_OK;
}

static sf_chip_store store_of(disk *d, const sf_chip *chip)
{
    sf_chip_store store = {disk_read, disk_write, d, 0};
    CHECK_EQ(sf_chip_slot_size(chip, &store.slot_size), SF_OK);
    CHECK(2 * store.slot_size <= STORE_SIZE);
    return store;
}

static sf_chip_options options_of(int is_dense, sf_chip_finding *findings)
{
    sf_chip_options o = sf_chip_options_default();
    o.width = W;
    o.height = H;
    o.run_capacity = is_dense ? 0 : RUNS;
    o.findings = findings;
    o.finding_capacity = PLACES;
    o.job = 7;
    return o;
}

static sf_chip *place(int which, int is_dense, sf_chip_finding *findings)
{
    sf_chip_options o = options_of(is_dense, findings);
    sf_chip *chip = NULL;
    memset(memory[which], 0x3c, sizeof memory[which]);
    CHECK_EQ(sf_chip_place(&o, memory[which], sizeof memory[which], &chip), SF_OK);
    return chip;
}

// Push what is left, and hold the end against the judgement.
static void finish(sf_chip *chip, const sf_chip_finding *findings)
{
    sf_chip_counts counts;
    CHECK_EQ(sf_chip_report(chip, &counts), SF_OK);
    for (uint32_t z = counts.layer_count; z < LAYERS; z++) {
        CHECK_EQ(sf_chip_push(chip, stack_decode, &shape), SF_OK);
    }
    CHECK_EQ(sf_chip_report(chip, &counts), SF_OK);
    check_counts(&counts, &right.counts);
    for (uint32_t i = 0; i < counts.finding_count; i++) {
        CHECK_EQ(findings[i].layer, right.findings[i].layer);
        CHECK_EQ(findings[i].x1, right.findings[i].x1);
    }
}

static void prepare(void)
{
    sf_rule rule = sf_rule_box3();
    do {
        stack_random(&shape, W, H, LAYERS);
        shape.form = AS_RUNS;
        stack_judge(&shape, &rule, 0, SF_BED_AUTO, &right);
    } while (right.counts.unsupported_runs < 2 * PLACES);
    right.counts.finding_count = PLACES;
}

// A job that saves after each layer until the power goes; returns how many states were saved whole.
static uint32_t run_until_dark(int is_dense, disk *d)
{
    sf_chip_finding findings[PLACES];
    sf_chip *chip = place(0, is_dense, findings);
    sf_chip_store store = store_of(d, chip);
    for (uint32_t z = 0; z < LAYERS; z++) {
        CHECK_EQ(sf_chip_push(chip, stack_decode, &shape), SF_OK);
        if (sf_chip_save(chip, &store) != SF_OK) {
            return z;
        }
    }
    return LAYERS;
}

static void cut_at_every_byte(int is_dense)
{
    static disk d;
    uint32_t saved = 0;
    for (long power = 0; saved < LAYERS; power++) {
        memset(&d, 0xff, sizeof d); // as flash memory is
        d.power = power;
        d.calls = -1;
        saved = run_until_dark(is_dense, &d);
        d.power = -1;
        sf_chip_finding findings[PLACES];
        sf_chip *chip = place(1, is_dense, findings);
        sf_chip_store store = store_of(&d, chip);
        sf_chip_counts counts;
        sf_status status = sf_chip_resume(chip, &store);
        CHECK_EQ(sf_chip_report(chip, &counts), SF_OK);
        CHECK_EQ(status, saved > 0 || counts.layer_count > 0 ? SF_OK : SF_ERR_FORMAT);
        // The last byte of a state makes it whole, though the call that wrote it was cut.
        CHECK(counts.layer_count == saved || counts.layer_count == saved + 1);
        if (power % 7 == 0) {
            finish(chip, findings);
            CHECK_EQ(sf_chip_save(chip, &store), SF_OK);
        }
    }
}

static void power_cuts_dense(void)
{
    prepare();
    cut_at_every_byte(1);
}

static void power_cuts_runs(void)
{
    prepare();
    cut_at_every_byte(0);
}

// Both slots hold whole states, of layers LAYERS - 1 and LAYERS.
static void two_states(int is_dense, disk *d)
{
    memset(d, 0, sizeof *d);
    d->power = d->calls = -1;
    CHECK_EQ(run_until_dark(is_dense, d), LAYERS);
}

// Any byte changed: its slot is not believed, and the other one is taken.
static void damage(int is_dense)
{
    static disk d, spoilt;
    prepare();
    two_states(is_dense, &d);
    sf_chip_finding findings[PLACES];
    sf_chip *chip = place(1, is_dense, findings);
    uint32_t slot_size = store_of(&d, chip).slot_size, fell_back = 0;
    for (uint32_t i = 0; i < 2 * slot_size; i++) {
        spoilt = d;
        spoilt.bytes[i] = (uint8_t)(spoilt.bytes[i] ^ (1u << test_random_below(8)));
        chip = place(1, is_dense, findings);
        sf_chip_store store = store_of(&spoilt, chip);
        sf_chip_counts counts;
        CHECK_EQ(sf_chip_resume(chip, &store), SF_OK);
        CHECK_EQ(sf_chip_report(chip, &counts), SF_OK);
        CHECK(counts.layer_count == LAYERS || counts.layer_count == LAYERS - 1);
        fell_back += counts.layer_count < LAYERS;
        finish(chip, findings);
    }
    CHECK(fell_back >= 84 + 4 * PLACES * 4);
    CHECK(fell_back <= slot_size);
}

static void damage_dense(void)
{
    damage(1);
}

static void damage_runs(void)
{
    damage(0);
}

// A state of another job, size, form or rule is refused, and the checker stays as it was.
static void other_options(void)
{
    static disk d;
    prepare();
    two_states(1, &d);
    for (int change = 0; change < 5; change++) {
        sf_chip_finding findings[PLACES];
        sf_chip_options o = options_of(1, findings);
        uint8_t plus[3] = {1, 1, 0};
        o.job += change == 0;
        o.width -= change == 1;
        o.bed_layer = change == 2 ? 0 : o.bed_layer;
        o.finding_capacity -= change == 3;
        o.rule.elements = change == 4 ? plus : o.rule.elements;
        sf_chip *chip = NULL;
        CHECK_EQ(sf_chip_place(&o, memory[1], sizeof memory[1], &chip), SF_OK);
        sf_chip_store store = {disk_read, disk_write, &d, STORE_SIZE / 2};
        CHECK_EQ(sf_chip_slot_size(chip, &store.slot_size), SF_OK);
        store.slot_size = store_of(&d, place(0, 1, findings)).slot_size;
        CHECK_EQ(sf_chip_resume(chip, &store), SF_ERR_SHAPE);
        sf_chip_counts counts;
        CHECK_EQ(sf_chip_report(chip, &counts), SF_OK);
        CHECK_EQ(counts.layer_count, 0);
        CHECK_EQ(counts.layers_hash, 0);
    }
}

// A new job in a store that holds an old one: its first state is the newest at once.
static void a_new_job(void)
{
    static disk d;
    prepare();
    two_states(0, &d);
    sf_chip_finding findings[PLACES];
    sf_chip_options o = options_of(0, findings);
    o.job = 8;
    for (uint32_t layers = 1; layers < 4; layers++) {
        sf_chip *chip = NULL;
        sf_chip_counts counts;
        CHECK_EQ(sf_chip_place(&o, memory[0], sizeof memory[0], &chip), SF_OK);
        sf_chip_store store = store_of(&d, chip);
        for (uint32_t z = 0; z < layers; z++) {
            CHECK_EQ(sf_chip_push(chip, stack_decode, &shape), SF_OK);
        }
        CHECK_EQ(sf_chip_save(chip, &store), SF_OK);
        CHECK_EQ(sf_chip_place(&o, memory[1], sizeof memory[1], &chip), SF_OK);
        CHECK_EQ(sf_chip_resume(chip, &store), SF_OK);
        CHECK_EQ(sf_chip_report(chip, &counts), SF_OK);
        CHECK_EQ(counts.layer_count, layers);
        finish(chip, findings);
    }
}

// Every read and every write can fail, and says so; a save can be tried again.
static void failing_calls(void)
{
    static disk d;
    prepare();
    for (int is_dense = 0; is_dense < 2; is_dense++) {
        sf_status status = SF_ERR_IO;
        for (long calls = 0; status != SF_OK && calls < 1000; calls++) {
            sf_chip_finding findings[PLACES];
            two_states(is_dense, &d);
            sf_chip *chip = place(1, is_dense, findings);
            sf_chip_store store = store_of(&d, chip);
            d.calls = calls;
            status = sf_chip_resume(chip, &store);
            CHECK(status == SF_OK || status == SF_ERR_IO);
            d.calls = -1;
            if (status != SF_OK) {
                CHECK_EQ(sf_chip_resume(chip, &store), SF_OK);
            }
            finish(chip, findings);
            // Writing again, from the other end.
            d.calls = calls;
            sf_status saved = sf_chip_save(chip, &store);
            CHECK(saved == SF_OK || saved == SF_ERR_IO);
            d.calls = -1;
            CHECK_EQ(sf_chip_save(chip, &store), SF_OK);
            CHECK_EQ(sf_chip_resume(chip, &store), SF_OK);
            finish(chip, findings);
        }
        CHECK_EQ(status, SF_OK);
    }
}

// CRC-32 as the textbook has it, bit by bit, without the last complement.
static uint32_t crc_of(const uint8_t *bytes, uint32_t size)
{
    uint32_t crc = ~UINT32_C(0);
    for (uint32_t i = 0; i < size; i++) {
        crc ^= bytes[i];
        for (int b = 0; b < 8; b++) {
            crc = crc >> 1 ^ (crc & 1 ? UINT32_C(0xedb88320) : 0);
        }
    }
    return crc;
}

static void set_number(uint8_t *bytes, uint32_t number)
{
    for (int i = 0; i < 4; i++) {
        bytes[i] = (uint8_t)(number >> 8 * i);
    }
}

static uint32_t number_at(const uint8_t *bytes)
{
    return bytes[0] | (uint32_t)bytes[1] << 8 | (uint32_t)bytes[2] << 16 | (uint32_t)bytes[3] << 24;
}

// The topmost layer, whatever the number that the state says it has.
static sf_status decode_top(void *user, sf_chip *chip, uint32_t layer, uint32_t y)
{
    (void)layer;
    return stack_decode(user, chip, LAYERS - 1, y);
}

// States whose checksums were forged: what cannot be one is refused, all else is safe to go on
// from.
static void forged(void)
{
    static disk states[2], spoilt;
    prepare();
    two_states(0, &states[0]);
    two_states(1, &states[1]);
    for (int round = 0; round < 6000; round++) {
        int is_dense = round % 2;
        sf_chip_finding findings[PLACES];
        sf_chip *chip = place(1, is_dense, findings);
        sf_chip_store store = store_of(&spoilt, chip);
        spoilt = states[is_dense];
        for (int slot = 0; slot < 2; slot++) {
            uint8_t *head = spoilt.bytes + (size_t)slot * store.slot_size;
            for (uint32_t i = test_random_below(4) + 1; i > 0; i--) {
                uint32_t at =
                    test_random_below(2) ? 6 + test_random_below(14) : 21 + test_random_below(60);
                set_number(head + 4 * at, (uint32_t)test_random() >> test_random_below(32));
            }
            if (test_random_below(4) == 0) {
                set_number(head + 12, test_random_below(store.slot_size / 4 - 20));
            }
            set_number(head + 16, crc_of(head + 84, 4 * number_at(head + 12)));
            set_number(head + 80, crc_of(head, 80));
        }
        sf_status status = sf_chip_resume(chip, &store);
        CHECK(status == SF_OK || status == SF_ERR_FORMAT);
        for (int z = 0; status == SF_OK && z < 3; z++) {
            sf_chip_counts counts;
            CHECK_EQ(sf_chip_report(chip, &counts), SF_OK);
            CHECK(counts.finding_count <= PLACES);
            shape.form = AS_RUNS;
            status = sf_chip_push(chip, decode_top, &shape);
            CHECK(status == SF_OK || status == SF_ERR_OVERFLOW);
        }
        if (status == SF_OK) {
            CHECK_EQ(sf_chip_save(chip, &store), SF_OK);
        }
    }
}

// An empty store, one that is too small, pointers that are none.
static void refusals(void)
{
    static disk d;
    prepare();
    memset(&d, 0, sizeof d);
    d.power = d.calls = -1;
    sf_chip_finding findings[PLACES];
    sf_chip *chip = place(0, 1, findings);
    sf_chip_store store = store_of(&d, chip), bad = store;
    CHECK_EQ(sf_chip_resume(chip, &store), SF_ERR_FORMAT);
    bad.slot_size = store.slot_size - 1;
    CHECK_EQ(sf_chip_save(chip, &bad), SF_ERR_ARGUMENT);
    bad.slot_size = 0;
    CHECK_EQ(sf_chip_resume(chip, &bad), SF_ERR_FORMAT);
    bad.slot_size = 0x80000000u;
    CHECK_EQ(sf_chip_save(chip, &bad), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_chip_resume(chip, &bad), SF_ERR_ARGUMENT);
    bad = store;
    bad.read = NULL;
    CHECK_EQ(sf_chip_save(chip, &bad), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_chip_resume(chip, &bad), SF_ERR_ARGUMENT);
    bad = store;
    bad.write = NULL;
    CHECK_EQ(sf_chip_save(chip, &bad), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_chip_save(chip, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_chip_save(NULL, &store), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_chip_resume(NULL, &store), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_chip_resume(chip, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_chip_slot_size(NULL, &store.slot_size), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_chip_slot_size(chip, NULL), SF_ERR_ARGUMENT);
}

int main(void)
{
    TEST(power_cuts_dense);
    TEST(power_cuts_runs);
    TEST(damage_dense);
    TEST(damage_runs);
    TEST(other_options);
    TEST(a_new_job);
    TEST(failing_calls);
    TEST(forged);
    TEST(refusals);
    return test_finish();
}
