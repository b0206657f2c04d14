//! The common interface of mechanisms with sensitivities.

use core::fmt::Debug;

use crate::mechanism::{Mechanism, Pose};
use crate::number::{Operations, Row};

/// A mechanism that knows how its motion depends on its parameters: one that is declared `with sensitivities;`.
///
/// Only `mechanism!` implements it. A new version may add items.
///
/// ```
/// use kin_core::prelude::*;
///
/// mechanism! {
///     pub struct FourBar { pub r1: Length, pub r2: Length, pub r3: Length, pub r4: Length }
///     input theta2: Angle;
///     unknown theta3: Angle, theta4: Angle;
///     r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
///     with sensitivities;
/// }
///
/// /// By how much the unknowns move, at most, if each parameter is off by no more than `tolerance`.
/// fn play<M: Sensitive<Scalar = f64>>(mechanism: &M, pose: &M::Pose, tolerance: f64) -> M::Unknowns<f64> {
///     let partials = mechanism.sensitivities_of(pose);
///     M::Unknowns::from_fn(|unknown| {
///         let position = |partial: &M::Partials| partial.unknown_partials()[unknown][0];
///         partials.as_ref().iter().map(|partial| tolerance * position(partial).abs()).sum()
///     })
/// }
///
/// let linkage: FourBar = FourBar { r1: 90.0, r2: 30.0, r3: 60.0, r4: 45.0 };
/// let pose = linkage.solve(Motion::at_constant_speed(1.1, 10.0), Assembly::Open)?;
/// assert!(play(&linkage, &pose, 0.1)[1] < 0.01);
///
/// // one derivative of all: of the rocker's angular velocity with respect to the length of the coupler
/// let by = linkage.sensitivities(&pose);
/// println!("{} rad/s for each unit of length", by.r3.theta4.velocity());
/// # Ok::<(), SolveError>(())
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` is declared without sensitivities",
    label = "not declared `with sensitivities;`",
    note = "write `with sensitivities;` in its declaration"
)]
pub trait Sensitive: Mechanism {
    /// The derivatives with respect to one parameter.
    type Partials: Partials<
            Motion = Self::Motion<Self::Scalar>,
            Unknowns<Self::Motion<Self::Scalar>> = Self::Unknowns<Self::Motion<Self::Scalar>>,
            Outputs<Self::Motion<Self::Scalar>> = <Self::Pose as Pose>::Outputs<Self::Motion<Self::Scalar>>,
        >;

    /// The cost of the derivatives with respect to all parameters, on top of the solvers.
    const SENSITIVITY_OPERATIONS: Operations;

    /// The derivatives with respect to each scalar parameter, as the inherent method `sensitivities` returns them. The
    /// pose must be one of this mechanism.
    fn sensitivities_of(&self, pose: &Self::Pose) -> Self::Parameters<Self::Partials>;
}

/// The partial derivatives of a motion with respect to one parameter, in all its orders. Entry n is the derivative of
/// the n-th time derivative.
///
/// Only `mechanism!` implements it. A new version may add items.
pub trait Partials: Copy + Debug {
    /// A value with its time derivatives.
    type Motion: Copy;
    /// A value for each unknown.
    type Unknowns<V: Copy>: Row<V>;
    /// A value for each scalar output.
    type Outputs<V: Copy>: Row<V>;

    /// The partial derivatives of the unknowns, in the order in which they were declared.
    fn unknown_partials(&self) -> Self::Unknowns<Self::Motion>;

    /// The partial derivatives of the outputs, in the order in which they were declared. A point is its x, then its y.
    fn output_partials(&self) -> Self::Outputs<Self::Motion>;
}
