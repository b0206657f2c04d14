//! Races kin's solvers in Rust, C, JavaScript and NumPy, and the packages of others.
//!
//! ```text
//! cargo run --release -p kin-peers               # four-bar and slider-crank beside CasADi, SymPy, heyoka and pylinkage
//! cargo run --release -p kin-peers -- --library  # size and time of every mechanism of the library in each language
//! cargo run --release -p kin-peers -- --book     # the same, and writes the table into docs/languages.md
//! ```
//!
//! gcc, node and Python have to be installed. The packages are installed into an environment of their own, in the
//! versions that `requirements.txt` names. All contenders of a race take turns, and must find the same numbers before
//! they do.

mod environment;
mod kin;
mod library;
mod linkages;
mod race;
mod solved;

use std::process::ExitCode;

use environment::Environment;

fn main() -> ExitCode {
    let word = std::env::args().nth(1);
    let environment = Environment::new(word.is_none());
    environment.print_versions();
    match word.as_deref() {
        None => linkages::race_all(&environment),
        Some("--library") => library::measure(&environment, false),
        Some("--book") => library::measure(&environment, true),
        Some(other) => {
            eprintln!("error: there is no {other}: the arguments are --library and --book");
            return ExitCode::FAILURE;
        }
    }
    ExitCode::SUCCESS
}
