use kin_core::mechanism;

mechanism! {
    pub struct SliderCrank {
        pub crank: Length,
        pub rod: Length,
        pub incline: Direction,
    }
    input theta: Angle;
    unknown phi: Direction, s: Length;
    crank * cis(theta) + rod * cis(phi) == s * cis(incline);
}

fn main() {}
