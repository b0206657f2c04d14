use kin_core::prelude::*;

mechanism! {
    struct Press { crank: Length }
    input theta: Angle;
    unknown phi: Angle, stroke: Length;

    crank * cis(theta) + 120 mm * cis(phi) == vec2(stroke, 0);
}

fn main() {}
