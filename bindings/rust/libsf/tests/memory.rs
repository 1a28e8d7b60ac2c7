// SPDX-License-Identifier: MIT
// Why: memory of the library's is Rust's, and a binding is where it gets lost: a destroy that is forgotten, an
// object that a failed call has left, a panic that jumps over both. So the program counts every block, of Rust's
// and of C's, through a hundred thousand calls, good ones and bad ones; and blocks that C asks for are refused,
// one at a time, whereupon the call must say so, leave the shape as it was, and give back all that it had.

use libsf::{
    Blend, Brush, BrushKind, Cage, CarveOptions, Channel, CheckOptions, Checker, Claim, ContourFill,
    ContourStack, Curve, CurveSample, Dab, DensityOptions, DrainOptions, ErrorKind, Fill, Grid, Halftone,
    Handle, Inside, Landing, Lattice, Mask, Materials, Mesh, MeshFormat, Mixture, Operation, OrientOptions,
    PathCost, PlaceOptions, Pose, PreserveOptions, Property, RefineRules, RepairOptions, Result, Rule,
    Sampler, Sculpt, SculptOptions, Session, SessionOptions, Stance, StanceKind, StanceOptions, Stand,
    StandOptions, Task, Terms, Tip, TipShape, ToneValues, Tones, Trend, VoidsOptions, Voxel, Voxelizer,
    Weights, WeightsOptions,
};
use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;
use std::panic::{catch_unwind, resume_unwind, AssertUnwindSafe};

// Of this thread, so that those of the harness do not disturb.
thread_local! {
    static LIVE: Cell<isize> = const { Cell::new(0) };
    static ASKED: Cell<usize> = const { Cell::new(0) };
    static REFUSED: Cell<Option<usize>> = const { Cell::new(None) };
}

struct Counting;

/// Blocks of C's, and those that are made for it, are aligned so.
const FOR_C: usize = 64;

unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        if layout.align() == FOR_C {
            let number = ASKED.get();
            ASKED.set(number + 1);
            if REFUSED.get() == Some(number) {
                return std::ptr::null_mut();
            }
        }
        let memory = unsafe { System.alloc(layout) };
        if !memory.is_null() {
            LIVE.set(LIVE.get() + layout.size() as isize);
        }
        memory
    }

    unsafe fn dealloc(&self, memory: *mut u8, layout: Layout) {
        LIVE.set(LIVE.get() - layout.size() as isize);
        unsafe { System.dealloc(memory, layout) }
    }
}

#[global_allocator]
static COUNTING: Counting = Counting;

/// What calls are made on.
struct Things {
    grid: Grid,
    brush: Grid,
    mesh: Mesh,
    bar: Grid,
    stl: Vec<u8>,
}

impl Things {
    fn new() -> Result<Things> {
        let on = Lattice::new(12, 8, 10, 1.0, 1.0)?;
        let grid = Grid::from_fn(&on, |layer, _, x| x < 4 || layer >= 6)?;
        let brush = Grid::from_fn(&on, |layer, y, x| layer > 3 && y > 4 && x > 2)?;
        let mesh = grid.surface(0, None)?.merged()?;
        let bar = Grid::from_fn(&Lattice::new(16, 4, 4, 1.0, 1.0)?, |_, _, _| true)?;
        let mut stl = Vec::new();
        mesh.write(&mut stl, MeshFormat::Stl)?;
        Ok(Things { grid, brush, mesh, bar, stl })
    }

    fn handles(&self) -> [Handle<'static>; 2] {
        [Handle::point([1.5, 1.5, 1.5]), Handle::point([14.5, 1.5, 1.5])]
    }

    /// Changes a copy of the shape, which must be as it was where that fails.
    fn changed<T>(&self, call: impl FnOnce(&mut Grid) -> Result<T>) -> Result<T> {
        let mut copy = self.grid.try_clone()?;
        let done = call(&mut copy);
        assert!(done.is_ok() || copy == self.grid, "a call that failed has changed the shape");
        done
    }
}

/// What must fail in one way: good where it does, and an error where it fails in another.
fn refused<T>(done: Result<T>, kind: ErrorKind) -> Result<()> {
    match done {
        Err(error) if error.kind() == kind => Ok(()),
        Err(error) => Err(error),
        Ok(_) => panic!("it was not refused"),
    }
}

/// What must panic, and says so or fails before it does.
fn panics(call: impl FnOnce() -> Result<()>) -> Result<()> {
    match catch_unwind(AssertUnwindSafe(call)) {
        Ok(done) => done.map(|()| panic!("it did not panic")),
        Err(_) => Ok(()),
    }
}

/// Makes a call whose progress panics when it reports for the last time, and it is too late to stop it.
fn panics_last(call: impl Fn(&mut Task<'_>) -> Result<()>) -> Result<()> {
    let (reports, last) = (Cell::new(0), Cell::new(0));
    call(&mut Task::new().progress(|_| last.set(last.get() + 1)))?;
    let report = |_| {
        reports.set(reports.get() + 1);
        if reports.get() == last.get() {
            resume_unwind(Box::new("too late"))
        }
    };
    panics(|| call(&mut Task::new().progress(report)))
}

struct Broken;

impl std::io::Read for Broken {
    fn read(&mut self, _: &mut [u8]) -> std::io::Result<usize> {
        resume_unwind(Box::new("broken"))
    }
}

fn coarse() -> StandOptions {
    StandOptions { pitch_mm: 1.0, wall_mm: 1.0, rounds_max: 3, deform: false, ..StandOptions::default() }
}

type Step = fn(&Things) -> Result<()>;

/// Calls that are quick.
fn quick() -> Vec<(&'static str, Step)> {
    vec![
        ("new", |t| Grid::new(t.grid.lattice()).map(drop)),
        ("heights", |t| Grid::new(&t.grid.lattice().clone().with_heights(&[0.5; 10])?).map(drop)),
        ("clone", |t| t.grid.try_clone().map(drop)),
        ("no lattice", |_| refused(Lattice::new(0, 1, 1, 1.0, 1.0), ErrorKind::Argument)),
        ("bounds", |t| t.mesh.bounds().map(drop)),
        ("measure", |t| t.mesh.measure().map(drop)),
        ("topology", |t| t.mesh.topology().map(drop)),
        ("sum", |t| t.grid.sha256(None).map(drop)),
        ("moments", |t| t.grid.moments(None).map(drop)),
        ("body", |t| t.grid.body(None, None).map(drop)),
        ("short body", |t| refused(t.grid.body(Some(&[]), None), ErrorKind::Shape)),
        ("gradient", |t| t.mesh.body_gradient(1.0).map(drop)),
        ("check", |t| t.grid.check(Rule::box3(), None).map(drop)),
        ("bad check", |t| refused(t.grid.check(Rule::octagon(9.0), None), ErrorKind::Argument)),
        ("slack", |t| t.grid.check(Rule::slack(0.7), None).map(drop)),
        ("voids", |t| t.grid.voids(&VoidsOptions::default(), None).map(drop)),
        ("trim", |t| t.changed(|grid| grid.trim(Rule::slack(0.7), None)).map(drop)),
        ("merge", |t| t.mesh.merged().map(drop)),
        ("copy", |t| t.mesh.try_clone().map(drop)),
        ("write", |t| t.mesh.write(std::io::sink(), MeshFormat::Ply)),
        ("read", |t| Mesh::read(&t.stl[..], MeshFormat::Stl).map(drop)),
        ("bad read", |t| refused(Mesh::read(&t.stl[..200], MeshFormat::Stl), ErrorKind::Format)),
        ("stance", |t| {
            Stance::new(&t.mesh, &StanceOptions::default()).and_then(|stance| {
                stance.polygon()?;
                stance.halfspaces()?;
                stance.judge([1.0; 3]).map(drop)
            })
        }),
        ("hang", |t| {
            let options = StanceOptions { kind: StanceKind::Hang, ..StanceOptions::default() };
            Stance::new(&t.mesh, &options).map(drop)
        }),
        ("no stance", |t| {
            let options = StanceOptions { up: [0.0; 3], ..StanceOptions::default() };
            refused(Stance::new(&t.mesh, &options), ErrorKind::Argument)
        }),
        ("foot", |t| t.grid.foot([0.0, 0.0, 1.0], 0.0).map(drop)),
        ("base", |t| Handle::base(&t.bar).map(drop)),
        ("density", |t| t.grid.lattice().density(&DensityOptions::default(), None).map(drop)),
        ("printing", |t| t.grid.printing(&Default::default(), None).map(drop)),
        ("wall", |t| t.grid.wall_inside(1.0, None).map(drop)),
        ("broken reader", |_| panics(|| Mesh::read(Broken, MeshFormat::Stl).map(drop))),
    ]
}

/// Calls that take a while, or panic in the middle of it.
fn slow() -> Vec<(&'static str, Step)> {
    vec![
        ("grow", |t| t.changed(|grid| grid.grow(Rule::box3(), None)).map(drop)),
        ("repair", |t| {
            t.changed(|grid| grid.repair(Rule::box3(), &RepairOptions::default(), None)).map(drop)
        }),
        ("preserve", |t| {
            let mut whole = t.grid.try_clone()?;
            whole.trim(Rule::box3(), None)?;
            whole.preserve(&t.brush, Rule::box3(), &PreserveOptions::default(), None).map(drop)
        }),
        ("cannot grow", |t| {
            let terms = Terms::new(Rule::box3()).keep(&t.grid).forbid(&t.grid);
            let everywhere = Grid::from_fn(t.grid.lattice(), |_, _, _| true)?;
            refused(t.changed(|grid| grid.grow(terms.forbid(&everywhere), None)), ErrorKind::Infeasible)
        }),
        ("checker", |t| {
            let mut checker = Checker::new(t.grid.lattice(), CheckOptions::default())?;
            t.grid.slices().try_for_each(|slice| checker.push(slice))?;
            checker.report().map(drop)
        }),
        ("steepest", |t| t.grid.steepest(None, None).map(drop)),
        ("surface", |t| t.grid.surface(2, None).map(drop)),
        ("voxelize", |t| t.mesh.voxelize(1.0, 1.0, None).map(drop)),
        ("voxelizer", |t| {
            let mut copy = Grid::new(t.grid.lattice())?;
            let mut voxelizer = Voxelizer::new(&t.mesh, t.grid.lattice(), Fill::Auto)?;
            for (k, slice) in copy.slices_mut().enumerate() {
                voxelizer.slice(k as u32, slice)?;
            }
            Ok(())
        }),
        ("cut", |t| t.mesh.cut(2, 4.5).map(drop)),
        ("rest", |t| t.mesh.rest([4.0, 4.0, 7.0], &[[0.0, 0.0, 1.0]; 3]).map(drop)),
        ("rock", |t| {
            let options = StanceOptions { kind: StanceKind::Rock, ..StanceOptions::default() };
            Stance::new(&t.mesh, &options)?.judge([4.0, 4.0, 7.0]).map(drop)
        }),
        ("carve", |t| {
            let wall = t.grid.wall(&t.mesh, 1.0, None)?;
            let stance = Stance::new(&t.mesh, &StanceOptions::default())?;
            let options = CarveOptions { stances: &[&stance], ..CarveOptions::default() };
            let (mut hollow, _) = t.grid.carve(&wall, Rule::box3(), &options, None)?;
            hollow.clearance(&t.mesh, None)?;
            hollow.drain(None, &DrainOptions::new(1.0), None).map(drop)
        }),
        ("place", |t| t.bar.place_handles(&PlaceOptions::default(), None).map(drop)),
        ("bend", |t| {
            let handles = t.handles();
            let weights = Weights::new(&t.bar, &handles, &WeightsOptions::default(), None)?;
            let blend = Blend::new(&weights, &[[2.0; 3], [9.0, 2.0, 2.0]], None)?;
            let poses = [Pose::default(), Pose { shift_mm: [0.0, 0.0, 1.0], ..Pose::default() }];
            let bent = blend.apply(&poses, None)?;
            blend.pull(&poses, &bent, None)?;
            weights.unbend(&bent, &poses, 1e-6, None, None).map(drop)
        }),
        ("no weights", |t| {
            let far = [Handle::point([99.0; 3])];
            let made = Weights::new(&t.bar, &far, &WeightsOptions::default(), None);
            refused(made, ErrorKind::Infeasible)
        }),
        ("orient", |t| {
            let options =
                OrientOptions { direction_count: 6, coarse_count: 2, fine_count: 1, ..Default::default() };
            let options = OrientOptions { coarse_resolution: 8, resolution: 8, ..options };
            t.mesh.orient(&options, None).map(drop)
        }),
        ("stand", |t| {
            let inside = Inside::new().density(|_| 1.5).keep(|place| place[2] < 1.0);
            let mut shape = Stand::new(&t.mesh, &[StanceOptions::default()], &[], &coarse(), inside, None)?;
            shape.run(None)?;
            shape.cavity()?;
            shape.grid().map(drop)
        }),
        ("contours", |t| {
            let stack = ContourStack::of(&t.grid)?;
            stack.layer(0)?;
            stack.grid(t.grid.lattice(), ContourFill::Nonzero, None).map(drop)
        }),
        ("certificate", |t| {
            let mut after = t.grid.try_clone()?;
            after.trim(Rule::box3(), None)?;
            let terms = Terms::new(Rule::box3());
            let claim = Claim { terms, operation: Operation::Trim, before: Some(&t.grid) };
            after.certify(claim, None)?.write(std::io::sink())
        }),
        ("path", |t| {
            let mut finder = t.grid.path_finder(Rule::box3(), Landing::Any, None)?;
            finder.find(Voxel { x: 8, y: 4, z: 5 })?;
            let map = t.grid.path_map(Rule::box3(), Landing::Any, PathCost::Count, None)?;
            map.walk(Voxel { x: 8, y: 4, z: 5 }).map(drop)
        }),
        ("sculpt", |t| {
            let mut model = Sculpt::new(&SculptOptions::new(t.grid.lattice().clone()))?;
            let ball = Tip::new(TipShape::Sphere, [2.0; 3])?;
            model.stroke(&Brush::new(BrushKind::AddGrow, &ball), &[Dab { x: 5, y: 4, z: 7 }])?;
            model.undo().map(drop)
        }),
        ("session", |t| {
            let mut session = Session::new(&SessionOptions::new(t.grid.lattice().clone()))?;
            let ball = session.add_tip(TipShape::Sphere, [2.0; 3])?;
            session.add_stroke(BrushKind::AddGrow, ball, &[Dab { x: 5, y: 4, z: 7 }])?;
            let mut text = Vec::new();
            session.write(&mut text)?;
            Session::read(&text[..], 0)?.replay(None).map(drop)
        }),
        ("graded", |_| {
            let mut cage = Cage::block([1; 3], [0.0; 3], [8.0; 3])?;
            cage.add_property(&Channel::of_points(Property::density(), &[1000.0; 8]))?;
            cage.refined(1, RefineRules::Standard, None)?.view(1)?;
            let limit = cage.limit(RefineRules::Standard, None)?;
            limit.locator()?.find(&[[4.0; 3]], 0.0, None)?;
            let on = Lattice::new(8, 8, 8, 1.0, 1.0)?;
            let (mut grid, mut density) = (Grid::new(&on)?, [0.0; 64]);
            let mut sampler = Sampler::of_limit(&limit, &on, None, &[0], None)?;
            sampler.slice(4, grid.slice_mut(4), &mut density)
        }),
        ("halftone", |_| {
            let (halftone, half) = (Halftone::new(&Mask::builtin(), 2)?, [0.5; 64]);
            let planes = [&half[..]];
            let tones = Tones::new(8, 8, ToneValues::F64(&planes));
            halftone.slice(&tones, Materials::counted(), None).map(drop)
        }),
        ("mixture", |_| {
            let samples = [(0.0, 1.0), (1.0, 9.0)].map(|(x, y)| CurveSample { x, y, weight: 1.0 });
            Curve::new(&samples, Trend::Auto)?.inverse(5.0)?;
            let measured = [[2000.0, 1.2], [1.0, 1.1], [900.0, 0.9]];
            let pure = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
            Mixture::new(&pure, &measured, None)?.fractions(&[900.0, 1.0], None).map(drop)
        }),
        ("stand that panics", |t| {
            panics(|| {
                let inside = Inside::new().density(|_| resume_unwind(Box::new("no")));
                Stand::new(&t.mesh, &[StanceOptions::default()], &[], &coarse(), inside, None).map(drop)
            })
        }),
        ("progress that panics", |t| {
            panics(|| {
                let mut task = Task::new().progress(|_| resume_unwind(Box::new("no")));
                t.changed(|grid| grid.grow(Rule::box3(), Some(&mut task))).map(drop)
            })
        }),
        ("surface that panics last", |t| panics_last(|task| t.grid.surface(0, Some(task)).map(drop))),
        ("cover that panics last", |t| panics_last(|task| t.grid.cover(&t.mesh, Some(task)).map(drop))),
        ("weights that panic last", |t| {
            let (handles, options) = (t.handles(), WeightsOptions::default());
            panics_last(|task| Weights::new(&t.bar, &handles, &options, Some(task)).map(drop))
        }),
        ("stand that panics last", |t| {
            let (stances, handles) = ([StanceOptions::default()], [Handle::point([9.5, 4.5, 8.5])]);
            let options = StandOptions { deform: true, ..coarse() };
            panics_last(|task| {
                Stand::new(&t.mesh, &stances, &handles, &options, Inside::new(), Some(task)).map(drop)
            })
        }),
        ("cancelled", |t| {
            let mut task = Task::new();
            task.canceller().cancel();
            refused(t.changed(|grid| grid.grow(Rule::box3(), Some(&mut task))), ErrorKind::Cancelled)
        }),
    ]
}

#[test]
fn a_hundred_thousand_calls_lose_nothing() {
    let things = Things::new().unwrap();
    let (quick, slow) = (quick(), slow());
    let mut calls = 0;
    let mut run = |times: usize, steps: &[(&str, Step)]| {
        for _ in 0..times {
            for (name, step) in steps {
                let before = LIVE.get();
                step(&things).unwrap_or_else(|error| panic!("{name}: {error}"));
                assert_eq!(LIVE.get(), before, "{name}: bytes that are not given back");
                calls += 1;
            }
        }
    };
    // The first of each may leave what is made once for all.
    for (name, step) in quick.iter().chain(&slow) {
        step(&things).unwrap_or_else(|error| panic!("{name}: {error}"));
    }
    run(3300, &quick);
    run(30, &slow);
    assert!(calls > 100_000, "{calls} calls");
}

#[test]
fn any_block_may_be_refused() {
    let things = Things::new().unwrap();
    let mut refusals = 0;
    for (name, step) in quick().iter().chain(&slow()) {
        step(&things).unwrap_or_else(|error| panic!("{name}: {error}"));
        ASKED.set(0);
        step(&things).unwrap();
        let blocks = ASKED.get();
        // All where there are few, else some from the first to the last.
        for k in (0..blocks).step_by(1 + blocks / 64) {
            let before = LIVE.get();
            ASKED.set(0);
            REFUSED.set(Some(k));
            let done = step(&things);
            REFUSED.set(None);
            let kind = done.as_ref().err().map(|error| error.kind());
            drop(done);
            // Voxels that stand in the way are left out where there is no memory for them.
            let told = kind == Some(ErrorKind::Memory) || (kind.is_none() && name.starts_with("cannot"));
            assert!(told, "{name}, block {k} of {blocks}: {kind:?}");
            assert_eq!(LIVE.get(), before, "{name}, block {k} of {blocks}: bytes are not given back");
            refusals += 1;
        }
    }
    assert!(refusals > 500, "{refusals} refusals");
}
