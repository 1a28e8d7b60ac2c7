// SPDX-License-Identifier: MIT
// Why: what is written has to come back as it was, whole or not at all; what a build without a library cannot do
// has to be said in words; and what is broken is refused with what is wrong and where.

mod shapes;

use libsf::{
    has_gltf, has_png, has_threemf, write_png, Cage, CageFormat, CageReadOptions, Channel, ErrorKind, Grid,
    Lattice, LayerWriter, Material, Mesh, MeshFormat, MeshLimits, Property, RefineRules, Rule, StackRule,
    Task, ThreeMf, ThreeMfKind,
};
use shapes::Random;
use std::fs;
use std::panic::{catch_unwind, AssertUnwindSafe};
use std::path::PathBuf;

/// A folder of a test's own, which goes with it.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Folder {
        let path = std::env::temp_dir().join(format!("libsf-{name}-{}", std::process::id()));
        fs::create_dir_all(&path).unwrap();
        Folder(path)
    }

    fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(&self.0).unwrap();
        entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect()
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

#[test]
fn a_broken_file_and_a_lattice_that_cannot_be_are_named() {
    let folder = Folder::new("named");
    let path = folder.0.join("part.stl");
    fs::write(&path, "hello").unwrap();
    let error = Mesh::load(&path).unwrap_err();
    assert_eq!((error.kind(), error.offset()), (ErrorKind::Format, 5));
    assert!(error.message().starts_with(&format!("{}: ", path.display())), "{error}");
    let error = Lattice::new(3, 4, 5, 0.0, 0.5).unwrap_err();
    assert_eq!(error.kind(), ErrorKind::Argument);
    assert!(error.message().contains("3 x 4 x 5 voxels of 0 x 0 mm"), "{error}");
    let error = Lattice::new(1 << 31, 1, 1, 0.5, 0.5).unwrap_err();
    assert_eq!(error.kind(), ErrorKind::Overflow);
    assert!(error.message().ends_with("make the voxels larger"), "{error}");
}

/// Whether the library must be able to read stack.json.
fn with_json() -> bool {
    cfg!(feature = "json")
}

fn grid() -> Grid {
    let mut random = Random::new(19);
    let lattice = Lattice::new(75, 20, 6, 0.05, 0.03)
        .and_then(|lattice| lattice.with_heights(&[0.03, 0.04, 0.05, 0.03, 0.03, 0.1]))
        .and_then(|lattice| lattice.with_origin([1.0, -2.0, 1.0 / 3.0]))
        .unwrap();
    Grid::from_fn(&lattice, |_, _, _| random.below(3) > 0).unwrap()
}

#[test]
fn a_stack_comes_back_as_it_was() {
    let folder = Folder::new("stack");
    let path = folder.0.join("stack");
    let grid = grid();
    let rule = Rule::slack(0.8).with_bridges(0.3, 0.1);
    for made_under in [None, Some(StackRule { rule, bed_layer: Some(2) }), Some(Rule::box3().into())] {
        grid.save_stack(&path, made_under, None).unwrap();
        assert_eq!(folder.names(), ["stack"]);
        let ending = if has_png() { "png" } else { "pbm" };
        assert!(path.join(format!("layer_00005.{ending}")).exists());
        match Grid::load_stack(&path, None) {
            Ok((read, found)) => {
                assert_eq!((&read, read.lattice()), (&grid, grid.lattice()));
                assert_eq!(found, made_under);
            }
            Err(error) => {
                let known = error.kind() == ErrorKind::Unsupported && error.message().contains("jansson");
                assert!(known && !with_json(), "{error}");
            }
        }
    }
}

#[test]
fn a_stack_appears_whole_or_not_at_all() {
    let folder = Folder::new("whole");
    let path = folder.0.join("stack");
    let grid = grid();
    let mut stop = Task::new().progress(|share| assert!(share < 0.4, "stop"));
    let saved = catch_unwind(AssertUnwindSafe(|| grid.save_stack(&path, None, Some(&mut stop))));
    assert_eq!(saved.unwrap_err().downcast_ref::<&str>(), Some(&"stop"));
    assert!(folder.names().is_empty(), "{:?}", folder.names());
    // What is no stack is not replaced.
    fs::create_dir(&path).unwrap();
    fs::write(path.join("letter.txt"), "dear").unwrap();
    let refused = grid.save_stack(&path, None, None).unwrap_err();
    assert!(refused.kind() == ErrorKind::Io && refused.message().contains("stack"), "{refused}");
    assert_eq!(fs::read(path.join("letter.txt")).unwrap(), b"dear");
    assert_eq!(folder.names(), ["stack"]);
    let missing = Grid::load_stack(folder.0.join("none"), None).unwrap_err();
    assert_eq!(missing.kind(), ErrorKind::Io);
    let no_stack = Grid::load_stack(&path, None).unwrap_err();
    assert!([ErrorKind::Io, ErrorKind::Unsupported].contains(&no_stack.kind()), "{no_stack}");
    let zero = grid.save_stack("a\0b", None, None).unwrap_err();
    assert_eq!(zero.kind(), ErrorKind::Argument);
}

#[test]
fn layers_of_materials_are_counted_and_written() {
    let folder = Folder::new("layers");
    let path = folder.0.join("job");
    let lattice = Lattice::new(20, 10, 4, 0.1, 0.05).unwrap();
    let named =
        |name: &str, density_g_cm3| Material { name: name.into(), colour: [200, 30, 40], density_g_cm3 };
    let materials = [named("soft", Some(1.1)), named("hard", None)];
    let mut writer = match LayerWriter::new(&path, &lattice, &materials) {
        Ok(writer) => writer,
        Err(error) => {
            assert!(!has_png(), "{error}");
            assert_eq!(error.kind(), ErrorKind::Unsupported, "{error}");
            return;
        }
    };
    assert!(has_png());
    let ids: Vec<u8> = (0..200).map(|n| (n % 3) as u8).collect();
    assert_eq!(writer.add(&ids[..199], 20).unwrap_err().kind(), ErrorKind::Shape);
    assert_eq!(writer.add(&ids, 19).unwrap_err().kind(), ErrorKind::Argument);
    assert_eq!(writer.add(&[3; 200], 20).unwrap_err().kind(), ErrorKind::Argument);
    for _ in 0..4 {
        writer.add(&ids, 20).unwrap();
    }
    assert_eq!(writer.add(&ids, 20).unwrap_err().kind(), ErrorKind::Argument);
    assert!(!path.exists());
    let uses = writer.finish().unwrap();
    assert_eq!((uses[0].voxels, uses[1].voxels), (4 * 67, 4 * 66));
    assert!((uses[0].mass_g - 268.0 * 0.1 * 0.1 * 0.05 * 1.1e-3).abs() < 1e-12);
    assert!(path.join("layer_00003.png").exists() && path.join("stack.json").exists());
    // One that is given up leaves what was there, and nothing beside it.
    let mut other = LayerWriter::new(&path, &lattice, &materials).unwrap();
    other.add(&ids, 20).unwrap();
    assert_eq!(other.finish().unwrap_err().kind(), ErrorKind::Argument);
    assert_eq!(folder.names(), ["job"]);
    for wrong in [
        vec![],
        vec![named("", None)],
        vec![named("a", Some(-1.0))],
        vec![named("a", None), named("a", None)],
    ] {
        assert_eq!(LayerWriter::new(&path, &lattice, &wrong).unwrap_err().kind(), ErrorKind::Argument);
    }
    if let Ok((read, _)) = Grid::load_stack(&path, None) {
        assert!(read
            .to_bools()
            .chunks(200)
            .all(|layer| layer.iter().zip(&ids).all(|(s, id)| *s == (*id > 0))));
    }
}

#[test]
fn pictures_are_written_or_refused() {
    let mut png = Vec::new();
    let pixels: Vec<u8> = (0..3 * 40 * 30).map(|n| (n % 251) as u8).collect();
    match write_png(&mut png, &pixels, 40, 30) {
        Ok(()) => {
            assert!(has_png());
            assert_eq!(png[..8], [0x89, b'P', b'N', b'G', 13, 10, 26, 10]);
            assert_eq!((&png[16..20], &png[20..24]), (&[0, 0, 0, 40][..], &[0, 0, 0, 30][..]));
        }
        Err(error) => assert_eq!((has_png(), error.kind()), (false, ErrorKind::Unsupported)),
    }
    assert_eq!(write_png(&mut png, &pixels[1..], 40, 30).unwrap_err().kind(), ErrorKind::Shape);
    assert_eq!(write_png(&mut png, &[], u32::MAX, u32::MAX).unwrap_err().kind(), ErrorKind::Shape);
}

#[test]
fn a_cage_comes_back_from_its_file() {
    let folder = Folder::new("cage");
    let path = folder.0.join("cage.vtk");
    let mut cage = Cage::block([3, 2, 1], [0.0; 3], [3.0, 2.0, 1.0 / 3.0]).unwrap();
    let heat: Vec<f64> = cage.positions().iter().map(|at| at[0] / 7.0).collect();
    cage.add_property(&Channel::of_points(Property::named("heat of it").unwrap(), &heat)).unwrap();
    cage.save(&path).unwrap();
    assert_eq!(folder.names(), ["cage.vtk"]);
    assert_eq!(Cage::load(&path).unwrap().view(), cage.view());
    for binary in [false, true] {
        let mut file = Vec::new();
        cage.view().write_vtk(&mut file, binary).unwrap();
        let (read, found) = Cage::read(&file[..], &CageReadOptions::default()).unwrap();
        assert_eq!(read.view(), cage.view());
        assert_eq!((found.format, found.turned_cells), (CageFormat::Vtk, 0));
        // A finer one has more points than what a reader may be told to take.
        let fine = cage.refined(1, RefineRules::Standard, None).unwrap();
        let mut file = Vec::new();
        fine.view(1).unwrap().write_vtk(&mut file, binary).unwrap();
        let few = CageReadOptions { points_max: 100, ..Default::default() };
        assert_eq!(Cage::read(&file[..], &few).unwrap_err().kind(), ErrorKind::Overflow);
        let short = CageReadOptions { bytes_max: 100, ..Default::default() };
        assert_eq!(Cage::read(&file[..], &short).unwrap_err().kind(), ErrorKind::Overflow);
        assert_eq!(
            Cage::read(&file[..file.len() / 2], &Default::default()).unwrap_err().kind(),
            ErrorKind::Format
        );
    }
    let broken = "MeshVersionFormatted 1\nDimension 3\nVertices 1\n0 zero 0 0\n";
    let error = Cage::read(broken.as_bytes(), &Default::default()).unwrap_err();
    assert_eq!((error.kind(), error.line()), (ErrorKind::Format, Some(4)), "{error}");
    // What VTK has no name for is refused before a byte is written, and leaves what was there.
    let named = Channel::of_points(Property::named("sf_point").unwrap(), &heat);
    cage.add_property(&named).unwrap();
    let refused = cage.save(&path).unwrap_err();
    assert!(refused.kind() == ErrorKind::Argument && refused.message().contains("sf_point"), "{refused}");
    assert_eq!(Cage::load(&path).unwrap().view().channels.len(), 1);
    assert_eq!(folder.names(), ["cage.vtk"]);
    assert_eq!(Cage::load(folder.0.join("none")).unwrap_err().kind(), ErrorKind::Io);
}

#[test]
fn a_reader_takes_no_more_than_it_is_told() {
    let mesh = grid().surface(0, None).unwrap();
    let mut file = Vec::new();
    mesh.write(&mut file, MeshFormat::Ply).unwrap();
    let (vertices, faces) = (mesh.vertices().len(), mesh.faces().len());
    let all = MeshLimits { bytes_max: file.len() as u64, triangles_max: faces, vertices_max: vertices };
    let read = |limits: &MeshLimits| Mesh::read_within(&file[..], MeshFormat::Ply, limits);
    assert_eq!(read(&all).unwrap().faces().len(), faces);
    for limits in [
        MeshLimits { bytes_max: all.bytes_max - 1, ..all },
        MeshLimits { triangles_max: faces - 1, ..all },
        MeshLimits { vertices_max: vertices - 1, ..all },
    ] {
        assert_eq!(read(&limits).unwrap_err().kind(), ErrorKind::Overflow, "{limits:?}");
    }
}

#[test]
fn a_mesh_goes_to_gltf_and_back() {
    let folder = Folder::new("gltf");
    let mesh = grid().surface(0, None).unwrap();
    let colours = vec![[10, 200, 90]; mesh.vertices().len()];
    let mut file = Vec::new();
    mesh.write_glb(&mut file, Some(&colours)).unwrap();
    assert_eq!(&file[..4], b"glTF");
    assert_eq!(mesh.write_glb(&mut Vec::new(), Some(&colours[1..])).unwrap_err().kind(), ErrorKind::Shape);
    let read = Mesh::read_gltf(&file[..], &MeshLimits::default(), Some(&folder.0));
    if !has_gltf() {
        assert_eq!(read.unwrap_err().kind(), ErrorKind::Unsupported);
        return;
    }
    let (read, report) = read.unwrap();
    assert_eq!((read.faces(), report.pieces, report.animations), (mesh.faces(), 1, 0));
    let same = |a: &[f64; 3], b: &[f64; 3]| (0..3).all(|i| (a[i] - b[i]).abs() < 1e-5);
    assert!(read.vertices().iter().zip(mesh.vertices()).all(|(a, b)| same(a, b)));
    let few = MeshLimits { triangles_max: mesh.faces().len() - 1, ..Default::default() };
    assert_eq!(Mesh::read_gltf(&file[..], &few, None).unwrap_err().kind(), ErrorKind::Overflow);
    // A buffer beside the file is read from the folder, and from nowhere else.
    let text = r#"{"asset":{"version":"2.0"},"buffers":[{"uri":"b.bin","byteLength":36}],
        "bufferViews":[{"buffer":0,"byteLength":36}],
        "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],
        "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"nodes":[{"mesh":0}],"scenes":[{"nodes":[0]}]}"#;
    let floats = [0.0f32, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0];
    fs::write(folder.0.join("b.bin"), floats.iter().flat_map(|x| x.to_le_bytes()).collect::<Vec<u8>>())
        .unwrap();
    let limits = MeshLimits::default();
    let (triangle, _) = Mesh::read_gltf(text.as_bytes(), &limits, Some(&folder.0)).unwrap();
    assert_eq!(triangle.vertices()[1], [1000.0, 0.0, 0.0]);
    assert!(Mesh::read_gltf(text.as_bytes(), &limits, None).is_err());
    let away = text.replace("b.bin", "../b.bin");
    assert_eq!(Mesh::read_gltf(away.as_bytes(), &limits, Some(&folder.0)).unwrap_err().kind(), ErrorKind::Io);
}

#[test]
fn a_mesh_goes_to_3mf_and_back() {
    fn both<T: Send + Sync>() {}
    both::<ThreeMf>();
    let mesh = grid().surface(0, None).unwrap();
    let mut file = Vec::new();
    let written = mesh.write(&mut file, MeshFormat::Threemf);
    let limits = MeshLimits::default();
    if !has_threemf() {
        assert_eq!(written.unwrap_err().kind(), ErrorKind::Unsupported);
        assert_eq!(ThreeMf::read(&b"PK"[..], &limits).unwrap_err().kind(), ErrorKind::Unsupported);
        return;
    }
    written.unwrap();
    let document = ThreeMf::read(&file[..], &limits).unwrap();
    let (objects, items) = (document.objects(), document.items());
    assert_eq!((objects.len(), items.len(), document.colours().len()), (1, 1, 0));
    assert_eq!((objects[0].kind, objects[0].stack, objects[0].colours), (ThreeMfKind::Model, None, None));
    assert_eq!((objects[0].vertices, objects[0].faces), (mesh.vertices(), mesh.faces()));
    assert_eq!((items[0].object, items[0].placed.shift_mm), (0, [0.0; 3]));
    assert_eq!(document.merged(&limits).unwrap().faces(), mesh.faces());
    let few = MeshLimits { triangles_max: mesh.faces().len() - 1, ..limits };
    assert_eq!(document.merged(&few).unwrap_err().kind(), ErrorKind::Overflow);
    assert_eq!(ThreeMf::read(&file[..], &few).unwrap_err().kind(), ErrorKind::Overflow);
    // It has no slices, and half of it is no file.
    assert!(!document.is_sliced());
    assert_eq!(document.contours().unwrap_err().kind(), ErrorKind::Format);
    let cut = ThreeMf::read(&file[..file.len() / 2], &limits).unwrap_err();
    assert!(cut.kind() == ErrorKind::Format && cut.message().len() > 10, "{cut}");
}

#[test]
fn a_sliced_3mf_gives_its_contours() {
    let Some(data) = std::env::var_os("SF_DATA").map(PathBuf::from) else { return };
    let path = data.join("3mf/torus_sliced.3mf");
    if !has_threemf() || !path.exists() {
        return;
    }
    let document = ThreeMf::load(path).unwrap();
    assert!(document.is_sliced());
    let stack = document.contours().unwrap();
    let layers = (0..stack.len()).map(|k| stack.layer(k).unwrap());
    let volume: f64 = layers.map(|l| l.contours.area_mm2() * (l.top_mm - l.bottom_mm)).sum();
    assert!((volume - 797.9223).abs() < 0.05, "{volume}");
}
