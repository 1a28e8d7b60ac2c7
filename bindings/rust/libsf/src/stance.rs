// SPDX-License-Identifier: MIT
// Stances: what a body stands, hangs or rocks on, and where its centre of mass may lie for it.
//
// A stance keeps nothing of its mesh, and nothing of it changes once it is made; a judgement of a body that
// rocks takes memory, from an allocator that serves all threads. So many may ask one stance at once.

use std::fmt;
use std::mem::{zeroed, ManuallyDrop};
use std::ptr::{self, NonNull};

use crate::error::{check, check_fault, no_fault, Result};
use crate::grid::own;
use crate::memory::allocator;
use crate::plain::{first_mut, room};
use crate::{sys, Halfspace, Mesh, Rest, StanceOptions, StanceVerdict};

#[doc = words!(sf_stance)]
///
/// ```
/// # fn main() -> libsf::Result<()> {
/// use libsf::{Grid, Lattice, Stance, StanceKind, StanceOptions};
///
/// // A tower of 8 x 8 x 24 mm falls when it is tilted by atan(4 / 12).
/// let lattice = Lattice::new(8, 8, 24, 1.0, 1.0)?;
/// let tower = Grid::from_fn(&lattice, |_, _, _| true)?.surface(0, None)?;
/// let com = tower.measure()?.com_mm;
/// let stands = Stance::new(&tower, &StanceOptions::default())?;
/// assert!((stands.judge(com)?.margin_rad - (4.0f64 / 12.0).atan()).abs() < 1e-9);
///
/// // On a string, tied to a corner, it comes to rest askew.
/// let options =
///     StanceOptions { kind: StanceKind::Hang, point_mm: [0.0, 0.0, 24.0], ..StanceOptions::default() };
/// assert!(!Stance::new(&tower, &options)?.judge(com)?.stands);
/// # Ok(())
/// # }
/// ```
pub struct Stance {
    c: NonNull<sys::sf_stance>,
}

// See above.
unsafe impl Send for Stance {}
unsafe impl Sync for Stance {}

impl Stance {
    #[doc = words!(sf_stance_create)]
    pub fn new(mesh: &Mesh, options: &StanceOptions) -> Result<Stance> {
        let (mut made, mut fault) = (ptr::null_mut(), no_fault());
        let created =
            unsafe { sys::sf_stance_create(mesh.view(), &options.c(), allocator(), &mut made, &mut fault) };
        check_fault(created, &fault)?;
        Ok(Stance { c: own(made)? })
    }

    /// A stance that belongs to something else, which it must not outlive.
    pub(crate) fn lent(c: *const sys::sf_stance) -> Result<ManuallyDrop<Stance>> {
        Ok(ManuallyDrop::new(Stance { c: own(c.cast_mut())? }))
    }

    pub(crate) fn c(&self) -> *const sys::sf_stance {
        self.c.as_ptr()
    }

    #[doc = words!(sf_stance_get_options)]
    pub fn options(&self) -> StanceOptions {
        StanceOptions::of(&unsafe { sys::sf_stance_get_options(self.c()) })
    }

    #[doc = words!(sf_stance_ground)]
    pub fn ground_mm(&self) -> f64 {
        unsafe { sys::sf_stance_ground(self.c()) }
    }

    /// All of a list of C's, which is asked for its length first.
    fn all<T: Copy + Default>(
        &self,
        call: impl Fn(&mut [T], *mut usize) -> sys::sf_status,
    ) -> Result<Vec<T>> {
        let mut count = 0;
        // It has no room for any, and says how many there are.
        let asked = call(&mut [], &mut count);
        if asked != sys::SF_ERR_CAPACITY {
            check(asked)?;
        }
        let mut found = room(count)?;
        check(call(&mut found, &mut count))?;
        found.truncate(count);
        Ok(found)
    }

    #[doc = words!(sf_stance_polygon)]
    pub fn polygon(&self) -> Result<Vec<[f64; 3]>> {
        self.all(|to: &mut [[f64; 3]], count| unsafe {
            sys::sf_stance_polygon(self.c(), to.as_mut_ptr().cast(), to.len(), count)
        })
    }

    #[doc = words!(sf_stance_contacts)]
    pub fn contacts(&self) -> Result<Vec<u32>> {
        self.all(|to: &mut [u32], count| unsafe {
            sys::sf_stance_contacts(self.c(), to.as_mut_ptr(), to.len(), count)
        })
    }

    #[doc = words!(sf_stance_halfspaces)]
    pub fn halfspaces(&self) -> Result<Vec<Halfspace>> {
        self.all(|to: &mut [Halfspace], count| unsafe {
            sys::sf_stance_halfspaces(self.c(), first_mut(to), to.len(), count)
        })
    }

    #[doc = words!(sf_stance_judge)]
    pub fn judge(&self, com_mm: [f64; 3]) -> Result<StanceVerdict> {
        let mut found: sys::sf_stance_verdict = unsafe { zeroed() };
        check(unsafe { sys::sf_stance_judge(self.c(), com_mm.as_ptr(), &mut found) })?;
        Ok(StanceVerdict::of(&found))
    }

    #[doc = words!(sf_stance_flatten: vertices)]
    pub fn flatten(&self, vertices: &mut [[f64; 3]]) -> Result<()> {
        let (to, count) = (vertices.as_mut_ptr().cast(), vertices.len());
        check(unsafe { sys::sf_stance_flatten(self.c(), to, count) })
    }
}

impl Drop for Stance {
    fn drop(&mut self) {
        unsafe { sys::sf_stance_destroy(self.c.as_ptr()) }
    }
}

impl fmt::Debug for Stance {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(to, "Stance({:?}, ground at {} mm)", self.options().kind, self.ground_mm())
    }
}

impl Mesh {
    #[doc = words!(sf_mesh_rest: com_mm, ups)]
    pub fn rest(&self, com_mm: [f64; 3], ups: &[[f64; 3]]) -> Result<Vec<Rest>> {
        let (mut found, mut fault): (Vec<Rest>, _) = (room(ups.len())?, no_fault());
        let (com, starts, to) = (com_mm.as_ptr(), ups.as_ptr().cast(), first_mut(&mut found));
        let rested =
            unsafe { sys::sf_mesh_rest(self.view(), com, starts, ups.len(), allocator(), to, &mut fault) };
        check_fault(rested, &fault)?;
        Ok(found)
    }
}
