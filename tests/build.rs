//! Writes the samples of random declarations that the campaign takes.

use std::{env, fs};

/// How many there are.
const COUNT: u64 = 6;

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    let folder = env::var("OUT_DIR").expect("cargo names a folder");
    fs::write(format!("{folder}/drawn.rs"), kin_declarations::code(0..COUNT)).expect("the folder can be written");
}
