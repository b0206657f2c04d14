use kin_core::mechanism;

mechanism! {
    pub struct Linkage {
        pub crank: Length,
        pub pivot: Point3,
        pub rod: Length,
    }
    input theta: Angle;
    unknown phi: Angle, psi: Angle;
    pivot + rot_x(phi) * vec3(0, 0, rod) == crank * cis(theta + psi);
}

fn main() {}
