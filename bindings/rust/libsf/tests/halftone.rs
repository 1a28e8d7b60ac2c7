// SPDX-License-Identifier: MIT
// Why: a halftone is one comparison a voxel, so it is made here a second time from the mask's ranks, and what
// comes out is held against the fractions that went in, from the measured mixture on. C is told where planes
// begin and not where they end; what is too short has to be refused here.

mod shapes;

use libsf::{
    material_uses, Curve, CurveSample, Diffuser, ErrorKind, Grid, Halftone, KeepOut, Lattice, Mask, MaskKind,
    MaskOptions, Materials, Mesh, Mixture, Shell, Slice, SliceMut, Task, ToneValues, Tones, Trend,
};
use shapes::Random;

fn unit(random: &mut Random) -> f64 {
    f64::from(random.below(1 << 20)) / f64::from(1 << 20)
}

/// The material of a voxel by the rule of <sf/halftone.h>; tones of all materials but the last.
fn material(mask: &Mask, x: u32, y: u32, z: u32, tones: &[f64]) -> u32 {
    let voxels = mask.size().iter().map(|&n| f64::from(n)).product::<f64>();
    let rank = f64::from(mask.rank(x, y, z));
    let mut sum = 0.0;
    for (j, tone) in tones.iter().enumerate() {
        sum += tone;
        if rank < (sum * voxels + 0.5).floor() {
            return j as u32;
        }
    }
    tones.len() as u32
}

#[test]
fn types_go_to_other_threads() {
    fn send<T: Send>() {}
    fn both<T: Send + Sync>() {}
    both::<Mask>();
    both::<Halftone>();
    both::<Curve>();
    both::<Mixture>();
    send::<Diffuser>();
    send::<Shell<'static>>();
}

#[test]
fn each_voxel_is_one_comparison() {
    let mut random = Random::new(3);
    let options = MaskOptions { size: [16, 12, 4], kind: MaskKind::Isotropic, seed: 9, ..Default::default() };
    let masks = [Mask::builtin(), Mask::new(&options, None).unwrap()];
    for (round, mask) in masks.iter().cycle().take(8).enumerate() {
        let (width, height) = (1 + random.below(90), 1 + random.below(20));
        let (stride, place) =
            (width as usize + round, [random.below(100), random.below(100), random.below(100)]);
        let count = stride * height as usize;
        let first: Vec<f64> = (0..count).map(|_| 0.6 * unit(&mut random)).collect();
        let second: Vec<f64> = (0..count).map(|_| 0.4 * unit(&mut random)).collect();
        let stride_words = width.div_ceil(64) as usize;
        let words: Vec<u64> = (0..stride_words * height as usize).map(|_| random.next()).collect();
        let solid = Slice::new(&words, width, height, stride_words).unwrap();
        let [x0, y0, layer] = place;
        let planes = [&first[..], &second[..]];
        let tones = Tones {
            x0,
            y0,
            layer,
            stride,
            solid: Some(solid),
            ..Tones::new(width, height, ToneValues::F64(&planes))
        };
        let mut ids = vec![99; (width as usize + 3) * height as usize];
        let mut memory = vec![u64::MAX; 3 * words.len()];
        let mut slices: Vec<SliceMut<'_>> = memory
            .chunks_mut(words.len())
            .map(|part| SliceMut::new(part, width, height, stride_words).unwrap())
            .collect();
        let to = Materials::counted().with_ids(&mut ids, width as usize + 3).with_slices(&mut slices);
        let halftone = Halftone::new(mask, 3).unwrap();
        let counts = halftone.slice(&tones, to, Some(&mut Task::new().threads(2))).unwrap();
        let mut wanted = [0; 3];
        for y in 0..height {
            for x in 0..width {
                let at = y as usize * stride + x as usize;
                let id = match solid.get(x, y) {
                    true => 1 + material(mask, x0 + x, y0 + y, layer, &[first[at], second[at]]),
                    false => 0,
                };
                assert_eq!(u32::from(ids[y as usize * (width as usize + 3) + x as usize]), id);
                for (j, slice) in slices.iter().enumerate() {
                    assert_eq!(slice.as_slice().get(x, y), j as u32 + 1 == id);
                    wanted[j] += u64::from(j as u32 + 1 == id);
                }
            }
        }
        assert_eq!(counts, wanted, "round {round}");
    }
}

#[test]
fn what_was_wanted_of_a_mixture_comes_out_of_the_printer() {
    let fractions = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.4, 0.3, 0.3], [0.1, 0.6, 0.3]];
    let measured = [[2000.0, 1.2], [1.0, 1.1], [900.0, 0.9], [600.0, 1.05], [80.0, 1.0]];
    let mixture = Mixture::new(&fractions, &measured, Some(&[100.0, 0.1])).unwrap();
    assert!(mixture.simplex_count() >= 3);
    let halftone = Halftone::new(&Mask::builtin(), 3).unwrap();
    let (mut hint, mut random) = (0, Random::new(17));
    for _ in 0..12 {
        // A mixture within some simplex has properties that can be asked for.
        let corners = mixture.simplex(random.below(mixture.simplex_count() as u32) as usize).unwrap();
        let shares = [0.2 + unit(&mut random), 0.2 + unit(&mut random), 0.2 + unit(&mut random)];
        let sum: f64 = shares.iter().sum();
        let blend = |of: &dyn Fn(usize) -> f64| -> f64 {
            (0..3).map(|n| shares[n] / sum * of(corners[n] as usize)).sum()
        };
        let wanted = [blend(&|i| measured[i][0]), blend(&|i| measured[i][1])];
        let mixed = mixture.fractions(&wanted, Some(&mut hint)).unwrap();
        assert!(mixed.miss < 1e-9 && hint < mixture.simplex_count(), "{mixed:?}");
        // Over whole periods each material has its fraction, to a voxel.
        let planes = [[mixed.fractions[0]; 1024], [mixed.fractions[1]; 1024]];
        let mut counts = [0; 3];
        for layer in 0..32 {
            let planes = [&planes[0][..], &planes[1][..]];
            let tones = Tones { layer, ..Tones::new(32, 32, ToneValues::F64(&planes)) };
            let found = halftone.slice(&tones, Materials::counted(), None).unwrap();
            (0..3).for_each(|j| counts[j] += found[j]);
        }
        let printed = counts.map(|n| n as f64 / 32768.0);
        assert!((0..3).all(|j| (printed[j] - mixed.fractions[j]).abs() <= 1.0 / 32768.0), "{printed:?}");
        let (has, miss) = mixture.properties(&printed).unwrap();
        assert!((has[0] - wanted[0]).abs() < 0.3 && (has[1] - wanted[1]).abs() < 1e-4 && miss < 1e-6);
    }
    let far = mixture.fractions(&[5000.0, 1.2], None).unwrap();
    assert!(far.miss > 29.0 && (far.fractions[0] - 1.0).abs() < 1e-9, "{far:?}");
}

#[test]
fn a_curve_is_monotone_and_inverse_to_itself() {
    let mut random = Random::new(2);
    let samples: Vec<CurveSample> = (0..20)
        .map(|n| CurveSample {
            x: f64::from(n) / 19.0,
            y: -f64::from(n * n) + unit(&mut random),
            weight: 1.0,
        })
        .collect();
    let curve = Curve::new(&samples, Trend::Falling).unwrap();
    assert!(curve.change() < 1.0);
    let mut before = f64::INFINITY;
    for n in 0..200 {
        let (y, slope) = curve.value(f64::from(n) / 199.0).unwrap();
        assert!(y <= before && slope <= 0.0);
        before = y;
        let (x, miss) = curve.inverse(y).unwrap();
        assert!(miss.abs() < 1e-9 && (curve.value(x).unwrap().0 - y).abs() < 1e-9);
    }
    assert_eq!(Curve::new(&samples[..1], Trend::Auto).unwrap_err().kind(), ErrorKind::Argument);
    assert_eq!(curve.value(f64::NAN).unwrap_err().kind(), ErrorKind::Argument);
}

#[test]
fn diffusion_keeps_account_of_all_tones() {
    let (width, height) = (40u32, 24u32);
    let mut diffuser = Diffuser::new(width, height, 2, [0.05, 0.05, 0.03]).unwrap();
    let mut random = Random::new(21);
    let (mut asked, mut placed) = (0.0, 0);
    for _ in 0..20 {
        let tones: Vec<f32> = (0..width * height).map(|_| unit(&mut random) as f32).collect();
        asked += tones.iter().map(|&tone| f64::from(tone)).sum::<f64>();
        let planes = [&tones[..]];
        let tones = Tones::new(width, height, ToneValues::F32(&planes));
        placed += diffuser.slice(&tones, Materials::counted()).unwrap()[0];
    }
    let report = diffuser.report().unwrap();
    assert_eq!(report.len(), 2);
    assert!((report[0].asked - asked).abs() < 0.01 && report[0].placed == placed as f64, "{report:?}");
    for one in &report {
        assert!((one.placed + one.dropped + one.carried - one.asked).abs() < 0.01, "{one:?}");
    }
    assert!((asked - placed as f64).abs() < f64::from(width * height));
    let planes = [&[0u8; 4][..]];
    let small = Tones::new(2, 2, ToneValues::U8(&planes));
    assert_eq!(diffuser.slice(&small, Materials::counted()).unwrap_err().kind(), ErrorKind::Shape);
}

#[test]
fn a_shell_keeps_a_material_from_the_surface() {
    let lattice = Lattice::new(48, 48, 48, 0.5, 0.5).unwrap();
    let solid = Grid::from_fn(&lattice, |k, y, x| [k, y, x].iter().all(|i| (4..44).contains(i))).unwrap();
    let mesh: Mesh = solid.surface(0, None).unwrap();
    let mut near = Grid::new(&lattice).unwrap();
    let mut shell = Shell::new(&mesh, &lattice, 2.0).unwrap();
    for k in (0..48).rev() {
        shell.slice(k, near.slice_mut(k)).unwrap();
    }
    // Voxels within 2 mm of a face, and none of the middle.
    assert!(near.get(24, 24, 4) && near.get(24, 24, 7) && !near.get(24, 24, 12) && !near.get(24, 24, 24));
    let halftone = Halftone::new(&Mask::builtin(), 2).unwrap();
    let mut counts = Vec::new();
    for k in 0..48 {
        let keep = [KeepOut { place: near.slice(k), material: 0, instead: 1 }];
        let half = vec![127u8; 48 * 48];
        let planes = [&half[..]];
        let tones = Tones {
            layer: k,
            solid: Some(solid.slice(k)),
            keep_outs: &keep,
            ..Tones::new(48, 48, ToneValues::U8(&planes))
        };
        let mut ids = vec![0; 48 * 48];
        counts.extend(halftone.slice(&tones, Materials::counted().with_ids(&mut ids, 48), None).unwrap());
        for (n, id) in ids.into_iter().enumerate() {
            let (y, x) = (n as u32 / 48, n as u32 % 48);
            assert_eq!(id > 0, solid.get(k, y, x));
            assert!(id != 1 || !near.get(k, y, x));
        }
    }
    let uses = material_uses(&lattice, &counts, 2, Some(&[1.0, 2.0])).unwrap();
    assert_eq!(uses[0].voxels + uses[1].voxels, solid.count());
    assert!(uses[0].voxels > 5000 && (uses[1].volume_mm3 - uses[1].voxels as f64 * 0.125).abs() < 1e-6);
    assert!((uses[1].mass_g - uses[1].volume_mm3 * 0.002).abs() < 1e-9);
    assert_eq!(material_uses(&lattice, &counts[1..], 2, None).unwrap_err().kind(), ErrorKind::Shape);
    assert_eq!(material_uses(&lattice, &counts, 2, Some(&[1.0])).unwrap_err().kind(), ErrorKind::Shape);
    assert_eq!(Shell::new(&mesh, &lattice, -1.0).unwrap_err().kind(), ErrorKind::Argument);
    assert_eq!(shell.slice(48, near.slice_mut(0)).unwrap_err().kind(), ErrorKind::Argument);
}

#[test]
fn what_does_not_fit_is_refused() {
    let kind = |error: libsf::Error| error.kind();
    let halftone = Halftone::new(&Mask::builtin(), 3).unwrap();
    let (long, short) = ([0.25f64; 40], [0.25f64; 39]);
    let refused = |tones: &Tones<'_>| kind(halftone.slice(tones, Materials::counted(), None).unwrap_err());
    let pair = [&long[..], &short[..]];
    assert_eq!(refused(&Tones::new(10, 4, ToneValues::F64(&pair))), ErrorKind::Shape);
    let one = [&long[..]];
    assert_eq!(refused(&Tones::new(10, 4, ToneValues::F64(&one))), ErrorKind::Shape);
    let pair = [&long[..], &long[..]];
    let good = Tones::new(10, 4, ToneValues::F64(&pair));
    assert_eq!(refused(&Tones { stride: usize::MAX, ..good }), ErrorKind::Shape);
    assert_eq!(refused(&Tones { stride: 9, ..good }), ErrorKind::Argument);
    assert_eq!(refused(&Tones { height: 0, ..good }), ErrorKind::Argument);
    assert_eq!(refused(&Tones { width: 0, height: u32::MAX, stride: 0, ..good }), ErrorKind::Argument);
    let words = [0u64; 4];
    let other = Slice::new(&words, 11, 4, 1).unwrap();
    assert_eq!(refused(&Tones { solid: Some(other), ..good }), ErrorKind::Shape);
    let same = [KeepOut { place: Slice::new(&words, 10, 4, 1).unwrap(), material: 1, instead: 1 }];
    assert_eq!(refused(&Tones { keep_outs: &same, ..good }), ErrorKind::Argument);
    let wide = [KeepOut { place: other, material: 0, instead: 1 }];
    assert_eq!(refused(&Tones { keep_outs: &wide, ..good }), ErrorKind::Shape);
    let mut memory = [0u64; 12];
    let mut wrong: Vec<SliceMut<'_>> =
        memory.chunks_mut(4).map(|part| SliceMut::new(part, 11, 4, 1).unwrap()).collect();
    let to = Materials::counted().with_slices(&mut wrong);
    assert_eq!(kind(halftone.slice(&good, to, None).unwrap_err()), ErrorKind::Shape);
    let much = [0.9f64; 40];
    let pair = [&much[..], &much[..]];
    assert_eq!(refused(&Tones::new(10, 4, ToneValues::F64(&pair))), ErrorKind::Argument);
    let mut ids = [7u8; 39];
    let to = Materials::counted().with_ids(&mut ids, 10);
    assert_eq!(kind(halftone.slice(&good, to, None).unwrap_err()), ErrorKind::Shape);
    let mut memory = [0u64; 8];
    let mut slices: Vec<SliceMut<'_>> =
        memory.chunks_mut(4).map(|part| SliceMut::new(part, 10, 4, 1).unwrap()).collect();
    let to = Materials::counted().with_slices(&mut slices);
    assert_eq!(kind(halftone.slice(&good, to, None).unwrap_err()), ErrorKind::Shape);
    assert_eq!(ids, [7; 39]);
    assert_eq!(kind(Halftone::new(&Mask::builtin(), 1).unwrap_err()), ErrorKind::Argument);
    assert_eq!(kind(Mask::from_ranks([4, 2, 1], &[0; 7]).unwrap_err()), ErrorKind::Shape);
    assert_eq!(kind(Mask::from_ranks([4, 2, 1], &[0; 8]).unwrap_err()), ErrorKind::Format);
    assert_eq!(kind(Mask::from_ranks([u32::MAX; 3], &[0; 8]).unwrap_err()), ErrorKind::Shape);
    let odd = MaskOptions { size: [12, 4, 4], ..Default::default() };
    assert_eq!(kind(Mask::new(&odd, None).unwrap_err()), ErrorKind::Argument);
    let cancelled = Task::new();
    cancelled.canceller().cancel();
    let mut cancelled = cancelled;
    assert_eq!(
        kind(Mask::new(&MaskOptions::default(), Some(&mut cancelled)).unwrap_err()),
        ErrorKind::Cancelled
    );
    assert_eq!(kind(Mixture::new(&[[1.0, 0.0]], &[[1.0], [2.0]], None).unwrap_err()), ErrorKind::Shape);
    let flat = Mixture::new(&[[1.0, 0.0], [1.0, 0.0]], &[[1.0], [2.0]], None).unwrap_err();
    assert!(flat.kind() == ErrorKind::Argument && flat.message().len() > 20, "{flat}");
    let two = Mixture::new(&[[1.0, 0.0], [0.0, 1.0]], &[[1.0], [2.0]], None).unwrap();
    assert_eq!(kind(two.properties(&[1.0]).unwrap_err()), ErrorKind::Shape);
    assert_eq!(kind(two.fractions(&[1.0, 2.0], None).unwrap_err()), ErrorKind::Shape);
    assert_eq!(kind(two.simplex(1).unwrap_err()), ErrorKind::Argument);
}

#[test]
fn the_default_mask_is_the_one_that_is_built_in() {
    let mut shares = Vec::new();
    let mut task = Task::new().progress(|share| shares.push(share));
    let made = Mask::new(&MaskOptions::default(), Some(&mut task)).unwrap();
    drop(task);
    assert!(!shares.is_empty());
    let built = Mask::builtin();
    let mut ranks = Vec::new();
    for n in 0..32 * 32 * 32u32 {
        let (x, y, z) = (n % 32, n / 32 % 32, n / 1024);
        assert_eq!(made.rank(x, y, z), built.rank(x, y, z));
        ranks.push(built.rank(x, y, z));
    }
    let kept = Mask::from_ranks([32; 3], &ranks).unwrap();
    assert_eq!((kept.size(), kept.rank(70, 80, 90)), ([32; 3], built.rank(70, 80, 90)));
}
