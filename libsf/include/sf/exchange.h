// SPDX-License-Identifier: MIT
// Exchange files: tetrahedra with their properties, in HDF5, from one program to another.
//
// A file says what a solid is, and nothing of how it will be printed: positions, tetrahedra, and of
// each property its values, with the UUID that says what it means, a name, a unit and bounds.
// Corners of tetrahedra name values of their own, so that a property may jump between two
// neighbours. The layout is on a page of the documentation, docs/exchange.md, and is read by h5py
// in a few lines.

#ifndef SF_EXCHANGE_H
#define SF_EXCHANGE_H

#include <sf/base.h>
#include <sf/tetra.h>

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Whether this build reads and writes exchange files.
 *
 * @return 1 where it has libhdf5, else 0.
 * @cost constant.   @threads any.
 * @since 0.1
 */
SF_API int sf_exchange_is_served(void);

/**
 * Write tetrahedra as an exchange file: the same bytes for the same tetrahedra.
 *
 * @param tets   the tetrahedra
 * @param sink   where the bytes go, when all of them are there; on failure it may have had some
 * @param fault  NULL, or filled on failure
 * @return SF_OK; SF_ERR_ARGUMENT: a NULL pointer; SF_ERR_UNSUPPORTED: a build without libhdf5;
 * SF_ERR_MEMORY; SF_ERR_INTERNAL: libhdf5 refuses what it should take; or what the sink returned.
 * @cost the compressor's; the file is held in memory, twice for a while, from the C library.
 * @threads one at a time in a process, whatever uses libhdf5 included.
 * @source C. Altenhofen and others, "Continuous property gradation for multi-material 3D-printed
 * objects", 2018, "Export and storage format".
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_exchange_write(const sf_tets *tets, sf_sink sink, sf_fault *fault);

/**
 * Read an exchange file.
 *
 * What is there beside the layout is passed over, and nothing outside of the file is looked at:
 * links to other places or files are refused. Every count is held against the size of the file
 * before memory is taken. But libhdf5 itself was not made for files that mean harm: read those of
 * strangers in a process of its own, with limits.
 *
 * @param source     the file, read to its end
 * @param bytes_max  most bytes that are read; 0: 2^32
 * @param allocator  for the tetrahedra and for reading; NULL for the C library's, which libhdf5
 * takes in any case
 * @param tets       receives the tetrahedra; untouched on failure
 * @param fault      NULL, or filled on failure: what is wrong, and where
 * @return SF_OK; SF_ERR_FORMAT: no HDF5 file, or none of this layout; SF_ERR_UNSUPPORTED: a version
 * that is not known, a build without libhdf5; SF_ERR_OVERFLOW: a file larger than bytes_max, or
 * more than tetrahedra can be; SF_ERR_ARGUMENT: a NULL pointer, or tetrahedra that cannot be, as
 * sf_tets_create(); SF_ERR_MEMORY; SF_ERR_IO: a source that claims more than it was asked for; or
 * what the source returned.
 * @cost the file and its contents are held in memory for a while.   @threads one at a time in a
 * process, whatever uses libhdf5 included.
 * @since 0.1
 */
SF_API SF_CHECKED sf_status sf_exchange_read(sf_source source, uint64_t bytes_max,
                                             const sf_allocator *allocator, sf_tets **tets,
                                             sf_fault *fault);

#ifdef __cplusplus
}
#endif

#endif
