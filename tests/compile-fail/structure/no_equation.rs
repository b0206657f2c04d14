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
    output all: Scalar = (r1 + r2) * theta2 / (r3 + r4);
}

fn main() {}
