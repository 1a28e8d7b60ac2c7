// SPDX-License-Identifier: MIT
// An object of C's between the call that makes it and the type that owns it.
//
// A panic of a callback goes on when its call has returned, also where the call had succeeded nevertheless:
// the cancel came too late. What it made is freed here then.

use std::ptr::{self, NonNull};

use crate::error::Result;
use crate::grid::own;

/// A place for what a call makes, freed unless somebody owns it.
pub(crate) struct Made<T> {
    c: *mut T,
    destroy: unsafe extern "C" fn(*mut T),
}

impl<T> Made<T> {
    /// Nothing yet; `destroy` frees what comes, and does nothing for NULL.
    pub(crate) fn new(destroy: unsafe extern "C" fn(*mut T)) -> Made<T> {
        Made { c: ptr::null_mut(), destroy }
    }

    /// Where C puts it.
    pub(crate) fn place(&mut self) -> *mut *mut T {
        &mut self.c
    }

    /// What is there, if anything.
    pub(crate) fn get(&self) -> *const T {
        self.c
    }

    /// What a call that succeeded has made, now somebody's.
    pub(crate) fn own(mut self) -> Result<NonNull<T>> {
        own(std::mem::replace(&mut self.c, ptr::null_mut()))
    }
}

impl<T> Drop for Made<T> {
    fn drop(&mut self) {
        unsafe { (self.destroy)(self.c) }
    }
}
