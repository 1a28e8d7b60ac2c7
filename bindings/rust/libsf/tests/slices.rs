// SPDX-License-Identifier: MIT
// Why: elements, runs and sums are small values that C believes. Each is compared with its definition, a voxel at
// a time, on random slices whose rows end everywhere in a word, under each instruction set that there is.

mod shapes;

use libsf::{
    isa_limit, label_runs, measure_runs, Border, Connectivity, Element, ErrorKind, Isa, Lattice, Rule, Run,
    Slice, SliceMut,
};
use shapes::Random;

struct Picture {
    width: u32,
    height: u32,
    stride: usize,
    words: Vec<u64>,
}

impl Picture {
    fn new(random: &mut Random) -> Picture {
        let (width, height) = (1 + random.below(150), 1 + random.below(20));
        let stride = width.div_ceil(64) as usize + random.below(2) as usize;
        let words = (0..stride * height as usize).map(|_| random.next() & random.next()).collect();
        Picture { width, height, stride, words }
    }

    fn slice(&self) -> Slice<'_> {
        Slice::new(&self.words, self.width, self.height, self.stride).unwrap()
    }

    fn slice_mut(&mut self) -> SliceMut<'_> {
        SliceMut::new(&mut self.words, self.width, self.height, self.stride).unwrap()
    }

    fn same(&self) -> Picture {
        Picture { words: self.words.clone(), ..*self }
    }

    fn voxels(&self) -> impl Iterator<Item = (u32, u32)> + '_ {
        (0..self.height).flat_map(|y| (0..self.width).map(move |x| (x, y)))
    }

    /// Whether a voxel is solid, with a border of so much outside.
    fn at(&self, x: i64, y: i64, outside: bool) -> bool {
        let inside = (0..i64::from(self.width)).contains(&x) && (0..i64::from(self.height)).contains(&y);
        if inside {
            self.slice().get(x as u32, y as u32)
        } else {
            outside
        }
    }

    /// Whether an element placed at a voxel meets anything that is `wanted`.
    fn meets(&self, x: u32, y: u32, element: &Element, outside: bool, wanted: bool) -> bool {
        let widths = element.half_widths();
        let reach = widths.len() as i64 - 1;
        (-reach..=reach).any(|dy| {
            let half = i64::from(widths[dy.unsigned_abs() as usize]);
            (-half..=half).any(|dx| self.at(i64::from(x) + dx, i64::from(y) + dy, outside) == wanted)
        })
    }
}

fn element(random: &mut Random) -> Element {
    let mut half = random.below(7) as u16;
    let widths: Vec<u16> = (0..1 + random.below(5))
        .map(|_| {
            half -= random.below(1 + u32::from(half)) as u16;
            half
        })
        .collect();
    Element::new(&widths).unwrap()
}

#[test]
fn dilation_and_erosion_are_their_definitions() {
    let mut names = std::collections::BTreeSet::new();
    for isa in [Isa::Reference, Isa::Word, Isa::Sse2, Isa::Neon, Isa::Avx2, Isa::Avx512] {
        names.insert(isa_limit(Some(isa)));
        let mut random = Random::new(6);
        for _ in 0..12 {
            let (from, by) = (Picture::new(&mut random), element(&mut random));
            for (border, outside) in [(Border::Empty, false), (Border::Solid, true)] {
                let (mut wide, mut thin) = (from.same(), from.same());
                wide.slice_mut().dilate(from.slice(), &by, border).unwrap();
                thin.slice_mut().erode(from.slice(), &by, border).unwrap();
                for (x, y) in from.voxels() {
                    assert_eq!(wide.slice().get(x, y), from.meets(x, y, &by, outside, true), "{by:?}");
                    assert_eq!(thin.slice().get(x, y), !from.meets(x, y, &by, outside, false), "{by:?}");
                }
            }
            let (below, mut top) = (from.same(), from.same());
            top.words.iter_mut().for_each(|word| *word |= random.next());
            let before = top.same();
            top.slice_mut().and_dilate(below.slice(), &by).unwrap();
            for (x, y) in from.voxels() {
                let wanted = before.slice().get(x, y) && below.meets(x, y, &by, false, true);
                assert_eq!(top.slice().get(x, y), wanted, "{by:?}");
            }
        }
    }
    isa_limit(None);
    assert!(names.contains("reference") && names.len() > 1, "{names:?}");
}

#[test]
fn elements_are_what_they_say() {
    assert_eq!(Element::box3().half_widths(), [1, 1]);
    assert_eq!(Element::plus3().half_widths(), [1, 0]);
    assert_eq!(Element::new(&[1, 0]).unwrap(), Element::plus3());
    for (rx, ry) in [(0.5, 3.0), (4.25, 2.5), (7.0, 7.0)] {
        let made = Element::ellipse((rx * 65536.0) as u64, (ry * 65536.0) as u64).unwrap();
        let widths: Vec<u16> = (0..=ry as u16)
            .map(|dy| {
                (0..=rx as u16)
                    .rev()
                    .find(|&dx| (f64::from(dx) / rx).powi(2) + (f64::from(dy) / ry).powi(2) <= 1.0)
                    .unwrap_or(0)
            })
            .collect();
        assert_eq!(made.half_widths(), widths);
    }
    let mut random = Random::new(12);
    for _ in 0..20 {
        let (from, a, b) = (Picture::new(&mut random), element(&mut random), element(&mut random));
        let (mut at_once, mut by_a, mut by_both) = (from.same(), from.same(), from.same());
        at_once.slice_mut().dilate(from.slice(), &a.sum(&b).unwrap(), Border::Solid).unwrap();
        by_a.slice_mut().dilate(from.slice(), &a, Border::Solid).unwrap();
        by_both.slice_mut().dilate(by_a.slice(), &b, Border::Solid).unwrap();
        assert_eq!(at_once.slice(), by_both.slice());
    }
    for widths in [&[][..], &[1, 2], &[256], &[0; 257]] {
        assert_eq!(Element::new(widths).unwrap_err().kind(), ErrorKind::Argument);
    }
    assert_eq!(Element::ellipse(1 << 40, 0).unwrap_err().kind(), ErrorKind::Overflow);
    let wide = Element::new(&[255]).unwrap();
    assert_eq!(wide.sum(&wide).unwrap_err().kind(), ErrorKind::Overflow);
    let lattice = Lattice::new(8, 8, 8, 0.1, 0.1).unwrap();
    assert_eq!(Rule::box3().element(&lattice, 3).unwrap(), Element::box3());
    let octagon = Rule::octagon(std::f64::consts::FRAC_PI_4);
    // A step is a plus, a square or, so that their sum stays within the angle, a voxel.
    let single = Element::new(&[0]).unwrap();
    let steps: Vec<Element> = (0..7).map(|k| octagon.element(&lattice, k).unwrap()).collect();
    let known = [Element::box3(), Element::plus3(), single];
    assert!(steps.iter().all(|step| known.contains(step)) && steps.contains(&known[0]), "{steps:?}");
}

#[test]
fn runs_and_sums_are_those_of_the_voxels() {
    let mut random = Random::new(14);
    for _ in 0..60 {
        let from = Picture::new(&mut random);
        let runs = from.slice().runs().unwrap();
        assert_eq!(runs.len(), from.slice().run_count().unwrap());
        let mut solid = runs.iter().flat_map(|run| (run.x0..run.x1).map(|x| (x, run.y)));
        assert!(from.voxels().filter(|&(x, y)| from.slice().get(x, y)).eq(&mut solid));
        let mut painted = from.same();
        painted.words.fill(u64::MAX);
        painted.slice_mut().paint_runs(&runs).unwrap();
        assert_eq!(painted.slice(), from.slice());
        let sums = from.slice().sums().unwrap();
        let sum = |of: fn(u64, u64) -> u64| -> u64 {
            let solid = from.voxels().filter(|&(x, y)| from.slice().get(x, y));
            solid.map(|(x, y)| of(x.into(), y.into())).sum()
        };
        assert_eq!((sums.count, sums.x, sums.y), (sum(|_, _| 1), sum(|x, _| x), sum(|_, y| y)));
        assert_eq!((sums.xx, sums.yy, sums.xy), (sum(|x, _| x * x), sum(|_, y| y * y), sum(|x, y| x * y)));
    }
    let mut picture = Picture::new(&mut random);
    let beyond = Run { x0: 0, x1: picture.width + 1, y: 0, label: 0 };
    assert_eq!(picture.slice_mut().paint_runs(&[beyond]).unwrap_err().kind(), ErrorKind::Argument);
}

#[test]
fn components_are_what_hangs_together() {
    let mut random = Random::new(15);
    for connectivity in [Connectivity::Edges, Connectivity::Corners] {
        for _ in 0..30 {
            let from = Picture::new(&mut random);
            let mut runs = from.slice().runs().unwrap();
            let count = label_runs(&mut runs, connectivity).unwrap();
            let corner = u32::from(connectivity == Connectivity::Corners);
            // Labels of runs that touch are equal, and there are as many as a flood finds.
            let touch =
                |a: &Run, b: &Run| a.y.abs_diff(b.y) == 1 && a.x0 < b.x1 + corner && b.x0 < a.x1 + corner;
            let mut parts: Vec<usize> = (0..runs.len()).collect();
            for _ in 0..runs.len() {
                let before = parts.clone();
                for a in 0..runs.len() {
                    for b in 0..a {
                        if touch(&runs[a], &runs[b]) {
                            let least = parts[a].min(parts[b]);
                            (parts[a], parts[b]) = (least, least);
                        }
                    }
                }
                if parts == before {
                    break;
                }
            }
            for a in 0..runs.len() {
                for b in 0..a {
                    assert_eq!(parts[a] == parts[b], runs[a].label == runs[b].label);
                }
            }
            let found = measure_runs(&runs, count).unwrap();
            assert_eq!(found.iter().map(|one| one.area).sum::<u64>(), from.slice().count());
            for run in &runs {
                let bounds = found[run.label as usize].bounds;
                assert!(
                    bounds.x0 <= run.x0 && run.x1 <= bounds.x1 && (bounds.y0..bounds.y1).contains(&run.y)
                );
            }
            if count > 0 {
                assert_eq!(measure_runs(&runs, count - 1).unwrap_err().kind(), ErrorKind::Capacity);
            }
        }
    }
    let mut apart = [Run { x0: 4, x1: 6, y: 1, label: 0 }, Run { x0: 1, x1: 2, y: 1, label: 0 }];
    assert_eq!(label_runs(&mut apart, Connectivity::Edges).unwrap_err().kind(), ErrorKind::Argument);
    assert_eq!(label_runs(&mut [], Connectivity::Other(3)).unwrap_err().kind(), ErrorKind::Argument);
}
