use kin_core::prelude::*;

mechanism! {
    struct Press { crank: Length, rod: Length }
    input theta: Angle;
    unknown phi: Angle, stroke: Length;

    crank * cos(theta) + rod * cos(phi) == stroke;
}

fn main() {}
