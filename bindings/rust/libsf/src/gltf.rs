// SPDX-License-Identifier: MIT
// glTF: meshes of the web and of modelling programs. Buffers outside of a file are read from a folder that the
// caller names, and from nowhere else.

use std::io::Read;
use std::mem::zeroed;
use std::path::Path;
use std::ptr;

use crate::error::Result;
use crate::made::Made;
use crate::memory::allocator;
use crate::stack::Directory;
use crate::stream::reading;
use crate::{sys, GltfReport, Mesh, MeshLimits};

#[doc = words!(sf_gltf_is_served)]
///
/// Where libsf is compiled into the crate it does not; with the feature `system` that is the installed one's
/// affair.
pub fn has_gltf() -> bool {
    unsafe { sys::sf_gltf_is_served() != 0 }
}

impl Mesh {
    #[doc = words!(sf_gltf_read)]
    ///
    /// - `folder`: where buffers outside of the file are; `None`: there are none
    ///
    /// ```
    /// # fn main() -> libsf::Result<()> {
    /// use libsf::{has_gltf, ErrorKind, Mesh, MeshLimits};
    ///
    /// let corners = [[0.0, 0.0, 0.0], [3.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 3.0]];
    /// let mesh = Mesh::new(&corners, &[[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])?;
    /// let mut glb = Vec::new();
    /// mesh.write_glb(&mut glb, None)?;
    /// match Mesh::read_gltf(&glb[..], &MeshLimits::default(), None) {
    ///     Ok((again, _)) => assert_eq!(again.faces(), mesh.faces()),
    ///     Err(error) => assert!(!has_gltf() && error.kind() == ErrorKind::Unsupported),
    /// }
    /// # Ok(())
    /// # }
    /// ```
    pub fn read_gltf(
        mut from: impl Read,
        limits: &MeshLimits,
        folder: Option<&Path>,
    ) -> Result<(Mesh, GltfReport)> {
        let directory = folder.map(Directory::reading).transpose()?;
        let folder = directory.as_ref().map(Directory::folder);
        let mut options = unsafe { sys::sf_gltf_options_default() };
        options.limits = limits.c();
        options.folder = folder.as_ref().map_or(ptr::null(), |folder| folder as _);
        let mut report: sys::sf_gltf_report = unsafe { zeroed() };
        let mut made = Made::new(sys::sf_mesh_destroy);
        reading(&mut from, |source, fault| unsafe {
            sys::sf_gltf_read(source, &options, allocator(), made.place(), &mut report, fault)
        })?;
        Ok((Mesh::of(made.own()?), GltfReport::of(&report)))
    }
}
