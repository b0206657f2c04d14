use kin_core::mechanism;

mechanism! {
    pub struct Three {
        pub a: Length,
    }
    input t: Angle;
    unknown x: Length, y: Length, z: Length;
    x + y == a * sin(t);
    y + z == a * cos(t);
    x - z == a * tan(t);
}

fn main() {}
