use kin_core::mechanism;

mechanism! {
    pub struct Both {
        pub a: Length,
        pub b: Length,
    }
    input t: Angle;
    unknown x: Length, y: Length, phi: Angle;
    x == a * cos(t);
    x == b * sin(t);
    y * cos(phi) == a * sin(t);
}

fn main() -> Result<(), kin_core::SolveError> {
    let both = Both { a: 1.0, b: 2.0 };
    let pose = both.solve(kin_core::Motion::constant(1.0))?;
    println!("{}", pose.x.snap() + pose.y.jerk());
    Ok(())
}
