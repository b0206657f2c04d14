use kin_core::mechanism;

mechanism! {
    pub struct Slide {
        pub a: Length,
    }
    input t: Scalar;
    unknown x: Length, y: Length, z: Length;
    let tiny = powi(1e-200, 2) * a;
    x == 1e308*a*t*10 + 1e308*a;
    y == a * exp(710) + tiny;
    1e308 * z == a * t - 1e308 * z;
}

fn main() {}
