// SPDX-License-Identifier: MIT
// Jobs of resin printers: the layers as they will be exposed, in and out.
//
// A job is a file that a slicer made for one printer: a picture for each layer, how large a pixel
// is, how thick each layer. SL1 (a zip archive of PNG pictures and settings) is read, changed and
// written; .photon (run lengths of one bit) is read. Layers are decoded one at a time, so that jobs
// of any length pass through the memory of one layer.
//
// A pixel is solid where its grey is at least the threshold, of 255: that much light hardens it.
// Layers lie as in a stack of pictures: x to the right, and the top row of a picture is the largest
// y. Mirrors of a printer's display are not undone; they change no answer of a check.

#ifndef SF_JOB_H
#define SF_JOB_H

#include <sf/io.h>

#ifdef __cplusplus
extern "C" {
#endif

// ---------------------------------------------------------------------------------------------
// Bytes that can be read anywhere
// ---------------------------------------------------------------------------------------------

/** Bytes that can be read at any place: a file that stays as it is while it is used. */
typedef struct sf_bytes {
    /** Store the `size` bytes from `offset` on; all of them, or a status, which is passed on. Never
     * asked for what lies beyond the size below. */
    sf_status (*read_at)(void *user, uint64_t offset, void *data, size_t size);
    uint64_t size; /**< how many there are */
    void *user;    /**< handed to it; may be NULL */
} sf_bytes;

/**
 * Bytes of an open file.
 *
 * @param file   the file, which must stay open; not to be read through sf_file_source() meanwhile
 * @param bytes  receives them
 * @param fault  NULL, or filled on failure
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer; SF_ERR_IO: it is no file that has a size, or the
 * disk fails.
 * @cost constant.   @threads one per file.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_file_bytes(sf_file *file, sf_bytes *bytes, sf_fault *fault);

/**
 * Bytes of memory.
 *
 * @param memory  data and size, not NULL, which must outlive the bytes; the position is not looked
 *                at
 * @return the bytes.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API sf_bytes sf_memory_bytes(sf_memory_cursor *memory);

// ---------------------------------------------------------------------------------------------
// Reading
// ---------------------------------------------------------------------------------------------

/** Formats of jobs. */
typedef enum sf_job_format {
    SF_JOB_SL1 = 1,   /**< a zip archive with config.ini and a PNG for each layer */
    SF_JOB_PHOTON = 2 /**< .photon of the cbddlp family, versions 1 and 2, one bit a pixel */
} sf_job_format;

/** How a job is understood. Fill with sf_job_options_default(). */
typedef struct sf_job_options {
    size_t struct_size;  /**< sizeof(sf_job_options), set by the default */
    uint32_t threshold;  /**< least grey that is solid, 1..255; 128 by default */
    double pitch_mm[2];  /**< size of a pixel along x and y; 0 (default): as the job says */
    uint64_t bytes_max;  /**< most bytes of the file (default 64 GiB) */
    uint32_t layers_max; /**< most layers (default 1e6) */
} sf_job_options;

/** What a job says of itself. */
typedef struct sf_job_info {
    sf_job_format format; /**< which format it is in */
    int has_greys;        /**< whether pictures have more than black and white */
    int has_pitch;        /**< whether the job says how large a pixel is; 0: the caller did, or the
                               format's first printer was taken */
} sf_job_info;

/** A job being read. */
typedef struct sf_job sf_job;

/**
 * The default options: 128 of 255 is solid, pixels as the job says, 64 GiB and a million layers.
 *
 * @return the options, by value, with struct_size set.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API sf_job_options sf_job_options_default(void);

/**
 * Whether this build reads and writes SL1, which takes libspng and zlib; .photon is always read.
 *
 * @return 1 when it does, else 0.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API int sf_job_has_sl1(void);

/**
 * Open a job: everything but the pictures' pixels is read and checked.
 *
 * Which format it is the first bytes say. No name in it ever becomes a path, and no number is
 * believed before the bytes that it speaks of are there. What would make two readers see two jobs
 * is refused: entries that overlap or come twice, pictures of several sizes, layers that are
 * missing. An SL1 job says its pixels in prusaslicer.ini; where that is missing, pictures of 1440 x
 * 2560 are taken for the SL1's own (0.04725 mm), and others must be told of in the options.
 *
 * @param bytes      the file, which must stay
 * @param options    NULL for sf_job_options_default()
 * @param allocator  for the job and for reading; NULL for the C library's
 * @param job        receives the job, for sf_job_close(); untouched on failure
 * @param fault      NULL, or filled on failure: what is wrong, where, what to do
 * @return SF_OK; SF_ERR_FORMAT: the file is no job, or damaged; SF_ERR_UNSUPPORTED: an encrypted,
 * 64-bit or newer one, several exposures a layer, a build without SL1, or pixels of no known size;
 * SF_ERR_OVERFLOW: more than the options allow; SF_ERR_ARGUMENT: no bytes or job, options that
 * cannot be; SF_ERR_MEMORY; SF_ERR_INTERNAL: libspng refuses what it should take; or what the bytes
 * returned.
 * @cost the directory, and the head of each picture; libspng takes its memory from the C library.
 * @threads any, on distinct bytes; one at a time for each allocator.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_job_open(sf_bytes bytes, const sf_job_options *options,
                                        const sf_allocator *allocator, sf_job **job,
                                        sf_fault *fault);

/**
 * The lattice of a job: its pixels, its layers and their heights; its corner is 0, 0, 0.
 *
 * @param job  the job; NULL has a lattice of zeros
 * @return the lattice, by value; its heights_mm, if any, belong to the job.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API sf_lattice sf_job_lattice(const sf_job *job);

/**
 * What a job says of itself.
 *
 * @param job   the job
 * @param info  receives it
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_job_describe(const sf_job *job, sf_job_info *info);

/**
 * Decode a layer as it is exposed: solid where a pixel has at least the threshold.
 *
 * @param job    the job
 * @param k      the layer
 * @param slice  written, of the job's nx and ny; on failure its voxels are not to be used
 * @param fault  NULL, or filled on failure
 * @return SF_OK; SF_ERR_ARGUMENT: no job, no such layer, a slice that is none; SF_ERR_SHAPE: a
 * slice of another size; SF_ERR_FORMAT: damaged, cut short, or more pixels than there are;
 * SF_ERR_UNSUPPORTED: an interlaced picture; SF_ERR_MEMORY; SF_ERR_INTERNAL; or what the bytes
 * returned.
 * @cost one pass over its bytes and pixels.   @threads one per job.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_job_read(sf_job *job, uint32_t k, sf_slice slice, sf_fault *fault);

/**
 * Decode a layer as greys: colours count as bright as they look, and what is transparent is black.
 *
 * @param job        the job
 * @param k          the layer
 * @param pixels     written, a byte each, row 0 the lowest; on failure not to be used
 * @param row_bytes  bytes from one row to the next, at least nx
 * @param fault      NULL, or filled on failure
 * @return as sf_job_read().
 * @cost as sf_job_read().   @threads one per job.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_job_read_grey(sf_job *job, uint32_t k, uint8_t *pixels,
                                             size_t row_bytes, sf_fault *fault);

/**
 * Close a job; the bytes are the caller's.
 *
 * @param job  the job, freed; NULL does nothing
 * @cost constant.   @threads one, and nobody else with this job.
 * @since 0.1
 */
SF_API void sf_job_close(sf_job *job);

// ---------------------------------------------------------------------------------------------
// Writing
// ---------------------------------------------------------------------------------------------

/**
 * Write an SL1 job again with the layers of a grid, and everything else byte for byte.
 *
 * Layers whose voxels are as they were are copied as they lie in the archive, and so is every other
 * entry: compressed bytes, dates, attributes, comments. A layer that differs becomes a new picture
 * under its name, 8 bits of grey, stored: what was added is 255, what was taken away 0, with the
 * dim rim around it, up to 8 pixels wide, that touches nothing which is left. All other greys stay.
 *
 * @param job      an SL1 job
 * @param grid     the new layers, with the job's counts
 * @param sink     where the bytes go; on failure it may have had some
 * @param task     NULL, or progress per layer; a cancel is honoured at every layer
 * @param changed  receives the number of layers that differ; may be NULL
 * @param fault    NULL, or filled on failure
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, no sink; SF_ERR_UNSUPPORTED: another format;
 * SF_ERR_SHAPE: other counts; SF_ERR_OVERFLOW: more than 4 GiB; SF_ERR_CANCELLED; as sf_job_read();
 * or what the sink returned.
 * @cost each layer is decoded once, those that differ once more and encoded; a layer of bytes and
 * five of bits.   @threads one per job.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_job_rewrite(sf_job *job, const sf_grid *grid, sf_sink sink,
                                           sf_task *task, uint32_t *changed, sf_fault *fault);

/** What a new SL1 job says beside its layers. Fill with sf_sl1_settings_default(). */
typedef struct sf_sl1_settings {
    size_t struct_size;      /**< sizeof(sf_sl1_settings), set by the default */
    const char *name;        /**< of the job: letters, digits, - and _; "job" by default */
    double exposure_s;       /**< of a layer, 0 < it <= 1e6; 8 by default */
    double first_exposure_s; /**< of the first ones; 35 by default */
    uint32_t fade_layers;    /**< layers from the one to the other; 10 by default */
} sf_sl1_settings;

/**
 * The default settings: "job", 8 s, 35 s at first, 10 layers to fade.
 *
 * @return the settings, by value, with struct_size set.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API sf_sl1_settings sf_sl1_settings_default(void);

/**
 * Write a grid as a new SL1 job: config.ini, prusaslicer.ini with the display, a PNG a layer.
 *
 * @param grid       the layers; all heights but the first must be one
 * @param settings   NULL for sf_sl1_settings_default()
 * @param allocator  for a picture at a time; NULL for the C library's
 * @param sink       where the bytes go; on failure it may have had some
 * @param task       NULL, or progress per layer; a cancel is honoured at every layer
 * @param fault      NULL, or filled on failure
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer, no sink, settings that cannot be;
 * SF_ERR_UNSUPPORTED: layers of several heights, more than 65533, or a build without SL1;
 * SF_ERR_OVERFLOW: more than 4 GiB; SF_ERR_MEMORY; SF_ERR_CANCELLED; SF_ERR_INTERNAL; or what the
 * sink returned.
 * @cost one pass, mostly in the compressor.   @threads any that only read the grid.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_sl1_write(const sf_grid *grid, const sf_sl1_settings *settings,
                                         const sf_allocator *allocator, sf_sink sink, sf_task *task,
                                         sf_fault *fault);

#ifdef __cplusplus
}
#endif

#endif
