use kin_core::mechanism;

const OFFSET: f64 = 3.0;

mechanism! {
    struct Crank { a: Length }
    input theta: Angle;
    unknown x: Length;
    x == a * cos(theta) + OFFSET;
}

fn main() {
    println!("{OFFSET}");
}
