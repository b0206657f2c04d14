//! `functions`: what can be called in a query.

use kin_search::Functions;

use super::fault::Fault;

/// What `functions` takes.
#[derive(Debug, clap::Args)]
pub(crate) struct FunctionsArguments {
    /// The function that is told; all are listed without it
    name: Option<String>,
}

/// Prints the list, or one function.
pub(crate) fn run(arguments: &FunctionsArguments, functions: &Functions) -> Result<(), Fault> {
    let Some(name) = &arguments.name else {
        for line in functions.list() {
            println!("{line}");
        }
        return Ok(());
    };
    let Some(function) = functions.iter().find(|function| function.name() == name) else {
        return Err(Fault::Wrong(format!(
            "there is no function {name}; `kin-search functions` lists all"
        )));
    };
    if let Some(documentation) = function.documentation() {
        println!("{}\n\n{}\n", documentation.syntax_example, documentation.description);
        for (name, meaning) in documentation.arguments.iter().flatten() {
            println!("  {name}: {meaning}");
        }
    }
    Ok(())
}
