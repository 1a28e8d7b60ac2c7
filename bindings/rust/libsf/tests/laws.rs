// SPDX-License-Identifier: MIT
// Why: what the operators promise has to hold through this crate as it does in C: that arguments arrive
// where they belong is seen in nothing but results. Shapes are random; under the papers' rule they are
// compared with that rule written down voxel by voxel (tests/shapes), under the others with the laws.

mod shapes;

use libsf::{ErrorKind, Grid, PreserveMode, PreserveOptions, RepairOptions, Rule, Terms};
use shapes::{lattice, shape, Random, Solid};
use std::f64::consts::FRAC_PI_4;

const SEEDS: std::ops::Range<u64> = 1..61;

fn rules() -> [Rule; 4] {
    let octagon = Rule::octagon(FRAC_PI_4);
    [Rule::box3(), octagon, Rule::slack(0.9), octagon.with_bridges(4.0, 1.0)]
}

/// A shape for each seed, and each rule with it.
fn all(mut test: impl FnMut(u64, &mut Random, Grid, Rule)) {
    for seed in SEEDS {
        let mut random = Random::new(seed);
        let lattice = lattice(&mut random);
        let grid = shape(&mut random, &lattice);
        for rule in rules() {
            test(seed, &mut random, grid.clone(), rule);
        }
    }
}

#[test]
fn voxels_go_in_and_come_out() {
    all(|seed, _, grid, _| {
        let solid = Solid::of(&grid);
        assert_eq!(grid.count(), solid.voxels.iter().filter(|&&one| one).count() as u64, "seed {seed}");
        assert_eq!(solid.grid(grid.lattice()), grid, "seed {seed}");
        let (_, ny, nx) = solid.shape;
        let bits = grid.words().chunks(grid.stride()).enumerate();
        for (row, words) in bits {
            for x in 0..nx {
                let place = solid.place(row / ny, row % ny, x);
                assert_eq!(words[x / 64] >> (x % 64) & 1 != 0, solid.voxels[place], "seed {seed}");
            }
        }
    });
}

#[test]
fn a_trim_is_the_largest_part_that_stands() {
    all(|seed, _, mut grid, rule| {
        let before = Solid::of(&grid);
        let loose = grid.check(rule, None).unwrap();
        let report = grid.trim(rule, None).unwrap();
        let after = Solid::of(&grid);
        assert!(after.within(&before), "seed {seed} {rule:?}");
        assert_eq!(loose.report.trimmed_voxels, report.removed_voxels, "seed {seed} {rule:?}");
        assert_eq!(grid.trim(rule, None).unwrap().removed_voxels, 0, "seed {seed} {rule:?}");
        assert!(grid.check(rule, None).unwrap().support_free(), "seed {seed} {rule:?}");
        if rule == Rule::box3() {
            assert_eq!(after, before.trimmed(), "seed {seed}");
            assert_eq!(loose.report.unsupported_voxels, before.unsupported(), "seed {seed}");
        }
    });
}

#[test]
fn growing_adds_and_repairing_is_no_dearer() {
    all(|seed, _, grid, rule| {
        let before = Solid::of(&grid);
        let mut grown = grid.clone();
        let report = grown.grow(rule, None).unwrap();
        assert!(before.within(&Solid::of(&grown)), "seed {seed} {rule:?}");
        assert_eq!(report.kept_voxels + report.added_voxels, grown.count(), "seed {seed} {rule:?}");
        assert!(grown.check(rule, None).unwrap().support_free(), "seed {seed} {rule:?}");
        let mut repaired = grid.clone();
        let done = repaired.repair(rule, &RepairOptions::default(), None).unwrap();
        assert!(repaired.check(rule, None).unwrap().support_free(), "seed {seed} {rule:?}");
        assert_eq!(done.cost, done.added_voxels + done.removed_voxels, "seed {seed} {rule:?}");
        assert!(done.cost <= report.added_voxels, "seed {seed} {rule:?}");
        assert!(done.trim_cost.map_or(true, |trim| done.cost <= trim), "seed {seed} {rule:?}");
    });
}

#[test]
fn costs_are_those_of_their_voxels() {
    for seed in SEEDS {
        let mut random = Random::new(seed);
        let lattice = lattice(&mut random);
        let grid = shape(&mut random, &lattice);
        let before = Solid::of(&grid);
        let mut prices = || before.voxels.iter().map(|_| 1 + random.below(9) as u8).collect::<Vec<u8>>();
        let (add, remove) = (prices(), prices());
        let options =
            RepairOptions { add_cost: Some(&add), remove_cost: Some(&remove), ..RepairOptions::default() };
        let mut repaired = grid.clone();
        let report = repaired.repair(Rule::box3(), &options, None).unwrap();
        let after = Solid::of(&repaired);
        let cost: u64 = (0..add.len())
            .map(|i| match (before.voxels[i], after.voxels[i]) {
                (false, true) => u64::from(add[i]),
                (true, false) => u64::from(remove[i]),
                _ => 0,
            })
            .sum();
        assert_eq!(report.cost, cost, "seed {seed}");
        let short = RepairOptions { add_cost: Some(&add[1..]), ..options };
        let refused = repaired.repair(Rule::box3(), &short, None).unwrap_err();
        assert_eq!(refused.kind(), ErrorKind::Shape, "seed {seed}");
    }
}

#[test]
fn preserving_loses_nothing_outside_the_brush() {
    all(|seed, random, mut grid, rule| {
        grid.trim(rule, None).unwrap();
        let before = Solid::of(&grid);
        let brush = shape(random, grid.lattice());
        let mut outside = grid.clone();
        outside.subtract(&brush).unwrap();
        for mode in [PreserveMode::Fast, PreserveMode::Irredundant, PreserveMode::Core] {
            let mut left = grid.clone();
            let options = PreserveOptions { mode, ..PreserveOptions::default() };
            let terms = match grid.bounds() {
                place if place.z1 > 0 => Terms::new(rule).bed_layer(place.z0),
                _ => Terms::new(rule),
            };
            let report = left.preserve(&brush, terms, &options, None).unwrap();
            let after = Solid::of(&left);
            assert!(after.within(&before), "seed {seed} {rule:?} {mode:?}");
            assert!(Solid::of(&outside).within(&after), "seed {seed} {rule:?} {mode:?}");
            assert_eq!(report.lost_outside, 0, "seed {seed} {rule:?} {mode:?}");
            assert_eq!(grid.count() - left.count(), report.removed_voxels, "seed {seed} {rule:?} {mode:?}");
            assert_eq!(left.unsupported(terms, None).unwrap().count(), 0, "seed {seed} {rule:?} {mode:?}");
        }
        let completed = grid.complete(&outside, rule, None);
        if grid.count() > 0 {
            let completed = Solid::of(&completed.unwrap());
            assert!(
                Solid::of(&outside).within(&completed) && completed.within(&before),
                "seed {seed} {rule:?}"
            );
        }
    });
}

#[test]
fn what_must_stay_and_cannot_comes_with_the_error() {
    all(|seed, _, grid, rule| {
        let loose = grid.unsupported(rule, None).unwrap();
        if loose.count() == 0 {
            return;
        }
        let as_it_was = grid.clone();
        let mut changed = grid.clone();
        // Nothing may be removed, and nothing may be added.
        let everywhere = Grid::from_fn(grid.lattice(), |_, _, _| true).unwrap();
        let terms = Terms::new(rule).keep(&everywhere).forbid(&everywhere);
        let refused = [
            changed.trim(terms, None).unwrap_err(),
            changed.grow(terms, None).unwrap_err(),
            changed.repair(terms, &RepairOptions::default(), None).unwrap_err(),
            grid.feasible(&grid, rule, None).unwrap_err(),
        ];
        for error in refused {
            assert_eq!(error.kind(), ErrorKind::Infeasible, "seed {seed} {rule:?}");
            let culprits = error.culprits().expect("voxels");
            assert!(Solid::of(&loose).within(&Solid::of(culprits)), "seed {seed} {rule:?}");
            assert!(Solid::of(culprits).within(&Solid::of(&grid)), "seed {seed} {rule:?}");
        }
        assert_eq!(changed, as_it_was, "seed {seed} {rule:?}");
        // What is lost is exempt, and all is well.
        changed.grow(Terms::new(rule).exempt(&loose).act(&loose).forbid(&everywhere), None).unwrap();
        assert_eq!(changed, as_it_was, "seed {seed} {rule:?}");
    });
}

#[test]
fn findings_add_up() {
    all(|seed, _, grid, rule| {
        let checked = grid.check(rule, None).unwrap();
        let volume: u64 = checked.findings.iter().map(|finding| finding.volume).sum();
        let report = checked.report;
        assert_eq!(volume + report.unlinked_voxels, report.trimmed_voxels, "seed {seed} {rule:?}");
        let count = report.island_count + report.overhang_count;
        assert_eq!(checked.findings.len() as u64, count, "seed {seed} {rule:?}");
        for (i, finding) in checked.findings.iter().enumerate() {
            assert!(finding.cause.map_or(true, |cause| (cause as usize) < i), "seed {seed} {rule:?}");
        }
    });
}
