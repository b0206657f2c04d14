use kin_core::mechanism;

mechanism! {
    pub struct FourBar {}
    input theta2: Angle;
    unknown theta3: Angle, theta4: Angle;
    cis(theta2) + cis(theta3) == 1 + cis(theta4);
}

fn main() {}
