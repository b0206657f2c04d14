use kin_core::mechanism;

mechanism! {
    pub struct Linkage {
        pub crank: Length,
        pub pivot: Point3,
        pub guide: Point,
        pub rod: Length,
    }
    input theta: Angle;
    unknown phi: Angle;
    norm(pivot + rot_x(phi) * vec3(0, 0, rod) - rot_z(theta) * vec3(crank, guide.x, guide.y)) == rod;
    output tip: Point3 = rot_x(phi) * guide;
}

fn main() {}
