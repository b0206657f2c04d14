//! Common subexpressions of sums and products: pairs that occur more than once are computed once.
//!
//! The greedy extraction of two-term divisors, most frequent first (R. K. Brayton and C. `McMullen`, "The decomposition
//! and factorization of Boolean expressions", ISCAS 1982, in its common form for arithmetic expressions).

use std::collections::BTreeMap;

use super::rows::{Row, RowId, Rows};

/// Two factors, or two terms and whether their signs differ.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
enum Pair {
    Product(RowId, RowId),
    Sum(RowId, RowId, bool),
}

/// Rewrites the rows until no pair occurs twice.
pub(super) fn share(rows: &mut Rows) {
    loop {
        let mut occurrences: BTreeMap<Pair, Vec<usize>> = BTreeMap::new();
        for (index, row) in rows.list.iter().enumerate() {
            for (pair, count) in pairs(row) {
                occurrences.entry(pair).or_default().extend((0..count).map(|_| index));
            }
        }
        let mut candidates: Vec<(Pair, Vec<usize>)> =
            occurrences.into_iter().filter(|(_, places)| places.len() > 1).collect();
        candidates.sort_by_key(|(pair, places)| (std::cmp::Reverse(places.len()), *pair));
        let mut changed = false;
        for (pair, mut places) in candidates {
            places.dedup();
            // earlier replacements may have used up what this pair needs
            let current: usize = places.iter().map(|&place| count_in(&rows.list[place], pair)).sum();
            if current < 2 {
                continue;
            }
            let replacement = rows.intern(match pair {
                Pair::Product(a, b) => Row::Product(vec![a, b]),
                Pair::Sum(a, b, opposite) => Row::Sum(vec![(false, a), (opposite, b)]),
            });
            for place in places {
                if RowId(place) != replacement {
                    changed |= replace(&mut rows.list[place], pair, replacement);
                }
            }
        }
        if !changed {
            return;
        }
    }
}

fn count_in(row: &Row, pair: Pair) -> usize {
    pairs(row)
        .into_iter()
        .find(|&(own, _)| own == pair)
        .map_or(0, |(_, count)| count)
}

/// The pairs in a row, and how often each can be taken out.
fn pairs(row: &Row) -> Vec<(Pair, usize)> {
    let mut found: BTreeMap<Pair, usize> = BTreeMap::new();
    match row {
        Row::Product(factors) => {
            let mut powers: BTreeMap<RowId, usize> = BTreeMap::new();
            for &factor in factors {
                *powers.entry(factor).or_insert(0) += 1;
            }
            let powers: Vec<(RowId, usize)> = powers.into_iter().collect();
            for (index, &(a, power)) in powers.iter().enumerate() {
                if power > 1 {
                    found.insert(Pair::Product(a, a), power / 2);
                }
                for &(b, other) in &powers[index + 1..] {
                    found.insert(Pair::Product(a, b), power.min(other));
                }
            }
        }
        Row::Sum(terms) => {
            for (index, &(negative, a)) in terms.iter().enumerate() {
                for &(other_negative, b) in &terms[index + 1..] {
                    if a != b {
                        let pair = Pair::Sum(a.min(b), a.max(b), negative != other_negative);
                        *found.entry(pair).or_insert(0) += 1;
                    }
                }
            }
        }
        _ => {}
    }
    found.into_iter().collect()
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
