//! All solutions of a system of polynomial equations, by continuation from all solutions of another system.
//!
//! A coupled block of a loop closure is such a system. Each unknown angle gives two variables, its cosine and sine,
//! with the equation c² + s² = 1; each unknown length gives one variable. The loops are equations of first or second
//! degree in them. Newton's method finds one solution near a guess; this module finds all solutions.
//!
//! # Method
//!
//! 1. Variables and equations are scaled, and the equations of first degree eliminate variables.
//! 2. The other equations are replaced by products of linear factors with random complex coefficients, chosen so that
//!    the equations have the same structure. Setting one factor of each equation to zero gives the solutions of this
//!    *start system*.
//! 3. The start system is deformed into the system to be solved. Each solution is followed on its path through the
//!    complex numbers, with a predictor (Runge-Kutta, fourth order), a corrector (Newton) and steps as long as the
//!    error of prediction allows. In homogeneous coordinates a path to infinity is no longer than other paths.
//! 4. If a path ends at a singular solution, it is followed around its end. The end is the mean over these loops
//!    (Cauchy's integral).
//! 5. Ends are sorted: regular or singular, finite or at infinity, real or complex. Real ends are corrected in real
//!    numbers. A path that is lost, or that ends where another path ends although only one can, is followed again
//!    with greater care. If that does not help, all paths are followed from another start system.
//!
//! For an angle the linear factors are c + i s - p and c - i s - q. These are isotropic coordinates, in which a plane
//! loop is one equation in the first and another in the second (C. W. Wampler, *Solving the kinematics of planar
//! mechanisms by Dixon determinant and a complex-plane formulation*, Journal of Mechanical Design 123 (2001) 382-387).
//! So n / 2 loops with n angles have at most n! / (n/2)!² paths: 2 for a four-bar linkage, 6 for the class III triad,
//! 20 for three loops. In general these are the numbers of real and complex solutions, and no path leads to infinity.
//!
//! A body in space that six equations hold, such as a platform on six legs, has [a separate system](BodySystem). It
//! starts from the 40 poses of a known body, so that no path leads to infinity unless the body is special.
//!
//! # Guarantees
//!
//! In exact arithmetic, with probability one, every isolated complex solution is the end of a path, and so is every
//! isolated real solution. (For generic coefficients no two paths meet before their ends, and each isolated solution of
//! multiplicity m is the end of m paths. The exceptions are a set of coefficients of measure zero.) The coefficients
//! are fixed pseudorandom numbers, so results are reproducible.
//!
//! - A. J. Sommese & C. W. Wampler, *The Numerical Solution of Systems of Polynomials Arising in Engineering and
//!   Science*, World Scientific 2005: chapter 7 for paths between systems of one family, chapter 8 for linear products,
//!   chapter 10 for endgames.
//! - A. P. Morgan, A. J. Sommese & C. W. Wampler, *A product-decomposition bound for Bezout numbers*, SIAM Journal on
//!   Numerical Analysis 32 (1995) 1308-1325: proof that the products of step 2 are allowed.
//! - A. P. Morgan, *Solving Polynomial Systems Using Continuation for Engineering and Scientific Problems*,
//!   Prentice-Hall 1987.
//!
//! Paths are followed in double precision, not in exact arithmetic. A step that is too long may jump to another path,
//! and there is no proof that none did. Three things guard against it: the error of prediction (2·10⁻⁴ at most in
//! coordinates of size one), the contraction of Newton's method, and the rule that no two paths end at the same regular
//! solution. A jump between paths that both end at regular solutions is detected, unless the two paths are exchanged,
//! which does no harm. A jump to a path that ends at a singular solution or at infinity is not detected. If factors of
//! the start system contradict each other up to rounding, they count as contradictory and have no path. This may be
//! wrong if the links in one loop differ by more than about six orders of magnitude.
//!
//! The [`PathCounts`] mean the following:
//!
//! - `lost == 0` ([`is_complete`](PathCounts::is_complete)): all isolated solutions are found. `regular` of them are
//!   regular and all different, with the probability and the reservation above.
//! - `lost > 0`: at most this many more isolated solutions may exist.
//! - `singular > 0`: paths end at multiple solutions, at a limit position or dead point, or where the solutions are not
//!   isolated because the mechanism can move with fixed inputs. Each real point at which such paths end is passed on,
//!   with the number of paths as its multiplicity. If solutions are not isolated, only some of their points are found.
//!
//! # Limits of effort
//!
//! A path takes at most 5000 steps from its start. If its end is singular, the path loops around it at 20 radii at
//! most, with at most 5000 steps for each radius, including those from the start. It is followed at most three times
//! from each of at most three start systems. A path that has not arrived then is `lost`.
//!
//! ```
//! use kin_core::Positions;
//! use kin_core::continuation::{PolynomialSystem, Solution, Term, real_solutions};
//!
//! // x² + y² = a² and (x - d)² + y² = b²
//! const SYSTEM: PolynomialSystem<2> = PolynomialSystem::new(&[
//!     Term::new(0, 0, &[(0, 2)]),
//!     Term::new(0, 0, &[(1, 2)]),
//!     Term::new(0, 1, &[]),
//!     Term::new(1, 0, &[(0, 2)]),
//!     Term::new(1, 2, &[(0, 1)]),
//!     Term::new(1, 0, &[(1, 2)]),
//!     Term::new(1, 3, &[]),
//! ]);
//! const PATHS: usize = SYSTEM.paths();
//!
//! let (a, b, d) = (3.0, 4.0, 5.0);
//! let coefficients = [1.0, -a * a, -2.0 * d, d * d - b * b];
//! let mut points = Positions::<Solution<2>, PATHS>::new();
//! let outcome = real_solutions::<2, PATHS>(&SYSTEM, &coefficients, |point| {
//!     points.push(point);
//! })?;
//! assert!(outcome.is_complete());
//! assert_eq!(outcome.real, 2);
//! for point in &points {
//!     let [x, y] = point.values;
//!     assert!((x - 1.8).abs() < 1e-14 && (y.abs() - 2.4).abs() < 1e-14);
//! }
//! # Ok::<(), kin_core::continuation::Unsuitable>(())
//! ```

mod body;
mod complex;
mod ending;
mod factors;
mod homotopy;
mod known_poses;
mod outcome;
mod paths;
mod reduction;
mod scaling;
mod sequence;
mod system;
mod traveller;

#[cfg(test)]
mod tests;

pub use body::BodySystem;
pub use outcome::{PathCounts, Solution, Unsuitable};
pub use system::{BorrowedSystem, BorrowedTerm, PolynomialSystem, Term};

use crate::assemblies::Positions;
use ending::PathEndKind;
use homotopy::{Homotopy, KnownSystem};
use paths::{FollowedPath, follow_all};
use scaling::Scales;

/// The number of start systems tried before paths are reported as lost.
const ATTEMPTS: u64 = 3;

/// Passes each real solution of a system to `found`, and returns the counts of all paths.
///
/// `PATHS` is the number of paths for which there is room; [`PolynomialSystem::paths`] is always enough. The terms of
/// the system refer to the given coefficients. Units of the variables may differ by many orders of magnitude.
///
/// Two coupled plane loops with four angles (6 paths) take about 0.7 ms, three loops with six angles (20 paths) about 5
/// ms, and more near a limit position. The stack holds about 100 + 8 M bytes for each of `PATHS`.
///
/// # Errors
/// [`Unsuitable`], if the table, the coefficients, or the equations of first degree do not allow a start. A system
/// without real solutions, or with lost paths, is not an error: the [`PathCounts`] report this.
pub fn real_solutions<const M: usize, const PATHS: usize>(
    system: &BorrowedSystem<'_, M>,
    coefficients: &[f64],
    found: impl FnMut(Solution<M>),
) -> Result<PathCounts, Unsuitable> {
    if !system.fits(coefficients.len()) {
        return Err(Unsuitable::Table);
    }
    if let Some(coefficient) = coefficients.iter().position(|value| !value.is_finite()) {
        return Err(Unsuitable::NotFinite { coefficient });
    }
    let degrees = system.degrees(coefficients);
    let occurring = &degrees[..system.variables()];
    if let Some(equation) = occurring.iter().position(|&degree| degree == 0) {
        return Err(Unsuitable::NoVariable { equation });
    }
    let scales = scaling::scales(system, coefficients);
    solutions::<M, PATHS>(system, coefficients, &degrees, &scales, None, found)
}

/// Systems of which all real solutions can be found, with `M` values each.
pub trait AllSolutions<const M: usize> {
    /// Passes each real solution to `found`, and returns the counts of all paths, for which there is room for `PATHS`.
    ///
    /// # Errors
    /// [`Unsuitable`], if the coefficients do not allow a start.
    fn real_solutions<const PATHS: usize>(
        &self,
        coefficients: &[f64],
        found: impl FnMut(Solution<M>),
    ) -> Result<PathCounts, Unsuitable>;
}

impl<const M: usize> AllSolutions<M> for BorrowedSystem<'_, M> {
    fn real_solutions<const PATHS: usize>(
        &self,
        coefficients: &[f64],
        found: impl FnMut(Solution<M>),
    ) -> Result<PathCounts, Unsuitable> {
        real_solutions::<M, PATHS>(self, coefficients, found)
    }
}

/// The real solutions of a system in units that the search chooses, from those of a known system if one is given.
fn solutions<const M: usize, const PATHS: usize>(
    system: &BorrowedSystem<'_, M>,
    coefficients: &[f64],
    degrees: &[u8; M],
    scales: &Scales<M>,
    known: Option<KnownSystem<'_, M>>,
    mut found: impl FnMut(Solution<M>),
) -> Result<PathCounts, Unsuitable> {
    let coordinates = reduction::reduce(system, coefficients, degrees, scales)
        .map_err(|equation| Unsuitable::Dependent { equation })?;
    let mut attempt = 0;
    let paths: Positions<FollowedPath<M>, PATHS> = loop {
        let homotopy = Homotopy::new(
            system,
            coefficients,
            degrees,
            scales,
            coordinates.clone(),
            known,
            attempt,
        );
        let paths: Positions<FollowedPath<M>, PATHS> = follow_all(&homotopy);
        if paths.missed() > 0 {
            return Err(Unsuitable::TooManyPaths {
                paths: paths.len() + paths.missed(),
            });
        }
        attempt += 1;
        if attempt == ATTEMPTS || paths.iter().all(|path| path.end.kind != PathEndKind::Lost) {
            break paths;
        }
    };
    let mut outcome = PathCounts {
        paths: paths.len(),
        ..PathCounts::default()
    };
    for (index, FollowedPath { end, .. }) in paths.iter().enumerate() {
        match end.kind {
            PathEndKind::Lost => outcome.lost += 1,
            PathEndKind::AtInfinity | PathEndKind::RegularAtInfinity => outcome.at_infinity += 1,
            PathEndKind::Regular => outcome.regular += 1,
            PathEndKind::Singular => outcome.singular += 1,
        }
        let Some(values) = end.values else {
            continue;
        };
        let multiplicity = if end.kind == PathEndKind::Singular {
            let same = |other: &&FollowedPath<M>| other.end.kind == PathEndKind::Singular && other.end.meets(end);
            if paths[..index]
                .iter()
                .any(|other| other.end.values.is_some() && same(&other))
            {
                continue;
            }
            paths.iter().filter(same).count()
        } else {
            outcome.real += 1;
            1
        };
        found(Solution {
            values,
            multiplicity,
            condition: end.condition,
        });
    }
    Ok(outcome)
}
