// SPDX-License-Identifier: MIT
// Why: where the weight lies, and whether a thing stands, is said by this crate in a dozen calls that people
// chain. Each is held against a second computation: sums over voxels, differences for derivatives, the
// geometry of a box, and one way of asking against another.

mod shapes;

use libsf::{
    Balance, Ballast, Body, DensityOptions, ErrorKind, Grid, Lattice, Mesh, OrientOptions, PrintingOptions,
    Region, Rule, Stance, StanceKind, StanceOptions,
};
use shapes::{lattice, shape, Random};

type Vector = [f64; 3];

fn dot(a: Vector, b: Vector) -> f64 {
    (0..3).map(|i| a[i] * b[i]).sum()
}

/// A foot of 8 x 8 mm with an arm on it, 24 mm long.
fn crane() -> Mesh {
    let lattice = Lattice::new(24, 8, 16, 1.0, 1.0).unwrap();
    let grid = Grid::from_fn(&lattice, |layer, _, x| x < 8 || layer >= 10).unwrap();
    grid.surface(0, None).unwrap().merged().unwrap()
}

/// Mass and centre of mass of voxels, by a loop over them.
fn summed(grid: &Grid, density: impl Fn(usize) -> f64) -> (f64, Vector) {
    let on = grid.lattice();
    let (_, ny, nx) = on.shape();
    let (mut mass, mut moment) = (0.0, [0.0; 3]);
    for (i, _) in grid.to_bools().iter().enumerate().filter(|(_, &solid)| solid) {
        let (k, y, x) = (i / nx / ny, i / nx % ny, i % nx);
        let bottom = on.layer_bottom(k as u32).unwrap();
        let height = on.layer_bottom(k as u32 + 1).unwrap() - bottom;
        let [px, py] = on.pitch_mm();
        let one = density(i) * px * py * height;
        let place = [
            on.origin_mm()[0] + (x as f64 + 0.5) * px,
            on.origin_mm()[1] + (y as f64 + 0.5) * py,
            bottom + 0.5 * height,
        ];
        mass += one;
        (0..3).for_each(|axis| moment[axis] += one * place[axis]);
    }
    (mass, moment.map(|part| part / mass))
}

#[test]
fn bodies_weigh_what_their_voxels_do() {
    for seed in 1..31 {
        let mut random = Random::new(seed);
        let on = lattice(&mut random).with_origin([3.0, -7.0, 1.5]).unwrap();
        let grid = shape(&mut random, &on);
        if grid.count() == 0 {
            let none = grid.body(None, None).unwrap().center_of_mass().unwrap_err();
            assert_eq!(none.kind(), ErrorKind::Argument, "seed {seed}");
            continue;
        }
        let weights: Vec<f32> = grid.to_bools().iter().map(|_| 1.0 + random.below(8) as f32).collect();
        let plain = grid.body(None, None).unwrap();
        let heavy = grid.body(Some(&weights), None).unwrap();
        for (body, (mass, com)) in
            [(plain, summed(&grid, |_| 1.0)), (heavy, summed(&grid, |i| f64::from(weights[i])))]
        {
            assert!((body.mass - mass).abs() < 1e-9 * mass, "seed {seed}");
            let found = body.center_of_mass().unwrap();
            assert!((0..3).all(|axis| (found[axis] - com[axis]).abs() < 1e-9), "seed {seed}");
        }
        let rest = heavy - plain;
        assert!((rest.plus(1.0, plain).mass - heavy.mass).abs() < 1e-9 * heavy.mass, "seed {seed}");
        let short = grid.body(Some(&weights[1..]), None).unwrap_err();
        assert_eq!(short.kind(), ErrorKind::Shape, "seed {seed}");
        assert!(short.message().contains("density"), "{short}");
    }
    assert!((crane().body(2.0).unwrap().mass - 2.0 * (8.0 * 8.0 * 16.0 + 16.0 * 8.0 * 6.0)).abs() < 1e-9);
    let two = [Ballast { mass: 2.0, at_mm: [1.0, 0.0, 0.0] }, Ballast { mass: 1.0, at_mm: [-2.0, 3.0, 0.0] }];
    assert_eq!(Body::of_ballast(&two).center_of_mass().unwrap(), [0.0, 1.0, 0.0]);
    assert_eq!(Body::of_ballast(&[]), Body::default());
}

#[test]
fn densities_are_those_of_the_last_region() {
    let on = Lattice::new(10, 10, 10, 1.0, 1.0).unwrap();
    let mask = Grid::from_fn(&on, |layer, _, _| layer == 9).unwrap();
    let ball = Grid::from_fn(&on, |layer, y, x| layer < 3 && y < 3 && x < 3).unwrap();
    let mesh = ball.surface(0, None).unwrap();
    let wall = Grid::from_fn(&on, |_, y, _| y == 0).unwrap();
    let regions = [
        (Region::Box { low_mm: [0.0; 3], high_mm: [10.0, 10.0, 1.0] }, 5.0),
        (Region::Mesh(&mesh), 3.0),
        (Region::Mask(&mask), 7.0),
    ];
    let options = DensityOptions { density: 2.0, infill: 0.5, wall: Some(&wall), regions: &regions };
    let found = on.density(&options, None).unwrap();
    for (i, &one) in found.iter().enumerate() {
        let (k, y, x) = (i / 100, i / 10 % 10, i % 10);
        let expected = match (k, y, x) {
            (9, _, _) => 7.0,
            (0..=2, 0..=2, 0..=2) => 3.0,
            (0, _, _) => 5.0,
            (_, 0, _) => 2.0,
            _ => 1.0,
        };
        assert_eq!(one, expected, "voxel {x} {y} {k}");
    }
    let nothing = DensityOptions { infill: 0.0, ..DensityOptions::default() };
    assert_eq!(on.density(&nothing, None).unwrap_err().kind(), ErrorKind::Argument);
}

#[test]
fn derivatives_are_what_differences_say() {
    let mesh = crane();
    let stance = Stance::new(&mesh, &StanceOptions::default()).unwrap();
    let balance = Balance::new(mesh.faces(), 1.5);
    let x: Vec<f64> = mesh.vertices().iter().flatten().copied().collect();
    let (mass, by_mass) = balance.mass(&x).unwrap();
    let (com, by_com) = balance.center_of_mass(&x).unwrap();
    let (margin, by_margin) = balance.margin(&x, &stance).unwrap();
    let measured = mesh.measure().unwrap();
    assert!((mass - 1.5 * measured.volume_mm3).abs() < 1e-9);
    assert!((0..3).all(|axis| (com[axis] - measured.com_mm[axis]).abs() < 1e-12));
    assert!((margin - stance.judge(com).unwrap().margin_rad).abs() < 1e-12);
    let mut random = Random::new(5);
    for _ in 0..40 {
        let i = random.below(x.len() as u32) as usize;
        let step = 1e-4;
        let at = |by: f64| {
            let mut moved = x.clone();
            moved[i] += by;
            let com = balance.center_of_mass(&moved).unwrap().0;
            let mass = balance.mass(&moved).unwrap().0;
            [mass, com[0], com[1], com[2], balance.margin(&moved, &stance).unwrap().0]
        };
        let (more, less) = (at(step), at(-step));
        let said = [by_mass[i], by_com[0][i], by_com[1][i], by_com[2][i], by_margin[i]];
        for (what, said) in said.into_iter().enumerate() {
            let seen = (more[what] - less[what]) / (2.0 * step);
            assert!((seen - said).abs() < 1e-7, "number {i}, value {what}: {seen} and not {said}");
        }
    }
    let rows = mesh.body(1.5).unwrap().com_gradient(&mesh.body_gradient(1.5).unwrap()).unwrap();
    assert!(rows.iter().enumerate().all(|(v, row)| row[1][2] == by_com[1][3 * v + 2]));
    assert_eq!(balance.mass(&x[1..]).unwrap_err().kind(), ErrorKind::Shape);
    assert_eq!(balance.mass(&x[3..]).unwrap_err().kind(), ErrorKind::Argument);
    let hangs = StanceOptions { kind: StanceKind::Hang, point_mm: [4.0, 4.0, 16.0], ..Default::default() };
    let hangs = Stance::new(&mesh, &hangs).unwrap();
    assert_eq!(balance.margin(&x, &hangs).unwrap_err().kind(), ErrorKind::Unsupported);
}

#[test]
fn a_stance_says_one_thing_in_all_ways() {
    let mesh = crane();
    let options = StanceOptions { gamma_rad: 0.1, ..StanceOptions::default() };
    let stance = Stance::new(&mesh, &options).unwrap();
    assert_eq!((stance.options().gamma_rad, stance.options().up), (0.1, [0.0, 0.0, 1.0]));
    assert_eq!(stance.ground_mm(), 0.0);
    let mut corners = stance.polygon().unwrap();
    corners.sort_by(|a, b| a.partial_cmp(b).unwrap());
    assert_eq!(corners, [[0.0, 0.0, 0.0], [0.0, 8.0, 0.0], [8.0, 0.0, 0.0], [8.0, 8.0, 0.0]]);
    let low: Vec<u32> =
        (0u32..).zip(mesh.vertices()).filter(|(_, place)| place[2] == 0.0).map(|(i, _)| i).collect();
    assert_eq!(stance.contacts().unwrap(), low);
    let halfspaces = stance.halfspaces().unwrap();
    assert_eq!(halfspaces.len(), 4);
    let mut random = Random::new(3);
    for _ in 0..2000 {
        let mut number = |most: f64| f64::from(random.below(10_000)) / 10_000.0 * most;
        let com = [number(8.0), number(8.0), 0.01 + number(12.0)];
        let verdict = stance.judge(com).unwrap();
        // The least of the four tilts that a box survives.
        let reach = [com[0], 8.0 - com[0], com[1], 8.0 - com[1]].into_iter().fold(f64::INFINITY, f64::min);
        assert!((verdict.margin_rad - reach.atan2(com[2])).abs() < 1e-9, "{com:?}");
        let slack = halfspaces.iter().map(|half| dot(half.normal, com) - half.offset_mm);
        let slack = slack.fold(f64::INFINITY, f64::min);
        assert!((verdict.slack_mm - slack).abs() < 1e-9, "{com:?}");
        if slack.abs() > 1e-6 {
            assert_eq!((verdict.safe, verdict.margin_rad > 0.1), (slack > 0.0, slack > 0.0), "{com:?}");
        }
        assert!(verdict.stands);
    }
    assert_eq!(stance.judge([f64::NAN; 3]).unwrap_err().kind(), ErrorKind::Argument);
    let wrong = StanceOptions { up: [0.0; 3], ..StanceOptions::default() };
    let refused = Stance::new(&mesh, &wrong).unwrap_err();
    assert_eq!(refused.kind(), ErrorKind::Argument);
    assert!(refused.message().len() > 20, "{refused}");
}

#[test]
fn feet_are_put_flat_and_bodies_come_to_rest() {
    let mesh = crane();
    let mut bumpy = mesh.vertices().to_vec();
    let mut random = Random::new(9);
    for place in bumpy.iter_mut().filter(|place| place[2] == 0.0) {
        place[2] = f64::from(random.below(100)) * 1e-3;
    }
    let uneven = Mesh::new(&bumpy, mesh.faces()).unwrap();
    let options = StanceOptions { contact_mm: 0.2, ..StanceOptions::default() };
    let stance = Stance::new(&uneven, &options).unwrap();
    stance.flatten(&mut bumpy).unwrap();
    for (flat, before) in bumpy.iter().zip(mesh.vertices()) {
        let expected = if before[2] == 0.0 { stance.ground_mm() } else { before[2] };
        assert_eq!(*flat, [before[0], before[1], expected]);
    }
    assert_eq!(stance.flatten(&mut bumpy[1..]).unwrap_err().kind(), ErrorKind::Shape);

    // The crane falls onto its arm; a cube stays on whichever face it is put.
    let com = mesh.measure().unwrap().com_mm;
    let fallen = mesh.rest(com, &[[0.0, 0.0, 1.0], [0.0, 0.0, -1.0]]).unwrap();
    assert!(fallen[0].tilt_rad > 0.5 && fallen[0].turn_count > 0, "{fallen:?}");
    assert_eq!((fallen[1].turn_count, fallen[1].tilt_rad), (0, 0.0), "{fallen:?}");
    let stance = StanceOptions { up: fallen[0].up, ..StanceOptions::default() };
    assert!(Stance::new(&mesh, &stance).unwrap().judge(com).unwrap().stands);
    assert!(mesh.rest(com, &[]).unwrap().is_empty());
    assert_eq!(mesh.rest([1e3; 3], &[[0.0, 0.0, 1.0]]).unwrap_err().kind(), ErrorKind::Argument);
}

#[test]
fn a_print_topples_when_its_weight_leaves_its_foot() {
    let on = Lattice::new(24, 8, 16, 1.0, 0.5).unwrap();
    let part = Grid::from_fn(&on, |layer, _, x| x < 8 || (layer >= 4 && x < 8 + layer)).unwrap();
    let found = part.printing(&PrintingOptions::default(), None).unwrap();
    let mut worst = (f64::INFINITY, 0);
    for k in 0..16 {
        let so_far = Grid::from_fn(&on, |layer, y, x| layer <= k && part.get(layer, y, x)).unwrap();
        let (_, com) = summed(&so_far, |_| 1.0);
        let reach = [com[0], 8.0 - com[0], com[1], 8.0 - com[1]].into_iter().fold(f64::INFINITY, f64::min);
        let margin = reach.atan2(com[2]);
        assert!((found.margins_rad[k as usize] - margin).abs() < 1e-9, "layer {k}");
        if margin < worst.0 {
            worst = (margin, k);
        }
    }
    assert_eq!((found.report.layer, found.report.bed_layer), (Some(worst.1), Some(0)));
    assert_eq!((found.report.floating_count, found.report.floating_layer), (0, None));
    let far = PrintingOptions { bed_layer: Some(16), ..PrintingOptions::default() };
    assert_eq!(part.printing(&far, None).unwrap_err().kind(), ErrorKind::Argument);
}

#[test]
fn an_orientation_is_what_a_trim_of_it_says() {
    let mesh = crane();
    let options =
        OrientOptions { direction_count: 100, coarse_count: 6, fine_count: 3, ..Default::default() };
    let options = OrientOptions { coarse_resolution: 24, resolution: 24, ..options };
    let (best, given) = mesh.orient(&options, None).unwrap();
    assert_eq!(best.len(), 3);
    assert!(best.windows(2).all(|pair| pair[0].score <= pair[1].score));
    assert!(best[0].score <= given.score);
    // Of the arm each layer may reach a voxel farther than the one below it.
    let hangs = (1..=6).map(|reach| (16 - reach) * 8).sum();
    assert_eq!((given.up, given.trimmed_voxels), ([0.0, 0.0, 1.0], hangs));
    for one in &best {
        let mut turned = mesh.clone();
        let rows = [0, 1, 2].map(|row| [0, 1, 2].map(|column| one.turn.matrix[3 * row + column]));
        turned.transform(rows, one.turn.shift_mm).unwrap();
        let [low, high] = turned.bounds().unwrap();
        assert!(low[2].abs() < 1e-9 && (high[2] - one.height_mm).abs() < 1e-9);
        let up = [0, 1, 2].map(|row| dot(rows[row], one.up));
        assert!((up[2] - 1.0).abs() < 1e-12);
        if one.trimmed_voxels == 0 {
            let grid = turned.voxelize(1.0, 1.0, None).unwrap();
            let rule = Rule::octagon(std::f64::consts::FRAC_PI_4);
            assert!(grid.check(rule, None).unwrap().support_free(), "{:?}", one.up);
        }
    }
    let none = OrientOptions { fine_count: 0, ..options };
    assert_eq!(mesh.orient(&none, None).unwrap_err().kind(), ErrorKind::Argument);
    let many = OrientOptions { fine_count: u32::MAX, ..options };
    assert_eq!(mesh.orient(&many, None).unwrap_err().kind(), ErrorKind::Argument);
}
