//! A candidate, and the design that it becomes: a value for everything that an objective seeks.

use std::f64::consts::{PI, TAU};

use kin_core::{Dimension, Mechanism};

use super::rows::{mechanism, share};
use super::{Adjustable, Goal, Objective, ObjectiveError, PART_NAMES, PARTS, Part, Timing, Travel};

/// The places at which the phase and the turned angle of a placement are tried, if a candidate does not give them.
const TRIES: usize = 36;

/// The error of a target at which the mechanism does not close, in spreads of the targets.
const OPEN: f64 = 10.0;

/// A mechanism to begin with, as a search finds it.
#[derive(Clone, Debug)]
pub struct Candidate<M: Mechanism<Scalar = f64>> {
    /// What names it in the results, such as its number in a search.
    pub id: u64,
    /// Its dimensions.
    pub mechanism: M,
    /// Its assembly.
    pub assembly: M::Assembly,
    /// Where it stands: x, y and the turned angle. Without it, the best place between the bounds is taken.
    pub placement: Option<[f64; 3]>,
    /// The number that is added to given inputs. Without it, the best one of 36 between the bounds is taken.
    pub phase: Option<f64>,
    /// The inputs of the targets, where they are sought. Without them, the best ones in order are taken.
    pub inputs: Option<Vec<f64>>,
}

impl<M: Mechanism<Scalar = f64>> Candidate<M> {
    /// A candidate of which only the dimensions and the assembly are known.
    #[must_use]
    pub fn new(mechanism: M, assembly: M::Assembly) -> Self {
        Self {
            id: 0,
            mechanism,
            assembly,
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
#[derive(Clone, Debug, PartialEq)]
pub struct Design<M: Mechanism<Scalar = f64>> {
    /// The parameters, then the parts, then the inputs that are sought.
    pub(crate) values: Vec<f64>,
    pub(crate) assembly: M::Assembly,
}

/// How far a design is from its targets, without weights.
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

impl<M: Mechanism<Scalar = f64>> Design<M> {
    /// The mechanism.
    #[must_use]
    pub fn mechanism(&self) -> M {
        mechanism(&self.values)
    }

    /// The assembly.
    #[must_use]
    pub fn assembly(&self) -> M::Assembly {
        self.assembly
    }

    /// The origin of the mechanism's frame in the plane of the targets, and the angle by which it is turned.
    #[must_use]
    pub fn placement(&self) -> [f64; 3] {
        [Part::X, Part::Y, Part::Turn].map(|part| self.part(part))
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
        self.values[Objective::<M>::place(part)]
    }

    /// The parameters by their names, then the parts of the placement, of the inputs and of the function.
    pub fn named(&self) -> impl Iterator<Item = (&'static str, f64)> {
        let parameters = M::DESCRIPTION.parameters.iter().map(|quantity| quantity.name);
        parameters.chain(PART_NAMES).zip(self.values.iter().copied())
    }
}

impl<M: Mechanism<Scalar = f64>> Objective<M> {
    /// The design with which a candidate begins. Numbers that it does not give are chosen, and all are moved between
    /// their bounds.
    ///
    /// # Errors
    /// [`ObjectiveError`], if a number of the candidate is not finite, if it has another number of inputs than there
    /// are targets, or if a full turn of a length is wanted.
    pub fn design(&self, candidate: &Candidate<M>) -> Result<Design<M>, ObjectiveError> {
        let input = M::DESCRIPTION.inputs[self.moving];
        let turns = self.travel == Travel::Turn || matches!(self.timing, Timing::Free { is_turn: true, .. });
        if turns && input.dimension != Dimension::Angle {
            return Err(ObjectiveError::WrongDimension {
                name: input.name.to_owned(),
                wanted: "angle, and has no full turn",
            });
        }
        let parameters = candidate.mechanism.parameters();
        let mut values = parameters.as_ref().to_vec();
        for (quantity, value) in M::DESCRIPTION.parameters.iter().zip(&values) {
            Adjustable::Fixed(*value).checked(quantity.name)?;
        }
        values.extend(self.parts.iter().map(|part| part.middle()));
        if let Timing::Free { range, .. } = self.timing {
            values.resize(values.len() + self.targets.len(), range[0]);
        }
        let given = [Part::X, Part::Y, Part::Turn]
            .into_iter()
            .zip(candidate.placement.into_iter().flatten());
        for (part, value) in given.chain(candidate.phase.map(|phase| (Part::Phase, phase))) {
            Adjustable::Fixed(value).checked(PART_NAMES[part as usize])?;
            values[Self::place(part)] = value;
        }
        self.clamp(&mut values);
        let mut design = Design {
            values,
            assembly: candidate.assembly,
        };
        self.begin(&mut design, candidate);
        if let (Some(inputs), Some(first)) = (&candidate.inputs, self.input_place(0)) {
            self.same_count("inputs", inputs.len())?;
            let range = match self.timing {
                Timing::Free {
                    range: [low, high],
                    is_turn: false,
                } => low..=high,
                _ => f64::NEG_INFINITY..=f64::INFINITY,
            };
            for (value, input) in design.values[first..].iter_mut().zip(inputs) {
                Adjustable::Fixed(*input).checked("input")?;
                *value = input.clamp(*range.start(), *range.end());
            }
        }
        Ok(design)
    }

    /// Moves every value between its bounds.
    fn clamp(&self, values: &mut [f64]) {
        for (place, [low, high]) in self.sought() {
            values[place] = values[place].clamp(low, high);
        }
    }

    /// The places of the values that are sought, without the inputs of the targets, with their bounds.
    pub(crate) fn sought(&self) -> Vec<(usize, [f64; 2])> {
        let parameters = self.parameters.iter().enumerate();
        let parts = self.parts.iter().zip(self.parameters.len()..).take(PARTS);
        let parameters = parameters.filter_map(|(place, bounds)| Some((place, (*bounds)?)));
        parameters
            .chain(parts.filter_map(|(part, place)| match part {
                Adjustable::Free(bounds) => Some((place, *bounds)),
                Adjustable::Fixed(_) => None,
            }))
            .collect()
    }

    /// The places of all values that are sought, with their bounds. An input on a turn may move half a turn from its
    /// place.
    pub(crate) fn sought_with_inputs(&self, values: &[f64]) -> Vec<(usize, [f64; 2])> {
        let mut sought = self.sought();
        if let (Timing::Free { range, is_turn }, Some(first)) = (&self.timing, self.input_place(0)) {
            let inputs = values.iter().enumerate().skip(first);
            sought
                .extend(inputs.map(|(place, input)| (place, if *is_turn { [input - PI, input + PI] } else { *range })));
        }
        sought
    }

    /// Half of the sum of squares of a design. The inputs of the targets are chosen anew, where they are sought. The
    /// share of the motion at which it does not close is returned if there is no such sum.
    pub(crate) fn cost(&self, design: &mut Design<M>) -> Result<f64, f64> {
        let own = design.mechanism();
        let assembly = design.assembly;
        let mut cost = 0.0;
        if let Some(first) = self.input_place(0) {
            let assigned = self.assign(&own, assembly, &design.values)?;
            design.values[first..].copy_from_slice(&assigned.inputs);
            cost = assigned.cost;
        } else {
            if !self.closes(&own, assembly) {
                return Err(1.0);
            }
            let targets = self.targets.len();
            let mut open = 0;
            for target in 0..targets {
                let mut add = |row: f64| cost += 0.5 * row * row;
                let found = self.target_rows(&own, assembly, &design.values, target, &mut add);
                open += usize::from(found.is_err());
            }
            if open > 0 {
                return Err(share(open, targets));
            }
        }
        let mut add = |row: f64| cost += 0.5 * row * row;
        let terms = self.term_rows(&own, assembly, &design.values, &mut add);
        // the places of the terms lie between the targets
        terms.map_err(|_| 0.0)?;
        if cost.is_finite() { Ok(cost) } else { Err(1.0) }
    }

    /// How far the targets are spread: a length for paths and motions.
    pub(crate) fn spread(&self) -> f64 {
        let count = share(self.targets.len(), 1);
        let quantities = self.traced.len().min(2);
        let squares = (0..quantities).map(|quantity| {
            let values = || self.targets.iter().map(|target| target[quantity]);
            let mean = values().sum::<f64>() / count;
            values().map(|value| (value - mean).powi(2)).sum::<f64>() / count
        });
        let spread = squares.sum::<f64>().sqrt();
        if spread > 0.0 { spread } else { 1.0 }
    }

    /// Chooses what a candidate does not give.
    fn begin(&self, design: &mut Design<M>, candidate: &Candidate<M>) {
        let is_sought = |part: Part| matches!(self.parts[part as usize], Adjustable::Free(_));
        let place = |part: Part| Self::place(part);
        let is_placed = self.goal == Goal::Function
            || candidate.placement.is_some()
            || ![Part::X, Part::Y, Part::Turn].into_iter().any(is_sought);
        let phases = match self.parts[Part::Phase as usize] {
            Adjustable::Free(bounds) if candidate.phase.is_none() => tries(bounds),
            _ => vec![design.values[place(Part::Phase)]],
        };
        let turns = match self.parts[Part::Turn as usize] {
            Adjustable::Free(bounds) if !is_placed => tries(bounds),
            _ => vec![design.values[place(Part::Turn)]],
        };
        if is_placed && phases.len() == 1 {
            // only the inputs of the targets are left
            let _ = self.cost(design);
            return;
        }
        let mut best: Option<(f64, Vec<f64>)> = None;
        for phase in phases {
            for &turn in &turns {
                let mut tried = design.clone();
                tried.values[place(Part::Phase)] = phase;
                tried.values[place(Part::Turn)] = turn;
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
    fn centre(&self, design: &mut Design<M>) {
        let own = design.mechanism();
        let inputs: Vec<f64> = match self.timing {
            Timing::Free { range: [low, high], .. } => {
                (0..TRIES).map(|try_| low + (high - low) * share(try_, TRIES)).collect()
            }
            Timing::Prescribed(_) => (0..self.targets.len())
                .map(|target| self.input(&design.values, target))
                .collect(),
        };
        let [x, y] = [Part::X, Part::Y].map(Self::place);
        let mut values = design.values.clone();
        (values[x], values[y]) = (0.0, 0.0);
        let mut sums = [0.0; 2];
        let mut count = 0.0;
        for input in inputs {
            if let Ok([[x, _], [y, _], _]) = self.traced(&own, design.assembly, &values, input) {
                sums = [sums[0] + x, sums[1] + y];
                count += 1.0;
            }
        }
        if count == 0.0 {
            return;
        }
        for (axis, (part, place)) in [(Part::X, x), (Part::Y, y)].into_iter().enumerate() {
            if let Adjustable::Free([low, high]) = self.parts[part as usize] {
                let wanted = self.targets.iter().map(|target| target[axis]).sum::<f64>() / share(self.targets.len(), 1);
                design.values[place] = (wanted - sums[axis] / count).clamp(low, high);
            }
        }
    }

    /// The values that a design reaches at each target, in the frame of the targets: x and y, with the angle in a
    /// motion, or the value of the function. `None` if it does not close at all of them.
    #[must_use]
    pub fn reached(&self, design: &Design<M>) -> Option<Vec<Vec<f64>>> {
        let own = design.mechanism();
        let reached = (0..self.targets.len()).map(|target| {
            let input = self.input(&design.values, target);
            let found = self.traced(&own, design.assembly, &design.values, input).ok()?;
            Some(found.iter().take(self.traced.len()).map(|[value, _]| *value).collect())
        });
        reached.collect()
    }

    /// The inputs of the targets in a design.
    #[must_use]
    pub fn inputs_of(&self, design: &Design<M>) -> Vec<f64> {
        (0..self.targets.len())
            .map(|target| self.input(&design.values, target))
            .collect()
    }

    /// The numbers that are sought in a design: their names, their values and their bounds. The input of a target is
    /// called `input` with the number of the target.
    #[must_use]
    pub fn variables(&self, design: &Design<M>) -> Vec<(String, f64, [f64; 2])> {
        let parameters = M::DESCRIPTION.parameters.iter().map(|quantity| quantity.name);
        let names: Vec<&str> = parameters.chain(PART_NAMES).collect();
        let sought = self.sought_with_inputs(&design.values).into_iter();
        let named = sought.map(|(place, bounds)| {
            let name = names
                .get(place)
                .map_or_else(|| format!("input {}", place - names.len()), |name| (*name).to_owned());
            (name, design.values[place], bounds)
        });
        named.collect()
    }

    /// The design with other values of the numbers that are sought, in the order of [`variables`](Self::variables).
    ///
    /// # Errors
    /// [`ObjectiveError::WrongCount`], or one of them is not finite.
    pub fn with_variables(&self, design: &Design<M>, variables: &[f64]) -> Result<Design<M>, ObjectiveError> {
        let sought = self.sought_with_inputs(&design.values);
        if sought.len() != variables.len() {
            return Err(ObjectiveError::WrongCount {
                list: "variables",
                given: variables.len(),
                wanted: sought.len(),
            });
        }
        let mut design = design.clone();
        for ((place, _), value) in sought.into_iter().zip(variables) {
            Adjustable::Fixed(*value).checked("variable")?;
            design.values[place] = *value;
        }
        Ok(design)
    }

    /// The rows of the sum of squares: the weighted errors of each target, then the terms. `None` if the mechanism does
    /// not close at a target or at a place of a term.
    #[must_use]
    pub fn residuals(&self, design: &Design<M>) -> Option<Vec<f64>> {
        self.rows(&design.values, design.assembly)
    }

    /// The partial derivatives of all [`residuals`](Self::residuals), row by row, by the numbers that are sought, in
    /// the order of [`variables`](Self::variables): exact but for rounding. A term whose margin is kept has the
    /// derivative zero.
    #[must_use]
    pub fn jacobian(&self, design: &Design<M>) -> Option<Vec<f64>> {
        let sought = self.sought_with_inputs(&design.values);
        let places: Vec<usize> = sought.into_iter().map(|(place, _)| place).collect();
        self.derivatives(&design.values, design.assembly, &places)
    }

    /// What an evolution strategy minimises: half of the sum of squares, up to a limit that belongs to errors of ten
    /// times the spread of the targets. Where the inputs of the targets are sought, the design takes the best ones in
    /// order.
    ///
    /// A larger sum is bent down to less than twice the limit, without a change of the order. A design that does not
    /// close has more than twice the limit, and the more the less of the motion closes.
    pub fn penalised_cost(&self, design: &mut Design<M>) -> f64 {
        let weights: f64 = self.weights.iter().map(|weight| weight * weight).sum();
        let limit = weights * (OPEN * self.spread()).powi(2);
        // Weights of zero leave the terms alone.
        let limit = if limit > 0.0 { limit } else { 1.0 };
        match self.cost(design) {
            Ok(cost) if cost <= limit => cost,
            Ok(cost) => limit * (2.0 - limit / cost),
            Err(open) => limit * (2.0 + open),
        }
    }

    /// How far a design is from its targets. `None` if it does not close at all of them.
    #[must_use]
    pub fn misfit(&self, design: &Design<M>) -> Option<Misfit> {
        let own = design.mechanism();
        let mut misfit = Misfit {
            sum_of_squares: 0.0,
            root_mean_square: 0.0,
            largest: 0.0,
            target: 0,
        };
        for target in 0..self.targets.len() {
            let input = self.input(&design.values, target);
            let found = self.traced(&own, design.assembly, &design.values, input).ok()?;
            let errors = found
                .iter()
                .enumerate()
                .take(self.traced.len())
                .map(|(quantity, [value, _])| {
                    let unit = if quantity == 2 { self.radian } else { 1.0 };
                    unit * self.error(&design.values, target, quantity, *value)
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

/// Numbers between two bounds; of bounds a turn apart, only one.
fn tries([low, high]: [f64; 2]) -> Vec<f64> {
    let of = if (high - low - TAU).abs() < 1e-9 {
        TRIES
    } else {
        TRIES - 1
    };
    (0..TRIES).map(|try_| low + (high - low) * share(try_, of)).collect()
}
