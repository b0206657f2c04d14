//! The loads of Coulomb friction, which depend on forces that they change.
//!
//! With the friction f of all contacts, the force in one of them has parts that are linear in f, and its own friction
//! is a measure of them: f = |b + C f|. Two facts make this solvable with certainty. The measures change by no more
//! than their parts, so the matrix of the sizes of C bounds the whole right side: if its spectral radius is below one,
//! the right side is a contraction, and there is one solution. (The bound is that of Collatz and Wielandt: R. S. Varga,
//! *Matrix Iterative Analysis*, 2nd edition, Springer 2000, section 2.1.) And measures are homogeneous, so that
//! Newton's method is a linear system in which the direction of each force stands.

use alloc::vec;
use alloc::vec::Vec;

use super::pose_number::SinglePose;
use crate::number::series::SeriesOf;
use crate::number::{Number, shifted};
use crate::solve::{FactorRow, Scalar, factor_in, substitute_in};

/// How the parts of the force in a contact become its friction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Measure {
    /// The length of the vector of the parts.
    Length,
    /// The size of the largest part.
    Largest,
}

/// A contact: the parts of its force, each times its coefficient.
#[derive(Clone, Debug)]
pub(super) struct Contact<T> {
    pub(super) measure: Measure,
    /// The parts without friction.
    pub(super) bare: Vec<T>,
    /// What a unit of the friction of each contact adds to them.
    pub(super) changes: Vec<Vec<T>>,
}

/// The friction of all contacts.
#[derive(Clone, Debug)]
pub(super) struct FrictionLoads<const N: usize, S = f64> {
    pub(super) loads: Vec<SeriesOf<S, N>>,
    /// The factor by which the right side contracts; from one on, it is not known to.
    pub(super) contraction: f64,
}

/// Why there is no friction that belongs to the forces without it.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Unsolved {
    /// As friction grows from nothing, its solution ends at this share of it, and these contacts have the largest loads
    /// there.
    Locked { share: f64, contacts: Vec<usize> },
    /// The iteration has not converged.
    Slow { steps: usize, contraction: f64 },
}

/// The most steps of the iteration. From a contraction of 0.9 on, it would need more without Newton's method.
const STEPS: usize = 200;
/// The most steps by which friction grows from nothing, each with so many of Newton's method.
const SHARES: usize = 400;
const CORRECTIONS: usize = 20;
/// The change of the loads in a step, as a part of them.
const CHANGE: f64 = 0.25;
/// The shortest step of the share.
const SHORTEST: f64 = 1e-10;
/// The rounding of a measure, as a part of the sum of the sizes of its terms.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// The friction of contacts. On the left side of a place, `parity` is -1: odd powers of the variable are negative
/// there.
pub(super) fn solve<S: SinglePose, const N: usize>(
    contacts: &[Contact<SeriesOf<S, N>>],
    parity: f64,
) -> Result<FrictionLoads<N, S>, Unsolved> {
    let reals: Vec<Contact<f64>> = contacts.iter().map(real).collect();
    let (contraction, weights) = contraction(&reals);
    let system = System {
        contacts: &reals,
        weights: &weights,
    };
    let values = if contraction < 1.0 {
        system.contracted(contraction)?
    } else {
        system.grown(contraction)?
    };
    let mut loads: Vec<SeriesOf<S, N>> = values.into_iter().map(SeriesOf::constant).collect();
    // A pass doubles the orders that are right, or adds one where a force passes through zero. A derivative with
    // respect to a dimension is one order more.
    let orders = N + S::ORDER;
    let doubled = (usize::BITS - (orders - 1).leading_zeros()) as usize;
    let (mut pass, mut passes) = (0, doubled);
    while pass < passes {
        let mut directions = Vec::with_capacity(contacts.len());
        for contact in contacts {
            let (direction, is_zero) = direction(contact, &loads, parity);
            if is_zero {
                passes = orders;
            }
            directions.push(direction);
        }
        let Some((next, _)) = linear(contacts, &directions, 1.0) else {
            let contacts = (0..contacts.len()).collect();
            return Err(Unsolved::Locked { share: 1.0, contacts });
        };
        loads = next;
        pass += 1;
    }
    Ok(FrictionLoads { loads, contraction })
}

fn real<S: SinglePose, const N: usize>(contact: &Contact<SeriesOf<S, N>>) -> Contact<f64> {
    let reals = |parts: &Vec<SeriesOf<S, N>>| parts.iter().map(|part| part.real()).collect();
    Contact {
        measure: contact.measure,
        bare: reals(&contact.bare),
        changes: contact.changes.iter().map(reals).collect(),
    }
}

impl<T: Scalar> Contact<T> {
    fn parts(&self, loads: &[T]) -> Vec<T> {
        let mut parts = self.bare.clone();
        for (change, load) in self.changes.iter().zip(loads) {
            for (part, change) in parts.iter_mut().zip(change) {
                *part = *part + *change * *load;
            }
        }
        parts
    }
}

impl Contact<f64> {
    fn load(&self, loads: &[f64]) -> f64 {
        measure(self.measure, &self.parts(loads))
    }

    /// The sum of the sizes of all terms.
    fn size(&self, loads: &[f64]) -> f64 {
        let sum = |parts: &[f64]| parts.iter().map(|part| part.abs()).sum::<f64>();
        let changes = self.changes.iter().zip(loads);
        sum(&self.bare) + changes.map(|(change, load)| sum(change) * load.abs()).sum::<f64>()
    }
}

fn measure(measure: Measure, parts: &[f64]) -> f64 {
    match *parts {
        [one, other] if measure == Measure::Length => num_traits::Float::hypot(one, other),
        _ => parts.iter().fold(0.0, |largest, part| largest.max(part.abs())),
    }
}

/// The slope of a measure along its parts, which is zero where they are.
fn slope(kind: Measure, parts: &[f64]) -> Vec<f64> {
    let size = measure(kind, parts);
    if size == 0.0 {
        return vec![0.0; parts.len()];
    }
    let mut is_met = false;
    let of_largest = |part: &f64| {
        let counts = !is_met && part.abs() == size;
        is_met |= counts;
        if counts { part.signum() } else { 0.0 }
    };
    match kind {
        Measure::Length => parts.iter().map(|part| part / size).collect(),
        Measure::Largest => parts.iter().map(of_largest).collect(),
    }
}

/// The loads for given directions of the forces and a share of the friction, and whether the determinant is positive.
fn linear<T: Scalar>(contacts: &[Contact<T>], directions: &[Vec<T>], share: f64) -> Option<(Vec<T>, bool)> {
    let (zero, share) = (T::constant(0.0), T::constant(share));
    let along = |direction: &[T], parts: &[T]| {
        let terms = direction.iter().zip(parts);
        share * terms.fold(zero, |sum, (direction, part)| sum + *direction * *part)
    };
    let count = contacts.len();
    let mut entries = Vec::with_capacity(count * count);
    let mut right = Vec::with_capacity(count);
    for (row, (contact, direction)) in contacts.iter().zip(directions).enumerate() {
        right.push(along(direction, &contact.bare));
        for (column, change) in contact.changes.iter().enumerate() {
            let own = T::constant(f64::from(u8::from(row == column)));
            entries.push(own - along(direction, change));
        }
    }
    let mut rows = vec![FactorRow::default(); count];
    let is_odd = factor_in(&mut entries, &mut rows).ok()?.is_odd;
    let pivots = (0..count).map(|row| entries[row * count + row].leading());
    let is_positive = pivots.fold(!is_odd, |is_positive, pivot| is_positive == (pivot > 0.0));
    let mut loads = vec![zero; count];
    substitute_in(&entries, &rows, &right, &mut loads);
    loads
        .iter()
        .all(|load| load.is_finite())
        .then_some((loads, is_positive))
}

/// A bound of the spectral radius of the sizes of all changes, and the weights of loads in which it is a norm.
fn contraction(contacts: &[Contact<f64>]) -> (f64, Vec<f64>) {
    const ROUNDS: usize = 60;
    let mut weights = vec![1.0; contacts.len()];
    let mut best = (f64::INFINITY, weights.clone());
    for _ in 0..ROUNDS {
        let row = |contact: &Contact<f64>| {
            let terms = contact.changes.iter().zip(&weights);
            terms
                .map(|(change, weight)| measure(contact.measure, change) * weight)
                .sum()
        };
        let image: Vec<f64> = contacts.iter().map(row).collect();
        let ratios = image.iter().zip(&weights).map(|(image, weight)| image / weight);
        let bound = ratios.fold(0.0, f64::max);
        if bound < best.0 {
            best = (bound, weights.clone());
        }
        // any weights above zero give a bound, and those of the power method the best
        for (weight, image) in weights.iter_mut().zip(&image) {
            *weight = 0.1 * best.0 * *weight + image;
        }
        let largest = weights.iter().copied().fold(0.0, f64::max);
        for weight in &mut weights {
            *weight = (*weight / largest).max(1e-100);
        }
        if largest == 0.0 || !largest.is_finite() {
            break;
        }
    }
    best
}

struct System<'s> {
    contacts: &'s [Contact<f64>],
    weights: &'s [f64],
}

impl System<'_> {
    fn image(&self, loads: &[f64]) -> Vec<f64> {
        self.contacts.iter().map(|contact| contact.load(loads)).collect()
    }

    /// The largest entry, each over its weight.
    fn norm(&self, entries: impl Iterator<Item = f64>) -> f64 {
        let ratios = entries.zip(self.weights).map(|(entry, weight)| entry.abs() / weight);
        ratios.fold(0.0, f64::max)
    }

    fn distance(&self, one: &[f64], other: &[f64]) -> f64 {
        self.norm(one.iter().zip(other).map(|(one, other)| one - other))
    }

    fn newton(&self, loads: &[f64], share: f64) -> Option<(Vec<f64>, bool)> {
        let directions = self
            .contacts
            .iter()
            .map(|contact| slope(contact.measure, &contact.parts(loads)));
        linear(self.contacts, &directions.collect::<Vec<_>>(), share)
    }

    /// The only solution of a contraction. Each step is the better one of Newton's method and of the iteration, which
    /// contracts.
    fn contracted(&self, contraction: f64) -> Result<Vec<f64>, Unsolved> {
        let mut loads = self.image(&vec![0.0; self.contacts.len()]);
        for _ in 0..STEPS {
            let image = self.image(&loads);
            let size = self.norm(self.contacts.iter().map(|contact| contact.size(&loads)));
            if self.distance(&image, &loads) <= ROUNDING * size {
                return Ok(loads);
            }
            let residual = |loads: &[f64]| self.distance(&self.image(loads), loads);
            let newton = self.newton(&loads, 1.0).map(|(loads, _)| loads);
            let newton = newton.filter(|newton| residual(newton) < residual(&image));
            loads = newton.unwrap_or(image);
        }
        let steps = STEPS;
        Err(Unsolved::Slow { steps, contraction })
    }

    /// The solution that grows with friction from none at all.
    fn grown(&self, contraction: f64) -> Result<Vec<f64>, Unsolved> {
        // half of what is known to contract
        let mut share = 0.5 / contraction;
        let bare = self.image(&vec![0.0; self.contacts.len()]);
        let mut loads = self.corrected(&bare, share).unwrap_or_else(|| vec![0.0; bare.len()]);
        let mut step = share;
        for _ in 0..SHARES {
            let next_share = (share + step).min(1.0);
            let next = self.corrected(&loads, next_share).filter(|next| {
                let largest = self.norm(loads.iter().copied());
                let sizes = loads
                    .iter()
                    .zip(self.weights)
                    .map(|(load, weight)| load + weight * largest);
                let mut changes = next.iter().zip(&loads).zip(sizes);
                changes.all(|((next, load), size)| (next - load).abs() <= CHANGE * size)
            });
            let Some(next) = next else {
                step *= 0.5;
                if step < SHORTEST * share {
                    break;
                }
                continue;
            };
            (loads, share) = (next, next_share);
            if share >= 1.0 {
                return Ok(loads);
            }
            step *= 1.5;
        }
        let largest = self.norm(loads.iter().copied());
        let is_large = |contact: &usize| loads[*contact] >= 0.01 * largest * self.weights[*contact];
        Err(Unsolved::Locked {
            share,
            contacts: (0..loads.len()).filter(is_large).collect(),
        })
    }

    /// The solution near loads, on the branch whose determinant has the sign that it has without friction.
    fn corrected(&self, near: &[f64], share: f64) -> Option<Vec<f64>> {
        let mut loads = near.to_vec();
        for _ in 0..CORRECTIONS {
            let (next, is_positive) = self.newton(&loads, share)?;
            let size = self.norm(self.contacts.iter().map(|contact| contact.size(&next)));
            let image = self.image(&next).into_iter().map(|load| share * load);
            if self.distance(&image.collect::<Vec<_>>(), &next) <= ROUNDING * size {
                return is_positive.then_some(next);
            }
            loads = next;
        }
        None
    }
}

/// The slope of a measure along its parts as series, and whether the parts pass through zero. There, the slope is that
/// beside the zero.
fn direction<S: SinglePose, const N: usize>(
    contact: &Contact<SeriesOf<S, N>>,
    loads: &[SeriesOf<S, N>],
    parity: f64,
) -> (Vec<SeriesOf<S, N>>, bool) {
    let parts = contact.parts(loads);
    let values: Vec<f64> = loads.iter().map(|load| load.real()).collect();
    let rounding = ROUNDING * real(contact).size(&values);
    let sign_of = |order: usize| if order.is_multiple_of(2) { 1.0 } else { parity };
    let begins = |part: &SeriesOf<S, N>, order: usize| {
        let least = if order == 0 { rounding } else { 0.0 };
        part.coefficients()[order].real().abs() > least
    };
    let Some(order) = (0..N).find(|order| parts.iter().any(|part| begins(part, *order))) else {
        return (vec![SeriesOf::constant(0.0); parts.len()], true);
    };
    let direction = match contact.measure {
        Measure::Length => {
            let parts: Vec<SeriesOf<S, N>> = parts.iter().map(|part| shifted(*part, order)).collect();
            let largest = parts
                .iter()
                .fold(0.0, |largest: f64, part| largest.max(part.real().abs()));
            let scaled = |part: &SeriesOf<S, N>| *part / SeriesOf::constant(largest);
            let square = parts
                .iter()
                .fold(SeriesOf::constant(0.0), |sum, part| sum + scaled(part) * scaled(part));
            let length = square.sqrt() * SeriesOf::constant(sign_of(order));
            parts.iter().map(|part| scaled(part) / length).collect()
        }
        Measure::Largest => {
            // the sizes of the terms in the order in which they count beside the place
            let sizes = parts.iter().map(|part| {
                let mut terms = part.coefficients().map(Number::real);
                if terms[0].abs() <= rounding {
                    terms[0] = 0.0;
                }
                for (order, term) in terms.iter_mut().enumerate() {
                    *term *= sign_of(order);
                }
                let sign = terms
                    .iter()
                    .find(|term| **term != 0.0)
                    .map_or(0.0, |term| term.signum());
                (terms.map(|term| sign * term), sign)
            });
            let sizes: Vec<_> = sizes.collect();
            let compare = |one: &usize, other: &usize| {
                let mut terms = sizes[*one].0.iter().zip(&sizes[*other].0);
                let found = terms.find_map(|(one, other)| one.partial_cmp(other).filter(|order| order.is_ne()));
                found.unwrap_or(core::cmp::Ordering::Equal)
            };
            let largest = (0..parts.len()).max_by(compare);
            let entry = |part: usize| if Some(part) == largest { sizes[part].1 } else { 0.0 };
            (0..parts.len()).map(|part| SeriesOf::constant(entry(part))).collect()
        }
    };
    (direction, order > 0)
}

#[cfg(test)]
mod tests {
    use std::vec;
    use std::vec::Vec;

    use super::{Contact, FrictionLoads, Measure, Unsolved, solve};
    use crate::number::series::Series;
    use crate::number::{Number as _, samples};
    use crate::verify::Random;

    type Fifth = Series<5>;

    fn sliding(bare: Fifth, change: f64) -> [Contact<Fifth>; 1] {
        [Contact {
            measure: Measure::Largest,
            bare: vec![bare, Series::ZERO],
            changes: vec![vec![Series::constant(change), Series::ZERO]],
        }]
    }

    fn close(one: Fifth, other: Fifth, tolerance: f64) {
        for (one, other) in one.coefficients().into_iter().zip(other.coefficients()) {
            assert!((one - other).abs() <= tolerance * (1.0 + other.abs()), "{one} {other}");
        }
    }

    /// f = |n - c f| has one solution for |c| < 1. From there on it has a second one or none, and the one that grows
    /// with friction is n/(1 + c). (P. Painlevé, Sur les lois du frottement de glissement, Comptes rendus 121, 1895,
    /// 112-115.)
    #[test]
    fn one_slide_has_one_two_or_no_solutions() {
        let bare = Fifth::from_coefficients([3.0, -1.0, 0.5, 0.2, 0.1]);
        for change in [-0.9, -0.3, 0.4, 0.99, 1.5, 20.0] {
            let found = solve(&sliding(bare, -change), 1.0).expect("it has a solution");
            assert!(
                (found.contraction - f64::abs(change)).abs() < 1e-14,
                "{}",
                found.contraction
            );
            close(found.loads[0], bare / Series::constant(1.0 + change), 1e-13);
        }
        for change in [-1.0, -1.25, -8.0] {
            let Err(Unsolved::Locked { share, contacts }) = solve(&sliding(bare, -change), 1.0) else {
                panic!("{change}")
            };
            assert!((share * -change - 1.0).abs() < 1e-8, "{share}");
            assert_eq!(contacts, [0]);
        }
    }

    /// Beside a force that passes through zero, friction is its size on the side that counts.
    #[test]
    fn a_force_passes_through_zero() {
        let bare = Fifth::from_coefficients([0.0, -2.0, 1.0, 0.5, 0.0]);
        for (parity, sign) in [(1.0, 1.0), (-1.0, -1.0)] {
            let found = solve(&sliding(bare, 0.25), parity).expect("it has a solution");
            // |n + f/4| with n below zero behind: f = -n/(1 + 1/4), and before: f = n/(1 - 1/4)
            let expected = bare / Series::constant(if sign > 0.0 { -1.25 } else { 0.75 });
            close(found.loads[0], expected, 1e-14);
            let pin = [Contact {
                measure: Measure::Length,
                bare: vec![bare, bare + bare],
                changes: vec![vec![Series::ZERO; 2]],
            }];
            let found = solve(&pin, parity).expect("it has a solution");
            // the series of a length over its zero loses its last term
            let length = bare * Series::constant(-sign * 5.0_f64.sqrt());
            close(found.loads[0], length, 1e-14);
        }
    }

    /// The solution in series is that of the iteration, term by term, from any start.
    #[test]
    fn an_iteration_gives_the_same() {
        let mut random = Random::new(21);
        for count in 1..8 {
            for _ in 0..samples::of(50) {
                let reach = 0.8 / f64::from(u8::try_from(count).expect("a few"));
                let mut series =
                    |size: f64| Fifth::from_coefficients(core::array::from_fn(|_| random.between(-size, size)));
                let contacts: Vec<Contact<Fifth>> = (0..count)
                    .map(|index| Contact {
                        measure: if index % 2 == 0 {
                            Measure::Length
                        } else {
                            Measure::Largest
                        },
                        bare: vec![series(1.0), series(1.0)],
                        changes: (0..count).map(|_| vec![series(reach), series(reach)]).collect(),
                    })
                    .collect();
                let FrictionLoads { loads, contraction } = match solve(&contacts, 1.0) {
                    Ok(found) => found,
                    Err(Unsolved::Locked { share, .. }) => {
                        assert!(share < 1.0, "{share}");
                        continue;
                    }
                    Err(error) => panic!("{error:?}"),
                };
                if contraction > 0.95 {
                    continue;
                }
                let mut own = vec![Series::ZERO; count];
                for _ in 0..1000 {
                    let measured = |contact: &Contact<Fifth>| {
                        let parts = contact.parts(&own);
                        match contact.measure {
                            Measure::Length => (parts[0] * parts[0] + parts[1] * parts[1]).sqrt(),
                            Measure::Largest => parts[0].abs().max(parts[1].abs()),
                        }
                    };
                    own = contacts.iter().map(measured).collect();
                }
                for (found, own) in loads.into_iter().zip(own) {
                    let size = own
                        .coefficients()
                        .into_iter()
                        .fold(1.0, |size: f64, term| size.max(term.abs()));
                    for (found, own) in found.coefficients().into_iter().zip(own.coefficients()) {
                        assert!((found - own).abs() < 1e-9 * size, "{found} {own} {contraction}");
                    }
                }
            }
        }
    }
}
