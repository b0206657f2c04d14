//! Published problems: the results of the literature, computed again, and those of a seeded search.
//!
//! ```sh
//! cargo run --release -p kin-fit --example problems -- straight-line
//! cargo run --release -p kin-fit --example problems -- path --starts 300 --generations 1000 --seed 0
//! ```

mod published;

use std::process::ExitCode;

use kin_fit::Effort;
use published::report::{PROBLEMS, Problem};

/// The problem of the arguments with its effort, or `None` if they are wrong.
fn asked(mut arguments: impl Iterator<Item = String>) -> Option<(&'static Problem, Effort)> {
    let name = arguments.next()?;
    let problem = PROBLEMS.iter().find(|problem| problem.name == name)?;
    let mut effort = Effort {
        starts: problem.starts,
        generations: problem.generations,
        seed: 0,
    };
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
    let names = PROBLEMS.each_ref().map(|problem| problem.name).join("|");
    eprintln!("usage: problems {names} [--starts N] [--generations N] [--seed N]");
    ExitCode::from(2)
}
