//! Dimensions that meet measured rows: points of a path, or values of unknowns and outputs, with the inputs that led to
//! them or without.

use std::error::Error;
use std::f64::consts::{PI, TAU};
use std::fmt;
use std::ops::RangeInclusive;

use kin_core::Dimension;
use kin_core::any::Description;

use crate::design::{Candidate, Design, Sought};
use crate::error::ObjectiveError;
use crate::functions::FitFunctions;
use crate::minimise::{Ending, Squares as _, levenberg_marquardt, trust_region};
use crate::objective::{Goal, InputRange, Objective, Target};
use crate::quantity::Traced;
use crate::rows::share;

/// The number of values of the moving input among which the start of a row without an input is sought.
const TRIALS: usize = 72;
/// The mean deviation, in units of the spread of the data, below which the numbers are met: it consists of roundings.
const MET: f64 = 1e-8;
/// The part of the sum of squares that one change alone takes away where no minimum was reached. Slow ends in long
/// valleys leave less, and steps that were cut leave much more.
const LOWERED: f64 = 1e-4;
/// The steps of each method, and the relative change of the sum of squares of a last step.
const STEPS: u64 = 500;
const SETTLED: f64 = 1e-12;

/// Measured rows.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Measured {
    /// For each column its index among the unknowns and, behind them, the scalar outputs.
    pub columns: Vec<usize>,
    /// For each row all inputs, where they are given.
    pub inputs: Vec<Vec<Option<f64>>>,
    /// For each row the value of each column, where it is given: radians, or the mechanism's unit of length.
    pub values: Vec<Vec<Option<f64>>>,
}

impl Measured {
    /// The number of values that are given.
    #[must_use]
    pub fn count(&self) -> usize {
        self.values.iter().flatten().flatten().count()
    }

    /// The spread of the values of each column, in which its errors are counted. Lengths have one spread together,
    /// since the coordinates of a point count alike. The spread of angles is one radian, that of numbers is one.
    fn scales(&self, traced: &[Traced]) -> Vec<f64> {
        let spread = |column: usize| {
            let values = self.values.iter().filter_map(|row| row[column]);
            let ends = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
                (value.min(low), value.max(high))
            });
            ends.1 - ends.0
        };
        let is_length = |column: &usize| traced[*column].dimension == Dimension::Length;
        let of_lengths = (0..traced.len()).filter(is_length).map(spread).fold(0.0, f64::max);
        let of_lengths = if of_lengths > 0.0 { of_lengths } else { 1.0 };
        let scale = |column: usize| if is_length(&column) { of_lengths } else { 1.0 };
        (0..traced.len()).map(scale).collect()
    }
}

impl Objective {
    /// Measured rows, in no order. `moving` is the index of the input that is sought, in a range, in rows without it. A
    /// range of a full revolution has no ends. Other inputs that a row does not give stand at `standing`, which has a
    /// value for each input.
    ///
    /// # Errors
    /// [`ObjectiveError`], if there is no row, if a number is not finite, or if a list has another length than the
    /// mechanism asks for.
    pub fn measured(
        functions: &'static dyn FitFunctions,
        measured: &Measured,
        moving: usize,
        standing: &[f64],
        range: [f64; 2],
    ) -> Result<Self, ObjectiveError> {
        let description = functions.description();
        let all: Vec<Traced> = Traced::all(description).collect();
        let none = |part| ObjectiveError::NoSuchPart {
            part,
            goal: "the mechanism",
        };
        let lead = description.inputs.get(moving).ok_or(none("input of this number"))?;
        let same = |list: &'static str, given: usize, wanted: usize| {
            if given == wanted {
                Ok(())
            } else {
                Err(ObjectiveError::WrongCount { list, given, wanted })
            }
        };
        let inputs = description.inputs.len();
        same("inputs", standing.len(), inputs)?;
        same("inputs", measured.inputs.len(), measured.values.len())?;
        for (row, values) in measured.inputs.iter().zip(&measured.values) {
            same("inputs", row.len(), inputs)?;
            same("values", values.len(), measured.columns.len())?;
        }
        let known = |column: &usize| all.get(*column).copied();
        let traced: Option<Vec<Traced>> = measured.columns.iter().map(known).collect();
        let mut traced = traced.ok_or(none("quantity of this number"))?;
        let scales = measured.scales(&traced);
        for (traced, scale) in traced.iter_mut().zip(scales) {
            traced.unit = 1.0 / scale;
        }
        let rows = measured.inputs.iter().zip(&measured.values);
        let targets = rows.map(|(inputs, values)| {
            let others = inputs.iter().zip(standing);
            Target {
                values: values.clone(),
                weight: 1.0,
                input: inputs[moving],
                others: Some(others.map(|(given, standing)| given.unwrap_or(*standing)).collect()),
                sought: None,
            }
        });
        let objective = Self::new(functions, Goal::Rows, traced, targets.collect())?;
        let [from, to] = range;
        let is_angle = lead.dimension == Dimension::Angle;
        Ok(Self {
            moving,
            others: standing.to_vec(),
            range: InputRange {
                ends: [from.min(to), from.max(to)],
                is_revolution: is_angle && (to - from).abs() > TAU - 1e-9,
            },
            ..objective
        })
    }
}

/// The usual bounds of a dimension: π about an angle, a quarter to four times a length.
#[must_use]
pub fn usual_bounds(description: &Description<'_>, parameters: &[f64], index: usize) -> RangeInclusive<f64> {
    let (quantity, value) = (&description.parameters[index], parameters[index]);
    let around = |width: f64| value - width..=value + width;
    match quantity.dimension {
        Dimension::Angle => around(PI),
        // a coordinate has a dot in its name
        Dimension::Length if quantity.name.contains('.') || value == 0.0 => {
            let all = description.parameters.iter().zip(parameters);
            let lengths = all.filter(|(quantity, _)| quantity.dimension == Dimension::Length);
            around(4.0 * lengths.fold(0.0_f64, |longest, (_, value)| longest.max(value.abs())))
        }
        Dimension::Length => (value / 4.0).min(value * 4.0)..=(value / 4.0).max(value * 4.0),
        Dimension::Scalar => around(value.abs().max(1.0)),
    }
}

/// The reason why dimensions cannot be fitted.
#[derive(Clone, PartialEq)]
#[non_exhaustive]
pub enum FitError {
    /// The objective or its start cannot be made.
    Objective(ObjectiveError),
    /// The mechanism closes nowhere in the range of its input, so that a row without an input has no start.
    NoStart,
    /// The mechanism closes in no row with the dimensions to start from.
    NothingCloses,
}

impl fmt::Display for FitError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Objective(error) => error.fmt(formatter),
            Self::NoStart => formatter.write_str("the mechanism closes nowhere in the range of its input"),
            Self::NothingCloses => {
                formatter.write_str("the mechanism closes in no row with the dimensions to start from")
            }
        }
    }
}

kin_core::__debug_by_display!(FitError);

impl Error for FitError {}

impl From<ObjectiveError> for FitError {
    fn from(error: ObjectiveError) -> Self {
        Self::Objective(error)
    }
}

/// A fit of dimensions to measured rows.
///
/// ```
/// use kin_core::any::Of;
/// use kin_core::library::FourBar;
/// use kin_core::prelude::*;
/// use kin_fit::{Candidate, Fit, Measured, Objective};
///
/// let right: FourBar = FourBar { r1: 90.0, r2: 30.0, r3: 82.0, r4: 57.0 };
/// let inputs: Vec<f64> = (0..12).map(|step| 0.5 * f64::from(step)).collect();
/// let rockers = inputs.iter().map(|input| Ok(right.position(*input, Assembly::Open)?.theta4.value()));
/// let rockers: Vec<f64> = rockers.collect::<Result<_, SolveError>>()?;
/// let rows = Measured {
///     columns: vec![1],
///     inputs: inputs.iter().map(|input| vec![Some(*input)]).collect(),
///     values: rockers.iter().map(|rocker| vec![Some(*rocker)]).collect(),
/// };
/// let objective = Objective::measured(Of::<FourBar>::FUNCTIONS, &rows, 0, &[0.0], [0.0, 6.2])?
///     .bounds("r3", 40.0..=100.0)?
///     .bounds("r4", 40.0..=100.0)?;
/// let start: FourBar = FourBar { r3: 80.0, r4: 60.0, ..right };
/// let fitted = Fit::new(objective, &Candidate::new(&start, Assembly::Open))?.least();
/// assert!((fitted.design.parameters()[3] - 57.0).abs() < 1e-6 && fitted.lowering.is_none());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Fit {
    objective: Objective,
    start: Design,
}

/// The result of a fit.
#[derive(Clone, Debug)]
pub struct Fitted {
    /// The dimensions.
    pub design: Design,
    /// `None` at a minimum; otherwise the name of a number, and the part of the sum of squares that a change of this
    /// number alone takes away.
    pub lowering: Option<(String, f64)>,
}

/// The deviation of a column from its values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Deviation {
    /// The root of the mean square, in the unit of the column.
    pub root_mean_square: f64,
    /// The number of values of the mean: those that are given, in rows that close.
    pub count: usize,
}

impl Fit {
    /// A fit from a start. The input of a row that gives none begins where the position is nearest to the row's values.
    ///
    /// # Errors
    /// [`FitError`].
    pub fn new(objective: Objective, start: &Candidate) -> Result<Self, FitError> {
        if objective.sought().is_empty() {
            return Err(ObjectiveError::NothingToSeek.into());
        }
        let start = objective.design(start)?;
        let mut fit = Self { objective, start };
        for target in 0..fit.objective.targets.len() {
            if let Some(index) = fit.objective.input_index(target) {
                fit.start.values[index] = fit.nearest(target).ok_or(FitError::NoStart)?;
            }
        }
        if fit.unclosed_rows(&fit.start) == fit.objective.targets.len() {
            return Err(FitError::NothingCloses);
        }
        Ok(fit)
    }

    /// The dimensions to start from, moved between their bounds.
    #[must_use]
    pub fn start(&self) -> &Design {
        &self.start
    }

    /// The numbers that are sought, in the order of [`Objective::variables`]: the dimensions first, then the inputs.
    #[must_use]
    pub fn variables(&self, design: &Design) -> Vec<(String, f64, [f64; 2])> {
        self.objective.variables(design)
    }

    /// The value of the moving input at which the position is nearest to the values of a row.
    fn nearest(&self, target: usize) -> Option<f64> {
        let [from, to] = self.objective.range.ends;
        let mut values = self.start.values.clone();
        let index = self.objective.input_index(target)?;
        let mut best: Option<(f64, f64)> = None;
        for step in 0..=TRIALS {
            values[index] = from + (to - from) * share(step, TRIALS);
            let posed = self.objective.posed(&values, &self.start.choice);
            let Some(errors) = self.objective.errors(&posed, target) else {
                continue;
            };
            let sum = errors.iter().map(|error| error.value * error.value).sum();
            if best.is_none_or(|(least, _)| sum < least) {
                best = Some((sum, values[index]));
            }
        }
        best.map(|(_, at)| at)
    }

    /// The nearest minimum, or the design at which the search for it ended.
    ///
    /// A bounded Levenberg-Marquardt method comes first. Where it does not end in a minimum, a reflective trust region
    /// goes on, whose steps take much longer for many rows.
    #[must_use]
    pub fn least(&self) -> Fitted {
        let sought = Sought::all(&self.objective, &self.start);
        let ending = Ending {
            steps: STEPS,
            change: SETTLED,
            cost: 0.5 * self.met(),
        };
        let (mut found, _) = levenberg_marquardt(&sought, &sought.numbers(), ending);
        if self.lowering(&sought, &found).is_some() {
            (found, _) = trust_region(&sought, &found, ending);
        }
        Fitted {
            lowering: self.lowering(&sought, &found),
            design: sought.at(&found),
        }
    }

    /// The sum of squares below which the numbers are met.
    fn met(&self) -> f64 {
        let given = self.objective.targets.iter().flat_map(|target| &target.values);
        MET * MET * share(given.flatten().count(), 1)
    }

    /// The number whose change alone lowers the sum of squares most, and the part by which the sum falls; `None` at a
    /// minimum.
    fn lowering(&self, sought: &Sought<'_>, point: &[f64]) -> Option<(String, f64)> {
        let rows = sought.rows(point);
        let sum = 2.0 * sought.cost(point);
        if sum <= self.met() {
            return None;
        }
        let derivatives = sought.derivatives(point);
        let lowered = sought.bounds().iter().enumerate().filter_map(|(index, [low, high])| {
            let (mut along, mut norm) = (0.0, 0.0);
            for (derivatives, row) in derivatives.chunks_exact(point.len()).zip(&rows) {
                along += derivatives[index] * row;
                norm += derivatives[index] * derivatives[index];
            }
            let mut other = point.to_vec();
            other[index] = (point[index] - along / norm).clamp(*low, *high);
            let change = other[index] - point[index];
            // most numbers promise nothing, and need no poses
            let promised = -change * (2.0 * along + norm * change) / sum;
            if promised.is_nan() || promised <= LOWERED {
                return None;
            }
            let part = 1.0 - 2.0 * sought.cost(&other) / sum;
            (part > LOWERED).then_some((index, part))
        });
        let (index, part) = lowered.max_by(|one, other| one.1.total_cmp(&other.1))?;
        let inputs = self.objective.description().inputs;
        let variables = self.objective.variables(&self.start).into_iter();
        let name = variables
            .map(|(name, ..)| name)
            .nth(index)
            .filter(|_| index < self.objective.sought().len());
        Some((
            name.unwrap_or_else(|| inputs[self.objective.moving].name.to_owned()),
            part,
        ))
    }

    /// The number of rows in which a design does not close.
    #[must_use]
    pub fn unclosed_rows(&self, design: &Design) -> usize {
        let posed = self.objective.posed(&design.values, &design.choice);
        let targets = 0..self.objective.targets.len();
        let unclosed = targets.filter(|target| self.objective.errors(&posed, *target).is_none());
        unclosed.count()
    }

    /// The deviation of each column from its values; `None` if no row with a value closes.
    #[must_use]
    pub fn deviations(&self, design: &Design) -> Vec<Option<Deviation>> {
        let objective = &self.objective;
        let posed = objective.posed(&design.values, &design.choice);
        let mut sums = vec![(0.0, 0); objective.traced.len()];
        for (target, row) in objective.targets.iter().enumerate() {
            let Some(errors) = objective.errors(&posed, target) else {
                continue;
            };
            let given = errors.iter().zip(&row.values).zip(&objective.traced);
            for (((error, _), traced), (sum, count)) in
                given.zip(&mut sums).filter(|(((_, value), _), _)| value.is_some())
            {
                *sum += (error.value / traced.unit).powi(2);
                *count += 1;
            }
        }
        let deviation = |(sum, count): (f64, usize)| {
            (count > 0).then(|| Deviation {
                root_mean_square: (sum / share(count, 1)).sqrt(),
                count,
            })
        };
        sums.into_iter().map(deviation).collect()
    }
}

#[cfg(test)]
mod tests {
    use kin_core::Assembly;
    use kin_core::any::Of;
    use kin_core::library::HoekenLinkage;

    use super::*;

    /// A search that ends at a point which is no minimum reports so.
    #[test]
    fn points_that_are_no_minimum() {
        let right: HoekenLinkage = HoekenLinkage {
            ground: 2.1,
            crank: 0.95,
            coupler: 2.4,
        };
        let inputs: Vec<f64> = (-1..=5)
            .filter(|input| *input != 0)
            .map(|input| 0.1 + f64::from(input))
            .collect();
        let rows = inputs.iter().map(|input| {
            let tracer = right
                .position(*input, Assembly::Open)
                .expect("it closes")
                .tracer
                .value();
            vec![Some(tracer.x), Some(tracer.y)]
        });
        let data = Measured {
            columns: vec![2, 3],
            inputs: vec![vec![None]; inputs.len()],
            values: rows.collect(),
        };
        let functions = Of::<HoekenLinkage>::FUNCTIONS;
        let mut objective = Objective::measured(functions, &data, 0, &[0.0], [0.0, TAU]).expect("good rows");
        for name in ["ground", "crank", "coupler"] {
            objective = objective.bounds(name, 0.5..=8.0).expect("a dimension");
        }
        let start: HoekenLinkage = HoekenLinkage {
            ground: 2.0,
            crank: 1.0,
            coupler: 2.5,
        };
        let fit = Fit::new(objective, &Candidate::new(&start, Assembly::Open)).expect("it closes");
        let sought = Sought::all(&fit.objective, &fit.start);
        let right: Vec<f64> = [2.1, 0.95, 2.4].into_iter().chain(inputs).collect();
        assert_eq!(fit.lowering(&sought, &right), None);
        for index in 0..right.len() {
            let mut off = right.clone();
            off[index] += 1e-3;
            let (name, part) = fit.lowering(&sought, &off).expect("no minimum");
            assert!(!name.is_empty() && part > LOWERED, "{name}: {part}");
        }
        assert!(fit.lowering(&sought, &sought.numbers()).is_some());

        // some rows give their input, and mistakes are errors
        let mut mixed = data.clone();
        mixed.inputs[1] = vec![Some(right[4])];
        let objective = |data: &Measured| Objective::measured(functions, data, 0, &[0.0], [0.0, TAU]);
        let fit = |data: &Measured, choice: usize| {
            let start = Candidate::with_parameters(vec![2.0, 1.0, 2.5], crate::Choice::Assembly(choice));
            Fit::new(objective(data)?.bounds("crank", 0.5..=2.0)?, &start)
        };
        assert_eq!(
            fit(&mixed, 0).expect("it closes").least().design.values.len(),
            3 + 7 + 5
        );
        assert!(matches!(
            fit(&mixed, 2),
            Err(FitError::Objective(ObjectiveError::NoSuchPart { .. }))
        ));
        mixed.columns[0] = 9;
        assert!(matches!(objective(&mixed), Err(ObjectiveError::NoSuchPart { .. })));
        mixed.values[0].pop();
        assert!(matches!(objective(&mixed), Err(ObjectiveError::WrongCount { .. })));
        assert!(crate::polish(&objective(&data).expect("good rows"), &[], &crate::Settings::default()).is_err());
    }
}
