//! One and the same four-bar linkage, typed in many ways.
//!
//! The recognised form must follow from the algebra, and so must the assembly: open is the same geometry in all of
//! them.

use kin_core::mechanism;

/// Declares a four-bar linkage by its equations alone.
macro_rules! four_bar {
    ($(#[$documentation:meta])* $name:ident: $($equations:tt)*) => {
        mechanism! {
            $(#[$documentation])*
            pub struct $name {
                r1: Length,
                r2: Length,
                r3: Length,
                r4: Length,
            }
            input theta2: Angle;
            unknown theta3: Angle, theta4: Angle;

            $($equations)*
        }
    };
}

four_bar! {
    /// As the library has it.
    FourBarPlain:
    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
}

four_bar! {
    /// The two sides change places.
    FourBarSidesSwapped:
    r1 + r4 * cis(theta4) == r2 * cis(theta2) + r3 * cis(theta3);
}

four_bar! {
    /// Terms and factors in another order.
    FourBarReordered:
    cis(theta3) * r3 + cis(theta2) * r2 == cis(theta4) * r4 + r1;
}

four_bar! {
    /// The unknown links on one side, the others on the other side.
    FourBarMovedAcross:
    r1 - r2 * cis(theta2) == r3 * cis(theta3) - r4 * cis(theta4);
}

four_bar! {
    /// Everything on one side.
    FourBarSumToZero:
    r2 * cis(theta2) + r3 * cis(theta3) - r4 * cis(theta4) - r1 == vec2(0, 0);
}

four_bar! {
    /// Everything on the other side, with minus signs.
    FourBarZeroToSum:
    vec2(0, 0) == -r3 * cis(theta3) - (r2 * cis(theta2) - r1) + r4 * cis(theta4);
}

four_bar! {
    /// Two scalar equations, x first.
    FourBarComponents:
    r2 * cos(theta2) + r3 * cos(theta3) == r1 + r4 * cos(theta4);
    r2 * sin(theta2) + r3 * sin(theta3) == r4 * sin(theta4);
}

four_bar! {
    /// Two scalar equations, y first.
    FourBarComponentsSwapped:
    r2 * sin(theta2) + r3 * sin(theta3) == r4 * sin(theta4);
    r2 * cos(theta2) + r3 * cos(theta3) == r1 + r4 * cos(theta4);
}

four_bar! {
    /// Two scalar equations, one of them upside down and doubled.
    FourBarNegatedComponent:
    r2 * cos(theta2) + r3 * cos(theta3) == r1 + r4 * cos(theta4);
    2 * r4 * sin(theta4) - 2 * r2 * sin(theta2) == r3 * sin(theta3) * 2;
}

four_bar! {
    /// The sum and the difference of the two scalar equations.
    FourBarMixedComponents:
    r2 * (cos(theta2) + sin(theta2)) + r3 * (cos(theta3) + sin(theta3)) == r1 + r4 * (cos(theta4) + sin(theta4));
    r2 * (cos(theta2) - sin(theta2)) + r3 * (cos(theta3) - sin(theta3)) == r1 + r4 * (cos(theta4) - sin(theta4));
}

four_bar! {
    /// Twice the loop.
    FourBarDoubled:
    2 * (r2 * cis(theta2) + r3 * cis(theta3)) == 2 * r1 + (r4 + r4) * cis(theta4);
}

four_bar! {
    /// The loop times a length.
    FourBarScaledByGround:
    r1 * (r2 * cis(theta2) + r3 * cis(theta3) - r4 * cis(theta4)) == vec2(r1.powi(2), 0);
}

four_bar! {
    /// The two scalar equations scaled by different lengths.
    FourBarScaledApart:
    r1 * r2 * cos(theta2) + r1 * r3 * cos(theta3) == r1 * (r1 + r4 * cos(theta4));
    r3 * (r2 * sin(theta2) + r3 * sin(theta3)) == r3 * r4 * sin(theta4);
}

four_bar! {
    /// Divided by the rocker.
    FourBarDivided:
    (r2 * cis(theta2) + r3 * cis(theta3) - r1) / r4 == cis(theta4);
}

four_bar! {
    /// The mirror image of the loop, with mirrored angles.
    FourBarConjugate:
    r2 * cis(-theta2) + r3 * cis(-theta3) == r1 + r4 * cis(-theta4);
}

four_bar! {
    /// The whole loop turned by a complex constant.
    FourBarTurned:
    vec2(3, 4) * (r2 * cis(theta2) + r3 * cis(theta3)) == (r1 + r4 * cis(theta4)) * vec2(3, 4);
}

four_bar! {
    /// The whole loop in the frame of the crank.
    FourBarInCrankFrame:
    r2 + r3 * cis(theta3 - theta2) == r1 * cis(-theta2) + r4 * cis(theta4 - theta2);
}

four_bar! {
    /// Lengths and angles.
    FourBarPolar:
    polar(r2, theta2) + polar(r3, theta3) == vec2(r1, 0) + polar(r4, theta4);
}

four_bar! {
    /// Coordinates.
    FourBarCoordinates:
    vec2(r2 * cos(theta2) + r3 * cos(theta3), r2 * sin(theta2) + r3 * sin(theta3))
        == vec2(r1 + r4 * theta4.cos(), r4 * theta4.sin());
}

four_bar! {
    /// A product of rotations.
    FourBarProduct:
    (r2 + r3 * cis(theta3 - theta2)) * cis(theta2) == r1 + r4 * cis(theta4);
}

four_bar! {
    /// Half angles, multiplied together.
    FourBarHalfAngles:
    r2 * cis(theta2 / 2) * cis(theta2 / 2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
}

four_bar! {
    /// With abbreviations.
    FourBarLets:
    let crank_pin = r2 * cis(theta2);
    let rocker_pin = r1 + r4 * cis(theta4);
    let coupler = rocker_pin - crank_pin;
    coupler.x == r3 * cos(theta3);
    coupler.y == r3 * sin(theta3);
}

four_bar! {
    /// The rocker's angle is measured at its other end.
    FourBarRockerFromPin:
    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4 + PI);
}

four_bar! {
    /// The coupler's angle is measured at its other end.
    FourBarCouplerFromRocker:
    r2 * cis(theta2) == r1 + r4 * cis(theta4) + r3 * cis(theta3);
}

four_bar! {
    /// The rocker's angle is measured from the y axis.
    FourBarRockerFromUpright:
    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4 + PI / 2);
}

four_bar! {
    /// The same by a quarter turn as a complex number.
    FourBarQuarterTurn:
    r2 * cis(theta2) + r3 * cis(theta3) == r1 + vec2(0, 1) * cis(theta4) * r4;
}

four_bar! {
    /// The rocker's angle is clockwise.
    FourBarClockwiseRocker:
    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(-theta4);
}

four_bar! {
    /// The coupler's angle is clockwise.
    FourBarClockwiseCoupler:
    r2 * cos(theta2) + r3 * cos(theta3) == r1 + r4 * cos(theta4);
    r2 * sin(theta2) - r3 * sin(theta3) == r4 * sin(theta4);
}

four_bar! {
    /// The rocker's angle is measured from the coupler.
    FourBarRelativeRocker:
    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta3 + theta4);
}

mechanism! {
    /// The unknowns declared the other way round.
    pub struct FourBarUnknownsSwapped {
        r1: Length,
        r2: Length,
        r3: Length,
        r4: Length,
    }
    input theta2: Angle;
    unknown theta4: Angle, theta3: Angle;

    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
}

mechanism! {
    /// Dimensions and unknowns of other names, in an order that turns the alphabet round.
    pub struct FourBarRenamed {
        ground: Length,
        zeta: Length,
        middle: Length,
        arm: Length,
    }
    input omega: Angle;
    unknown phi: Angle, alpha: Angle;

    zeta * cis(omega) + middle * cis(phi) == ground + arm * cis(alpha);
}
