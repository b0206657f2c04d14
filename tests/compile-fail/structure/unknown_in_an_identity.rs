use kin_core::mechanism;

mechanism! {
    struct Circle {
        a: Scalar,
    }
    input t: Scalar;
    unknown x: Scalar;
    a * (sin(x) * sin(x) + cos(x) * cos(x)) == a * t;
}

fn main() {}
