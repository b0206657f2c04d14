//! The rows of the sum of squares, in any number: in plain numbers they are the errors, in numbers that carry a
//! derivative also its derivatives.

use std::f64::consts::{FRAC_PI_2, TAU};

use kin_core::series::Series;
use kin_core::{Dimension, Mechanism, Number, PlaneOrSpace as _, PointArray as _, Row, SolveError};

use super::margins::{driver_turns, grashof};
use super::{Goal, Objective, PARTS, Part, Term, Timing, Travel};

/// A value and its derivative with respect to one of the numbers that are sought.
type Change = Series<2>;

/// The places of the travel at which terms are evaluated.
pub(crate) const PLACES: usize = 24;

#[expect(clippy::cast_precision_loss, reason = "counts are small")]
pub(crate) fn share(part: usize, of: usize) -> f64 {
    part as f64 / of as f64
}

/// The mechanism of a row of values, which begins with its parameters.
pub(crate) fn mechanism<W: Mechanism>(values: &[W::Scalar]) -> W {
    W::from_parameters(Row::from_fn(|index| values[index]))
}

impl<M: Mechanism<Scalar = f64>> Objective<M> {
    /// The place of a part among the values.
    pub(crate) fn place(part: Part) -> usize {
        M::DESCRIPTION.parameters.len() + part as usize
    }

    /// The place of the input of a target among the values, if inputs are sought.
    pub(crate) fn input_place(&self, target: usize) -> Option<usize> {
        match self.timing {
            Timing::Free { .. } => Some(M::DESCRIPTION.parameters.len() + PARTS + target),
            Timing::Prescribed(_) => None,
        }
    }

    /// The input of a target.
    pub(crate) fn input<S: Number>(&self, values: &[S], target: usize) -> S {
        match &self.timing {
            Timing::Free { .. } => values[M::DESCRIPTION.parameters.len() + PARTS + target],
            Timing::Prescribed(inputs) => {
                let [phase, pace] = [Part::Phase, Part::Pace].map(|part| values[Self::place(part)]);
                phase + pace * S::constant(inputs[target])
            }
        }
    }

    /// The inputs as motions, with the rate 1 of the moving one.
    pub(crate) fn motions<W: Mechanism>(&self, input: W::Scalar) -> W::Inputs<W::Motion<W::Scalar>> {
        Row::from_fn(|index| {
            Row::from_fn(|order| match (index == self.moving, order) {
                (true, 0) => input,
                (true, 1) => W::Scalar::constant(1.0),
                (false, 0) => W::Scalar::constant(self.others[index]),
                _ => W::Scalar::constant(0.0),
            })
        })
    }

    /// The values of the inputs.
    pub(crate) fn inputs<W: Mechanism>(&self, input: W::Scalar) -> W::Inputs<W::Scalar> {
        Row::from_fn(|index| {
            if index == self.moving {
                input
            } else {
                W::Scalar::constant(self.others[index])
            }
        })
    }

    /// The traced quantities in the frame of the targets at an input, and their rates by it.
    pub(crate) fn traced<W: Mechanism<Assembly = M::Assembly>>(
        &self,
        mechanism: &W,
        assembly: W::Assembly,
        values: &[W::Scalar],
        input: W::Scalar,
    ) -> Result<[[W::Scalar; 2]; 3], SolveError> {
        let pose = mechanism.solve(self.motions::<W>(input), assembly)?;
        let zero = W::Scalar::constant(0.0);
        let mut found = [[zero; 2]; 3];
        for (found, traced) in found.iter_mut().zip(&self.traced) {
            *found = traced.of(&pose);
        }
        if self.goal == Goal::Function {
            return Ok(found);
        }
        let [x, y, turn] = [Part::X, Part::Y, Part::Turn].map(|part| values[Self::place(part)]);
        let (sine, cosine) = turn.sin_cos();
        let [along, beside, angle] = found;
        let turned = |order: usize| {
            [
                cosine * along[order] - sine * beside[order],
                sine * along[order] + cosine * beside[order],
            ]
        };
        let ([place_x, place_y], [rate_x, rate_y]) = (turned(0), turned(1));
        Ok([
            [x + place_x, rate_x],
            [y + place_y, rate_y],
            [turn + angle[0], angle[1]],
        ])
    }

    /// The number by which the error of a traced quantity is multiplied.
    pub(crate) fn weight(&self, target: usize, quantity: usize) -> f64 {
        let unit = if quantity == 2 { self.radian } else { 1.0 };
        self.weights[target] * unit
    }

    /// The error of a traced quantity, without weight. Angles are compared up to whole turns.
    pub(crate) fn error<S: Number>(&self, values: &[S], target: usize, quantity: usize, value: S) -> S {
        let given = S::constant(self.targets[target][quantity]);
        let wanted = if self.goal == Goal::Function {
            let [offset, scale] = [Part::Offset, Part::Scale].map(|part| values[Self::place(part)]);
            offset + scale * given
        } else {
            given
        };
        let error = value - wanted;
        if self.traced[quantity].dimension == Dimension::Angle {
            error - S::constant(TAU * (error.real() / TAU).round())
        } else {
            error
        }
    }

    /// Calls `emit` with the weighted errors of a target.
    pub(crate) fn target_rows<W: Mechanism<Assembly = M::Assembly>>(
        &self,
        mechanism: &W,
        assembly: W::Assembly,
        values: &[W::Scalar],
        target: usize,
        emit: &mut impl FnMut(W::Scalar),
    ) -> Result<(), SolveError> {
        let found = self.traced(mechanism, assembly, values, self.input(values, target))?;
        for (quantity, [value, _]) in found.into_iter().enumerate().take(self.traced.len()) {
            let error = self.error(values, target, quantity, value);
            emit(error * W::Scalar::constant(self.weight(target, quantity)));
        }
        Ok(())
    }

    /// The places of the travel.
    fn places<S: Number>(&self, values: &[S]) -> Vec<S> {
        let place = |place: usize| match self.travel {
            Travel::Turn => S::constant(TAU * share(place, PLACES)),
            Travel::Targets => {
                let [first, last] = [0, self.targets.len() - 1].map(|target| self.input(values, target));
                first + (last - first) * S::constant(share(place, PLACES - 1))
            }
        };
        (0..PLACES).map(place).collect()
    }

    /// The number of rows.
    pub(crate) fn row_count(&self) -> usize {
        let blocks = <M::Blocks<f64> as Row<f64>>::LENGTH;
        let terms = self.terms.iter().map(|term| match term {
            Term::Lengths { .. } => 1,
            Term::Box { .. } => 2,
            Term::Grashof { .. } | Term::DriverTurns { .. } => blocks,
            Term::Transmission { .. } => PLACES,
        });
        self.targets.len() * self.traced.len() + terms.sum::<usize>()
    }

    /// Calls `emit` with the rows of all terms.
    pub(crate) fn term_rows<W: Mechanism<Assembly = M::Assembly>>(
        &self,
        mechanism: &W,
        assembly: W::Assembly,
        values: &[W::Scalar],
        emit: &mut impl FnMut(W::Scalar),
    ) -> Result<(), SolveError> {
        let constant = W::Scalar::constant;
        let deficit = |short: W::Scalar, weight: f64| {
            if short.real() > 0.0 {
                short * constant(weight)
            } else {
                constant(0.0)
            }
        };
        let forms = mechanism.block_forms();
        let name = M::DESCRIPTION.inputs[self.moving].name;
        for term in &self.terms {
            match *term {
                Term::Lengths { weight } => {
                    let mut sum = constant(0.0);
                    for (quantity, value) in M::DESCRIPTION.parameters.iter().zip(values) {
                        if quantity.dimension == Dimension::Length {
                            sum = if value.real() < 0.0 { sum - *value } else { sum + *value };
                        }
                    }
                    emit(sum * constant(weight));
                }
                Term::Box { width, height, weight } => {
                    let mut ends: [Option<[W::Scalar; 2]>; 2] = [None; 2];
                    for input in self.places(values) {
                        let inputs = self.inputs::<W>(input);
                        let unknowns = mechanism.position(self.inputs::<W>(input), assembly)?;
                        for joint in mechanism.places(inputs, unknowns).as_slice() {
                            let joint = joint.in_space();
                            for (ends, value) in ends.iter_mut().zip([joint.x, joint.y]) {
                                let [low, high] = ends.get_or_insert([value; 2]);
                                if value.real() < low.real() {
                                    *low = value;
                                }
                                if value.real() > high.real() {
                                    *high = value;
                                }
                            }
                        }
                    }
                    for (ends, free) in ends.into_iter().zip([width, height]) {
                        let [low, high] = ends.unwrap_or([constant(0.0); 2]);
                        emit(deficit(high - low - constant(free), weight));
                    }
                }
                Term::Grashof { aim, weight } => {
                    for form in forms.as_ref() {
                        let margin = grashof(form, name);
                        emit(margin.map_or(constant(0.0), |margin| deficit(constant(aim) - margin, weight)));
                    }
                }
                Term::DriverTurns { aim, weight } => {
                    for form in forms.as_ref() {
                        let margin = driver_turns(form, name);
                        emit(margin.map_or(constant(0.0), |margin| deficit(constant(aim) - margin, weight)));
                    }
                }
                Term::Transmission { aim, weight, .. } => {
                    for input in self.places(values) {
                        let inputs = self.inputs::<W>(input);
                        let unknowns = mechanism.position(self.inputs::<W>(input), assembly)?;
                        let mut worst = constant(FRAC_PI_2);
                        for dyad in mechanism.transmission_angles_at(inputs, unknowns).as_ref() {
                            let folded = dyad.folded();
                            if folded.real() < worst.real() {
                                worst = folded;
                            }
                        }
                        emit(deficit(constant(aim) - worst, weight));
                    }
                }
            }
        }
        Ok(())
    }

    /// Whether the mechanism closes at the places of the travel, if that is a full turn.
    pub(crate) fn closes(&self, mechanism: &M, assembly: M::Assembly) -> bool {
        self.travel == Travel::Targets
            || (0..PLACES).all(|place| {
                let input = TAU * share(place, PLACES);
                mechanism.position(self.inputs::<M>(input), assembly).is_ok()
            })
    }

    /// All rows; none if the mechanism does not close somewhere.
    pub(crate) fn rows(&self, values: &[f64], assembly: M::Assembly) -> Option<Vec<f64>> {
        let own: M = mechanism(values);
        if !self.closes(&own, assembly) {
            return None;
        }
        let mut rows = Vec::with_capacity(self.row_count());
        for target in 0..self.targets.len() {
            self.target_rows(&own, assembly, values, target, &mut |row| rows.push(row))
                .ok()?;
        }
        self.term_rows(&own, assembly, values, &mut |row| rows.push(row)).ok()?;
        rows.iter().all(|row| row.is_finite()).then_some(rows)
    }

    /// The derivatives of all rows by the values at the given places, row by row; none if the mechanism does not close
    /// somewhere.
    pub(crate) fn derivatives(&self, values: &[f64], assembly: M::Assembly, by: &[usize]) -> Option<Vec<f64>> {
        let columns = by.len();
        let mut derivatives = vec![0.0; self.row_count() * columns];
        let targets = self.targets.len();
        let times = M::DESCRIPTION.parameters.len() + PARTS;
        for (column, &place) in by.iter().enumerate() {
            let seeded: Vec<Change> = values
                .iter()
                .enumerate()
                .map(|(index, value)| Change::from_coefficients([*value, if index == place { 1.0 } else { 0.0 }]))
                .collect();
            let own: M::With<Change> = mechanism(&seeded);
            let mut row = 0;
            let mut emit = |value: Change| {
                derivatives[row * columns + column] = value.coefficients()[1];
                row += 1;
            };
            for target in 0..targets {
                // The input of a target has no influence on the others.
                if place >= times && place != times + target {
                    for _ in &self.traced {
                        emit(Change::constant(0.0));
                    }
                } else {
                    self.target_rows(&own, assembly, &seeded, target, &mut emit).ok()?;
                }
            }
            // On a full turn terms do not depend on the inputs of targets, and otherwise on the first and the last.
            // Their derivatives are zero already.
            let moves_terms =
                place < times || self.travel == Travel::Targets && (place == times || place + 1 == times + targets);
            if !self.terms.is_empty() && moves_terms {
                self.term_rows(&own, assembly, &seeded, &mut emit).ok()?;
            }
        }
        derivatives.iter().all(|one| one.is_finite()).then_some(derivatives)
    }
}
