use kin_core::prelude::*;

mechanism! {
    struct Press { crank: Length, rod: Length }
    input theta: Angle;
    unknown phi: Angle, stroke: Length;

    crank · cis(theta) + rod · cis(phi) == vec2(stroke, 0);
}

fn main() {}
