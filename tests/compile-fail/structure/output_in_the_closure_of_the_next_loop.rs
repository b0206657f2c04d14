use kin_core::prelude::*;

mechanism! {
    struct Press { crank: Length, rod: Length, arm: Length }
    input theta: Angle;
    unknown phi: Angle, stroke: Length, psi: Angle, lift: Length;

    crank * cis(theta) + rod * cis(phi) == vec2(stroke, 0);
    output pin: Point = crank * cis(theta);
    pin + arm * cis(psi) == vec2(0, lift);
}

fn main() {}
