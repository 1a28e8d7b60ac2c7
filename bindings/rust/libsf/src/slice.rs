// SPDX-License-Identifier: MIT
// Slices: planes of bits in somebody's memory, to be read, or to be written by one.
//
// A slice of C is a pointer and three numbers, and C believes them. So one is made here only of memory that
// is there: words of the caller's that are long enough, or a layer of a grid.

use std::fmt;
use std::marker::PhantomData;

use crate::error::{check, Result};
use crate::{sys, Error, ErrorKind, Rect};

#[doc = words!(sf_slice)]
///
/// Voxel x of row y is bit `x % 64` of word `y * stride + x / 64`; bits past the width mean nothing.
#[derive(Clone, Copy)]
pub struct Slice<'a> {
    c: sys::sf_slice,
    words: PhantomData<&'a [u64]>,
}

/// A slice that may be written.
pub struct SliceMut<'a> {
    c: sys::sf_slice,
    words: PhantomData<&'a mut [u64]>,
}

// They are references to words, no more.
unsafe impl Send for Slice<'_> {}
unsafe impl Sync for Slice<'_> {}
unsafe impl Send for SliceMut<'_> {}
unsafe impl Sync for SliceMut<'_> {}

/// Words that a slice of a size spans, from its first to its last.
fn span(width: u32, height: u32, stride: usize) -> Option<usize> {
    let row = width.div_ceil(64) as usize;
    let rows = (height as usize).checked_sub(1)?;
    if row == 0 || width > sys::SF_EXTENT_MAX || height > sys::SF_EXTENT_MAX || stride < row {
        return None;
    }
    rows.checked_mul(stride)?.checked_add(row)
}

fn fitting(words: usize, width: u32, height: u32, stride: usize) -> Result<()> {
    match span(width, height, stride) {
        None => Err(Error::new(
            ErrorKind::Argument,
            format!("no slice is {width} x {height} with rows of {stride} words"),
        )),
        Some(needed) if needed > words => {
            Err(Error::new(ErrorKind::Shape, format!("{words} words, and the slice needs {needed}")))
        }
        Some(_) => Ok(()),
    }
}

#[doc = words!(sf_slice_stride)]
pub fn slice_stride(width: u32) -> usize {
    unsafe { sys::sf_slice_stride(width) }
}

impl<'a> Slice<'a> {
    /// A slice of `width` by `height` voxels whose rows begin every `stride` words.
    pub fn new(words: &'a [u64], width: u32, height: u32, stride: usize) -> Result<Slice<'a>> {
        fitting(words.len(), width, height, stride)?;
        let c = sys::sf_slice { words: words.as_ptr().cast_mut(), width, height, stride };
        Ok(Slice { c, words: PhantomData })
    }

    /// # Safety
    /// The words must be readable for as long as the slice lives, and must not be written meanwhile.
    pub(crate) unsafe fn of(c: sys::sf_slice) -> Slice<'a> {
        Slice { c, words: PhantomData }
    }

    pub(crate) fn c(&self) -> sys::sf_slice {
        self.c
    }

    /// Voxels along x.
    pub fn width(&self) -> u32 {
        self.c.width
    }

    /// Rows along y.
    pub fn height(&self) -> u32 {
        self.c.height
    }

    /// Words from one row to the next.
    pub fn stride(&self) -> usize {
        self.c.stride
    }

    /// The words of row `y`, as many as the width needs.
    ///
    /// # Panics
    /// Where there is no such row.
    pub fn row(&self, y: u32) -> &'a [u64] {
        assert!(y < self.c.height, "row {y} of {}", self.c.height);
        let count = self.c.width.div_ceil(64) as usize;
        unsafe { std::slice::from_raw_parts(self.c.words.add(y as usize * self.c.stride), count) }
    }

    #[doc = words!(sf_slice_get)]
    pub fn get(&self, x: u32, y: u32) -> bool {
        unsafe { sys::sf_slice_get(self.c, x, y) != 0 }
    }

    #[doc = words!(sf_slice_popcount)]
    pub fn count(&self) -> u64 {
        unsafe { sys::sf_slice_popcount(self.c) }
    }

    #[doc = words!(sf_slice_bounds)]
    pub fn bounds(&self) -> Rect {
        Rect::of(&unsafe { sys::sf_slice_bounds(self.c) })
    }
}

impl PartialEq for Slice<'_> {
    fn eq(&self, other: &Slice<'_>) -> bool {
        unsafe { sys::sf_slice_equal(self.c, other.c) != 0 }
    }
}

impl Eq for Slice<'_> {}

impl fmt::Debug for Slice<'_> {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(to, "Slice({} x {}, {} solid voxels)", self.width(), self.height(), self.count())
    }
}

impl<'a> SliceMut<'a> {
    /// A slice of `width` by `height` voxels whose rows begin every `stride` words.
    pub fn new(words: &'a mut [u64], width: u32, height: u32, stride: usize) -> Result<SliceMut<'a>> {
        fitting(words.len(), width, height, stride)?;
        let c = sys::sf_slice { words: words.as_mut_ptr(), width, height, stride };
        Ok(SliceMut { c, words: PhantomData })
    }

    /// # Safety
    /// The words must be this slice's alone for as long as it lives.
    pub(crate) unsafe fn of(c: sys::sf_slice) -> SliceMut<'a> {
        SliceMut { c, words: PhantomData }
    }

    pub(crate) fn c(&mut self) -> sys::sf_slice {
        self.c
    }

    /// The same to be read.
    pub fn as_slice(&self) -> Slice<'_> {
        Slice { c: self.c, words: PhantomData }
    }

    /// The words of row `y`, as many as the width needs.
    ///
    /// # Panics
    /// Where there is no such row.
    pub fn row_mut(&mut self, y: u32) -> &mut [u64] {
        assert!(y < self.c.height, "row {y} of {}", self.c.height);
        let count = self.c.width.div_ceil(64) as usize;
        unsafe { std::slice::from_raw_parts_mut(self.c.words.add(y as usize * self.c.stride), count) }
    }

    #[doc = words!(sf_slice_set)]
    pub fn set(&mut self, x: u32, y: u32, solid: bool) -> Result<()> {
        check(unsafe { sys::sf_slice_set(self.c, x, y, solid.into()) })
    }

    #[doc = words!(sf_slice_fill: rect)]
    pub fn fill(&mut self, rect: Rect, solid: bool) -> Result<()> {
        check(unsafe { sys::sf_slice_fill(self.c, rect.c(), solid.into()) })
    }

    #[doc = words!(sf_slice_copy)]
    pub fn copy(&mut self, other: Slice<'_>) -> Result<()> {
        check(unsafe { sys::sf_slice_copy(self.c, other.c) })
    }

    #[doc = words!(sf_slice_and)]
    pub fn and(&mut self, other: Slice<'_>) -> Result<()> {
        check(unsafe { sys::sf_slice_and(self.c, self.c, other.c) })
    }

    #[doc = words!(sf_slice_or)]
    pub fn or(&mut self, other: Slice<'_>) -> Result<()> {
        check(unsafe { sys::sf_slice_or(self.c, self.c, other.c) })
    }

    #[doc = words!(sf_slice_xor)]
    pub fn xor(&mut self, other: Slice<'_>) -> Result<()> {
        check(unsafe { sys::sf_slice_xor(self.c, self.c, other.c) })
    }

    #[doc = words!(sf_slice_subtract)]
    pub fn subtract(&mut self, other: Slice<'_>) -> Result<()> {
        check(unsafe { sys::sf_slice_subtract(self.c, self.c, other.c) })
    }
}

impl fmt::Debug for SliceMut<'_> {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.as_slice().fmt(to)
    }
}
