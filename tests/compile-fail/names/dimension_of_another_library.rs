use kin_core::mechanism;

mechanism! {
    struct Crank { a: Length, pivot: Vec2, ratio: f64 }
    input theta: Radians;
    unknown x: Meters;
    x == a * cos(theta) + pivot.x * ratio;
}

fn main() {}
