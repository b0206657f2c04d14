//! Tells the program which compiler it was built by: counts of instructions depend on it.

use std::env;
use std::process::Command;

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    let compiler = env::var_os("RUSTC").expect("cargo names the compiler");
    let output = Command::new(compiler).arg("--version").output().expect("it runs");
    let version = String::from_utf8(output.stdout).expect("it says its version");
    // `rustc 1.95.0 (59807616e 2026-04-14)`
    let version = version
        .split_whitespace()
        .nth(1)
        .expect("the second word is the version");
    println!("cargo::rustc-env=KIN_COMPILER={version}");
}
