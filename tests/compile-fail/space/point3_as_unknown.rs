use kin_core::mechanism;

mechanism! {
    pub struct Linkage {
        pub crank: Length,
        pub pivot: Point3,
        pub rod: Length,
    }
    input theta: Angle;
    unknown ball: Point3;
    norm(ball - pivot) == rod + crank * theta;
}

fn main() {}
