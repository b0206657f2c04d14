//! Two approximations of the slider-crank, whose slider is an explicit function of the crank's angle.
//!
//! The root in s = R cos θ + √(L² - R² sin² θ) is expanded in powers of R/L.
//! [`SliderCrankSeries`](super::SliderCrankSeries) has any number of terms, and a bound on the truncation error.

crate::mechanism! {
    /// The first approximation: cos φ ≈ 1 - R² sin² θ / (2 L²).
    pub struct SliderCrankFirstApproximation {
        /// Crank, R.
        pub r: Length,
        /// Connecting rod, L.
        pub l: Length,
    }
    input
        /// The crank's angle.
        theta: Angle;
    unknown
        /// The slider's distance from the crank's pivot.
        s: Length;

    s == r * cos(theta) + l - r.powi(2) / (4 * l) * (1 - cos(2 * theta));

    ground 0;
    body r: 0, r * cis(theta);
    body l: r * cis(theta), vec2(s, 0);
    slide vec2(s, 0) along vec2(1, 0);
}

crate::mechanism! {
    /// The approximation up to (R/L)⁵: four harmonics of the crank's angle.
    pub struct SliderCrankHigherApproximation {
        /// Crank, R.
        pub r: Length,
        /// Connecting rod, L.
        pub l: Length,
    }
    input
        /// The crank's angle.
        theta: Angle;
    unknown
        /// The slider's distance from the crank's pivot.
        s: Length;

    let c0 = l - r.powi(2) / (4 * l) - 3 * r.powi(4) / (64 * l.powi(3)) - 5 * r.powi(6) / (256 * l.powi(5));
    let c2 = r.powi(2) / (4 * l) + r.powi(4) / (16 * l.powi(3)) + 15 * r.powi(6) / (512 * l.powi(5));
    let c4 = r.powi(4) / (64 * l.powi(3)) + 3 * r.powi(6) / (256 * l.powi(5));
    let c6 = r.powi(6) / (512 * l.powi(5));

    s == r * cos(theta) + c0 + c2 * cos(2 * theta) - c4 * cos(4 * theta) + c6 * cos(6 * theta);

    ground 0;
    body r: 0, r * cis(theta);
    body l: r * cis(theta), vec2(s, 0);
    slide vec2(s, 0) along vec2(1, 0);
}
