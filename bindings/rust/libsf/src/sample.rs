// SPDX-License-Identifier: MIT
// Sampling: slices of a graded solid, a layer at a time. A sampler reads the limit or the tetrahedra that it
// was made of, which stay as they are while it lives.

use std::fmt;
use std::marker::PhantomData;
use std::mem::zeroed;
use std::ptr::{self, NonNull};

use crate::error::{check, check_fault, no_fault, Result};
use crate::grid::own;
use crate::made::Made;
use crate::memory::allocator;
use crate::plain::elements;
use crate::task::run;
use crate::{sys, Error, ErrorKind, Lattice, Limit, SampleReport, SliceMut, Task, Tets};

#[doc = words!(sf_sampler)]
///
/// ```
/// # fn main() -> libsf::Result<()> {
/// use libsf::{Cage, Channel, Grid, Lattice, Property, RefineRules, Sampler};
///
/// // A block that gets denser upwards; the limit of a block is smaller than its cage, and round.
/// let mut cage = Cage::block([4; 3], [0.0; 3], [8.0; 3])?;
/// let height: Vec<f64> = cage.positions().iter().map(|at| 100.0 * at[2]).collect();
/// cage.add_property(&Channel::of_points(Property::density(), &height))?;
/// let limit = cage.limit(RefineRules::Standard, None)?;
///
/// let lattice = Lattice::new(32, 32, 32, 0.25, 0.25)?;
/// let mut grid = Grid::new(&lattice)?;
/// let mut sampler = Sampler::of_limit(&limit, &lattice, None, &[0], None)?;
/// let mut density = vec![0.0; 32 * 32];
/// sampler.slice(16, grid.slice_mut(16), &mut density)?;
/// assert!(grid.slice(16).get(16, 16));
/// // The middle of layer 16 is 4.125 mm high.
/// assert!((density[16 * 32 + 16] - 412.5).abs() < 1e-6);
/// # Ok(())
/// # }
/// ```
pub struct Sampler<'s> {
    c: NonNull<sys::sf_sampler>,
    shape: (usize, usize),
    channels: usize,
    source: PhantomData<&'s Limit>,
}

// What it points to is its own, or borrowed and not changed.
unsafe impl Send for Sampler<'_> {}
unsafe impl Sync for Sampler<'_> {}

/// The triangles by which voxels are solid.
#[derive(Clone, Copy, Debug)]
pub struct SampledSurface<'a> {
    /// The vertices, mm.
    pub vertices: &'a [[f64; 3]],
    /// Three vertices each, counter-clockwise seen from outside.
    pub faces: &'a [[u32; 3]],
    /// How far it may be from the limit surface, mm.
    pub error_mm: f64,
}

impl<'s> Sampler<'s> {
    #[doc = words!(sf_sampler_create: channels)]
    ///
    /// - `tolerance`: how far the surface may be from the limit, as a share of the smallest pitch, above 0
    ///   and at most 1; `None`: a twentieth
    pub fn of_limit(
        limit: &'s Limit,
        lattice: &Lattice,
        tolerance: Option<f64>,
        channels: &[usize],
        task: Option<&mut Task<'_>>,
    ) -> Result<Sampler<'s>> {
        let mut options = unsafe { sys::sf_sample_options_default() };
        options.tolerance = tolerance.unwrap_or(options.tolerance);
        let (mut made, mut fault) = (Made::new(sys::sf_sampler_destroy), no_fault());
        let (on, count, which) = (lattice.c(), channels.len(), channels.as_ptr());
        let (limit, memory) = (limit.c(), allocator());
        let status = run(task, |task| unsafe {
            sys::sf_sampler_create(limit, &on, &options, count, which, memory, task, made.place(), &mut fault)
        });
        check_fault(status, &fault)?;
        Sampler::of(made.own()?.as_ptr(), lattice, count)
    }

    #[doc = words!(sf_sampler_of_tets: channels)]
    pub fn of_tets(tets: &'s Tets<'_>, lattice: &Lattice, channels: &[usize]) -> Result<Sampler<'s>> {
        let (mut made, mut fault) = (ptr::null_mut(), no_fault());
        let (on, count, which) = (lattice.c(), channels.len(), channels.as_ptr());
        let status = unsafe {
            sys::sf_sampler_of_tets(tets.c(), &on, count, which, allocator(), &mut made, &mut fault)
        };
        check_fault(status, &fault)?;
        Sampler::of(made, lattice, count)
    }

    fn of(made: *mut sys::sf_sampler, lattice: &Lattice, channels: usize) -> Result<Sampler<'s>> {
        let (_, ny, nx) = lattice.shape();
        Ok(Sampler { c: own(made)?, shape: (ny, nx), channels, source: PhantomData })
    }

    #[doc = words!(sf_sampler_slice: k, solid)]
    ///
    /// - `values`: receives for each property ny rows of nx numbers, in the order of the properties: what
    ///   solid voxels have, and 0 elsewhere
    pub fn slice(&mut self, k: u32, mut solid: SliceMut<'_>, values: &mut [f64]) -> Result<()> {
        let (ny, nx) = self.shape;
        if Some(values.len()) != (ny * nx).checked_mul(self.channels) {
            let said = format!("{} values for {} planes of {ny} rows of {nx}", values.len(), self.channels);
            return Err(Error::new(ErrorKind::Shape, said));
        }
        let planes: Vec<*mut f64> = values.chunks_exact_mut(ny * nx).map(<[f64]>::as_mut_ptr).collect();
        check(unsafe { sys::sf_sampler_slice(self.c.as_ptr(), k, solid.c(), planes.as_ptr()) })
    }

    #[doc = words!(sf_sampler_surface)]
    pub fn surface(&self) -> SampledSurface<'_> {
        let mut error_mm = 0.0;
        let view = unsafe { sys::sf_sampler_surface(self.c.as_ptr(), &mut error_mm) };
        let (vertices, faces) = unsafe {
            (
                elements(view.vertices.cast(), view.vertex_count),
                elements(view.triangles.cast(), view.triangle_count),
            )
        };
        SampledSurface { vertices, faces, error_mm }
    }

    #[doc = words!(sf_sampler_report)]
    pub fn report(&self) -> Result<SampleReport> {
        let mut report: sys::sf_sample_report = unsafe { zeroed() };
        check(unsafe { sys::sf_sampler_report(self.c.as_ptr(), &mut report) })?;
        Ok(SampleReport::of(&report))
    }
}

impl Drop for Sampler<'_> {
    fn drop(&mut self) {
        unsafe { sys::sf_sampler_destroy(self.c.as_ptr()) }
    }
}

impl fmt::Debug for Sampler<'_> {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        to.debug_struct("Sampler").field("report", &self.report()).finish_non_exhaustive()
    }
}
