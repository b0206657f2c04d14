use kin_core::library::FourBar;
use kin_core::load::Loads;
use kin_core::prelude::*;

fn main() {
    let linkage = FourBar { r1: 0.9, r2: 0.3, r3: 0.7, r4: 0.6 };
    let loads = Loads::<FourBar>::new().inertia(0.1, |pose| pose.theta4);
    let turn = linkage.sweep(Assembly::Open).over(0.0..=6.28, 361);
    let _ = turn.of_expression(|at| at.effort(&loads, 0)).peak();
}
