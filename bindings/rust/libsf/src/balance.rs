// SPDX-License-Identifier: MIT
// Mass, centre of mass and margin as functions of numbers, with derivatives: for any optimiser.
//
// The margin is that of a body that stands. Let h be the height of the centre of mass c above the ground,
// and s = n . (c - p) how far inside of the edge it lies over which it falls first, n the edge's inward
// normal. It falls when the ground tilts by atan2(s, h), whose derivative by c is (h n - s up) / (h^2 + s^2).

use crate::body::{body, body_gradient};
use crate::error::Result;
use crate::{sys, Error, ErrorKind, Stance, StanceKind};

type Vector = [f64; 3];

/// Mass, centre of mass and margin of a closed mesh as functions of its vertices, with their derivatives.
///
/// Each function takes x, y, z of every vertex in a row, in mm, and returns a value and, in the same order,
/// its derivatives. Optimisers want functions of numbers, and get these as closures:
///
/// ```
/// # fn main() -> libsf::Result<()> {
/// use libsf::{Balance, Grid, Lattice, Mesh, Stance, StanceOptions};
///
/// // A foot, and an arm that pulls it over.
/// let lattice = Lattice::new(24, 8, 16, 1.0, 1.0)?;
/// let grid = Grid::from_fn(&lattice, |layer, _, x| x < 8 || layer >= 10)?;
/// let mesh = grid.surface(0, None)?.merged()?;
/// let stance = Stance::new(&mesh, &StanceOptions::default())?;
/// let balance = Balance::new(mesh.faces(), 1.0);
/// let margin = |x: &[f64]| balance.margin(x, &stance);
///
/// // Steps uphill, as long as they have to be; what stands on the ground is held.
/// let mut x: Vec<f64> = mesh.vertices().iter().flatten().copied().collect();
/// assert!(margin(&x)?.0 < -0.1, "it falls");
/// for _ in 0..5 {
///     let (value, mut by_x) = margin(&x)?;
///     let held = by_x.chunks_mut(3).zip(x.chunks(3)).filter(|(_, place)| place[2] == 0.0);
///     held.for_each(|(by, _)| by.fill(0.0));
///     let square: f64 = by_x.iter().map(|by| by * by).sum();
///     x.iter_mut().zip(by_x).for_each(|(x, by)| *x += (0.05 - value) / square * by);
/// }
/// assert!((margin(&x)?.0 - 0.05).abs() < 1e-6, "it stands");
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Debug)]
pub struct Balance {
    faces: Vec<[u32; 3]>,
    density: f64,
}

impl Balance {
    /// A mesh's triangles, and what 1 mm3 of what they bound weighs.
    pub fn new(faces: &[[u32; 3]], density: f64) -> Balance {
        Balance { faces: faces.to_vec(), density }
    }

    fn view(&self, vertices: &[f64]) -> Result<sys::sf_mesh_view> {
        if vertices.len() % 3 != 0 {
            let said = format!("{} numbers are no places: three for each vertex are needed", vertices.len());
            return Err(Error::new(ErrorKind::Shape, said));
        }
        Ok(sys::sf_mesh_view {
            vertices: vertices.as_ptr(),
            vertex_count: vertices.len() / 3,
            triangles: self.faces.as_ptr().cast(),
            triangle_count: self.faces.len(),
        })
    }

    /// The mass, and its derivatives.
    pub fn mass(&self, vertices: &[f64]) -> Result<(f64, Vec<f64>)> {
        let view = self.view(vertices)?;
        let by_vertex = body_gradient(view, self.density)?;
        Ok((body(view, self.density)?.mass, by_vertex.iter().flat_map(|rows| rows[0]).collect()))
    }

    /// The centre of mass, and the derivatives of its x, y and z.
    pub fn center_of_mass(&self, vertices: &[f64]) -> Result<(Vector, [Vec<f64>; 3])> {
        let view = self.view(vertices)?;
        let whole = body(view, self.density)?;
        let by_vertex = whole.com_gradient(&body_gradient(view, self.density)?)?;
        let row = |axis: usize| by_vertex.iter().flat_map(|rows| rows[axis]).collect();
        Ok((whole.center_of_mass()?, [row(0), row(1), row(2)]))
    }

    /// The tilt of the ground, in radians, that a shape which stands survives, and its derivatives.
    ///
    /// It is negative where the shape falls as it is. The stance is as it was made: what touches the ground
    /// does not move along, so vertices that do should be held.
    pub fn margin(&self, vertices: &[f64], stance: &Stance) -> Result<(f64, Vec<f64>)> {
        let (com, by_vertex) = self.center_of_mass(vertices)?;
        let (margin, by_com) = margin(com, stance)?;
        let whole = (0..vertices.len()).map(|i| (0..3).map(|axis| by_com[axis] * by_vertex[axis][i]).sum());
        Ok((margin, whole.collect()))
    }
}

/// The margin of a centre of mass, and its derivatives by that.
fn margin(com: Vector, stance: &Stance) -> Result<(f64, Vector)> {
    let refused = |said: &str| Err(Error::new(ErrorKind::Unsupported, said));
    let options = stance.options();
    if options.kind != StanceKind::Stand {
        return refused("derivatives of a margin are those of a body that stands; this one hangs or rocks");
    }
    let [from, to] = stance.judge(com)?.edge_mm;
    let across = cross(options.up, less(to, from));
    let length = dot(across, across).sqrt();
    if length == 0.0 {
        return refused("it stands on a point, over no edge that it would fall over first");
    }
    let inward = across.map(|part| part / length);
    let (inside, height) = (dot(inward, less(com, from)), dot(options.up, com) - stance.ground_mm());
    let square = height * height + inside * inside;
    if square == 0.0 {
        return refused("the centre of mass lies on the edge that it stands on");
    }
    let by_com = [0, 1, 2].map(|axis| (height * inward[axis] - inside * options.up[axis]) / square);
    Ok((inside.atan2(height), by_com))
}

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn less(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
