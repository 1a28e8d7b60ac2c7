// SPDX-License-Identifier: MIT
// Layers as closed polygons, and stacks of them: how slicers exchange layers.

use std::fmt;
use std::io::{Read, Write};
use std::path::Path;
use std::ptr::{self, NonNull};

use crate::error::{check, check_fault, no_fault, Result};
use crate::grid::own;
use crate::made::Made;
use crate::memory::allocator;
use crate::plain::{elements, room};
use crate::stream::{open, reading, saving, writing};
use crate::task::run;
use crate::{sys, ContourFill, ContourFormat, Grid, Lattice, MeshLimits, Slice, SliceMut, Task};

#[doc = words!(sf_contours)]
///
/// Here they own their points.
#[derive(Clone, Debug, PartialEq)]
pub struct Contours {
    points_mm: Vec<[f64; 2]>,
    starts: Vec<usize>,
}

impl Default for Contours {
    fn default() -> Contours {
        Contours::new()
    }
}

impl Contours {
    /// No polygon yet.
    pub fn new() -> Contours {
        Contours { points_mm: Vec::new(), starts: vec![0] }
    }

    /// Adds a polygon, whose last point is joined to its first.
    pub fn push(&mut self, polygon_mm: &[[f64; 2]]) {
        self.points_mm.extend_from_slice(polygon_mm);
        self.starts.push(self.points_mm.len());
    }

    /// How many polygons there are.
    pub fn len(&self) -> usize {
        self.starts.len() - 1
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The polygons.
    pub fn polygons(&self) -> impl DoubleEndedIterator<Item = &[[f64; 2]]> + ExactSizeIterator {
        self.starts.windows(2).map(|ends| &self.points_mm[ends[0]..ends[1]])
    }

    #[doc = words!(sf_contours_area_mm2)]
    pub fn area_mm2(&self) -> f64 {
        unsafe { sys::sf_contours_area_mm2(&self.c()) }
    }

    /// As C has them; the points are these.
    pub(crate) fn c(&self) -> sys::sf_contours {
        sys::sf_contours {
            points_mm: self.points_mm.as_ptr().cast(),
            starts: self.starts.as_ptr(),
            contour_count: self.len(),
        }
    }
}

impl<P: AsRef<[[f64; 2]]>> FromIterator<P> for Contours {
    fn from_iter<I: IntoIterator<Item = P>>(polygons: I) -> Contours {
        let mut made = Contours::new();
        polygons.into_iter().for_each(|polygon| made.push(polygon.as_ref()));
        made
    }
}

/// One layer of a stack: from where to where it reaches, and its polygons.
#[derive(Clone, Debug, PartialEq)]
pub struct ContourLayer {
    /// Height of its underside.
    pub bottom_mm: f64,
    /// Height of its top.
    pub top_mm: f64,
    /// Its polygons.
    pub contours: Contours,
}

#[doc = words!(sf_contour_stack)]
///
/// ```
/// # fn main() -> libsf::Result<()> {
/// use libsf::{ContourFill, ContourStack, Contours, Rule};
///
/// // Twenty squares that shrink, each with a hole.
/// let square = |reach: f64| [[-reach, -reach], [reach, -reach], [reach, reach], [-reach, reach]];
/// let mut stack = ContourStack::new(0.0)?;
/// for k in 0..20u8 {
///     let reach = 5.0 - 0.1 * f64::from(k);
///     let ring: Contours = [square(reach), square(1.0)].into_iter().collect();
///     stack.add(0.2 * f64::from(k + 1), &ring)?;
/// }
/// let grid = stack.grid(&stack.lattice([0.1, 0.1])?, ContourFill::EvenOdd, None)?;
/// assert_eq!(grid.slice(0).count(), 100 * 100 - 20 * 20);
/// assert!(grid.check(Rule::box3(), None)?.support_free());
/// # Ok(())
/// # }
/// ```
pub struct ContourStack {
    c: NonNull<sys::sf_contour_stack>,
}

// C only reads what it takes as const.
unsafe impl Send for ContourStack {}
unsafe impl Sync for ContourStack {}

impl ContourStack {
    #[doc = words!(sf_contour_stack_create: bottom_mm)]
    pub fn new(bottom_mm: f64) -> Result<ContourStack> {
        let mut made = ptr::null_mut();
        check(unsafe { sys::sf_contour_stack_create(bottom_mm, allocator(), &mut made) })?;
        Ok(ContourStack { c: own(made)? })
    }

    /// A new stack of C's.
    pub(crate) fn owned(c: NonNull<sys::sf_contour_stack>) -> ContourStack {
        ContourStack { c }
    }

    /// The borders of all layers of a grid.
    pub fn of(grid: &Grid) -> Result<ContourStack> {
        let on = grid.lattice();
        let ends = (0..=on.nz()).filter_map(|k| on.layer_bottom(k));
        let mut made = ContourStack::new(on.origin_mm()[2])?;
        for (slice, top_mm) in grid.slices().zip(ends.skip(1)) {
            made.trace(top_mm, slice, on)?;
        }
        Ok(made)
    }

    #[doc = words!(sf_contour_stack_add: top_mm)]
    pub fn add(&mut self, top_mm: f64, contours: &Contours) -> Result<()> {
        let mut fault = no_fault();
        let added = unsafe { sys::sf_contour_stack_add(self.c.as_ptr(), top_mm, &contours.c(), &mut fault) };
        check_fault(added, &fault)
    }

    #[doc = words!(sf_contour_stack_trace: top_mm, slice, lattice)]
    pub fn trace(&mut self, top_mm: f64, slice: Slice<'_>, lattice: &Lattice) -> Result<()> {
        check(unsafe { sys::sf_contour_stack_trace(self.c.as_ptr(), top_mm, slice.c(), &lattice.c()) })
    }

    #[doc = words!(sf_contour_stack_count)]
    pub fn len(&self) -> u32 {
        unsafe { sys::sf_contour_stack_count(self.c.as_ptr()) }
    }

    /// Whether it has no layer.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    #[doc = words!(sf_contour_stack_layer: k)]
    ///
    /// The polygons are copied.
    pub fn layer(&self, k: u32) -> Result<ContourLayer> {
        let (mut bottom_mm, mut top_mm, mut found) = (0.0, 0.0, Contours::new().c());
        let stack = self.c.as_ptr();
        check(unsafe { sys::sf_contour_stack_layer(stack, k, &mut found, &mut bottom_mm, &mut top_mm) })?;
        let starts = match found.contour_count {
            0 => vec![0],
            count => unsafe { elements(found.starts, count + 1) }.to_vec(),
        };
        let points = unsafe { elements(found.points_mm.cast::<[f64; 2]>(), starts[starts.len() - 1]) };
        Ok(ContourLayer { bottom_mm, top_mm, contours: Contours { points_mm: points.to_vec(), starts } })
    }

    #[doc = words!(sf_contour_stack_lattice)]
    pub fn lattice(&self, pitch_mm: [f64; 2]) -> Result<Lattice> {
        let mut heights: Vec<f64> = room(self.len() as usize)?;
        let mut found = unsafe { std::mem::zeroed() };
        check(unsafe {
            let ([x, y], to, places) = (pitch_mm, heights.as_mut_ptr(), heights.len());
            sys::sf_contour_stack_lattice(self.c.as_ptr(), x, y, to, places, &mut found)
        })?;
        Lattice::of(&found)
    }

    #[doc = words!(sf_grid_from_contours: lattice)]
    pub fn grid(&self, lattice: &Lattice, fill: ContourFill, task: Option<&mut Task<'_>>) -> Result<Grid> {
        let (mut made, on) = (Made::new(sys::sf_grid_destroy), lattice.c());
        let to = made.place();
        check(run(task, |task| unsafe {
            sys::sf_grid_from_contours(self.c.as_ptr(), &on, fill.c(), allocator(), task, to)
        }))?;
        Ok(Grid::of(made.own()?, lattice))
    }
}

impl ContourStack {
    #[doc = words!(sf_contour_stack_read)]
    ///
    /// Of the limits, those of bytes and of vertices count.
    pub fn read(mut from: impl Read, limits: &MeshLimits) -> Result<ContourStack> {
        let (mut made, limits) = (Made::new(sys::sf_contour_stack_destroy), limits.c());
        let to = made.place();
        reading(&mut from, |source, fault| unsafe {
            sys::sf_contour_stack_read(source, &limits, allocator(), to, fault)
        })?;
        Ok(ContourStack { c: made.own()? })
    }

    #[doc = words!(sf_contour_stack_write: format)]
    ///
    /// ```
    /// # fn main() -> libsf::Result<()> {
    /// use libsf::{ContourFormat, ContourStack, Contours};
    ///
    /// let square: Contours = [[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]]].into_iter().collect();
    /// let mut stack = ContourStack::new(0.0)?;
    /// stack.add(0.1, &square)?;
    /// stack.add(0.2, &square)?;
    /// let mut cli = Vec::new();
    /// stack.write(&mut cli, ContourFormat::Text)?;
    /// let again = ContourStack::read(&cli[..], &Default::default())?;
    /// assert_eq!(again.layer(1)?, stack.layer(1)?);
    /// # Ok(())
    /// # }
    /// ```
    pub fn write(&self, mut to: impl Write, format: ContourFormat) -> Result<()> {
        writing(&mut to, |sink| unsafe { sys::sf_contour_stack_write(self.c.as_ptr(), format.c(), sink) })
    }

    /// Reads a CLI file.
    pub fn load(path: impl AsRef<Path>) -> Result<ContourStack> {
        ContourStack::read(open(path.as_ref())?, &MeshLimits::default())
    }

    /// Writes a CLI file, as text, whole or not at all.
    pub fn save(&self, path: impl AsRef<Path>) -> Result<()> {
        let format = ContourFormat::Text.c();
        saving(path.as_ref(), |sink| unsafe { sys::sf_contour_stack_write(self.c.as_ptr(), format, sink) })
    }
}

impl Drop for ContourStack {
    fn drop(&mut self) {
        unsafe { sys::sf_contour_stack_destroy(self.c.as_ptr()) }
    }
}

impl fmt::Debug for ContourStack {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(to, "ContourStack({} layers)", self.len())
    }
}

impl SliceMut<'_> {
    #[doc = words!(sf_slice_from_contours: lattice, contours)]
    pub fn draw(&mut self, lattice: &Lattice, contours: &Contours, fill: ContourFill) -> Result<()> {
        let (mut fault, on, from) = (no_fault(), lattice.c(), contours.c());
        let drawn =
            unsafe { sys::sf_slice_from_contours(self.c(), &on, &from, fill.c(), allocator(), &mut fault) };
        check_fault(drawn, &fault)
    }
}

/// What a checker is pushed: contours on a lattice of its width and height.
pub(crate) fn push(
    checker: *mut sys::sf_checker,
    lattice: &Lattice,
    contours: &Contours,
    fill: ContourFill,
) -> Result<()> {
    let (mut fault, on, from) = (no_fault(), lattice.c(), contours.c());
    let pushed =
        unsafe { sys::sf_checker_push_contours(checker, &on, &from, fill.c(), allocator(), &mut fault) };
    check_fault(pushed, &fault)
}
