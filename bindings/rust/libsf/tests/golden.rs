// SPDX-License-Identifier: MIT
// Why: C, Python and this crate are held against the same small shapes, and against what a few lines of
// another language make of them (tests/golden/make.py). What the three agree on is then no habit of one.

use libsf::{Balance, Grid, Lattice, Mesh, Rule, Stance, StanceOptions, Terms, VoxelBox};
use serde_json::Value;

fn number(value: &Value) -> u32 {
    u32::try_from(value.as_u64().expect("a number")).expect("a small one")
}

/// A string of 0 and 1 in (layer, y, x) order.
fn grid(one: &Value, key: &str) -> Grid {
    let [nx, ny, nz] = [0, 1, 2].map(|axis| number(&one["size"][axis]));
    let solid: Vec<bool> = one[key].as_str().expect(key).bytes().map(|sign| sign == b'1').collect();
    Grid::from_bools(&Lattice::new(nx, ny, nz, 1.0, 1.0).unwrap(), &solid).unwrap()
}

#[test]
fn shapes_come_to_what_three_languages_say() {
    let file: Value = serde_json::from_str(include_str!("box3.json")).unwrap();
    let cases = file["cases"].as_array().unwrap();
    assert_eq!(cases.len(), 45);
    let terms = Terms::new(Rule::box3()).bed_layer(0);
    for (i, one) in cases.iter().enumerate() {
        let mut shape = grid(one, "voxels");
        let [x0, y0, z0, x1, y1, z1] = [0, 1, 2, 3, 4, 5].map(|end| number(&one["bounds"][end]));
        assert_eq!(shape.bounds(), VoxelBox { x0, y0, z0, x1, y1, z1 }, "case {i}");
        assert_eq!(shape.count(), u64::from(number(&one["count"])), "case {i}");
        assert_eq!(shape.unsupported(terms, None).unwrap(), grid(one, "unsupported"), "case {i}");
        let report = shape.trim(terms, None).unwrap();
        assert_eq!(shape, grid(one, "trimmed"), "case {i}");
        assert_eq!(report.kept_voxels, u64::from(number(&one["kept"])), "case {i}");
    }
}

fn numbers<const COUNT: usize>(value: &Value) -> [f64; COUNT] {
    std::array::from_fn(|i| value[i].as_f64().expect("a number"))
}

#[test]
fn bodies_come_to_what_fractions_say() {
    let file: Value = serde_json::from_str(include_str!("tetrahedra.json")).unwrap();
    let cases = file["cases"].as_array().unwrap();
    assert_eq!(cases.len(), 39);
    for (i, one) in cases.iter().enumerate() {
        let vertices: [[f64; 3]; 4] = std::array::from_fn(|v| numbers(&one["vertices"][v]));
        let faces: [[u32; 3]; 4] =
            std::array::from_fn(|face| std::array::from_fn(|v| number(&one["triangles"][face][v])));
        let mesh = Mesh::new(&vertices, &faces).unwrap();
        let (mass, volume) = (mesh.measure().unwrap(), one["volume_mm3"].as_f64().unwrap());
        assert!((mass.volume_mm3 - volume).abs() <= 1e-12 * volume, "case {i}");
        let com: [f64; 3] = numbers(&one["com_mm"]);
        assert!((0..3).all(|axis| (mass.com_mm[axis] - com[axis]).abs() <= 1e-12), "case {i}");
        let inertia: [f64; 6] = numbers(&one["inertia_mm5"]);
        assert!((0..6).all(|part| (mass.inertia_mm5[part] - inertia[part]).abs() <= 1e-9), "case {i}");
        let (stance, margin) = (Stance::new(&mesh, &StanceOptions::default()).unwrap(), &one["margin_rad"]);
        let verdict = stance.judge(mass.com_mm).unwrap();
        assert!((verdict.margin_rad - margin.as_f64().unwrap()).abs() <= 1e-12, "case {i}");
        let x: Vec<f64> = vertices.iter().flatten().copied().collect();
        let found = Balance::new(&faces, 3.0).margin(&x, &stance).unwrap().0;
        assert!((found - verdict.margin_rad).abs() <= 1e-12, "case {i}");
    }
}
