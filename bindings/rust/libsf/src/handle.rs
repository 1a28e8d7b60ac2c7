// SPDX-License-Identifier: MIT
// Handles: a few places of a solid that are posed, and that the whole follows.

use std::cell::RefCell;
use std::ffi::{c_int, c_void};
use std::ptr;

use crate::caught::Caught;
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

#[doc = words!(sf_ray_hit)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RayHit {
    #[doc = words!(sf_ray_hit.along)]
    pub along: f64,
    #[doc = words!(sf_ray_hit.triangle)]
    pub triangle: u32,
    /// Whether the ray comes from inside there; else it enters.
    pub leaves: bool,
}

/// The caller's function that finds hits, and what it panicked with.
struct Caster<F> {
    next: RefCell<F>,
    caught: Caught,
}

/// # Safety
/// `user` leads to a caster with a function of this type, and all others to what C says.
unsafe extern "C" fn next<F: FnMut([f64; 3], [f64; 3], f64) -> Option<RayHit>>(
    user: *mut c_void,
    from_mm: *const f64,
    direction: *const f64,
    beyond: f64,
    hit: *mut sys::sf_ray_hit,
    found: *mut c_int,
) -> sys::sf_status {
    let caster = unsafe { &*user.cast_const().cast::<Caster<F>>() };
    let (from, along) = unsafe { (from_mm.cast::<[f64; 3]>().read(), direction.cast::<[f64; 3]>().read()) };
    let asked = caster.caught.guard(None, || Some(caster.next.borrow_mut()(from, along, beyond)));
    let Some(answer) = asked else { return sys::SF_ERR_CANCELLED };
    if let Some(RayHit { along, triangle, leaves }) = answer {
        unsafe { hit.write(sys::sf_ray_hit { along, triangle, leaves: leaves.into() }) };
    }
    unsafe { found.write(answer.is_some().into()) };
    sys::SF_OK
}

#[doc = words!(sf_handle_center_by_rays: from_mm, direction)]
///
/// `caster` gets where a ray begins, where it runs, and how many times that direction's length beyond its
/// beginning the hit that is wanted must lie; it returns the nearest such hit.
///
/// ```
/// # fn main() -> libsf::Result<()> {
/// use libsf::{handle_center_by_rays, RayHit};
///
/// // A slab between the heights 2 and 6.
/// let slab = |from: [f64; 3], direction: [f64; 3], beyond: f64| {
///     let hits = [(6.0, 0), (2.0, 1)].map(|(height, triangle)| {
///         let along = (height - from[2]) / direction[2];
///         RayHit { along, triangle, leaves: (direction[2] < 0.0) == (triangle == 1) }
///     });
///     hits.into_iter().filter(|hit| hit.along > beyond).min_by(|a, b| a.along.total_cmp(&b.along))
/// };
/// let center = handle_center_by_rays(slab, [1.0, 1.0, 9.0], [0.0, 0.0, -2.0])?;
/// assert_eq!(center, [1.0, 1.0, 4.0]);
/// # Ok(())
/// # }
/// ```
pub fn handle_center_by_rays<F>(caster: F, from_mm: [f64; 3], direction: [f64; 3]) -> Result<[f64; 3]>
where
    F: FnMut([f64; 3], [f64; 3], f64) -> Option<RayHit>,
{
    let caster = Caster { next: RefCell::new(caster), caught: Caught::default() };
    let user = (&caster as *const Caster<F>).cast_mut().cast();
    let (mut found, mut fault) = ([0.0; 3], no_fault());
    let asked = sys::sf_ray_caster { next: Some(next::<F>), user };
    let (from, along, to) = (from_mm.as_ptr(), direction.as_ptr(), found.as_mut_ptr());
    let met = unsafe { sys::sf_handle_center_by_rays(asked, from, along, to, &mut fault) };
    caster.caught.resume();
    check_fault(met, &fault)?;
    Ok(found)
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
