//! What all poses of a mechanism have in common, whatever their order.

use core::fmt::Debug;

use crate::Mechanism;

/// A pose of the mechanism `M` through any order: the position at least, with as many derivatives as were solved for.
///
/// Every structure that the solvers of `M` return is one, from its position to its snap. What depends on the position
/// alone takes any of them.
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
/// assert_eq!(PoseOf::<FourBar>::unknown_values(&position), velocity.unknown_values());
/// # Ok::<(), SolveError>(())
/// ```
pub trait PoseOf<M: Mechanism>: Copy + Debug {
    /// The values of the inputs, in the order in which they were declared.
    fn input_values(&self) -> M::Inputs<M::Scalar>;

    /// The values of the unknowns, in the order in which they were declared.
    fn unknown_values(&self) -> M::Unknowns<M::Scalar>;
}
