use kin_core::library::FourBar;
use kin_core::prelude::*;
use kin_core::sweep::SweepError;

fn main() -> Result<(), SweepError> {
    let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 70.0, r4: 60.0 };
    let table = linkage.sweep(Assembly::Open).table()?;
    println!("{table}");
    Ok(())
}
