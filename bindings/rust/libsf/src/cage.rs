// SPDX-License-Identifier: MIT
// Cages: control meshes of cells, in the caller's arrays or in the library's.
//
// C believes the counts of a view. Here a view is slices, and what their lengths have to do with each other
// is looked at before C sees it. A view of a cage borrows the cage, so its values cannot change under it.

use std::fmt;
use std::mem::zeroed;
use std::ptr::{self, NonNull};

use crate::error::{check, check_fault, no_fault, Result};
use crate::grid::own;
use crate::memory::allocator;
use crate::plain::{array, elements, first};
use crate::{sys, CageReport, Channel, Crease, Error, ErrorKind, SharpPoint};

#[doc = words!(sf_cage_view)]
///
/// What a cage is made of, and what it shows of itself.
#[derive(Clone, Debug, PartialEq)]
pub struct CageView<'a> {
    #[doc = words!(sf_cage_view.dimension)]
    pub dimension: u32,
    /// The points, mm.
    pub positions: &'a [[f64; 3]],
    /// Where the corners of each cell begin, and where those of the last end.
    pub starts: &'a [u32],
    /// The points at the corners of all cells.
    pub corners: &'a [u32],
    /// Edges that are sharp, each once.
    pub creases: &'a [Crease],
    /// Points that are sharp, each once.
    pub sharps: &'a [SharpPoint],
    /// Properties, each UUID and each name once.
    pub channels: Vec<Channel<'a>>,
}

/// A view as C has it, with what it points to.
pub(crate) struct PlacedView<'a> {
    pub(crate) c: sys::sf_cage_view,
    _channels: Vec<sys::sf_channel>,
    _view: std::marker::PhantomData<&'a ()>,
}

impl<'a> CageView<'a> {
    /// Cells without properties, and nothing sharp.
    pub fn new(positions: &'a [[f64; 3]], starts: &'a [u32], corners: &'a [u32]) -> CageView<'a> {
        let (creases, sharps, channels) = (&[][..], &[][..], Vec::new());
        CageView { dimension: 3, positions, starts, corners, creases, sharps, channels }
    }

    /// How many cells there are.
    pub fn cell_count(&self) -> usize {
        self.starts.len().saturating_sub(1)
    }

    /// The corners of each cell.
    pub fn cells(&self) -> impl Iterator<Item = &'a [u32]> + '_ {
        let (starts, corners) = (self.starts, self.corners);
        starts.windows(2).map(|two| &corners[two[0] as usize..two[1] as usize])
    }

    /// Number of the property of a name.
    pub fn channel(&self, name: &str) -> Option<usize> {
        self.channels.iter().position(|channel| channel.property.name == name)
    }

    /// As C has it, if its arrays fit each other.
    pub(crate) fn place(&self) -> Result<PlacedView<'a>> {
        let ordered = self.starts.windows(2).all(|two| two[0] <= two[1]);
        let whole = self.starts.last().map_or(0, |&end| end as usize) == self.corners.len();
        if self.starts.first() != Some(&0) || !ordered || !whole {
            let said = format!("starts rise from 0 to the number of corners, {}", self.corners.len());
            return Err(Error::new(ErrorKind::Shape, said));
        }
        let (points, corners) = (self.positions.len(), self.corners.len());
        let channels: Vec<sys::sf_channel> =
            self.channels.iter().map(|channel| channel.c(points, corners)).collect::<Result<_>>()?;
        let c = sys::sf_cage_view {
            dimension: self.dimension,
            point_count: points,
            positions: self.positions.as_ptr().cast(),
            cell_count: self.cell_count(),
            starts: self.starts.as_ptr(),
            corners: self.corners.as_ptr(),
            crease_count: self.creases.len(),
            creases: first(self.creases),
            sharp_count: self.sharps.len(),
            sharps: first(self.sharps),
            channel_count: channels.len(),
            channels: channels.as_ptr(),
        };
        Ok(PlacedView { c, _channels: channels, _view: std::marker::PhantomData })
    }

    /// # Safety
    /// The arrays hold what is said for as long as 'a.
    pub(crate) unsafe fn of(c: &sys::sf_cage_view) -> CageView<'a> {
        unsafe {
            let starts: &[u32] = match c.cell_count {
                0 => &[],
                count => elements(c.starts, count + 1),
            };
            let corners = starts.last().map_or(0, |&end| end as usize);
            CageView {
                dimension: c.dimension,
                positions: elements(c.positions.cast(), c.point_count),
                starts,
                corners: elements(c.corners, corners),
                creases: array(c.creases, c.crease_count),
                sharps: array(c.sharps, c.sharp_count),
                channels: elements(c.channels, c.channel_count)
                    .iter()
                    .map(|channel| Channel::of(channel, corners))
                    .collect(),
            }
        }
    }
}

#[doc = words!(sf_cage)]
///
/// ```
/// # fn main() -> libsf::Result<()> {
/// use libsf::{Cage, CageView, Channel, Property, RefineRules};
///
/// // One cell, half as dense at its top, and round all over.
/// let corners: Vec<[f64; 3]> = (0..8)
///     .map(|i| [[0.0, 8.0, 8.0, 0.0][i % 4], [0.0, 0.0, 8.0, 8.0][i % 4], [0.0, 8.0][i / 4]])
///     .collect();
/// let mut cage = Cage::new(&CageView::new(&corners, &[0, 8], &[0, 1, 2, 3, 4, 5, 6, 7]))?;
/// let density = [1000.0, 1000.0, 1000.0, 1000.0, 500.0, 500.0, 500.0, 500.0];
/// cage.add_property(&Channel::of_points(Property::density(), &density))?;
/// assert_eq!(cage.check()?.volume_mm3, 512.0);
///
/// let limit = cage.limit(RefineRules::Standard, None)?;
/// let middle = limit.place(0, [0.5; 3])?;
/// assert_eq!(limit.positions(&[middle], None)?, [[4.0; 3]]);
/// assert_eq!(limit.values(0, &[middle], None)?, [750.0]);
/// # Ok(())
/// # }
/// ```
pub struct Cage {
    c: NonNull<sys::sf_cage>,
}

// All that it points to is its own, and C only reads what it takes as const.
unsafe impl Send for Cage {}
unsafe impl Sync for Cage {}

impl Cage {
    #[doc = words!(sf_cage_create)]
    pub fn new(view: &CageView<'_>) -> Result<Cage> {
        let placed = view.place()?;
        Cage::made(|made, fault| unsafe { sys::sf_cage_create(&placed.c, allocator(), made, fault) })
    }

    /// The owner of a cage that a call makes.
    pub(crate) fn made(
        call: impl FnOnce(*mut *mut sys::sf_cage, *mut sys::sf_fault) -> sys::sf_status,
    ) -> Result<Cage> {
        let (mut made, mut fault) = (ptr::null_mut(), no_fault());
        check_fault(call(&mut made, &mut fault), &fault)?;
        Cage::of(made)
    }

    /// A new cage of C's.
    pub(crate) fn of(made: *mut sys::sf_cage) -> Result<Cage> {
        Ok(Cage { c: own(made)? })
    }

    pub(crate) fn c(&self) -> *const sys::sf_cage {
        self.c.as_ptr()
    }

    pub(crate) fn c_mut(&mut self) -> *mut sys::sf_cage {
        self.c.as_ptr()
    }

    #[doc = words!(sf_cage_get_view)]
    pub fn view(&self) -> CageView<'_> {
        unsafe { CageView::of(&sys::sf_cage_get_view(self.c())) }
    }

    /// The points, mm.
    pub fn positions(&self) -> &[[f64; 3]] {
        self.view().positions
    }

    /// Number of the property of a name.
    pub fn channel(&self, name: &str) -> Option<usize> {
        self.view().channel(name)
    }

    /// The values of a property.
    pub fn values(&self, channel: usize) -> Result<&[f64]> {
        let none = || Error::new(ErrorKind::Argument, format!("there is no property {channel}"));
        self.view().channels.get(channel).map(|found| found.values).ok_or_else(none)
    }

    /// A copy.
    pub fn try_clone(&self) -> Result<Cage> {
        Cage::new(&self.view())
    }

    #[doc = words!(sf_cage_set_positions: first)]
    pub fn set_positions(&mut self, first: usize, positions: &[[f64; 3]]) -> Result<()> {
        let (cage, xyz) = (self.c_mut(), positions.as_ptr().cast());
        check(unsafe { sys::sf_cage_set_positions(cage, first, positions.len(), xyz) })
    }

    #[doc = words!(sf_cage_set_values: channel, first)]
    pub fn set_values(&mut self, channel: usize, first: usize, values: &[f64]) -> Result<()> {
        let (cage, count) = (self.c_mut(), values.len());
        check(unsafe { sys::sf_cage_set_values(cage, channel, first, count, values.as_ptr()) })
    }

    #[doc = words!(sf_cage_add_property)]
    pub fn add_property(&mut self, channel: &Channel<'_>) -> Result<()> {
        let view = self.view();
        let c = channel.c(view.positions.len(), view.corners.len())?;
        let mut fault = no_fault();
        check_fault(unsafe { sys::sf_cage_add_property(self.c_mut(), &c, &mut fault) }, &fault)
    }

    #[doc = words!(sf_cage_remove_property: channel)]
    pub fn remove_property(&mut self, channel: usize) -> Result<()> {
        check(unsafe { sys::sf_cage_remove_property(self.c_mut(), channel) })
    }

    #[doc = words!(sf_cage_check)]
    pub fn check(&self) -> Result<CageReport> {
        let mut report: sys::sf_cage_report = unsafe { zeroed() };
        check(unsafe { sys::sf_cage_check(self.c(), allocator(), &mut report, ptr::null_mut()) })?;
        Ok(CageReport::of(&report))
    }
}

impl Drop for Cage {
    fn drop(&mut self) {
        unsafe { sys::sf_cage_destroy(self.c.as_ptr()) }
    }
}

impl Clone for Cage {
    /// # Panics
    /// Where there is no memory; [`Cage::try_clone`] says so instead.
    fn clone(&self) -> Cage {
        self.try_clone().expect("memory for a copy of a cage")
    }
}

impl fmt::Debug for Cage {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        let view = self.view();
        let (points, cells, properties) = (view.positions.len(), view.cell_count(), view.channels.len());
        write!(to, "Cage({points} points, {cells} cells, {properties} properties)")
    }
}
