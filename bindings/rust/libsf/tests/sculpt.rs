// SPDX-License-Identifier: MIT
// Why: a stroke of C's keeps the address of a tip, undo promises the same bits, and a session the same model
// wherever it is played. What this crate adds must not loosen any of it: a guard that is dropped or forgotten
// leaves a model that is as it was, and every change arrives with the counts that belong to it.

mod shapes;

use libsf::{
    Brush, BrushKind, Dab, ErrorKind, Grid, Lattice, Rule, RuleKind, Sculpt, SculptOptions, Session,
    SessionOptions, SessionStep, Stroke, Task, Tip, TipShape,
};
use shapes::{Random, Solid};
use std::f64::consts::FRAC_PI_4;

const KINDS: [BrushKind; 6] = [
    BrushKind::AddTrim,
    BrushKind::RemovePreserve,
    BrushKind::AddGrow,
    BrushKind::RemoveTrim,
    BrushKind::SmoothTrim,
    BrushKind::Paint,
];

fn lattice() -> Lattice {
    Lattice::new(70, 24, 30, 0.5, 0.5).unwrap()
}

fn dab(random: &mut Random) -> Dab {
    let mut at = |n: u32| random.below(n + 8) as i32 - 4;
    Dab { x: at(70), y: at(24), z: at(30) }
}

/// All that a model is.
fn state(model: &Sculpt) -> ([u8; 32], [u8; 32], Vec<u8>) {
    let hash = |grid: &Grid| grid.sha256(None).unwrap();
    (hash(model.printable()), hash(model.drawn()), model.materials().to_vec())
}

#[test]
fn types_go_to_other_threads() {
    fn both<T: Send + Sync>() {}
    both::<Sculpt>();
    both::<Session>();
    both::<Tip>();
    both::<Brush<'static>>();
    both::<Stroke<'static, 'static>>();
}

#[test]
fn what_is_printable_is_the_trim_of_what_is_drawn() {
    for (seed, rule) in [(1, Rule::box3()), (2, Rule::octagon(FRAC_PI_4)), (3, Rule::slack(0.9))] {
        let mut random = Random::new(seed);
        let options = SculptOptions { rule, keep_drawn: true, ..SculptOptions::new(lattice()) };
        let mut model = Sculpt::new(&options).unwrap();
        let tip = Tip::new(TipShape::Sphere, [4.0, 3.0, 3.0]).unwrap();
        for i in 0..40 {
            let brush = Brush { mirror_x: i % 3 == 0, ..Brush::new(KINDS[i % 6], &tip) };
            let before = Solid::of(model.printable());
            let change = model.stroke(&brush, &dab(&mut random).line(dab(&mut random)).unwrap()).unwrap();
            let after = Solid::of(model.printable());
            let mut trimmed = model.drawn().clone();
            let terms = libsf::Terms::new(rule).bed_layer(0);
            if trimmed.count() > 0 {
                trimmed.trim(terms, None).unwrap();
            }
            assert_eq!(trimmed, *model.printable(), "seed {seed} stroke {i}");
            let pairs = before.voxels.iter().zip(&after.voxels);
            let came = pairs.clone().filter(|(was, is)| !**was && **is).count() as u64;
            let went = pairs.filter(|(was, is)| **was && !**is).count() as u64;
            assert_eq!(change.added_voxels, came, "seed {seed} stroke {i}");
            assert_eq!(change.removed_voxels + change.lost_voxels, went, "seed {seed} stroke {i}");
            let drawn = model.drawn().to_bools();
            let named = model.materials().iter().map(|&m| m > 0);
            assert!(drawn.into_iter().eq(named), "seed {seed} stroke {i}");
        }
    }
}

#[test]
fn undo_and_redo_give_the_same_bits() {
    let mut random = Random::new(7);
    let mut model = Sculpt::new(&SculptOptions::new(lattice())).unwrap();
    let ball = Tip::new(TipShape::Sphere, [5.0; 3]).unwrap();
    let mut states = vec![state(&model)];
    for i in 0..48 {
        let brush = Brush::new(KINDS[i % 6], &ball).with_material(1 + i as u8);
        model.stroke(&brush, &dab(&mut random).line(dab(&mut random)).unwrap()).unwrap();
        if model.history().undo_count == states.len() {
            states.push(state(&model));
        }
    }
    assert!(states.len() > 12);
    for wanted in states.iter().rev().skip(1) {
        model.undo().unwrap();
        assert!(state(&model) == *wanted);
    }
    assert_eq!(model.undo().unwrap_err().kind(), ErrorKind::Infeasible);
    assert_eq!(model.history().redo_count, states.len() - 1);
    for wanted in &states[1..] {
        model.redo().unwrap();
        assert!(state(&model) == *wanted);
    }
    assert_eq!(model.redo().unwrap_err().kind(), ErrorKind::Infeasible);
}

#[test]
fn a_stroke_that_is_not_ended_is_given_up() {
    let mut model = Sculpt::new(&SculptOptions::new(lattice())).unwrap();
    let ball = Tip::new(TipShape::Sphere, [5.0; 3]).unwrap();
    model.stroke(&Brush::new(BrushKind::AddGrow, &ball), &[Dab { x: 30, y: 12, z: 15 }]).unwrap();
    let wanted = state(&model);
    {
        let hole = Tip::new(TipShape::Box, [3.0; 3]).unwrap();
        let mut stroke = model.begin(&Brush::new(BrushKind::RemoveTrim, &hole)).unwrap();
        assert!(stroke.dab(&[Dab { x: 30, y: 12, z: 8 }]).unwrap().lost_voxels > 0);
        assert_ne!(stroke.model().printable().sha256(None).unwrap(), wanted.0);
        let far = stroke.dab(&[Dab { x: i32::MAX, y: 0, z: 0 }]).unwrap_err();
        assert_eq!(far.kind(), ErrorKind::Argument);
        drop(stroke);
        assert!(state(&model) == wanted);
        let mut stroke = model.begin(&Brush::new(BrushKind::RemoveTrim, &hole)).unwrap();
        stroke.dab(&[Dab { x: 30, y: 12, z: 8 }]).unwrap();
        std::mem::forget(stroke);
    }
    // The tip is gone; whatever comes next gives the stroke up and does not look at it.
    let change = model.stroke(&Brush::new(BrushKind::Paint, &ball).with_material(9), &[]).unwrap();
    assert_eq!(change.added_voxels + change.lost_voxels, 0);
    assert!(state(&model) == wanted);
    let stroke = model.begin(&Brush::new(BrushKind::AddTrim, &ball)).unwrap();
    std::mem::forget(stroke);
    model.undo().unwrap();
    assert_eq!(model.drawn().count(), 0);
}

#[test]
fn what_is_out_of_range_is_refused() {
    let mut model = Sculpt::new(&SculptOptions::new(lattice())).unwrap();
    let kind = |error: libsf::Error| error.kind();
    assert_eq!(kind(Tip::new(TipShape::Sphere, [f64::NAN; 3]).unwrap_err()), ErrorKind::Argument);
    assert_eq!(kind(Tip::new(TipShape::Other(9), [1.0; 3]).unwrap_err()), ErrorKind::Argument);
    assert_eq!(kind(Tip::stamp(&[1, 2, 3], 2, 2, 2, 3).unwrap_err()), ErrorKind::Shape);
    assert_eq!(kind(Tip::stamp(&[], 0, 0, 0, 3).unwrap_err()), ErrorKind::Argument);
    let empty = Grid::new(&lattice()).unwrap();
    assert_eq!(kind(Tip::of_mask(&empty, Dab::default()).unwrap_err()), ErrorKind::Argument);
    assert_eq!(kind(model.replace(Some(&empty), Some(&[1])).unwrap_err()), ErrorKind::Shape);
    let other = Grid::new(&Lattice::new(8, 8, 8, 0.5, 0.5).unwrap()).unwrap();
    assert_eq!(kind(model.replace(Some(&other), None).unwrap_err()), ErrorKind::Shape);
    let tip = Tip::new(TipShape::Cone, [2.0; 3]).unwrap();
    for brush in [
        Brush { material: 0, ..Brush::new(BrushKind::AddTrim, &tip) },
        Brush { passes: 17, ..Brush::new(BrushKind::SmoothTrim, &tip) },
        Brush::new(BrushKind::Other(6), &tip),
    ] {
        assert_eq!(kind(model.stroke(&brush, &[]).unwrap_err()), ErrorKind::Argument);
    }
    let far = Dab { x: i32::MIN, y: 0, z: 0 };
    assert_eq!(kind(far.line(Dab::default()).unwrap_err()), ErrorKind::Argument);
    assert_eq!(BrushKind::RemovePreserve.to_string(), "remove-preserve");
    let deep = SculptOptions { bed_layer: 30, ..SculptOptions::new(lattice()) };
    assert_eq!(kind(Sculpt::new(&deep).unwrap_err()), ErrorKind::Argument);
}

#[test]
fn a_line_is_a_dab_for_each_step() {
    let line = Dab { x: 3, y: 2, z: 1 }.line(Dab { x: -4, y: 6, z: 1 }).unwrap();
    assert_eq!((line.len(), line[0], line[7].x), (8, Dab { x: 3, y: 2, z: 1 }, -4));
    let steps =
        line.windows(2).all(|two| two[0].x - two[1].x == 1 && (0..2).contains(&(two[1].y - two[0].y)));
    assert!(steps, "{line:?}");
    let rest = Dab { x: 5, y: 5, z: 5 };
    assert_eq!(rest.line(rest).unwrap(), [rest]);
}

/// A session of strokes of every kind, with undo and a shape put in between.
fn recorded() -> Session {
    let mut random = Random::new(11);
    let options =
        SessionOptions { rule: RuleKind::Octagon, keep_drawn: true, ..SessionOptions::new(lattice()) };
    let mut session = Session::new(&options).unwrap();
    let ball = session.add_tip(TipShape::Sphere, [4.5; 3]).unwrap();
    let shape = shapes::shape(&mut random, &lattice());
    let mask =
        session.add_mask(&Grid::from_fn(&lattice(), |k, _, x| k < 3 && x < 4).unwrap(), Dab::default());
    assert_eq!((ball, mask.unwrap()), (0, 1));
    session.add_shape(&shape, None).unwrap();
    for (i, kind) in KINDS.into_iter().cycle().take(30).enumerate() {
        let tip = random.below(2);
        let dabs = [dab(&mut random), dab(&mut random), dab(&mut random)];
        session.add_stroke(kind, tip, &dabs[..i % 4]).unwrap();
        if i % 5 == 4 {
            session.add_step(SessionStep::Undo).unwrap();
        }
    }
    session.add_step(SessionStep::Redo).unwrap();
    session.add_step(SessionStep::DropGhosts).unwrap();
    session
}

#[test]
fn a_session_gives_the_same_model_again() {
    let mut session = recorded();
    let counts = session.counts();
    assert_eq!((counts.tips, counts.strokes, counts.steps, counts.has_state), (2, 30, 39, false));
    assert_eq!(session.open().unwrap_err().kind(), ErrorKind::Infeasible);
    let mut shares = Vec::new();
    let mut task = Task::new().progress(|share| shares.push(share));
    let replayed = session.replay(Some(&mut task)).unwrap();
    drop(task);
    assert!(shares.len() > 10 && shares.windows(2).all(|pair| pair[0] <= pair[1]));
    assert!(replayed.printable().count() > 100);

    // By its steps, and by its strokes as a host does them by itself.
    let mut played = session.begin().unwrap();
    let mut by_hand = session.begin().unwrap();
    for step in 0..counts.steps {
        let change = session.play(step, &mut played).unwrap();
        match session.stroke(step) {
            Some((brush, dabs)) => assert_eq!(by_hand.stroke(&brush, dabs).unwrap(), change),
            None => assert_eq!(session.play(step, &mut by_hand).unwrap(), change),
        }
    }
    assert!(state(&played) == state(&replayed));
    assert!(state(&by_hand) == state(&replayed));

    // From its file, with the state at its end.
    session.keep_state(Some(&played)).unwrap();
    let mut text = Vec::new();
    session.write(&mut text).unwrap();
    let read = Session::read(&text[..], 0).unwrap();
    assert_eq!(read.options(), session.options());
    assert!(read.counts().has_state);
    assert!(state(&read.replay(None).unwrap()) == state(&replayed));
    assert!(state(&read.open().unwrap()) == state(&replayed));
    let mut again = Vec::new();
    read.write(&mut again).unwrap();
    assert_eq!(text, again);

    // Another state than that of the steps is noticed.
    session.keep_state(Some(&session.begin().unwrap())).unwrap();
    assert_eq!(session.replay(None).unwrap_err().kind(), ErrorKind::Format);
}

#[test]
fn a_broken_session_is_refused_with_its_line() {
    let mut text = Vec::new();
    recorded().write(&mut text).unwrap();
    let text = String::from_utf8(text).unwrap();
    let broken = text.replacen("stroke", "strike", 1);
    let error = Session::read(broken.as_bytes(), 0).unwrap_err();
    let line = broken.lines().position(|line| line.contains("strike")).unwrap() as u32 + 1;
    assert_eq!((error.kind(), error.line()), (ErrorKind::Format, Some(line)));
    assert_eq!(Session::read(text.as_bytes(), 100).unwrap_err().kind(), ErrorKind::Overflow);
    for end in [0, 1, text.len() / 2] {
        assert!(Session::read(&text.as_bytes()[..end], 0).is_err());
    }
    let mut session = recorded();
    assert_eq!(session.add_stroke(BrushKind::Paint, 2, &[]).unwrap_err().kind(), ErrorKind::Argument);
    assert_eq!(session.play(39, &mut session.begin().unwrap()).unwrap_err().kind(), ErrorKind::Argument);
    assert!(session.tip(2).is_none() && session.stroke(39).is_none() && session.stroke(0).is_none());
    let other = Session::new(&SessionOptions::new(Lattice::new(9, 9, 9, 0.5, 0.5).unwrap())).unwrap();
    assert_eq!(session.keep_state(Some(&other.begin().unwrap())).unwrap_err().kind(), ErrorKind::Shape);
}
