// SPDX-License-Identifier: MIT
// The whole core of libsf in one include. Files are apart, in <sf/io.h>, as is their library.

#ifndef SF_SF_H
#define SF_SF_H

#include <sf/base.h>
#include <sf/bend.h>
#include <sf/blend.h>
#include <sf/body.h>
#include <sf/cage.h>
#include <sf/cage_build.h>
#include <sf/cage_history.h>
#include <sf/carve.h>
#include <sf/certificate.h>
#include <sf/chip.h>
#include <sf/contour.h>
#include <sf/density.h>
#include <sf/finding.h>
#include <sf/grow.h>
#include <sf/halftone.h>
#include <sf/handles.h>
#include <sf/limit.h>
#include <sf/locate.h>
#include <sf/mesh.h>
#include <sf/mixture.h>
#include <sf/orient.h>
#include <sf/paint.h>
#include <sf/preserve.h>
#include <sf/printing.h>
#include <sf/property.h>
#include <sf/refine.h>
#include <sf/repair.h>
#include <sf/sample.h>
#include <sf/sculpt.h>
#include <sf/stance.h>
#include <sf/stand.h>
#include <sf/support.h>
#include <sf/tetra.h>
#include <sf/voxel.h>
#include <sf/weights.h>

#endif
