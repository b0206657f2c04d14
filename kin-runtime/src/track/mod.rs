//! Moving a mechanism from a known position to another one.

#[cfg(feature = "alloc")]
mod between;
mod cause;
mod follow;
mod limit;
mod line;
mod obstacle;
mod steps;
#[cfg(test)]
mod tests;

#[cfg(feature = "alloc")]
pub use between::track_between;
pub use obstacle::{TrackError, TrackLimit, TrackStop};
pub use steps::MOST_TRACK_STEPS;

use line::TrackPosition;

use crate::any::Of;
use crate::failure::SolveError;
use crate::mechanism::{Mechanism, PoseOf};
use crate::number::{Number, Row};

/// The [`TrackError`] of a mechanism, with its inputs and unknowns in double precision.
pub type TrackErrorOf<M> = TrackError<<M as Mechanism>::Inputs<f64>, <M as Mechanism>::Unknowns<f64>>;

/// Moves the inputs on a straight line from one point to another, and moves the mechanism with them without leaving its
/// assembly.
///
/// `from_unknowns` are the unknowns at `from_inputs`, or values close enough for
/// [`position_near`](Mechanism::position_near). The result contains the unknowns at `to_inputs`, in radians
/// or the mechanism's unit. Angles are unwrapped, so a crank ends 2π further after a full revolution.
///
/// This is a continuation method. The Taylor series of the mechanism's solvers predicts each step, to the order of
/// the mechanism, and [`solve_near`](Mechanism::solve_near) corrects it. A step is accepted if prediction
/// and correction agree in the unknowns and their rates, and if the determinant of each block's Jacobian keeps its
/// sign, and its size within a factor of two, at every quarter of the step. Two changes of sign could hide only if a
/// determinant fell to zero and recovered within a quarter of a step on which the series is accurate. The last terms of
/// the series and these tests determine the length of the steps.
///
/// If an unknown moves more than 32 times as fast as the inputs, it becomes the parameter and the track solves for the
/// inputs instead. A limit position is then a regular point: the zero of the inputs' rate. Newton's method finds it,
/// and the inputs there are exact to rounding.
///
/// # Steps
/// A track takes at most 100 000 steps, including rejected ones. A step is one solution by the mechanism's
/// solvers or, where an unknown is the parameter, one solution by at most 64 corrections. Locating an obstacle takes at
/// most 64 more solutions.
///
/// The effect of rounding errors of the closure on the unknowns does not count as a difference between prediction and
/// correction, so long links in a loop of short ones do not force short steps. Short steps without progress are
/// counted: after 256 in a row that are shorter than 10⁻⁶, or 32 that do not change the inputs, the track looks for the
/// cause.
///
/// The track runs in double precision; a number type that carries derivatives gets them at the end.
///
/// # Errors
/// [`TrackError::TurningPoint`], [`TrackError::ChangePoint`] and [`TrackError::Pole`] with the position.
/// [`TrackError::Failed`] if there is no position at the start, or if something else ends the track: at the end of the
/// domain of a function, or of the range of an unknown, its inputs are the first ones beyond, to the last digit.
/// [`TrackError::TooManySteps`] and [`TrackError::Lost`] with the last position and the reason for stopping there.
///
/// ```
/// use core::f64::consts::TAU;
/// use kin_core::library::FourBar;
/// use kin_core::prelude::*;
/// use kin_core::{TrackError, track};
///
/// // a crank-rocker goes all the way round
/// let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 70.0, r4: 60.0 };
/// for assembly in Assembly::BOTH {
///     let start = linkage.position(0.5, assembly)?.unknowns();
///     let end = track(&linkage, [0.5], start, [0.5 + TAU])?;
///     assert!((end[0] - start[0]).abs() < 1e-13 && (end[1] - start[1]).abs() < 1e-13);
/// }
///
/// // with a shorter coupler the crank comes as far as cos(theta2) = (r1² + r2² - (r3 + r4)²) / (2 r1 r2)
/// let (r1, r2, r3, r4) = (90.0_f64, 30.0, 60.0, 45.0);
/// let linkage = FourBar { r1, r2, r3, r4 };
/// let start = linkage.position(0.5, Assembly::Open)?.unknowns();
/// let Err(TrackError::TurningPoint(limit)) = track(&linkage, [0.5], start, [3.0]) else {
///     panic!("the links do not reach");
/// };
/// let expected = ((r1 * r1 + r2 * r2 - (r3 + r4) * (r3 + r4)) / (2.0 * r1 * r2)).acos();
/// assert!((limit.inputs[0] - expected).abs() < 1e-14);
/// // where coupler and rocker are in line
/// assert!((limit.unknowns[0] - limit.unknowns[1] + core::f64::consts::PI).abs() < 1e-12);
/// assert_eq!(limit.block, "theta3, theta4");
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[doc(alias = "simulate")]
#[doc(alias = "continuation")]
pub fn track<M: Mechanism>(
    mechanism: &M,
    from_inputs: M::Inputs<M::Scalar>,
    from_unknowns: M::Unknowns<M::Scalar>,
    to_inputs: M::Inputs<M::Scalar>,
) -> Result<M::Unknowns<M::Scalar>, TrackErrorOf<M>> {
    let end = end(mechanism, (from_inputs, from_unknowns), to_inputs)?;
    Ok(mechanism.position_near(to_inputs, end)?)
}

/// [`track`] from a pose, where the caller solves the last position once, as the type it needs. `arrive` takes unknowns
/// that are close to it.
///
/// # Errors
/// Returns the errors of [`track`], and the error of `arrive`.
pub fn track_to<M: Mechanism, P>(
    mechanism: &M,
    pose: &impl PoseOf<M>,
    to_inputs: M::Inputs<M::Scalar>,
    arrive: impl FnOnce(M::Unknowns<M::Scalar>) -> Result<P, SolveError>,
) -> Result<P, TrackErrorOf<M>> {
    let end = end(mechanism, pose.values(), to_inputs)?;
    Ok(arrive(end)?)
}

/// The unknowns at the end of the track, before the last position is solved.
fn end<M: Mechanism>(
    mechanism: &M,
    (from_inputs, from_unknowns): (M::Inputs<M::Scalar>, M::Unknowns<M::Scalar>),
    to_inputs: M::Inputs<M::Scalar>,
) -> Result<M::Unknowns<M::Scalar>, TrackErrorOf<M>> {
    let real = |values: &M::Inputs<M::Scalar>| M::Inputs::<f64>::from_fn(|index| values[index].real());
    let (from, to) = (real(&from_inputs), real(&to_inputs));
    let parameters = mechanism.parameters();
    let parameters = M::Parameters::<f64>::from_fn(|index| parameters[index].real());
    let mut inputs = from;
    let mut unknowns = M::Unknowns::<f64>::from_fn(|index| from_unknowns[index].real());
    let followed = M::lend(|lent| {
        follow::follow(
            Of::<M>::FUNCTIONS,
            parameters.as_ref(),
            [from.as_ref(), to.as_ref()],
            TrackPosition {
                inputs: inputs.as_mut(),
                unknowns: unknowns.as_mut(),
            },
            lent,
        )
    });
    match followed {
        Ok(()) => Ok(Row::from_fn(|index| M::Scalar::constant(unknowns[index]))),
        Err(error) => Err(error.with_position(inputs, unknowns)),
    }
}
