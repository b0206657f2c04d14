use kin_core::prelude::*;

mechanism! {
    struct Press { crank: Length, rod: Length }
    input theta: Angle;
    unknown phi: Angle in 0:PI, stroke: Length;

    crank * cis(theta) + rod * cis(phi) == vec2(stroke, 0);
}

fn main() {}
