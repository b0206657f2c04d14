//! The common interface of all poses of a mechanism, whatever their order.

use core::fmt::Debug;

use crate::failure::SolveError;
#[cfg(feature = "alloc")]
use crate::mechanism::jacobian::{Jacobian, JacobianError, rows_of};
use crate::mechanism::{Mechanism, condition};
#[cfg(feature = "alloc")]
use crate::number::Number;

/// A pose of the mechanism `M` of any order: the position, with as many derivatives as were solved for.
///
/// Every structure that a solver of `M` returns implements this trait, from position to snap. Functions that need only
/// the position accept any of them.
///
/// Only [`mechanism!`](crate::mechanism!) implements it. A new version may add items.
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

    /// The Jacobian of the pose: the partial derivatives of the unknowns, then of the scalar outputs, with respect to the
    /// inputs.
    ///
    /// It has a row for each unknown and then for each scalar output, and in each row a number for each input, all in the
    /// order in which they were declared. A point has a row for x, a row for y and, in space, a row for z. An entry has the
    /// unit of its unknown or output over that of its input: radians per radian, lengths per radian, and so on. A row
    /// times the velocities of the inputs is the velocity of its unknown or output, and the transposed rows turn forces
    /// into the efforts of the inputs.
    ///
    /// It does not depend on the velocity of the pose, and never divides by it: the position is solved again from the
    /// unknowns of the pose, and the velocity once for each input.
    ///
    /// # Errors
    /// Returns the errors of `position_near`: the pose is not one of this mechanism, or so close to a singular position
    /// that rounding decides whether it closes.
    ///
    /// ```
    /// use kin_core::library::FourBar;
    /// use kin_core::prelude::*;
    ///
    /// let linkage: FourBar = FourBar { r1: 90.0, r2: 30.0, r3: 60.0, r4: 45.0 };
    /// let pose = linkage.solve(Motion::at_constant_speed(1.1, 10.0), Assembly::Open)?;
    /// let [[theta3], [theta4]] = pose.jacobian(&linkage)?;
    /// assert!((10.0 * theta3 - pose.theta3.velocity()).abs() < 1e-13);
    /// assert!((10.0 * theta4 - pose.theta4.velocity()).abs() < 1e-13);
    /// # Ok::<(), SolveError>(())
    /// ```
    fn jacobian(&self, mechanism: &M) -> Result<M::Results<M::Inputs<M::Scalar>>, SolveError> {
        let (inputs, unknowns) = self.values();
        mechanism.jacobian_near(inputs, unknowns)
    }

    /// The rows of the [`jacobian`](Self::jacobian) for unknowns or outputs of these names, with their singular values. A point
    /// has a row for each of its coordinates.
    ///
    /// All of these results must have one dimension, and all inputs must have one: see [`Jacobian`](crate::Jacobian), which
    /// tells what singular values mean. Along a sweep, [`of_jacobian`](crate::sweep::Course::of_jacobian) finds where they
    /// are smallest.
    ///
    /// ```
    /// use kin_core::library::FiveBar;
    /// use kin_core::prelude::*;
    ///
    /// let robot = FiveBar { ground: 2.0, left: 1.5, left_rod: 2.0, right_rod: 2.0, right: 1.5 };
    /// let pose = robot.position(2.2, 0.9, Assembly::Open)?;
    /// // lengths of the hand's way for each radian of the cranks
    /// let values = pose.jacobian_of(&robot, &["hand"])?.singular_values();
    /// assert!(values[0] > values[1] && values[1] > 0.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`JacobianError`](crate::JacobianError) for names that no result has, for mixed dimensions, and with the errors of
    /// [`jacobian`](Self::jacobian).
    #[cfg(feature = "alloc")]
    #[cfg_attr(docsrs, doc(cfg(feature = "alloc")))]
    fn jacobian_of(&self, mechanism: &M, results: &[&str]) -> Result<Jacobian<f64>, JacobianError> {
        let rows = rows_of(&M::DESCRIPTION, results)?;
        let jacobian = self.jacobian(mechanism)?;
        let entry = |row: usize, column: usize| jacobian[rows[row]][column].real();
        Ok(Jacobian::from_fn(rows.len(), M::DESCRIPTION.inputs.len(), entry))
    }

    /// The condition of each unknown, in the unit of the unknown: rounding changes its value by about this times ε, the
    /// [distance](crate::Number::EPSILON) from 1 to the next number.
    ///
    /// The condition is the sum of the first-order changes of the unknown that are caused by changing each of the
    /// following alone by a part ε of itself: every parameter and every input; the term of every unknown in every
    /// equation, where the term of an angle is the term of one radian; and the unknown itself. It is calculated in
    /// double precision for any number type, from the closure at the position and its derivatives alone. This takes one
    /// evaluation of the closure per parameter, input and unknown, and the factors of a matrix.
    ///
    /// The condition is infinite if the Jacobian is singular to all digits. If ε times its square is not small, it is
    /// only a warning, because the first order is not sufficient there: above about 10⁷ in double precision, next to a
    /// limit position, only half of the digits are right.
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

    /// The largest of the [conditions](Self::conditions), with angles measured in radians, lengths relative to the
    /// longest length of the mechanism, and plain numbers relative to their own size if that is larger than 1. From 1/ε
    /// on, no digit of the position is reliable.
    fn condition(&self, mechanism: &M) -> f64 {
        condition::condition(mechanism, &self.input_values(), &self.unknowns())
    }
}
