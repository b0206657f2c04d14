//! Jansen's walking leg.

use crate::Assembly;

crate::mechanism! {
    /// Jansen's leg: eleven bars and a crank that move a foot along a flat path and lift it back.
    ///
    /// The letters come from T. Jansen, The Great Pretender, 010 Publishers 2007.
    /// [`HOLY_NUMBERS`](JansenLeg::HOLY_NUMBERS) contains his "eleven holy numbers" with the position of the pivot and
    /// the crank. The crank `m` turns about the origin; all other parts turn about the pivot (-`a`, -`l`). From the
    /// crank's pin, `j` leads to the upper triangle `b`, `d`, `e`, one corner of which is the pivot. Also from the pin,
    /// `k` leads to the knee, which `c` connects to the pivot. `f` from the upper triangle and `g` from the knee meet
    /// at the outer corner of the lower triangle `g`, `h`, `i`, whose last corner is the foot.
    ///
    /// With the holy numbers the foot's path is 67.9 wide and 22.5 high. Within 1 of its lowest point the foot moves
    /// 57.4 along the ground, while the crank turns through 155°.
    ///
    /// ```
    /// use kin_core::library::JansenLeg;
    /// use kin_core::prelude::*;
    ///
    /// let leg = JansenLeg::HOLY_NUMBERS;
    /// let path = (0..720)
    ///     .map(|step| leg.position(f64::from(step).to_radians() / 2.0, JansenLeg::WALKING))
    ///     .map(|position| position.map(|position| position.foot.value()))
    ///     .collect::<Result<Vec<_>, _>>()?;
    /// let low = path.iter().fold(f64::INFINITY, |low, foot| low.min(foot.y));
    /// let on_ground: Vec<_> = path.iter().filter(|foot| foot.y < low + 1.0).collect();
    /// let (left, right) = on_ground.iter().fold((0.0_f64, -100.0_f64), |(left, right), foot| {
    ///     (left.min(foot.x), right.max(foot.x))
    /// });
    /// assert!((right - left - 57.4).abs() < 0.3);
    /// assert!((on_ground.len() as f64 / 2.0 - 155.0).abs() < 1.0);
    /// # Ok::<(), SolveError>(())
    /// ```
    pub struct JansenLeg {
        /// Horizontal distance of the pivot from the crank's axle.
        pub a: Length,
        /// Upper triangle, from the pivot to the upper corner.
        pub b: Length,
        /// Link from the pivot to the knee.
        pub c: Length,
        /// Upper triangle, from the pivot to the outer corner.
        pub d: Length,
        /// Upper triangle, from the upper to the outer corner.
        pub e: Length,
        /// Link from the upper triangle's outer corner to the lower triangle.
        pub f: Length,
        /// Lower triangle, from the knee to the outer corner.
        pub g: Length,
        /// Lower triangle, from the outer corner to the foot.
        pub h: Length,
        /// Lower triangle, from the knee to the foot.
        pub i: Length,
        /// Link from the crank's pin to the upper triangle.
        pub j: Length,
        /// Link from the crank's pin to the knee.
        pub k: Length,
        /// Height of the crank's axle above the pivot.
        pub l: Length,
        /// Crank.
        pub m: Length,
    }
    input
        /// The crank's angle.
        theta: Angle;
    unknown
        /// The angle of `j`.
        angle_j: Angle,
        /// The angle of `b`.
        angle_b: Angle,
        /// The angle of `k`.
        angle_k: Angle,
        /// The angle of `c`.
        angle_c: Angle,
        /// The angle of `f`.
        angle_f: Angle,
        /// The angle of `g`.
        angle_g: Angle;

    let pin = m * cis(theta);
    let pivot = vec2(-a, -l);
    pin + j * cis(angle_j) == pivot + b * cis(angle_b);
    pin + k * cis(angle_k) == pivot + c * cis(angle_c);

    // The corners of the triangles relative to one of their sides, by the cosine rule.
    let d_along = (b.powi(2) + d.powi(2) - e.powi(2)) / (2 * b);
    let d_beside = sqrt(d.powi(2) - d_along.powi(2));
    let i_along = (g.powi(2) + i.powi(2) - h.powi(2)) / (2 * g);
    let i_beside = sqrt(i.powi(2) - i_along.powi(2));

    let knee = pivot + c * cis(angle_c);
    pivot + vec2(d_along, d_beside) * cis(angle_b) + f * cis(angle_f) == knee + g * cis(angle_g);

    /// The foot.
    output foot: Point = knee + vec2(i_along, i_beside) * cis(angle_g);
}

impl JansenLeg {
    /// Jansen's dimensions.
    pub const HOLY_NUMBERS: Self = Self {
        a: 38.0,
        b: 41.5,
        c: 39.3,
        d: 40.1,
        e: 55.8,
        f: 39.4,
        g: 36.7,
        h: 65.7,
        i: 49.0,
        j: 50.0,
        k: 61.9,
        l: 7.8,
        m: 15.0,
    };
    /// The assembly in which the leg walks.
    pub const WALKING: JansenLegAssembly = JansenLegAssembly {
        angle_j_angle_b: Assembly::Crossed,
        angle_k_angle_c: Assembly::Open,
        angle_f_angle_g: Assembly::Crossed,
    };
}
