use kin_core::prelude::*;

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

fn main() {
    let orbit: Kepler = Kepler { e: 0.5 };
    let _ = orbit.position(1.0, Assembly::Open);
}
