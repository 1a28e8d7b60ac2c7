// SPDX-License-Identifier: MIT
// Why: a struct that Rust lays out otherwise than C is memory that both sides read wrong, and nothing
// else would say so. The C compiler is asked here, with the headers that the crate is built from, for
// every size, offset, value and constant, and Rust for the same.

#![allow(clippy::incompatible_msrv)]

#[path = "layout/numbers.rs"]
mod numbers;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// A program of C that prints each number on a line.
fn program() -> String {
    let mut text = String::from("#include <stddef.h>\n#include <stdio.h>\n");
    for header in numbers::HEADERS {
        text += &format!("#include <{header}>\n");
    }
    text += "int main(void)\n{\n";
    for (expression, _) in numbers::NUMBERS {
        text += &format!("    printf(\"%llu\\n\", (unsigned long long)({expression}));\n");
    }
    text + "    return 0;\n}\n"
}

/// Compiles and runs a program of C on the machine that the tests run on.
fn output_of(program: &str) -> String {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR"));
    let (source, binary) = (folder.join("layout.c"), folder.join("layout"));
    fs::write(&source, program).unwrap();
    let target = env!("LIBSF_SYS_TARGET");
    let mut tool = cc::Build::new();
    tool.target(target).host(target).opt_level(0).cargo_metadata(false);
    tool.include(Path::new(env!("LIBSF_SYS_INCLUDE"))).define("SF_STATIC", None);
    let made = tool.get_compiler().to_command().arg(&source).arg("-o").arg(&binary).status().unwrap();
    assert!(made.success(), "the C compiler refuses {}", source.display());
    String::from_utf8(Command::new(&binary).output().unwrap().stdout).unwrap()
}

#[test]
fn every_function_is_in_the_library() {
    // That this links is the test; two functions at one address would be two names for one.
    let mut places = numbers::functions().to_vec();
    places.sort();
    places.dedup();
    assert_eq!(places.len(), numbers::functions().len());
}

#[test]
fn c_and_rust_agree_on_every_number() {
    let said: Vec<u64> = output_of(&program()).lines().map(|line| line.parse().unwrap()).collect();
    assert_eq!(said.len(), numbers::NUMBERS.len());
    let differ: Vec<String> = numbers::NUMBERS
        .iter()
        .zip(&said)
        .filter(|((_, rust), c)| *rust as u64 != **c)
        .map(|((expression, rust), c)| format!("{expression} is {c} in C and {rust} in Rust"))
        .collect();
    assert!(differ.is_empty(), "{}", differ.join("\n"));
}
