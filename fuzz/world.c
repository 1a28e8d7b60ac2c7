// SPDX-License-Identifier: MIT
// The world's memory, its objects, and what is held around each call.
//
// The allocator puts each block into memory of its own, so that a sanitizer sees its ends, fills it
// with something that is not zero, and knows when a block is freed with another size than it was
// taken with. Nothing may take more than WORLD_BYTES_MAX together: more is refused, as it would be
// on a small machine, so that absurd sizes end in SF_ERR_MEMORY and not in swapping.

#include "world.h"

enum { WORLD_BYTES_MAX = 1 << 24, HEAD = 32, FILLED = 1 << 16 };

void world_fail(const world *w, const char *what)
{
    fprintf(stderr, "broken: %s: %s\n", w->function != NULL ? w->function : "(no call)", what);
    if (w->fault_given != NULL) {
        fprintf(stderr, "its sentence: %.232s\n", w->fault.message);
    }
    abort();
}

// xorshift64 (Marsaglia, 2003), seeded by the input.
static uint32_t dice(world *w)
{
    w->dice ^= w->dice << 13;
    w->dice ^= w->dice >> 7;
    w->dice ^= w->dice << 17;
    return (uint32_t)(w->dice >> 32);
}

static int is_refused(world *w, size_t size)
{
    if (!w->armed) {
        return 0;
    }
    long index = w->requests++;
    size_t most = (w->in.sane ? 16u : 1u) * (size_t)WORLD_BYTES_MAX;
    int chosen = w->fail_once ? index == w->fail_at : w->fail_at >= 0 && index >= w->fail_at;
    return chosen || dice(w) % 256 < w->chance || size > most || w->bytes + size > most;
}

static void *take(void *user, size_t size, size_t align)
{
    world *w = user;
    if (size == 0 || align == 0 || (align & (align - 1)) != 0) {
        world_fail(w, "asks for memory of no size or of an alignment that is no power of two");
    }
    if (is_refused(w, size)) {
        w->refusals++;
        return NULL;
    }
    size_t head = (HEAD + align - 1) / align * align;
    unsigned char *base = malloc(head + size + align);
    if (base == NULL) {
        w->refusals++;
        return NULL;
    }
    unsigned char *memory = base + head + (align - (uintptr_t)(base + head) % align) % align;
    // What is behind the block is given back, so that the sanitizer's end is the block's.
    uint64_t facts[2] = {(uint64_t)(memory - base), size};
    memcpy(memory - 16, facts, 16);
    memset(memory, 0xdb, size < FILLED ? size : FILLED);
    w->live++;
    w->bytes += size;
    return memory;
}

static void give(void *user, void *memory, size_t size)
{
    world *w = user;
    uint64_t facts[2];
    memcpy(facts, (unsigned char *)memory - 16, 16);
    if (facts[1] != size) {
        world_fail(w, "frees memory with another size than it was taken with");
    }
    w->live--;
    w->bytes -= size;
    free((unsigned char *)memory - facts[0]);
}

void *world_scratch(world *w, size_t size)
{
    if (w->scratch_count == w->scratch_capacity) {
        w->scratch_capacity = 2 * w->scratch_capacity + 64;
        w->scratch = realloc(w->scratch, w->scratch_capacity * sizeof *w->scratch);
    }
    void *memory = calloc(1, size > 0 ? size : 1);
    w->scratch[w->scratch_count++] = memory;
    return memory;
}

static void *note_output(world *w, void *place, size_t size, int counts)
{
    if (w->output_count == WORLD_OUTPUTS) {
        world_fail(w, "has more outputs than WORLD_OUTPUTS");
    }
    world_output output = {place, world_scratch(w, size), size, counts};
    memcpy(output.before, place, size);
    w->outputs[w->output_count++] = output;
    return place;
}

void *world_room(world *w, size_t size, int counts)
{
    if (draw_odd(&w->in, 24)) {
        return NULL;
    }
    void *place = world_scratch(w, size);
    memset(place, 0xa5, size);
    return note_output(w, place, size, counts);
}

void *world_inout(world *w, const void *held, size_t size)
{
    void *place = world_room(w, size, 0);
    if (place != NULL && held != NULL) {
        memcpy(place, held, size);
        memcpy(w->outputs[w->output_count - 1].before, held, size);
    }
    return place;
}

// --- objects -------------------------------------------------------------------------------------

static world_object *add(world *w, const char *kind, void *object, int hidden)
{
    if (object == NULL) {
        return NULL;
    }
    if (w->object_count == WORLD_OBJECTS) {
        world_destroy(kind, object);
        return NULL;
    }
    world_object entry = {kind, object, world_look(w, kind, object), hidden, 0, 0};
    w->objects[w->object_count] = entry;
    return &w->objects[w->object_count++];
}

static world_object *find(world *w, const char *kind)
{
    world_object *found[WORLD_OBJECTS];
    size_t count = 0;
    for (size_t i = 0; i < w->object_count; i++) {
        if (!w->objects[i].hidden && strcmp(w->objects[i].kind, kind) == 0) {
            found[count++] = &w->objects[i];
        }
    }
    uint32_t choice = draw_below(&w->in, 4);
    if (count == 0 || (choice == 3 && count < 4)) {
        world_object *made = add(w, kind, world_make(w, kind), 0);
        if (made != NULL || count == 0) {
            return made;
        }
    }
    return found[choice % count];
}

void *world_pick(world *w, const char *kind)
{
    if (draw_odd(&w->in, 32)) {
        return NULL;
    }
    world_object *o = find(w, kind);
    return o != NULL ? o->object : NULL;
}

void *world_need(world *w, const char *kind)
{
    world_object *o = find(w, kind);
    return o != NULL ? o->object : NULL;
}

void *world_change(world *w, const char *kind)
{
    if (draw_odd(&w->in, 32)) {
        return NULL;
    }
    world_object *o = find(w, kind);
    if (o == NULL) {
        return NULL;
    }
    o->changes = 1;
    return o->object;
}

void *world_culprits(world *w, const char *kind)
{
    void *object = world_change(w, kind);
    for (size_t i = 0; i < w->object_count; i++) {
        w->objects[i].culprits = object != NULL && w->objects[i].object == object;
    }
    return object;
}

void *world_own(world *w, const char *kind)
{
    world_object *o = add(w, kind, world_make(w, kind), 1);
    if (o == NULL) {
        return NULL;
    }
    o->changes = 1;
    return o->object;
}

void *world_give(world *w, const char *kind)
{
    return draw_odd(&w->in, 16) ? NULL : world_make(w, kind);
}

void world_keep(world *w, const char *kind, void *object)
{
    (void)add(w, kind, object, 0);
}

// --- around a call -------------------------------------------------------------------------------

void world_begin(world *w, const void *bytes, size_t size, int sane)
{
    memset(w, 0, sizeof *w);
    draw in = {bytes, size, 0, sane};
    sf_allocator allocator = {take, give, w};
    w->in = in;
    w->allocator = allocator;
    w->fail_at = w->break_at = w->cancel_at = w->cancel_wanted = -1;
    w->dice = 0x9e3779b97f4a7c15u ^ draw_word(&w->in);
    w->dice += w->dice == 0;
    uint32_t luck = draw_byte(&w->in);
    w->chance = sane || luck % 2 == 0 ? 0 : luck / 16; // half of all runs get all they ask for
    w->lattice = world_sf_lattice(w);
    if (sf_lattice_validate(&w->lattice) != SF_OK) {
        sf_lattice small = {5, 4, 3, 1, 1, 1, NULL, {0, 0, 0}};
        w->lattice = small;
    }
    w->rule = world_sf_rule(w);
    w->terms = sf_terms_default();
    w->terms.rule = w->rule;
}

void world_end(world *w)
{
    w->armed = 0;
    while (w->object_count > 0) {
        world_object *last = &w->objects[--w->object_count];
        world_destroy(last->kind, last->object);
    }
    if (w->live != 0) {
        world_fail(w, "memory is left that nobody owns");
    }
    for (size_t i = 0; i < w->scratch_count; i++) {
        free(w->scratch[i]);
    }
    free(w->scratch);
    for (size_t i = 0; i < w->file_count; i++) {
        free(w->files[i].bytes);
    }
}

void world_arm(world *w, const char *function)
{
    w->function = function;
    w->called = 1;
    w->requests = w->refusals = w->transfers = w->breaks = w->ticks = 0;
    w->progress = 0;
    w->missing = 0;
    w->armed = 1;
}

static void judge_objects(world *w, sf_status status)
{
    for (size_t i = 0; i < w->object_count; i++) {
        world_object *o = &w->objects[i];
        uint64_t now = world_look(w, o->kind, o->object);
        int failed = status != SF_OK && !(o->culprits && status == SF_ERR_INFEASIBLE);
        if (o->hash != now && (failed || !o->changes)) {
            fprintf(stderr, "it is a %s\n", o->kind);
            world_fail(w, failed ? "failed, and an object is not as it was"
                                 : "changes an object that it should only read");
        }
        o->hash = now;
        o->changes = o->culprits = 0;
    }
}

static void judge_outputs(world *w, sf_status status)
{
    for (size_t i = 0; i < w->output_count; i++) {
        const world_output *o = &w->outputs[i];
        int free_to_write =
            status == SF_OK ||
            (o->counts && (status == SF_ERR_CAPACITY || status == SF_ERR_INFEASIBLE));
        if (!free_to_write && memcmp(o->place, o->before, o->size) != 0) {
            world_fail(w, "failed, and wrote to an output");
        }
    }
    w->output_count = 0;
}

// A sentence is owed where the reason lies in somebody's data; where one is given it is of the
// status.
static void judge_fault(world *w, sf_status status)
{
    const sf_fault *fault = w->fault_given;
    if (fault == NULL) {
        return;
    }
    int said = fault->message[0] != '\0';
    int owed =
        status == SF_ERR_FORMAT || status == SF_ERR_UNSUPPORTED || status == SF_ERR_INFEASIBLE;
    if (memchr(fault->message, 0, sizeof fault->message) == NULL || (owed && !said) ||
        (said && fault->status != status)) {
        fprintf(stderr, "status %s, in the fault %s\n", sf_status_name(status),
                sf_status_name(fault->status));
        world_fail(w, "says nothing, or something of another status");
    }
    w->fault_given = NULL;
}

void world_judge(world *w, sf_status status, uint32_t codes)
{
    w->armed = 0;
    if (status == SF_ERR_IO && w->breaks + w->missing > 0) {
        codes |= 1u << SF_ERR_IO; // passed on
    }
    if ((unsigned)status >= 32 || (codes >> status & 1) == 0) {
        fprintf(stderr, "status %s\n", sf_status_name(status));
        world_fail(w, "returns a status that is not documented for it");
    }
    if (w->breaks > 0 && status == SF_OK) {
        world_fail(w, "a read or a write failed, and it says that all is well");
    }
    judge_fault(w, status);
    judge_outputs(w, status);
    judge_objects(w, status);
    w->function = NULL;
}

void world_judge_quiet(world *w)
{
    w->armed = 0;
    w->output_count = 0;
    judge_objects(w, SF_OK);
    w->function = NULL;
}
