use kin_core::mechanism;

mechanism! {
    pub struct Slide {
        pub a: Scalar,
    }
    input t: Scalar;
    unknown x: Scalar;
    x == a * powi(powi(t, 64), 64);
}

fn main() {}
