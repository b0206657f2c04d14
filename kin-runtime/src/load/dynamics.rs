//! Equivalent inertia with its derivatives, and accelerations from efforts.

use crate::load::{Balance, LoadError, Rates};
use crate::mechanism::Mechanism;
use crate::motion::Contains;
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

/// The matrix of equivalent inertias, and its slopes along a motion of one input at unit speed each.
pub(super) fn equivalent_inertia<M: Mechanism<Scalar = f64>>(
    inputs: M::Inputs<f64>,
    balance: impl Fn(M::Inputs<M::Motion<f64>>) -> Result<Balance<M>, LoadError>,
) -> Result<EquivalentInertia<M>, LoadError> {
    let row_of_zeros: M::Inputs<f64> = M::Inputs::splat(0.0);
    let zeros: M::Inputs<M::Inputs<f64>> = M::Inputs::splat(row_of_zeros);
    let mut felt = EquivalentInertia::<M> {
        matrix: zeros,
        slopes: M::Inputs::splat(zeros),
    };
    for direction in 0..<M::Inputs<f64> as Row<f64>>::LENGTH {
        let moving = state::<M>(inputs, |input| if input == direction { 1.0 } else { 0.0 });
        let inertias = balance(moving)?.inertias();
        felt.matrix = entries_of::<M>(&inertias, 0);
        felt.slopes[direction] = entries_of::<M>(&inertias, 1);
    }
    Ok(felt)
}

/// The accelerations of the inputs by given efforts.
pub(super) fn accelerations<M>(
    inputs: M::Inputs<f64>,
    velocities: M::Inputs<f64>,
    efforts: M::Inputs<f64>,
    balance: impl Fn(M::Inputs<M::Motion<f64>>) -> Result<Balance<M>, LoadError>,
) -> Result<M::Inputs<f64>, LoadError>
where
    M: Mechanism<Scalar = f64>,
    M::Motion<f64>: Contains<2>,
{
    let moving = state::<M>(inputs, |input| velocities[input]);
    let balance = balance(moving)?;
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
