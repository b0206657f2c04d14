//! One and the same slider-crank, typed in many ways, and its kin.
//!
//! The crank turns about the origin, the slider moves along the x axis at the height `h` unless said otherwise.

use kin_core::mechanism;

/// Declares a slider-crank with offset by its equations alone.
macro_rules! slider_crank {
    ($(#[$documentation:meta])* $name:ident: $($equations:tt)*) => {
        mechanism! {
            $(#[$documentation])*
            pub struct $name {
                r: Length,
                l: Length,
                h: Length,
            }
            input theta: Angle;
            unknown phi: Angle, s: Length;

            $($equations)*
        }
    };
}

slider_crank! {
    /// A loop of vectors, the rod's angle counter-clockwise at the pin.
    SliderCrankLoop:
    r * cis(theta) + l * cis(phi) == vec2(s, h);
}

slider_crank! {
    /// The same from the slider to the crank.
    SliderCrankSidesSwapped:
    vec2(s, h) == l * cis(phi) + r * cis(theta);
}

slider_crank! {
    /// Everything on one side.
    SliderCrankSumToZero:
    s + h * vec2(0, 1) - polar(r, theta) - polar(l, phi) == vec2(0, 0);
}

slider_crank! {
    /// Two scalar equations, the slider's first.
    SliderCrankComponents:
    s == r * cos(theta) + l * cos(phi);
    h == r * sin(theta) + l * sin(phi);
}

slider_crank! {
    /// Two scalar equations, upside down and scaled.
    SliderCrankScaled:
    2 * h - 2 * l * sin(phi) == 2 * r * sin(theta);
    r * (l * cos(phi) + r * cos(theta)) == r * s;
}

slider_crank! {
    /// The whole loop turned, so that neither equation holds one unknown alone.
    SliderCrankTurned:
    vec2(0.6, 0.8) * (r * cis(theta) + l * cis(phi)) == vec2(0.6, 0.8) * vec2(s, h);
}

slider_crank! {
    /// The sum and the difference of the two scalar equations.
    SliderCrankMixedComponents:
    s + h == r * (cos(theta) + sin(theta)) + l * (cos(phi) + sin(phi));
    s - h == r * (cos(theta) - sin(theta)) + l * (cos(phi) - sin(phi));
}

slider_crank! {
    /// The rod's angle is measured at the slider.
    SliderCrankRodFromSlider:
    r * cis(theta) == vec2(s, h) + l * cis(phi);
}

slider_crank! {
    /// The rod's angle is clockwise.
    SliderCrankClockwise:
    r * cis(theta) + l * cis(-phi) == vec2(s, h);
}

slider_crank! {
    /// The slider's travel is counted towards negative x.
    SliderCrankBackwards:
    r * cis(theta) + l * cis(phi) == vec2(-s, h);
}

slider_crank! {
    /// The slider moves along the y axis, at x = `h`.
    SliderCrankUpright:
    r * cis(theta) + l * cis(phi) == vec2(h, s);
}

mechanism! {
    /// The slide is inclined by `beta`, and passes the crank's pivot at the distance `h`.
    pub struct SliderCrankInclined {
        r: Length,
        l: Length,
        h: Length,
        beta: Angle,
    }
    input theta: Angle;
    unknown phi: Angle, s: Length;

    r * cis(theta) + l * cis(phi) == vec2(s, h) * cis(beta);
}

mechanism! {
    /// The slide is given by a point and a direction, which need not be a unit vector.
    pub struct SliderCrankAlongVector {
        r: Length,
        l: Length,
        foot: Point,
        direction: Vector,
    }
    input theta: Angle;
    unknown phi: Angle, s: Scalar;

    r * cis(theta) + l * cis(phi) == foot + s * direction;
}

mechanism! {
    /// Driven at the slider: the crank is an unknown, and both links have known lengths.
    pub struct SliderCrankDrivenAtSlider {
        r: Length,
        l: Length,
        h: Length,
    }
    input s: Length;
    unknown theta: Angle, phi: Angle;

    r * cis(theta) + l * cis(phi) == vec2(s, h);
}

mechanism! {
    /// Driven by the rod: crank and slider are unknowns.
    pub struct SliderCrankDrivenByRod {
        r: Length,
        l: Length,
        h: Length,
    }
    input phi: Angle;
    unknown s: Length, theta: Angle;

    r * cis(theta) + l * cis(phi) == vec2(s, h);
}
