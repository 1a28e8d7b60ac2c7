// SPDX-License-Identifier: MIT
// Handles: a few places of a solid that are posed, and that the whole follows.

use std::ptr;

use crate::error::{check, check_fault, no_fault, Result};
use crate::grid::own;
use crate::made::Made;
use crate::memory::allocator;
use crate::plain::{c, of};
use crate::task::run;
use crate::{sys, Error, ErrorKind, Grid, HandleKind, Mesh, Pose, PoseChange, Task};

#[doc = words!(sf_handle)]
#[derive(Clone, Copy, Debug)]
pub struct Handle<'g> {
    #[doc = words!(sf_handle.at_mm)]
    pub at_mm: [f64; 3],
    /// Radius of a ball; 0 for a point.
    pub radius_mm: f64,
    #[doc = words!(sf_handle.region)]
    pub region: Option<&'g Grid>,
    #[doc = words!(sf_handle.locked)]
    pub locked: bool,
}

impl<'g> Handle<'g> {
    /// A handle that holds the cell that a place lies in.
    pub fn point(at_mm: [f64; 3]) -> Handle<'g> {
        Handle { at_mm, radius_mm: 0.0, region: None, locked: false }
    }

    /// A handle that holds what lies within a radius as well.
    pub fn ball(at_mm: [f64; 3], radius_mm: f64) -> Handle<'g> {
        Handle { radius_mm, ..Handle::point(at_mm) }
    }

    #[doc = words!(sf_handle_base)]
    pub fn base(region: &'g Grid) -> Result<Handle<'g>> {
        let mut made = Handle::point([0.0; 3]).c();
        check(unsafe { sys::sf_handle_base(region.c(), &mut made) })?;
        Ok(Handle { at_mm: made.at_mm, radius_mm: 0.0, region: Some(region), locked: made.locked != 0 })
    }

    /// The same, left alone by whoever looks for poses.
    pub fn locked(mut self) -> Handle<'g> {
        self.locked = true;
        self
    }

    /// What it holds.
    pub fn kind(&self) -> HandleKind {
        match self.region {
            Some(_) => HandleKind::Base,
            None if self.radius_mm == 0.0 => HandleKind::Point,
            None => HandleKind::Ball,
        }
    }

    pub(crate) fn c(&self) -> sys::sf_handle {
        sys::sf_handle {
            kind: self.kind().c(),
            at_mm: self.at_mm,
            radius_mm: self.radius_mm,
            region: self.region.map_or(ptr::null(), Grid::c),
            locked: self.locked.into(),
        }
    }
}

/// Handles as C has them; the regions are borrowed for as long as these are.
pub(crate) fn c_handles(handles: &[Handle<'_>]) -> Vec<sys::sf_handle> {
    handles.iter().map(Handle::c).collect()
}

#[doc = words!(sf_place_options)]
#[derive(Clone, Copy, Debug)]
pub struct PlaceOptions<'a> {
    #[doc = words!(sf_place_options.count)]
    pub count: u32,
    #[doc = words!(sf_place_options.base)]
    pub base: Option<&'a Grid>,
    #[doc = words!(sf_place_options.ball)]
    pub ball: f64,
    #[doc = words!(sf_place_options.most_cells)]
    pub most_cells: u32,
}

impl Default for PlaceOptions<'_> {
    fn default() -> Self {
        let c = unsafe { sys::sf_place_options_default() };
        PlaceOptions { count: c.count, base: None, ball: c.ball, most_cells: c.most_cells }
    }
}

impl Grid {
    #[doc = words!(sf_grid_foot: up, height_mm)]
    pub fn foot(&self, up: [f64; 3], height_mm: f64) -> Result<Grid> {
        let mut made = ptr::null_mut();
        check(unsafe { sys::sf_grid_foot(self.c(), up.as_ptr(), height_mm, allocator(), &mut made) })?;
        Ok(Grid::of(own(made)?, self.lattice()))
    }

    #[doc = words!(sf_grid_cover: surface)]
    pub fn cover(&self, surface: &Mesh, task: Option<&mut Task<'_>>) -> Result<Grid> {
        let mut made = Made::new(sys::sf_grid_destroy);
        let to = made.place();
        check(run(task, |task| unsafe {
            sys::sf_grid_cover(self.c(), surface.view(), allocator(), task, to)
        }))?;
        Ok(Grid::of(made.own()?, self.lattice()))
    }

    #[doc = words!(sf_handle_center: from_mm, direction)]
    pub fn handle_center(&self, from_mm: [f64; 3], direction: [f64; 3]) -> Result<[f64; 3]> {
        let (mut found, mut fault) = ([0.0; 3], no_fault());
        let (from, along, to) = (from_mm.as_ptr(), direction.as_ptr(), found.as_mut_ptr());
        let met = unsafe { sys::sf_handle_center(self.c(), from, along, to, &mut fault) };
        check_fault(met, &fault)?;
        Ok(found)
    }

    #[doc = words!(sf_handles_place)]
    pub fn place_handles(
        &self,
        options: &PlaceOptions<'_>,
        task: Option<&mut Task<'_>>,
    ) -> Result<Vec<Handle<'static>>> {
        let mut c = unsafe { sys::sf_place_options_default() };
        c.count = options.count;
        c.base = options.base.map_or(ptr::null(), Grid::c);
        c.ball = options.ball;
        c.most_cells = options.most_cells;
        // More than there can be is refused, so there is no need for more places.
        let wanted = options.count.min(sys::SF_HANDLE_MAX);
        let mut found = c_handles(&vec![Handle::point([0.0; 3]); wanted as usize]);
        let (mut count, mut fault) = (0, no_fault());
        let placed = run(task, |task| unsafe {
            let (to, capacity) = (found.as_mut_ptr(), found.len());
            sys::sf_handles_place(self.c(), &c, allocator(), task, to, capacity, &mut count, &mut fault)
        });
        check_fault(placed, &fault)?;
        let made = |c: &sys::sf_handle| Handle::ball(c.at_mm, c.radius_mm);
        Ok(found[..count].iter().map(made).collect())
    }
}

impl Default for Pose {
    #[doc = words!(sf_pose_identity)]
    fn default() -> Pose {
        of(&unsafe { sys::sf_pose_identity() })
    }
}

impl Pose {
    #[doc = words!(sf_pose_move: change)]
    ///
    /// ```
    /// # fn main() -> libsf::Result<()> {
    /// use libsf::{Pose, PoseChange};
    ///
    /// let quarter = PoseChange { spin_rad: [0.0, 0.0, std::f64::consts::FRAC_PI_2], ..PoseChange::default() };
    /// let turned = Pose::default().moved(&quarter)?.moved(&quarter)?;
    /// assert!((turned.turn[0] + 1.0).abs() < 1e-12 && (turned.turn[8] - 1.0).abs() < 1e-12);
    /// # Ok(())
    /// # }
    /// ```
    pub fn moved(self, change: &PoseChange) -> Result<Pose> {
        let mut pose = c(&self);
        check(unsafe { sys::sf_pose_move(&mut pose, &c(change)) })?;
        Ok(of(&pose))
    }
}

/// Poses as C has them, if there is one for each handle.
pub(crate) fn one_each<T: crate::plain::Plain>(
    given: &[T],
    handles: usize,
    what: &str,
) -> Result<*const T::C> {
    if given.len() != handles {
        let said = format!("{} {what} for {handles} handles", given.len());
        return Err(Error::new(ErrorKind::Shape, said));
    }
    Ok(crate::plain::first(given))
}
