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
    for steps in example::STEPS {
        let drift = example::drift(&example::fall(&loads, steps).expect("it falls freely"));
        let line = format!("{steps:>6} steps: {drift:.1e}");
        assert!(chapter.contains(&line), "the chapter has no line `{line}`");
        // the method is of the fourth order
        if let Some(before) = before {
            assert!(before / drift > 14.0, "{steps} steps: {before:.1e} {drift:.1e}");
        }
        before = Some(drift);
    }
}
