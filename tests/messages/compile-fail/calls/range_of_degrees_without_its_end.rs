use kin_core::library::FourBar;
use kin_core::prelude::*;

fn main() {
    let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 70.0, r4: 60.0 };
    let _ = linkage.sweep(Assembly::Open).over(0..360, 361).table();
}
