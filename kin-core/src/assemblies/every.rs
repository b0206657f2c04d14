//! All assemblies of a mechanism with coupled blocks.

use core::f64::consts::TAU;
use core::ops::Deref;

use num_traits::Float;

use crate::assemblies::{
    Positions,
    continuation::{PolynomialSystem, Solution, real_solutions},
};
use crate::assembly::{Assembly, Near};
use crate::failure::{Failure, SolveError};
use crate::mechanism::{Mechanism, PositionSearch};
use crate::number::{Number, Row};

/// The distance within which positions are the same, in radians or relative to their lengths. Regular positions lie
/// further apart.
const SAME: f64 = 1e-7;

/// All positions of a mechanism at given inputs, which identify its assemblies. It dereferences to a slice.
///
/// Each is a regular position, found by Newton's method to the last digit. See [`continuation`](crate::continuation)
/// for the guarantees: if [`is_complete`](Self::is_complete), there is no other regular position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Assemblies<const N: usize, const CAPACITY: usize> {
    positions: Positions<Near<N>, CAPACITY>,
    lost: usize,
    singular: usize,
}

impl<const N: usize, const CAPACITY: usize> Assemblies<N, CAPACITY> {
    /// Whether no path to a position was lost, so that the list contains all regular positions.
    #[must_use]
    pub const fn is_complete(&self) -> bool {
        self.lost == 0 && self.positions.missed() == 0
    }

    /// The number of singular positions found: limit positions and dead points. The list does not contain them.
    #[must_use]
    pub const fn singular(&self) -> usize {
        self.singular
    }
}

impl<const N: usize, const CAPACITY: usize> Deref for Assemblies<N, CAPACITY> {
    type Target = [Near<N>];

    fn deref(&self) -> &[Near<N>] {
        &self.positions
    }
}

impl<'a, const N: usize, const CAPACITY: usize> IntoIterator for &'a Assemblies<N, CAPACITY> {
    type Item = &'a Near<N>;
    type IntoIter = core::slice::Iter<'a, Near<N>>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

/// The choices on the path to a position, block by block. The paths are tried one after another.
#[derive(Clone, Copy, Debug)]
pub struct Choices {
    /// For each choice on the path, the chosen index and the number of options.
    way: [(usize, usize); Self::DEPTH],
    depth: usize,
    lost: usize,
}

impl Choices {
    /// The number of choices on one path. A mechanism with more blocks has too many assemblies to try all.
    const DEPTH: usize = 64;

    const fn new() -> Self {
        Self {
            way: [(0, 1); Self::DEPTH],
            depth: 0,
            lost: 0,
        }
    }

    /// The chosen one of `count` options, and whether this choice is made for the first time.
    fn one_of(&mut self, count: usize) -> (usize, bool) {
        let place = self.depth;
        self.depth += 1;
        let Some(choice) = self.way.get_mut(place) else {
            return (0, false);
        };
        choice.1 = count;
        (choice.0, choice.0 == 0)
    }

    /// Moves on to the next path; returns false if there is none.
    fn advance(&mut self) -> bool {
        let mut place = self.depth.min(Self::DEPTH);
        self.depth = 0;
        while place > 0 {
            place -= 1;
            let (which, count) = self.way[place];
            if which + 1 < count {
                self.way[place].0 = which + 1;
                return true;
            }
            self.way[place] = (0, 1);
        }
        false
    }

    /// The assembly of a block with a closed form.
    pub fn assembly(&mut self) -> Assembly {
        Assembly::BOTH[self.one_of(2).0]
    }

    /// A solution of a block without a closed form.
    ///
    /// # Errors
    /// Fails if there is no solution.
    pub fn solution<const M: usize, const PATHS: usize>(
        &mut self,
        system: &PolynomialSystem<M>,
        coefficients: &[f64],
    ) -> Result<[f64; M], Failure> {
        let mut solutions = Positions::<Solution<M>, PATHS>::new();
        let outcome = real_solutions::<M, PATHS>(system, coefficients, |solution| {
            solutions.push(solution);
        });
        let (which, is_first) = self.one_of(solutions.len());
        if is_first {
            self.lost += outcome.map_or(1, |outcome| outcome.lost);
        }
        solutions
            .get(which)
            .map(|solution| solution.values)
            .ok_or(Failure::Singular { determinant: 0.0 })
    }
}

/// Tries all combinations of choices in `position`, and keeps the resulting positions, `refined` to the last digit.
///
/// There is one path per combination of solutions. The macro calls this function for mechanisms with at most 4096.
///
/// # Errors
/// [`Failure::NotFinite`] if a parameter or an input is not finite.
pub fn every<const N: usize, const CAPACITY: usize>(
    mut position: impl FnMut(&mut Choices) -> Result<[f64; N], SolveError>,
    refined: impl Fn([f64; N]) -> Result<[f64; N], SolveError>,
) -> Result<Assemblies<N, CAPACITY>, SolveError> {
    let mut choices = Choices::new();
    let mut all = Assemblies {
        positions: Positions::new(),
        lost: 0,
        singular: 0,
    };
    loop {
        match position(&mut choices) {
            Ok(near) => match refined(near) {
                Ok(position) if all.iter().any(|Near(known)| is_same(known, &position)) => {}
                Ok(position) => {
                    all.positions.push(Near(position));
                }
                Err(_) => all.singular += 1,
            },
            Err(
                error @ SolveError {
                    failure: Failure::NotFinite { .. },
                    ..
                },
            ) => return Err(error),
            Err(_) => {}
        }
        if !choices.advance() {
            all.lost = choices.lost;
            return Ok(all);
        }
    }
}

/// Passes on the positions that were found in double precision, each refined in the mechanism's own numbers.
/// One that cannot be refined counts as singular.
pub fn positions_near<M, const N: usize, const CAPACITY: usize>(
    mechanism: &M,
    inputs: M::Inputs<M::Scalar>,
    all: &Assemblies<N, CAPACITY>,
    mut found: impl FnMut(M::Assembly, M::Unknowns<M::Scalar>),
) -> PositionSearch
where
    M: Mechanism<Assembly = Near<N>>,
{
    let mut search = PositionSearch::default();
    (search.singular, search.is_complete) = (all.singular(), all.is_complete());
    for near in all {
        let guess = M::Unknowns::from_fn(|unknown| M::Scalar::constant(near.0[unknown]));
        match mechanism.solve_position_near(inputs, guess) {
            Ok(unknowns) => {
                search.found += 1;
                found(*near, unknowns);
            }
            Err(_) => search.singular += 1,
        }
    }
    search
}

/// Whether two positions are the same up to whole turns.
fn is_same<const N: usize>(a: &[f64; N], b: &[f64; N]) -> bool {
    a.iter().zip(b).all(|(a, b)| {
        let difference = a - b;
        let turned = difference - TAU * Float::round(difference / TAU);
        Float::min(difference.abs(), turned.abs()) <= SAME * (1.0 + a.abs())
    })
}
