use kin_core::prelude::*;

mechanism! {
    struct Press { crank: Length, rod: Length, omega: Scalar }
    input theta: Angle;
    unknown phi: Angle, stroke: Length;

    crank * cis(omega * t) + rod * cis(phi) == vec2(stroke, 0);
}

fn main() {}
