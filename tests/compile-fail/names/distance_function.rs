use kin_core::prelude::*;

mechanism! {
    struct Press { crank: Length, rod: Length }
    input theta: Angle;
    unknown stroke: Length;

    dist(crank * cis(theta), vec2(stroke, 0)) == rod;
}

fn main() {}
