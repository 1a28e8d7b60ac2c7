// SPDX-License-Identifier: MIT
// Bytes from readers and to writers of Rust's.
//
// An error of theirs is kept and becomes the source of ours; a panic is kept and goes on after the call.

use std::cell::RefCell;
use std::ffi::{c_void, CString};
use std::fs::File;
use std::io::{self, Read, Write};
use std::path::Path;

use crate::caught::Caught;
use crate::error::{check_fault, Result};
use crate::memory::allocator;
use crate::{sys, Error, ErrorKind};

/// A reader or writer while a call runs.
struct Stream<'a, T> {
    inner: RefCell<&'a mut T>,
    failed: RefCell<Option<io::Error>>,
    caught: Caught,
}

impl<'a, T> Stream<'a, T> {
    fn new(inner: &'a mut T) -> Stream<'a, T> {
        Stream { inner: RefCell::new(inner), failed: RefCell::new(None), caught: Caught::default() }
    }

    /// What a step of the caller's comes to, as a status.
    fn step(&self, call: impl FnOnce(&mut T) -> io::Result<()>) -> sys::sf_status {
        if self.caught.any() {
            return sys::SF_ERR_IO;
        }
        let done = self.caught.guard(None, || Some(call(&mut self.inner.borrow_mut())));
        match done {
            Some(Ok(())) => sys::SF_OK,
            Some(Err(error)) => {
                self.failed.replace(Some(error));
                sys::SF_ERR_IO
            }
            None => sys::SF_ERR_IO,
        }
    }

    /// The result of the call, once a panic has gone on.
    fn finish(self, status: sys::sf_status, fault: &sys::sf_fault) -> Result<()> {
        self.caught.resume();
        check_fault(status, fault).map_err(|mut error| {
            error.cause = self.failed.into_inner();
            error
        })
    }
}

unsafe extern "C" fn read<T: Read>(
    user: *mut c_void,
    data: *mut c_void,
    capacity: usize,
    size: *mut usize,
) -> sys::sf_status {
    let stream = unsafe { &*user.cast_const().cast::<Stream<'_, T>>() };
    // A reader may look at what it is handed, so it has to hold something.
    let room = unsafe {
        data.cast::<u8>().write_bytes(0, capacity);
        std::slice::from_raw_parts_mut(data.cast::<u8>(), capacity)
    };
    stream.step(|from| loop {
        match from.read(room) {
            Err(error) if error.kind() == io::ErrorKind::Interrupted => continue,
            Err(error) => return Err(error),
            Ok(count) if count > capacity => return Err(io::ErrorKind::InvalidData.into()),
            Ok(count) => {
                unsafe { size.write(count) };
                return Ok(());
            }
        }
    })
}

unsafe extern "C" fn write<T: Write>(user: *mut c_void, data: *const c_void, size: usize) -> sys::sf_status {
    let stream = unsafe { &*user.cast_const().cast::<Stream<'_, T>>() };
    if size == 0 {
        return sys::SF_OK;
    }
    let bytes = unsafe { std::slice::from_raw_parts(data.cast::<u8>(), size) };
    stream.step(|to| to.write_all(bytes))
}

/// Makes a call that reads.
pub(crate) fn reading<T: Read>(
    from: &mut T,
    call: impl FnOnce(sys::sf_source, &mut sys::sf_fault) -> sys::sf_status,
) -> Result<()> {
    let stream = Stream::new(from);
    let user = (&stream as *const Stream<'_, T>).cast_mut().cast();
    let mut fault = crate::error::no_fault();
    let status = call(sys::sf_source { read: Some(read::<T>), user }, &mut fault);
    stream.finish(status, &fault)
}

/// Makes a call that writes.
pub(crate) fn writing<T: Write>(to: &mut T, call: impl FnOnce(sys::sf_sink) -> sys::sf_status) -> Result<()> {
    writing_with(to, |sink, _| call(sink))
}

/// Makes a call that writes, and may say more.
pub(crate) fn writing_with<T: Write>(
    to: &mut T,
    call: impl FnOnce(sys::sf_sink, &mut sys::sf_fault) -> sys::sf_status,
) -> Result<()> {
    let stream = Stream::new(to);
    let user = (&stream as *const Stream<'_, T>).cast_mut().cast();
    let mut fault = crate::error::no_fault();
    let status = call(sys::sf_sink { write: Some(write::<T>), user }, &mut fault);
    stream.finish(status, &fault)
}

/// Writes a file whole or not at all.
pub(crate) fn saving(path: &Path, call: impl FnOnce(sys::sf_sink) -> sys::sf_status) -> Result<()> {
    saving_with(path, |sink, _| call(sink))
}

/// The same by a call that may say more.
pub(crate) fn saving_with(
    path: &Path,
    call: impl FnOnce(sys::sf_sink, &mut sys::sf_fault) -> sys::sf_status,
) -> Result<()> {
    let name = c_path(path)?;
    let (mut save, mut fault) = (std::ptr::null_mut(), crate::error::no_fault());
    let begun = unsafe { sys::sf_save_begin(name.as_ptr(), allocator(), &mut save, &mut fault) };
    check_fault(begun, &fault)?;
    let save = Save(save);
    let status = call(unsafe { sys::sf_save_sink(save.0) }, &mut fault);
    check_fault(status, &fault)?;
    let save = std::mem::ManuallyDrop::new(save).0;
    check_fault(unsafe { sys::sf_save_commit(save, &mut fault) }, &fault)
}

/// A file being written, which is given up unless it is published: also where the call panics.
struct Save(*mut sys::sf_save);

impl Drop for Save {
    fn drop(&mut self) {
        unsafe { sys::sf_save_abort(self.0) }
    }
}

/// Opens a file to be read.
pub(crate) fn open(path: &Path) -> Result<File> {
    File::open(path).map_err(|cause| {
        let mut error = Error::new(ErrorKind::Io, format!("{}: {cause}", path.display()));
        error.cause = Some(cause);
        error
    })
}

/// A path as the C library takes it.
pub(crate) fn c_path(path: &Path) -> Result<CString> {
    #[cfg(unix)]
    let bytes = Some(std::os::unix::ffi::OsStrExt::as_bytes(path.as_os_str()));
    #[cfg(not(unix))]
    let bytes = path.to_str().map(str::as_bytes);
    let made = bytes.and_then(|bytes| CString::new(bytes).ok());
    let said = || format!("{}: no path that the C library takes", path.display());
    made.ok_or_else(|| Error::new(ErrorKind::Argument, said()))
}
