use kin_core::prelude::*;

mechanism! {
    struct Press { arm: Length, forearm: Length }
    input shoulder: Angle;
    unknown x: Length, y: Length;

    arm * cis(shoulder) + forearm * cis(elbow) == vec2(x, y);
}

fn main() {}
