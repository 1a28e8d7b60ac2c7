// SPDX-License-Identifier: MIT
// Tetrahedra with properties: of the caller's arrays, of an exchange file, or of a refinement, which they
// borrow then: their positions and values are the refinement's own.
//
// Exchange files are libhdf5's, which as most builds have it serves one thread of a process at a time. What
// other crates do with it cannot be known here, so reading and writing such files are unsafe.

use std::fmt;
use std::io::{Read, Write};
use std::marker::PhantomData;
use std::mem::zeroed;
use std::ptr::{self, NonNull};

use crate::error::{check, check_fault, no_fault, Result};
use crate::grid::own;
use crate::memory::allocator;
use crate::plain::elements;
use crate::stream::{reading, writing_with};
use crate::{sys, Channel, Refinement, TetsReport};

#[doc = words!(sf_tets_view)]
#[derive(Clone, Debug, PartialEq)]
pub struct TetsView<'a> {
    /// The points, mm.
    pub positions: &'a [[f64; 3]],
    #[doc = words!(sf_tets_view.corners)]
    pub corners: &'a [[u32; 4]],
    /// Properties; their indices are of tetrahedra's corners, in this order.
    pub channels: Vec<Channel<'a>>,
}

#[doc = words!(sf_tets)]
///
/// ```
/// # fn main() -> libsf::Result<()> {
/// use libsf::{Cage, Channel, Property, RefineRules, Tets, TetsView};
///
/// let corners = [[0.0, 0.0, 0.0], [3.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 3.0]];
/// let channels = vec![Channel::of_points(Property::density(), &[1.0, 2.0, 3.0, 4.0])];
/// let one = Tets::new(&TetsView { positions: &corners, corners: &[[0, 1, 2, 3]], channels })?;
/// assert!((one.check()?.volume_mm3 - 4.5).abs() < 1e-12);
///
/// let fine = Cage::block([2; 3], [0.0; 3], [1.0; 3])?.refined(1, RefineRules::Standard, None)?;
/// let tets = Tets::of_refinement(&fine, 1)?;
/// assert_eq!(tets.view().corners.len(), 6 * 64);
/// assert_eq!(tets.check()?.inverted, 0);
/// # Ok(())
/// # }
/// ```
pub struct Tets<'r> {
    c: NonNull<sys::sf_tets>,
    refinement: PhantomData<&'r Refinement>,
}

// What it points to is its own, or borrowed and not changed.
unsafe impl Send for Tets<'_> {}
unsafe impl Sync for Tets<'_> {}

impl Tets<'static> {
    #[doc = words!(sf_tets_create)]
    pub fn new(view: &TetsView<'_>) -> Result<Tets<'static>> {
        let (points, tets) = (view.positions.len(), view.corners.len());
        let corners = tets.saturating_mul(4);
        let channels: Vec<sys::sf_channel> =
            view.channels.iter().map(|channel| channel.c(points, corners)).collect::<Result<_>>()?;
        let c = sys::sf_tets_view {
            point_count: points,
            positions: view.positions.as_ptr().cast(),
            tet_count: tets,
            corners: view.corners.as_ptr().cast(),
            channel_count: channels.len(),
            channels: channels.as_ptr(),
        };
        let (mut made, mut fault) = (ptr::null_mut(), no_fault());
        check_fault(unsafe { sys::sf_tets_create(&c, allocator(), &mut made, &mut fault) }, &fault)?;
        Tets::of(made)
    }

    /// Whether exchange files can be read and written: not where libsf is compiled into the crate, and with
    /// the feature `system` where the installed one has libhdf5.
    ///
    #[doc = words!(sf_exchange_is_served)]
    pub fn has_exchange() -> bool {
        unsafe { sys::sf_exchange_is_served() != 0 }
    }

    #[doc = words!(sf_exchange_read: bytes_max)]
    ///
    /// # Safety
    /// No other thread of the process may use libhdf5 meanwhile, be it through this crate or not.
    pub unsafe fn read_exchange(mut from: impl Read, bytes_max: u64) -> Result<Tets<'static>> {
        let mut made = ptr::null_mut();
        reading(&mut from, |source, fault| unsafe {
            sys::sf_exchange_read(source, bytes_max, allocator(), &mut made, fault)
        })?;
        Tets::of(made)
    }

    #[doc = words!(sf_tets_set_values: channel, first)]
    pub fn set_values(&mut self, channel: usize, first: usize, values: &[f64]) -> Result<()> {
        let (c, count) = (self.c.as_ptr(), values.len());
        check(unsafe { sys::sf_tets_set_values(c, channel, first, count, values.as_ptr()) })
    }
}

impl<'r> Tets<'r> {
    fn of(made: *mut sys::sf_tets) -> Result<Tets<'r>> {
        Ok(Tets { c: own(made)?, refinement: PhantomData })
    }

    #[doc = words!(sf_tets_of_refinement: step)]
    pub fn of_refinement(refinement: &'r Refinement, step: u32) -> Result<Tets<'r>> {
        let mut made = ptr::null_mut();
        check(unsafe { sys::sf_tets_of_refinement(refinement.c(), step, allocator(), &mut made) })?;
        Tets::of(made)
    }

    pub(crate) fn c(&self) -> *const sys::sf_tets {
        self.c.as_ptr()
    }

    #[doc = words!(sf_tets_get_view)]
    pub fn view(&self) -> TetsView<'_> {
        let c = unsafe { sys::sf_tets_get_view(self.c()) };
        unsafe {
            TetsView {
                positions: elements(c.positions.cast(), c.point_count),
                corners: elements(c.corners.cast(), c.tet_count),
                channels: elements(c.channels, c.channel_count)
                    .iter()
                    .map(|channel| Channel::of(channel, 4 * c.tet_count))
                    .collect(),
            }
        }
    }

    #[doc = words!(sf_tets_check)]
    pub fn check(&self) -> Result<TetsReport> {
        let mut report: sys::sf_tets_report = unsafe { zeroed() };
        check(unsafe { sys::sf_tets_check(self.c(), allocator(), &mut report) })?;
        Ok(TetsReport::of(&report))
    }

    #[doc = words!(sf_exchange_write)]
    ///
    /// # Safety
    /// No other thread of the process may use libhdf5 meanwhile, be it through this crate or not.
    pub unsafe fn write_exchange(&self, mut to: impl Write) -> Result<()> {
        writing_with(&mut to, |sink, fault| unsafe { sys::sf_exchange_write(self.c(), sink, fault) })
    }
}

impl Drop for Tets<'_> {
    fn drop(&mut self) {
        unsafe { sys::sf_tets_destroy(self.c.as_ptr()) }
    }
}

impl fmt::Debug for Tets<'_> {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        let view = self.view();
        write!(to, "Tets({} points, {} tetrahedra)", view.positions.len(), view.corners.len())
    }
}
