//! Equivalent inertia with its derivatives, and accelerations from efforts.

use crate::load::{Load, LoadError, Loads, Rates};
use crate::mechanism::Mechanism;
use crate::number::{Number, Row};

/// The matrix of equivalent inertias at given inputs, with its partial derivatives.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct EquivalentInertia<M: Mechanism> {
    /// A row for each input: the kinetic energy is half the sum of the entries times the velocities of both inputs.
    pub matrix: M::Inputs<M::Inputs<f64>>,
    /// The partial derivative of the matrix with respect to each input.
    pub slopes: M::Inputs<M::Inputs<M::Inputs<f64>>>,
}

impl<M: Mechanism<Scalar = f64>, L: Load<M>> Loads<M, L> {
    /// The matrix of equivalent inertias with its derivatives by the inputs, at given values of the inputs.
    ///
    /// The derivatives are those along a motion of one input at unit speed, for each in turn. So no speed is divided by.
    ///
    /// # Errors
    /// Returns the errors of [`at`](Self::at).
    ///
    /// ```
    /// use kin_core::library::SliderCrank;
    /// use kin_core::load::{Change, Loads};
    /// use kin_core::prelude::*;
    ///
    /// // a piston of 2 kg feels like an inertia of 2 (ds/dtheta)²
    /// let engine = SliderCrank { r: 0.05, l: 0.15 };
    /// let piston = Loads::<SliderCrank>::new()
    ///     .mass(2.0, |pose| Motion::from_coordinates(pose.s, Motion::constant(Change::constant(0.0))));
    /// let felt = piston.equivalent_inertia(&engine, [1.0], Assembly::Open)?;
    /// let pose = engine.solve(Motion::at_constant_speed(1.0, 1.0), Assembly::Open)?;
    /// let (slope, bend) = (pose.s.velocity(), pose.s.acceleration());
    /// assert!((felt.matrix[0][0] - 2.0 * slope * slope).abs() < 1e-16);
    /// assert!((felt.slopes[0][0][0] - 4.0 * slope * bend).abs() < 1e-16);
    /// # Ok::<(), kin_core::load::LoadError>(())
    /// ```
    pub fn equivalent_inertia(
        &self,
        mechanism: &M,
        inputs: M::Inputs<f64>,
        assembly: M::Assembly,
    ) -> Result<EquivalentInertia<M>, LoadError> {
        let row_of_zeros: M::Inputs<f64> = M::Inputs::splat(0.0);
        let zeros: M::Inputs<M::Inputs<f64>> = M::Inputs::splat(row_of_zeros);
        let mut felt = EquivalentInertia::<M> {
            matrix: zeros,
            slopes: M::Inputs::splat(zeros),
        };
        for direction in 0..<M::Inputs<f64> as Row<f64>>::LENGTH {
            let moving = state::<M>(inputs, |input| if input == direction { 1.0 } else { 0.0 });
            let inertias = self.at(mechanism, moving, assembly)?.inertias();
            felt.matrix = entries_of::<M>(&inertias, 0);
            felt.slopes[direction] = entries_of::<M>(&inertias, 1);
        }
        Ok(felt)
    }

    /// The accelerations of the inputs under given efforts of their drives, from their values and velocities: forward dynamics. Without
    /// drives, the efforts are zero.
    ///
    /// The equations of motion are J q'' = Q - R, with the matrix J of equivalent inertias, the efforts Q, and the efforts R that the same
    /// velocities would need without acceleration. A solver of ordinary differential equations turns them into a motion. The mechanism's
    /// order must be 2 or higher.
    ///
    /// # Errors
    /// Returns the errors of [`at`](Self::at), [`LoadError::NoInertia`] if the matrix is not positive definite up to rounding, and
    /// [`LoadError::NotFinite`] if an effort or an acceleration is not finite.
    ///
    /// ```
    /// use kin_core::library::SliderCrank;
    /// use kin_core::load::{Change, Loads};
    /// use kin_core::prelude::*;
    ///
    /// let engine = SliderCrank { r: 0.05, l: 0.15 };
    /// let loads = Loads::<SliderCrank>::new()
    ///     .inertia(0.01, |pose| pose.theta)
    ///     .mass(2.0, |pose| Motion::from_coordinates(pose.s, Motion::constant(Change::constant(0.0))));
    /// let [acceleration] = loads.accelerations(&engine, [1.0], [30.0], [5.0], Assembly::Open)?;
    /// // the drive of a crank with this acceleration has that torque
    /// let crank = Motion::from((1.0, 30.0, acceleration, 0.0, 0.0));
    /// let [torque] = loads.at(&engine, [crank], Assembly::Open)?.efforts();
    /// assert!((torque.value() - 5.0).abs() < 1e-13);
    /// # Ok::<(), kin_core::load::LoadError>(())
    /// ```
    pub fn accelerations(
        &self,
        mechanism: &M,
        inputs: M::Inputs<f64>,
        velocities: M::Inputs<f64>,
        efforts: M::Inputs<f64>,
        assembly: M::Assembly,
    ) -> Result<M::Inputs<f64>, LoadError>
    where
        M::Motion<f64>: crate::motion::Contains<2>,
    {
        let moving = state::<M>(inputs, |input| velocities[input]);
        let balance = self.at(mechanism, moving, assembly)?;
        let (resisting, inertias) = (balance.efforts(), balance.inertias());
        let matrix = entries_of::<M>(&inertias, 0);
        let right = M::Inputs::from_fn(|input| efforts[input] - resisting[input].value());
        let accelerations = solve::<M>(matrix, right)?;
        let is_finite = accelerations
            .as_ref()
            .iter()
            .all(|acceleration| acceleration.is_finite());
        is_finite.then_some(accelerations).ok_or(LoadError::NotFinite)
    }
}

/// The motions of the inputs with given velocities, without acceleration.
fn state<M: Mechanism>(inputs: M::Inputs<f64>, velocity: impl Fn(usize) -> f64) -> M::Inputs<M::Motion<f64>> {
    M::Inputs::from_fn(|input| {
        let motion: M::Motion<f64> = Row::from_fn(|order| match order {
            0 => inputs[input],
            1 => velocity(input),
            _ => 0.0,
        });
        motion
    })
}

/// The matrix of inertias, order 0, or its derivative by time of another order.
fn entries_of<M: Mechanism>(inertias: &M::Inputs<M::Inputs<Rates<M, f64>>>, order: usize) -> M::Inputs<M::Inputs<f64>> {
    M::Inputs::from_fn(|row| {
        let own: &M::Inputs<Rates<M, f64>> = &inertias[row];
        let entries: M::Inputs<f64> = M::Inputs::from_fn(|column| own[column].as_slice()[order]);
        entries
    })
}

/// The solution of a positive definite system, by Cholesky's factors.
fn solve<M: Mechanism>(matrix: M::Inputs<M::Inputs<f64>>, right: M::Inputs<f64>) -> Result<M::Inputs<f64>, LoadError> {
    let count = <M::Inputs<f64> as Row<f64>>::LENGTH;
    let zeros: M::Inputs<f64> = M::Inputs::splat(0.0);
    let mut factor: M::Inputs<M::Inputs<f64>> = M::Inputs::splat(zeros);
    for row in 0..count {
        for column in 0..=row {
            let products = (0..column).map(|inner| factor[row][inner] * factor[column][inner]);
            let rest = matrix[row][column] - products.sum::<f64>();
            factor[row][column] = if column < row {
                rest / factor[column][column]
            } else if rest > f64::EPSILON * matrix[row][row] {
                Number::sqrt(rest)
            } else {
                return Err(LoadError::NoInertia { input: row });
            };
        }
    }
    let mut solution = right;
    for row in 0..count {
        let known = (0..row).map(|inner| factor[row][inner] * solution[inner]);
        solution[row] = (solution[row] - known.sum::<f64>()) / factor[row][row];
    }
    for row in (0..count).rev() {
        let known = (row + 1..count).map(|inner| factor[inner][row] * solution[inner]);
        solution[row] = (solution[row] - known.sum::<f64>()) / factor[row][row];
    }
    Ok(solution)
}
