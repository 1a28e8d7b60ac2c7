// SPDX-License-Identifier: MIT
// Panics that must not cross C.
//
// A closure of the caller's runs between two stretches of C, and a panic must not unwind through these. It
// is caught where the closure returns to C and kept; C is told to stop; and when its call has returned the
// panic goes on from there, as if C had never been in between.

use std::any::Any;
use std::panic::{catch_unwind, resume_unwind, AssertUnwindSafe};
use std::sync::Mutex;

/// A place for the first panic of a call.
#[derive(Default)]
pub(crate) struct Caught(Mutex<Option<Box<dyn Any + Send>>>);

impl Caught {
    /// Runs something of the caller's; `failed` stands for it when it panics.
    pub(crate) fn guard<T>(&self, failed: T, run: impl FnOnce() -> T) -> T {
        match catch_unwind(AssertUnwindSafe(run)) {
            Ok(value) => value,
            Err(panic) => {
                if let Ok(mut place) = self.0.lock() {
                    place.get_or_insert(panic);
                }
                failed
            }
        }
    }

    /// Whether something panicked.
    pub(crate) fn any(&self) -> bool {
        self.0.lock().map_or(true, |place| place.is_some())
    }

    /// Lets the panic go on, if there was one.
    pub(crate) fn resume(self) {
        self.pass_on();
    }

    /// The same of a place that serves one call after the other.
    pub(crate) fn pass_on(&self) {
        let panic = self.0.lock().map_or(None, |mut place| place.take());
        if let Some(panic) = panic {
            resume_unwind(panic);
        }
    }
}
