//! Common subexpressions of sums and products: pairs that occur more than once are computed once.
//!
//! The greedy extraction of two-term divisors, most frequent first (R. K. Brayton and C. `McMullen`, "The decomposition
//! and factorization of Boolean expressions", ISCAS 1982, in its common form for arithmetic expressions).

use std::collections::{BTreeMap, BTreeSet};
use std::mem;

use super::rows::{Row, RowId, Rows};
use crate::expr::HashMap;
use crate::passes::Pass;

/// Two factors, or two terms and whether their signs differ.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
enum Pair {
    Product(RowId, RowId),
    Sum(RowId, RowId, bool),
}

/// Where each pair occurs. Only rows that change are looked at again.
#[derive(Default)]
struct Occurrences {
    /// The rows, ascending, and how often each has the pair.
    places: HashMap<Pair, Vec<(usize, usize)>>,
    /// The pairs of each row.
    pairs: Vec<Vec<(Pair, usize)>>,
}

impl Occurrences {
    /// Takes note of what a row has become.
    fn update(&mut self, index: usize, row: &Row) {
        if self.pairs.len() <= index {
            self.pairs.resize_with(index + 1, Vec::new);
        }
        let own = pairs(row);
        for (pair, _) in mem::replace(&mut self.pairs[index], own) {
            if let Some(places) = self.places.get_mut(&pair) {
                places.retain(|&(place, _)| place != index);
            }
        }
        for &(pair, count) in &self.pairs[index] {
            let places = self.places.entry(pair).or_default();
            let position = places.partition_point(|&(place, _)| place < index);
            places.insert(position, (index, count));
        }
    }

    /// The pairs that occur more than once, the most frequent first.
    fn candidates(&self) -> Vec<Pair> {
        let mut candidates: Vec<(usize, Pair)> = self
            .places
            .iter()
            .map(|(&pair, places)| (places.iter().map(|&(_, count)| count).sum(), pair))
            .filter(|&(count, _)| count > 1)
            .collect();
        // in full, so that the order in which the table was read does not matter
        candidates.sort_unstable_by_key(|&(count, pair)| (std::cmp::Reverse(count), pair));
        candidates.into_iter().map(|(_, pair)| pair).collect()
    }
}

/// Rewrites the rows until no pair occurs twice.
pub(super) fn share(rows: &mut Rows) {
    if !rows.style.passes.include(Pass::SharedPairs) {
        return;
    }
    let mut occurrences = Occurrences::default();
    let mut changed: BTreeSet<usize> = (0..rows.list.len()).collect();
    while !changed.is_empty() {
        for index in mem::take(&mut changed) {
            occurrences.update(index, &rows.list[index]);
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
            if replacement.0 >= occurrences.pairs.len() {
                changed.insert(replacement.0);
            }
            for &(place, _) in places {
                if RowId(place) != replacement && replace(&mut rows.list[place], pair, replacement) {
                    changed.insert(place);
                }
            }
        }
    }
}

fn count_in(row: &Row, pair: Pair) -> usize {
    match (row, pair) {
        (Row::Product(factors), Pair::Product(a, b)) => {
            let count = |wanted: RowId| factors.iter().filter(|&&factor| factor == wanted).count();
            if a == b { count(a) / 2 } else { count(a).min(count(b)) }
        }
        (Row::Sum(terms), Pair::Sum(a, b, opposite)) => {
            let signs = |wanted: RowId| terms.iter().filter(move |&&(_, term)| term == wanted);
            signs(a)
                .map(|first| signs(b).filter(|second| (first.0 != second.0) == opposite).count())
                .sum()
        }
        _ => 0,
    }
}

/// The pairs in a row, and how often each can be taken out.
fn pairs(row: &Row) -> Vec<(Pair, usize)> {
    let mut found = Vec::new();
    match row {
        Row::Product(factors) => {
            let powers: Vec<(RowId, usize)> = factors
                .chunk_by(|a, b| a == b)
                .map(|power| (power[0], power.len()))
                .collect();
            for (index, &(a, power)) in powers.iter().enumerate() {
                if power > 1 {
                    found.push((Pair::Product(a, a), power / 2));
                }
                for &(b, other) in &powers[index + 1..] {
                    found.push((Pair::Product(a, b), power.min(other)));
                }
            }
        }
        Row::Sum(terms) => {
            let mut counts: BTreeMap<Pair, usize> = BTreeMap::new();
            for (index, &(negative, a)) in terms.iter().enumerate() {
                for &(other_negative, b) in &terms[index + 1..] {
                    if a != b {
                        let pair = Pair::Sum(a.min(b), a.max(b), negative != other_negative);
                        *counts.entry(pair).or_insert(0) += 1;
                    }
                }
            }
            found.extend(counts);
        }
        _ => {}
    }
    found
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
