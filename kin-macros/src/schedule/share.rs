//! Common subexpressions of sums and products: pairs that occur more than once are computed once.
//!
//! The greedy extraction of two-term divisors, most frequent first (R. K. Brayton and C. `McMullen`, "The decomposition
//! and factorization of Boolean expressions", ISCAS 1982, in its common form for arithmetic expressions).
//!
//! An element that occurs only once is in no pair that occurs twice. Only pairs of other elements are counted, and only those
//! whose elements have changed are counted again, so the work follows the length of what can be shared.

use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};
use std::mem;

use super::rows::{Row, RowId, Rows};
use crate::algebra::HashMap;
use crate::passes::Pass;
use crate::work;

/// Two factors, or two terms and whether their signs differ.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
enum Pair {
    Product(RowId, RowId),
    Sum(RowId, RowId, bool),
}

/// How often a term stands in a row with each sign; a factor has no sign.
type Multiplicity = [usize; 2];

/// Whether a row is a sum, and an element of it: a term is nothing to products, nor a factor to sums.
type Element = (bool, RowId);

/// The elements of a row, each as often as it stands there.
fn elements(row: &Row) -> Vec<(RowId, bool)> {
    match row {
        Row::Product(factors) => factors.iter().map(|&factor| (factor, false)).collect(),
        Row::Sum(terms) => terms.iter().map(|&(negative, term)| (term, negative)).collect(),
        _ => Vec::new(),
    }
}

/// Elements that occur more than once, and for all others the only row that they stand in.
struct Repeated {
    elements: HashMap<Element, usize>,
    only: HashMap<Element, usize>,
}

impl Repeated {
    fn of(rows: &[Row]) -> Self {
        let mut repeated = Self {
            elements: HashMap::default(),
            only: HashMap::default(),
        };
        for (index, row) in rows.iter().enumerate() {
            for (id, _) in elements(row) {
                let element = (matches!(row, Row::Sum(_)), id);
                if let Some(first) = repeated.only.insert(element, index) {
                    repeated.elements.insert(element, first);
                }
            }
        }
        repeated
    }

    fn contain(&self, element: Element) -> bool {
        self.elements.contains_key(&element)
    }

    /// Takes note that an element now occurs more than once. If it did not before, the row that it stood in is handed back.
    fn add(&mut self, element: Element) -> Option<usize> {
        let is_new = self.elements.insert(element, 0).is_none();
        is_new.then(|| self.only.get(&element).copied()).flatten()
    }
}

/// The terms or factors of a row, of those that occur more than once, ascending.
type Elements = Vec<(RowId, Multiplicity)>;

/// The elements of a row that occur more than once.
fn repeated_elements(row: &Row, repeated: &Repeated) -> Elements {
    let is_sum = matches!(row, Row::Sum(_));
    let mut counts: BTreeMap<RowId, Multiplicity> = BTreeMap::new();
    for (id, negative) in elements(row) {
        if repeated.contain((is_sum, id)) {
            counts.entry(id).or_default()[usize::from(negative)] += 1;
        }
    }
    counts.into_iter().collect()
}

/// An element of a row, and how often it stands there before and after a change.
#[derive(Clone, Copy)]
struct Change {
    id: RowId,
    before: Multiplicity,
    after: Multiplicity,
}

/// The elements that a row has before or after a change.
fn changes(before: &Elements, after: &Elements) -> Vec<Change> {
    let mut all: BTreeMap<RowId, [Multiplicity; 2]> = BTreeMap::new();
    for (place, elements) in [before, after].into_iter().enumerate() {
        for &(id, count) in elements {
            all.entry(id).or_default()[place] = count;
        }
    }
    all.into_iter()
        .map(|(id, [before, after])| Change { id, before, after })
        .collect()
}

impl Pair {
    /// The pairs that two different elements of a row may form, or one with itself.
    fn of(is_sum: bool, one: RowId, other: RowId) -> impl Iterator<Item = Self> {
        let (a, b) = (one.min(other), one.max(other));
        let pairs = if is_sum {
            [false, true].map(|opposite| (a != b).then_some(Self::Sum(a, b, opposite)))
        } else {
            [Some(Self::Product(a, b)), None]
        };
        pairs.into_iter().flatten()
    }

    /// How often the pair can be taken out of a row that has its elements as often as given.
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

/// Where each pair occurs. Only elements that change are looked at again.
#[derive(Default)]
struct Occurrences {
    /// The rows, ascending, and how often each has the pair.
    places: HashMap<Pair, Vec<(usize, usize)>>,
    /// The elements of each row.
    elements: Vec<Elements>,
    /// The pairs that occur in more rows, or more often, than before.
    grown: BTreeSet<Pair>,
}

impl Occurrences {
    /// Takes note of what a row has become.
    fn update(&mut self, index: usize, row: &Row, repeated: &Repeated) {
        if self.elements.len() <= index {
            self.elements.resize_with(index + 1, Elements::new);
        }
        let after = repeated_elements(row, repeated);
        let before = mem::replace(&mut self.elements[index], after);
        let is_sum = matches!(row, Row::Sum(_));
        let (changed, unchanged): (Vec<_>, Vec<_>) = changes(&before, &self.elements[index])
            .into_iter()
            .partition(|change| change.before != change.after);
        for (position, one) in changed.iter().enumerate() {
            for other in changed[position..].iter().chain(&unchanged) {
                work::turn();
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
        let places = self.places.entry(pair).or_default();
        match (places.binary_search_by_key(&index, |&(place, _)| place), count) {
            (Ok(position), 0) => drop(places.remove(position)),
            (Err(_), 0) => {}
            (Ok(position), _) => places[position].1 = count,
            (Err(position), _) => places.insert(position, (index, count)),
        }
        if count > 0 {
            self.grown.insert(pair);
        }
    }

    /// The pairs that occur more than once and have not been looked at since they did, the most frequent first.
    fn candidates(&mut self) -> Vec<Pair> {
        let mut candidates: Vec<(usize, Pair)> = mem::take(&mut self.grown)
            .into_iter()
            .map(|pair| (self.places[&pair].iter().map(|&(_, count)| count).sum(), pair))
            .filter(|&(count, _)| count > 1)
            .collect();
        candidates.sort_unstable_by_key(|&(count, pair)| (Reverse(count), pair));
        candidates.into_iter().map(|(_, pair)| pair).collect()
    }
}

/// Rewrites the rows until no pair occurs twice.
pub(super) fn share(rows: &mut Rows) {
    if !rows.style.passes.include(Pass::SharedPairs) {
        return;
    }
    let mut occurrences = Occurrences::default();
    let mut repeated = Repeated::of(&rows.list);
    let mut changed: BTreeSet<usize> = (0..rows.list.len()).collect();
    while !changed.is_empty() {
        for index in mem::take(&mut changed) {
            occurrences.update(index, &rows.list[index], &repeated);
        }
        for pair in occurrences.candidates() {
            let places = &occurrences.places[&pair];
            // earlier replacements may have used up what this pair needs
            let current: usize = places.iter().map(|&(place, _)| count_in(&rows.list[place], pair)).sum();
            if current < 2 {
                continue;
            }
            let replacement = rows.intern(match pair {
                Pair::Product(a, b) => Row::Product(vec![a, b]),
                Pair::Sum(a, b, opposite) => Row::Sum(vec![(false, a), (opposite, b)]),
            });
            if replacement.0 >= occurrences.elements.len() {
                changed.insert(replacement.0);
            }
            changed.extend(repeated.add((matches!(pair, Pair::Sum(..)), replacement)));
            for &(place, _) in places {
                if RowId(place) != replacement && replace(&mut rows.list[place], pair, replacement) {
                    changed.insert(place);
                }
            }
        }
    }
}

/// How often a pair can be taken out of a row.
fn count_in(row: &Row, pair: Pair) -> usize {
    match (row, pair) {
        (Row::Product(factors), Pair::Product(a, b)) => {
            let count = |id: RowId| [factors.iter().filter(|&&factor| factor == id).count(), 0];
            pair.times(count(a), count(b))
        }
        (Row::Sum(terms), Pair::Sum(a, b, _)) => {
            let count =
                |id: RowId| [false, true].map(|negative| terms.iter().filter(|&&term| term == (negative, id)).count());
            pair.times(count(a), count(b))
        }
        _ => 0,
    }
}

/// Puts `replacement` in the place of a pair, as often as it occurs.
fn replace(row: &mut Row, pair: Pair, replacement: RowId) -> bool {
    let mut changed = false;
    match (row, pair) {
        (Row::Product(factors), Pair::Product(a, b)) => {
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
        (Row::Sum(terms), Pair::Sum(a, b, opposite)) => {
            let find = |terms: &[(bool, RowId)], wanted: RowId| terms.iter().position(|&(_, term)| term == wanted);
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
