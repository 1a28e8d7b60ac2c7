// SPDX-License-Identifier: MIT
// Certificates: a claim that a shape is support-free, with all that somebody else needs to check
// it.
//
// A certificate names a shape by its fingerprint and says under which rule, on which lattice, on
// which bed and apart from which exempt voxels it is support-free; which operation made it, out of
// which input; and how much matter there is, layer by layer. Where one look at two layers is no
// proof it holds witnesses: the integers that the rule was made into for each step, and every gap
// that a bridge spans. Making one looks at every layer anew, so there is none for a shape that is
// not support-free. sf_certificate_write() in <sf/io.h> makes a file of it, and sf-verify, which
// shares no code with the library, checks that file against a stack.
//
// What is certified is the shape on its lattice, not what smoothing or another lattice makes of it.
// A fingerprint says that nothing was changed since, by accident or by hand, in the voxels that the
// certificate speaks of; it does not say who made the certificate.

#ifndef SF_CERTIFICATE_H
#define SF_CERTIFICATE_H

#include <sf/support.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Size of a fingerprint in bytes. */
#define SF_SHA256_SIZE 32

/** What made a shape. */
typedef enum sf_operation {
    SF_OPERATION_CHECK = 0,   /**< nothing was changed */
    SF_OPERATION_TRIM = 1,    /**< matter was taken away only */
    SF_OPERATION_GROW = 2,    /**< matter was added only */
    SF_OPERATION_REPAIR = 3,  /**< both */
    SF_OPERATION_PRESERVE = 4 /**< matter was taken away only */
} sf_operation;

/**
 * Name of an operation, as certificates spell it.
 *
 * @param operation  any value
 * @return "check", "trim", "grow", "repair", "preserve", or "unknown"; a static string, never NULL.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API const char *sf_operation_name(sf_operation operation);

/**
 * Fingerprint of a grid's voxels: SHA-256 of its bits, not of its lengths.
 *
 * The bytes that are hashed are those of its stack's pictures: every row as (nx + 7) / 8 bytes,
 * voxel x being the bit of value 128 >> x % 8 in byte x / 8, solid 1, and unused bits 0; in a layer
 * rows from the largest y down, layers from the lowest up. Counts are not among them, so what
 * compares fingerprints compares lattices too.
 *
 * @param grid    the grid
 * @param task    NULL, or progress per slice; a cancel is honoured at every slice
 * @param digest  the fingerprint; untouched on failure
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer; SF_ERR_CANCELLED.
 * @cost one pass, about 5 ns a byte.   @threads any; the grid is only read.
 * @source NIST, "Secure Hash Standard", FIPS 180-4, 2015.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_grid_sha256(const sf_grid *grid, sf_task *task,
                                           uint8_t digest[SF_SHA256_SIZE]);

/** What is to be certified of a shape. Fill with sf_claim_default(). */
typedef struct sf_claim {
    size_t struct_size;      /**< sizeof(sf_claim), set by the default */
    const sf_terms *terms;   /**< rule, bed and exempt voxels; the other masks are not looked at */
    double angle_rad;        /**< angle that the rule was made for; not looked at for box3 */
    double bridge_span_mm;   /**< what sf_rule_set_bridges() was given; 0: no bridges */
    double bridge_anchor_mm; /**< the same; not looked at where there are no bridges */
    sf_operation operation;  /**< what made the shape; SF_OPERATION_CHECK by default */
    const sf_grid *before;   /**< what it was made from; NULL (default): the shape itself */
} sf_claim;

/**
 * A claim about a shape that nothing was done to, without terms, which must be set.
 *
 * @return the claim, by value.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API sf_claim sf_claim_default(void);

/** The counts of one layer. */
typedef struct sf_certificate_layer {
    uint64_t solid;   /**< solid voxels */
    uint64_t exempt;  /**< those of them that are exempt */
    uint64_t bridged; /**< those that nothing below carries, and bridges hold */
} sf_certificate_layer;

/**
 * The integers of one step, from layer k to layer k + 1.
 *
 * Box3 and octagon: voxel (dx, dy) off carries where |dx| and |dy| are at most `first` and |dx| +
 * |dy| is at most `second`. Disk and slack: the reach of the step along x and along y in 1/2^24
 * voxel; slack: and the units that the step gives.
 */
typedef struct sf_certificate_step {
    uint64_t first;  /**< see above */
    uint64_t second; /**< see above */
    uint32_t gain;   /**< slack: units that the step gives; else 0 */
} sf_certificate_step;

/**
 * One gap that a bridge spans: `length` voxels from (x, y) along a direction.
 *
 * Directions: 0 is (1, 0), 1 is (0, 1), 2 is (1, 1), 3 is (-1, 1). Listed are the gaps, as
 * sf_bridge defines them, that hold a voxel which nothing else carries; layer by layer, direction
 * by direction, and by their first such voxel, row by row.
 */
typedef struct sf_certificate_span {
    uint32_t layer;     /**< layer of the lattice */
    uint32_t direction; /**< 0 to 3 */
    uint32_t y;         /**< first voxel of the gap: its row */
    uint32_t x;         /**< and its place in it */
    uint32_t length;    /**< voxels of the gap */
} sf_certificate_span;

/** All that a certificate says. Arrays belong to the certificate. */
typedef struct sf_certificate_view {
    sf_operation operation;                /**< what made the shape */
    sf_lattice lattice;                    /**< where it lies; layer 0 is where the rule's
                                                schedule begins */
    sf_rule_kind kind;                     /**< the rule */
    double angle_rad;                      /**< its angle; 0 for box3 */
    double tangent;                        /**< the tangent that its integers come from; or 0 */
    double bridge_span_mm;                 /**< its bridges in mm; 0: none */
    double bridge_anchor_mm;               /**< carried matter at both ends of one, in mm */
    sf_bridge bridge;                      /**< the same in voxels */
    uint16_t slack_x;                      /**< slack: units in a voxel along x; else 0 */
    uint16_t slack_y;                      /**< the same along y */
    uint16_t slack_cap;                    /**< most units that a voxel has to spare */
    uint32_t bed_layer;                    /**< the bed as it was given, or SF_BED_AUTO */
    uint32_t bed;                          /**< layer that rests on the bed; nz: no matter */
    uint8_t input_sha256[SF_SHA256_SIZE];  /**< fingerprint of what the operation began with */
    uint8_t output_sha256[SF_SHA256_SIZE]; /**< fingerprint of the shape */
    uint64_t input_voxels;                 /**< solid voxels of the input */
    uint64_t output_voxels;                /**< solid voxels of the shape */
    uint64_t added_voxels;                 /**< in the shape, not in the input */
    uint64_t removed_voxels;               /**< in the input, not in the shape */
    const sf_certificate_layer *layers;    /**< nz of them */
    const sf_certificate_step *steps;      /**< integers of each step */
    size_t step_count;                     /**< nz - 1 */
    const sf_run *exempt;                  /**< maximal runs of solid exempt voxels, from the
                                                lowest layer up, row by row; label: the layer */
    size_t exempt_count;                   /**< runs */
    const sf_certificate_span *spans;      /**< gaps that bridges span */
    size_t span_count;                     /**< gaps */
} sf_certificate_view;

/** A certificate; owns its memory, and refers to no grid. */
typedef struct sf_certificate sf_certificate;

/**
 * Certify that a shape is support-free but for exempt voxels, after looking at every layer of it.
 *
 * The claim's angle and spans must be those that the rule in its terms was made from: the rule is
 * made again, and its integers compared.
 *
 * @param shape        the shape; only read
 * @param claim        what is claimed of it; it and what it points to are not needed afterwards
 * @param allocator    for the certificate and for working memory; NULL for the C library's
 * @param task         NULL, or progress per slice; a cancel is honoured at every slice
 * @param certificate  where the certificate is left, to be destroyed by the caller; untouched on
 *                     failure
 * @param fault        NULL, or filled on failure: what is wrong, for a shape that is not
 *                     support-free with the first voxel that nothing carries
 * @return SF_OK; SF_ERR_INFEASIBLE: the shape is not support-free; SF_ERR_ARGUMENT: a NULL pointer,
 * a struct without its size, terms that do not serve the shape, a rule that was not made from the
 * claimed numbers, an operation that there is not or that cannot have made this shape from that;
 * SF_ERR_SHAPE: grids that differ in counts; SF_ERR_UNSUPPORTED: what sf_rule_make() says;
 * SF_ERR_OVERFLOW; SF_ERR_MEMORY; SF_ERR_CANCELLED.
 * @cost a trim, two fingerprints, and with bridges a walk along each gap.
 * @threads any; grids are only read.
 * @source a field that the layer rule's own step reproduces proves the shape support-free, for
 * every rule that is monotone.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_certificate_make(const sf_grid *shape, const sf_claim *claim,
                                                const sf_allocator *allocator, sf_task *task,
                                                sf_certificate **certificate, sf_fault *fault);

/**
 * What a certificate says.
 *
 * @param certificate  the certificate; NULL gives a view of nothing, all zero
 * @return the view, by value; its arrays live as long as the certificate.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API sf_certificate_view sf_certificate_get_view(const sf_certificate *certificate);

/**
 * Free a certificate.
 *
 * @param certificate  the certificate, freed; NULL does nothing
 * @cost constant.   @threads one, and nobody else with this certificate.
 * @since 0.1
 */
SF_API void sf_certificate_destroy(sf_certificate *certificate);

#ifdef __cplusplus
}
#endif

#endif
