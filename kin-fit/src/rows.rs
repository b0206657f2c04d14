//! The rows of the sum of squares, in any number: in plain numbers they are the errors, in numbers that carry a derivative also its
//! derivatives.

use std::f64::consts::{FRAC_PI_2, TAU};

use kin_core::{Dimension, Number, Scalar};

use crate::functions::{Change, Choice, FitOver, Posed, Solved, unturned};
use crate::margins::{driver_turns, grashof};
use crate::objective::{Objective, PARTS, Part};
use crate::term::{Term, TermAt, Travel};

/// The places of the travel at which terms are evaluated.
pub(crate) const PLACES: usize = 24;

/// The error of a position that does not close, in spreads of the targets: larger than any that does. The [crate](crate) tells the rule.
pub(crate) const OPEN: f64 = 100.0;

#[expect(clippy::cast_precision_loss, reason = "counts are small")]
pub(crate) fn share(part: usize, of: usize) -> f64 {
    part as f64 / of as f64
}

/// A number of which plain numbers are one kind.
pub(crate) trait FitNumber: Scalar {
    fn over(objective: &Objective) -> &'static dyn FitOver<Self>;

    fn change(self) -> Change;

    fn of_change(change: Change) -> Self;
}

impl FitNumber for f64 {
    fn over(objective: &Objective) -> &'static dyn FitOver<Self> {
        objective.functions
    }

    fn change(self) -> Change {
        Change::constant(self)
    }

    fn of_change(change: Change) -> Self {
        change.value
    }
}

impl FitNumber for Change {
    fn over(objective: &Objective) -> &'static dyn FitOver<Self> {
        objective.functions
    }

    fn change(self) -> Change {
        self
    }

    fn of_change(change: Change) -> Self {
        change
    }
}

impl Objective {
    /// The place of a part among the values.
    pub(crate) fn place(&self, part: Part) -> usize {
        self.parameters.len() + part as usize
    }

    /// The place among the values behind the parts, where the sought inputs begin.
    pub(crate) fn first_input(&self) -> usize {
        self.parameters.len() + PARTS
    }

    /// The place of the input of a target among the values, if it is sought.
    pub(crate) fn input_place(&self, target: usize) -> Option<usize> {
        self.targets[target].sought.map(|place| self.first_input() + place)
    }

    /// The input of a target.
    pub(crate) fn input<T: Number>(&self, values: &[T], target: usize) -> T {
        if let Some(place) = self.input_place(target) {
            return values[place];
        }
        let [phase, pace] = [Part::Phase, Part::Pace].map(|part| values[self.place(part)]);
        phase + pace * T::constant(self.targets[target].input.unwrap_or(0.0))
    }

    /// The values of the inputs.
    pub(crate) fn inputs<T: Number>(&self, input: T) -> Vec<T> {
        self.inputs_beside(&self.others, input)
    }

    /// All inputs where the moving one has this value, in the order of the declaration.
    #[must_use]
    pub fn inputs_at(&self, moving: f64) -> Vec<f64> {
        self.inputs(moving)
    }

    fn inputs_beside<T: Number>(&self, others: &[f64], input: T) -> Vec<T> {
        let mut inputs: Vec<T> = others.iter().copied().map(T::constant).collect();
        inputs[self.moving] = input;
        inputs
    }

    /// The mechanism of a row of values, which begins with its parameters.
    pub(crate) fn posed<'p, T: FitNumber>(&self, values: &'p [T], choice: &'p Choice) -> Posed<'p, T> {
        Posed {
            functions: self.functions,
            over: T::over(self),
            parameters: &values[..self.parameters.len()],
            choice,
        }
    }

    /// The traced quantities in the frame of the targets, at the inputs of a target with this moving one.
    pub(crate) fn traced<T: FitNumber>(
        &self,
        posed: &Posed<'_, T>,
        values: &[T],
        target: usize,
        input: T,
    ) -> Option<Vec<T>> {
        let others = self.targets[target].others.as_ref().unwrap_or(&self.others);
        let solved = posed.solve(self.inputs_beside(others, input))?;
        let outputs = posed.outputs(&solved);
        let mut found: Vec<T> = self
            .traced
            .iter()
            .map(|one| one.of(&solved.unknowns, &outputs))
            .collect();
        if self.goal.is_placed() {
            let [x, y, turn] = [Part::X, Part::Y, Part::Turn].map(|part| values[self.place(part)]);
            let (sine, cosine) = turn.sin_cos();
            let [along, beside] = [found[0], found[1]];
            found[0] = x + (cosine * along - sine * beside);
            found[1] = y + (sine * along + cosine * beside);
            if let Some(angle) = found.get_mut(2) {
                *angle = turn + *angle;
            }
        }
        Some(found)
    }

    /// The error of a traced quantity, without weight; zero where no value is given. Angles are compared up to whole turns.
    pub(crate) fn error<T: Number>(&self, values: &[T], target: usize, quantity: usize, value: T) -> T {
        let Some(given) = self.targets[target].values[quantity] else {
            return T::constant(0.0);
        };
        let [offset, scale] = [Part::Offset, Part::Scale].map(|part| values[self.place(part)]);
        let error = value - (offset + scale * T::constant(given));
        if self.traced[quantity].dimension == Dimension::Angle {
            unturned(error)
        } else {
            error
        }
    }

    /// The weighted errors of a target.
    pub(crate) fn errors<T: FitNumber>(&self, posed: &Posed<'_, T>, values: &[T], target: usize) -> Option<Vec<T>> {
        let found = self.traced(posed, values, target, self.input(values, target))?;
        let weighted = found.into_iter().enumerate().map(|(quantity, value)| {
            let weight = self.targets[target].weight * self.traced[quantity].unit;
            self.error(values, target, quantity, value) * T::constant(weight)
        });
        Some(weighted.collect())
    }

    /// The positions at the places of the travel.
    fn along_travel<T: FitNumber>(&self, posed: &Posed<'_, T>, values: &[T]) -> Option<Vec<Solved<T>>> {
        let place = |place: usize| match self.travel {
            Travel::Turn => T::constant(TAU * share(place, PLACES)),
            Travel::Targets => {
                let [first, last] = [0, self.targets.len() - 1].map(|target| self.input(values, target));
                first + (last - first) * T::constant(share(place, PLACES - 1))
            }
        };
        (0..PLACES).map(|step| posed.solve(self.inputs(place(step)))).collect()
    }

    /// The number of rows of a term.
    fn term_row_count(&self, term: &Term) -> usize {
        match term {
            Term::Lengths { .. } => 1,
            Term::Box { .. } => 2,
            Term::Grashof { .. } | Term::DriverTurns { .. } => self.description().blocks.len(),
            Term::Transmission { .. } => PLACES,
        }
    }

    /// The number of rows.
    pub(crate) fn row_count(&self) -> usize {
        let terms = self.terms.iter().map(|term| self.term_row_count(term)).sum::<usize>();
        let own = self.own_terms.iter().map(|term| term.count).sum::<usize>();
        self.targets.len() * self.traced.len() + terms + own
    }

    /// The rows of a term, or `None` where a position of it does not close.
    fn term_rows<T: FitNumber>(&self, term: &Term, posed: &Posed<'_, T>, values: &[T]) -> Option<Vec<T>> {
        let constant = T::constant;
        let deficit = |short: T, weight: f64| {
            if short.real() > 0.0 {
                short * constant(weight)
            } else {
                constant(0.0)
            }
        };
        let name = self.description().inputs[self.moving].name;
        let margins = |margin: fn(&kin_core::BlockForm<T>, &str) -> Option<T>, aim: f64, weight: f64| {
            let rows = posed.forms().into_iter().map(|form| {
                margin(&form, name).map_or(constant(0.0), |margin| deficit(constant(aim) - margin, weight))
            });
            rows.collect()
        };
        Some(match *term {
            Term::Lengths { weight } => {
                let mut sum = constant(0.0);
                for (quantity, value) in self.description().parameters.iter().zip(values) {
                    if quantity.dimension == Dimension::Length {
                        sum = if value.real() < 0.0 { sum - *value } else { sum + *value };
                    }
                }
                vec![sum * constant(weight)]
            }
            Term::Box { width, height, weight } => {
                let mut ends: [Option<[T; 2]>; 2] = [None; 2];
                for solved in self.along_travel(posed, values)? {
                    posed.joints(&solved, &mut |joint| {
                        for (ends, value) in ends.iter_mut().zip(joint) {
                            let [low, high] = ends.get_or_insert([value; 2]);
                            if value.real() < low.real() {
                                *low = value;
                            }
                            if value.real() > high.real() {
                                *high = value;
                            }
                        }
                    });
                }
                let rows = ends.into_iter().zip([width, height]).map(|(ends, free)| {
                    let [low, high] = ends.unwrap_or([constant(0.0); 2]);
                    deficit(high - low - constant(free), weight)
                });
                rows.collect()
            }
            Term::Grashof { aim, weight } => margins(grashof, aim, weight),
            Term::DriverTurns { aim, weight } => margins(driver_turns, aim, weight),
            Term::Transmission { aim, weight, .. } => {
                let rows = self.along_travel(posed, values)?.into_iter().map(|solved| {
                    let worst = posed.transmission(&solved).unwrap_or(constant(FRAC_PI_2));
                    deficit(constant(aim) - worst, weight)
                });
                rows.collect()
            }
        })
    }

    /// The rows of all terms, each `None` where a position of it does not close, with the number of rows that it has.
    pub(crate) fn all_term_rows<T: FitNumber>(
        &self,
        posed: &Posed<'_, T>,
        values: &[T],
    ) -> Vec<(usize, Option<Vec<T>>)> {
        let terms = self.terms.iter();
        let mut all: Vec<_> = terms
            .map(|term| (self.term_row_count(term), self.term_rows(term, posed, values)))
            .collect();
        if !self.own_terms.is_empty() {
            let parameters: Vec<Change> = posed.parameters.iter().map(|value| value.change()).collect();
            let posed = Posed::<Change> {
                functions: self.functions,
                over: Change::over(self),
                parameters: &parameters,
                choice: posed.choice,
            };
            let at = TermAt { posed: &posed };
            all.extend(self.own_terms.iter().map(|term| {
                let rows = (term.rows)(&at);
                let rows = rows.map(|rows| rows.into_iter().map(T::of_change).collect());
                (term.count, rows)
            }));
        }
        all
    }

    /// Whether the mechanism closes at the places of the travel, if that is a full turn.
    pub(crate) fn closes(&self, values: &[f64], choice: &Choice) -> bool {
        let posed = self.posed(values, choice);
        self.travel == Travel::Targets
            || (0..PLACES).all(|place| posed.solve(self.inputs(TAU * share(place, PLACES))).is_some())
    }

    /// The size of a row whose position does not close.
    fn open(&self) -> f64 {
        OPEN * self.spread()
    }

    /// All rows, and how many of them have no position.
    pub(crate) fn rows(&self, values: &[f64], choice: &Choice) -> (Vec<f64>, usize) {
        let count = self.row_count();
        if !self.closes(values, choice) {
            return (vec![self.open(); count], count);
        }
        let posed = self.posed(values, choice);
        let (mut rows, mut open) = (Vec::with_capacity(count), 0);
        let mut add = |own: Option<Vec<f64>>, count: usize, size: f64| match own {
            Some(own) if own.iter().all(|row| row.is_finite()) => rows.extend(own),
            _ => {
                open += count;
                rows.extend(std::iter::repeat_n(size, count));
            }
        };
        for (target, one) in self.targets.iter().enumerate() {
            add(
                self.errors(&posed, values, target),
                self.traced.len(),
                one.weight * self.open(),
            );
        }
        for (count, own) in self.all_term_rows(&posed, values) {
            add(own, count, self.open());
        }
        (rows, open)
    }

    /// The derivatives of all rows by the values at the given places, row by row: zero in rows without a position.
    pub(crate) fn derivatives(&self, values: &[f64], choice: &Choice, by: &[usize]) -> Vec<f64> {
        let columns = by.len();
        let mut derivatives = vec![0.0; self.row_count() * columns];
        if !self.closes(values, choice) {
            return derivatives;
        }
        let (quantities, first, targets) = (self.traced.len(), self.first_input(), self.targets.len());
        let ends = [0, targets - 1].map(|target| self.input_place(target));
        for (column, &place) in by.iter().enumerate() {
            let seeded = |(index, value): (usize, &f64)| Change::new(*value, if index == place { 1.0 } else { 0.0 });
            let seeded: Vec<Change> = values.iter().enumerate().map(seeded).collect();
            let posed = self.posed(&seeded, choice);
            let mut write = |row: usize, own: Option<Vec<Change>>| {
                for (offset, value) in own.into_iter().flatten().enumerate() {
                    derivatives[(row + offset) * columns + column] = value.change;
                }
            };
            for target in 0..targets {
                // the input of a target has no influence on the others
                if place < first || self.input_place(target) == Some(place) {
                    write(target * quantities, self.errors(&posed, &seeded, target));
                }
            }
            // on a full turn terms do not depend on the inputs of targets, and otherwise on the first and the last
            if place < first || self.travel == Travel::Targets && ends.contains(&Some(place)) {
                let mut row = targets * quantities;
                for (count, own) in self.all_term_rows(&posed, &seeded) {
                    write(row, own);
                    row += count;
                }
            }
        }
        derivatives
    }
}
