use kin_core::prelude::*;

mechanism! {
    pub struct Atkinson { crank: Length, link: Length, swing: Length, base: Length, con: Length }
    input theta: Angle;
    unknown tri: Angle, sw: Angle, rod: Angle, piston: Length;
    crank * cis(theta) + link * cis(tri) == base + swing * cis(sw);
    crank * cis(theta) + link * cis(tri - PI / 3) + con * cis(rod) == vec2(0, piston);
}

fn main() {
    let engine: Atkinson = Atkinson { crank: 30.0, link: 60.0, swing: 70.0, base: 80.0, con: 120.0 };
    let assembly = AtkinsonAssembly { tri_sw: Assembly::Open, piston: Assembly::Open };
    let _ = engine.position(1.0, assembly);
}
