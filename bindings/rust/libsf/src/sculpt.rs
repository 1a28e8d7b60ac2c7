// SPDX-License-Identifier: MIT
// Sculpting: a shape that a person works on with brushes, and that prints after every stroke.
//
// A stroke of C's is a state of its model, which keeps the address of the brush's tip until the stroke ends.
// Here it is a guard that has the model for itself and lives no longer than the tip; dropped, it gives the
// stroke up. A guard may also be forgotten without being dropped, so the model notes that a stroke was begun,
// and whatever changes it next gives that up first: giving up does not look at the tip, so no tip that is
// gone is ever read. The two grids belong to the model and stay where they are; they are lent to be read.

use std::fmt;
use std::marker::PhantomData;
use std::mem::{zeroed, ManuallyDrop};
use std::ptr::{self, NonNull};

use crate::error::{check, Result};
use crate::grid::own;
use crate::memory::allocator;
use crate::plain::{c, elements, first};
use crate::rule::Placed;
use crate::{sys, BrushKind, Dab, Error, ErrorKind, Grid, Lattice, Rule};
use crate::{SculptChange, SculptHistory, TipRef};

/// A brush: a tip, and what it does where it is put.
#[derive(Clone, Copy, Debug)]
pub struct Brush<'t> {
    #[doc = words!(sf_brush.kind)]
    pub kind: BrushKind,
    /// The voxels that it covers.
    pub tip: TipRef<'t>,
    #[doc = words!(sf_brush.material)]
    pub material: u8,
    #[doc = words!(sf_brush.passes)]
    pub passes: u32,
    /// Every tip is also put mirrored, x to nx - 1 - x.
    pub mirror_x: bool,
    /// The same along y; both give four tips for each dab.
    pub mirror_y: bool,
}

impl<'t> Brush<'t> {
    /// A brush of a kind: material 1, one pass, no mirrors.
    pub fn new(kind: BrushKind, tip: impl Into<TipRef<'t>>) -> Brush<'t> {
        let c = unsafe { sys::sf_brush_default() };
        let (material, passes) = (c.material, c.passes);
        Brush { kind, tip: tip.into(), material, passes, mirror_x: false, mirror_y: false }
    }

    /// The same that gives another material to what it adds or paints.
    pub fn with_material(mut self, material: u8) -> Brush<'t> {
        self.material = material;
        self
    }

    pub(crate) fn c(&self) -> sys::sf_brush {
        let mut c = unsafe { sys::sf_brush_default() };
        c.kind = self.kind.c();
        c.tip = self.tip.c();
        c.material = self.material;
        c.passes = self.passes;
        c.mirror_x = self.mirror_x.into();
        c.mirror_y = self.mirror_y.into();
        c
    }

    /// # Safety
    /// The tip lives as long as 't.
    pub(crate) unsafe fn of(c: &sys::sf_brush) -> Option<Brush<'t>> {
        Some(Brush {
            kind: BrushKind::of(c.kind),
            tip: unsafe { TipRef::of(c.tip) }?,
            material: c.material,
            passes: c.passes,
            mirror_x: c.mirror_x != 0,
            mirror_y: c.mirror_y != 0,
        })
    }
}

impl fmt::Display for BrushKind {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = unsafe { sys::sf_brush_kind_name(self.c()) };
        if name.is_null() {
            return write!(to, "{self:?}");
        }
        to.write_str(&unsafe { std::ffi::CStr::from_ptr(name) }.to_string_lossy())
    }
}

/// How a model is made.
#[derive(Clone, Debug, PartialEq)]
pub struct SculptOptions {
    /// Where its voxels lie.
    pub lattice: Lattice,
    /// What may rest on what.
    pub rule: Rule,
    /// The layer that rests on the bed; it does not move while one works.
    pub bed_layer: u32,
    /// Whether what is trimmed stays as a ghost.
    pub keep_drawn: bool,
    #[doc = words!(sf_sculpt_options.history_size)]
    pub history_size: usize,
}

impl SculptOptions {
    /// Box3, a bed below layer 0, no ghosts, and 64 MiB of history.
    pub fn new(lattice: Lattice) -> SculptOptions {
        let c = unsafe { sys::sf_sculpt_options_default() };
        let (bed_layer, history_size) = (c.bed_layer, c.history_size);
        SculptOptions { lattice, rule: Rule::box3(), bed_layer, keep_drawn: false, history_size }
    }
}

#[doc = words!(sf_sculpt)]
///
/// It holds what is drawn and what of it prints without supports, and a material for each voxel that is
/// drawn. After every stroke what is left prints.
///
/// ```
/// # fn main() -> libsf::Result<()> {
/// use libsf::{Brush, BrushKind, Dab, Lattice, Rule, Sculpt, SculptOptions, Tip, TipShape};
///
/// let mut model = Sculpt::new(&SculptOptions::new(Lattice::new(64, 64, 64, 0.5, 0.5)?))?;
/// let ball = Tip::new(TipShape::Sphere, [6.0; 3])?;
/// // A ball in the air: what it needs grows below it.
/// let grow = Brush::new(BrushKind::AddGrow, &ball);
/// let change = model.stroke(&grow, &[Dab { x: 32, y: 32, z: 40 }])?;
/// assert!(change.added_voxels > ball.mask().count() && change.path_voxels > 0);
/// assert!(model.printable().check(Rule::box3(), None)?.support_free());
///
/// // A stroke can also be drawn dab by dab, and given up.
/// let before = model.printable().clone();
/// let mut stroke = model.begin(&Brush::new(BrushKind::RemoveTrim, &ball))?;
/// let change = stroke.dab(&[Dab { x: 32, y: 32, z: 20 }])?;
/// assert!(change.lost_voxels > 0, "the ball falls with its stem");
/// stroke.abandon()?;
/// assert_eq!(*model.printable(), before);
///
/// model.undo()?;
/// assert_eq!(model.printable().count(), 0);
/// # Ok(())
/// # }
/// ```
///
/// A stroke needs its tip:
///
/// ```compile_fail,E0505
/// # fn main() -> libsf::Result<()> {
/// # use libsf::{Brush, BrushKind, Dab, Lattice, Sculpt, SculptOptions, Tip, TipShape};
/// # let mut model = Sculpt::new(&SculptOptions::new(Lattice::new(8, 8, 8, 0.5, 0.5)?))?;
/// let ball = Tip::new(TipShape::Sphere, [6.0; 3])?;
/// let mut stroke = model.begin(&Brush::new(BrushKind::AddTrim, &ball))?;
/// drop(ball);
/// stroke.dab(&[Dab { x: 4, y: 4, z: 0 }])?;
/// # Ok(())
/// # }
/// ```
pub struct Sculpt {
    c: NonNull<sys::sf_sculpt>,
    printable: ManuallyDrop<Grid>,
    drawn: ManuallyDrop<Grid>,
    options: SculptOptions,
    under_way: bool,
    // Where the rule has its integers; nothing, where layers have one height.
    _rule: Option<Placed>,
}

// All that it points to is its own, and C only reads what it takes as const.
unsafe impl Send for Sculpt {}
unsafe impl Sync for Sculpt {}

impl Sculpt {
    #[doc = words!(sf_sculpt_create)]
    pub fn new(options: &SculptOptions) -> Result<Sculpt> {
        let rule = options.rule.place(&options.lattice)?;
        let mut c = unsafe { sys::sf_sculpt_options_default() };
        c.lattice = options.lattice.c();
        c.rule = rule.c;
        c.bed_layer = options.bed_layer;
        c.keep_drawn = options.keep_drawn.into();
        c.history_size = options.history_size;
        let mut made = ptr::null_mut();
        check(unsafe { sys::sf_sculpt_create(&c, allocator(), &mut made) })?;
        Sculpt::of(made, options.clone(), Some(rule))
    }

    /// The owner of a model that C has made.
    pub(crate) fn of(
        made: *mut sys::sf_sculpt,
        options: SculptOptions,
        rule: Option<Placed>,
    ) -> Result<Sculpt> {
        let c = own(made)?;
        let (printable, drawn) = unsafe { (sys::sf_sculpt_printable(made), sys::sf_sculpt_drawn(made)) };
        let (printable, drawn) =
            (Grid::lent(printable, &options.lattice)?, Grid::lent(drawn, &options.lattice)?);
        Ok(Sculpt { c, printable, drawn, options, under_way: false, _rule: rule })
    }

    pub(crate) fn c(&self) -> *const sys::sf_sculpt {
        self.c.as_ptr()
    }

    /// The model to be changed; a stroke whose guard was forgotten is given up.
    pub(crate) fn c_mut(&mut self) -> Result<*mut sys::sf_sculpt> {
        if self.under_way {
            check(unsafe { sys::sf_sculpt_abandon(self.c.as_ptr(), ptr::null_mut()) })?;
            self.under_way = false;
        }
        Ok(self.c.as_ptr())
    }

    /// A call that says what it changed.
    fn changed(
        &mut self,
        call: impl FnOnce(*mut sys::sf_sculpt, &mut sys::sf_sculpt_change) -> sys::sf_status,
    ) -> Result<SculptChange> {
        let mut change: sys::sf_sculpt_change = unsafe { zeroed() };
        let c = self.c_mut()?;
        check(call(c, &mut change))?;
        Ok(SculptChange::of(&change))
    }

    /// The options that it was made with.
    pub fn options(&self) -> &SculptOptions {
        &self.options
    }

    /// Where its voxels lie.
    pub fn lattice(&self) -> &Lattice {
        &self.options.lattice
    }

    #[doc = words!(sf_sculpt_printable)]
    pub fn printable(&self) -> &Grid {
        &self.printable
    }

    #[doc = words!(sf_sculpt_drawn)]
    pub fn drawn(&self) -> &Grid {
        &self.drawn
    }

    #[doc = words!(sf_sculpt_materials)]
    pub fn materials(&self) -> &[u8] {
        let (nz, ny, nx) = self.lattice().shape();
        unsafe { elements(sys::sf_sculpt_materials(self.c()), nz * ny * nx) }
    }

    #[doc = words!(sf_sculpt_begin)]
    pub fn begin<'m, 't>(&'m mut self, brush: &Brush<'t>) -> Result<Stroke<'m, 't>> {
        let c = self.c_mut()?;
        check(unsafe { sys::sf_sculpt_begin(c, &brush.c()) })?;
        self.under_way = true;
        Ok(Stroke { model: self, tip: PhantomData })
    }

    #[doc = words!(sf_sculpt_stroke)]
    pub fn stroke(&mut self, brush: &Brush<'_>, dabs: &[Dab]) -> Result<SculptChange> {
        let brush = brush.c();
        self.changed(|c, change| unsafe { sys::sf_sculpt_stroke(c, &brush, first(dabs), dabs.len(), change) })
    }

    #[doc = words!(sf_sculpt_replace: drawn, materials)]
    pub fn replace(&mut self, drawn: Option<&Grid>, materials: Option<&[u8]>) -> Result<SculptChange> {
        let (nz, ny, nx) = self.lattice().shape();
        fitting(materials, nz * ny * nx)?;
        let drawn = drawn.map_or(ptr::null(), Grid::c);
        let materials = materials.map_or(ptr::null(), <[u8]>::as_ptr);
        self.changed(|c, change| unsafe { sys::sf_sculpt_replace(c, drawn, materials, change) })
    }

    #[doc = words!(sf_sculpt_drop_ghosts)]
    pub fn drop_ghosts(&mut self) -> Result<SculptChange> {
        self.changed(|c, change| unsafe { sys::sf_sculpt_drop_ghosts(c, change) })
    }

    #[doc = words!(sf_sculpt_history_of)]
    pub fn history(&self) -> SculptHistory {
        SculptHistory::of(&unsafe { sys::sf_sculpt_history_of(self.c()) })
    }

    #[doc = words!(sf_sculpt_undo)]
    ///
    /// Where there is no step to take back that is [`ErrorKind::Infeasible`].
    pub fn undo(&mut self) -> Result<SculptChange> {
        self.changed(|c, change| unsafe { sys::sf_sculpt_undo(c, change) })
    }

    #[doc = words!(sf_sculpt_redo)]
    ///
    /// Where there is nothing to do again that is [`ErrorKind::Infeasible`].
    pub fn redo(&mut self) -> Result<SculptChange> {
        self.changed(|c, change| unsafe { sys::sf_sculpt_redo(c, change) })
    }
}

/// Refuses materials that are not one for each voxel.
pub(crate) fn fitting(materials: Option<&[u8]>, voxels: usize) -> Result<()> {
    match materials {
        Some(given) if given.len() != voxels => {
            let said = format!("{} materials for {voxels} voxels", given.len());
            Err(Error::new(ErrorKind::Shape, said))
        }
        _ => Ok(()),
    }
}

impl Drop for Sculpt {
    fn drop(&mut self) {
        unsafe { sys::sf_sculpt_destroy(self.c.as_ptr()) }
    }
}

impl fmt::Debug for Sculpt {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (drawn, printable) = (&*self.drawn, &*self.printable);
        to.debug_struct("Sculpt").field("drawn", drawn).field("printable", printable).finish_non_exhaustive()
    }
}

/// A stroke that is under way; dropped, it is given up.
#[must_use = "a stroke that is dropped is given up"]
pub struct Stroke<'m, 't> {
    model: &'m mut Sculpt,
    tip: PhantomData<TipRef<'t>>,
}

impl Stroke<'_, '_> {
    #[doc = words!(sf_sculpt_dab)]
    pub fn dab(&mut self, dabs: &[Dab]) -> Result<SculptChange> {
        let mut change: sys::sf_sculpt_change = unsafe { zeroed() };
        let model = self.model.c.as_ptr();
        check(unsafe { sys::sf_sculpt_dab(model, first(dabs), dabs.len(), &mut change) })?;
        Ok(SculptChange::of(&change))
    }

    /// The model as far as the stroke has come.
    pub fn model(&self) -> &Sculpt {
        self.model
    }

    #[doc = words!(sf_sculpt_end)]
    pub fn end(self) -> Result<SculptChange> {
        let mut change: sys::sf_sculpt_change = unsafe { zeroed() };
        check(unsafe { sys::sf_sculpt_end(self.model.c.as_ptr(), &mut change) })?;
        self.model.under_way = false;
        Ok(SculptChange::of(&change))
    }

    #[doc = words!(sf_sculpt_abandon)]
    pub fn abandon(self) -> Result<SculptChange> {
        let mut change: sys::sf_sculpt_change = unsafe { zeroed() };
        check(unsafe { sys::sf_sculpt_abandon(self.model.c.as_ptr(), &mut change) })?;
        self.model.under_way = false;
        Ok(SculptChange::of(&change))
    }
}

impl Drop for Stroke<'_, '_> {
    fn drop(&mut self) {
        if self.model.under_way {
            let _ = unsafe { sys::sf_sculpt_abandon(self.model.c.as_ptr(), ptr::null_mut()) };
            self.model.under_way = false;
        }
    }
}

impl fmt::Debug for Stroke<'_, '_> {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        to.debug_struct("Stroke").field("model", &self.model).finish_non_exhaustive()
    }
}

impl Dab {
    #[doc = words!(sf_dab_line)]
    pub fn line(self, to: Dab) -> Result<Vec<Dab>> {
        let mut count = 0;
        let (from, to) = (c(&self), c(&to));
        let asked = unsafe { sys::sf_dab_line(from, to, ptr::null_mut(), 0, &mut count) };
        if asked != sys::SF_ERR_CAPACITY {
            check(asked)?;
        }
        let mut dabs = crate::plain::room(count)?;
        let to_dabs = crate::plain::first_mut(&mut dabs);
        check(unsafe { sys::sf_dab_line(from, to, to_dabs, count, &mut count) })?;
        Ok(dabs)
    }
}
