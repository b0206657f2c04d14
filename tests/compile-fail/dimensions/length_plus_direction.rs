use kin_core::mechanism;

mechanism! {
    pub struct SliderCrank {
        pub crank: Length,
        pub rod: Length,
    }
    input theta: Angle;
    unknown phi: Direction, s: Length;
    crank * cis(theta) + rod * cis(phi) == vec2(s + phi, 0);
}

fn main() {}
