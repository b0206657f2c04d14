use kin_core::mechanism;

mechanism! {
    pub struct FourBar {
        pub r1: Length,
        pub r2: Length,
        pub r3: Length,
        pub r4: Length,
    }
    input theta2: Angle;
    unknown theta3: Angle, theta4: Angle;
    r1 * sin(theta2) == r2 * sin(theta3) + r3 * sin(2 * theta4);
    r1 * cos(theta2) == r2 * cos(theta3) + r4 * cos(3 * theta4);
}

fn main() {}
