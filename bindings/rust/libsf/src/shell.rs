// SPDX-License-Identifier: MIT
// Shells: the voxels near the surface of a mesh, which is read as long as its shell lives.

use std::fmt;
use std::marker::PhantomData;
use std::ptr::{self, NonNull};

use crate::error::{check, check_fault, no_fault, Result};
use crate::grid::own;
use crate::memory::allocator;
use crate::{sys, Lattice, Mesh, SliceMut};

#[doc = words!(sf_shell)]
///
/// ```
/// # fn main() -> libsf::Result<()> {
/// use libsf::{Grid, Lattice, Mesh, Shell};
///
/// let corners = [[0.0, 0.0, 0.0], [8.0, 0.0, 0.0], [0.0, 8.0, 0.0], [0.0, 0.0, 8.0]];
/// let mesh = Mesh::new(&corners, &[[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])?;
/// let mut near = Grid::new(&Lattice::new(80, 80, 80, 0.1, 0.1)?)?;
/// let mut shell = Shell::new(&mesh, near.lattice(), 0.5)?;
/// shell.slice(20, near.slice_mut(20))?;
/// assert!(near.get(20, 3, 30) && !near.get(20, 20, 20));
/// # Ok(())
/// # }
/// ```
pub struct Shell<'m> {
    c: NonNull<sys::sf_shell>,
    mesh: PhantomData<&'m Mesh>,
}

// Of the mesh it only reads; it serves one at a time, so it is not Sync.
unsafe impl Send for Shell<'_> {}

impl<'m> Shell<'m> {
    #[doc = words!(sf_shell_create: distance_mm)]
    pub fn new(mesh: &'m Mesh, lattice: &Lattice, distance_mm: f64) -> Result<Shell<'m>> {
        let (mut made, mut fault) = (ptr::null_mut(), no_fault());
        let (view, on) = (mesh.view(), lattice.c());
        let created =
            unsafe { sys::sf_shell_create(view, &on, distance_mm, allocator(), &mut made, &mut fault) };
        check_fault(created, &fault)?;
        Ok(Shell { c: own(made)?, mesh: PhantomData })
    }

    #[doc = words!(sf_shell_slice: k, slice)]
    pub fn slice(&mut self, k: u32, mut slice: SliceMut<'_>) -> Result<()> {
        check(unsafe { sys::sf_shell_slice(self.c.as_ptr(), k, slice.c()) })
    }
}

impl Drop for Shell<'_> {
    fn drop(&mut self) {
        unsafe { sys::sf_shell_destroy(self.c.as_ptr()) }
    }
}

impl fmt::Debug for Shell<'_> {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        to.debug_struct("Shell").finish_non_exhaustive()
    }
}
