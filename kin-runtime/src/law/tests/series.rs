//! The closed derivatives, beside truncated series that go through the values only.

use super::{Random, shapes};
use crate::law::{ConstantSpeed, Dwell, Fourier, Law as _, Limits, Piecewise, Polynomial, Rise, SCurve, Sequence};
use crate::motion::Motion;
use crate::number::Number as _;
use crate::number::series::Series;

const N: usize = 7;

/// Compares at scattered times. The size of a derivative is its largest value there.
fn assert_same(name: &str, law: &dyn Piecewise<f64>, series: &dyn Piecewise<Series<N>>, roundings: f64) {
    let duration = law.duration();
    let times: std::vec::Vec<f64> = (0..40).map(|step| duration * (f64::from(step) + 0.37) / 40.0).collect();
    let mut sizes = [f64::MIN_POSITIVE; N];
    for &time in &times {
        for (size, entry) in sizes.iter_mut().zip(law.at::<N>(time).derivatives()) {
            *size = size.max(entry.abs());
        }
    }
    for time in times {
        let closed = law.at::<N>(time).derivatives();
        let mut instant = [0.0; N];
        (instant[0], instant[1]) = (time, 1.0);
        let by_series = series.at::<1>(Series::from_derivatives(instant)).value().derivatives();
        for order in 0..N {
            let difference = (closed[order] - by_series[order]).abs();
            assert!(
                difference <= roundings * f64::EPSILON * sizes[order],
                "{name}, order {order} at {time}: {} and {}",
                closed[order],
                by_series[order]
            );
        }
    }
}

#[test]
fn derivatives_are_those_of_the_value() {
    type Of = Series<N>;
    let c = Of::constant;
    for shape in shapes() {
        let law = Rise::new(shape, 2.0, 5.0, 0.8).expect("it is a rise");
        let series = Rise::new(shape, c(2.0), c(5.0), c(0.8)).expect("it is a rise");
        // the series loses digits as n! of its sines and in sums of binomials up to 9 choose 4
        assert_same("rise", &law, &series, 4000.0);
    }
    let (one, two) = ([[0.3, -0.2], [0.1, 0.05], [0.0, 0.02]], 1.7);
    let law = Fourier::new(0.4, one, two).expect("it is one");
    let series = Fourier::new(c(0.4), one.map(|pair| pair.map(c)), c(two)).expect("it is one");
    assert_same("Fourier", &law, &series, 4000.0);

    let (start, end) = ([1.0, -2.0, 3.0, 4.0], [2.0, 1.0, 0.0, -5.0]);
    let law: Polynomial<f64, 8> = Polynomial::between(start.into(), end.into(), 0.9).expect("it is one");
    let series: Polynomial<Of, 8> =
        Polynomial::between(start.map(c).into(), end.map(c).into(), c(0.9)).expect("it is one");
    assert_same("polynomial", &law, &series, 4000.0);

    for snap in [None, Some(5e4)] {
        let law = SCurve::new(
            0.0,
            1.0,
            Limits {
                velocity: 2.0,
                acceleration: 12.0,
                jerk: 300.0,
                snap,
            },
        );
        let limits = Limits {
            velocity: c(2.0),
            acceleration: c(12.0),
            jerk: c(300.0),
            snap: snap.map(c),
        };
        let series = SCurve::new(c(0.0), c(1.0), limits);
        assert_same("S-curve", &law.expect("it is one"), &series.expect("it is one"), 4000.0);
    }

    let dwell = (
        Dwell::new(2.0, 0.3).expect("it is one"),
        Dwell::new(c(2.0), c(0.3)).expect("it is one"),
    );
    let run = (
        ConstantSpeed::new(2.0, -1.5, 0.4).expect("it is one"),
        ConstantSpeed::new(c(2.0), c(-1.5), c(0.4)).expect("it is one"),
    );
    let law = Sequence::new([&dwell.0, &run.0]).expect("it is one");
    let series = Sequence::new([&dwell.1, &run.1]).expect("it is one");
    assert_same("sequence", &law, &series, 16.0);
}

/// The chain rule, beside the law run over the series of its driving angle.
#[test]
fn driven_laws_follow_the_chain_rule() {
    let mut random = Random(5);
    let c = Series::<N>::constant;
    for shape in shapes() {
        let law = Rise::new(shape, 2.0, 5.0, 0.8).expect("it is a rise");
        let series = Rise::new(shape, c(2.0), c(5.0), c(0.8)).expect("it is a rise");
        for _ in 0..20 {
            let mut drive = [0.0; N].map(|_: f64| random.signed(1.0));
            drive[0] = 0.8 * random.part();
            let found = law.driven(Motion::new(drive)).derivatives();
            let expected = series.at::<1>(Series::from_derivatives(drive)).value().derivatives();
            // the derivatives of the law by its angle are as large as these
            let sizes = [5.0, 1e1, 1e2, 1e3, 3e4, 1e6, 3e7];
            for order in 0..N {
                let difference = (found[order] - expected[order]).abs();
                assert!(difference <= 1e-12 * sizes[order], "{shape:?} {order}: {difference:e}");
            }
        }
    }
}

/// An S-curve's duration carries derivatives through its roots: in other units of time and length it is known.
#[test]
fn s_curves_carry_derivatives_of_their_limits() {
    let mut random = Random(11);
    for _ in 0..300 {
        let [distance, velocity, acceleration, jerk, snap] = [0.0; 5].map(|_: f64| random.size(1e-2, 1e2));
        let mut growth = [0.0; N];
        growth[1] = 1.0;
        let longer = Series::from_derivatives(growth).exp();
        let c = Series::<N>::constant;
        let limits = |snap| Limits {
            velocity: c(velocity) / longer,
            acceleration: c(acceleration) / longer.powi(2),
            jerk: c(jerk) / longer.powi(3),
            snap,
        };
        for snap in [None, Some(c(snap) / longer.powi(4))] {
            let law = SCurve::new(c(0.0), c(distance), limits(snap)).expect("it is one");
            let duration = law.duration().derivatives();
            for derivative in duration {
                assert!((derivative - duration[0]).abs() <= 1e-11 * duration[0], "{duration:?}");
            }
        }
    }
}
