use kin_core::mechanism;

mechanism! {
    pub struct Kepler {
        pub e: Scalar,
    }
    /// The mean anomaly.
    input m: Angle;
    /// The eccentric anomaly.
    unknown a: Angle in 0..=PI;
    a - e * sin(a) == m;
}

fn main() {}
