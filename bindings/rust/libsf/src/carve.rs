// SPDX-License-Identifier: MIT
// Carving: walls, cavities, and the holes that drain them.

use std::mem::zeroed;
use std::ptr;

use crate::error::{check, Result};
use crate::memory::allocator;
use crate::plain::c;
use crate::rule::PlacedTerms;
use crate::task::run;
use crate::{
    sys, Body, CarveGoal, CarveMode, CarveReport, Drain, DrainReport, Grid, Mesh, Stance, Task, Terms,
};

/// How to carve.
#[derive(Clone, Copy, Debug)]
pub struct CarveOptions<'a> {
    #[doc = words!(sf_carve_options.mode)]
    pub mode: CarveMode,
    #[doc = words!(sf_carve_options.goal)]
    pub goal: CarveGoal,
    #[doc = words!(sf_carve_options.density)]
    pub density: Option<&'a [f32]>,
    #[doc = words!(sf_carve_options.rest)]
    pub rest: Body,
    #[doc = words!(sf_carve_options.stances)]
    pub stances: &'a [&'a Stance],
    #[doc = words!(sf_carve_options.strut_width_vx)]
    pub strut_width_vx: u32,
    #[doc = words!(sf_carve_options.rounds_max)]
    pub rounds_max: u32,
}

impl Default for CarveOptions<'_> {
    fn default() -> Self {
        let c = unsafe { sys::sf_carve_options_default() };
        CarveOptions {
            mode: CarveMode::of(c.mode),
            goal: CarveGoal::of(c.goal),
            density: None,
            rest: Body::default(),
            stances: &[],
            strut_width_vx: c.strut_width_vx,
            rounds_max: c.rounds_max,
        }
    }
}

/// How holes are drilled.
#[derive(Clone, Copy, Debug)]
pub struct DrainOptions<'a> {
    #[doc = words!(sf_drain_options.diameter_mm)]
    pub diameter_mm: f64,
    #[doc = words!(sf_drain_options.count)]
    pub count: u32,
    #[doc = words!(sf_drain_options.void_min)]
    pub void_min: u64,
    #[doc = words!(sf_drain_options.fill)]
    pub fill: bool,
    #[doc = words!(sf_drain_options.density)]
    pub density: Option<&'a [f32]>,
    #[doc = words!(sf_drain_options.body)]
    pub body: Body,
    #[doc = words!(sf_drain_options.stances)]
    pub stances: &'a [&'a Stance],
    /// Most holes that are told.
    pub drains: usize,
}

impl DrainOptions<'_> {
    /// A hole of a diameter for each void.
    pub fn new(diameter_mm: f64) -> Self {
        let c = unsafe { sys::sf_drain_options_default() };
        DrainOptions {
            diameter_mm,
            count: c.count,
            void_min: c.void_min,
            fill: c.fill != 0,
            density: None,
            body: Body::default(),
            stances: &[],
            drains: 1024,
        }
    }
}

/// Stances as C has them.
fn c_stances(stances: &[&Stance]) -> Vec<*const sys::sf_stance> {
    stances.iter().map(|stance| stance.c()).collect()
}

impl Grid {
    #[doc = words!(sf_grid_wall: surface, wall_mm)]
    pub fn wall(&self, surface: &Mesh, wall_mm: f64, task: Option<&mut Task<'_>>) -> Result<Grid> {
        let mut wall = Grid::new(self.lattice())?;
        let to = wall.c_mut();
        check(run(task, |task| unsafe {
            sys::sf_grid_wall(self.c(), surface.view(), wall_mm, allocator(), task, to)
        }))?;
        Ok(wall)
    }

    #[doc = words!(sf_grid_wall_inside: wall_mm)]
    pub fn wall_inside(&self, wall_mm: f64, task: Option<&mut Task<'_>>) -> Result<Grid> {
        let mut wall = Grid::new(self.lattice())?;
        let to = wall.c_mut();
        check(run(task, |task| unsafe {
            sys::sf_grid_wall_inside(self.c(), wall_mm, allocator(), task, to)
        }))?;
        Ok(wall)
    }

    #[doc = words!(sf_grid_clearance: surface)]
    pub fn clearance(&self, surface: &Mesh, task: Option<&mut Task<'_>>) -> Result<f64> {
        let mut least_mm = 0.0;
        check(run(task, |task| unsafe {
            sys::sf_grid_clearance(self.c(), surface.view(), allocator(), task, &mut least_mm)
        }))?;
        Ok(least_mm)
    }

    #[doc = words!(sf_grid_carve: wall, terms)]
    ///
    /// ```
    /// # fn main() -> libsf::Result<()> {
    /// use libsf::{CarveOptions, Grid, Lattice, Rule};
    ///
    /// // A ball, hollow but for a wall of 2 mm, that prints without supports inside.
    /// let lattice = Lattice::new(40, 40, 40, 0.5, 0.5)?;
    /// let ball = Grid::from_fn(&lattice, |layer, y, x| {
    ///     [layer, y, x].iter().map(|&i| (f64::from(i) - 19.5).powi(2)).sum::<f64>() < 19.0 * 19.0
    /// })?;
    /// let wall = ball.wall_inside(2.0, None)?;
    /// let (hollow, report) = ball.carve(&wall, Rule::box3(), &CarveOptions::default(), None)?;
    /// assert_eq!(hollow.count() + report.removed_voxels, ball.count());
    /// assert!(report.removed_voxels > ball.count() / 4);
    /// # Ok(())
    /// # }
    /// ```
    pub fn carve<'t>(
        &self,
        wall: &Grid,
        terms: impl Into<Terms<'t>>,
        options: &CarveOptions<'_>,
        task: Option<&mut Task<'_>>,
    ) -> Result<(Grid, CarveReport)> {
        let (terms, stances) = (terms.into().place(self.lattice())?, c_stances(options.stances));
        let mut from = unsafe { sys::sf_carve_options_default() };
        from.mode = options.mode.c();
        from.goal = options.goal.c();
        from.density = self.lattice().each(options.density, "density")?;
        from.rest = c(&options.rest);
        from.stances = stances.as_ptr();
        from.stance_count = stances.len();
        from.strut_width_vx = options.strut_width_vx;
        from.rounds_max = options.rounds_max;
        let mut result = Grid::new(self.lattice())?;
        let mut report: sys::sf_carve_report = unsafe { zeroed() };
        let to = result.c_mut();
        check(run(task, |task| unsafe {
            sys::sf_grid_carve(self.c(), wall.c(), &terms.c, &from, allocator(), task, to, &mut report)
        }))?;
        Ok((result, CarveReport::of(&report)))
    }

    #[doc = words!(sf_grid_drain: terms)]
    pub fn drain(
        &mut self,
        terms: Option<Terms<'_>>,
        options: &DrainOptions<'_>,
        task: Option<&mut Task<'_>>,
    ) -> Result<(DrainReport, Vec<Drain>)> {
        let placed = terms.map(|terms| terms.place(self.lattice())).transpose()?;
        let terms = placed.as_ref().map_or(ptr::null(), |terms: &PlacedTerms<'_>| &terms.c);
        let stances = c_stances(options.stances);
        let mut drains: Vec<sys::sf_drain> = vec![unsafe { zeroed() }; options.drains];
        let mut from = unsafe { sys::sf_drain_options_default() };
        from.diameter_mm = options.diameter_mm;
        from.count = options.count;
        from.void_min = options.void_min;
        from.fill = options.fill.into();
        from.density = self.lattice().each(options.density, "density")?;
        from.body = c(&options.body);
        from.stances = stances.as_ptr();
        from.stance_count = stances.len();
        from.drains = if drains.is_empty() { ptr::null_mut() } else { drains.as_mut_ptr() };
        from.drain_capacity = drains.len();
        let mut report: sys::sf_drain_report = unsafe { zeroed() };
        let grid = self.c_mut();
        check(run(task, |task| unsafe {
            sys::sf_grid_drain(grid, terms, &from, allocator(), task, &mut report)
        }))?;
        let told = report.drain_count - report.drains_dropped;
        let drains = drains.iter().take(told as usize).map(Drain::of).collect();
        Ok((DrainReport::of(&report), drains))
    }
}
