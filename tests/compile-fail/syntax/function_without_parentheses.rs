use kin_core::mechanism;

mechanism! {
    struct Crank { a: Length, b: Length }
    input t: Angle;
    unknown x: Length, phi: Angle;
    a * cis t + b * cis(phi) == vec2(x, 0);
    output height: Length = a * sin 30deg;
}

fn main() {}
