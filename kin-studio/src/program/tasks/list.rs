//! `kin list`

use kin_core::in_small_letters;

use super::super::fault::Fault;
use super::super::subject::Entry;
use super::super::text::{self, Column};
use super::print;

pub(crate) fn list(all: &[Entry]) -> Result<(), Fault> {
    let descriptions: Vec<_> = all.iter().map(|entry| entry.0.description()).collect();
    let inputs = descriptions.iter().map(|one| {
        let names: Vec<&str> = one.inputs.iter().map(|input| input.name).collect();
        names.join(", ")
    });
    let mut columns = vec![
        Column::words(
            "mechanism",
            descriptions.iter().map(|one| in_small_letters(one.name, '_')).collect(),
        ),
        Column::words("inputs", inputs.collect()),
        Column::numbers(
            "unknowns",
            descriptions.iter().map(|one| one.unknowns.len().to_string()).collect(),
        ),
        Column::numbers(
            "assemblies",
            all.iter()
                .map(|one| match one.0.assemblies().len() {
                    0 => "nearby".to_owned(),
                    count => count.to_string(),
                })
                .collect(),
        ),
    ];
    columns.truncate(text::fitting(&columns, text::width()));
    print(&text::table(&columns))
}
