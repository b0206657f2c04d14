use kin_core::mechanism;

mechanism! {
    pub struct Slide {
        pub a: Length,
    }
    input t: Scalar;
    unknown x: Length;
    powi(1e-200 * x + 2 * a, 2) == a * a * t;
}

fn main() {}
