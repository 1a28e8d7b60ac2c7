// SPDX-License-Identifier: MIT
// 3MF files: objects in their places, materials and slices. What a document shows of itself borrows it.

use std::ffi::CStr;
use std::fmt;
use std::io::Read;
use std::path::Path;
use std::ptr::NonNull;

use crate::error::{check_fault, no_fault, Result};
use crate::made::Made;
use crate::memory::allocator;
use crate::plain::{elements, of};
use crate::stream::{open, reading};
use crate::{sys, ContourStack, Mesh, MeshLimits, Transform};

#[doc = words!(sf_threemf_is_served)]
///
/// Where libsf is compiled into the crate it does not; with the feature `system` that is the installed one's
/// affair.
pub fn has_threemf() -> bool {
    unsafe { sys::sf_threemf_is_served() != 0 }
}

#[doc = words!(sf_threemf_kind)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ThreeMfKind {
    /// A part.
    Model,
    /// A support that is printed as it is.
    SolidSupport,
    /// A support that the printer's program makes solid.
    Support,
    /// A surface without an inside.
    Surface,
    /// Anything else, which is not printed.
    Unprinted,
}

#[doc = words!(sf_threemf_object)]
#[derive(Clone, Debug, PartialEq)]
pub struct ThreeMfObject<'d> {
    /// As the file says, or nothing.
    pub name: String,
    /// What it is for.
    pub kind: ThreeMfKind,
    /// Its vertices, mm, in its own axes.
    pub vertices: &'d [[f64; 3]],
    /// Three vertices each.
    pub faces: &'d [[u32; 3]],
    /// Of each corner of each face the number of its colour, `u32::MAX` where it has none; `None`: there are
    /// none at all.
    pub colours: Option<&'d [[u32; 3]]>,
    /// Number of its stack of slices.
    pub stack: Option<u32>,
    /// Whether the file says that the triangles only stand for slices.
    pub is_rough: bool,
}

#[doc = words!(sf_threemf_item)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ThreeMfItem {
    /// Number of the object.
    pub object: u32,
    /// From the object's axes to the bed's.
    pub placed: Transform,
}

#[doc = words!(sf_threemf_colour)]
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ThreeMfColour {
    /// Of a base material; nothing for a colour of a group.
    pub name: String,
    /// Red, green, blue, and 255 for opaque.
    pub rgba: [u8; 4],
    /// Colours of one group of the file have the same number.
    pub group: u32,
}

#[doc = words!(sf_threemf)]
///
/// ```
/// # fn main() -> libsf::Result<()> {
/// use libsf::{has_threemf, Mesh, MeshFormat, ThreeMf};
///
/// let corners = [[0.0, 0.0, 0.0], [3.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 3.0]];
/// let mesh = Mesh::new(&corners, &[[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])?;
/// if has_threemf() {
///     let mut file = Vec::new();
///     mesh.write(&mut file, MeshFormat::Threemf)?;
///     let document = ThreeMf::read(&file[..], &Default::default())?;
///     assert_eq!(document.objects()[0].faces, mesh.faces());
///     assert_eq!(document.merged(&Default::default())?.vertices(), mesh.vertices());
/// }
/// # Ok(())
/// # }
/// ```
pub struct ThreeMf {
    c: NonNull<sys::sf_threemf>,
}

// It does not change once it is read.
unsafe impl Send for ThreeMf {}
unsafe impl Sync for ThreeMf {}

/// # Safety
/// It is text of C's, or NULL.
unsafe fn text(c: *const std::ffi::c_char) -> String {
    if c.is_null() {
        return String::new();
    }
    unsafe { CStr::from_ptr(c) }.to_string_lossy().into_owned()
}

fn number(c: u32) -> Option<u32> {
    (c != sys::SF_THREEMF_NONE).then_some(c)
}

impl ThreeMf {
    #[doc = words!(sf_threemf_read)]
    pub fn read(mut from: impl Read, limits: &MeshLimits) -> Result<ThreeMf> {
        let (mut made, limits) = (Made::new(sys::sf_threemf_destroy), limits.c());
        let to = made.place();
        reading(&mut from, |source, fault| unsafe {
            sys::sf_threemf_read(source, &limits, allocator(), to, fault)
        })?;
        Ok(ThreeMf { c: made.own()? })
    }

    /// Reads a file.
    pub fn load(path: impl AsRef<Path>) -> Result<ThreeMf> {
        ThreeMf::read(open(path.as_ref())?, &MeshLimits::default())
    }

    fn c(&self) -> *const sys::sf_threemf {
        self.c.as_ptr()
    }

    #[doc = words!(sf_threemf_get_view)]
    ///
    /// Here the objects, in the order of the file.
    pub fn objects(&self) -> Vec<ThreeMfObject<'_>> {
        let view = unsafe { sys::sf_threemf_get_view(self.c()) };
        let all = unsafe { elements(view.objects, view.object_count) };
        all.iter().map(|object| unsafe { ThreeMfObject::of(object) }).collect()
    }

    /// What is built, in the order of the file.
    pub fn items(&self) -> Vec<ThreeMfItem> {
        let view = unsafe { sys::sf_threemf_get_view(self.c()) };
        let all = unsafe { elements(view.items, view.item_count) };
        all.iter().map(|item| ThreeMfItem { object: item.object, placed: of(&item.placed) }).collect()
    }

    /// All materials, and the colours of all groups.
    pub fn colours(&self) -> Vec<ThreeMfColour> {
        let view = unsafe { sys::sf_threemf_get_view(self.c()) };
        let all = unsafe { elements(view.colours, view.colour_count) };
        let one = |colour: &sys::sf_threemf_colour| ThreeMfColour {
            name: unsafe { text(colour.name) },
            rgba: colour.rgba,
            group: colour.group,
        };
        all.iter().map(one).collect()
    }

    #[doc = words!(sf_threemf_merge: limits)]
    pub fn merged(&self, limits: &MeshLimits) -> Result<Mesh> {
        let (mut made, mut fault) = (Made::new(sys::sf_mesh_destroy), no_fault());
        let limits = limits.c();
        let merged =
            unsafe { sys::sf_threemf_merge(self.c(), &limits, allocator(), made.place(), &mut fault) };
        check_fault(merged, &fault)?;
        Ok(Mesh::of(made.own()?))
    }

    #[doc = words!(sf_threemf_is_sliced)]
    pub fn is_sliced(&self) -> bool {
        unsafe { sys::sf_threemf_is_sliced(self.c()) != 0 }
    }

    #[doc = words!(sf_threemf_contours)]
    pub fn contours(&self) -> Result<ContourStack> {
        let (mut made, mut fault) = (Made::new(sys::sf_contour_stack_destroy), no_fault());
        let found = unsafe { sys::sf_threemf_contours(self.c(), allocator(), made.place(), &mut fault) };
        check_fault(found, &fault)?;
        Ok(ContourStack::owned(made.own()?))
    }
}

impl<'d> ThreeMfObject<'d> {
    /// # Safety
    /// The arrays hold what is said for as long as 'd.
    unsafe fn of(c: &sys::sf_threemf_object) -> ThreeMfObject<'d> {
        let (vertices, faces) = (c.mesh.vertices.cast(), c.mesh.triangles.cast());
        let colours: *const [u32; 3] = c.colours.cast();
        unsafe {
            ThreeMfObject {
                name: text(c.name),
                kind: match c.kind {
                    sys::SF_THREEMF_MODEL => ThreeMfKind::Model,
                    sys::SF_THREEMF_SOLID_SUPPORT => ThreeMfKind::SolidSupport,
                    sys::SF_THREEMF_SUPPORT => ThreeMfKind::Support,
                    sys::SF_THREEMF_SURFACE => ThreeMfKind::Surface,
                    _ => ThreeMfKind::Unprinted,
                },
                vertices: elements(vertices, c.mesh.vertex_count),
                faces: elements(faces, c.mesh.triangle_count),
                colours: (!colours.is_null()).then(|| elements(colours, c.mesh.triangle_count)),
                stack: number(c.stack),
                is_rough: c.is_rough != 0,
            }
        }
    }
}

impl Drop for ThreeMf {
    fn drop(&mut self) {
        unsafe { sys::sf_threemf_destroy(self.c.as_ptr()) }
    }
}

impl fmt::Debug for ThreeMf {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(to, "ThreeMf({} objects, {} items)", self.objects().len(), self.items().len())
    }
}
