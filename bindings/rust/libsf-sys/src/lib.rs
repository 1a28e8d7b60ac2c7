// SPDX-License-Identifier: MIT
//! Externs of libsf, as C has them: shapes that print without supports, stand when they should, and are
//! graded between materials.
//!
//! The C sources are compiled into the crate. The feature `system` links to an installed libsf and
//! libsf-io instead, found by pkg-config; `png` and `json` are for files that need a library each.
//!
//! Every item has the comment of its header. What it says holds here too; beyond that
//!
//! - a call that can fail returns an [`sf_status`], and where that is not [`SF_OK`] it changed nothing;
//! - a pointer may be null where its comment says NULL, and nowhere else;
//! - what a call leaves behind a pointer to a pointer is the caller's, who ends it by the `_destroy` of
//!   its type;
//! - enums are numbers, because C may return a value that this version has no name for;
//! - a callback must not unwind: catch a panic, hand on a status, and resume it after the call.
//!
//! ```
//! use core::ptr;
//! use libsf_sys::*;
//!
//! let lattice = sf_lattice {
//!     nx: 4,
//!     ny: 4,
//!     nz: 2,
//!     pitch_x_mm: 0.1,
//!     pitch_y_mm: 0.1,
//!     layer_mm: 0.1,
//!     heights_mm: ptr::null(),
//!     origin_mm: [0.0; 3],
//! };
//! let mut grid = ptr::null_mut();
//! unsafe {
//!     assert_eq!(sf_grid_create(&lattice, ptr::null(), &mut grid), SF_OK);
//!     assert_eq!(sf_slice_set(sf_grid_slice(grid, 1), 2, 3, 1), SF_OK);
//!     assert_eq!(sf_grid_popcount(grid), 1);
//!     sf_grid_destroy(grid);
//! }
//! ```

#![no_std]
#![allow(non_camel_case_types)]

#[rustfmt::skip]
mod externs;
pub use externs::*;
