// SPDX-License-Identifier: MIT
// Weights of the points of a solid for its handles, and blends: where points go when handles are posed.

use std::fmt;
use std::ptr::NonNull;

use crate::error::{check, check_fault, no_fault, Result};
use crate::handle::{c_handles, one_each};
use crate::made::Made;
use crate::memory::allocator;
use crate::plain::{elements, first_mut, room};
use crate::task::run;
use crate::{
    sys, Error, ErrorKind, Fold, Grid, Handle, Pose, PoseChange, Task, WeightsFacts, WeightsOptions,
};

#[doc = words!(sf_weights)]
///
/// ```
/// # fn main() -> libsf::Result<()> {
/// use libsf::{Blend, Grid, Handle, Lattice, Pose, Weights, WeightsOptions};
///
/// // A bar that is held at one end and lifted at the other.
/// let lattice = Lattice::new(40, 8, 8, 0.5, 0.5)?;
/// let bar = Grid::from_fn(&lattice, |_, _, _| true)?;
/// let handles = [Handle::point([1.75, 2.0, 2.0]), Handle::point([18.25, 2.0, 2.0])];
/// let weights = Weights::new(&bar, &handles, &WeightsOptions::default(), None)?;
/// let (w, _) = weights.at([10.0, 2.0, 2.0])?;
/// assert!((w[0] - 0.5).abs() < 0.01 && (w[0] + w[1] - 1.0).abs() < 1e-12);
///
/// let lifted = Pose { shift_mm: [0.0, 0.0, 3.0], ..Pose::default() };
/// let blend = Blend::new(&weights, &[[1.75, 2.0, 2.0], [18.25, 2.0, 2.0]], None)?;
/// let bent = blend.apply(&[Pose::default(), lifted], None)?;
/// assert_eq!(bent, [[1.75, 2.0, 2.0], [18.25, 2.0, 5.0]]);
/// assert_eq!(weights.fold(&[Pose::default(), lifted], None)?.folded, 0);
/// # Ok(())
/// # }
/// ```
pub struct Weights {
    c: NonNull<sys::sf_weights>,
    handles: usize,
}

// C only reads them once they are made.
unsafe impl Send for Weights {}
unsafe impl Sync for Weights {}

/// Where bent points lay before, and how well that is known.
#[derive(Clone, Debug, PartialEq)]
pub struct Unbent {
    /// The rest points, mm.
    pub rest_mm: Vec<[f64; 3]>,
    /// How far the blend of each is from its bent point.
    pub residual_mm: Vec<f64>,
    /// How many were not found within the tolerance.
    pub missed: usize,
}

impl Weights {
    #[doc = words!(sf_weights_create: solid, handles)]
    pub fn new(
        solid: &Grid,
        handles: &[Handle<'_>],
        options: &WeightsOptions,
        task: Option<&mut Task<'_>>,
    ) -> Result<Weights> {
        let (from, options) = (c_handles(handles), options.c());
        let (mut made, mut fault) = (Made::new(sys::sf_weights_destroy), no_fault());
        let created = run(task, |task| unsafe {
            let (first, count, to) = (from.as_ptr(), from.len(), made.place());
            sys::sf_weights_create(solid.c(), first, count, &options, allocator(), task, to, &mut fault)
        });
        check_fault(created, &fault)?;
        Ok(Weights { c: made.own()?, handles: handles.len() })
    }

    fn c(&self) -> *const sys::sf_weights {
        self.c.as_ptr()
    }

    #[doc = words!(sf_weights_describe)]
    pub fn facts(&self) -> WeightsFacts {
        WeightsFacts::of(&unsafe { sys::sf_weights_describe(self.c()) })
    }

    #[doc = words!(sf_weights_centers)]
    pub fn centers(&self) -> &[[f64; 3]] {
        unsafe { elements(sys::sf_weights_centers(self.c()).cast(), self.handles) }
    }

    #[doc = words!(sf_weights_at)]
    ///
    /// A weight for each handle, and its gradient, per mm.
    pub fn at(&self, p_mm: [f64; 3]) -> Result<(Vec<f64>, Vec<[f64; 3]>)> {
        let (mut w, mut gradient): (_, Vec<[f64; 3]>) = (room(self.handles)?, room(self.handles)?);
        let (to, slopes) = (w.as_mut_ptr(), gradient.as_mut_ptr().cast());
        check(unsafe { sys::sf_weights_at(self.c(), p_mm.as_ptr(), to, slopes) })?;
        Ok((w, gradient))
    }

    #[doc = words!(sf_weights_sample)]
    ///
    /// As many in a row as there are handles, point after point.
    pub fn sample(&self, points_mm: &[[f64; 3]], task: Option<&mut Task<'_>>) -> Result<Vec<f64>> {
        let many = || Error::new(ErrorKind::Overflow, format!("weights of {} points", points_mm.len()));
        let mut found = room(points_mm.len().checked_mul(self.handles).ok_or_else(many)?)?;
        check(run(task, |task| unsafe {
            let (from, count, to) = (points_mm.as_ptr().cast(), points_mm.len(), found.as_mut_ptr());
            sys::sf_weights_sample(self.c(), from, count, task, to)
        }))?;
        Ok(found)
    }

    #[doc = words!(sf_weights_fold)]
    pub fn fold(&self, poses: &[Pose], task: Option<&mut Task<'_>>) -> Result<Fold> {
        let (poses, mut found) = (one_each(poses, self.handles, "poses")?, [Fold::default()]);
        check(run(task, |task| unsafe {
            sys::sf_weights_fold(self.c(), poses, task, first_mut(&mut found))
        }))?;
        Ok(found[0])
    }

    #[doc = words!(sf_weights_unbend: tolerance_mm)]
    ///
    /// `guesses_mm` are what was found for a pose close to this one, and without them the bent points.
    pub fn unbend(
        &self,
        bent_mm: &[[f64; 3]],
        poses: &[Pose],
        tolerance_mm: f64,
        guesses_mm: Option<&[[f64; 3]]>,
        task: Option<&mut Task<'_>>,
    ) -> Result<Unbent> {
        let poses = one_each(poses, self.handles, "poses")?;
        let guesses = guesses_mm.unwrap_or(bent_mm);
        if guesses.len() != bent_mm.len() {
            let said = format!("{} guesses for {} points", guesses.len(), bent_mm.len());
            return Err(Error::new(ErrorKind::Shape, said));
        }
        let (mut rest_mm, mut residual_mm): (Vec<[f64; 3]>, _) = (room(guesses.len())?, room(guesses.len())?);
        rest_mm.copy_from_slice(guesses);
        let mut missed = 0;
        check(run(task, |task| unsafe {
            let (bent, count, rest) = (bent_mm.as_ptr().cast(), bent_mm.len(), rest_mm.as_mut_ptr().cast());
            let (off, lost, memory) = (residual_mm.as_mut_ptr(), &mut missed, allocator());
            sys::sf_weights_unbend(self.c(), poses, bent, count, tolerance_mm, memory, task, rest, off, lost)
        }))?;
        Ok(Unbent { rest_mm, residual_mm, missed })
    }
}

impl Drop for Weights {
    fn drop(&mut self) {
        unsafe { sys::sf_weights_destroy(self.c.as_ptr()) }
    }
}

impl fmt::Debug for Weights {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(to, "Weights({} handles, {} cells)", self.handles, self.facts().cell_count)
    }
}

#[doc = words!(sf_blend)]
///
/// With its derivatives in both directions: [`push`](Blend::push) and [`pull`](Blend::pull) make a function of
/// the points one of the poses, for any optimiser.
#[derive(Clone, Debug)]
pub struct Blend {
    rest_mm: Vec<[f64; 3]>,
    weights: Vec<f64>,
    centers_mm: Vec<[f64; 3]>,
}

impl Blend {
    /// Points of a solid that follow its handles.
    pub fn new(weights: &Weights, points_mm: &[[f64; 3]], task: Option<&mut Task<'_>>) -> Result<Blend> {
        let sampled = weights.sample(points_mm, task)?;
        let (rest_mm, centers_mm) = (points_mm.to_vec(), weights.centers().to_vec());
        Ok(Blend { rest_mm, weights: sampled, centers_mm })
    }

    /// The points as they were, mm.
    pub fn rest(&self) -> &[[f64; 3]] {
        &self.rest_mm
    }

    fn c(&self) -> sys::sf_blend {
        sys::sf_blend {
            rest_mm: self.rest_mm.as_ptr().cast(),
            weights: self.weights.as_ptr(),
            point_count: self.rest_mm.len(),
            centers_mm: self.centers_mm.as_ptr().cast(),
            handle_count: self.centers_mm.len(),
        }
    }

    fn poses(&self, given: &[Pose]) -> Result<*const sys::sf_pose> {
        one_each(given, self.centers_mm.len(), "poses")
    }

    #[doc = words!(sf_blend_apply)]
    pub fn apply(&self, poses: &[Pose], task: Option<&mut Task<'_>>) -> Result<Vec<[f64; 3]>> {
        let (poses, mut bent) = (self.poses(poses)?, room(self.rest_mm.len())?);
        let to = <[[f64; 3]]>::as_mut_ptr(&mut bent).cast();
        check(run(task, |task| unsafe { sys::sf_blend_apply(self.c(), poses, task, to) }))?;
        Ok(bent)
    }

    #[doc = words!(sf_blend_push)]
    pub fn push(
        &self,
        poses: &[Pose],
        changes: &[PoseChange],
        task: Option<&mut Task<'_>>,
    ) -> Result<Vec<[f64; 3]>> {
        let changes = one_each(changes, self.centers_mm.len(), "changes")?;
        let (poses, mut moves) = (self.poses(poses)?, room(self.rest_mm.len())?);
        let to = <[[f64; 3]]>::as_mut_ptr(&mut moves).cast();
        check(run(task, |task| unsafe { sys::sf_blend_push(self.c(), poses, changes, task, to) }))?;
        Ok(moves)
    }

    #[doc = words!(sf_blend_pull: gradient)]
    pub fn pull(
        &self,
        poses: &[Pose],
        gradient: &[[f64; 3]],
        task: Option<&mut Task<'_>>,
    ) -> Result<Vec<PoseChange>> {
        if gradient.len() != self.rest_mm.len() {
            let said = format!("derivatives by {} points of {}", gradient.len(), self.rest_mm.len());
            return Err(Error::new(ErrorKind::Shape, said));
        }
        let (poses, mut changes) = (self.poses(poses)?, room(self.centers_mm.len())?);
        check(run(task, |task| unsafe {
            let (from, to) = (gradient.as_ptr().cast(), first_mut(&mut changes));
            sys::sf_blend_pull(self.c(), poses, from, allocator(), task, to)
        }))?;
        Ok(changes)
    }
}
