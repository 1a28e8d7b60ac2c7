// SPDX-License-Identifier: MIT
// The operators that make a shape support-free, in place: each leaves the shape as it was when it fails.
//
// What C writes to a grid of culprits is had here by asking once more: only the call that failed pays for
// it, and the voxels come along with the error.

use std::mem::zeroed;
use std::ptr;

use crate::error::{check, Result};
use crate::memory::allocator;
use crate::task::{run, run_quietly};
use crate::{sys, ErrorKind, Grid, GrowReport, Lattice, PreserveMode, PreserveReport};
use crate::{RepairReport, Rule, Steepest, Task, Terms, TrimReport, VoxelBox};

/// What a call said, and where it could not be had, what is in the way, for which it is made again.
fn judged(
    status: sys::sf_status,
    lattice: &Lattice,
    again: impl FnOnce(*mut sys::sf_grid) -> sys::sf_status,
) -> Result<()> {
    check(status).map_err(|mut error| {
        if error.kind() == ErrorKind::Infeasible {
            if let Ok(mut found) = Grid::new(lattice) {
                if again(found.c_mut()) == sys::SF_ERR_INFEASIBLE {
                    error.culprits = Some(Box::new(found));
                }
            }
        }
        error
    })
}

/// How a repair is made.
#[derive(Clone, Copy, Debug)]
pub struct RepairOptions<'a> {
    #[doc = words!(sf_repair_options.add_cost)]
    pub add_cost: Option<&'a [u8]>,
    #[doc = words!(sf_repair_options.remove_cost)]
    pub remove_cost: Option<&'a [u8]>,
    #[doc = words!(sf_repair_options.min_feature_vx)]
    pub min_feature_vx: u32,
    #[doc = words!(sf_repair_options.rounds)]
    pub rounds: u32,
}

impl Default for RepairOptions<'_> {
    fn default() -> Self {
        let c = unsafe { sys::sf_repair_options_default() };
        let (min_feature_vx, rounds) = (c.min_feature_vx, c.rounds);
        RepairOptions { add_cost: None, remove_cost: None, min_feature_vx, rounds }
    }
}

/// How a brush is taken away.
#[derive(Clone, Copy, Debug)]
pub struct PreserveOptions<'a> {
    #[doc = words!(sf_preserve_options.mode)]
    pub mode: PreserveMode,
    #[doc = words!(sf_preserve_options.must_go)]
    pub must_go: Option<&'a Grid>,
    #[doc = words!(sf_preserve_options.brush_box)]
    pub brush_box: VoxelBox,
    #[doc = words!(sf_preserve_options.strut_width)]
    pub strut_width: u32,
    #[doc = words!(sf_preserve_options.accept_unsupported)]
    pub accept_unsupported: bool,
    #[doc = words!(sf_preserve_options.known_support_free)]
    pub known_support_free: bool,
    #[doc = words!(sf_preserve_options.trim_after)]
    pub trim_after: bool,
}

impl Default for PreserveOptions<'_> {
    fn default() -> Self {
        let c = unsafe { sys::sf_preserve_options_default() };
        PreserveOptions {
            mode: PreserveMode::of(c.mode),
            must_go: None,
            brush_box: VoxelBox::of(&c.brush_box),
            strut_width: c.strut_width,
            accept_unsupported: c.accept_unsupported != 0,
            known_support_free: c.known_support_free != 0,
            trim_after: c.trim_after != 0,
        }
    }
}

impl Grid {
    #[doc = words!(sf_grid_trim)]
    ///
    /// With masks, only if nothing that must stay is lost: see
    /// [`sf_grid_trim_on()`](crate::sys::sf_grid_trim_on).
    ///
    /// ```
    /// # fn main() -> libsf::Result<()> {
    /// use libsf::{Grid, Lattice, Rule};
    ///
    /// // A post, and a voxel that hangs beside its top.
    /// let lattice = Lattice::new(8, 8, 8, 0.1, 0.1)?;
    /// let mut grid = Grid::from_fn(&lattice, |layer, y, x| y == 4 && (x == 2 || (layer == 7 && x == 6)))?;
    /// let report = grid.trim(Rule::box3(), None)?;
    /// assert_eq!((report.kept_voxels, report.removed_voxels), (8, 1));
    /// # Ok(())
    /// # }
    /// ```
    pub fn trim<'t>(
        &mut self,
        terms: impl Into<Terms<'t>>,
        mut task: Option<&mut Task<'_>>,
    ) -> Result<TrimReport> {
        let terms: Terms<'t> = terms.into();
        let placed = terms.place(self.lattice())?;
        let mut report: sys::sf_trim_report = unsafe { zeroed() };
        let (grid, c) = (self.c_mut(), &placed.c);
        if !terms.masked() {
            check(run(task, |task| unsafe {
                sys::sf_grid_trim(grid, &c.rule, c.bed_layer, task, &mut report)
            }))?;
            return Ok(TrimReport::of(&report));
        }
        let mut call = |task, culprits| unsafe {
            sys::sf_grid_trim_on(grid, c, allocator(), task, culprits, &mut report)
        };
        let status = run(task.as_deref_mut(), |task| call(task, ptr::null_mut()));
        judged(status, self.lattice(), |culprits| run_quietly(task, |task| call(task, culprits)))?;
        Ok(TrimReport::of(&report))
    }

    #[doc = words!(sf_grid_trim_box: box)]
    ///
    /// This grid is what is printable.
    ///
    /// - `drawn`: the shape as drawn, after the change; `None`: this grid itself, which was support-free
    ///   before a change that only removed matter
    ///
    /// It returns a box around the voxels of this grid that changed.
    pub fn trim_box(
        &mut self,
        drawn: Option<&Grid>,
        rule: Rule,
        bed_layer: Option<u32>,
        place: VoxelBox,
    ) -> Result<VoxelBox> {
        let placed = rule.place(self.lattice())?;
        let (grid, bed) = (self.c_mut(), crate::rule::bed(bed_layer));
        let drawn = drawn.map_or(grid.cast_const(), Grid::c);
        let mut changed = VoxelBox::default().c();
        check(unsafe { sys::sf_grid_trim_box(drawn, grid, &placed.c, bed, place.c(), &mut changed) })?;
        Ok(VoxelBox::of(&changed))
    }

    #[doc = words!(sf_grid_grow)]
    ///
    /// Where some voxels cannot be carried the error has them: [`Error::culprits`](crate::Error::culprits).
    pub fn grow<'t>(
        &mut self,
        terms: impl Into<Terms<'t>>,
        mut task: Option<&mut Task<'_>>,
    ) -> Result<GrowReport> {
        let placed = terms.into().place(self.lattice())?;
        let mut report: sys::sf_grow_report = unsafe { zeroed() };
        let (grid, c) = (self.c_mut(), &placed.c);
        let mut call =
            |task, culprits| unsafe { sys::sf_grid_grow(grid, c, allocator(), task, culprits, &mut report) };
        let status = run(task.as_deref_mut(), |task| call(task, ptr::null_mut()));
        judged(status, self.lattice(), |culprits| run_quietly(task, |task| call(task, culprits)))?;
        Ok(GrowReport::of(&report))
    }

    #[doc = words!(sf_grid_repair)]
    ///
    /// Where something must stay and cannot the error has it: [`Error::culprits`](crate::Error::culprits).
    pub fn repair<'t>(
        &mut self,
        terms: impl Into<Terms<'t>>,
        options: &RepairOptions<'_>,
        mut task: Option<&mut Task<'_>>,
    ) -> Result<RepairReport> {
        let placed = terms.into().place(self.lattice())?;
        let mut report: sys::sf_repair_report = unsafe { zeroed() };
        let mut c = unsafe { sys::sf_repair_options_default() };
        c.terms = placed.c;
        c.add_cost = self.lattice().each(options.add_cost, "add_cost")?;
        c.remove_cost = self.lattice().each(options.remove_cost, "remove_cost")?;
        c.min_feature_vx = options.min_feature_vx;
        c.rounds = options.rounds;
        let grid = self.c_mut();
        let mut call = |task, culprits| unsafe {
            sys::sf_grid_repair(grid, &c, allocator(), task, culprits, &mut report)
        };
        let status = run(task.as_deref_mut(), |task| call(task, ptr::null_mut()));
        judged(status, self.lattice(), |culprits| run_quietly(task, |task| call(task, culprits)))?;
        Ok(RepairReport::of(&report))
    }

    #[doc = words!(sf_grid_preserve: brush)]
    pub fn preserve<'t>(
        &mut self,
        brush: &Grid,
        terms: impl Into<Terms<'t>>,
        options: &PreserveOptions<'_>,
        task: Option<&mut Task<'_>>,
    ) -> Result<PreserveReport> {
        let placed = terms.into().place(self.lattice())?;
        let mut report: sys::sf_preserve_report = unsafe { zeroed() };
        let mut c = unsafe { sys::sf_preserve_options_default() };
        c.mode = options.mode.c();
        c.must_go = options.must_go.map_or(ptr::null(), Grid::c);
        c.brush_box = options.brush_box.c();
        c.strut_width = options.strut_width;
        c.accept_unsupported = options.accept_unsupported.into();
        c.known_support_free = options.known_support_free.into();
        c.trim_after = options.trim_after.into();
        let grid = self.c_mut();
        check(run(task, |task| unsafe {
            sys::sf_grid_preserve(grid, brush.c(), &placed.c, &c, allocator(), task, &mut report)
        }))?;
        Ok(PreserveReport::of(&report))
    }

    #[doc = words!(sf_grid_complete: needed)]
    pub fn complete<'t>(
        &self,
        needed: &Grid,
        terms: impl Into<Terms<'t>>,
        task: Option<&mut Task<'_>>,
    ) -> Result<Grid> {
        let placed = terms.into().place(self.lattice())?;
        let mut result = Grid::new(self.lattice())?;
        let to = result.c_mut();
        check(run(task, |task| unsafe {
            sys::sf_grid_complete(self.c(), needed.c(), &placed.c, allocator(), task, to)
        }))?;
        Ok(result)
    }

    #[doc = words!(sf_grid_feasible: needed)]
    ///
    /// The shape is what is allowed. Where it is not feasible the error has the culprits.
    pub fn feasible<'t>(
        &self,
        needed: &Grid,
        terms: impl Into<Terms<'t>>,
        mut task: Option<&mut Task<'_>>,
    ) -> Result<()> {
        let placed = terms.into().place(self.lattice())?;
        let call = |task, culprits| unsafe {
            let (allowed, needed) = (self.c(), needed.c());
            sys::sf_grid_feasible(allowed, needed, &placed.c, allocator(), task, culprits, ptr::null_mut())
        };
        let status = run(task.as_deref_mut(), |task| call(task, ptr::null_mut()));
        judged(status, self.lattice(), |culprits| run_quietly(task, |task| call(task, culprits)))
    }

    #[doc = words!(sf_grid_unsupported)]
    pub fn unsupported<'t>(&self, terms: impl Into<Terms<'t>>, task: Option<&mut Task<'_>>) -> Result<Grid> {
        let placed = terms.into().place(self.lattice())?;
        let mut found = Grid::new(self.lattice())?;
        let to = found.c_mut();
        check(run(task, |task| unsafe {
            sys::sf_grid_unsupported(self.c(), &placed.c, allocator(), task, to, ptr::null_mut())
        }))?;
        Ok(found)
    }

    #[doc = words!(sf_grid_steepest)]
    pub fn steepest(&self, bed_layer: Option<u32>, task: Option<&mut Task<'_>>) -> Result<Steepest> {
        let mut found: sys::sf_steepest = unsafe { zeroed() };
        let bed = crate::rule::bed(bed_layer);
        check(run(task, |task| unsafe {
            sys::sf_grid_steepest(self.c(), bed, allocator(), task, &mut found)
        }))?;
        Ok(Steepest::of(&found))
    }
}
