// SPDX-License-Identifier: MIT
// Properties that everybody means the same by, and those that have a name only.
//
// The UUIDs of the known ones were drawn at random once (RFC 9562, version 4) and are part of the
// interface: files of years ago are read by them. So is the rule that makes a UUID of a name.

#include <sf/property.h>

#include "base/sha256.h"

#include <math.h>
#include <string.h>

sf_property sf_property_density(void)
{
    sf_property density = {"density",
                           {0x40, 0x8b, 0x9c, 0x0d, 0x60, 0x8a, 0x45, 0xf0, 0x9a, 0xf1, 0xff, 0xee,
                            0xda, 0x90, 0xd9, 0xea},
                           {-3, 1, 0, 0, 0, 0, 0},
                           0,
                           INFINITY};
    return density;
}

sf_property sf_property_young(void)
{
    sf_property young = {"Young's modulus",
                         {0x2b, 0x3d, 0x5e, 0x79, 0x5d, 0xc1, 0x4e, 0xa8, 0x8d, 0x04, 0xc4, 0x88,
                          0x65, 0xce, 0xa0, 0xc1},
                         {-1, 1, -2, 0, 0, 0, 0},
                         0,
                         INFINITY};
    return young;
}

sf_property sf_property_poisson(void)
{
    sf_property poisson = {"Poisson's ratio",
                           {0xdb, 0x25, 0x4e, 0xc6, 0xa5, 0x8b, 0x45, 0xd9, 0x97, 0xb5, 0x80, 0x9f,
                            0xe7, 0xe6, 0x20, 0xb2},
                           {0},
                           -1,
                           0.5};
    return poisson;
}

sf_status sf_property_named(const char *name, sf_property *property)
{
    static const char prefix[] = "libsf property ";
    sf_property made = {"", {0}, {0}, -INFINITY, INFINITY};
    size_t length = 0;
    while (name != NULL && length < sizeof made.name && name[length] != '\0') {
        length++;
    }
    if (property == NULL || length == 0 || length == sizeof made.name) {
        return SF_ERR_ARGUMENT;
    }
    memcpy(made.name, name, length);
    sfi_sha256 hash;
    uint8_t digest[SFI_SHA256_SIZE];
    sfi_sha256_begin(&hash);
    sfi_sha256_add(&hash, prefix, sizeof prefix - 1);
    sfi_sha256_add(&hash, name, length);
    sfi_sha256_end(&hash, digest);
    memcpy(made.uuid, digest, sizeof made.uuid);
    made.uuid[6] = (uint8_t)(0x80 | (made.uuid[6] & 0x0f));
    made.uuid[8] = (uint8_t)(0x80 | (made.uuid[8] & 0x3f));
    *property = made;
    return SF_OK;
}
