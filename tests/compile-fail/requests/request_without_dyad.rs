use kin_core::mechanism;

mechanism! {
    pub struct ScotchYoke {
        pub crank: Length,
    }
    input theta: Angle;
    unknown stroke: Length;
    stroke == crank * cos(theta);
    with transmission_angles;
}

fn main() {}
