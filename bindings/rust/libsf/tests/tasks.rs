// SPDX-License-Identifier: MIT
// Why: callbacks of Rust's are called from C, which no panic may cross, and C trusts what they do. So they
// panic here, cancel, come from other threads, and break the rules; the library must return each time,
// leave the shape as it was, and give the same bytes for whatever threads there are.

use libsf::{Canceller, ErrorKind, Grid, Lattice, Mesh, MeshFormat, Rule, Task};
use std::cell::Cell;
use std::io::{self, Read, Write};
use std::panic::{catch_unwind, AssertUnwindSafe};

/// Two towers with a roof that hangs between them.
fn gate() -> Grid {
    let lattice = Lattice::new(150, 40, 90, 0.5, 0.5).unwrap();
    Grid::from_fn(&lattice, |layer, _, x| layer >= 80 || x % 100 < 20).unwrap()
}

fn said(panic: Box<dyn std::any::Any + Send>) -> String {
    panic.downcast_ref::<&str>().map_or_else(String::new, |text| text.to_string())
}

#[test]
fn a_panic_of_the_progress_goes_on_after_the_call() {
    let mut grid = gate();
    let as_it_was = grid.clone();
    let calls = Cell::new(0);
    let mut task = Task::new().progress(|share| {
        calls.set(calls.get() + 1);
        assert!(share < 0.3, "enough");
    });
    let panic = catch_unwind(AssertUnwindSafe(|| grid.grow(Rule::box3(), Some(&mut task)))).unwrap_err();
    assert_eq!(said(panic), "enough");
    assert!(calls.get() > 1);
    assert!(task.is_cancelled());
    assert_eq!(grid, as_it_was);
    // The task is spent, and the shape is not.
    let refused = grid.grow(Rule::box3(), Some(&mut task)).unwrap_err();
    assert_eq!(refused.kind(), ErrorKind::Cancelled);
    drop(task);
    grid.grow(Rule::box3(), None).unwrap();
    assert!(grid.check(Rule::box3(), None).unwrap().support_free());
}

#[test]
fn a_panic_of_a_thread_goes_on_after_the_call() {
    let grid = gate();
    let mut task = Task::new().parallel_for(|_, _| panic!("no threads today"));
    let panic = catch_unwind(AssertUnwindSafe(|| grid.moments(Some(&mut task)))).unwrap_err();
    assert_eq!(said(panic), "no threads today");
}

#[test]
fn a_cancel_stops_the_call_from_within_and_from_another_thread() {
    let mut grid = gate();
    let as_it_was = grid.clone();
    let task = Task::new();
    let cancel = task.canceller();
    let mut task = task.progress(move |share| {
        if share > 0.2 {
            cancel.cancel();
        }
    });
    let stopped = grid.grow(Rule::box3(), Some(&mut task)).unwrap_err();
    assert_eq!(stopped.kind(), ErrorKind::Cancelled);
    assert_eq!(grid, as_it_was);

    let task = Task::new();
    let cancel: Canceller = task.canceller();
    let mut task = task.progress(|_| {
        let cancel = cancel.clone();
        std::thread::spawn(move || cancel.cancel()).join().unwrap();
    });
    let stopped = grid.repair(Rule::box3(), &Default::default(), Some(&mut task)).unwrap_err();
    assert_eq!(stopped.kind(), ErrorKind::Cancelled);
    assert_eq!(grid, as_it_was);
}

#[test]
fn threads_change_nothing() {
    let grid = gate();
    let alone = grid.moments(None).unwrap();
    let backwards = |count: usize, body: &(dyn Fn(usize) + Sync)| (0..count).rev().for_each(body);
    let lazy = |count: usize, body: &(dyn Fn(usize) + Sync)| (0..count / 2).for_each(body);
    let eager = |count: usize, body: &(dyn Fn(usize) + Sync)| {
        (0..count + 3).chain(0..count).for_each(body);
    };
    let tasks = [
        Task::new().threads(0),
        Task::new().threads(3),
        Task::new().parallel_for(backwards),
        Task::new().parallel_for(lazy),
        Task::new().parallel_for(eager),
    ];
    let mesh = grid.surface(2, None).unwrap();
    let mut wanted = Grid::new(grid.lattice()).unwrap();
    wanted.voxelize(&mesh, libsf::Fill::Auto, None).unwrap();
    for mut task in tasks {
        assert_eq!(grid.moments(Some(&mut task)).unwrap(), alone);
        let mut voxels = Grid::new(grid.lattice()).unwrap();
        voxels.voxelize(&mesh, libsf::Fill::Auto, Some(&mut task)).unwrap();
        assert_eq!(voxels, wanted);
    }
}

struct Broken(&'static str);

impl Read for Broken {
    fn read(&mut self, room: &mut [u8]) -> io::Result<usize> {
        self.write(room)
    }
}

impl Write for Broken {
    fn write(&mut self, _: &[u8]) -> io::Result<usize> {
        match self.0 {
            "panic" => panic!("a reader's own"),
            said => Err(io::Error::new(io::ErrorKind::ConnectionReset, said)),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

#[test]
fn readers_and_writers_may_fail_and_panic() {
    let mesh = gate().surface(0, None).unwrap();
    let results = [
        Mesh::read(Broken("gone"), MeshFormat::Auto).map(|_| ()),
        mesh.write(Broken("gone"), MeshFormat::Ply),
    ];
    for result in results {
        let error = result.unwrap_err();
        assert_eq!(error.kind(), ErrorKind::Io);
        let cause = std::error::Error::source(&error).unwrap();
        assert_eq!(cause.downcast_ref::<io::Error>().unwrap().to_string(), "gone");
        assert_eq!(io::Error::from(error).kind(), io::ErrorKind::ConnectionReset);
    }
    let read = catch_unwind(|| Mesh::read(Broken("panic"), MeshFormat::Auto).map(|_| ()));
    assert_eq!(said(read.unwrap_err()), "a reader's own");
    let write = AssertUnwindSafe(|| mesh.write(Broken("panic"), MeshFormat::Ply));
    assert_eq!(said(catch_unwind(write).unwrap_err()), "a reader's own");
}
