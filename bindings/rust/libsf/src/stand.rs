// SPDX-License-Identifier: MIT
// Make it stand: a shape carved inside and bent outside until it rests as it is meant to.
//
// C keeps the addresses of the caller's functions of places for as long as the shape lives, and asks them on
// the thread that makes a call. They lie in a block of their own, which the shape frees after itself. When
// one panics, the call is cancelled, so that the shape is as it was, and the panic goes on from there.

use std::cell::RefCell;
use std::ffi::{c_int, c_void};
use std::fmt;
use std::mem::zeroed;
use std::ptr::NonNull;

use crate::caught::Caught;
use crate::error::{check, check_fault, no_fault, Result};
use crate::handle::c_handles;
use crate::made::Made;
use crate::memory::allocator;
use crate::plain::{c, elements, first, of};
use crate::task::run;
use crate::{sys, Ballast, Canceller, Error, ErrorKind, Grid, Handle, Lattice, Lent, Mesh, Pose};
use crate::{Stance, StanceOptions, StandOptions, StandReport, Task};

type Density<'f> = dyn FnMut([f64; 3]) -> f64 + Send + 'f;
type Keep<'f> = dyn FnMut([f64; 3]) -> bool + Send + 'f;

/// What a shape is made of, and what of it must stay.
#[derive(Default)]
pub struct Inside<'f> {
    ballast: Vec<Ballast>,
    density: Option<Box<Density<'f>>>,
    keep: Option<Box<Keep<'f>>>,
}

impl<'f> Inside<'f> {
    /// Matter of one density, all of which but the wall may be carved.
    pub fn new() -> Inside<'f> {
        Inside::default()
    }

    #[doc = words!(sf_stand_options.ballast)]
    pub fn ballast(mut self, ballast: &[Ballast]) -> Inside<'f> {
        self.ballast = ballast.to_vec();
        self
    }

    #[doc = words!(sf_density_field)]
    pub fn density(mut self, field: impl FnMut([f64; 3]) -> f64 + Send + 'f) -> Inside<'f> {
        self.density = Some(Box::new(field));
        self
    }

    #[doc = words!(sf_keep_field)]
    pub fn keep(mut self, field: impl FnMut([f64; 3]) -> bool + Send + 'f) -> Inside<'f> {
        self.keep = Some(Box::new(field));
        self
    }
}

impl fmt::Debug for Inside<'_> {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        to.debug_struct("Inside").field("ballast", &self.ballast).finish_non_exhaustive()
    }
}

/// What C's callbacks need, at an address that stays.
struct Fields<'f> {
    density: RefCell<Option<Box<Density<'f>>>>,
    keep: RefCell<Option<Box<Keep<'f>>>>,
    caught: Caught,
    running: RefCell<Option<Canceller>>,
}

impl Fields<'_> {
    fn ask<T>(&self, otherwise: T, call: impl FnOnce() -> T) -> T
    where
        T: Copy,
    {
        if self.caught.any() {
            return otherwise;
        }
        let value = self.caught.guard(otherwise, call);
        if self.caught.any() {
            if let Some(running) = self.running.borrow().as_ref() {
                running.cancel();
            }
        }
        value
    }
}

/// # Safety
/// `user` leads to fields, and `p_mm` to three numbers.
unsafe extern "C" fn density(user: *mut c_void, p_mm: *const f64) -> f64 {
    let fields = unsafe { &*user.cast_const().cast::<Fields<'_>>() };
    let place = unsafe { p_mm.cast::<[f64; 3]>().read() };
    // A density of 0 is refused at once.
    fields.ask(0.0, || fields.density.borrow_mut().as_mut().map_or(1.0, |field| field(place)))
}

/// # Safety
/// As that of densities.
unsafe extern "C" fn keep(user: *mut c_void, p_mm: *const f64) -> c_int {
    let fields = unsafe { &*user.cast_const().cast::<Fields<'_>>() };
    let place = unsafe { p_mm.cast::<[f64; 3]>().read() };
    fields.ask(true, || fields.keep.borrow_mut().as_mut().is_some_and(|field| field(place))).into()
}

#[doc = words!(sf_stand)]
///
/// ```
/// # fn main() -> libsf::Result<()> {
/// use libsf::{Grid, Inside, Lattice, Stand, StanceOptions, StandOptions};
///
/// // A foot, and an arm that pulls it over: the arm is carved until it stands.
/// let lattice = Lattice::new(28, 10, 24, 1.0, 1.0)?;
/// let grid = Grid::from_fn(&lattice, |layer, _, x| x < 10 || (layer >= 10 && x < 24))?;
/// let mesh = grid.surface(0, None)?;
/// let options = StandOptions { pitch_mm: 0.5, wall_mm: 1.0, deform: false, ..StandOptions::default() };
/// let stances = [StanceOptions::default()];
/// let mut shape = Stand::new(&mesh, &stances, &[], &options, Inside::new(), None)?;
/// let report = shape.run(None)?;
/// assert!(report.margin_before_rad < 0.0 && report.succeeded);
/// assert!(shape.cavity()?.is_some());
/// # Ok(())
/// # }
/// ```
///
/// What it lends lasts until the next round:
///
/// ```compile_fail,E0502
/// # fn last(shape: &mut libsf::Stand<'_>) -> libsf::Result<()> {
/// let grid = shape.grid()?;
/// shape.round(None)?;
/// println!("{}", grid.count());
/// # Ok(())
/// # }
/// ```
pub struct Stand<'f> {
    c: NonNull<sys::sf_stand>,
    fields: NonNull<Fields<'f>>,
    handles: usize,
}

// The fields are asked by whoever has the shape for himself, and what it lends is only read.
unsafe impl Send for Stand<'_> {}
unsafe impl Sync for Stand<'_> {}

impl<'f> Stand<'f> {
    #[doc = words!(sf_stand_create: mesh, stances, handles)]
    pub fn new(
        mesh: &Mesh,
        stances: &[StanceOptions],
        handles: &[Handle<'_>],
        options: &StandOptions,
        inside: Inside<'f>,
        task: Option<&mut Task<'_>>,
    ) -> Result<Stand<'f>> {
        let stances: Vec<_> = stances.iter().map(StanceOptions::c).collect();
        let handles = c_handles(handles);
        let fields = Owned::new(Fields {
            density: RefCell::new(inside.density),
            keep: RefCell::new(inside.keep),
            caught: Caught::default(),
            running: RefCell::new(None),
        });
        let shared = fields.get();
        let mut from = options.c();
        from.ballast = first(&inside.ballast);
        from.ballast_count = inside.ballast.len();
        from.density = shared.density.borrow().is_some().then_some(density as _);
        from.keep = shared.keep.borrow().is_some().then_some(keep as _);
        from.density_user = fields.0.as_ptr().cast();
        from.keep_user = from.density_user;
        let (mut made, mut fault) = (Made::new(sys::sf_stand_destroy), no_fault());
        let created = running(shared, task, |task| unsafe {
            let (asked, moved, to) = (stances.as_ptr(), handles.as_ptr(), made.place());
            let (asked_count, moved_count) = (stances.len(), handles.len());
            sys::sf_stand_create(
                mesh.view(),
                asked,
                asked_count,
                moved,
                moved_count,
                &from,
                allocator(),
                task,
                to,
                &mut fault,
            )
        });
        check_fault(created, &fault)?;
        Ok(Stand { c: made.own()?, fields: fields.leave(), handles: handles.len() })
    }

    fn c(&self) -> *const sys::sf_stand {
        self.c.as_ptr()
    }

    fn go(
        &mut self,
        task: Option<&mut Task<'_>>,
        call: impl FnOnce(*mut sys::sf_stand, *mut sys::sf_task, *mut sys::sf_stand_report) -> sys::sf_status,
    ) -> Result<StandReport> {
        let mut report: sys::sf_stand_report = unsafe { zeroed() };
        let fields = unsafe { self.fields.as_ref() };
        check(running(fields, task, |task| call(self.c.as_ptr(), task, &mut report)))?;
        Ok(StandReport::of(&report))
    }

    #[doc = words!(sf_stand_round)]
    pub fn round(&mut self, task: Option<&mut Task<'_>>) -> Result<StandReport> {
        self.go(task, |c, task, report| unsafe { sys::sf_stand_round(c, task, report) })
    }

    #[doc = words!(sf_stand_run)]
    pub fn run(&mut self, task: Option<&mut Task<'_>>) -> Result<StandReport> {
        self.go(task, |c, task, report| unsafe { sys::sf_stand_run(c, task, report) })
    }

    #[doc = words!(sf_stand_describe)]
    pub fn report(&self) -> StandReport {
        StandReport::of(&unsafe { sys::sf_stand_describe(self.c()) })
    }

    #[doc = words!(sf_stand_set_pose: handle, pose, lock)]
    pub fn set_pose(&mut self, handle: usize, pose: &Pose, lock: bool) -> Result<()> {
        check(unsafe { sys::sf_stand_set_pose(self.c.as_ptr(), handle, &c(pose), lock.into()) })
    }

    #[doc = words!(sf_stand_get_pose)]
    ///
    /// `None` where there is no such handle.
    pub fn pose(&self, handle: usize) -> Option<Pose> {
        (handle < self.handles).then(|| of(&unsafe { sys::sf_stand_get_pose(self.c(), handle) }))
    }

    #[doc = words!(sf_stand_outer)]
    pub fn outer(&self) -> Result<Mesh> {
        Mesh::copied(unsafe { sys::sf_stand_outer(self.c()) })
    }

    #[doc = words!(sf_stand_cavity)]
    ///
    /// `None` where there is none.
    pub fn cavity(&self) -> Result<Option<Mesh>> {
        let view = unsafe { sys::sf_stand_cavity(self.c()) };
        (view.triangle_count > 0).then(|| Mesh::copied(view)).transpose()
    }

    #[doc = words!(sf_stand_grid)]
    pub fn grid(&self) -> Result<Lent<'_, Grid>> {
        let c = unsafe { sys::sf_stand_grid(self.c()) };
        if c.is_null() {
            return Err(Error::new(ErrorKind::Argument, "there was no round yet, so there are no voxels"));
        }
        let lattice = Lattice::of(&unsafe { sys::sf_grid_lattice(c) })?;
        Ok(Lent::new(Grid::lent(c, &lattice)?))
    }

    #[doc = words!(sf_stand_density)]
    pub fn density(&self) -> Option<&[f32]> {
        let first = unsafe { sys::sf_stand_density(self.c()) };
        let grid = unsafe { sys::sf_stand_grid(self.c()) };
        if first.is_null() || grid.is_null() {
            return None;
        }
        let on = unsafe { sys::sf_grid_lattice(grid) };
        let count = [on.ny, on.nz].iter().try_fold(on.nx as usize, |n, &m| n.checked_mul(m as usize))?;
        Some(unsafe { elements(first, count) })
    }

    #[doc = words!(sf_stand_stance)]
    pub fn stance(&self, index: usize) -> Result<Lent<'_, Stance>> {
        let c = unsafe { sys::sf_stand_stance(self.c(), index) };
        if c.is_null() {
            return Err(Error::new(ErrorKind::Argument, format!("there is no stance {index}")));
        }
        Ok(Lent::new(Stance::lent(c)?))
    }
}

/// Makes a call during which the fields may be asked.
fn running(
    fields: &Fields<'_>,
    task: Option<&mut Task<'_>>,
    call: impl FnOnce(*mut sys::sf_task) -> sys::sf_status,
) -> sys::sf_status {
    let status = match task {
        Some(task) => ask_on(fields, task, call),
        None => ask_on(fields, &mut Task::new(), call),
    };
    fields.caught.pass_on();
    status
}

fn ask_on(
    fields: &Fields<'_>,
    task: &mut Task<'_>,
    call: impl FnOnce(*mut sys::sf_task) -> sys::sf_status,
) -> sys::sf_status {
    fields.running.replace(Some(task.canceller()));
    let status = run(Some(task), call);
    fields.running.replace(None);
    status
}

/// A block that C has the address of, freed unless somebody takes it over.
struct Owned<T>(NonNull<T>);

impl<T> Owned<T> {
    fn new(value: T) -> Owned<T> {
        Owned(NonNull::from(Box::leak(Box::new(value))))
    }

    fn get(&self) -> &T {
        unsafe { self.0.as_ref() }
    }

    fn leave(self) -> NonNull<T> {
        std::mem::ManuallyDrop::new(self).0
    }
}

impl<T> Drop for Owned<T> {
    fn drop(&mut self) {
        drop(unsafe { Box::from_raw(self.0.as_ptr()) });
    }
}

impl Drop for Stand<'_> {
    fn drop(&mut self) {
        unsafe { sys::sf_stand_destroy(self.c.as_ptr()) };
        drop(Owned(self.fields));
    }
}

impl fmt::Debug for Stand<'_> {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        let report = self.report();
        write!(to, "Stand({} rounds, margin {} rad)", report.rounds, report.margin_rad)
    }
}
