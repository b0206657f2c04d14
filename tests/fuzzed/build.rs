//! Writes the sample: as many declarations as `KIN_COUNT` says, from the seed `KIN_SEED` on.

use std::fmt::Write;
use std::{env, fs};

use kin_declarations::sample;

/// Enough for every change. `.ci/run` asks for 30, `.ci/fuzz` for more.
const COUNT: u64 = 8;

fn number(name: &str, usual: u64) -> u64 {
    println!("cargo::rerun-if-env-changed={name}");
    env::var(name).map_or(usual, |value| value.parse().expect("a number"))
}

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    let (first, count) = (number("KIN_SEED", 0), number("KIN_COUNT", COUNT));
    let (mut modules, mut entries) = (String::new(), String::new());
    for seed in first..first + count {
        let name = format!("Mechanism{seed}");
        let declaration = sample(&name, seed);
        writeln!(
            modules,
            "mod mechanism_{seed} {{
                use kin_core::prelude::*;
                mechanism! {{ {declaration} }}
                pub(super) fn found() -> super::Found {{ of!({name}) }}
            }}"
        )
        .expect("a string can be written");
        writeln!(entries, "(mechanism_{seed}::found, {declaration:?}),").expect("a string can be written");
    }
    let source = format!("{modules}\nconst SAMPLE: &[(Find, &str)] = &[\n{entries}];\n");
    let folder = env::var("OUT_DIR").expect("cargo names a folder");
    fs::write(format!("{folder}/sample.rs"), source).expect("the folder can be written");
}
