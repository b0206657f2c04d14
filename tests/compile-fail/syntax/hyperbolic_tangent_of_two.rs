use kin_core::mechanism;

mechanism! {
    pub struct Catenary {
        pub a: Length,
    }
    input t: Scalar;
    unknown x: Length;
    x == a * cosh(t);
    output reach: Length = a * tanh(t, 2);
}

fn main() {}
