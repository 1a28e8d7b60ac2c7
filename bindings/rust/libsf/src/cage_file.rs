// SPDX-License-Identifier: MIT
// Cages in files: Medit, MFEM and VTK in, VTK out.

use std::io::{Read, Write};
use std::mem::zeroed;
use std::path::Path;
use std::ptr;

use crate::error::Result;
use crate::memory::allocator;
use crate::stream::{open, reading, saving_with, writing_with};
use crate::{sys, Cage, CageFormat, CageReading, CageView};

#[doc = words!(sf_cage_read_options)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CageReadOptions {
    /// The format.
    pub format: CageFormat,
    #[doc = words!(sf_cage_read_options.bytes_max)]
    pub bytes_max: u64,
    #[doc = words!(sf_cage_read_options.points_max)]
    pub points_max: usize,
    #[doc = words!(sf_cage_read_options.corners_max)]
    pub corners_max: usize,
}

impl Default for CageReadOptions {
    fn default() -> CageReadOptions {
        let c = unsafe { sys::sf_cage_read_options_default() };
        CageReadOptions {
            format: CageFormat::of(c.format),
            bytes_max: c.bytes_max,
            points_max: c.points_max,
            corners_max: c.corners_max,
        }
    }
}

impl Cage {
    #[doc = words!(sf_cage_read)]
    ///
    /// ```
    /// # fn main() -> libsf::Result<()> {
    /// use libsf::Cage;
    ///
    /// let text = "MeshVersionFormatted 1\nDimension 3\nVertices 4\n\
    ///     0 0 0 0\n3 0 0 0\n0 3 0 0\n0 0 3 0\nTetrahedra 1\n1 2 3 4 0\nEnd\n";
    /// let (cage, found) = Cage::read(text.as_bytes(), &Default::default())?;
    /// assert!((cage.check()?.volume_mm3 - 4.5).abs() < 1e-12);
    /// assert_eq!(found.turned_cells, 0);
    ///
    /// let mut vtk = Vec::new();
    /// cage.view().write_vtk(&mut vtk, false)?;
    /// assert_eq!(Cage::read(&vtk[..], &Default::default())?.0.view(), cage.view());
    /// # Ok(())
    /// # }
    /// ```
    pub fn read(mut from: impl Read, options: &CageReadOptions) -> Result<(Cage, CageReading)> {
        let mut c = unsafe { sys::sf_cage_read_options_default() };
        c.format = options.format.c();
        c.bytes_max = options.bytes_max;
        c.points_max = options.points_max;
        c.corners_max = options.corners_max;
        let (mut made, mut found) = (ptr::null_mut(), unsafe { zeroed::<sys::sf_cage_reading>() });
        reading(&mut from, |source, fault| unsafe {
            sys::sf_cage_read(source, &c, allocator(), &mut made, &mut found, fault)
        })?;
        Ok((Cage::of(made)?, CageReading::of(&found)))
    }

    /// Reads a file: Medit, MFEM or VTK, by its content.
    pub fn load(path: impl AsRef<Path>) -> Result<Cage> {
        Ok(Cage::read(open(path.as_ref())?, &CageReadOptions::default())?.0)
    }

    /// Writes a binary VTK file, whole or not at all.
    pub fn save(&self, path: impl AsRef<Path>) -> Result<()> {
        self.view().save(path)
    }
}

impl CageView<'_> {
    #[doc = words!(sf_cage_write_vtk)]
    pub fn write_vtk(&self, mut to: impl Write, binary: bool) -> Result<()> {
        let placed = self.place()?;
        writing_with(&mut to, |sink, fault| unsafe {
            sys::sf_cage_write_vtk(&placed.c, binary.into(), allocator(), sink, fault)
        })
    }

    /// Writes a binary VTK file, whole or not at all.
    pub fn save(&self, path: impl AsRef<Path>) -> Result<()> {
        let placed = self.place()?;
        saving_with(path.as_ref(), |sink, fault| unsafe {
            sys::sf_cage_write_vtk(&placed.c, 1, allocator(), sink, fault)
        })
    }
}
