//! The library's mechanisms against published values and exact geometry.
//!
//! Both oracles are run over the whole library in the tests of `proof`.

mod andrews;
mod drawn_curves;
mod platforms;
mod single_loops;
mod stored;
mod turns;

use kin_core::prelude::*;
use kin_tests::mechanisms::cases::ThroughSnap;
use kin_tests::oracles::{ALLOWED, Gauge};
use kin_tests::random::Random;

type Path = Motion<Plane, 5>;

/// Crank motions with random rates, evenly spread.
fn cranks(low: f64, high: f64, seed: u64) -> Vec<Motion> {
    let mut random = Random::new(seed);
    (0..60)
        .map(|step| low + (high - low) * (f64::from(step) + 0.5) / 60.0)
        .map(|angle| Motion::new(random.motion(angle)))
        .collect()
}

/// The error that the links of lengths `links`, at angles with the places `angles` among the unknowns, leave in a
/// point.
fn point_unit<M: ThroughSnap>(
    mechanism: &M,
    inputs: M::Inputs<Motion>,
    unknowns: &M::Unknowns<Motion>,
    links: &[(f64, usize)],
    order: usize,
) -> f64 {
    let gauge = Gauge::new(mechanism, &inputs, unknowns);
    let links: f64 = links
        .iter()
        .map(|(length, angle)| length * gauge.unknown(*angle, order))
        .sum();
    ALLOWED[order] * links
}

/// The points that a crank's angles in degrees give.
fn points(degrees: impl Iterator<Item = f64>, point: impl Fn(f64) -> Plane) -> Vec<Plane> {
    degrees.map(|angle| point(angle.to_radians())).collect()
}

/// The largest extent of points along x and along y.
fn extent(points: &[Plane]) -> Plane {
    let spread = |coordinate: fn(&Plane) -> f64| {
        let low = points.iter().map(coordinate).fold(f64::INFINITY, f64::min);
        points.iter().map(coordinate).fold(f64::NEG_INFINITY, f64::max) - low
    };
    Plane::new(spread(|point| point.x), spread(|point| point.y))
}

/// Asserts that a figure is the published one, to the digits that are printed.
#[track_caller]
fn assert_printed(own: f64, printed: f64, last_digit: f64) {
    assert!(
        (own - printed).abs() <= 0.5 * last_digit,
        "{own} is not printed as {printed}"
    );
}
