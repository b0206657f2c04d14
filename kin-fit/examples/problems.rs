//! Published problems: what the literature reached, computed again, and what a seeded search reaches.
//!
//! ```sh
//! cargo run --release -p kin-fit --example problems -- straight-line
//! cargo run --release -p kin-fit --example problems -- path --starts 300 --generations 1000 --seed 0
//! ```

#[allow(dead_code, reason = "a test uses the rest")]
mod published;

use std::process::ExitCode;

use published::report::Problem;

/// The problem of the arguments with its effort, or `None` if they are wrong.
fn asked(mut arguments: impl Iterator<Item = String>) -> Option<(Problem, kin_fit::Effort)> {
    let problem = Problem::named(&arguments.next()?)?;
    let mut effort = problem.effort();
    while let Some(name) = arguments.next() {
        let number = arguments.next()?.parse().ok()?;
        match name.as_str() {
            "--starts" => effort.starts = number,
            "--generations" => effort.generations = number,
            "--seed" => effort.seed = number,
            _ => return None,
        }
    }
    Some((problem, effort))
}

fn main() -> ExitCode {
    if let Some((problem, effort)) = asked(std::env::args().skip(1)) {
        print!("{}", problem.solve(effort));
        return ExitCode::SUCCESS;
    }
    let names = Problem::ALL.map(Problem::name).join("|");
    eprintln!("usage: problems {names} [--starts N] [--generations N] [--seed N]");
    ExitCode::from(2)
}
