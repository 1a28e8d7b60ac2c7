// SPDX-License-Identifier: MIT
// Lattices: where voxels lie. A value that was checked when it was made and does not change.

use std::sync::Arc;

use crate::error::{check, Result};
use crate::{sys, Error, ErrorKind};

#[doc = words!(sf_lattice)]
///
/// Layers have one height, or a height each. Arrays of voxels are in (layer, y, x) order.
#[derive(Clone, Debug, PartialEq)]
pub struct Lattice {
    counts: [u32; 3],
    pitch_mm: [f64; 2],
    layer_mm: f64,
    heights_mm: Option<Arc<[f64]>>,
    origin_mm: [f64; 3],
}

impl Lattice {
    /// A lattice of so many voxels along x, y and z, square in the plane, with its corner at the origin.
    ///
    #[doc = words!(sf_lattice_validate)]
    pub fn new(nx: u32, ny: u32, nz: u32, pitch_mm: f64, layer_mm: f64) -> Result<Lattice> {
        let counts = [nx, ny, nz];
        let pitch_mm = [pitch_mm; 2];
        Lattice { counts, pitch_mm, layer_mm, heights_mm: None, origin_mm: [0.0; 3] }.checked()
    }

    /// A lattice of voxels of a pitch and a height around a box, with `margin` voxels to spare on each
    /// side; its layers begin at the box's bottom, or the margin below it.
    pub fn around(
        low_mm: [f64; 3],
        high_mm: [f64; 3],
        pitch_mm: f64,
        layer_mm: f64,
        margin: u32,
    ) -> Result<Lattice> {
        let step = [pitch_mm, pitch_mm, layer_mm];
        let mut counts = [0; 3];
        let mut origin_mm = [0.0; 3];
        for axis in 0..3 {
            let voxels = ((high_mm[axis] - low_mm[axis]) / step[axis] - 1e-9).ceil().max(0.0);
            counts[axis] = (voxels as u32).saturating_add(margin.saturating_mul(2));
            let middle = 0.5 * (low_mm[axis] + high_mm[axis]);
            origin_mm[axis] = middle - 0.5 * f64::from(counts[axis]) * step[axis];
        }
        origin_mm[2] = low_mm[2] - f64::from(margin) * layer_mm;
        Lattice { counts, pitch_mm: [pitch_mm; 2], layer_mm, heights_mm: None, origin_mm }.checked()
    }

    /// The same with voxels of another size along x than along y.
    pub fn with_pitch(mut self, pitch_x_mm: f64, pitch_y_mm: f64) -> Result<Lattice> {
        self.pitch_mm = [pitch_x_mm, pitch_y_mm];
        self.checked()
    }

    /// The same with a height for each layer, from the bottom.
    pub fn with_heights(mut self, heights_mm: &[f64]) -> Result<Lattice> {
        if heights_mm.len() != self.counts[2] as usize {
            let said = format!("{} heights for {} layers", heights_mm.len(), self.counts[2]);
            return Err(Error::new(ErrorKind::Shape, said));
        }
        self.heights_mm = Some(heights_mm.into());
        // Nobody looks at it then, and lattices that are the same are equal.
        self.layer_mm = 0.0;
        self.checked()
    }

    /// The same with the lower corner of voxel (0, 0, 0) elsewhere.
    pub fn with_origin(mut self, origin_mm: [f64; 3]) -> Result<Lattice> {
        self.origin_mm = origin_mm;
        self.checked()
    }

    fn checked(self) -> Result<Lattice> {
        let Err(error) = check(unsafe { sys::sf_lattice_validate(&self.c()) }) else {
            return Ok(self);
        };
        let ([nx, ny, nz], [px, py]) = (self.counts, self.pitch_mm);
        let size = format!("{nx} x {ny} x {nz} voxels of {px} x {py} mm, layers of {} mm", self.layer_mm);
        let more = match error.kind() {
            ErrorKind::Overflow => "make the voxels larger",
            _ => "counts and sizes must be above 0, places finite",
        };
        Err(Error::new(error.kind(), format!("no lattice can have {size}; {more}")))
    }

    /// Voxels along x.
    pub fn nx(&self) -> u32 {
        self.counts[0]
    }

    /// Voxels along y.
    pub fn ny(&self) -> u32 {
        self.counts[1]
    }

    /// Layers.
    pub fn nz(&self) -> u32 {
        self.counts[2]
    }

    /// The shape of arrays on it: layers, rows, voxels of a row.
    pub fn shape(&self) -> (usize, usize, usize) {
        (self.nz() as usize, self.ny() as usize, self.nx() as usize)
    }

    /// Size of a voxel along x and y, mm.
    pub fn pitch_mm(&self) -> [f64; 2] {
        self.pitch_mm
    }

    /// Lower corner of voxel (0, 0, 0), mm.
    pub fn origin_mm(&self) -> [f64; 3] {
        self.origin_mm
    }

    /// The heights of the layers, where each has its own.
    pub fn heights_mm(&self) -> Option<&[f64]> {
        self.heights_mm.as_deref()
    }

    /// Height of layer `k` in mm; `None` where there is no such layer.
    ///
    #[doc = words!(sf_lattice_layer_height)]
    pub fn layer_height(&self, k: u32) -> Option<f64> {
        (k < self.nz()).then(|| unsafe { sys::sf_lattice_layer_height(&self.c(), k) })
    }

    /// Where layer `k` begins, mm, and of `nz` where the last ends; `None` beyond.
    ///
    #[doc = words!(sf_lattice_layer_bottom)]
    pub fn layer_bottom(&self, k: u32) -> Option<f64> {
        (k <= self.nz()).then(|| unsafe { sys::sf_lattice_layer_bottom(&self.c(), k) })
    }

    /// An array of the caller's as C takes it, if it has a number for each voxel.
    pub(crate) fn each<T>(&self, given: Option<&[T]>, what: &str) -> Result<*const T> {
        let Some(given) = given else { return Ok(std::ptr::null()) };
        let (nz, ny, nx) = self.shape();
        if Some(given.len()) != nz.checked_mul(ny).and_then(|n| n.checked_mul(nx)) {
            let said = format!("{what}: {} numbers for {nz} layers of {ny} rows of {nx} voxels", given.len());
            return Err(Error::new(ErrorKind::Shape, said));
        }
        Ok(given.as_ptr())
    }

    /// A copy of one of C's.
    pub(crate) fn of(c: &sys::sf_lattice) -> Result<Lattice> {
        let heights_mm = (!c.heights_mm.is_null())
            .then(|| unsafe { crate::plain::elements(c.heights_mm, c.nz as usize) }.into());
        let (counts, pitch_mm) = ([c.nx, c.ny, c.nz], [c.pitch_x_mm, c.pitch_y_mm]);
        let layer_mm = if heights_mm.is_some() { 0.0 } else { c.layer_mm };
        Lattice { counts, pitch_mm, layer_mm, heights_mm, origin_mm: c.origin_mm }.checked()
    }

    /// As C has it; the heights are this lattice's.
    pub(crate) fn c(&self) -> sys::sf_lattice {
        sys::sf_lattice {
            nx: self.counts[0],
            ny: self.counts[1],
            nz: self.counts[2],
            pitch_x_mm: self.pitch_mm[0],
            pitch_y_mm: self.pitch_mm[1],
            layer_mm: self.layer_mm,
            heights_mm: self.heights_mm.as_ref().map_or(std::ptr::null(), |heights| heights.as_ptr()),
            origin_mm: self.origin_mm,
        }
    }
}
