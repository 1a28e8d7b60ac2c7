// SPDX-License-Identifier: MIT
// Grids: voxels on a lattice, a bit each, in memory of the library's.
//
// A grid is one pointer, and whoever has a reference to it may do what the reference allows: C only reads
// what it takes as const, so many may read at once, and a grid may go to another thread, because its memory
// comes from the C library's allocator, which every thread may use. That a mask is not the grid that an
// operator changes, which C has to check, is said here by the references alone.

use std::fmt;
use std::mem::ManuallyDrop;
use std::ptr::{self, NonNull};

use crate::error::{check, Result};
use crate::memory::allocator;
use crate::task::run;
use crate::{sys, Error, ErrorKind, Lattice, Moments, Slice, SliceMut, Task, VoxelBox};

/// Voxels on a lattice, a bit each.
///
#[doc = words!(sf_grid)]
///
/// ```
/// # fn main() -> libsf::Result<()> {
/// use libsf::{Grid, Lattice};
///
/// let lattice = Lattice::new(32, 32, 32, 0.25, 0.25)?;
/// let ball = Grid::from_fn(&lattice, |layer, y, x| {
///     let square = |i: u32| (f64::from(i) - 15.5).powi(2);
///     square(layer) + square(y) + square(x) < 15.0 * 15.0
/// })?;
/// assert!(ball.get(16, 16, 16) && !ball.get(0, 0, 0));
/// assert_eq!(ball.bounds().z1, 31);
/// # Ok(())
/// # }
/// ```
pub struct Grid {
    c: NonNull<sys::sf_grid>,
    lattice: Lattice,
}

// See above.
unsafe impl Send for Grid {}
unsafe impl Sync for Grid {}

impl Grid {
    #[doc = words!(sf_grid_create: lattice)]
    pub fn new(lattice: &Lattice) -> Result<Grid> {
        let mut c = ptr::null_mut();
        check(unsafe { sys::sf_grid_create(&lattice.c(), allocator(), &mut c) })?;
        Ok(Grid { c: own(c)?, lattice: lattice.clone() })
    }

    /// A grid whose voxel (layer, y, x) is solid where `solid` says so.
    pub fn from_fn(lattice: &Lattice, mut solid: impl FnMut(u32, u32, u32) -> bool) -> Result<Grid> {
        let mut grid = Grid::new(lattice)?;
        for layer in 0..lattice.nz() {
            let mut slice = grid.slice_mut(layer);
            for y in 0..lattice.ny() {
                fill_row(slice.row_mut(y), (0..lattice.nx()).map(|x| solid(layer, y, x)));
            }
        }
        Ok(grid)
    }

    /// A grid of nz * ny * nx bools in (layer, y, x) order.
    pub fn from_bools(lattice: &Lattice, solid: &[bool]) -> Result<Grid> {
        let (nz, ny, nx) = lattice.shape();
        if Some(solid.len()) != nz.checked_mul(ny).and_then(|n| n.checked_mul(nx)) {
            let said = format!("{} bools for {nz} layers of {ny} rows of {nx} voxels", solid.len());
            return Err(Error::new(ErrorKind::Shape, said));
        }
        let at = |layer: u32, y: u32, x: u32| (layer as usize * ny + y as usize) * nx + x as usize;
        Grid::from_fn(lattice, |layer, y, x| solid[at(layer, y, x)])
    }

    /// The voxels as nz * ny * nx bools in (layer, y, x) order.
    pub fn to_bools(&self) -> Vec<bool> {
        let (nz, ny, nx) = self.lattice.shape();
        let mut solid = Vec::with_capacity(nz * ny * nx);
        for layer in self.slices() {
            for y in 0..self.lattice.ny() {
                let row = layer.row(y);
                solid.extend((0..nx).map(|x| row[x / 64] >> (x % 64) & 1 != 0));
            }
        }
        solid
    }

    #[doc = words!(sf_grid_clone)]
    pub fn try_clone(&self) -> Result<Grid> {
        let mut c = ptr::null_mut();
        check(unsafe { sys::sf_grid_clone(self.c(), allocator(), &mut c) })?;
        Ok(Grid { c: own(c)?, lattice: self.lattice.clone() })
    }

    /// A new grid of C's.
    pub(crate) fn of(c: NonNull<sys::sf_grid>, lattice: &Lattice) -> Grid {
        Grid { c, lattice: lattice.clone() }
    }

    /// A grid that belongs to something else, which it must not outlive, and which must not be changed
    /// through it.
    pub(crate) fn lent(c: *const sys::sf_grid, lattice: &Lattice) -> Result<ManuallyDrop<Grid>> {
        Ok(ManuallyDrop::new(Grid { c: own(c.cast_mut())?, lattice: lattice.clone() }))
    }

    pub(crate) fn c(&self) -> *const sys::sf_grid {
        self.c.as_ptr()
    }

    pub(crate) fn c_mut(&mut self) -> *mut sys::sf_grid {
        self.c.as_ptr()
    }

    /// Where the voxels lie.
    pub fn lattice(&self) -> &Lattice {
        &self.lattice
    }

    #[doc = words!(sf_grid_slice)]
    ///
    /// # Panics
    /// Where there is no such layer.
    pub fn slice(&self, k: u32) -> Slice<'_> {
        self.within(k);
        unsafe { Slice::of(sys::sf_grid_slice(self.c(), k)) }
    }

    /// Slice k, to be written.
    ///
    /// # Panics
    /// Where there is no such layer.
    pub fn slice_mut(&mut self, k: u32) -> SliceMut<'_> {
        self.within(k);
        unsafe { SliceMut::of(sys::sf_grid_slice(self.c(), k)) }
    }

    fn within(&self, k: u32) {
        assert!(k < self.lattice.nz(), "layer {k} of {}", self.lattice.nz());
    }

    /// All slices, from the bottom up.
    pub fn slices(&self) -> impl DoubleEndedIterator<Item = Slice<'_>> + ExactSizeIterator {
        let layers = 0..self.lattice.nz() as usize;
        layers.map(|k| self.slice(k as u32))
    }

    /// All slices, to be written, and by several threads if need be.
    pub fn slices_mut(&mut self) -> impl DoubleEndedIterator<Item = SliceMut<'_>> + ExactSizeIterator {
        let c = self.c();
        let layers = 0..self.lattice.nz() as usize;
        // Each layer is handed out once, and no two share a word.
        layers.map(move |k| unsafe { SliceMut::of(sys::sf_grid_slice(c, k as u32)) })
    }

    /// Words from one row to the next.
    pub fn stride(&self) -> usize {
        self.slice(0).stride()
    }

    /// The grid's own memory: nz * ny * stride words, rows after rows and layers after layers.
    ///
    /// Voxel x of a row is bit `x % 64` of its word `x / 64`; bits past the width mean nothing.
    pub fn words(&self) -> &[u64] {
        let (first, count) = self.memory();
        unsafe { std::slice::from_raw_parts(first, count) }
    }

    /// The same, to be written.
    pub fn words_mut(&mut self) -> &mut [u64] {
        let (first, count) = self.memory();
        unsafe { std::slice::from_raw_parts_mut(first, count) }
    }

    fn memory(&self) -> (*mut u64, usize) {
        let (nz, ny, _) = self.lattice.shape();
        let first = unsafe { sys::sf_grid_slice(self.c(), 0) };
        let last = unsafe { sys::sf_grid_slice(self.c(), self.lattice.nz() - 1) };
        let layer = ny * first.stride;
        assert!(
            last.words == first.words.wrapping_add((nz - 1) * layer),
            "layers that do not follow each other"
        );
        (first.words, nz * layer)
    }

    /// Whether voxel (layer, y, x) is solid; what lies outside is not.
    pub fn get(&self, layer: u32, y: u32, x: u32) -> bool {
        layer < self.lattice.nz() && self.slice(layer).get(x, y)
    }

    /// Makes voxel (layer, y, x) solid, or empty.
    pub fn set(&mut self, layer: u32, y: u32, x: u32, solid: bool) -> Result<()> {
        if layer >= self.lattice.nz() {
            let said = format!("layer {layer} of {}", self.lattice.nz());
            return Err(Error::new(ErrorKind::Argument, said));
        }
        self.slice_mut(layer).set(x, y, solid)
    }

    /// Makes every voxel of a box solid, or empty.
    pub fn fill(&mut self, place: VoxelBox, solid: bool) -> Result<()> {
        let rect = crate::Rect { x0: place.x0, y0: place.y0, x1: place.x1, y1: place.y1 };
        let nz = self.lattice.nz();
        let inside = rect.x1 <= self.lattice.nx() && rect.y1 <= self.lattice.ny() && place.z1 <= nz;
        if !inside {
            return Err(Error::new(ErrorKind::Argument, format!("{place:?} leaves the grid")));
        }
        (place.z0..place.z1).try_for_each(|k| self.slice_mut(k).fill(rect, solid))
    }

    #[doc = words!(sf_grid_popcount)]
    pub fn count(&self) -> u64 {
        unsafe { sys::sf_grid_popcount(self.c()) }
    }

    #[doc = words!(sf_grid_bounds)]
    pub fn bounds(&self) -> VoxelBox {
        VoxelBox::of(&unsafe { sys::sf_grid_bounds(self.c()) })
    }

    #[doc = words!(sf_grid_measure)]
    pub fn moments(&self, task: Option<&mut Task<'_>>) -> Result<Moments> {
        let mut found: sys::sf_moments = unsafe { std::mem::zeroed() };
        check(run(task, |task| unsafe { sys::sf_grid_measure(self.c(), task, &mut found) }))?;
        Ok(Moments::of(&found))
    }

    #[doc = words!(sf_grid_sha256)]
    pub fn sha256(&self, task: Option<&mut Task<'_>>) -> Result<[u8; 32]> {
        let mut digest = [0; sys::SF_SHA256_SIZE as usize];
        check(run(task, |task| unsafe { sys::sf_grid_sha256(self.c(), task, digest.as_mut_ptr()) }))?;
        Ok(digest)
    }

    /// Leaves what both have.
    pub fn and(&mut self, other: &Grid) -> Result<()> {
        self.with(other, |mut to, from| to.and(from))
    }

    /// Adds what the other has.
    pub fn or(&mut self, other: &Grid) -> Result<()> {
        self.with(other, |mut to, from| to.or(from))
    }

    /// Leaves what just one of them has.
    pub fn xor(&mut self, other: &Grid) -> Result<()> {
        self.with(other, |mut to, from| to.xor(from))
    }

    /// Takes away what the other has.
    pub fn subtract(&mut self, other: &Grid) -> Result<()> {
        self.with(other, |mut to, from| to.subtract(from))
    }

    fn with(&mut self, other: &Grid, call: impl Fn(SliceMut<'_>, Slice<'_>) -> Result<()>) -> Result<()> {
        if self.lattice.shape() != other.lattice.shape() {
            let said = format!("grids of {:?} and {:?}", self.lattice.shape(), other.lattice.shape());
            return Err(Error::new(ErrorKind::Shape, said));
        }
        self.slices_mut().zip(other.slices()).try_for_each(|(to, from)| call(to, from))
    }
}

/// Packs bools into the words of a row.
fn fill_row(row: &mut [u64], solid: impl Iterator<Item = bool>) {
    row.fill(0);
    for (x, one) in solid.enumerate() {
        row[x / 64] |= u64::from(one) << (x % 64);
    }
}

/// What a call that succeeded has left.
pub(crate) fn own<T>(c: *mut T) -> Result<NonNull<T>> {
    NonNull::new(c).ok_or_else(|| Error::new(ErrorKind::Internal, "the library left no object"))
}

impl Drop for Grid {
    fn drop(&mut self) {
        unsafe { sys::sf_grid_destroy(self.c.as_ptr()) }
    }
}

impl Clone for Grid {
    /// # Panics
    /// Where there is no memory; [`Grid::try_clone`] says so instead.
    fn clone(&self) -> Grid {
        self.try_clone().expect("memory for a copy of a grid")
    }
}

impl PartialEq for Grid {
    #[doc = words!(sf_grid_equal)]
    fn eq(&self, other: &Grid) -> bool {
        unsafe { sys::sf_grid_equal(self.c(), other.c()) != 0 }
    }
}

impl Eq for Grid {}

impl fmt::Debug for Grid {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (nz, ny, nx) = self.lattice.shape();
        write!(to, "Grid({nx} x {ny} x {nz}, {} solid voxels)", self.count())
    }
}
