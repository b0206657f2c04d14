//! The planar four-bar linkage by the geometric method: one scalar equation after another.

use crate::{Assembly, Number, Scalar};

crate::mechanism! {
    /// Planar four-bar linkage, solved triangle by triangle over the diagonal `e` from the crank's pin B to the
    /// rocker's pivot D.
    ///
    /// It is the same linkage as [`FourBar`](super::FourBar), with the diagonal and the angles beside it as unknowns.
    /// The sine rule does not determine whether `alpha` and `beta` are acute or obtuse, so these equations have eight
    /// assemblies. Two of them close the linkage at any position; [`assembly`](Self::assembly) returns them.
    pub struct GeometricFourBar {
        /// Ground link, AD.
        pub r1: Length,
        /// Crank, AB.
        pub r2: Length,
        /// Coupler, BC.
        pub r3: Length,
        /// Rocker, DC.
        pub r4: Length,
    }
    input
        /// The crank's angle.
        theta2: Angle;
    unknown
        /// The diagonal BD.
        e: Length where e > 0,
        /// The angle at D between DA and DB.
        alpha: Angle,
        /// The angle at C between CB and CD.
        gamma: Angle,
        /// The angle at D between DB and DC.
        beta: Angle,
        /// The rocker's angle.
        theta4: Angle,
        /// The coupler's angle.
        theta3: Angle;

    e.powi(2) == r1.powi(2) + r2.powi(2) - 2 * r1 * r2 * cos(theta2);
    sin(alpha) == r2 * sin(theta2) / e;
    cos(gamma) == (r3.powi(2) + r4.powi(2) - e.powi(2)) / (2 * r3 * r4);
    sin(beta) == r3 * sin(gamma) / e;
    alpha + beta + theta4 == PI;
    theta3 == theta4 - gamma;

    let pin = r2 * cis(theta2);
    let pivot = vec2(r1, 0);
    let joint = pivot + r4 * cis(theta4);
    ground 0, pivot;
    body r2: 0, pin;
    body r3: pin, joint;
    body r4: pivot, joint;
}

impl<T: Scalar> GeometricFourBar<T> {
    /// The assembly of these equations that corresponds to an assembly of the linkage, at a given crank angle.
    ///
    /// `alpha` is obtuse if the crank's pin lies beyond the rocker's pivot, and `beta` is obtuse if r3² > r4² + e².
    /// Both change only through a right angle, where the sine rule is singular.
    #[must_use]
    pub fn assembly(&self, theta2: T, assembly: Assembly) -> GeometricFourBarAssembly {
        let [r1, r2, r3, r4, theta2] = [self.r1, self.r2, self.r3, self.r4, theta2].map(Number::real);
        let along = r1 - r2 * Number::sin_cos(theta2).1;
        let square = r1 * r1 + r2 * r2 - 2.0 * r1 * r2 * Number::sin_cos(theta2).1;
        GeometricFourBarAssembly {
            alpha: Assembly::from_sign(along),
            gamma: assembly,
            beta: Assembly::from_sign(r4 * r4 + square - r3 * r3),
        }
    }
}
