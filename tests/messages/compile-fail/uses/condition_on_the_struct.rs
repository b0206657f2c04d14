use kin_core::mechanism;

mechanism! {
    #[cfg(all())]
    #[cfg_attr(all(), derive(PartialOrd), cfg(any()))]
    pub struct Slide {
        pub a: Length,
    }
    input t: Scalar;
    unknown x: Length;
    x == a * t;
}

fn main() {
    let _ = Slide { a: 1.0 };
}
