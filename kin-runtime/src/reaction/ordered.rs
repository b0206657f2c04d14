//! Linear equations in series, order by order: each term follows from the factors of the values alone.
//!
//! Few entries are not zero, and which they are is the same in all poses. So the order of the elimination, and the
//! places of all entries that it meets, are found once: a pivot is one that leaves the fewest entries to change, among
//! those that are not much smaller than the largest of their column (I. S. Duff, A. M. Erisman and J. K. Reid, *Direct
//! Methods for Sparse Matrices*, 2nd edition, Oxford 2017, section 5.2). In another pose the same order may have pivots
//! that are too small. [`factor`](OrderedSystem::factor) tells.

use alloc::vec;
use alloc::vec::Vec;

use super::frames::MovingNumber as _;
use super::pose_number::{PoseNumber, SinglePose};
use crate::number::Number;
use crate::number::series::{Series, SeriesOf};

/// A pivot is at least this part of the largest entry of its column.
const SMALLEST_PART: f64 = 0.25;

/// The largest multiplier in another pose: a digit more than where the order was found.
const LARGEST_MULTIPLIER: f64 = 16.0;

/// The smallest pivot in another pose, as a part of the entry of its column that was the largest one.
const SMALLEST_PIVOT: f64 = 1e-9;

/// A place at which there is no entry.
const NONE: u32 = u32::MAX;

/// A step of the elimination: the row and the column of the pivot, its slot, and the ends of its parts of the lists of
/// what is below and beside it.
#[derive(Clone, Copy, Debug)]
struct Step {
    row: usize,
    column: usize,
    pivot: usize,
    below_end: usize,
    beside_end: usize,
}

/// An entry or a multiplier, by its slot: the step that eliminates its row, and the one of its column.
#[derive(Clone, Copy, Debug)]
struct Coupling {
    row: usize,
    column: usize,
    slot: usize,
}

/// A square matrix of series with the factors of its values.
#[derive(Clone, Debug)]
pub(super) struct OrderedSystem<const N: usize, S = f64> {
    /// The slot of each entry, row by row.
    slots: Vec<u32>,
    /// The entries, by their slots.
    entries: Vec<SeriesOf<S, N>>,
    /// The column of each entry.
    columns: Vec<usize>,
    /// The entries that change, with their slots, and the steps that eliminate their rows and columns.
    changing: Vec<Coupling>,
    steps: Vec<Step>,
    /// The multipliers of rows below pivots.
    below: Vec<Coupling>,
    /// The entries beside pivots.
    beside: Vec<Coupling>,
    /// The same in the order in which the solution needs them.
    backward: Vec<Coupling>,
    /// For each row below a pivot, the slots that change with the entries beside it.
    targets: Vec<usize>,
    /// The factors, by their slots, of which the first are those of the entries: multipliers below the pivots, and
    /// beside them what is divided by them.
    factors: Vec<S>,
    /// The reciprocals of the pivots.
    reciprocals: Vec<S>,
    /// The largest entry of each column.
    largest: Vec<S>,
    rest: Vec<S>,
    known: Vec<[S; N]>,
    solution: Vec<SeriesOf<S, N>>,
}

impl<S: SinglePose, const N: usize> OrderedSystem<N, S> {
    /// A matrix by its columns, with its factors; none if a pivot is zero or an entry not finite.
    pub(super) fn of(columns: &[Vec<SeriesOf<S, N>>]) -> Option<Self> {
        let mut system = Self::planned(columns, core::iter::once(columns))?;
        for (column, entries) in columns.iter().enumerate() {
            for (row, entry) in entries.iter().enumerate() {
                system.set(row, column, *entry);
            }
        }
        system.factor_to(f64::INFINITY, 0.0).then_some(system)
    }

    /// The order of the elimination for the values of a matrix, by its columns, whose entries are those that are
    /// something in any of these samples, or change with a dimension. Its own entries are still zero.
    pub(super) fn planned<R: SinglePose, const M: usize>(
        columns: &[Vec<SeriesOf<S, N>>],
        samples: impl Iterator<Item: AsRef<[Vec<SeriesOf<R, M>>]>>,
    ) -> Option<Self> {
        let count = columns.len();
        let (mut is_entry, mut changes) = (vec![false; count * count], vec![false; count * count]);
        for sample in samples {
            for (column, entries) in sample.as_ref().iter().enumerate() {
                for (row, entry) in entries.iter().enumerate() {
                    let terms = entry.coefficients();
                    changes[row * count + column] |= terms[1..].iter().any(|term| term.real() != 0.0);
                    is_entry[row * count + column] |= terms[0].real() != 0.0;
                }
            }
        }
        for (column, entries) in columns.iter().enumerate() {
            for (row, entry) in entries.iter().enumerate() {
                let terms = entry.coefficients();
                changes[row * count + column] |= terms[1..].iter().any(|term| term.changes());
                is_entry[row * count + column] |= terms[0].changes();
            }
        }
        let mut slots = vec![NONE; count * count];
        let (mut own_columns, mut changing) = (Vec::new(), Vec::new());
        let mut next = 0;
        for place in 0..count * count {
            if is_entry[place] || changes[place] {
                slots[place] = next;
                next += 1;
                own_columns.push(place % count);
            }
            if changes[place] {
                changing.push(Coupling {
                    row: place / count,
                    column: place % count,
                    slot: slots[place] as usize,
                });
            }
        }
        let zero = S::constant(0.0);
        let mut system = Self {
            entries: vec![SeriesOf::constant(0.0); next as usize],
            columns: own_columns,
            changing,
            steps: Vec::new(),
            below: Vec::new(),
            beside: Vec::new(),
            backward: Vec::new(),
            targets: Vec::new(),
            factors: Vec::new(),
            reciprocals: vec![zero; count],
            largest: vec![zero; count],
            rest: vec![zero; count],
            known: vec![[zero; N]; count],
            solution: vec![SeriesOf::constant(0.0); count],
            slots: slots.clone(),
        };
        let mut values = vec![0.0; count * count];
        for (column, entries) in columns.iter().enumerate() {
            for (row, entry) in entries.iter().enumerate() {
                values[row * count + column] = entry.real();
            }
        }
        system.order(values, slots, next)?;
        Some(system)
    }

    /// Finds the order of the elimination.
    fn order(&mut self, mut values: Vec<f64>, mut slots: Vec<u32>, mut next: u32) -> Option<()> {
        let count = self.rest.len();
        let (mut rows, mut columns): (Vec<usize>, Vec<usize>) = ((0..count).collect(), (0..count).collect());
        while !rows.is_empty() {
            let mut best: Option<(usize, f64, usize, usize)> = None;
            for &column in &columns {
                let size = |row: &usize| values[row * count + column].abs();
                let largest = rows.iter().map(size).fold(0.0, f64::max);
                let is_entry = |row: usize, column: usize| usize::from(slots[row * count + column] != NONE);
                let below = rows.iter().map(|row| is_entry(*row, column)).sum::<usize>();
                for &row in rows
                    .iter()
                    .filter(|row| size(row) > 0.0 && size(row) >= SMALLEST_PART * largest)
                {
                    let beside = columns.iter().map(|column| is_entry(row, *column)).sum::<usize>();
                    let (cost, part) = ((below - 1) * (beside - 1), size(&row) / largest);
                    if best.is_none_or(|(least, larger, ..)| cost < least || cost == least && part > larger) {
                        best = Some((cost, part, row, column));
                    }
                }
            }
            let (_, _, row, column) = best?;
            rows.retain(|own| *own != row);
            columns.retain(|own| *own != column);
            let start = self.beside.len();
            for &other in &columns {
                if slots[row * count + other] != NONE {
                    self.beside.push(Coupling {
                        row,
                        column: other,
                        slot: slots[row * count + other] as usize,
                    });
                }
            }
            for &below in &rows {
                let place = below * count + column;
                if slots[place] == NONE {
                    continue;
                }
                self.below.push(Coupling {
                    row: below,
                    column,
                    slot: slots[place] as usize,
                });
                let multiplier = values[place] / values[row * count + column];
                for beside in &self.beside[start..] {
                    let target = below * count + beside.column;
                    if slots[target] == NONE {
                        slots[target] = next;
                        next += 1;
                    }
                    self.targets.push(slots[target] as usize);
                    values[target] -= multiplier * values[row * count + beside.column];
                }
            }
            self.steps.push(Step {
                row,
                column,
                pivot: slots[row * count + column] as usize,
                below_end: self.below.len(),
                beside_end: self.beside.len(),
            });
        }
        let (mut step_of_row, mut step_of_column) = (vec![0; count], vec![0; count]);
        for (index, step) in self.steps.iter().enumerate() {
            (step_of_row[step.row], step_of_column[step.column]) = (index, index);
        }
        self.backward.clone_from(&self.beside);
        for couplings in [&mut self.changing, &mut self.below, &mut self.backward] {
            for coupling in couplings {
                coupling.row = step_of_row[coupling.row];
                coupling.column = step_of_column[coupling.column];
            }
        }
        // what is found last is needed first
        self.backward
            .sort_by_key(|coupling| core::cmp::Reverse(coupling.column));
        self.factors = vec![S::constant(0.0); next as usize];
        Some(())
    }
}

impl<const N: usize> OrderedSystem<N> {
    /// The same order for numbers of another type, with the entries that are there.
    pub(super) fn in_numbers<S: PoseNumber>(&self) -> OrderedSystem<N, S> {
        let zero = S::constant(0.0);
        let entry = |entry: &Series<N>| SeriesOf::from_coefficients(entry.coefficients().map(S::constant));
        OrderedSystem {
            slots: self.slots.clone(),
            entries: self.entries.iter().map(entry).collect(),
            columns: self.columns.clone(),
            changing: self.changing.clone(),
            steps: self.steps.clone(),
            below: self.below.clone(),
            beside: self.beside.clone(),
            backward: self.backward.clone(),
            targets: self.targets.clone(),
            factors: vec![zero; self.factors.len()],
            reciprocals: vec![zero; self.reciprocals.len()],
            largest: vec![zero; self.largest.len()],
            rest: vec![zero; self.rest.len()],
            known: vec![[zero; N]; self.known.len()],
            solution: vec![SeriesOf::constant(0.0); self.solution.len()],
        }
    }
}

impl<S: PoseNumber, const N: usize> OrderedSystem<N, S> {
    /// Replaces an entry. False if it is none of those that were planned.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn set(&mut self, row: usize, column: usize, entry: SeriesOf<S, N>) -> bool {
        let slot = self.slots[row * self.rest.len() + column];
        if slot == NONE {
            let is_zero = |term: S| !term.exceeds(0.0, S::constant(0.0)) && !term.real().is_nan() && !term.changes();
            return entry.coefficients().into_iter().all(is_zero);
        }
        self.entries[slot as usize] = entry;
        true
    }

    /// Finds the factors. False if the order of the elimination is not right for these entries.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn factor(&mut self) -> bool {
        self.factor_to(LARGEST_MULTIPLIER, SMALLEST_PIVOT)
    }

    #[inline(never)]
    fn factor_to(&mut self, multipliers: f64, pivots: f64) -> bool {
        self.largest.fill(S::constant(0.0));
        for ((entry, column), factor) in self.entries.iter().zip(&self.columns).zip(&mut self.factors) {
            *factor = entry.now();
            let largest = &mut self.largest[*column];
            *largest = largest.or_larger(factor.size());
        }
        let factors = &mut self.factors[..];
        factors[self.entries.len()..].fill(S::constant(0.0));
        let mut targets = self.targets.iter();
        let (mut below, mut beside) = (&self.below[..], &self.beside[..]);
        let (mut below_start, mut beside_start) = (0, 0);
        for (step, reciprocal) in self.steps.iter().zip(&mut self.reciprocals) {
            let pivot = factors[step.pivot];
            // neither zero nor not a number
            if !pivot.exceeds(pivots, self.largest[step.column]) || !pivot.is_finite() {
                return false;
            }
            *reciprocal = S::constant(1.0) / pivot;
            let (own_below, own_beside);
            (own_below, below) = below.split_at(step.below_end - below_start);
            (own_beside, beside) = beside.split_at(step.beside_end - beside_start);
            (below_start, beside_start) = (step.below_end, step.beside_end);
            for row in own_below {
                let multiplier = factors[row.slot] * *reciprocal;
                if multiplier.exceeds(multipliers, S::constant(1.0)) {
                    return false;
                }
                factors[row.slot] = multiplier;
                for (entry, target) in own_beside.iter().zip(&mut targets) {
                    factors[*target] = factors[*target] - multiplier * factors[entry.slot];
                }
            }
            for entry in own_beside {
                factors[entry.slot] = factors[entry.slot] * *reciprocal;
            }
        }
        true
    }

    /// The solution for a right-hand side.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn solve(&mut self, right: &[SeriesOf<S, N>]) -> &[SeriesOf<S, N>] {
        let (factors, rest, known) = (&self.factors[..], &mut self.rest[..], &mut self.known[..]);
        for order in 0..N {
            for (rest, step) in rest.iter_mut().zip(&self.steps) {
                *rest = right[step.row].coefficients()[order];
            }
            if order > 0 {
                for Coupling { row, column, slot } in &self.changing {
                    let (entry, known) = (self.entries[*slot].coefficients(), &known[*column]);
                    for power in 1..=order {
                        rest[*row] = rest[*row] - entry[power] * known[order - power];
                    }
                }
            }
            for Coupling { row, column, slot } in &self.below {
                rest[*row] = rest[*row] - factors[*slot] * rest[*column];
            }
            for (rest, reciprocal) in rest.iter_mut().zip(&self.reciprocals) {
                *rest = *rest * *reciprocal;
            }
            for Coupling { row, column, slot } in &self.backward {
                rest[*row] = rest[*row] - factors[*slot] * rest[*column];
            }
            for (known, rest) in known.iter_mut().zip(&*rest) {
                known[order] = *rest;
            }
        }
        for (known, step) in known.iter().zip(&self.steps) {
            self.solution[step.column] = SeriesOf::from_coefficients(*known);
        }
        &self.solution
    }
}

#[cfg(test)]
mod tests {
    use std::vec;
    use std::vec::Vec;

    use super::OrderedSystem;
    use crate::number::Number as _;
    use crate::number::series::Series;
    use crate::verify::Random;

    #[test]
    fn the_solution_gives_the_right_side() {
        let mut random = Random::new(5);
        for count in 1..6 {
            let mut series =
                |size: f64| Series::<6>::from_coefficients(core::array::from_fn(|_| random.between(-size, size)));
            let mut columns: Vec<Vec<_>> = (0..count).map(|_| (0..count).map(|_| series(1.0)).collect()).collect();
            for (index, column) in columns.iter_mut().enumerate() {
                column[index] = column[index] + Series::constant(8.0);
            }
            let right: Vec<_> = (0..count).map(|_| series(3.0)).collect();
            let mut system = OrderedSystem::of(&columns).expect("it is regular");
            let mut sums = vec![Series::ZERO; count];
            for (column, value) in columns.iter().zip(system.solve(&right)) {
                for (sum, entry) in sums.iter_mut().zip(column) {
                    *sum = *sum + *entry * *value;
                }
            }
            for (sum, right) in sums.iter().zip(&right) {
                for (sum, right) in sum.coefficients().into_iter().zip(right.coefficients()) {
                    assert!((sum - right).abs() < 1e-13, "{sum} {right}");
                }
            }
        }
    }

    #[test]
    fn an_order_is_taken_over() {
        let one = Series::<2>::constant(1.0);
        let matrix = |entry: f64| {
            vec![
                vec![Series::from_coefficients([entry, 1.0]), one],
                vec![one, Series::ZERO],
            ]
        };
        let mut system =
            OrderedSystem::planned(&matrix(2.0), [matrix(2.0), matrix(0.0)].iter()).expect("it is regular");
        let mut fill = |entries: [[f64; 2]; 2]| {
            let places = [0, 1].into_iter().flat_map(|row| [0, 1].map(|column| (row, column)));
            let fits = places.fold(true, |fits, (row, column)| {
                system.set(row, column, Series::constant(entries[column][row])) && fits
            });
            fits && system.factor()
        };
        // a zero among the entries that change is one that others have
        assert!(fill([[0.0, 1.0], [1.0, 0.0]]));
        assert!(!fill([[1.0, 1.0], [1.0, 3.0]]), "an entry that was not planned");
        assert!(!fill([[1.0, 1.0], [0.0, 0.0]]), "a column of zeros");
        assert!(!fill([[f64::NAN, f64::NAN], [1.0, 0.0]]), "no numbers");
    }
}
