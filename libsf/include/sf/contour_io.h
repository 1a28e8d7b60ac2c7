// SPDX-License-Identifier: MIT
// Files of contours: CLI, the Common Layer Interface, in text and in binary.
//
// A CLI file has layers with their heights, and in each polygons that say whether they are an
// outside or a hole. Lines that are open and hatches enclose nothing and are passed over.

#ifndef SF_CONTOUR_IO_H
#define SF_CONTOUR_IO_H

#include <sf/io.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Kinds of CLI files. */
typedef enum sf_contour_format {
    SF_CONTOUR_CLI_TEXT = 0,  /**< numbers as text, which read back as the same doubles */
    SF_CONTOUR_CLI_BINARY = 1 /**< floats of 32 bits */
} sf_contour_format;

/**
 * Read a CLI file, text or binary, with short or long numbers.
 *
 * A layer's height is that of its top; the lowest one is as thick as the step to the next (where
 * there is only one: down to 0, or a millimetre where it lies there or below). A polygon that says
 * it is an outside turns to the left afterwards, one that says it is a hole to the right, so that
 * SF_CONTOUR_NONZERO is the fill to take. Layers of one height that follow each other are one.
 *
 * No count is believed: memory grows as points come. Refused are heights that fall, numbers that
 * are not finite, another number of layers than the head says, and files that end early.
 *
 * @param source     the file
 * @param limits     NULL for sf_read_limits_default(); bytes and vertices count
 * @param allocator  for the stack and for reading; NULL for the C library's
 * @param stack      receives the stack, to be destroyed by the caller; untouched on failure
 * @param fault      NULL, or filled on failure, with the line or byte
 * @return SF_OK; SF_ERR_FORMAT: no CLI file, or a damaged one; SF_ERR_OVERFLOW: more than `limits`;
 * SF_ERR_MEMORY; SF_ERR_ARGUMENT: a NULL pointer, a source without `read`; or what the source
 * returned.
 * @cost one pass.   @threads any, on distinct sources; one at a time for each allocator.
 * @source "Common Layer Interface (CLI), Version 2.0", Brite EuRam BE 2578, 1994.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_contour_stack_read(sf_source source, const sf_read_limits *limits,
                                                  const sf_allocator *allocator,
                                                  sf_contour_stack **stack, sf_fault *fault);

/**
 * Write a stack as a CLI file, in mm.
 *
 * What turns to the left is written as an outside, what turns to the right as a hole. The file does
 * not say where the lowest layer begins.
 *
 * @param stack   the stack
 * @param format  text or binary
 * @param sink    where the bytes go; on failure it may have had some
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, no sink, no such format; SF_ERR_OVERFLOW: in
 * binary, a polygon of 2^31 points or more; or what the sink returned.
 * @cost one pass; 12 KiB of stack, no memory.   @threads any, on distinct sinks.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_contour_stack_write(const sf_contour_stack *stack,
                                                   sf_contour_format format, sf_sink sink);

#ifdef __cplusplus
}
#endif

#endif
