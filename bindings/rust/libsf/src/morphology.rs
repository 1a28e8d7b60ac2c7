// SPDX-License-Identifier: MIT
// What is done to slices beyond their bits: dilation and erosion, runs and components, exact sums.

use std::ffi::CStr;
use std::fmt;
use std::mem::zeroed;

use crate::error::{check, Result};
use crate::plain::{first, first_mut, room};
use crate::{sys, Border, Component, Connectivity, Error, ErrorKind, Isa, Lattice, Rule, Run, Slice};
use crate::{SliceMut, SliceSums};

#[doc = words!(sf_element)]
///
/// ```
/// # fn main() -> libsf::Result<()> {
/// use libsf::{Border, Element, Grid, Lattice};
///
/// let lattice = Lattice::new(9, 9, 2, 0.1, 0.1)?;
/// let mut grid = Grid::from_fn(&lattice, |layer, y, x| (layer, y, x) == (0, 4, 4))?;
/// let plus = Element::plus3();
/// assert_eq!(plus.sum(&plus)?.half_widths(), [2, 1, 0]);
/// let below = grid.clone();
/// grid.slice_mut(1).dilate(below.slice(0), &plus.sum(&plus)?, Border::Empty)?;
/// assert_eq!(grid.slice(1).count(), 13);
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Copy)]
pub struct Element(sys::sf_element);

impl Element {
    /// An element by its half width in its middle row, in the next one, and so on; they never grow.
    pub fn new(half_widths: &[u16]) -> Result<Element> {
        let reach = half_widths.len().wrapping_sub(1);
        let falls = half_widths.windows(2).all(|two| two[0] >= two[1]);
        let most = half_widths.first().copied().unwrap_or(0);
        if reach > sys::SF_REACH_MAX as usize || u32::from(most) > sys::SF_REACH_MAX || !falls {
            let said =
                format!("half widths never grow, reach {} at most, and are 1 to 256", sys::SF_REACH_MAX);
            return Err(Error::new(ErrorKind::Argument, said));
        }
        let mut c = unsafe { sys::sf_element_box3() };
        c.reach_y = reach as u16;
        c.half_width[..half_widths.len()].copy_from_slice(half_widths);
        Ok(Element(c))
    }

    #[doc = words!(sf_element_box3)]
    pub fn box3() -> Element {
        Element(unsafe { sys::sf_element_box3() })
    }

    #[doc = words!(sf_element_plus3)]
    pub fn plus3() -> Element {
        Element(unsafe { sys::sf_element_plus3() })
    }

    #[doc = words!(sf_element_ellipse: rx_q16, ry_q16)]
    pub fn ellipse(rx_q16: u64, ry_q16: u64) -> Result<Element> {
        let mut made = Element::box3();
        check(unsafe { sys::sf_element_ellipse(rx_q16, ry_q16, &mut made.0) })?;
        Ok(made)
    }

    #[doc = words!(sf_element_sum)]
    pub fn sum(&self, other: &Element) -> Result<Element> {
        let mut made = *self;
        check(unsafe { sys::sf_element_sum(&self.0, &other.0, &mut made.0) })?;
        Ok(made)
    }

    /// Its half width in its middle row, in the next one, and so on.
    pub fn half_widths(&self) -> &[u16] {
        &self.0.half_width[..=usize::from(self.0.reach_y)]
    }
}

impl PartialEq for Element {
    fn eq(&self, other: &Element) -> bool {
        self.half_widths() == other.half_widths()
    }
}

impl Eq for Element {}

impl fmt::Debug for Element {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        to.debug_tuple("Element").field(&self.half_widths()).finish()
    }
}

impl Rule {
    #[doc = words!(sf_rule_element: k)]
    pub fn element(&self, lattice: &Lattice, k: u32) -> Result<Element> {
        let placed = self.place(lattice)?;
        let mut made = Element::box3();
        check(unsafe { sys::sf_rule_element(&placed.c, k, &mut made.0) })?;
        Ok(made)
    }
}

impl Slice<'_> {
    #[doc = words!(sf_slice_measure)]
    pub fn sums(&self) -> Result<SliceSums> {
        let mut sums: sys::sf_slice_sums = unsafe { zeroed() };
        check(unsafe { sys::sf_slice_measure(self.c(), &mut sums) })?;
        Ok(SliceSums::of(&sums))
    }

    #[doc = words!(sf_slice_run_count)]
    pub fn run_count(&self) -> Result<usize> {
        let mut count = 0;
        check(unsafe { sys::sf_slice_run_count(self.c(), &mut count) })?;
        Ok(count)
    }

    #[doc = words!(sf_slice_runs)]
    ///
    /// ```
    /// # fn main() -> libsf::Result<()> {
    /// use libsf::{label_runs, measure_runs, Connectivity, Slice};
    ///
    /// // Two voxels that touch at a corner, and a run.
    /// let slice = Slice::new(&[0b111_0001, 0b10], 8, 2, 1)?;
    /// let mut runs = slice.runs()?;
    /// assert_eq!(runs.len(), 3);
    /// assert_eq!(label_runs(&mut runs, Connectivity::Edges)?, 3);
    /// let parts = label_runs(&mut runs, Connectivity::Corners)?;
    /// let found = measure_runs(&runs, parts)?;
    /// assert_eq!((found[0].area, found[1].area), (2, 3));
    /// # Ok(())
    /// # }
    /// ```
    pub fn runs(&self) -> Result<Vec<Run>> {
        let mut count = self.run_count()?;
        let mut runs = room::<Run>(count)?;
        let (to, capacity) = (first_mut(&mut runs), count);
        check(unsafe { sys::sf_slice_runs(self.c(), to, capacity, &mut count) })?;
        Ok(runs)
    }
}

impl SliceMut<'_> {
    #[doc = words!(sf_slice_dilate: element, border)]
    pub fn dilate(&mut self, of: Slice<'_>, element: &Element, border: Border) -> Result<()> {
        check(unsafe { sys::sf_slice_dilate(self.c(), of.c(), &element.0, border.c()) })
    }

    #[doc = words!(sf_slice_erode: element, border)]
    pub fn erode(&mut self, of: Slice<'_>, element: &Element, border: Border) -> Result<()> {
        check(unsafe { sys::sf_slice_erode(self.c(), of.c(), &element.0, border.c()) })
    }

    #[doc = words!(sf_slice_and_dilate: below, element)]
    ///
    /// The slice is trimmed in place.
    pub fn and_dilate(&mut self, below: Slice<'_>, element: &Element) -> Result<()> {
        let c = self.c();
        check(unsafe { sys::sf_slice_and_dilate(c, c, below.c(), &element.0) })
    }

    #[doc = words!(sf_slice_from_runs: runs)]
    pub fn paint_runs(&mut self, runs: &[Run]) -> Result<()> {
        check(unsafe { sys::sf_slice_from_runs(self.c(), first(runs), runs.len()) })
    }
}

#[doc = words!(sf_runs_label: connectivity)]
///
/// It returns the number of components.
pub fn label_runs(runs: &mut [Run], connectivity: Connectivity) -> Result<u32> {
    let (mut count, length) = (0, runs.len());
    check(unsafe { sys::sf_runs_label(first_mut(runs), length, connectivity.c(), &mut count) })?;
    Ok(count)
}

#[doc = words!(sf_runs_measure)]
///
/// - `components`: how many there are, as [`label_runs`] says
pub fn measure_runs(runs: &[Run], components: u32) -> Result<Vec<Component>> {
    let none: sys::sf_component = unsafe { zeroed() };
    let mut found = Vec::new();
    let no_memory = |_| Error::new(ErrorKind::Memory, format!("no memory for {components} components"));
    found.try_reserve_exact(components as usize).map_err(no_memory)?;
    found.resize(components as usize, none);
    let (to, capacity) = (found.as_mut_ptr(), found.len());
    check(unsafe { sys::sf_runs_measure(first(runs), runs.len(), to, capacity) })?;
    Ok(found.iter().map(Component::of).collect())
}

#[doc = words!(sf_isa_limit)]
///
/// `None` lifts the limit.
pub fn isa_limit(limit: Option<Isa>) -> &'static str {
    let limit = limit.map_or(sys::SF_ISA_COUNT, Isa::c);
    unsafe { CStr::from_ptr(sys::sf_isa_limit(limit)) }.to_str().unwrap_or("")
}
