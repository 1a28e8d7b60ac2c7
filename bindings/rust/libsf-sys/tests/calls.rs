// SPDX-License-Identifier: MIT
// Why: externs that agree on every number may still pass arguments otherwise than C does. Here values go
// in and come back in every way that the interface has: plain numbers, structs by value and by pointer,
// arrays, new objects, texts, callbacks of Rust that C calls, and errors.

use core::ffi::{c_int, c_void, CStr};
use core::{mem, ptr};
use libsf_sys::*;
use std::alloc::{alloc, dealloc, Layout};
use std::cell::{Cell, RefCell};

fn lattice(n: u32) -> sf_lattice {
    sf_lattice {
        nx: n,
        ny: n,
        nz: n,
        pitch_x_mm: 0.5,
        pitch_y_mm: 0.5,
        layer_mm: 0.25,
        heights_mm: ptr::null(),
        origin_mm: [-1.0, 2.0, 3.5],
    }
}

fn text(pointer: *const core::ffi::c_char) -> &'static str {
    assert!(!pointer.is_null());
    unsafe { CStr::from_ptr(pointer) }.to_str().unwrap()
}

#[test]
fn texts_come_out() {
    let said = CStr::from_bytes_with_nul(SF_VERSION_STRING).unwrap().to_str().unwrap();
    assert_eq!(text(unsafe { sf_version() }), said);
    assert_eq!(text(unsafe { sf_status_name(SF_ERR_SHAPE) }), "SF_ERR_SHAPE");
    assert_eq!(text(unsafe { sf_status_name(-7) }), "SF_STATUS_UNKNOWN");
}

#[test]
fn structs_go_by_value_and_by_pointer() {
    let given = lattice(40);
    let mut grid = ptr::null_mut();
    unsafe {
        assert_eq!(sf_grid_create(&given, ptr::null(), &mut grid), SF_OK);
        let back = sf_grid_lattice(grid);
        assert_eq!((back.nx, back.ny, back.nz), (40, 40, 40));
        assert_eq!(back.origin_mm, given.origin_mm);
        assert_eq!(back.layer_mm, 0.25);
        assert_eq!(sf_lattice_layer_bottom(&given, 4), 4.5);
        // A tower, and beside it what hangs in the air.
        for k in 0..10 {
            let rect = sf_rect { x0: 3, y0: 4, x1: 9, y1: 8 };
            assert_eq!(sf_slice_fill(sf_grid_slice(grid, k), rect, 1), SF_OK);
        }
        let far = sf_rect { x0: 30, y0: 30, x1: 33, y1: 31 };
        assert_eq!(sf_slice_fill(sf_grid_slice(grid, 9), far, 1), SF_OK);
        assert_eq!(sf_grid_popcount(grid), 243);
        let all = sf_grid_bounds(grid);
        assert_eq!((all.x0, all.y0, all.z0, all.x1, all.y1, all.z1), (3, 4, 0, 33, 31, 10));
        let mut moments: sf_moments = mem::zeroed();
        assert_eq!(sf_grid_measure(grid, ptr::null_mut(), &mut moments), SF_OK);
        assert_eq!((moments.count, moments.z.low, moments.z.high), (243, 24 * 45 + 27, 0));
        let mut report: sf_trim_report = mem::zeroed();
        let terms = sf_terms_default();
        assert_eq!(
            sf_grid_trim_on(grid, &terms, ptr::null(), ptr::null_mut(), ptr::null_mut(), &mut report),
            SF_OK
        );
        assert_eq!(sf_grid_popcount(grid), 240);
        sf_grid_destroy(grid);
        sf_grid_destroy(ptr::null_mut());
    }
}

#[test]
fn failures_are_numbers_and_sentences() {
    let mut grid: *mut sf_grid = ptr::null_mut();
    let none = sf_lattice { nx: 0, ..lattice(4) };
    let mut rule: sf_rule = unsafe { mem::zeroed() };
    let mut fault: sf_fault = unsafe { mem::zeroed() };
    let space = lattice(4);
    unsafe {
        assert_eq!(sf_grid_create(&none, ptr::null(), &mut grid), SF_ERR_ARGUMENT);
        assert!(grid.is_null());
        let made = sf_rule_make(SF_RULE_OCTAGON, 9.0, &space, ptr::null_mut(), &mut rule, &mut fault);
        assert_eq!(made, SF_ERR_ARGUMENT);
    }
    assert_eq!(fault.status, SF_ERR_ARGUMENT);
    assert!(text(fault.message.as_ptr()).len() > 10);
}

#[test]
fn bytes_come_from_rust() {
    unsafe extern "C" fn read(
        user: *mut c_void,
        data: *mut c_void,
        capacity: usize,
        size: *mut usize,
    ) -> sf_status {
        let left = &mut *user.cast::<&[u8]>();
        let taken = left.len().min(capacity).min(7);
        ptr::copy_nonoverlapping(left.as_ptr(), data.cast(), taken);
        *left = &left[taken..];
        *size = taken;
        SF_OK
    }
    let off = b"OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
    let mut left: &[u8] = off;
    let source = sf_source { read: Some(read), user: (&mut left as *mut &[u8]).cast() };
    let mut mesh = ptr::null_mut();
    unsafe {
        let status =
            sf_mesh_read(source, SF_MESH_FORMAT_AUTO, ptr::null(), ptr::null(), &mut mesh, ptr::null_mut());
        assert_eq!(status, SF_OK);
        let view = sf_mesh_get_view(mesh);
        assert_eq!((view.vertex_count, view.triangle_count), (4, 4));
        assert_eq!(core::slice::from_raw_parts(view.vertices, 12)[3..6], [1.0, 0.0, 0.0]);
        let mut mass: sf_mass = mem::zeroed();
        assert_eq!(sf_mesh_measure(view, &mut mass), SF_OK);
        assert!((mass.volume_mm3 - 1.0 / 6.0).abs() < 1e-15);
        sf_mesh_destroy(mesh);
    }
}

#[test]
fn memory_comes_from_rust_and_goes_back() {
    struct Ledger {
        live: Cell<usize>,
        most: Cell<usize>,
    }
    unsafe extern "C" fn take(user: *mut c_void, size: usize, align: usize) -> *mut c_void {
        let ledger = &*user.cast::<Ledger>();
        ledger.live.set(ledger.live.get() + size);
        ledger.most.set(ledger.most.get().max(ledger.live.get()));
        // What it is freed with does not say the alignment, so all have the same.
        assert!(align <= 64);
        alloc(Layout::from_size_align(size, 64).unwrap()).cast()
    }
    unsafe extern "C" fn give_back(user: *mut c_void, memory: *mut c_void, size: usize) {
        let ledger = &*user.cast::<Ledger>();
        ledger.live.set(ledger.live.get() - size);
        dealloc(memory.cast(), Layout::from_size_align(size, 64).unwrap());
    }
    let ledger = Ledger { live: Cell::new(0), most: Cell::new(0) };
    let allocator = sf_allocator {
        alloc: Some(take),
        free: Some(give_back),
        user: (&ledger as *const Ledger).cast_mut().cast(),
    };
    let mut grid = ptr::null_mut();
    unsafe {
        assert_eq!(sf_grid_create(&lattice(64), &allocator, &mut grid), SF_OK);
        sf_grid_destroy(grid);
    }
    assert!(ledger.most.get() >= 64 * 64 * 64 / 8);
    assert_eq!(ledger.live.get(), 0);
}

#[test]
fn work_is_done_by_threads_of_rust() {
    unsafe extern "C" fn progress(user: *mut c_void, fraction: f64) {
        (*user.cast::<RefCell<Vec<f64>>>()).borrow_mut().push(fraction);
    }
    unsafe extern "C" fn side_by_side(
        _: *mut c_void,
        count: usize,
        body: sf_task_body,
        context: *mut c_void,
    ) {
        struct Shared(*mut c_void);
        unsafe impl Sync for Shared {}
        let (shared, body) = (&Shared(context), body.unwrap());
        std::thread::scope(|scope| {
            for thread in 0..3 {
                scope.spawn(move || (thread..count).step_by(3).for_each(|i| unsafe { body(shared.0, i) }));
            }
        });
    }
    let seen = RefCell::new(Vec::new());
    let (mut alone, mut together): (sf_moments, sf_moments) = unsafe { mem::zeroed() };
    unsafe {
        let mut grid = ptr::null_mut();
        assert_eq!(sf_grid_create(&lattice(200), ptr::null(), &mut grid), SF_OK);
        for k in 0..200 {
            let rect = sf_rect { x0: k / 2, y0: 0, x1: 150, y1: 200 - k };
            assert_eq!(sf_slice_fill(sf_grid_slice(grid, k), rect, 1), SF_OK);
        }
        let mut task = sf_task {
            progress: Some(progress),
            parallel_for: Some(side_by_side),
            user: (&seen as *const RefCell<Vec<f64>>).cast_mut().cast(),
            ..sf_task_default()
        };
        assert_eq!(sf_grid_measure(grid, ptr::null_mut(), &mut alone), SF_OK);
        assert_eq!(sf_grid_measure(grid, &mut task, &mut together), SF_OK);
        sf_task_cancel(&mut task);
        let cancelled: c_int = sf_task_is_cancelled(&task);
        assert_eq!(cancelled, 1);
        assert_eq!(sf_grid_measure(grid, &mut task, &mut together), SF_ERR_CANCELLED);
        sf_grid_destroy(grid);
    }
    assert!(alone.count > 0);
    assert_eq!((alone.count, alone.xz.low, alone.yy.low), (together.count, together.xz.low, together.yy.low));
    let fractions = seen.borrow();
    assert!(fractions.windows(2).all(|pair| pair[0] <= pair[1]));
    assert_eq!(fractions.last(), Some(&1.0));
}
