// SPDX-License-Identifier: MIT
// Sessions: what a person did, as a list of steps, in a file that does it again.
//
// A session owns its tips; a brush of one of its strokes borrows the session. Layers of a session have one
// height, so the rule of a model that it makes needs no integers of its own.

use std::fmt;
use std::io::{Read, Write};
use std::mem::zeroed;
use std::path::Path;
use std::ptr::{self, NonNull};

use crate::error::{check, Result};
use crate::grid::own;
use crate::made::Made;
use crate::memory::allocator;
use crate::plain::{array, c, first};
use crate::sculpt::fitting;
use crate::stream::{open, reading, saving, writing};
use crate::task::run;
use crate::{sys, Brush, Dab, Grid, Lattice, Rule, RuleKind, Sculpt, SculptChange};
use crate::{SculptOptions, SessionCounts, SessionStep, Task, TipRef, TipShape};

/// The space of a session.
#[derive(Clone, Debug, PartialEq)]
pub struct SessionOptions {
    #[doc = words!(sf_session_options.lattice)]
    pub lattice: Lattice,
    /// Which rule.
    pub rule: RuleKind,
    #[doc = words!(sf_session_options.angle_rad)]
    pub angle_rad: f64,
    /// The layer that rests on the bed.
    pub bed_layer: u32,
    /// Whether what is trimmed stays as a ghost.
    pub keep_drawn: bool,
    #[doc = words!(sf_sculpt_options.history_size)]
    pub history_size: usize,
}

impl SessionOptions {
    /// Box3, 45 degrees for a rule that takes an angle, a bed below layer 0, no ghosts, 64 MiB of history.
    pub fn new(lattice: Lattice) -> SessionOptions {
        let c = unsafe { sys::sf_session_options_default() };
        SessionOptions {
            lattice,
            rule: RuleKind::of(c.rule),
            angle_rad: c.angle_rad,
            bed_layer: c.bed_layer,
            keep_drawn: c.keep_drawn != 0,
            history_size: c.history_size,
        }
    }

    fn of(c: &sys::sf_session_options) -> Result<SessionOptions> {
        Ok(SessionOptions {
            lattice: Lattice::of(&c.lattice)?,
            rule: RuleKind::of(c.rule),
            angle_rad: c.angle_rad,
            bed_layer: c.bed_layer,
            keep_drawn: c.keep_drawn != 0,
            history_size: c.history_size,
        })
    }

    fn c(&self) -> sys::sf_session_options {
        let mut c = unsafe { sys::sf_session_options_default() };
        c.lattice = self.lattice.c();
        c.rule = self.rule.c();
        c.angle_rad = self.angle_rad;
        c.bed_layer = self.bed_layer;
        c.keep_drawn = self.keep_drawn.into();
        c.history_size = self.history_size;
        c
    }

    /// The options of a model in this space.
    fn sculpt(&self) -> SculptOptions {
        SculptOptions {
            lattice: self.lattice.clone(),
            rule: Rule::new(self.rule, self.angle_rad),
            bed_layer: self.bed_layer,
            keep_drawn: self.keep_drawn,
            history_size: self.history_size,
        }
    }
}

#[doc = words!(sf_session)]
///
/// ```
/// # fn main() -> libsf::Result<()> {
/// use libsf::{BrushKind, Dab, Lattice, Session, SessionOptions, SessionStep, TipShape};
///
/// let mut session = Session::new(&SessionOptions::new(Lattice::new(48, 48, 48, 0.5, 0.5)?))?;
/// let ball = session.add_tip(TipShape::Sphere, [5.0; 3])?;
/// let line = Dab { x: 10, y: 24, z: 30 }.line(Dab { x: 38, y: 24, z: 30 })?;
/// session.add_stroke(BrushKind::AddGrow, ball, &line)?;
/// session.add_stroke(BrushKind::RemovePreserve, ball, &[Dab { x: 24, y: 24, z: 30 }])?;
/// session.add_step(SessionStep::Undo)?;
///
/// // Written, read and played it gives the same bits on every machine.
/// let mut text = Vec::new();
/// session.write(&mut text)?;
/// let again = Session::read(&text[..], 0)?;
/// assert_eq!(again.replay(None)?.printable(), session.replay(None)?.printable());
/// # Ok(())
/// # }
/// ```
pub struct Session {
    c: NonNull<sys::sf_session>,
    options: SessionOptions,
}

// All that it points to is its own, and C only reads what it takes as const.
unsafe impl Send for Session {}
unsafe impl Sync for Session {}

impl Session {
    #[doc = words!(sf_session_create)]
    pub fn new(options: &SessionOptions) -> Result<Session> {
        let mut made = ptr::null_mut();
        check(unsafe { sys::sf_session_create(&options.c(), allocator(), &mut made) })?;
        Session::of(made)
    }

    fn of(made: *mut sys::sf_session) -> Result<Session> {
        let c = own(made)?;
        let options = SessionOptions::of(&unsafe { sys::sf_session_options_of(made) })?;
        Ok(Session { c, options })
    }

    fn c(&self) -> *const sys::sf_session {
        self.c.as_ptr()
    }

    #[doc = words!(sf_session_options_of)]
    pub fn options(&self) -> &SessionOptions {
        &self.options
    }

    #[doc = words!(sf_session_count)]
    pub fn counts(&self) -> SessionCounts {
        SessionCounts::of(&unsafe { sys::sf_session_count(self.c()) })
    }

    #[doc = words!(sf_session_add_tip: shape, radius_vx)]
    ///
    /// It returns the tip's number, counted from 0.
    pub fn add_tip(&mut self, shape: TipShape, radius_vx: [f64; 3]) -> Result<u32> {
        let mut tip = 0;
        let radius = radius_vx.as_ptr();
        check(unsafe { sys::sf_session_add_tip(self.c.as_ptr(), shape.c(), radius, &mut tip) })?;
        Ok(tip)
    }

    #[doc = words!(sf_session_add_mask: mask, anchor)]
    ///
    /// It returns the tip's number, counted from 0.
    pub fn add_mask(&mut self, mask: &Grid, anchor: Dab) -> Result<u32> {
        let mut tip = 0;
        check(unsafe { sys::sf_session_add_mask(self.c.as_ptr(), mask.c(), c(&anchor), &mut tip) })?;
        Ok(tip)
    }

    #[doc = words!(sf_session_tip: tip)]
    pub fn tip(&self, tip: u32) -> Option<TipRef<'_>> {
        unsafe { TipRef::of(sys::sf_session_tip(self.c(), tip)) }
    }

    #[doc = words!(sf_session_add_stroke: tip, dabs)]
    ///
    /// - `does`: a kind of brush, or a whole one, whose own tip is not looked at
    pub fn add_stroke(&mut self, does: impl Into<StrokeOf>, tip: u32, dabs: &[Dab]) -> Result<()> {
        let does: StrokeOf = does.into();
        let (session, list) = (self.c.as_ptr(), first(dabs));
        check(unsafe { sys::sf_session_add_stroke(session, &does.0, tip, list, dabs.len()) })
    }

    #[doc = words!(sf_session_add_step: step)]
    pub fn add_step(&mut self, step: SessionStep) -> Result<()> {
        check(unsafe { sys::sf_session_add_step(self.c.as_ptr(), step.c()) })
    }

    #[doc = words!(sf_session_add_shape: drawn, materials)]
    pub fn add_shape(&mut self, drawn: &Grid, materials: Option<&[u8]>) -> Result<()> {
        let (nz, ny, nx) = self.options.lattice.shape();
        fitting(materials, nz * ny * nx)?;
        let materials = materials.map_or(ptr::null(), <[u8]>::as_ptr);
        check(unsafe { sys::sf_session_add_shape(self.c.as_ptr(), drawn.c(), materials) })
    }

    #[doc = words!(sf_session_keep_state)]
    pub fn keep_state(&mut self, model: Option<&Sculpt>) -> Result<()> {
        let model = model.map_or(ptr::null(), Sculpt::c);
        check(unsafe { sys::sf_session_keep_state(self.c.as_ptr(), model) })
    }

    /// A model in this space that C makes.
    fn model(&self, call: impl FnOnce(*mut *mut sys::sf_sculpt) -> sys::sf_status) -> Result<Sculpt> {
        let mut made = Made::new(sys::sf_sculpt_destroy);
        check(call(made.place()))?;
        Sculpt::of(made.own()?.as_ptr(), self.options.sculpt(), None)
    }

    #[doc = words!(sf_session_begin)]
    pub fn begin(&self) -> Result<Sculpt> {
        self.model(|made| unsafe { sys::sf_session_begin(self.c(), allocator(), made) })
    }

    #[doc = words!(sf_session_play: step)]
    ///
    /// Where there is nothing to undo or redo it changes nothing.
    pub fn play(&self, step: usize, model: &mut Sculpt) -> Result<SculptChange> {
        let mut change: sys::sf_sculpt_change = unsafe { zeroed() };
        let model = model.c_mut()?;
        check(unsafe { sys::sf_session_play(self.c(), step, allocator(), model, &mut change) })?;
        Ok(SculptChange::of(&change))
    }

    #[doc = words!(sf_session_stroke: step)]
    pub fn stroke(&self, step: usize) -> Option<(Brush<'_>, &[Dab])> {
        let (mut brush, mut dabs, mut count) =
            (unsafe { sys::sf_brush_default() }, ptr::null::<sys::sf_dab>(), 0);
        let found = unsafe { sys::sf_session_stroke(self.c(), step, &mut brush, &mut dabs, &mut count) };
        if found == 0 {
            return None;
        }
        Some((unsafe { Brush::of(&brush) }?, unsafe { array(dabs, count) }))
    }

    #[doc = words!(sf_session_replay)]
    pub fn replay(&self, task: Option<&mut Task<'_>>) -> Result<Sculpt> {
        let play = |task, made| unsafe { sys::sf_session_replay(self.c(), allocator(), task, made) };
        self.model(|made| run(task, |task| play(task, made)))
    }

    #[doc = words!(sf_session_open)]
    pub fn open(&self) -> Result<Sculpt> {
        self.model(|made| unsafe { sys::sf_session_open(self.c(), allocator(), made) })
    }

    #[doc = words!(sf_session_write)]
    pub fn write(&self, mut to: impl Write) -> Result<()> {
        writing(&mut to, |sink| unsafe { sys::sf_session_write(self.c(), sink) })
    }

    #[doc = words!(sf_session_read: bytes_max)]
    pub fn read(mut from: impl Read, bytes_max: u64) -> Result<Session> {
        let mut made = ptr::null_mut();
        reading(&mut from, |source, fault| unsafe {
            sys::sf_session_read(source, bytes_max, allocator(), &mut made, fault)
        })?;
        Session::of(made)
    }

    /// Writes a file, whole or not at all.
    pub fn save(&self, path: impl AsRef<Path>) -> Result<()> {
        saving(path.as_ref(), |sink| unsafe { sys::sf_session_write(self.c(), sink) })
    }

    /// Reads a file of at most 1 GiB.
    pub fn load(path: impl AsRef<Path>) -> Result<Session> {
        Session::read(open(path.as_ref())?, 0)
    }
}

/// What a stroke that is recorded does: a kind of brush, or a brush without its tip.
#[derive(Clone, Copy, Debug)]
pub struct StrokeOf(sys::sf_brush);

// The tip in it is null and stays so.
unsafe impl Send for StrokeOf {}
unsafe impl Sync for StrokeOf {}

impl From<crate::BrushKind> for StrokeOf {
    fn from(kind: crate::BrushKind) -> StrokeOf {
        let mut c = unsafe { sys::sf_brush_default() };
        c.kind = kind.c();
        c.tip = ptr::null();
        StrokeOf(c)
    }
}

impl From<Brush<'_>> for StrokeOf {
    fn from(brush: Brush<'_>) -> StrokeOf {
        StrokeOf(sys::sf_brush { tip: ptr::null(), ..brush.c() })
    }
}

impl Drop for Session {
    fn drop(&mut self) {
        unsafe { sys::sf_session_destroy(self.c.as_ptr()) }
    }
}

impl fmt::Debug for Session {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        to.debug_struct("Session").field("counts", &self.counts()).finish_non_exhaustive()
    }
}
