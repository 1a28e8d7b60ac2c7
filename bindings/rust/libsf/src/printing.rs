// SPDX-License-Identifier: MIT
// Printing: does a part topple while it is printed? And which way up does it print best?

use std::mem::zeroed;

use crate::error::{check, Result};
use crate::memory::allocator;
use crate::plain::room;
use crate::rule::bed;
use crate::task::run;
use crate::{sys, Connectivity, Grid, Mesh, OrientOptions, Orientation, PrintingReport, Task};

/// How a print is looked at.
#[derive(Clone, Copy, Debug)]
pub struct PrintingOptions {
    /// The layer that rests on the bed; `None`: the first that holds matter.
    pub bed_layer: Option<u32>,
    #[doc = words!(sf_printing_options.connectivity)]
    pub connectivity: Connectivity,
}

impl Default for PrintingOptions {
    fn default() -> PrintingOptions {
        let c = unsafe { sys::sf_printing_options_default() };
        PrintingOptions { bed_layer: None, connectivity: Connectivity::of(c.connectivity) }
    }
}

/// How a part stands while it is printed.
#[derive(Clone, Debug, PartialEq)]
pub struct Printing {
    /// The worst of it.
    pub report: PrintingReport,
    /// The margin after each layer, radians.
    pub margins_rad: Vec<f64>,
}

impl Grid {
    #[doc = words!(sf_grid_printing)]
    ///
    /// ```
    /// # fn main() -> libsf::Result<()> {
    /// use libsf::{Grid, Lattice};
    ///
    /// // A leg with an arm: from some layer on it topples, and nothing of it floats.
    /// let lattice = Lattice::new(32, 8, 32, 1.0, 1.0)?;
    /// let part = Grid::from_fn(&lattice, |layer, _, x| x < 8 || x < layer)?;
    /// let found = part.printing(&Default::default(), None)?;
    /// assert!(found.margins_rad[0] > 0.0 && found.margins_rad[31] < 0.0);
    /// assert_eq!((found.report.layer, found.report.floating_count), (Some(31), 0));
    /// # Ok(())
    /// # }
    /// ```
    pub fn printing(&self, options: &PrintingOptions, task: Option<&mut Task<'_>>) -> Result<Printing> {
        let mut margins_rad = room(self.lattice().shape().0)?;
        let mut c = unsafe { sys::sf_printing_options_default() };
        c.bed_layer = bed(options.bed_layer);
        c.connectivity = options.connectivity.c();
        c.margins_rad = margins_rad.as_mut_ptr();
        c.margin_capacity = margins_rad.len();
        let mut report: sys::sf_printing_report = unsafe { zeroed() };
        check(run(task, |task| unsafe {
            sys::sf_grid_printing(self.c(), &c, allocator(), task, &mut report)
        }))?;
        Ok(Printing { report: PrintingReport::of(&report), margins_rad })
    }
}

impl Mesh {
    #[doc = words!(sf_mesh_orient)]
    ///
    /// Beside them, the same figures for the mesh as it is given.
    ///
    /// ```
    /// # fn main() -> libsf::Result<()> {
    /// use libsf::{Grid, Lattice, OrientOptions};
    ///
    /// // A table: it prints best with its top on the bed.
    /// let lattice = Lattice::new(16, 16, 16, 1.0, 1.0)?;
    /// let leg = |i: u32| i < 3 || i >= 13;
    /// let table = Grid::from_fn(&lattice, |layer, y, x| layer >= 13 || (leg(x) && leg(y)))?;
    /// let options = OrientOptions { direction_count: 50, coarse_count: 5, ..OrientOptions::default() };
    /// let options = OrientOptions { coarse_resolution: 16, resolution: 16, fine_count: 2, ..options };
    /// let (best, given) = table.surface(0, None)?.orient(&options, None)?;
    /// assert_eq!((best[0].up, best[0].trimmed_voxels), ([0.0, 0.0, -1.0], 0));
    /// assert!(given.trimmed_voxels > 0);
    /// # Ok(())
    /// # }
    /// ```
    pub fn orient(
        &self,
        options: &OrientOptions,
        task: Option<&mut Task<'_>>,
    ) -> Result<(Vec<Orientation>, Orientation)> {
        // More than a thousand are refused.
        let wanted = options.fine_count.min(1000) as usize;
        let mut found: Vec<sys::sf_orientation> = vec![unsafe { zeroed() }; wanted];
        let mut given: sys::sf_orientation = unsafe { zeroed() };
        let (mut count, c) = (0, options.c());
        check(run(task, |task| unsafe {
            let (to, places) = (found.as_mut_ptr(), found.len());
            sys::sf_mesh_orient(self.view(), &c, allocator(), task, to, places, &mut count, &mut given)
        }))?;
        let best = found.iter().take(count).map(Orientation::of).collect();
        Ok((best, Orientation::of(&given)))
    }
}
