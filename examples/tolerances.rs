//! Every part is made within a tolerance: how far off is the coupler's point, and which part is to blame?
//!
//! ```sh
//! cargo run --example tolerances
//! ```
//!
//! ```text
//! theta   expected   at worst   most by
//!    0°   0.080 mm   0.165 mm   rocker (0.060 mm)
//!   45°   0.071 mm   0.148 mm   rocker (0.052 mm)
//!   90°   0.057 mm   0.119 mm   rocker (0.045 mm)
//!  135°   0.063 mm   0.132 mm   rocker (0.047 mm)
//!  180°   0.075 mm   0.165 mm   rocker (0.051 mm)
//!  225°   0.072 mm   0.159 mm   rocker (0.047 mm)
//!  270°   0.068 mm   0.149 mm   rocker (0.045 mm)
//!  315°   0.073 mm   0.164 mm   rocker (0.052 mm)
//! ```

use kin_core::prelude::*;

mechanism! {
    /// A four-bar linkage with a point of its coupler.
    struct Guide { ground: Length, crank: Length, coupler: Length, rocker: Length, trace: Vector }
    input theta: Angle;
    unknown phi: Angle, psi: Angle;
    crank * cis(theta) + coupler * cis(phi) == ground + rocker * cis(psi);
    output point: Point = crank * cis(theta) + trace * cis(phi);
    with sensitivities;
}

/// By how much a dimension may be off (mm), in the order of `DESCRIPTION`.
const TOLERANCES: [f64; 6] = [0.05, 0.02, 0.05, 0.05, 0.02, 0.02];

fn main() -> Result<(), SolveError> {
    let guide: Guide = Guide {
        ground: 90.0,
        crank: 30.0,
        coupler: 80.0,
        rocker: 60.0,
        trace: Plane::new(60.0, 40.0),
    };
    println!("theta   expected   at worst   most by");
    for degrees in (0..360).step_by(45) {
        let pose = guide.solve(f64::from(degrees).to_radians(), Assembly::Open)?;
        let by = guide.sensitivities_of(&pose);
        // the distance that each dimension moves the point when it is off by its tolerance, to first order
        let moves: [Plane; 6] = std::array::from_fn(|index| TOLERANCES[index] * by[index].point.position());
        let lengths = moves.map(|way| way.norm_squared().sqrt());
        let expected = lengths.iter().map(|length| length * length).sum::<f64>().sqrt();
        let worst: f64 = lengths.iter().sum();
        let (most, parameter) = lengths
            .into_iter()
            .zip(Guide::<f64>::DESCRIPTION.parameters)
            .max_by(|one, other| one.0.total_cmp(&other.0))
            .expect("there are six");
        println!(
            "{degrees:4}° {expected:7.3} mm {worst:7.3} mm   {} ({most:.3} mm)",
            parameter.name
        );
    }
    Ok(())
}
