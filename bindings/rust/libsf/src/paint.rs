// SPDX-License-Identifier: MIT
// Painting a cage: a selection gives each of its points a weight, an operation changes what the weights say;
// and a history takes either back.

use std::fmt;
use std::ptr::{self, NonNull};

use crate::error::{check, Result};
use crate::grid::own;
use crate::memory::allocator;
use crate::{sys, Cage, CageHistoryState, Error, ErrorKind, Falloff, PaintOperation, PaintWhere};

#[doc = words!(sf_paint_brush)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PaintBrush {
    #[doc = words!(sf_paint_brush.from_mm)]
    pub from_mm: [f64; 3],
    #[doc = words!(sf_paint_brush.to_mm)]
    pub to_mm: [f64; 3],
    #[doc = words!(sf_paint_brush.radius_mm)]
    pub radius_mm: f64,
    #[doc = words!(sf_paint_brush.strength)]
    pub strength: f64,
    /// How it falls from its middle.
    pub falloff: Falloff,
    /// Which points it takes.
    pub place: PaintWhere,
}

impl PaintBrush {
    /// A ball, smooth and of full strength.
    pub fn ball(at_mm: [f64; 3], radius_mm: f64) -> PaintBrush {
        let c = unsafe { sys::sf_paint_brush_default() };
        PaintBrush {
            from_mm: at_mm,
            to_mm: at_mm,
            radius_mm,
            strength: c.strength,
            falloff: Falloff::of(c.falloff),
            place: PaintWhere::of(c.where_),
        }
    }

    fn c(&self) -> sys::sf_paint_brush {
        let mut c = unsafe { sys::sf_paint_brush_default() };
        c.from_mm = self.from_mm;
        c.to_mm = self.to_mm;
        c.radius_mm = self.radius_mm;
        c.strength = self.strength;
        c.falloff = self.falloff.c();
        c.where_ = self.place.c();
        c
    }
}

impl Cage {
    /// Refuses weights that are not one for each point.
    fn weighted(&self, weights: &[f64]) -> Result<()> {
        let points = self.positions().len();
        if weights.len() != points {
            let said = format!("{} weights for {points} points", weights.len());
            return Err(Error::new(ErrorKind::Shape, said));
        }
        Ok(())
    }

    #[doc = words!(sf_paint_select: weights)]
    ///
    /// It returns how many points the brush gives a weight above 0.
    ///
    /// ```
    /// # fn main() -> libsf::Result<()> {
    /// use libsf::{Cage, CageHistory, Channel, PaintBrush, PaintOperation, Property};
    ///
    /// let mut cage = Cage::block([8, 8, 8], [0.0; 3], [8.0; 3])?;
    /// cage.add_property(&Channel::of_points(Property::density(), &[1000.0; 729]))?;
    /// let mut history = CageHistory::new(&cage, 1 << 20)?;
    ///
    /// let mut weights = vec![0.0; 729];
    /// cage.select(&PaintBrush::ball([4.0, 4.0, 8.0], 3.0), &mut weights)?;
    /// let changed = cage.paint(0, &weights, PaintOperation::Set, 200.0)?;
    /// assert!(cage.values(0)?.contains(&200.0));
    /// assert_eq!(history.record(&cage)?, changed);
    ///
    /// history.undo(&mut cage)?;
    /// assert_eq!(cage.values(0)?, [1000.0; 729]);
    /// # Ok(())
    /// # }
    /// ```
    pub fn select(&self, brush: &PaintBrush, weights: &mut [f64]) -> Result<usize> {
        self.weighted(weights)?;
        let mut touched = 0;
        let to = weights.as_mut_ptr();
        check(unsafe { sys::sf_paint_select(self.c(), &brush.c(), to, &mut touched) })?;
        Ok(touched)
    }

    #[doc = words!(sf_paint_values: channel, weights, operation, amount)]
    ///
    /// It returns how many values are not what they were.
    pub fn paint(
        &mut self,
        channel: usize,
        weights: &[f64],
        operation: PaintOperation,
        amount: f64,
    ) -> Result<usize> {
        self.weighted(weights)?;
        let mut changed = 0;
        let (cage, by, does) = (self.c_mut(), weights.as_ptr(), operation.c());
        check(unsafe { sys::sf_paint_values(cage, channel, by, does, amount, allocator(), &mut changed) })?;
        Ok(changed)
    }

    #[doc = words!(sf_paint_move: weights, vector_mm)]
    ///
    /// It returns how many points are not where they were.
    pub fn drag(&mut self, weights: &[f64], vector_mm: [f64; 3]) -> Result<usize> {
        self.weighted(weights)?;
        let mut changed = 0;
        let (cage, by, vector) = (self.c_mut(), weights.as_ptr(), vector_mm.as_ptr());
        check(unsafe { sys::sf_paint_move(cage, by, vector, allocator(), &mut changed) })?;
        Ok(changed)
    }

    #[doc = words!(sf_paint_smooth: weights, amount)]
    ///
    /// It returns how many points are not where they were.
    pub fn smooth(&mut self, weights: &[f64], amount: f64) -> Result<usize> {
        self.weighted(weights)?;
        let mut changed = 0;
        let (cage, by) = (self.c_mut(), weights.as_ptr());
        check(unsafe { sys::sf_paint_smooth(cage, by, amount, allocator(), &mut changed) })?;
        Ok(changed)
    }
}

#[doc = words!(sf_cage_history)]
///
/// It remembers how its cage was, and is told of it by each call; of another cage it takes none.
pub struct CageHistory {
    c: NonNull<sys::sf_cage_history>,
}

// All that it points to is its own, and C only reads what it takes as const.
unsafe impl Send for CageHistory {}
unsafe impl Sync for CageHistory {}

impl CageHistory {
    #[doc = words!(sf_cage_history_create: bytes_max)]
    pub fn new(cage: &Cage, bytes_max: usize) -> Result<CageHistory> {
        let mut made = ptr::null_mut();
        check(unsafe { sys::sf_cage_history_create(cage.c(), bytes_max, allocator(), &mut made) })?;
        Ok(CageHistory { c: own(made)? })
    }

    #[doc = words!(sf_cage_history_record)]
    ///
    /// It returns how many numbers are not what they were.
    pub fn record(&mut self, cage: &Cage) -> Result<usize> {
        let mut changed = 0;
        check(unsafe { sys::sf_cage_history_record(self.c.as_ptr(), cage.c(), &mut changed) })?;
        Ok(changed)
    }

    #[doc = words!(sf_cage_history_undo)]
    ///
    /// It returns how many numbers are not what they were; 0: there was no step.
    pub fn undo(&mut self, cage: &mut Cage) -> Result<usize> {
        let mut changed = 0;
        check(unsafe { sys::sf_cage_history_undo(self.c.as_ptr(), cage.c_mut(), &mut changed) })?;
        Ok(changed)
    }

    #[doc = words!(sf_cage_history_redo)]
    ///
    /// It returns how many numbers are not what they were; 0: there was no step.
    pub fn redo(&mut self, cage: &mut Cage) -> Result<usize> {
        let mut changed = 0;
        check(unsafe { sys::sf_cage_history_redo(self.c.as_ptr(), cage.c_mut(), &mut changed) })?;
        Ok(changed)
    }

    #[doc = words!(sf_cage_history_get_state)]
    pub fn state(&self) -> CageHistoryState {
        CageHistoryState::of(&unsafe { sys::sf_cage_history_get_state(self.c.as_ptr()) })
    }
}

impl Drop for CageHistory {
    fn drop(&mut self) {
        unsafe { sys::sf_cage_history_destroy(self.c.as_ptr()) }
    }
}

impl fmt::Debug for CageHistory {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        to.debug_struct("CageHistory").field("state", &self.state()).finish_non_exhaustive()
    }
}
