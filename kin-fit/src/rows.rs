//! The rows of the sum of squares, in numbers that carry a derivative with respect to one number that is sought.

use std::f64::consts::{FRAC_PI_2, TAU};

use kin_core::{Dimension, Number as _};

use crate::functions::{Change, Choice, Posed, Solved, unturned};
use crate::margins::{driver_turns, grashof};
use crate::objective::{Objective, PARTS, Part};
use crate::term::{Term, TermAt, Travel};

/// The number of samples of the travel at which terms are evaluated.
pub(crate) const SAMPLES: usize = 24;

/// The error of a position that does not close, in spreads of the targets: larger than that of any position that
/// closes. The [crate](crate) states the rule.
pub(crate) const UNCLOSED: f64 = 100.0;

#[expect(clippy::cast_precision_loss, reason = "counts are small")]
pub(crate) fn share(part: usize, of: usize) -> f64 {
    part as f64 / of as f64
}

impl Objective {
    /// The index of a part among the values.
    pub(crate) fn part_index(&self, part: Part) -> usize {
        self.parameters.len() + part as usize
    }

    /// The index of the first sought input among the values, which follows the parts.
    pub(crate) fn first_input(&self) -> usize {
        self.parameters.len() + PARTS
    }

    /// The index of the input of a target among the values, if it is sought.
    pub(crate) fn input_index(&self, target: usize) -> Option<usize> {
        self.targets[target].sought.map(|index| self.first_input() + index)
    }

    /// The input of a target.
    pub(crate) fn input(&self, posed: &Posed<'_>, target: usize) -> Change {
        if let Some(index) = self.input_index(target) {
            return posed.values[index];
        }
        let [phase, pace] = [Part::Phase, Part::Pace].map(|part| posed.values[self.part_index(part)]);
        phase + pace * Change::constant(self.targets[target].input.unwrap_or(0.0))
    }

    /// The values of the inputs.
    pub(crate) fn inputs(&self, input: Change) -> Vec<Change> {
        self.inputs_beside(&self.others, input)
    }

    /// All inputs where the moving input has this value, in the order of the declaration.
    #[must_use]
    pub fn inputs_at(&self, moving: f64) -> Vec<f64> {
        let mut inputs = self.others.clone();
        inputs[self.moving] = moving;
        inputs
    }

    fn inputs_beside(&self, others: &[f64], input: Change) -> Vec<Change> {
        let mut inputs: Vec<Change> = others.iter().copied().map(Change::constant).collect();
        inputs[self.moving] = input;
        inputs
    }

    /// The mechanism of a row of values, which begins with its parameters.
    pub(crate) fn posed<'p>(&self, values: &[f64], choice: &'p Choice) -> Posed<'p> {
        Posed {
            functions: self.functions,
            values: values.iter().copied().map(Change::constant).collect(),
            choice,
        }
    }

    /// The traced quantities in the frame of the targets, at the inputs of a target with this value of the moving
    /// input.
    pub(crate) fn traced(&self, posed: &Posed<'_>, target: usize, input: Change) -> Option<Vec<Change>> {
        let others = self.targets[target].others.as_ref().unwrap_or(&self.others);
        let solved = posed.solve(self.inputs_beside(others, input))?;
        let outputs = posed.outputs(&solved);
        let mut found: Vec<Change> = self
            .traced
            .iter()
            .map(|one| one.of(&solved.unknowns, &outputs))
            .collect();
        if self.goal.is_placed() {
            let [x, y, rotation] = [Part::X, Part::Y, Part::Rotation].map(|part| posed.values[self.part_index(part)]);
            let (sine, cosine) = rotation.sin_cos();
            let [along, beside] = [found[0], found[1]];
            found[0] = x + (cosine * along - sine * beside);
            found[1] = y + (sine * along + cosine * beside);
            if let Some(angle) = found.get_mut(2) {
                *angle = rotation + *angle;
            }
        }
        Some(found)
    }

    /// The error of a traced quantity, without weight; zero where no value is given. Angles are compared up to whole
    /// revolutions.
    pub(crate) fn error(&self, posed: &Posed<'_>, target: usize, quantity: usize, value: Change) -> Change {
        let Some(given) = self.targets[target].values[quantity] else {
            return Change::constant(0.0);
        };
        let [offset, scale] = [Part::Offset, Part::Scale].map(|part| posed.values[self.part_index(part)]);
        let error = value - (offset + scale * Change::constant(given));
        if self.traced[quantity].dimension == Dimension::Angle {
            unturned(error)
        } else {
            error
        }
    }

    /// The weighted errors of a target.
    pub(crate) fn errors(&self, posed: &Posed<'_>, target: usize) -> Option<Vec<Change>> {
        let found = self.traced(posed, target, self.input(posed, target))?;
        let weighted = found.into_iter().enumerate().map(|(quantity, value)| {
            let weight = self.targets[target].weight * self.traced[quantity].unit;
            self.error(posed, target, quantity, value) * Change::constant(weight)
        });
        Some(weighted.collect())
    }

    /// The positions at the samples of the travel.
    fn along_travel(&self, posed: &Posed<'_>) -> Option<Vec<Solved>> {
        let sample = |sample: usize| match self.travel {
            Travel::Revolution => Change::constant(TAU * share(sample, SAMPLES)),
            Travel::Targets => {
                let [first, last] = [0, self.targets.len() - 1].map(|target| self.input(posed, target));
                first + (last - first) * Change::constant(share(sample, SAMPLES - 1))
            }
        };
        (0..SAMPLES)
            .map(|step| posed.solve(self.inputs(sample(step))))
            .collect()
    }

    /// The number of rows of a term.
    fn term_row_count(&self, term: &Term) -> usize {
        match term {
            Term::Lengths { .. } => 1,
            Term::Box { .. } => 2,
            Term::Grashof { .. } | Term::DriverTurns { .. } => self.description().blocks.len(),
            Term::Transmission { .. } => SAMPLES,
        }
    }

    /// The number of rows.
    pub(crate) fn row_count(&self) -> usize {
        let terms = self.terms.iter().map(|term| self.term_row_count(term)).sum::<usize>();
        let custom = self.custom_terms.iter().map(|term| term.count).sum::<usize>();
        self.targets.len() * self.traced.len() + terms + custom
    }

    /// The rows of a term, or `None` where one of its positions does not close.
    fn term_rows(&self, term: &Term, posed: &Posed<'_>) -> Option<Vec<Change>> {
        let constant = Change::constant;
        let deficit = |short: Change, weight: f64| {
            if short.value > 0.0 {
                short * constant(weight)
            } else {
                constant(0.0)
            }
        };
        let name = self.description().inputs[self.moving].name;
        let margins = |margin: fn(&kin_core::BlockForm<Change>, &str) -> Option<Change>, aim: f64, weight: f64| {
            let rows = posed.forms().into_iter().map(|form| {
                margin(&form, name).map_or(constant(0.0), |margin| deficit(constant(aim) - margin, weight))
            });
            rows.collect()
        };
        Some(match *term {
            Term::Lengths { weight } => {
                let mut sum = constant(0.0);
                for (quantity, value) in self.description().parameters.iter().zip(posed.parameters()) {
                    if quantity.dimension == Dimension::Length {
                        sum = if value.value < 0.0 { sum - *value } else { sum + *value };
                    }
                }
                vec![sum * constant(weight)]
            }
            Term::Box { width, height, weight } => {
                let mut ends: [Option<[Change; 2]>; 2] = [None; 2];
                for solved in self.along_travel(posed)? {
                    posed.joints(&solved, &mut |joint| {
                        for (ends, value) in ends.iter_mut().zip(joint) {
                            let [low, high] = ends.get_or_insert([value; 2]);
                            if value.value < low.value {
                                *low = value;
                            }
                            if value.value > high.value {
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
                let rows = self.along_travel(posed)?.into_iter().map(|solved| {
                    let worst = posed.transmission(&solved).unwrap_or(constant(FRAC_PI_2));
                    deficit(constant(aim) - worst, weight)
                });
                rows.collect()
            }
        })
    }

    /// The rows of all terms, each with their number. The rows of a term are `None` where one of its positions does not
    /// close.
    pub(crate) fn all_term_rows(&self, posed: &Posed<'_>) -> Vec<(usize, Option<Vec<Change>>)> {
        let terms = self.terms.iter();
        let mut all: Vec<_> = terms
            .map(|term| (self.term_row_count(term), self.term_rows(term, posed)))
            .collect();
        let at = TermAt { posed };
        all.extend(self.custom_terms.iter().map(|term| (term.count, (term.rows)(&at))));
        all
    }

    /// Whether the mechanism closes at the samples of the travel, if the travel is a full revolution.
    pub(crate) fn closes(&self, values: &[f64], choice: &Choice) -> bool {
        let posed = self.posed(values, choice);
        self.travel == Travel::Targets
            || (0..SAMPLES).all(|sample| {
                posed
                    .solve(self.inputs(Change::constant(TAU * share(sample, SAMPLES))))
                    .is_some()
            })
    }

    /// The size of a row whose position does not close.
    fn unclosed(&self) -> f64 {
        UNCLOSED * self.spread()
    }

    /// All rows, and the number of rows without a position.
    pub(crate) fn rows(&self, values: &[f64], choice: &Choice) -> (Vec<f64>, usize) {
        let count = self.row_count();
        if !self.closes(values, choice) {
            return (vec![self.unclosed(); count], count);
        }
        let posed = self.posed(values, choice);
        let (mut rows, mut unclosed) = (Vec::with_capacity(count), 0);
        let mut add = |found: Option<Vec<Change>>, count: usize, size: f64| match found {
            Some(found) if found.iter().all(|row| row.value.is_finite()) => {
                rows.extend(found.iter().map(|row| row.value));
            }
            _ => {
                unclosed += count;
                rows.extend(std::iter::repeat_n(size, count));
            }
        };
        for (index, target) in self.targets.iter().enumerate() {
            let size = target.weight * self.unclosed();
            add(self.errors(&posed, index), self.traced.len(), size);
        }
        for (count, found) in self.all_term_rows(&posed) {
            add(found, count, self.unclosed());
        }
        (rows, unclosed)
    }

    /// The derivatives of all rows by the values at the given indices, row by row: zero in rows without a position.
    pub(crate) fn derivatives(&self, values: &[f64], choice: &Choice, by: &[usize]) -> Vec<f64> {
        let columns = by.len();
        let mut derivatives = vec![0.0; self.row_count() * columns];
        if !self.closes(values, choice) {
            return derivatives;
        }
        let (quantities, first, targets) = (self.traced.len(), self.first_input(), self.targets.len());
        let ends = [0, targets - 1].map(|target| self.input_index(target));
        let mut posed = self.posed(values, choice);
        for (column, &index) in by.iter().enumerate() {
            posed.values[index].change = 1.0;
            let mut write = |row: usize, found: Option<Vec<Change>>| {
                for (offset, value) in found.into_iter().flatten().enumerate() {
                    derivatives[(row + offset) * columns + column] = value.change;
                }
            };
            for target in 0..targets {
                // the input of a target has no influence on the others
                if index < first || self.input_index(target) == Some(index) {
                    write(target * quantities, self.errors(&posed, target));
                }
            }
            // over a full revolution, terms do not depend on the inputs of targets; otherwise on the first and the last
            if index < first || self.travel == Travel::Targets && ends.contains(&Some(index)) {
                let mut row = targets * quantities;
                for (count, found) in self.all_term_rows(&posed) {
                    write(row, found);
                    row += count;
                }
            }
            posed.values[index].change = 0.0;
        }
        derivatives
    }
}
