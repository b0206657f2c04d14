//! The assembly of a mechanism with coupled blocks.

use crate::number::Number;

/// The assembly of a block of coupled equations, chosen by values of the unknowns close to it. The number of assemblies
/// of a coupled block depends on the dimensions and inputs, so they have no names.
///
/// ```
/// use kin_core::Near;
///
/// let from_drawing = Near([0.4, 1.9]);
/// assert_eq!(from_drawing.0[1], 1.9);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Near<const N: usize>(
    /// The unknowns in the order in which they were declared: radians, or the mechanism's unit of length.
    pub [f64; N],
);

/// The values of `N` unknowns of the mechanism `M` near the wanted position, for `position_near`, `solve_near` and all
/// solvers of mechanisms with coupled blocks.
///
/// | given | means |
/// |---|---|
/// | a pose of the mechanism, of any order | its unknowns |
/// | `[0.4, 1.9]` | the unknowns in the order in which they were declared |
/// | [`Near`] | the same, in double precision |
/// | a reference to one of these | the same |
///
/// Only this crate and `mechanism!` implement it. A new version may add items.
///
/// ```
/// use kin_core::library::FourBar;
/// use kin_core::prelude::*;
///
/// let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 60.0, r4: 45.0 };
/// let mut pose = linkage.position(1.0, Assembly::Open)?;
/// for step in 1..=10 {
///     pose = linkage.position_near(1.0 + 0.05 * f64::from(step), pose)?;
/// }
/// assert!((pose.theta2.position() - 1.5).abs() < 1e-15);
/// # Ok::<(), SolveError>(())
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not give values near the position for all unknowns, {N} in number",
    label = "give {N} in the order of the unknowns, as in `[..]` or `Near([..])`, or a pose of this mechanism",
    note = "coupled equations have no closed form: a mechanism with such a block takes values near the position \
            instead of an `Assembly`. Its `assemblies_at` finds all positions at given inputs, and `track` follows one \
            of them from pose to pose"
)]
pub trait Guess<T, const N: usize, M> {
    /// The values.
    fn values(self) -> [T; N];
}

impl<T, const N: usize, M> Guess<T, N, M> for [T; N] {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn values(self) -> Self {
        self
    }
}

impl<T: Number, const N: usize, M> Guess<T, N, M> for Near<N> {
    #[inline]
    fn values(self) -> [T; N] {
        self.0.map(T::constant)
    }
}

impl<T, const N: usize, M, G: Guess<T, N, M> + Copy> Guess<T, N, M> for &G {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn values(self) -> [T; N] {
        (*self).values()
    }
}
