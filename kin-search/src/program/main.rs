//! The program `kin-search`: searches of mechanisms by their dimensions, in SQL.

mod bench;
#[cfg(feature = "cluster")]
mod cluster;
mod declared;
mod fault;
mod functions;
#[cfg(feature = "refine")]
mod mechanisms;
mod memory;
#[cfg(feature = "refine")]
mod pages;
mod print;
mod processor;
mod query;
#[cfg(feature = "refine")]
mod refine;
#[cfg(feature = "cluster")]
mod scaling;
mod table;

use std::process::ExitCode;

use clap::{Parser, Subcommand};
use kin_search::Functions;
use kin_search::say;

/// Searches of mechanisms by their dimensions, in SQL over kin's solvers
#[derive(Debug, Parser)]
#[command(version, about)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Answer the queries of a file of SQL
    Query(query::QueryArguments),
    /// List the functions, or tell what one of them does
    Functions(functions::FunctionsArguments),
    /// Measure candidates and poses per second, and what SQL costs
    Bench(bench::BenchArguments),
    /// Polish the best candidates of a query, and drop those that fail over the full cycle
    #[cfg(feature = "refine")]
    Refine(refine::RefineArguments),
    /// Distribute searches over executors
    #[cfg(feature = "cluster")]
    Scheduler(cluster::SchedulerArguments),
    /// Work for a scheduler
    #[cfg(feature = "cluster")]
    Executor(cluster::ExecutorArguments),
    /// Search the same ids in this process and on executors of one core each, and print what each takes
    #[cfg(feature = "cluster")]
    Scaling(scaling::ScalingArguments),
}

#[tokio::main]
async fn main() -> ExitCode {
    let command = Arguments::parse().command;
    let functions = Functions::library();
    let done = match command {
        Command::Query(arguments) => query::run(arguments, &functions).await,
        Command::Functions(arguments) => functions::run(&arguments, &functions),
        Command::Bench(arguments) => bench::run(&arguments, &functions).await,
        #[cfg(feature = "refine")]
        Command::Refine(arguments) => refine::run(&arguments, &functions),
        #[cfg(feature = "cluster")]
        Command::Scheduler(arguments) => arguments.run(&functions).await,
        #[cfg(feature = "cluster")]
        Command::Executor(arguments) => arguments.run(&functions).await,
        #[cfg(feature = "cluster")]
        Command::Scaling(arguments) => arguments.run(&functions).await,
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(fault) => {
            say(format_args!("{fault}"));
            fault.code()
        }
    }
}
