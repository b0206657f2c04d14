use kin_core::mechanism;

mechanism! {
    struct FourBar { r1: Length, r2: Length, r3: Length, r4: Length }
    input theta2: Angle;
    unknown theta3: Angle, theta3: Angle;
    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
}

fn main() {}
