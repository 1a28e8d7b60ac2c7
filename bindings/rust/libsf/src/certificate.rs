// SPDX-License-Identifier: MIT
// Certificates: a claim that a shape is support-free, with all that somebody else needs to check it.

use std::fmt;
use std::io::Write;
use std::path::Path;
use std::ptr::{self, NonNull};

use crate::error::{check_fault, no_fault, Result};
use crate::made::Made;
use crate::memory::allocator;
use crate::plain::array;
use crate::stream::{saving, writing};
use crate::task::run;
use crate::{sys, Bridge, CertificateLayer, CertificateSpan, CertificateStep, Grid, Lattice, Operation};
use crate::{RuleKind, Run, Task, Terms};

impl fmt::Display for Operation {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = unsafe { std::ffi::CStr::from_ptr(sys::sf_operation_name(self.c())) };
        to.write_str(&name.to_string_lossy())
    }
}

/// What is to be certified of a shape.
///
/// Terms, or a rule alone, stand for a shape that nothing was done to.
#[derive(Clone, Copy, Debug)]
pub struct Claim<'a> {
    /// Rule, bed and exempt voxels; the other masks are not looked at.
    pub terms: Terms<'a>,
    /// What made the shape.
    pub operation: Operation,
    /// What it was made from; `None`: the shape itself.
    pub before: Option<&'a Grid>,
}

impl<'a, T: Into<Terms<'a>>> From<T> for Claim<'a> {
    fn from(terms: T) -> Claim<'a> {
        Claim { terms: terms.into(), operation: Operation::Check, before: None }
    }
}

#[doc = words!(sf_certificate)]
///
/// ```
/// # fn main() -> libsf::Result<()> {
/// use libsf::{Claim, Grid, Lattice, Operation, Rule, Terms};
///
/// let lattice = Lattice::new(16, 16, 16, 0.1, 0.1)?;
/// let before = Grid::from_fn(&lattice, |layer, _, x| layer > 9 || x == 8)?;
/// let mut after = before.clone();
/// after.grow(Rule::box3(), None)?;
/// let claim =
///     Claim { terms: Terms::new(Rule::box3()), operation: Operation::Grow, before: Some(&before) };
/// let certificate = after.certify(claim, None)?;
/// let view = certificate.view()?;
/// assert_eq!(view.output_sha256, after.sha256(None)?);
/// assert_eq!(view.added_voxels, after.count() - before.count());
/// let mut json = Vec::new();
/// certificate.write(&mut json)?;
/// # Ok(())
/// # }
/// ```
pub struct Certificate {
    c: NonNull<sys::sf_certificate>,
}

// It does not change once it is made.
unsafe impl Send for Certificate {}
unsafe impl Sync for Certificate {}

impl Grid {
    #[doc = words!(sf_certificate_make)]
    ///
    /// Where the shape is not support-free that is
    /// [`ErrorKind::Infeasible`](crate::ErrorKind::Infeasible), and the message names the first voxel that
    /// nothing carries.
    pub fn certify<'t>(
        &self,
        claim: impl Into<Claim<'t>>,
        task: Option<&mut Task<'_>>,
    ) -> Result<Certificate> {
        let claim: Claim<'t> = claim.into();
        let placed = claim.terms.place(self.lattice())?;
        let rule = claim.terms.rule();
        let mut c = unsafe { sys::sf_claim_default() };
        c.terms = &placed.c;
        c.angle_rad = rule.angle_rad();
        [c.bridge_span_mm, c.bridge_anchor_mm] = rule.bridges_mm();
        c.operation = claim.operation.c();
        c.before = claim.before.map_or(ptr::null(), Grid::c);
        let (mut made, mut fault) = (Made::new(sys::sf_certificate_destroy), no_fault());
        let status = run(task, |task| unsafe {
            sys::sf_certificate_make(self.c(), &c, allocator(), task, made.place(), &mut fault)
        });
        check_fault(status, &fault)?;
        Ok(Certificate { c: made.own()? })
    }
}

#[doc = words!(sf_certificate_view)]
#[derive(Clone, Debug)]
pub struct CertificateView<'c> {
    /// What made the shape.
    pub operation: Operation,
    #[doc = words!(sf_certificate_view.lattice)]
    pub lattice: Lattice,
    /// The rule.
    pub kind: RuleKind,
    #[doc = words!(sf_certificate_view.angle_rad)]
    pub angle_rad: f64,
    #[doc = words!(sf_certificate_view.tangent)]
    pub tangent: f64,
    #[doc = words!(sf_certificate_view.bridge_span_mm)]
    pub bridge_span_mm: f64,
    #[doc = words!(sf_certificate_view.bridge_anchor_mm)]
    pub bridge_anchor_mm: f64,
    /// The same in voxels.
    pub bridge: Bridge,
    /// Under slack units in a voxel along x and along y, and most that a voxel has to spare; else 0.
    pub slack: [u16; 3],
    /// The bed as it was given; `None`: by the shape itself.
    pub bed_layer: Option<u32>,
    #[doc = words!(sf_certificate_view.bed)]
    pub bed: u32,
    #[doc = words!(sf_certificate_view.input_sha256)]
    pub input_sha256: [u8; 32],
    #[doc = words!(sf_certificate_view.output_sha256)]
    pub output_sha256: [u8; 32],
    #[doc = words!(sf_certificate_view.input_voxels)]
    pub input_voxels: u64,
    #[doc = words!(sf_certificate_view.output_voxels)]
    pub output_voxels: u64,
    #[doc = words!(sf_certificate_view.added_voxels)]
    pub added_voxels: u64,
    #[doc = words!(sf_certificate_view.removed_voxels)]
    pub removed_voxels: u64,
    /// The counts of each layer.
    pub layers: &'c [CertificateLayer],
    #[doc = words!(sf_certificate_view.steps)]
    pub steps: &'c [CertificateStep],
    #[doc = words!(sf_certificate_view.exempt)]
    pub exempt: &'c [Run],
    #[doc = words!(sf_certificate_view.spans)]
    pub spans: &'c [CertificateSpan],
}

impl Certificate {
    fn c(&self) -> *const sys::sf_certificate {
        self.c.as_ptr()
    }

    #[doc = words!(sf_certificate_get_view)]
    pub fn view(&self) -> Result<CertificateView<'_>> {
        let c = unsafe { sys::sf_certificate_get_view(self.c()) };
        let lattice = Lattice::of(&c.lattice)?;
        let layers = unsafe { array(c.layers, lattice.nz() as usize) };
        Ok(CertificateView {
            operation: Operation::of(c.operation),
            lattice,
            kind: RuleKind::of(c.kind),
            angle_rad: c.angle_rad,
            tangent: c.tangent,
            bridge_span_mm: c.bridge_span_mm,
            bridge_anchor_mm: c.bridge_anchor_mm,
            bridge: Bridge::of(&c.bridge),
            slack: [c.slack_x, c.slack_y, c.slack_cap],
            bed_layer: (c.bed_layer != sys::SF_BED_AUTO).then_some(c.bed_layer),
            bed: c.bed,
            input_sha256: c.input_sha256,
            output_sha256: c.output_sha256,
            input_voxels: c.input_voxels,
            output_voxels: c.output_voxels,
            added_voxels: c.added_voxels,
            removed_voxels: c.removed_voxels,
            layers,
            steps: unsafe { array(c.steps, c.step_count) },
            exempt: unsafe { array(c.exempt, c.exempt_count) },
            spans: unsafe { array(c.spans, c.span_count) },
        })
    }

    #[doc = words!(sf_certificate_write)]
    pub fn write(&self, mut to: impl Write) -> Result<()> {
        writing(&mut to, |sink| unsafe { sys::sf_certificate_write(self.c(), sink) })
    }

    /// Writes a file, whole or not at all.
    pub fn save(&self, path: impl AsRef<Path>) -> Result<()> {
        saving(path.as_ref(), |sink| unsafe { sys::sf_certificate_write(self.c(), sink) })
    }
}

impl Drop for Certificate {
    fn drop(&mut self) {
        unsafe { sys::sf_certificate_destroy(self.c.as_ptr()) }
    }
}

impl fmt::Debug for Certificate {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.view().fmt(to)
    }
}
