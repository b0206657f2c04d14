//! What all poses of a mechanism have in common, whatever their order.

use core::fmt::Debug;

use crate::mechanism::{Mechanism, condition};

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

    /// The values of the unknowns, in the order in which they were declared: as `position_near` and `solve_near` take them.
    fn unknowns(&self) -> M::Unknowns<M::Scalar> {
        self.values().1
    }

    /// The condition of each unknown's value, in the unit of the unknown: rounding changes the value by about this times ε, the
    /// [distance](crate::Number::EPSILON) from 1 to the next number.
    ///
    /// It is the sum of the changes to first order that the following make of the unknown, each changed by a part ε of itself and alone:
    /// every parameter and every input; the term of every unknown in every equation, where an angle's term is that of a radian; and
    /// the unknown itself. It is calculated in double precision, for any number type, from the closure at the position and its derivatives
    /// alone. This takes as many evaluations of the closure as there are parameters, inputs and unknowns, and the factors of a matrix.
    ///
    /// It is infinite if the Jacobian is singular to all digits. It is no more than a warning where ε times its square is not small, as the
    /// first order does not suffice there: above some 10⁷ in double precision, next to a limit position, half of the digits are left.
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
        condition::conditions(mechanism, &self.input_values(), &self.unknowns())
    }

    /// The largest of the [conditions](Self::conditions), where angles are measured in radians, lengths in the longest length of the
    /// mechanism, and plain numbers by their own size if that is larger than 1. If it reaches the reciprocal of ε, no digit of the position
    /// can be relied on.
    fn condition(&self, mechanism: &M) -> f64 {
        condition::condition(mechanism, &self.input_values(), &self.unknowns())
    }
}
