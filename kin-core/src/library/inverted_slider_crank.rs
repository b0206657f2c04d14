//! The inverted slider-crank: the crank's pin slides in a lever.

crate::mechanism! {
    /// Inverted slider-crank: a slotted lever turns about the origin, the crank about the point (`r1`, 0).
    ///
    /// The crank's pin slides along the lever; its distance from the lever's pivot is the unknown `r4`.
    pub struct InvertedSliderCrank {
        /// Ground link, from the lever's pivot to the crank's.
        pub r1: Length,
        /// Crank.
        pub r2: Length,
    }
    input
        /// The crank's angle.
        theta2: Angle;
    unknown
        /// The distance from the lever's pivot to the crank's pin.
        r4: Length where r4 > 0,
        /// The lever's angle.
        theta4: Angle;

    r1 + r2 * cis(theta2) == r4 * cis(theta4);
}
