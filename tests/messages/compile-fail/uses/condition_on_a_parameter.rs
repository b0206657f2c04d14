use kin_core::mechanism;

mechanism! {
    pub struct Slide {
        pub a: Length,
        #[cfg(debug_assertions)]
        pub b: Length,
    }
    input t: Scalar;
    unknown x: Length;
    x == a * t + b;
}

fn main() {
    let _ = Slide { a: 1.0, b: 2.0 };
}
