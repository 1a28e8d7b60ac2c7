// SPDX-License-Identifier: MIT
// Densities: what 1 mm3 of each voxel weighs, from what people know of a part.

use std::ptr;

use crate::error::{check, Result};
use crate::memory::allocator;
use crate::plain::room;
use crate::task::run;
use crate::{sys, Error, ErrorKind, Grid, Lattice, Mesh, Task};

/// Where a region of one density lies.
#[derive(Clone, Copy, Debug)]
pub enum Region<'a> {
    #[doc = words!(SF_DENSITY_BOX)]
    Box {
        /// its lower corner
        low_mm: [f64; 3],
        /// its upper corner
        high_mm: [f64; 3],
    },
    #[doc = words!(SF_DENSITY_MESH)]
    Mesh(&'a Mesh),
    #[doc = words!(SF_DENSITY_MASK)]
    Mask(&'a Grid),
}

impl Region<'_> {
    fn c(&self, density: f64) -> sys::sf_density_region {
        let mut c = sys::sf_density_region {
            shape: sys::SF_DENSITY_BOX,
            density,
            low_mm: [0.0; 3],
            high_mm: [0.0; 3],
            mesh: sys::sf_mesh_view {
                vertices: ptr::null(),
                vertex_count: 0,
                triangles: ptr::null(),
                triangle_count: 0,
            },
            mask: ptr::null(),
        };
        match self {
            Region::Box { low_mm, high_mm } => (c.low_mm, c.high_mm) = (*low_mm, *high_mm),
            Region::Mesh(mesh) => (c.shape, c.mesh) = (sys::SF_DENSITY_MESH, mesh.view()),
            Region::Mask(mask) => (c.shape, c.mask) = (sys::SF_DENSITY_MASK, mask.c()),
        }
        c
    }
}

/// Where densities come from.
#[derive(Clone, Copy, Debug)]
pub struct DensityOptions<'a> {
    #[doc = words!(sf_density_options.density)]
    pub density: f64,
    #[doc = words!(sf_density_options.infill)]
    pub infill: f64,
    #[doc = words!(sf_density_options.wall)]
    pub wall: Option<&'a Grid>,
    /// Regions, each with what 1 mm3 of it weighs; of those that overlap the last one counts.
    pub regions: &'a [(Region<'a>, f64)],
}

impl Default for DensityOptions<'_> {
    fn default() -> Self {
        let c = unsafe { sys::sf_density_options_default() };
        DensityOptions { density: c.density, infill: c.infill, wall: None, regions: &[] }
    }
}

impl Lattice {
    #[doc = words!(sf_lattice_density)]
    ///
    /// ```
    /// # fn main() -> libsf::Result<()> {
    /// use libsf::{DensityOptions, Grid, Lattice, Region};
    ///
    /// // A cube of 10 mm with walls of 1 mm, a fifth of infill, and lead in a corner.
    /// let lattice = Lattice::new(20, 20, 20, 0.5, 0.5)?;
    /// let cube = Grid::from_fn(&lattice, |_, _, _| true)?;
    /// let wall = cube.wall_inside(1.0, None)?;
    /// let lead = Region::Box { low_mm: [0.0; 3], high_mm: [2.0; 3] };
    /// let options = DensityOptions {
    ///     infill: 0.2,
    ///     wall: Some(&wall),
    ///     regions: &[(lead, 9.0)],
    ///     ..DensityOptions::default()
    /// };
    /// let density = lattice.density(&options, None)?;
    /// let mass = cube.body(Some(&density), None)?.mass;
    /// let (inside, outside) = (8.0 * 8.0 * 8.0, 10.0 * 10.0 * 10.0);
    /// let expected = outside - inside + 0.2 * inside + 8.0 * 9.0 - 7.0 - 0.2;
    /// assert!((mass - expected).abs() < 1e-4);
    /// # Ok(())
    /// # }
    /// ```
    pub fn density(&self, options: &DensityOptions<'_>, task: Option<&mut Task<'_>>) -> Result<Vec<f32>> {
        let (nz, ny, nx) = self.shape();
        let many = || Error::new(ErrorKind::Overflow, format!("{nx} x {ny} x {nz} densities"));
        let voxels = nz.checked_mul(ny).and_then(|n| n.checked_mul(nx)).ok_or_else(many)?;
        let regions: Vec<_> = options.regions.iter().map(|(place, density)| place.c(*density)).collect();
        let mut c = unsafe { sys::sf_density_options_default() };
        c.density = options.density;
        c.infill = options.infill;
        c.wall = options.wall.map_or(ptr::null(), Grid::c);
        c.regions = regions.as_ptr();
        c.region_count = regions.len();
        let mut found = room(voxels)?;
        let lattice = self.c();
        check(run(task, |task| unsafe {
            sys::sf_lattice_density(&lattice, &c, allocator(), task, found.as_mut_ptr())
        }))?;
        Ok(found)
    }
}
