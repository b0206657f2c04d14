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

/// Positions nearer to each other than this, in radians or in the size of their lengths, are one: regular ones are not.
const SAME: f64 = 1e-7;

/// All positions of a mechanism at given inputs, by which its assemblies are told; a slice for reading.
///
/// Each is a regular position, found by Newton's method to the last digit. See [`continuation`](crate::continuation) for what is
/// guaranteed: if [`is_complete`](Self::is_complete), there is no other regular position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Assemblies<const N: usize, const CAPACITY: usize> {
    positions: Positions<Near<N>, CAPACITY>,
    lost: usize,
    singular: usize,
}

impl<const N: usize, const CAPACITY: usize> Assemblies<N, CAPACITY> {
    /// Whether no path to a position was lost, so that these are all regular positions.
    #[must_use]
    pub const fn is_complete(&self) -> bool {
        self.lost == 0 && self.positions.missed() == 0
    }

    /// How many singular positions were met, limit positions and dead points; they are not in the list.
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

/// What is chosen on the way to a position, block by block: one way after another, until all have been gone.
#[derive(Clone, Copy, Debug)]
pub struct Choices {
    /// Which of how many, for each choice on the way.
    way: [(usize, usize); Self::DEPTH],
    depth: usize,
    lost: usize,
}

impl Choices {
    /// Choices on one way. A mechanism of more blocks than this has too many assemblies to go through.
    const DEPTH: usize = 64;

    const fn new() -> Self {
        Self {
            way: [(0, 1); Self::DEPTH],
            depth: 0,
            lost: 0,
        }
    }

    /// One of `count`, and whether it is the first time that this choice is made.
    fn one_of(&mut self, count: usize) -> (usize, bool) {
        let place = self.depth;
        self.depth += 1;
        let Some(choice) = self.way.get_mut(place) else {
            return (0, false);
        };
        choice.1 = count;
        (choice.0, choice.0 == 0)
    }

    /// Goes on to the next way; false if there is none.
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
    /// If there is none.
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

/// Goes every way that `position` leaves to choose, and keeps the positions at which it arrives, `refined` to the last digit.
///
/// There are as many ways as combinations of solutions; the macro calls it for a mechanism of 4096 at most.
///
/// # Errors
/// [`Failure::NotFinite`], if parameters or inputs are not.
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

/// Whether two positions are one, up to whole turns.
fn is_same<const N: usize>(a: &[f64; N], b: &[f64; N]) -> bool {
    a.iter().zip(b).all(|(a, b)| {
        let difference = a - b;
        let turned = difference - TAU * Float::round(difference / TAU);
        Float::min(difference.abs(), turned.abs()) <= SAME * (1.0 + a.abs())
    })
}
