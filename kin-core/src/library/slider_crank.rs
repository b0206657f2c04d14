//! The slider-crank, centric and with offset.

crate::mechanism! {
    /// Centric slider-crank: the slider's line passes through the crank's pivot.
    ///
    /// The crank `r` is at the angle `theta`, the connecting rod `l` at the angle `phi`, and the slider at the distance
    /// `s`. `phi` is measured clockwise from the slider's line, so that both angles of the triangle are positive
    /// together. In the open assembly the slider is beyond the crank's pin, cos phi > 0.
    pub struct SliderCrank {
        /// Crank.
        pub r: Length,
        /// Connecting rod.
        pub l: Length,
    }
    input
        /// The crank's angle.
        theta: Angle;
    unknown
        /// The connecting rod's angle, clockwise.
        phi: Angle,
        /// The slider's distance from the crank's pivot.
        s: Length;

    r * sin(theta) == l * sin(phi);
    s == r * cos(theta) + l * cos(phi);

    let pin = r * cis(theta);
    let piston = vec2(s, 0);
    ground 0;
    body r: 0, pin;
    body l: pin, piston;
    slide piston along vec2(1, 0);
}

crate::mechanism! {
    /// Slider-crank with offset: the slider's line passes the crank's pivot at the height `h`.
    ///
    /// Otherwise it is the same as [`SliderCrank`].
    pub struct OffsetSliderCrank {
        /// Crank.
        pub r: Length,
        /// Connecting rod.
        pub l: Length,
        /// Height of the slider's line above the crank's pivot.
        pub h: Length,
    }
    input
        /// The crank's angle.
        theta: Angle;
    unknown
        /// The connecting rod's angle, clockwise.
        phi: Angle,
        /// The slider's position along its line, from the foot of the perpendicular through the crank's pivot.
        s: Length;

    r * cis(theta) + l * cis(-phi) == vec2(s, h);
}
