use kin_core::prelude::*;

mechanism! {
    /// Every mistake is told at once, and what uses the mechanism below adds none.
    pub struct FourBar {
        pub r1: Length,
        pub r2: Lenght,
        pub r3: Length,
        pub r4: Length,
        pub r5: Length,
    }
    input theta2: Angle
    unknown theta3: Angle;
    unknown theta4: Angle where theta4 > r1;
    unknown type: Angle;
    r2 * cis(theta2) + r3 * cis(thetta3) == r1 + theta2 + r4 * cis(theta4);
    type + theta4 == PI;
    let half = if r3 > 0 { r3 / 2 } else { 0 };
    output midpoint: Point = r2 * cis(theta2) + half * cis(theta3);
    output tip: Point = sin(r4) * cis(theta4);
}

fn turn(crank: Motion) -> Result<f64, SolveError> {
    let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 60.0, r4: 45.0, r5: 1.0 };
    let position = linkage.position(1.0, Assembly::Open)?;
    let velocity = position.velocity(10.0);
    let all = linkage.solve(crank, FourBar::<f64>::ASSEMBLIES[0])?;
    Ok(velocity.theta4 + all.midpoint.snap().x)
}

fn main() {
    turn(Motion::from([1.0, 10.0, 0.0, 0.0, 0.0])).unwrap();
}
