//! The planar four-bar linkage by Freudenstein's equations, one for the rocker and one for the coupler.

use crate::Assembly;

crate::mechanism! {
    /// Planar four-bar linkage by Freudenstein's two scalar equations.
    ///
    /// It is the same linkage as [`FourBar`](super::FourBar). Each equation has two solutions, but only two of the four
    /// combinations close the linkage: [`OPEN`](FreudensteinFourBar::OPEN) and
    /// [`CROSSED`](FreudensteinFourBar::CROSSED).
    ///
    /// Source of the rocker's equation: F. Freudenstein, "Approximate synthesis of four-bar linkages", Transactions of
    /// the ASME 77, 1955. The coupler's equation is its counterpart.
    pub struct FreudensteinFourBar {
        /// Ground link.
        pub r1: Length,
        /// Crank.
        pub r2: Length,
        /// Coupler.
        pub r3: Length,
        /// Rocker.
        pub r4: Length,
    }
    input
        /// The crank's angle.
        theta2: Angle;
    unknown
        /// The coupler's angle.
        theta3: Angle,
        /// The rocker's angle.
        theta4: Angle;

    let k1 = r1 / r2;
    let k2 = r1 / r4;
    let k3 = (r2.powi(2) - r3.powi(2) + r4.powi(2) + r1.powi(2)) / (2 * r2 * r4);
    let k4 = r1 / r3;
    let k5 = (r4.powi(2) - r1.powi(2) - r2.powi(2) - r3.powi(2)) / (2 * r2 * r3);

    k1 * cos(theta4) - k2 * cos(theta2) + k3 == cos(theta2 - theta4);
    k1 * cos(theta3) + k4 * cos(theta2) + k5 == cos(theta2 - theta3);

    let pin = r2 * cis(theta2);
    let pivot = vec2(r1, 0);
    let joint = pivot + r4 * cis(theta4);
    ground 0, pivot;
    body r2: 0, pin;
    body r3: pin, joint;
    body r4: pivot, joint;
}

impl FreudensteinFourBar {
    /// The open linkage, which is [`Assembly::Open`] of [`FourBar`](super::FourBar).
    pub const OPEN: FreudensteinFourBarAssembly = FreudensteinFourBarAssembly {
        theta3: Assembly::Crossed,
        theta4: Assembly::Crossed,
    };
    /// The crossed linkage, which is [`Assembly::Crossed`] of [`FourBar`](super::FourBar).
    pub const CROSSED: FreudensteinFourBarAssembly = FreudensteinFourBarAssembly {
        theta3: Assembly::Open,
        theta4: Assembly::Open,
    };
}
