// SPDX-License-Identifier: MIT
// Halftones: tones in, one material in every voxel out, by a mask or by error diffusion.
//
// C is told where planes begin and believes that they go on. Here they are slices, and are as long as the
// rectangle asks before C looks. That nothing which is written overlaps what is read the references say.

use std::fmt;
use std::ptr::{self, NonNull};

use crate::error::{check, Result};
use crate::grid::own;
use crate::memory::allocator;
use crate::plain::room;
use crate::task::run;
use crate::{sys, Diffusion, Error, ErrorKind, Lattice, Mask, MaterialUse, Slice, SliceMut, Task};

/// Tones of each material but the last, which gets what is left: a plane each, all of one type.
#[derive(Clone, Copy, Debug)]
pub enum ToneValues<'a> {
    /// Bytes: 255 is all.
    U8(&'a [&'a [u8]]),
    /// Single precision: 1 is all.
    F32(&'a [&'a [f32]]),
    /// Double precision: 1 is all.
    F64(&'a [&'a [f64]]),
}

/// Where a material must not be.
#[derive(Clone, Copy, Debug)]
pub struct KeepOut<'a> {
    #[doc = words!(sf_keep_out.where)]
    pub place: Slice<'a>,
    /// Which material, counted from 0.
    pub material: u32,
    /// Which one takes its place there; another one.
    pub instead: u32,
}

/// A rectangle of one slice, to be halftoned.
#[derive(Clone, Copy, Debug)]
pub struct Tones<'a> {
    /// Voxels along x.
    pub width: u32,
    /// Rows along y.
    pub height: u32,
    /// Where its first voxel lies: which part of the mask applies.
    pub x0: u32,
    /// See [`Tones::x0`].
    pub y0: u32,
    /// See [`Tones::x0`].
    pub layer: u32,
    /// How much of each material but the last.
    pub values: ToneValues<'a>,
    /// Tones from one row to the next, at least the width.
    pub stride: usize,
    /// What is solid; what is empty gets no material, and its tones are not looked at. `None`: all.
    pub solid: Option<Slice<'a>>,
    /// Where materials must not be, applied in their order.
    pub keep_outs: &'a [KeepOut<'a>],
}

impl<'a> Tones<'a> {
    /// A rectangle at the origin of layer 0, rows one after the other, all solid.
    pub fn new(width: u32, height: u32, values: ToneValues<'a>) -> Tones<'a> {
        let (x0, y0, layer, solid, keep_outs) = (0, 0, 0, None, &[][..]);
        Tones { width, height, x0, y0, layer, values, stride: width as usize, solid, keep_outs }
    }

    /// The planes as C has them, if there is one for each material but the last and they are long enough.
    fn planes(&self, materials: u32) -> Result<(sys::sf_tone_type, Vec<sys::sf_tone_plane>)> {
        let rows = (self.height as usize).saturating_sub(1);
        let needed = rows.checked_mul(self.stride).and_then(|n| n.checked_add(self.width as usize));
        let needed = needed.unwrap_or(usize::MAX);
        let plane = |values: *const std::ffi::c_void, length: usize| {
            if length < needed {
                let said = format!("a plane of {length} tones, and the rectangle needs {needed}");
                return Err(Error::new(ErrorKind::Shape, said));
            }
            Ok(sys::sf_tone_plane { values, stride: self.stride })
        };
        let (kind, planes): (_, Result<Vec<_>>) = match self.values {
            ToneValues::U8(all) => {
                (sys::SF_TONE_U8, all.iter().map(|one| plane(one.as_ptr().cast(), one.len())).collect())
            }
            ToneValues::F32(all) => {
                (sys::SF_TONE_F32, all.iter().map(|one| plane(one.as_ptr().cast(), one.len())).collect())
            }
            ToneValues::F64(all) => {
                (sys::SF_TONE_F64, all.iter().map(|one| plane(one.as_ptr().cast(), one.len())).collect())
            }
        };
        let planes = planes?;
        if planes.len() + 1 != materials as usize {
            let said = format!("{} planes for {materials} materials: one less is needed", planes.len());
            return Err(Error::new(ErrorKind::Shape, said));
        }
        Ok((kind, planes))
    }

    /// Makes a call on them as C has them.
    fn halftone(
        &self,
        materials: u32,
        to: Materials<'_, '_>,
        call: impl FnOnce(&sys::sf_tones, &sys::sf_materials) -> sys::sf_status,
    ) -> Result<Vec<u64>> {
        let (type_, planes) = self.planes(materials)?;
        let keep_outs: Vec<sys::sf_keep_out> = self
            .keep_outs
            .iter()
            .map(|one| sys::sf_keep_out {
                where_: one.place.c(),
                material: one.material,
                instead: one.instead,
            })
            .collect();
        let none = sys::sf_slice { words: ptr::null_mut(), width: 0, height: 0, stride: 0 };
        let tones = sys::sf_tones {
            struct_size: std::mem::size_of::<sys::sf_tones>(),
            width: self.width,
            height: self.height,
            x0: self.x0,
            y0: self.y0,
            layer: self.layer,
            type_,
            planes: planes.as_ptr(),
            solid: self.solid.map_or(none, |solid| solid.c()),
            keep_outs: keep_outs.as_ptr(),
            keep_out_count: keep_outs.len(),
        };
        let mut counts = room::<u64>(materials as usize)?;
        to.place(self, &mut counts, |materials| call(&tones, materials))?;
        Ok(counts)
    }
}

/// Where materials go: nowhere, so that they are only counted, to bytes, to slices, or to both.
#[derive(Debug, Default)]
pub struct Materials<'a, 's> {
    ids: Option<(&'a mut [u8], usize)>,
    slices: Option<&'a mut [SliceMut<'s>]>,
}

impl<'a, 's> Materials<'a, 's> {
    /// Nowhere: they are counted.
    pub fn counted() -> Materials<'a, 's> {
        Materials { ids: None, slices: None }
    }

    /// A byte a voxel, 0 or material + 1, rows `stride` bytes apart.
    pub fn with_ids(mut self, ids: &'a mut [u8], stride: usize) -> Materials<'a, 's> {
        self.ids = Some((ids, stride));
        self
    }

    /// A slice for each material.
    pub fn with_slices(mut self, slices: &'a mut [SliceMut<'s>]) -> Materials<'a, 's> {
        self.slices = Some(slices);
        self
    }

    /// Makes a call on them as C has them, if they are as many and as long as the rectangle needs.
    fn place(
        mut self,
        tones: &Tones<'_>,
        counts: &mut [u64],
        call: impl FnOnce(&sys::sf_materials) -> sys::sf_status,
    ) -> Result<()> {
        let mut c = sys::sf_materials {
            slices: ptr::null(),
            ids: ptr::null_mut(),
            ids_stride: 0,
            counts: counts.as_mut_ptr(),
        };
        if let Some((ids, stride)) = &mut self.ids {
            let rows = (tones.height as usize).saturating_sub(1);
            let needed = rows.checked_mul(*stride).and_then(|n| n.checked_add(tones.width as usize));
            if needed.map_or(true, |needed| ids.len() < needed) {
                let (given, height) = (ids.len(), tones.height);
                let said = format!("{given} bytes for {height} rows of {stride}");
                return Err(Error::new(ErrorKind::Shape, said));
            }
            (c.ids, c.ids_stride) = (ids.as_mut_ptr(), *stride);
        }
        let slices: Option<Vec<sys::sf_slice>> =
            self.slices.map(|slices| slices.iter_mut().map(|one| one.c()).collect());
        if let Some(slices) = &slices {
            if slices.len() != counts.len() {
                let said = format!("{} slices for {} materials", slices.len(), counts.len());
                return Err(Error::new(ErrorKind::Shape, said));
            }
            c.slices = slices.as_ptr();
        }
        check(call(&c))
    }
}

#[doc = words!(sf_halftone)]
///
/// ```
/// # fn main() -> libsf::Result<()> {
/// use libsf::{Halftone, Mask, Materials, ToneValues, Tones};
///
/// // A quarter of material 0, half of material 1, and the rest of material 2: over a whole mask exactly.
/// let halftone = Halftone::new(&Mask::builtin(), 3)?;
/// let (quarter, half) = ([0.25; 32 * 32], [0.5; 32 * 32]);
/// let mut ids = [0; 32 * 32];
/// let mut counts = [0; 3];
/// for layer in 0..32 {
///     let planes = [&quarter[..], &half[..]];
///     let tones = Tones { layer, ..Tones::new(32, 32, ToneValues::F64(&planes)) };
///     let found = halftone.slice(&tones, Materials::counted().with_ids(&mut ids, 32), None)?;
///     assert_eq!(found[2] as usize, ids.iter().filter(|&&id| id == 3).count());
///     (0..3).for_each(|j| counts[j] += found[j]);
/// }
/// assert_eq!(counts, [8192, 16384, 8192]);
/// # Ok(())
/// # }
/// ```
pub struct Halftone {
    c: NonNull<sys::sf_halftone>,
    materials: u32,
}

// It does not change once it is made.
unsafe impl Send for Halftone {}
unsafe impl Sync for Halftone {}

impl Halftone {
    #[doc = words!(sf_halftone_create: material_count)]
    pub fn new(mask: &Mask, material_count: u32) -> Result<Halftone> {
        let mut made = ptr::null_mut();
        check(unsafe { sys::sf_halftone_create(mask.c(), material_count, allocator(), &mut made) })?;
        Ok(Halftone { c: own(made)?, materials: material_count })
    }

    /// How many materials.
    pub fn material_count(&self) -> u32 {
        self.materials
    }

    #[doc = words!(sf_halftone_slice)]
    ///
    /// It returns how many voxels each material has.
    pub fn slice(
        &self,
        tones: &Tones<'_>,
        to: Materials<'_, '_>,
        task: Option<&mut Task<'_>>,
    ) -> Result<Vec<u64>> {
        let c = self.c.as_ptr();
        tones.halftone(self.materials, to, |tones, to| {
            run(task, |task| unsafe { sys::sf_halftone_slice(c, tones, to, task) })
        })
    }
}

impl Drop for Halftone {
    fn drop(&mut self) {
        unsafe { sys::sf_halftone_destroy(self.c.as_ptr()) }
    }
}

impl fmt::Debug for Halftone {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(to, "Halftone({} materials)", self.materials)
    }
}

#[doc = words!(sf_diffuser)]
pub struct Diffuser {
    c: NonNull<sys::sf_diffuser>,
    materials: u32,
}

// All that it points to is its own; it serves one at a time, so it is not Sync.
unsafe impl Send for Diffuser {}

impl Diffuser {
    #[doc = words!(sf_diffuser_create: width, height, material_count, pitch_mm)]
    pub fn new(width: u32, height: u32, material_count: u32, pitch_mm: [f64; 3]) -> Result<Diffuser> {
        let mut made = ptr::null_mut();
        let (pitch, memory) = (pitch_mm.as_ptr(), allocator());
        check(unsafe { sys::sf_diffuser_create(width, height, material_count, pitch, memory, &mut made) })?;
        Ok(Diffuser { c: own(made)?, materials: material_count })
    }

    #[doc = words!(sf_diffuser_slice)]
    ///
    /// It returns how many voxels each material has.
    pub fn slice(&mut self, tones: &Tones<'_>, to: Materials<'_, '_>) -> Result<Vec<u64>> {
        let c = self.c.as_ptr();
        tones.halftone(self.materials, to, |tones, to| unsafe { sys::sf_diffuser_slice(c, tones, to) })
    }

    #[doc = words!(sf_diffuser_report)]
    ///
    /// An entry for each material.
    pub fn report(&self) -> Result<Vec<Diffusion>> {
        let none = sys::sf_diffusion { asked: 0.0, placed: 0.0, dropped: 0.0, carried: 0.0 };
        let mut found = vec![none; self.materials as usize];
        check(unsafe { sys::sf_diffuser_report(self.c.as_ptr(), found.as_mut_ptr()) })?;
        Ok(found.iter().map(Diffusion::of).collect())
    }
}

impl Drop for Diffuser {
    fn drop(&mut self) {
        unsafe { sys::sf_diffuser_destroy(self.c.as_ptr()) }
    }
}

impl fmt::Debug for Diffuser {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(to, "Diffuser({} materials)", self.materials)
    }
}

#[doc = words!(sf_material_uses: counts, material_count, density_g_cm3)]
pub fn material_uses(
    lattice: &Lattice,
    counts: &[u64],
    material_count: u32,
    density_g_cm3: Option<&[f64]>,
) -> Result<Vec<MaterialUse>> {
    let needed = (lattice.nz() as usize).checked_mul(material_count as usize);
    let densities = density_g_cm3.map_or(material_count as usize, <[f64]>::len);
    if needed != Some(counts.len()) || densities != material_count as usize {
        let nz = lattice.nz();
        let said = format!(
            "{} counts, {densities} densities for {material_count} materials in {nz} layers",
            counts.len()
        );
        return Err(Error::new(ErrorKind::Shape, said));
    }
    let none = sys::sf_material_use { voxels: 0, volume_mm3: 0.0, mass_g: 0.0 };
    let mut uses = vec![none; material_count as usize];
    let (from, to) = (counts.as_ptr(), uses.as_mut_ptr());
    let density = density_g_cm3.map_or(ptr::null(), <[f64]>::as_ptr);
    check(unsafe { sys::sf_material_uses(&lattice.c(), from, material_count, density, to) })?;
    Ok(uses.iter().map(MaterialUse::of).collect())
}
