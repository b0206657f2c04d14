//! Races kin's solvers in Rust, C, JavaScript and NumPy, and the packages of others.
//!
//! ```text
//! cargo run --release -p kin-peers               # eight linkages beside CasADi, SymPy, heyoka and pylinkage
//! cargo run --release -p kin-peers -- jansen     # those courses whose name has this part
//! cargo run --release -p kin-peers -- --library  # size and time of every mechanism of the library in each language
//! cargo run --release -p kin-peers -- --book     # the same, and writes the table into docs/languages.md
//! ```
//!
//! gcc, node and Python have to be installed. The packages are installed into an environment of their own, in the
//! versions that `requirements.txt` names. All contenders of a race take turns, and must find the same numbers before
//! they do. Kin also tests whether a pose is in reach and whether all that it has found is finite, and says so for each
//! pose; the others do not.

mod contest;
mod environment;
mod floor;
mod kin;
mod library;
mod linkages;
mod race;
mod solved;
mod turns;

use std::process::ExitCode;

use contest::Contests;
use environment::Environment;
use floor::Units;
use turns::Turns;

fn main() -> ExitCode {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    if let ["--turns", course, way, file] = words[..] {
        linkages::visit_all(&mut Turns {
            course: course.to_owned(),
            is_prepared: way == "prepared",
            file: file.to_owned(),
        });
        return ExitCode::SUCCESS;
    }
    if words == ["--units"] {
        Units::print();
        return ExitCode::SUCCESS;
    }
    let part = words.first().copied().unwrap_or_default();
    let environment = Environment::new(!part.starts_with("--"));
    environment.print_versions();
    match part {
        "--library" => library::measure(&environment, false),
        "--book" => library::measure(&environment, true),
        other if other.starts_with("--") => {
            eprintln!("error: there is no {other}: the arguments are --library, --book and a part of a course's name");
            return ExitCode::FAILURE;
        }
        _ => {
            let mut contests = Contests {
                environment: &environment,
                part: part.to_owned(),
                units: environment.native.as_deref().and_then(Units::of),
                standings: Vec::new(),
            };
            linkages::visit_all(&mut contests);
            for line in contests.standings {
                println!("{line}");
            }
        }
    }
    ExitCode::SUCCESS
}
