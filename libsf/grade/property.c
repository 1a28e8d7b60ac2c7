// SPDX-License-Identifier: MIT
// Properties that everybody means the same by.
//
// Their UUIDs were drawn at random once (RFC 9562, version 4) and are part of the interface: files
// of years ago are read by them.

#include <sf/property.h>

#include <math.h>

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
