use kin_core::prelude::*;

mechanism! {
    pub struct FourBar {
        pub r1: Length,
        pub r2: Length,
        pub r3: Length,
        pub r4: Length,
    }
    input theta2: Angle;
    unknown theta3: Angle, theta4: Angle;
    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
}

fn main() {
    let linkage: FourBar = FourBar { r1: 90.0, r2: 30.0, r3: 60.0, r4: 45.0 };
    let pose = linkage.position(1.0, Assembly::Open);
    println!("{}", pose.theta3);
}
