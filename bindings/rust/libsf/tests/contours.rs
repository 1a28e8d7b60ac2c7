// SPDX-License-Identifier: MIT
// Why: polygons of a slicer's become voxels, and voxels polygons, and neither may lose anything: what is traced
// and drawn again is the same, by the stack, by the slice and by the checker.

mod shapes;

use libsf::{
    CheckOptions, Checker, ContourFill, ContourStack, Contours, ErrorKind, Grid, Lattice, Rule, Task,
};
use shapes::{lattice, shape, Random};

#[test]
fn what_is_traced_is_drawn_again() {
    for seed in 1..41 {
        let mut random = Random::new(seed);
        let on = lattice(&mut random).with_origin([2.0, -1.0, 0.5]).unwrap();
        let grid = shape(&mut random, &on);
        let stack = ContourStack::of(&grid).unwrap();
        assert_eq!((stack.len(), stack.is_empty()), (on.nz(), false), "seed {seed}");
        for fill in [ContourFill::Nonzero, ContourFill::EvenOdd] {
            assert_eq!(stack.grid(&on, fill, None).unwrap(), grid, "seed {seed} {fill:?}");
        }
        let mut checker =
            Checker::new(&on, CheckOptions { run_capacity: 4096, ..CheckOptions::default() }).unwrap();
        let mut drawn = Grid::new(&on).unwrap();
        for k in 0..stack.len() {
            let layer = stack.layer(k).unwrap();
            assert_eq!(Some(layer.top_mm), on.layer_bottom(k + 1), "seed {seed}");
            // Around pieces to the left, around holes to the right: the area is that of the voxels.
            let area = grid.slice(k).count() as f64 * 0.25;
            assert!((layer.contours.area_mm2() - area).abs() < 1e-9, "seed {seed}");
            drawn.slice_mut(k).draw(&on, &layer.contours, ContourFill::Nonzero).unwrap();
            checker.push_contours(&on, &layer.contours, ContourFill::Nonzero).unwrap();
        }
        assert_eq!(drawn, grid, "seed {seed}");
        assert_eq!(checker.report().unwrap(), grid.check(Rule::box3(), None).unwrap(), "seed {seed}");
    }
}

#[test]
fn polygons_are_what_was_handed_in() {
    let square = |reach: f64| [[-reach, -reach], [reach, -reach], [reach, reach], [-reach, reach]];
    let ring: Contours = [square(5.0), square(2.0)].into_iter().collect();
    assert_eq!((ring.len(), ring.area_mm2()), (2, 100.0 + 16.0));
    assert_eq!(ring.polygons().nth(1).unwrap(), square(2.0));
    assert!(Contours::new().is_empty() && Contours::default().polygons().len() == 0);
    let mut stack = ContourStack::new(1.0).unwrap();
    assert_eq!(stack.lattice([0.1; 2]).unwrap_err().kind(), ErrorKind::Argument);
    stack.add(1.5, &ring).unwrap();
    stack.add(1.75, &Contours::new()).unwrap();
    assert_eq!(stack.layer(0).unwrap().contours, ring);
    assert_eq!((stack.layer(1).unwrap().bottom_mm, stack.layer(1).unwrap().contours.len()), (1.5, 0));
    assert_eq!(stack.layer(2).unwrap_err().kind(), ErrorKind::Argument);
    // It ends at the first voxel beyond.
    let on = stack.lattice([0.5, 0.25]).unwrap();
    assert_eq!((on.shape(), on.origin_mm()), ((2, 41, 21), [-5.0, -5.0, 1.0]));
    assert_eq!(on.heights_mm(), Some(&[0.5, 0.25][..]));
    let count = |fill| stack.grid(&on, fill, None).unwrap().count();
    assert_eq!(count(ContourFill::Nonzero), 20 * 40);
    assert_eq!(count(ContourFill::EvenOdd), 20 * 40 - 8 * 16);
    let mut task = Task::new();
    task.canceller().cancel();
    let stopped = stack.grid(&on, ContourFill::Nonzero, Some(&mut task)).unwrap_err();
    assert_eq!(stopped.kind(), ErrorKind::Cancelled);
    let three = Lattice::new(20, 40, 3, 0.5, 0.25).unwrap();
    assert_eq!(stack.grid(&three, ContourFill::Nonzero, None).unwrap_err().kind(), ErrorKind::Shape);
    // What is refused leaves the stack as it was.
    let lost: Contours = [[[0.0, 0.0], [f64::NAN, 0.0], [1.0, 1.0]]].into_iter().collect();
    for (top_mm, contours) in [(2.0, &lost), (1.75, &ring), (f64::INFINITY, &ring)] {
        let refused = stack.add(top_mm, contours).unwrap_err();
        assert_eq!((refused.kind(), stack.len()), (ErrorKind::Argument, 2), "{refused}");
    }
    let mut grid = Grid::new(&on).unwrap();
    let fault = grid.slice_mut(0).draw(&on, &lost, ContourFill::Nonzero).unwrap_err();
    assert!(fault.kind() == ErrorKind::Argument && fault.message().len() > 20, "{fault}");
    assert_eq!(
        grid.slice_mut(0).draw(&on, &ring, ContourFill::Other(9)).unwrap_err().kind(),
        ErrorKind::Argument
    );
    assert_eq!(grid.count(), 0);
}

/// How often polygons wind around a point that lies on none of their edges.
fn winding(contours: &Contours, [x, y]: [f64; 2]) -> i32 {
    let mut turns = 0;
    for polygon in contours.polygons() {
        for (i, a) in polygon.iter().enumerate() {
            let b = polygon[(i + 1) % polygon.len()];
            if (a[1] > y) != (b[1] > y) && x < a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0]) {
                turns += if b[1] > a[1] { 1 } else { -1 };
            }
        }
    }
    turns
}

#[test]
fn a_voxel_is_solid_where_its_centre_is_inside() {
    let lattice = Lattice::new(48, 24, 1, 0.5, 0.5).unwrap();
    let mut random = Random::new(31);
    let (mut told, mut voxels) = (0, 0);
    for round in 0..80 {
        // Corners on sixteenths, between the centres of voxels.
        let mut at = |n: u32| 0.0625 + 0.125 * f64::from(random.below(n));
        let polygons = (0..1 + round % 3)
            .map(|n| (0..(round + 2 * n) % 7).map(|_| [at(200), at(100)]).collect::<Vec<_>>());
        let mut contours = Contours::new();
        polygons.for_each(|polygon| contours.push(&polygon));
        let even_odd = round % 2 == 0;
        let fill = if even_odd { ContourFill::EvenOdd } else { ContourFill::Nonzero };
        let inside = |at: [f64; 2]| match winding(&contours, at) {
            turns if even_odd => turns % 2 != 0,
            turns => turns != 0,
        };
        let mut grid = Grid::new(&lattice).unwrap();
        grid.slice_mut(0).draw(&lattice, &contours, fill).unwrap();
        for n in 0..48 * 24 {
            let (x, y) = (n % 48, n / 48);
            let [cx, cy] = [0.25 + 0.5 * f64::from(x), 0.25 + 0.5 * f64::from(y)];
            // Where a little to the side is another answer, the centre is all but on an edge.
            let near = [[cx + 1e-3, cy], [cx - 1e-3, cy], [cx, cy + 1e-3], [cx, cy - 1e-3]];
            voxels += 1;
            if near.iter().all(|&to| inside(to) == inside([cx, cy])) {
                assert_eq!(grid.get(0, y, x), inside([cx, cy]), "round {round}: {x} {y} {contours:?}");
                told += 1;
            }
        }
    }
    assert!(told * 50 > voxels * 49, "{told} of {voxels}");
}
