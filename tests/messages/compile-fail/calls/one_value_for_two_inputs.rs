use kin_core::prelude::*;

mechanism! {
    pub struct FiveBar { left: Length, right: Length, base: Length, near: Length, far: Length }
    input alpha: Angle, beta: Angle;
    unknown gamma: Angle, delta: Angle;
    left * cis(alpha) + near * cis(gamma) == base + right * cis(beta) + far * cis(delta);
}

fn main() {
    let robot: FiveBar = FiveBar { left: 100.0, right: 100.0, base: 80.0, near: 150.0, far: 150.0 };
    let _ = robot.solve(2.0, Assembly::Open);
}
