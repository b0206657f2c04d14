use kin_core::mechanism;

mechanism! {
    struct Crank { a: Length }
    input theta: Angle;
    unknown x: Length;
    x == a * cos(theta);
    output speed: Length = x.velocity();
    output jolt: Length = jerk(x);
    output push: Length = x.acceleration;
}

fn main() {}
