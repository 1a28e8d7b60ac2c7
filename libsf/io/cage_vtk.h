// SPDX-License-Identifier: MIT
// What a VTK file of a cage has besides what every VTK file has: names that its writer and its
// reader agree on. Other programs see data and fields of these names, and may leave them alone.

#ifndef SF_IO_CAGE_VTK_H
#define SF_IO_CAGE_VTK_H

// Data of points: which point this one is a copy of.
#define SFI_VTK_POINT_NAME "sf_point"

// Fields of the grid. Rows of two points and a sharpness; of a point and a sharpness.
#define SFI_VTK_CREASES_NAME "sf_creases"
#define SFI_VTK_SHARPS_NAME "sf_sharps"

// For each property a field of this name and its own: one row of so many numbers, the 16 bytes of
// the UUID, the 7 exponents of its unit, whether it has a low bound, the low bound or 0, and the
// same for the high one. There is no infinity in VTK's text.
#define SFI_VTK_PROPERTY_NAME "sf_property:"
#define SFI_VTK_PROPERTY_NUMBERS 27

#endif
