//! One and the same inverted slider-crank, typed in many ways, with and without offset.
//!
//! The slotted lever turns about the origin, the crank about the point (`r1`, 0). With an offset, the pin's line passes
//! the lever's pivot at the distance `h`.

use kin_core::mechanism;

/// Declares an inverted slider-crank by its equations alone.
macro_rules! inverted_slider_crank {
    ($(#[$documentation:meta])* $name:ident($($parameter:ident)+): $($equations:tt)*) => {
        mechanism! {
            $(#[$documentation])*
            pub struct $name {
                $($parameter: Length,)+
            }
            input theta2: Angle;
            unknown r4: Length, theta4: Angle;

            $($equations)*
        }
    };
}

inverted_slider_crank! {
    /// A loop of vectors.
    InvertedLoop(r1 r2):
    r1 + r2 * cis(theta2) == r4 * cis(theta4);
}

inverted_slider_crank! {
    /// The same as lengths and angles, the sides swapped.
    InvertedPolar(r1 r2):
    polar(r4, theta4) == polar(r2, theta2) + r1;
}

inverted_slider_crank! {
    /// Two scalar equations, one of them upside down and scaled.
    InvertedComponents(r1 r2):
    -r2 * sin(theta2) * r1 == -r1 * r4 * sin(theta4);
    r4 * cos(theta4) - r1 == r2 * cos(theta2);
}

inverted_slider_crank! {
    /// In the frame of the crank.
    InvertedInCrankFrame(r1 r2):
    r1 * cis(-theta2) + r2 == r4 * cis(theta4 - theta2);
}

inverted_slider_crank! {
    /// The lever's angle is measured at its other end.
    InvertedFromPin(r1 r2):
    r1 + r2 * cis(theta2) + r4 * cis(theta4) == vec2(0, 0);
}

inverted_slider_crank! {
    /// The lever's angle is clockwise.
    InvertedClockwise(r1 r2):
    r1 + r2 * cis(theta2) == r4 * cis(-theta4);
}

inverted_slider_crank! {
    /// With an offset, as a complex number in the lever's frame.
    InvertedOffset(r1 r2 h):
    r1 + r2 * cis(theta2) == vec2(r4, h) * cis(theta4);
    with sensitivities;
}

inverted_slider_crank! {
    /// With an offset, as a vector at right angles to the lever.
    InvertedOffsetAtRightAngles(r1 r2 h):
    r4 * cis(theta4) + h * cis(theta4 + PI / 2) == r2 * cis(theta2) + vec2(r1, 0);
}

inverted_slider_crank! {
    /// With an offset, in two scalar equations.
    InvertedOffsetComponents(r1 r2 h):
    r4 * sin(theta4) + h * cos(theta4) == r2 * sin(theta2);
    r4 * cos(theta4) - h * sin(theta4) == r1 + r2 * cos(theta2);
}

inverted_slider_crank! {
    /// With an offset, in the frame of the lever.
    InvertedOffsetInLeverFrame(r1 r2 h):
    (r1 + r2 * cis(theta2)) * cis(-theta4) == vec2(r4, h);
}

mechanism! {
    /// The oscillating cylinder: the piston's length is given, both angles follow.
    pub struct InvertedDrivenByCylinder {
        r1: Length,
        r2: Length,
    }
    input r4: Length;
    unknown theta2: Angle, theta4: Angle;

    r1 + r2 * cis(theta2) == r4 * cis(theta4);
}
