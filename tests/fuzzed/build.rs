//! Writes the sample: as many declarations as `KIN_COUNT` says, from the seed `KIN_SEED` on.

use std::{env, fs};

/// Enough for every change. `.ci/run` asks for 30, `.ci/fuzz` for more.
const COUNT: u64 = 8;

fn number(name: &str, usual: u64) -> u64 {
    println!("cargo::rerun-if-env-changed={name}");
    env::var(name).map_or(usual, |value| value.parse().expect("a number"))
}

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    let (first, count) = (number("KIN_SEED", 0), number("KIN_COUNT", COUNT));
    let code = kin_declarations::code(first..first + count);
    let folder = env::var("OUT_DIR").expect("cargo names a folder");
    fs::write(format!("{folder}/sample.rs"), code).expect("the folder can be written");
}
