//! The planar four-bar linkage, as one vector loop.

use crate::{Number, Scalar};

crate::mechanism! {
    /// Planar four-bar linkage: ground 1, crank 2, coupler 3, rocker 4.
    ///
    /// The crank turns about the origin, the rocker about the point (`r1`, 0). Angles are measured
    /// counter-clockwise from the ground link.
    ///
    /// ```
    /// use kin_core::library::FourBar;
    /// use kin_core::prelude::*;
    ///
    /// let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 60.0, r4: 45.0 };
    /// let crank = Motion::from((65_f64.to_radians(), -10.0, 2.0, -0.5, 0.3));
    /// let motion = linkage.solve(crank, Assembly::Open)?;
    /// assert!((motion.theta4.position().to_degrees() - 114.8278).abs() < 5e-5);
    /// assert!((motion.theta4.snap() - 19274.1419586847).abs() < 1e-7);
    /// # Ok::<(), SolveError>(())
    /// ```
    pub struct FourBar {
        /// Ground link, from the crank's pivot to the rocker's.
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

    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
}

/// The crank angles at which a four-bar linkage closes: |theta2|, reduced to half a revolution, from `low` to `high`,
/// in radians.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CrankRange {
    /// The smallest angle between crank and ground; 0 if the crank passes the ground line.
    pub low: f64,
    /// The largest angle between crank and ground; π if the crank passes the extension of the ground line.
    pub high: f64,
}

impl CrankRange {
    /// Whether the crank makes full revolutions.
    #[must_use]
    pub fn is_full_revolution(&self) -> bool {
        self.low == 0.0 && self.high == core::f64::consts::PI
    }
}

impl<T: Scalar> FourBar<T> {
    /// The crank angles at which the linkage closes, the same for both assemblies; `None` if there are none.
    ///
    /// The diagonal e from the crank's pin to the rocker's pivot must be within reach of coupler and rocker: |r3 - r4|
    /// ≤ e ≤ r3 + r4, where e² = r1² + r2² - 2 r1 r2 cos theta2. At the limits, coupler and rocker lie on one line.
    ///
    /// ```
    /// use kin_core::library::FourBar;
    ///
    /// let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 60.0, r4: 45.0 };
    /// let range = linkage.crank_range().unwrap();
    /// assert_eq!(range.low, 0.0);
    /// assert!((range.high.to_degrees() - 112.024).abs() < 5e-4);
    /// ```
    #[must_use]
    pub fn crank_range(&self) -> Option<CrankRange> {
        let [r1, r2, r3, r4] = [self.r1, self.r2, self.r3, self.r4].map(|length| length.real().abs());
        let cosine = |diagonal: f64| (r1 * r1 + r2 * r2 - diagonal * diagonal) / (2.0 * r1 * r2);
        let (nearest, farthest) = (cosine(r3 - r4), cosine(r3 + r4));
        if !(nearest.is_finite() && farthest.is_finite()) || nearest <= -1.0 || farthest >= 1.0 {
            return None;
        }
        let low = if nearest >= 1.0 { 0.0 } else { Number::acos(nearest) };
        let high = if farthest <= -1.0 {
            core::f64::consts::PI
        } else {
            Number::acos(farthest)
        };
        Some(CrankRange { low, high })
    }
}
