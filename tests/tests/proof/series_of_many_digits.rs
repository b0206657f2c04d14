//! The Taylor series of the reference, 77 digits long, against tables and against their own inverses.

use kin_tests::reference::series::Series;

const COUNT: usize = 6;

fn same(one: &Series, other: &Series) {
    for power in 0..COUNT {
        let difference = (&one.coefficient(power) - &other.coefficient(power)).nearest();
        assert!(difference.abs() < 1e-70, "power {power}: {one:?} {other:?}");
    }
}

fn argument() -> Series {
    Series::from_derivatives(&[0.4, -0.7, 1.3, 0.2, -2.1, 5.0])
}

/// The derivatives of functions of time itself, from tables.
#[test]
fn functions_of_time() {
    let time = Series::from_derivatives(&[0.5, 1.0]);
    let one = Series::from_derivatives(&[1.0]);
    same(
        &one.over(&time, COUNT),
        &Series::from_derivatives(&[2.0, -4.0, 16.0, -96.0, 768.0, -7680.0]),
    );
    let logarithm = time.ln(COUNT);
    let tail = Series::from_derivatives(&[0.0, 2.0, -4.0, 16.0, -96.0, 768.0]);
    same(&logarithm.minus(&Series::constant(logarithm.coefficient(0))), &tail);
    let zero = Series::from_derivatives(&[0.0, 1.0]);
    same(&zero.exp(COUNT), &Series::from_derivatives(&[1.0; COUNT]));
    let (sine, cosine) = zero.sin_cos(COUNT);
    same(&sine, &Series::from_derivatives(&[0.0, 1.0, 0.0, -1.0, 0.0, 1.0]));
    same(&cosine, &Series::from_derivatives(&[1.0, 0.0, -1.0, 0.0, 1.0, 0.0]));
    same(
        &zero.atan2(&one, COUNT),
        &Series::from_derivatives(&[0.0, 1.0, 0.0, -2.0, 0.0, 24.0]),
    );
}

#[test]
fn functions_and_their_inverses_cancel() {
    let x = argument();
    let one = Series::from_derivatives(&[1.0]);
    same(&x.over(&x, COUNT), &one);
    same(&x.times(&x, COUNT).sqrt(COUNT), &x);
    same(&x.exp(COUNT).ln(COUNT), &x);
    let (sine, cosine) = x.sin_cos(COUNT);
    same(&sine.times(&sine, COUNT).plus(&cosine.times(&cosine, COUNT)), &one);
    same(&sine.atan2(&cosine, COUNT), &x);
    let (sine, cosine) = x.sinh_cosh(COUNT);
    same(&cosine.times(&cosine, COUNT).minus(&sine.times(&sine, COUNT)), &one);
    same(&sine.plus(&cosine), &x.exp(COUNT));
    same(&sine.asinh(COUNT), &x);
    same(&cosine.acosh(COUNT), &x);
    same(&sine.over(&cosine, COUNT).atanh(COUNT), &x);
}
