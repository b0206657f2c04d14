//! What a solver finds from the parameters alone.

use super::Mechanism;
use crate::failure::{Failure, SolveError};

/// A mechanism whose solver has found all that depends on the parameters alone, so that each pose takes less time. The
/// numbers of a pose are those of the mechanism, to the last bit.
///
/// It pays for spherical and spatial linkages, whose axes and arcs are parameters, and for links with three joints. For
/// a four-bar of two dimensions there is nothing to prepare. A [`Batch`](crate::batch::Batch) with the same parameters
/// in all poses is prepared in any case.
///
/// ```
/// use kin_core::Prepared;
/// use kin_core::library::SphericalFourBar;
/// use kin_core::prelude::*;
///
/// let [ground, crank, coupler, rocker] = [80.0, 25.0, 70.0, 60.0].map(f64::to_radians);
/// let linkage = SphericalFourBar { ground, crank, coupler, rocker };
/// let prepared = Prepared::of(linkage);
/// for step in 0..10 {
///     let motion = Motion::at_constant_speed(0.1 * f64::from(step), 20.0);
///     let pose = prepared.solve([motion], Assembly::Open)?;
///     assert_eq!(pose, linkage.solve(motion, Assembly::Open)?);
/// }
/// # Ok::<(), kin_core::SolveError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Prepared<M: Mechanism> {
    mechanism: M,
    prepared: M::Prepared,
}

impl<M: Mechanism> Prepared<M> {
    /// A prepared mechanism.
    #[inline]
    pub fn of(mechanism: M) -> Self {
        Self {
            mechanism,
            prepared: mechanism.prepare(),
        }
    }

    /// The mechanism.
    #[inline]
    pub const fn mechanism(&self) -> &M {
        &self.mechanism
    }

    /// The position and all time derivatives.
    ///
    /// # Errors
    /// As for [`Mechanism::solve`].
    #[inline]
    pub fn solve(&self, inputs: M::Inputs<M::Motion<M::Scalar>>, assembly: M::Assembly) -> Result<M::Pose, SolveError> {
        self.mechanism.solve_prepared(&self.prepared, inputs, assembly)
    }
}

/// What generated code prepares, or the failure and its block, which becomes an error where the inputs are known.
pub type Preparation<P> = Result<P, (Failure, &'static str)>;
