use kin_core::mechanism;

mechanism! {
    struct Arm {
        a: Vector3,
        l: Length,
    }
    input t: Angle;
    unknown u: Angle;
    norm(rot(a, u) * a - rot_z(t) * vec3(l, 0, 0)) == l;
}

fn main() {}
