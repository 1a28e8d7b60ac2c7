// SPDX-License-Identifier: MIT
// Why: the codes are part of the ABI: numbers are fixed, and each has a name and a sentence.

#include "test.h"

#include "base/status.h"

static void codes_keep_their_numbers_and_names(void)
{
    static const struct {
        sf_status code;
        int number;
        const char *name;
    } all[] = {
        {SF_OK, 0, "SF_OK"},
        {SF_ERR_ARGUMENT, 1, "SF_ERR_ARGUMENT"},
        {SF_ERR_SHAPE, 2, "SF_ERR_SHAPE"},
        {SF_ERR_CAPACITY, 3, "SF_ERR_CAPACITY"},
        {SF_ERR_OVERFLOW, 4, "SF_ERR_OVERFLOW"},
        {SF_ERR_MEMORY, 5, "SF_ERR_MEMORY"},
        {SF_ERR_IO, 6, "SF_ERR_IO"},
        {SF_ERR_FORMAT, 7, "SF_ERR_FORMAT"},
        {SF_ERR_UNSUPPORTED, 8, "SF_ERR_UNSUPPORTED"},
        {SF_ERR_CANCELLED, 9, "SF_ERR_CANCELLED"},
        {SF_ERR_INTERNAL, 10, "SF_ERR_INTERNAL"},
        {SF_ERR_INFEASIBLE, 11, "SF_ERR_INFEASIBLE"},
    };
    CHECK_EQ(sizeof all / sizeof all[0], SF_STATUS_COUNT);
    for (size_t i = 0; i < sizeof all / sizeof all[0]; i++) {
        CHECK_EQ(all[i].code, all[i].number);
        CHECK_STR(sf_status_name(all[i].code), all[i].name);
        size_t length = strlen(sf_status_message(all[i].code));
        CHECK(length > 4 && sf_status_message(all[i].code)[length - 1] == '.');
    }
}

static void values_that_are_no_code_have_a_name_too(void)
{
    CHECK_STR(sf_status_name(SF_STATUS_COUNT), "SF_STATUS_UNKNOWN");
    CHECK_STR(sf_status_name((sf_status)-1), "SF_STATUS_UNKNOWN");
    CHECK(strlen(sf_status_message((sf_status)77)) > 0);
}

static void a_fault_carries_place_and_sentence_and_is_cut_to_size(void)
{
    sf_fault fault;
    CHECK_EQ(sfi_fault_set(&fault, SF_ERR_FORMAT, 3, 99, "bad %s", "vertex"), SF_ERR_FORMAT);
    CHECK_EQ(fault.status, SF_ERR_FORMAT);
    CHECK_EQ(fault.line, 3);
    CHECK_EQ(fault.offset, 99);
    CHECK_STR(fault.message, "bad vertex");
    char text[400];
    memset(text, 'x', sizeof text);
    text[sizeof text - 1] = '\0';
    CHECK_EQ(sfi_fault_set(&fault, SF_ERR_IO, 0, 0, "%s", text), SF_ERR_IO);
    CHECK_EQ(strlen(fault.message), SF_FAULT_MESSAGE_SIZE - 1);
    CHECK_EQ(sfi_fault_set(NULL, SF_ERR_IO, 0, 0, "nobody listens"), SF_ERR_IO);
}

int main(void)
{
    TEST(codes_keep_their_numbers_and_names);
    TEST(values_that_are_no_code_have_a_name_too);
    TEST(a_fault_carries_place_and_sentence_and_is_cut_to_size);
    return test_finish();
}
