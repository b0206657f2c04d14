//! Klann's walking leg.

use core::f64::consts::PI;

use crate::{Assembly, Plane};

crate::mechanism! {
    /// Klann's leg: a Stephenson six-bar linkage of the third kind, whose foot moves straight for half a revolution of
    /// the crank and is lifted for the other half.
    ///
    /// The crank turns about the origin and drives a bent connecting arm. The lower rocker holds the bend of the arm,
    /// which is the elbow. The end of the arm is the knee of a bent leg, and the upper rocker holds the hip of that
    /// leg.
    ///
    /// [`PATENT`](KlannLeg::PATENT) has the dimensions of J. C. Klann, "Walking device", US patent 6,260,862, 2001, as
    /// they follow from its coordinates: the axles of the crank at (1.599, 0.750), of the lower rocker at (1.009,
    /// 0.574) and of the upper rocker at (1.366, 1.366), a crank of 0.268, and 0.590 from its pin to the elbow. With
    /// these dimensions the foot moves from (1, 0) at the crank angle 0 to (0, 0) at 180°, a stride of 1. On the way it
    /// deviates from the straight line by 5.5 % of the stride. All coordinates here are relative to the crank's axle.
    ///
    /// ```
    /// use kin_core::library::KlannLeg;
    /// use kin_core::prelude::*;
    ///
    /// let leg = KlannLeg::PATENT;
    /// let foot = |degrees: f64| {
    ///     leg.position(degrees.to_radians(), KlannLeg::WALKING).map(|position| position.foot.value())
    /// };
    /// let (start, end) = (foot(0.0)?, foot(180.0)?);
    /// assert!((start.x - (1.0 - 1.599)).abs() < 1e-3 && (start.y - (0.0 - 0.75)).abs() < 1e-3);
    /// assert!((start.x - end.x - 1.0).abs() < 1e-3 && (start.y - end.y).abs() < 1e-3);
    /// # Ok::<(), SolveError>(())
    /// ```
    pub struct KlannLeg {
        /// Crank.
        pub crank: Length,
        /// The connecting arm from the crank's pin to the elbow.
        pub arm: Length,
        /// The connecting arm from the elbow to the knee.
        pub forearm: Length,
        /// Angle of the bend of the connecting arm at the elbow, clockwise.
        pub elbow_bend: Angle,
        /// The axle of the lower rocker.
        pub lower_axle: Point,
        /// The lower rocker.
        pub lower_rocker: Length,
        /// The axle of the upper rocker.
        pub upper_axle: Point,
        /// The upper rocker.
        pub upper_rocker: Length,
        /// The leg from the knee to the hip.
        pub thigh: Length,
        /// The leg from the knee to the foot.
        pub shin: Length,
        /// The angle at the knee, clockwise from the thigh to the shin.
        pub knee: Angle,
    }
    input
        /// The crank's angle.
        theta: Angle;
    unknown
        /// The angle of the connecting arm at the crank.
        phi: Angle,
        /// The lower rocker's angle.
        lower: Angle,
        /// The thigh's angle.
        psi: Angle,
        /// The upper rocker's angle.
        upper: Angle;

    let elbow = crank * cis(theta) + arm * cis(phi);
    elbow == lower_axle + lower_rocker * cis(lower);
    let knee_point = elbow + forearm * cis(phi - elbow_bend);
    knee_point + thigh * cis(psi) == upper_axle + upper_rocker * cis(upper);

    /// The foot.
    output foot: Point = knee_point + shin * cis(psi - knee);
}

impl KlannLeg {
    /// The patent's dimensions, with the stride as the unit of length.
    pub const PATENT: Self = Self {
        crank: 0.268,
        arm: 0.590,
        forearm: 0.5221,
        elbow_bend: 12.84 * PI / 180.0,
        lower_axle: Plane::new(-0.590, -0.176),
        lower_rocker: 0.3206,
        upper_axle: Plane::new(-0.233, 0.616),
        upper_rocker: 0.5177,
        thigh: 0.8966,
        shin: 0.8966,
        knee: 5.0 * PI / 6.0,
    };
    /// The assembly in which the leg of the patent walks.
    pub const WALKING: KlannLegAssembly = KlannLegAssembly {
        phi_lower: Assembly::Crossed,
        psi_upper: Assembly::Open,
    };
}
