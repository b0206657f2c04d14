//! The common interface of all poses of a mechanism, whatever their order.

use core::fmt::Debug;

use crate::mechanism::Mechanism;

/// A pose of the mechanism `M` of any order: the position, with as many derivatives as were solved for.
///
/// Every structure that a solver of `M` returns implements this trait, from position to snap. Functions that need only
/// the position accept any of them.
///
/// Only `mechanism!` implements it. A new version may add items.
///
/// ```
/// use kin_core::library::FourBar;
/// use kin_core::prelude::*;
/// use kin_core::PoseOf;
///
/// let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 60.0, r4: 45.0 };
/// let position = linkage.position(1.0, Assembly::Open)?;
/// let velocity = position.velocity(-10.0);
/// assert_eq!(position.input_values(), [1.0]);
/// assert_eq!(position.unknowns(), velocity.unknowns());
/// # Ok::<(), SolveError>(())
/// ```
pub trait PoseOf<M: Mechanism>: Copy + Debug {
    /// The values of the inputs and of the unknowns.
    fn values(&self) -> (M::Inputs<M::Scalar>, M::Unknowns<M::Scalar>);

    /// The values of the inputs, in the order in which they were declared.
    fn input_values(&self) -> M::Inputs<M::Scalar> {
        self.values().0
    }

    /// The values of the unknowns, in the order in which they were declared. `position_near` and `solve_near` take them
    /// in this form.
    fn unknowns(&self) -> M::Unknowns<M::Scalar> {
        self.values().1
    }
}
