// SPDX-License-Identifier: MIT
// Cages of simple shapes, and functions of the place, which may panic: the cage is as it was then, and the
// panic goes on when C has returned.

use std::cell::RefCell;
use std::ffi::{c_int, c_void};

use crate::caught::Caught;
use crate::error::{check, Result};
use crate::memory::allocator;
use crate::plain::first;
use crate::{sys, Cage, SkeletonNode, SkeletonStrut};

/// A function of the caller's while a call runs.
struct Function<F> {
    call: RefCell<F>,
    caught: Caught,
}

impl<F> Function<F> {
    fn new(call: F) -> Function<F> {
        Function { call: RefCell::new(call), caught: Caught::default() }
    }

    fn user(&self) -> *mut c_void {
        (self as *const Function<F>).cast_mut().cast()
    }

    /// What a call said, once a panic has gone on.
    fn finish(self, status: sys::sf_status) -> Result<()> {
        self.caught.resume();
        check(status)
    }
}

unsafe extern "C" fn place<F: FnMut([f64; 3]) -> [f64; 3]>(
    user: *mut c_void,
    at_mm: *const f64,
    moved_mm: *mut f64,
) -> c_int {
    let function = unsafe { &*user.cast_const().cast::<Function<F>>() };
    let at = unsafe { at_mm.cast::<[f64; 3]>().read() };
    let answer = function.caught.guard(None, || Some((function.call.borrow_mut())(at)));
    answer.map_or(0, |moved| {
        unsafe { moved_mm.cast::<[f64; 3]>().write(moved) };
        1
    })
}

unsafe extern "C" fn value<F: FnMut([f64; 3], f64) -> f64>(
    user: *mut c_void,
    at_mm: *const f64,
    value: *mut f64,
) -> c_int {
    let function = unsafe { &*user.cast_const().cast::<Function<F>>() };
    let (at, was) = unsafe { (at_mm.cast::<[f64; 3]>().read(), value.read()) };
    let answer = function.caught.guard(None, || Some((function.call.borrow_mut())(at, was)));
    answer.map_or(0, |is| {
        unsafe { value.write(is) };
        1
    })
}

impl Cage {
    #[doc = words!(sf_cage_block: counts, low_mm, high_mm)]
    ///
    /// ```
    /// # fn main() -> libsf::Result<()> {
    /// let block = libsf::Cage::block([2, 3, 4], [0.0; 3], [2.0, 3.0, 4.0])?;
    /// assert_eq!((block.view().cell_count(), block.positions().len()), (24, 60));
    /// assert!((block.check()?.volume_mm3 - 24.0).abs() < 1e-12);
    /// # Ok(())
    /// # }
    /// ```
    pub fn block(counts: [u32; 3], low_mm: [f64; 3], high_mm: [f64; 3]) -> Result<Cage> {
        let (low, high) = (low_mm.as_ptr(), high_mm.as_ptr());
        let counts = counts.as_ptr();
        Cage::made(|made, _| unsafe { sys::sf_cage_block(counts, low, high, allocator(), made) })
    }

    #[doc = words!(sf_cage_extrude: vector_mm, layers)]
    pub fn extruded(&self, vector_mm: [f64; 3], layers: u32) -> Result<Cage> {
        let vector = vector_mm.as_ptr();
        Cage::made(|made, fault| unsafe {
            sys::sf_cage_extrude(self.c(), vector, layers, allocator(), made, fault)
        })
    }

    #[doc = words!(sf_cage_revolve: sectors, angle_rad)]
    pub fn revolved(&self, sectors: u32, angle_rad: f64) -> Result<Cage> {
        Cage::made(|made, fault| unsafe {
            sys::sf_cage_revolve(self.c(), sectors, angle_rad, allocator(), made, fault)
        })
    }

    #[doc = words!(sf_cage_skeleton: nodes, struts)]
    pub fn skeleton(nodes: &[SkeletonNode], struts: &[SkeletonStrut]) -> Result<Cage> {
        Cage::made(|made, fault| unsafe {
            let (to, among) = (first(struts), first(nodes));
            sys::sf_cage_skeleton(nodes.len(), among, struts.len(), to, allocator(), made, fault)
        })
    }

    #[doc = words!(sf_cage_map_positions)]
    pub fn map_positions(&mut self, function: impl FnMut([f64; 3]) -> [f64; 3]) -> Result<()> {
        fn call<F: FnMut([f64; 3]) -> [f64; 3]>(cage: &mut Cage, function: F) -> Result<()> {
            let (function, cage) = (Function::new(function), cage.c_mut());
            let user = function.user();
            let done = unsafe { sys::sf_cage_map_positions(cage, Some(place::<F>), user, allocator()) };
            function.finish(done)
        }
        call(self, function)
    }

    #[doc = words!(sf_cage_map_values: channel)]
    ///
    /// The function has the place and the value before.
    pub fn map_values(&mut self, channel: usize, function: impl FnMut([f64; 3], f64) -> f64) -> Result<()> {
        fn call<F: FnMut([f64; 3], f64) -> f64>(cage: &mut Cage, channel: usize, function: F) -> Result<()> {
            let (function, cage) = (Function::new(function), cage.c_mut());
            let (user, ask) = (function.user(), Some(value::<F> as _));
            let done = unsafe { sys::sf_cage_map_values(cage, channel, ask, user, allocator()) };
            function.finish(done)
        }
        call(self, channel, function)
    }
}
