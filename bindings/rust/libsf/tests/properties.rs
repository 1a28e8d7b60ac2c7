// SPDX-License-Identifier: MIT
// Why: the laws of the operators, for any shape that can be thought of. tests/laws.rs has seeds of its own;
// here whatever breaks a law is made smaller until nothing of it can be left out, and that shape is printed.

use libsf::{Grid, Lattice, PreserveOptions, Rule, Terms};
use proptest::prelude::*;
use std::f64::consts::FRAC_PI_4;

/// Shapes of one lattice: rows that end in the first word, at its end, or in the second.
fn shapes<const COUNT: usize>() -> impl Strategy<Value = [Grid; COUNT]> {
    let wide = prop_oneof![1u32..7, Just(63u32), Just(64), Just(66)];
    (wide, 1u32..5, 1u32..7).prop_flat_map(|(nx, ny, nz)| {
        let lattice = Lattice::new(nx, ny, nz, 0.5, 0.5).unwrap();
        let voxels = (nx * ny * nz) as usize;
        let solid = proptest::collection::vec(prop::bool::weighted(0.6), voxels);
        let made = move |solid: Vec<bool>| Grid::from_bools(&lattice, &solid).unwrap();
        proptest::array::uniform(solid).prop_map(move |all: [Vec<bool>; COUNT]| all.map(&made))
    })
}

fn rules() -> impl Strategy<Value = Rule> {
    let octagon = Rule::octagon(FRAC_PI_4);
    prop_oneof![
        Just(Rule::box3()),
        Just(octagon),
        Just(Rule::slack(0.9)),
        Just(octagon.with_bridges(2.0, 0.5))
    ]
}

fn terms(rule: Rule) -> Terms<'static> {
    Terms::new(rule).bed_layer(0)
}

fn trimmed(shape: &Grid, rule: Rule) -> Grid {
    let mut left = shape.clone();
    left.trim(terms(rule), None).unwrap();
    left
}

fn united(a: &Grid, b: &Grid) -> Grid {
    let mut both = a.clone();
    both.or(b).unwrap();
    both
}

fn within(small: &Grid, large: &Grid) -> bool {
    united(small, large) == *large
}

fn stands(shape: &Grid, rule: Rule) -> bool {
    shape.unsupported(terms(rule), None).unwrap().count() == 0
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn a_trim_shrinks_stands_and_is_the_largest_that_does([a, b] in shapes(), rule in rules()) {
        let left = trimmed(&a, rule);
        prop_assert!(within(&left, &a) && stands(&left, rule));
        prop_assert_eq!(&trimmed(&left, rule), &left);
        // Whatever stands within the shape is in its trim.
        let mut other = b;
        other.and(&a).unwrap();
        prop_assert!(within(&trimmed(&other, rule), &left));
    }

    #[test]
    fn a_trim_of_more_has_more([a, b] in shapes(), rule in rules()) {
        let both = united(&a, &b);
        prop_assert!(within(&united(&trimmed(&a, rule), &trimmed(&b, rule)), &trimmed(&both, rule)));
    }

    #[test]
    fn what_grew_holds_all_that_was_and_stands([a] in shapes(), rule in rules()) {
        let mut grown = a.clone();
        let report = grown.grow(terms(rule), None).unwrap();
        prop_assert!(within(&a, &grown) && stands(&grown, rule));
        prop_assert_eq!(report.added_voxels, grown.count() - a.count());
        let whole = grown.clone();
        prop_assert_eq!(grown.grow(terms(rule), None).unwrap().added_voxels, 0);
        prop_assert_eq!(grown, whole);
    }

    #[test]
    fn nothing_outside_a_brush_is_lost([a, brush] in shapes(), rule in rules()) {
        let shape = trimmed(&a, rule);
        let mut left = shape.clone();
        let report = left.preserve(&brush, terms(rule), &PreserveOptions::default(), None).unwrap();
        let mut outside = shape.clone();
        outside.subtract(&brush).unwrap();
        prop_assert!(within(&outside, &left) && within(&left, &shape) && stands(&left, rule));
        prop_assert_eq!(report.removed_voxels, shape.count() - left.count());
        // Where the rest stands without the brush, all of the brush goes.
        if stands(&outside, rule) {
            prop_assert_eq!(left, outside);
        }
    }
}
