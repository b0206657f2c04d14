//! The nested dual numbers, whose cost growth is compared with, differentiate as they should.

use kin_core::Number;
use kin_core::series::Series;
use kin_tests::carrier::Carrier;
use kin_tests::nested::Nested;

type Fourth = Nested<Nested<Nested<Nested<f64>>>>;

fn derivatives(number: Fourth) -> [f64; 5] {
    [
        number.value.value.value.value,
        number.rate.value.value.value,
        number.rate.rate.value.value,
        number.rate.rate.rate.value,
        number.rate.rate.rate.rate,
    ]
}

/// Every operation, and every function, against Taylor series.
fn check(name: &str, nested: impl Fn(Fourth, Fourth) -> Fourth, series: impl Fn(Series<5>, Series<5>) -> Series<5>) {
    let (x, y) = ([0.4, -0.7, 1.3, 0.2, -2.1], [0.9, 0.3, -0.4, 1.1, 0.5]);
    let own = derivatives(nested(Fourth::carry(&x), Fourth::carry(&y)));
    let expected = series(Series::carry(&x), Series::carry(&y)).derivatives();
    // both come by the highest derivative through sums of products that are about as large
    let size = expected
        .iter()
        .fold(0.0_f64, |size, derivative| size.max(derivative.abs()));
    for (own, expected) in own.into_iter().zip(expected) {
        let error = (own - expected).abs() / (f64::EPSILON * size);
        assert!(error <= 32.0, "{name}: {own} instead of {expected}");
    }
}

macro_rules! check {
    ($($name:literal $function:expr;)+) => {
        $(check($name, $function, $function);)+
    };
}

#[test]
fn they_agree_with_series() {
    check! {
        "sum" |x, y| x + y;
        "difference" |x, y| -(x - y);
        "product" |x, y| x * y;
        "quotient" |x, y| x / y;
        "root" |x, _| x.sqrt();
        "sine" |x, _| x.sin_cos().0;
        "cosine" |x, _| x.sin_cos().1;
        "arc sine" |x, _| x.asin();
        "arc cosine" |x, _| x.acos();
        "arctangent" |x, _| x.atan();
        "arctangent of two" Number::atan2;
        "hyperbolic sine" |x, _| x.sinh();
        "hyperbolic cosine" |x, _| x.cosh();
        "hyperbolic tangent" |x, _| x.tanh();
        "area hyperbolic sine" |x, _| x.asinh();
        "area hyperbolic cosine" |x, y| (x + y + y).acosh();
        "area hyperbolic tangent" |x, _| x.atanh();
        "exponential" |x, _| x.exp();
        "logarithm" |_, y| y.ln();
    }
    assert_eq!(<Fourth as Number>::ORDER, 4);
}
