//! The free fall of the chapter on loads conserves its energy as the chapter says.

use std::fs;
use std::path::Path;

#[expect(dead_code, reason = "the picture and what the example prints are not asked for here")]
#[path = "../../examples/loads.rs"]
mod example;

#[test]
fn the_drift_of_the_energy_is_up_to_date() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let chapter = fs::read_to_string(root.join("docs/loads.md")).expect("it is there");
    let loads = example::bars::<f64>();
    let mut before: Option<f64> = None;
    for tolerance in example::TOLERANCES {
        let drift = example::drift(&example::fall(&loads, tolerance, example::FALL).expect("it falls freely"));
        let line = format!("tolerance {tolerance:.0e}: {drift:.1e}");
        assert!(chapter.contains(&line), "the chapter has no line `{line}`");
        // the errors of all steps add up, and those at different tolerances differ by their luck
        assert!(drift < 100.0 * tolerance, "{tolerance:.0e}: {drift:.1e}");
        if let Some(before) = before {
            assert!(before / drift > 10.0, "{tolerance:.0e}: {before:.1e} {drift:.1e}");
        }
        before = Some(drift);
    }
}
