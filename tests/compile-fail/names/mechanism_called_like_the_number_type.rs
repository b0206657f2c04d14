use kin_core::mechanism;

mechanism! {
    pub struct T {
        pub r: Length,
    }
    input theta: Angle;
    unknown s: Length;
    s == r * cos(theta);
}

fn main() {}
