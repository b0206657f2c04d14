//! A square root together with its square.

use crate::assembly::Assembly;
use crate::solve::Scalar;
use crate::solve::check::Check;

/// A square root with a sign, and its square.
///
/// Rates are divided by roots. `value / square` equals the reciprocal of the root, and `1 / square` can be computed
/// without waiting for it: a root followed by a division takes a processor about thirty cycles; in parallel they take
/// twenty.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Root<T = f64> {
    /// The root.
    pub value: T,
    /// The square from which the root was taken. It and its reciprocal have full precision.
    pub square: T,
}

impl<T: Scalar> Root<T> {
    /// The root with the sign of the assembly, if a check holds.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn provided<const N: usize, const K: usize>(
        square: T,
        check: impl Check<T, N, K>,
        assembly: Assembly,
    ) -> Option<Self> {
        let (square, root) = square.rooted(check)?;
        Some(Self {
            value: root.signed(assembly),
            square,
        })
    }

    /// The root with the sign of the assembly.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn of(square: T, assembly: Assembly) -> Self {
        Self {
            value: square.sqrt().signed(assembly),
            square,
        }
    }
}
