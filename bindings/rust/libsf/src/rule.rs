// SPDX-License-Identifier: MIT
// Rules, and the terms that an operator works on.
//
// A rule here is what a person means: a kind, an angle, bridges. The integers that C computes with belong to
// one lattice, and are made of it when a call is, so that no rule can be used on another lattice than its
// own, and none outlives its table.

use std::ffi::CStr;
use std::fmt;
use std::str::FromStr;

use crate::error::{check, check_fault, no_fault, Result};
use crate::{sys, Error, Grid, Lattice, RuleAngles, RuleKind};

/// What may rest on what: a kind, an angle from the vertical, and bridges.
///
#[doc = words!(sf_rule_make: angle_rad)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rule {
    kind: RuleKind,
    angle_rad: f64,
    span_mm: f64,
    anchor_mm: f64,
}

impl Default for Rule {
    /// The papers' rule.
    fn default() -> Rule {
        Rule::box3()
    }
}

impl Rule {
    /// A rule of a kind, with an angle, which box3 does not look at.
    pub fn new(kind: RuleKind, angle_rad: f64) -> Rule {
        Rule { kind, angle_rad, span_mm: 0.0, anchor_mm: 0.0 }
    }

    #[doc = words!(sf_rule_box3)]
    pub fn box3() -> Rule {
        Rule::new(RuleKind::Box3, 0.0)
    }

    /// A schedule of pluses and squares that stays within the asked angle: the rule to take where an angle
    /// is given and pixels are square.
    pub fn octagon(angle_rad: f64) -> Rule {
        Rule::new(RuleKind::Octagon, angle_rad)
    }

    /// An ellipse in voxels, a disk in mm.
    pub fn disk(angle_rad: f64) -> Rule {
        Rule::new(RuleKind::Disk, angle_rad)
    }

    /// The exact angle: what one layer does not reach the next may, added up.
    pub fn slack(angle_rad: f64) -> Rule {
        Rule::new(RuleKind::Slack, angle_rad)
    }

    #[doc = words!(sf_rule_set_bridges: span_mm, anchor_mm)]
    pub fn with_bridges(mut self, span_mm: f64, anchor_mm: f64) -> Rule {
        self.span_mm = span_mm;
        self.anchor_mm = anchor_mm;
        self
    }

    /// Which rule it is.
    pub fn kind(&self) -> RuleKind {
        self.kind
    }

    /// Its angle from the vertical.
    pub fn angle_rad(&self) -> f64 {
        self.angle_rad
    }

    /// Its bridges: the longest span, 0 where there are none, and what is carried at both ends, mm.
    pub fn bridges_mm(&self) -> [f64; 2] {
        [self.span_mm, self.anchor_mm]
    }

    #[doc = words!(sf_rule_measure)]
    pub fn measure(&self, lattice: &Lattice) -> Result<RuleAngles> {
        let mut found: sys::sf_rule_angles = unsafe { std::mem::zeroed() };
        let placed = self.place(lattice)?;
        check(unsafe { sys::sf_rule_measure(&placed.c, &lattice.c(), &mut found) })?;
        Ok(RuleAngles::of(&found))
    }

    /// The integers that C computes with, for one lattice.
    pub(crate) fn place(&self, lattice: &Lattice) -> Result<Placed> {
        let on = lattice.c();
        let mut fault = no_fault();
        let mut table = vec![0; unsafe { sys::sf_rule_table_count(&on) }];
        let mut c = unsafe { sys::sf_rule_box3() };
        let to = if table.is_empty() { std::ptr::null_mut() } else { table.as_mut_ptr() };
        let (kind, angle) = (self.kind.c(), self.angle_rad);
        let made = unsafe { sys::sf_rule_make(kind, angle, &on, to, &mut c, &mut fault) };
        check_fault(made, &fault)?;
        if self.span_mm != 0.0 {
            let (span, anchor) = (self.span_mm, self.anchor_mm);
            let made = unsafe { sys::sf_rule_set_bridges(&mut c, span, anchor, &on, &mut fault) };
            check_fault(made, &fault)?;
        }
        Ok(Placed { c, _table: table })
    }
}

/// A rule on a lattice; the table stays where it is when this moves.
pub(crate) struct Placed {
    pub(crate) c: sys::sf_rule,
    _table: Vec<u64>,
}

impl FromStr for RuleKind {
    type Err = Error;

    #[doc = words!(sf_rule_kind_from_name)]
    fn from_str(name: &str) -> Result<RuleKind> {
        let mut kind = sys::SF_RULE_BOX3;
        let text: Vec<u8> = name.bytes().take_while(|&b| b != 0).chain([0]).collect();
        check(unsafe { sys::sf_rule_kind_from_name(text.as_ptr().cast(), &mut kind) })?;
        Ok(RuleKind::of(kind))
    }
}

impl fmt::Display for RuleKind {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = unsafe { CStr::from_ptr(sys::sf_rule_kind_name(self.c())) };
        to.write_str(&name.to_string_lossy())
    }
}

/// The terms that an operator works on: a rule, a bed, and masks.
///
#[doc = words!(sf_terms)]
///
/// A rule alone stands for terms without masks, whose bed is chosen by the shape itself.
#[derive(Clone, Copy, Debug, Default)]
pub struct Terms<'a> {
    rule: Rule,
    bed_layer: Option<u32>,
    exempt: Option<&'a Grid>,
    keep: Option<&'a Grid>,
    forbid: Option<&'a Grid>,
    act: Option<&'a Grid>,
}

impl From<Rule> for Terms<'_> {
    fn from(rule: Rule) -> Self {
        Terms { rule, ..Terms::default() }
    }
}

impl From<&Rule> for Terms<'_> {
    fn from(rule: &Rule) -> Self {
        Terms::from(*rule)
    }
}

impl<'a> From<&Terms<'a>> for Terms<'a> {
    fn from(terms: &Terms<'a>) -> Self {
        *terms
    }
}

impl<'a> Terms<'a> {
    /// Terms without masks.
    pub fn new(rule: Rule) -> Terms<'a> {
        Terms::from(rule)
    }

    /// The layer that rests on the bed; without it the first that holds matter.
    pub fn bed_layer(mut self, layer: u32) -> Terms<'a> {
        self.bed_layer = Some(layer);
        self
    }

    #[doc = words!(sf_terms.exempt)]
    pub fn exempt(mut self, mask: &'a Grid) -> Terms<'a> {
        self.exempt = Some(mask);
        self
    }

    #[doc = words!(sf_terms.keep)]
    pub fn keep(mut self, mask: &'a Grid) -> Terms<'a> {
        self.keep = Some(mask);
        self
    }

    #[doc = words!(sf_terms.forbid)]
    pub fn forbid(mut self, mask: &'a Grid) -> Terms<'a> {
        self.forbid = Some(mask);
        self
    }

    #[doc = words!(sf_terms.act)]
    pub fn act(mut self, mask: &'a Grid) -> Terms<'a> {
        self.act = Some(mask);
        self
    }

    /// What may rest on what.
    pub fn rule(&self) -> Rule {
        self.rule
    }

    /// Whether there is a mask.
    pub(crate) fn masked(&self) -> bool {
        [self.exempt, self.keep, self.forbid, self.act].iter().any(Option::is_some)
    }

    /// As C has them, for a lattice.
    pub(crate) fn place(&self, lattice: &Lattice) -> Result<PlacedTerms<'a>> {
        let rule = self.rule.place(lattice)?;
        let mut c = unsafe { sys::sf_terms_default() };
        let mask = |grid: Option<&'a Grid>| grid.map_or(std::ptr::null(), Grid::c);
        c.rule = rule.c;
        c.bed_layer = bed(self.bed_layer);
        c.exempt = mask(self.exempt);
        c.keep = mask(self.keep);
        c.forbid = mask(self.forbid);
        c.act = mask(self.act);
        Ok(PlacedTerms { c, _rule: rule, _masks: std::marker::PhantomData })
    }
}

/// A bed layer as C has it. The number that stands for none is no layer, so it is refused by the grid.
pub(crate) fn bed(layer: Option<u32>) -> u32 {
    layer.map_or(sys::SF_BED_AUTO, |layer| layer.min(sys::SF_BED_AUTO - 1))
}

/// Terms on a lattice, with what they point to.
pub(crate) struct PlacedTerms<'a> {
    pub(crate) c: sys::sf_terms,
    _rule: Placed,
    _masks: std::marker::PhantomData<&'a Grid>,
}
