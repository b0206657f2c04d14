//! Peaucellier's exact straight-line linkage.

use crate::Assembly;

crate::mechanism! {
    /// Peaucellier's linkage, also called Lipkin's: seven bars that draw an exact straight line.
    ///
    /// Two arms turn about the origin O and end in opposite corners A and B of a rhombus. Its other corners are C, on a
    /// crank that turns about (`ground`, 0), and the tracer P. O, C and P lie on one line, and their distances satisfy
    /// OC · OP = arm² - side²: P is the inverse of C. If `crank` equals `ground`, C moves on a circle through O, and P
    /// on the straight line x = (arm² - side²) / (2 `ground`). Otherwise P draws an arc, whose radius can be as large
    /// as you like.
    ///
    /// Source: A. Peaucellier, "Note sur une question de géométrie de compas", Nouvelles annales de
    /// mathématiques 12, 1873; A. B. Kempe, How to Draw a Straight Line, Macmillan 1877.
    ///
    /// Each of the three dyads has two assemblies. The rhombus is open if the two arms have different assemblies, and
    /// the tracer is the corner away from C: [`STRAIGHT`](PeaucellierLinkage::STRAIGHT). This holds for the whole
    /// motion if arm² - side² > 4 `ground`². Otherwise the pin C can meet the tracer, where the rhombus collapses.
    ///
    /// ```
    /// use kin_core::library::PeaucellierLinkage;
    /// use kin_core::prelude::*;
    ///
    /// let linkage = PeaucellierLinkage { ground: 2.0, crank: 2.0, arm: 6.0, side: 4.0 };
    /// let crank = Motion::from((0.6_f64, 1.0, -0.5, 0.3, 0.2));
    /// let tracer = linkage.solve(crank, PeaucellierLinkage::STRAIGHT)?.tracer;
    /// assert!((tracer.x().position() - 5.0).abs() < 1e-14);
    /// assert!(tracer.x().derivatives().into_iter().skip(1).all(|rate| rate.abs() < 1e-12));
    /// assert!(tracer.y().velocity() > 1.0);
    /// # Ok::<(), SolveError>(())
    /// ```
    pub struct PeaucellierLinkage {
        /// Ground link, from the pivot of the arms to the crank's.
        pub ground: Length,
        /// Crank; the path is straight if it is as long as `ground`.
        pub crank: Length,
        /// Each of the two arms.
        pub arm: Length,
        /// Each side of the rhombus.
        pub side: Length,
    }
    input
        /// The crank's angle.
        theta: Angle;
    unknown
        /// The angle of the arm to A.
        alpha: Angle,
        /// The direction from the crank's pin C to A.
        gamma: Angle,
        /// The angle of the arm to B.
        beta: Angle,
        /// The direction from the crank's pin C to B.
        delta: Angle,
        /// The direction from A to the tracer.
        epsilon: Angle,
        /// The direction from B to the tracer.
        zeta: Angle;

    let pin = ground + crank * cis(theta);
    arm * cis(alpha) == pin + side * cis(gamma);
    arm * cis(beta) == pin + side * cis(delta);
    arm * cis(alpha) + side * cis(epsilon) == arm * cis(beta) + side * cis(zeta);

    /// The tracer P.
    output tracer: Point = arm * cis(alpha) + side * cis(epsilon);
}

impl PeaucellierLinkage {
    /// The assembly that draws the straight line. Its mirror image, with the arms exchanged, is another one of the
    /// eight assemblies.
    pub const STRAIGHT: PeaucellierLinkageAssembly = PeaucellierLinkageAssembly {
        alpha_gamma: Assembly::Open,
        beta_delta: Assembly::Crossed,
        epsilon_zeta: Assembly::Open,
    };
}
