// SPDX-License-Identifier: MIT
// Tips: the voxels that a brush covers. One is made by the caller, or belongs to a session; brushes take
// either as a reference.

use std::fmt;
use std::marker::PhantomData;
use std::mem::{zeroed, ManuallyDrop};
use std::ptr::{self, NonNull};

use crate::error::{check, Result};
use crate::grid::own;
use crate::memory::allocator;
use crate::plain::{c, of};
use crate::{sys, Dab, Error, ErrorKind, Grid, Lattice, TipShape};

#[doc = words!(sf_tip)]
///
/// ```
/// # fn main() -> libsf::Result<()> {
/// use libsf::{Tip, TipShape};
///
/// let cube = Tip::new(TipShape::Box, [2.0, 1.0, 1.0])?;
/// assert_eq!(cube.mask().count(), 5 * 3 * 3);
/// // A stamp of two pixels: three voxels high, and one.
/// let stamp = Tip::stamp(&[255, 85], 2, 1, 2, 3)?;
/// assert_eq!(stamp.mask().count(), 4);
/// # Ok(())
/// # }
/// ```
pub struct Tip {
    c: NonNull<sys::sf_tip>,
    mask: ManuallyDrop<Grid>,
    anchor: Dab,
}

// It does not change once it is made.
unsafe impl Send for Tip {}
unsafe impl Sync for Tip {}

impl Tip {
    #[doc = words!(sf_tip_create: shape, radius_vx)]
    pub fn new(shape: TipShape, radius_vx: [f64; 3]) -> Result<Tip> {
        let mut made = ptr::null_mut();
        check(unsafe { sys::sf_tip_create(shape.c(), radius_vx.as_ptr(), allocator(), &mut made) })?;
        Tip::of(made)
    }

    #[doc = words!(sf_tip_create_mask: mask, anchor)]
    pub fn of_mask(mask: &Grid, anchor: Dab) -> Result<Tip> {
        let mut made = ptr::null_mut();
        check(unsafe { sys::sf_tip_create_mask(mask.c(), c(&anchor), allocator(), &mut made) })?;
        Tip::of(made)
    }

    #[doc = words!(sf_tip_create_stamp: row_bytes, width, height, depth_vx)]
    ///
    /// `heights` are the pixels, row after row.
    pub fn stamp(heights: &[u8], width: u32, height: u32, row_bytes: usize, depth_vx: u32) -> Result<Tip> {
        let rows = (height as usize).saturating_sub(1);
        let needed = rows.checked_mul(row_bytes).and_then(|n| n.checked_add(width as usize));
        if needed.map_or(true, |needed| heights.len() < needed) {
            let said = format!("{} pixels for {height} rows of {row_bytes} bytes", heights.len());
            return Err(Error::new(ErrorKind::Shape, said));
        }
        let mut made = ptr::null_mut();
        check(unsafe {
            let pixels = heights.as_ptr();
            sys::sf_tip_create_stamp(pixels, row_bytes, width, height, depth_vx, allocator(), &mut made)
        })?;
        Tip::of(made)
    }

    fn of(made: *mut sys::sf_tip) -> Result<Tip> {
        let c = own(made)?;
        let mut anchor: sys::sf_dab = unsafe { zeroed() };
        let mask = unsafe { sys::sf_tip_mask(made, &mut anchor) };
        let lattice = Lattice::of(&unsafe { sys::sf_grid_lattice(mask) })?;
        Ok(Tip { c, mask: Grid::lent(mask, &lattice)?, anchor: of(&anchor) })
    }

    #[doc = words!(sf_tip_mask)]
    pub fn mask(&self) -> &Grid {
        &self.mask
    }

    /// The anchor's place in the mask, which comes to lie on each dab.
    pub fn anchor(&self) -> Dab {
        self.anchor
    }

    /// A reference to it, for a brush.
    pub fn as_tip(&self) -> TipRef<'_> {
        TipRef { c: self.c, tip: PhantomData }
    }
}

impl Drop for Tip {
    fn drop(&mut self) {
        unsafe { sys::sf_tip_destroy(self.c.as_ptr()) }
    }
}

impl fmt::Debug for Tip {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        to.debug_struct("Tip").field("mask", &*self.mask).field("anchor", &self.anchor).finish()
    }
}

/// A reference to a tip: one of the caller's, or one of a session's.
#[derive(Clone, Copy)]
pub struct TipRef<'t> {
    c: NonNull<sys::sf_tip>,
    tip: PhantomData<&'t Tip>,
}

// As a reference to what does not change.
unsafe impl Send for TipRef<'_> {}
unsafe impl Sync for TipRef<'_> {}

impl<'t> TipRef<'t> {
    pub(crate) fn c(&self) -> *const sys::sf_tip {
        self.c.as_ptr()
    }

    /// # Safety
    /// The tip lives as long as 't.
    pub(crate) unsafe fn of(c: *const sys::sf_tip) -> Option<TipRef<'t>> {
        NonNull::new(c.cast_mut()).map(|c| TipRef { c, tip: PhantomData })
    }

    /// A copy of its mask, and the anchor's place in it.
    pub fn mask(&self) -> Result<(Grid, Dab)> {
        let mut anchor: sys::sf_dab = unsafe { zeroed() };
        let mask = unsafe { sys::sf_tip_mask(self.c(), &mut anchor) };
        let lattice = Lattice::of(&unsafe { sys::sf_grid_lattice(mask) })?;
        Ok((Grid::lent(mask, &lattice)?.try_clone()?, of(&anchor)))
    }
}

impl<'t> From<&'t Tip> for TipRef<'t> {
    fn from(tip: &'t Tip) -> TipRef<'t> {
        tip.as_tip()
    }
}

impl fmt::Debug for TipRef<'_> {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        to.debug_struct("TipRef").finish_non_exhaustive()
    }
}
