use kin_core::prelude::*;

mechanism! {
    struct Press { crank: Length, rod: Length }
    input theta: Angle;
    unknown phi, psi: Angle;

    crank * cis(theta) + rod * cis(phi) == 2 * crank + rod * cis(psi);
}

fn main() {}
