// SPDX-License-Identifier: MIT
// Jobs of resin printers: layers as they are exposed, read at any place, and SL1 archives written.
//
// C keeps the address of the bytes that a job is read from as long as the job lives. So the reader lies in memory
// of its own, which moves with nobody and is freed after the job. Its errors and its panics are kept there while C
// runs, and go on when a call has returned.

use std::cell::RefCell;
use std::ffi::{c_void, CString};
use std::fmt;
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::mem::zeroed;
use std::ops::Deref;
use std::path::Path;
use std::ptr::NonNull;

use crate::caught::Caught;
use crate::error::{check, check_fault, no_fault, Result};
use crate::made::Made;
use crate::memory::allocator;
use crate::stream::{open, saving_with, writing_with};
use crate::task::run;
use crate::{sys, Error, ErrorKind, Grid, JobInfo, Lattice, SliceMut, Task};

#[doc = words!(sf_job_has_sl1)]
///
/// Where libsf is compiled into the crate that is what the feature `png` decides.
pub fn has_sl1() -> bool {
    unsafe { sys::sf_job_has_sl1() != 0 }
}

trait ReadSeek: Read + Seek {}

impl<T: Read + Seek> ReadSeek for T {}

/// What a job is read from.
struct Source<'r> {
    from: RefCell<Box<dyn ReadSeek + Send + 'r>>,
    failed: RefCell<Option<io::Error>>,
    caught: Caught,
}

/// A source in memory of its own, to which C has a pointer.
struct Placed<'r>(NonNull<Source<'r>>);

impl<'r> Placed<'r> {
    fn new(from: Box<dyn ReadSeek + Send + 'r>) -> Placed<'r> {
        let (from, failed, caught) = (RefCell::new(from), RefCell::new(None), Caught::default());
        let made = Box::leak(Box::new(Source { from, failed, caught }));
        Placed(NonNull::from(made))
    }
}

impl<'r> Deref for Placed<'r> {
    type Target = Source<'r>;

    fn deref(&self) -> &Source<'r> {
        unsafe { self.0.as_ref() }
    }
}

impl Drop for Placed<'_> {
    fn drop(&mut self) {
        drop(unsafe { Box::from_raw(self.0.as_ptr()) });
    }
}

impl Source<'_> {
    /// What became of a call, once a panic has gone on.
    fn finish(&self, result: Result<()>) -> Result<()> {
        self.caught.pass_on();
        let failed = self.failed.take();
        result.map_err(|mut error| {
            error.cause = error.cause.take().or(failed);
            error
        })
    }
}

unsafe extern "C" fn read_at(
    user: *mut c_void,
    offset: u64,
    data: *mut c_void,
    size: usize,
) -> sys::sf_status {
    let source = unsafe { &*user.cast_const().cast::<Source<'_>>() };
    if size == 0 {
        return sys::SF_OK;
    }
    if source.caught.any() {
        return sys::SF_ERR_IO;
    }
    // A reader may look at what it is handed, so it has to hold something.
    let room = unsafe {
        data.cast::<u8>().write_bytes(0, size);
        std::slice::from_raw_parts_mut(data.cast::<u8>(), size)
    };
    let done = source.caught.guard(None, || {
        let mut from = source.from.borrow_mut();
        Some(from.seek(SeekFrom::Start(offset)).and_then(|_| from.read_exact(room)))
    });
    match done {
        Some(Ok(())) => sys::SF_OK,
        Some(Err(error)) => {
            source.failed.replace(Some(error));
            sys::SF_ERR_IO
        }
        None => sys::SF_ERR_IO,
    }
}

#[doc = words!(sf_job_options)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JobOptions {
    /// Least grey that is solid, 1 to 255.
    pub threshold: u32,
    /// Size of a pixel along x and y; `None`: as the job says.
    pub pitch_mm: Option<[f64; 2]>,
    #[doc = words!(sf_job_options.bytes_max)]
    pub bytes_max: u64,
    #[doc = words!(sf_job_options.layers_max)]
    pub layers_max: u32,
}

impl Default for JobOptions {
    fn default() -> JobOptions {
        let c = unsafe { sys::sf_job_options_default() };
        let (threshold, bytes_max, layers_max) = (c.threshold, c.bytes_max, c.layers_max);
        JobOptions { threshold, pitch_mm: None, bytes_max, layers_max }
    }
}

#[doc = words!(sf_job)]
///
/// ```
/// # fn main() -> libsf::Result<()> {
/// use libsf::{has_sl1, Grid, Job, JobOptions, Lattice, Rule, Sl1Settings};
/// use std::io::Cursor;
///
/// let lattice = Lattice::new(64, 40, 8, 0.05, 0.05)?;
/// let grid = Grid::from_fn(&lattice, |layer, y, x| x < 20 && (layer < 6 || y < 30))?;
/// let mut file = Vec::new();
/// if has_sl1() {
///     grid.write_sl1(&mut file, &Sl1Settings::default(), None)?;
///     let mut job = Job::open(Cursor::new(&file), &JobOptions::default())?;
///     let mut read = job.grid()?;
///     assert!(read == grid && read.check(Rule::box3(), None)?.support_free());
///     // A layer that is changed is a new picture; all else of the job stays as it is.
///     read.set(7, 5, 5, false)?;
///     let mut again = Vec::new();
///     assert_eq!(job.rewrite(&read, &mut again, None)?, 1);
/// }
/// # Ok(())
/// # }
/// ```
pub struct Job<'r> {
    c: NonNull<sys::sf_job>,
    lattice: Lattice,
    source: Placed<'r>,
}

// Its reader may go to another thread, and all else is its own; it serves one at a time, so it is not Sync.
unsafe impl Send for Job<'_> {}

impl Job<'static> {
    /// Opens a file.
    pub fn load(path: impl AsRef<Path>) -> Result<Job<'static>> {
        Job::open(open(path.as_ref())?, &JobOptions::default())
    }
}

impl<'r> Job<'r> {
    #[doc = words!(sf_job_open)]
    pub fn open(mut from: impl Read + Seek + Send + 'r, options: &JobOptions) -> Result<Job<'r>> {
        let size = from.seek(SeekFrom::End(0)).map_err(|cause| {
            let mut error = Error::new(ErrorKind::Io, format!("the job has no end: {cause}"));
            error.cause = Some(cause);
            error
        })?;
        let source = Placed::new(Box::new(from));
        let user = source.0.as_ptr().cast();
        let bytes = sys::sf_bytes { read_at: Some(read_at), size, user };
        let mut c = unsafe { sys::sf_job_options_default() };
        c.threshold = options.threshold;
        c.pitch_mm = options.pitch_mm.unwrap_or([0.0; 2]);
        c.bytes_max = options.bytes_max;
        c.layers_max = options.layers_max;
        let (mut made, mut fault) = (Made::new(sys::sf_job_close), no_fault());
        let opened = unsafe { sys::sf_job_open(bytes, &c, allocator(), made.place(), &mut fault) };
        source.finish(check_fault(opened, &fault))?;
        let lattice = Lattice::of(&unsafe { sys::sf_job_lattice(made.get()) })?;
        Ok(Job { c: made.own()?, lattice, source })
    }

    #[doc = words!(sf_job_lattice)]
    pub fn lattice(&self) -> &Lattice {
        &self.lattice
    }

    #[doc = words!(sf_job_describe)]
    pub fn info(&self) -> Result<JobInfo> {
        let mut info: sys::sf_job_info = unsafe { zeroed() };
        check(unsafe { sys::sf_job_describe(self.c.as_ptr(), &mut info) })?;
        Ok(JobInfo::of(&info))
    }

    #[doc = words!(sf_job_read: k, slice)]
    pub fn read(&mut self, k: u32, mut slice: SliceMut<'_>) -> Result<()> {
        let mut fault = no_fault();
        let read = unsafe { sys::sf_job_read(self.c.as_ptr(), k, slice.c(), &mut fault) };
        self.source.finish(check_fault(read, &fault))
    }

    #[doc = words!(sf_job_read_grey: k, pixels, row_bytes)]
    pub fn read_grey(&mut self, k: u32, pixels: &mut [u8], row_bytes: usize) -> Result<()> {
        let (_, ny, nx) = self.lattice.shape();
        let needed = (ny - 1).checked_mul(row_bytes).and_then(|n| n.checked_add(nx));
        if needed.map_or(true, |needed| pixels.len() < needed) {
            let said = format!("{} pixels for {ny} rows of {row_bytes} bytes", pixels.len());
            return Err(Error::new(ErrorKind::Shape, said));
        }
        let mut fault = no_fault();
        let (c, to) = (self.c.as_ptr(), pixels.as_mut_ptr());
        let read = unsafe { sys::sf_job_read_grey(c, k, to, row_bytes, &mut fault) };
        self.source.finish(check_fault(read, &fault))
    }

    /// All layers.
    pub fn grid(&mut self) -> Result<Grid> {
        let mut grid = Grid::new(&self.lattice)?;
        for (k, slice) in grid.slices_mut().enumerate() {
            self.read(k as u32, slice)?;
        }
        Ok(grid)
    }

    #[doc = words!(sf_job_rewrite: grid)]
    ///
    /// It returns the number of layers that differ.
    pub fn rewrite(&mut self, grid: &Grid, mut to: impl Write, task: Option<&mut Task<'_>>) -> Result<u32> {
        let (mut changed, c) = (0, self.c.as_ptr());
        let written = writing_with(&mut to, |sink, fault| {
            run(task, |task| unsafe { sys::sf_job_rewrite(c, grid.c(), sink, task, &mut changed, fault) })
        });
        self.source.finish(written).map(|()| changed)
    }

    /// The same to a file, whole or not at all; it may be the one that the job is read from.
    pub fn save(&mut self, grid: &Grid, path: impl AsRef<Path>, task: Option<&mut Task<'_>>) -> Result<u32> {
        let (mut changed, c) = (0, self.c.as_ptr());
        let written = saving_with(path.as_ref(), |sink, fault| {
            run(task, |task| unsafe { sys::sf_job_rewrite(c, grid.c(), sink, task, &mut changed, fault) })
        });
        self.source.finish(written).map(|()| changed)
    }
}

impl Drop for Job<'_> {
    fn drop(&mut self) {
        unsafe { sys::sf_job_close(self.c.as_ptr()) }
    }
}

impl fmt::Debug for Job<'_> {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        to.debug_struct("Job").field("lattice", &self.lattice).finish_non_exhaustive()
    }
}

#[doc = words!(sf_sl1_settings)]
#[derive(Clone, Debug, PartialEq)]
pub struct Sl1Settings {
    /// Of the job: letters, digits, - and _.
    pub name: String,
    #[doc = words!(sf_sl1_settings.exposure_s)]
    pub exposure_s: f64,
    #[doc = words!(sf_sl1_settings.first_exposure_s)]
    pub first_exposure_s: f64,
    #[doc = words!(sf_sl1_settings.fade_layers)]
    pub fade_layers: u32,
}

impl Default for Sl1Settings {
    fn default() -> Sl1Settings {
        let c = unsafe { sys::sf_sl1_settings_default() };
        let (exposure_s, first_exposure_s, fade_layers) = (c.exposure_s, c.first_exposure_s, c.fade_layers);
        Sl1Settings { name: "job".into(), exposure_s, first_exposure_s, fade_layers }
    }
}

impl Grid {
    #[doc = words!(sf_sl1_write: settings)]
    pub fn write_sl1(
        &self,
        mut to: impl Write,
        settings: &Sl1Settings,
        task: Option<&mut Task<'_>>,
    ) -> Result<()> {
        let name = CString::new(settings.name.as_str())
            .map_err(|_| Error::new(ErrorKind::Argument, format!("{:?} holds a 0", settings.name)))?;
        let mut c = unsafe { sys::sf_sl1_settings_default() };
        c.name = name.as_ptr();
        c.exposure_s = settings.exposure_s;
        c.first_exposure_s = settings.first_exposure_s;
        c.fade_layers = settings.fade_layers;
        writing_with(&mut to, |sink, fault| {
            run(task, |task| unsafe { sys::sf_sl1_write(self.c(), &c, allocator(), sink, task, fault) })
        })
    }
}
