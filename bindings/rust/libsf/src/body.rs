// SPDX-License-Identifier: MIT
// Bodies: what a thing weighs and where its weight lies, and how both change with its vertices.

use std::ops::{Add, Sub};

use crate::error::{check, Result};
use crate::plain::{c, first, first_mut, of, room};
use crate::task::run;
use crate::{sys, Ballast, Body, Grid, Mesh, Task};

/// Derivatives of a mass and its moments by a point: a row for the mass, one for each moment.
pub type BodyGradient = [[f64; 3]; 4];

impl Body {
    #[doc = words!(sf_body_add: factor)]
    pub fn plus(self, factor: f64, other: Body) -> Body {
        of(&unsafe { sys::sf_body_add(c(&self), factor, c(&other)) })
    }

    #[doc = words!(sf_ballast_body)]
    pub fn of_ballast(ballast: &[Ballast]) -> Body {
        of(&unsafe { sys::sf_ballast_body(first(ballast), ballast.len()) })
    }

    #[doc = words!(sf_body_com)]
    ///
    /// ```
    /// # fn main() -> libsf::Result<()> {
    /// use libsf::{Ballast, Body, Grid, Lattice};
    ///
    /// let lattice = Lattice::new(20, 20, 20, 1.0, 1.0)?;
    /// let block = Grid::from_fn(&lattice, |_, _, _| true)?.body(None, None)?;
    /// assert_eq!(block.center_of_mass()?, [10.0; 3]);
    /// // A magnet as heavy as the block, in its foot.
    /// let magnet = Ballast { mass: 8000.0, at_mm: [10.0, 10.0, 1.0] };
    /// let both = block + Body::of_ballast(&[magnet]);
    /// assert_eq!(both.center_of_mass()?, [10.0, 10.0, 5.5]);
    /// # Ok(())
    /// # }
    /// ```
    pub fn center_of_mass(self) -> Result<[f64; 3]> {
        let mut found = [0.0; 3];
        check(unsafe { sys::sf_body_com(c(&self), found.as_mut_ptr()) })?;
        Ok(found)
    }

    #[doc = words!(sf_body_com_gradient)]
    ///
    /// A row for each axis of the centre.
    pub fn com_gradient(self, gradient: &[BodyGradient]) -> Result<Vec<[[f64; 3]; 3]>> {
        let mut found: Vec<[[f64; 3]; 3]> = room(gradient.len())?;
        let (from, to) = (gradient.as_ptr().cast(), found.as_mut_ptr().cast());
        check(unsafe { sys::sf_body_com_gradient(c(&self), from, gradient.len(), to) })?;
        Ok(found)
    }
}

impl Add for Body {
    type Output = Body;

    fn add(self, other: Body) -> Body {
        self.plus(1.0, other)
    }
}

impl Sub for Body {
    type Output = Body;

    fn sub(self, other: Body) -> Body {
        self.plus(-1.0, other)
    }
}

impl Mesh {
    #[doc = words!(sf_mesh_body: density)]
    pub fn body(&self, density: f64) -> Result<Body> {
        body(self.view(), density)
    }

    #[doc = words!(sf_mesh_body_gradient: density)]
    pub fn body_gradient(&self, density: f64) -> Result<Vec<BodyGradient>> {
        body_gradient(self.view(), density)
    }
}

/// The body of the solid that triangles bound.
pub(crate) fn body(mesh: sys::sf_mesh_view, density: f64) -> Result<Body> {
    let mut found = c(&Body::default());
    check(unsafe { sys::sf_mesh_body(mesh, density, &mut found) })?;
    Ok(of(&found))
}

/// Its derivatives by each vertex.
pub(crate) fn body_gradient(mesh: sys::sf_mesh_view, density: f64) -> Result<Vec<BodyGradient>> {
    let mut found: Vec<BodyGradient> = room(mesh.vertex_count)?;
    check(unsafe { sys::sf_mesh_body_gradient(mesh, density, found.as_mut_ptr().cast()) })?;
    Ok(found)
}

impl Grid {
    #[doc = words!(sf_grid_body: density)]
    pub fn body(&self, density: Option<&[f32]>, task: Option<&mut Task<'_>>) -> Result<Body> {
        let weights = self.lattice().each(density, "density")?;
        let mut found = [Body::default()];
        check(run(task, |task| unsafe {
            sys::sf_grid_body(self.c(), weights, task, first_mut(&mut found))
        }))?;
        Ok(found[0])
    }
}
