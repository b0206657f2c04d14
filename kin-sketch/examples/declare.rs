//! Declares drawings: one in JSON on each line of the input, its declaration or its faults in JSON on a line of the
//! output.

use std::error::Error;
use std::io::{BufRead, Write, stdin, stdout};

use kin_sketch::Sketch;
use serde_json::json;

fn main() -> Result<(), Box<dyn Error>> {
    for line in stdin().lock().lines() {
        let sketch: Sketch = serde_json::from_str(&line?)?;
        let answer = match sketch.declaration() {
            Ok(declaration) => json!(declaration),
            Err(faults) => json!({ "faults": faults }),
        };
        writeln!(stdout(), "{answer}")?;
    }
    Ok(())
}
