//! The mechanisms of the tests of sweeps and extremes.

use crate::geometry::Plane;
use crate::library::{ClassThreeTriad, FourBar};

/// Its crank makes full revolutions.
pub(crate) const CRANK_ROCKER: FourBar = FourBar {
    r1: 90.0,
    r2: 30.0,
    r3: 70.0,
    r4: 60.0,
};

/// Its crank swings by 112 degrees to both sides.
pub(crate) const LIMITED: FourBar = FourBar {
    r1: 90.0,
    r2: 30.0,
    r3: 60.0,
    r4: 45.0,
};

/// Two equilateral triangles, of which the legs rotate one: l² = R² + ρ² - 2 R ρ cos phi for legs of the length l, with
/// R = 2 and ρ = 1.
pub(crate) fn triad() -> ClassThreeTriad {
    let root = 3.0_f64.sqrt();
    ClassThreeTriad {
        base_b: Plane::new(2.0 * root, 0.0),
        base_c: Plane::new(root, 3.0),
        platform_b: Plane::new(root, 0.0),
        platform_c: Plane::new(root / 2.0, 1.5),
    }
}

crate::mechanism! {
    /// An angle by its sine, up to one radian.
    pub(crate) struct Inverse { pub factor: Scalar }
    input u: Scalar;
    unknown x: Angle in -1..1;
    sin(x) == factor * u;
}
