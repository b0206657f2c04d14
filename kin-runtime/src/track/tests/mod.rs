//! A track ends where it should, and reports its obstacles. The package of tests tracks mechanisms of several loops,
//! and coupled ones.

mod ends;
mod limits;
mod revolutions;
mod steps;

use core::f64::consts::TAU;

use super::{TrackError, TrackErrorOf, track};
use crate::assembly::Assembly;
use crate::library::FourBar;
use crate::mechanism::PoseOf;
pub(super) use steps::on_the_way;

const CRANK_ROCKER: FourBar = FourBar {
    r1: 90.0,
    r2: 30.0,
    r3: 70.0,
    r4: 60.0,
};

const DOUBLE_ROCKER: FourBar = FourBar {
    r1: 90.0,
    r2: 30.0,
    r3: 60.0,
    r4: 45.0,
};

fn turned_alike(one: f64, other: f64) -> f64 {
    let difference = one - other;
    (difference - (difference / TAU).round() * TAU).abs()
}

fn from_to(linkage: &FourBar, assembly: Assembly, from: f64, to: f64) -> Result<[f64; 2], TrackErrorOf<FourBar>> {
    let start = linkage.position(from, assembly).unwrap().unknowns();
    track(linkage, [from], start, [to])
}
