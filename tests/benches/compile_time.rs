//! The compile time that the macro costs its user: crates with 0, 1, 10 and 50 four-bar linkages, with chains of 1 to
//! 16 loops, and with serial arms of 7 to 30 joints, are built as a user would build them. What each question to a
//! six-bar linkage adds to a release build comes first.
//!
//! `cargo bench -p kin-tests --bench compile_time` prints the time of a cold build, of each crate's own build, and of
//! the expansion of its macros within it, as the compiler reports them; and lines `ratio NAME VALUE`. Nothing is
//! asserted.
//!
//! Macros are built without optimisation by default, in release builds as well; `[profile.dev.build-override]` changes
//! that. Both are measured.
#![allow(missing_docs, reason = "a program")]

use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;

/// How often each crate is built; the shortest time counts.
const ROUNDS: usize = 5;

/// A crate of somebody who uses kin, in a directory of its own.
struct User {
    directory: PathBuf,
}

/// Milliseconds of the compiler for a crate.
#[derive(Clone, Copy)]
struct Times {
    /// Of macros, with the parsing of what they give.
    expansion: f64,
    /// Of everything.
    total: f64,
}

impl User {
    fn new(name: &str, features: &[&str], profile: &str) -> Self {
        let directory = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
        if directory.exists() {
            fs::remove_dir_all(&directory).expect("the directory is ours");
        }
        fs::create_dir_all(directory.join("src")).expect("the directory can be written");
        let repository = Path::new(env!("CARGO_MANIFEST_DIR"))
            .parent()
            .expect("the tests are within the repository");
        let core = repository.join("kin-core").display().to_string();
        let manifest = format!(
            "[package]\nname = \"user\"\nedition = \"2024\"\n\n[dependencies]\nkin-core = {{ path = '{core}', \
                features = {features:?} }}\n\n\
             [workspace]\n\n{profile}"
        );
        fs::write(directory.join("Cargo.toml"), manifest).expect("the directory can be written");
        // the same versions as here, which are downloaded already
        fs::copy(repository.join("Cargo.lock"), directory.join("Cargo.lock")).expect("there is a lock file");
        Self { directory }
    }

    /// Builds the crate of this source, with everything that is not built yet, and returns what the compiler says.
    fn build(&self, source: &str) -> String {
        fs::write(self.directory.join("src/lib.rs"), source).expect("the directory can be written");
        let cargo = std::env::var("CARGO").unwrap_or_else(|_| "cargo".to_owned());
        let output = Command::new(cargo)
            .args(["rustc", "--offline", "--", "-Ztime-passes"])
            .current_dir(&self.directory)
            .env("CARGO_TARGET_DIR", self.directory.join("target"))
            .env("CARGO_INCREMENTAL", "0")
            // the stable compiler times its passes when it is told to, for this crate only
            .env("RUSTC_BOOTSTRAP", "user")
            .output()
            .expect("cargo runs");
        let said = format!(
            "{}\n{}",
            String::from_utf8_lossy(&output.stdout),
            String::from_utf8_lossy(&output.stderr)
        );
        assert!(output.status.success(), "{said}");
        said
    }

    /// Seconds of a build from nothing, of an empty crate.
    fn cold(&self) -> f64 {
        let start = Instant::now();
        self.build("");
        start.elapsed().as_secs_f64()
    }

    /// The compiler's times for each of some crates, the dependencies of which are built. They take turns, and the
    /// shortest of each counts.
    fn times(&self, sources: &[String]) -> Vec<Times> {
        let mut least = vec![
            Times {
                expansion: f64::INFINITY,
                total: f64::INFINITY,
            };
            sources.len()
        ];
        for round in 0..ROUNDS {
            for (source, least) in sources.iter().zip(&mut least) {
                let said = self.build(&format!("// {round}\n{source}"));
                least.expansion = least.expansion.min(pass(&said, "macro_expand_crate"));
                least.total = least.total.min(pass(&said, "total"));
            }
        }
        least
    }
}

/// Milliseconds of a pass of the compiler: of a line `time:   0.012; rss: … pass`.
fn pass(said: &str, name: &str) -> f64 {
    let line = said
        .lines()
        .find(|line| line.starts_with("time:") && line.split_whitespace().last() == Some(name))
        .unwrap_or_else(|| panic!("no time of {name} in\n{said}"));
    let seconds = line
        .split([':', ';'])
        .nth(1)
        .and_then(|seconds| seconds.trim().parse::<f64>().ok());
    seconds.unwrap_or_else(|| panic!("no number in {line}")) * 1e3
}

/// So many four-bar linkages, each with a function that solves it through snap.
fn four_bars(count: usize) -> String {
    let mut source = String::from("#![allow(clippy::all)]\nuse kin_core::prelude::*;\n");
    for index in 0..count {
        writeln!(
            source,
            "mechanism! {{
                pub struct FourBar{index} {{ pub r1: Length, pub r2: Length, pub r3: Length, pub r4: Length }}
                input theta2: Angle;
                unknown theta3: Angle, theta4: Angle;
                r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
            }}
            pub fn solve_{index}(linkage: &FourBar{index}, crank: Motion) -> Result<FourBar{index}Snap, SolveError> {{
                linkage.solve(crank, Assembly::Open)
            }}"
        )
        .expect("a string can be written");
    }
    source
}

/// A chain of so many four-bar linkages, with a function that solves it through snap.
fn chain(loops: usize) -> String {
    let (mut fields, mut unknowns, mut equations) = (String::new(), String::new(), String::new());
    let (mut crank, mut angle) = ("crank".to_owned(), "theta".to_owned());
    for index in 1..=loops {
        let (rocker, psi) = (format!("rocker_{index}"), format!("psi_{index}"));
        write!(
            fields,
            ", pub ground_{index}: Length, pub coupler_{index}: Length, pub {rocker}: Length"
        )
        .expect("a string can be written");
        writeln!(unknowns, "unknown phi_{index}: Angle, {psi}: Angle;").expect("a string can be written");
        writeln!(
            equations,
            "{crank} * cis({angle}) + coupler_{index} * cis(phi_{index}) == ground_{index} + {rocker} * cis({psi});"
        )
        .expect("a string can be written");
        (crank, angle) = (rocker, psi);
    }
    format!(
        "use kin_core::prelude::*;
        mechanism! {{ pub struct Linkages {{ pub crank: Length{fields} }} input theta: Angle; {unknowns} {equations} }}
        pub fn solve(linkages: &Linkages, crank: Motion) -> Result<LinkagesSnap, SolveError> {{
            let assembly = <Linkages as Mechanism>::assembly(0).expect(\"there are assemblies\");
            linkages.solve(crank, assembly)
        }}\n"
    )
}

/// The tip of a serial arm by its joint angles, with what is requested.
fn arm(joints: usize, request: &str) -> String {
    let list = |item: &dyn Fn(usize) -> String, separator: &str| {
        let items: Vec<String> = (0..joints).map(item).collect();
        items.join(separator)
    };
    let offsets = list(&|joint| format!("pub p{joint}: Vector3"), ", ");
    let angles = list(&|joint| format!("q{joint}: Angle"), ", ");
    let rotations = list(
        &|joint| match joint {
            0 => "let r0 = rot_z(q0);".to_owned(),
            _ => format!(
                "let r{joint} = r{} * rot_{}(q{joint});",
                joint - 1,
                ["z", "x", "y"][joint % 3]
            ),
        },
        " ",
    );
    let tip = list(&|joint| format!("r{joint} * p{joint}"), " + ");
    format!(
        "use kin_core::prelude::*;
        mechanism! {{
            pub struct Arm {{ {offsets} }}
            input {angles};
            unknown x: Length, y: Length, z: Length;
            {rotations}
            vec3(x, y, z) == {tip};
            {request}
        }}\n"
    )
}

fn measure(kind: &str, user: &User) {
    println!("time {kind}.cold_build {:.1} s", user.cold());
    let mut names = vec!["empty".to_owned()];
    let mut sources = vec![four_bars(0)];
    for count in [1, 10, 50] {
        names.push(format!("four_bars_{count}"));
        sources.push(four_bars(count));
    }
    for loops in [1, 2, 4, 8, 16] {
        names.push(format!("chain_{loops}"));
        sources.push(chain(loops));
    }
    names.push("arm_7_with_sensitivities".to_owned());
    sources.push(arm(7, "with sensitivities;"));
    for joints in [7, 15, 30] {
        names.push(format!("arm_{joints}"));
        sources.push(arm(joints, ""));
    }
    let times = user.times(&sources);
    let empty = times[0];
    println!("time {kind}.empty {:.0} ms", empty.total);
    for (name, times) in names.iter().zip(&times).skip(1) {
        let expansion = times.expansion - empty.expansion;
        println!("time {kind}.{name}.expansion {expansion:.1} ms");
        println!(
            "time {kind}.{name}.rest {:.1} ms",
            times.total - empty.total - expansion
        );
    }
    let ratio = |name: &str, other: &str| {
        let of = |name: &str| {
            let index = names.iter().position(|each| each == name).expect("it was built");
            times[index].total - empty.total
        };
        println!("ratio {kind}.{name}/{kind}.{other} {:.3}", of(name) / of(other));
    };
    for count in [10, 50] {
        ratio(&format!("four_bars_{count}"), "four_bars_1");
    }
    for loops in [2, 4, 8, 16] {
        ratio(&format!("chain_{loops}"), "chain_1");
    }
    for joints in [15, 30] {
        ratio(&format!("arm_{joints}"), "arm_7");
    }
}

/// A six-bar linkage of two dyads, with a function that asks it something.
fn six_bar(question: &str) -> String {
    format!(
        "use kin_core::prelude::*;
        use kin_core::cycle::FullCycle;
        mechanism! {{
            pub struct SixBar {{ r1: Length, r2: Length, r3: Length, r4: Length, arm: Length, r5: Length,
                r6: Length, pivot: Point }}
            input theta2: Angle;
            unknown theta3: Angle, theta4: Angle, theta5: Angle, theta6: Angle;
            r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
            r1 + arm * cis(theta4) + r5 * cis(theta5) == pivot + r6 * cis(theta6);
        }}
        pub fn ask(linkage: &SixBar) -> Option<f64> {{
            let assembly = <SixBar as Mechanism>::assembly(0)?;
            let turn = linkage.sweep(assembly).over(0.0..=6.28, 361);
            {question}
        }}\n"
    )
}

/// What each question to a mechanism costs a release build, whose dependencies are built: in one codegen unit, so that
/// the time is that of one processor.
fn questions() {
    let user = User::new(
        "user-questions",
        &[],
        "[profile.dev]\nopt-level = 3\ndebug = false\ncodegen-units = 1\n",
    );
    user.build("");
    let asked = [
        ("none", "let _ = turn; None"),
        (
            "solve",
            "let _ = turn; Some(linkage.solve(Motion::at_constant_speed(1.0, 1.0), assembly).ok()?.theta6.snap())",
        ),
        ("peak", "Some(turn.of(\"theta6_jerk\").peak().ok()?.value)"),
        ("table", "Some(turn.table().ok()?.column(\"theta6_jerk\").ok()?[7])"),
        (
            "cycle",
            "let _ = turn; Some(linkage.cycle().ok()?.branches().len() as f64)",
        ),
        (
            "stroke",
            "let _ = turn; Some(linkage.cycle().ok()?.along(0).of(\"theta6\").stroke().ok()?.length())",
        ),
        (
            "sensitivities",
            "Some(turn.of(\"theta6_jerk\").peak_sensitivities().ok()?.by[0].value)",
        ),
    ];
    let sources: Vec<String> = asked.iter().map(|(_, question)| six_bar(question)).collect();
    let times = user.times(&sources);
    for ((name, _), times) in asked.iter().zip(times) {
        println!("time questions.{name} {:.2} s", times.total / 1e3);
    }
}

/// The profile of a release build, for builds that are made in that for development.
const RELEASE: &str = "[profile.dev]\nopt-level = 3\ndebug = false\ndebug-assertions = false\n\
    overflow-checks = false\nincremental = false\n";

fn main() {
    questions();
    measure("compile_time", &User::new("user-default", &[], ""));
    let with_library = User::new("user-with-library", &["library"], "").cold();
    println!("time compile_time_with_library.cold_build {with_library:.1} s");
    let in_release = User::new("user-release", &[], RELEASE).cold();
    println!("time compile_time_in_release.cold_build {in_release:.1} s");
    measure(
        "compile_time_with_optimised_macro",
        &User::new("user-optimised", &[], "[profile.dev.build-override]\nopt-level = 3\n"),
    );
}
