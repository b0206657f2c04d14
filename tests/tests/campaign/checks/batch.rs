//! Batches find what single poses find, in every kind of vectors, and on all cores to the last bit.

use kin_core::any::AssemblyChoice;
use kin_core::batch::{Outcome, Vectors};

use super::pose::ALLOWED;
use super::{Campaign, Pose, Size, Solved};
use crate::topology::{Problem, Rates};
use crate::unit::units;
use kin_tests::batches::{Table, vectors};

/// Above this condition of a position, rounding may decide whether a batch and a single solver find it: see the chapter
/// on batches.
const DECISIVE: f64 = 1e3;

/// The relative change of a number from which the condition of a margin follows.
const STEP: f64 = 1e-7;

/// The sum of all dimensions and inputs.
fn lengths(problem: &Problem) -> f64 {
    let inputs = problem.inputs.iter().map(|rates| &rates[0]);
    problem.parameters.iter().chain(inputs).map(|number| number.abs()).sum()
}

impl Campaign {
    /// Everything that was solved once more in batches, those of an assembly together.
    pub(super) fn batches(&mut self, all: &[Solved], size: Size) {
        let mut kinds: Vec<Option<usize>> = all.iter().map(|solved| solved.assembly.index()).collect();
        kinds.sort_unstable();
        kinds.dedup();
        let mut largest = Vec::new();
        for kind in kinds {
            let together: Vec<&Solved> = all.iter().filter(|solved| solved.assembly.index() == kind).collect();
            for vectors in vectors() {
                self.batch(&together, vectors);
            }
            if together.len() > largest.len() {
                largest = together;
            }
        }
        if let Some(first) = largest.first() {
            self.current = (first.problem.clone(), first.assembly.clone());
            self.in_parallel(&largest, size.parallel);
        }
    }

    fn batch(&mut self, together: &[&Solved], vectors: Vectors) {
        let (problems, assemblies): (Vec<Problem>, Vec<AssemblyChoice>) = together
            .iter()
            .map(|solved| (solved.problem.clone(), solved.assembly.clone()))
            .unzip();
        self.current = (problems[0].clone(), assemblies[0].clone());
        let (table, outcomes, summary) = self.topology.batch(&problems, &assemblies, vectors);
        let mut solved_ones = 0;
        for (index, (solved, outcome)) in together.iter().zip(&outcomes).enumerate() {
            solved_ones += usize::from(outcome.is_solved());
            let expected = solved.result.as_ref().map_or_else(Outcome::from, |_| Outcome::Solved);
            if !self.are_alike(*outcome, expected, solved) {
                let condition = self.condition(solved, &table, index);
                if condition > DECISIVE {
                    self.tally.undecided += 1;
                    continue;
                }
                let what = format!("{vectors:?} says {outcome:?}, solve {expected:?}; condition {condition:e}");
                self.find("outcome", what, &solved.problem, &solved.assembly);
                continue;
            }
            match &solved.result {
                Ok(pose) => self.agrees(solved, pose, &table, index, vectors),
                Err(_) => self.is_empty(solved, &table, index, vectors),
            }
        }
        if summary.solved != solved_ones || summary.failed != outcomes.len() - solved_ones {
            let what = format!("{vectors:?}: {summary:?}, and {solved_ones} are solved");
            self.find("summary", what, &problems[0], &assemblies[0]);
        }
    }

    /// Whether two outcomes are the same, with margins that agree to 4 ε of the lengths, multiplied by the condition of
    /// the blocks before.
    fn are_alike(&self, own: Outcome, other: Outcome, solved: &Solved) -> bool {
        if let (Outcome::OutOfReach { margin: own }, Outcome::OutOfReach { margin: other }) = (own, other) {
            let allowed = |condition: f64| (own - other).abs() <= 4.0 * f64::EPSILON * condition;
            return allowed(lengths(&solved.problem) + other.abs()) || allowed(self.margin_condition(solved, other));
        }
        own == other
    }

    /// The condition of a margin: its change with each number, times the number. The blocks before the one that fails
    /// pass on their rounding errors, each of which is like a change of its own numbers.
    fn margin_condition(&self, solved: &Solved, margin: f64) -> f64 {
        let change = |problem: &Problem| {
            let outcome = self
                .topology
                .solve(problem, &solved.assembly)
                .as_ref()
                .map_or_else(Outcome::from, |_| Outcome::Solved);
            let moved = outcome.margin().unwrap_or(margin);
            (moved - margin).abs() / STEP
        };
        let mut condition = lengths(&solved.problem) + margin.abs();
        let mut problem = solved.problem.clone();
        for place in 0..problem.parameters.len() {
            let own = problem.parameters[place];
            problem.parameters[place] = own * (1.0 + STEP);
            condition += change(&problem);
            problem.parameters[place] = own;
        }
        for place in 0..problem.inputs.len() {
            let own = problem.inputs[place][0];
            problem.inputs[place][0] = own * (1.0 + STEP);
            condition += change(&problem);
            problem.inputs[place][0] = own;
        }
        condition
    }

    /// The condition of a pose that closes for a batch or alone, whichever has found it.
    fn condition(&self, solved: &Solved, table: &Table, index: usize) -> f64 {
        let own = if let Ok(pose) = &solved.result {
            pose.units.as_ref().map(|units| units.condition)
        } else {
            let unknowns: Vec<Rates> = (0..table.unknowns.len())
                .map(|place| {
                    let mut rates = Rates::from(std::array::from_fn(|order| table.unknowns[place][order][index]));
                    if table.is_direction(place) {
                        rates[0] = table.sines[place][index].atan2(rates[0]);
                    }
                    rates
                })
                .collect();
            units(&self.topology, &solved.problem, &unknowns).map(|units| units.condition)
        };
        own.unwrap_or(f64::NAN)
    }

    /// A pose of a batch is that of the single solver.
    fn agrees(&mut self, solved: &Solved, pose: &Pose, table: &Table, index: usize, vectors: Vectors) {
        let numbers = table
            .unknowns
            .iter()
            .chain(&table.outputs)
            .flatten()
            .chain(&table.sines);
        let is_finite = numbers.map(|column| column[index]).all(f64::is_finite);
        if !is_finite {
            self.find(
                "batch",
                format!("{vectors:?}: not finite"),
                &solved.problem,
                &solved.assembly,
            );
        }
        let Some(units) = pose.known(f64::EPSILON) else {
            return;
        };
        for (place, columns) in table.unknowns.iter().enumerate() {
            let mut expected = pose.found.unknowns[place];
            let (sine, cosine) = expected[0].sin_cos();
            let is_direction = table.is_direction(place);
            if is_direction {
                expected[0] = cosine;
            }
            let rates = (0..).zip(columns.iter().zip(expected));
            let rates = rates.map(|(order, (column, expected))| (order, column[index], expected));
            let sine = is_direction.then(|| (0, table.sines[place][index], sine));
            for (order, found, expected) in rates.chain(sine) {
                // Cosine and sine move by no more than the angle, and are rounded themselves.
                let unit = f64::EPSILON * units.conditions[place][order] + f64::MIN_POSITIVE;
                let error = (found - expected).abs() / unit;
                self.tally.values += 1;
                self.tally.batch = self.tally.batch.max(error);
                if error > ALLOWED {
                    let name = self.topology.description().unknowns[place].name;
                    let what = format!(
                        "{vectors:?}: order {order} of {name} is {found:e} for {expected:e}, {error:.1} units; \
                            condition {:e}",
                        units.condition
                    );
                    self.find("batch", what, &solved.problem, &solved.assembly);
                }
            }
        }
    }

    /// A pose that is not found leaves no numbers.
    fn is_empty(&mut self, solved: &Solved, table: &Table, index: usize, vectors: Vectors) {
        let mut numbers = table.unknowns.iter().chain(&table.outputs).flatten();
        if !numbers.all(|column| column[index].is_nan()) {
            self.find(
                "batch",
                format!("{vectors:?}: numbers of no pose"),
                &solved.problem,
                &solved.assembly,
            );
        }
    }

    /// All cores together come to the same bits as one.
    fn in_parallel(&mut self, together: &[&Solved], count: usize) {
        let (problems, assemblies): (Vec<Problem>, Vec<AssemblyChoice>) = together
            .iter()
            .cycle()
            .take(count)
            .map(|solved| (solved.problem.clone(), solved.assembly.clone()))
            .unzip();
        let widest = Vectors::widest();
        let (table, outcomes, summary) = self.topology.batch(&problems, &assemblies, widest);
        let (other, other_outcomes, other_summary) = (self.topology.in_parallel)(&problems, &assemblies, widest);
        for index in 0..problems.len() {
            if table.bits(index) != other.bits(index) || outcomes[index] != other_outcomes[index] {
                self.find(
                    "parallel",
                    format!("pose {index}"),
                    &problems[index],
                    &assemblies[index],
                );
            }
        }
        let same = (summary.solved, summary.failed) == (other_summary.solved, other_summary.failed)
            && summary.first_failure.map(|(first, _)| first) == other_summary.first_failure.map(|(first, _)| first);
        if !same {
            self.find(
                "parallel",
                format!("{summary:?} {other_summary:?}"),
                &problems[0],
                &assemblies[0],
            );
        }
    }
}
