use kin_core::mechanism;

mechanism! {
    pub struct Slide {
        pub a: Length,
    }
    input t: Scalar;
    unknown x: Length;
    x == a * t * tan(PI / 2);
}

fn main() {}
