// SPDX-License-Identifier: MIT
// Why: where matter is missing, what it costs and how it is proved goes from Rust to C and back: findings as they
// came, paths with their ends, certificates with their arrays. Paths are held here against the papers' costs
// written down voxel by voxel, and everything else against the operators that it has to agree with.

mod shapes;

use libsf::{
    Certificate, Checker, Claim, ErrorKind, Finding, Grid, Landing, Lattice, Operation, PathCost, PathEnd,
    PathFinder, PathMap, Rule, Terms, Voxel, VoxelBox,
};
use shapes::{lattice, shape, Random, Solid};
use std::f64::consts::FRAC_PI_4;

#[test]
fn types_go_to_other_threads() {
    fn send<T: Send>() {}
    fn both<T: Send + Sync>() {}
    both::<Certificate>();
    both::<PathMap<'static>>();
    send::<PathFinder<'static>>();
}

/// The costs of <sf/grow.h> for box3 and a bed below layer 0, by the layer below.
struct Costs {
    solid: Solid,
    /// Of a voxel that is to be filled, with what it then needs.
    filled: Vec<u64>,
}

impl Costs {
    fn of(grid: &Grid) -> Costs {
        let solid = Solid::of(grid);
        let (nz, ny, nx) = solid.shape;
        let mut costs = Costs { filled: vec![0; solid.voxels.len()], solid };
        for k in 0..nz {
            for y in 0..ny {
                for x in 0..nx {
                    let place = costs.solid.place(k, y, x);
                    costs.filled[place] = match k {
                        0 => costs.to_matter(y, x),
                        _ => 1 + costs.path(k, y, x),
                    };
                }
            }
        }
        costs
    }

    /// Of a voxel on the bed: the distance to its matter, rounded up.
    fn to_matter(&self, y: usize, x: usize) -> u64 {
        let (_, ny, nx) = self.solid.shape;
        let matter = (0..ny * nx).filter(|&n| self.solid.voxels[n]);
        let square = |n: usize| (n / nx).abs_diff(y).pow(2) + (n % nx).abs_diff(x).pow(2);
        matter.map(square).min().map_or(1, |square| (square as f64).sqrt().ceil() as u64)
    }

    /// Of the path of a voxel.
    fn path(&self, k: usize, y: usize, x: usize) -> u64 {
        if k == 0 {
            return 0;
        }
        let (_, ny, nx) = self.solid.shape;
        let (ys, xs) = (y.saturating_sub(1)..(y + 2).min(ny), x.saturating_sub(1)..(x + 2).min(nx));
        let below = ys.flat_map(|y| xs.clone().map(move |x| (y, x)));
        let cost = |(y, x): (usize, usize)| {
            let place = self.solid.place(k - 1, y, x);
            if self.solid.voxels[place] {
                0
            } else {
                self.filled[place]
            }
        };
        below.map(cost).min().unwrap()
    }
}

#[test]
fn paths_cost_what_the_paper_says() {
    for seed in 1..25 {
        let mut random = Random::new(seed);
        let lattice = lattice(&mut random);
        let grid = shape(&mut random, &lattice);
        let costs = Costs::of(&grid);
        let (nz, ny, nx) = costs.solid.shape;
        let terms = Terms::new(Rule::box3()).bed_layer(0);
        let mut finder = grid.path_finder(terms, Landing::Any, None).unwrap();
        let map = grid.path_map(terms, Landing::Any, PathCost::Count, None).unwrap();
        for _ in 0..40 {
            let (z, y, x) = (random.below(nz as u32), random.below(ny as u32), random.below(nx as u32));
            let wanted = costs.path(z as usize, y as usize, x as usize);
            let from = Voxel { x, y, z };
            for path in [finder.find(from).unwrap(), map.walk(from).unwrap()] {
                assert_eq!(path.cost, wanted, "seed {seed} {from:?} {path:?}");
                let mut above = from;
                for &voxel in &path.voxels {
                    assert_eq!(voxel.z + 1, above.z);
                    assert!(voxel.x.abs_diff(above.x) <= 1 && voxel.y.abs_diff(above.y) <= 1);
                    above = voxel;
                }
                match path.end {
                    PathEnd::Matter => {
                        let landing = path.landing;
                        assert!(grid.get(landing.z, landing.y, landing.x) && landing.z + 1 == above.z);
                    }
                    end => assert_eq!((end, path.landing, above.z), (PathEnd::Bed, above, 0)),
                }
            }
        }
        let outside = Voxel { x: nx as u32, y: 0, z: 0 };
        assert_eq!(finder.find(outside).unwrap_err().kind(), ErrorKind::Argument);
    }
}

#[test]
fn a_way_that_is_barred_is_no_path() {
    let lattice = Lattice::new(9, 9, 9, 0.1, 0.1).unwrap();
    let grid = Grid::from_fn(&lattice, |layer, y, x| (layer, y, x) == (8, 4, 4)).unwrap();
    let floor = Grid::from_fn(&lattice, |layer, _, _| layer == 3).unwrap();
    let terms = Terms::new(Rule::box3()).bed_layer(0).forbid(&floor);
    let from = Voxel { x: 4, y: 4, z: 8 };
    let refused = grid.path_finder(terms, Landing::Alive, None).unwrap().find(from).unwrap_err();
    assert_eq!(refused.kind(), ErrorKind::Infeasible);
    // A voxel of the floor that is held is a way to end.
    let held = Grid::from_fn(&lattice, |layer, y, x| (layer, y, x) == (4, 4, 2)).unwrap();
    let terms = terms.exempt(&held);
    let path = grid.path_finder(terms, Landing::Any, None).unwrap().find(from).unwrap();
    assert_eq!((path.end, path.landing, path.cost), (PathEnd::Held, Voxel { x: 2, y: 4, z: 4 }, 4));
    let slack = grid.path_map(Rule::slack(0.8), Landing::Any, PathCost::Count, None).unwrap_err();
    assert_eq!(slack.kind(), ErrorKind::Unsupported);
    // A brush along it, and along one that the masks bar.
    let mut built = grid.clone();
    let cube = Grid::from_fn(&Lattice::new(3, 3, 3, 0.1, 0.1).unwrap(), |_, _, _| true).unwrap();
    let anchor = Voxel { x: 1, y: 1, z: 1 };
    let report = built.emit(&cube, anchor, &path.voxels, terms).unwrap();
    assert_eq!(built.count(), 1 + report.added_voxels);
    assert!(report.added_voxels > 4 && built.unsupported(terms, None).unwrap().count() == 0);
    let barred: Vec<Voxel> = (0..8).rev().map(|z| Voxel { x: 4, y: 4, z }).collect();
    let before = built.clone();
    let refused = built.emit(&cube, anchor, &barred, terms).unwrap_err();
    assert!(refused.kind() == ErrorKind::Infeasible && built == before);
    let outside = built.emit(&cube, Voxel { x: 3, y: 0, z: 0 }, &path.voxels, terms).unwrap_err();
    assert_eq!(outside.kind(), ErrorKind::Argument);
}

#[test]
fn findings_cost_what_mends_them() {
    for seed in 1..40 {
        let mut random = Random::new(seed);
        let lattice = lattice(&mut random);
        let grid = shape(&mut random, &lattice);
        for rule in [Rule::box3(), Rule::octagon(FRAC_PI_4), Rule::slack(0.9)] {
            let checked = grid.check(rule, None).unwrap();
            let mut added = Grid::new(grid.lattice()).unwrap();
            let costs = checked.costs(&grid, rule, Some(&mut added), None).unwrap();
            assert_eq!(costs, checked.costs(&grid, rule, None, None).unwrap());
            assert_eq!(costs.len(), checked.findings.len());
            let sum: u64 = costs.iter().map(|cost| cost.grow_voxels.unwrap()).sum();
            assert!(added.count() <= sum, "seed {seed} {rule:?}");
            for (cost, finding) in costs.iter().zip(&checked.findings) {
                assert_eq!(cost.trim_voxels, finding.volume, "seed {seed} {rule:?}");
            }
            let mut fixed = grid.clone();
            fixed.or(&added).unwrap();
            assert!(fixed.check(rule, None).unwrap().support_free(), "seed {seed} {rule:?}");
            let order = checked.rank(Some(&costs)).unwrap();
            let least = |i: &u32| costs[*i as usize].trim_voxels.min(costs[*i as usize].grow_voxels.unwrap());
            assert!(order.windows(2).all(|two| least(&two[0]) >= least(&two[1])), "seed {seed} {rule:?}");
            let mut all = order.clone();
            all.sort_unstable();
            assert!(all.into_iter().eq(0..costs.len() as u32));
            if let Some(finding) = checked.findings.first() {
                assert_eq!(checked.rank(Some(&costs[1..])).unwrap_err().kind(), ErrorKind::Shape);
                // Findings of another shape are noticed.
                let wrong = Finding { area: finding.area + 1, ..*finding };
                let mut other = checked.clone();
                other.findings[0] = wrong;
                let refused = other.costs(&grid, rule, None, None).unwrap_err();
                assert_eq!(refused.kind(), ErrorKind::Argument, "seed {seed} {rule:?}");
            }
        }
    }
}

#[test]
fn what_nothing_may_be_added_to_has_no_cost_of_growing() {
    let lattice = Lattice::new(8, 8, 8, 0.1, 0.1).unwrap();
    let grid = Grid::from_fn(&lattice, |layer, y, x| y == 4 && (x == 1 || (layer == 7 && x == 5))).unwrap();
    let everywhere = Grid::from_fn(&lattice, |_, _, _| true).unwrap();
    let checked = grid.check(Rule::box3(), None).unwrap();
    let costs = checked.costs(&grid, Terms::new(Rule::box3()).forbid(&everywhere), None, None).unwrap();
    assert_eq!((costs[0].trim_voxels, costs[0].grow_voxels), (1, None));
    assert_eq!(checked.rank(Some(&costs)).unwrap(), [0]);
}

#[test]
fn a_trim_in_a_box_is_the_trim() {
    for seed in 1..40 {
        let mut random = Random::new(seed);
        let lattice = lattice(&mut random);
        let (first, second) = (shape(&mut random, &lattice), shape(&mut random, &lattice));
        for rule in [Rule::box3(), Rule::octagon(FRAC_PI_4), Rule::slack(0.9)] {
            let terms = Terms::new(rule).bed_layer(0);
            let (mut printable, mut drawn) = (first.clone(), first.clone());
            printable.trim(terms, None).unwrap();
            let before = printable.clone();
            drawn.xor(&second).unwrap();
            let place = second.bounds();
            let changed = printable.trim_box(Some(&drawn), rule, Some(0), place).unwrap();
            let mut wanted = drawn.clone();
            wanted.trim(terms, None).unwrap();
            assert!(printable == wanted, "seed {seed} {rule:?}");
            let mut differs = before.clone();
            differs.xor(&printable).unwrap();
            assert_eq!(changed, differs.bounds(), "seed {seed} {rule:?}");
            // What is only taken away from needs one grid.
            let mut alone = printable.clone();
            alone.subtract(&first).unwrap();
            alone.trim_box(None, rule, Some(0), first.bounds()).unwrap();
            wanted.subtract(&first).unwrap();
            wanted.trim(terms, None).unwrap();
            assert!(alone == wanted, "seed {seed} {rule:?}");
            let beyond = VoxelBox { x1: lattice.nx() + 1, y1: 1, z1: 1, ..VoxelBox::default() };
            let refused = alone.trim_box(None, rule, Some(0), beyond).unwrap_err();
            assert_eq!(refused.kind(), ErrorKind::Argument);
        }
    }
}

#[test]
fn layers_as_runs_are_layers() {
    for seed in 1..30 {
        let mut random = Random::new(seed);
        let lattice = lattice(&mut random);
        let grid = shape(&mut random, &lattice);
        let rule = Rule::octagon(FRAC_PI_4);
        let mut checker = Checker::new(grid.lattice(), rule).unwrap();
        for slice in grid.slices() {
            checker.push_runs(&slice.runs().unwrap()).unwrap();
        }
        let (found, wanted) = (checker.report().unwrap(), grid.check(rule, None).unwrap());
        assert_eq!(found.report.trimmed_voxels, wanted.report.trimmed_voxels, "seed {seed}");
        assert_eq!(found.findings.len(), wanted.findings.len(), "seed {seed}");
        let beyond = libsf::Run { x0: 0, x1: grid.lattice().nx() + 1, y: 0, label: 0 };
        assert_eq!(checker.push_runs(&[beyond]).unwrap_err().kind(), ErrorKind::Argument);
    }
}

#[test]
fn a_certificate_says_what_the_shape_is() {
    for seed in 1..30 {
        let mut random = Random::new(seed);
        let lattice = lattice(&mut random);
        let before = shape(&mut random, &lattice);
        for rule in [Rule::box3(), Rule::octagon(FRAC_PI_4).with_bridges(3.0, 1.0), Rule::slack(0.9)] {
            let loose = before.check(rule, None).unwrap();
            let mut after = before.clone();
            let removed = after.trim(rule, None).unwrap().removed_voxels;
            let terms = Terms::new(rule);
            let claim = Claim { terms, operation: Operation::Trim, before: Some(&before) };
            let certificate = after.certify(claim, None).unwrap();
            let view = certificate.view().unwrap();
            assert_eq!(
                (view.kind, view.operation, &view.lattice),
                (rule.kind(), Operation::Trim, after.lattice())
            );
            assert_eq!(view.input_sha256, before.sha256(None).unwrap());
            assert_eq!(view.output_sha256, after.sha256(None).unwrap());
            assert_eq!((view.added_voxels, view.removed_voxels), (0, removed), "seed {seed} {rule:?}");
            assert_eq!(
                (view.layers.len(), view.steps.len() + 1),
                (after.slices().len(), after.slices().len())
            );
            for (layer, slice) in view.layers.iter().zip(after.slices()) {
                assert_eq!((layer.solid, layer.exempt), (slice.count(), 0));
            }
            if rule == Rule::box3() {
                assert!(view.steps.iter().all(|step| (step.first, step.second) == (1, 2)));
            }
            assert_eq!([view.bridge_span_mm, view.bridge_anchor_mm], rule.bridges_mm());
            // Without the trim there is none, unless what hangs is exempt.
            let refused = before.certify(rule, None);
            assert_eq!(refused.is_err(), !loose.support_free(), "seed {seed} {rule:?}");
            if let Err(error) = refused {
                assert!(
                    error.kind() == ErrorKind::Infeasible && error.message().contains("layer"),
                    "{error}"
                );
                let exempt = before.unsupported(rule, None).unwrap();
                let certified = before.certify(terms.exempt(&exempt), None).unwrap();
                let runs = certified.view().unwrap().exempt;
                let length: u64 = runs.iter().map(|run| u64::from(run.x1 - run.x0)).sum();
                assert_eq!(length, exempt.count(), "seed {seed} {rule:?}");
            }
        }
    }
}

#[test]
fn a_certificate_lists_its_bridges_and_becomes_a_file() {
    let lattice = Lattice::new(24, 6, 8, 0.1, 0.1).unwrap();
    let gate = Grid::from_fn(&lattice, |layer, _, x| layer >= 6 || !(6..18).contains(&x)).unwrap();
    let rule = Rule::octagon(FRAC_PI_4).with_bridges(1.5, 0.2);
    assert!(gate.certify(Rule::octagon(FRAC_PI_4), None).is_err());
    let certificate = gate.certify(rule, None).unwrap();
    let view = certificate.view().unwrap();
    assert!(view.spans.iter().any(|span| (span.layer, span.direction) == (6, 0)), "{:?}", view.spans);
    assert!(view.layers[6].bridged > 0 && view.layers[7].bridged == 0);
    assert_eq!((view.bed_layer, view.bed, view.bridge.span_x), (None, 0, 15));
    let mut text = Vec::new();
    certificate.write(&mut text).unwrap();
    let hash: String = view.output_sha256.iter().map(|byte| format!("{byte:02x}")).collect();
    assert!(String::from_utf8(text.clone()).unwrap().contains(&hash));
    let path = std::env::temp_dir().join(format!("libsf-{}.json", std::process::id()));
    certificate.save(&path).unwrap();
    assert_eq!(std::fs::read(&path).unwrap(), text);
    std::fs::remove_file(path).unwrap();
    assert_eq!(Operation::Preserve.to_string(), "preserve");
    // What was added cannot have come of a trim.
    let empty = Grid::new(&lattice).unwrap();
    let claim = Claim { terms: rule.into(), operation: Operation::Trim, before: Some(&empty) };
    assert_eq!(gate.certify(claim, None).unwrap_err().kind(), ErrorKind::Argument);
}
