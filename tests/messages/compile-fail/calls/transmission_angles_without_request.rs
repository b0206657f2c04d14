use kin_core::prelude::*;

mechanism! {
    struct Press { crank: Length, rod: Length }
    input theta: Angle;
    unknown phi: Angle, stroke: Length;

    crank * cis(theta) + rod * cis(phi) == vec2(stroke, 0);
}

fn main() {
    let press: Press = Press { crank: 30.0, rod: 90.0 };
    let pose = press.position(1.0, Assembly::Open).unwrap();
    println!("{:?}", pose.transmission_angles());
}
