// SPDX-License-Identifier: MIT
// Long work: progress, a cancel from any thread, and threads of the caller's.
//
// The task of C lies in memory that the task and its cancellers share, so that a cancel reaches it while a
// call runs. Only the cancel flag is touched by several threads, and C does that atomically; the callbacks
// are written before a call and taken out after it, by the one who has the task for himself. While a call
// runs, `user` leads to what stands on its stack.
//
// The library trusts a hook for threads to run every piece once. A hook here is safe code and may do
// anything, so each piece is marked when it begins, and what the hook left out is run after it.

use std::cell::{RefCell, UnsafeCell};
use std::ffi::c_void;
use std::fmt;
use std::ptr::{self, addr_of_mut};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::Arc;

use crate::caught::Caught;
use crate::sys;

type Progress<'a> = dyn FnMut(f64) + 'a;
type Hook<'a> = dyn Fn(usize, &(dyn Fn(usize) + Sync)) + 'a;

#[doc = words!(sf_task)]
///
/// A task serves one call after the other. A panic of a callback stops the call and goes on when it has
/// returned; the task is cancelled then.
///
/// ```
/// # fn main() -> libsf::Result<()> {
/// use libsf::{Grid, Lattice, Rule, Task};
///
/// let mut grid = Grid::new(&Lattice::new(64, 64, 64, 0.1, 0.1)?)?;
/// let mut shares = Vec::new();
/// let mut task = Task::new().threads(4).progress(|share| shares.push(share));
/// grid.repair(Rule::octagon(0.7), &Default::default(), Some(&mut task))?;
/// drop(task);
/// assert!(shares.windows(2).all(|pair| pair[0] <= pair[1]));
/// # Ok(())
/// # }
/// ```
pub struct Task<'a> {
    shared: Canceller,
    progress: Option<Box<Progress<'a>>>,
    hook: Option<Box<Hook<'a>>>,
}

/// Stops what runs on a task, from any thread.
#[derive(Clone)]
pub struct Canceller(Arc<Shared>);

struct Shared(UnsafeCell<sys::sf_task>);

// The flag is atomic in C, and the rest is touched by the owner of the task alone.
unsafe impl Send for Shared {}
unsafe impl Sync for Shared {}

impl Canceller {
    #[doc = words!(sf_task_cancel)]
    pub fn cancel(&self) {
        unsafe { sys::sf_task_cancel(self.0 .0.get()) }
    }

    #[doc = words!(sf_task_is_cancelled)]
    pub fn is_cancelled(&self) -> bool {
        unsafe { sys::sf_task_is_cancelled(self.0 .0.get()) != 0 }
    }
}

impl fmt::Debug for Canceller {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(to, "Canceller({})", self.is_cancelled())
    }
}

impl Default for Task<'_> {
    fn default() -> Self {
        Task::new()
    }
}

impl<'a> Task<'a> {
    #[doc = words!(sf_task_default)]
    pub fn new() -> Task<'a> {
        let c = unsafe { sys::sf_task_default() };
        // Read from other threads only through C, which knows what is atomic.
        #[allow(clippy::arc_with_non_send_sync)]
        let shared = Canceller(Arc::new(Shared(UnsafeCell::new(c))));
        Task { shared, progress: None, hook: None }
    }

    /// Calls `report` on this thread with a share in [0, 1] that never falls during one call.
    pub fn progress(mut self, report: impl FnMut(f64) + 'a) -> Task<'a> {
        self.progress = Some(Box::new(report));
        self
    }

    /// Lends the library so many threads, the caller's own among them. The results are the same bytes.
    pub fn threads(self, count: usize) -> Task<'a> {
        self.parallel_for(move |pieces, body| spread(count, pieces, body))
    }

    /// Lends the library the threads of `hook`, which calls its second argument once with each number
    /// below its first, in any order and on any threads.
    ///
    /// What the hook leaves out is run when it has returned, and what it asks for twice is run once.
    pub fn parallel_for(mut self, hook: impl Fn(usize, &(dyn Fn(usize) + Sync)) + 'a) -> Task<'a> {
        self.hook = Some(Box::new(hook));
        self
    }

    /// What stops the task, to be kept elsewhere: in the progress itself, or in another thread.
    pub fn canceller(&self) -> Canceller {
        self.shared.clone()
    }

    #[doc = words!(sf_task_is_cancelled)]
    pub fn is_cancelled(&self) -> bool {
        self.shared.is_cancelled()
    }
}

impl fmt::Debug for Task<'_> {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        to.debug_struct("Task").field("is_cancelled", &self.is_cancelled()).finish_non_exhaustive()
    }
}

/// Pieces dealt out to threads; where the machine has no more of these, with fewer.
fn spread(threads: usize, count: usize, body: &(dyn Fn(usize) + Sync)) {
    let next = AtomicUsize::new(0);
    let work = || loop {
        let i = next.fetch_add(1, Ordering::Relaxed);
        if i >= count {
            return;
        }
        body(i);
    };
    std::thread::scope(|scope| {
        for _ in 1..threads.min(count) {
            if std::thread::Builder::new().spawn_scoped(scope, work).is_err() {
                break;
            }
        }
        work();
    });
}

/// What the callbacks of C need while a call runs.
struct Running<'t> {
    c: *mut sys::sf_task,
    progress: RefCell<Option<&'t mut Progress<'t>>>,
    hook: Option<&'t Hook<'t>>,
    caught: Caught,
}

unsafe extern "C" fn report(user: *mut c_void, fraction: f64) {
    let running = unsafe { &*user.cast_const().cast::<Running<'_>>() };
    if running.caught.any() {
        return;
    }
    running.caught.guard((), || {
        if let Ok(mut progress) = running.progress.try_borrow_mut() {
            if let Some(call) = progress.as_mut() {
                call(fraction);
            }
        }
    });
    if running.caught.any() {
        unsafe { sys::sf_task_cancel(running.c) };
    }
}

unsafe extern "C" fn share_out(
    user: *mut c_void,
    count: usize,
    body: sys::sf_task_body,
    context: *mut c_void,
) {
    struct Context(*mut c_void);
    unsafe impl Sync for Context {}
    impl Context {
        fn get(&self) -> *mut c_void {
            self.0
        }
    }
    let running = unsafe { &*user.cast_const().cast::<Running<'_>>() };
    let Some(body) = body else { return };
    let context = Context(context);
    let begun: Vec<AtomicBool> = (0..count).map(|_| AtomicBool::new(false)).collect();
    let once = |i: usize| {
        if begun.get(i).is_some_and(|flag| !flag.swap(true, Ordering::Relaxed)) {
            unsafe { body(context.get(), i) }
        }
    };
    if let (Some(hook), false) = (running.hook, running.caught.any()) {
        running.caught.guard((), || hook(count, &once));
        if running.caught.any() {
            unsafe { sys::sf_task_cancel(running.c) };
        }
    }
    (0..count).for_each(once);
}

/// Makes a call on a task, and lets a panic of its callbacks go on when the call has returned.
pub(crate) fn run<T>(task: Option<&mut Task<'_>>, call: impl FnOnce(*mut sys::sf_task) -> T) -> T {
    run_with(task, true, call)
}

/// The same without progress: for what is done a second time.
pub(crate) fn run_quietly<T>(task: Option<&mut Task<'_>>, call: impl FnOnce(*mut sys::sf_task) -> T) -> T {
    run_with(task, false, call)
}

fn run_with<T>(task: Option<&mut Task<'_>>, told: bool, call: impl FnOnce(*mut sys::sf_task) -> T) -> T {
    let Some(task) = task else { return call(ptr::null_mut()) };
    let c = task.shared.0 .0.get();
    let progress: Option<&mut Progress<'_>> = match &mut task.progress {
        Some(report) if told => Some(&mut **report),
        _ => None,
    };
    let running = Running {
        c,
        progress: RefCell::new(progress),
        hook: task.hook.as_ref().map(|hook| &**hook as &Hook<'_>),
        caught: Caught::default(),
    };
    let reports = running.progress.borrow().is_some();
    unsafe {
        addr_of_mut!((*c).progress).write(if reports { Some(report) } else { None });
        addr_of_mut!((*c).parallel_for).write(if running.hook.is_some() { Some(share_out) } else { None });
        addr_of_mut!((*c).user).write((&running as *const Running<'_>).cast_mut().cast());
    }
    let value = call(c);
    unsafe {
        addr_of_mut!((*c).progress).write(None);
        addr_of_mut!((*c).parallel_for).write(None);
        addr_of_mut!((*c).user).write(ptr::null_mut());
    }
    running.caught.resume();
    value
}
