// SPDX-License-Identifier: MIT
// Meshes: triangles in and out, voxels of them, and surfaces of voxels.

use std::fmt;
use std::io::{Read, Write};
use std::marker::PhantomData;
use std::mem::zeroed;
use std::path::Path;
use std::ptr::{self, NonNull};

use crate::error::{check, check_fault, no_fault, Result};
use crate::grid::own;
use crate::made::Made;
use crate::memory::allocator;
use crate::plain::elements;
use crate::stream::{c_path, open, reading, saving, writing};
use crate::task::run;
use crate::VoxelizeReport;
use crate::{sys, Error, ErrorKind, Fill, Grid, Lattice, Mass, MeshFormat, SliceMut, Task, Topology};

/// Triangles: vertices in mm, and for each triangle three of them, counter-clockwise seen from outside.
///
#[doc = words!(sf_mesh)]
///
/// ```
/// # fn main() -> libsf::Result<()> {
/// use libsf::Mesh;
///
/// let corners = [[0.0, 0.0, 0.0], [3.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 3.0]];
/// let mesh = Mesh::new(&corners, &[[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])?;
/// assert!(mesh.topology()?.closed);
/// assert!((mesh.measure()?.volume_mm3 - 4.5).abs() < 1e-12);
///
/// let grid = mesh.voxelize(0.1, 0.1, None)?;
/// let volume = grid.count() as f64 * 0.001;
/// assert!((volume - 4.5).abs() < 0.2);
/// # Ok(())
/// # }
/// ```
pub struct Mesh {
    c: NonNull<sys::sf_mesh>,
}

// As a grid: C only reads what it takes as const, and its memory comes from the C library.
unsafe impl Send for Mesh {}
unsafe impl Sync for Mesh {}

impl Mesh {
    #[doc = words!(sf_mesh_validate)]
    pub fn new(vertices: &[[f64; 3]], faces: &[[u32; 3]]) -> Result<Mesh> {
        let mut fault = no_fault();
        let view = sys::sf_mesh_view {
            vertices: vertices.as_ptr().cast(),
            vertex_count: vertices.len(),
            triangles: faces.as_ptr().cast(),
            triangle_count: faces.len(),
        };
        check_fault(unsafe { sys::sf_mesh_validate(view, &mut fault) }, &fault)?;
        let mut c = ptr::null_mut();
        check(unsafe { sys::sf_mesh_create(allocator(), &mut c) })?;
        let mesh = Mesh { c: own(c)? };
        check(unsafe { sys::sf_mesh_add_vertices(c, view.vertices, view.vertex_count) })?;
        check(unsafe { sys::sf_mesh_add_triangles(c, view.triangles, view.triangle_count) })?;
        Ok(mesh)
    }

    /// A new mesh of C's.
    pub(crate) fn of(c: NonNull<sys::sf_mesh>) -> Mesh {
        Mesh { c }
    }

    /// A copy of triangles that belong to something else.
    pub(crate) fn copied(view: sys::sf_mesh_view) -> Result<Mesh> {
        let vertices = unsafe { elements(view.vertices.cast(), view.vertex_count) };
        Mesh::new(vertices, unsafe { elements(view.triangles.cast(), view.triangle_count) })
    }

    pub(crate) fn view(&self) -> sys::sf_mesh_view {
        unsafe { sys::sf_mesh_get_view(self.c.as_ptr()) }
    }

    /// The vertices, mm.
    pub fn vertices(&self) -> &[[f64; 3]] {
        let view = self.view();
        unsafe { elements(view.vertices.cast(), view.vertex_count) }
    }

    /// The triangles, three vertices each.
    pub fn faces(&self) -> &[[u32; 3]] {
        let view = self.view();
        unsafe { elements(view.triangles.cast(), view.triangle_count) }
    }

    /// A copy.
    pub fn try_clone(&self) -> Result<Mesh> {
        Mesh::new(self.vertices(), self.faces())
    }

    #[doc = words!(sf_mesh_bounds)]
    ///
    /// The two corners.
    pub fn bounds(&self) -> Result<[[f64; 3]; 2]> {
        let mut found = [[0.0; 3]; 2];
        let [low, high] = &mut found;
        check(unsafe { sys::sf_mesh_bounds(self.view(), low.as_mut_ptr(), high.as_mut_ptr()) })?;
        Ok(found)
    }

    #[doc = words!(sf_mesh_measure)]
    pub fn measure(&self) -> Result<Mass> {
        let mut found: sys::sf_mass = unsafe { zeroed() };
        check(unsafe { sys::sf_mesh_measure(self.view(), &mut found) })?;
        Ok(Mass::of(&found))
    }

    #[doc = words!(sf_mesh_analyze)]
    pub fn topology(&self) -> Result<Topology> {
        let mut found: sys::sf_topology = unsafe { zeroed() };
        check(unsafe { sys::sf_mesh_analyze(self.view(), allocator(), &mut found) })?;
        Ok(Topology::of(&found))
    }

    #[doc = words!(sf_mesh_transform)]
    ///
    /// `matrix` is row after row; the shift is added last.
    pub fn transform(&mut self, matrix: [[f64; 3]; 3], shift_mm: [f64; 3]) -> Result<()> {
        let mut c = sys::sf_transform { matrix: [0.0; 9], shift_mm };
        for (i, number) in matrix.iter().flatten().enumerate() {
            c.matrix[i] = *number;
        }
        check(unsafe { sys::sf_mesh_transform(self.c.as_ptr(), &c) })
    }

    #[doc = words!(sf_mesh_merge)]
    pub fn merged(&self) -> Result<Mesh> {
        let mut made = ptr::null_mut();
        check(unsafe { sys::sf_mesh_merge(self.view(), allocator(), &mut made) })?;
        Ok(Mesh { c: own(made)? })
    }

    #[doc = words!(sf_mesh_cut: axis, at_mm)]
    ///
    /// Low half first.
    pub fn cut(&self, axis: usize, at_mm: f64) -> Result<(Mesh, Mesh)> {
        let (mut low, mut high, mut fault) = (ptr::null_mut(), ptr::null_mut(), no_fault());
        let axis = i32::try_from(axis).unwrap_or(i32::MAX);
        let cut = unsafe {
            sys::sf_mesh_cut(self.view(), axis, at_mm, allocator(), &mut low, &mut high, &mut fault)
        };
        check_fault(cut, &fault)?;
        Ok((Mesh { c: own(low)? }, Mesh { c: own(high)? }))
    }

    #[doc = words!(sf_mesh_read: format)]
    ///
    /// ```
    /// # fn main() -> libsf::Result<()> {
    /// use libsf::{Mesh, MeshFormat};
    ///
    /// let text = "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
    /// let mesh = Mesh::read(text.as_bytes(), MeshFormat::Auto)?;
    /// let mut stl = Vec::new();
    /// mesh.write(&mut stl, MeshFormat::Stl)?;
    /// assert_eq!(stl.len(), 84 + 4 * 50);
    /// # Ok(())
    /// # }
    /// ```
    pub fn read(from: impl Read, format: MeshFormat) -> Result<Mesh> {
        Mesh::read_within(from, format, &MeshLimits::default())
    }

    /// The same with bounds on what is taken.
    ///
    #[doc = words!(sf_read_limits)]
    pub fn read_within(mut from: impl Read, format: MeshFormat, limits: &MeshLimits) -> Result<Mesh> {
        let c = limits.c();
        let mut made = ptr::null_mut();
        reading(&mut from, |source, fault| unsafe {
            sys::sf_mesh_read(source, format.c(), &c, allocator(), &mut made, fault)
        })?;
        Ok(Mesh { c: own(made)? })
    }

    #[doc = words!(sf_mesh_write: format)]
    pub fn write(&self, mut to: impl Write, format: MeshFormat) -> Result<()> {
        writing(&mut to, |sink| unsafe { sys::sf_mesh_write(self.view(), format.c(), sink) })
    }

    #[doc = words!(sf_gltf_write)]
    ///
    /// `colors` are red, green and blue of each vertex.
    pub fn write_glb(&self, mut to: impl Write, colors: Option<&[[u8; 3]]>) -> Result<()> {
        if colors.is_some_and(|colors| colors.len() != self.vertices().len()) {
            let (given, needed) = (colors.map_or(0, <[_]>::len), self.vertices().len());
            return Err(Error::new(ErrorKind::Shape, format!("{given} colours for {needed} vertices")));
        }
        let first = colors.map_or(ptr::null(), |colors| colors.as_ptr().cast());
        writing(&mut to, |sink| unsafe { sys::sf_gltf_write(self.view(), first, sink) })
    }

    /// Reads a file: STL, OBJ, PLY, OFF or 3MF, by its name, or else by its content; glTF where the library was
    /// made with what reads that.
    pub fn load(path: impl AsRef<Path>) -> Result<Mesh> {
        let path = path.as_ref();
        Mesh::read(open(path)?, MeshFormat::from_path(path)?).map_err(|error| error.in_file(path))
    }

    /// Writes a file: STL, OBJ, PLY, 3MF or binary glTF, by its name; whole or not at all.
    pub fn save(&self, path: impl AsRef<Path>) -> Result<()> {
        let path = path.as_ref();
        let format = MeshFormat::from_path(path)?;
        let text = path.extension().is_some_and(|end| end.eq_ignore_ascii_case("gltf"));
        if text || matches!(format, MeshFormat::Auto | MeshFormat::Off) {
            let said =
                format!("{}: a name that ends in .stl, .obj, .ply, .3mf or .glb is needed", path.display());
            return Err(Error::new(ErrorKind::Argument, said));
        }
        saving(path, |sink| unsafe { sys::sf_mesh_write(self.view(), format.c(), sink) })
    }

    /// The voxels whose centres lie in the mesh, on a lattice of its own around it.
    pub fn voxelize(&self, pitch_mm: f64, layer_mm: f64, task: Option<&mut Task<'_>>) -> Result<Grid> {
        let [low, high] = self.bounds()?;
        let mut grid = Grid::new(&Lattice::around(low, high, pitch_mm, layer_mm, 1)?)?;
        grid.voxelize(self, Fill::Auto, task)?;
        Ok(grid)
    }
}

/// Most that [`Mesh::read_within`] takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MeshLimits {
    #[doc = words!(sf_read_limits.bytes_max)]
    pub bytes_max: u64,
    #[doc = words!(sf_read_limits.triangles_max)]
    pub triangles_max: usize,
    #[doc = words!(sf_read_limits.vertices_max)]
    pub vertices_max: usize,
}

impl MeshLimits {
    pub(crate) fn c(&self) -> sys::sf_read_limits {
        let mut c = unsafe { sys::sf_read_limits_default() };
        c.bytes_max = self.bytes_max;
        c.triangles_max = self.triangles_max;
        c.vertices_max = self.vertices_max;
        c
    }
}

impl Default for MeshLimits {
    fn default() -> MeshLimits {
        let c = unsafe { sys::sf_read_limits_default() };
        let (triangles_max, vertices_max) = (c.triangles_max, c.vertices_max);
        MeshLimits { bytes_max: c.bytes_max, triangles_max, vertices_max }
    }
}

impl Drop for Mesh {
    fn drop(&mut self) {
        unsafe { sys::sf_mesh_destroy(self.c.as_ptr()) }
    }
}

impl Clone for Mesh {
    /// # Panics
    /// Where there is no memory; [`Mesh::try_clone`] says so instead.
    fn clone(&self) -> Mesh {
        self.try_clone().expect("memory for a copy of a mesh")
    }
}

impl fmt::Debug for Mesh {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(to, "Mesh({} vertices, {} faces)", self.vertices().len(), self.faces().len())
    }
}

impl MeshFormat {
    #[doc = words!(sf_mesh_format_from_name)]
    pub fn from_path(path: impl AsRef<Path>) -> Result<MeshFormat> {
        let name = c_path(path.as_ref())?;
        Ok(MeshFormat::of(unsafe { sys::sf_mesh_format_from_name(name.as_ptr()) }))
    }
}

impl Grid {
    #[doc = words!(sf_grid_voxelize)]
    pub fn voxelize(
        &mut self,
        mesh: &Mesh,
        fill: Fill,
        task: Option<&mut Task<'_>>,
    ) -> Result<VoxelizeReport> {
        let mut options = unsafe { sys::sf_voxelize_options_default() };
        options.fill = fill.c();
        let mut report: sys::sf_voxelize_report = unsafe { zeroed() };
        let grid = self.c_mut();
        check(run(task, |task| unsafe {
            sys::sf_grid_voxelize(grid, mesh.view(), &options, allocator(), task, &mut report)
        }))?;
        Ok(VoxelizeReport::of(&report))
    }

    #[doc = words!(sf_grid_surface)]
    ///
    /// - `smooth_passes`: 0 for the exact voxel faces
    pub fn surface(&self, smooth_passes: u32, task: Option<&mut Task<'_>>) -> Result<Mesh> {
        let mut options = unsafe { sys::sf_surface_options_default() };
        options.smooth_passes = i32::try_from(smooth_passes).unwrap_or(i32::MAX);
        let mut made = Made::new(sys::sf_mesh_destroy);
        let to = made.place();
        check(run(task, |task| unsafe { sys::sf_grid_surface(self.c(), &options, allocator(), task, to) }))?;
        Ok(Mesh { c: made.own()? })
    }
}

#[doc = words!(sf_voxelizer)]
///
/// It reads the mesh as long as it lives, so the mesh has to stay:
///
/// ```compile_fail,E0505
/// # fn main() -> libsf::Result<()> {
/// use libsf::{Fill, Lattice, Mesh, Voxelizer};
///
/// let mesh = Mesh::new(&[], &[])?;
/// let voxelizer = Voxelizer::new(&mesh, &Lattice::new(8, 8, 8, 0.1, 0.1)?, Fill::Auto)?;
/// drop(mesh);
/// voxelizer.report()?;
/// # Ok(())
/// # }
/// ```
pub struct Voxelizer<'m> {
    c: NonNull<sys::sf_voxelizer>,
    mesh: PhantomData<&'m Mesh>,
}

// Of the mesh it only reads; it serves one at a time, so it is not Sync.
unsafe impl Send for Voxelizer<'_> {}

impl<'m> Voxelizer<'m> {
    #[doc = words!(sf_voxelizer_create)]
    pub fn new(mesh: &'m Mesh, lattice: &Lattice, fill: Fill) -> Result<Voxelizer<'m>> {
        let mut options = unsafe { sys::sf_voxelize_options_default() };
        options.fill = fill.c();
        let (mut made, mut fault) = (ptr::null_mut(), no_fault());
        let created = unsafe {
            sys::sf_voxelizer_create(mesh.view(), &lattice.c(), &options, allocator(), &mut made, &mut fault)
        };
        check_fault(created, &fault)?;
        Ok(Voxelizer { c: own(made)?, mesh: PhantomData })
    }

    #[doc = words!(sf_voxelizer_slice: k, slice)]
    pub fn slice(&mut self, k: u32, mut slice: SliceMut<'_>) -> Result<()> {
        check(unsafe { sys::sf_voxelizer_slice(self.c.as_ptr(), k, slice.c()) })
    }

    #[doc = words!(sf_voxelizer_report)]
    pub fn report(&self) -> Result<VoxelizeReport> {
        let mut report: sys::sf_voxelize_report = unsafe { zeroed() };
        check(unsafe { sys::sf_voxelizer_report(self.c.as_ptr(), &mut report) })?;
        Ok(VoxelizeReport::of(&report))
    }
}

impl Drop for Voxelizer<'_> {
    fn drop(&mut self) {
        unsafe { sys::sf_voxelizer_destroy(self.c.as_ptr()) }
    }
}

impl fmt::Debug for Voxelizer<'_> {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        to.debug_struct("Voxelizer").finish_non_exhaustive()
    }
}
