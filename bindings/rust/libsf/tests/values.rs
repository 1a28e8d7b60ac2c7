// SPDX-License-Identifier: MIT
// Why: what a type promises beyond its calls: that it may go to another thread, that what is out of range is
// an error or a panic of Rust's and never a stray access, and that layers and files say what grids and meshes do.

mod shapes;

use libsf::{
    Balance, Blend, Canceller, CheckOptions, Checker, ContourStack, Error, ErrorKind, Fill, Finding, Grid,
    Handle, Inside, Lattice, Lent, Mesh, MeshFormat, Rule, RuleKind, Slice, SliceMut, Stance, Stand, Terms,
    VoidKind, VoidsOptions, VoxelBox, Voxelizer, Weights,
};
use shapes::{lattice, shape, Random, Solid};
use std::f64::consts::FRAC_PI_4;
use std::panic::catch_unwind;

#[test]
fn types_go_to_other_threads() {
    fn send<T: Send>() {}
    fn both<T: Send + Sync>() {}
    both::<Grid>();
    both::<Mesh>();
    both::<Lattice>();
    both::<Rule>();
    both::<Terms<'static>>();
    both::<Slice<'static>>();
    both::<SliceMut<'static>>();
    both::<Canceller>();
    both::<Error>();
    both::<Finding>();
    both::<Balance>();
    both::<Blend>();
    both::<ContourStack>();
    both::<Handle<'static>>();
    both::<Lent<'static, Grid>>();
    both::<Stance>();
    both::<Stand<'static>>();
    both::<Weights>();
    send::<Inside<'static>>();
    send::<Checker>();
    send::<Voxelizer<'static>>();

    let lattice = Lattice::new(70, 9, 16, 0.5, 0.5).unwrap();
    let mut grid = Grid::new(&lattice).unwrap();
    std::thread::scope(|scope| {
        for (k, mut slice) in grid.slices_mut().enumerate() {
            scope.spawn(move || slice.set(k as u32, 3, true).unwrap());
        }
    });
    let counted = std::thread::scope(|scope| {
        let threads = [scope.spawn(|| grid.count()), scope.spawn(|| grid.count())];
        threads.map(|thread| thread.join().unwrap())
    });
    assert_eq!(counted, [16, 16]);
    assert!((0..16).all(|k| grid.get(k, 3, k)));
}

#[test]
fn a_lattice_is_checked_when_it_is_made() {
    let kind = |made: libsf::Result<Lattice>| made.unwrap_err().kind();
    assert_eq!(kind(Lattice::new(0, 1, 1, 1.0, 1.0)), ErrorKind::Argument);
    assert_eq!(kind(Lattice::new(1 << 20, 1, 1, 1.0, 1.0)), ErrorKind::Overflow);
    assert_eq!(kind(Lattice::new(1, 1, 1, f64::NAN, 1.0)), ErrorKind::Argument);
    assert_eq!(kind(Lattice::around([0.0; 3], [f64::NAN; 3], 1.0, 1.0, 1)), ErrorKind::Argument);
    assert_eq!(kind(Lattice::around([0.0; 3], [1.0; 3], 0.0, 1.0, 1)), ErrorKind::Argument);
    assert_eq!(kind(Lattice::around([0.0; 3], [1.0; 3], 1e-9, 1.0, 1)), ErrorKind::Overflow);
    let plain = Lattice::new(4, 5, 3, 0.1, 0.2).unwrap();
    assert_eq!(kind(plain.clone().with_heights(&[0.1, 0.2])), ErrorKind::Shape);
    let made = plain.with_heights(&[0.1, 0.2, 0.4]).and_then(|l| l.with_origin([1.0, 2.0, 3.0])).unwrap();
    assert_eq!(made.shape(), (3, 5, 4));
    assert_eq!((made.layer_height(2), made.layer_height(3)), (Some(0.4), None));
    assert_eq!((made.layer_bottom(0), made.layer_bottom(4)), (Some(3.0), None));
    assert!((made.layer_bottom(3).unwrap() - 3.7).abs() < 1e-12);
    let grid = Grid::new(&made).unwrap();
    assert_eq!(grid.lattice().heights_mm(), Some(&[0.1, 0.2, 0.4][..]));
    // The rule's table is the lattice's, and a copy of the grid has both.
    assert!(grid.clone().check(Rule::octagon(FRAC_PI_4), None).unwrap().support_free());
    let around = Lattice::around([0.0, 0.0, 2.0], [1.0, 2.0, 3.0], 0.5, 0.25, 2).unwrap();
    assert_eq!(around.shape(), (8, 8, 6));
    assert_eq!(around.origin_mm(), [-1.0, -1.0, 1.5]);
}

#[test]
fn what_is_out_of_range_is_refused() {
    let lattice = Lattice::new(70, 9, 3, 0.5, 0.5).unwrap();
    let mut grid = Grid::new(&lattice).unwrap();
    assert!(!grid.get(3, 0, 0) && !grid.get(0, 9, 0) && !grid.get(0, 0, 70));
    for place in [(3, 0, 0), (0, 9, 0), (0, 0, 70), (u32::MAX, u32::MAX, u32::MAX)] {
        assert_eq!(grid.set(place.0, place.1, place.2, true).unwrap_err().kind(), ErrorKind::Argument);
    }
    let beyond = VoxelBox { x0: 1, y0: 1, z0: 1, x1: 71, y1: 9, z1: 3 };
    assert_eq!(grid.fill(beyond, true).unwrap_err().kind(), ErrorKind::Argument);
    grid.fill(VoxelBox { x1: 70, ..beyond }, true).unwrap();
    assert_eq!(grid.count(), 69 * 8 * 2);
    assert_eq!(grid.bounds(), VoxelBox { x1: 70, ..beyond });
    assert!(catch_unwind(|| grid.slice(3).count()).is_err());
    assert!(catch_unwind(|| grid.slice(0).row(9).len()).is_err());
    let mut words = [0u64; 17];
    assert_eq!(Slice::new(&words, 70, 9, 1).unwrap_err().kind(), ErrorKind::Argument);
    assert_eq!(Slice::new(&words, 70, 9, 2).unwrap_err().kind(), ErrorKind::Shape);
    assert_eq!(Slice::new(&words, 64, 2, usize::MAX).unwrap_err().kind(), ErrorKind::Argument);
    let mut slice = SliceMut::new(&mut words, 70, 8, 2).unwrap();
    assert_eq!(slice.copy(grid.slice(2)).unwrap_err().kind(), ErrorKind::Shape);
    slice.set(69, 7, true).unwrap();
    assert_eq!(words[15], 1 << 5);
    let other = Grid::new(&Lattice::new(71, 9, 3, 0.5, 0.5).unwrap()).unwrap();
    assert_eq!(grid.or(&other).unwrap_err().kind(), ErrorKind::Shape);
    let masked = Terms::new(Rule::box3()).exempt(&other);
    assert_eq!(grid.grow(masked, None).unwrap_err().kind(), ErrorKind::Shape);
    let far = Terms::new(Rule::box3()).bed_layer(u32::MAX);
    assert_eq!(grid.grow(far, None).unwrap_err().kind(), ErrorKind::Argument);
    let narrow = grid.check(Rule::octagon(3.0), None).unwrap_err();
    assert_eq!(narrow.kind(), ErrorKind::Argument);
    assert!(narrow.message().len() > 20, "{narrow}");
    assert_eq!("slack".parse::<RuleKind>().unwrap(), RuleKind::Slack);
    assert_eq!(RuleKind::Disk.to_string(), "disk");
    assert!("sl\0ack".parse::<RuleKind>().is_err());
    let unknown = grid.check(Rule::new(RuleKind::Other(77), 0.8), None).unwrap_err();
    assert_eq!(unknown.kind(), ErrorKind::Argument);
}

#[test]
fn layers_as_they_come_are_judged_like_the_whole() {
    for seed in 1..41 {
        let mut random = Random::new(seed);
        let lattice = lattice(&mut random);
        let grid = shape(&mut random, &lattice);
        let solid = Solid::of(&grid);
        let options = CheckOptions { run_capacity: 4096, ..CheckOptions::from(Rule::octagon(FRAC_PI_4)) };
        let whole = grid.check(options, None).unwrap();
        let mut checkers =
            [Checker::new(&lattice, options).unwrap(), Checker::new(&lattice, options).unwrap()];
        let layer = solid.shape.1 * solid.shape.2;
        for (k, slice) in grid.slices().enumerate() {
            checkers[0].push(slice).unwrap();
            let grey: Vec<u8> =
                solid.voxels[k * layer..(k + 1) * layer].iter().map(|&one| 127 + u8::from(one)).collect();
            checkers[1].push_grey(&grey, solid.shape.2, 128).unwrap();
            let short = checkers[1].push_grey(&grey[1..], solid.shape.2, 128).unwrap_err();
            assert_eq!(short.kind(), ErrorKind::Shape);
            if k == 1 {
                // A checker may move.
                checkers.swap(0, 1);
                checkers.swap(0, 1);
            }
        }
        for checker in &checkers {
            assert_eq!(checker.report().unwrap(), whole, "seed {seed}");
        }
    }
}

#[test]
fn voids_are_found() {
    let lattice = Lattice::new(20, 20, 20, 0.5, 0.5).unwrap();
    let box_with_a_bubble =
        Grid::from_fn(&lattice, |layer, y, x| ![layer, y, x].iter().all(|i| (5..9).contains(i))).unwrap();
    let (report, voids) = box_with_a_bubble.voids(&VoidsOptions::default(), None).unwrap();
    assert_eq!((report.trap_count, report.trap_voxels), (1, 64));
    assert_eq!((voids.len(), voids[0].kind, voids[0].vent_layer), (1, VoidKind::Trap, None));
    assert_eq!(voids[0].box_, VoxelBox { x0: 5, y0: 5, z0: 5, x1: 9, y1: 9, z1: 9 });
}

#[test]
fn meshes_go_out_and_come_back() {
    let mut random = Random::new(7);
    let lattice = Lattice::new(30, 12, 12, 0.5, 0.25).unwrap().with_origin([3.0, -2.0, 1.0]).unwrap();
    let grid = shape(&mut random, &lattice);
    assert!(grid.count() > 0);
    let mesh = grid.surface(0, None).unwrap();
    assert!(mesh.topology().unwrap().closed);
    let volume = grid.count() as f64 * 0.5 * 0.5 * 0.25;
    assert!((mesh.measure().unwrap().volume_mm3 - volume).abs() < 0.05 * volume);
    let mut back = Grid::new(&lattice).unwrap();
    assert_eq!(back.voxelize(&mesh, Fill::Auto, None).unwrap().solid_voxels, grid.count());
    assert_eq!(back, grid);
    let mut voxelizer = Voxelizer::new(&mesh, &lattice, Fill::Winding).unwrap();
    for (k, slice) in back.slices_mut().enumerate().rev() {
        voxelizer.slice(k as u32, slice).unwrap();
    }
    assert_eq!(back, grid);
    assert_eq!(voxelizer.report().unwrap().solid_voxels, grid.count());

    let folder = std::env::temp_dir().join(format!("libsf-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    for name in ["shape.ply", "shape.OBJ", "shape.stl"] {
        let path = folder.join(name);
        mesh.save(&path).unwrap();
        let read = Mesh::load(&path).unwrap();
        assert_eq!(read.merged().unwrap().faces().len(), mesh.faces().len(), "{name}");
        if name != "shape.stl" {
            assert_eq!(read.vertices(), mesh.vertices(), "{name}");
        }
    }
    assert_eq!(mesh.save(folder.join("shape.doc")).unwrap_err().kind(), ErrorKind::Argument);
    assert_eq!(Mesh::load(folder.join("none.stl")).unwrap_err().kind(), ErrorKind::Io);
    std::fs::write(folder.join("bad.off"), "OFF\n1 1 0\n0 0 0\n3 0 1 2\n").unwrap();
    let bad = Mesh::load(folder.join("bad.off")).unwrap_err();
    assert_eq!((bad.kind(), bad.line()), (ErrorKind::Format, Some(4)), "{bad}");
    std::fs::remove_dir_all(&folder).unwrap();
    assert_eq!(MeshFormat::from_path("a.stl").unwrap(), MeshFormat::Stl);
}

#[test]
fn meshes_are_written_as_gltf() {
    let mesh = Grid::from_fn(&Lattice::new(4, 4, 4, 1.0, 1.0).unwrap(), |_, _, _| true).unwrap();
    let mesh = mesh.surface(0, None).unwrap().merged().unwrap();
    let (mut plain, mut saved, mut colored) = (Vec::new(), Vec::new(), Vec::new());
    mesh.write(&mut plain, MeshFormat::Gltf).unwrap();
    mesh.write_glb(&mut saved, None).unwrap();
    let colors = vec![[255, 128, 0]; mesh.vertices().len()];
    mesh.write_glb(&mut colored, Some(&colors)).unwrap();
    assert_eq!(plain, saved);
    // A head that says how long it is, and vertices with three floats and then some for the colours.
    for glb in [&plain, &colored] {
        let length = u32::from_le_bytes(glb[8..12].try_into().unwrap());
        assert_eq!((&glb[..4], length as usize), (&b"glTF"[..], glb.len()));
    }
    assert!(colored.len() >= plain.len() + 6 * colors.len());
    assert_eq!(mesh.write_glb(&mut colored, Some(&colors[1..])).unwrap_err().kind(), ErrorKind::Shape);
    let folder = std::env::temp_dir();
    let refused = mesh.save(folder.join("libsf.gltf")).unwrap_err();
    assert!(refused.kind() == ErrorKind::Argument && refused.message().contains(".glb"), "{refused}");
    match Mesh::read(&plain[..], MeshFormat::Gltf) {
        Ok(back) => assert_eq!(back.faces().len(), mesh.faces().len()),
        Err(error) => assert_eq!(error.kind(), ErrorKind::Unsupported, "{error}"),
    }
}

#[test]
fn meshes_are_measured_moved_and_cut() {
    let corners = [[0.0, 0.0, 0.0], [3.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 3.0]];
    let faces = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
    let mut mesh = Mesh::new(&corners, &faces).unwrap();
    assert_eq!((mesh.vertices(), mesh.faces()), (&corners[..], &faces[..]));
    assert_eq!(mesh.bounds().unwrap(), [[0.0; 3], [3.0; 3]]);
    let (low, high) = mesh.cut(2, 1.0).unwrap();
    let volume = |mesh: &Mesh| mesh.measure().unwrap().volume_mm3;
    assert!((volume(&high) - 8.0 / 6.0).abs() < 1e-12 && (volume(&low) - 19.0 / 6.0).abs() < 1e-12);
    mesh.transform([[0.0, -2.0, 0.0], [2.0, 0.0, 0.0], [0.0, 0.0, 2.0]], [1.0, 0.0, 0.0]).unwrap();
    assert_eq!(mesh.vertices()[1], [1.0, 6.0, 0.0]);
    assert!((volume(&mesh) - 36.0).abs() < 1e-12);
    assert_eq!(mesh.transform([[0.0; 3]; 3], [0.0; 3]).unwrap_err().kind(), ErrorKind::Argument);
    assert_eq!(mesh.cut(3, 1.0).unwrap_err().kind(), ErrorKind::Argument);
    assert_eq!(Mesh::new(&corners, &[[0, 1, 4]]).unwrap_err().kind(), ErrorKind::Argument);
    assert_eq!(Mesh::new(&[[0.0, f64::NAN, 0.0]], &[]).unwrap_err().kind(), ErrorKind::Argument);
    let empty = Mesh::new(&[], &[]).unwrap();
    assert!(empty.vertices().is_empty() && empty.clone().faces().is_empty());
    assert_eq!(empty.bounds().unwrap_err().kind(), ErrorKind::Argument);
}

#[test]
fn the_rest_of_a_grid() {
    let lattice = Lattice::new(12, 12, 12, 1.0, 1.0).unwrap();
    let step = Grid::from_fn(&lattice, |layer, _, x| x <= layer).unwrap();
    let steepest = step.steepest(None, None).unwrap();
    // Two voxels of twelve in its tangent may be forgiven.
    assert!(steepest.is_bounded, "{steepest:?}");
    assert!((10.0 / 12.0 - 0.1..1.001).contains(&steepest.angle_rad.tan()), "{steepest:?}");
    let moments = step.moments(None).unwrap();
    assert_eq!((moments.count, moments.y), (936, 936 / 12 * 66));
    let angles = Rule::box3().measure(&lattice).unwrap();
    assert!(
        (angles.axis_x_rad - FRAC_PI_4).abs() < 1e-6
            && (angles.diagonal_rad - 2f64.sqrt().atan()).abs() < 1e-6
    );
    let mut turned = step.clone();
    turned.xor(&Grid::from_fn(&lattice, |_, _, _| true).unwrap()).unwrap();
    assert_eq!(turned.count(), 1728 - 936);
    assert_ne!(turned.sha256(None).unwrap(), step.sha256(None).unwrap());
    turned.and(&step).unwrap();
    assert_eq!(turned.count(), 0);
    assert_eq!(turned.bounds(), VoxelBox::default());
    assert_eq!(libsf::slice_stride(513), 16);
    assert_eq!(libsf::version(), env!("CARGO_PKG_VERSION"));
}
