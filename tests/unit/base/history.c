// SPDX-License-Identifier: MIT
// Why: an undo list that forgets the wrong step, or keeps more than it may, loses somebody's work
// or memory. Random steps, undone and redone, are held against a list that keeps everything and
// works out from the sizes alone which steps must still be there. Promise: at most so many bytes;
// the oldest go first; without memory nothing has changed.

#include "failing_allocator.h"
#include "test.h"

#include "base/history.h"

enum { STEPS = 3000, BUDGET = 500 };

// All steps ever that are not undone and overwritten: their sizes and first bytes.
typedef struct model {
    size_t first, count, done; // of those that must be kept
    size_t sizes[STEPS];
    unsigned char marks[STEPS];
} model;

static void add_to_model(model *m, size_t size, unsigned char mark)
{
    m->count = m->done;
    m->sizes[m->count] = size;
    m->marks[m->count++] = mark;
    m->done = m->count;
    size_t sum = 0, i = m->count;
    while (i > m->first && sum + m->sizes[i - 1] <= BUDGET) {
        sum += m->sizes[--i];
    }
    m->first = i;
}

static size_t bytes_of(const model *m)
{
    size_t sum = 0;
    for (size_t i = m->first; i < m->count; i++) {
        sum += m->sizes[i];
    }
    return sum;
}

static void check_step(const sfi_step *step, const model *m, size_t i)
{
    CHECK(step != NULL);
    if (step != NULL) {
        CHECK_EQ(step->size, m->sizes[i]);
        CHECK_EQ(((const unsigned char *)step->bytes)[0], m->marks[i]);
    }
}

static void steps_are_those_of_a_plain_list(void)
{
    static model m;
    failing_allocator memory;
    failing_begin(&memory, -1);
    sfi_history h;
    sfi_history_begin(BUDGET, &memory.allocator, &h);
    for (int round = 0; round < STEPS; round++) {
        unsigned way = (unsigned)(test_random() % 5);
        if (way < 2) {
            size_t size = 1 + test_random() % (round % 50 == 0 ? 2 * BUDGET : 120);
            void *bytes = NULL;
            CHECK_EQ(sfi_history_add(&h, size, &bytes), SF_OK);
            CHECK_EQ(bytes == NULL, size > BUDGET);
            add_to_model(&m, size, (unsigned char)round);
            if (bytes != NULL) {
                memset(bytes, round & 255, size);
            } else {
                m.first = m.count;
            }
        } else if (way < 4) {
            const sfi_step *step = sfi_history_back(&h);
            if (m.done == m.first) {
                CHECK(step == NULL);
            } else {
                check_step(step, &m, --m.done);
            }
        } else {
            const sfi_step *step = sfi_history_forth(&h);
            if (m.done == m.count) {
                CHECK(step == NULL);
            } else {
                check_step(step, &m, m.done++);
            }
        }
        CHECK_EQ(h.bytes, bytes_of(&m));
        CHECK_EQ(h.count, m.count - m.first);
        CHECK_EQ(h.done, m.done - m.first);
        CHECK(h.bytes <= BUDGET);
    }
    sfi_history_end(&h);
    CHECK(memory.live == 0 && memory.faults == 0);
}

static void without_memory_nothing_is_forgotten(void)
{
    for (long k = 0; k < 12; k++) {
        failing_allocator memory;
        failing_begin(&memory, k);
        sfi_history h;
        sfi_history_begin(100, &memory.allocator, &h);
        size_t good = 0;
        for (int i = 0; i < 8; i++) {
            void *bytes = NULL;
            size_t before = h.count, held = h.bytes;
            sf_status status = sfi_history_add(&h, 10, &bytes);
            CHECK(status == SF_OK || status == SF_ERR_MEMORY);
            CHECK(status == SF_OK || (h.count == before && h.bytes == held && h.done == before));
            good += status == SF_OK;
        }
        CHECK_EQ(h.count, good);
        sfi_history_end(&h);
        CHECK(memory.live == 0 && memory.faults == 0);
    }
}

int main(void)
{
    TEST(steps_are_those_of_a_plain_list);
    TEST(without_memory_nothing_is_forgotten);
    return test_finish();
}
