//! The assembly of a mechanism with coupled blocks.

/// Which assembly, told by values of the unknowns near it: a block of coupled equations has as many assemblies as its
/// dimensions and inputs allow, and no names for them.
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
