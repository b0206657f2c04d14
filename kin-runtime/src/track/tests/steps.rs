//! What a track decides by: sides, rounding, the prediction of a step.

use std::vec;

use super::super::follow::{CORRECTION, attempted, station};
use super::super::line::{TrackLine, TrackPosition};
use super::{CRANK_ROCKER, DOUBLE_ROCKER};
use crate::any::Of;
use crate::assembly::Assembly;
use crate::curve::{LentRows, Sides, WayPoint, blur, fastest, is_crossed, is_indistinct, largest, largest_difference};
use crate::library::FourBar;
use crate::mechanism::{Mechanism, PoseOf};

#[test]
fn largest_magnitude_with_nan() {
    let of = |values: &[f64]| largest(values.iter().copied());
    assert_eq!(of(&[1.0, -3.0, 2.0]), 3.0);
    assert_eq!(of(&[]), 0.0);
    assert_eq!(of(&[-f64::INFINITY, 1.0]), f64::INFINITY);
    for values in [[f64::NAN, 1.0, 2.0], [1.0, f64::NAN, 2.0], [1.0, 2.0, f64::NAN]] {
        assert!(of(&values).is_nan(), "{values:?}");
    }
}

#[test]
fn fastest_is_the_first_of_equals() {
    assert_eq!(fastest(&[1.0, -3.0, 2.0]), 1);
    assert_eq!(fastest(&[-2.0, 2.0, 1.0]), 0);
    assert_eq!(fastest(&[0.0, 0.0]), 0);
}

/// Asks something of the line between two crank angles, at its beginning.
pub(in crate::track) fn on_the_way<R>(
    linkage: &FourBar,
    unknowns: [f64; 2],
    [from, to]: [f64; 2],
    ask: impl FnOnce(&TrackLine<'_>, WayPoint<'_>, &mut LentRows<'_>) -> R,
) -> R {
    let (mut inputs, mut end) = ([from], unknowns);
    let position = TrackPosition {
        inputs: &mut inputs,
        unknowns: &mut end,
    };
    let (parameters, from, to) = (linkage.parameters(), [from], [to]);
    FourBar::<f64>::lend(|lent| {
        let functions = Of::<FourBar>::FUNCTIONS;
        let (way, mut scratch) = TrackLine::new(functions, &parameters, [&from, &to], &unknowns, lent, position);
        let point = WayPoint {
            unknowns: &unknowns,
            travel: 0.0,
        };
        ask(&way, point, &mut scratch)
    })
}

/// At a limit the determinant changes its sign, and rounding moves the unknowns by its square root.
#[test]
fn rounding_grows_near_a_limit() {
    let end = DOUBLE_ROCKER.crank_range().unwrap().high;
    let mut before = 0.0;
    for gap in [0.5, 1e-2, 1e-4, 1e-6] {
        let unknowns = DOUBLE_ROCKER.position(end - gap, Assembly::Open).unwrap().unknowns();
        let (moved, is_unclear) = on_the_way(&DOUBLE_ROCKER, unknowns, [end - gap, 3.0], |way, point, scratch| {
            (blur(way, point, scratch), is_indistinct(way, point, scratch))
        });
        // The sensitivity is a few ε of the terms, divided by the determinant.
        let sensitivity = 1.0 / f64::sqrt(gap);
        assert!(
            moved > f64::EPSILON * sensitivity && moved < 100.0 * f64::EPSILON * sensitivity,
            "{gap}: {moved}"
        );
        assert!(moved > before, "{gap}: {moved}");
        assert!(!is_unclear, "{gap}");
        before = moved;
    }
    let unknowns = DOUBLE_ROCKER.position(end - 1e-15, Assembly::Open).unwrap().unknowns();
    on_the_way(&DOUBLE_ROCKER, unknowns, [end - 1e-15, 3.0], |way, point, scratch| {
        assert!(is_indistinct(way, point, scratch));
        // With an unknown as the parameter, a limit is an ordinary point, but a change point is not.
        assert!(!is_crossed(way, point, 0, scratch));
    });
    let parallelogram = FourBar {
        r1: 1.0,
        r2: 0.4,
        r3: 1.0,
        r4: 0.4,
    };
    for (angle, is_near) in [(1e-9, true), (1e-2, false)] {
        let crosses = on_the_way(&parallelogram, [0.0, angle], [angle, 3.0], |way, point, scratch| {
            is_crossed(way, point, 1, scratch)
        });
        assert_eq!(crosses, is_near, "{angle}");
    }
}

/// The two assemblies lie on different sides of the limit, and each stays on its side.
#[test]
fn sides_are_those_of_the_assembly() {
    let with_sides = |assembly: Assembly, angle: f64, ask: &mut dyn FnMut(&Sides<'_>)| {
        let unknowns = DOUBLE_ROCKER.position(angle, assembly).unwrap().unknowns();
        on_the_way(&DOUBLE_ROCKER, unknowns, [angle, 3.0], |way, point, scratch| {
            let linear = way.linearise(point, scratch).unwrap();
            ask(&Sides::of(way, &linear, scratch));
        });
    };
    let sines = vec![-1.9, -1.0, 0.5, 1.9];
    for &one in &sines {
        for &other in &sines {
            with_sides(Assembly::Open, one, &mut |one_side| {
                with_sides(Assembly::Crossed, other, &mut |crossed| {
                    assert!(!one_side.are_same(crossed) && !one_side.are_near(crossed));
                });
                with_sides(Assembly::Open, other, &mut |same| assert!(one_side.are_same(same)));
            });
        }
    }
}

/// The position at the end of a step agrees with the prediction, whatever the length of the step.
#[test]
fn steps_end_where_predicted() {
    let (mut taken, mut refused) = (0, 0);
    for linkage in [CRANK_ROCKER, DOUBLE_ROCKER] {
        for assembly in Assembly::BOTH {
            for from in [-1.5, -0.4, 0.3, 1.1] {
                let start = Mechanism::position(&linkage, [from], assembly).unwrap();
                on_the_way(&linkage, start, [from, from + 10.0], |way, point, scratch| {
                    let here = station(way, 0.0, point.unknowns, scratch).ok().unwrap();
                    for hundredths in 1..400 {
                        let mut scratch = scratch.scope();
                        let step = 0.01 * f64::from(hundredths);
                        let Ok(there) = attempted(way, &here, step, &mut scratch) else {
                            refused += 1;
                            continue;
                        };
                        taken += 1;
                        let near = here.predicted(step, &mut scratch);
                        let distance = largest_difference(there.point.unknowns, near, &[1.0; 2]);
                        let rates = there.rates(&[1.0; 2], &mut scratch);
                        let fastest = largest(rates.iter().copied()).max(1.0);
                        let allowed = CORRECTION * (step * fastest).min(1.0);
                        // Rounding moves these linkages by less than the last term.
                        assert!(
                            distance <= allowed + 1e-10,
                            "{assembly:?} from {from} by {step}: {distance}"
                        );
                    }
                });
            }
        }
    }
    assert!(taken > 500 && refused > 500, "{taken} {refused}");
}
