//! A square root, and what it is the root of.

use crate::assembly::Assembly;
use crate::solve::Scalar;

/// A square root with a sign, and its square.
///
/// Rates are divided by roots. `value / square` is the reciprocal of a root, where `1 / square` need not wait for it: a root and a
/// division take a processor some thirty cycles one after the other, and twenty beside each other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Root<T = f64> {
    /// The root.
    pub value: T,
    /// Its square, from which it was taken: it and its reciprocal have full precision.
    pub square: T,
}

impl<T: Scalar> Root<T> {
    /// The root with the sign of the assembly.
    #[inline(always)]
    pub(super) fn of(square: T, assembly: Assembly) -> Self {
        Self {
            value: square.sqrt().signed(assembly),
            square,
        }
    }
}
