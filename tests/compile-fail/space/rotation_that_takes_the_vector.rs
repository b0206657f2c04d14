use kin_core::prelude::*;

mechanism! {
    struct Press { crank: Length, rod: Length, offset: Length }
    input theta: Angle;
    unknown stroke: Length;

    norm(rot_z(theta, vec3(crank, 0, 0)) - vec3(stroke, 0, offset)) == rod;
}

fn main() {}
