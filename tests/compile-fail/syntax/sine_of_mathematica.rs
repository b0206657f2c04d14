use kin_core::prelude::*;

mechanism! {
    struct Press { crank: Length }
    input theta: Angle;
    unknown stroke: Length;

    stroke == crank * Cos[theta];
}

fn main() {}
