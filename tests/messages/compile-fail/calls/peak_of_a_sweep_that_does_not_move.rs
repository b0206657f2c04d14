use kin_core::extremes::ExtremesError;
use kin_core::library::FourBar;
use kin_core::prelude::*;

fn main() -> Result<(), ExtremesError> {
    let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 70.0, r4: 60.0 };
    println!("{}", linkage.sweep(Assembly::Open).of("theta4_jerk").peak()?);
    Ok(())
}
