use kin_core::mechanism;

mechanism! {
    pub struct FourBar {
        pub r1: Length,
        pub r2: Length,
        pub r3: Length,
        pub r4: Length,
    }
    input theta2: Angle;
    r1 * theta2 == r2 + r3 + r4;
}

fn main() {}
