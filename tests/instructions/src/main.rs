//! Counts the instructions of kin's solvers, and refuses more than there were.
//!
//! ```text
//! cargo run --profile bench -p kin-instructions               # counts, and fails if `recorded.txt` has fewer
//! cargo run --profile bench -p kin-instructions -- --record   # counts and writes them down
//! ```
//!
//! Callgrind, of valgrind, counts. Its counts are the same in every run, however busy the machine is, so that they can
//! be asserted where times cannot. They are no times: they tell that a solver has become longer, and not how fast it
//! is.
//!
//! The counts depend on these sources, the locked version of libm, and the compiler. The counts are recorded with the
//! compiler's version: the allowance is small for that one, and larger for another.

mod callgrind;
mod counted;
mod record;

use std::collections::BTreeMap;
use std::env;
use std::process::ExitCode;

use record::Record;

/// The argument with which the program calls itself within callgrind.
const RUN: &str = "--run";

fn main() -> ExitCode {
    let outcome = match env::args().nth(1).as_deref() {
        None => counts().and_then(|counts| compare(&counts)),
        Some("--record") => counts().and_then(|counts| Record::of_this_build(counts).write()),
        Some(RUN) => counted::run().map_err(|error| error.to_string()),
        Some(other) => Err(format!("there is no {other}: the only argument is --record")),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::FAILURE
        }
    }
}

/// Instructions per pose, by the names of the counted functions.
fn counts() -> Result<BTreeMap<String, u64>, String> {
    let mut counts = callgrind::of_this_program(RUN, "counted::")?;
    for count in counts.values_mut() {
        // rounded to the nearest
        *count = (*count + counted::POSES / 2) / counted::POSES;
    }
    Ok(counts)
}

/// Prints the counts beside the recorded ones.
fn compare(counts: &BTreeMap<String, u64>) -> Result<(), String> {
    let record = Record::read()?;
    for (name, count) in counts {
        match record.counts.get(name) {
            Some(recorded) => println!("instructions {name} {count} (recorded: {recorded})"),
            None => println!("instructions {name} {count} (not recorded)"),
        }
    }
    record.refuse(counts)
}
