// SPDX-License-Identifier: MIT
// Properties: what a place of a graded solid has besides where it is.
//
// A property is known by its UUID; its name is for people. Its unit is given by the exponents of
// the seven base units, so that a file says what its numbers mean and a program can refuse to mix
// a stiffness with a density. A channel holds the values of one property over a mesh of cells: one
// for each point, or, where cells name values of their own at their corners, as many as those need;
// cells that name different values at a point that they share let the property jump there.

#ifndef SF_PROPERTY_H
#define SF_PROPERTY_H

#include <sf/base.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Bytes of a property's name, the 0 at its end included. */
#define SF_PROPERTY_NAME_SIZE 48
/** Largest number of properties of one mesh. */
#define SF_PROPERTY_MAX 64

/** What a property is. */
typedef struct sf_property {
    char name[SF_PROPERTY_NAME_SIZE]; /**< UTF-8, not empty, ended by a 0 */
    uint8_t uuid[16];                 /**< its identity, bytes as RFC 9562 orders them; not all 0 */
    int8_t si[7];                     /**< exponents of m, kg, s, A, K, mol and cd */
    double low;                       /**< no value lies below; minus infinity: no bound */
    double high;                      /**< no value lies above; infinity: no bound */
} sf_property;

/**
 * Mass density in kg/m3, 0 and more.
 *
 * @return the property, by value; its UUID, 408b9c0d-608a-45f0-9af1-ffeeda90d9ea, never changes.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API sf_property sf_property_density(void);

/**
 * Young's modulus in Pa, 0 and more.
 *
 * @return the property, by value; its UUID, 2b3d5e79-5dc1-4ea8-8d04-c48865cea0c1, never changes.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API sf_property sf_property_young(void);

/**
 * Poisson's ratio, a bare number from -1 to 0.5.
 *
 * @return the property, by value; its UUID, db254ec6-a58b-45d9-97b5-809fe7e620b2, never changes.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API sf_property sf_property_poisson(void);

/**
 * A property of which no more than the name is known: a bare number without bounds.
 *
 * Its UUID is made of the name, and the same wherever that is: the first 16 bytes of SHA-256 of
 * "libsf property " and the name, marked as version 8 of RFC 9562. Cages of files without UUIDs
 * have such properties. Whoever publishes a property draws a UUID of its own at random instead.
 *
 * @param name      1 to 47 bytes of UTF-8, ended by a 0
 * @param property  receives the property
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a name that is empty or too long.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_property_named(const char *name, sf_property *property);

/** The values of one property over a mesh. */
typedef struct sf_channel {
    sf_property property; /**< what it is */
    size_t value_count;   /**< number of values; that of the mesh's points where indices is NULL */
    const double *values; /**< finite, within the property's bounds */
    const uint32_t *indices; /**< for each corner of each cell, in the mesh's order, its value;
                                  NULL: a corner has the value of its point */
} sf_channel;

#ifdef __cplusplus
}
#endif

#endif
