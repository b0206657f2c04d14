//! All assemblies of a mechanism with coupled blocks.

use core::f64::consts::TAU;
use core::ops::Deref;

use num_traits::Float;

use crate::assemblies::{Positions, continuation::AllSolutions};
use crate::assembly::{Assembly, Near};
use crate::failure::{Failure, SolveError};
use crate::mechanism::{Mechanism, PositionSearch};
use crate::number::{Number, Row};

/// The distance within which positions are the same, in radians or relative to their lengths. Regular positions lie
/// further apart.
const SAME_POSITION: f64 = 1e-7;

/// The number of choices on one path. A mechanism with more blocks has too many assemblies to try all.
const DEPTH: usize = 64;

/// All positions of a mechanism at given inputs, which identify its assemblies. It dereferences to a slice.
///
/// Each is a regular position, found by Newton's method to the last digit. If [`is_complete`](Self::is_complete), there
/// is no other regular position. In exact arithmetic this holds with probability one. Paths are followed in double
/// precision: a jump between paths to regular positions is noticed, a jump to a path that ends at a singular position
/// or at infinity is not.
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
#[derive(Debug)]
pub struct Choices<'m> {
    /// For each choice on the path, the chosen index and the number of options.
    way: [(usize, usize); DEPTH],
    depth: usize,
    /// The number of choices, from the first on, that have the same options as on the path before.
    kept: usize,
    /// The solutions of the blocks without a closed form on this path, each with room for all of its solutions.
    solutions: &'m mut [f64],
    /// The room that is taken by the blocks so far.
    taken: usize,
    lost: usize,
}

impl<'m> Choices<'m> {
    const fn new(solutions: &'m mut [f64]) -> Self {
        Self {
            way: [(0, 1); DEPTH],
            depth: 0,
            kept: 0,
            solutions,
            taken: 0,
            lost: 0,
        }
    }

    /// The index of the chosen one of `count` options.
    fn one_of(&mut self, count: usize) -> usize {
        let level = self.depth;
        self.depth += 1;
        self.way.get_mut(level).map_or(0, |choice| {
            choice.1 = count;
            choice.0
        })
    }

    /// Moves on to the next path; returns false if there is none.
    fn advance(&mut self) -> bool {
        let mut level = self.depth.min(DEPTH);
        (self.depth, self.taken) = (0, 0);
        while level > 0 {
            level -= 1;
            let (which, count) = self.way[level];
            if which + 1 < count {
                self.way[level].0 = which + 1;
                self.kept = level + 1;
                return true;
            }
            self.way[level] = (0, 1);
        }
        false
    }

    /// The assembly of a block with a closed form.
    pub fn assembly(&mut self) -> Assembly {
        Assembly::BOTH[self.one_of(2)]
    }

    /// A solution of a block without a closed form. The block is solved once for all paths that differ later.
    ///
    /// # Errors
    /// Fails if there is no solution.
    pub fn solution<const M: usize, const PATHS: usize>(
        &mut self,
        system: &impl AllSolutions<M>,
        coefficients: &[f64],
    ) -> Result<[f64; M], Failure> {
        let known = self.solution_in(M, PATHS, |found| {
            let outcome = system.real_solutions::<PATHS>(coefficients, |solution| found(&solution.values));
            outcome.map_or(1, |outcome| outcome.lost)
        })?;
        let (known, _) = known.as_chunks::<M>();
        known.first().copied().ok_or(NO_SOLUTION)
    }

    /// [`solution`](Self::solution) of a system with any number of variables, of which `all` passes on every real
    /// solution, `paths` of them at most, and returns the number of paths that it lost.
    ///
    /// # Errors
    /// Fails if there is no solution.
    #[doc(hidden)]
    pub fn solution_in(
        &mut self,
        variables: usize,
        paths: usize,
        all: impl FnOnce(&mut dyn FnMut(&[f64])) -> usize,
    ) -> Result<&[f64], Failure> {
        let first = self.taken;
        self.taken += paths * variables;
        let room = self.solutions.get_mut(first..self.taken).unwrap_or(&mut []);
        let count = if self.depth < self.kept {
            self.way[self.depth].1
        } else {
            let (mut count, mut rows) = (0, room.chunks_exact_mut(variables.max(1)));
            self.lost += all(&mut |solution| {
                if let Some(row) = rows.next() {
                    row.copy_from_slice(solution);
                    count += 1;
                }
            });
            count
        };
        let which = self.one_of(count);
        let known = self
            .solutions
            .get(first..)
            .unwrap_or(&[])
            .chunks_exact(variables.max(1));
        known.take(count).nth(which).ok_or(NO_SOLUTION)
    }
}

/// The failure of a path without a solution.
const NO_SOLUTION: Failure = Failure::Singular { determinant: 0.0 };

/// Tries all combinations of choices in `position`, and keeps the resulting positions, `refined` to the last digit.
///
/// There is one path per combination of solutions. The macro calls this function for mechanisms with at most 4096.
/// There is room for `ROOM` numbers: the solutions of all blocks without a closed form.
///
/// # Errors
/// [`Failure::NotFinite`] if a parameter or an input is not finite.
pub fn every<const N: usize, const CAPACITY: usize, const ROOM: usize>(
    mut position: impl FnMut(&mut Choices<'_>) -> Result<[f64; N], SolveError>,
    refined: impl Fn([f64; N]) -> Result<[f64; N], SolveError>,
) -> Result<Assemblies<N, CAPACITY>, SolveError> {
    let mut all = Assemblies {
        positions: Positions::new(),
        lost: 0,
        singular: 0,
    };
    all.lost = every_in(&mut [0.0; ROOM], |choices| {
        match refined(position(choices)?) {
            Ok(position) if all.iter().any(|Near(known)| is_same_position(known, &position)) => {}
            Ok(position) => {
                all.positions.push(Near(position));
            }
            Err(_) => all.singular += 1,
        }
        Ok(())
    })?;
    Ok(all)
}

/// Takes all paths, each a combination of choices, and returns the number of solutions that may be lost. `solutions`
/// has room for the solutions of all blocks without a closed form.
///
/// # Errors
/// The error of a path that says that a parameter or an input is not finite.
#[doc(hidden)]
pub fn every_in(
    solutions: &mut [f64],
    mut path: impl FnMut(&mut Choices<'_>) -> Result<(), SolveError>,
) -> Result<usize, SolveError> {
    let mut choices = Choices::new(solutions);
    loop {
        if let Err(error) = path(&mut choices)
            && matches!(error.failure, Failure::NotFinite { .. })
        {
            return Err(error);
        }
        if !choices.advance() {
            return Ok(choices.lost);
        }
    }
}

/// Passes on the positions that were found in double precision, each refined in the mechanism's numbers.
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
        match mechanism.position_near(inputs, guess) {
            Ok(unknowns) => {
                search.found += 1;
                found(*near, unknowns);
            }
            Err(_) => search.singular += 1,
        }
    }
    search
}

/// Whether two positions are the same up to whole revolutions.
#[doc(hidden)]
#[must_use]
pub fn is_same_position(a: &[f64], b: &[f64]) -> bool {
    a.iter().zip(b).all(|(a, b)| {
        let difference = a - b;
        let wrapped = difference - TAU * Float::round(difference / TAU);
        Float::min(difference.abs(), wrapped.abs()) <= SAME_POSITION * (1.0 + a.abs())
    })
}
