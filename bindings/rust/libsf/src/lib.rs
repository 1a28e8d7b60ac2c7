// SPDX-License-Identifier: MIT
//! Shapes that print without supports, that stand, and that are graded between materials.
//!
//! A shape is a [`Grid`] of voxels on a [`Lattice`], a bit each; a [`Rule`] says what may rest on what.
//! [`Grid::check`] names the places that nothing carries; [`Grid::trim`] takes away what hangs,
//! [`Grid::grow`] adds what is missing, [`Grid::repair`] weighs the two, and [`Grid::preserve`] removes a
//! brush but for what of it carries the rest. A [`Checker`] takes layers as they come. Grids come out of
//! meshes and go back into them: [`Mesh::voxelize`], [`Grid::surface`].
//!
//! ```
//! use libsf::{Grid, Lattice, MeshFormat, Rule};
//!
//! fn main() -> libsf::Result<()> {
//!     // A table: four legs, and a top that hangs over them.
//!     let lattice = Lattice::new(48, 48, 24, 0.5, 0.5)?;
//!     let mut table = Grid::from_fn(&lattice, |layer, y, x| {
//!         let leg = |i: u32| (12..15).contains(&i) || (33..36).contains(&i);
//!         layer >= 21 || (leg(x) && leg(y))
//!     })?;
//!
//!     let rule = Rule::octagon(std::f64::consts::FRAC_PI_4);
//!     let checked = table.check(rule, None)?;
//!     println!("{} voxels hang in the air", checked.report.unsupported_voxels);
//!
//!     let report = table.repair(rule, &Default::default(), None)?;
//!     assert!(table.check(rule, None)?.support_free());
//!     assert!(report.cost <= report.trim_cost.unwrap());
//!
//!     let mut stl = Vec::new();
//!     table.surface(0, None)?.write(&mut stl, MeshFormat::Stl)?;
//!     Ok(())
//! }
//! ```
//!
//! # Whether it stands
//!
//! A [`Body`] is a mass and where it lies, of a mesh or of voxels; a [`Stance`] says what a mesh stands, hangs or
//! rocks on and [judges](Stance::judge) a centre of mass. [`Stand`] makes a shape stand that falls: it carves the
//! inside and bends the outside. Its parts can be had by themselves: [walls](Grid::wall) and
//! [cavities](Grid::carve), the [holes](Grid::drain) that drain them, [`Weights`] and a [`Blend`] that bend what
//! follows a few [handles](Handle). [`Balance`] has mass, centre of mass and margin as functions of numbers with
//! their derivatives, for any optimiser; [`Blend::pull`] takes derivatives on to the poses of handles.
//! [`Grid::printing`] says whether a part topples while it is printed, and [`Mesh::orient`] which way up it
//! prints best.
//!
//! # Sculpted and graded
//!
//! A [`Sculpt`] is worked on with a [`Brush`] and prints after every stroke; a [`Session`] keeps what was done, and
//! does it again to the same bits. A [`Cage`] of cells with properties at its points is [refined](Cage::refined),
//! or goes straight to its smooth [`Limit`]; a [`Sampler`] slices that, a [`Mixture`] or a [`Curve`] says what to
//! mix, and a [`Halftone`] makes layers of materials of it.
//!
//! # In and out
//!
//! Meshes, cages, sessions and certificates are read from any reader and written to any writer of Rust's; stacks
//! of pictures are folders: [`Grid::save_stack`], [`Grid::load_stack`]. A [`ContourStack`] has layers as polygons.
//!
//! # What holds everywhere
//!
//! - A call that fails returns an [`Error`] and has changed nothing.
//! - Lengths are in mm, angles in radians, arrays in (layer, y, x) order.
//! - Results are the same bytes for any number of threads, processor and compiler.
//! - A long call takes a [`Task`]: progress, threads of the caller's, and a [`Canceller`] for other
//!   threads. Callbacks may panic: the call is stopped, and the panic goes on when it has returned.
//! - Types are [`Send`]; those that many threads may read at once are [`Sync`]. What belongs to something else
//!   is [`Lent`], and borrows it.
//! - Memory comes from Rust's global allocator, also what libsf takes; where there is none, that is an error.
//! - Words are those of the C headers, and what they say of `SF_ERR_SHAPE` holds for
//!   [`ErrorKind::Shape`]. The few calls that are not here are in [`sys`].
//!
//! # Features
//!
//! | feature | what it does |
//! |---|---|
//! | `ndarray` | arrays in and out: [bools](Grid::from_bools), and the grid's own words |
//! | `png`, `json` | stacks of pictures as PNG, and read back; libspng and jansson are found by pkg-config |
//! | `system` | links to an installed libsf and libsf-io, found by pkg-config, and compiles nothing |

#![deny(unsafe_op_in_unsafe_fn)]
#![warn(missing_docs, missing_debug_implementations)]

pub use libsf_sys as sys;

#[macro_use]
#[rustfmt::skip]
mod words;
#[rustfmt::skip]
mod records;

#[cfg(feature = "ndarray")]
mod array;
mod balance;
mod body;
mod cage;
mod cage_build;
mod cage_file;
mod carve;
mod caught;
mod certificate;
mod check;
mod contour;
mod density;
mod error;
mod finding;
mod gltf;
mod grid;
mod halftone;
mod handle;
mod job;
mod lattice;
mod lent;
mod limit;
mod made;
mod mask;
mod memory;
mod mesh;
mod mixture;
mod morphology;
mod operators;
mod paint;
mod path;
mod plain;
mod printing;
mod property;
mod refine;
mod rule;
mod sample;
mod sculpt;
mod session;
mod shell;
mod slice;
mod stack;
mod stance;
mod stand;
mod stream;
mod task;
mod tetra;
mod threemf;
mod tip;
mod weights;

pub use balance::Balance;
pub use body::BodyGradient;
pub use cage::{Cage, CageView};
pub use cage_file::CageReadOptions;
pub use carve::{CarveOptions, DrainOptions};
pub use certificate::{Certificate, CertificateView, Claim};
pub use check::{CheckOptions, Checked, Checker, VoidsOptions};
pub use contour::{ContourLayer, ContourStack, Contours};
pub use density::{DensityOptions, Region};
pub use error::{Error, Result};
pub use gltf::has_gltf;
pub use grid::Grid;
pub use halftone::{material_uses, Diffuser, Halftone, KeepOut, Materials, ToneValues, Tones};
pub use handle::{handle_center_by_rays, Handle, PlaceOptions, RayHit};
pub use job::{has_sl1, Job, JobOptions, Sl1Settings};
pub use lattice::Lattice;
pub use lent::Lent;
pub use limit::{Limit, Locator};
pub use mask::{Mask, MaskOptions};
pub use mesh::{Mesh, MeshLimits, Voxelizer};
pub use mixture::{Curve, Mixed, Mixture};
pub use morphology::{isa_limit, label_runs, measure_runs, Element};
pub use operators::{PreserveOptions, RepairOptions};
pub use paint::{CageHistory, PaintBrush};
pub use path::{PathFinder, PathMap, SupportPath};
pub use printing::{Printing, PrintingOptions};
pub use property::{Channel, Property};
pub use records::*;
pub use refine::Refinement;
pub use rule::{Rule, Terms};
pub use sample::{SampledSurface, Sampler};
pub use sculpt::{Brush, Sculpt, SculptOptions, Stroke};
pub use session::{Session, SessionOptions, StrokeOf};
pub use shell::Shell;
pub use slice::{slice_stride, Slice, SliceMut};
pub use stack::{has_png, write_png, LayerWriter, Material, StackRule};
pub use stance::Stance;
pub use stand::{Inside, Stand};
pub use task::{Canceller, Task};
pub use tetra::{Tets, TetsView};
pub use threemf::{has_threemf, ThreeMf, ThreeMfColour, ThreeMfItem, ThreeMfKind, ThreeMfObject};
pub use tip::{Tip, TipRef};
pub use weights::{Blend, Unbent, Weights};

#[doc = words!(sf_version)]
pub fn version() -> &'static str {
    unsafe { std::ffi::CStr::from_ptr(sys::sf_version()) }.to_str().unwrap_or("")
}
