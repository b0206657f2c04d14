//! Common subexpressions of sums and products: pairs that occur more than once are computed once.
//!
//! This is the greedy extraction of two-term divisors, most frequent first (R. K. Brayton and C. `McMullen`, "The
//! decomposition and factorization of Boolean expressions", ISCAS 1982, in its common form for arithmetic expressions).
//!
//! An element that occurs only once is in no pair that occurs twice. So only pairs of other elements are counted, and
//! only pairs with changed elements are counted again. The work follows the number of elements that can be shared.

use std::cmp::Reverse;
use std::collections::BTreeSet;
use std::mem;

use super::lines::{Line, LineId, Lines};
use crate::algebra::{HashMap, IndexTable};
use crate::passes::Pass;
use crate::work;

/// Two factors, or two terms and whether their signs differ.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
enum Pair {
    Product(LineId, LineId),
    Sum(LineId, LineId, bool),
}

/// The number of occurrences of a term in a line, by sign. Factors have no sign.
type Multiplicity = [usize; 2];

/// An element of a line, and whether the line is a sum: terms of sums and factors of products are never shared with
/// each other.
type LineMember = (bool, LineId);

/// The elements of a line, each as often as it occurs, and whether they are negative terms.
fn elements(line: &Line) -> Vec<(LineId, bool)> {
    match line {
        Line::Product(factors) => factors.iter().map(|&factor| (factor, false)).collect(),
        Line::Sum(terms) => terms.iter().map(|&(negative, term)| (term, negative)).collect(),
        _ => Vec::new(),
    }
}

/// Elements that occur more than once, and for each other element the only line that contains it.
#[derive(Default)]
struct Recurring {
    factors: Occurring,
    terms: Occurring,
}

/// The recurring elements of products, or of sums, and the line that contains each other element.
#[derive(Default)]
struct Occurring {
    recurring: IndexTable<LineId, ()>,
    only: IndexTable<LineId, usize>,
}

impl Recurring {
    fn of(lines: &[Line]) -> Self {
        let mut repeated = Self::default();
        for (index, line) in lines.iter().enumerate() {
            let is_sum = matches!(line, Line::Sum(_));
            for (id, _) in elements(line) {
                let known = repeated.of_kind_mut(is_sum);
                if known.only.get(id).is_some() {
                    known.recurring.insert(id, ());
                }
                known.only.insert(id, index);
            }
        }
        repeated
    }

    fn of_kind_mut(&mut self, is_sum: bool) -> &mut Occurring {
        if is_sum { &mut self.terms } else { &mut self.factors }
    }

    fn contain(&self, (is_sum, id): LineMember) -> bool {
        let known = if is_sum { &self.terms } else { &self.factors };
        known.recurring.get(id).is_some()
    }

    /// Records that an element now occurs more than once. If this is new, the line that contained it is returned.
    fn add(&mut self, (is_sum, id): LineMember) -> Option<usize> {
        let known = self.of_kind_mut(is_sum);
        if known.recurring.get(id).is_some() {
            return None;
        }
        known.recurring.insert(id, ());
        known.only.get(id)
    }
}

/// The elements of a line that occur more than once, ascending.
type Elements = Vec<(LineId, Multiplicity)>;

/// The elements of a line that occur more than once.
fn repeated_elements(line: &Line, repeated: &Recurring) -> Elements {
    let is_sum = matches!(line, Line::Sum(_));
    let mut elements = elements(line);
    elements.retain(|&(id, _)| repeated.contain((is_sum, id)));
    elements.sort_unstable();
    let mut counts = Elements::new();
    for (id, negative) in elements {
        if counts.last().is_none_or(|&(last, _)| last != id) {
            counts.push((id, [0; 2]));
        }
        if let Some((_, count)) = counts.last_mut() {
            count[usize::from(negative)] += 1;
        }
    }
    counts
}

/// An element of a line, with its number of occurrences before and after a change.
#[derive(Clone, Copy)]
struct Recount {
    id: LineId,
    before: Multiplicity,
    after: Multiplicity,
}

/// The elements of a line before or after a change, with their counts: those that change, and then the others.
fn changes(mut before: &[(LineId, Multiplicity)], mut after: &[(LineId, Multiplicity)]) -> [Vec<Recount>; 2] {
    let (mut changed, mut unchanged) = (Vec::new(), Vec::new());
    loop {
        let recount = match (before, after) {
            ([], []) => return [changed, unchanged],
            (&[(id, count), ref rest @ ..], others) if others.first().is_none_or(|&(other, _)| id < other) => {
                before = rest;
                Recount {
                    id,
                    before: count,
                    after: [0; 2],
                }
            }
            (others, &[(id, count), ref rest @ ..]) if others.first().is_none_or(|&(other, _)| id < other) => {
                after = rest;
                Recount {
                    id,
                    before: [0; 2],
                    after: count,
                }
            }
            (one, other) => {
                (before, after) = (&one[1..], &other[1..]);
                Recount {
                    id: one[0].0,
                    before: one[0].1,
                    after: other[0].1,
                }
            }
        };
        if recount.before == recount.after {
            unchanged.push(recount);
        } else {
            changed.push(recount);
        }
    }
}

impl Pair {
    /// The pairs that two elements of a line can form. An element can form a pair with itself.
    fn of(is_sum: bool, one: LineId, other: LineId) -> impl Iterator<Item = Self> {
        let (a, b) = (one.min(other), one.max(other));
        let pairs = if is_sum {
            [false, true].map(|opposite| (a != b).then_some(Self::Sum(a, b, opposite)))
        } else {
            [Some(Self::Product(a, b)), None]
        };
        pairs.into_iter().flatten()
    }

    /// The number of times that the pair can be taken out of a line, given the multiplicity of its elements.
    const fn times(self, [p, m]: Multiplicity, [q, n]: Multiplicity) -> usize {
        match self {
            Self::Product(a, b) if a.0 == b.0 => p / 2,
            Self::Product(..) if p < q => p,
            Self::Product(..) => q,
            Self::Sum(_, _, true) => p * n + m * q,
            Self::Sum(_, _, false) => p * q + m * n,
        }
    }
}

/// The occurrences of each pair. Only changed elements are counted again.
#[derive(Default)]
struct Occurrences {
    /// The lines that contain each pair, ascending, with the number of times.
    lines_of_pair: HashMap<Pair, Vec<(usize, usize)>>,
    /// The elements of each line.
    elements: Vec<Elements>,
    /// The pairs that occur in more lines, or more often, than before, perhaps several times.
    grown: Vec<Pair>,
}

impl Occurrences {
    /// Records the new state of a line.
    fn update(&mut self, index: usize, line: &Line, repeated: &Recurring) {
        if self.elements.len() <= index {
            self.elements.resize_with(index + 1, Elements::new);
        }
        let after = repeated_elements(line, repeated);
        let before = mem::replace(&mut self.elements[index], after);
        let is_sum = matches!(line, Line::Sum(_));
        let [changed, unchanged] = changes(&before, &self.elements[index]);
        for (position, one) in changed.iter().enumerate() {
            for other in changed[position..].iter().chain(&unchanged) {
                work::iteration();
                for pair in Pair::of(is_sum, one.id, other.id) {
                    let after = pair.times(one.after, other.after);
                    if pair.times(one.before, other.before) != after {
                        self.set(pair, index, after);
                    }
                }
            }
        }
    }

    fn set(&mut self, pair: Pair, index: usize, count: usize) {
        let lines_of_pair = self.lines_of_pair.entry(pair).or_default();
        match (lines_of_pair.binary_search_by_key(&index, |&(line, _)| line), count) {
            (Ok(position), 0) => drop(lines_of_pair.remove(position)),
            (Err(_), 0) => {}
            (Ok(position), _) => lines_of_pair[position].1 = count,
            (Err(position), _) => lines_of_pair.insert(position, (index, count)),
        }
        if count > 0 {
            self.grown.push(pair);
        }
    }

    /// The pairs that occur more than once and have not been examined since, the most frequent first.
    fn candidates(&mut self) -> Vec<Pair> {
        let mut candidates: Vec<(usize, Pair)> = mem::take(&mut self.grown)
            .into_iter()
            .map(|pair| (self.lines_of_pair[&pair].iter().map(|&(_, count)| count).sum(), pair))
            .filter(|&(count, _)| count > 1)
            .collect();
        candidates.sort_unstable_by_key(|&(count, pair)| (Reverse(count), pair));
        candidates.dedup();
        candidates.into_iter().map(|(_, pair)| pair).collect()
    }
}

/// Rewrites the lines until no pair occurs twice.
pub(super) fn share(lines: &mut Lines) {
    if !lines.style.passes.include(Pass::SharedPairs) {
        return;
    }
    let mut occurrences = Occurrences::default();
    let mut repeated = Recurring::of(&lines.list);
    let mut changed: BTreeSet<usize> = (0..lines.list.len()).collect();
    while !changed.is_empty() && !work::is_spent() {
        for index in mem::take(&mut changed) {
            occurrences.update(index, &lines.list[index], &repeated);
        }
        for pair in occurrences.candidates() {
            let lines_of_pair = &occurrences.lines_of_pair[&pair];
            // earlier replacements may have used up elements of this pair
            let current: usize = lines_of_pair
                .iter()
                .map(|&(line, _)| count_in(&lines.list[line], pair))
                .sum();
            if current < 2 {
                continue;
            }
            let replacement = lines.intern(match pair {
                Pair::Product(a, b) => Line::Product(vec![a, b]),
                Pair::Sum(a, b, opposite) => Line::Sum(vec![(false, a), (opposite, b)]),
            });
            if replacement.0 >= occurrences.elements.len() {
                changed.insert(replacement.0);
            }
            changed.extend(repeated.add((matches!(pair, Pair::Sum(..)), replacement)));
            for &(line, _) in lines_of_pair {
                if LineId(line) != replacement && replace(&mut lines.list[line], pair, replacement) {
                    changed.insert(line);
                }
            }
        }
    }
}

/// The number of times that a pair can be taken out of a line.
fn count_in(line: &Line, pair: Pair) -> usize {
    match (line, pair) {
        (Line::Product(factors), Pair::Product(a, b)) => {
            let count = |id: LineId| [factors.iter().filter(|&&factor| factor == id).count(), 0];
            pair.times(count(a), count(b))
        }
        (Line::Sum(terms), Pair::Sum(a, b, _)) => {
            let count =
                |id: LineId| [false, true].map(|negative| terms.iter().filter(|&&term| term == (negative, id)).count());
            pair.times(count(a), count(b))
        }
        _ => 0,
    }
}

/// Replaces a pair by `replacement`, as often as it occurs. Returns whether it occurred.
fn replace(line: &mut Line, pair: Pair, replacement: LineId) -> bool {
    let mut changed = false;
    match (line, pair) {
        (Line::Product(factors), Pair::Product(a, b)) => {
            while let Some(first) = factors.iter().position(|&factor| factor == a) {
                let Some(second) = (0..factors.len()).find(|&index| index != first && factors[index] == b) else {
                    break;
                };
                factors.remove(first.max(second));
                factors.remove(first.min(second));
                factors.push(replacement);
                factors.sort_unstable();
                changed = true;
            }
        }
        (Line::Sum(terms), Pair::Sum(a, b, opposite)) => {
            let find = |terms: &[(bool, LineId)], wanted: LineId| terms.iter().position(|&(_, term)| term == wanted);
            if let (Some(first), Some(second)) = (find(terms, a), find(terms, b))
                && (terms[first].0 != terms[second].0) == opposite
            {
                let negative = terms[first].0;
                terms[first.min(second)] = (negative, replacement);
                terms.remove(first.max(second));
                changed = true;
            }
        }
        _ => {}
    }
    changed
}
