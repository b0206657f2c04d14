//! What all poses of a mechanism have in common, whatever their order.

use core::fmt::Debug;

use crate::Mechanism;
use crate::condition;

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

    /// By how much rounding can change each unknown's value, in the unit of the unknown and in multiples of ε, the
    /// [distance](crate::Scalar::EPSILON) from 1 to the next number: the position is known to about ε times this, and to no less.
    ///
    /// It is the sum of the changes that the following make of the unknown to first order, each changed by a part ε of itself and alone:
    /// every parameter and every input; the terms of every equation, each unknown's, where that of an angle is the one of a radian; and
    /// the unknown itself. The closure at the position and its derivatives are all that it is calculated from, in double precision and
    /// for any number type. So it takes as many evaluations of the closure as there are parameters, inputs and unknowns, and the
    /// factors of a matrix.
    ///
    /// Infinite if the Jacobian is singular there to all digits. The first order is all there is as long as ε times the square of an angle's
    /// condition is small: next to a limit position, above some 10⁷ in double precision, half of the digits are left, and it is no more than
    /// a warning.
    ///
    /// ```
    /// use kin_core::library::FourBar;
    /// use kin_core::prelude::*;
    ///
    /// let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 60.0, r4: 45.0 };
    /// let position = linkage.position(1.0, Assembly::Open)?;
    /// let [theta3, theta4] = position.conditions(&linkage);
    /// assert!(theta3 < 10.0 && theta4 < 10.0);
    ///
    /// let near_the_limit = linkage.position(1.955, Assembly::Open)?;
    /// let [_, theta4] = near_the_limit.conditions(&linkage);
    /// println!("{} ± {:e} rad", near_the_limit.theta4.position(), f64::EPSILON * theta4);
    /// assert!(theta4 > 1e2);
    /// # Ok::<(), SolveError>(())
    /// ```
    fn conditions(&self, mechanism: &M) -> M::Unknowns<f64> {
        condition::conditions(mechanism, &self.input_values(), &self.unknown_values())
    }

    /// The largest of the [conditions](Self::conditions), where angles are measured in radians, lengths in the longest one that there is, and
    /// plain numbers by themselves if they are larger than 1: the reciprocal of ε, and no digit of the position can be relied on.
    fn condition(&self, mechanism: &M) -> f64 {
        condition::condition(mechanism, &self.input_values(), &self.unknown_values())
    }
}
