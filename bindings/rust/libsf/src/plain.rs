// SPDX-License-Identifier: MIT
// Arrays of small structs that are the same bytes in both languages, so that they cross without a copy.
//
// Which structs these are bindings/rust/safe.py says, which writes both sides of the same fields: numbers
// only, of which every bit pattern is one. Sizes and alignments are compared when the crate is compiled.

use std::mem::{align_of, size_of};

use crate::error::Result;
use crate::{Error, ErrorKind};

/// A struct that is the same bytes in C.
///
/// # Safety
/// Both structs have the same fields in the same order, all plain numbers or arrays of them.
pub(crate) unsafe trait Plain: Copy {
    /// The struct of C.
    type C: Copy;
    /// Read by whoever casts, so that a struct that is not the same does not compile.
    const SAME: () =
        assert!(size_of::<Self>() == size_of::<Self::C>() && align_of::<Self>() == align_of::<Self::C>());
}

/// One value as C has it.
pub(crate) fn c<T: Plain>(value: &T) -> T::C {
    let () = T::SAME;
    unsafe { (value as *const T).cast::<T::C>().read() }
}

/// One value as Rust has it.
pub(crate) fn of<T: Plain>(value: &T::C) -> T {
    let () = T::SAME;
    unsafe { (value as *const T::C).cast::<T>().read() }
}

/// Where an array begins, as C has it.
pub(crate) fn first<T: Plain>(values: &[T]) -> *const T::C {
    let () = T::SAME;
    values.as_ptr().cast()
}

/// Where an array begins that C fills.
pub(crate) fn first_mut<T: Plain>(values: &mut [T]) -> *mut T::C {
    let () = T::SAME;
    values.as_mut_ptr().cast()
}

/// An array of C's, which may have no address where it is empty.
///
/// # Safety
/// There are so many values, and nobody writes them for as long as 'a.
pub(crate) unsafe fn array<'a, T: Plain>(first: *const T::C, count: usize) -> &'a [T] {
    let () = T::SAME;
    unsafe { elements(first.cast(), count) }
}

/// Elements of the library's arrays, which may have no address where there are none.
///
/// # Safety
/// There are so many, and nobody writes them for as long as 'a.
pub(crate) unsafe fn elements<'a, T>(first: *const T, count: usize) -> &'a [T] {
    if count == 0 {
        return &[];
    }
    unsafe { std::slice::from_raw_parts(first, count) }
}

/// Places for so many values, or what there is no memory for.
pub(crate) fn room<T: Copy + Default>(count: usize) -> Result<Vec<T>> {
    let mut made = Vec::new();
    let none = |_| Error::new(ErrorKind::Memory, format!("no memory for {count} values"));
    made.try_reserve_exact(count).map_err(none)?;
    made.resize(count, T::default());
    Ok(made)
}
