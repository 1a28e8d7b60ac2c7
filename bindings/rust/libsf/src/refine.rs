// SPDX-License-Identifier: MIT
// Refinement: a cage cut finer, step by step. What it shows of a step borrows it, so that nothing changes
// under whoever looks.

use std::fmt;
use std::mem::zeroed;
use std::ptr::{self, NonNull};

use crate::error::{check, Result};
use crate::made::Made;
use crate::memory::allocator;
use crate::plain::room;
use crate::task::run;
use crate::{sys, Cage, CageView, Error, ErrorKind, RefineRules, Task};

#[doc = words!(sf_refinement)]
///
/// ```
/// # fn main() -> libsf::Result<()> {
/// use libsf::{Cage, RefineRules};
///
/// let cage = Cage::block([1; 3], [-1.0; 3], [1.0; 3])?;
/// let fine = cage.refined(2, RefineRules::Standard, None)?;
/// let step = fine.view(2)?;
/// assert_eq!(step.cell_count(), 64);
/// // The middle of the cell stays in the middle, by equal weights of all corners.
/// let middle = step.positions.iter().position(|at| *at == [0.0; 3]).unwrap();
/// assert_eq!(fine.stencil(2, middle)?.len(), 8);
/// # Ok(())
/// # }
/// ```
pub struct Refinement {
    c: NonNull<sys::sf_refinement>,
}

// All that it points to is its own, and C only reads what it takes as const.
unsafe impl Send for Refinement {}
unsafe impl Sync for Refinement {}

impl Cage {
    #[doc = words!(sf_refine)]
    pub fn refined(&self, steps: u32, rules: RefineRules, task: Option<&mut Task<'_>>) -> Result<Refinement> {
        let mut options = unsafe { sys::sf_refine_options_default() };
        options.steps = steps;
        options.rules = rules.c();
        let mut made = Made::new(sys::sf_refinement_destroy);
        check(run(task, |task| unsafe {
            sys::sf_refine(self.c(), &options, allocator(), task, made.place())
        }))?;
        Ok(Refinement { c: made.own()? })
    }
}

/// Refuses an array that is not as long as what it takes the place of.
pub(crate) fn as_long(given: usize, needed: usize, what: &str) -> Result<()> {
    if given != needed {
        return Err(Error::new(ErrorKind::Shape, format!("{given} {what}, and the cage has {needed}")));
    }
    Ok(())
}

impl Refinement {
    pub(crate) fn c(&self) -> *const sys::sf_refinement {
        self.c.as_ptr()
    }

    #[doc = words!(sf_refinement_get_view: step)]
    pub fn view(&self, step: u32) -> Result<CageView<'_>> {
        let mut view: sys::sf_cage_view = unsafe { zeroed() };
        check(unsafe { sys::sf_refinement_get_view(self.c(), step, &mut view) })?;
        Ok(unsafe { CageView::of(&view) })
    }

    #[doc = words!(sf_refinement_update_positions: positions)]
    pub fn update_positions(&mut self, positions: &[[f64; 3]], task: Option<&mut Task<'_>>) -> Result<()> {
        as_long(positions.len(), self.view(0)?.positions.len(), "positions")?;
        let (c, xyz) = (self.c.as_ptr(), positions.as_ptr().cast());
        check(run(task, |task| unsafe { sys::sf_refinement_update_positions(c, xyz, task) }))
    }

    #[doc = words!(sf_refinement_update_values: channel, values)]
    pub fn update_values(
        &mut self,
        channel: usize,
        values: &[f64],
        task: Option<&mut Task<'_>>,
    ) -> Result<()> {
        let view = self.view(0)?;
        if let Some(found) = view.channels.get(channel) {
            as_long(values.len(), found.values.len(), "values")?;
        }
        let c = self.c.as_ptr();
        check(run(task, |task| unsafe {
            sys::sf_refinement_update_values(c, channel, values.as_ptr(), task)
        }))
    }

    #[doc = words!(sf_refinement_stencil: step, point)]
    ///
    /// Points of the cage, and their weights.
    pub fn stencil(&self, step: u32, point: usize) -> Result<Vec<(u32, f64)>> {
        let mut count = 0;
        let (no_points, no_weights) = (ptr::null_mut(), ptr::null_mut());
        let asked = unsafe {
            let c = self.c();
            sys::sf_refinement_stencil(c, step, point, allocator(), 0, no_points, no_weights, &mut count)
        };
        if asked != sys::SF_ERR_CAPACITY {
            check(asked)?;
        }
        let (mut points, mut weights) = (room::<u32>(count)?, room::<f64>(count)?);
        let (to_points, to_weights) = (points.as_mut_ptr(), weights.as_mut_ptr());
        check(unsafe {
            let c = self.c();
            sys::sf_refinement_stencil(c, step, point, allocator(), count, to_points, to_weights, &mut count)
        })?;
        Ok(points.into_iter().zip(weights).collect())
    }
}

impl Drop for Refinement {
    fn drop(&mut self) {
        unsafe { sys::sf_refinement_destroy(self.c.as_ptr()) }
    }
}

impl fmt::Debug for Refinement {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        to.debug_struct("Refinement").finish_non_exhaustive()
    }
}
