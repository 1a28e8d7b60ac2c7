// SPDX-License-Identifier: MIT
// Stacks: folders of pictures, a layer each, and stack.json, written whole or not at all; and single pictures.
//
// The folders are of the disk. A layer writer holds the folder that it writes to, which shows under its path
// when the last layer is there and `finish` says so, and never if the writer is dropped before.

use std::fmt;
use std::io::Write;
use std::mem::zeroed;
use std::path::Path;
use std::ptr::{self, NonNull};

use crate::error::{check_fault, no_fault, Result};
use crate::grid::own;
use crate::made::Made;
use crate::memory::allocator;
use crate::property::chars;
use crate::rule::bed;
use crate::stream::{c_path, writing};
use crate::task::run;
use crate::{sys, Error, ErrorKind, Grid, Lattice, MaterialUse, Rule, RuleKind, Task};

#[doc = words!(sf_stack_has_png)]
///
/// Where libsf is compiled into the crate that is what the feature `png` decides.
pub fn has_png() -> bool {
    unsafe { sys::sf_stack_has_png() != 0 }
}

#[doc = words!(sf_png_write_rgb: pixels, width, height)]
pub fn write_png(mut to: impl Write, pixels: &[u8], width: u32, height: u32) -> Result<()> {
    let needed = u64::from(width).checked_mul(height.into()).and_then(|n| n.checked_mul(3));
    if needed != Some(pixels.len() as u64) {
        let said = format!("{} bytes for {width} x {height} pixels of three", pixels.len());
        return Err(Error::new(ErrorKind::Shape, said));
    }
    writing(&mut to, |sink| unsafe { sys::sf_png_write_rgb(pixels.as_ptr(), width, height, sink) })
}

/// The rule that a stack was made under, and the layer that rests on the bed; `None`: by the shape itself.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StackRule {
    /// What may rest on what.
    pub rule: Rule,
    /// The layer that rests on the bed.
    pub bed_layer: Option<u32>,
}

impl From<Rule> for StackRule {
    fn from(rule: Rule) -> StackRule {
        StackRule { rule, bed_layer: None }
    }
}

impl StackRule {
    fn c(&self) -> sys::sf_stack_info {
        let [bridge_span_mm, bridge_anchor_mm] = self.rule.bridges_mm();
        let kind = self.rule.kind();
        let angle_rad = if kind == RuleKind::Box3 { 0.0 } else { self.rule.angle_rad() };
        sys::sf_stack_info {
            has_rule: 1,
            rule: kind.c(),
            angle_rad,
            bed_layer: bed(self.bed_layer),
            bridge_span_mm,
            bridge_anchor_mm,
        }
    }

    fn of(c: &sys::sf_stack_info) -> Option<StackRule> {
        let rule = Rule::new(RuleKind::of(c.rule), c.angle_rad);
        let rule = rule.with_bridges(c.bridge_span_mm, c.bridge_anchor_mm);
        let bed_layer = (c.bed_layer != sys::SF_BED_AUTO).then_some(c.bed_layer);
        (c.has_rule != 0).then_some(StackRule { rule, bed_layer })
    }
}

/// A folder of the disk that is read, or written and not yet published.
pub(crate) struct Directory(NonNull<sys::sf_directory>);

type Open = unsafe extern "C" fn(
    *const std::ffi::c_char,
    *const sys::sf_allocator,
    *mut *mut sys::sf_directory,
    *mut sys::sf_fault,
) -> sys::sf_status;

impl Directory {
    fn open(path: &Path, call: Open) -> Result<Directory> {
        let name = c_path(path)?;
        let (mut made, mut fault) = (ptr::null_mut(), no_fault());
        let opened = unsafe { call(name.as_ptr(), allocator(), &mut made, &mut fault) };
        check_fault(opened, &fault)?;
        Ok(Directory(own(made)?))
    }

    pub(crate) fn reading(path: &Path) -> Result<Directory> {
        Directory::open(path, sys::sf_directory_read)
    }

    fn writing(path: &Path) -> Result<Directory> {
        Directory::open(path, sys::sf_directory_write)
    }

    pub(crate) fn folder(&self) -> sys::sf_folder {
        unsafe { sys::sf_directory_folder(self.0.as_ptr()) }
    }

    /// Publishes what was written; freed, whatever comes of it.
    fn commit(self) -> Result<()> {
        let mut fault = no_fault();
        let c = std::mem::ManuallyDrop::new(self).0.as_ptr();
        check_fault(unsafe { sys::sf_directory_commit(c, &mut fault) }, &fault)
    }
}

impl Drop for Directory {
    fn drop(&mut self) {
        unsafe { sys::sf_directory_close(self.0.as_ptr()) }
    }
}

impl Grid {
    #[doc = words!(sf_stack_write)]
    ///
    /// The folder appears whole or not at all; one that holds a stack already is replaced.
    ///
    /// ```
    /// # fn main() -> libsf::Result<()> {
    /// use libsf::{Grid, Lattice, Rule};
    ///
    /// let lattice = Lattice::new(8, 8, 4, 0.1, 0.05)?;
    /// let grid = Grid::from_fn(&lattice, |_, y, x| y == x)?;
    /// let path = std::env::temp_dir().join(format!("libsf-stack-{}", std::process::id()));
    /// grid.save_stack(&path, Some(Rule::box3().into()), None)?;
    /// assert!(path.join("stack.json").exists());
    /// # std::fs::remove_dir_all(path).unwrap();
    /// # Ok(())
    /// # }
    /// ```
    pub fn save_stack(
        &self,
        path: impl AsRef<Path>,
        made_under: Option<StackRule>,
        task: Option<&mut Task<'_>>,
    ) -> Result<()> {
        let directory = Directory::writing(path.as_ref())?;
        let info = made_under.map(|rule| rule.c());
        let mut fault = no_fault();
        let (info, folder) = (info.as_ref().map_or(ptr::null(), |info| info as _), directory.folder());
        let status =
            run(task, |task| unsafe { sys::sf_stack_write(self.c(), info, folder, task, &mut fault) });
        check_fault(status, &fault)?;
        directory.commit()
    }

    #[doc = words!(sf_stack_read)]
    ///
    /// Where libsf is compiled into the crate stacks are read with the feature `json`, and those of PNG with
    /// `png` as well.
    pub fn load_stack(
        path: impl AsRef<Path>,
        task: Option<&mut Task<'_>>,
    ) -> Result<(Grid, Option<StackRule>)> {
        let directory = Directory::reading(path.as_ref())?;
        let mut info: sys::sf_stack_info = unsafe { zeroed() };
        let (mut made, mut fault, folder) = (Made::new(sys::sf_grid_destroy), no_fault(), directory.folder());
        let status = run(task, |task| unsafe {
            sys::sf_stack_read(folder, allocator(), task, made.place(), &mut info, &mut fault)
        });
        check_fault(status, &fault)?;
        let lattice = Lattice::of(&unsafe { sys::sf_grid_lattice(made.get()) })?;
        Ok((Grid::of(made.own()?, &lattice), StackRule::of(&info)))
    }
}

#[doc = words!(sf_material)]
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// 1 to 47 bytes, no control characters.
    pub name: String,
    /// Red, green and blue in its pictures.
    pub colour: [u8; 3],
    /// `None`: not known, and then no grams are said.
    pub density_g_cm3: Option<f64>,
}

impl Material {
    fn c(&self) -> Result<sys::sf_material> {
        let density_g_cm3 = self.density_g_cm3.unwrap_or(0.0);
        Ok(sys::sf_material { name: chars(&self.name)?, colour: self.colour, density_g_cm3 })
    }
}

#[doc = words!(sf_layers)]
///
/// A picture a layer, whose pixels name materials, and stack.json, which says how much of each there is.
/// Needs PNG: see [`has_png`].
pub struct LayerWriter {
    // Ends before the folder that it writes to.
    c: NonNull<sys::sf_layers>,
    directory: Option<Directory>,
    lattice: Lattice,
    materials: usize,
}

// All that it points to is its own.
unsafe impl Send for LayerWriter {}

impl LayerWriter {
    #[doc = words!(sf_layers_begin: lattice, materials)]
    ///
    /// - `path`: the folder to be, which may hold an earlier stack
    pub fn new(path: impl AsRef<Path>, lattice: &Lattice, materials: &[Material]) -> Result<LayerWriter> {
        let list: Vec<sys::sf_material> = materials.iter().map(Material::c).collect::<Result<_>>()?;
        let count = u32::try_from(list.len()).unwrap_or(u32::MAX);
        let directory = Directory::writing(path.as_ref())?;
        let (mut made, mut fault, folder) = (ptr::null_mut(), no_fault(), directory.folder());
        let begun = unsafe {
            let (on, of) = (lattice.c(), list.as_ptr());
            sys::sf_layers_begin(folder, &on, count, of, allocator(), &mut made, &mut fault)
        };
        check_fault(begun, &fault)?;
        let (directory, lattice) = (Some(directory), lattice.clone());
        Ok(LayerWriter { c: own(made)?, directory, lattice, materials: list.len() })
    }

    #[doc = words!(sf_layers_add: ids, stride)]
    pub fn add(&mut self, ids: &[u8], stride: usize) -> Result<()> {
        let (_, ny, nx) = self.lattice.shape();
        let needed = (ny - 1).checked_mul(stride).and_then(|n| n.checked_add(nx));
        if needed.map_or(true, |needed| ids.len() < needed) {
            let said = format!("{} bytes for {ny} rows of {stride}", ids.len());
            return Err(Error::new(ErrorKind::Shape, said));
        }
        let mut fault = no_fault();
        let added = unsafe { sys::sf_layers_add(self.c.as_ptr(), ids.as_ptr(), stride, &mut fault) };
        check_fault(added, &fault)
    }

    #[doc = words!(sf_layers_finish)]
    ///
    /// The folder shows then, and it returns what of each material there is.
    pub fn finish(mut self) -> Result<Vec<MaterialUse>> {
        let none = sys::sf_material_use { voxels: 0, volume_mm3: 0.0, mass_g: 0.0 };
        let (mut uses, mut fault) = (vec![none; self.materials], no_fault());
        let done = unsafe { sys::sf_layers_finish(self.c.as_ptr(), uses.as_mut_ptr(), &mut fault) };
        check_fault(done, &fault)?;
        if let Some(directory) = self.directory.take() {
            directory.commit()?;
        }
        Ok(uses.iter().map(MaterialUse::of).collect())
    }
}

impl Drop for LayerWriter {
    fn drop(&mut self) {
        unsafe { sys::sf_layers_end(self.c.as_ptr()) }
    }
}

impl fmt::Debug for LayerWriter {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(to, "LayerWriter({} materials)", self.materials)
    }
}
