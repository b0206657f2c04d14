use kin_core::prelude::*;

mechanism! {
    pub struct Lift {
        pub radius: Length,
    }
    input theta: Angle;
    unknown height: Length;
    height == radius * sin(theta);
}

fn main() {
    let lift: Lift = Lift { radius: 0.5 };
    let pose = lift.position(1.0).unwrap();
    println!("{}", pose.height.velocity());
}
