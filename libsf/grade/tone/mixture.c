// SPDX-License-Identifier: MIT
// Measured mixtures, read forwards and backwards.
//
// Forwards a mixture is located among the simplices and properties are interpolated with its
// barycentric coordinates. Backwards the same simplices, with their corners at the measured
// properties, are looked through for the wanted ones; each either holds them, or has a nearest
// point. Both are one question: the nearest point of a simplex whose corners stand in this space or
// in that.

#include <sf/mixture.h>

#include "base/memory.h"
#include "base/status.h"
#include "grade/tone/nearest.h"
#include "grade/tone/simplices.h"

#include <math.h>
#include <string.h>

#define LARGEST 1e100
#define SUM_SLACK 1e-6
#define CLOSEST 1e-3
// Squared, in scales: nothing is nearer than this.
#define HIT 1e-24

struct sf_mixture {
    size_t materials, properties, count;
    double *fractions; // of sum 1
    double *scaled;    // properties in scales
    double scales[SF_MIXTURE_PROPERTY_MAX];
    sfi_simplices simplices;
    sf_allocator allocator;
};

// ---------------------------------------------------------------------------------------------
// Making and freeing
// ---------------------------------------------------------------------------------------------

static const char *fault_in_numbers(const sf_mixture_samples *s)
{
    for (size_t i = 0; i < s->count; i++) {
        double sum = 0.0;
        for (size_t j = 0; j < s->material_count; j++) {
            double f = s->fractions[i * s->material_count + j];
            if (!(f >= 0.0 && f <= 1.0 + SUM_SLACK)) {
                return "A fraction of a measured mixture is not between 0 and 1.";
            }
            sum += f;
        }
        if (!(fabs(sum - 1.0) <= SUM_SLACK)) {
            return "The fractions of a measured mixture do not add up to 1.";
        }
        for (size_t j = 0; j < s->property_count; j++) {
            if (!(fabs(s->properties[i * s->property_count + j]) < LARGEST)) {
                return "A measured property is not a finite number.";
            }
        }
    }
    for (size_t j = 0; s->scales != NULL && j < s->property_count; j++) {
        if (!(s->scales[j] > 1e-100 && s->scales[j] < LARGEST)) {
            return "The scale of a property is not above 0.";
        }
    }
    return NULL;
}

static const char *fault_in_samples(const sf_mixture_samples *s)
{
    if (s == NULL || s->fractions == NULL || s->properties == NULL) {
        return "The measured mixtures are missing.";
    }
    if (s->material_count < 2 || s->material_count > SF_MIXTURE_MATERIAL_MAX ||
        s->property_count < 1 || s->property_count > SF_MIXTURE_PROPERTY_MAX ||
        s->count < s->material_count || s->count > SF_MIXTURE_MAX) {
        return "A mixture has 2 to 6 materials, 1 to 8 properties, and 256 measurements at most, "
               "but "
               "as many as materials.";
    }
    return fault_in_numbers(s);
}

static int some_are_close(const sf_mixture *m)
{
    for (size_t i = 0; i < m->count; i++) {
        for (size_t k = 0; k < i; k++) {
            double apart = 0.0;
            for (size_t j = 0; j < m->materials; j++) {
                double d =
                    fabs(m->fractions[i * m->materials + j] - m->fractions[k * m->materials + j]);
                apart = d > apart ? d : apart;
            }
            if (apart < CLOSEST) {
                return 1;
            }
        }
    }
    return 0;
}

static void copy_fractions(sf_mixture *m, const double *from)
{
    for (size_t i = 0; i < m->count; i++) {
        const double *f = from + i * m->materials;
        double sum = 0.0;
        for (size_t j = 0; j < m->materials; j++) {
            sum += f[j];
        }
        for (size_t j = 0; j < m->materials; j++) {
            m->fractions[i * m->materials + j] = f[j] / sum;
        }
    }
}

static void copy_properties(sf_mixture *m, const sf_mixture_samples *s)
{
    for (size_t j = 0; j < m->properties; j++) {
        double low = s->properties[j], high = low;
        for (size_t i = 1; i < m->count; i++) {
            double p = s->properties[i * m->properties + j];
            low = p < low ? p : low;
            high = p > high ? p : high;
        }
        double span = high - low > 1e-100 ? high - low : 1.0;
        m->scales[j] = s->scales != NULL ? s->scales[j] : span;
        for (size_t i = 0; i < m->count; i++) {
            m->scaled[i * m->properties + j] = s->properties[i * m->properties + j] / m->scales[j];
        }
    }
}

static sf_status fill(sf_mixture *m, const sf_mixture_samples *samples, sf_fault *fault)
{
    m->fractions = sfi_alloc_array(&m->allocator, m->count * m->materials, sizeof(double));
    m->scaled = sfi_alloc_array(&m->allocator, m->count * m->properties, sizeof(double));
    if (m->fractions == NULL || m->scaled == NULL) {
        return sfi_fault_set(fault, SF_ERR_MEMORY, 0, 0, "There is too little memory.");
    }
    copy_fractions(m, samples->fractions);
    copy_properties(m, samples);
    if (some_are_close(m)) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                             "Two measured mixtures differ by less than 0.001 in every fraction: "
                             "replace them by their mean.");
    }
    sf_status status =
        sfi_simplices_create(m->fractions, m->count, m->materials, &m->allocator, &m->simplices);
    if (status != SF_OK) {
        return sfi_fault_set(fault, status, 0, 0, "There is too little memory.");
    }
    if (m->simplices.count == 0) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                             "All measured mixtures lie in a plane of the space of fractions: "
                             "measure one outside, or leave a material out.");
    }
    return SF_OK;
}

sf_status sf_mixture_create(const sf_mixture_samples *samples, const sf_allocator *allocator,
                            sf_mixture **mixture, sf_fault *fault)
{
    sf_allocator a = sfi_allocator_or_default(allocator);
    const char *wrong = fault_in_samples(samples);
    if (wrong != NULL || mixture == NULL) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "%s",
                             wrong != NULL ? wrong : "There is no place for the mixture.");
    }
    if (!sfi_simplices_fit(samples->count, samples->material_count)) {
        return sfi_fault_set(fault, SF_ERR_OVERFLOW, 0, 0,
                             "There are too many measured mixtures for so many materials: of four "
                             "101, of five 57, of six 40 can be had.");
    }
    sf_mixture *m = sfi_alloc_array(&a, 1, sizeof *m);
    if (m == NULL) {
        return sfi_fault_set(fault, SF_ERR_MEMORY, 0, 0, "There is too little memory.");
    }
    memset(m, 0, sizeof *m);
    m->materials = samples->material_count;
    m->properties = samples->property_count;
    m->count = samples->count;
    m->allocator = a;
    sf_status status = fill(m, samples, fault);
    if (status != SF_OK) {
        sf_mixture_destroy(m);
        return status;
    }
    *mixture = m;
    return SF_OK;
}

void sf_mixture_destroy(sf_mixture *mixture)
{
    if (mixture != NULL) {
        sf_allocator a = mixture->allocator;
        sfi_free_array(&a, mixture->fractions, mixture->count * mixture->materials, sizeof(double));
        sfi_free_array(&a, mixture->scaled, mixture->count * mixture->properties, sizeof(double));
        sfi_simplices_destroy(&mixture->simplices, &a);
        sfi_free_array(&a, mixture, 1, sizeof *mixture);
    }
}

size_t sf_mixture_simplex_count(const sf_mixture *mixture)
{
    return mixture != NULL ? mixture->simplices.count : 0;
}

sf_status sf_mixture_simplex(const sf_mixture *mixture, size_t simplex, uint32_t *corners)
{
    if (mixture == NULL || corners == NULL || simplex >= mixture->simplices.count) {
        return SF_ERR_ARGUMENT;
    }
    memcpy(corners, mixture->simplices.corners + simplex * mixture->materials,
           mixture->materials * sizeof *corners);
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Forwards and backwards
// ---------------------------------------------------------------------------------------------

// A point of a simplex.
typedef struct spot {
    size_t simplex;
    double weights[SFI_SOLVE_MAX];
    double distance; // squared, from what was looked for; negative: none yet
} spot;

static void look_in(const sf_mixture *m, size_t simplex, const double *points, size_t dimensions,
                    const double *p, spot *best)
{
    const uint32_t *corners = m->simplices.corners + simplex * m->materials;
    sfi_corners c = {{NULL}, (int)m->materials, (int)dimensions};
    double weights[SFI_SOLVE_MAX];
    for (size_t i = 0; i < m->materials; i++) {
        c.at[i] = points + corners[i] * dimensions;
    }
    double distance = sfi_nearest(&c, p, weights);
    if (best->distance < 0.0 || distance < best->distance) {
        best->simplex = simplex;
        best->distance = distance;
        memcpy(best->weights, weights, sizeof weights);
    }
}

static spot look(const sf_mixture *m, const double *points, size_t dimensions, const double *p,
                 size_t hint)
{
    spot best = {0, {0.0}, -1.0};
    if (hint < m->simplices.count) {
        look_in(m, hint, points, dimensions, p, &best);
    }
    for (size_t i = 0; i < m->simplices.count && !(best.distance >= 0.0 && best.distance <= HIT);
         i++) {
        look_in(m, i, points, dimensions, p, &best);
    }
    return best;
}

// The same point of the simplex in another space.
static void carry_over(const sf_mixture *m, const spot *s, const double *points, size_t dimensions,
                       double *to)
{
    const uint32_t *corners = m->simplices.corners + s->simplex * m->materials;
    for (size_t d = 0; d < dimensions; d++) {
        to[d] = 0.0;
        for (size_t i = 0; i < m->materials; i++) {
            to[d] += s->weights[i] * points[corners[i] * dimensions + d];
        }
    }
}

static int all_finite(const double *values, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        if (!(fabs(values[i]) < LARGEST)) {
            return 0;
        }
    }
    return 1;
}

sf_status sf_mixture_properties(const sf_mixture *mixture, const double *fractions,
                                double *properties, double *miss)
{
    if (mixture == NULL || fractions == NULL || properties == NULL ||
        !all_finite(fractions, mixture->materials)) {
        return SF_ERR_ARGUMENT;
    }
    spot at = look(mixture, mixture->fractions, mixture->materials, fractions, SIZE_MAX);
    carry_over(mixture, &at, mixture->scaled, mixture->properties, properties);
    for (size_t j = 0; j < mixture->properties; j++) {
        properties[j] *= mixture->scales[j];
    }
    if (miss != NULL) {
        *miss = at.distance <= HIT ? 0.0 : sqrt(at.distance);
    }
    return SF_OK;
}

sf_status sf_mixture_fractions(const sf_mixture *mixture, const double *wanted, size_t *hint,
                               double *fractions, double *obtained, double *miss)
{
    double scaled[SF_MIXTURE_PROPERTY_MAX];
    if (mixture == NULL || wanted == NULL || fractions == NULL ||
        !all_finite(wanted, mixture->properties)) {
        return SF_ERR_ARGUMENT;
    }
    for (size_t j = 0; j < mixture->properties; j++) {
        scaled[j] = wanted[j] / mixture->scales[j];
    }
    spot at = look(mixture, mixture->scaled, mixture->properties, scaled,
                   hint != NULL ? *hint : SIZE_MAX);
    carry_over(mixture, &at, mixture->fractions, mixture->materials, fractions);
    if (obtained != NULL) {
        carry_over(mixture, &at, mixture->scaled, mixture->properties, obtained);
        for (size_t j = 0; j < mixture->properties; j++) {
            obtained[j] *= mixture->scales[j];
        }
    }
    if (hint != NULL) {
        *hint = at.simplex;
    }
    if (miss != NULL) {
        *miss = at.distance <= HIT ? 0.0 : sqrt(at.distance);
    }
    return SF_OK;
}
