use kin_core::mechanism;

mechanism! {
    struct Crank { a: Length } # the crank
    input theta: Angle;
    unknown x: Length;
    x == a * cos(theta);
}

fn main() {}
