// SPDX-License-Identifier: MIT
// Masks: blocks of ranks that are repeated through space, by which tones become materials.

use std::fmt;
use std::ptr::{self, NonNull};

use crate::error::{check, Result};
use crate::grid::own;
use crate::made::Made;
use crate::memory::allocator;
use crate::task::run;
use crate::{sys, Error, ErrorKind, MaskKind, Task};

#[doc = words!(sf_mask_options)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MaskOptions {
    /// Between which voxels it keeps what is alike apart.
    pub kind: MaskKind,
    /// Its period in voxels along x, a power of two in 4..=256, and along y and z, 1..=256.
    pub size: [u32; 3],
    #[doc = words!(sf_mask_options.pitch_mm)]
    pub pitch_mm: [f64; 3],
    #[doc = words!(sf_mask_options.spread)]
    pub spread: f64,
    #[doc = words!(sf_mask_options.seed)]
    pub seed: u64,
}

impl Default for MaskOptions {
    fn default() -> MaskOptions {
        let c = unsafe { sys::sf_mask_options_default() };
        MaskOptions {
            kind: MaskKind::of(c.kind),
            size: [c.nx, c.ny, c.nz],
            pitch_mm: c.pitch_mm,
            spread: c.spread,
            seed: c.seed,
        }
    }
}

#[doc = words!(sf_mask)]
///
/// ```
/// # fn main() -> libsf::Result<()> {
/// use libsf::Mask;
///
/// let mask = Mask::builtin();
/// assert_eq!(mask.size(), [32; 3]);
/// assert_eq!(mask.rank(3, 4, 5), mask.rank(35, 36, 37));
/// let checker = Mask::from_ranks([4, 2, 1], &[0, 4, 1, 5, 6, 2, 7, 3])?;
/// assert_eq!(checker.rank(1, 1, 9), 2);
/// # Ok(())
/// # }
/// ```
pub struct Mask {
    c: NonNull<sys::sf_mask>,
}

// It does not change once it is made.
unsafe impl Send for Mask {}
unsafe impl Sync for Mask {}

impl Mask {
    #[doc = words!(sf_mask_builtin)]
    pub fn builtin() -> Mask {
        let c = unsafe { sys::sf_mask_builtin() };
        // Freeing it does nothing.
        Mask { c: NonNull::new(c.cast_mut()).expect("a mask that is part of the library") }
    }

    #[doc = words!(sf_mask_create)]
    pub fn new(options: &MaskOptions, task: Option<&mut Task<'_>>) -> Result<Mask> {
        let mut c = unsafe { sys::sf_mask_options_default() };
        c.kind = options.kind.c();
        [c.nx, c.ny, c.nz] = options.size;
        c.pitch_mm = options.pitch_mm;
        c.spread = options.spread;
        c.seed = options.seed;
        let mut made = Made::new(sys::sf_mask_destroy);
        check(run(task, |task| unsafe { sys::sf_mask_create(&c, allocator(), task, made.place()) }))?;
        Ok(Mask { c: made.own()? })
    }

    #[doc = words!(sf_mask_from_ranks: ranks)]
    ///
    /// - `size`: the period along x, y and z
    pub fn from_ranks(size: [u32; 3], ranks: &[u32]) -> Result<Mask> {
        let voxels = size.iter().try_fold(1u64, |n, &one| n.checked_mul(one.into()));
        if voxels != Some(ranks.len() as u64) {
            let said = format!("{} ranks for a mask of {size:?}", ranks.len());
            return Err(Error::new(ErrorKind::Shape, said));
        }
        let mut made = ptr::null_mut();
        let ([nx, ny, nz], from) = (size, ranks.as_ptr());
        check(unsafe { sys::sf_mask_from_ranks(nx, ny, nz, from, allocator(), &mut made) })?;
        Ok(Mask { c: own(made)? })
    }

    pub(crate) fn c(&self) -> *const sys::sf_mask {
        self.c.as_ptr()
    }

    #[doc = words!(sf_mask_size)]
    pub fn size(&self) -> [u32; 3] {
        let mut size = [0; 3];
        unsafe { sys::sf_mask_size(self.c(), size.as_mut_ptr()) };
        size
    }

    #[doc = words!(sf_mask_rank)]
    pub fn rank(&self, x: u32, y: u32, z: u32) -> u32 {
        unsafe { sys::sf_mask_rank(self.c(), x, y, z) }
    }
}

impl Drop for Mask {
    fn drop(&mut self) {
        unsafe { sys::sf_mask_destroy(self.c.as_ptr()) }
    }
}

impl fmt::Debug for Mask {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [nx, ny, nz] = self.size();
        write!(to, "Mask({nx} x {ny} x {nz})")
    }
}
