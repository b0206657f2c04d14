//! A candidate, and the design that it becomes: a value for everything that an objective seeks.

use std::f64::consts::{PI, TAU};

use kin_core::{Dimension, Mechanism, Number as _, Row};

use crate::adjustable::Adjustable;
use crate::error::ObjectiveError;
use crate::functions::{Change, Choice, FitFunctions};
use crate::minimise::{self, Squares};
use crate::objective::{Goal, Objective, PART_NAMES, PARTS, Part};
use crate::rows::{UNCLOSED, share};
use crate::term::Travel;

/// The number of phases, and of angles of a placement, that are tried if a candidate does not give them.
const TRIES: usize = 36;

/// A mechanism to begin with, as a search finds it.
#[derive(Clone, Debug, PartialEq)]
pub struct Candidate {
    /// Its number in the results, such as its id in a search.
    pub id: u64,
    /// Its scalar parameters, in the order of the declaration.
    pub parameters: Vec<f64>,
    /// Its assembly.
    pub choice: Choice,
    /// The placement: x, y and the angle of rotation. Without it, the best placement between the bounds is taken.
    pub placement: Option<[f64; 3]>,
    /// The number that is added to given inputs. Without it, the best of 36 numbers between the bounds is taken.
    pub phase: Option<f64>,
    /// The inputs of the targets, where they are sought. Without them, the best inputs in order are taken.
    pub inputs: Option<Vec<f64>>,
}

impl Candidate {
    /// A candidate of which only the dimensions and the assembly are known. Values nearby, which stand for the assembly
    /// of coupled blocks, are those at inputs of zero.
    #[must_use]
    pub fn new<M: Mechanism<Scalar = f64>>(mechanism: &M, assembly: M::Assembly) -> Self {
        let inputs: M::Inputs<f64> = Row::splat(0.0);
        Self::with_parameters(
            mechanism.parameters().as_ref().to_vec(),
            Choice::of::<M>(assembly, inputs.as_ref()),
        )
    }

    /// A candidate by its scalar parameters, in the order of the declaration.
    #[must_use]
    pub fn with_parameters(parameters: Vec<f64>, choice: Choice) -> Self {
        Self {
            id: 0,
            parameters,
            choice,
            placement: None,
            phase: None,
            inputs: None,
        }
    }

    /// The same candidate with a number.
    #[must_use]
    pub fn numbered(self, id: u64) -> Self {
        Self { id, ..self }
    }
}

/// A value for everything that an objective seeks, and an assembly.
#[derive(Clone, Debug)]
pub struct Design {
    pub(crate) functions: &'static dyn FitFunctions,
    /// The parameters, then the parts, then the inputs that are sought.
    pub(crate) values: Vec<f64>,
    pub(crate) choice: Choice,
}

/// The errors of a design at its targets, without weights.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Misfit {
    /// The sum of the squares of all errors: of distances in a path, of distances and of angles times the length
    /// `radian` in a motion, of the values of a function.
    pub sum_of_squares: f64,
    /// The root of the mean square over the targets.
    pub root_mean_square: f64,
    /// The largest error of a target.
    pub largest: f64,
    /// The target with the largest error, from zero on.
    pub target: usize,
}

impl Design {
    /// The scalar parameters, in the order of the declaration.
    #[must_use]
    pub fn parameters(&self) -> &[f64] {
        &self.values[..self.functions.description().parameters.len()]
    }

    /// The mechanism in its own type, which must be that of the objective.
    #[must_use]
    pub fn mechanism<M: Mechanism<Scalar = f64>>(&self) -> M {
        M::from_parameters(Row::from_fn(|index| self.values[index]))
    }

    /// The choice among the positions.
    #[must_use]
    pub fn choice(&self) -> &Choice {
        &self.choice
    }

    /// The origin of the mechanism's frame in the plane of the targets, and the angle by which it is turned.
    #[must_use]
    pub fn placement(&self) -> [f64; 3] {
        [Part::X, Part::Y, Part::Rotation].map(|part| self.part(part))
    }

    /// The phase and the pace of the inputs.
    #[must_use]
    pub fn input_line(&self) -> [f64; 2] {
        [Part::Phase, Part::Pace].map(|part| self.part(part))
    }

    /// The offset and the scale of the values of a function.
    #[must_use]
    pub fn value_line(&self) -> [f64; 2] {
        [Part::Offset, Part::Scale].map(|part| self.part(part))
    }

    fn part(&self, part: Part) -> f64 {
        self.values[self.parameters().len() + part as usize]
    }

    /// The parameters by their names, then the parts of the placement, of the inputs and of the function.
    pub fn named(&self) -> impl Iterator<Item = (&'static str, f64)> {
        let parameters = self.functions.description().parameters.iter();
        let names = parameters.map(|quantity| quantity.name).chain(PART_NAMES);
        names.zip(self.values.iter().copied())
    }
}

impl Objective {
    /// The design with which a candidate begins. Numbers that it does not give are chosen, and all are moved between
    /// their bounds.
    ///
    /// # Errors
    /// [`ObjectiveError`], if a number of the candidate is not finite, if it has another number of inputs than there
    /// are targets, or if a full revolution of a length is wanted.
    pub fn design(&self, candidate: &Candidate) -> Result<Design, ObjectiveError> {
        let input = self.description().inputs[self.moving];
        let is_revolving = self.travel == Travel::Revolution || self.has_free_inputs() && self.range.is_revolution;
        if is_revolving && input.dimension != Dimension::Angle {
            return Err(ObjectiveError::WrongDimension {
                name: input.name.to_owned(),
                wanted: "angle, and has no full revolution",
            });
        }
        let mut values = candidate.parameters.clone();
        if values.len() != self.parameters.len() {
            return Err(ObjectiveError::WrongCount {
                list: "parameters",
                given: values.len(),
                wanted: self.parameters.len(),
            });
        }
        self.check(&candidate.choice)?;
        for (quantity, value) in self.description().parameters.iter().zip(&values) {
            Adjustable::Fixed(*value).checked(quantity.name)?;
        }
        values.extend(self.parts.iter().map(|part| part.middle()));
        let sought = self.targets.iter().filter(|target| target.sought.is_some());
        values.resize(values.len() + sought.count(), self.range.ends[0]);
        let given = [Part::X, Part::Y, Part::Rotation]
            .into_iter()
            .zip(candidate.placement.into_iter().flatten());
        for (part, value) in given.chain(candidate.phase.map(|phase| (Part::Phase, phase))) {
            Adjustable::Fixed(value).checked(PART_NAMES[part as usize])?;
            values[self.part_index(part)] = value;
        }
        self.clamp(&mut values);
        let mut design = Design {
            functions: self.functions,
            values,
            choice: candidate.choice.clone(),
        };
        if self.goal == Goal::Rows {
            // a fit finds their inputs
            return Ok(design);
        }
        self.begin(&mut design, candidate);
        if let (Some(inputs), Some(first)) = (&candidate.inputs, self.input_index(0)) {
            self.same_count("inputs", inputs.len())?;
            let [low, high] = if self.range.is_revolution {
                [f64::NEG_INFINITY, f64::INFINITY]
            } else {
                self.range.ends
            };
            for (value, input) in design.values[first..].iter_mut().zip(inputs) {
                Adjustable::Fixed(*input).checked("input")?;
                *value = input.clamp(low, high);
            }
        }
        Ok(design)
    }

    fn check(&self, choice: &Choice) -> Result<(), ObjectiveError> {
        let same = |list, given: usize, wanted: usize| {
            let wrong = ObjectiveError::WrongCount { list, given, wanted };
            if given == wanted { Ok(()) } else { Err(wrong) }
        };
        match choice {
            Choice::Assembly(index) if *index < self.functions.assembly_count() => Ok(()),
            Choice::Assembly(_) => Err(ObjectiveError::NoSuchPart {
                part: "assembly of this number",
                goal: "the mechanism",
            }),
            Choice::From { inputs, near } => {
                same("inputs", inputs.len(), self.others.len())?;
                same("unknowns", near.len(), self.description().unknowns.len())
            }
        }
    }

    /// Moves every value between its bounds.
    fn clamp(&self, values: &mut [f64]) {
        for (index, [low, high]) in self.sought() {
            values[index] = values[index].clamp(low, high);
        }
    }

    /// The indices of the values that are sought, without the inputs of the targets, with their bounds.
    pub(crate) fn sought(&self) -> Vec<(usize, [f64; 2])> {
        let parameters = self.parameters.iter().enumerate();
        let parts = self.parts.iter().zip(self.parameters.len()..).take(PARTS);
        let parameters = parameters.filter_map(|(index, bounds)| Some((index, (*bounds)?)));
        parameters
            .chain(parts.filter_map(|(part, index)| match part {
                Adjustable::Free(bounds) => Some((index, *bounds)),
                Adjustable::Fixed(_) => None,
            }))
            .collect()
    }

    /// The indices of all values that are sought, with their bounds. An input on a revolution may move half a
    /// revolution from its value.
    pub(crate) fn sought_with_inputs(&self, values: &[f64]) -> Vec<(usize, [f64; 2])> {
        let inputs = values.iter().enumerate().skip(self.first_input());
        let bounds = |input: f64| {
            if self.range.is_revolution {
                [input - PI, input + PI]
            } else {
                self.range.ends
            }
        };
        let mut sought = self.sought();
        sought.extend(inputs.map(|(index, input)| (index, bounds(*input))));
        sought
    }

    /// Half of the sum of squares of a design. The inputs of the targets are chosen anew, where they are sought. The
    /// share of the motion at which it does not close is returned if there is no such sum.
    pub(crate) fn cost(&self, design: &mut Design) -> Result<f64, f64> {
        let mut cost = 0.0;
        if self.goal != Goal::Rows
            && let Some(first) = self.input_index(0)
        {
            let assigned = self.assign(&design.values, &design.choice)?;
            design.values[first..].copy_from_slice(&assigned.inputs);
            cost = assigned.cost;
        } else {
            if !self.closes(&design.values, &design.choice) {
                return Err(1.0);
            }
            let posed = self.posed(&design.values, &design.choice);
            let targets = self.targets.len();
            let mut unclosed = 0;
            for target in 0..targets {
                match self.errors(&posed, target) {
                    Some(errors) => cost += half_square(&errors),
                    None => unclosed += 1,
                }
            }
            if unclosed > 0 {
                return Err(share(unclosed, targets));
            }
        }
        let posed = self.posed(&design.values, &design.choice);
        for (_, rows) in self.all_term_rows(&posed) {
            // the samples of the terms lie between the targets
            cost += half_square(&rows.ok_or(0.0)?);
        }
        if cost.is_finite() { Ok(cost) } else { Err(1.0) }
    }

    /// The spread of the targets: a length for paths and motions.
    pub(crate) fn spread(&self) -> f64 {
        if self.goal == Goal::Rows {
            // their errors are counted in spreads
            return 1.0;
        }
        let count = share(self.targets.len(), 1);
        let quantities = self.traced.len().min(2);
        let squares = (0..quantities).map(|quantity| {
            let values = || self.targets.iter().filter_map(|target| target.values[quantity]);
            let mean = values().sum::<f64>() / count;
            values().map(|value| (value - mean).powi(2)).sum::<f64>() / count
        });
        let spread = squares.sum::<f64>().sqrt();
        if spread > 0.0 { spread } else { 1.0 }
    }

    /// Chooses what a candidate does not give.
    fn begin(&self, design: &mut Design, candidate: &Candidate) {
        let is_sought = |part: Part| matches!(self.parts[part as usize], Adjustable::Free(_));
        let index = |part: Part| self.part_index(part);
        let is_placed = !self.goal.is_placed()
            || candidate.placement.is_some()
            || ![Part::X, Part::Y, Part::Rotation].into_iter().any(is_sought);
        let phases = match self.parts[Part::Phase as usize] {
            Adjustable::Free(bounds) if candidate.phase.is_none() => tries(bounds),
            _ => vec![design.values[index(Part::Phase)]],
        };
        let angles = match self.parts[Part::Rotation as usize] {
            Adjustable::Free(bounds) if !is_placed => tries(bounds),
            _ => vec![design.values[index(Part::Rotation)]],
        };
        if is_placed && phases.len() == 1 {
            // only the inputs of the targets are left
            let _ = self.cost(design);
            return;
        }
        let mut best: Option<(f64, Vec<f64>)> = None;
        for phase in phases {
            for &angle in &angles {
                let mut tried = design.clone();
                tried.values[index(Part::Phase)] = phase;
                tried.values[index(Part::Rotation)] = angle;
                if !is_placed {
                    self.centre(&mut tried);
                }
                if let Ok(cost) = self.cost(&mut tried)
                    && best.as_ref().is_none_or(|(least, _)| cost < *least)
                {
                    best = Some((cost, tried.values));
                }
            }
        }
        if let Some((_, values)) = best {
            design.values = values;
        }
    }

    /// Places the mechanism so that the centre of its motion lies in the centre of the targets: of the motion at the
    /// targets, or over the whole range if their inputs are sought.
    fn centre(&self, design: &mut Design) {
        let inputs: Vec<f64> = if self.has_free_inputs() {
            let [low, high] = self.range.ends;
            (0..TRIES).map(|try_| low + (high - low) * share(try_, TRIES)).collect()
        } else {
            self.inputs_of(design)
        };
        let [x, y] = [Part::X, Part::Y].map(|part| self.part_index(part));
        let mut values = design.values.clone();
        (values[x], values[y]) = (0.0, 0.0);
        let mut sums = [0.0; 2];
        let mut count = 0.0;
        for input in inputs {
            let posed = self.posed(&values, &design.choice);
            if let Some(found) = self.traced(&posed, 0, Change::constant(input)) {
                sums = [sums[0] + found[0].value, sums[1] + found[1].value];
                count += 1.0;
            }
        }
        if count == 0.0 {
            return;
        }
        for (axis, (part, index)) in [(Part::X, x), (Part::Y, y)].into_iter().enumerate() {
            if let Adjustable::Free([low, high]) = self.parts[part as usize] {
                let wanted = self
                    .targets
                    .iter()
                    .filter_map(|target| target.values[axis])
                    .sum::<f64>();
                let wanted = wanted / share(self.targets.len(), 1);
                design.values[index] = (wanted - sums[axis] / count).clamp(low, high);
            }
        }
    }

    /// The values that a design reaches at each target, in the frame of the targets: x and y, with the angle in a
    /// motion, or the value of the function. `None` if it does not close at all of them.
    #[must_use]
    pub fn reached(&self, design: &Design) -> Option<Vec<Vec<f64>>> {
        let posed = self.posed(&design.values, &design.choice);
        let reached = (0..self.targets.len()).map(|target| {
            let found = self.traced(&posed, target, self.input(&posed, target))?;
            Some(found.iter().map(|value| value.value).collect())
        });
        reached.collect()
    }

    /// The inputs of the targets in a design.
    #[must_use]
    pub fn inputs_of(&self, design: &Design) -> Vec<f64> {
        let posed = self.posed(&design.values, &design.choice);
        let targets = 0..self.targets.len();
        targets.map(|target| self.input(&posed, target).value).collect()
    }

    /// The numbers that are sought in a design: their names, their values and their bounds. The input of a target is
    /// called `input` with the number of the target.
    #[must_use]
    pub fn variables(&self, design: &Design) -> Vec<(String, f64, [f64; 2])> {
        let parameters = self.description().parameters.iter().map(|quantity| quantity.name);
        let names: Vec<&str> = parameters.chain(PART_NAMES).collect();
        let sought = self.sought_with_inputs(&design.values).into_iter();
        let named = sought.map(|(index, bounds)| {
            let name = names
                .get(index)
                .map_or_else(|| format!("input {}", index - names.len()), |name| (*name).to_owned());
            (name, design.values[index], bounds)
        });
        named.collect()
    }

    /// The design with the given values of the numbers that are sought, in the order of [`variables`](Self::variables).
    ///
    /// # Errors
    /// [`ObjectiveError::WrongCount`], or one of them is not finite.
    pub fn with_variables(&self, design: &Design, variables: &[f64]) -> Result<Design, ObjectiveError> {
        let sought = self.sought_with_inputs(&design.values);
        if sought.len() != variables.len() {
            return Err(ObjectiveError::WrongCount {
                list: "variables",
                given: variables.len(),
                wanted: sought.len(),
            });
        }
        let mut design = design.clone();
        for ((index, _), value) in sought.into_iter().zip(variables) {
            Adjustable::Fixed(*value).checked("variable")?;
            design.values[index] = *value;
        }
        Ok(design)
    }

    /// The rows of the sum of squares: the weighted errors of each target, then the terms. `None` if the mechanism does
    /// not close at a target or at a sample of a term.
    #[must_use]
    pub fn residuals(&self, design: &Design) -> Option<Vec<f64>> {
        let (rows, unclosed) = self.rows(&design.values, &design.choice);
        (unclosed == 0).then_some(rows)
    }

    /// The partial derivatives of all [`residuals`](Self::residuals), row by row, by the numbers that are sought, in
    /// the order of [`variables`](Self::variables): exact but for rounding. A term whose margin is kept has the
    /// derivative zero.
    #[must_use]
    pub fn jacobian(&self, design: &Design) -> Option<Vec<f64>> {
        let sought = self.sought_with_inputs(&design.values);
        let indices: Vec<usize> = sought.into_iter().map(|(index, _)| index).collect();
        self.residuals(design)?;
        let derivatives = self.derivatives(&design.values, &design.choice, &indices);
        derivatives.iter().all(|one| one.is_finite()).then_some(derivatives)
    }

    /// The cost for an evolution strategy: half of the sum of squares, [penalised](crate::penalised) beyond the limit
    /// that belongs to errors of a hundred times the spread of the targets. Where the inputs of the targets are sought,
    /// the design takes the best ones in order.
    pub fn penalised_cost(&self, design: &mut Design) -> f64 {
        let weights: f64 = self.targets.iter().map(|target| target.weight * target.weight).sum();
        let limit = weights * (UNCLOSED * self.spread()).powi(2);
        // Weights of zero leave the terms alone.
        let limit = if limit > 0.0 { limit } else { 1.0 };
        penalised(self.cost(design), limit)
    }

    /// The design with the least sum of squares near another one, by the least squares of [`polish`](crate::polish)
    /// alone: no search comes first, and the full cycle is not checked. `steps` limits the steps of both methods; the
    /// second finds the last digits, and each of its steps takes as long as thirty of the first.
    #[must_use]
    pub fn nearest_minimum(&self, design: &Design, steps: [u64; 2]) -> Design {
        let sought = Sought::all(self, design);
        sought.at(&minimise::polish(&sought, &sought.numbers(), steps).0)
    }

    /// The errors of a design at its targets; `None` if the design does not close at all targets.
    #[must_use]
    pub fn misfit(&self, design: &Design) -> Option<Misfit> {
        let posed = self.posed(&design.values, &design.choice);
        let mut misfit = Misfit {
            sum_of_squares: 0.0,
            root_mean_square: 0.0,
            largest: 0.0,
            target: 0,
        };
        for target in 0..self.targets.len() {
            let found = self.traced(&posed, target, self.input(&posed, target))?;
            let errors = found.into_iter().enumerate().map(|(quantity, value)| {
                self.traced[quantity].unit * self.error(&posed, target, quantity, value).value
            });
            let square = errors.map(|error| error * error).sum::<f64>();
            misfit.sum_of_squares += square;
            if square.sqrt() > misfit.largest {
                (misfit.largest, misfit.target) = (square.sqrt(), target);
            }
        }
        misfit.root_mean_square = (misfit.sum_of_squares / share(self.targets.len(), 1)).sqrt();
        Some(misfit)
    }
}

/// A design with its sum of squares as a function of the numbers that are sought.
pub(crate) struct Sought<'o> {
    pub(crate) objective: &'o Objective,
    pub(crate) design: &'o Design,
    indices: Vec<usize>,
    bounds: Vec<[f64; 2]>,
}

impl<'o> Sought<'o> {
    pub(crate) fn new(objective: &'o Objective, design: &'o Design, sought: Vec<(usize, [f64; 2])>) -> Self {
        let (indices, bounds) = sought.into_iter().unzip();
        Self {
            objective,
            design,
            indices,
            bounds,
        }
    }

    /// All numbers that are sought, the inputs of targets among them.
    pub(crate) fn all(objective: &'o Objective, design: &'o Design) -> Self {
        Self::new(objective, design, objective.sought_with_inputs(&design.values))
    }

    /// The numbers of the design itself.
    pub(crate) fn numbers(&self) -> Vec<f64> {
        self.indices.iter().map(|index| self.design.values[*index]).collect()
    }

    /// The design with other numbers.
    pub(crate) fn at(&self, numbers: &[f64]) -> Design {
        let mut design = self.design.clone();
        for (index, number) in self.indices.iter().zip(numbers) {
            design.values[*index] = *number;
        }
        design
    }
}

impl Squares for Sought<'_> {
    fn bounds(&self) -> &[[f64; 2]] {
        &self.bounds
    }

    fn rows(&self, numbers: &[f64]) -> Vec<f64> {
        let design = self.at(numbers);
        self.objective.rows(&design.values, &design.choice).0
    }

    fn derivatives(&self, numbers: &[f64]) -> Vec<f64> {
        let design = self.at(numbers);
        let derivatives = self
            .objective
            .derivatives(&design.values, &design.choice, &self.indices);
        // at a limit position a row gives no direction
        let finite = |derivative: f64| if derivative.is_finite() { derivative } else { 0.0 };
        derivatives.into_iter().map(finite).collect()
    }
}

fn half_square(rows: &[Change]) -> f64 {
    rows.iter().map(|row| 0.5 * row.value * row.value).sum()
}

/// A cost by which designs are compared: from the cost of a design that closes, or from the share of the motion at
/// which a design does not close.
///
/// A cost up to the limit is itself. A larger cost is bent down to less than twice the limit, without a change of the
/// order. A design that does not close has more than twice the limit: the less of its motion closes, the larger its
/// cost.
///
/// ```
/// use kin_fit::penalised;
///
/// assert_eq!(penalised(Ok(0.5), 1.0), 0.5);
/// assert_eq!(penalised(Ok(1e9), 1.0), 2.0 - 1e-9);
/// assert_eq!(penalised(Err(0.25), 1.0), 2.25);
/// ```
#[must_use]
pub fn penalised(cost: Result<f64, f64>, limit: f64) -> f64 {
    match cost {
        Ok(cost) if cost <= limit => cost,
        Ok(cost) => limit * (2.0 - limit / cost),
        Err(unclosed) => limit * (2.0 + unclosed),
    }
}

/// Numbers between two bounds. Bounds a revolution apart are one angle, of which one number is tried.
fn tries([low, high]: [f64; 2]) -> Vec<f64> {
    let of = if (high - low - TAU).abs() < 1e-9 {
        TRIES
    } else {
        TRIES - 1
    };
    (0..TRIES).map(|try_| low + (high - low) * share(try_, of)).collect()
}
