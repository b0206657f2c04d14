//! A mechanism and its loads.

use crate::failure::SolveError;
use crate::load::dynamics::{self, EquivalentInertia};
use crate::load::{Balance, Change, LoadError, Moving, totals};
use crate::mechanism::Mechanism;
use crate::motion::Contains;
use crate::number::{Number, Row};

/// Loads of the mechanism `M`, whichever they are. Do not implement it: a new version may add items.
#[diagnostic::on_unimplemented(
    message = "the loads are not those of `{M}`",
    label = "declare the loads for this mechanism and its number type, as in `Loads::<Press>::new()`",
    note = "along a sweep the number type is `Local`: `Loads::<Press<Local>>::new()`, or a function of any number \
    type, `fn loads<T: Scalar>() -> Loads<Press<T>, impl Load<Press<T>>>`"
)]
pub trait LoadsOf<M: Mechanism> {
    /// The balance in the pose that `solve` finds, for numbers with their change along one input each.
    #[doc(hidden)]
    fn balance(
        &self,
        mechanism: &M,
        inputs: M::Inputs<M::Motion<M::Scalar>>,
        solve: impl Fn(&totals::ChangingMechanism<M>, totals::ChangingInputs<M>) -> Result<Moving<M>, SolveError>,
    ) -> Result<Balance<M>, LoadError>;
}

/// The loads of a mechanism: what its drives must give, and how it moves by given efforts.
pub trait Loaded: Mechanism {
    /// The balance of loads and drives in the pose at given motions of the inputs.
    ///
    /// The mechanism is solved once for each input, over numbers with their change. Where it has a single position,
    /// there is no assembly to give: `lift.balance(&loads, [motion])`.
    ///
    /// # Errors
    /// Returns [`LoadError::Solve`] where the mechanism has no pose, and the other errors for loads without a result
    /// there.
    fn balance(
        &self,
        loads: &impl LoadsOf<Self>,
        inputs: Self::Inputs<Self::Motion<Self::Scalar>>,
        assembly: Self::Assembly,
    ) -> Result<Balance<Self>, LoadError> {
        loads.balance(self, inputs, |changing, moved| changing.solve(moved, assembly))
    }

    /// [`balance`](Self::balance), in the pose closest to values of the unknowns.
    ///
    /// # Errors
    /// As for [`balance`](Self::balance).
    fn balance_near(
        &self,
        loads: &impl LoadsOf<Self>,
        inputs: Self::Inputs<Self::Motion<Self::Scalar>>,
        near: Self::Unknowns<Self::Scalar>,
    ) -> Result<Balance<Self>, LoadError> {
        let zero = Self::Scalar::constant(0.0);
        loads.balance(self, inputs, |changing, moved| {
            changing.solve_near(moved, Row::from_fn(|unknown| Change::new(near[unknown], zero)))
        })
    }

    /// The matrix of equivalent inertias with its derivatives by the inputs, at given values of the inputs.
    ///
    /// The derivatives are those along a motion of one input at unit speed, for each in turn. So no speed is divided
    /// by.
    ///
    /// # Errors
    /// Returns the errors of [`balance`](Self::balance).
    ///
    /// ```
    /// use kin_core::library::SliderCrank;
    /// use kin_core::load::Loads;
    /// use kin_core::prelude::*;
    ///
    /// // a piston of 2 kg feels like an inertia of 2 (ds/dtheta)²
    /// let engine = SliderCrank { r: 0.05, l: 0.15 };
    /// let piston = Loads::<SliderCrank>::new().mass(2.0, |pose| Motion::from_coordinates(pose.s, 0.0 * pose.s));
    /// let felt = engine.equivalent_inertia(&piston, [1.0], Assembly::Open)?;
    /// let pose = engine.solve(Motion::at_constant_speed(1.0, 1.0), Assembly::Open)?;
    /// let (slope, bend) = (pose.s.velocity(), pose.s.acceleration());
    /// assert!((felt.matrix[0][0] - 2.0 * slope * slope).abs() < 1e-16);
    /// assert!((felt.slopes[0][0][0] - 4.0 * slope * bend).abs() < 1e-16);
    /// # Ok::<(), kin_core::load::LoadError>(())
    /// ```
    fn equivalent_inertia(
        &self,
        loads: &impl LoadsOf<Self>,
        inputs: Self::Inputs<f64>,
        assembly: Self::Assembly,
    ) -> Result<EquivalentInertia<Self>, LoadError>
    where
        Self: Mechanism<Scalar = f64>,
    {
        dynamics::equivalent_inertia(inputs, |moving| self.balance(loads, moving, assembly))
    }

    /// The accelerations of the inputs under given efforts of their drives, from their values and velocities: forward
    /// dynamics. Without drives, the efforts are zero.
    ///
    /// The equations of motion are J q'' = Q - R, with the matrix J of equivalent inertias, the efforts Q, and the
    /// efforts R that the same velocities would need without acceleration. A solver of ordinary differential equations
    /// turns them into a motion. The mechanism's order must be 2 or higher.
    ///
    /// # Errors
    /// Returns the errors of [`balance`](Self::balance), [`LoadError::NoInertia`] if the matrix is not positive
    /// definite up to rounding, and [`LoadError::NotFinite`] if an effort or an acceleration is not finite.
    ///
    /// ```
    /// use kin_core::library::SliderCrank;
    /// use kin_core::load::Loads;
    /// use kin_core::prelude::*;
    ///
    /// let engine = SliderCrank { r: 0.05, l: 0.15 };
    /// let loads = Loads::<SliderCrank>::new()
    ///     .inertia(0.01, |pose| pose.theta)
    ///     .mass(2.0, |pose| Motion::from_coordinates(pose.s, 0.0 * pose.s));
    /// let [acceleration] = engine.accelerations(&loads, [1.0], [30.0], [5.0], Assembly::Open)?;
    /// // the drive of a crank with this acceleration has that torque
    /// let crank = Motion::from((1.0, 30.0, acceleration, 0.0, 0.0));
    /// let [torque] = engine.balance(&loads, [crank], Assembly::Open)?.efforts();
    /// assert!((torque.value() - 5.0).abs() < 1e-13);
    /// # Ok::<(), kin_core::load::LoadError>(())
    /// ```
    fn accelerations(
        &self,
        loads: &impl LoadsOf<Self>,
        inputs: Self::Inputs<f64>,
        velocities: Self::Inputs<f64>,
        efforts: Self::Inputs<f64>,
        assembly: Self::Assembly,
    ) -> Result<Self::Inputs<f64>, LoadError>
    where
        Self: Mechanism<Scalar = f64>,
        Self::Motion<f64>: Contains<2>,
    {
        dynamics::accelerations(inputs, velocities, efforts, |moving| {
            self.balance(loads, moving, assembly)
        })
    }
}

impl<M: Mechanism> Loaded for M {}
