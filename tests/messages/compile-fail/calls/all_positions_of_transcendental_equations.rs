use kin_core::prelude::*;

mechanism! {
    pub struct Orbit { pub eccentricity: Scalar }
    input mean: Angle;
    unknown eccentric: Angle;
    eccentric - eccentricity * sin(eccentric) == mean;
}

fn main() {
    let orbit: Orbit = Orbit { eccentricity: 0.5 };
    let _ = orbit.assemblies_at(1.0);
}
