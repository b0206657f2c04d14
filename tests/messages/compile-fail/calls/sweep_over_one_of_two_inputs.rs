use kin_core::library::FiveBar;
use kin_core::prelude::*;

fn main() {
    let robot = FiveBar { ground: 2.0, left: 1.5, left_rod: 2.0, right_rod: 2.0, right: 1.5 };
    let _ = robot.sweep(Assembly::Open).over(0.0..=1.0, 11);
}
