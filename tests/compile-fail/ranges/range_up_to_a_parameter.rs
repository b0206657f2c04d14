use kin_core::mechanism;

mechanism! {
    struct Crank { a: Length, b: Length, least: Length }
    input theta: Angle;
    unknown x: Length where x > least, phi: Angle;
    a * cis(theta) + b * cis(phi) == vec2(x, 0);
}

fn main() {}
