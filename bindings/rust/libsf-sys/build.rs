// SPDX-License-Identifier: MIT
// Makes the library that the externs are linked to.
//
// By default the C sources beside this file are compiled into the crate, core and files, so that nothing
// has to be installed. They are whole folders, as in libsf's own build without meson, so there is no list
// here that could fall behind. With the feature `system` an installed library is taken instead.
//
// Whoever depends on this crate finds in DEP_SF_INCLUDE where the headers are. LIBSF_SYS_INCLUDE and
// LIBSF_SYS_TARGET go to this crate's own tests, which hold the externs against the headers.

use std::env;
use std::fs;
use std::path::{Path, PathBuf};

/// Another minor version may have another interface, before 1.0.
const INTERFACE: std::ops::Range<&str> = "0.1".."0.2";

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    let include = if has_feature("SYSTEM") { system() } else { bundled() };
    println!("cargo:include={}", include.display());
    println!("cargo:rustc-env=LIBSF_SYS_INCLUDE={}", include.display());
    println!("cargo:rustc-env=LIBSF_SYS_TARGET={}", env::var("TARGET").unwrap());
}

fn has_feature(name: &str) -> bool {
    env::var_os(format!("CARGO_FEATURE_{name}")).is_some()
}

/// Links to what pkg-config knows, and returns where its headers are.
fn system() -> PathBuf {
    let found = pkg_config::Config::new()
        .range_version(INTERFACE)
        .probe("libsf-io")
        .unwrap_or_else(|error| panic!("the feature `system` wants an installed libsf-io: {error}"));
    let holds = |folder: &&PathBuf| folder.join("sf/io.h").exists();
    let usual = PathBuf::from("/usr/include");
    found.include_paths.iter().find(holds).cloned().unwrap_or(usual)
}

/// Compiles the library, and returns where its headers are.
fn bundled() -> PathBuf {
    let vendor = PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").unwrap()).join("vendor");
    let include = vendor.join("include");
    assert!(
        include.join("sf/io.h").exists(),
        "{} is empty: it is a link to libsf's sources",
        vendor.display()
    );
    println!("cargo:rerun-if-changed={}", vendor.display());
    let mut build = cc::Build::new();
    build.files(sources(&vendor)).include(&include).include(&vendor);
    build.define("SF_STATIC", None).define("SF_BUILDING", None).warnings(false);
    // Results are the same bytes on every machine: no contraction, no registers of 80 bits.
    build.std("c99").flag_if_supported("-ffp-contract=off");
    if env::var("CARGO_CFG_TARGET_ARCH").as_deref() == Ok("x86") {
        build.flag_if_supported("-msse2").flag_if_supported("-mfpmath=sse");
    }
    // Without optimization it is ten times slower, in a crate whose debugging nobody is after.
    if env::var("OPT_LEVEL").as_deref() == Ok("0") {
        build.opt_level(2);
    }
    let libraries = [("PNG", "spng", "SF_HAVE_SPNG"), ("JSON", "jansson", "SF_HAVE_JANSSON")];
    for (feature, library, define) in libraries {
        if has_feature(feature) {
            let found = pkg_config::probe_library(library)
                .unwrap_or_else(|error| panic!("a feature wants {library}: {error}"));
            build.define(define, None).includes(found.include_paths);
        }
    }
    build.compile("sf");
    include
}

/// The C files of the rooms, and of the folders in them, in the order of their names.
fn sources(vendor: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for room in entries(vendor) {
        for file in entries(&room) {
            found.extend(entries(&file));
            found.push(file);
        }
    }
    found.retain(|path| path.extension().is_some_and(|ending| ending == "c"));
    found
}

fn entries(folder: &Path) -> Vec<PathBuf> {
    let Ok(list) = fs::read_dir(folder) else { return Vec::new() };
    let mut found: Vec<PathBuf> = list.filter_map(|entry| Some(entry.ok()?.path())).collect();
    found.sort();
    found
}
