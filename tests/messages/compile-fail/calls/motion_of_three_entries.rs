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
    let _ = lift.solve([1.0, 2.0, 0.0]);
    let _ = lift.solve(Motion::from((1.0, 2.0, 0.0)));
}
