//! `functions`: the functions of queries.

use std::fmt::Write as _;

use kin_search::Functions;

use super::declared::DeclaredArguments;
use super::fault::Fault;
use super::print::print;

/// The options of `functions`.
#[derive(Debug, clap::Args)]
pub(crate) struct FunctionsArguments {
    /// The function to describe; all are listed without it
    name: Option<String>,
    #[command(flatten)]
    declared: DeclaredArguments,
}

/// Prints the list, or one function.
pub(crate) fn run(arguments: &FunctionsArguments, functions: &Functions) -> Result<(), Fault> {
    let functions = arguments.declared.join(functions)?;
    let Some(name) = &arguments.name else {
        return print(
            &functions
                .list()
                .iter()
                .fold(String::new(), |text, line| text + line + "\n"),
        );
    };
    let Some(function) = functions.iter().find(|function| function.name() == name) else {
        return Err(Fault::Wrong(format!(
            "there is no function {name}; `kin-search functions` lists all"
        )));
    };
    let Some(documentation) = function.documentation() else {
        return Ok(());
    };
    let mut text = format!("{}\n\n{}\n\n", documentation.syntax_example, documentation.description);
    for (name, meaning) in documentation.arguments.iter().flatten() {
        let _ = writeln!(text, "  {name}: {meaning}");
    }
    print(&text)
}
