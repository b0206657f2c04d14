use kin_core::library::ScotchYoke;
use kin_core::prelude::*;

fn main() {
    let yoke = ScotchYoke { crank: 1.0, gamma: 1.5 };
    let _ = yoke.sweep(Assembly::Open).over(0.0..=6.28, 361);
}
