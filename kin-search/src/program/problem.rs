//! `kin-search problem`: a published problem, with what the literature reached and what a search reaches.

use clap::Args;
use clap::builder::PossibleValuesParser;
use kin_search::problem::{Effort, Problem};

use super::fault::Fault;
use super::print::print;

/// Which problem, and how much is searched.
#[derive(Debug, Args)]
pub(crate) struct ProblemArguments {
    /// The problem
    #[arg(value_parser = PossibleValuesParser::new(Problem::ALL.map(Problem::name)))]
    name: String,
    /// The number of starts, instead of that of the book
    #[arg(long, value_parser = clap::value_parser!(u64).range(1..))]
    starts: Option<u64>,
    /// The generations of each start, instead of those of the book
    #[arg(long, value_parser = clap::value_parser!(u64).range(1..))]
    generations: Option<u64>,
    /// The seed of the first start
    #[arg(long, default_value_t = 0)]
    seed: u64,
}

/// Prints what the problem reaches.
pub(crate) fn run(arguments: &ProblemArguments) -> Result<(), Fault> {
    // the parser lets no other name pass
    if let Some(problem) = Problem::named(&arguments.name) {
        let own = problem.effort();
        let effort = Effort {
            starts: arguments.starts.unwrap_or(own.starts),
            generations: arguments.generations.unwrap_or(own.generations),
            seed: arguments.seed,
        };
        return print(&problem.solve(effort));
    }
    Ok(())
}
