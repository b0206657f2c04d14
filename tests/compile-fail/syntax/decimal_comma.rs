use kin_core::prelude::*;

mechanism! {
    struct Press { crank: Length, rod: Length }
    input theta: Angle;
    unknown phi: Angle, stroke: Length;

    crank * cis(theta) + rod * cis(phi) == vec2(stroke, 0);
    output middle: Point = crank * cis(theta) + 0,5 * rod * cis(phi);
}

fn main() {}
