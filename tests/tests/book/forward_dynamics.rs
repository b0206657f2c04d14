//! Mechanisms without a drive move as the chapter on loads says.

use std::fs;
use std::path::Path;

#[expect(dead_code, reason = "what the example prints is not asked for here")]
#[path = "../../examples/forward_dynamics.rs"]
mod example;

/// The published digits, of which the last is a part in 10¹² or 10¹³, to ten times the sum of the errors that the
/// integration allows in each of its 900 steps.
#[test]
fn parallelograms_move_as_published() {
    for ((time, expected), allowed) in example::BENCHMARK.into_iter().zip([1e-11, 1e-10]) {
        let (found, drift) = example::parallelograms(time, 1e-13).expect("they move");
        for (found, expected) in found.into_iter().zip(expected) {
            assert!((found - expected).abs() < allowed, "{time}: {found} {expected}");
        }
        assert!(drift < 1e-12, "{time}: {drift:.1e}");
    }
}

/// What the press loses is the heat of friction, and the difference is that of the integration.
#[test]
fn friction_takes_what_is_lost() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let chapter = fs::read_to_string(root.join("docs/loads.md")).expect("it is there");
    // compiled without optimisation, the finer ones take minutes
    let count = if cfg!(feature = "every-case") { 4 } else { 2 };
    for tolerance in example::TOLERANCES.into_iter().take(count) {
        let [before, after, heat] = example::coasted(tolerance).expect("it runs on");
        let open = (before - after - heat).abs() / before;
        let line = format!("{before:.2} J = {after:.2} J + {heat:.2} J of heat");
        // the coarsest integration has errors of these digits
        assert!(
            tolerance > 1e-5 || chapter.contains(&line),
            "the chapter has no line `{line}`"
        );
        // the integration decides anew in each build about steps at the tolerance, of which there are a few hundred
        assert!(
            open < 10.0 * tolerance && heat > 0.3 * before,
            "{tolerance:.0e}: {open:.1e}"
        );
    }
}
