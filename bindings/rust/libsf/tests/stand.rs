// SPDX-License-Identifier: MIT
// Why: what bends, carves and makes stand is a chain of calls that each trust the one before. So real bodies
// are made to stand here, and what is said of them is computed a second time from what comes out; and the
// functions of places, which C keeps for long, panic, lie and are dropped.

use libsf::{
    handle_center_by_rays, Ballast, Blend, Body, CarveGoal, CarveMode, CarveOptions, DrainOptions, ErrorKind,
    Grid, Handle, HandleKind, Inside, Lattice, Mesh, PlaceOptions, Pose, PoseChange, RayHit, Rule, Stance,
    StanceKind, StanceOptions, Stand, StandOptions, Task, Terms, VoidsOptions, Weights, WeightsMethod,
    WeightsOptions,
};
use std::panic::{catch_unwind, AssertUnwindSafe};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::Arc;

type Vector = [f64; 3];

/// A foot of 10 x 10 mm with an arm on it that pulls it over.
fn crane() -> Mesh {
    let lattice = Lattice::new(28, 10, 24, 1.0, 1.0).unwrap();
    let grid = Grid::from_fn(&lattice, |layer, _, x| x < 10 || (layer >= 10 && x < 24)).unwrap();
    grid.surface(0, None).unwrap().merged().unwrap()
}

fn coarse() -> StandOptions {
    StandOptions { pitch_mm: 0.5, wall_mm: 1.0, ..StandOptions::default() }
}

fn carving() -> StandOptions {
    StandOptions { deform: false, ..coarse() }
}

/// What a shape weighs: its outside less its cavity, whose triangles look inwards.
fn weight(shape: &Stand<'_>) -> Body {
    let cavity = shape.cavity().unwrap().map_or(Body::default(), |mesh| mesh.body(1.0).unwrap());
    shape.outer().unwrap().body(1.0).unwrap() + cavity
}

#[test]
fn what_is_carved_stands_by_a_second_computation() {
    let mesh = crane();
    let stances = [StanceOptions::default()];
    let mut shape = Stand::new(&mesh, &stances, &[], &carving(), Inside::new(), None).unwrap();
    assert_eq!(shape.grid().unwrap_err().kind(), ErrorKind::Argument);
    let report = shape.run(None).unwrap();
    assert_eq!(shape.report(), report);
    assert!(report.succeeded && report.margin_before_rad < 0.0, "{report:?}");
    let com = weight(&shape).center_of_mass().unwrap();
    assert!((0..3).all(|axis| (com[axis] - report.com_mm[axis]).abs() < 1e-6), "{com:?} {report:?}");
    let stance = Stance::new(&mesh, &stances[0]).unwrap();
    let verdict = stance.judge(com).unwrap();
    assert!(verdict.safe && (verdict.margin_rad - report.margin_rad).abs() < 1e-6, "{verdict:?}");
    assert_eq!(shape.stance(0).unwrap().polygon().unwrap(), stance.polygon().unwrap());
    assert_eq!(shape.stance(1).unwrap_err().kind(), ErrorKind::Argument);
    assert!(shape.density().is_none());
    // What stood without supports but for the arm stands so, too, with a cavity in it.
    let rule = Rule::octagon(std::f64::consts::FRAC_PI_4);
    let grid = shape.grid().unwrap();
    let solid = Grid::from_fn(grid.lattice(), |_, _, _| false).and_then(|mut solid| {
        solid.voxelize(&mesh, libsf::Fill::Auto, None)?;
        Ok(solid)
    });
    let hung = solid.unwrap().unsupported(rule, None).unwrap();
    let mut hangs = grid.unsupported(rule, None).unwrap();
    hangs.subtract(&hung).unwrap();
    assert_eq!((hangs.count(), report.hanging_voxels), (0, 0));
    // It is the same on another thread, and with threads.
    let again = std::thread::scope(|scope| {
        let work = scope.spawn(|| {
            let mut again = Stand::new(&mesh, &stances, &[], &carving(), Inside::new(), None).unwrap();
            let mut task = Task::new().threads(2);
            (again.run(Some(&mut task)).unwrap(), again.grid().unwrap().clone())
        });
        work.join().unwrap()
    });
    assert_eq!(again, (report, grid.clone()));
}

#[test]
fn what_is_bent_stands_too_and_keeps_poses_by_hand() {
    let mesh = crane();
    let grid = mesh.voxelize(0.5, 0.5, None).unwrap();
    let handles = [Handle::point([5.0, 5.0, 17.0]), Handle::point([20.0, 5.0, 17.0])];
    assert!(handles.iter().all(|handle| grid.handle_center(handle.at_mm, [1.0, 0.0, 0.0]).is_ok()));
    let options = StandOptions { carve: false, ..coarse() };
    let mut shape =
        Stand::new(&mesh, &[StanceOptions::default()], &handles, &options, Inside::new(), None).unwrap();
    let report = shape.run(None).unwrap();
    assert!(report.succeeded && report.displacement_mm > 0.1 && report.folded == 0, "{report:?}");
    assert!(shape.cavity().unwrap().is_none());
    let outer = shape.outer().unwrap();
    assert_eq!(outer.faces(), mesh.faces());
    let verdict = shape.stance(0).unwrap().judge(outer.measure().unwrap().com_mm).unwrap();
    assert!(verdict.safe && (verdict.margin_rad - report.margin_rad).abs() < 1e-6);
    assert_ne!(shape.pose(1).unwrap(), Pose::default());
    assert_eq!(shape.pose(2), None);
    // By hand: the arm stays where it is put.
    let by_hand = Pose { scale: 0.8, ..Pose::default() };
    shape.set_pose(1, &by_hand, true).unwrap();
    shape.run(None).unwrap();
    assert_eq!(shape.pose(1), Some(by_hand));
    assert_eq!(shape.set_pose(2, &by_hand, true).unwrap_err().kind(), ErrorKind::Argument);
    let nothing = Pose { scale: f64::NAN, ..by_hand };
    assert_eq!(shape.set_pose(0, &nothing, false).unwrap_err().kind(), ErrorKind::Argument);
    assert_eq!(shape.pose(1), Some(by_hand));
    let outside = [Handle::point([500.0; 3])];
    let refused = Stand::new(&mesh, &[StanceOptions::default()], &outside, &options, Inside::new(), None);
    let refused = refused.unwrap_err();
    assert_eq!(refused.kind(), ErrorKind::Infeasible);
    assert!(refused.message().contains("handle"), "{refused}");
}

#[test]
fn fields_and_ballast_weigh_and_keep() {
    let mesh = crane();
    let asked = Arc::new(AtomicUsize::new(0));
    let here = asked.clone();
    let heavy = move |place: Vector| {
        here.fetch_add(1, Ordering::Relaxed);
        if place[2] < 5.0 {
            2.0
        } else {
            1.0
        }
    };
    let kept = |place: Vector| place[0] > 20.0;
    let inside =
        Inside::new().density(heavy).keep(kept).ballast(&[Ballast { mass: 100.0, at_mm: [2.0, 5.0, 2.0] }]);
    let mut shape = Stand::new(&mesh, &[StanceOptions::default()], &[], &carving(), inside, None).unwrap();
    let report = shape.run(None).unwrap();
    assert!(asked.load(Ordering::Relaxed) > 1000);
    // As it was given: the foot twice as heavy as the rest, and the ballast.
    let foot = Body { mass: 500.0, moment: [500.0 * 5.0, 500.0 * 5.0, 500.0 * 2.5] };
    let whole =
        mesh.body(1.0).unwrap() + foot + Body::of_ballast(&[Ballast { mass: 100.0, at_mm: [2.0, 5.0, 2.0] }]);
    let com = whole.center_of_mass().unwrap();
    assert!((0..3).all(|axis| (com[axis] - report.com_before_mm[axis]).abs() < 1e-6), "{com:?} {report:?}");
    let grid = shape.grid().unwrap();
    let density = shape.density().unwrap();
    let (_, ny, nx) = grid.lattice().shape();
    let origin = grid.lattice().origin_mm();
    let mut looked_at = 0;
    for (i, solid) in grid.to_bools().into_iter().enumerate() {
        let place = [i % nx, i / nx % ny, i / nx / ny];
        let at = [0, 1, 2].map(|axis| origin[axis] + 0.5 * (place[axis] as f64 + 0.5));
        let within =
            at[0] > 20.0 && at[0] < 24.0 && at[1] > 0.0 && at[1] < 10.0 && at[2] > 10.0 && at[2] < 24.0;
        if within {
            assert!(solid, "{at:?} must stay");
            looked_at += 1;
        }
        if solid {
            assert_eq!(density[i], if at[2] < 5.0 { 2.0 } else { 1.0 }, "{at:?}");
        }
    }
    assert_eq!(looked_at, 8 * 20 * 28);
    drop(shape);
    assert_eq!(Arc::strong_count(&asked), 1, "the field was dropped with the shape");
}

#[test]
fn fields_that_panic_or_lie_leave_the_shape_as_it_was() {
    let mesh = crane();
    let stances = [StanceOptions::default()];
    for lie in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let inside = Inside::new().density(move |_| lie);
        let refused = Stand::new(&mesh, &stances, &[], &carving(), inside, None);
        assert_eq!(refused.unwrap_err().kind(), ErrorKind::Argument, "{lie}");
    }
    let panicking = Inside::new().density(|_| panic!("how should I know"));
    let panic = catch_unwind(AssertUnwindSafe(|| {
        Stand::new(&mesh, &stances, &[], &carving(), panicking, None).map(|_| ())
    }));
    assert_eq!(*panic.unwrap_err().downcast_ref::<&str>().unwrap(), "how should I know");

    let bad = Arc::new(AtomicUsize::new(1));
    let here = bad.clone();
    let keep = move |_: Vector| {
        assert!(here.load(Ordering::Relaxed) == 0, "not now");
        false
    };
    let mut shape = Stand::new(&mesh, &stances, &[], &carving(), Inside::new().keep(keep), None).unwrap();
    let before = shape.report();
    for _ in 0..2 {
        let panic = catch_unwind(AssertUnwindSafe(|| shape.round(None).map(|_| ())));
        assert_eq!(*panic.unwrap_err().downcast_ref::<&str>().unwrap(), "not now");
        assert_eq!(shape.report(), before);
        assert!(shape.grid().is_err());
    }
    // A task that somebody else has is stopped by it.
    let mut task = Task::new();
    assert!(catch_unwind(AssertUnwindSafe(|| shape.round(Some(&mut task)).map(|_| ()))).is_err());
    assert!(task.is_cancelled());
    bad.store(0, Ordering::Relaxed);
    assert!(shape.run(None).unwrap().succeeded);
    // A cancel leaves it as it is, too.
    let after = shape.report();
    assert_eq!(shape.round(Some(&mut task)).unwrap_err().kind(), ErrorKind::Cancelled);
    assert_eq!(shape.report(), after);
}

#[test]
fn a_shape_may_hang() {
    let mesh = crane();
    let hangs = StanceOptions {
        kind: StanceKind::Hang,
        point_mm: [12.0, 5.0, 24.0],
        tolerance_rad: 0.05,
        ..StanceOptions::default()
    };
    let mut shape = Stand::new(&mesh, &[hangs], &[], &carving(), Inside::new(), None).unwrap();
    let report = shape.run(None).unwrap();
    let com = weight(&shape).center_of_mass().unwrap();
    let askew = (com[0] - 12.0).hypot(com[1] - 5.0).atan2(24.0 - com[2]);
    assert!((report.margin_rad + askew).abs() < 1e-6, "{report:?} {askew}");
    assert!(report.margin_rad > report.margin_before_rad);
    assert_eq!(report.succeeded, askew <= 0.05);
    let none = Stand::new(&mesh, &[], &[], &carving(), Inside::new(), None).unwrap_err();
    assert_eq!(none.kind(), ErrorKind::Argument);
}

/// A bar of 20 x 4 x 4 mm, and handles at its ends and in its middle.
fn bar() -> (Grid, [Handle<'static>; 3]) {
    let on = Lattice::new(40, 8, 8, 0.5, 0.5).unwrap();
    let at = |x: f64| Handle::point([x, 1.75, 1.75]);
    (Grid::from_fn(&on, |_, _, _| true).unwrap(), [at(1.75), at(9.75), at(17.75)])
}

#[test]
fn weights_add_up_and_change_as_they_say() {
    let (solid, handles) = bar();
    for method in [WeightsMethod::Clamped, WeightsMethod::Bounded] {
        let options = WeightsOptions { method, ..WeightsOptions::default() };
        let weights = Weights::new(&solid, &handles, &options, None).unwrap();
        assert_eq!((weights.facts().handle_count, weights.facts().loose_count), (3, 0));
        assert_eq!(weights.centers(), handles.map(|handle| handle.at_mm));
        for i in 0..50 {
            let p = [0.613 + 0.37 * f64::from(i), 1.1, 2.3];
            let (w, gradient) = weights.at(p).unwrap();
            assert!((w.iter().sum::<f64>() - 1.0).abs() < 1e-12);
            assert!(w.iter().all(|one| (0.0..=1.0).contains(one)));
            let step = 1e-6;
            let more = weights.sample(&[[p[0] + step, p[1], p[2]], [p[0] - step, p[1], p[2]]], None).unwrap();
            for (j, slope) in gradient.iter().enumerate() {
                let seen = (more[j] - more[3 + j]) / (2.0 * step);
                assert!((seen - slope[0]).abs() < 1e-6, "{p:?}, handle {j}: {seen} and not {}", slope[0]);
            }
        }
    }
    let options = WeightsOptions::default();
    let outside = Weights::new(&solid, &[Handle::point([99.0; 3])], &options, None).unwrap_err();
    assert_eq!(outside.kind(), ErrorKind::Infeasible);
    assert!(outside.message().contains("handle"), "{outside}");
    assert_eq!(Weights::new(&solid, &[], &options, None).unwrap_err().kind(), ErrorKind::Argument);
    let other = Grid::new(&Lattice::new(3, 3, 3, 1.0, 1.0).unwrap()).unwrap();
    assert_eq!(Handle::base(&other).unwrap_err().kind(), ErrorKind::Argument);
    let foot = solid.foot([-1.0, 0.0, 0.0], 0.0).unwrap();
    assert_eq!((foot.count(), foot.bounds().x0), (64, 39));
    let base = Handle::base(&foot).unwrap();
    assert_eq!((base.kind(), base.locked, base.at_mm), (HandleKind::Base, true, [19.75, 2.0, 2.0]));
    let held = Weights::new(&solid, &[base, handles[0]], &options, None).unwrap();
    assert_eq!(held.at([19.8, 0.1, 3.9]).unwrap().0, [1.0, 0.0]);
    let pair = Weights::new(&solid, &[base, Handle::ball([19.0, 2.0, 2.0], 1.0)], &options, None);
    assert_eq!(pair.unwrap_err().kind(), ErrorKind::Infeasible);
}

#[test]
fn blends_are_the_formula_and_their_derivatives_agree() {
    let (solid, handles) = bar();
    let weights = Weights::new(&solid, &handles, &WeightsOptions::default(), None).unwrap();
    let points: Vec<Vector> = (0..60).map(|i| [0.4 + 0.31 * f64::from(i), 0.9, 2.6]).collect();
    let blend = Blend::new(&weights, &points, None).unwrap();
    assert_eq!(blend.rest(), points);
    let turn = PoseChange { scale: 0.1, shift_mm: [0.0, 0.3, 1.0], spin_rad: [0.0, 0.4, 0.1] };
    let poses =
        [Pose::default(), Pose::default().moved(&turn).unwrap(), Pose { scale: 0.9, ..Pose::default() }];
    let bent = blend.apply(&poses, None).unwrap();
    let w = weights.sample(&points, None).unwrap();
    for (i, p) in points.iter().enumerate() {
        let mut expected = [0.0; 3];
        for (j, pose) in poses.iter().enumerate() {
            let c = handles[j].at_mm;
            for (row, to) in expected.iter_mut().enumerate() {
                let turned: f64 = (0..3).map(|k| pose.turn[3 * row + k] * (p[k] - c[k])).sum();
                *to += w[3 * i + j] * (pose.scale * turned + c[row] + pose.shift_mm[row]);
            }
        }
        assert!((0..3).all(|axis| (expected[axis] - bent[i][axis]).abs() < 1e-12), "point {i}");
    }
    let step = 1e-6;
    let change = |by: f64| PoseChange {
        scale: 0.2 * by,
        shift_mm: [0.5 * by, -by, 0.1 * by],
        spin_rad: [0.3 * by, 0.2 * by, -0.7 * by],
    };
    let moved = |by: f64| {
        let poses: Vec<Pose> = poses.iter().map(|pose| pose.moved(&change(by)).unwrap()).collect();
        blend.apply(&poses, None).unwrap()
    };
    let moves = blend.push(&poses, &[change(1.0); 3], None).unwrap();
    for (i, (more, less)) in moved(step).iter().zip(&moved(-step)).enumerate() {
        for axis in 0..3 {
            let seen = (more[axis] - less[axis]) / (2.0 * step);
            assert!((seen - moves[i][axis]).abs() < 1e-6, "point {i}: {seen} and not {}", moves[i][axis]);
        }
    }
    // The transpose: both sums are one number.
    let gradient: Vec<Vector> = (0..60).map(|i| [f64::from(i % 7) - 3.0, 0.5, f64::from(i % 3)]).collect();
    let pulled = blend.pull(&poses, &gradient, None).unwrap();
    let one: f64 = moves.iter().zip(&gradient).flat_map(|(m, g)| (0..3).map(|axis| m[axis] * g[axis])).sum();
    let part = |c: &PoseChange| {
        let of = change(1.0);
        let turns =
            (0..3).map(|axis| c.shift_mm[axis] * of.shift_mm[axis] + c.spin_rad[axis] * of.spin_rad[axis]);
        c.scale * of.scale + turns.sum::<f64>()
    };
    let other: f64 = pulled.iter().map(part).sum();
    assert!((one - other).abs() < 1e-9 * one.abs().max(1.0), "{one} {other}");

    let back = weights.unbend(&bent, &poses, 1e-9, None, None).unwrap();
    assert_eq!(back.missed, 0);
    assert!(back.residual_mm.iter().all(|&off| off <= 1e-9));
    for (found, p) in back.rest_mm.iter().zip(&points) {
        assert!((0..3).all(|axis| (found[axis] - p[axis]).abs() < 1e-6), "{found:?} {p:?}");
    }
    let fold = weights.fold(&poses, None).unwrap();
    assert!(fold.folded == 0 && fold.least_det > 0.0 && fold.places > 0);
    let past = [Pose { shift_mm: [30.0, 0.0, 0.0], ..Pose::default() }, Pose::default(), Pose::default()];
    assert!(weights.fold(&past, None).unwrap().folded > 0);

    let kind = |made: libsf::Result<Vec<Vector>>| made.unwrap_err().kind();
    assert_eq!(kind(blend.apply(&poses[1..], None)), ErrorKind::Shape);
    assert_eq!(kind(blend.push(&poses, &[change(1.0)], None)), ErrorKind::Shape);
    assert_eq!(blend.pull(&poses, &gradient[1..], None).unwrap_err().kind(), ErrorKind::Shape);
    let guesses = weights.unbend(&bent, &poses, 1e-9, Some(&points[1..]), None);
    assert_eq!(guesses.unwrap_err().kind(), ErrorKind::Shape);
}

#[test]
fn handles_find_their_places() {
    let (solid, _) = bar();
    let foot = solid.foot([0.0, 0.0, 1.0], 0.0).unwrap();
    let options = PlaceOptions { count: 3, base: Some(&foot), ball: 0.5, ..PlaceOptions::default() };
    let found = solid.place_handles(&options, None).unwrap();
    assert!(!found.is_empty() && found.len() <= 3);
    for handle in &found {
        assert_eq!((handle.kind(), handle.locked), (HandleKind::Ball, false));
        assert!(handle.at_mm[2] > 1.0 && handle.radius_mm > 0.0, "{handle:?}");
    }
    let centre = solid.handle_center([5.1, -3.0, 2.2], [0.0, 2.0, 0.0]).unwrap();
    assert!((0..3).all(|axis| (centre[axis] - [5.1, 2.0, 2.2][axis]).abs() < 1e-9), "{centre:?}");
    let past = solid.handle_center([5.1, -3.0, 2.2], [0.0, -1.0, 0.0]).unwrap_err();
    assert_eq!(past.kind(), ErrorKind::Infeasible);
    let many = PlaceOptions { count: 65, ..PlaceOptions::default() };
    assert_eq!(solid.place_handles(&many, None).unwrap_err().kind(), ErrorKind::Argument);
    let mesh = crane();
    let grid = mesh.voxelize(0.7, 0.7, None).unwrap();
    let covered = grid.cover(&mesh, None).unwrap();
    let mut both = grid.clone();
    both.or(&covered).unwrap();
    assert!(both == covered && covered.count() > grid.count());
}

#[test]
fn rays_of_the_callers_find_a_centre() {
    // A ball of radius 3 around (1, 2, 3).
    let ball = |from: Vector, direction: Vector, beyond: f64| {
        let to = [1.0, 2.0, 3.0];
        let (mut square, mut half, mut rest) = (0.0, 0.0, -9.0);
        for axis in 0..3 {
            let off = from[axis] - to[axis];
            square += direction[axis] * direction[axis];
            half += direction[axis] * off;
            rest += off * off;
        }
        let root = (half * half - square * rest).sqrt();
        let hits = [(-1.0, false), (1.0, true)];
        let hits =
            hits.map(|(sign, leaves)| RayHit { along: (sign * root - half) / square, triangle: 0, leaves });
        hits.into_iter().find(|hit| hit.along > beyond)
    };
    let centre = handle_center_by_rays(ball, [-9.0, 2.0, 3.0], [0.5, 0.0, 0.0]).unwrap();
    assert!((0..3).all(|axis| (centre[axis] - [1.0, 2.0, 3.0][axis]).abs() < 1e-12), "{centre:?}");
    let past = handle_center_by_rays(ball, [-9.0, 2.0, 3.0], [-0.5, 0.0, 0.0]).unwrap_err();
    assert_eq!(past.kind(), ErrorKind::Infeasible);
    let back = RayHit { along: -1.0, triangle: 0, leaves: false };
    let wrong = handle_center_by_rays(|_, _, _| Some(back), [0.0; 3], [1.0, 0.0, 0.0]).unwrap_err();
    assert_eq!(wrong.kind(), ErrorKind::Internal);
    let panic = catch_unwind(|| handle_center_by_rays(|_, _, _| panic!("no rays"), [0.0; 3], [1.0; 3]));
    assert_eq!(*panic.unwrap_err().downcast_ref::<&str>().unwrap(), "no rays");
}

#[test]
fn a_cavity_leaves_its_wall_and_weighs_as_it_says() {
    let on = Lattice::new(30, 30, 30, 0.5, 0.5).unwrap();
    let block = Grid::from_fn(&on, |layer, y, x| [layer, y, x].iter().all(|i| (1..29).contains(i))).unwrap();
    let mesh = block.surface(0, None).unwrap();
    let wall = block.wall(&mesh, 1.5, None).unwrap();
    assert_eq!(wall, block.wall_inside(1.5, None).unwrap());
    let deep = |i: u32| (4..26).contains(&i);
    let expected =
        Grid::from_fn(&on, |layer, y, x| block.get(layer, y, x) && !(deep(layer) && deep(y) && deep(x)));
    assert_eq!(wall, expected.unwrap());

    let rule = Rule::octagon(std::f64::consts::FRAC_PI_4);
    let (hollow, report) = block.carve(&wall, rule, &CarveOptions::default(), None).unwrap();
    assert_eq!(hollow.unsupported(rule, None).unwrap().count(), 0);
    assert!(report.safe && report.floating_pieces == 0, "{report:?}");
    assert_eq!(report.solid_voxels, hollow.count() + report.removed_voxels);
    assert_eq!(report.after, hollow.body(None, None).unwrap());
    let mut cavity = block.clone();
    cavity.subtract(&hollow).unwrap();
    assert!((cavity.clearance(&mesh, None).unwrap() - 1.5).abs() < 1e-9);

    // To one side of the middle: a half-space that the stance of a smaller foot asks for.
    let options = StanceOptions {
        region_low_mm: [0.0, 0.0, 0.0],
        region_high_mm: [7.5, 20.0, 20.0],
        ..StanceOptions::default()
    };
    let stance = Stance::new(&mesh, &options).unwrap();
    let com = block.body(None, None).unwrap().center_of_mass().unwrap();
    assert!(!stance.judge(com).unwrap().safe);
    for (mode, goal) in [(CarveMode::SupportFree, CarveGoal::Enough), (CarveMode::Plane, CarveGoal::Deepest)]
    {
        let options = CarveOptions { mode, goal, stances: &[&stance], ..CarveOptions::default() };
        let (carved, report) = block.carve(&wall, rule, &options, None).unwrap();
        let com = carved.body(None, None).unwrap().center_of_mass().unwrap();
        let verdict = stance.judge(com).unwrap();
        assert_eq!(verdict.safe, report.safe, "{mode:?}");
        assert!((verdict.slack_mm - report.slack_mm).abs() < 1e-9, "{mode:?}");
        assert!(report.safe && report.slack_before_mm < 0.0, "{mode:?} {report:?}");
    }
    let too_much =
        block.carve(&Grid::from_fn(&on, |_, _, _| true).unwrap(), rule, &CarveOptions::default(), None);
    assert_eq!(too_much.unwrap_err().kind(), ErrorKind::Infeasible);
    let short = CarveOptions { density: Some(&[1.0]), ..CarveOptions::default() };
    assert_eq!(block.carve(&wall, rule, &short, None).unwrap_err().kind(), ErrorKind::Shape);
}

#[test]
fn a_drain_opens_what_was_shut_in() {
    let on = Lattice::new(30, 30, 30, 0.5, 0.5).unwrap();
    let block = Grid::from_fn(&on, |layer, y, x| [layer, y, x].iter().all(|i| (1..29).contains(i))).unwrap();
    let wall = block.wall_inside(2.0, None).unwrap();
    let rule = Rule::box3();
    let (hollow, _) = block.carve(&wall, rule, &CarveOptions::default(), None).unwrap();
    let open = VoidsOptions { bed_is_open: true, ..VoidsOptions::default() };
    let shut = hollow.voids(&open, None).unwrap().0.trap_count;
    assert!(shut >= 1);
    let mut drained = hollow.clone();
    let (report, drains) = drained.drain(Some(Terms::new(rule)), &DrainOptions::new(1.5), None).unwrap();
    assert_eq!((report.void_count, report.closed_count), (shut, 0), "{report:?}");
    assert_eq!(drained.voids(&open, None).unwrap().0.trap_count, 0);
    assert_eq!(drains.len() as u64, report.drain_count);
    assert_eq!(drains.iter().map(|drain| drain.voxels).sum::<u64>(), hollow.count() - drained.count());
    assert_eq!(drained.unsupported(rule, None).unwrap().count(), 0);
    let removed = hollow.body(None, None).unwrap() - drained.body(None, None).unwrap();
    assert!((report.removed.mass - removed.mass).abs() < 1e-9);
    assert!(drains.iter().all(|drain| drain.to_mm[2] < drain.from_mm[2]));
    let untold = DrainOptions { drains: 0, ..DrainOptions::new(1.5) };
    let (again, none) = hollow.clone().drain(None, &untold, None).unwrap();
    assert!(none.is_empty() && again.drains_dropped == again.drain_count && again.drain_count > 0);
    let as_it_was = drained.clone();
    let refused = drained.drain(None, &DrainOptions::new(0.0), None).unwrap_err();
    assert_eq!((refused.kind(), drained == as_it_was), (ErrorKind::Argument, true));
}
