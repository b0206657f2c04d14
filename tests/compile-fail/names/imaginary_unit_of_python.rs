use kin_core::prelude::*;

mechanism! {
    struct Press { crank: Length, rod: Length }
    input theta: Angle;
    unknown phi: Angle, stroke: Length;

    crank * exp(1j * theta) + rod * exp(1j * phi) == stroke;
}

fn main() {}
