//! `kin fit`: dimensions by least squares, from points of a path or from values of an unknown.
//!
//! The minimiser is basin's bounded Levenberg-Marquardt method. It cuts a whole step where one number meets its bound,
//! so that all may stand still there. Then a reflective trust region goes on, whose steps take much longer for long
//! files. The derivatives by the dimensions come from the solver in numbers that carry them.

use std::convert::Infallible;
use std::f64::consts::{PI, TAU};
use std::fmt::Write as _;

use basin::{
    BoundedLevenbergMarquardt, BoxBounds, ConstraintDescription, ConstraintSet, Constraints, DenseMatrix, Executor,
    Jacobian, PointState, Residual, Solver, TrustRegionReflective,
};
use kin_core::Dimension;
use kin_core::any::{Description, Quantity};

use super::super::case::Case;
use super::super::command::Fit;
use super::super::fault::{Fault, similar};
use super::super::file::Told;
use super::super::motion::InputMotion;
use super::super::progress::watched;
use super::super::subject::{Partial, Subject, Wanted};
use super::super::text::{self, Column, Units};
use super::super::value::{self, Lengths};
use super::print;

/// The deviation of a row that does not close, in units of the spread of the data: larger than any that does, so that
/// the step is refused.
const OPEN: f64 = 100.0;
/// The places of the leading input among which the start of a row without an input is sought.
const PLACES: u32 = 72;
/// The mean deviation, in units of the spread of the data, below which the numbers are met: what is left of it are
/// roundings.
const MET: f64 = 1e-8;
/// The part of the sum of squares that one change alone takes away where no minimum was reached. Slow ends in long
/// valleys leave less, and steps that were cut leave much more.
const LOWERED: f64 = 1e-4;

/// The numbers that are to be met.
struct Data {
    /// For each column its place among unknowns and outputs.
    columns: Vec<usize>,
    /// For each row the inputs, where they are given.
    inputs: Vec<Vec<Option<f64>>>,
    /// For each row the values, where they are given.
    values: Vec<Vec<Option<f64>>>,
}

impl Data {
    /// The first value of an input that every row has.
    fn begin(&self, input: usize) -> Option<f64> {
        let all: Option<Vec<f64>> = self.inputs.iter().map(|row| row[input]).collect();
        all?.first().copied()
    }
}

pub(super) fn run(subject: &Subject, options: &Fit, told: &Told) -> Result<(), Fault> {
    let typed = options.setup.typed(told);
    let case = typed.case_without_range(subject, 0.0)?;
    let mut lengths = match case.length {
        "" => Lengths::default(),
        name => Lengths::named(name).map_err(Fault::Wrong)?,
    };
    let data = read(subject, options, &mut lengths)?;
    // a range is for the rows whose input is sought
    let case = match data.begin(case.lead) {
        Some(begin) => typed.case_without_range(subject, begin)?,
        None => typed.case(subject)?,
    };
    let problem = Problem::new(subject, options, &case, data, &mut lengths)?;
    let start = problem.start.clone();
    if start.is_empty() {
        return Err(Fault::wrong("the mechanism has no dimensions that could change"));
    }
    if problem.values_given() < start.len() {
        eprintln!(
            "note: {} numbers are given for {} that may change, so many linkages fit alike: vary fewer dimensions",
            problem.values_given(),
            start.len()
        );
    }
    if problem.poses(&start).iter().all(Option::is_none) {
        return Err(Fault::open(
            "the mechanism closes in no row with the dimensions to start from: give better ones by `--set`",
        ));
    }
    let found = watched("fitting", 1, |_| problem.least())?;
    print(&problem.shown(&case, &start, &found))?;
    problem.closes(&found)?;
    problem.is_settled(&found)
}

/// Reads the file of numbers.
fn read(subject: &Subject, options: &Fit, lengths: &mut Lengths) -> Result<Data, Fault> {
    let path = options.data.display();
    let text = std::fs::read_to_string(&options.data)
        .map_err(|error| Fault::wrong(format!("{path} cannot be read: {error}")))?;
    let description = subject.description();
    let names: Vec<&Quantity<'_>> = quantities(description);
    let mut reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .flexible(true)
        .trim(csv::Trim::All)
        .from_reader(text.trim_start_matches('\u{feff}').as_bytes());
    let mut records = reader
        .records()
        .filter(|record| !record.as_ref().is_ok_and(|record| record.iter().all(str::is_empty)));
    let unread = |error: csv::Error| Fault::wrong(format!("{path} cannot be read: {error}"));
    let Some(head) = records.next().transpose().map_err(unread)? else {
        return Err(Fault::wrong(format!(
            "{path} is empty: its first line names the columns"
        )));
    };
    let mut columns = Vec::new();
    for cell in &head {
        let (name, unit) = match cell.split_once('[') {
            Some((name, unit)) => (name.trim(), unit.trim_end_matches(']').trim()),
            None => (cell, ""),
        };
        // a length without a unit, as a sweep writes it
        let unit = if unit == "L" { "" } else { unit };
        let input = description.inputs.iter().position(|input| input.name == name);
        let value = names.iter().position(|quantity| quantity.name == name);
        let role = match (input, value) {
            (Some(index), _) => Some((true, index, description.inputs[index].dimension)),
            (None, Some(index)) => Some((false, index, names[index].dimension)),
            // rates and remarks of a table that this program wrote
            _ if is_of_a_sweep(description, name) => None,
            _ => {
                let all = description
                    .inputs
                    .iter()
                    .chain(names.iter().copied())
                    .map(|one| one.name);
                return Err(Fault::wrong(format!(
                    "{path}: no quantity is called `{name}`; {}",
                    similar(name, all)
                )));
            }
        };
        if let Some((.., Dimension::Angle)) = role
            && unit.is_empty()
        {
            return Err(Fault::wrong(format!(
                "{path}: the angle `{name}` has no unit: name the column `{name} [deg]`"
            )));
        }
        columns.push(role.map(|role| (role, unit)));
    }
    let mut data = Data {
        columns: columns
            .iter()
            .filter_map(|column| {
                column
                    .as_ref()
                    .and_then(|((is_input, index, _), _)| (!is_input).then_some(*index))
            })
            .collect(),
        inputs: Vec::new(),
        values: Vec::new(),
    };
    if data.columns.is_empty() {
        let first = names.first().map_or("theta4", |quantity| quantity.name);
        return Err(Fault::wrong(format!(
            "{path} has no column of an unknown or an output, such as `{first}`"
        )));
    }
    for record in records {
        let record = record.map_err(unread)?;
        let line = record.position().map_or(0, csv::Position::line);
        let (mut inputs, mut values) = (vec![None; description.inputs.len()], Vec::new());
        for (cell, column) in record.iter().chain(std::iter::repeat("")).zip(&columns) {
            let Some(((is_input, index, dimension), unit)) = column else {
                continue;
            };
            let number = if cell.is_empty() {
                None
            } else {
                let value = value::quantity(*dimension, &format!("{cell}{unit}"), lengths)
                    .map_err(|message| Fault::wrong(format!("{path}, line {line}: {message}")))?;
                Some(value)
            };
            if *is_input {
                inputs[*index] = number;
            } else {
                values.push(number);
            }
        }
        if values.iter().any(Option::is_some) {
            data.inputs.push(inputs);
            data.values.push(values);
        }
    }
    if data.values.is_empty() {
        return Err(Fault::wrong(format!(
            "{path} has no rows of numbers below the names of the columns"
        )));
    }
    Ok(data)
}

/// Whether a sweep writes a column of this name.
fn is_of_a_sweep(description: &Description<'_>, name: &str) -> bool {
    let all = description
        .inputs
        .iter()
        .chain(description.unknowns)
        .chain(description.outputs);
    let is_rate = |quantity: &Quantity<'_>| {
        name.strip_prefix(quantity.name)
            .is_some_and(|rest| rest.starts_with('_'))
    };
    ["outcome", "margin", "time", "row", ""].contains(&name) || all.into_iter().any(is_rate)
}

fn quantities<'d>(description: &'d Description<'d>) -> Vec<&'d Quantity<'d>> {
    description.unknowns.iter().chain(description.outputs).collect()
}

/// The sum of squares that is to become small.
struct Problem<'s> {
    subject: &'s Subject,
    data: std::rc::Rc<Data>,
    assembly: Wanted,
    parameters: Vec<f64>,
    /// The inputs that stand, and the first values of those that move.
    standing: Vec<f64>,
    /// The dimensions that change.
    varied: Vec<usize>,
    /// The rows whose leading input is sought.
    free: Vec<usize>,
    lead: usize,
    start: Vec<f64>,
    lower: Vec<f64>,
    upper: Vec<f64>,
    /// The spread of the values of each column.
    scales: Vec<f64>,
}

impl<'s> Problem<'s> {
    fn new(subject: &'s Subject, options: &Fit, case: &Case, data: Data, lengths: &mut Lengths) -> Result<Self, Fault> {
        let description = subject.description();
        let varied = varied(description, &options.vary)?;
        let longest = description
            .parameters
            .iter()
            .zip(&case.parameters)
            .filter(|(quantity, _)| quantity.dimension == Dimension::Length)
            .fold(0.0_f64, |longest, (_, value)| longest.max(value.abs()));
        let (mut start, mut lower, mut upper) = (Vec::new(), Vec::new(), Vec::new());
        for &index in &varied {
            let (quantity, value) = (&description.parameters[index], case.parameters[index]);
            let (low, high) = match quantity.dimension {
                Dimension::Angle => (value - PI, value + PI),
                // a coordinate has a dot in its name
                Dimension::Length if quantity.name.contains('.') || value == 0.0 => {
                    (value - 4.0 * longest, value + 4.0 * longest)
                }
                Dimension::Length => ((value / 4.0).min(value * 4.0), (value / 4.0).max(value * 4.0)),
                Dimension::Scalar => (value - value.abs().max(1.0), value + value.abs().max(1.0)),
            };
            start.push(value);
            lower.push(low);
            upper.push(high);
        }
        for text in &options.within {
            let Some((name, range)) = text.split_once('=') else {
                return Err(Fault::wrong(format!(
                    "`{text}` is no name with a range, as in `--within r2=10..50`"
                )));
            };
            let place = varied
                .iter()
                .position(|index| description.parameters[*index].name == name.trim());
            let Some(place) = place else {
                let names = varied.iter().map(|index| description.parameters[*index].name);
                return Err(Fault::wrong(format!(
                    "no dimension `{}` may change; {}",
                    name.trim(),
                    similar(name, names)
                )));
            };
            let dimension = description.parameters[varied[place]].dimension;
            let (low, high) = value::range(dimension, range, lengths)
                .map_err(|message| Fault::wrong(format!("{}: {message}", name.trim())))?;
            (lower[place], upper[place]) = (low.min(high), low.max(high));
            start[place] = start[place].clamp(lower[place], upper[place]);
        }
        let lead = case.lead;
        let standing: Vec<f64> = case.motions.iter().map(InputMotion::start).collect();
        let free: Vec<usize> = (0..data.inputs.len())
            .filter(|row| data.inputs[*row][lead].is_none())
            .collect();
        let scales = scales(description, &data);
        // the values are those where the motion begins, and each row is reached from there
        let assembly = match &case.assembly {
            Wanted::Near(near) => Wanted::At {
                inputs: standing.clone(),
                near: near.clone(),
            },
            other => other.clone(),
        };
        let mut problem = Self {
            subject,
            data: data.into(),
            assembly,
            parameters: case.parameters.clone(),
            standing,
            varied,
            free,
            lead,
            start,
            lower,
            upper,
            scales,
        };
        let (from, to) = (case.motions[lead].start(), case.motions[lead].end());
        let (low, high) = ends(description.inputs[lead].dimension, from, to);
        for row in problem.free.clone() {
            let best = problem.nearest(row, from, to)?;
            problem.start.push(best);
            problem.lower.push(low);
            problem.upper.push(high);
        }
        Ok(problem)
    }

    fn clone_for_search(&self) -> Self {
        Self {
            subject: self.subject,
            data: self.data.clone(),
            assembly: self.assembly.clone(),
            parameters: self.parameters.clone(),
            standing: self.standing.clone(),
            varied: self.varied.clone(),
            free: self.free.clone(),
            lead: self.lead,
            start: self.start.clone(),
            lower: self.lower.clone(),
            upper: self.upper.clone(),
            scales: self.scales.clone(),
        }
    }

    /// The nearest minimum, or where the search for it ended.
    fn least(&self) -> Result<Vec<f64>, Fault> {
        let fast = BoundedLevenbergMarquardt::new().with_relative_cost_change_tolerance(1e-12);
        let found = self.searched(fast, &self.start)?;
        if self.lowering(&found).is_none() {
            return Ok(found);
        }
        // the slopes have no scale of their own, so that only the sum of squares says when to end
        let reflective = TrustRegionReflective::new()
            .with_absolute_scaled_gradient_tolerance(None)
            .with_relative_cost_change_tolerance(1e-12);
        self.searched(reflective, &found)
    }

    fn searched<M>(&self, minimiser: M, start: &[f64]) -> Result<Vec<f64>, Fault>
    where
        M: Solver<Self, PointState<Vec<f64>>>,
        M::Error: std::fmt::Display,
    {
        let result = Executor::new(self.clone_for_search(), minimiser, PointState::new(start.to_vec()))
            .max_iter(500)
            .target_objective(0.5 * self.met())
            .run()
            .map_err(|error| Fault::open(format!("the fit failed: {error}")))?;
        Ok(result.best_param().clone())
    }

    /// The sum of squares below which the numbers are met.
    fn met(&self) -> f64 {
        #[expect(clippy::cast_precision_loss, reason = "files have fewer numbers")]
        let count = self.values_given() as f64;
        MET * MET * count
    }

    fn values_given(&self) -> usize {
        self.data.values.iter().flatten().flatten().count()
    }

    /// The place of the leading input whose values are nearest to those of a row.
    fn nearest(&self, row: usize, from: f64, to: f64) -> Result<f64, Fault> {
        let mut best: Option<(f64, f64)> = None;
        for place in 0..=PLACES {
            let at = from + (to - from) * f64::from(place) / f64::from(PLACES);
            let mut inputs = self.inputs(row, &self.start);
            inputs[self.lead] = at;
            let Ok(pose) = self.subject.partial(&self.parameters, &inputs, &self.assembly) else {
                continue;
            };
            let sum: f64 = self.differences(row, &pose).iter().flatten().map(|one| one * one).sum();
            if best.is_none_or(|(least, _)| sum < least) {
                best = Some((sum, at));
            }
        }
        best.map(|(_, at)| at)
            .ok_or_else(|| Fault::open("the mechanism closes nowhere in the range of its input"))
    }

    fn parameters(&self, point: &[f64]) -> Vec<f64> {
        let mut parameters = self.parameters.clone();
        for (index, value) in self.varied.iter().zip(point) {
            parameters[*index] = *value;
        }
        parameters
    }

    fn inputs(&self, row: usize, point: &[f64]) -> Vec<f64> {
        let given = &self.data.inputs[row];
        let mut inputs: Vec<f64> = given
            .iter()
            .zip(&self.standing)
            .map(|(own, standing)| own.unwrap_or(*standing))
            .collect();
        let free = self.free.iter().position(|free| *free == row);
        if let Some(value) = free.and_then(|free| point.get(self.varied.len() + free)) {
            inputs[self.lead] = *value;
        }
        inputs
    }

    /// The scaled differences of a row from its numbers.
    fn differences(&self, row: usize, pose: &Partial) -> Vec<Option<f64>> {
        let description = self.subject.description();
        let quantities = quantities(description);
        let columns = self.data.columns.iter().zip(&self.data.values[row]).zip(&self.scales);
        columns
            .map(|((column, wanted), scale)| {
                let mut difference = pose.values[*column] - (*wanted)?;
                if quantities[*column].dimension == Dimension::Angle {
                    difference -= TAU * (difference / TAU).round();
                }
                Some(difference / scale)
            })
            .collect()
    }

    /// The pose of each row.
    fn poses(&self, point: &[f64]) -> Vec<Option<Partial>> {
        let parameters = self.parameters(point);
        (0..self.data.values.len())
            .map(|row| {
                self.subject
                    .partial(&parameters, &self.inputs(row, point), &self.assembly)
                    .ok()
            })
            .collect()
    }

    /// The scaled differences of all rows.
    fn scaled(&self, point: &[f64]) -> Vec<f64> {
        let poses = self.poses(point);
        let rows = poses.iter().enumerate().flat_map(|(row, pose)| match pose {
            Some(pose) => self
                .differences(row, pose)
                .into_iter()
                .map(|one| one.unwrap_or(0.0))
                .collect(),
            None => vec![OPEN; self.data.columns.len()],
        });
        rows.collect()
    }

    /// The derivatives of all scaled differences, row by row.
    fn slopes(&self, point: &[f64]) -> Vec<f64> {
        let poses = self.poses(point);
        let (width, columns) = (point.len(), self.data.columns.len());
        let mut slopes = vec![0.0; poses.len() * columns * width];
        for (row, pose) in poses.iter().enumerate() {
            // a row that does not close has a constant deviation
            let Some(pose) = pose else { continue };
            for (place, column) in self.data.columns.iter().enumerate() {
                if self.data.values[row][place].is_none() {
                    continue;
                }
                let line = &mut slopes[(row * columns + place) * width..][..width];
                for (cell, index) in line.iter_mut().zip(&self.varied) {
                    *cell = pose.by[*column][*index] / self.scales[place];
                }
                if let Some(free) = self.free.iter().position(|free| *free == row) {
                    line[self.varied.len() + free] =
                        pose.by[*column][self.parameters.len() + self.lead] / self.scales[place];
                }
            }
        }
        slopes
    }

    /// Rows that do not close with what was found are told by the code of the program.
    fn closes(&self, found: &[f64]) -> Result<(), Fault> {
        let poses = self.poses(found);
        match poses.iter().filter(|pose| pose.is_none()).count() {
            0 => Ok(()),
            open => Err(Fault::open(format!(
                "with what was found, the mechanism does not close in {open} of {} rows",
                poses.len()
            ))),
        }
    }

    /// A search that ended before a minimum is told by the code of the program.
    fn is_settled(&self, found: &[f64]) -> Result<(), Fault> {
        let Some((place, part)) = self.lowering(found) else {
            return Ok(());
        };
        let description = self.subject.description();
        let name = match self.varied.get(place) {
            Some(index) => description.parameters[*index].name,
            None => description.inputs[self.lead].name,
        };
        Err(Fault::open(format!(
            "what was found is no minimum: a change of `{name}` alone takes away {:.2} % of the sum of squares. Fit \
             again from there with the `--set` above, or vary fewer dimensions",
            100.0 * part
        )))
    }

    /// The place whose change alone takes most of the sum of squares away, and the part of it, unless the point is a
    /// minimum.
    fn lowering(&self, point: &[f64]) -> Option<(usize, f64)> {
        let squares = |differences: &[f64]| differences.iter().map(|one| one * one).sum::<f64>();
        let differences = self.scaled(point);
        let sum = squares(&differences);
        if sum <= self.met() {
            return None;
        }
        let slopes = self.slopes(point);
        let lowered = (0..point.len()).filter_map(|place| {
            let (mut along, mut norm) = (0.0, 0.0);
            for (row, difference) in slopes.chunks_exact(point.len()).zip(&differences) {
                along += row[place] * difference;
                norm += row[place] * row[place];
            }
            let mut other = point.to_vec();
            other[place] = (point[place] - along / norm).clamp(self.lower[place], self.upper[place]);
            let change = other[place] - point[place];
            // most places promise nothing, and need no poses
            let promised = -change * (2.0 * along + norm * change) / sum;
            if promised.is_nan() || promised <= LOWERED {
                return None;
            }
            let part = 1.0 - squares(&self.scaled(&other)) / sum;
            (part > LOWERED).then_some((place, part))
        });
        lowered.max_by(|one, other| one.1.total_cmp(&other.1))
    }

    /// The root of the mean square of each column, in its own unit, with the number of its rows that close, if any
    /// does.
    fn deviations(&self, point: &[f64]) -> Vec<Option<(f64, u32)>> {
        let poses = self.poses(point);
        (0..self.data.columns.len())
            .map(|column| {
                let (mut sum, mut count) = (0.0, 0_u32);
                for (row, pose) in poses.iter().enumerate() {
                    let difference = pose.as_ref().and_then(|pose| self.differences(row, pose)[column]);
                    if let Some(difference) = difference {
                        sum += (difference * self.scales[column]).powi(2);
                        count += 1;
                    }
                }
                (count > 0).then(|| ((sum / f64::from(count)).sqrt(), count))
            })
            .collect()
    }

    fn shown(&self, case: &Case, start: &[f64], found: &[f64]) -> String {
        let description = self.subject.description();
        let quantities = quantities(description);
        let units = Units {
            in_degrees: case.in_degrees,
            length: case.length,
        };
        let parameters: Vec<&Quantity<'_>> = self
            .varied
            .iter()
            .map(|index| &description.parameters[*index])
            .collect();
        let column = |values: &[f64]| {
            let texts = parameters
                .iter()
                .zip(values)
                .map(|(one, value)| units.text(one.dimension, 0, *value));
            texts.collect::<Vec<_>>()
        };
        let remarks = self
            .lower
            .iter()
            .zip(&self.upper)
            .zip(found)
            .map(|((low, high), value)| {
                let is_at_bound = (value - low).min(high - value) < 1e-3 * (high - low);
                if is_at_bound {
                    "at its bound".to_owned()
                } else {
                    String::new()
                }
            });
        let mut out = text::table(&[
            Column::words("dimension", parameters.iter().map(|one| one.name.to_owned()).collect()),
            Column::numbers("lowest", column(&self.lower)),
            Column::numbers("start", column(start)),
            Column::numbers("found", column(found)),
            Column::numbers("highest", column(&self.upper)),
            Column::words("", remarks.take(parameters.len()).collect()),
        ]);
        out.push('\n');
        let (before, after) = (self.deviations(start), self.deviations(found));
        for (place, column) in self.data.columns.iter().enumerate() {
            let quantity = quantities[*column];
            let deviation = |of_rows: Option<(f64, u32)>| match of_rows {
                Some((value, rows)) => {
                    let value = units.text(quantity.dimension, 0, value);
                    format!(
                        "by {value} in the mean of {rows} {}",
                        if rows == 1 { "row" } else { "rows" }
                    )
                }
                None => "in no row, since none closes".to_owned(),
            };
            let _ = writeln!(
                out,
                "{}: deviates {}; at the start {}",
                quantity.name,
                deviation(after[place]),
                deviation(before[place])
            );
        }
        let set: Vec<String> = parameters
            .iter()
            .zip(found)
            .map(|(one, value)| match one.dimension {
                Dimension::Angle => format!("--set {}={:?}deg", one.name, value.to_degrees()),
                _ => format!(
                    "--set {}={value:?}{}",
                    one.name,
                    if one.dimension == Dimension::Length {
                        case.length
                    } else {
                        ""
                    }
                ),
            })
            .collect();
        let _ = writeln!(out, "\n{}", set.join(" "));
        out
    }
}

/// The bounds of an input that is sought. Whole turns have no ends: a point beside the seam may lie on either side of
/// it.
fn ends(dimension: Dimension, from: f64, to: f64) -> (f64, f64) {
    if dimension == Dimension::Angle && (to - from).abs() > TAU - 1e-9 {
        (f64::NEG_INFINITY, f64::INFINITY)
    } else {
        (from.min(to), from.max(to))
    }
}

/// The dimensions of these names; the name of a point stands for its coordinates.
fn varied(description: &Description<'_>, names: &[String]) -> Result<Vec<usize>, Fault> {
    let all = description.parameters.iter().enumerate();
    if names.is_empty() {
        return Ok(all.map(|(index, _)| index).collect());
    }
    let mut varied = Vec::new();
    for name in names {
        let point = format!("{name}.");
        let own = all
            .clone()
            .filter(|(_, quantity)| quantity.name == name || quantity.name.starts_with(&point));
        let before = varied.len();
        varied.extend(own.map(|(index, _)| index));
        if varied.len() == before {
            let names = description.parameters.iter().map(|quantity| quantity.name);
            return Err(Fault::wrong(format!(
                "there is no dimension `{name}`; {}",
                similar(name, names)
            )));
        }
    }
    varied.sort_unstable();
    varied.dedup();
    Ok(varied)
}

/// The spread of the lengths together, since the coordinates of a point count alike; one radian and one for the others.
fn scales(description: &Description<'_>, data: &Data) -> Vec<f64> {
    let quantities = quantities(description);
    let spread = |column: usize| {
        let values = || data.values.iter().filter_map(move |row| row[column]);
        let (low, high) = values().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
            (low.min(value), high.max(value))
        });
        high - low
    };
    let is_length = |column: usize| quantities[data.columns[column]].dimension == Dimension::Length;
    let lengths = (0..data.columns.len()).filter(|column| is_length(*column)).map(spread);
    let of_lengths = lengths.fold(0.0, f64::max);
    let of_lengths = if of_lengths > 0.0 { of_lengths } else { 1.0 };
    (0..data.columns.len())
        .map(|column| if is_length(column) { of_lengths } else { 1.0 })
        .collect()
}

impl Constraints for Problem<'_> {
    type Set = ConstraintSet<BoxBounds<Vec<f64>>>;

    fn constraints(&self) -> <Self::Set as ConstraintDescription>::Borrowed<'_> {
        ConstraintSet::new().with_bounds(BoxBounds::new(Some(&self.lower), Some(&self.upper)))
    }
}

impl Residual for Problem<'_> {
    type Param = Vec<f64>;
    type Output = Vec<f64>;
    type Error = Infallible;

    fn residual(&self, point: &Vec<f64>) -> Result<Vec<f64>, Infallible> {
        Ok(self.scaled(point))
    }
}

impl Jacobian for Problem<'_> {
    type Jacobian = DenseMatrix<f64>;

    fn jacobian(&self, point: &Vec<f64>) -> Result<DenseMatrix<f64>, Infallible> {
        let rows = self.data.values.len() * self.data.columns.len();
        Ok(DenseMatrix::from_row_slice(rows, point.len(), &self.slopes(point)))
    }
}

#[cfg(test)]
mod tests {
    use clap::{Args as _, Command, FromArgMatches as _};
    use kin_core::library::HoekenLinkage;

    use super::super::super::case::Typed;
    use super::super::super::subject::Subject;
    use super::*;

    /// Wherever a search ends, a point that is no minimum is told.
    #[test]
    fn what_is_no_minimum_is_told() {
        let subject = Subject::of::<HoekenLinkage>();
        let command = Fit::augment_args(Command::new("fit"));
        let options = Fit::from_arg_matches(&command.get_matches_from(["fit", "--data", "path.csv"])).unwrap();
        let set = ["ground=2", "crank=1", "coupler=2.5"].map(str::to_owned).to_vec();
        let case = Typed {
            set,
            ..Typed::default()
        }
        .case(&subject)
        .unwrap();
        let right = [2.1, 0.95, 2.4, -0.1, 1.0, 2.0, 3.0, 4.0, 5.0];
        let rows = right[3..].iter().map(|input| {
            let pose = subject.partial(&right[..3], &[*input], &case.assembly).unwrap();
            [2, 3].map(|output| Some(pose.values[output])).to_vec()
        });
        let data = Data {
            columns: vec![2, 3],
            inputs: vec![vec![None]; right.len() - 3],
            values: rows.collect(),
        };
        let problem = Problem::new(&subject, &options, &case, data, &mut Lengths::default()).unwrap();
        problem.is_settled(&right).unwrap();
        for place in 0..right.len() {
            let mut off = right;
            off[place] += 1e-3;
            let fault = problem.is_settled(&off).unwrap_err().to_string();
            assert!(fault.contains("is no minimum: a change of `"), "{fault}");
        }
        assert!(problem.is_settled(&problem.start).is_err());
    }
}
