use kin_core::mechanism;

mechanism! {
    pub struct Linkage {
        pub crank: Length,
        pub pivot: Point3,
        pub rod: Length,
    }
    input theta: Angle;
    unknown phi: Angle, psi: Angle, x: Length;
    rot_x(phi) * rot_y(psi) == rot_z(theta);
    x == norm(pivot) + crank + rod;
}

fn main() {}
