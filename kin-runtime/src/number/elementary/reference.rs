//! Sine, cosine and arctangent to about 30 digits, by series in sums of two doubles, and the errors measured against
//! them.

use std::vec::Vec;

use crate::number::samples;

/// A sum of two doubles. The second is smaller than the last place of the first.
#[derive(Clone, Copy, Debug)]
pub(super) struct Double(pub(super) f64, pub(super) f64);

impl Double {
    /// The exact sum a + b (Knuth).
    fn sum(a: f64, b: f64) -> Self {
        let s = a + b;
        let part = s - a;
        Self(s, (a - (s - part)) + (b - part))
    }

    /// The exact product a b.
    fn product(a: f64, b: f64) -> Self {
        let p = a * b;
        Self(p, f64::mul_add(a, b, -p))
    }

    fn plus(self, other: Self) -> Self {
        let high = Self::sum(self.0, other.0);
        let low = Self::sum(self.1, other.1);
        let next = Self::sum(high.0, high.1 + low.0);
        Self::sum(next.0, next.1 + low.1)
    }

    fn minus(self, other: Self) -> Self {
        self.plus(Self(-other.0, -other.1))
    }

    fn times(self, other: Self) -> Self {
        let p = Self::product(self.0, other.0);
        Self::sum(p.0, p.1 + (self.0 * other.1 + self.1 * other.0))
    }

    fn over(self, divisor: f64) -> Self {
        let q = self.0 / divisor;
        let rest = self.minus(Self::product(q, divisor));
        Self::sum(q, rest.0 / divisor)
    }
}

/// π/2 as a sum of four doubles.
const RIGHT_ANGLE: [f64; 4] = [
    core::f64::consts::FRAC_PI_2,
    6.123_233_995_736_766e-17,
    -1.497_384_904_859_169_8e-33,
    5.562_271_104_316_826e-50,
];

/// The sine and cosine of an angle of up to 10⁶.
pub(super) fn sine_cosine(angle: f64) -> [Double; 2] {
    let quarters = (angle / RIGHT_ANGLE[0]).round();
    let mut r = Double(angle, 0.0);
    for part in RIGHT_ANGLE {
        r = r.minus(Double::product(quarters, part));
    }
    let square = r.times(r);
    // Every second term of the exponential series, from the n-th on.
    let series = |first: Double, n: u32| {
        let mut term = first;
        let mut terms = Vec::from([first]);
        for k in (n..30).step_by(2) {
            let t = term.times(square).over(f64::from((k + 1) * (k + 2)));
            term = Double(-t.0, -t.1);
            terms.push(term);
        }
        terms.into_iter().rev().reduce(Double::plus).unwrap()
    };
    let (sine, cosine) = (series(r, 1), series(Double(1.0, 0.0), 0));
    let negative = |x: Double| Double(-x.0, -x.1);
    match quarters.rem_euclid(4.0) {
        0.0 => [sine, cosine],
        1.0 => [cosine, negative(sine)],
        2.0 => [negative(sine), negative(cosine)],
        _ => [negative(cosine), sine],
    }
}

/// The angle of a point: the library's result, improved by one step of Newton's method. The remaining error is the cube
/// of the library's error.
pub(super) fn arc_tangent(y: f64, x: f64) -> Double {
    let angle = y.atan2(x);
    let [sine, cosine] = sine_cosine(angle);
    let (x, y) = (Double(x, 0.0), Double(y, 0.0));
    let across = y.times(cosine).minus(x.times(sine));
    let along = x.times(cosine).plus(y.times(sine));
    Double(angle, 0.0).plus(across.over(along.0))
}

/// The error of `found` in units in the last place, for a number type with `digits` binary digits and the smallest unit
/// `smallest`.
pub(super) fn units(found: f64, expected: Double, digits: i32, smallest: f64) -> f64 {
    // log2 may be off by one next to a power of two.
    let size = expected.0.abs().max(f64::MIN_POSITIVE);
    let mut power = size.log2().floor();
    power += f64::from(size >= f64::exp2(power + 1.0)) - f64::from(size < f64::exp2(power));
    let unit = f64::max(f64::exp2(power + 1.0 - f64::from(digits)), smallest);
    ((found - expected.0) - expected.1).abs() / unit
}

/// The divisor of sample counts. The Miri interpreter is slower by about this factor.
pub(super) const THINNED: u32 = if cfg!(miri) { 1000 } else { 1 };

/// Fractions that fill 0 .. 1 evenly: as many as `count`, or a tenth of them.
pub(super) fn fractions(count: u32) -> impl Iterator<Item = f64> {
    let count = samples::of(count).div_ceil(THINNED);
    (1..=count).map(|k| (f64::from(k) * 0.618_033_988_749_894_9).fract())
}

#[cfg(test)]
mod tests {
    use super::{arc_tangent, sine_cosine};

    /// The expected values are the first two doubles of 40-digit results of the multiple-precision package mpmath.
    #[test]
    fn a_few_values_to_thirty_digits() {
        let [sine, cosine] = sine_cosine(1.0);
        let [far_sine, far_cosine] = sine_cosine(100_000.0);
        for (found, expected) in [
            (sine, (0.841_470_984_807_896_5, 1.776_845_092_935_536e-18)),
            (cosine, (0.540_302_305_868_139_8, -4.760_954_612_604_417e-17)),
            (far_sine, (0.035_748_797_972_016_51, 1.542_974_370_610_986_1e-18)),
            (far_cosine, (-0.999_360_807_438_212_4, -2.344_708_890_518_740_2e-17)),
            (
                arc_tangent(1.0, 2.0),
                (0.463_647_609_000_806_1, 2.269_877_745_296_168_7e-17),
            ),
            (
                arc_tangent(3.0, -1.0),
                (1.892_546_881_191_539, -9.738_372_121_068_368e-17),
            ),
        ] {
            assert_eq!(found.0, expected.0);
            assert!((found.1 - expected.1).abs() <= 1e-30, "{found:?}");
        }
    }
}
