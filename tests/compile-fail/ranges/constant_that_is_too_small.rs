use kin_core::mechanism;

mechanism! {
    pub struct Slide {
        pub a: Length,
    }
    input t: Scalar;
    unknown x: Length;
    x * 1e-320 == a * t;
}

fn main() {}
