use kin_core::mechanism;

mechanism! {
    pub struct FourBar {
        pub r1: Length,
        pub r2: Length,
        pub r3: Length,
        pub r4: Length,
    }
}

fn main() {}
