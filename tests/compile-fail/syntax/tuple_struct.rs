use kin_core::mechanism;

mechanism! {
    pub struct FourBar(Length, Length);
    input theta2: Angle;
    unknown theta3: Angle, theta4: Angle;
    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
}

fn main() {}
