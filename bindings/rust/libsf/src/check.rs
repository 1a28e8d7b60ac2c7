// SPDX-License-Identifier: MIT
// Checking: a whole grid, or layers as they come.
//
// A checker of C lives in memory of the caller's and keeps addresses in it; here the memory, the findings
// and the rule's table are blocks of their own that stay where they are when the checker moves. It may go
// to another thread, but not be used by two, not even to ask for its report: so it is Send and not Sync.

use std::alloc::{alloc_zeroed, dealloc, Layout};
use std::fmt;
use std::ptr::{self, NonNull};

use crate::error::{check, Result};
use crate::memory::allocator;
use crate::rule::{bed, Placed};
use crate::task::run;
use crate::{sys, CheckReport, Error, ErrorKind, Finding, Grid, Lattice, Rule, Run, Slice, Task};
use crate::{ContourFill, Contours, Void, VoidsReport};

/// How a check runs.
#[derive(Clone, Copy, Debug)]
pub struct CheckOptions {
    /// What may rest on what.
    pub rule: Rule,
    /// The layer that rests on the bed; `None`: the first that holds matter.
    pub bed_layer: Option<u32>,
    /// Most places that are told.
    pub findings: usize,
    #[doc = words!(sf_check_options.run_capacity)]
    pub run_capacity: u32,
}

impl Default for CheckOptions {
    fn default() -> CheckOptions {
        CheckOptions { rule: Rule::box3(), bed_layer: None, findings: 1024, run_capacity: 0 }
    }
}

impl From<Rule> for CheckOptions {
    fn from(rule: Rule) -> CheckOptions {
        CheckOptions { rule, ..CheckOptions::default() }
    }
}

impl From<&CheckOptions> for CheckOptions {
    fn from(options: &CheckOptions) -> CheckOptions {
        *options
    }
}

impl CheckOptions {
    fn place(&self, rule: &Placed, findings: &Block<sys::sf_finding>) -> sys::sf_check_options {
        let mut c = unsafe { sys::sf_check_options_default() };
        c.rule = rule.c;
        c.bed_layer = bed(self.bed_layer);
        c.run_capacity = self.run_capacity;
        c.finding_capacity = findings.count;
        c.findings = if findings.count > 0 { findings.first.as_ptr() } else { ptr::null_mut() };
        c
    }
}

/// What a check found: its counts, and the places, lowest first.
#[derive(Clone, Debug, PartialEq)]
pub struct Checked {
    /// The counts.
    pub report: CheckReport,
    /// The places that are not supported.
    pub findings: Vec<Finding>,
}

impl Checked {
    /// Whether it prints without supports.
    pub fn support_free(&self) -> bool {
        self.report.support_free
    }
}

/// Places for values of C that stay where they are.
struct Block<T> {
    first: NonNull<T>,
    count: usize,
    layout: Layout,
}

impl<T> Block<T> {
    /// All zero, and aligned to 64 bytes.
    fn new(count: usize) -> Result<Block<T>> {
        let too_many = |_| Error::new(ErrorKind::Overflow, format!("{count} places"));
        let layout =
            Layout::array::<T>(count.max(1)).and_then(|layout| layout.align_to(64)).map_err(too_many)?;
        let first = NonNull::new(unsafe { alloc_zeroed(layout) }.cast::<T>());
        let none = || Error::new(ErrorKind::Memory, format!("no memory for {} bytes", layout.size()));
        Ok(Block { first: first.ok_or_else(none)?, count, layout })
    }

    fn get(&self, i: usize) -> Option<&T> {
        (i < self.count).then(|| unsafe { &*self.first.as_ptr().add(i) })
    }
}

impl<T> Drop for Block<T> {
    fn drop(&mut self) {
        unsafe { dealloc(self.first.as_ptr().cast(), self.layout) }
    }
}

fn told(places: &Block<sys::sf_finding>, count: usize) -> Vec<Finding> {
    (0..count).filter_map(|i| places.get(i)).map(Finding::of).collect()
}

impl Grid {
    #[doc = words!(sf_grid_check)]
    ///
    /// ```
    /// # fn main() -> libsf::Result<()> {
    /// use libsf::{FindingKind, Grid, Lattice, Rule};
    ///
    /// // A post, and a voxel that hangs beside its top.
    /// let lattice = Lattice::new(8, 8, 8, 0.1, 0.1)?;
    /// let grid = Grid::from_fn(&lattice, |layer, y, x| y == 4 && (x == 2 || (layer == 7 && x == 6)))?;
    /// let checked = grid.check(Rule::octagon(std::f64::consts::FRAC_PI_4), None)?;
    /// assert!(!checked.support_free());
    /// assert_eq!(checked.findings[0].kind, FindingKind::Island);
    /// assert_eq!(checked.findings[0].layer, 7);
    /// # Ok(())
    /// # }
    /// ```
    pub fn check(&self, options: impl Into<CheckOptions>, task: Option<&mut Task<'_>>) -> Result<Checked> {
        let options: CheckOptions = options.into();
        let (rule, places) = (options.rule.place(self.lattice())?, Block::new(options.findings)?);
        let c = options.place(&rule, &places);
        let mut report: sys::sf_check_report = unsafe { std::mem::zeroed() };
        let mut count = 0;
        check(run(task, |task| unsafe {
            sys::sf_grid_check(self.c(), &c, allocator(), task, &mut report, &mut count)
        }))?;
        Ok(Checked { report: CheckReport::of(&report), findings: told(&places, count) })
    }

    #[doc = words!(sf_grid_voids)]
    pub fn voids(
        &self,
        options: &VoidsOptions,
        task: Option<&mut Task<'_>>,
    ) -> Result<(VoidsReport, Vec<Void>)> {
        let places: Block<sys::sf_void> = Block::new(options.voids)?;
        let mut c = unsafe { sys::sf_voids_options_default() };
        c.bed_layer = bed(options.bed_layer);
        c.bed_is_open = options.bed_is_open.into();
        c.cup_area_min = options.cup_area_min;
        c.cup_layers_min = options.cup_layers_min;
        c.void_capacity = places.count;
        c.voids = if places.count > 0 { places.first.as_ptr() } else { ptr::null_mut() };
        let mut report: sys::sf_voids_report = unsafe { std::mem::zeroed() };
        let mut count = 0;
        check(run(task, |task| unsafe {
            sys::sf_grid_voids(self.c(), &c, allocator(), task, &mut report, &mut count)
        }))?;
        let found = (0..count).filter_map(|i| places.get(i)).map(Void::of).collect();
        Ok((VoidsReport::of(&report), found))
    }
}

/// How voids are looked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct VoidsOptions {
    /// The layer that rests on the bed; `None`: the first that holds matter.
    pub bed_layer: Option<u32>,
    #[doc = words!(sf_voids_options.bed_is_open)]
    pub bed_is_open: bool,
    #[doc = words!(sf_voids_options.cup_area_min)]
    pub cup_area_min: u64,
    #[doc = words!(sf_voids_options.cup_layers_min)]
    pub cup_layers_min: u32,
    /// Most voids that are told.
    pub voids: usize,
}

impl Default for VoidsOptions {
    fn default() -> VoidsOptions {
        VoidsOptions { bed_layer: None, bed_is_open: false, cup_area_min: 0, cup_layers_min: 0, voids: 1024 }
    }
}

#[doc = words!(sf_checker)]
///
/// ```
/// # fn main() -> libsf::Result<()> {
/// use libsf::{Checker, Lattice, Rule};
///
/// // Layers of 100 x 50 pixels of 0.05 mm, grey from 0 to 255.
/// let lattice = Lattice::new(100, 50, 1, 0.05, 0.05)?;
/// let mut checker = Checker::new(&lattice, Rule::octagon(std::f64::consts::FRAC_PI_4))?;
/// for layer in 0..20u8 {
///     let row = |y: usize| (0..100).map(move |x| if x < 30 && y < 40 { 255 } else { layer / 20 });
///     let pixels: Vec<u8> = (0..50).flat_map(row).collect();
///     checker.push_grey(&pixels, 100, 128)?;
/// }
/// assert!(checker.report()?.support_free());
/// # Ok(())
/// # }
/// ```
///
/// Two threads cannot share one:
///
/// ```compile_fail
/// fn shared<T: Sync>() {}
/// shared::<libsf::Checker>();
/// ```
pub struct Checker {
    c: NonNull<sys::sf_checker>,
    size: (u32, u32),
    places: Block<sys::sf_finding>,
    _memory: Block<u8>,
    _rule: Placed,
}

// All that it points to is its own.
unsafe impl Send for Checker {}

impl Checker {
    /// A checker for layers of a lattice's width and height, the first of which is its layer 0.
    ///
    /// The lattice's heights are those of the layers to come; one height serves any number.
    pub fn new(lattice: &Lattice, options: impl Into<CheckOptions>) -> Result<Checker> {
        let options: CheckOptions = options.into();
        let (rule, places) = (options.rule.place(lattice)?, Block::new(options.findings)?);
        let mut c = options.place(&rule, &places);
        c.width = lattice.nx();
        c.height = lattice.ny();
        let mut size = 0;
        check(unsafe { sys::sf_checker_size(&c, &mut size) })?;
        let memory: Block<u8> = Block::new(size)?;
        let mut made = ptr::null_mut();
        check(unsafe { sys::sf_checker_place(&c, memory.first.as_ptr().cast(), size, &mut made) })?;
        let made = crate::grid::own(made)?;
        Ok(Checker { c: made, size: (c.width, c.height), places, _memory: memory, _rule: rule })
    }

    #[doc = words!(sf_checker_push)]
    pub fn push(&mut self, layer: Slice<'_>) -> Result<()> {
        check(unsafe { sys::sf_checker_push(self.c.as_ptr(), layer.c()) })
    }

    #[doc = words!(sf_checker_push_runs: runs)]
    pub fn push_runs(&mut self, runs: &[Run]) -> Result<()> {
        let list = crate::plain::first(runs);
        check(unsafe { sys::sf_checker_push_runs(self.c.as_ptr(), list, runs.len()) })
    }

    #[doc = words!(sf_checker_push_grey: row_bytes, threshold)]
    pub fn push_grey(&mut self, pixels: &[u8], row_bytes: usize, threshold: u8) -> Result<()> {
        let (width, height) = (self.size.0 as usize, self.size.1 as usize);
        let needed = (height - 1).checked_mul(row_bytes).and_then(|n| n.checked_add(width));
        if needed.is_some_and(|needed| pixels.len() < needed) {
            let said = format!("{} pixels for {height} rows of {row_bytes} bytes", pixels.len());
            return Err(Error::new(ErrorKind::Shape, said));
        }
        check(unsafe { sys::sf_checker_push_grey(self.c.as_ptr(), pixels.as_ptr(), row_bytes, threshold) })
    }

    #[doc = words!(sf_checker_push_contours: lattice, contours)]
    pub fn push_contours(&mut self, lattice: &Lattice, contours: &Contours, fill: ContourFill) -> Result<()> {
        crate::contour::push(self.c.as_ptr(), lattice, contours, fill)
    }

    #[doc = words!(sf_checker_report)]
    pub fn report(&self) -> Result<Checked> {
        let mut report: sys::sf_check_report = unsafe { std::mem::zeroed() };
        let mut count = 0;
        check(unsafe { sys::sf_checker_report(self.c.as_ptr(), &mut report, &mut count) })?;
        Ok(Checked { report: CheckReport::of(&report), findings: told(&self.places, count) })
    }
}

impl fmt::Debug for Checker {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        to.debug_struct("Checker").field("size", &self.size).finish_non_exhaustive()
    }
}
