//! A number that stands for all its values over an interval of the input.

pub(crate) mod linear;

use core::ops::{Add, Div, Mul, Neg, Sub};

use num_traits::Float;

use crate::assembly::Assembly;
use crate::failure::Failure;
use crate::number::{Number, real_parts};
use crate::solve::{Check, Choose, Equations, NewtonMemory, Scalar};

/// The bound of a number of which nothing is known.
pub(crate) const HUGE: f64 = 1e150;
/// The width of bounds beyond which nothing is known of a number.
pub(crate) const UNBOUNDED: f64 = 1e75;
/// The smallest bound that is not zero. Its square does not underflow.
const TINY: f64 = 1e-140;
/// The error of an elementary function, relative to its largest value.
const FUNCTION: f64 = 8.0 * f64::EPSILON;

/// The failure where some values of the interval lead one way, and others another way.
pub(crate) const UNDECIDED: &str = "interval in which the solver decides both ways";

/// What is not certain about a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Doubt(u8);

impl Doubt {
    /// Every value exists.
    pub(crate) const NONE: Self = Self(0);
    /// The values exist from some point of the interval on, or everywhere, or nowhere.
    const RISING: Self = Self(1);
    /// The values exist up to some point of the interval, or everywhere, or nowhere.
    const FALLING: Self = Self(2);
    /// Nothing is known about where the values exist.
    const UNKNOWN: Self = Self(4);
    /// Rounding decides in the middle of the interval, and a shorter interval decides no more.
    const ROUNDING: Self = Self(8);

    /// The doubt about a number made of two.
    #[inline]
    pub(crate) const fn and(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// Whether values exist at both ends only if they exist in between, and the points where they exist touch one
    /// certain end.
    #[inline]
    pub(crate) const fn is_one_sided(self) -> bool {
        self.0 == Self::RISING.0 || self.0 == Self::FALLING.0
    }

    /// Whether rounding decides, so that a shorter interval decides no more.
    #[inline]
    pub(crate) const fn is_rounding(self) -> bool {
        self.0 & Self::ROUNDING.0 != 0
    }
}

/// All values of a function of one variable t in -1 ..= 1.
///
/// The value at t = 0 has an error of at most `error`. All values lie between `low` and `high`, and all derivatives
/// between `least_slope` and `greatest_slope`, rounding included: each operation widens its bounds by more than its
/// error. (R. E. Moore, R. B. Kearfott and M. J. Cloud, Introduction to Interval Analysis, SIAM 2009: natural
/// extensions and, in [`Bounds::tight`], the mean value form.)
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bounds {
    middle: f64,
    error: f64,
    pub(crate) low: f64,
    pub(crate) high: f64,
    least_slope: f64,
    greatest_slope: f64,
    pub(crate) doubt: Doubt,
}

/// The smaller of two numbers, neither of which is NaN.
#[inline]
fn smaller(one: f64, other: f64) -> f64 {
    if one < other { one } else { other }
}

/// The larger of two numbers, neither of which is NaN.
#[inline]
fn larger(one: f64, other: f64) -> f64 {
    if one > other { one } else { other }
}

/// The smallest interval that holds the products of two intervals.
#[inline]
pub(crate) fn product(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    widened(rounded_product(a, b))
}

/// The interval of the rounded products of the ends of two intervals.
#[inline]
fn rounded_product(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    let [one, two, three, four] = [a[0] * b[0], a[0] * b[1], a[1] * b[0], a[1] * b[1]];
    [
        smaller(smaller(one, two), smaller(three, four)),
        larger(larger(one, two), larger(three, four)),
    ]
}

/// An interval that holds the exact result of an operation, whose rounded ends are given.
#[inline]
pub(crate) fn widened([low, high]: [f64; 2]) -> [f64; 2] {
    let size = larger(low.abs(), high.abs());
    // Only the product with an exact zero is zero: bounds do not underflow, and stay above the numbers with which
    // processors are slow.
    let slack = if size < TINY && size > 0.0 {
        TINY
    } else {
        f64::EPSILON * size
    };
    let [low, high] = [low - slack, high + slack];
    // Nothing is known about a bound that is not a number.
    [
        if low > -HUGE { low } else { -HUGE },
        if high < HUGE { high } else { HUGE },
    ]
}

/// The reciprocals of an interval.
#[inline]
pub(crate) fn reciprocal([low, high]: [f64; 2]) -> [f64; 2] {
    if low > 0.0 || high < 0.0 {
        widened([1.0 / high, 1.0 / low])
    } else {
        [-HUGE, HUGE]
    }
}

impl Bounds {
    /// The variable itself: all values from `low` to `high`.
    #[inline]
    pub(crate) fn variable(low: f64, high: f64) -> Self {
        let middle = 0.5 * (low + high);
        let [least_slope, greatest_slope] = widened([0.5 * (high - low); 2]);
        Self {
            middle,
            error: 0.0,
            low,
            high,
            least_slope,
            greatest_slope,
            doubt: Doubt::NONE,
        }
    }

    /// A number that is known to one unit in its last place, as a length that was read or multiplied by a unit. What
    /// such a unit decides is not decided.
    #[inline]
    pub(crate) fn rounded(value: f64) -> Self {
        let error = f64::EPSILON * value.abs();
        Self {
            error,
            low: value - error,
            high: value + error,
            ..Self::constant(value)
        }
    }

    /// A number that differs from another one by an error at most, and by rounding.
    pub(crate) fn around(value: f64, error: f64) -> Self {
        let error = (error + 2.0 * f64::EPSILON * value.abs()) * (1.0 + 2.0 * f64::EPSILON);
        Self {
            error,
            low: value - error,
            high: value + error,
            ..Self::constant(value)
        }
    }

    /// Any number of an interval.
    pub(crate) fn within([low, high]: [f64; 2]) -> Self {
        Self::around(0.5 * (low + high), 0.5 * (high - low))
    }

    /// The same function, whose value in the middle of the interval has this error at most, within bounds that are
    /// known of its derivative.
    pub(crate) fn sloped(self, error: f64, slopes: [f64; 2]) -> Self {
        let [least_slope, greatest_slope] = slopes;
        Self {
            error: smaller(error, self.error),
            least_slope,
            greatest_slope,
            ..self
        }
        .tight()
    }

    /// The largest size of its values.
    pub(crate) fn size(self) -> f64 {
        larger(self.low.abs(), self.high.abs())
    }

    /// Whether its values and its derivative have bounds.
    pub(crate) fn is_bounded(self) -> bool {
        larger(self.size(), larger(self.least_slope.abs(), self.greatest_slope.abs())) < UNBOUNDED
    }

    /// The value in the middle of the interval, as far as it exists.
    #[inline]
    pub(crate) fn middle(self) -> f64 {
        self.middle
    }

    /// The largest error of the value in the middle of the interval.
    #[inline]
    pub(crate) fn error(self) -> f64 {
        self.error
    }

    #[inline]
    fn new(middle: f64, error: f64, values: [f64; 2], slopes: [f64; 2], doubt: Doubt) -> Self {
        let [low, high] = widened(values);
        let [least_slope, greatest_slope] = slopes;
        Self {
            middle,
            error: error + f64::EPSILON * middle.abs(),
            low,
            high,
            least_slope,
            greatest_slope,
            doubt,
        }
        .tight()
    }

    /// Whether this is one number, known up to an error, which exists everywhere.
    #[inline]
    fn is_constant(self) -> bool {
        self.least_slope == 0.0 && self.greatest_slope == 0.0 && self.doubt == Doubt::NONE
    }

    /// This function times a constant. Its bounds are almost as tight as before.
    #[inline]
    fn scaled(self, constant: Self) -> Self {
        let factor = constant.middle;
        let times = |[low, high]: [f64; 2]| {
            let slack = constant.error * larger(low.abs(), high.abs());
            let [low, high] = [low * factor, high * factor];
            let [low, high] = if factor < 0.0 { [high, low] } else { [low, high] };
            widened([low - slack, high + slack])
        };
        let middle = self.middle * factor;
        let ([low, high], [least_slope, greatest_slope]) = (times(self.values()), times(self.slopes()));
        let error = self.error * factor.abs() + constant.error * (self.middle.abs() + self.error);
        Self {
            middle,
            error: error * (1.0 + 4.0 * f64::EPSILON) + f64::EPSILON * middle.abs(),
            low,
            high,
            least_slope,
            greatest_slope,
            doubt: self.doubt,
        }
    }

    /// The same function within the bounds that its derivative gives.
    #[inline]
    fn tight(mut self) -> Self {
        let reach =
            (larger(self.least_slope.abs(), self.greatest_slope.abs()) + self.error) * (1.0 + 4.0 * f64::EPSILON);
        let rounding = f64::EPSILON * self.middle.abs();
        let (low, high) = (self.middle - reach - rounding, self.middle + reach + rounding);
        if reach < HUGE {
            self.low = larger(low, self.low);
            self.high = smaller(high, self.high);
        }
        self
    }

    /// The same function within bounds that are known of its derivative.
    pub(crate) fn with_slopes(mut self, [low, high]: [f64; 2]) -> Self {
        self.least_slope = larger(low, self.least_slope);
        self.greatest_slope = smaller(high, self.greatest_slope);
        self.tight()
    }

    #[inline]
    pub(crate) fn values(self) -> [f64; 2] {
        [self.low, self.high]
    }

    #[inline]
    pub(crate) fn slopes(self) -> [f64; 2] {
        [self.least_slope, self.greatest_slope]
    }

    /// A function of this number: its values, and its derivatives with respect to this number.
    #[inline]
    fn through(self, middle: f64, [low, high]: [f64; 2], slopes: [f64; 2]) -> Self {
        let slack = FUNCTION * low.abs().max(high.abs()).max(f64::MIN_POSITIVE);
        let steepest = slopes[0].abs().max(slopes[1].abs());
        Self::new(
            middle,
            self.error * steepest + slack,
            [low - slack, high + slack],
            product(self.slopes(), slopes),
            self.doubt,
        )
    }

    /// A function that rises with this number.
    #[inline]
    fn rising(self, domain: [f64; 2], function: impl Fn(f64) -> f64, slopes: [f64; 2]) -> Self {
        let inside = |value: f64| function(value.max(domain[0]).min(domain[1]));
        self.through(inside(self.middle), [inside(self.low), inside(self.high)], slopes)
    }

    /// A number of which only bounds of its values are known.
    #[inline]
    fn rough(middle: f64, values: [f64; 2], doubt: Doubt) -> Self {
        Self::new(middle, 0.0, values, [-HUGE, HUGE], doubt)
    }

    /// Both of two numbers, of which one is right in a part of the interval.
    #[inline]
    fn hull(self, other: Self, middle: f64) -> Self {
        let values = [self.low.min(other.low), self.high.max(other.high)];
        Self::rough(middle, values, self.doubt.and(other.doubt))
    }

    /// The angles from the vector in the middle, whose components are `x` and this number, to the corners of the box of
    /// all vectors.
    fn seen_from_the_middle(self, x: Self) -> [f64; 2] {
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for y in self.values() {
            for x_value in x.values() {
                let along = x_value * x.middle + y * self.middle;
                let across = y * x.middle - x_value * self.middle;
                if along <= 0.0 {
                    return [-core::f64::consts::PI, core::f64::consts::PI];
                }
                let angle = Number::atan2(across, along);
                (low, high) = (low.min(angle), high.max(angle));
            }
        }
        [low, high]
    }

    /// The values at which a comparison of this number or of its magnitude may go different ways.
    #[inline]
    fn corners(self) -> ([f64; 3], usize) {
        if self.low == self.high {
            ([self.low; 3], 1)
        } else if self.low < 0.0 && self.high > 0.0 {
            ([self.low, self.high, 0.0], 3)
        } else {
            ([self.low, self.high, self.high], 2)
        }
    }
}

/// The most operands of a check whose conditions compare them one by one.
const MOST_OPERANDS: usize = 16;

/// Calls `visit` with all combinations of the corners of some numbers.
fn at_corners(operands: &[Bounds], visit: &mut dyn FnMut(&[f64])) {
    let mut values = [0.0; MOST_OPERANDS];
    let mut corner = [0_usize; MOST_OPERANDS];
    let (values, corner) = (&mut values[..operands.len()], &mut corner[..operands.len()]);
    for (value, operand) in values.iter_mut().zip(operands) {
        *value = operand.corners().0[0];
    }
    loop {
        visit(values);
        let mut index = 0;
        loop {
            let Some(operand) = operands.get(index) else { return };
            let (corners, count) = operand.corners();
            corner[index] += 1;
            if corner[index] < count {
                values[index] = corners[corner[index]];
                break;
            }
            corner[index] = 0;
            values[index] = corners[0];
            index += 1;
        }
    }
}

/// The solution for numbers in some intervals, where all of them have the same, without the type of the choice.
fn chosen_of(operands: &[Bounds], choose: &dyn Fn(&[f64]) -> Result<Assembly, Failure>) -> Result<Assembly, Failure> {
    let mut middles = [0.0; MOST_OPERANDS];
    for (middle, operand) in middles.iter_mut().zip(operands) {
        *middle = operand.middle;
    }
    let mut last = choose(&middles[..operands.len()]);
    let mut is_decided = true;
    at_corners(operands, &mut |values| {
        let next = choose(values);
        is_decided &= match (&last, &next) {
            (Err(_), Err(_)) => true,
            (Ok(one), Ok(other)) => one == other,
            _ => false,
        };
        last = next;
    });
    if is_decided {
        last
    } else {
        Err(Failure::not_finite(UNDECIDED))
    }
}

/// What a check says about an interval.
pub(crate) enum Verdict {
    Holds,
    Fails,
    Doubtful(Doubt),
}

/// The verdict of conditions that are comparisons of each operand or of its magnitude.
#[inline]
pub(crate) fn verdict<const N: usize, const K: usize>(check: impl Check<Bounds, N, K>) -> Verdict {
    const { assert!(N <= MOST_OPERANDS && K <= MOST_CONDITIONS) }
    verdict_of(&check.operands(), K, &|values, held| {
        let mut operands = [0.0; N];
        operands.copy_from_slice(values);
        held.copy_from_slice(&check.holds(operands));
    })
}

/// The most conditions of such a check.
const MOST_CONDITIONS: usize = 16;

/// The conditions of a check: whether each holds for some operands.
type Conditions<'c> = &'c dyn Fn(&[f64], &mut [bool]);

/// [`verdict`] without the type of the check, so that it is compiled once.
fn verdict_of(operands: &[Bounds], conditions: usize, holds: Conditions<'_>) -> Verdict {
    let (mut always, mut never) = ([true; MOST_CONDITIONS], [true; MOST_CONDITIONS]);
    let mut held = [false; MOST_CONDITIONS];
    at_corners(operands, &mut |values| {
        let held = &mut held[..conditions];
        holds(values, held);
        for (condition, holds) in held.iter().enumerate() {
            always[condition] &= holds;
            never[condition] &= !holds;
        }
    });
    let (always, never) = (&always[..conditions], &never[..conditions]);
    if always.iter().all(|holds| *holds) {
        return Verdict::Holds;
    }
    if never.iter().any(|fails| *fails) {
        return Verdict::Fails;
    }
    let mut doubt = Doubt::NONE;
    for condition in (0..conditions).filter(|condition| !always[*condition]) {
        doubt = doubt.and(trend(operands, condition, conditions, holds));
    }
    Verdict::Doubtful(doubt)
}

/// The largest part of the width of an interval of values that is rounding where halving the interval of the input is
/// of no more use.
const SPREAD: f64 = 16.0;

/// Whether a condition rises or falls along the interval, or rounding decides about it.
fn trend(operands: &[Bounds], condition: usize, conditions: usize, holds: Conditions<'_>) -> Doubt {
    let mut doubt = Doubt::NONE;
    let mut buffer = [Bounds::constant(0.0); MOST_OPERANDS];
    let varied = &mut buffer[..operands.len()];
    varied.copy_from_slice(operands);
    for (index, &operand) in operands.iter().enumerate() {
        let mut ends = |value: f64| {
            varied[index] = Bounds::constant(value);
            let (mut all, mut any) = (true, false);
            let mut held = [false; MOST_CONDITIONS];
            at_corners(varied, &mut |values| {
                holds(values, &mut held[..conditions]);
                (all, any) = (all && held[condition], any || held[condition]);
            });
            varied[index] = operand;
            (all, any)
        };
        let (corners, count) = operand.corners();
        if count == 1 {
            continue;
        }
        let is_rounded = operand.high - operand.low <= SPREAD * operand.error
            && [
                operand.middle - operand.error,
                operand.middle,
                operand.middle + operand.error,
            ]
            .map(&mut ends)
            .windows(2)
            .any(|pair| pair[0] != pair[1]);
        if is_rounded {
            doubt = doubt.and(Doubt::ROUNDING);
        }
        let (low, high) = (ends(corners[0]), ends(corners[1]));
        if low == high {
            if count == 3 && ends(0.0) != low {
                doubt = doubt.and(Doubt::UNKNOWN);
            }
            continue;
        }
        // From the lower end to the upper one, the condition becomes true, or it becomes false.
        let becomes_true = u8::from(high.0) + u8::from(high.1) > u8::from(low.0) + u8::from(low.1);
        doubt = doubt.and(if operand.least_slope > 0.0 {
            if becomes_true { Doubt::RISING } else { Doubt::FALLING }
        } else if operand.greatest_slope < 0.0 {
            if becomes_true { Doubt::FALLING } else { Doubt::RISING }
        } else {
            Doubt::UNKNOWN
        });
    }
    if doubt == Doubt::NONE { Doubt::UNKNOWN } else { doubt }
}

impl Add for Bounds {
    type Output = Self;

    #[inline(never)]
    fn add(self, other: Self) -> Self {
        Self::new(
            self.middle + other.middle,
            self.error + other.error,
            [self.low + other.low, self.high + other.high],
            widened([
                self.least_slope + other.least_slope,
                self.greatest_slope + other.greatest_slope,
            ]),
            self.doubt.and(other.doubt),
        )
    }
}

impl Neg for Bounds {
    type Output = Self;

    #[inline(never)]
    fn neg(self) -> Self {
        Self {
            middle: -self.middle,
            low: -self.high,
            high: -self.low,
            least_slope: -self.greatest_slope,
            greatest_slope: -self.least_slope,
            ..self
        }
    }
}

impl Sub for Bounds {
    type Output = Self;

    #[inline(never)]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Bounds {
    type Output = Self;

    #[inline(never)]
    fn mul(self, other: Self) -> Self {
        if other.is_constant() {
            return self.scaled(other);
        }
        if self.is_constant() {
            return other.scaled(self);
        }
        let [one, two] = [
            product(self.slopes(), other.values()),
            product(self.values(), other.slopes()),
        ];
        Self::new(
            self.middle * other.middle,
            (self.middle.abs() * other.error + other.middle.abs() * self.error) * (1.0 + 4.0 * f64::EPSILON)
                + self.error * other.error,
            rounded_product(self.values(), other.values()),
            widened([one[0] + two[0], one[1] + two[1]]),
            self.doubt.and(other.doubt),
        )
    }
}

impl Div for Bounds {
    type Output = Self;

    #[inline(never)]
    fn div(self, other: Self) -> Self {
        let inverse = reciprocal(other.values());
        if inverse == [-HUGE, HUGE] {
            return Self::rough(0.0, inverse, self.doubt.and(other.doubt));
        }
        let slope = product(inverse, inverse);
        self * other.through(1.0 / other.middle, inverse, [-slope[1], -slope[0]])
    }
}

impl Number for Bounds {
    const EPSILON: f64 = f64::EPSILON;

    #[inline(never)]
    fn constant(value: f64) -> Self {
        Self {
            middle: value,
            error: 0.0,
            low: value,
            high: value,
            least_slope: 0.0,
            greatest_slope: 0.0,
            doubt: Doubt::NONE,
        }
    }

    #[inline]
    fn real(self) -> f64 {
        self.middle
    }

    #[inline]
    fn is_finite(self) -> bool {
        !(self.low.is_nan() || self.high.is_nan())
    }

    #[inline(never)]
    fn sqrt(self) -> Self {
        let roots = self.values().map(|value| Float::sqrt(value.max(0.0)));
        let slopes = if roots[0] > 0.0 {
            widened([0.5 / roots[1], 0.5 / roots[0]])
        } else {
            [-HUGE, HUGE]
        };
        if self.middle <= 0.0 || slopes[0] < 0.0 {
            return Self::rough(Float::sqrt(self.middle.max(0.0)), roots, self.doubt);
        }
        self.through(Float::sqrt(self.middle), roots, slopes)
    }

    #[inline(never)]
    fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = Number::sin_cos(self.middle);
        let reach = (self.high - self.middle).max(self.middle - self.low) * (1.0 + f64::EPSILON) + self.error;
        // sin(m + d) = sin(m) cos(d) + cos(m) sin(d), with 1 - d²/2 <= cos(d) <= 1 and |sin(d)| <= |d|.
        let around = |value: f64, slope: f64| {
            if reach > 1.5 {
                return [-1.0, 1.0];
            }
            let shrunk = value * (1.0 - 0.5 * reach * reach);
            let aside = slope.abs() * reach + FUNCTION;
            [
                (shrunk.min(value) - aside).max(-1.0),
                (shrunk.max(value) + aside).min(1.0),
            ]
        };
        let (sines, cosines) = (around(sine, cosine), around(cosine, sine));
        (
            self.through(sine, sines, cosines),
            self.through(cosine, cosines, [-sines[1], -sines[0]]),
        )
    }

    #[inline(never)]
    fn asin(self) -> Self {
        let square = self * self;
        let rest = 1.0 - square.high;
        let slopes = if rest > 0.0 {
            widened([1.0, 1.0 / Float::sqrt(rest)])
        } else {
            [-HUGE, HUGE]
        };
        self.rising([-1.0, 1.0], Number::asin, slopes)
    }

    #[inline(never)]
    fn acos(self) -> Self {
        Self::constant(core::f64::consts::FRAC_PI_2) - self.asin()
    }

    #[inline(never)]
    fn atan(self) -> Self {
        let square = self * self;
        let slopes = reciprocal([1.0 + square.low.max(0.0), 1.0 + square.high]);
        self.rising([-HUGE, HUGE], Number::atan, slopes)
    }

    /// The angle goes on beyond half a revolution, so that it is continuous over the interval.
    #[inline(never)]
    fn atan2(self, x: Self) -> Self {
        let doubt = self.doubt.and(x.doubt);
        let middle = Number::atan2(self.middle, x.middle);
        let square = self * self + x * x;
        let inverse = reciprocal(square.values());
        let across = [product(x.values(), self.slopes()), product(self.values(), x.slopes())];
        let slopes = product(
            widened([across[0][0] - across[1][1], across[0][1] - across[1][0]]),
            inverse,
        );
        let steepest = Float::sqrt(inverse[1].abs());
        let error = (self.error + x.error) * steepest + FUNCTION * 4.0;
        let half_revolution = core::f64::consts::PI;
        let mut values = [middle - half_revolution, middle + half_revolution];
        if slopes[0].abs().max(slopes[1].abs()) > 1.0 {
            let [low, high] = self.seen_from_the_middle(x);
            values = [middle + low - FUNCTION, middle + high + FUNCTION];
        }
        Self::new(middle, error, values, slopes, doubt)
    }

    #[inline(never)]
    fn sinh(self) -> Self {
        let slopes = self.cosh().values();
        self.rising([-HUGE, HUGE], Number::sinh, slopes)
    }

    #[inline(never)]
    fn cosh(self) -> Self {
        let power = self.exp();
        let half = Self::constant(0.5);
        power * half + half / power
    }

    #[inline(never)]
    fn tanh(self) -> Self {
        let largest = self.low.abs().max(self.high.abs());
        let tangent = Number::tanh(largest);
        self.rising([-HUGE, HUGE], Number::tanh, widened([1.0 - tangent * tangent, 1.0]))
    }

    #[inline(never)]
    fn asinh(self) -> Self {
        let largest = self.low.abs().max(self.high.abs());
        let slopes = widened([1.0 / Float::sqrt(1.0 + largest * largest), 1.0]);
        self.rising([-HUGE, HUGE], Number::asinh, slopes)
    }

    #[inline(never)]
    fn acosh(self) -> Self {
        let rest = self.low * self.low - 1.0;
        let slopes = if self.low > 1.0 && rest > 0.0 {
            widened([0.0, 1.0 / Float::sqrt(rest)])
        } else {
            [-HUGE, HUGE]
        };
        self.rising([1.0, HUGE], Number::acosh, slopes)
    }

    #[inline(never)]
    fn atanh(self) -> Self {
        let square = (self * self).high;
        let slopes = if square < 1.0 {
            widened([1.0, 1.0 / (1.0 - square)])
        } else {
            [-HUGE, HUGE]
        };
        let end = 1.0 - f64::EPSILON;
        self.rising([-end, end], Number::atanh, slopes)
    }

    #[inline(never)]
    fn exp(self) -> Self {
        let slopes = widened(self.values().map(|value| Number::exp(value.min(340.0))));
        self.rising([-HUGE, 340.0], Number::exp, slopes)
    }

    #[inline(never)]
    fn ln(self) -> Self {
        let slopes = reciprocal(self.values());
        self.rising([f64::MIN_POSITIVE, HUGE], Number::ln, slopes)
    }
}

impl Scalar for Bounds {
    #[inline]
    fn provided<const N: usize, const K: usize>(self, check: impl Check<Self, N, K>) -> Option<Self> {
        match verdict(check) {
            Verdict::Holds => Some(self),
            Verdict::Fails => None,
            Verdict::Doubtful(doubt) => Some(Self {
                doubt: self.doubt.and(doubt),
                ..self
            }),
        }
    }

    #[inline]
    fn either<const N: usize>(
        check: impl Check<Self, N, 1>,
        one: impl FnOnce() -> Self,
        other: impl FnOnce() -> Self,
    ) -> Self {
        match verdict(check) {
            Verdict::Holds => one(),
            Verdict::Fails => other(),
            Verdict::Doubtful(_) => {
                let [holds] = check.holds(real_parts(check.operands()));
                let (one, other) = (one(), other());
                one.hull(other, if holds { one.middle } else { other.middle })
            }
        }
    }

    #[inline]
    fn chosen<const N: usize>(choice: impl Choose<Self, N>) -> Result<Assembly, Failure> {
        const { assert!(N <= MOST_OPERANDS) }
        chosen_of(&choice.operands(), &|values| {
            let mut operands = [0.0; N];
            operands.copy_from_slice(values);
            choice.choose(operands)
        })
    }

    #[inline]
    fn root(_: &mut [Self], _: &[Self], _: NewtonMemory<'_, Self>, _: impl Equations<Self>) -> Result<(), Failure> {
        Err(Failure::not_finite(UNDECIDED))
    }
}
