// SPDX-License-Identifier: MIT
// Limits: the smooth shape that a cage stands for, at any place of it, and the way back from a point to the
// place that lies there.
//
// C asks for as many positions and values as the cage had and cannot count what it is given; the numbers are
// kept here. A locator reads the limit, which therefore cannot be updated while one lives.

use std::fmt;
use std::marker::PhantomData;
use std::mem::zeroed;
use std::ptr::{self, NonNull};

use crate::error::{check, Result};
use crate::grid::own;
use crate::made::Made;
use crate::memory::allocator;
use crate::plain::{first, first_mut, of, room};
use crate::refine::as_long;
use crate::task::run;
use crate::{sys, Cage, Error, ErrorKind, LimitReport, Place, RefineRules, Task};

#[doc = words!(sf_limit)]
pub struct Limit {
    c: NonNull<sys::sf_limit>,
    dimension: u32,
    points: usize,
    values: Vec<usize>,
}

// All that it points to is its own, and C only reads what it takes as const.
unsafe impl Send for Limit {}
unsafe impl Sync for Limit {}

impl Cage {
    #[doc = words!(sf_limit_create)]
    pub fn limit(&self, rules: RefineRules, task: Option<&mut Task<'_>>) -> Result<Limit> {
        let mut made = Made::new(sys::sf_limit_destroy);
        check(run(task, |task| unsafe {
            sys::sf_limit_create(self.c(), rules.c(), allocator(), task, made.place())
        }))?;
        let view = self.view();
        let values = view.channels.iter().map(|channel| channel.values.len()).collect();
        Ok(Limit { c: made.own()?, dimension: view.dimension, points: view.positions.len(), values })
    }
}

impl Limit {
    pub(crate) fn c(&self) -> *const sys::sf_limit {
        self.c.as_ptr()
    }

    /// The dimension of its cage, 2 or 3.
    pub fn dimension(&self) -> u32 {
        self.dimension
    }

    /// How many properties its cage had.
    pub fn channel_count(&self) -> usize {
        self.values.len()
    }

    #[doc = words!(sf_limit_piece_count)]
    pub fn piece_count(&self) -> usize {
        unsafe { sys::sf_limit_piece_count(self.c()) }
    }

    #[doc = words!(sf_limit_place: cell, u)]
    pub fn place(&self, cell: usize, u: [f64; 3]) -> Result<Place> {
        let mut place: sys::sf_place = unsafe { zeroed() };
        check(unsafe { sys::sf_limit_place(self.c(), cell, u.as_ptr(), &mut place) })?;
        Ok(of(&place))
    }

    #[doc = words!(sf_limit_positions: places)]
    pub fn positions(&self, places: &[Place], task: Option<&mut Task<'_>>) -> Result<Vec<[f64; 3]>> {
        let mut found = room::<[f64; 3]>(places.len())?;
        let (at, to, count) = (first(places), found.as_mut_ptr().cast(), places.len());
        check(run(task, |task| unsafe {
            sys::sf_limit_positions(self.c(), count, at, allocator(), task, to, ptr::null_mut())
        }))?;
        Ok(found)
    }

    /// Where places lie, and their derivatives: of each place 9 numbers, in dimension 2 6: of x by each
    /// parameter, then of y, then of z; as [`Limit::positions`].
    pub fn derivatives(
        &self,
        places: &[Place],
        task: Option<&mut Task<'_>>,
    ) -> Result<(Vec<[f64; 3]>, Vec<f64>)> {
        let mut found = room::<[f64; 3]>(places.len())?;
        let mut slopes = room::<f64>(many(places.len(), 3 * self.dimension as usize)?)?;
        let (at, count) = (first(places), places.len());
        let (to, by) = (found.as_mut_ptr().cast(), slopes.as_mut_ptr());
        check(run(task, |task| unsafe {
            sys::sf_limit_positions(self.c(), count, at, allocator(), task, to, by)
        }))?;
        Ok((found, slopes))
    }

    #[doc = words!(sf_limit_values: channel, places)]
    pub fn values(&self, channel: usize, places: &[Place], task: Option<&mut Task<'_>>) -> Result<Vec<f64>> {
        let mut found = room::<f64>(places.len())?;
        let (at, to, count) = (first(places), found.as_mut_ptr(), places.len());
        check(run(task, |task| unsafe {
            sys::sf_limit_values(self.c(), channel, count, at, allocator(), task, to, ptr::null_mut())
        }))?;
        Ok(found)
    }

    /// What a property is at places, and its derivatives: of each place 3 numbers, in dimension 2 2, by each
    /// parameter; as [`Limit::values`].
    pub fn value_derivatives(
        &self,
        channel: usize,
        places: &[Place],
        task: Option<&mut Task<'_>>,
    ) -> Result<(Vec<f64>, Vec<f64>)> {
        let mut found = room::<f64>(places.len())?;
        let mut slopes = room::<f64>(many(places.len(), self.dimension as usize)?)?;
        let (at, count) = (first(places), places.len());
        let (to, by) = (found.as_mut_ptr(), slopes.as_mut_ptr());
        check(run(task, |task| unsafe {
            sys::sf_limit_values(self.c(), channel, count, at, allocator(), task, to, by)
        }))?;
        Ok((found, slopes))
    }

    #[doc = words!(sf_limit_check)]
    pub fn check(&self, task: Option<&mut Task<'_>>) -> Result<LimitReport> {
        let mut report: sys::sf_limit_report = unsafe { zeroed() };
        check(run(task, |task| unsafe { sys::sf_limit_check(self.c(), allocator(), task, &mut report) }))?;
        Ok(LimitReport::of(&report))
    }

    #[doc = words!(sf_limit_bounds)]
    ///
    /// The two corners.
    pub fn bounds(&self, task: Option<&mut Task<'_>>) -> Result<[[f64; 3]; 2]> {
        let mut found = [[0.0; 3]; 2];
        let [low, high] = &mut found;
        let (low, high) = (low.as_mut_ptr(), high.as_mut_ptr());
        check(run(task, |task| unsafe { sys::sf_limit_bounds(self.c(), allocator(), task, low, high) }))?;
        Ok(found)
    }

    #[doc = words!(sf_limit_update_positions: positions)]
    pub fn update_positions(&mut self, positions: &[[f64; 3]], task: Option<&mut Task<'_>>) -> Result<()> {
        as_long(positions.len(), self.points, "positions")?;
        let (c, xyz) = (self.c.as_ptr(), positions.as_ptr().cast());
        check(run(task, |task| unsafe { sys::sf_limit_update_positions(c, xyz, task) }))
    }

    #[doc = words!(sf_limit_update_values: channel, values)]
    pub fn update_values(
        &mut self,
        channel: usize,
        values: &[f64],
        task: Option<&mut Task<'_>>,
    ) -> Result<()> {
        if let Some(&needed) = self.values.get(channel) {
            as_long(values.len(), needed, "values")?;
        }
        let (c, to) = (self.c.as_ptr(), values.as_ptr());
        check(run(task, |task| unsafe { sys::sf_limit_update_values(c, channel, to, task) }))
    }

    #[doc = words!(sf_locator_create)]
    pub fn locator(&self) -> Result<Locator<'_>> {
        let mut made = ptr::null_mut();
        check(unsafe { sys::sf_locator_create(self.c(), allocator(), &mut made) })?;
        Ok(Locator { c: own(made)?, limit: PhantomData })
    }
}

/// So many numbers for each of so many places.
fn many(places: usize, each: usize) -> Result<usize> {
    let too_many = || Error::new(ErrorKind::Overflow, format!("{places} places"));
    places.checked_mul(each).ok_or_else(too_many)
}

impl Drop for Limit {
    fn drop(&mut self) {
        unsafe { sys::sf_limit_destroy(self.c.as_ptr()) }
    }
}

impl fmt::Debug for Limit {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(to, "Limit({} pieces, {} properties)", self.piece_count(), self.values.len())
    }
}

#[doc = words!(sf_locator)]
///
/// ```
/// # fn main() -> libsf::Result<()> {
/// use libsf::{Cage, RefineRules};
///
/// let limit = Cage::block([3; 3], [0.0; 3], [9.0; 3])?.limit(RefineRules::Standard, None)?;
/// let found = limit.locator()?.find(&[[4.0, 5.0, 3.0], [50.0; 3]], 0.0, None)?;
/// let (place, distance_mm) = found[0].unwrap();
/// assert!(distance_mm < 1e-8);
/// let at = limit.positions(&[place], None)?[0];
/// assert!((at[0] - 4.0).abs() < 1e-8 && (at[1] - 5.0).abs() < 1e-8);
/// assert_eq!(found[1], None);
/// # Ok(())
/// # }
/// ```
///
/// While there is one the limit stays as it is:
///
/// ```compile_fail,E0502
/// # fn main() -> libsf::Result<()> {
/// # use libsf::{Cage, RefineRules};
/// # let cage = Cage::block([3; 3], [0.0; 3], [9.0; 3])?;
/// let mut limit = cage.limit(RefineRules::Standard, None)?;
/// let locator = limit.locator()?;
/// limit.update_positions(cage.positions(), None)?;
/// locator.find(&[[4.0; 3]], 0.0, None)?;
/// # Ok(())
/// # }
/// ```
pub struct Locator<'l> {
    c: NonNull<sys::sf_locator>,
    limit: PhantomData<&'l Limit>,
}

// It does not change once it is made.
unsafe impl Send for Locator<'_> {}
unsafe impl Sync for Locator<'_> {}

impl Locator<'_> {
    #[doc = words!(sf_locator_find: points, reach_mm)]
    ///
    /// The place of each point, and how far from it that lies; `None` where none is within reach.
    pub fn find(
        &self,
        points: &[[f64; 3]],
        reach_mm: f64,
        task: Option<&mut Task<'_>>,
    ) -> Result<Vec<Option<(Place, f64)>>> {
        let count = points.len();
        let (mut places, mut distances) = (room::<Place>(count)?, room::<f64>(count)?);
        let (from, to, far) = (points.as_ptr().cast(), first_mut(&mut places), distances.as_mut_ptr());
        let c = self.c.as_ptr();
        check(run(task, |task| unsafe {
            sys::sf_locator_find(c, count, from, reach_mm, allocator(), task, to, far)
        }))?;
        let found = places.into_iter().zip(distances);
        Ok(found.map(|one| (one.0.piece != sys::SF_NO_PIECE).then_some(one)).collect())
    }
}

impl Drop for Locator<'_> {
    fn drop(&mut self) {
        unsafe { sys::sf_locator_destroy(self.c.as_ptr()) }
    }
}

impl fmt::Debug for Locator<'_> {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        to.debug_struct("Locator").finish_non_exhaustive()
    }
}
