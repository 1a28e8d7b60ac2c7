// SPDX-License-Identifier: MIT
// Why: a graded solid goes through many hands: a cage, its refinement, its limit, a sampler. What each gives is
// held here against something that is known without the library: splines written down, sums of determinants,
// properties that are a function of the place. What C believes of an array's length has to be refused before.

mod shapes;

use libsf::{
    Cage, CageHistory, CageView, Channel, Crease, ErrorKind, Falloff, Grid, Lattice, Limit, Locator,
    PaintBrush, PaintOperation, PaintWhere, Place, Property, RefineRules, Refinement, Sampler, SharpPoint,
    SkeletonNode, SkeletonStrut, Task, Tets, TetsView,
};
use shapes::Random;
use std::panic::{catch_unwind, AssertUnwindSafe};

fn unit(random: &mut Random) -> f64 {
    f64::from(random.below(1 << 20)) / f64::from(1 << 20)
}

/// A block of 6 cells along each axis, 12 mm long, its points somewhat astray, with 100 z as its density.
fn block() -> Cage {
    let mut random = Random::new(5);
    let mut cage = Cage::block([6; 3], [0.0; 3], [12.0; 3]).unwrap();
    cage.map_positions(|at| at.map(|x| x + 0.6 * unit(&mut random) - 0.3)).unwrap();
    let values: Vec<f64> = cage.positions().iter().map(|at| 100.0 * (at[2] + 1.0)).collect();
    cage.add_property(&Channel::of_points(Property::density(), &values)).unwrap();
    cage
}

fn places(random: &mut Random, limit: &Limit, count: usize) -> Vec<Place> {
    let pieces = limit.piece_count() as u32;
    let mut place = || Place { piece: random.below(pieces), u: [(); 3].map(|()| unit(random)) };
    (0..count).map(|_| place()).collect()
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|i| (a[i] - b[i]).powi(2)).sum::<f64>().sqrt()
}

#[test]
fn types_go_to_other_threads() {
    fn both<T: Send + Sync>() {}
    both::<Cage>();
    both::<CageView<'static>>();
    both::<CageHistory>();
    both::<Refinement>();
    both::<Limit>();
    both::<Locator<'static>>();
    both::<Tets<'static>>();
    both::<Sampler<'static>>();
}

#[test]
fn a_cage_comes_out_as_it_went_in() {
    let cage = block();
    let view = cage.view();
    assert_eq!((view.cell_count(), view.cells().count(), view.cells().next().unwrap().len()), (216, 216, 8));
    let creases = [Crease { points: [0, 1], sharpness: 2.5 }, Crease { points: [1, 2], sharpness: 10.0 }];
    let sharps = [SharpPoint { point: 0, sharpness: 1.0 }];
    // Each cell has a value of its own at its corners: it jumps everywhere.
    let values: Vec<f64> = (0..216).map(f64::from).collect();
    let indices: Vec<u32> = (0..216 * 8).map(|corner| corner / 8).collect();
    let mut channels = view.channels.clone();
    channels.push(Channel {
        property: Property::named("number").unwrap(),
        values: &values,
        indices: Some(&indices),
    });
    let wanted = CageView { creases: &creases, sharps: &sharps, channels, ..view };
    let made = Cage::new(&wanted).unwrap();
    assert_eq!(made.view(), wanted);
    assert_eq!(made.try_clone().unwrap().view(), wanted);
    assert_eq!(
        (made.channel("number"), made.channel("density"), made.channel("x")),
        (Some(1), Some(0), None)
    );
    let limit = made.limit(RefineRules::Standard, None).unwrap();
    let all = places(&mut Random::new(3), &limit, 200);
    let found = limit.values(1, &all, None).unwrap();
    for (place, value) in all.iter().zip(found) {
        assert!((value - f64::from(place.piece / 8)).abs() < 1e-9, "{place:?} {value}");
    }
}

#[test]
fn a_limit_is_the_spline_where_the_cage_is_regular() {
    let cage = block();
    let limit = cage.limit(RefineRules::Standard, None).unwrap();
    let at = |i: usize, j: usize, k: usize| i + 7 * (j + 7 * k);
    let weights = [1.0 / 6.0, 4.0 / 6.0, 1.0 / 6.0];
    let mut checked = 0;
    for (i, j, k) in [(2, 3, 4), (3, 3, 3), (4, 2, 3), (2, 2, 2)] {
        let place = limit.place(i + 6 * (j + 6 * k), [0.0; 3]).unwrap();
        let (mut wanted, mut value) = ([0.0; 3], 0.0);
        for n in 0..27 {
            let (a, b, c) = (n % 3, n / 3 % 3, n / 9);
            let (point, w) = (at(i + a - 1, j + b - 1, k + c - 1), weights[a] * weights[b] * weights[c]);
            (0..3).for_each(|axis| wanted[axis] += w * cage.positions()[point][axis]);
            value += w * cage.values(0).unwrap()[point];
        }
        assert!(distance(limit.positions(&[place], None).unwrap()[0], wanted) < 1e-12);
        assert!((limit.values(0, &[place], None).unwrap()[0] - value).abs() < 1e-9);
        checked += 1;
    }
    assert_eq!(checked, 4);
}

#[test]
fn derivatives_are_differences() {
    let limit = block().limit(RefineRules::Standard, None).unwrap();
    let mut random = Random::new(8);
    let mut task = Task::new().threads(2);
    let all: Vec<Place> = places(&mut random, &limit, 60)
        .into_iter()
        .map(|place| Place { u: place.u.map(|u| 0.1 + 0.8 * u), ..place })
        .collect();
    let (at, slopes) = limit.derivatives(&all, Some(&mut task)).unwrap();
    let (values, value_slopes) = limit.value_derivatives(0, &all, None).unwrap();
    assert_eq!((at.len(), slopes.len(), values.len(), value_slopes.len()), (60, 540, 60, 180));
    assert_eq!(limit.positions(&all, None).unwrap(), at);
    let step = 1e-6;
    for (n, place) in all.iter().enumerate() {
        for by in 0..3 {
            let moved = |to: f64| {
                let mut u = place.u;
                u[by] += to;
                Place { u, ..*place }
            };
            let ends = [moved(step), moved(-step)];
            let p = limit.positions(&ends, None).unwrap();
            let v = limit.values(0, &ends, None).unwrap();
            for axis in 0..3 {
                let wanted = (p[0][axis] - p[1][axis]) / (2.0 * step);
                assert!((slopes[9 * n + 3 * axis + by] - wanted).abs() < 1e-6, "{place:?}");
            }
            let wanted = (v[0] - v[1]) / (2.0 * step);
            assert!((value_slopes[3 * n + by] - wanted).abs() < 1e-4, "{place:?}");
        }
    }
}

#[test]
fn a_locator_finds_the_place_of_a_point() {
    let limit = block().limit(RefineRules::Standard, None).unwrap();
    let report = limit.check(None).unwrap();
    assert_eq!(report.inverted, 0);
    let all = places(&mut Random::new(4), &limit, 100);
    let at = limit.positions(&all, None).unwrap();
    let locator = limit.locator().unwrap();
    let found = locator.find(&at, 0.01, None).unwrap();
    for (point, found) in at.iter().zip(found) {
        let (place, far) = found.unwrap();
        assert!(far < 1e-7 && distance(limit.positions(&[place], None).unwrap()[0], *point) < 1e-7);
    }
    let [low, high] = limit.bounds(None).unwrap();
    assert!(at.iter().all(|p| (0..3).all(|axis| p[axis] > low[axis] - 1e-9 && p[axis] < high[axis] + 1e-9)));
    assert_eq!(locator.find(&[[-50.0; 3]], 1.0, None).unwrap(), [None]);
    assert_eq!(locator.find(&[[f64::NAN; 3]], 1.0, None).unwrap_err().kind(), ErrorKind::Argument);
}

#[test]
fn refinement_is_its_stencils_and_follows_the_cage() {
    let mut cage = block();
    let mut fine = cage.refined(2, RefineRules::Standard, Some(&mut Task::new().threads(2))).unwrap();
    cage.map_positions(|at| [at[0] + 0.01 * at[1] * at[1], at[1] - 0.2, at[2]]).unwrap();
    let values: Vec<f64> = (0..343).map(|n| f64::from(n % 17)).collect();
    cage.set_values(0, 0, &values).unwrap();
    fine.update_positions(cage.positions(), None).unwrap();
    fine.update_values(0, cage.values(0).unwrap(), None).unwrap();
    let again = cage.refined(2, RefineRules::Standard, None).unwrap();
    assert_eq!(fine.view(2).unwrap(), again.view(2).unwrap());
    let view = fine.view(2).unwrap();
    assert_eq!(view.cell_count(), 216 * 64);
    for point in (0..view.positions.len()).step_by(97) {
        let stencil = fine.stencil(2, point).unwrap();
        assert!((stencil.iter().map(|one| one.1).sum::<f64>() - 1.0).abs() < 1e-12);
        let mut wanted = [0.0; 3];
        let mut value = 0.0;
        for (from, w) in stencil {
            (0..3).for_each(|axis| wanted[axis] += w * cage.positions()[from as usize][axis]);
            value += w * values[from as usize];
        }
        assert!(distance(view.positions[point], wanted) < 1e-11);
        assert!((view.channels[0].values[point] - value).abs() < 1e-10);
    }
}

#[test]
fn tetrahedra_fill_the_solid() {
    let fine = block().refined(1, RefineRules::Standard, None).unwrap();
    let tets = Tets::of_refinement(&fine, 1).unwrap();
    let view = tets.view();
    let volume: f64 = view
        .corners
        .iter()
        .map(|corners| {
            let p = corners.map(|corner| view.positions[corner as usize]);
            let d = [1, 2, 3].map(|n| [0, 1, 2].map(|axis: usize| p[n][axis] - p[0][axis]));
            let cross = |a: [f64; 3], b: [f64; 3], i: usize| {
                a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3]
            };
            (0..3).map(|i| cross(d[0], d[1], i) * d[2][i]).sum::<f64>() / 6.0
        })
        .sum();
    let report = tets.check().unwrap();
    assert!((report.volume_mm3 - volume).abs() < 1e-8 && volume > 1000.0, "{volume}");
    assert_eq!((report.inverted, report.crowded_faces), (0, 0));
    // A copy of the arrays is the same, and can be changed.
    let mut copy = Tets::new(&view).unwrap();
    assert_eq!(copy.view(), view);
    copy.set_values(0, 3, &[7.0, 8.0]).unwrap();
    assert_eq!(copy.view().channels[0].values[3..5], [7.0, 8.0]);
    assert_eq!(copy.set_values(0, 3, &[-1.0]).unwrap_err().kind(), ErrorKind::Argument);
    assert_eq!(copy.set_values(1, 0, &[1.0]).unwrap_err().kind(), ErrorKind::Argument);
    assert_eq!(Tets::of_refinement(&fine, 2).unwrap_err().kind(), ErrorKind::Argument);
    let inside_out = TetsView { corners: &[[0, 2, 1, 3]], channels: Vec::new(), ..view };
    assert!(Tets::new(&inside_out).is_ok());
    let short = TetsView { channels: vec![Channel::of_points(Property::young(), &[1.0])], ..inside_out };
    assert_eq!(Tets::new(&short).unwrap_err().kind(), ErrorKind::Shape);
    let beyond = TetsView { corners: &[[0, 1, 2, u32::MAX]], channels: Vec::new(), ..short };
    let error = Tets::new(&beyond).unwrap_err();
    assert!(error.kind() == ErrorKind::Argument && error.message().contains("4294967295"), "{error}");
}

#[test]
fn exchange_files_are_written_and_read_or_refused() {
    let fine = block().refined(1, RefineRules::Standard, None).unwrap();
    let tets = Tets::of_refinement(&fine, 1).unwrap();
    let mut file = Vec::new();
    let written = unsafe { tets.write_exchange(&mut file) };
    let read = |bytes: &[u8]| unsafe { Tets::read_exchange(bytes, 0) };
    if Tets::has_exchange() {
        written.unwrap();
        assert_eq!(read(&file).unwrap().view(), tets.view());
        assert_eq!(read(b"no such file").unwrap_err().kind(), ErrorKind::Format);
    } else {
        assert_eq!(written.unwrap_err().kind(), ErrorKind::Unsupported);
        assert_eq!(read(b"no such file").unwrap_err().kind(), ErrorKind::Unsupported);
    }
}

/// Samples all layers, and holds what solid voxels have against the function that the property is. Few lie
/// within the surface and not within the shape: they have what the nearest place has, or where there is none
/// near, and the report counts them as filled, what a neighbour has.
fn sampled(mut sampler: Sampler<'_>, lattice: &Lattice) -> Grid {
    let mut grid = Grid::new(lattice).unwrap();
    let (nz, ny, nx) = lattice.shape();
    let (mut outside, mut filled) = (0, 0);
    for k in (0..nz).rev() {
        let mut values = vec![f64::NAN; ny * nx];
        sampler.slice(k as u32, grid.slice_mut(k as u32), &mut values).unwrap();
        let z = lattice.layer_bottom(k as u32).unwrap() + 0.5 * lattice.layer_height(k as u32).unwrap();
        for (n, value) in values.into_iter().enumerate() {
            let solid = grid.get(k as u32, (n / nx) as u32, (n % nx) as u32);
            let wanted = if solid { 100.0 * (z + 1.0) } else { 0.0 };
            let off = (value - wanted).abs();
            assert!(off < 60.0, "layer {k} voxel {n}: {value} and {wanted}");
            outside += u64::from(off > 1e-5);
            filled += u64::from(off > 100.0 * 0.02 * 0.25);
        }
    }
    let report = sampler.report().unwrap();
    assert_eq!(report.solid, grid.count());
    assert!(filled <= report.filled && outside < grid.count() / 1000, "{outside}, {filled} of {report:?}");
    grid
}

#[test]
fn samples_are_what_the_property_is_at_the_voxel() {
    let cage = block();
    let limit = cage.limit(RefineRules::Standard, None).unwrap();
    let [low, high] = limit.bounds(None).unwrap();
    let lattice = Lattice::around(low, high, 0.3, 0.25, 1).unwrap();
    let sampler = Sampler::of_limit(&limit, &lattice, Some(0.02), &[0], None).unwrap();
    assert!(sampler.surface().error_mm <= 0.02 * 0.25);
    let mesh = libsf::Mesh::new(sampler.surface().vertices, sampler.surface().faces).unwrap();
    assert!(mesh.topology().unwrap().closed);
    let of_limit = sampled(sampler, &lattice);
    let volume = of_limit.count() as f64 * 0.3 * 0.3 * 0.25;
    let measured = mesh.measure().unwrap().volume_mm3;
    assert!((volume / measured - 1.0).abs() < 0.01, "{volume} and {measured}");

    // Tetrahedra of two steps are nearly the same solid, and the property is linear in them as well.
    let fine = cage.refined(2, RefineRules::Standard, None).unwrap();
    let tets = Tets::of_refinement(&fine, 2).unwrap();
    let mut of_tets = sampled(Sampler::of_tets(&tets, &lattice, &[0]).unwrap(), &lattice);
    of_tets.xor(&of_limit).unwrap();
    assert!(of_tets.count() < of_limit.count() / 25, "{} differ", of_tets.count());
}

#[test]
fn what_does_not_fit_is_refused() {
    let kind = |error: libsf::Error| error.kind();
    let mut cage = block();
    let view = cage.view();
    let cut = CageView { starts: &[0, 8, 4, 16], ..view.clone() };
    assert_eq!(kind(Cage::new(&cut).unwrap_err()), ErrorKind::Shape);
    for starts in [&[][..], &[0], &[0, 8], &[1, 1728], &[0, 1729]] {
        let view = CageView { starts, ..view.clone() };
        assert_eq!(kind(Cage::new(&view).unwrap_err()), ErrorKind::Shape, "{starts:?}");
    }
    let few = CageView { positions: &view.positions[1..], ..view.clone() };
    assert_eq!(kind(Cage::new(&few).unwrap_err()), ErrorKind::Shape);
    let few = CageView { channels: Vec::new(), ..few };
    assert_eq!(kind(Cage::new(&few).unwrap_err()), ErrorKind::Argument);
    let long = Property { name: "x".repeat(48), ..Property::young() };
    assert_eq!(kind(Property::named(&long.name).unwrap_err()), ErrorKind::Argument);
    assert_eq!(kind(Property::named("").unwrap_err()), ErrorKind::Argument);
    assert_eq!(
        kind(cage.add_property(&Channel::of_points(long, &[1.0; 343])).unwrap_err()),
        ErrorKind::Argument
    );
    let short = Channel::of_points(Property::young(), &[1.0; 342]);
    assert_eq!(kind(cage.add_property(&short).unwrap_err()), ErrorKind::Shape);
    let indices = Channel { values: &[1.0], indices: Some(&[0; 8]), ..short };
    assert_eq!(kind(cage.add_property(&indices).unwrap_err()), ErrorKind::Shape);
    let twice = Channel::of_points(Property::density(), &[1.0; 343]);
    assert_eq!(kind(cage.add_property(&twice).unwrap_err()), ErrorKind::Argument);
    assert_eq!(kind(cage.set_positions(343, &[[0.0; 3]]).unwrap_err()), ErrorKind::Argument);
    assert_eq!(kind(cage.set_values(0, usize::MAX, &[1.0]).unwrap_err()), ErrorKind::Argument);
    assert_eq!(kind(cage.set_values(1, 0, &[]).unwrap_err()), ErrorKind::Argument);
    assert_eq!(kind(cage.values(1).unwrap_err()), ErrorKind::Argument);
    assert_eq!(kind(cage.paint(0, &[1.0; 342], PaintOperation::Add, 1.0).unwrap_err()), ErrorKind::Shape);
    assert_eq!(kind(cage.drag(&[2.0; 343], [1.0; 3]).unwrap_err()), ErrorKind::Argument);
    assert_eq!(kind(cage.refined(13, RefineRules::Standard, None).unwrap_err()), ErrorKind::Argument);
    assert_eq!(kind(cage.limit(RefineRules::Other(9), None).unwrap_err()), ErrorKind::Argument);
    let mut fine = cage.refined(1, RefineRules::Standard, None).unwrap();
    assert_eq!(kind(fine.update_positions(&[[0.0; 3]; 342], None).unwrap_err()), ErrorKind::Shape);
    assert_eq!(kind(fine.update_values(0, &[0.0; 344], None).unwrap_err()), ErrorKind::Shape);
    assert_eq!(kind(fine.update_values(1, &[0.0; 343], None).unwrap_err()), ErrorKind::Argument);
    assert_eq!(kind(fine.stencil(2, 0).unwrap_err()), ErrorKind::Argument);
    let mut limit = cage.limit(RefineRules::Standard, None).unwrap();
    assert_eq!(kind(limit.update_positions(&[[0.0; 3]; 342], None).unwrap_err()), ErrorKind::Shape);
    assert_eq!(kind(limit.update_values(0, &[0.0; 344], None).unwrap_err()), ErrorKind::Shape);
    assert_eq!(kind(limit.update_values(1, &[0.0; 343], None).unwrap_err()), ErrorKind::Argument);
    assert_eq!(kind(limit.place(216, [0.0; 3]).unwrap_err()), ErrorKind::Argument);
    let nowhere = Place { piece: u32::MAX, u: [0.5; 3] };
    assert_eq!(kind(limit.positions(&[nowhere], None).unwrap_err()), ErrorKind::Argument);
    let lattice = Lattice::new(8, 8, 8, 0.5, 0.5).unwrap();
    assert_eq!(kind(Sampler::of_limit(&limit, &lattice, None, &[1], None).unwrap_err()), ErrorKind::Argument);
    assert_eq!(
        kind(Sampler::of_limit(&limit, &lattice, Some(0.0), &[0], None).unwrap_err()),
        ErrorKind::Argument
    );
    let mut sampler = Sampler::of_limit(&limit, &lattice, None, &[0], None).unwrap();
    let mut grid = Grid::new(&lattice).unwrap();
    assert_eq!(kind(sampler.slice(0, grid.slice_mut(0), &mut [0.0; 63]).unwrap_err()), ErrorKind::Shape);
    assert_eq!(kind(sampler.slice(8, grid.slice_mut(0), &mut [0.0; 64]).unwrap_err()), ErrorKind::Argument);
    cage.remove_property(0).unwrap();
    assert_eq!(kind(cage.remove_property(0).unwrap_err()), ErrorKind::Argument);
}

#[test]
fn brushes_fall_off_as_they_say() {
    let cage = block();
    let [from, to] = [[2.0, 3.0, 4.0], [9.0, 3.0, 8.0]];
    let along: f64 = (0..3).map(|i| (to[i] - from[i]) * (to[i] - from[i])).sum();
    type Function = fn(f64) -> f64;
    let falloffs: [(Falloff, Function); 4] = [
        (Falloff::Constant, |_| 1.0),
        (Falloff::Linear, |t| 1.0 - t),
        (Falloff::Smooth, |t| 1.0 - 3.0 * t * t + 2.0 * t * t * t),
        (Falloff::Gaussian, |t| ((-4.5 * t * t).exp() - (-4.5f64).exp()) / (1.0 - (-4.5f64).exp())),
    ];
    for (falloff, function) in falloffs {
        let brush = PaintBrush { to_mm: to, strength: 0.8, falloff, ..PaintBrush::ball(from, 4.0) };
        let mut weights = vec![0.0; 343];
        let touched = cage.select(&brush, &mut weights).unwrap();
        assert_eq!(touched, weights.iter().filter(|&&w| w > 0.0).count());
        assert!(touched > 20 && touched < 340);
        for (at, weight) in cage.positions().iter().zip(&weights) {
            let s: f64 = (0..3).map(|i| (at[i] - from[i]) * (to[i] - from[i])).sum::<f64>() / along;
            let s = s.clamp(0.0, 1.0);
            let middle = [0, 1, 2].map(|i| from[i] + s * (to[i] - from[i]));
            let t = distance(*at, middle) / 4.0;
            let wanted = if t <= 1.0 { 0.8 * function(t) } else { 0.0 };
            assert!((weight - wanted).abs() < 1e-9, "{falloff:?} {t} {weight} {wanted}");
        }
    }
    let mut inside = vec![0.0; 343];
    let all = PaintBrush { place: PaintWhere::Inside, ..PaintBrush::ball([0.0; 3], f64::INFINITY) };
    assert_eq!(cage.select(&all, &mut inside).unwrap(), 125);
}

#[test]
fn a_history_gives_the_same_bits() {
    let bits = |cage: &Cage| -> Vec<u64> {
        let (places, values) = (cage.positions().iter().flatten(), cage.values(0).unwrap());
        places.chain(values).map(|x| x.to_bits()).collect()
    };
    let mut cage = block();
    let mut history = CageHistory::new(&cage, 1 << 20).unwrap();
    let mut states = vec![bits(&cage)];
    for i in 0..8 {
        let mut weights = vec![0.0; 343];
        let at = [1.5 * f64::from(i), 6.0, 12.0 - f64::from(i)];
        cage.select(&PaintBrush::ball(at, 4.0), &mut weights).unwrap();
        match i % 4 {
            0 => cage.paint(0, &weights, PaintOperation::Set, 10.0).unwrap(),
            1 => cage.paint(0, &weights, PaintOperation::Smooth, 0.7).unwrap(),
            2 => cage.drag(&weights, [0.1, 0.2, 0.3]).unwrap(),
            _ => cage.smooth(&weights, 0.5).unwrap(),
        };
        assert!(history.record(&cage).unwrap() > 0);
        states.push(bits(&cage));
    }
    assert_eq!((history.state().undo_count, history.record(&cage).unwrap()), (8, 0));
    for wanted in states.iter().rev().skip(1) {
        assert!(history.undo(&mut cage).unwrap() > 0);
        assert!(bits(&cage) == *wanted);
    }
    assert_eq!(history.undo(&mut cage).unwrap(), 0);
    for wanted in &states[1..] {
        assert!(history.redo(&mut cage).unwrap() > 0);
        assert!(bits(&cage) == *wanted);
    }
    let mut other = Cage::block([1; 3], [0.0; 3], [1.0; 3]).unwrap();
    assert_eq!(history.undo(&mut other).unwrap_err().kind(), ErrorKind::Shape);
}

#[test]
fn functions_of_the_place_may_panic() {
    let mut cage = block();
    let before = cage.try_clone().unwrap();
    let mut calls = 0;
    let mut stop = || {
        calls += 1;
        assert!(calls < 10, "no more");
    };
    let moved = catch_unwind(AssertUnwindSafe(|| {
        cage.map_positions(|at| {
            stop();
            at.map(|x| x + 1.0)
        })
    }));
    assert_eq!(moved.unwrap_err().downcast_ref::<&str>(), Some(&"no more"));
    let painted = catch_unwind(AssertUnwindSafe(|| {
        cage.map_values(0, |_, value| {
            assert!(value.is_nan(), "never");
            value
        })
    }));
    assert!(painted.is_err());
    assert_eq!(cage.view(), before.view());
    assert_eq!(cage.map_values(0, |_, _| -1.0).unwrap_err().kind(), ErrorKind::Argument);
    assert_eq!(cage.map_positions(|_| [f64::NAN; 3]).unwrap_err().kind(), ErrorKind::Argument);
    assert_eq!(cage.view(), before.view());
    cage.map_values(0, |at, was| at[0].abs() + 0.0 * was).unwrap();
    let wanted: Vec<f64> = cage.positions().iter().map(|at| at[0].abs()).collect();
    assert_eq!(cage.values(0).unwrap(), wanted);
}

#[test]
fn simple_shapes_have_their_volumes() {
    let square = [[1.0, 0.0, 0.0], [3.0, 0.0, 0.0], [3.0, 0.0, 2.0], [1.0, 0.0, 2.0]];
    let face = CageView { dimension: 2, ..CageView::new(&square, &[0, 4], &[0, 1, 2, 3]) };
    let face = Cage::new(&face).unwrap();
    let bar = face.extruded([0.0, -5.0, 0.0], 4).unwrap();
    let report = bar.check().unwrap();
    assert_eq!((bar.view().cell_count(), report.inverted_cells, report.components), (4, 0, 1));
    assert!((report.volume_mm3 - 20.0).abs() < 1e-12);
    // A ring of 12 sides: by Pappus its section times the way of its middle, here along a polygon.
    let ring = face.revolved(12, 2.0 * std::f64::consts::PI).unwrap();
    let area = |r: f64| 6.0 * r * r * (std::f64::consts::PI / 6.0).sin();
    let wanted = 2.0 * (area(3.0) - area(1.0));
    assert!((ring.check().unwrap().volume_mm3 - wanted).abs() < 1e-9, "{wanted}");
    assert_eq!(face.extruded([0.0; 3], 4).unwrap_err().kind(), ErrorKind::Argument);
    assert_eq!(bar.revolved(12, 1.0).unwrap_err().kind(), ErrorKind::Unsupported);
    let nodes = [0.0, 10.0].map(|x| SkeletonNode { at_mm: [x, 0.0, 0.0], half_side_mm: 1.0 });
    let strut = SkeletonStrut { nodes: [0, 1], cells: 4 };
    let dumbbell = Cage::skeleton(&nodes, &[strut]).unwrap();
    assert_eq!(dumbbell.view().cell_count(), 6);
    assert!((dumbbell.check().unwrap().volume_mm3 - 48.0).abs() < 1e-9);
    let twice = Cage::skeleton(&nodes, &[strut, strut]).unwrap_err();
    assert!(twice.kind() == ErrorKind::Unsupported && twice.message().len() > 20, "{twice}");
    let nowhere = Cage::skeleton(&nodes, &[SkeletonStrut { nodes: [0, 2], cells: 4 }]);
    assert_eq!(nowhere.unwrap_err().kind(), ErrorKind::Argument);
}
