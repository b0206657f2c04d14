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
    /// The unknowns in the order in which they were declared: radians, or the mechanism's own unit of length.
    pub [f64; N],
);

/// The values of `N` unknowns near the wanted position.
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not tell the assembly of coupled equations, which have no closed form",
    label = "give values of the unknowns near the position, as in `Near([..])` or `position_near(.., [..])`",
    note = "`assemblies_at` finds all positions at given inputs, and `track` follows one of them from pose to pose"
)]
pub trait Guess<T, const N: usize> {
    /// The values.
    fn values(self) -> [T; N];
}

impl<T: Number, const N: usize> Guess<T, N> for Near<N> {
    #[inline]
    fn values(self) -> [T; N] {
        self.0.map(T::constant)
    }
}
