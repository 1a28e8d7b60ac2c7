// SPDX-License-Identifier: MIT
// Why: a job is read from C through a reader of Rust's for as long as it lives, at places that C chooses. So readers
// move, fail and panic here; what is written has to come back as it was, and what is not changed byte for byte.

mod shapes;

use libsf::{
    has_sl1, ContourFill, ContourFormat, ContourStack, ErrorKind, Grid, Job, JobFormat, JobOptions, Lattice,
    MeshLimits, Sl1Settings, Task,
};
use shapes::{lattice, shape, Random};
use std::fs;
use std::io::{self, Cursor, Read, Seek, SeekFrom};
use std::panic::{catch_unwind, AssertUnwindSafe};
use std::path::PathBuf;
use std::sync::atomic::{AtomicU8, Ordering};

fn grid() -> Grid {
    let lattice = Lattice::new(64, 40, 9, 0.05, 0.03).unwrap();
    let mut random = Random::new(23);
    Grid::from_fn(&lattice, |layer, y, x| x < 40 && (layer < 5 || y < 30) && random.below(40) > 0).unwrap()
}

/// A job in memory, where this build has them.
fn written(grid: &Grid) -> Option<Vec<u8>> {
    let mut file = Vec::new();
    match grid.write_sl1(&mut file, &Sl1Settings { name: "part-1".into(), ..Default::default() }, None) {
        Ok(()) => Some(file),
        Err(error) => {
            assert!(!has_sl1() && error.kind() == ErrorKind::Unsupported, "{error}");
            None
        }
    }
}

fn opened(file: &[u8]) -> libsf::Result<Job<'_>> {
    Job::open(Cursor::new(file), &JobOptions::default())
}

#[test]
fn a_job_comes_back_as_it_was() {
    fn send<T: Send>() {}
    send::<Job<'static>>();
    let grid = grid();
    let Some(file) = written(&grid) else { return };
    let mut job = opened(&file).unwrap();
    let info = job.info().unwrap();
    assert_eq!((info.format, info.has_greys, info.has_pitch), (JobFormat::Sl1, false, true));
    assert_eq!(job.lattice().shape(), grid.lattice().shape());
    assert!((job.lattice().pitch_mm()[0] - 0.05).abs() < 1e-9);
    let read = std::thread::scope(|scope| scope.spawn(move || job.grid().unwrap()).join().unwrap());
    assert!(read == grid);
    let mut job = opened(&file).unwrap();
    let mut pixels = vec![7; 64 * 40];
    job.read_grey(3, &mut pixels, 64).unwrap();
    for (n, pixel) in pixels.iter().enumerate() {
        assert_eq!(*pixel, if grid.get(3, n as u32 / 64, n as u32 % 64) { 255 } else { 0 });
    }
    assert_eq!(job.read_grey(3, &mut pixels[1..], 64).unwrap_err().kind(), ErrorKind::Shape);
    assert_eq!(job.read_grey(3, &mut pixels, 63).unwrap_err().kind(), ErrorKind::Argument);
    let mut other = Grid::new(&Lattice::new(64, 41, 9, 0.05, 0.03).unwrap()).unwrap();
    assert_eq!(job.read(3, other.slice_mut(0)).unwrap_err().kind(), ErrorKind::Shape);
    let few = JobOptions { layers_max: 8, ..Default::default() };
    assert_eq!(Job::open(Cursor::new(&file), &few).unwrap_err().kind(), ErrorKind::Overflow);
    let dark = JobOptions { threshold: 0, ..Default::default() };
    assert_eq!(Job::open(Cursor::new(&file), &dark).unwrap_err().kind(), ErrorKind::Argument);
    let wide = JobOptions { pitch_mm: Some([0.1, 0.2]), ..Default::default() };
    assert_eq!(Job::open(Cursor::new(&file), &wide).unwrap().lattice().pitch_mm(), [0.1, 0.2]);
}

#[test]
fn what_is_not_changed_stays_byte_for_byte() {
    let grid = grid();
    let Some(file) = written(&grid) else { return };
    let mut job = opened(&file).unwrap();
    let mut same = Vec::new();
    assert_eq!(job.rewrite(&grid, &mut same, None).unwrap(), 0);
    assert!(same == file);
    let mut changed = grid.clone();
    changed.slice_mut(2).set(5, 5, !grid.get(2, 5, 5)).unwrap();
    changed.slice_mut(8).fill(libsf::Rect { x0: 50, y0: 0, x1: 60, y1: 9 }, true).unwrap();
    let mut again = Vec::new();
    assert_eq!(job.rewrite(&changed, &mut again, None).unwrap(), 2);
    assert!(opened(&again).unwrap().grid().unwrap() == changed);
    let other = Grid::new(&Lattice::new(64, 40, 8, 0.05, 0.03).unwrap()).unwrap();
    assert_eq!(job.rewrite(&other, &mut again, None).unwrap_err().kind(), ErrorKind::Shape);
}

/// A folder of a test's own, which goes with it.
struct Folder(PathBuf);

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

#[test]
fn a_file_is_saved_over_itself_or_not_at_all() {
    let mut grid = grid();
    let Some(file) = written(&grid) else { return };
    let folder = Folder(std::env::temp_dir().join(format!("libsf-jobs-{}", std::process::id())));
    fs::create_dir_all(&folder.0).unwrap();
    let path = folder.0.join("part.sl1");
    fs::write(&path, &file).unwrap();
    let mut job = Job::load(&path).unwrap();
    let was = grid.get(1, 3, 3);
    grid.set(1, 3, 3, !was).unwrap();
    let mut stop = Task::new().progress(|share| assert!(share < 0.5, "stop"));
    let saved = catch_unwind(AssertUnwindSafe(|| job.save(&grid, &path, Some(&mut stop))));
    assert_eq!(saved.unwrap_err().downcast_ref::<&str>(), Some(&"stop"));
    assert!(fs::read(&path).unwrap() == file);
    assert_eq!(fs::read_dir(&folder.0).unwrap().count(), 1);
    assert_eq!(job.save(&grid, &path, None).unwrap(), 1);
    assert!(Job::load(&path).unwrap().grid().unwrap() == grid);
    assert_eq!(fs::read_dir(&folder.0).unwrap().count(), 1);
    assert_eq!(Job::load(folder.0.join("none")).unwrap_err().kind(), ErrorKind::Io);
}

/// A reader that goes wrong once it is told to.
struct Moody<'f> {
    file: Cursor<&'f [u8]>,
    mood: &'f AtomicU8,
}

impl Read for Moody<'_> {
    fn read(&mut self, room: &mut [u8]) -> io::Result<usize> {
        match self.mood.load(Ordering::Relaxed) {
            1 => Err(io::Error::new(io::ErrorKind::ConnectionReset, "gone")),
            2 => panic!("a reader's own"),
            // Short reads are no end.
            _ => {
                let some = room.len().min(7);
                self.file.read(&mut room[..some])
            }
        }
    }
}

impl Seek for Moody<'_> {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        self.file.seek(to)
    }
}

#[test]
fn readers_may_fail_and_panic() {
    let grid = grid();
    let Some(file) = written(&grid) else { return };
    let mood = AtomicU8::new(0);
    let set = |to| mood.store(to, Ordering::Relaxed);
    let from = || Moody { file: Cursor::new(&file[..]), mood: &mood };
    let mut job = Job::open(from(), &JobOptions::default()).unwrap();
    let mut read = Grid::new(grid.lattice()).unwrap();
    set(1);
    let error = job.read(0, read.slice_mut(0)).unwrap_err();
    assert_eq!(error.kind(), ErrorKind::Io);
    assert_eq!(std::error::Error::source(&error).unwrap().to_string(), "gone");
    assert_eq!(Job::open(from(), &JobOptions::default()).unwrap_err().kind(), ErrorKind::Io);
    set(2);
    let panic = catch_unwind(AssertUnwindSafe(|| job.read(0, read.slice_mut(0)))).unwrap_err();
    assert_eq!(panic.downcast_ref::<&str>(), Some(&"a reader's own"));
    let panic = catch_unwind(AssertUnwindSafe(|| Job::open(from(), &JobOptions::default()).is_ok()));
    assert!(panic.is_err());
    // The job is as good as its reader.
    set(0);
    assert!(job.grid().unwrap() == grid);
}

#[test]
fn a_job_that_is_cut_short_is_refused() {
    let none = opened(b"").unwrap_err();
    assert_eq!(none.kind(), ErrorKind::Format, "{none}");
    let Some(file) = written(&grid()) else { return };
    let mut told = 0;
    for end in (0..file.len()).step_by(97) {
        let error = opened(&file[..end]).unwrap_err();
        assert!([ErrorKind::Format, ErrorKind::Unsupported].contains(&error.kind()), "{end}: {error}");
        assert!(error.message().len() > 10, "{end}: {error}");
        told += 1;
    }
    assert!(told > 10);
}

#[test]
fn contours_come_back_from_their_file() {
    for seed in 1..20 {
        let mut random = Random::new(seed);
        let lattice = lattice(&mut random);
        let grid = shape(&mut random, &lattice);
        let stack = ContourStack::of(&grid).unwrap();
        for format in [ContourFormat::Text, ContourFormat::Binary] {
            let mut file = Vec::new();
            stack.write(&mut file, format).unwrap();
            let read = ContourStack::read(&file[..], &MeshLimits::default()).unwrap();
            assert_eq!(read.len(), stack.len(), "seed {seed} {format:?}");
            assert!(
                read.grid(&lattice, ContourFill::Nonzero, None).unwrap() == grid,
                "seed {seed} {format:?}"
            );
            let short = MeshLimits { bytes_max: file.len() as u64 / 2, ..Default::default() };
            assert_eq!(ContourStack::read(&file[..], &short).unwrap_err().kind(), ErrorKind::Overflow);
            let cut = ContourStack::read(&file[..file.len() / 2], &MeshLimits::default()).unwrap_err();
            assert_eq!(cut.kind(), ErrorKind::Format, "seed {seed} {format:?} {cut}");
        }
        assert_eq!(stack.write(Vec::new(), ContourFormat::Other(5)).unwrap_err().kind(), ErrorKind::Argument);
    }
    let path = std::env::temp_dir().join(format!("libsf-{}.cli", std::process::id()));
    let stack = ContourStack::of(&grid()).unwrap();
    stack.save(&path).unwrap();
    let read = ContourStack::load(&path).unwrap();
    fs::remove_file(&path).unwrap();
    assert_eq!(read.layer(8).unwrap().contours, stack.layer(8).unwrap().contours);
    let wrong = "$$HEADERSTART\n$$ASCII\n$$UNITS/1\n$$HEADEREND\n$$GEOMETRYSTART\n$$LAYER/x\n";
    let error = ContourStack::read(wrong.as_bytes(), &MeshLimits::default()).unwrap_err();
    assert!(error.kind() == ErrorKind::Format && error.line() == Some(6), "{error}");
}
