//! Writes the samples of random declarations that the campaign takes: of four unknowns and more, through snap, whose
//! positions no range excludes.

use std::{env, fs};

use kin_declarations::Sample;

/// How many there are.
const COUNT: usize = 6;

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    let is_suitable = |seed: &u64| {
        let sample = Sample::new(*seed);
        sample.order() == 4 && sample.unknowns().len() >= 4 && !sample.has_ranges()
    };
    let code = kin_declarations::code((0..).filter(is_suitable).take(COUNT));
    let folder = env::var("OUT_DIR").expect("cargo names a folder");
    fs::write(format!("{folder}/drawn.rs"), code).expect("the folder can be written");
}
