// SPDX-License-Identifier: MIT
// Mixtures: which fractions of materials have the properties that are wanted.
//
// What a halftone of two materials is like is measured: stiffness, say, at some fractions. A curve
// goes through such measurements, made monotone, and is read backwards: from a property to a
// fraction. With more materials or more properties the measured mixtures are the corners of
// simplices that fill the space of fractions; between corners properties are interpolated, and a
// wanted set of them is looked up in all simplices. What no mixture has is answered with the
// nearest that one has, and with how far off that is.

#ifndef SF_MIXTURE_H
#define SF_MIXTURE_H

#include <sf/base.h>

#ifdef __cplusplus
extern "C" {
#endif

// ---------------------------------------------------------------------------------------------
// Curves
// ---------------------------------------------------------------------------------------------

/** Largest number of samples of a curve. */
#define SF_CURVE_SAMPLE_MAX 65536u

/** A measurement. */
typedef struct sf_curve_sample {
    double x;      /**< what was set: a fraction */
    double y;      /**< what was found: a property, in any unit */
    double weight; /**< how much it counts where measurements disagree, above 0; 1 */
} sf_curve_sample;

/** Which way a curve goes. */
typedef enum sf_trend {
    SF_TREND_AUTO = 0,   /**< the way that changes the samples less; up where both do alike */
    SF_TREND_RISING = 1, /**< y never falls with x */
    SF_TREND_FALLING = 2 /**< y never rises with x */
} sf_trend;

/** A monotone function through measurements. */
typedef struct sf_curve sf_curve;

/**
 * Make a curve from samples in any order.
 *
 * Samples of equal x become their mean. Where the others contradict the trend they are replaced by
 * the closest values that do not (least squares). Between them goes a cubic that is monotone and
 * smooth to its first derivative; beyond the first and the last it is constant.
 *
 * @param samples    count of them, finite, below 1e100 in size
 * @param count      at least 2 of different x, at most SF_CURVE_SAMPLE_MAX
 * @param trend      which way it goes
 * @param allocator  for the curve and for scratch; NULL for the C library's
 * @param curve      receives the curve
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, no such trend, too few samples, one that is not
 * finite or has no weight; SF_ERR_OVERFLOW: too many samples; SF_ERR_MEMORY.
 * @cost sorting the samples.   @threads any; one at a time for each allocator.
 * @source M. Ayer and others, "An empirical distribution function for sampling with incomplete
 * information", 1955 (pool adjacent violators); F. N. Fritsch, R. E. Carlson, "Monotone piecewise
 * cubic interpolation", 1980.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_curve_create(const sf_curve_sample *samples, size_t count,
                                            sf_trend trend, const sf_allocator *allocator,
                                            sf_curve **curve);

/**
 * Free a curve.
 *
 * @param curve  the curve, freed; NULL does nothing
 * @cost constant.   @threads one, and nobody else with this curve.
 * @since 0.1
 */
SF_API void sf_curve_destroy(sf_curve *curve);

/**
 * The curve at x.
 *
 * @param curve  the curve
 * @param x      anywhere
 * @param y      receives the value
 * @param slope  NULL, or receives the derivative; 0 beyond the ends
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, an x that is no number.
 * @cost a binary search.   @threads any.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_curve_value(const sf_curve *curve, double x, double *y,
                                           double *slope);

/**
 * Where the curve has a value: the least such x, or the end whose value is nearest.
 *
 * @param curve  the curve
 * @param y      the wanted value
 * @param x      receives the place
 * @param miss   NULL, or receives the value there less the wanted one: 0 but for rounding where the
 *               curve has it
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a y that is no number.
 * @cost a binary search and some ten evaluations.   @threads any.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_curve_inverse(const sf_curve *curve, double y, double *x,
                                             double *miss);

/**
 * How far the curve is from the sample that it had to leave the most; 0 for NULL.
 *
 * @param curve  the curve; NULL gives 0
 * @return a distance in y.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API double sf_curve_change(const sf_curve *curve);

// ---------------------------------------------------------------------------------------------
// Mixtures
// ---------------------------------------------------------------------------------------------

/** Largest number of materials in a mixture. */
#define SF_MIXTURE_MATERIAL_MAX 6u
/** Largest number of its properties. */
#define SF_MIXTURE_PROPERTY_MAX 8u
/** Largest number of measured mixtures. */
#define SF_MIXTURE_MAX 256u

/** What was measured. */
typedef struct sf_mixture_samples {
    size_t material_count;    /**< 2..SF_MIXTURE_MATERIAL_MAX */
    size_t property_count;    /**< 1..SF_MIXTURE_PROPERTY_MAX */
    size_t count;             /**< measured mixtures, at most SF_MIXTURE_MAX */
    const double *fractions;  /**< material_count of each: at least 0, of sum 1 within 1e-6 */
    const double *properties; /**< property_count of each, finite, below 1e100 in size */
    const double *scales;     /**< what of each property counts as one unit of error, above 0; NULL:
                                   the span that was measured */
} sf_mixture_samples;

/** Measured mixtures, and what lies between them. */
typedef struct sf_mixture sf_mixture;

/**
 * Span the space of fractions by simplices whose corners are the measured mixtures.
 *
 * The simplices are those of Delaunay; where that leaves a choice, as on a regular pattern, a fixed
 * one is made. They fill the convex hull of what was measured, so measure the pure materials too.
 *
 * @param samples    what was measured; copied. No two mixtures are closer than 0.001 in every
 *                   fraction, and they do not all lie in a plane (or on a line, or in a point)
 * @param allocator  NULL for the C library's
 * @param mixture    receives the object
 * @param fault      NULL, or receives a sentence on failure
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a count or a number out of range, mixtures that
 * are too close or too flat; SF_ERR_OVERFLOW: mixtures of which more than 2^22 simplices could be
 * made: 256 of three materials, 101 of four, 57 of five, 40 of six can be had; SF_ERR_MEMORY.
 * @cost all simplices that could be made are looked at: up to some seconds.
 * @threads any; one at a time for each allocator.
 * @source B. Delaunay, "Sur la sphere vide", 1934; K. Q. Brown, "Voronoi diagrams from convex
 * hulls", 1979.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_mixture_create(const sf_mixture_samples *samples,
                                              const sf_allocator *allocator, sf_mixture **mixture,
                                              sf_fault *fault);

/**
 * Free a mixture.
 *
 * @param mixture  the mixture, freed; NULL does nothing
 * @cost constant.   @threads one, and nobody else with this mixture.
 * @since 0.1
 */
SF_API void sf_mixture_destroy(sf_mixture *mixture);

/**
 * How many simplices there are.
 *
 * @param mixture  the mixture; NULL has none
 * @return the number; 0 for NULL.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API size_t sf_mixture_simplex_count(const sf_mixture *mixture);

/**
 * The corners of a simplex: as many measured mixtures as there are materials, in rising order.
 *
 * @param mixture  the mixture
 * @param simplex  which, below sf_mixture_simplex_count()
 * @param corners  receives the numbers of the measured mixtures, as many as there are materials
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, no such simplex.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_mixture_simplex(const sf_mixture *mixture, size_t simplex,
                                               uint32_t *corners);

/**
 * What properties a mixture has: forwards, from fractions.
 *
 * @param mixture     what was measured
 * @param fractions   one for each material; those that lie in no simplex are replaced by the
 * nearest that do
 * @param properties  receives one number for each property
 * @param miss        NULL, or receives how far the fractions lay from the nearest: 0 within
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a fraction that is not finite.
 * @cost a small linear system for each simplex.   @threads any.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_mixture_properties(const sf_mixture *mixture,
                                                  const double *fractions, double *properties,
                                                  double *miss);

/**
 * Which fractions have the wanted properties: backwards; or the nearest properties that some have.
 *
 * Errors are measured in scales of each property, squared and added. Where several mixtures do
 * equally well it is one in the first simplex that holds one: fewer properties than materials less
 * one leave such a choice.
 *
 * @param mixture    what was measured
 * @param wanted     one number for each property
 * @param hint       NULL, or the simplex to look in first, which receives where the answer was: for
 *                   many points that lie together. Where several simplices have what is wanted, it
 *                   decides; any number will do to begin with.
 * @param fractions  receives one for each material: at least 0, of sum 1
 * @param obtained   NULL, or receives the properties of that mixture
 * @param miss       NULL, or receives the distance of these from the wanted, in scales
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, a wanted property that is not finite.
 * @cost a small linear system where the hint is right, else up to one for each face of each
 * simplex.
 * @threads any; one at a time for each hint.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_mixture_fractions(const sf_mixture *mixture, const double *wanted,
                                                 size_t *hint, double *fractions, double *obtained,
                                                 double *miss);

#ifdef __cplusplus
}
#endif

#endif
