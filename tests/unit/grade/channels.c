// SPDX-License-Identifier: MIT
// Why: properties come out of files, so what a channel may be is checked once for all meshes, and
// a mesh that could not take one more is as it was. The bytes of the constant UUIDs are held here
// as text: files of years ago are read by them.

#include "grade/channels.h"

#include "base/memory.h"
#include "failing_allocator.h"
#include "test.h"

enum { POINTS = 5, CORNERS = 8 };

static const sfi_channel_shape shape = {POINTS, CORNERS};
static const double five[POINTS] = {1, 2, 3, 4, 5};
static const uint32_t eight[CORNERS] = {0, 1, 2, 3, 1, 2, 3, 4};

static sf_channel channel_of(sf_property property)
{
    sf_channel channel = {property, POINTS, five, NULL};
    return channel;
}

static void check_uuid(sf_property property, const char *text, int version)
{
    char found[37];
    char *at = found;
    for (int i = 0; i < 16; i++) {
        at += snprintf(at, 4, "%s%02x", i == 4 || i == 6 || i == 8 || i == 10 ? "-" : "",
                       property.uuid[i]);
    }
    CHECK_STR(found, text);
    CHECK_EQ(property.uuid[6] >> 4, version); // 4: drawn at random, 8: made by a rule
    CHECK_EQ(property.uuid[8] >> 6, 2);
    CHECK_EQ(sfi_property_check(&property, 0, NULL), SF_OK);
}

static void constant_properties_stay_what_they_are(void)
{
    sf_property density = sf_property_density(), young = sf_property_young();
    sf_property poisson = sf_property_poisson();
    check_uuid(density, "408b9c0d-608a-45f0-9af1-ffeeda90d9ea", 4);
    check_uuid(young, "2b3d5e79-5dc1-4ea8-8d04-c48865cea0c1", 4);
    check_uuid(poisson, "db254ec6-a58b-45d9-97b5-809fe7e620b2", 4);
    static const int8_t pascal[7] = {-1, 1, -2, 0, 0, 0, 0};
    CHECK(memcmp(young.si, pascal, 7) == 0);
    CHECK(density.si[0] == -3 && density.si[1] == 1 && density.si[2] == 0);
    CHECK(sfi_property_allows(&poisson, 0.5) && !sfi_property_allows(&poisson, 0.51));
    CHECK(!sfi_property_allows(&density, INFINITY) && !sfi_property_allows(&density, NAN));
}

// The UUID was made by another program, of the rule that the header states.
static void a_name_makes_a_property(void)
{
    sf_property made = sf_property_density(), again;
    char long_name[SF_PROPERTY_NAME_SIZE + 1];
    memset(long_name, 'x', sizeof long_name);
    long_name[SF_PROPERTY_NAME_SIZE] = '\0';
    CHECK_EQ(sf_property_named("stiffness", &made), SF_OK);
    check_uuid(made, "e3cb4e9e-4d9d-8698-b6aa-d73a73d6bff2", 8);
    CHECK_STR(made.name, "stiffness");
    CHECK(made.low == -INFINITY && made.high == INFINITY && made.si[1] == 0);
    again = made;
    CHECK_EQ(sf_property_named("", &again), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_property_named(long_name, &again), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_property_named(NULL, &again), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_property_named("stiffness", NULL), SF_ERR_ARGUMENT);
    CHECK_STR(again.name, made.name);
    CHECK(memcmp(again.uuid, made.uuid, sizeof made.uuid) == 0);
    long_name[SF_PROPERTY_NAME_SIZE - 1] = '\0';
    CHECK_EQ(sf_property_named(long_name, &again), SF_OK);
    CHECK_STR(again.name, long_name);
}

static void copies_are_apart_from_what_they_were_made_of(void)
{
    double values[POINTS] = {1, 2, 3, 4, 5};
    sfi_channels channels = {0};
    sf_allocator allocator = sfi_allocator_or_default(NULL);
    sf_channel channel = {sf_property_density(), POINTS, values, eight};
    CHECK_EQ(sfi_channels_copy(&channels, 1, &channel, shape, &allocator, NULL), SF_OK);
    values[0] = 100;
    CHECK(channels.at[0].values[0] == 1 && channels.at[0].indices[7] == 4);
    sf_channel young = channel_of(sf_property_young());
    CHECK_EQ(sfi_channels_add(&channels, &young, shape, &allocator, NULL), SF_OK);
    double two[2] = {8, 9};
    CHECK_EQ(sfi_channel_set(&channels.at[1], 3, 2, two), SF_OK);
    CHECK_EQ(sfi_channel_set(&channels.at[1], 4, 2, two), SF_ERR_ARGUMENT);
    two[1] = -1;
    CHECK_EQ(sfi_channel_set(&channels.at[1], 0, 2, two), SF_ERR_ARGUMENT);
    CHECK(channels.at[1].values[0] == 1 && channels.at[1].values[4] == 9);
    sfi_channels_remove(&channels, 0, shape, &allocator);
    CHECK_EQ(channels.count, 1);
    CHECK_STR(channels.at[0].property.name, "Young's modulus");
    sfi_channels_clear(&channels, shape, &allocator);
}

static void refuse(sf_channel channel, const char *part)
{
    sfi_channels channels = {0};
    sf_allocator allocator = sfi_allocator_or_default(NULL);
    sf_fault fault = {0};
    sf_channel there = channel_of(sf_property_density());
    CHECK_EQ(sfi_channels_add(&channels, &there, shape, &allocator, NULL), SF_OK);
    CHECK_EQ(sfi_channels_add(&channels, &channel, shape, &allocator, &fault), SF_ERR_ARGUMENT);
    CHECK(strstr(fault.message, part) != NULL);
    CHECK_EQ(channels.count, 1);
    sfi_channels_clear(&channels, shape, &allocator);
}

static void what_is_wrong_is_said(void)
{
    static const double odd[POINTS] = {1, 2, NAN, 4, 5};
    static const uint32_t beyond[CORNERS] = {0, 0, 0, 0, 0, 0, 0, POINTS};
    sf_channel good = channel_of(sf_property_young()), bad = good;
    refuse(channel_of(sf_property_density()), "name or the UUID of another");
    memset(bad.property.name, 'a', sizeof bad.property.name);
    refuse(bad, "name");
    bad = good;
    memcpy(bad.property.name, "\xc3", 2);
    refuse(bad, "UTF-8");
    memcpy(bad.property.name, "a\n", 3);
    refuse(bad, "control");
    memcpy(bad.property.name, "\xc3\xa4", 3); // a letter of two bytes is fine, so
    bad.property.low = NAN;
    refuse(bad, "bounds");
    bad = good;
    memset(bad.property.uuid, 0, 16);
    refuse(bad, "UUID");
    bad = good;
    bad.value_count = POINTS - 1;
    refuse(bad, "4 values for 5 points");
    bad = good;
    bad.values = odd;
    refuse(bad, "value 2 of property 1");
    bad = good;
    bad.indices = beyond;
    refuse(bad, "corner 7");
    bad = good;
    bad.values = NULL;
    refuse(bad, "no values");
}

static void there_is_an_end_to_properties(void)
{
    sfi_channels channels = {0};
    sf_allocator allocator = sfi_allocator_or_default(NULL);
    for (int i = 0; i <= SF_PROPERTY_MAX; i++) {
        sf_channel channel = channel_of(sf_property_density());
        snprintf(channel.property.name, sizeof channel.property.name, "property %d", i);
        channel.property.uuid[0] = (uint8_t)i;
        CHECK_EQ(sfi_channels_add(&channels, &channel, shape, &allocator, NULL),
                 i < SF_PROPERTY_MAX ? SF_OK : SF_ERR_ARGUMENT);
    }
    sfi_channels_clear(&channels, shape, &allocator);
}

static void without_memory_there_are_none(void)
{
    sf_channel both[2] = {channel_of(sf_property_density()), channel_of(sf_property_young())};
    both[1].indices = eight;
    for (long k = 0;; k++) {
        failing_allocator memory;
        failing_begin(&memory, k);
        sfi_channels channels = {0};
        sf_status status = sfi_channels_copy(&channels, 2, both, shape, &memory.allocator, NULL);
        CHECK(status == SF_OK || (status == SF_ERR_MEMORY && channels.count == 0));
        sfi_channels_clear(&channels, shape, &memory.allocator);
        CHECK(memory.live == 0 && memory.faults == 0);
        if (status == SF_OK) {
            CHECK_EQ(k, 3);
            break;
        }
    }
}

int main(void)
{
    TEST(constant_properties_stay_what_they_are);
    TEST(a_name_makes_a_property);
    TEST(copies_are_apart_from_what_they_were_made_of);
    TEST(what_is_wrong_is_said);
    TEST(there_is_an_end_to_properties);
    TEST(without_memory_there_are_none);
    return test_finish();
}
