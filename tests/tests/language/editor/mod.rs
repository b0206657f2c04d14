//! Declarations in an editor: rust-analyzer completes, explains and follows the names in them, keeps the solvers of a
//! half-typed one, and finds no fault in a sound one.
//!
//! `cargo test -p kin-tests --test language -- --ignored editor` runs this where rust-analyzer is installed, as
//! `.ci/run` does.

mod server;

use std::fs;
use std::path::{Path, PathBuf};

use server::Server;

const PROGRAM: &str = "\
use kin_core::prelude::*;

mechanism! {
    pub struct FourBar { pub r1: Length, pub r2: Length, pub r3: Length, pub r4: Length, pub tip: Vector }
    input theta2: Angle;
    unknown theta3: Angle, theta4: Angle;
    let half = (r3 + r4) / 2;
    r2 * cis(theta2) + r3 * theta3.cis() == r1 + r4 * cis(theta4);
    output pin: Point = r2 * cis(theta2) + tip * cis(theta3) + half;
    with sensitivities, transmission_angles;
    let coupler = frame(r2 * cis(theta2), theta3);
    for (trace, trail) in [(tip, pen), (tip / 2, rubber)] {
        let mark = coupler * trace;
        output trail: Point = mark;
    }
}

fn main() -> Result<(), SolveError> {
    let linkage: FourBar = FourBar { r1: 90.0, r2: 30.0, r3: 60.0, r4: 45.0, tip: Plane::new(1.0, 2.0) };
    let pose = linkage.solve(Motion::at_constant_speed(1.1, 10.0), Assembly::Open)?;
    println!(\"{}\", pose.theta3.value());
    Ok(())
}
";

/// The program with one stretch replaced.
fn with(old: &str, new: &str) -> String {
    assert!(PROGRAM.contains(old), "the program contains no {old}");
    PROGRAM.replacen(old, new, 1)
}

fn repository() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("..")
        .canonicalize()
        .expect("the tests lie in the repository")
}

#[test]
#[ignore = "rust-analyzer"]
fn an_editor_understands_declarations() {
    let mut server = Server::start(PROGRAM);
    names_are_completed(&mut server);
    names_are_explained_and_followed(&mut server);
    a_half_typed_declaration_keeps_its_solvers(&mut server);
    helpers_are_not_offered(&mut server);
    each_mistake_is_told_once(&mut server);
    sound_declarations_have_no_messages(&mut server);
}

fn names_are_completed(server: &mut Server) {
    let names = ["r1", "tip", "theta2", "theta4", "half", "cis", "polar", "PI"];
    for (old, new, wanted) in [
        ("r1 + r4", "th¦ + r4", names.as_slice()),
        ("r1 + r4", "¦ + r4", &names),
        ("    output pin", "    r2 * c¦\n    output pin", &names),
        (
            "    output pin",
            "    out¦\n    output pin",
            &["input", "unknown", "output"],
        ),
        (
            "theta4: Angle",
            "theta4: An¦",
            &["Angle", "Length", "Direction", "Scalar"],
        ),
        ("r3: Length", "r3: Le¦", &["Length", "Vector3"]),
        ("theta3.cis()", "theta3.¦", &["cis", "sin"]),
        ("+ half", "+ half.¦", &["x", "y", "norm"]),
        ("with sensitivities", "with sen¦", &["sensitivities", "test"]),
        ("coupler * trace", "coupler * tr¦", &["trace", "tip", "coupler"]),
        ("= mark", "= ma¦", &["mark", "trace"]),
    ] {
        let offered = server.completions(&with(old, new));
        for name in wanted {
            assert!(
                offered.iter().any(|own| own == name),
                "no `{name}` at `{new}`: {offered:?}"
            );
        }
    }
}

fn names_are_explained_and_followed(server: &mut Server) {
    for (old, new, told) in [
        ("cis(theta2)", "c¦is(theta2)", "unit vector of the plane"),
        ("theta3.cis", "the¦ta3.cis", "theta3: Angle"),
        ("theta2: Angle", "theta2: An¦gle", "in radians"),
        ("with sensitivities", "with sensi¦tivities", "partial derivatives"),
    ] {
        let hint = server.hover(&with(old, new));
        assert!(hint.contains(told), "at `{new}`: {hint}");
    }
    for (old, new, place) in [
        ("theta3.cis", "the¦ta3.cis", "theta3: Angle, theta4"),
        ("r1 + r4", "r¦1 + r4", "r1: Length, pub r2"),
        ("+ half", "+ ha¦lf", "half = (r3"),
        ("coupler * trace", "coupler * tra¦ce", "trace, trail) in"),
        ("(tip, pen)", "(ti¦p, pen)", "tip: Vector }"),
        ("pose.theta3", "pose.the¦ta3", "theta3: Angle, theta4"),
    ] {
        let found = server.definitions(&with(old, new));
        assert!(
            found.iter().any(|line| line.starts_with(place)),
            "at `{new}`: {found:?}"
        );
    }
}

fn a_half_typed_declaration_keeps_its_solvers(server: &mut Server) {
    let broken = with("== r1 + r4 * cis(theta4);", "== r1 + r4 * ;");
    assert_eq!(
        server.diagnostics(&broken),
        ["nothing follows this `*`: complete the expression"]
    );
    let at = |old: &str, new: &str| broken.replacen(old, new, 1);
    for (text, wanted) in [
        (
            at("    let pose", "    linkage.¦;\n    let pose"),
            ["r1", "solve", "position", "position_near", "skeleton"].as_slice(),
        ),
        (at("pose.theta3.value()", "pose.¦"), &["theta2", "theta3", "pin"]),
        (at("pose.theta3.value()", "pose.theta3.¦"), &["value", "snap"]),
        (
            at("fn main", "fn show(pose: &FourBar¦) {}\nfn main"),
            &["FourBarPosition", "FourBarSnap", "FourBarAssembly"],
        ),
    ] {
        let offered = server.completions(&text);
        for name in wanted {
            assert!(
                offered.iter().any(|own| own == name),
                "no `{name}` in {offered:?}\n{text}"
            );
        }
    }
}

fn helpers_are_not_offered(server: &mut Server) {
    let offered = server.completions(&with("    let pose", "    linkage.¦;\n    let pose"));
    assert!(offered.iter().any(|name| name == "solve"), "{offered:?}");
    let helpers: Vec<&String> = offered.iter().filter(|name| name.starts_with("__")).collect();
    assert!(helpers.is_empty(), "{helpers:?}");
}

fn each_mistake_is_told_once(server: &mut Server) {
    for (old, new) in [
        ("r1 + r4 * cis(theta4)", "r1 + r5 * cis(theta4)"),
        ("r4 * cis(theta4)", "r4 * cis(theta4).velocity()"),
        ("r4 * cis(theta4)", "r4 * ciss(theta4)"),
        ("r4 * cis(theta4)", "r4 * cis(theta4, 2)"),
        ("r4 * cis(theta4)", "r4 * cis"),
        ("r4 * cis(theta4)", "r4 * theta4."),
        ("r4 * cis(theta4)", "r4 * exp(i * theta4)"),
        ("theta4: Angle", "theta4: Angel"),
        ("with sens", "order = 99; with sens"),
        ("tip: Vector }", "tip: Vector } # the crank"),
    ] {
        let messages = server.diagnostics(&with(old, new));
        assert_eq!(messages.len(), 1, "`{new}`: {messages:#?}");
    }
}

fn sound_declarations_have_no_messages(server: &mut Server) {
    assert_eq!(server.diagnostics(PROGRAM), [""; 0]);
    let library = repository().join("kin-core/src/library");
    let mut count = 0;
    for entry in fs::read_dir(library).expect("the library is a folder") {
        let file = entry.expect("the library can be read").path();
        let text = fs::read_to_string(&file).expect("the library can be read");
        // a file without a declaration may belong to a feature that is off here
        if !text.contains("mechanism! {") {
            continue;
        }
        server.open(&file, &text);
        assert_eq!(server.diagnostics_of(&file), [""; 0], "{}", file.display());
        count += text.matches("mechanism! {").count();
    }
    assert!(count > 30, "{count} declarations");
}
