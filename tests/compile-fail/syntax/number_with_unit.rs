use kin_core::mechanism;

mechanism! {
    pub struct FourBar {
        pub r1: Length,
        pub r2: Length,
        pub r3: Length,
        pub r4: Length,
    }
    input theta2: Angle;
    unknown theta3: Angle, theta4: Angle;
    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
    output reach: Length = r1 + 5mm;
}

fn main() {}
