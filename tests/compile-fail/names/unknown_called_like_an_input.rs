use kin_core::mechanism;

mechanism! {
    struct Crank { a: Length, b: Length }
    input theta: Angle;
    unknown theta: Angle, x: Length;
    a * cis(theta) + b * cis(theta) == vec2(x, 0);
}

fn main() {}
