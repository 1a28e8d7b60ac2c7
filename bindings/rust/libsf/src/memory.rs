// SPDX-License-Identifier: MIT
// Memory of the library's: that of Rust's global allocator.
//
// C asks for blocks of a size and an alignment, and hands the size back with each that it frees, but not the
// alignment. So all blocks here have the one that C asks for, and a block that wanted more is refused. What
// a program counts, limits or replaces with `#[global_allocator]` is then what the library takes as well; and
// where there is none, C says so in an error, and nothing aborts.

use std::alloc::{alloc, dealloc, Layout};
use std::ffi::c_void;
use std::ptr;

use crate::sys;

/// What C aligns its blocks to.
const ALIGN: usize = 64;

struct Global(sys::sf_allocator);

// It holds functions that any thread may call, and no state.
unsafe impl Sync for Global {}

static GLOBAL: Global =
    Global(sys::sf_allocator { alloc: Some(take), free: Some(give_back), user: ptr::null_mut() });

unsafe extern "C" fn take(_: *mut c_void, size: usize, align: usize) -> *mut c_void {
    match Layout::from_size_align(size, ALIGN) {
        Ok(layout) if align <= ALIGN && size > 0 => unsafe { alloc(layout) }.cast(),
        _ => ptr::null_mut(),
    }
}

unsafe extern "C" fn give_back(_: *mut c_void, memory: *mut c_void, size: usize) {
    if let Ok(layout) = Layout::from_size_align(size, ALIGN) {
        unsafe { dealloc(memory.cast(), layout) }
    }
}

/// What every call that takes memory is given.
pub(crate) fn allocator() -> *const sys::sf_allocator {
    &GLOBAL.0
}
