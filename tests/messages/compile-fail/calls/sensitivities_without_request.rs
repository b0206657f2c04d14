use kin_core::prelude::*;

mechanism! {
    struct Crank { a: Length }
    input theta: Angle;
    unknown x: Length;
    x == a * cos(theta);
}

fn main() {
    let crank: Crank = Crank { a: 1.0 };
    let pose = crank.solve(Motion::at_constant_speed(0.8, 10.0)).unwrap();
    println!("{:?}", crank.sensitivities(&pose));
}
