use kin_core::prelude::*;

mechanism! {
    struct Press { crank: Length }
    input theta: Angle;
    unknown phi: Angle;

    theta + phi == 90;
    output lift: Length = crank * sin(phi);
}

fn main() {}
