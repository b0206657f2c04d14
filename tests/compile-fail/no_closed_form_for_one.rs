use kin_core::mechanism;

mechanism! {
    pub struct Kepler {
        pub e: Scalar,
    }
    /// The mean anomaly.
    input m: Angle;
    /// The eccentric anomaly.
    unknown a: Angle;
    a - e * sin(a) == m;
}

fn main() {}
