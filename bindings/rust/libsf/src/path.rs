// SPDX-License-Identifier: MIT
// Closest supporting paths: of one voxel after the other, of many in a grid that stays, and a brush along one.
//
// A finder and a map look at the grid and the masks whenever they are asked. They borrow all of these, so
// that nothing changes meanwhile: a finder made anew is what C calls refreshed.

use std::fmt;
use std::mem::zeroed;
use std::ptr::NonNull;

use crate::error::{check, Result};
use crate::made::Made;
use crate::memory::allocator;
use crate::plain::{c, first, first_mut, of, room};
use crate::rule::PlacedTerms;
use crate::task::run;
use crate::{sys, EmitReport, Grid, Landing, PathCost, PathEnd, Task, Terms, Voxel};

#[doc = words!(sf_path)]
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SupportPath {
    /// Its voxels, from the top: neither the one asked about nor matter below.
    pub voxels: Vec<Voxel>,
    /// What it ends on.
    pub end: PathEnd,
    #[doc = words!(sf_path.landing)]
    pub landing: Voxel,
    /// Its voxels, and where it ends on the bed the distance to the matter there.
    pub cost: u64,
    #[doc = words!(sf_path.bed_square)]
    pub bed_square: u64,
}

impl SupportPath {
    /// What a call finds; the layers of a grid are always places enough.
    fn found(
        layers: u32,
        call: impl FnOnce(*mut sys::sf_voxel, usize, &mut sys::sf_path) -> sys::sf_status,
    ) -> Result<SupportPath> {
        let mut voxels = room::<Voxel>(layers as usize)?;
        let mut found: sys::sf_path = unsafe { zeroed() };
        let to = first_mut(&mut voxels);
        check(call(to, layers as usize, &mut found))?;
        voxels.truncate(found.count);
        Ok(SupportPath {
            voxels,
            end: PathEnd::of(found.end),
            landing: of(&found.landing),
            cost: found.cost,
            bed_square: found.bed_square,
        })
    }
}

#[doc = words!(sf_path_finder)]
///
/// ```
/// # fn main() -> libsf::Result<()> {
/// use libsf::{Grid, Landing, Lattice, PathEnd, Rule, Voxel};
///
/// // A post, and a voxel three to its side.
/// let lattice = Lattice::new(16, 16, 16, 0.1, 0.1)?;
/// let mut grid = Grid::from_fn(&lattice, |layer, y, x| y == 8 && x == 4 && layer < 12)?;
/// let from = Voxel { x: 7, y: 8, z: 12 };
/// let path = grid.path_finder(Rule::box3(), Landing::Any, None)?.find(from)?;
/// assert_eq!((path.end, path.landing), (PathEnd::Matter, Voxel { x: 4, y: 8, z: 9 }));
/// assert_eq!(path.voxels, [Voxel { x: 6, y: 8, z: 11 }, Voxel { x: 5, y: 8, z: 10 }]);
///
/// // With them the voxel stands.
/// let dot = Grid::from_fn(&Lattice::new(1, 1, 1, 0.1, 0.1)?, |_, _, _| true)?;
/// grid.emit(&dot, Voxel::default(), &path.voxels, Rule::box3())?;
/// grid.set(12, 8, 7, true)?;
/// assert!(grid.check(Rule::box3(), None)?.support_free());
/// # Ok(())
/// # }
/// ```
pub struct PathFinder<'g> {
    c: NonNull<sys::sf_path_finder>,
    layers: u32,
    _terms: PlacedTerms<'g>,
}

// Of the grids it only reads; it serves one at a time, so it is not Sync.
unsafe impl Send for PathFinder<'_> {}

#[doc = words!(sf_path_map)]
///
/// It has a path for each voxel that has one, and the same one whoever asks.
pub struct PathMap<'g> {
    c: NonNull<sys::sf_path_map>,
    layers: u32,
    _terms: PlacedTerms<'g>,
}

// It does not change once it is made, and the grids that it reads are borrowed.
unsafe impl Send for PathMap<'_> {}
unsafe impl Sync for PathMap<'_> {}

impl Grid {
    #[doc = words!(sf_path_finder_create: landing)]
    pub fn path_finder<'g>(
        &'g self,
        terms: impl Into<Terms<'g>>,
        landing: Landing,
        task: Option<&mut Task<'_>>,
    ) -> Result<PathFinder<'g>> {
        let placed = terms.into().place(self.lattice())?;
        let mut made = Made::new(sys::sf_path_finder_destroy);
        check(run(task, |task| unsafe {
            let landing = landing.c();
            sys::sf_path_finder_create(self.c(), &placed.c, landing, allocator(), task, made.place())
        }))?;
        Ok(PathFinder { c: made.own()?, layers: self.lattice().nz(), _terms: placed })
    }

    #[doc = words!(sf_path_map_create)]
    ///
    /// - `landing`: what matter a path may end on
    /// - `cost`: what a path costs
    pub fn path_map<'g>(
        &'g self,
        terms: impl Into<Terms<'g>>,
        landing: Landing,
        cost: PathCost,
        task: Option<&mut Task<'_>>,
    ) -> Result<PathMap<'g>> {
        let placed = terms.into().place(self.lattice())?;
        let mut options = unsafe { sys::sf_path_map_options_default() };
        options.landing = landing.c();
        options.cost = cost.c();
        let mut made = Made::new(sys::sf_path_map_destroy);
        check(run(task, |task| unsafe {
            sys::sf_path_map_create(self.c(), &placed.c, &options, allocator(), task, made.place())
        }))?;
        Ok(PathMap { c: made.own()?, layers: self.lattice().nz(), _terms: placed })
    }

    #[doc = words!(sf_grid_emit)]
    ///
    /// - `brush`: a shape of any size
    /// - `anchor`: its voxel that comes to lie on each voxel of the path
    /// - `path`: voxels, one for each layer, from the top, as a finder gives them
    pub fn emit<'t>(
        &mut self,
        brush: &Grid,
        anchor: Voxel,
        path: &[Voxel],
        terms: impl Into<Terms<'t>>,
    ) -> Result<EmitReport> {
        let placed = terms.into().place(self.lattice())?;
        let (brush, anchor, count) = (brush.c(), c(&anchor), path.len());
        let stroke = sys::sf_stroke { brush, anchor, path: first(path), count };
        let mut report: sys::sf_emit_report = unsafe { zeroed() };
        let grid = self.c_mut();
        check(unsafe { sys::sf_grid_emit(grid, &placed.c, &stroke, allocator(), &mut report) })?;
        Ok(EmitReport::of(&report))
    }
}

impl PathFinder<'_> {
    #[doc = words!(sf_path_finder_find: from)]
    ///
    /// Where there is no path that is [`ErrorKind::Infeasible`](crate::ErrorKind::Infeasible).
    pub fn find(&mut self, from: Voxel) -> Result<SupportPath> {
        let (finder, from) = (self.c.as_ptr(), c(&from));
        SupportPath::found(self.layers, |to, capacity, found| unsafe {
            sys::sf_path_finder_find(finder, from, to, capacity, found)
        })
    }
}

impl PathMap<'_> {
    #[doc = words!(sf_path_map_walk: from)]
    ///
    /// Where there is no path that is [`ErrorKind::Infeasible`](crate::ErrorKind::Infeasible).
    pub fn walk(&self, from: Voxel) -> Result<SupportPath> {
        let (map, from) = (self.c.as_ptr(), c(&from));
        SupportPath::found(self.layers, |to, capacity, found| unsafe {
            sys::sf_path_map_walk(map, from, to, capacity, found)
        })
    }
}

impl Drop for PathFinder<'_> {
    fn drop(&mut self) {
        unsafe { sys::sf_path_finder_destroy(self.c.as_ptr()) }
    }
}

impl Drop for PathMap<'_> {
    fn drop(&mut self) {
        unsafe { sys::sf_path_map_destroy(self.c.as_ptr()) }
    }
}

impl fmt::Debug for PathFinder<'_> {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        to.debug_struct("PathFinder").finish_non_exhaustive()
    }
}

impl fmt::Debug for PathMap<'_> {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        to.debug_struct("PathMap").finish_non_exhaustive()
    }
}
