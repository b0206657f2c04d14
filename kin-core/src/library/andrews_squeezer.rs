//! Andrews' squeezing mechanism.

use crate::{Assembly, Plane};

crate::mechanism! {
    /// Andrews' squeezing mechanism: seven bodies in three loops, a well-known test problem for solvers of mechanical
    /// systems.
    ///
    /// The names of lengths, points and angles come from E. Hairer and G. Wanner, Solving Ordinary Differential
    /// Equations II, 2nd edition, Springer 1996, section VII.7. The three vector equations are the six scalar equations
    /// of that book. The crank `rr` turns about the origin at `beta`. The rod `d` continues from its end at `beta` +
    /// `theta`. Three chains lead from the end of the rod to the points A (twice) and B.
    ///
    /// [`PUBLISHED`](AndrewsSqueezer::PUBLISHED) contains the dimensions, in metres, and
    /// [`PUBLISHED_ASSEMBLY`](AndrewsSqueezer::PUBLISHED_ASSEMBLY) the assembly of that source. Here the angle `theta`
    /// drives the mechanism, because the published position gives it. All three loops then close one after another.
    ///
    /// ```
    /// use kin_core::library::AndrewsSqueezer;
    /// use kin_core::prelude::*;
    ///
    /// // the initial position and accelerations of the source: it starts from rest
    /// let start = Motion::from((0.0, 0.0, -10666.832_939_965_585, 0.0, 0.0));
    /// let pose = AndrewsSqueezer::PUBLISHED.solve(start, AndrewsSqueezer::PUBLISHED_ASSEMBLY)?;
    /// let agrees = |found: f64, published: f64| (found - published).abs() < 1e-14;
    /// assert!(agrees(pose.beta.position(), -0.061_713_890_014_276_45));
    /// assert!(agrees(pose.gamma.position(), 0.455_279_819_163_070_4));
    /// assert!(agrees(pose.phi.position(), 0.222_668_390_165_885_9));
    /// assert!(agrees(pose.delta.position(), 0.487_364_979_543_842_55));
    /// assert!(agrees(pose.omega.position(), -0.222_668_390_165_885_9));
    /// assert!(agrees(pose.epsilon.position(), 1.230_547_444_549_821_2));
    /// assert!((pose.beta.acceleration() - 14222.443_919_954_114).abs() < 1e-9);
    /// # Ok::<(), SolveError>(())
    /// ```
    pub struct AndrewsSqueezer {
        /// The crank.
        pub rr: Length,
        /// The rod on the crank.
        pub d: Length,
        /// The rod from the rods' joint to the chain to B; it is at right angles to `gamma`.
        pub ss: Length,
        /// The rod from the rods' joint to the first chain to A.
        pub e: Length,
        /// The other rod of the first chain to A.
        pub zt: Length,
        /// The rod from the rods' joint to the second chain to A.
        pub zf: Length,
        /// The other rod of the second chain to A.
        pub u: Length,
        /// The pivot of two chains.
        pub a: Point,
        /// The pivot of the third chain.
        pub b: Point,
    }
    input
        /// The angle between the crank and its rod.
        theta: Angle;
    unknown
        /// The crank's angle.
        beta: Angle,
        /// The angle of the chain to B.
        gamma: Angle,
        /// The angle within the first chain to A.
        phi: Angle,
        /// The angle of the first chain to A.
        delta: Angle,
        /// The angle within the second chain to A.
        omega: Angle,
        /// The angle of the second chain to A.
        epsilon: Angle;

    let joint = rr * cis(beta) - d * cis(beta + theta);
    joint + vec2(0, ss) * cis(gamma) == b;
    joint + vec2(0, e) * cis(phi + delta) - zt * cis(delta) == a;
    joint - zf * cis(omega + epsilon) + vec2(0, u) * cis(epsilon) == a;

    /// The joint of the rods.
    output knee: Point = joint;
}

impl AndrewsSqueezer {
    /// The published dimensions, in metres.
    pub const PUBLISHED: Self = Self {
        rr: 0.007,
        d: 0.028,
        ss: 0.035,
        e: 0.02,
        zt: 0.04,
        zf: 0.02,
        u: 0.04,
        a: Plane::new(-0.069_34, -0.002_27),
        b: Plane::new(-0.036_35, 0.032_73),
    };
    /// The published assembly.
    pub const PUBLISHED_ASSEMBLY: AndrewsSqueezerAssembly = AndrewsSqueezerAssembly {
        beta_gamma: Assembly::Open,
        phi_delta: Assembly::Crossed,
        omega_epsilon: Assembly::Open,
    };
}
