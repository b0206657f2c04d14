//! Tables of comma-separated values: candidates in, results out.

use std::fmt::Write as _;

use kin_core::assembly_named;

use crate::design::{Candidate, Design};
use crate::functions::{Choice, FitFunctions};
use crate::job::JobError;
use crate::refine::Refinement;

/// The cells of a line. A cell in quotes may hold commas, and a quote is written twice in it.
fn cells(line: &str) -> Vec<String> {
    let mut reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .trim(csv::Trim::All)
        .from_reader(line.as_bytes());
    let record = reader.records().next().and_then(Result::ok).unwrap_or_default();
    record.iter().map(str::to_owned).collect()
}

/// The candidates of the first rows of a table, each with the text of the other columns of its line. A row without an
/// assembly is a candidate in each assembly. Rows without an id count from 0.
///
/// # Errors
/// [`JobError::Candidate`].
pub fn read(
    functions: &'static dyn FitFunctions,
    table: &str,
    best: usize,
) -> Result<Vec<(Candidate, String)>, JobError> {
    let wrong = |line: usize, message: String| JobError::Candidate { line, message };
    let mut lines = table.lines().zip(1..).filter(|(line, _)| !line.trim().is_empty());
    let (head, line) = lines
        .next()
        .ok_or_else(|| wrong(1, "the table is empty: its first line names the columns".to_owned()))?;
    let names = cells(head.trim_start_matches('\u{feff}'));
    let column = |wanted: &str| {
        let plain = wanted.replace('.', "_").to_lowercase();
        names
            .iter()
            .position(|name| name == wanted || name.to_lowercase() == plain)
    };
    let mut columns = Vec::new();
    for quantity in functions.description().parameters {
        let index = column(quantity.name);
        columns.push(index.ok_or_else(|| wrong(line, format!("no column is called `{}`", quantity.name)))?);
    }
    let [id_column, assembly_column, phase, mechanism] = ["id", "assembly", "input_phase", "mechanism"].map(column);
    let placement = ["placed_x", "placed_y", "placed_turn"].map(column);
    let assembly_names: Vec<String> = functions.assembly_names();
    let mut candidates = Vec::new();
    for (row, (text, line)) in lines.take(best).enumerate() {
        let cells = cells(text);
        let cell = |column: usize| cells.get(column).map_or("", String::as_str);
        let number = |column: usize| {
            let value = cell(column).parse::<f64>().ok().filter(|value| value.is_finite());
            value.ok_or_else(|| {
                wrong(
                    line,
                    format!("`{}` in the column `{}` is no number", cell(column), names[column]),
                )
            })
        };
        let parameters: Vec<f64> = columns.iter().map(|column| number(*column)).collect::<Result<_, _>>()?;
        let id = match id_column {
            Some(column) => {
                let id = cell(column).parse::<u64>();
                id.map_err(|_| {
                    wrong(
                        line,
                        format!("`{}` in the column `id` is no whole number", cell(column)),
                    )
                })?
            }
            None => row as u64,
        };
        let placement = match placement {
            [Some(x), Some(y), Some(angle)] => Some([number(x)?, number(y)?, number(angle)?]),
            _ => None,
        };
        let phase = phase.map(number).transpose()?;
        let known = [id_column, assembly_column, mechanism];
        let other = (0..names.len()).filter(|column| !columns.contains(column) && !known.contains(&Some(*column)));
        let said: Vec<String> = other
            .map(|column| format!("{}: {}", names[column], cell(column)))
            .collect();
        let said = said.join("; ");
        let assemblies: Vec<usize> = match assembly_column {
            Some(column) => {
                let found = assembly_named(&assembly_names, cell(column));
                vec![found.ok_or_else(|| {
                    let known = assembly_names.join("`, `");
                    wrong(line, format!("`{}` is no assembly; there are `{known}`", cell(column)))
                })?]
            }
            None => (0..functions.assembly_count()).collect(),
        };
        for assembly in assemblies {
            let candidate = Candidate::with_parameters(parameters.clone(), Choice::Assembly(assembly)).numbered(id);
            let candidate = Candidate {
                placement,
                phase,
                ..candidate
            };
            candidates.push((candidate, said.clone()));
        }
    }
    Ok(candidates)
}

impl Refinement {
    /// All results as comma-separated values, those that were dropped with their defect. Errors are roots of mean
    /// squares, the largest error is that of one target, and the transmission angle is the smallest one over the
    /// travel, in degrees.
    #[must_use]
    pub fn table(&self) -> String {
        let mut table = "id,defect,start,evolved,polished,largest,transmission".to_owned();
        let named = |design: &Design| -> Vec<(&'static str, f64)> { design.named().collect() };
        let first = self.results.first().map(|result| &result.design);
        if let Some(design) = first.or(self.dropped.first().map(|dropped| &dropped.design)) {
            for (name, _) in named(design) {
                let _ = write!(table, ",{}", name.replace('.', "_"));
            }
        }
        table.push_str(",assembly\n");
        let assembly = |design: &Design| {
            let index = design.choice().index();
            index
                .and_then(|index| self.functions.assembly_name(index))
                .unwrap_or_default()
        };
        let number = |value: Option<f64>| value.map_or_else(String::new, |value| format!("{value}"));
        let mut line = |id: u64, defect: &str, figures: [Option<f64>; 5], design: &Design| {
            let _ = write!(table, "{id},{defect}");
            for value in figures
                .into_iter()
                .chain(named(design).into_iter().map(|(_, value)| Some(value)))
            {
                let _ = write!(table, ",{}", number(value));
            }
            let _ = writeln!(table, ",\"{}\"", assembly(design));
        };
        for result in &self.results {
            let figures = [
                result.start.map(|misfit| misfit.root_mean_square),
                result.evolved.map(|misfit| misfit.root_mean_square),
                Some(result.polished.root_mean_square),
                Some(result.polished.largest),
                result.figures.transmission.map(|least| least.value.to_degrees()),
            ];
            line(result.id, "", figures, &result.design);
        }
        for dropped in &self.dropped {
            let misfit = dropped.misfit;
            let figures = [
                None,
                None,
                misfit.map(|misfit| misfit.root_mean_square),
                misfit.map(|misfit| misfit.largest),
                None,
            ];
            line(dropped.id, &dropped.defect.kind().to_string(), figures, &dropped.design);
        }
        table
    }
}
