use kin_core::mechanism;

mechanism! {
    struct Circle {
        a: Scalar,
    }
    input t: Scalar;
    unknown x: Scalar;
    x == a * t;
    a * (sin(x) * sin(x) + cos(x) * cos(x)) == a * t;
}

fn main() {}
