// SPDX-License-Identifier: MIT
// Rules as tables of bytes, made where a job is made and read where it is printed.
//
// The elements of a rule's steps are few: one for box3 and for a disk on layers of one height, at
// most four for an octagon there, because pluses and squares come in Bresenham's order. So a table
// is those elements once, and a byte for each step that says which it has; the chip computes
// nothing.
//
// Two passes: the first finds how far any element reaches, which is the size of its place in the
// table; the second compares each step's element with those that are there already.
//
// Freestanding. Source: none; it is a dictionary.

#include <sf/chip.h>

#include "base/bytes.h"
#include "base/size.h"
#include "base/status.h"
#include "support/rule/carry.h"
#include "support/rule/rule.h"

// Whether every step has the same element however many there are.
static int is_one_element(const sf_rule *rule)
{
    return rule->kind == SF_RULE_BOX3 || (rule->kind == SF_RULE_DISK && rule->table == NULL);
}

static void write_element(const sf_element *element, uint32_t reach, uint8_t *bytes)
{
    memset(bytes, 0, reach + 2);
    bytes[0] = (uint8_t)element->reach_y;
    for (uint32_t dy = 0; dy <= element->reach_y; dy++) {
        bytes[1 + dy] = (uint8_t)element->half_width[dy];
    }
}

static int is_same(const uint8_t *a, const uint8_t *b, uint32_t size)
{
    uint32_t i = 0;
    while (i < size && a[i] == b[i]) {
        i++;
    }
    return i == size;
}

// The table's elements while they are gathered, one more than there is room for as a scratch.
typedef struct gathering {
    uint8_t *elements;
    uint32_t count, capacity, each; // each: bytes of an element
} gathering;

// Index of an element, which is added where it is new.
static sf_status index_of(gathering *g, const sf_element *element, uint32_t *index)
{
    uint8_t bytes[SF_REACH_MAX + 2];
    write_element(element, g->each - 2, bytes);
    for (*index = 0; *index < g->count; ++*index) {
        if (is_same(g->elements + *index * g->each, bytes, g->each)) {
            return SF_OK;
        }
    }
    if (g->count == SF_CHIP_ELEMENT_MAX) {
        return SF_ERR_UNSUPPORTED;
    }
    if (g->count == g->capacity) {
        return SF_ERR_CAPACITY;
    }
    memcpy(g->elements + g->count++ * g->each, bytes, g->each);
    return SF_OK;
}

static sf_status largest_reach(const sf_rule *rule, uint32_t first, uint32_t steps, uint32_t *reach)
{
    sf_element element;
    *reach = 0;
    for (uint32_t i = 0; i < steps; i++) {
        SF_TRY(sf_rule_element(rule, first + i, &element));
        *reach = element.reach_y > *reach ? element.reach_y : *reach;
    }
    return SF_OK;
}

// Fill the steps, which lie before the elements.
static sf_status gather(const sf_rule *rule, uint32_t first, uint32_t count, gathering *g,
                        uint8_t *steps)
{
    sf_element element = {0, {0}};
    uint32_t index = 0;
    // A table needs an element even where there is no step.
    SF_TRY(count > 0 ? sf_rule_element(rule, first, &element) : SF_OK);
    SF_TRY(index_of(g, &element, &index));
    for (uint32_t i = 0; steps != NULL && i < count; i++) {
        SF_TRY(sf_rule_element(rule, first + i, &element));
        SF_TRY(index_of(g, &element, &index));
        steps[i] = (uint8_t)index;
    }
    return SF_OK;
}

sf_status sf_chip_rule_make(const sf_rule *rule, uint32_t first_layer, uint32_t layer_count,
                            uint8_t *memory, size_t memory_size, size_t *size, sf_chip_rule *table)
{
    if (rule == NULL || size == NULL || table == NULL || layer_count == 0 ||
        (memory == NULL && memory_size > 0)) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(sfi_rule_check(rule, first_layer, layer_count));
    if (!sfi_rule_is_element(rule)) {
        return SF_ERR_UNSUPPORTED;
    }
    int is_one = is_one_element(rule);
    uint32_t count = is_one ? 1 : layer_count - 1, reach;
    SF_TRY(largest_reach(rule, first_layer, count, &reach));
    size_t steps = is_one ? 0 : count,
           most = count < SF_CHIP_ELEMENT_MAX ? count : SF_CHIP_ELEMENT_MAX;
    most = most > 0 ? most : 1;
    size_t needed;
    if (!sfi_size_add(steps, most * (reach + 2), &needed)) {
        return SF_ERR_OVERFLOW;
    }
    if (memory_size <= steps) {
        *size = needed;
        return SF_ERR_CAPACITY;
    }
    size_t fit = (memory_size - steps) / (reach + 2);
    gathering g = {memory + steps, 0, (uint32_t)(fit < most ? fit : most), reach + 2};
    sf_status status = gather(rule, first_layer, count, &g, is_one ? NULL : memory);
    if (status != SF_OK) {
        *size = status == SF_ERR_CAPACITY ? needed : *size;
        return status;
    }
    *size = steps + (size_t)g.count * g.each;
    table->elements = g.elements;
    table->steps = is_one ? NULL : memory;
    table->step_count = (uint32_t)steps;
    table->first_layer = first_layer;
    table->element_count = (uint8_t)g.count;
    table->reach = (uint8_t)reach;
    return SF_OK;
}
