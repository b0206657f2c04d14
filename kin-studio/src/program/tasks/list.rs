//! `kin list`

use kin_core::in_small_letters;

use super::super::text::{self, Column};
use super::print;
use crate::case::fault::Fault;
use crate::case::subject::Subject;
use crate::library::DESIGNS;

pub(crate) fn list() -> Result<(), Fault> {
    let all: Result<Vec<Subject>, Fault> = DESIGNS.iter().map(Subject::of_library).collect();
    let all = all?;
    let descriptions: Vec<_> = all.iter().map(Subject::description).collect();
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
                .map(|one| match one.assemblies().len() {
                    0 => "nearby".to_owned(),
                    count => count.to_string(),
                })
                .collect(),
        ),
    ];
    columns.truncate(text::fitting(&columns, text::width()));
    print(&text::table(&columns))
}
